/* Static meshes: a thread rests on an incline, goes round a cylinder by the law of the rope, and never passes a thin sheet; a
 * saved scene has the mesh; queries find it; refused input changes nothing; a mesh that is far away costs nothing. */
#include <stdlib.h>
#include <string.h>

#include "scene/capstan_rig.h"
#include "scene/small.h"

#define THICKNESS 0.5e-3
enum { MAX_CELLS = 220, MAX_VERTICES = (MAX_CELLS + 1) * (MAX_CELLS + 1) };

/* A square sheet of two triangles a cell, about a point, with its normal along y, tilted about z. */
typedef struct sheet {
    double vertices[MAX_VERTICES][3];
    uint32_t triangles[2 * MAX_CELLS * MAX_CELLS][3];
    vbss_scene_static_mesh_config config;
} sheet;

static sheet own_sheet;

static const vbss_scene_static_mesh_config *make_sheet(uint32_t cells, double side, vec3 middle,
                                                       double tilt)
{
    uint32_t count = 0;
    for (uint32_t i = 0; i < (cells + 1) * (cells + 1); i++) {
        const uint32_t row = i / (cells + 1), column = i % (cells + 1);
        const double along = side * ((double)row / cells - 0.5);
        const double across = side * ((double)column / cells - 0.5);
        vec3_store(own_sheet.vertices[i],
                   vec3_add(middle, vec3_make(along * cos(tilt), -along * sin(tilt), across)));
    }
    for (uint32_t i = 0; i < cells * cells; i++, count += 2) {
        const uint32_t a = i / cells * (cells + 1) + i % cells, b = a + cells + 1;
        const uint32_t cell[2][3] = {{a, a + 1, b + 1}, {a, b + 1, b}};
        memcpy(own_sheet.triangles[count], cell, sizeof cell);
    }
    own_sheet.config = vbss_scene_static_mesh_config_default();
    own_sheet.config.vertex_count = (cells + 1) * (cells + 1);
    own_sheet.config.triangle_count = count;
    own_sheet.config.vertices = own_sheet.vertices[0];
    own_sheet.config.triangles = own_sheet.triangles[0];
    own_sheet.config.thickness = THICKNESS;
    return &own_sheet.config;
}

static uint32_t add_sheet(small *s, uint32_t cells, double side, vec3 middle, double tilt,
                          double friction)
{
    uint32_t body;
    vbss_scene_static_mesh_config config = *make_sheet(cells, side, middle, tilt);
    config.friction = friction;
    expect_ok(vbss_scene_add_static_mesh(s->scene, &config, &body));
    return body;
}

static const vbss_scene_static_mesh_config *make_one_sided(uint32_t cells, double tilt)
{
    (void)make_sheet(cells, 60e-3, vec3_zero(), tilt);
    own_sheet.config.one_sided = 1;
    return &own_sheet.config;
}

static void begin(small *s)
{
    small_begin(s);
    s->config.floor = 0;
    s->config.contact_capacity = 4096;
    s->config.candidate_capacity = 65536;
    s->thread.gravity[1] = -9.81;
    small_create(s);
}

/* ---- physics */

/* How far a thread across a sheet slides down it in 0.1 s, in steps of h. */
static double slide_on_incline(uint32_t cells, double friction, double h)
{
    small s;
    vbss_thread *thread;
    const double tilt = 0.3, above = 0.5 * THICKNESS + 0.125e-3;
    begin(&s);
    add_sheet(&s, cells, 60e-3, vec3_zero(), tilt, friction);
    const vec3 up = vec3_scale(vec3_make(sin(tilt), cos(tilt), 0.0), above);
    small_thread(&s, vec3_add(up, vec3_make(0.0, 0.0, -10e-3)),
                 vec3_add(up, vec3_make(0.0, 0.0, 10e-3)), 20, &thread);
    small_steps(&s, (uint32_t)(0.1 / h + 0.5), h);
    const vec3 moved = vec3_sub(small_node(thread, 10), up);
    const double slid = vec3_dot(moved, vec3_make(cos(tilt), -sin(tilt), 0.0));
    const double sunk = vec3_dot(moved, vec3_make(sin(tilt), cos(tilt), 0.0));
    expect_near(0.0, sunk, 0.02e-3);
    small_end(&s);
    return slid;
}

