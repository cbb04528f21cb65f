/* Planes beside the floor: forces of a groove in closed form, the same motion as on the floor, nothing that passes,
 * saved scenes, queries and refused input. */
#include <stdlib.h>

#include "scene/small.h"

#define GRAVITY 9.81
#define SAG 0.02e-3 /* m, what the contacts give way */

static void begin(small *s)
{
    small_begin(s);
    s->config.floor = 0;
    s->config.rigid_capacity = 12;
    s->config.contact_capacity = 4096;
    s->thread.gravity[1] = -GRAVITY;
    s->rigid.gravity[1] = -GRAVITY;
}

static const vbss_scene_plane_config *level_plane(void)
{
    static vbss_scene_plane_config config;
    config = vbss_scene_plane_config_default();
    return &config;
}

static uint32_t add_plane(small *s, vec3 normal, double height, double friction)
{
    uint32_t body = 0;
    vbss_scene_plane_config config = vbss_scene_plane_config_default();
    vec3_store(config.normal, normal);
    config.height = height;
    config.friction = friction;
    expect_ok(vbss_scene_add_plane(s->scene, &config, &body));
    return body;
}

/* The normal of a plane that rises to the left by `slope`, rad; a negative one rises to the right. */
static vec3 normal_of(double slope)
{
    return vec3_make(sin(slope), cos(slope), 0.0);
}

typedef struct groove {
    double left, right; /* slopes of its sides, rad, both positive */
    double friction;
    uint32_t planes[2];
} groove;

static void add_groove(small *s, groove *g)
{
    g->planes[0] = add_plane(s, normal_of(g->left), 0.0, g->friction);
    g->planes[1] = add_plane(s, normal_of(-g->right), 0.0, g->friction);
}

/* Where a circle of a radius touches both sides. */
static vec3 middle_in(const groove *g, double radius)
{
    const double y = radius * (sin(g->left) + sin(g->right)) / sin(g->left + g->right);
    return vec3_make((radius - y * cos(g->left)) / sin(g->left), y, 0.0);
}

static double force_on(const small *s, uint32_t plane)
{
    const vbss_scene_rigid_state state = small_rigid(s, plane);
    return vec3_norm(vec3_load(state.contact_force));
}

/* ---- forces of a groove */

static void expect_forces(const small *s, const groove *g, double weight)
{
    const double sum = sin(g->left + g->right);
    expect_near(weight * sin(g->right) / sum, force_on(s, g->planes[0]), 1e-3 * weight);
    expect_near(weight * sin(g->left) / sum, force_on(s, g->planes[1]), 1e-3 * weight);
}

static const groove grooves[] = {{0.8, 0.8, 0.0, {0}}, {0.3, 1.1, 0.0, {0}}, {1.2, 0.5, 0.0, {0}}};

static void groove_bears_a_body_with_forces_of_the_closed_form(void **state)
{
    (void)state;
    for (size_t i = 0; i < sizeof grooves / sizeof grooves[0]; i++) {
        small s;
        groove g = grooves[i];
        begin(&s);
        small_create(&s);
        add_groove(&s, &g);
        const vec3 middle = middle_in(&g, 2e-3);
        const uint32_t stick =
            small_stick(&s, VBSS_SCENE_RIGID_FREE, middle, vec3_make(0.0, 0.0, 8e-3), 2e-3);
        small_steps(&s, 200, 1e-3);
        expect_near(0.0, vec3_distance(middle, small_position(&s, stick)), SAG);
        expect_forces(&s, &g, 0.02 * GRAVITY);
        small_end(&s);
    }
}

static double weight_of(const small *s, double length)
{
    return s->thread.linear_density * length * GRAVITY;
}

static void groove_bears_a_thread_with_forces_of_the_closed_form(void **state)
{
    (void)state;
    for (size_t i = 0; i < sizeof grooves / sizeof grooves[0]; i++) {
        small s;
        groove g = grooves[i];
        vbss_thread *thread;
        begin(&s);
        small_create(&s);
        add_groove(&s, &g);
        const vec3 middle = middle_in(&g, s.thread.radius);
        small_thread(&s, vec3_add(middle, vec3_make(0.0, 0.0, -10e-3)),
                     vec3_add(middle, vec3_make(0.0, 0.0, 10e-3)), 20, &thread);
        small_steps(&s, 300, 1e-3);
        expect_near(0.0, vec3_distance(middle, small_node(thread, 10)), SAG);
        expect_forces(&s, &g, weight_of(&s, 20e-3));
        small_end(&s);
    }
}

/* Along the groove a thread is braked by the friction of both sides. The implicit step adds h / time to the
 * distance of a free fall. */
