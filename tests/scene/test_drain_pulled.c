/* A drain is torn off its block, falls, is opened far and closed beyond itself by what holds its nodes, and threads pull
 * on it from outside and through its lumen. */
#include "scene/drain_case.h"

static drain_case c;

#define TOP 7.0e-3

/* The rod goes in and up: anchors tear one after the other, then all hangs on the rod. */
static void rod_in_lumen_tears_drain_off(void **state)
{
    (void)state;
    drain_case_begin(&c);
    c.config.tear_stress = 2e3;
    drain_case_make(&c);
    uint32_t rod = drain_case_tool(&c, VBSS_SCENE_RIGID_COUPLED, vec3_make(0.0, 0.0, 0.0),
                                   vec3_make(25e-3, 0.0, 0.0), 1.5e-3);
    drain_case_move_to(&c, rod, vec3_make(0.0, 40e-3, 0.0), 800);
    drain_case_wait(&c, 300);
    assert_int_equal(drain_case_statistics(&c).torn, 33);
    assert_int_equal(drain_case_statistics(&c).inverted, 0);
    assert_true(vec3_norm(drain_case_anchor_sum(&c)) == 0.0);
    vec3 force = drain_case_contact_force(&c, rod);
    expect_near(0.0, vec3_norm(force), 1e-3); /* no weight */
    assert_true(drain_case_fastest(&c) < 5e-2);
    drain_case_finish(&c, "torn off", 0.05);
}

static void fall(double thickness)
{
    drain_case_begin(&c);
    c.config.thickness = thickness;
    c.config.tear_stress = 1.0;
    c.config.gravity[1] = -9.81;
    c.s.config.floor = 1;
    c.s.config.floor_height = -15e-3;
    drain_case_make(&c);
    drain_case_wait(&c, 1500);
    assert_int_equal(drain_case_statistics(&c).torn, 33);
    assert_int_equal(drain_case_statistics(&c).inverted, 0);
    assert_true(drain_case_fastest(&c) < 1e-2);
    vbss_view kinds = small_view(&c.s, VBSS_SCENE_VIEW_CONTACTS);
    vec3 weight = vec3_zero();
    for (uint64_t i = 0; i < kinds.count; i++) {
        const uint32_t *words =
            (const uint32_t *)(const void *)((const char *)kinds.data + i * kinds.stride_bytes);
        if (words[0] == VBSS_SCENE_CONTACT_DRAIN_FLOOR) {
            weight = vec3_add(weight, small_vector(&c.s, VBSS_SCENE_VIEW_CONTACT_FORCES, i));
        }
    }
    drain_object *d;
    double mass = 0.0;
    expect_ok(vbss_drain_open(c.drain, &d));
    for (uint32_t i = 0; i < d->mesh.node_count; i++) {
        mass += d->mass[i];
    }
    expect_near(9.81 * mass, weight.y, 1e-4 * 9.81 * mass);
    expect_near(0.0, weight.x, 1e-4 * 9.81 * mass);
    expect_near(0.0, weight.z, 1e-4 * 9.81 * mass);
}

static void loose_drain_falls_and_carries_weight(void **state)
{
    (void)state;
    fall(1e-3);
    drain_case_finish(&c, "fallen", 0.01);
    fall(0.4e-3);
    drain_case_finish(&c, "fallen, thin", 0.01);
}

/* By two hooks beside each other in the slit, that go apart until it is open by 10 mm: their surfaces are. */
static void two_rods_open_slit(void **state)
{
    (void)state;
    const double radius = 0.5e-3;
    uint32_t hooks[2];
    vbss_drain_gap gap;
    drain_case_begin(&c);
    drain_case_make(&c);
    for (int k = 0; k < 2; k++) {
        hooks[k] = drain_case_tool(&c, VBSS_SCENE_RIGID_COUPLED,
                                   vec3_make(1.2e-3 * k - 0.6e-3, 20e-3, 0.0),
                                   vec3_make(0.0, 8e-3, 0.0), radius);
    }
    for (int i = 1; i <= 1400; i++) {
        double down = i <= 300 ? i / 300.0 : i > 1100 ? (1400 - i) / 300.0 : 1.0;
        double progress = i <= 300    ? 0.0
                          : i <= 600  ? (i - 300) / 300.0
                          : i <= 800  ? 1.0
                          : i <= 1100 ? (1100 - i) / 300.0
                                      : 0.0;
        for (int k = 0; k < 2; k++) {
            drain_case_target(&c, hooks[k],
                              vec3_make(1.2e-3 * k - 0.6e-3, 20e-3 - 9e-3 * down,
                                        (k == 0 ? -1.0 : 1.0) * 5.2e-3 * progress));
        }
        drain_case_step(&c);
        if (i == 800) {
            expect_ok(vbss_drain_get_gap(c.drain, &gap, sizeof gap));
            assert_true(gap.gap > 10e-3 && gap.gap < 13e-3);
            drain_case_report(&c, "hooked");
        }
    }
    drain_case_wait(&c, 300);
    drain_case_expect_rest(&c, 0.1e-3);
    drain_case_finish(&c, "hooked", 0.05);
}

