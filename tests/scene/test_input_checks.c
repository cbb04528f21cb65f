/* What a scene says about a set-up that is probably wrong: bodies that overlap, values in a wrong unit, poses that jump. */
#include <stdlib.h>

#include "scene/small.h"

/* ---- a scene that listens */

typedef struct listener {
    uint32_t warnings;
    char last[256];
} listener;

static void listen(void *user, vbss_log_level level, const char *message)
{
    listener *l = user;
    if (level == VBSS_LOG_WARNING) {
        l->warnings++;
        snprintf(l->last, sizeof l->last, "%s", message);
    }
}

/* The same small scene, in a context with a log. */
static void begin_listening(small *s, listener *l)
{
    vbss_context_config config;
    small_begin(s);
    harness_context_end(s->context, &s->memory);
    config = harness_watched_config(&s->memory);
    config.log = listen;
    config.log_user = l;
    *l = (listener){0};
    expect_ok(vbss_context_create(&config, &s->context));
}

static void expect_warning(listener *l, const char *wanted)
{
    if (l->warnings != 1 || strstr(l->last, wanted) == NULL) {
        fail_msg("%u warnings, the last '%s', not one with '%s'", l->warnings, l->last, wanted);
    }
    *l = (listener){0};
}

static vbss_scene_overlap overlap_of(const small *s, uint32_t body)
{
    vbss_scene_overlap o;
    expect_ok(vbss_scene_get_overlap(s->scene, body, &o, sizeof o));
    return o;
}

static vbss_thread *free_thread(small *s, vec3 begin, vec3 end, uint32_t segments)
{
    vbss_thread *thread;
    s->thread.segment_count = segments;
    s->thread.length = vec3_distance(begin, end);
    vec3_store(s->thread.start, begin);
    vec3_store(s->thread.direction, vec3_sub(end, begin));
    expect_ok(vbss_thread_create(s->context, &s->thread, &thread));
    return thread;
}

/* ---- overlaps */

static const vec3 left = {-0.01, 0.0, 0.0}, right = {0.01, 0.0, 0.0}, along = {0.0, 0.0, 0.01};

static void thread_through_a_tool_is_reported(void **state)
{
    (void)state;
    small s;
    listener l;
    begin_listening(&s, &l);
    small_create(&s);
    uint32_t stick = small_stick(&s, VBSS_SCENE_RIGID_DRIVEN, vec3_zero(), along, 2e-3);
    assert_true(overlap_of(&s, stick).depth == 0.0);
    uint32_t body = small_thread(&s, left, right, 20, NULL);
    char wanted[64];
    snprintf(wanted, sizeof wanted, "the thread overlaps body %u by 2.", stick);
    expect_warning(&l, wanted);
    const vbss_scene_overlap o = overlap_of(&s, body);
    assert_int_equal(o.body, stick);
    expect_near(2e-3 + s.thread.radius, o.depth, 1e-9);
    assert_int_equal(overlap_of(&s, stick).body, body);
    vbss_scene_overlap none;
    expect_result(VBSS_ERROR_NOT_FOUND, vbss_scene_get_overlap(s.scene, 99, &none, sizeof none));
    small_end(&s);
}

static void overlap_is_refused_or_allowed_as_configured(void **state)
{
    (void)state;
    for (vbss_scene_overlap_policy policy = 0; policy < 3; policy++) {
        small s;
        listener l;
        uint32_t body = 77;
        begin_listening(&s, &l);
        s.config.overlap = policy;
        small_create(&s);
        (void)small_stick(&s, VBSS_SCENE_RIGID_DRIVEN, vec3_zero(), along, 2e-3);
        vbss_thread *thread = free_thread(&s, left, right, 20);
        const uint64_t hash = small_hash(&s);
        vbss_result result = vbss_scene_add_thread(s.scene, thread, &body);
        expect_result(policy == VBSS_SCENE_OVERLAP_REFUSE ? VBSS_ERROR_OUT_OF_RANGE : VBSS_OK,
                      result);
        assert_int_equal(l.warnings, policy == VBSS_SCENE_OVERLAP_WARN);
        if (policy == VBSS_SCENE_OVERLAP_REFUSE) {
            assert_true(small_hash(&s) == hash);
            assert_int_equal(body, 77);
            expect_ok(vbss_thread_destroy(thread)); /* it belongs to no scene */
        }
        small_end(&s);
    }
}

static void body_in_a_drain_or_a_floor_is_reported(void **state)
{
    (void)state;
    small s;
    listener l;
    begin_listening(&s, &l);
    s.config.floor = 1;
    s.config.floor_height = -0.05;
    small_create(&s);
    uint32_t drain = small_drain(&s, NULL);
    assert_int_equal(l.warnings, 0);
    uint32_t thread =
        small_thread(&s, vec3_make(0.0, -0.02, 0.0), vec3_make(0.0, 0.02, 0.0), 20, NULL);
    expect_warning(&l, "the thread overlaps body");
    assert_int_equal(overlap_of(&s, thread).body, drain);
    uint32_t low = small_stick(&s, VBSS_SCENE_RIGID_FREE, vec3_make(0.1, -0.05, 0.0), along, 1e-3);
    expect_warning(&l, "the rigid body is 1 mm inside the floor");
    assert_int_equal(overlap_of(&s, low).body, 0);
    expect_near(1e-3, overlap_of(&s, low).depth, 1e-12);
    small_end(&s);
}