static void thread_slides_along_a_groove_by_the_closed_form(void **state)
{
    (void)state;
    const double time = 0.1, tilt = 0.6, h = 1e-3;
    for (size_t i = 0; i < sizeof grooves / sizeof grooves[0]; i++) {
        small s;
        groove g = grooves[i];
        vbss_thread *thread;
        g.friction = 0.2;
        begin(&s);
        s.thread.linear_density = 1e-3; /* the solver's tolerance is in newtons */
        s.thread.gravity[1] = -GRAVITY * cos(tilt);
        s.thread.gravity[2] = GRAVITY * sin(tilt);
        small_create(&s);
        add_groove(&s, &g);
        const vec3 middle = middle_in(&g, s.thread.radius);
        small_thread(&s, vec3_add(middle, vec3_make(0.0, 0.0, -10e-3)),
                     vec3_add(middle, vec3_make(0.0, 0.0, 10e-3)), 20, &thread);
        small_steps(&s, (uint32_t)(time / h + 0.5), h);
        const double pressed = (sin(g.left) + sin(g.right)) / sin(g.left + g.right);
        const double fallen = 0.5 * GRAVITY * time * time *
                              (sin(tilt) - g.friction * cos(tilt) * pressed) * (1.0 + h / time);
        expect_near(fallen, small_node(thread, 10).z - middle.z, 3e-3 * fallen);
        small_end(&s);
    }
}

/* ---- the floor and a plane */

static vec3 node_after_fall(bool is_on_floor, double *height)
{
    small s;
    vbss_thread *thread;
    begin(&s);
    s.config.floor = is_on_floor ? 1 : 0;
    s.config.floor_normal[0] = 0.4;
    s.config.floor_normal[1] = 0.9;
    s.config.floor_height = 1e-3;
    s.config.floor_friction = 0.25;
    small_create(&s);
    if (!is_on_floor) {
        add_plane(&s, vec3_make(0.4, 0.9, 0.0), 1e-3, 0.25);
    }
    small_thread(&s, vec3_make(-4e-3, 6e-3, -10e-3), vec3_make(3e-3, 5e-3, 9e-3), 20, &thread);
    const uint32_t stick = small_stick(&s, VBSS_SCENE_RIGID_FREE, vec3_make(15e-3, 8e-3, 0.0),
                                       vec3_make(0.0, 1e-3, 8e-3), 2e-3);
    small_steps(&s, 100, 1e-3);
    *height = small_position(&s, stick).y;
    const vec3 x = small_node(thread, 7);
    small_end(&s);
    return x;
}

static void bodies_fall_on_a_plane_as_on_the_floor(void **state)
{
    (void)state;
    double on_floor, on_plane;
    const vec3 a = node_after_fall(true, &on_floor), b = node_after_fall(false, &on_plane);
    expect_near(0.0, vec3_distance(a, b), 1e-12);
    expect_near(on_floor, on_plane, 1e-12);
}

/* ---- nothing passes */

typedef struct corner {
    vec3 normals[3];
    double lowest; /* of all nodes in all states, m */
} corner;

static void watch(void *watcher, const scene_object *s)
{
    corner *c = watcher;
    for (uint32_t i = 0; i < s->body_count; i++) {
        const thread_object *t = s->bodies[i].thread.thread;
        for (uint32_t k = 0; s->bodies[i].kind == SCENE_BODY_THREAD && k < t->node_count; k++) {
            for (int j = 0; j < 3; j++) {
                c->lowest = fmin(c->lowest, vec3_dot(c->normals[j], t->trial[k]));
            }
        }
    }
}

static void thrown_threads_never_pass_a_corner_of_planes(void **state)
{
    (void)state;
    for (int trial = 0; trial < 12; trial++) {
        small s;
        vbss_thread *thread;
        corner c = {{normal_of(0.5 + 0.05 * trial), normal_of(-1.0),
                     vec3_unit_or(vec3_make(0.1 * trial, 0.5, 1.0), vec3_zero())},
                    1.0};
        begin(&s);
        small_create(&s);
        for (int k = 0; k < 3; k++) {
            add_plane(&s, c.normals[k], 0.0, 0.1 * k);
        }
        small_thread(&s, vec3_make(-8e-3, 40e-3, 21e-3), vec3_make(9e-3, 40e-3, 18e-3), 20,
                     &thread);
        double velocities[21][3];
        for (int i = 0; i < 21; i++) {
            vec3_store(velocities[i], vec3_make(0.5 * trial, -20.0, -10.0));
        }
        expect_ok(vbss_thread_set_state(thread, NULL, velocities[0], 21));
        small_object(&s)->on_substep = watch;
        small_object(&s)->on_substep_data = &c;
        small_steps(&s, 40, 1e-3);
        assert_true(c.lowest > 0.0 && c.lowest < 0.2e-3);
        small_end(&s);
    }
}

