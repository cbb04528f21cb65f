/* Method VBLAST of scenes: threads, the floor and a drain. Both sides of such a pair are deformable: they share a response
 * as two threads do, by how far each came. */
#include "fixtures/baseline_of.h"
#include "scene/paper_drains.h"

#define TOUCHING (HALF_WALL + RADIUS)

/* Across the drain, 60 mm, at that height, 2 mm from mid-length. */
static hands place_across(stage *s, double height, uint32_t segments)
{
    vbss_thread_config c = paper_thread(segments);
    const double start[3] = {2e-3, height, -0.03}, direction[3] = {0.0, 0.0, 1.0};
    memcpy(c.start, start, sizeof start);
    memcpy(c.direction, direction, sizeof direction);
    c.length = 0.06;
    baseline_of(&c.baseline)->drain_damping = 0.01;
    add(s, 0, &c);
    return hold_ends(s, 0);
}

/* Its hands go 3 mm down. It is stopped and stretched; who has not come does not yield, however hard it pulls: the paper's
 * shares. */
static void overlying_thread_is_carried_without_motion(void **state)
{
    (void)state;
    stage s;
    double largest = 0.0;
    stage_drain d = begin_with_drain(&s);
    hands h = place_across(&s, 7.3e-3, 30);
    for (int i = 1; i <= 2000; i++) {
        for (int k = 0; k < 2; k++) {
            double to[3], progress = i < 1500 ? i / 1500.0 : 1.0;
            vec3_store(to, vec3_sub(h.at[k], vec3_make(0, 3e-3 * progress, 0)));
            expect_ok(vbss_thread_set_attachment_target(s.threads[0], h.ids[k], to, NULL));
        }
        expect_ok(vbss_scene_step(s.scene, 2e-4)); /* longer ones stretch it until it bursts */
        largest = i % 10 == 0 ? vbss_max(TOUCHING - clearance(&s, &d), largest) : largest;
    }
    expect_near(0.0, largest, 1e-5);
    expect_near(TOUCHING, clearance(&s, &d), 1e-5);
    expect_near(0.0, farthest(&d, DRAIN_NODES), 0.0);
    vbss_view v = view_of(&s, VBSS_SCENE_VIEW_CONTACTS);
    const uint32_t *features = v.data;
    assert_true(v.count > 0);
    assert_int_equal(VBSS_SCENE_CONTACT_SIDES, features[0]);
    assert_int_equal(s.bodies[0], features[1]);
    assert_int_equal(d.body, features[3]);
    assert_true(statistics_of(&s).last_stretch_error > 3e-3);
    end(&s);
}

/* Free, it slides off: no friction. */
static void free_thread_slides_off(void **state)
{
    (void)state;
    stage s;
    uint32_t n;
    stage_drain d = begin_with_drain(&s);
    hands h = place_across(&s, 7.3e-3, 30);
    for (int k = 0; k < 2; k++) {
        expect_ok(vbss_thread_detach(s.threads[0], h.ids[k]));
    }
    double largest = 0.0;
    for (int i = 0; i < 500; i++) {
        expect_ok(vbss_scene_step(s.scene, 1e-3));
        largest = vbss_max(TOUCHING - clearance(&s, &d), largest);
    }
    assert_true(largest < 1e-4);
    const vec3 *x = places(s.threads[0], &n);
    for (uint32_t i = 0; i < n; i++) {
        assert_true(x[i].y < -RING_RADIUS);
    }
    expect_near(0.0, farthest(&d, DRAIN_NODES), 0.0);
    end(&s);
}

/* A segment whose ends are both held is as good as a tool. */
static void held_segment_moves_drain(void **state)
{
    (void)state;
    stage s;
    stage_drain d = begin_with_drain(&s);
    hands h = place_across(&s, 7.3e-3, 1);
    for (int i = 1; i <= 200; i++) {
        for (int k = 0; k < 2; k++) {
            double to[3];
            vec3_store(to,
                       vec3_sub(h.at[k], vec3_make(0, 1.5e-3 * (i < 100 ? i / 100.0 : 1.0), 0)));
            expect_ok(vbss_thread_set_attachment_target(s.threads[0], h.ids[k], to, NULL));
        }
        expect_ok(vbss_scene_step(s.scene, 1e-3));
    }
    assert_true(farthest(&d, DRAIN_NODES) > 2e-4);
    expect_near(TOUCHING, clearance(&s, &d), 1e-5);
    end(&s);
}

