#include "scene/drain_watch.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Features nearer than this along the surface do not touch: in walls. */
#define NEAR 3.0
/* Sums in another order. */
#define ROUNDING 1e-12

/* Least ways over sides from one node to all. */
static void find_arcs(const drain_mesh *m, uint32_t source, double *arcs)
{
    for (uint32_t i = 0; i < m->node_count; i++) {
        arcs[i] = i == source ? 0.0 : HUGE_VAL;
    }
    for (bool changed = true; changed;) {
        changed = false;
        for (uint32_t i = 0; i < m->edge_count; i++) {
            const uint32_t *n = m->edges[i].nodes;
            double length = vec3_distance(m->rest[n[0]], m->rest[n[1]]);
            for (int k = 0; k < 2; k++) {
                double arc = arcs[n[k]] + length;
                changed = changed || arc < arcs[n[1 - k]];
                arcs[n[1 - k]] = vbss_min(arc, arcs[n[1 - k]]);
            }
        }
    }
}

static void find_near(drain_watch_near *w, const drain_object *d)
{
    const drain_mesh *m = &d->mesh;
    double arcs[DRAIN_WATCH_NODES], smallest = NEAR * d->config.thickness;
    memset(w, 0, sizeof *w);
    w->drain = d;
    for (uint32_t i = 0; i < m->edge_count; i++) {
        memcpy(w->sides[i], m->edges[i].nodes, sizeof w->sides[i]);
    }
    for (uint32_t i = 0; i < m->node_count; i++) {
        find_arcs(m, i, arcs);
        for (uint32_t k = 0; k < m->node_count; k++) {
            bool near = i == k || arcs[k] < smallest * (1.0 + ROUNDING);
            w->near[i][k / 64] |= (uint64_t)near << k % 64;
        }
    }
}

static const drain_watch_near *know(drain_watch *w, const drain_object *d)
{
    for (uint32_t i = 0; i < w->count; i++) {
        if (w->drains[i].drain == d) {
            return &w->drains[i];
        }
    }
    if (w->count == DRAIN_WATCH_DRAINS || d->mesh.node_count > DRAIN_WATCH_NODES) {
        abort(); /* what is not looked at proves nothing */
    }
    find_near(&w->drains[w->count], d);
    return &w->drains[w->count++];
}

uint64_t drain_watch_passed(drain_watch *w, const scene_object *s, const passing_chain *chains,
                            size_t chain_count, passing_surface_report *report)
{
    passing_surface surfaces[DRAIN_WATCH_DRAINS];
    size_t count = 0;
    *report = (passing_surface_report){0};
    for (uint32_t i = 0; i < s->body_count; i++) {
        const scene_body *b = &s->bodies[i];
        if (b->kind != SCENE_BODY_DRAIN) {
            continue;
        }
        const drain_object *d = b->drain.drain;
        const drain_watch_near *known = know(w, d);
        surfaces[count++] = (passing_surface){.start = d->x,
                                              .end = d->trial,
                                              .nodes = d->mesh.node_count,
                                              .triangles = d->mesh.triangles[0],
                                              .sides = known->sides[0],
                                              .triangle_count = d->mesh.triangle_count,
                                              .side_count = d->mesh.edge_count,
                                              .near = known->near[0],
                                              .words = DRAIN_WATCH_NODES / 64};
    }
    return count == 0 ? 0 : passing_surfaces(surfaces, count, chains, chain_count, report);
}