/* A driven tool is held back, and no node of a drain passes. */
static void planes_hold_back_tools_and_drains(void **state)
{
    (void)state;
    small s;
    vbss_drain *drain;
    begin(&s);
    small_create(&s);
    small_drain(&s, &drain);
    const uint32_t plane = add_plane(&s, vec3_make(0.0, -1.0, 0.0), -7.2e-3, 0.3);
    const uint32_t tool = small_stick(&s, VBSS_SCENE_RIGID_DRIVEN, vec3_make(20e-3, 4e-3, 0.0),
                                      vec3_make(0.0, 0.0, 2e-3), 2e-3);
    for (int i = 0; i < 40; i++) {
        small_move(&s, tool, vec3_make(20e-3, 4e-3 + 0.2e-3 * i, 0.0));
        small_steps(&s, 1, 1e-3);
    }
    assert_true(small_position(&s, tool).y < 7.2e-3);
    const double up[3] = {0.0, 300.0, 0.0};
    expect_ok(vbss_scene_set_gravity(s.scene, 1, up));
    for (int i = 0; i < 100; i++) {
        small_steps(&s, 1, 1e-3);
        const drain_object *d = small_object(&s)->bodies[0].drain.drain;
        for (uint32_t k = 0; k < d->mesh.node_count; k++) {
            assert_true(d->x[k].y < 7.2e-3);
        }
    }
    assert_true(force_on(&s, plane) > 0.0);
    small_end(&s);
}

/* ---- what a host may ask */

static void queries_find_planes(void **state)
{
    (void)state;
    small s;
    vbss_scene_body_info info;
    vbss_scene_ray_hit hit;
    vbss_scene_nearest found;
    vbss_scene_overlap overlap;
    begin(&s);
    small_create(&s);
    const uint32_t plane = add_plane(&s, vec3_make(0.0, 2.0, 0.0), 3e-3, 0.25);
    const double from[3] = {2e-3, 10e-3, 1e-3}, down[3] = {0.0, -20e-3, 0.0};
    expect_ok(vbss_scene_get_body(s.scene, plane, &info, sizeof info));
    assert_int_equal(info.kind, VBSS_SCENE_BODY_PLANE);
    expect_near(0.25, info.friction, 0.0);
    expect_ok(vbss_scene_cast_ray(s.scene, from, down, UINT32_MAX, &hit, sizeof hit));
    assert_true(hit.is_hit == 1 && hit.body == plane && hit.feature == 0);
    expect_near(3e-3, hit.point[1], 1e-15);
    expect_ok(vbss_scene_find_nearest(s.scene, from, 1.0, UINT32_MAX, &found, sizeof found));
    assert_true(found.is_found == 1 && found.body == plane);
    expect_near(7e-3, found.distance, 1e-15);
    const uint32_t thread =
        small_thread(&s, vec3_make(0.0, 2e-3, 0.0), vec3_make(0.0, 4e-3, 8e-3), 10, NULL);
    expect_ok(vbss_scene_get_overlap(s.scene, thread, &overlap, sizeof overlap));
    assert_int_equal(overlap.body, plane);
    expect_near(1e-3 + s.thread.radius, overlap.depth, 1e-12);
    small_end(&s);
}

static void plane_in_a_body_is_refused_if_the_scene_refuses_overlaps(void **state)
{
    (void)state;
    small s;
    uint32_t body = 0;
    begin(&s);
    s.config.overlap = VBSS_SCENE_OVERLAP_REFUSE;
    small_create(&s);
    small_thread(&s, vec3_make(0.0, -1e-3, 0.0), vec3_make(0.0, 4e-3, 8e-3), 10, NULL);
    assert_int_equal(vbss_scene_add_plane(s.scene, level_plane(), &body), VBSS_ERROR_OUT_OF_RANGE);
    add_plane(&s, vec3_make(0.0, 1.0, 0.0), -2e-3, 0.0);
    small_end(&s);
}

static void filtered_plane_touches_nothing(void **state)
{
    (void)state;
    small s;
    vbss_thread *thread;
    begin(&s);
    small_create(&s);
    const uint32_t plane = add_plane(&s, vec3_make(0.0, 1.0, 0.0), 0.0, 0.25);
    expect_ok(vbss_scene_set_filter(s.scene, plane, 2, 2));
    small_thread(&s, vec3_make(0.0, 1e-3, -10e-3), vec3_make(0.0, 1e-3, 10e-3), 20, &thread);
    small_steps(&s, 100, 1e-3);
    assert_true(small_node(thread, 10).y < -20e-3);
    small_end(&s);
}

/* ---- saved scenes */

static void begin_with_planes(small *s, double height)
{
    begin(s);
    small_create(s);
    add_plane(s, normal_of(0.4), 0.0, 0.2);
    add_plane(s, normal_of(-0.7), height, 0.1);
    small_thread(s, vec3_make(-5e-3, 9e-3, -10e-3), vec3_make(3e-3, 8e-3, 10e-3), 20, NULL);
}

