/* Pictures of a needle on its way through a drain. */
#include "needle/pass.h"
#include "painter/painter.h"

enum { WIDTH = 760, HEIGHT = 620 };
#define THREAD_SHOWN 0.2e-3 /* thicker than it is, so that it is seen */
#define FLOOR_HALF 0.1
#define WIDE 0.1
#define CLOSE 0.045

static bool add_tool(painter *p, const hand *h, painter_colour colour)
{
    vbss_view view;
    bool good = vbss_grasper_get_view(h->grasper, VBSS_GRASPER_VIEW_CAPSULES, &view, sizeof view) ==
                VBSS_OK;
    for (uint64_t i = 0; good && i < view.count; i++) {
        const double *part = (const double *)view.data + 7 * i;
        good = painter_add_capsule(p, part, part + 3, part[6], i == 0 ? colour : PAINTER_STEEL) ==
               PAINTER_OK;
    }
    return good;
}

static bool add_drain(painter *p, const site *s)
{
    vbss_view x, triangles;
    bool good = vbss_drain_get_view(s->drain, VBSS_DRAIN_POSITIONS, &x, sizeof x) == VBSS_OK &&
                vbss_drain_get_view(s->drain, VBSS_DRAIN_TRIANGLES, &triangles, sizeof triangles) ==
                    VBSS_OK &&
                painter_add_triangles(p, x.data, (size_t)x.count, 0, triangles.data,
                                      (size_t)triangles.count, PAINTER_TISSUE) == PAINTER_OK;
    for (int side = 0; good && side < 2; side++) {
        double at[3];
        v_store(at, site_mark(s, side));
        good = painter_add_capsule(p, at, at, 0.6e-3, PAINTER_BLUE) == PAINTER_OK;
    }
    return good;
}

static bool add_needle(painter *p, const site *s)
{
    vbss_view needle;
    const vec *x = stand_nodes(&s->stand);
    return vbss_needle_get_view(s->needle, VBSS_NEEDLE_VIEW_POINTS, &needle, sizeof needle) ==
               VBSS_OK &&
           painter_add_chain(p, needle.data, (size_t)needle.count, 0, s->wire, PAINTER_BLACK,
                             NULL) == PAINTER_OK &&
           painter_add_chain(p, &x[0].x, s->stand.nodes, 0, THREAD_SHOWN, PAINTER_VIOLET, NULL) ==
               PAINTER_OK;
}

bool show_picture(const stitch *t, const char *path, const char *text)
{
    painter *p;
    const double centre[3] = {0.0, 0.0, t->site.floor};
    const double u[3] = {FLOOR_HALF, 0.0, 0.0}, v[3] = {0.0, FLOOR_HALF, 0.0};
    bool wide = t->state < STITCH_AIM;
    painter_camera c = {
        .eye = {0.0, -0.24, 0.07}, .target = {0.0, 0.0, -2e-3}, .up = {0, 0, 1}, .width = CLOSE};
    if (wide) {
        c.eye[0] = c.target[0] = 0.015;
        c.width = WIDE;
    }
    if (painter_create(WIDTH, HEIGHT, &p) != PAINTER_OK) {
        return false;
    }
    bool good =
        painter_add_floor(p, centre, u, v, 20, PAINTER_FLOOR) == PAINTER_OK &&
        add_drain(p, &t->site) && add_needle(p, &t->site) && add_tool(p, &t->left, PAINTER_GREEN) &&
        add_tool(p, &t->right, PAINTER_YELLOW) && painter_set_camera(p, &c) == PAINTER_OK &&
        painter_add_text(p, 10, 20, text, PAINTER_BLACK) == PAINTER_OK &&
        painter_add_scale_bar(p, wide ? 0.01 : 5e-3, wide ? "1 cm" : "5 mm") == PAINTER_OK &&
        painter_write_two_views(p, path) == PAINTER_OK;
    painter_destroy(p);
    return good;
}
