/* Views of a drain: arrays, landmarks, energies, statistics. */
#include "base/api_call.h"
#include "base/config.h"
#include "base/error.h"
#include "drain/drain.h"

#include <string.h>

_Static_assert(sizeof(vbss_drain_places) == 32, "published size");
_Static_assert(sizeof(vbss_drain_energies) == 56, "published size");
_Static_assert(sizeof(vbss_drain_statistics) == 88, "published size");

static const uint32_t places_sizes[] = {32, 0}, energies_sizes[] = {56, 0};
static const uint32_t statistics_sizes[] = {80, 88, 0};
static const vbss_layout places_layout = {"vbss_drain_places", NULL, places_sizes};
static const vbss_layout energies_layout = {"vbss_drain_energies", NULL, energies_sizes};
static const vbss_layout statistics_layout = {"vbss_drain_statistics", NULL, statistics_sizes};

/* ---- arrays */

static void fill_anchor_forces(drain_object *d)
{
    memset(d->view_forces, 0, d->mesh.node_count * sizeof *d->view_forces);
    vbss_shell_add_forces(&d->shell, d->x, d->view_forces);
    for (uint32_t i = 0; i < d->mesh.anchor_count; i++) {
        d->anchor_forces[i] = vbss_drain_anchor_force(d, i, d->view_forces);
        if (!d->torn[i]) {
            d->anchor_forces[i] =
                vec3_sub(d->anchor_forces[i], d->contact_forces[d->mesh.anchors[i]]);
        }
    }
}

static void fill_strains(drain_object *d)
{
    vbss_shell_compute_responses(&d->shell, d->x, d->shell_responses);
    for (uint32_t t = 0; t < d->mesh.triangle_count; t++) {
        memcpy(d->strains[t], d->shell_responses[t].strain, sizeof d->strains[t]);
        memcpy(d->curvatures[t], d->shell_responses[t].curvature, sizeof d->curvatures[t]);
    }
}

static vbss_view triples(const void *data, uint64_t count)
{
    vbss_view view = {0, VBSS_VIEW_TYPE_F64, 3, sizeof(vec3), count, data, 0};
    return view;
}

static vbss_view numbers(const uint32_t *data, uint64_t count)
{
    vbss_view view = {0, VBSS_VIEW_TYPE_U32, 1, sizeof *data, count, data, 0};
    return view;
}

static vbss_result get_field(drain_object *d, vbss_drain_field field, vbss_view *view)
{
    const drain_mesh *m = &d->mesh;
    switch (field) {
    case VBSS_DRAIN_VIEW_POSITIONS:
        *view = triples(d->x, m->node_count);
        return VBSS_OK;
    case VBSS_DRAIN_VIEW_VELOCITIES:
        *view = triples(d->v, m->node_count);
        return VBSS_OK;
    case VBSS_DRAIN_VIEW_REST_POSITIONS:
        *view = triples(m->rest, m->node_count);
        return VBSS_OK;
    case VBSS_DRAIN_VIEW_TRIANGLES:
        *view = (vbss_view){
            0, VBSS_VIEW_TYPE_U32, 3, sizeof *m->triangles, m->triangle_count, m->triangles, 0};
        return VBSS_OK;
    case VBSS_DRAIN_VIEW_SLIT_LEFT:
        *view = numbers(m->slit_nodes[DRAIN_LEFT], m->slit_count);
        return VBSS_OK;
    case VBSS_DRAIN_VIEW_SLIT_RIGHT:
        *view = numbers(m->slit_nodes[DRAIN_RIGHT], m->slit_count);
        return VBSS_OK;
    case VBSS_DRAIN_VIEW_ANCHORS:
        *view = numbers(m->anchors, m->anchor_count);
        return VBSS_OK;
    case VBSS_DRAIN_VIEW_ANCHOR_FORCES:
        fill_anchor_forces(d);
        *view = triples(d->anchor_forces, m->anchor_count);
        return VBSS_OK;
    case VBSS_DRAIN_VIEW_STRAINS:
        fill_strains(d);
        *view = triples(d->strains, m->triangle_count);
        return VBSS_OK;
    case VBSS_DRAIN_VIEW_CURVATURES:
        fill_strains(d);
        *view = triples(d->curvatures, m->triangle_count);
        return VBSS_OK;
    default:
        return vbss_fail(d->context, VBSS_ERROR_OUT_OF_RANGE, "a drain has no field %d", field);
    }
}

vbss_result vbss_drain_get_view(vbss_drain *drain, vbss_drain_field field, vbss_view *view,
                                uint32_t struct_size)
{
    VBSS_ENTER(drain);
    drain_object *d;
    vbss_view own;
    VBSS_TRY(vbss_drain_open(drain, &d));
    VBSS_TRY(get_field(d, field, &own));
    own.generation = d->generation;
    return vbss_struct_write(d->context, &vbss_view_layout, &own, view, struct_size);
}

/* ---- landmarks */

vbss_result vbss_drain_get_places(vbss_drain *drain, vbss_drain_places *places,
                                  uint32_t struct_size)
{
    VBSS_ENTER(drain);
    drain_object *d;
    VBSS_TRY(vbss_drain_open(drain, &d));
    const drain_mesh *m = &d->mesh;
    const vbss_drain_places own = {
        .struct_size = sizeof own,
        .node_count = m->node_count,
        .triangle_count = m->triangle_count,
        .marks = {m->marks[DRAIN_LEFT], m->marks[DRAIN_RIGHT]},
        .gap_points = {m->slit_middle[DRAIN_LEFT], m->slit_middle[DRAIN_RIGHT]}};
    return vbss_struct_write(d->context, &places_layout, &own, places, struct_size);
}

/* ---- sums over the drain */

vbss_result vbss_drain_get_energies(vbss_drain *drain, vbss_drain_energies *energies,
                                    uint32_t struct_size)
{
    VBSS_ENTER(drain);
    drain_object *d;
    VBSS_TRY(vbss_drain_open(drain, &d));
    vbss_drain_energies own = {.struct_size = sizeof own};
    d->method->add_energies(d, &own);
    for (uint32_t i = 0; i < d->mesh.node_count; i++) {
        own.kinetic += 0.5 * d->mass[i] * vec3_norm_squared(d->v[i]);
        own.gravity -= d->mass[i] * vec3_dot(d->gravity, d->x[i]);
    }
    for (uint32_t k = 0; k < d->config.attachment_capacity; k++) {
        const drain_attachment *a = &d->attachments[k];
        if (a->id != 0 && a->kind == VBSS_DRAIN_ATTACHMENT_SPRING) {
            vec3 extension = vec3_sub(a->position, d->x[a->node]);
            own.springs += 0.5 * a->stiffness * vec3_norm_squared(extension);
        }
    }
    own.total = own.kinetic + own.membrane + own.bending + own.springs + own.gravity;
    return vbss_struct_write(d->context, &energies_layout, &own, energies, struct_size);
}

vbss_result vbss_drain_get_statistics(vbss_drain *drain, vbss_drain_statistics *statistics,
                                      uint32_t struct_size)
{
    VBSS_ENTER(drain);
    drain_object *d;
    VBSS_TRY(vbss_drain_open(drain, &d));
    vbss_drain_statistics own = d->statistics;
    own.struct_size = sizeof own;
    for (uint32_t t = 0; t < d->mesh.triangle_count; t++) {
        own.inverted += vbss_shell_is_inverted(&d->shell, t, d->x);
    }
    return vbss_struct_write(d->context, &statistics_layout, &own, statistics, struct_size);
}