/* The implicit step adds h / time to the distance of a free fall. The edges of the mesh add nothing. */
static void thread_slides_down_an_incline_as_on_a_plane(void **state)
{
    (void)state;
    const double tilt = 0.3, time = 0.1, friction = 0.2;
    const double fallen = 0.5 * 9.81 * (sin(tilt) - friction * cos(tilt)) * time * time;
    const double steps[] = {0.25e-3, 1e-3, 2e-3};
    const uint32_t cells[] = {16, 64, 200}; /* the last are smaller than the contact distance */
    assert_true(fabs(slide_on_incline(16, 1.3 * tan(tilt), 1e-3)) < 0.05e-3);
    for (int i = 0; i < 3; i++) {
        for (int k = 0; k < 3; k++) {
            const double expected = fallen * (1.0 + steps[k] / time);
            expect_near(expected, slide_on_incline(cells[i], friction, steps[k]), 2e-3 * expected);
        }
    }
}

#define WIDTH 3e-3
#define ASIDE 0.13e-3 /* the thread runs along no line of the mesh */
enum { AXIAL_CELLS = 4, MAX_ROUND = 90, CYLINDER_VERTICES = (AXIAL_CELLS + 1) * MAX_ROUND };
static uint32_t round_cells;

static void add_cylinder(capstan *c)
{
    double x[CYLINDER_VERTICES][3];
    uint32_t triangles[2 * AXIAL_CELLS * MAX_ROUND][3], body, count = 0;
    for (uint32_t i = 0; i < round_cells * (AXIAL_CELLS + 1); i++) {
        const uint32_t row = i / (AXIAL_CELLS + 1);
        const double angle = 2.0 * CAPSTAN_PI * (row + 0.5) / round_cells;
        x[i][0] = -(CAPSTAN_RADIUS - 0.5 * THICKNESS) * cos(angle);
        x[i][1] = (CAPSTAN_RADIUS - 0.5 * THICKNESS) * sin(angle);
        x[i][2] = WIDTH * ((double)(i % (AXIAL_CELLS + 1)) / AXIAL_CELLS - 0.5) + ASIDE;
    }
    for (uint32_t i = 0; i < round_cells * AXIAL_CELLS; i++, count += 2) {
        const uint32_t column = i / AXIAL_CELLS, row = i % AXIAL_CELLS;
        const uint32_t a = column * (AXIAL_CELLS + 1) + row;
        const uint32_t b = (column + 1) % round_cells * (AXIAL_CELLS + 1) + row;
        const uint32_t cell[2][3] = {{a, a + 1, b + 1}, {a, b + 1, b}};
        memcpy(triangles[count], cell, sizeof cell);
    }
    vbss_scene_static_mesh_config mesh = vbss_scene_static_mesh_config_default();
    mesh.vertex_count = round_cells * (AXIAL_CELLS + 1);
    mesh.triangle_count = count;
    mesh.vertices = x[0];
    mesh.triangles = triangles[0];
    mesh.thickness = THICKNESS;
    mesh.friction = c->friction;
    expect_ok(vbss_scene_add_static_mesh(c->rig.scene, &mesh, &body));
}

static void tension_over_a_static_mesh_follows_capstan_equation(void **state)
{
    (void)state;
    const uint32_t cells[] = {18, 24, 60, MAX_ROUND};
    for (int i = 0; i < 4; i++) {
        capstan c = capstan_half_turn(0.3);
        round_cells = cells[i];
        c.fineness = 0.2;
        c.speed = i % 2 == 0 ? 2e-3 : 10e-3;
        c.add_cylinder = add_cylinder;
        const double got = capstan_pulled_over(&c);
        expect_near(1.0, got / (0.3 * c.angle), 0.01);
    }
}

