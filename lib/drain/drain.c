/* Creation, memory, handles and steps of drains. */
#include "drain/drain.h"

#include "base/check.h"
#include "base/error.h"
#include "base/stream.h"

#include <string.h>

/* ---- memory: the table of arrays */

enum { ARRAY_COUNT = 19 };

static size_t list_arrays(drain_object *d, vbss_array arrays[ARRAY_COUNT])
{
    size_t n = d->mesh.node_count, m = d->mesh.triangle_count, anchors = d->mesh.anchor_count;
    const vbss_array all[] = {
        {&d->groups, vbss_shell_group_count(d->mesh.triangle_count), sizeof *d->groups},
        {&d->mass, n, sizeof *d->mass},
        {&d->anchor_strength, anchors, sizeof *d->anchor_strength},
        {&d->x, n, sizeof *d->x},
        {&d->v, n, sizeof *d->v},
        {&d->torn, anchors, sizeof *d->torn},
        {&d->attachments, d->config.attachment_capacity, sizeof *d->attachments},
        {&d->anchored, n, sizeof *d->anchored},
        {&d->trial, n, sizeof *d->trial},
        {&d->internal_forces, n, sizeof *d->internal_forces},
        {&d->v_substep_start, n, sizeof *d->v_substep_start},
        {&d->contact_forces, n, sizeof *d->contact_forces},
        {&d->saved_x, n, sizeof *d->saved_x},
        {&d->saved_v, n, sizeof *d->saved_v},
        {&d->anchor_forces, anchors, sizeof *d->anchor_forces},
        {&d->view_forces, n, sizeof *d->view_forces},
        {&d->strains, m, sizeof *d->strains},
        {&d->curvatures, m, sizeof *d->curvatures},
        {&d->shell_responses, m, sizeof *d->shell_responses},
    };
    _Static_assert(sizeof all <= ARRAY_COUNT * sizeof(vbss_array), "the table is long enough");
    memcpy(arrays, all, sizeof all);
    return sizeof all / sizeof all[0];
}

static void free_drain(vbss_context *context, void *object)
{
    drain_object *d = object;
    vbss_array arrays[ARRAY_COUNT], mesh_arrays[DRAIN_MESH_ARRAYS];
    size_t count = list_arrays(d, arrays);
    vbss_drain_mesh_arrays(&d->mesh, mesh_arrays);
    d->method->destroy_drain(context, d);
    vbss_release_arrays(context, arrays, count);
    vbss_release_arrays(context, mesh_arrays, DRAIN_MESH_ARRAYS);
    vbss_release(context, d, 1, sizeof *d);
}

const vbss_kind vbss_drain_kind = {"drain", VBSS_CODE('D', 'R', 'A', 'N'), 1, free_drain,
                                   vbss_drain_serialise};

/* ---- creation */

/* The baseline method uses the shell for masses and strains only. */
static vbss_result create_shell(drain_object *d)
{
    const drain_mesh *m = &d->mesh;
    const vbss_drain_config *c = &d->config;
    const vbss_shell_input input = {
        .node_count = m->node_count,
        .triangle_count = m->triangle_count,
        .rest = m->rest,
        .triangles = (const uint32_t(*)[3])m->triangles,
        .opposite_node = (const uint32_t(*)[3])m->opposite_node,
        .angular_widths = m->angular_width,
        .young = c->young_modulus,
        .thickness = c->thickness,
        .density = c->density,
        .poisson = c->poisson_ratio,
        .moment_free_edges = true,
    };
    VBSS_TRY(vbss_shell_init(d->context, &input, d->groups, &d->shell));
    vbss_shell_add_masses(&d->shell, d->mass);
    return VBSS_OK;
}

static void init_positions(drain_object *d)
{
    for (uint32_t i = 0; i < d->mesh.node_count; i++) {
        d->x[i] = pose_apply(d->frame, d->mesh.rest[i]);
    }
    for (uint32_t i = 0; i < d->mesh.anchor_count; i++) {
        d->anchor_strength[i] = d->config.tear_stress * d->mesh.node_area[d->mesh.anchors[i]];
    }
    vbss_drain_update_anchored(d);
}

/* Does all that can fail. On failure the caller frees the object. */
static vbss_result build_drain(drain_object *d, const vbss_drain_config *config)
{
    quat orientation;
    d->config = *config;
    VBSS_TRY(vbss_read_orientation(d->context, config->orientation, &orientation));
    d->frame = pose_make(vec3_load(config->position), orientation);
    d->gravity = vec3_load(config->gravity);
    const drain_mesh_kind kind = d->method->mesh_kind(config);
    drain_mesh_options options = vbss_drain_mesh_options_of(config, kind);
    VBSS_TRY(vbss_drain_mesh_plan(d->context, &options, &d->mesh));
    vbss_array arrays[ARRAY_COUNT], mesh_arrays[DRAIN_MESH_ARRAYS];
    size_t count = list_arrays(d, arrays);
    vbss_drain_mesh_arrays(&d->mesh, mesh_arrays);
    VBSS_TRY(vbss_allocate_arrays(d->context, mesh_arrays, DRAIN_MESH_ARRAYS, "mesh of a drain"));
    VBSS_TRY(vbss_allocate_arrays(d->context, arrays, count, "drain"));
    vbss_drain_mesh_fill(&d->mesh);
    VBSS_TRY(create_shell(d));
    init_positions(d);
    return d->method->create_drain(d);
}