/* It flies against a thread that rests, and is put back and aside; the thread stays. */
static void moving_particle_yields_to_resting_thread(void **state)
{
    (void)state;
    stage s;
    uint32_t n;
    vbss_drain_config c = paper_drain();
    baseline_of(&c.baseline)->drain_damping = c.drag = 0.0;
    begin(&s);
    make(&s);
    stage_drain d = add_drain(&s, &c);
    vbss_thread_config t = paper_thread(1);
    const double start[3] = {-2e-3, 1e-3, RING_RADIUS + 1e-3}, direction[3] = {2.0, -1.0, 0.0};
    memcpy(t.start, start, sizeof start);
    memcpy(t.direction, direction, sizeof direction);
    t.length = 5e-3;
    t.gravity[1] = 0.0;
    add(&s, 0, &t);
    vec3 v[DRAIN_NODES] = {{0}};
    v[SIDE_NODE].z = 5.0;
    expect_ok(vbss_drain_set_state(d.drain, NULL, &v[0].x, DRAIN_NODES));
    expect_ok(vbss_scene_step(s.scene, 2e-4));
    expect_near(start[2], places(s.threads[0], &n)[0].z, 0.0);
    assert_true(moved(&d, SIDE_NODE).z > 0.0 && moved(&d, SIDE_NODE).z < 0.6e-3); /* of 1 mm */
    expect_near(0.0, statistics_of(&s).last_penetration, 1e-12);
    assert_true(statistics_of(&s).contacts > 0);
    end(&s);
}

/* Half the wall above it. */
static void floor_carries_drain(void **state)
{
    (void)state;
    stage s;
    vbss_drain_config c = paper_drain();
    begin(&s);
    s.config.floor = 1;
    s.config.floor_height = -RING_RADIUS;
    make(&s);
    stage_drain d = add_drain(&s, &c);
    wait_for(&s, 20);
    uint32_t lifted = 0;
    for (uint32_t i = 0; i < DRAIN_NODES; i++) {
        double height = d.object->x[i].y + RING_RADIUS;
        assert_true(height > HALF_WALL - 1e-12);
        lifted += height < HALF_WALL + 1e-12;
    }
    assert_int_equal(7, lifted); /* the line at the bottom */
    const uint32_t *features = view_of(&s, VBSS_SCENE_VIEW_CONTACTS).data;
    assert_int_equal(7, statistics_of(&s).contacts);
    assert_int_equal(VBSS_SCENE_CONTACT_DRAIN_FLOOR, features[0]);
    assert_int_equal(d.body, features[1]);
    assert_int_equal(0, features[3]);
    end(&s);
}

/* Two drains are not one: their edges meet, and who comes yields. */
static void two_drains_touch(void **state)
{
    (void)state;
    stage s;
    vbss_drain_config c = paper_drain();
    begin(&s);
    s.config.drain_capacity = 2;
    make(&s);
    stage_drain d = add_drain(&s, &c);
    c.position[2] = 2.0 * RING_RADIUS + 1.2e-3;
    baseline_of(&c.baseline)->drain_damping = c.drag = 0.0;
    stage_drain e = add_drain(&s, &c);
    wait_for(&s, 2);
    assert_int_equal(0, statistics_of(&s).contacts);
    vec3 v[DRAIN_NODES] = {{0}};
    v[SIDE_NODE + 6].z = -5.0; /* of the other, opposite to the side node */
    expect_ok(vbss_drain_set_state(e.drain, NULL, &v[0].x, DRAIN_NODES));
    expect_ok(vbss_scene_step(s.scene, 1e-4));
    const uint32_t *features = view_of(&s, VBSS_SCENE_VIEW_CONTACTS).data;
    assert_true(statistics_of(&s).contacts > 0);
    assert_int_equal(VBSS_SCENE_CONTACT_SIDES, features[0]);
    assert_int_equal(d.body, features[1]);
    assert_int_equal(e.body, features[3]);
    expect_near(0.0, farthest(&d, DRAIN_NODES), 0.0);
    expect_near(-0.2e-3, moved(&e, SIDE_NODE + 6).z, 1e-5);
    end(&s);
}

int test_paper_drain_threads(void)
{
    const struct CMUnitTest tests[] = {
        harness_test(overlying_thread_is_carried_without_motion),
        harness_test(free_thread_slides_off),
        harness_test(held_segment_moves_drain),
        harness_test(moving_particle_yields_to_resting_thread),
        harness_test(floor_carries_drain),
        harness_test(two_drains_touch),
    };
    return cmocka_run_group_tests_name("scene.paper_drain_threads", tests, NULL, NULL);
}
