/* Memory of drains, and their construction. */
#include "drain/surface.h"

#include "base/check.h"
#include "base/error.h"
#include "base/memory.h"

#include <string.h>

/* ---- memory: the table of arrays */

enum { ARRAY_COUNT = 19 + DRAIN_TANGENTS };

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
        {&d->tangents[0].shape, n, sizeof *d->tangents[0].shape},
        {&d->tangents[1].shape, n, sizeof *d->tangents[1].shape},
        {&d->tangents[2].shape, n, sizeof *d->tangents[2].shape},
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

void vbss_drain_free(vbss_context *context, void *object)
{
    drain_object *d = object;
    vbss_array arrays[ARRAY_COUNT], mesh_arrays[DRAIN_MESH_ARRAYS];
    size_t count = list_arrays(d, arrays);
    vbss_drain_mesh_arrays(&d->mesh, mesh_arrays);
    d->method->destroy_drain(context, d);
    vbss_drain_free_surface(context, d);
    vbss_release_arrays(context, arrays, count);
    vbss_release_arrays(context, mesh_arrays, DRAIN_MESH_ARRAYS);
    vbss_release(context, d, 1, sizeof *d);
}

/* ---- construction */

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
        .triangle_young = d->triangle_young_modulus,
        .triangle_thickness = d->triangle_thickness,
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

vbss_result vbss_drain_build(drain_object *d, const vbss_drain_config *config)
{
    quat orientation;
    d->method = config->method == VBSS_METHOD_VBLAST ? &vbss_baseline_drain : &vbss_drain_implicit;
    d->config = *config;
    d->baseline_config = *config->baseline;
    d->config.baseline = &d->baseline_config;
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
    VBSS_TRY(vbss_drain_copy_surface(d));
    VBSS_TRY(create_shell(d));
    init_positions(d);
    return d->method->create_drain(d);
}
