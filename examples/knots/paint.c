/* The pictures of a knot: tight, from two sides, and a strip of how it became so. */
#include <stdio.h>

#include "knots/draw.h"
#include "knots/panels.h"

/* Of one picture, pixels; strips have three or four panels side by side. */
enum { WIDTH = 680, HEIGHT = 600, PANEL_WIDTH = 420, PANEL_HEIGHT = 400, PANELS = 4 };
/* Across a panel, m; where they are seen from, rad. */
#define PANEL_METRES 15e-3
#define PANEL_AZIMUTH 0.35
#define PANEL_ELEVATION 0.35
/* The knot stands above the middle of the picture, by so much of its width, as the tube is below it. */
#define BELOW_KNOT 0.18
#define DOT_PIXELS 1.6
/* How far from its middle the knot is painted, in widths of the picture; and of a drawing. */
#define SHOWN 0.9
#define DRAWN 0.6
enum { MAX_DOTS = 256 };

static bool complain(const gallery_knot *g, painter *p)
{
    fprintf(stderr, "%s: %s\n", g->title, p != NULL ? painter_error(p) : "cannot be painted");
    painter_destroy(p);
    return false;
}

/* ---- the tight knot */

/* Where strands touch strands; returns how many. The middle of them is the knot's. */
static size_t find_contacts(const gallery_knot *g, vec3 *points, vec3 *middle)
{
    vbss_view features, all;
    size_t count = 0;
    *middle = vec3_zero();
    if (vbss_scene_get_view(g->knot.scene, VBSS_SCENE_VIEW_CONTACTS, &features, sizeof features) !=
            VBSS_OK ||
        vbss_scene_get_view(g->knot.scene, VBSS_SCENE_VIEW_CONTACT_POINTS, &all, sizeof all) !=
            VBSS_OK) {
        return 0;
    }
    for (size_t i = 0; i < features.count && count < MAX_DOTS; i++) {
        if (((const uint32_t *)features.data)[5 * i] == VBSS_SCENE_CONTACT_SEGMENTS) {
            points[count] = ((const vec3 *)all.data)[i];
            *middle = vec3_add(*middle, points[count++]);
        }
    }
    *middle = vec3_scale(*middle, count > 0 ? 1.0 / (double)count : 0.0);
    return count;
}

/* All but the tube and the dots. */
static bool add_tight(painter *p, const gallery_knot *g, vec3 middle, double near)
{
    const vec3 *x = g->frames[g->frame_count - 1].x;
    uint32_t first = 0, last = g->knot.node_count - 1;
    char text[128];
    vbss_view tensions;
    if (vbss_thread_get_view(g->knot.thread, VBSS_THREAD_VIEW_TENSIONS, &tensions,
                             sizeof tensions) != VBSS_OK) {
        return false;
    }
    while (first + 1 < last && vec3_distance(x[first + 1], middle) > near * g->width) {
        first++;
    }
    while (last - 1 > first && vec3_distance(x[last - 1], middle) > near * g->width) {
        last--;
    }
    const draw_tensions colours = {tensions.data, g->knot.node_count};
    snprintf(text, sizeof text, "%s, %.2f N at both ends", g->title, g->force);
    return draw_thread(p, g, x, first, last, draw_by_tension, &colours) &&
           painter_add_text(p, 16, 28, text, PAINTER_BLACK) == PAINTER_OK &&
           painter_add_ramp(p, "0 N", "2 N") == PAINTER_OK &&
           painter_add_scale_bar(p, 1e-3, "1 mm") == PAINTER_OK;
}

/* What the middle of the picture shows. */
static vec3 below(const gallery_knot *g, vec3 middle)
{
    middle.z -= g->cylinder ? BELOW_KNOT * g->width : 0.0;
    return middle;
}

static bool paint_tight(const gallery_knot *g, const char *folder)
{
    vec3 dots[MAX_DOTS], middle;
    size_t count = find_contacts(g, dots, &middle);
    char path[1024];
    painter *p = NULL;
    snprintf(path, sizeof path, "%s/%s.png", folder, g->file);
    if (painter_create(WIDTH, HEIGHT, &p) != PAINTER_OK || !add_tight(p, g, middle, SHOWN) ||
        !draw_cylinder(p, g, middle.y, true) ||
        painter_add_dots(p, &dots[0].x, count, 0, DOT_PIXELS, PAINTER_GREEN) != PAINTER_OK ||
        !draw_seen_from(p, below(g, middle), g->azimuth, g->elevation, g->width) ||
        painter_write_two_views(p, path) != PAINTER_OK) {
        return complain(g, p);
    }
    painter_destroy(p);
    return true;
}

