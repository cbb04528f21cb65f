/* Bodies by number, data of the host, rays and nearest bodies. */
#include "scene/small.h"

#include <vblast_ss/scene_query.h>
#include <vblast_ss/scene_settings.h>

#define ALL UINT32_MAX

static const vec3 half = {0.0, 0.0, 5e-3};

/* A ray that may miss. */
static vbss_scene_ray_hit cast(const small *s, vec3 from, vec3 translation, uint32_t mask)
{
    vbss_scene_ray_hit hit;
    double origin[3], along[3];
    vec3_store(origin, from);
    vec3_store(along, translation);
    expect_ok(vbss_scene_cast_ray(s->scene, origin, along, mask, &hit, sizeof hit));
    return hit;
}

static vbss_scene_nearest nearest(const small *s, vec3 to, double radius)
{
    vbss_scene_nearest found;
    double point[3];
    vec3_store(point, to);
    expect_ok(vbss_scene_find_nearest(s->scene, point, radius, ALL, &found, sizeof found));
    return found;
}

/* ---- bodies */

static void bodies_are_listed_with_kinds_and_handles(void **state)
{
    (void)state;
    small s;
    vbss_thread *thread;
    vbss_drain *drain, *found;
    uint32_t numbers[4], count;
    vbss_scene_body_info info;
    small_begin_scene(&s);
    const uint32_t removed =
        small_stick(&s, VBSS_SCENE_RIGID_DRIVEN, vec3_make(1.0, 0.0, 0.0), half, 1e-3);
    const uint32_t a =
        small_thread(&s, vec3_make(0.0, 0.2, 0.0), vec3_make(0.02, 0.2, 0.0), 10, &thread);
    const uint32_t b = small_drain(&s, &drain);
    const uint32_t c =
        small_stick(&s, VBSS_SCENE_RIGID_COUPLED, vec3_make(0.5, 0.0, 0.0), half, 1e-3);
    expect_ok(vbss_scene_remove(s.scene, removed));
    expect_ok(vbss_scene_get_bodies(s.scene, NULL, 0, &count));
    assert_int_equal(count, 3);
    assert_int_equal(vbss_scene_get_bodies(s.scene, numbers, 2, &count), VBSS_ERROR_CAPACITY);
    assert_int_equal(count, 3);
    expect_ok(vbss_scene_get_bodies(s.scene, numbers, 4, &count));
    assert_true(numbers[0] == a && numbers[1] == b && numbers[2] == c);
    const vbss_scene_body_kind kinds[] = {VBSS_SCENE_BODY_THREAD, VBSS_SCENE_BODY_DRAIN,
                                          VBSS_SCENE_BODY_RIGID};
    for (int i = 0; i < 3; i++) {
        expect_ok(vbss_scene_get_body(s.scene, numbers[i], &info, sizeof info));
        assert_int_equal(info.kind, kinds[i]);
        assert_true(info.category == 1u && info.mask == ALL);
    }
    assert_int_equal(info.motion, VBSS_SCENE_RIGID_COUPLED);
    expect_near(0.15, info.friction, 0.0);
    expect_ok(vbss_scene_get_drain(s.scene, b, &found));
    assert_ptr_equal(found, drain);
    assert_int_equal(vbss_scene_get_drain(s.scene, a, &found), VBSS_ERROR_INCOMPATIBLE);
    assert_null(found);
    assert_int_equal(vbss_scene_get_body(s.scene, removed, &info, sizeof info),
                     VBSS_ERROR_NOT_FOUND);
    small_end(&s);
}

static void user_data_stays_with_body_and_is_no_state(void **state)
{
    (void)state;
    small s;
    int mark = 0;
    void *data = &mark;
    small_begin_scene(&s);
    const uint32_t a = small_stick(&s, VBSS_SCENE_RIGID_DRIVEN, vec3_zero(), half, 1e-3);
    const uint64_t before = small_hash(&s);
    expect_ok(vbss_scene_get_user_data(s.scene, a, &data));
    assert_null(data);
    expect_ok(vbss_scene_set_user_data(s.scene, a, &mark));
    small_steps(&s, 0, 1e-3);
    assert_true(small_hash(&s) == before);
    expect_ok(vbss_scene_get_user_data(s.scene, a, &data));
    assert_ptr_equal(data, &mark);
    expect_ok(vbss_scene_remove(s.scene, a));
    assert_int_equal(vbss_scene_get_user_data(s.scene, a, &data), VBSS_ERROR_NOT_FOUND);
    const uint32_t b = small_stick(&s, VBSS_SCENE_RIGID_DRIVEN, vec3_zero(), half, 1e-3);
    expect_ok(vbss_scene_get_user_data(s.scene, b, &data));
    assert_null(data);
    small_end(&s);
}

