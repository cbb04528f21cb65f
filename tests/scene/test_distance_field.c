/* Distance fields: the surface is where the distances say, to second order; a thread goes round a sampled cylinder by
 * the law of the rope; nothing passes; what a grid cannot show is refused. */
#include <stdlib.h>

#include "scene/capstan_rig.h"
#include "scene/small.h"

enum { MAX_SIDE = 72, MAX_DISTANCES = MAX_SIDE * MAX_SIDE * MAX_SIDE };

static double distances[MAX_DISTANCES];

typedef double (*distance_function)(vec3 x);

/* Samples a function on a cube about the origin. */
static vbss_scene_distance_field_config sample(distance_function f, double half, double spacing)
{
    vbss_scene_distance_field_config c = vbss_scene_distance_field_config_default();
    const uint32_t side = (uint32_t)(2.0 * half / spacing + 1.5);
    uint32_t i = 0;
    assert_true(side <= MAX_SIDE);
    for (uint32_t z = 0; z < side; z++) {
        for (uint32_t y = 0; y < side; y++) {
            for (uint32_t x = 0; x < side; x++) {
                distances[i++] =
                    f(vec3_make(spacing * x - half, spacing * y - half, spacing * z - half));
            }
        }
    }
    for (int k = 0; k < 3; k++) {
        c.counts[k] = side;
        c.spacing[k] = spacing;
        c.position[k] = -half;
    }
    c.distance_count = i;
    c.distances = distances;
    return c;
}

static void begin(small *s)
{
    small_begin(s);
    s->config.floor = 0;
    s->config.contact_capacity = 8192;
    s->config.candidate_capacity = 65536;
    s->thread.gravity[1] = -9.81;
    small_create(s);
}

static uint32_t add_field(small *s, const vbss_scene_distance_field_config *c)
{
    uint32_t body = 0;
    expect_ok(vbss_scene_add_distance_field(s->scene, c, &body));
    return body;
}

/* ---- where the surface is */

#define BALL_RADIUS 5e-3
static double distance_of_ball(vec3 x)
{
    return vec3_norm(x) - BALL_RADIUS;
}

/* Largest error of the distance of points around the ball. */
static double error_of_ball(double spacing)
{
    small s;
    double largest = 0.0;
    begin(&s);
    const vbss_scene_distance_field_config c = sample(distance_of_ball, 6e-3, spacing);
    add_field(&s, &c);
    for (int i = 0; i < 200; i++) {
        const double height = 1.0 - 2.0 * (i + 0.5) / 200.0, turn = 2.39996 * i;
        const double across = sqrt(1.0 - height * height);
        double at[3];
        vbss_scene_nearest found;
        vec3_store(at, vec3_scale(vec3_make(across * cos(turn), height, across * sin(turn)), 7e-3));
        expect_ok(vbss_scene_find_nearest(s.scene, at, 1.0, UINT32_MAX, &found, sizeof found));
        largest = fmax(largest, fabs(found.distance - (7e-3 - BALL_RADIUS)));
    }
    small_end(&s);
    return largest;
}

/* Chords and linear interpolation: the error is 0.55 h^2 / R. */
static void surface_is_where_the_distances_say_to_second_order(void **state)
{
    (void)state;
    const double spacings[] = {1e-3, 0.5e-3, 0.25e-3};
    for (int i = 0; i < 3; i++) {
        const double h = spacings[i], error = error_of_ball(h);
        assert_true(error < 0.6 * h * h / BALL_RADIUS);
    }
}

#define TILT 0.3
static double distance_of_incline(vec3 x)
{
    return vec3_dot(x, vec3_make(sin(TILT), cos(TILT), 0.0));
}