/* The marks by pins: apart so far that the slit is 10 mm, then past each other, and let go. */
static void pins_open_slit_and_cross_lips(void **state)
{
    (void)state;
    drain_case_begin(&c);
    drain_case_make(&c);
    uint32_t pins[2];
    vec3 at[2];
    for (int k = 0; k < 2; k++) {
        pins[k] = drain_case_pin(&c, c.places.marks[k]);
        at[k] = drain_case_node(&c, c.places.marks[k]);
    }
    double travel = 0.0, step = 20e-3 * c.h;
    vbss_drain_gap gap = {0};
    while (gap.gap < 10e-3) {
        travel += step;
        assert_true(travel < 15e-3);
        drain_case_target_pin(&c, pins[0], vec3_make(at[0].x, at[0].y, at[0].z - travel));
        drain_case_target_pin(&c, pins[1], vec3_make(at[1].x, at[1].y, at[1].z + travel));
        drain_case_step(&c);
        expect_ok(vbss_drain_get_gap(c.drain, &gap, sizeof gap));
    }
    drain_case_wait(&c, 200);
    drain_case_report(&c, "opened");
    while (travel > -(vec3_distance(at[0], at[1]) + 2e-3) / 2.0) { /* 2 mm beyond each other */
        travel -= step;
        drain_case_target_pin(&c, pins[0], vec3_make(at[0].x, at[0].y, at[0].z - travel));
        drain_case_target_pin(&c, pins[1], vec3_make(at[1].x, at[1].y, at[1].z + travel));
        drain_case_step(&c);
    }
    drain_case_wait(&c, 200);
    drain_case_report(&c, "crossed");
    for (int k = 0; k < 2; k++) {
        drain_case_unpin(&c, pins[k]);
    }
    drain_case_wait(&c, 1000);
    drain_case_report(&c, "let go");
    small_watch_expect_nothing(&c.watch);
    assert_true(drain_case_fastest(&c) < 1e-3);
    drain_case_finish(&c, "crossed", 0.05);
}

/* Ends are drawn by forces that are there in full after 0.3 s. */
static void pull_thread(uint32_t segments, vec3 direction, double force, uint32_t steps)
{
    vbss_thread_attachment a;
    uint32_t ids[2];
    expect_ok(vbss_thread_attachment_init(&a, sizeof a));
    a.kind = VBSS_THREAD_ATTACHMENT_FORCE;
    for (uint32_t k = 0; k < 2; k++) {
        a.node = k * segments;
        expect_ok(vbss_thread_attach(c.threads[0], &a, &ids[k]));
    }
    for (uint32_t i = 0; i < steps; i++) {
        for (uint32_t k = 0; k < 2; k++) {
            double f[3];
            vec3_store(f, vec3_scale(direction, force * vbss_min(i / 300.0, 1.0)));
            expect_ok(vbss_thread_set_attachment_target(c.threads[0], ids[k], f, NULL));
        }
        drain_case_step(&c);
    }
}

static void overlying_thread_is_pulled_down(void **state)
{
    (void)state;
    drain_case_begin(&c);
    c.s.config.floor = 1; /* or the ends go on down */
    c.s.config.floor_height = -60e-3;
    c.s.thread.radius = 0.125e-3;
    drain_case_make(&c);
    drain_case_thread(&c, vec3_make(1e-3, TOP + 0.3e-3, -40e-3),
                      vec3_make(1e-3, TOP + 0.3e-3, 40e-3), 80);
    pull_thread(80, vec3_make(0.0, -1.0, 0.0), 1.0, 800);
    drain_case_report(&c, "a thread over it");
    small_watch_expect_nothing(&c.watch);
    drain_case_end(&c);
}

static void thread_through_lumen_is_pulled_up(void **state)
{
    (void)state;
    drain_case_begin(&c);
    c.config.tear_stress = 1e6;
    c.s.thread.radius = 0.125e-3;
    drain_case_make(&c);
    drain_case_thread(&c, vec3_make(-40e-3, 0.0, 0.3e-3), vec3_make(40e-3, 0.0, 0.3e-3), 80);
    pull_thread(80, vec3_make(0.0, 1.0, 0.0), 0.5, 800);
    drain_case_report(&c, "a thread through it");
    small_watch_expect_nothing(&c.watch);
    drain_case_end(&c);
}

int test_drain_pulled(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(rod_in_lumen_tears_drain_off),
        cmocka_unit_test(loose_drain_falls_and_carries_weight),
        cmocka_unit_test(two_rods_open_slit),
        cmocka_unit_test(pins_open_slit_and_cross_lips),
        cmocka_unit_test(overlying_thread_is_pulled_down),
        cmocka_unit_test(thread_through_lumen_is_pulled_up),
    };
    return cmocka_run_group_tests_name("drain pulled", tests, NULL, NULL);
}