/* Its lowest point touches the floor, or is 3 mm below it. */
static void needle_is_compared_where_it_is(void **state)
{
    (void)state;
    const double depths[2] = {0.0, 3e-3};
    for (int k = 0; k < 2; k++) {
        small s;
        listener l;
        vbss_needle *needle;
        uint32_t body;
        begin_listening(&s, &l);
        s.config.floor = 1;
        s.config.capsule_capacity = 64;
        small_create(&s);
        vbss_needle_config config = vbss_needle_config_default();
        config.position[1] = config.radius + config.wire_radius - depths[k];
        expect_ok(vbss_needle_create(s.context, &config, &needle));
        expect_ok(vbss_scene_add_needle(s.scene, needle, &body));
        assert_int_equal(l.warnings, k);
        if (k == 1) {
            expect_warning(&l, "the needle is 3 mm inside the floor");
            expect_near(3e-3, overlap_of(&s, body).depth, 1e-12);
        }
        small_end(&s);
    }
}

static void usual_places_are_not_reported(void **state)
{
    (void)state;
    small s;
    listener l;
    begin_listening(&s, &l);
    s.config.capsule_capacity = 64;
    small_create(&s);
    vbss_needle_config config;
    vbss_needle *needle;
    uint32_t body;
    double swage[3], direction[3];
    vbss_needle_mass mass;
    expect_ok(vbss_needle_config_init(&config, sizeof config));
    expect_ok(vbss_needle_create(s.context, &config, &needle));
    expect_ok(vbss_needle_get_mass(needle, &mass, sizeof mass));
    expect_ok(vbss_scene_add_needle(s.scene, needle, &body));
    expect_ok(vbss_needle_get_place(needle, mass.length, swage, direction));
    const vec3 start = vec3_load(swage), forward = vec3_load(direction);
    (void)small_thread(&s, start, vec3_add_scaled(start, -0.05, forward), 100,
                       NULL); /* at the swage */
    const vec3 far = vec3_make(0.5, 0.0, 0.0);
    (void)small_stick(&s, VBSS_SCENE_RIGID_DRIVEN, far, along, 2e-3); /* two driven ones */
    (void)small_stick(&s, VBSS_SCENE_RIGID_DRIVEN, far, vec3_make(0.01, 0.0, 0.0), 2e-3);
    uint32_t tool = small_stick(&s, VBSS_SCENE_RIGID_DRIVEN, vec3_make(0.0, 0.5, 0.0), along, 1e-3);
    assert_int_equal(l.warnings, 0);
    uint32_t tied = small_thread(&s, vec3_make(0.0, 0.5, 0.0), vec3_make(0.03, 0.5, 0.0), 6, NULL);
    expect_warning(&l, "the thread overlaps");
    small_pin(&s, tied, 0, tool);
    assert_true(overlap_of(&s, tied).depth == 0.0);
    small_end(&s);
}

/* ---- units */

static void values_in_a_wrong_unit_are_named(void **state)
{
    (void)state;
    small s;
    listener l;
    begin_listening(&s, &l);
    small_create(&s);
    vbss_thread *thread;
    s.thread.length = 150.0;
    expect_ok(vbss_thread_create(s.context, &s.thread, &thread));
    expect_warning(
        &l, "length is 150 m, more than is likely; if it is in mm, the right value is 0.15 m");
    s.thread.length = 0.15;
    s.thread.linear_density = 0.105;
    expect_ok(vbss_thread_create(s.context, &s.thread, &thread));
    expect_warning(&l, "linear_density is 0.105 kg/m, more than is likely; if it is in g/m");
    s.thread.linear_density = 1e-4;
    s.thread.gravity[1] = -9810.0;
    expect_ok(vbss_thread_create(s.context, &s.thread, &thread));
    expect_warning(&l, "if it is in mm/s^2, the right value is 9.81 m/s^2");
    (void)small_stick(&s, VBSS_SCENE_RIGID_DRIVEN, vec3_zero(), vec3_make(0.0, 0.0, 50.0), 2e-3);
    expect_warning(&l, "a coordinate of a capsule is 50 m");
    small_end(&s);
}

/* ---- jumps */

static vbss_grasper *add_grasper(small *s)
{
    vbss_grasper_config config;
    vbss_grasper *grasper;
    uint32_t body;
    expect_ok(vbss_grasper_config_init(&config, sizeof config));
    expect_ok(vbss_grasper_create(s->context, &config, &grasper));
    expect_ok(vbss_scene_add_grasper(s->scene, grasper, &body));
    return grasper;
}

static vbss_grasper_state state_of(vbss_grasper *grasper)
{
    vbss_grasper_state found;
    expect_ok(vbss_grasper_get_state(grasper, &found, sizeof found));
    return found;
}