/* Strokes in the order of their depths, which the tube has none of when it is seen from the front. */
static bool paint_drawing(const gallery_knot *g, const char *folder)
{
    vec3 dots[MAX_DOTS], middle;
    (void)find_contacts(g, dots, &middle);
    char path[1024];
    painter *p = NULL;
    snprintf(path, sizeof path, "%s/%s.svg", folder, g->file);
    if (painter_create(WIDTH, HEIGHT, &p) != PAINTER_OK || !add_tight(p, g, middle, DRAWN) ||
        !draw_cylinder(p, g, middle.y, false) ||
        !draw_seen_from(p, below(g, middle), 0.0, 0.0, g->width) ||
        painter_write_svg(p, path) != PAINTER_OK) {
        return complain(g, p);
    }
    painter_destroy(p);
    return true;
}

/* ---- the strip: loose, each throw laid, tight; with one throw: loose, half, tight */

static size_t choose_frames(const gallery_knot *g, const gallery_frame **chosen)
{
    size_t count = 0;
    uint32_t last = g->frame_count - 1, tight = last;
    while (tight > 0 && g->frames[tight - 1].stage == g->frames[last].stage) {
        tight--;
    }
    chosen[count++] = &g->frames[0];
    if (g->knot.throws == 1) {
        chosen[count++] = &g->frames[tight / 2];
    }
    for (uint32_t i = 1; i < tight && count + 1 < PANELS; i++) {
        if (g->frames[i].stage != g->frames[i - 1].stage) {
            chosen[count++] = &g->frames[i];
        }
    }
    chosen[count++] = &g->frames[last];
    return count;
}

static void name_panel(const gallery_knot *g, size_t index, size_t count, char *text, size_t size)
{
    if (index == 0) {
        snprintf(text, size, "%s: loose", g->title);
    } else if (index + 1 == count) {
        snprintf(text, size, "tight");
    } else if (g->knot.throws == 1) {
        snprintf(text, size, "half");
    } else {
        snprintf(text, size, "throw %u laid", (unsigned)index);
    }
}

static bool paint_panel(painter *p, const gallery_knot *g, const gallery_frame *f, const char *text,
                        uint8_t *pixels)
{
    painter_clear(p);
    return draw_thread(p, g, f->x, 0, g->knot.node_count - 1, draw_by_limb, g) &&
           draw_cylinder(p, g, 0.0, true) && draw_pegs(p, g, f) &&
           draw_seen_from(p, vec3_zero(), PANEL_AZIMUTH, PANEL_ELEVATION, PANEL_METRES) &&
           painter_add_text(p, 12, 24, text, PAINTER_BLACK) == PAINTER_OK &&
           painter_paint(p, pixels, (size_t)3 * PANEL_WIDTH * PANEL_HEIGHT) == PAINTER_OK;
}

static bool paint_stages(const gallery_knot *g, const char *folder)
{
    static uint8_t panel[3 * PANEL_WIDTH * PANEL_HEIGHT], strip[PANELS * sizeof panel];
    const gallery_frame *frames[PANELS];
    size_t count = choose_frames(g, frames);
    char path[1024], text[128];
    painter *p = NULL;
    snprintf(path, sizeof path, "%s/%s-stages.png", folder, g->file);
    if (painter_create(PANEL_WIDTH, PANEL_HEIGHT, &p) != PAINTER_OK) {
        return complain(g, p);
    }
    for (size_t i = 0; i < count; i++) {
        name_panel(g, i, count, text, sizeof text);
        if (!paint_panel(p, g, frames[i], text, panel)) {
            return complain(g, p);
        }
        panels_put(panel, PANEL_WIDTH, PANEL_HEIGHT, i, count, strip);
    }
    painter_destroy(p);
    return painter_save_png(path, strip, (int)count * PANEL_WIDTH, PANEL_HEIGHT) == PAINTER_OK ||
           complain(g, NULL);
}

bool gallery_paint(const gallery_knot *g, const char *folder)
{
    return paint_tight(g, folder) && paint_drawing(g, folder) && paint_stages(g, folder);
}
