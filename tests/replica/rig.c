#include "rig.h"

#include <string.h>

#include "scene/api/inspect.h"

/* ---- from the scene */

static void add_number(vbss_hash *hash, uint64_t number)
{
    vbss_hash_add(hash, &number, sizeof number);
}

static void add_view(vbss_hash *hash, const vbss_view *view)
{
    const size_t size = view->type == VBSS_VIEW_TYPE_U32 ? sizeof(uint32_t) : sizeof(double);
    for (uint64_t i = 0; i < view->count; i++) {
        vbss_hash_add(hash, (const char *)view->data + i * view->stride_bytes,
                      view->components * size);
    }
}

/* Tensions have no view of their own: that of the thread has forces of bending, too. */
static void add_thread(vbss_hash *hash, vbss_thread *thread)
{
    vbss_view positions;
    const double none = 0.0;
    const scene_thread_info info = vbss_scene_inspect_thread(thread);
    expect_ok(
        vbss_thread_get_view(thread, VBSS_THREAD_VIEW_POSITIONS, &positions, sizeof positions));
    add_number(hash, positions.count);
    add_view(hash, &positions);
    vbss_hash_add(hash, info.tensions, (info.node_count - 1) * sizeof *info.tensions);
    vbss_hash_add(hash, &none, sizeof none);
}

static void add_drain(vbss_hash *hash, vbss_drain *drain)
{
    const vbss_drain_field fields[2] = {VBSS_DRAIN_VIEW_POSITIONS, VBSS_DRAIN_VIEW_TRIANGLES};
    for (int i = 0; i < 2; i++) {
        vbss_view view;
        expect_ok(vbss_drain_get_view(drain, fields[i], &view, sizeof view));
        add_number(hash, view.count);
        add_view(hash, &view);
    }
}

static void add_rigid(vbss_hash *hash, vbss_scene *scene, const scene_body_info *body)
{
    vbss_scene_rigid_state state;
    vbss_grasper_state tool = {.jaw_angle = 0.0};
    expect_ok(vbss_scene_get_rigid(scene, body->number, &state, sizeof state));
    vbss_hash_add(hash, state.position, sizeof state.position);
    vbss_hash_add(hash, state.orientation, sizeof state.orientation);
    if (body->grasper != NULL) {
        expect_ok(vbss_grasper_get_state(body->grasper, &tool, sizeof tool));
    }
    vbss_hash_add(hash, &tool.jaw_angle, sizeof tool.jaw_angle);
    for (uint32_t i = 0; i < body->capsule_count; i++) {
        const scene_capsule_info c = vbss_scene_inspect_capsule(scene, body, i);
        vbss_hash_add(hash, &c, sizeof c);
    }
}

static void add_holes(vbss_hash *hash, vbss_scene *scene)
{
    vbss_scene_hole hole;
    for (uint32_t i = 0; vbss_scene_get_hole(scene, i, &hole, sizeof hole) == VBSS_OK; i++) {
        const uint32_t bodies[4] = {hole.id, hole.needle, hole.thread, hole.drain};
        vbss_hash_add(hash, bodies, sizeof bodies);
        vbss_hash_add(hash, hole.position, sizeof hole.position);
        vbss_hash_add(hash, hole.rest_position, sizeof hole.rest_position);
        vbss_hash_add(hash, &hole.arc_length, sizeof hole.arc_length);
    }
}

uint64_t rig_hash_scene(vbss_scene *scene)
{
    vbss_hash hash;
    scene_info info;
    vbss_scene_statistics statistics;
    vbss_hash_begin(&hash);
    expect_ok(vbss_scene_get_statistics(scene, &statistics, sizeof statistics));
    add_number(&hash, statistics.steps);
    vbss_hash_add(&hash, &statistics.time, sizeof statistics.time);
    expect_ok(vbss_scene_inspect(scene, &info));
    for (uint32_t i = 0; i < info.entry_count; i++) {
        const scene_body_info body = vbss_scene_inspect_entry(scene, i);
        if (body.number == 0) {
            continue;
        }
        add_number(&hash, body.number);
        if (body.thread != NULL) {
            add_thread(&hash, body.thread);
        } else if (body.drain != NULL) {
            add_drain(&hash, body.drain);
        } else {
            add_rigid(&hash, scene, &body);
        }
    }
    add_holes(&hash, scene);
    for (vbss_scene_field field = VBSS_SCENE_VIEW_CONTACTS; field <= VBSS_SCENE_VIEW_CONTACT_GAPS;
         field++) {
        vbss_view view;
        expect_ok(vbss_scene_get_view(scene, field, &view, sizeof view));
        add_view(&hash, &view);
    }
    return vbss_hash_end(&hash);
}