/* A plane has no chords: level triangles do not brake. */
static void thread_slides_down_a_sampled_incline_as_on_a_plane(void **state)
{
    (void)state;
    const double time = 0.1, h = 1e-3, friction = 0.2;
    const double fallen = 0.5 * 9.81 * (sin(TILT) - friction * cos(TILT)) * time * time;
    small s;
    vbss_thread *thread;
    begin(&s);
    vbss_scene_distance_field_config c = sample(distance_of_incline, 12e-3, 1e-3);
    c.friction = friction;
    add_field(&s, &c);
    const vec3 up = vec3_scale(vec3_make(sin(TILT), cos(TILT), 0.0), s.thread.radius);
    small_thread(&s, vec3_add(up, vec3_make(0.0, 0.0, -8e-3)),
                 vec3_add(up, vec3_make(0.0, 0.0, 8e-3)), 16, &thread);
    small_steps(&s, (uint32_t)(time / h + 0.5), h);
    const vec3 moved = vec3_sub(small_node(thread, 8), up);
    const double expected = fallen * (1.0 + h / time);
    expect_near(expected, vec3_dot(moved, vec3_make(cos(TILT), -sin(TILT), 0.0)), 3e-3 * expected);
    expect_near(0.0, distance_of_incline(moved), 0.02e-3);
    small_end(&s);
}

/* ---- the law of the rope */

static double cylinder_spacing;

static double distance_of_cylinder(vec3 x)
{
    return sqrt(x.x * x.x + x.y * x.y) - CAPSTAN_RADIUS;
}

static void add_cylinder(capstan *c)
{
    uint32_t body;
    vbss_scene_distance_field_config field = sample(distance_of_cylinder, 3.1e-3, cylinder_spacing);
    field.friction = c->friction;
    expect_ok(vbss_scene_add_distance_field(c->rig.scene, &field, &body));
}

static void tension_over_a_sampled_cylinder_follows_capstan_equation(void **state)
{
    (void)state;
    const double cells_of_radius[] = {5.0, 8.0, 12.0};
    for (int i = 0; i < 3; i++) {
        capstan c = capstan_half_turn(0.3);
        cylinder_spacing = CAPSTAN_RADIUS / cells_of_radius[i];
        c.fineness = 0.2;
        c.speed = i % 2 == 0 ? 2e-3 : 10e-3;
        c.add_cylinder = add_cylinder;
        const double got = capstan_pulled_over(&c);
        expect_near(1.0, got / (0.3 * c.angle), 0.01);
    }
}

/* ---- nothing passes */

/* A plate that is as thick as two cells. */
static double distance_of_plate(vec3 x)
{
    return fabs(x.y) - 1e-3;
}

static void throw_at(distance_function f, double min_distance, int trial)
{
    small s;
    vbss_thread *thread;
    begin(&s);
    const vbss_scene_distance_field_config c = sample(f, 12e-3, 1e-3);
    add_field(&s, &c);
    small_thread(&s, vec3_make(-8e-3, 10e-3 + 1e-3 * trial, 1e-3), vec3_make(8e-3, 10e-3, -2e-3),
                 20, &thread);
    double velocities[21][3];
    for (int i = 0; i < 21; i++) {
        vec3_store(velocities[i], vec3_make(0.1 * trial, -20.0, 0.1 * trial));
    }
    expect_ok(vbss_thread_set_state(thread, NULL, velocities[0], 21));
    for (int step = 0; step < 20; step++) {
        small_steps(&s, 1, 1e-3);
        for (uint32_t i = 0; i < 21; i++) {
            assert_true(f(small_node(thread, i)) > min_distance);
        }
    }
    small_end(&s);
}

/* At half the thickness inside of the distance 0 is the middle of the wall. */
static void thrown_threads_never_pass_a_field(void **state)
{
    (void)state;
    for (int trial = 0; trial < 6; trial++) {
        throw_at(distance_of_plate, -0.25e-3, trial);
        throw_at(distance_of_ball, -0.25e-3 - 1e-6 / (8.0 * BALL_RADIUS), trial);
    }
}

/* ---- what a grid cannot show */

/* A wall across the diagonals of cells, of which 0.8 mm are inside of the thickness. */
static double distance_of_slanting_wall(vec3 x)
{
    const double along = (x.x + x.y + x.z) / sqrt(3.0);
    return fabs(along - 0.5e-3 * sqrt(3.0)) - 0.65e-3;
}

static const char *last_error(const small *s)
{
    const char *text;
    expect_ok(vbss_context_get_last_error(s->context, NULL, &text));
    return text;
}

static void features_thinner_than_a_cell_are_refused(void **state)
{
    (void)state;
    small s;
    uint32_t body = 77;
    begin(&s);
    vbss_scene_distance_field_config c = sample(distance_of_slanting_wall, 6e-3, 1e-3);
    assert_int_equal(vbss_scene_add_distance_field(s.scene, &c, &body), VBSS_ERROR_OUT_OF_RANGE);
    assert_non_null(strstr(last_error(&s), "twice"));
    assert_int_equal(body, 77);
    c = sample(distance_of_slanting_wall, 6e-3, 0.2e-3);
    add_field(&s, &c);
    small_end(&s);
}

