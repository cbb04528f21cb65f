/* Nodes that are points of bodies: of the world, of driven, coupled and free ones; and that are let go. */
#include "base/elementary.h"
#include "scene/small.h"

static const vec3 half = {0.0, 0.0, 3e-3};

/* A line of 24 mm between two sticks, pinned to the first at node 0. */
typedef struct line {
    small s;
    vbss_thread *thread;
    uint32_t number, stick, pin;
} line;

static void begin_line(line *l, vbss_scene_rigid_kind kind)
{
    small_begin_scene(&l->s);
    l->number = small_thread(&l->s, vec3_zero(), vec3_make(0.024, 0.0, 0.0), 12, &l->thread);
    l->s.rigid.mass = 1e-4;
    l->stick = small_stick(&l->s, kind, vec3_make(-2e-3, 1e-3, 0.0), half, 1e-3);
    l->pin = small_pin(&l->s, l->number, 0, l->stick);
}

static void expect_at(vec3 wanted, vec3 got, double tolerance)
{
    expect_near(0.0, vec3_distance(wanted, got), tolerance);
}

/* Where the pinned point of the stick is now. */
static vec3 pinned_point(const line *l)
{
    vbss_scene_rigid_state r = small_rigid(&l->s, l->stick);
    quat q = quat_make(r.orientation[0], r.orientation[1], r.orientation[2], r.orientation[3]);
    return pose_apply(pose_make(vec3_load(r.position), q), vec3_make(2e-3, -1e-3, 0.0));
}

static void world_pin_stays(void **state)
{
    (void)state;
    small s;
    vbss_thread *thread;
    uint32_t pin;
    const double there[3] = {2e-3, 2e-3, 1e-3};
    small_begin_scene(&s);
    s.thread.gravity[1] = -9.81;
    uint32_t number = small_thread(&s, vec3_zero(), vec3_make(0.024, 0.0, 0.0), 12, &thread);
    small_pin(&s, number, 12, 0);
    expect_ok(vbss_scene_pin_thread(s.scene, number, 0, 0, there, &pin));
    for (int i = 0; i < 30; i++) {
        small_steps(&s, 1, 1e-3);
        expect_at(vec3_make(0.024, 0.0, 0.0), small_node(thread, 12), 1e-17);
        expect_at(vec3_load(there), small_node(thread, 0), 0.0); /* within the first step */
    }
    assert_true(small_node(thread, 6).y < 0.0);
    small_end(&s);
}

/* Carried round: the node is the point of the body at the end of each step, wherever that went. */
static void pin_on_driven_body_follows(void **state)
{
    (void)state;
    line l;
    begin_line(&l, VBSS_SCENE_RIGID_DRIVEN);
    for (int i = 1; i <= 60; i++) {
        double turn = 0.01 * i, p[3] = {-2e-3 + 5e-5 * i, 1e-3, 1e-5 * i};
        const double q[4] = {vbss_cos(0.5 * turn), vbss_sin(0.5 * turn), 0.0, 0.0};
        expect_ok(vbss_scene_set_rigid_target(l.s.scene, l.stick, p, q));
        small_steps(&l.s, 1, 1e-3);
        expect_at(vec3_load(p), small_position(&l.s, l.stick), 1e-16);
        expect_at(pinned_point(&l), small_node(l.thread, 0), 1e-15);
    }
    assert_int_equal(small_statistics(&l.s).clamped, 0);
    small_end(&l.s);
}

static void pin_on_dynamic_body_follows(void **state)
{
    (void)state;
    for (int k = VBSS_SCENE_RIGID_COUPLED; k <= VBSS_SCENE_RIGID_FREE; k++) {
        line l;
        begin_line(&l, k);
        double v[39] = {0.0};
        for (int i = 0; i < 13; i++) {
            v[3 * i + 1] = 0.1 + 0.02 * i;
        }
        expect_ok(vbss_thread_set_state(l.thread, NULL, v, 13));
        for (int i = 0; i < 60; i++) {
            if (k == VBSS_SCENE_RIGID_COUPLED) {
                small_move(&l.s, l.stick, vec3_make(-2e-3, 1e-3 + 2e-5 * i, 0.0));
            }
            small_steps(&l.s, 1, 1e-3);
            expect_at(pinned_point(&l), small_node(l.thread, 0), 1e-14);
        }
        assert_true(small_position(&l.s, l.stick).y > 1.01e-3); /* it was pulled along */
        assert_int_equal(small_statistics(&l.s).clamped, 0);
        small_end(&l.s);
    }
}