static void loaded_scene_has_the_planes_and_goes_on_to_the_same_bits(void **state)
{
    (void)state;
    small s, other;
    harness_memory memory;
    vbss_scene *loaded = NULL;
    begin_with_planes(&s, 1e-3);
    expect_ok(vbss_scene_set_friction(s.scene, 2, 0.4));
    small_steps(&s, 60, 1e-3);
    const small_state saved = small_save(&s);
    vbss_context *context = harness_context(&memory);
    expect_ok(vbss_scene_load(context, saved.bytes, saved.count, &loaded));
    for (int i = 0; i < 40; i++) {
        uint64_t hash = 0;
        expect_ok(vbss_scene_get_hash(loaded, &hash));
        assert_true(hash == small_hash(&s));
        expect_ok(vbss_scene_step(loaded, 1e-3));
        small_steps(&s, 1, 1e-3);
    }
    begin_with_planes(&other, 1.1e-3);
    assert_int_not_equal(vbss_scene_restore(other.scene, saved.bytes, saved.count), VBSS_OK);
    small_end(&other);
    free(saved.bytes);
    expect_ok(vbss_scene_destroy(loaded));
    harness_context_end(context, &memory);
    small_end(&s);
}

/* ---- refused input */

static void refused_planes_change_nothing(void **state)
{
    (void)state;
    small s;
    uint32_t body = 77, pin = 0;
    begin(&s);
    small_create(&s);
    const uint64_t hash = small_hash(&s);
    const vbss_scene_plane_config good = vbss_scene_plane_config_default();
    vbss_scene_plane_config bad = good;
    bad.normal[1] = 0.0;
    assert_int_equal(vbss_scene_add_plane(s.scene, &bad, &body), VBSS_ERROR_OUT_OF_RANGE);
    bad.normal[1] = (double)INFINITY;
    assert_int_equal(vbss_scene_add_plane(s.scene, &bad, &body), VBSS_ERROR_NOT_FINITE);
    bad = good;
    bad.height = 1e4;
    assert_int_equal(vbss_scene_add_plane(s.scene, &bad, &body), VBSS_ERROR_OUT_OF_RANGE);
    bad = good;
    bad.friction = -0.1;
    assert_int_equal(vbss_scene_add_plane(s.scene, &bad, &body), VBSS_ERROR_OUT_OF_RANGE);
    bad = good;
    bad.reserved = 1;
    assert_int_equal(vbss_scene_add_plane(s.scene, &bad, &body), VBSS_ERROR_OUT_OF_RANGE);
    assert_int_equal(vbss_scene_add_plane(s.scene, &good, NULL), VBSS_ERROR_NULL_ARGUMENT);
    assert_true(small_hash(&s) == hash && body == 77);
    for (int i = 0; i < 12; i++) {
        expect_ok(vbss_scene_add_plane(s.scene, level_plane(), &body));
    }
    assert_int_equal(vbss_scene_add_plane(s.scene, level_plane(), &body), VBSS_ERROR_CAPACITY);
    const uint32_t thread =
        small_thread(&s, vec3_make(0.0, 2e-3, 0.0), vec3_make(0.0, 4e-3, 8e-3), 10, NULL);
    const double place[3] = {0.0, 0.0, 0.0};
    assert_int_equal(vbss_scene_set_rigid_target(s.scene, body, place, NULL),
                     VBSS_ERROR_INCOMPATIBLE);
    assert_int_equal(vbss_scene_pin_thread(s.scene, thread, 0, body, NULL, &pin),
                     VBSS_ERROR_INCOMPATIBLE);
    expect_ok(vbss_scene_remove(s.scene, body));
    small_steps(&s, 2, 1e-3);
    small_end(&s);
}

int test_planes(void)
{
    const struct CMUnitTest tests[] = {
        harness_test(groove_bears_a_body_with_forces_of_the_closed_form),
        harness_test(groove_bears_a_thread_with_forces_of_the_closed_form),
        harness_test(thread_slides_along_a_groove_by_the_closed_form),
        harness_test(bodies_fall_on_a_plane_as_on_the_floor),
        harness_test(thrown_threads_never_pass_a_corner_of_planes),
        harness_test(planes_hold_back_tools_and_drains),
        harness_test(queries_find_planes),
        harness_test(plane_in_a_body_is_refused_if_the_scene_refuses_overlaps),
        harness_test(filtered_plane_touches_nothing),
        harness_test(loaded_scene_has_the_planes_and_goes_on_to_the_same_bits),
        harness_test(refused_planes_change_nothing),
    };
    return cmocka_run_group_tests_name("scene.planes", tests, NULL, NULL);
}
