/* Host surfaces: at rest one acts as a static mesh; it carries, drags and lifts a thread by the closed solutions; and the
 * forces on its vertices add up to the contact forces. */
#include <stdlib.h>

#include "scene/surface_rig.h"

static surface_sheet sheet;

static void begin(small *s)
{
    small_begin(s);
    s->config.floor = 0;
    s->config.contact_capacity = 4096;
    s->config.candidate_capacity = 65536;
    s->thread.gravity[1] = -9.81;
    small_create(s);
}

/* A thread across the sheet, in contact. */
static vbss_thread *add_resting_thread(small *s)
{
    vbss_thread *thread;
    const double y = 0.5 * SURFACE_THICKNESS + s->thread.radius;
    small_thread(s, vec3_make(0.3e-3, y, -10e-3), vec3_make(0.3e-3, y, 10e-3), 20, &thread);
    return thread;
}

/* ---- motion */

static void surface_at_rest_is_a_static_mesh_to_the_bit(void **state)
{
    (void)state;
    vec3 ends[2][21];
    for (int moves = 0; moves < 2; moves++) {
        small s;
        uint32_t body;
        vbss_thread *thread;
        begin(&s);
        surface_make(&sheet, 9, 60e-3);
        sheet.config.friction = 0.2;
        for (uint32_t i = 0; i < sheet.config.vertex_count; i++) {
            sheet.x[i][1] = -0.3 * sheet.x[i][0];
        }
        vbss_scene_static_mesh_config mesh = vbss_scene_static_mesh_config_default();
        mesh.vertex_count = sheet.config.vertex_count;
        mesh.triangle_count = sheet.config.triangle_count;
        mesh.vertices = sheet.x[0];
        mesh.triangles = sheet.triangles[0];
        mesh.thickness = SURFACE_THICKNESS;
        mesh.friction = 0.2;
        if (moves == 1) {
            surface_add(&s, &sheet);
        } else {
            expect_ok(vbss_scene_add_static_mesh(s.scene, &mesh, &body));
        }
        small_thread(&s, vec3_make(-5e-3, 6e-3, -10e-3), vec3_make(4e-3, 4e-3, 10e-3), 20, &thread);
        for (int i = 0; i < 150; i++) {
            if (moves == 1 && i % 3 == 0) {
                surface_move(&s, &sheet);
            }
            small_steps(&s, 1, 1e-3);
        }
        assert_true(small_statistics(&s).contacts > 0);
        for (uint32_t i = 0; i < 21; i++) {
            ends[moves][i] = small_node(thread, i);
        }
        small_end(&s);
    }
    assert_memory_equal(ends[0], ends[1], sizeof ends[0]);
}

/* Where the middle of a thread is after 0.1 s on a belt that runs along x from the first step on. */
static double carried(double speed, double friction, double h)
{
    small s;
    begin(&s);
    surface_make(&sheet, 12, 60e-3);
    sheet.config.friction = friction;
    surface_add(&s, &sheet);
    vbss_thread *thread = add_resting_thread(&s);
    const double before = small_node(thread, 10).x;
    const uint32_t steps = (uint32_t)(0.1 / h + 0.5);
    for (uint32_t i = 1; i <= steps; i++) {
        surface_shift(&s, &sheet, vec3_make(speed * h * i, 0.0, 0.0));
        small_steps(&s, 1, h);
    }
    const double moved = small_node(thread, 10).x - before;
    small_end(&s);
    return moved;
}

/* A slow belt holds the thread from the second step on. On a fast one it slides, with the acceleration of
 * Coulomb's law; the implicit step adds h / time to the distance. */
static void belt_carries_a_thread_by_coulombs_law(void **state)
{
    (void)state;
    const double steps[] = {0.5e-3, 1e-3, 2e-3};
    for (int i = 0; i < 3; i++) {
        const double h = steps[i], slid = 0.5 * 0.2 * 9.81 * 0.01 * (1.0 + h / 0.1);
        expect_near(slid, carried(0.3, 0.2, h), 2e-3 * slid);
    }
    expect_near(1e-3, carried(10e-3, 2.0, 1e-3), 1e-6);
}

/* The surface accelerates upward from its second step on. */
static void lifted_thread_presses_with_its_weight_and_inertia(void **state)
{
    (void)state;
    small s;
    const double h = 1e-3, acceleration = 4.0;
    begin(&s);
    surface_make(&sheet, 6, 60e-3);
    surface_add(&s, &sheet);
    (void)add_resting_thread(&s);
    small_steps(&s, 200, h);
    const double weight = surface_total(&s, &sheet).force.y;
    assert_true(weight < 0.0);
    for (int i = 1; i <= 30; i++) {
        surface_shift(&s, &sheet, vec3_make(0.0, 0.5 * acceleration * (i * h) * (i * h), 0.0));
        small_steps(&s, 1, h);
    }
    const double lifting = surface_total(&s, &sheet).force.y;
    expect_near(1.0 + acceleration / 9.81, lifting / weight, 5e-3);
    small_end(&s);
}

/* ---- forces */

/* The contact forces on the surface by the views of the scene, and their torque at the points of the middle of its wall
 * where the contacts act. */
