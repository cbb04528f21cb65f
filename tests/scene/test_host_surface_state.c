/* Host surfaces: refused input changes nothing; a saved, loaded or restored scene goes on to the same bits; queries find the
 * surface where it is. */
#include <stdlib.h>

#include <vblast_ss/scene_query.h>

#include "fixtures/solver_of.h"
#include "scene/surface_rig.h"

static surface_sheet sheet;

static void begin(small *s)
{
    s->config.floor = 0;
    s->config.contact_capacity = 4096;
    s->config.candidate_capacity = 65536;
    s->thread.gravity[1] = -9.81;
    small_create(s);
    surface_make(&sheet, 8, 60e-3);
    sheet.config.friction = 0.3;
    surface_add(s, &sheet);
    small_thread(s, vec3_make(-5e-3, 2e-3, -10e-3), vec3_make(4e-3, 3e-3, 10e-3), 20, NULL);
}

static void wave_step(small *s, int step)
{
    surface_wave(&sheet, 1e-3 * step);
    surface_move(s, &sheet);
    small_steps(s, 1, 1e-3);
}

/* ---- refusals */

static void refused_surfaces_change_nothing(void **state)
{
    (void)state;
    small s;
    uint32_t body = 77;
    small_begin_scene(&s);
    const uint64_t hash = small_hash(&s);
    surface_make(&sheet, 3, 60e-3);
    vbss_scene_surface_config bad = sheet.config;
    bad.jump_limit = 0.0;
    expect_result(VBSS_ERROR_OUT_OF_RANGE, vbss_scene_add_surface(s.scene, &bad, &body));
    bad = sheet.config;
    bad.vertices = NULL;
    expect_result(VBSS_ERROR_NULL_ARGUMENT, vbss_scene_add_surface(s.scene, &bad, &body));
    bad = sheet.config;
    bad.one_sided = 1;
    expect_result(VBSS_ERROR_OUT_OF_RANGE, vbss_scene_add_surface(s.scene, &bad, &body));
    bad = sheet.config;
    bad.thickness = (double)NAN;
    expect_result(VBSS_ERROR_NOT_FINITE, vbss_scene_add_surface(s.scene, &bad, &body));
    expect_result(VBSS_ERROR_NULL_ARGUMENT, vbss_scene_add_surface(s.scene, &sheet.config, NULL));
    memcpy(sheet.x[5], sheet.x[4], sizeof sheet.x[5]); /* a triangle without area */
    expect_result(VBSS_ERROR_OUT_OF_RANGE, vbss_scene_add_surface(s.scene, &sheet.config, &body));
    assert_true(small_hash(&s) == hash && body == 77);
    small_end(&s);
}

/* Adds a host surface, or a static mesh if `user` is set, to a scene of its own. */
static vbss_result add_to_new_scene(vbss_context *context, void *user)
{
    vbss_scene *scene = NULL;
    uint32_t body = 0;
    vbss_scene_static_mesh_config mesh = vbss_scene_static_mesh_config_default();
    mesh.vertex_count = sheet.config.vertex_count;
    mesh.triangle_count = sheet.config.triangle_count;
    mesh.vertices = sheet.config.vertices;
    mesh.triangles = sheet.config.triangles;
    const vbss_scene_config config = vbss_scene_config_default();
    const vbss_result created = vbss_scene_create(context, &config, &scene);
    if (created != VBSS_OK) {
        return created;
    }
    const vbss_result result = user != NULL ? vbss_scene_add_static_mesh(scene, &mesh, &body)
                                            : vbss_scene_add_surface(scene, &sheet.config, &body);
    expect_ok(vbss_scene_destroy(scene));
    return result;
}

static void surface_without_memory_leaves_no_block(void **state)
{
    (void)state;
    surface_make(&sheet, 3, 60e-3);
    sheet.config.compliance_size = 9;
    harness_fail_every_allocation(add_to_new_scene, NULL);
    harness_fail_every_allocation(add_to_new_scene, &sheet);
}

static void expect_refused_move(small *s, vbss_result wanted, const double *x, uint32_t count)
{
    const uint64_t hash = small_hash(s);
    expect_result(wanted, vbss_scene_move_surface(s->scene, sheet.body, x, count));
    assert_true(small_hash(s) == hash);
}