/* ---- rays */

static void ray_meets_capsule_where_geometry_says(void **state)
{
    (void)state;
    small s;
    small_begin_scene(&s);
    const uint32_t far =
        small_stick(&s, VBSS_SCENE_RIGID_DRIVEN, vec3_make(0.2, 0.0, 0.0), half, 2e-3);
    const uint32_t near =
        small_stick(&s, VBSS_SCENE_RIGID_DRIVEN, vec3_make(0.1, 0.0, 0.0), half, 2e-3);
    vbss_scene_ray_hit hit = cast(&s, vec3_zero(), vec3_make(0.4, 0.0, 0.0), ALL);
    assert_int_equal(hit.is_hit, 1);
    assert_int_equal(hit.body, near);
    expect_near(0.098 / 0.4, hit.fraction, 1e-15);
    expect_near(0.098, hit.point[0], 1e-15);
    expect_near(-1.0, hit.normal[0], 1e-15);
    /* the rounded end: centre at z = 5 mm */
    hit = cast(&s, vec3_make(0.1, 0.0, 0.1), vec3_make(0.0, 0.0, -0.2), ALL);
    expect_near(0.007, hit.point[2], 1e-15);
    expect_near(1.0, hit.normal[2], 1e-15);
    /* too short, beside, and away */
    assert_int_equal(cast(&s, vec3_zero(), vec3_make(0.097, 0.0, 0.0), ALL).is_hit, 0);
    assert_int_equal(cast(&s, vec3_make(0.0, 2.1e-3, 0.0), vec3_make(1.0, 0.0, 0.0), ALL).is_hit,
                     0);
    assert_int_equal(cast(&s, vec3_zero(), vec3_make(-1.0, 0.0, 0.0), ALL).is_hit, 0);
    /* from inside */
    hit = cast(&s, vec3_make(0.1, 1e-3, 0.0), vec3_make(1.0, 0.0, 0.0), ALL);
    expect_near(0.0, hit.fraction, 0.0);
    expect_near(1.0, hit.normal[1], 1e-15);
    /* a mask leaves out the nearer one */
    expect_ok(vbss_scene_set_filter(s.scene, near, 2u, ALL));
    assert_int_equal(cast(&s, vec3_zero(), vec3_make(0.4, 0.0, 0.0), 1u).body, far);
    small_end(&s);
}

static void ray_meets_floor_wall_and_thread(void **state)
{
    (void)state;
    small s;
    vbss_drain *drain;
    vbss_view view;
    small_begin(&s);
    s.config.floor = 1;
    s.config.floor_height = -0.3;
    small_create(&s);
    const uint32_t thread =
        small_thread(&s, vec3_make(0.3, 0.0, 0.0), vec3_make(0.34, 0.0, 0.0), 10, NULL);
    const uint32_t wall = small_drain(&s, &drain);
    vbss_scene_ray_hit hit = cast(&s, vec3_make(0.5, 0.1, 0.0), vec3_make(0.0, -1.0, 0.0), ALL);
    assert_true(hit.is_hit == 1 && hit.body == 0);
    expect_near(0.4, hit.fraction, 1e-14);
    hit = cast(&s, vec3_make(0.315, 0.1, 0.0), vec3_make(0.0, -1.0, 0.0), ALL);
    assert_true(hit.body == thread && hit.feature == 3);
    expect_near(s.thread.radius, hit.point[1], 1e-14);
    /* from outside to the centre of a triangle: the wall is half its thickness nearer */
    expect_ok(vbss_drain_get_view(drain, VBSS_DRAIN_VIEW_POSITIONS, &view, sizeof view));
    const double *x = view.data;
    expect_ok(vbss_drain_get_view(drain, VBSS_DRAIN_VIEW_TRIANGLES, &view, sizeof view));
    const uint32_t *n = view.data;
    const vec3 p = vec3_load(x + 3 * (size_t)n[0]), q = vec3_load(x + 3 * (size_t)n[1]),
               r = vec3_load(x + 3 * (size_t)n[2]);
    const vec3 centre = vec3_scale(vec3_add(vec3_add(p, q), r), 1.0 / 3.0);
    const vec3 normal = vec3_unit_or(vec3_cross(vec3_sub(q, p), vec3_sub(r, p)), vec3_zero());
    const double start = 0.9 * s.drain.thickness;
    hit = cast(&s, vec3_add_scaled(centre, start, normal), vec3_scale(normal, -1e-2), ALL);
    assert_int_equal(hit.body, wall);
    expect_near((start - 0.5 * s.drain.thickness) / 1e-2, hit.fraction, 1e-9);
    expect_near(1.0, vec3_dot(normal, vec3_load(hit.normal)), 1e-9);
    small_end(&s);
}