vbss_result vbss_drain_create(vbss_context *context, const vbss_drain_config *config,
                              vbss_drain **drain)
{
    if (drain == NULL) {
        VBSS_TRY(vbss_context_open(context));
        return vbss_check_pointer(context, drain, "drain");
    }
    *drain = NULL;
    VBSS_TRY(vbss_context_open(context));
    VBSS_TRY(vbss_context_edit(context));
    vbss_drain_config own;
    VBSS_TRY(vbss_drain_read_config(context, config, &own));
    drain_object *d = vbss_allocate(context, 1, sizeof *d, "drain");
    if (d == NULL) {
        return VBSS_ERROR_OUT_OF_MEMORY;
    }
    d->context = context;
    d->method = own.method == VBSS_METHOD_PAPER ? &vbss_baseline_drain : &vbss_drain_implicit;
    vbss_slot *slot = NULL;
    vbss_result result = build_drain(d, &own);
    if (result == VBSS_OK) {
        result = vbss_slot_create(context, &vbss_drain_kind, d, &slot);
    }
    if (result != VBSS_OK) {
        free_drain(context, d);
        return result;
    }
    *drain = (vbss_drain *)slot;
    return VBSS_OK;
}

vbss_result vbss_drain_destroy(vbss_drain *drain)
{
    return vbss_slot_destroy(drain, &vbss_drain_kind);
}

/* ---- handles */

vbss_result vbss_drain_open(const vbss_drain *handle, drain_object **drain)
{
    vbss_slot *slot;
    VBSS_TRY(vbss_slot_open(handle, &vbss_drain_kind, &slot));
    *drain = slot->object;
    return VBSS_OK;
}

vbss_result vbss_drain_edit(vbss_drain *handle, drain_object **drain)
{
    vbss_slot *slot;
    VBSS_TRY(vbss_slot_edit(handle, &vbss_drain_kind, &slot));
    *drain = slot->object;
    return VBSS_OK;
}

vbss_result vbss_drain_edit_unowned(vbss_drain *handle, drain_object **drain)
{
    vbss_slot *slot;
    VBSS_TRY(vbss_slot_edit_unowned(handle, &vbss_drain_kind, &slot));
    *drain = slot->object;
    return VBSS_OK;
}

/* ---- step and state */

/* Runs a step; on failure nothing changes. */
static vbss_result run_step(drain_object *d, double h)
{
    const vbss_drain_statistics before = d->statistics;
    size_t bytes = d->mesh.node_count * sizeof *d->x;
    memcpy(d->saved_x, d->x, bytes);
    memcpy(d->saved_v, d->v, bytes);
    d->statistics.last_move = 0.0;
    vbss_result result = d->method->step_drain(d, h);
    if (result != VBSS_OK) {
        d->statistics = before;
        memcpy(d->x, d->saved_x, bytes);
        memcpy(d->v, d->saved_v, bytes);
        return result != VBSS_ERROR_NOT_FINITE
                   ? result
                   : vbss_fail(d->context, result, "drain step: no finite state after step %llu",
                               (unsigned long long)before.steps);
    }
    vbss_drain_finish_step(d, h);
    return VBSS_OK;
}

vbss_result vbss_drain_step(vbss_drain *drain, double h)
{
    drain_object *d;
    VBSS_TRY(vbss_drain_edit_unowned(drain, &d));
    VBSS_TRY(vbss_check_range(d->context, h, 1e-7, 0.1, "h"));
    VBSS_TRY(vbss_check_arithmetic(d->context));
    return run_step(d, h);
}

static vbss_result check_state(const drain_object *d, const double *positions,
                               const double *velocities)
{
    for (uint32_t i = 0; i < d->mesh.node_count; i++) {
        const double *x = positions != NULL ? positions + 3 * (size_t)i : &d->x[i].x;
        const double *v = velocities != NULL ? velocities + 3 * (size_t)i : &d->v[i].x;
        VBSS_TRY(vbss_check_finite(d->context, x, 3, "a position"));
        VBSS_TRY(vbss_check_finite(d->context, v, 3, "a velocity"));
        VBSS_TRY(vbss_check_range(d->context, vbss_max_abs(x, 3), 0.0, 1e3, "a position"));
        VBSS_TRY(vbss_check_range(d->context, vbss_max_abs(v, 3), 0.0, 1e5, "a velocity"));
        bool moves = vec3_distance(vec3_load(x), d->x[i]) > 0.0 || vbss_max_abs(v, 3) > 0.0;
        if (d->anchored[i] && moves) {
            return vbss_fail(d->context, VBSS_ERROR_OUT_OF_RANGE, "node %u is anchored", i);
        }
    }
    return VBSS_OK;
}

void vbss_drain_invalidate(drain_object *d)
{
    d->generation++;
    d->edit_generation++;
}

vbss_result vbss_drain_set_state(vbss_drain *drain, const double *positions,
                                 const double *velocities, uint32_t node_count)
{
    drain_object *d;
    VBSS_TRY(vbss_drain_edit(drain, &d));
    double nodes = d->mesh.node_count;
    VBSS_TRY(vbss_check_range(d->context, node_count, nodes, nodes, "node_count"));
    VBSS_TRY(check_state(d, positions, velocities));
    for (uint32_t i = 0; i < node_count; i++) {
        d->x[i] = positions != NULL ? vec3_load(positions + 3 * (size_t)i) : d->x[i];
        d->v[i] = velocities != NULL ? vec3_load(velocities + 3 * (size_t)i) : d->v[i];
    }
    vbss_drain_invalidate(d);
    return VBSS_OK;
}