static void refused_moves_change_nothing(void **state)
{
    (void)state;
    small s;
    small_begin(&s);
    begin(&s);
    wave_step(&s, 1);
    const uint32_t count = sheet.config.vertex_count;
    surface_wave(&sheet, 2e-3);
    static double good[SURFACE_MAX_VERTICES][3];
    memcpy(good, sheet.x, sizeof good);
    expect_refused_move(&s, VBSS_ERROR_NULL_ARGUMENT, NULL, count);
    expect_refused_move(&s, VBSS_ERROR_OUT_OF_RANGE, good[0], count - 1);
    expect_refused_move(&s, VBSS_ERROR_OUT_OF_RANGE, good[0], count + 1);
    sheet.x[7][2] = (double)NAN;
    expect_refused_move(&s, VBSS_ERROR_NOT_FINITE, sheet.x[0], count);
    memcpy(sheet.x, good, sizeof good);
    sheet.x[7][1] += 1.01 * sheet.config.jump_limit;
    expect_refused_move(&s, VBSS_ERROR_OUT_OF_RANGE, sheet.x[0], count);
    memcpy(sheet.x, good, sizeof good);
    sheet.x[20][0] += 9e-3; /* beyond its neighbour, 7.5 mm away: inverted triangles */
    expect_refused_move(&s, VBSS_ERROR_OUT_OF_RANGE, sheet.x[0], count);
    memcpy(sheet.x, good, sizeof good);
    surface_move(&s, &sheet);
    small_end(&s);
}

static void only_a_host_surface_moves_so(void **state)
{
    (void)state;
    small s;
    small_begin(&s);
    begin(&s);
    const double place[3] = {0.0, 0.0, 0.0};
    uint32_t pin;
    vbss_view view;
    const uint32_t count = sheet.config.vertex_count, thread = sheet.body + 1;
    expect_result(VBSS_ERROR_INCOMPATIBLE,
                  vbss_scene_move_surface(s.scene, thread, sheet.x[0], count));
    expect_result(VBSS_ERROR_NOT_FOUND, vbss_scene_move_surface(s.scene, 99, sheet.x[0], count));
    expect_result(VBSS_ERROR_INCOMPATIBLE,
                  vbss_scene_get_surface_view(s.scene, thread, VBSS_SCENE_SURFACE_VIEW_FORCES,
                                              &view, sizeof view));
    expect_result(VBSS_ERROR_OUT_OF_RANGE,
                  vbss_scene_get_surface_view(s.scene, sheet.body, 99, &view, sizeof view));
    expect_result(VBSS_ERROR_INCOMPATIBLE,
                  vbss_scene_set_rigid_target(s.scene, sheet.body, place, NULL));
    expect_result(VBSS_ERROR_INCOMPATIBLE,
                  vbss_scene_pin_thread(s.scene, thread, 0, sheet.body, NULL, &pin));
    expect_ok(vbss_scene_remove(s.scene, sheet.body));
    small_end(&s);
}

/* ---- state */

static void saved_surface_goes_on_to_the_same_bits(void **state)
{
    (void)state;
    small s;
    harness_memory memory;
    vbss_scene *loaded = NULL;
    small_begin(&s);
    begin(&s);
    for (int i = 1; i <= 40; i++) {
        wave_step(&s, i);
    }
    surface_wave(&sheet, 41e-3);
    surface_move(&s, &sheet); /* the saved state has an input that no step has used */
    const small_state saved = small_save(&s);
    vbss_context *context = harness_context(&memory);
    expect_ok(vbss_scene_load(context, saved.bytes, saved.count, &loaded));
    for (int i = 41; i <= 80; i++) {
        uint64_t hash = 0;
        expect_ok(vbss_scene_get_hash(loaded, &hash));
        assert_true(hash == small_hash(&s));
        small_steps(&s, 1, 1e-3);
        expect_ok(vbss_scene_step(loaded, 1e-3));
        surface_wave(&sheet, 1e-3 * (i + 1));
        surface_move(&s, &sheet);
        expect_ok(
            vbss_scene_move_surface(loaded, sheet.body, sheet.x[0], sheet.config.vertex_count));
    }
    const uint64_t hash = small_hash(&s);
    expect_ok(vbss_scene_restore(s.scene, saved.bytes, saved.count));
    for (int i = 41; i <= 80; i++) {
        small_steps(&s, 1, 1e-3);
        surface_wave(&sheet, 1e-3 * (i + 1));
        surface_move(&s, &sheet);
    }
    assert_true(small_hash(&s) == hash);
    free(saved.bytes);
    expect_ok(vbss_scene_destroy(loaded));
    harness_context_end(context, &memory);
    small_end(&s);
}

static void surface_of_other_triangles_is_not_restored(void **state)
{
    (void)state;
    small s, other;
    small_begin(&s);
    begin(&s);
    const small_state saved = small_save(&s);
    small_begin(&other);
    other.config.floor = 0;
    other.config.contact_capacity = 4096;
    other.config.candidate_capacity = 65536;
    small_create(&other);
    surface_make(&sheet, 8, 60e-3);
    const uint32_t swapped[3] = {sheet.triangles[3][1], sheet.triangles[3][2],
                                 sheet.triangles[3][0]};
    memcpy(sheet.triangles[3], swapped, sizeof swapped);
    sheet.config.friction = 0.3;
    surface_add(&other, &sheet);
    small_thread(&other, vec3_make(-5e-3, 2e-3, -10e-3), vec3_make(4e-3, 3e-3, 10e-3), 20, NULL);
    assert_int_not_equal(vbss_scene_restore(other.scene, saved.bytes, saved.count), VBSS_OK);
    free(saved.bytes);
    small_end(&other);
    small_end(&s);
}

