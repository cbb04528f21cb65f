/* A thread with an adaptive mesh lies over the edges of a rigid mesh that moves and turns under it: the thread is divided at the
 * edges and passes through no triangle, in the steps or as its mesh changes. */
#include "scene/box_mesh.h"
#include "scene/line_crossing.h"
#include "scene/small.h"

#define THICKNESS 0.5e-3

static const vec3 half = {4e-3, 2e-3, 20e-3}; /* of the box, m */

/* The box goes to and fro along x and turns to and fro about y. */
static void move_box(const small *s, uint32_t body, double time)
{
    const double angle = 0.25 * sin(6.0 * time); /* half of it, rad */
    const double position[3] = {1.5e-3 * sin(9.0 * time), 0.0, 0.0};
    const double orientation[4] = {cos(angle), 0.0, sin(angle), 0.0};
    expect_ok(vbss_scene_set_rigid_target(s->scene, body, position, orientation));
}

/* Both ends of the thread are drawn down beside the box, so that it is bent over the edges, and up again. */
static void move_ends(small *s, const uint32_t ends[2], double height, double time)
{
    const double part = fmin(fmin(time, 1.5 - time) / 0.4, 1.0);
    for (int k = 0; k < 2; k++) {
        const double outward = k == 0 ? -1.0 : 1.0;
        small_move(
            s, ends[k],
            vec3_make(outward * (20e-3 - 8e-3 * part), height - 13.4e-3 * part, outward * 1e-3));
    }
}

static vec3 corner_of(const box_mesh *b, const vbss_scene_rigid_state *frame, uint32_t vertex)
{
    const quat q = {frame->orientation[0], frame->orientation[1], frame->orientation[2],
                    frame->orientation[3]};
    return vec3_add(vec3_load(frame->position), quat_rotate(q, vec3_load(b->vertices[vertex])));
}

static uint32_t crossings(const small *s, const box_mesh *b, uint32_t body, vbss_thread *thread,
                          uint32_t nodes)
{
    const vbss_scene_rigid_state frame = small_rigid(s, body);
    uint32_t count = 0;
    for (uint32_t t = 0; t < BOX_TRIANGLES; t++) {
        vec3 corner[3];
        double weights[3];
        for (int k = 0; k < 3; k++) {
            corner[k] = corner_of(b, &frame, box_mesh_triangles[t][k]);
        }
        for (uint32_t i = 0; i + 1 < nodes; i++) {
            count += line_crosses_triangle(small_node(thread, i), small_node(thread, i + 1), corner,
                                           weights);
        }
    }
    return count;
}

static void adaptive_thread_passes_no_edge_of_a_moving_mesh(void **state)
{
    (void)state;
    small s;
    box_mesh b;
    vbss_thread *thread;
    vbss_thread_statistics now;
    uint32_t body = 0, ends[2];
    double touched = 0.0;
    small_begin(&s);
    s.config.floor = 0;
    s.config.node_capacity = 400;
    s.thread.mesh = VBSS_THREAD_MESH_ADAPTIVE;
    s.thread.node_capacity = 200;
    s.thread.gravity[1] = -9.81;
    small_create(&s);
    box_mesh_make(&b, half, THICKNESS);
    s.rigid.kind = VBSS_SCENE_RIGID_DRIVEN;
    s.rigid.capsules = NULL;
    s.rigid.capsule_count = 0;
    expect_ok(vbss_scene_add_rigid_mesh(s.scene, &s.rigid, &b.config, &body));
    const double top = half.y + 0.5 * THICKNESS + s.thread.radius + 0.1e-3;
    const uint32_t number =
        small_thread(&s, vec3_make(-20e-3, top, -1e-3), vec3_make(20e-3, top, 1e-3), 20, &thread);
    for (uint32_t k = 0; k < 2; k++) {
        const vec3 end = small_node(thread, 20 * k);
        ends[k] = small_stick(&s, VBSS_SCENE_RIGID_DRIVEN, end, vec3_make(0.0, 0.0, 1e-3), 0.2e-3);
        small_pin(&s, number, 20 * k, ends[k]);
    }
    for (int i = 1; i <= 1500; i++) {
        move_box(&s, body, 1e-3 * i);
        move_ends(&s, ends, top, 1e-3 * i);
        small_steps(&s, 1, 1e-3);
        expect_ok(vbss_thread_get_statistics(thread, &now, sizeof now));
        assert_int_equal(crossings(&s, &b, body, thread, now.nodes), 0);
        touched = fmax(touched, vec3_norm(vec3_load(small_rigid(&s, body).contact_force)));
    }
    assert_true(touched > 1e-3);
    assert_true(now.refined >= 8 && now.coarsened >= 6);
    small_end(&s);
}

int test_adaptive_rigid_mesh(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(adaptive_thread_passes_no_edge_of_a_moving_mesh),
    };
    return cmocka_run_group_tests_name("scene.adaptive_rigid_mesh", tests, NULL, NULL);
}