/* ---- distance */

static void nearest_body_has_distance_of_surface(void **state)
{
    (void)state;
    small s;
    small_begin(&s);
    s.config.floor = 1;
    s.config.floor_height = -0.05;
    small_create(&s);
    const uint32_t a = small_stick(&s, VBSS_SCENE_RIGID_DRIVEN, vec3_zero(), half, 2e-3);
    const uint32_t thread =
        small_thread(&s, vec3_make(0.05, 0.0, 0.0), vec3_make(0.09, 0.0, 0.0), 10, NULL);
    vbss_scene_nearest found = nearest(&s, vec3_make(0.01, 0.0, 0.0), 0.02);
    assert_true(found.is_found == 1 && found.body == a);
    expect_near(0.008, found.distance, 1e-15);
    expect_near(0.002, found.point[0], 1e-15);
    expect_near(1.0, found.normal[0], 1e-15);
    assert_int_equal(nearest(&s, vec3_make(0.01, 0.0, 0.0), 0.0079).is_found, 0);
    found = nearest(&s, vec3_make(0.071, 0.01, 0.0), 0.05);
    assert_true(found.body == thread && found.feature == 5);
    expect_near(0.01 - s.thread.radius, found.distance, 1e-15);
    found = nearest(&s, vec3_make(0.3, -0.04, 0.0), 0.02);
    assert_true(found.is_found == 1 && found.body == 0);
    expect_near(0.01, found.distance, 1e-15);
    found = nearest(&s, vec3_make(0.0, 5e-4, 0.0), 0.02);
    expect_near(-1.5e-3, found.distance, 1e-15);
    small_end(&s);
}

static void queries_change_no_state(void **state)
{
    (void)state;
    small s;
    small_begin_scene(&s);
    small_stick(&s, VBSS_SCENE_RIGID_FREE, vec3_zero(), half, 2e-3);
    small_thread(&s, vec3_make(0.0, 2.1e-3, 0.0), vec3_make(0.04, 2.1e-3, 0.0), 10, NULL);
    small_steps(&s, 5, 1e-3);
    const uint64_t before = small_hash(&s);
    (void)cast(&s, vec3_zero(), vec3_make(1.0, 0.0, 0.0), ALL);
    (void)nearest(&s, vec3_zero(), 1.0);
    assert_true(small_hash(&s) == before);
    const double origin[3] = {0.0, 0.0, 0.0}, big[3] = {1e5, 0.0, 0.0};
    vbss_scene_ray_hit hit;
    assert_int_equal(vbss_scene_cast_ray(s.scene, origin, origin, ALL, &hit, sizeof hit),
                     VBSS_ERROR_OUT_OF_RANGE);
    assert_int_equal(vbss_scene_cast_ray(s.scene, origin, big, ALL, &hit, sizeof hit),
                     VBSS_ERROR_OUT_OF_RANGE);
    small_end(&s);
}

int test_queries(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(bodies_are_listed_with_kinds_and_handles),
        cmocka_unit_test(user_data_stays_with_body_and_is_no_state),
        cmocka_unit_test(ray_meets_capsule_where_geometry_says),
        cmocka_unit_test(ray_meets_floor_wall_and_thread),
        cmocka_unit_test(nearest_body_has_distance_of_surface),
        cmocka_unit_test(queries_change_no_state),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