/* A given point, away from where the node is: it comes within the next step. */
static void node_is_moved_to_pin_target(void **state)
{
    (void)state;
    for (int k = VBSS_SCENE_RIGID_DRIVEN; k <= VBSS_SCENE_RIGID_FREE; k++) {
        small s;
        vbss_thread *thread;
        uint32_t pin;
        const double point[3] = {2.2e-3, -1e-3, 1e-4};
        small_begin_scene(&s);
        uint32_t number = small_thread(&s, vec3_zero(), vec3_make(0.024, 0.0, 0.0), 12, &thread);
        uint32_t stick = small_stick(&s, k, vec3_make(-2e-3, 1e-3, 0.0), half, 1e-3);
        expect_ok(vbss_scene_pin_thread(s.scene, number, 0, stick, point, &pin));
        small_steps(&s, 1, 1e-3);
        vec3 wanted = vec3_add(small_position(&s, stick), vec3_load(point));
        expect_at(wanted, small_node(thread, 0), 1e-6); /* a free body has turned a little */
        expect_at(vec3_make(-2e-3, 1e-3, 0.0), small_position(&s, stick), 1e-3);
        small_end(&s);
    }
}

/* ---- the force that it transmits */

/* A taut thread between the world and a body: what the body feels is the tension. */
static void body_feels_pin_force(void **state)
{
    (void)state;
    for (int k = VBSS_SCENE_RIGID_DRIVEN; k <= VBSS_SCENE_RIGID_COUPLED; k++) {
        line l;
        begin_line(&l, k);
        small_pin(&l.s, l.number, 12, 0);
        for (int i = 1; i <= 150; i++) {
            double pulled = vbss_min(1e-6 * i, 1e-4);
            small_move(&l.s, l.stick, vec3_make(-2e-3 - pulled, 1e-3, 0.0));
            small_steps(&l.s, 1, 1e-3);
        }
        double tension = small_tension(l.thread, 0);
        vbss_scene_rigid_state r = small_rigid(&l.s, l.stick);
        assert_true(tension > 0.1);
        expect_near(tension, r.contact_force[0], 1e-3 * tension);
        expect_near(0.0, r.contact_force[1], 1e-2 * tension);
        expect_near(tension, r.hand_force[0], 1e-2 * tension);
        /* About the frame's origin: r x F, with the point 1 mm below. */
        expect_near(1e-3 * tension, r.contact_torque[2], 3e-2 * 1e-3 * tension);
        small_end(&l.s);
    }
}

/* ---- let go */

static void unpinned_node_is_free(void **state)
{
    (void)state;
    for (int k = VBSS_SCENE_RIGID_DRIVEN; k <= VBSS_SCENE_RIGID_FREE; k++) {
        line l;
        uint32_t again;
        begin_line(&l, k);
        small_pin(&l.s, l.number, 12, 0);
        small_steps(&l.s, 3, 1e-3);
        expect_ok(vbss_scene_unpin_thread(l.s.scene, l.pin));
        expect_result(VBSS_ERROR_NOT_FOUND, vbss_scene_unpin_thread(l.s.scene, l.pin));
        double v[39] = {0.0};
        v[2] = 0.5;
        expect_ok(vbss_thread_set_state(l.thread, NULL, v, 13));
        small_steps(&l.s, 5, 1e-3);
        assert_true(small_node(l.thread, 0).z > 1e-4);
        expect_at(vec3_make(0.024, 0.0, 0.0), small_node(l.thread, 12), 1e-17);
        again = small_pin(&l.s, l.number, 0, l.stick); /* names are never used again */
        assert_true(again > l.pin + 1);
        small_steps(&l.s, 2, 1e-3);
        small_end(&l.s);
    }
}

static uint32_t holders(vbss_thread *thread)
{
    thread_object *t;
    uint32_t count = 0;
    expect_ok(vbss_thread_open(thread, &t));
    for (uint32_t i = 0; i < t->config.attachment_capacity; i++) {
        count += t->attachments[i].id != 0;
    }
    return count;
}

