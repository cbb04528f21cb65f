/* Discs, lines and text on pixels, their edges smoothed by the distance to them. */
#include "picture.h"

static const double font_unit = 1.4; /* pixels */
static const double pen = 0.75;      /* half a stroke of the font, pixels */

static void blend(const pixel_area *area, int x, int y, painter_colour colour, double cover)
{
    uint8_t *pixel = area->first + (size_t)y * area->stride + 3 * (size_t)x;
    painter_colour old = (painter_colour)pixel[0] << 16 | (painter_colour)pixel[1] << 8 | pixel[2];
    painter_colour mixed = rgb_packed(rgb_mix(rgb_of(old), rgb_of(colour), cover));
    pixel[0] = (uint8_t)(mixed >> 16);
    pixel[1] = (uint8_t)(mixed >> 8 & 255);
    pixel[2] = (uint8_t)(mixed & 255);
}

static double distance_to_line(double x, double y, double x0, double y0, double x1, double y1)
{
    double dx = x1 - x0, dy = y1 - y0, length2 = dx * dx + dy * dy;
    double t = length2 > 0.0 ? ((x - x0) * dx + (y - y0) * dy) / length2 : 0.0;
    t = clamp(t, 0.0, 1.0);
    dx = x - x0 - t * dx;
    dy = y - y0 - t * dy;
    return sqrt(dx * dx + dy * dy);
}

/* All that is nearer to the line than `half`. */
static void draw_pen(const pixel_area *area, double x0, double y0, double x1, double y1,
                     double half, painter_colour colour, double opacity)
{
    int left = (int)clamp(floor(fmin(x0, x1) - half - 1.0), 0.0, area->width);
    int right = (int)clamp(ceil(fmax(x0, x1) + half + 1.0), 0.0, area->width);
    int top = (int)clamp(floor(fmin(y0, y1) - half - 1.0), 0.0, area->height);
    int bottom = (int)clamp(ceil(fmax(y0, y1) + half + 1.0), 0.0, area->height);
    for (int y = top; y < bottom; y++) {
        for (int x = left; x < right; x++) {
            double off = distance_to_line(x + 0.5, y + 0.5, x0, y0, x1, y1);
            double cover = clamp(half - off + 0.5, 0.0, 1.0);
            if (cover > 0.0) {
                blend(area, x, y, colour, opacity * cover);
            }
        }
    }
}

static void pixels_disc(void *user, double x, double y, double radius, painter_colour colour)
{
    draw_pen(user, x, y, x, y, radius, colour, 1.0);
}

static void pixels_line(void *user, double x0, double y0, double x1, double y1, double thickness,
                        painter_colour colour)
{
    draw_pen(user, x0, y0, x1, y1, 0.5 * thickness, colour, 1.0);
}

static void pixels_fill(void *user, double x, double y, double width, double height,
                        painter_colour colour)
{
    const pixel_area *area = user;
    int left = (int)clamp(floor(x + 0.5), 0.0, area->width);
    int right = (int)clamp(floor(x + width + 0.5), 0.0, area->width);
    int top = (int)clamp(floor(y + 0.5), 0.0, area->height);
    int bottom = (int)clamp(floor(y + height + 0.5), 0.0, area->height);
    for (int row = top; row < bottom; row++) {
        for (int column = left; column < right; column++) {
            blend(area, column, row, colour, 1.0);
        }
    }
}

static void draw_glyph(const pixel_area *area, const char *glyph, double x, double y, double half,
                       painter_colour colour, double opacity)
{
    const char *c = glyph;
    while (*c != '\0') {
        double px = x + font_unit * (c[0] - '0'), py = y - font_unit * (c[1] - '2');
        c += 2;
        if (*c == ' ' || *c == '\0') {
            draw_pen(area, px, py, px, py, half * 1.25, colour, opacity); /* a dot, or an end */
        }
        while (*c != ' ' && *c != '\0') {
            double qx = x + font_unit * (c[0] - '0'), qy = y - font_unit * (c[1] - '2');
            draw_pen(area, px, py, qx, qy, half, colour, opacity);
            px = qx;
            py = qy;
            c += 2;
        }
        c += *c == ' ' ? 1 : 0;
    }
}

static void pixels_text(void *user, double x, double y, double anchor, const char *text,
                        painter_colour colour)
{
    double left = x - anchor * font_unit * font_width(text);
    for (int pass = 0; pass < 2; pass++) { /* first a light halo under all of it */
        double at = left;
        for (const char *next = text; *next != '\0';) {
            const char *glyph = font_glyph(&next);
            draw_glyph(user, glyph, at, y, pass == 0 ? pen + 1.6 : pen,
                       pass == 0 ? PICTURE_BACKGROUND : colour, pass == 0 ? 0.75 : 1.0);
            at += font_unit * font_advance(glyph);
        }
    }
}

sheet sheet_on_pixels(pixel_area *area)
{
    return (sheet){.user = area,
                   .width = area->width,
                   .height = area->height,
                   .disc = pixels_disc,
                   .line = pixels_line,
                   .fill = pixels_fill,
                   .text = pixels_text};
}
