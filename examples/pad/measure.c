/* Gaps, holes, tensions and crossings. */
#include "pad.h"

#include <math.h>
#include <string.h>

#include "base/elementary.h"
#include "base/error.h"
#include "scripted/crossing.h"

static const double near_hole =
    2.5e-3; /* m: contact is complete beyond (docs/explanation/stitch.md) */
enum { BESIDE = 2 /* segments from a hole to where its tensions are read */ };

static const vec3 *skin_nodes(const pad *p)
{
    vbss_view x;
    return vbss_drain_get_view(p->skin, VBSS_DRAIN_VIEW_POSITIONS, &x, sizeof x) == VBSS_OK
               ? (const vec3 *)x.data
               : NULL;
}

/* ---- lips */

static vec3 on_lip(const pad *p, const vec3 *x, int side, double at)
{
    const uint32_t row = (uint32_t)at < PAD_ROWS - 1 ? (uint32_t)at : PAD_ROWS - 2;
    return vec3_lerp(x[p->sheet.lips[side][row]], x[p->sheet.lips[side][row + 1]], at - row);
}

vec3 pad_across(const pad *p, double z)
{
    const vec3 *x = skin_nodes(p);
    const double first = p->sheet.x[p->sheet.lips[0][0]][2],
                 spacing = p->sheet.x[p->sheet.lips[0][1]][2] - first;
    const vec3 here = on_lip(p, x, 0, (z - first) / spacing);
    vec3 nearest = vec3_make((double)INFINITY, 0.0, 0.0);
    for (uint32_t i = 0; i < 20 * (PAD_ROWS - 1); i++) {
        const vec3 to = vec3_sub(on_lip(p, x, 1, i / 20.0), here);
        nearest = vec3_norm(to) < vec3_norm(nearest) ? to : nearest;
    }
    return nearest;
}

double pad_opening(const pad *p, double z)
{
    return vec3_norm(pad_across(p, z));
}

static void measure_skin(const pad *p, pad_report *r)
{
    const vec3 *x = skin_nodes(p);
    for (uint32_t i = 0; i < PAD_BITES; i++) {
        r->gap[i] = pad_opening(p, pad_place(i));
    }
    for (uint32_t i = 0; i < PAD_ROWS; i++) {
        r->largest_gap = fmax(r->largest_gap, pad_opening(p, p->sheet.x[p->sheet.lips[0][i]][2]));
    }
    for (uint32_t i = 0; i < PAD_NODES; i++) {
        r->lowest = fmin(r->lowest, x[i].y);
        r->highest = fmax(r->highest, x[i].y);
    }
}

/* ---- holes */

static vbss_result measure_hole(pad *p, const vbss_scene_hole *hole, pad_report *r)
{
    vbss_view x, tensions, lengths;
    pad_hole *h = &r->holes[r->hole_count];
    h->suture = hole->thread == p->sutures[0].thread_body ? 0 : 1;
    h->place = vec3_load(hole->rest_position);
    h->along = hole->arc_length;
    h->force = vec3_neg(vec3_load(hole->force));
    r->side_force[h->place.x < 0.0 ? 0 : 1] =
        vec3_add(r->side_force[h->place.x < 0.0 ? 0 : 1], h->force);
    r->hole_count++;
    vbss_thread *thread = p->sutures[h->suture].thread;
    VBSS_TRY(vbss_thread_get_view(thread, VBSS_THREAD_VIEW_POSITIONS, &x, sizeof x));
    VBSS_TRY(vbss_thread_get_view(thread, VBSS_THREAD_VIEW_TENSIONS, &tensions, sizeof tensions));
    VBSS_TRY(vbss_thread_get_view(thread, VBSS_THREAD_VIEW_REST_LENGTHS, &lengths, sizeof lengths));
    const double *rest = lengths.data, *tension = tensions.data;
    uint32_t at = 0;
    for (double along = h->along - rest[0]; along > 0.0 && at + 1 < lengths.count;) {
        along -= rest[++at];
    }
    if (at < BESIDE || at + BESIDE >= lengths.count) {
        return VBSS_OK;
    }
    const vec3 *node = (const vec3 *)x.data;
    const vec3 before = vec3_sub(node[at - BESIDE + 1], node[at - BESIDE]),
               after = vec3_sub(node[at + BESIDE + 1], node[at + BESIDE]);
    const double cosine = vec3_dot(before, after) / (vec3_norm(before) * vec3_norm(after));
    h->angle = vbss_acos(fmax(-1.0, fmin(1.0, cosine)));
    h->tension[0] = tension[at - BESIDE];
    h->tension[1] = tension[at + BESIDE];
    return VBSS_OK;
}

static vbss_result measure_holes(pad *p, pad_report *r)
{
    vbss_scene_hole hole;
    for (uint32_t i = 0; r->hole_count < PAD_MAX_HOLES &&
                         vbss_scene_get_hole(p->scene, i, &hole, sizeof hole) == VBSS_OK;
         i++) {
        r->needle_holes += hole.thread == 0;
        if (hole.thread != 0) {
            VBSS_TRY(measure_hole(p, &hole, r));
        }
    }
    return VBSS_OK;
}

static vbss_result measure_crossings(pad *p, pad_report *r)
{
    scripted_surface surface = {.vertices = skin_nodes(p),
                                .triangles = (const uint32_t(*)[3])p->sheet.triangles,
                                .triangle_count = PAD_TRIANGLES,
                                .near_hole = near_hole};
    scripted_find_holes(p->scene, &surface);
    for (uint32_t i = 0; i < PAD_THREADS; i++) {
        const pad_suture *s = &p->sutures[i];
        vbss_view chain;
        if (s->thread != NULL) {
            VBSS_TRY(
                vbss_thread_get_view(s->thread, VBSS_THREAD_VIEW_POSITIONS, &chain, sizeof chain));
            r->crossings += scripted_count_crossings(&surface, &chain);
        }
        if (s->has_needle) {
            VBSS_TRY(
                vbss_needle_get_view(s->needle, VBSS_NEEDLE_VIEW_POINTS, &chain, sizeof chain));
            r->crossings += scripted_count_crossings(&surface, &chain);
        }
    }
    return VBSS_OK;
}

vbss_result pad_measure(pad *p, pad_report *r)
{
    memset(r, 0, sizeof *r);
    measure_skin(p, r);
    r->end_force[0] = p->tail.force;
    r->end_force[1] = p->bite > 0 ? p->tension : 0.0;
    VBSS_TRY(measure_holes(p, r));
    return measure_crossings(p, r);
}