/* Threads that are thrown at 20 m/s onto a sheet of 0.1 mm: no node ends below it. */
static void thrown_threads_never_pass_a_thin_sheet(void **state)
{
    (void)state;
    for (int trial = 0; trial < 12; trial++) {
        small s;
        uint32_t body;
        vbss_thread *thread;
        small_begin(&s);
        s.config.floor = 0;
        small_create(&s);
        vbss_scene_static_mesh_config config =
            *make_sheet((uint32_t)(1 + trial), 200e-3, vec3_zero(), 0.0);
        config.thickness = 0.1e-3;
        expect_ok(vbss_scene_add_static_mesh(s.scene, &config, &body));
        const double lean = 2e-3 * trial;
        small_thread(&s, vec3_make(-8e-3, 10e-3 + lean, 1e-3), vec3_make(9e-3, 10e-3, -2e-3), 20,
                     &thread);
        double velocities[21][3];
        for (int i = 0; i < 21; i++) {
            vec3_store(velocities[i], vec3_make(0.3 * trial, -20.0, 0.1 * trial));
        }
        expect_ok(vbss_thread_set_state(thread, NULL, velocities[0], 21));
        for (int step = 0; step < 30; step++) {
            small_steps(&s, 1, 1e-3);
            for (uint32_t i = 0; i < 21; i++) {
                assert_true(small_node(thread, i).y > 0.0);
            }
        }
        small_end(&s);
    }
}

/* A free body comes to rest on the sheet, which bears its weight. */
static void sheet_bears_a_free_body(void **state)
{
    (void)state;
    small s;
    begin(&s);
    const uint32_t mesh = add_sheet(&s, 8, 60e-3, vec3_zero(), 0.0, 0.5);
    s.rigid.gravity[1] = -9.81;
    const uint32_t stick = small_stick(&s, VBSS_SCENE_RIGID_FREE, vec3_make(1e-3, 2.3e-3, 0.5e-3),
                                       vec3_make(8e-3, 0.0, 0.0), 2e-3);
    small_steps(&s, 300, 1e-3);
    expect_near(2e-3 + 0.5 * THICKNESS, small_position(&s, stick).y, 0.02e-3);
    expect_near(-9.81 * 0.02, small_rigid(&s, mesh).contact_force[1], 0.01 * 9.81 * 0.02);
    small_end(&s);
}

/* ---- one side */

/* The middle of a thread that moves vertically for 20 ms at 2 m/s, across a sheet of one side or without it. */
static vec3 fly_across(double y, double speed, bool with_sheet, double *force)
{
    small s;
    vbss_thread *thread;
    uint32_t mesh = 0;
    small_begin(&s);
    s.config.floor = 0;
    small_create(&s);
    if (with_sheet) {
        expect_ok(vbss_scene_add_static_mesh(s.scene, make_one_sided(16, 0.0), &mesh));
    }
    small_thread(&s, vec3_make(-8e-3, y, 1e-3), vec3_make(9e-3, 1.1 * y, -2e-3), 20, &thread);
    double velocities[21][3];
    for (int i = 0; i < 21; i++) {
        vec3_store(velocities[i], vec3_make(0.0, speed, 0.0));
    }
    expect_ok(vbss_thread_set_state(thread, NULL, velocities[0], 21));
    *force = 0.0;
    for (int i = 0; i < 20; i++) {
        small_steps(&s, 1, 1e-3);
        *force = fmax(*force, with_sheet ? fabs(small_rigid(&s, mesh).contact_force[1]) : 0.0);
    }
    const vec3 x = small_node(thread, 10);
    small_end(&s);
    return x;
}

static void one_sided_sheet_stops_what_comes_from_the_front(void **state)
{
    (void)state;
    double force;
    assert_true(fly_across(11e-3, -2.0, true, &force).y > 0.0);
    assert_true(force > 0.0);
}

/* It is pushed only from when it is in front, but nearer than the contact distance. */
static void one_sided_sheet_lets_through_what_comes_from_behind(void **state)
{
    (void)state;
    double force, none;
    const vec3 across = fly_across(-11e-3, 2.0, true, &force),
               alone = fly_across(-11e-3, 2.0, false, &none);
    assert_true(across.y > 20e-3 && vec3_distance(across, alone) < 2e-3);
    const vec3 behind = fly_across(-0.2e-3, 0.0, true, &force);
    expect_near(0.0, vec3_distance(behind, fly_across(-0.2e-3, 0.0, false, &none)), 0.0);
    expect_near(0.0, force, 0.0);
}