static surface_wrench contact_total(const small *s)
{
    surface_wrench sum = {vec3_zero(), vec3_zero()};
    const scene_object *object = small_object(s);
    const vec3 *x = surface_view(s, &sheet, VBSS_SCENE_SURFACE_VIEW_POSITIONS);
    const collision_shape *shape =
        object->collision->shapes[vbss_scene_body(object, sheet.body)->shape];
    const vbss_view features = small_view(s, VBSS_SCENE_VIEW_CONTACTS);
    for (uint32_t i = 0; i < object->contacts->count; i++) {
        const contact_constraint *c = &object->contacts->constraints[i];
        const double *at = scene_geometry_of(object, c)->barycentric;
        const bool is_a = c->key.body_a == sheet.body;
        uint64_t k = 0;
        while (k < features.count &&
               memcmp((const uint32_t *)features.data + 5 * k, &c->key, 20) != 0) {
            k++;
        }
        if (k == features.count || (!is_a && c->key.body_b != sheet.body)) {
            continue; /* open, or of other bodies */
        }
        vec3 point = x[c->key.feature_a];
        if (c->key.kind == VBSS_SCENE_CONTACT_SIDES) {
            const uint32_t *n = shape->edges[c->key.feature_b];
            point = vec3_lerp(x[n[0]], x[n[1]], at[1]);
        } else if (!is_a) {
            const uint32_t *n = shape->triangles[c->key.feature_b];
            point = vec3_add(vec3_scale(x[n[0]], 1.0 - at[0] - at[1]),
                             vec3_add(vec3_scale(x[n[1]], at[0]), vec3_scale(x[n[2]], at[1])));
        }
        const vec3 on_a = small_vector(s, VBSS_SCENE_VIEW_CONTACT_FORCES, k);
        const vec3 force = is_a ? on_a : vec3_neg(on_a);
        sum.force = vec3_add(sum.force, force);
        sum.torque = vec3_add(sum.torque, vec3_cross(point, force));
    }
    return sum;
}

static void expect_equal_wrenches(const small *s, double *largest)
{
    const surface_wrench got = surface_total(s, &sheet), expected = contact_total(s);
    const double force = vec3_norm(expected.force), torque = vec3_norm(expected.torque);
    *largest = fmax(*largest, force);
    expect_near(0.0, vec3_distance(got.force, expected.force), 1e-12 * force);
    /* The arm of a force is up to 30 mm, and torques of both signs cancel. */
    expect_near(0.0, vec3_distance(got.torque, expected.torque), 1e-12 * (torque + 30e-3 * force));
    const vbss_scene_rigid_state rigid = small_rigid(s, sheet.body);
    expect_near(0.0, vec3_distance(got.force, vec3_load(rigid.contact_force)), 1e-12 * force);
}

static void ride_the_wave(double friction)
{
    small s;
    double largest = 0.0;
    begin(&s);
    surface_make(&sheet, 11, 60e-3);
    sheet.config.friction = friction;
    surface_add(&s, &sheet);
    (void)add_resting_thread(&s);
    s.rigid.gravity[1] = -9.81;
    (void)small_stick(&s, VBSS_SCENE_RIGID_FREE, vec3_make(8e-3, 3e-3, 1e-3),
                      vec3_make(2e-3, 0.0, 7e-3), 1.5e-3);
    uint32_t touched = 0;
    for (int i = 1; i <= 300; i++) {
        surface_wave(&sheet, 1e-3 * i);
        surface_move(&s, &sheet);
        small_steps(&s, 1, 1e-3);
        touched += small_statistics(&s).contacts > 0;
        expect_equal_wrenches(&s, &largest);
    }
    assert_true(touched > 100 && largest > 0.1);
    small_end(&s);
}

static void forces_on_vertices_have_the_sum_and_torque_of_the_contacts(void **state)
{
    (void)state;
    ride_the_wave(0.0);
    ride_the_wave(0.4);
}

/* The surface comes down on the slit. Corners of it meet triangles of the drain: there it is feature a. */
static void forces_add_up_where_the_surface_presses_on_a_drain(void **state)
{
    (void)state;
    small s;
    double largest = 0.0;
    begin(&s);
    surface_make(&sheet, 12, 60e-3);
    surface_add(&s, &sheet);
    s.drain.position[1] =
        -(s.drain.radius + 0.5 * s.drain.thickness + 0.5 * SURFACE_THICKNESS + 0.1e-3);
    (void)small_drain(&s, NULL);
    for (int i = 1; i <= 40; i++) {
        surface_shift(&s, &sheet, vec3_make(0.01e-3 * i, -0.02e-3 * i, 0.0));
        small_steps(&s, 1, 1e-3);
        expect_equal_wrenches(&s, &largest);
    }
    assert_true(largest > 1e-3);
    small_end(&s);
}

int test_host_surface(void)
{
    const struct CMUnitTest tests[] = {
        harness_test(surface_at_rest_is_a_static_mesh_to_the_bit),
        harness_test(belt_carries_a_thread_by_coulombs_law),
        harness_test(lifted_thread_presses_with_its_weight_and_inertia),
        harness_test(forces_on_vertices_have_the_sum_and_torque_of_the_contacts),
        harness_test(forces_add_up_where_the_surface_presses_on_a_drain),
    };
    return cmocka_run_group_tests_name("scene.host_surface", tests, NULL, NULL);
}
