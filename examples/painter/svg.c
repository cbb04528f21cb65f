/* Pictures as SVG files: strokes sorted by depth, each with a dark edge, so that crossings show. */
#include "pieces.h"
#include "xml.h"

#include <stdlib.h>
#include <string.h>

/* ---- what is behind the eye is cut off */

static bool clip_line(const view *v, vec *a, vec *b)
{
    double near = 1.01 * v->near;
    if (!v->perspective || (a->z >= near && b->z >= near)) {
        return true;
    }
    if (a->z < near && b->z < near) {
        return false;
    }
    vec cut = vec_lerp(*a, *b, (near - a->z) / (b->z - a->z));
    *(a->z < near ? a : b) = cut;
    return true;
}

static void put_point(const drawing *d, vec place)
{
    double x, y;
    if (view_project(&d->v, place, &x, &y)) {
        xml_number(d->to, x);
        xml_put(d->to, " ");
        xml_number(d->to, y);
        xml_put(d->to, " ");
    }
}

/* Points of the corners in front of the eye and of the edges that come from behind it. */
static void put_polygon(const drawing *d, const vec *corners, int count, painter_colour colour)
{
    xml_put(d->to, "<polygon points=\"");
    for (int i = 0; i < count; i++) {
        vec a = corners[i], b = corners[(i + 1) % count], from = a, to = b;
        if (clip_line(&d->v, &from, &to)) {
            put_point(d, from);
            if (d->v.perspective && b.z < 1.01 * d->v.near) {
                put_point(d, to);
            }
        }
    }
    xml_put(d->to, "\"");
    xml_colour(d->to, "fill", colour);
    xml_colour(d->to, "stroke", colour);
    xml_put(d->to, " stroke-width=\"0.5\"/>\n");
}

static void put_segment(const drawing *d, vec a, vec b, double width, painter_colour colour)
{
    if (clip_line(&d->v, &a, &b)) {
        xml_put(d->to, "<path d=\"M");
        put_point(d, a);
        put_point(d, b);
        xml_put(d->to, "\"");
        xml_colour(d->to, "stroke", colour);
        xml_attribute(d->to, "stroke-width", width);
        xml_put(d->to, "/>\n");
    }
}

/* ---- flat things */

static painter_colour shaded(const drawing *d, const shape *s)
{
    vec middle = vec_add(s->a, vec_scale(vec_add(s->b, s->c), 1.0 / 3.0));
    ray r = {{0.0, 0.0, 0.0}, {0.0, 0.0, 1.0}};
    if (d->v.perspective) {
        r.along = vec_scale(middle, 1.0 / fmax(vec_length(middle), 1e-300));
    }
    double faces_light = vec_dot(shape_normal(s, &r, middle), light_direction());
    double strength = 0.46 + 0.16 * faces_light + 0.5 * fmax(faces_light, 0.0);
    rgb own = rgb_of(s->colour);
    return rgb_packed((rgb){own.r * strength, own.g * strength, own.b * strength});
}

static void put_flat(const drawing *d, const shape *s)
{
    vec b = vec_add(s->a, s->b), c = vec_add(s->a, s->c), far = vec_add(b, s->c);
    if (s->kind == SHAPE_TRIANGLE) {
        put_polygon(d, (const vec[3]){s->a, b, c}, 3, shaded(d, s));
        return;
    }
    put_polygon(d, (const vec[4]){s->a, b, far, c}, 4, s->colour);
    painter_colour line = rgb_packed(rgb_mix(rgb_of(s->colour), rgb_of(PICTURE_INK), 0.16));
    for (int i = 0; i <= s->cells; i++) {
        double t = (double)i / s->cells;
        put_segment(d, vec_lerp(s->a, b, t), vec_lerp(c, far, t), 1.0, line);
        put_segment(d, vec_lerp(s->a, c, t), vec_lerp(b, far, t), 1.0, line);
    }
}

/* ---- what lies in front */

static void svg_disc(void *user, double x, double y, double radius, painter_colour colour)
{
    bytes *to = user;
    xml_put(to, "<circle");
    xml_attribute(to, "cx", x);
    xml_attribute(to, "cy", y);
    xml_attribute(to, "r", radius);
    xml_colour(to, "fill", colour);
    xml_put(to, "/>\n");
}