static void one_sided_mesh_must_be_wound_alike(void **state)
{
    (void)state;
    small s;
    uint32_t body;
    begin(&s);
    vbss_scene_static_mesh_config config = *make_sheet(3, 60e-3, vec3_zero(), 0.0);
    const uint32_t first = own_sheet.triangles[4][0];
    own_sheet.triangles[4][0] = own_sheet.triangles[4][1];
    own_sheet.triangles[4][1] = first;
    config.one_sided = 2;
    assert_int_equal(vbss_scene_add_static_mesh(s.scene, &config, &body), VBSS_ERROR_OUT_OF_RANGE);
    config.one_sided = 1;
    assert_int_equal(vbss_scene_add_static_mesh(s.scene, &config, &body), VBSS_ERROR_OUT_OF_RANGE);
    config.one_sided = 0;
    expect_ok(vbss_scene_add_static_mesh(s.scene, &config, &body));
    small_end(&s);
}

/* ---- cost */

static vbss_scene_statistics falling_statistics(uint32_t cells, vec3 middle, uint64_t *tested)
{
    small s;
    begin(&s);
    s.config.floor = 0;
    if (cells > 0) {
        add_sheet(&s, cells, 60e-3, middle, 0.0, 0.1);
    }
    small_thread(&s, vec3_make(0.0, 20e-3, -10e-3), vec3_make(0.0, 20e-3, 10e-3), 20, NULL);
    small_steps(&s, 20, 1e-3);
    *tested = small_object(&s)->collision->boxes_tested;
    const vbss_scene_statistics statistics = small_statistics(&s);
    small_end(&s);
    return statistics;
}

/* One test of the whole mesh's box a search, whatever the number of triangles. */
static void far_mesh_adds_no_pairs_and_one_box_test(void **state)
{
    (void)state;
    uint64_t alone, beside_one, beside;
    const vbss_scene_statistics a = falling_statistics(0, vec3_zero(), &alone);
    (void)falling_statistics(1, vec3_make(0.5, 0.0, 0.0), &beside_one);
    const vbss_scene_statistics b =
        falling_statistics(MAX_CELLS, vec3_make(0.5, 0.0, 0.0), &beside);
    assert_int_equal(a.guard_pairs, b.guard_pairs);
    assert_int_equal(beside_one, beside);
    assert_true(beside < alone + 100);
}

/* ---- what a host may ask */

static void queries_find_a_static_mesh(void **state)
{
    (void)state;
    small s;
    vbss_scene_body_info info;
    vbss_scene_ray_hit hit;
    vbss_scene_nearest found;
    begin(&s);
    const uint32_t mesh = add_sheet(&s, 4, 60e-3, vec3_zero(), 0.0, 0.25);
    const double from[3] = {2e-3, 10e-3, 1e-3}, down[3] = {0.0, -20e-3, 0.0};
    expect_ok(vbss_scene_get_body(s.scene, mesh, &info, sizeof info));
    assert_int_equal(info.kind, VBSS_SCENE_BODY_STATIC_MESH);
    expect_near(0.25, info.friction, 0.0);
    expect_ok(vbss_scene_cast_ray(s.scene, from, down, UINT32_MAX, &hit, sizeof hit));
    assert_true(hit.is_hit == 1 && hit.body == mesh);
    expect_near(0.5 * THICKNESS, hit.point[1], 1e-12);
    expect_ok(vbss_scene_find_nearest(s.scene, from, 1.0, UINT32_MAX, &found, sizeof found));
    assert_true(found.is_found == 1 && found.body == mesh);
    expect_near(10e-3 - 0.5 * THICKNESS, found.distance, 1e-12);
    small_end(&s);
}

/* A filter lets a thread fall through. */
static void filtered_mesh_touches_nothing(void **state)
{
    (void)state;
    small s;
    vbss_thread *thread;
    begin(&s);
    const uint32_t mesh = add_sheet(&s, 4, 60e-3, vec3_zero(), 0.0, 0.25);
    expect_ok(vbss_scene_set_filter(s.scene, mesh, 2, 2));
    small_thread(&s, vec3_make(0.0, 1e-3, -10e-3), vec3_make(0.0, 1e-3, 10e-3), 20, &thread);
    small_steps(&s, 100, 1e-3);
    assert_true(small_node(thread, 10).y < -20e-3);
    small_end(&s);
}

