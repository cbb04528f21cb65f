/* The throws of a knot as the detector tells them, each in its colour on both limbs: loose and tight. */
#include <math.h>
#include <stdio.h>

#include "knots/draw.h"
#include "knots/panels.h"
#include "knots/words.h"

/* Of a panel and of its legend at the top, pixels. */
enum { WIDTH = 560, HEIGHT = 600, PANELS = 2, LEFT = 18, TOP = 30, LINE = 22 };
#define SWATCH 4.5
enum { FIRST_SWATCH = 7, SECOND_SWATCH = 23, AFTER_SWATCHES = 40 };
/* How much wider a panel is than the knot; how far from its middle there is thread to paint, in its widths. */
#define BORDER 1.3
#define REACH 0.9
#define ELEVATION 0.3 /* rad, of a PNG */
#define TAIL_TINT 0.45
#define TAIL_LIMB 0xf4f1e8u
#define LONG_LIMB 0x5f6973u

static const painter_colour colours[GALLERY_THROWS] = {
    PAINTER_VERMILION, PAINTER_BLUE, PAINTER_GREEN,  PAINTER_PINK,
    PAINTER_YELLOW,    PAINTER_SKY,  PAINTER_ORANGE, PAINTER_VIOLET};

/* ---- colours */

static painter_colour tinted(painter_colour c, double share)
{
    painter_colour mixed = 0;
    for (int shift = 0; shift <= 16; shift += 8) {
        double part = (double)(c >> shift & 0xffu);
        mixed |= (painter_colour)(part + share * (255.0 - part)) << shift;
    }
    return mixed;
}

static bool lies_in(double place, const double places[2])
{
    return place >= places[0] && place <= places[1];
}

static painter_colour by_throw(const void *user, uint32_t segment, double t)
{
    const gallery_reading *r = user;
    double place = segment + t;
    uint32_t middle = 0;
    for (uint32_t i = 0; i < r->state.throw_count; i++) {
        const vbss_knot_throw *one = &r->throws[i];
        if ((one->flags & VBSS_KNOT_THROW_LOCATED) == 0) {
            continue;
        }
        if (lies_in(place, one->tail_places)) {
            return tinted(colours[i], TAIL_TINT);
        }
        if (lies_in(place, one->long_places)) {
            return colours[i];
        }
        middle += place > 0.5 * (one->tail_places[1] + one->long_places[0]) ? 1 : 0;
    }
    return 2 * middle > r->state.throw_count ? LONG_LIMB : TAIL_LIMB;
}

/* ---- where they are */

typedef struct extent {
    vec3 low, high;
} extent;

static void widen(extent *e, vec3 x)
{
    e->low = vec3_make(vbss_min(e->low.x, x.x), vbss_min(e->low.y, x.y), vbss_min(e->low.z, x.z));
    e->high =
        vec3_make(vbss_max(e->high.x, x.x), vbss_max(e->high.y, x.y), vbss_max(e->high.z, x.z));
}

static void widen_along(extent *e, const vec3 *x, uint32_t count, double from, double to)
{
    for (uint32_t i = 0; i < count; i++) {
        if (i >= from && i <= to) {
            widen(e, x[i]);
        }
    }
}

/* Of the throws; with all that lies between them when it is loose. */
static extent extent_of(const gallery_knot *g, const gallery_frame *f, const gallery_reading *r,
                        bool loose)
{
    extent e = {vec3_make(1e9, 1e9, 1e9), vec3_make(-1e9, -1e9, -1e9)};
    double first = 1e9, last = -1e9;
    for (uint32_t i = 0; i < r->state.throw_count; i++) {
        const vbss_knot_throw *t = &r->throws[i];
        if ((t->flags & VBSS_KNOT_THROW_LOCATED) == 0) {
            continue;
        }
        widen_along(&e, f->x, g->knot.node_count, t->tail_places[0], t->tail_places[1]);
        widen_along(&e, f->x, g->knot.node_count, t->long_places[0], t->long_places[1]);
        first = vbss_min(first, t->tail_places[0]);
        last = vbss_max(last, t->long_places[1]);
    }
    if (first > last) { /* nobody knows where they are */
        widen_along(&e, f->x, g->knot.node_count, 0.0, g->knot.node_count);
    } else if (loose) {
        widen_along(&e, f->x, g->knot.node_count, first, last);
    }
    double thick = g->knot.options.thread.radius;
    widen(&e, vec3_add(e.low, vec3_make(-thick, -thick, -thick)));
    widen(&e, vec3_add(e.high, vec3_make(thick, thick, thick)));
    return e;
}

/* ---- a panel */

typedef struct panel {
    const gallery_frame *frame;
    const gallery_reading *reading;
    bool loose;
    double elevation;
} panel;

/* A dot in the scene that comes to lie at a pixel. */
static bool add_swatch(painter *p, double x, double y, painter_colour colour)
{
    painter_camera c;
    if (painter_get_camera(p, &c) != PAINTER_OK) {
        return false;
    }
    vec3 eye = vec3_load(c.eye), target = vec3_load(c.target), up = vec3_load(c.up);
    vec3 right = vec3_unit_or(vec3_cross(vec3_sub(target, eye), up), vec3_make(1.0, 0.0, 0.0));
    double metres = c.width / WIDTH;
    vec3 at = vec3_add_scaled(target, metres * (x - 0.5 * WIDTH), right);
    at = vec3_add_scaled(at, metres * (0.5 * HEIGHT - y), up);
    return painter_add_dots(p, &at.x, 1, 0, SWATCH, colour) == PAINTER_OK;
}

static bool add_line(painter *p, int line, const char *text)
{
    return painter_add_text(p, LEFT, TOP + LINE * line, text, PAINTER_BLACK) == PAINTER_OK;
}