/* ---- from the replica */

vbss_view rig_view(vbss_replica *replica, vbss_replica_field field)
{
    vbss_view view;
    expect_ok(vbss_replica_get_view(replica, field, &view, sizeof view));
    return view;
}

/* Some items of a view. */
static void add_rows(vbss_hash *hash, const vbss_view *view, uint32_t first, uint32_t count)
{
    vbss_view part = *view;
    part.data = (const char *)view->data + (size_t)first * view->stride_bytes;
    part.count = count;
    add_view(hash, &part);
}

typedef struct body_row {
    uint32_t kind, number, first_node, node_count, first_triangle, triangle_count, first_capsule,
        capsule_count;
} body_row;

static void add_body(vbss_hash *hash, vbss_replica *replica, const body_row *row, uint32_t index)
{
    const vbss_view nodes = rig_view(replica, VBSS_REPLICA_VIEW_NODES);
    const vbss_view tensions = rig_view(replica, VBSS_REPLICA_VIEW_TENSIONS);
    const vbss_view triangles = rig_view(replica, VBSS_REPLICA_VIEW_TRIANGLES);
    const vbss_view poses = rig_view(replica, VBSS_REPLICA_VIEW_POSES);
    const vbss_view sizes = rig_view(replica, VBSS_REPLICA_VIEW_SIZES);
    const vbss_view capsules = rig_view(replica, VBSS_REPLICA_VIEW_CAPSULES);
    const double *jaws = (const double *)sizes.data + 2 * (size_t)index + 1;
    add_number(hash, row->number);
    if (row->kind == VBSS_REPLICA_KIND_THREAD) {
        add_number(hash, row->node_count);
        add_rows(hash, &nodes, row->first_node, row->node_count);
        add_rows(hash, &tensions, row->first_node, row->node_count);
    } else if (row->kind == VBSS_REPLICA_KIND_DRAIN) {
        add_number(hash, row->node_count);
        add_rows(hash, &nodes, row->first_node, row->node_count);
        add_number(hash, row->triangle_count);
        add_rows(hash, &triangles, row->first_triangle, row->triangle_count);
    } else {
        add_rows(hash, &poses, index, 1);
        vbss_hash_add(hash, jaws, sizeof *jaws);
        add_rows(hash, &capsules, row->first_capsule, row->capsule_count);
    }
}

static void add_hole_rows(vbss_hash *hash, vbss_replica *replica)
{
    const vbss_view holes = rig_view(replica, VBSS_REPLICA_VIEW_HOLES);
    const vbss_view places = rig_view(replica, VBSS_REPLICA_VIEW_HOLE_PLACES);
    assert_true(holes.count == places.count);
    for (uint32_t i = 0; i < holes.count; i++) {
        const double *place = (const double *)places.data + 8 * (size_t)i;
        add_rows(hash, &holes, i, 1);
        vbss_hash_add(hash, place, 6 * sizeof *place);
        vbss_hash_add(hash, &place[7], sizeof *place);
    }
}

uint64_t rig_hash_replica(vbss_replica *replica, const vbss_replica_state *state)
{
    vbss_hash hash;
    const vbss_view bodies = rig_view(replica, VBSS_REPLICA_VIEW_BODIES);
    vbss_hash_begin(&hash);
    add_number(&hash, state->steps);
    vbss_hash_add(&hash, &state->time, sizeof state->time);
    for (uint32_t i = 0; i < bodies.count; i++) {
        body_row row;
        memcpy(&row, (const char *)bodies.data + (size_t)i * bodies.stride_bytes, sizeof row);
        add_body(&hash, replica, &row, i);
    }
    add_hole_rows(&hash, replica);
    for (vbss_replica_field field = VBSS_REPLICA_VIEW_CONTACTS;
         field <= VBSS_REPLICA_VIEW_CONTACT_GAPS; field++) {
        const vbss_view view = rig_view(replica, field);
        add_view(&hash, &view);
    }
    return vbss_hash_end(&hash);
}

vbss_replica_state rig_take(vbss_replica *replica)
{
    vbss_replica_state state;
    expect_ok(vbss_replica_take(replica, &state, sizeof state));
    assert_int_equal(state.is_new, 1);
    return state;
}

void rig_expect_equal(vbss_replica *replica, vbss_scene *scene)
{
    expect_ok(vbss_replica_publish(replica, scene));
    const vbss_replica_state state = rig_take(replica);
    assert_true(rig_hash_replica(replica, &state) == rig_hash_scene(scene));
}