static void loaded_scene_has_the_mesh_and_goes_on_to_the_same_bits(void **state)
{
    (void)state;
    small s;
    harness_memory memory;
    vbss_scene *loaded = NULL;
    begin(&s);
    uint32_t second;
    add_sheet(&s, 12, 60e-3, vec3_zero(), 0.2, 0.2);
    expect_ok(vbss_scene_add_static_mesh(s.scene, make_one_sided(9, -0.2), &second));
    small_thread(&s, vec3_make(-5e-3, 8e-3, -10e-3), vec3_make(3e-3, 4e-3, 10e-3), 20, NULL);
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
    /* another mesh is another scene */
    small other;
    begin(&other);
    add_sheet(&other, 12, 60e-3, vec3_zero(), 0.21, 0.2);
    expect_ok(vbss_scene_add_static_mesh(other.scene, make_one_sided(9, -0.2), &second));
    small_thread(&other, vec3_make(-5e-3, 8e-3, -10e-3), vec3_make(3e-3, 4e-3, 10e-3), 20, NULL);
    assert_int_not_equal(vbss_scene_restore(other.scene, saved.bytes, saved.count), VBSS_OK);
    small_end(&other);
    free(saved.bytes);
    expect_ok(vbss_scene_destroy(loaded));
    harness_context_end(context, &memory);
    small_end(&s);
}

static void refused_meshes_change_nothing(void **state)
{
    (void)state;
    small s;
    uint32_t body = 77;
    begin(&s);
    const uint64_t hash = small_hash(&s);
    const vbss_scene_static_mesh_config good = *make_sheet(3, 60e-3, vec3_zero(), 0.0);
    vbss_scene_static_mesh_config bad = good;
    bad.vertex_count = 2;
    assert_int_equal(vbss_scene_add_static_mesh(s.scene, &bad, &body), VBSS_ERROR_OUT_OF_RANGE);
    bad = good;
    bad.vertices = NULL;
    assert_int_equal(vbss_scene_add_static_mesh(s.scene, &bad, &body), VBSS_ERROR_NULL_ARGUMENT);
    bad = good;
    bad.thickness = 0.0;
    assert_int_equal(vbss_scene_add_static_mesh(s.scene, &bad, &body), VBSS_ERROR_OUT_OF_RANGE);
    bad = good;
    bad.friction = (double)NAN;
    assert_int_equal(vbss_scene_add_static_mesh(s.scene, &bad, &body), VBSS_ERROR_NOT_FINITE);
    own_sheet.triangles[5][1] = good.vertex_count;
    assert_int_equal(vbss_scene_add_static_mesh(s.scene, &good, &body), VBSS_ERROR_OUT_OF_RANGE);
    own_sheet.triangles[5][1] = own_sheet.triangles[5][0];
    assert_int_equal(vbss_scene_add_static_mesh(s.scene, &good, &body), VBSS_ERROR_OUT_OF_RANGE);
    (void)make_sheet(3, 60e-3, vec3_zero(), 0.0);
    own_sheet.vertices[4][2] = (double)INFINITY;
    assert_int_equal(vbss_scene_add_static_mesh(s.scene, &good, &body), VBSS_ERROR_NOT_FINITE);
    assert_true(small_hash(&s) == hash && body == 77);
    const uint32_t mesh = add_sheet(&s, 3, 60e-3, vec3_zero(), 0.0, 0.1);
    const double place[3] = {0.0, 0.0, 0.0};
    assert_int_equal(vbss_scene_set_rigid_target(s.scene, mesh, place, NULL),
                     VBSS_ERROR_INCOMPATIBLE);
    expect_ok(vbss_scene_remove(s.scene, mesh));
    small_end(&s);
}

int test_static_mesh(void)
{
    const struct CMUnitTest tests[] = {
        harness_test(thread_slides_down_an_incline_as_on_a_plane),
        harness_test(tension_over_a_static_mesh_follows_capstan_equation),
        harness_test(thrown_threads_never_pass_a_thin_sheet),
        harness_test(sheet_bears_a_free_body),
        harness_test(one_sided_sheet_stops_what_comes_from_the_front),
        harness_test(one_sided_sheet_lets_through_what_comes_from_behind),
        harness_test(one_sided_mesh_must_be_wound_alike),
        harness_test(far_mesh_adds_no_pairs_and_one_box_test),
        harness_test(queries_find_a_static_mesh),
        harness_test(filtered_mesh_touches_nothing),
        harness_test(loaded_scene_has_the_mesh_and_goes_on_to_the_same_bits),
        harness_test(refused_meshes_change_nothing),
    };
    return cmocka_run_group_tests_name("scene.static_mesh", tests, NULL, NULL);
}