/* A pose in millimetres: 30 m away. */
static void tool_in_millimetres_is_named_and_slowed(void **state)
{
    (void)state;
    small s;
    listener l;
    begin_listening(&s, &l);
    small_create(&s);
    (void)small_thread(&s, vec3_make(0.05, 0.05, 0.0), vec3_make(0.08, 0.05, 0.0), 10, NULL);
    vbss_grasper *grasper = add_grasper(&s);
    const double position[3] = {29.5, 2.0, 1.0};
    small_steps(&s, 3, 1e-3);
    for (int i = 0; i < 20; i++) {
        expect_ok(vbss_grasper_set_target(grasper, position, NULL));
        small_steps(&s, 1, 1e-3);
        const vbss_grasper_state now = state_of(grasper);
        assert_true(vec3_norm(vec3_load(now.hand_force)) < 2e3);
        assert_true(vec3_norm(vec3_load(now.position)) < 20.0 * 1e-3 * (i + 1) + 1e-3);
    }
    assert_int_equal(small_statistics(&s).paused, 0);
    expect_warning(&l, "the way to position is 29.");
    small_end(&s);
}

static void host_sets_the_speed_of_targets(void **state)
{
    (void)state;
    small s;
    small_begin(&s);
    s.config.speed_limit = 2.0;
    small_create(&s);
    uint32_t stick =
        small_stick(&s, VBSS_SCENE_RIGID_DRIVEN, vec3_zero(), vec3_make(0.0, 0.0, 1e-4), 1e-4);
    const vec3 far = {0.011, 0.0, 0.0};
    small_move(&s, stick, far);
    for (int i = 1; i <= 5; i++) {
        small_steps(&s, 1, 1e-3);
        expect_near(2e-3 * i, small_position(&s, stick).x, 1e-12);
        expect_near(0.011, small_rigid(&s, stick).target_position[0], 1e-15);
    }
    small_steps(&s, 1, 1e-3);
    expect_same_bits(far.x, small_position(&s, stick).x);
    small_end(&s);
}

/* A turn counts by the way of the farthest point. */
static void turn_is_limited_too(void **state)
{
    (void)state;
    small s;
    small_begin(&s);
    s.config.speed_limit = 1.0;
    small_create(&s);
    uint32_t stick =
        small_stick(&s, VBSS_SCENE_RIGID_DRIVEN, vec3_zero(), vec3_make(0.0, 0.0, 0.1), 1e-3);
    const double zero[3] = {0.0, 0.0, 0.0}, quarter[4] = {sqrt(0.5), sqrt(0.5), 0.0, 0.0};
    expect_ok(vbss_scene_set_rigid_target(s.scene, stick, zero, quarter));
    small_steps(&s, 1, 1e-3);
    const vbss_scene_rigid_state now = small_rigid(&s, stick);
    const double angle = 2.0 * asin(now.orientation[1]);
    expect_near(1e-3 / 0.101, angle, 1e-6);
    small_end(&s);
}

static void no_limit_is_a_jump_as_before(void **state)
{
    (void)state;
    small s;
    small_begin(&s);
    s.config.speed_limit = 0.0;
    small_create(&s);
    uint32_t stick = small_stick(&s, VBSS_SCENE_RIGID_DRIVEN, vec3_zero(), along, 1e-3);
    small_move(&s, stick, vec3_make(0.5, 0.0, 0.0));
    small_steps(&s, 1, 1e-3);
    expect_same_bits(0.5, small_position(&s, stick).x);
    small_end(&s);
}

/* What is left of a way is part of the state. */
static void slowed_motion_goes_on_after_a_restore(void **state)
{
    (void)state;
    small s;
    small_begin(&s);
    s.config.speed_limit = 2.0;
    small_create(&s);
    uint32_t stick = small_stick(&s, VBSS_SCENE_RIGID_COUPLED, vec3_zero(), along, 1e-3);
    small_move(&s, stick, vec3_make(0.02, 0.01, 0.0));
    small_steps(&s, 3, 1e-3);
    small_state saved = small_save(&s);
    small_steps(&s, 15, 1e-3);
    const uint64_t hash = small_hash(&s);
    expect_ok(vbss_scene_restore(s.scene, saved.bytes, saved.count));
    small_steps(&s, 15, 1e-3);
    assert_true(small_hash(&s) == hash);
    free(saved.bytes);
    small_end(&s);
}

int test_input_checks(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(thread_through_a_tool_is_reported),
        cmocka_unit_test(overlap_is_refused_or_allowed_as_configured),
        cmocka_unit_test(body_in_a_drain_or_a_floor_is_reported),
        cmocka_unit_test(needle_is_compared_where_it_is),
        cmocka_unit_test(usual_places_are_not_reported),
        cmocka_unit_test(values_in_a_wrong_unit_are_named),
        cmocka_unit_test(tool_in_millimetres_is_named_and_slowed),
        cmocka_unit_test(host_sets_the_speed_of_targets),
        cmocka_unit_test(turn_is_limited_too),
        cmocka_unit_test(no_limit_is_a_jump_as_before),
        cmocka_unit_test(slowed_motion_goes_on_after_a_restore),
    };
    return cmocka_run_group_tests_name("scene.input_checks", tests, NULL, NULL);
}