static void svg_line(void *user, double x0, double y0, double x1, double y1, double thickness,
                     painter_colour colour)
{
    bytes *to = user;
    xml_put(to, "<line");
    xml_attribute(to, "x1", x0);
    xml_attribute(to, "y1", y0);
    xml_attribute(to, "x2", x1);
    xml_attribute(to, "y2", y1);
    xml_colour(to, "stroke", colour);
    xml_attribute(to, "stroke-width", thickness);
    xml_put(to, " stroke-linecap=\"round\"/>\n");
}

static void svg_fill(void *user, double x, double y, double width, double height,
                     painter_colour colour)
{
    bytes *to = user;
    xml_put(to, "<rect");
    xml_attribute(to, "x", x);
    xml_attribute(to, "y", y);
    xml_attribute(to, "width", width);
    xml_attribute(to, "height", height);
    xml_colour(to, "fill", colour);
    xml_put(to, "/>\n");
}

static void svg_text(void *user, double x, double y, double anchor, const char *text,
                     painter_colour colour)
{
    bytes *to = user;
    xml_put(to, "<text");
    xml_attribute(to, "x", x);
    xml_attribute(to, "y", y);
    if (anchor > 0.0) {
        xml_put(to, anchor < 1.0 ? " text-anchor=\"middle\"" : " text-anchor=\"end\"");
    }
    xml_colour(to, "fill", colour);
    xml_colour(to, "stroke", PICTURE_BACKGROUND);
    xml_put(to, " stroke-width=\"3\" stroke-opacity=\"0.75\" paint-order=\"stroke\">");
    xml_text(to, text);
    xml_put(to, "</text>\n");
}

/* ---- the file */

static void put_head(bytes *to, int width, int height)
{
    xml_put(to, "<svg xmlns=\"http://www.w3.org/2000/svg\"");
    xml_attribute(to, "width", width);
    xml_attribute(to, "height", height);
    xml_put(to, " viewBox=\"0 0 ");
    xml_number(to, width);
    xml_put(to, " ");
    xml_number(to, height);
    xml_put(to, "\">\n<rect width=\"100%\" height=\"100%\"");
    xml_colour(to, "fill", PICTURE_BACKGROUND);
    xml_put(to, "/>\n<g fill=\"none\" stroke-linejoin=\"round\">\n");
}

static void put_lines(const drawing *d, const piece *part)
{
    for (size_t i = part->first; i <= part->last; i++) {
        const shape *s = &d->placed[i];
        vec a = i == part->first ? vec_lerp(s->a, s->b, part->t0) : s->a;
        vec b = i == part->last ? vec_lerp(s->a, s->b, part->t1) : s->b;
        put_segment(d, a, b, 1.2, s->colour);
    }
}

static bool put_scene(const drawing *d)
{
    size_t count;
    piece *pieces = pieces_sorted(d, &count);
    if (pieces == NULL) {
        return false;
    }
    for (size_t i = 0; i < count; i++) {
        const shape *s = &d->placed[pieces[i].first];
        if (s->kind == SHAPE_CAPSULE) {
            strokes_put(d, &pieces[i]);
        } else if (s->kind == SHAPE_LINE) {
            put_lines(d, &pieces[i]);
        } else {
            put_flat(d, s);
        }
    }
    free(pieces);
    return true;
}

painter_result painter_write_svg(painter *p, const char *path)
{
    if (p == NULL) {
        return PAINTER_ERROR_NULL;
    }
    if (path == NULL) {
        return picture_need(p, path, "the path");
    }
    painter_camera camera = camera_in_use(p);
    bytes file = {.data = NULL};
    shape *placed = calloc(p->shape_count + 1, sizeof *placed);
    bool enough = placed != NULL;
    if (enough) {
        drawing d = {&file, view_of(&camera, p->width, p->height), placed, p->shape_count};
        for (size_t i = 0; i < p->shape_count; i++) {
            placed[i] = shape_placed(&d.v, &p->shapes[i]);
        }
        put_head(&file, p->width, p->height);
        enough = put_scene(&d);
        xml_put(&file, "</g>\n<g font-family=\"sans-serif\" font-size=\"13\" stroke=\"none\">\n");
        sheet front = {&file, p->width, p->height, svg_disc, svg_line, svg_fill, svg_text};
        picture_overlay(p, &camera, &front);
        xml_put(&file, "</g>\n</svg>\n");
    }
    painter_result result = enough
                                ? picture_save(p, &file, path)
                                : picture_fail(p, PAINTER_ERROR_MEMORY, "no memory for the file");
    bytes_free(&file);
    free(placed);
    return result;
}