static void removed_body_removes_pins(void **state)
{
    (void)state;
    for (int k = VBSS_SCENE_RIGID_DRIVEN; k <= VBSS_SCENE_RIGID_FREE; k++) {
        line l;
        begin_line(&l, k);
        uint32_t other = small_stick(&l.s, k, vec3_make(0.012, 5e-3, 0.0), half, 1e-3);
        small_pin(&l.s, l.number, 4, other);
        uint32_t world = small_pin(&l.s, l.number, 12, 0);
        small_steps(&l.s, 2, 1e-3);
        expect_ok(vbss_scene_remove(l.s.scene, l.stick));
        expect_result(VBSS_ERROR_NOT_FOUND, vbss_scene_unpin_thread(l.s.scene, l.pin));
        assert_int_equal(holders(l.thread), k == VBSS_SCENE_RIGID_DRIVEN ? 2 : 1);
        small_steps(&l.s, 2, 1e-3);
        small_pin(&l.s, l.number, 0, other); /* its node is free again */
        small_steps(&l.s, 2, 1e-3);
        expect_ok(vbss_scene_remove(l.s.scene, l.number)); /* and the thread all of them */
        assert_int_equal(holders(l.thread), 0);
        expect_result(VBSS_ERROR_NOT_FOUND, vbss_scene_unpin_thread(l.s.scene, world));
        expect_ok(vbss_thread_step(l.thread, 1e-3));
        small_steps(&l.s, 2, 1e-3);
        assert_int_equal(small_object(&l.s)->pins[0].id, 0);
        small_end(&l.s);
    }
}

/* ---- what a host does to the thread itself */

static void body_pin_excludes_other_holders(void **state)
{
    (void)state;
    for (int k = VBSS_SCENE_RIGID_DRIVEN; k <= VBSS_SCENE_RIGID_FREE; k++) {
        line l;
        vbss_thread_attachment a;
        uint32_t id;
        begin_line(&l, k);
        expect_ok(vbss_thread_attachment_init(&a, sizeof a));
        expect_result(VBSS_ERROR_IN_USE, vbss_thread_attach(l.thread, &a, &id));
        a.kind = VBSS_THREAD_ATTACHMENT_CLAMP;
        expect_result(VBSS_ERROR_IN_USE, vbss_thread_attach(l.thread, &a, &id));
        small_steps(&l.s, 2, 1e-3);
        a.kind = VBSS_THREAD_ATTACHMENT_MASS; /* which is carried along */
        a.mass = 1e-3;
        expect_ok(vbss_thread_attach(l.thread, &a, &id));
        small_steps(&l.s, 2, 1e-3);
        small_end(&l.s);
    }
}

static void detached_pin_is_harmless(void **state)
{
    (void)state;
    line l;
    begin_line(&l, VBSS_SCENE_RIGID_DRIVEN);
    small_steps(&l.s, 1, 1e-3);
    expect_ok(vbss_thread_detach(l.thread, 1));
    small_steps(&l.s, 2, 1e-3);
    expect_ok(vbss_scene_unpin_thread(l.s.scene, l.pin));
    assert_int_equal(holders(l.thread), 0);
    small_steps(&l.s, 1, 1e-3);
    small_end(&l.s);
}

/* ---- two welds side by side: a swage that holds the thread's direction too */

static void adjacent_welded_nodes_move_with_body(void **state)
{
    (void)state;
    for (uint32_t count = 1; count <= 4; count++) {
        small s;
        vbss_thread *thread;
        small_begin_scene(&s);
        s.rigid.gravity[1] = s.thread.gravity[1] = -9.81;
        uint32_t number = small_thread(&s, vec3_zero(), vec3_make(0.024, 0.0, 0.0), 12, &thread);
        s.rigid.mass = 1e-3;
        uint32_t needle = small_stick(&s, VBSS_SCENE_RIGID_FREE, vec3_make(-2e-3, 0.0, 0.0),
                                      vec3_make(1e-3, 0.0, 0.0), 2e-4);
        for (uint32_t node = 0; node < count; node++) {
            small_pin(&s, number, node, needle);
        }
        for (int i = 1; i <= 40; i++) {
            small_steps(&s, 1, 1e-3);
            /* All of it falls freely: backward Euler's fall. */
            double fallen = -9.81 * 1e-6 * 0.5 * i * (i + 1);
            expect_near(fallen, small_position(&s, needle).y, 1e-9);
            expect_near(fallen, small_node(thread, 12).y, 1e-9);
        }
        assert_int_equal(small_statistics(&s).attempts, 40);
        small_end(&s);
    }
}

int test_scene_pins(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(world_pin_stays),
        cmocka_unit_test(pin_on_driven_body_follows),
        cmocka_unit_test(pin_on_dynamic_body_follows),
        cmocka_unit_test(node_is_moved_to_pin_target),
        cmocka_unit_test(body_feels_pin_force),
        cmocka_unit_test(unpinned_node_is_free),
        cmocka_unit_test(removed_body_removes_pins),
        cmocka_unit_test(body_pin_excludes_other_holders),
        cmocka_unit_test(detached_pin_is_harmless),
        cmocka_unit_test(adjacent_welded_nodes_move_with_body),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