static bool add_swatches(painter *p, int line, painter_colour tail, painter_colour other,
                         const char *text)
{
    double y = TOP + LINE * line;
    return painter_add_text(p, LEFT + AFTER_SWATCHES, y, text, PAINTER_BLACK) == PAINTER_OK &&
           add_swatch(p, LEFT + FIRST_SWATCH, y - SWATCH, tail) &&
           add_swatch(p, LEFT + SECOND_SWATCH, y - SWATCH, other);
}

static bool add_legend(painter *p, const panel *a)
{
    const gallery_reading *r = a->reading;
    char text[2 * WORD_TAGS], words[WORD_TAGS];
    int line = 0;
    words_of_faults(r->state.faults, words);
    snprintf(text, sizeof text, "%s: %s, %s, %s", a->loose ? "loose" : "tight", r->notation,
             words_of_name(r->state.name), words_of_result(r->state.verdict));
    bool good = add_line(p, line++, text) && add_line(p, line++, words);
    for (uint32_t i = 0; i < r->state.throw_count && good; i++) {
        words_of_throw(&r->throws[i], words);
        snprintf(text, sizeof text, "throw %u: %s", (unsigned)i + 1, words);
        good = add_swatches(p, line++, tinted(colours[i], TAIL_TINT), colours[i], text);
    }
    return good && add_swatches(p, line, TAIL_LIMB, LONG_LIMB, "tail limb, long limb");
}

static double legend_height(const gallery_reading *r)
{
    return TOP + LINE * (3.0 + r->state.throw_count);
}

/* So that the knot stands below the legend; returns the panel's width, m. */
static double set_view(painter *p, const panel *a, extent e)
{
    const double legend = legend_height(a->reading);
    vec3 size = vec3_sub(e.high, e.low);
    double tall = cos(a->elevation) * size.z + sin(a->elevation) * size.y;
    double width = BORDER * vbss_max(size.x, tall * WIDTH / (HEIGHT - legend));
    vec3 up = vec3_make(0.0, sin(a->elevation), cos(a->elevation));
    vec3 middle = vec3_add_scaled(vec3_lerp(e.low, e.high, 0.5), 0.5 * legend * width / WIDTH, up);
    return draw_seen_from(p, middle, 0.0, a->elevation, width) ? width : 0.0;
}

/* Each run of it that comes near. */
static bool add_thread(painter *p, const gallery_knot *g, const panel *a, vec3 middle, double reach)
{
    const vec3 *x = a->frame->x;
    uint32_t count = g->knot.node_count, first = 0;
    bool good = true;
    for (uint32_t i = 0; i < count && good; i++) {
        bool near = vec3_distance(x[i], middle) <= reach;
        if (near && i + 1 < count) {
            continue;
        }
        if (i > first && (near || i > first + 1)) { /* as far as the node beyond */
            good = draw_thread(p, g, x, first, i, by_throw, a->reading);
        }
        first = i;
    }
    return good;
}

static bool add_panel(painter *p, const gallery_knot *g, const panel *a)
{
    extent e = extent_of(g, a->frame, a->reading, a->loose);
    vec3 middle = vec3_lerp(e.low, e.high, 0.5);
    painter_clear(p);
    double width = set_view(p, a, e);
    return width > 0.0 && add_thread(p, g, a, middle, REACH * width) &&
           draw_cylinder(p, g, a->loose ? 0.0 : middle.y, a->elevation != 0.0) &&
           add_legend(p, a) && painter_add_scale_bar(p, 1e-3, "1 mm") == PAINTER_OK;
}

/* ---- the files */

static bool write_drawing(painter *p, const gallery_knot *g, panel panels[PANELS],
                          const char *folder)
{
    char path[1024], part[1100];
    bool good = true;
    snprintf(path, sizeof path, "%s/%s-throws.svg", folder, g->file);
    for (int i = 0; i < PANELS && good; i++) {
        panels[i].elevation = 0.0; /* strokes have no depth but that of their middles */
        snprintf(part, sizeof part, "%s.%d", path, i);
        good = add_panel(p, g, &panels[i]) && painter_write_svg(p, part) == PAINTER_OK;
    }
    return good && panels_join(path, WIDTH, HEIGHT, PANELS);
}

static bool write_picture(painter *p, const gallery_knot *g, panel panels[PANELS],
                          const char *folder)
{
    static uint8_t pixels[3 * WIDTH * HEIGHT], strip[PANELS * sizeof pixels];
    char path[1024];
    bool good = true;
    snprintf(path, sizeof path, "%s/%s-throws.png", folder, g->file);
    for (int i = 0; i < PANELS && good; i++) {
        panels[i].elevation = ELEVATION;
        good = add_panel(p, g, &panels[i]) && painter_paint(p, pixels, sizeof pixels) == PAINTER_OK;
        panels_put(pixels, WIDTH, HEIGHT, (size_t)i, PANELS, strip);
    }
    return good && painter_save_png(path, strip, PANELS * WIDTH, HEIGHT) == PAINTER_OK;
}

bool gallery_paint_throws(const gallery_knot *g, const char *folder)
{
    panel panels[PANELS] = {
        {&g->frames[0], &g->loose_reading, true, 0.0},
        {&g->frames[g->frame_count - 1], &g->tight_reading, false, 0.0},
    };
    painter *p = NULL;
    bool good = painter_create(WIDTH, HEIGHT, &p) == PAINTER_OK &&
                write_picture(p, g, panels, folder) && write_drawing(p, g, panels, folder);
    if (!good) {
        fprintf(stderr, "%s: %s\n", g->title, p != NULL ? painter_error(p) : "cannot be painted");
    }
    painter_destroy(p);
    return good;
}
