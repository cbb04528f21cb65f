/* Reads threads, drains, needles and graspers by their handles, for the folders after scene. */
#include "scene/api/api.h"
#include "scene/api/inspect.h"

_Static_assert(sizeof(drain_edge) == 4 * sizeof(uint32_t), "edges are read as four numbers");
_Static_assert(SCENE_INSPECT_NONE == DRAIN_NONE, "the arrays of a mesh are handed out as they are");

vbss_result vbss_scene_inspect_handle(scene_handle_type type, const void *handle, vbss_slot **slot)
{
    static const vbss_kind *const kinds[] = {[SCENE_HANDLE_SCENE] = &vbss_scene_kind,
                                             [SCENE_HANDLE_THREAD] = &vbss_thread_kind,
                                             [SCENE_HANDLE_DRAIN] = &vbss_drain_kind,
                                             [SCENE_HANDLE_NEEDLE] = &vbss_needle_kind,
                                             [SCENE_HANDLE_GRASPER] = &vbss_grasper_kind_of_slot};
    return vbss_slot_open(handle, kinds[type], slot);
}

static const void *object_of(const void *handle)
{
    return ((const vbss_slot *)handle)->object;
}

scene_thread_info vbss_scene_inspect_thread(const vbss_thread *thread)
{
    const thread_object *t = object_of(thread);
    return (scene_thread_info){.is_guarded = t->method->is_guarded,
                               .node_count = t->node_count,
                               .node_capacity = t->node_capacity,
                               .radius = t->config.radius,
                               .length = vbss_thread_arc_length(t, t->node_count - 1),
                               .positions = t->now.x,
                               .rest_lengths = t->rest,
                               .tensions = t->now.tension};
}

scene_drain_info vbss_scene_inspect_drain(const vbss_drain *drain)
{
    const drain_object *d = object_of(drain);
    const drain_mesh *m = &d->mesh;
    return (scene_drain_info){.is_surface = d->method->is_surface,
                              .radius = d->config.radius,
                              .thickness = d->config.thickness,
                              .centre = d->frame.position,
                              .orientation = d->frame.orientation,
                              .node_count = m->node_count,
                              .triangle_count = m->triangle_count,
                              .edge_count = m->edge_count,
                              .anchor_count = m->anchor_count,
                              .torn_anchor_count = d->statistics.torn,
                              .anchor_load = d->anchor_load,
                              .marks = {m->marks[0], m->marks[1]},
                              .slit_middle = {m->slit_middle[0], m->slit_middle[1]},
                              .positions = d->x,
                              .rest_positions = m->rest,
                              .material_coordinates = (const double(*)[2])m->material_coordinates,
                              .triangles = (const uint32_t(*)[3])m->triangles,
                              .edges = (const uint32_t(*)[4])m->edges,
                              .first_edge = m->first_edge,
                              .next_edge = m->next_edge};
}

scene_needle_info vbss_scene_inspect_needle(const vbss_needle *needle)
{
    const needle_object *n = object_of(needle);
    return (scene_needle_info){.wire_radius = n->config.wire_radius,
                               .arc_radius = n->config.radius,
                               .length = vbss_needle_length(n),
                               .arc = n->config.arc,
                               .pose = vbss_needle_pose(n)};
}

scene_line_point vbss_scene_inspect_needle_point(const scene_needle_info *needle, double arc_length)
{
    const double radius = needle->arc_radius, arc = needle->arc;
    return (scene_line_point){.position = vbss_needle_line_point(radius, arc, arc_length),
                              .direction = vbss_needle_line_direction(radius, arc, arc_length)};
}

static scene_capsule_info describe_capsule(const grasper_capsule *c)
{
    return (scene_capsule_info){.axis = {c->axis[0], c->axis[1]}, .radius = c->radius};
}

scene_grasper_info vbss_scene_inspect_grasper(const vbss_grasper *grasper)
{
    const grasper_object *g = object_of(grasper);
    grasper_capsule capsules[GRASPER_CAPSULES];
    vbss_grasper_compute_capsules(g, g->jaw_angle, capsules);
    return (scene_grasper_info){
        .kind = g->kind,
        .jaw_angle = g->jaw_angle,
        .pose = g->tool_pose,
        .forward = quat_rotate(vbss_grasper_jaw_frame(g).orientation, vec3_make(0.0, 0.0, -1.0)),
        .shaft = describe_capsule(&capsules[GRASPER_SHAFT]),
        .jaws = {describe_capsule(&capsules[GRASPER_JAW]),
                 describe_capsule(&capsules[GRASPER_JAW + 1])},
        .neck = describe_capsule(&capsules[GRASPER_NECK])};
}

scene_geometry vbss_scene_inspect_geometry(const scene_body_info *body)
{
    if (body->thread != NULL) {
        return (scene_geometry){.type = SCENE_GEOMETRY_THREAD,
                                .identity = body->thread,
                                .thread = vbss_scene_inspect_thread(body->thread)};
    }
    if (body->drain != NULL) {
        return (scene_geometry){.type = SCENE_GEOMETRY_DRAIN,
                                .identity = body->drain,
                                .drain = vbss_scene_inspect_drain(body->drain)};
    }
    if (body->needle != NULL) {
        return (scene_geometry){.type = SCENE_GEOMETRY_NEEDLE,
                                .identity = body->needle,
                                .needle = vbss_scene_inspect_needle(body->needle)};
    }
    if (body->grasper != NULL) {
        return (scene_geometry){.type = SCENE_GEOMETRY_GRASPER,
                                .identity = body->grasper,
                                .grasper = vbss_scene_inspect_grasper(body->grasper)};
    }
    return (scene_geometry){.type = SCENE_GEOMETRY_CAPSULES};
}