/* Hashes of 120 calls whose budget suspends steps; with `restores`, each call begins from a snapshot. */
static uint32_t run_suspended(bool restores, uint64_t hashes[120])
{
    small s;
    uint32_t suspended = 0;
    small_begin(&s);
    set_call_operations(&s.config, 3000);
    begin(&s);
    for (int i = 0; i < 120; i++) {
        wave_step(&s, i + 1);
        suspended += small_statistics(&s).behind > 0;
        if (restores) {
            const small_state saved = small_save(&s);
            expect_ok(vbss_scene_restore(s.scene, saved.bytes, saved.count));
            free(saved.bytes);
        }
        hashes[i] = small_hash(&s);
    }
    small_end(&s);
    return suspended;
}

static void suspended_steps_keep_their_surface(void **state)
{
    (void)state;
    static uint64_t one[120], other[120];
    assert_true(run_suspended(false, one) > 10);
    (void)run_suspended(true, other);
    assert_memory_equal(one, other, sizeof one);
}

/* A driven tool at rest and the surface that comes down on it both follow the host, so the guard stops the surface. The host
 * then has the forces of the last complete step; a thread on the surface makes them. */
static void truncated_step_keeps_the_forces_of_the_step_before(void **state)
{
    (void)state;
    static vec3 before[SURFACE_MAX_VERTICES];
    small s;
    small_begin(&s);
    begin(&s);
    (void)small_stick(&s, VBSS_SCENE_RIGID_DRIVEN, vec3_make(15e-3, -2.5e-3, 15e-3), vec3_zero(),
                      2e-3);
    bool is_behind = false, was_same = true;
    for (int i = 1; i <= 80 && !is_behind; i++) {
        const size_t size = sheet.config.vertex_count * sizeof *before;
        memcpy(before, surface_view(&s, &sheet, VBSS_SCENE_SURFACE_VIEW_FORCES), size);
        surface_shift(&s, &sheet, vec3_make(0.0, -0.05e-3 * i, 0.0));
        small_steps(&s, 1, 1e-3);
        const vec3 *now = surface_view(&s, &sheet, VBSS_SCENE_SURFACE_VIEW_POSITIONS),
                   *wanted = surface_view(&s, &sheet, VBSS_SCENE_SURFACE_VIEW_TARGETS),
                   *forces = surface_view(&s, &sheet, VBSS_SCENE_SURFACE_VIEW_FORCES);
        is_behind = vec3_distance(now[0], wanted[0]) > 0.0;
        const bool is_same = memcmp(before, forces, size) == 0;
        assert_true(is_same || !is_behind);
        was_same = is_behind ? was_same : is_same;
    }
    assert_false(was_same); /* the thread presses, and complete steps have other forces */
    assert_true(is_behind);
    small_end(&s);
}

/* ---- queries */

static void queries_find_the_surface_where_it_is(void **state)
{
    (void)state;
    small s;
    vbss_scene_body_info info;
    vbss_scene_nearest found;
    small_begin(&s);
    begin(&s);
    surface_shift(&s, &sheet, vec3_make(0.0, -4e-3, 0.0));
    small_steps(&s, 1, 1e-3);
    expect_near(-4e-3, surface_view(&s, &sheet, VBSS_SCENE_SURFACE_VIEW_POSITIONS)[3].y, 0.0);
    expect_near(-4e-3, surface_view(&s, &sheet, VBSS_SCENE_SURFACE_VIEW_TARGETS)[3].y, 0.0);
    expect_ok(vbss_scene_get_body(s.scene, sheet.body, &info, sizeof info));
    assert_int_equal(info.kind, VBSS_SCENE_BODY_SURFACE);
    const double from[3] = {20e-3, -10e-3, 1e-3};
    expect_ok(vbss_scene_find_nearest(s.scene, from, 1.0, UINT32_MAX, &found, sizeof found));
    assert_true(found.is_found == 1 && found.body == sheet.body);
    expect_near(6e-3 - 0.5 * SURFACE_THICKNESS, found.distance, 1e-12);
    small_end(&s);
}

int test_host_surface_state(void)
{
    const struct CMUnitTest tests[] = {
        harness_test(refused_surfaces_change_nothing),
        harness_test(surface_without_memory_leaves_no_block),
        harness_test(refused_moves_change_nothing),
        harness_test(only_a_host_surface_moves_so),
        harness_test(saved_surface_goes_on_to_the_same_bits),
        harness_test(surface_of_other_triangles_is_not_restored),
        harness_test(suspended_steps_keep_their_surface),
        harness_test(truncated_step_keeps_the_forces_of_the_step_before),
        harness_test(queries_find_the_surface_where_it_is),
    };
    return cmocka_run_group_tests_name("scene.host_surface_state", tests, NULL, NULL);
}
