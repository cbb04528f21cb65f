#include "needle/show.h"

#define THREAD_SHOWN 0.2e-3 /* thicker than it is, so that it is seen */
#define FLOOR_HALF 0.1

static bool add_floor(painter *p, const site *s)
{
    const double centre[3] = {0.0, 0.0, s->floor};
    const double u[3] = {FLOOR_HALF, 0.0, 0.0}, v[3] = {0.0, FLOOR_HALF, 0.0};
    return painter_add_floor(p, centre, u, v, 20, PAINTER_FLOOR) == PAINTER_OK;
}

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
    bool good = vbss_drain_get_view(s->drain, VBSS_DRAIN_VIEW_POSITIONS, &x, sizeof x) == VBSS_OK &&
                vbss_drain_get_view(s->drain, VBSS_DRAIN_VIEW_TRIANGLES, &triangles,
                                    sizeof triangles) == VBSS_OK &&
                painter_add_triangles(p, x.data, (size_t)x.count, 0, triangles.data,
                                      (size_t)triangles.count, PAINTER_TISSUE) == PAINTER_OK;
    for (int side = 0; good && side < 2; side++) {
        double at[3];
        v_store(at, mirror_vec(s->rig.mirrored, site_mark(s, side)));
        good = painter_add_capsule(p, at, at, 0.6e-3, PAINTER_BLUE) == PAINTER_OK;
    }
    return good;
}

static bool add_needle(painter *p, const site *s)
{
    vbss_view needle;
    const vec *x = throw_rig_nodes(&s->rig);
    return vbss_needle_get_view(s->needle, VBSS_NEEDLE_VIEW_POINTS, &needle, sizeof needle) ==
               VBSS_OK &&
           painter_add_chain(p, needle.data, (size_t)needle.count, 0, s->wire, PAINTER_BLACK,
                             NULL) == PAINTER_OK &&
           painter_add_chain(p, &x[0].x, s->rig.nodes, 0, THREAD_SHOWN, PAINTER_VIOLET, NULL) ==
               PAINTER_OK;
}

bool show_add(painter *p, const stitch *t)
{
    return add_floor(p, &t->site) && add_drain(p, &t->site) && add_needle(p, &t->site) &&
           add_tool(p, stitch_hand(t, SITE_LEFT), PAINTER_GREEN) &&
           add_tool(p, stitch_hand(t, SITE_RIGHT), PAINTER_YELLOW);
}