static void expect_refusal(small *s, vbss_result expected,
                           const vbss_scene_distance_field_config *c)
{
    uint32_t body = 77;
    assert_int_equal(vbss_scene_add_distance_field(s->scene, c, &body), expected);
    assert_int_equal(body, 77);
}

static void refused_distance_fields_change_nothing(void **state)
{
    (void)state;
    small s;
    begin(&s);
    const uint64_t hash = small_hash(&s);
    const vbss_scene_distance_field_config good = sample(distance_of_ball, 6e-3, 1e-3);
    vbss_scene_distance_field_config bad = good;
    bad.distance_count--;
    expect_refusal(&s, VBSS_ERROR_OUT_OF_RANGE, &bad);
    bad = good;
    bad.distances = NULL;
    expect_refusal(&s, VBSS_ERROR_NULL_ARGUMENT, &bad);
    for (int k = 0; k < 3; k++) {
        bad = good;
        bad.counts[k] = 1;
        expect_refusal(&s, VBSS_ERROR_OUT_OF_RANGE, &bad);
        bad = good;
        bad.spacing[k] = 0.0;
        expect_refusal(&s, VBSS_ERROR_OUT_OF_RANGE, &bad);
    }
    bad = good;
    bad.position[1] = (double)NAN;
    expect_refusal(&s, VBSS_ERROR_NOT_FINITE, &bad);
    bad = good;
    memset(bad.orientation, 0, sizeof bad.orientation);
    expect_refusal(&s, VBSS_ERROR_OUT_OF_RANGE, &bad);
    bad = good;
    bad.thickness = 20e-3; /* nothing of the ball is left */
    expect_refusal(&s, VBSS_ERROR_OUT_OF_RANGE, &bad);
    bad = good;
    bad.one_sided = 2;
    expect_refusal(&s, VBSS_ERROR_OUT_OF_RANGE, &bad);
    distances[5] = (double)INFINITY;
    expect_refusal(&s, VBSS_ERROR_NOT_FINITE, &good);
    assert_true(small_hash(&s) == hash);
    small_end(&s);
}

/* ---- saved scenes */

static void loaded_scene_has_the_surface_and_goes_on_to_the_same_bits(void **state)
{
    (void)state;
    small s;
    harness_memory memory;
    vbss_scene *loaded = NULL;
    begin(&s);
    const vbss_scene_distance_field_config c = sample(distance_of_ball, 6e-3, 1e-3);
    add_field(&s, &c);
    small_thread(&s, vec3_make(-5e-3, 7e-3, -8e-3), vec3_make(3e-3, 6e-3, 8e-3), 20, NULL);
    small_steps(&s, 40, 1e-3);
    const small_state saved = small_save(&s);
    vbss_context *context = harness_context(&memory);
    expect_ok(vbss_scene_load(context, saved.bytes, saved.count, &loaded));
    for (int i = 0; i < 20; i++) {
        uint64_t hash = 0;
        expect_ok(vbss_scene_get_hash(loaded, &hash));
        assert_true(hash == small_hash(&s));
        expect_ok(vbss_scene_step(loaded, 1e-3));
        small_steps(&s, 1, 1e-3);
    }
    free(saved.bytes);
    expect_ok(vbss_scene_destroy(loaded));
    harness_context_end(context, &memory);
    small_end(&s);
}

int test_distance_field(void)
{
    const struct CMUnitTest tests[] = {
        harness_test(surface_is_where_the_distances_say_to_second_order),
        harness_test(thread_slides_down_a_sampled_incline_as_on_a_plane),
        harness_test(tension_over_a_sampled_cylinder_follows_capstan_equation),
        harness_test(thrown_threads_never_pass_a_field),
        harness_test(features_thinner_than_a_cell_are_refused),
        harness_test(refused_distance_fields_change_nothing),
        harness_test(loaded_scene_has_the_surface_and_goes_on_to_the_same_bits),
    };
    return cmocka_run_group_tests_name("scene.distance_field", tests, NULL, NULL);
}
