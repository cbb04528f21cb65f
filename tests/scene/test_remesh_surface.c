/* A host surface gets another mesh: its holes stay where they are and keep their forces, contacts go on, and a call that is
 * refused or finds no memory changes nothing. */
#include <stdlib.h>

#include <vblast_ss/scene_surface.h>

#include "fixtures/pad.h"
#include "scene/small.h"

#define H 1e-3
#define SIDE 30e-3
#define LENGTH 20e-3 /* of the thread */
#define STIFFNESS 1e4
enum { CELLS = 12, SEGMENTS = 40 };

typedef struct mesh {
    pad p;
    uint32_t cells;
} mesh;

static mesh before, after;

typedef struct stitched {
    small s;
    vbss_thread *thread;
    uint32_t wall, suture, hole;
} stitched;

/* A square that is bent about z: a cylinder of radius 1 / curvature. */
static void make_mesh(mesh *m, uint32_t cells, double curvature)
{
    pad_make(&m->p, cells, cells, SIDE, SIDE);
    m->cells = cells;
    for (uint32_t i = 0; i < m->p.surface.node_count; i++) {
        double *x = m->p.positions[i];
        x[1] = -0.5 * curvature * x[0] * x[0];
    }
}

/* Other numbers for vertices and triangles; triangles wound in the opposite sense. */
static void renumber(mesh *m)
{
    static double x[PAD_NODES][3];
    static uint32_t triangles[PAD_TRIANGLES][3];
    const uint32_t n = m->p.surface.node_count, t = m->p.surface.triangle_count;
    memcpy(x, m->p.positions, sizeof x);
    memcpy(triangles, m->p.triangles, sizeof triangles);
    for (uint32_t i = 0; i < n; i++) {
        memcpy(m->p.positions[n - 1 - i], x[i], sizeof x[i]);
    }
    for (uint32_t i = 0; i < t; i++) {
        for (uint32_t k = 0; k < 3; k++) {
            m->p.triangles[t - 1 - i][2 - k] = n - 1 - triangles[i][k];
        }
    }
}

static vbss_result remesh_with(stitched *c, const mesh *m, vbss_scene_place_hole_fn place,
                               void *user)
{
    return vbss_scene_remesh_surface(c->s.scene, c->wall, m->p.positions[0],
                                     m->p.surface.node_count, m->p.triangles[0],
                                     m->p.surface.triangle_count, place, user);
}

static vec3 point_of(const mesh *m, uint32_t triangle, const double weights[3])
{
    vec3 at = vec3_zero();
    for (int k = 0; k < 3; k++) {
        at =
            vec3_add_scaled(at, weights[k], vec3_load(m->p.positions[m->p.triangles[triangle][k]]));
    }
    return at;
}

/* A thread that is bent in a hole of the surface `before`, and slides or sticks there. */
static void begin(stitched *c, uint32_t compliance_size)
{
    static const double weights[3] = {0.2, 0.3, 0.5};
    const uint32_t triangle = before.cells * before.cells;
    small_begin(&c->s);
    c->s.config.mode = VBSS_SCENE_MODE_OFFLINE;
    c->s.config.floor = 0;
    c->s.config.contact_capacity = 1024;
    c->s.config.candidate_capacity = 65536;
    small_create(&c->s);
    vbss_scene_surface_config config = vbss_scene_surface_config_default();
    config.vertex_count = before.p.surface.node_count;
    config.triangle_count = before.p.surface.triangle_count;
    config.vertices = before.p.positions[0];
    config.triangles = before.p.triangles[0];
    config.thickness = 1e-3;
    config.friction = 0.2;
    config.thread_force = 0.025;
    config.hole_stiffness = STIFFNESS;
    config.compliance_size = compliance_size;
    expect_ok(vbss_scene_add_surface(c->s.scene, &config, &c->wall));
    const vec3 hole = point_of(&before, triangle, weights),
               half = vec3_make(0.0, 0.5 * LENGTH, 0.0);
    c->suture =
        small_thread(&c->s, vec3_add(hole, half), vec3_sub(hole, half), SEGMENTS, &c->thread);
    expect_ok(vbss_scene_make_hole(c->s.scene, c->suture, 0.5 * LENGTH, c->wall, triangle, weights,
                                   &c->hole));
    small_draw(c->thread, 0, vec3_make(0.06, 0.08, 0.0));
    small_draw(c->thread, SEGMENTS, vec3_make(0.03, -0.08, 0.01));
}

static vbss_scene_hole hole_of(const stitched *c)
{
    vbss_scene_hole hole;
    expect_ok(vbss_scene_get_hole(c->s.scene, 0, &hole, sizeof hole));
    return hole;
}

static double force_apart(const vbss_scene_hole *a, const vbss_scene_hole *b)
{
    return vec3_distance(vec3_load(a->force), vec3_load(b->force));
}

/* ---- forces */

/* Compares the stitch with one whose surface keeps its mesh: in each step the forces differ by hole_stiffness times the
 * distance that the hole has moved at most, and at the end by `end`, N. Returns the distance, m. */
static double compare_forces(double end)
{
    stitched same, other;
    begin(&same, 0);
    begin(&other, 0);
    small_steps(&same.s, 80, H);
    small_steps(&other.s, 80, H);
    const vbss_scene_hole earlier = hole_of(&other);
    expect_ok(remesh_with(&other, &after, NULL, NULL));
    const vbss_scene_hole moved = hole_of(&other);
    const double distance = vec3_distance(vec3_load(earlier.position), vec3_load(moved.position));
    assert_int_equal(moved.id, earlier.id);
    assert_int_equal(moved.thread, earlier.thread);
    assert_true(earlier.friction == moved.friction);
    for (int i = 0; i < 80; i++) {
        small_steps(&same.s, 1, H);
        small_steps(&other.s, 1, H);
        const vbss_scene_hole a = hole_of(&same), b = hole_of(&other);
        assert_true(vec3_norm(vec3_load(a.force)) > 0.03);
        assert_true(force_apart(&a, &b) <= 1e-9 + STIFFNESS * distance);
    }
    const vbss_scene_hole a = hole_of(&same), b = hole_of(&other);
    assert_true(force_apart(&a, &b) <= end);
    small_end(&same.s);
    small_end(&other.s);
    return distance;
}

/* On a flat surface the place is exact, and forces differ by 1e-9 N at most. */
static void stitch_keeps_its_force_on_another_mesh(void **state)
{
    (void)state;
    const uint32_t cells[] = {24, 5, 12};
    make_mesh(&before, CELLS, 0.0);
    for (int i = 0; i < 3; i++) {
        make_mesh(&after, cells[i], 0.0);
        if (i == 2) {
            renumber(&after);
        }
        assert_true(compare_forces(1e-9) < 1e-12);
    }
}

/* On a curved one the nearest place is a little beside the old one. */
static void stitch_in_a_curved_surface_is_held_by_its_stiffness(void **state)
{
    (void)state;
    make_mesh(&before, CELLS, 8.0);
    make_mesh(&after, 24, 8.0);
    const double finer = compare_forces(1e-4);
    make_mesh(&after, 7, 8.0);
    const double coarser = compare_forces(1e-4);
    assert_true(finer > 1e-7 && finer < 20e-6 && coarser > 1e-7 && coarser < 40e-6);
}

/* A thread lies across the surface, and still touches it where it did. */
static void contacts_go_on_after_a_remesh(void **state)
{
    (void)state;
    stitched c;
    vbss_thread *thread;
    make_mesh(&before, CELLS, 0.0);
    make_mesh(&after, 17, 0.0);
    begin(&c, 0);
    c.s.thread.gravity[1] = -9.81;
    c.s.thread.damping = 20.0;
    const uint32_t body = small_thread(&c.s, vec3_make(-6e-3, 0.9e-3, 8e-3),
                                       vec3_make(7e-3, 0.9e-3, 7e-3), 25, &thread);
    small_steps(&c.s, 300, H);
    const vec3 rested = small_node(thread, 12);
    expect_ok(remesh_with(&c, &after, NULL, NULL));
    const contact_set *set = small_object(&c.s)->contacts;
    for (uint32_t i = 0; i < set->warm_start_count; i++) { /* features of the old mesh */
        const contact_key *key = &set->warm_start[i].key;
        assert_true(key->body_b != c.wall || key->kind == VBSS_SCENE_CONTACT_HOLE);
    }
    uint32_t parted = 0;
    for (int i = 0; i < 100; i++) {
        vbss_scene_event event;
        small_steps(&c.s, 1, H);
        if (small_events(&c.s, VBSS_SCENE_EVENT_PART, &event) > 0) {
            parted += event.body_a == body || event.body_b == body;
        }
        assert_true(fabs(small_node(thread, 12).y - rested.y) < 0.01e-3);
    }
    assert_int_equal(parted, 0);
    small_end(&c.s);
}

/* ---- places that the host states */

typedef struct answer {
    vbss_scene_hole_place asked;
    uint32_t calls, triangle;
    double weights[3];
    vbss_result result;
    bool leaves; /* triangle and weights as the call passed them */
    vbss_scene *scene;
    vbss_result inside; /* of a call that changes the scene */
} answer;

static vbss_result answer_with(void *user, const vbss_scene_hole_place *hole, uint32_t *triangle,
                               double *weights)
{
    answer *a = user;
    a->asked = *hole;
    a->calls++;
    a->inside = a->scene != NULL ? vbss_scene_step(a->scene, H) : VBSS_OK;
    if (!a->leaves) {
        *triangle = a->triangle;
        memcpy(weights, a->weights, sizeof a->weights);
    }
    return a->result;
}

static void host_states_the_place_of_a_hole(void **state)
{
    (void)state;
    stitched c;
    make_mesh(&before, CELLS, 0.0);
    make_mesh(&after, CELLS, 0.0);
    renumber(&after);
    begin(&c, 0);
    small_steps(&c.s, 20, H);
    const vbss_scene_hole earlier = hole_of(&c);
    const uint32_t triangle = 2 * CELLS * CELLS - 1 - earlier.triangle;
    answer a = {.triangle = triangle, .weights = {0.5, 0.31, 0.19}, .scene = c.s.scene};
    expect_ok(remesh_with(&c, &after, answer_with, &a));
    assert_int_equal(a.calls, 1);
    assert_int_equal(a.inside, VBSS_ERROR_BUSY);
    assert_int_equal(a.asked.hole, c.hole);
    assert_int_equal(a.asked.triangle, earlier.triangle);
    assert_memory_equal(a.asked.weights, earlier.weights, sizeof earlier.weights);
    assert_memory_equal(a.asked.position, earlier.position, sizeof earlier.position);
    expect_near_vec3(vec3_make(0.0, 1.0, 0.0), vec3_load(a.asked.normal), 1e-12);
    const vbss_scene_hole moved = hole_of(&c);
    assert_int_equal(moved.triangle, triangle);
    assert_memory_equal(moved.weights, a.weights, sizeof a.weights);
    expect_near_vec3(point_of(&after, triangle, a.weights), vec3_load(moved.position), 1e-15);
    assert_int_equal(moved.outward,
                     !earlier.outward); /* the triangles are wound in the opposite sense */
    small_steps(&c.s, 20, H);
    small_end(&c.s);
}

/* ---- refusals */

static void expect_refused(stitched *c, vbss_result wanted, const mesh *m, answer *a)
{
    const uint64_t hash = small_hash(&c->s);
    expect_result(wanted, remesh_with(c, m, a != NULL ? answer_with : NULL, a));
    assert_true(small_hash(&c->s) == hash);
}

static void refused_remesh_changes_nothing(void **state)
{
    (void)state;
    stitched c, same;
    make_mesh(&before, CELLS, 0.0);
    begin(&c, 0);
    begin(&same, 0);
    small_steps(&c.s, 30, H);
    small_steps(&same.s, 30, H);
    make_mesh(&after, 15, 0.0);
    answer answers[] = {
        {.triangle = 2 * 15 * 15, .weights = {1.0, 0.0, 0.0}},
        {.triangle = 100, .weights = {0.5, 0.6, 0.0}},
        {.triangle = 100, .weights = {1.5, -0.5, 0.0}},
        {.triangle = 100, .weights = {1.0, 0.0, 0.0}}, /* far from the hole */
    };
    for (size_t i = 0; i < sizeof answers / sizeof answers[0]; i++) {
        expect_refused(&c, VBSS_ERROR_OUT_OF_RANGE, &after, &answers[i]);
        assert_int_equal(answers[i].calls, 1);
    }
    answer infinite = {.triangle = 100, .weights = {(double)NAN, 0.5, 0.5}};
    expect_refused(&c, VBSS_ERROR_NOT_FINITE, &after, &infinite);
    answer none = {.leaves = true, .result = VBSS_ERROR_DEVICE};
    expect_refused(&c, VBSS_ERROR_NOT_FOUND, &after, &none);
    after.p.triangles[7][1] = after.p.triangles[7][0];
    expect_refused(&c, VBSS_ERROR_OUT_OF_RANGE, &after, NULL);
    after.p.triangles[7][1] = 16 * 16;
    expect_refused(&c, VBSS_ERROR_OUT_OF_RANGE, &after, NULL);
    make_mesh(&after, 15, 0.0);
    after.p.positions[40][2] = (double)NAN;
    expect_refused(&c, VBSS_ERROR_NOT_FINITE, &after, NULL);
    make_mesh(&after, 15, 0.0);
    for (uint32_t i = 0; i < 16 * 16; i++) {
        after.p.positions[i][1] += 5e-3; /* away from the hole */
    }
    expect_refused(&c, VBSS_ERROR_OUT_OF_RANGE, &after, NULL);
    expect_result(VBSS_ERROR_INCOMPATIBLE,
                  vbss_scene_remesh_surface(c.s.scene, c.suture, after.p.positions[0], 16 * 16,
                                            after.p.triangles[0], 450, NULL, NULL));
    expect_result(VBSS_ERROR_NULL_ARGUMENT,
                  vbss_scene_remesh_surface(c.s.scene, c.wall, NULL, 16 * 16, after.p.triangles[0],
                                            450, NULL, NULL));
    small_steps(&c.s, 30, H);
    small_steps(&same.s, 30, H);
    assert_true(small_hash(&c.s) == small_hash(&same.s));
    small_end(&c.s);
    small_end(&same.s);
}

/* A tool that the new mesh would be in, if the scene refuses overlaps. */
static void mesh_that_overlaps_a_body_is_refused(void **state)
{
    (void)state;
    stitched c;
    make_mesh(&before, CELLS, 0.0);
    make_mesh(&after, 15, 0.0);
    begin(&c, 0);
    (void)small_stick(&c.s, VBSS_SCENE_RIGID_COUPLED, vec3_make(10e-3, 2e-3, 10e-3), vec3_zero(),
                      1e-3);
    small_steps(&c.s, 10, H);
    small_object(&c.s)->config.overlap = VBSS_SCENE_OVERLAP_REFUSE;
    for (uint32_t i = 0; i < 16 * 16; i++) {
        after.p.positions[i][1] +=
            vbss_max(0.0, after.p.positions[i][0] - 8e-3); /* a ramp beside the hole */
    }
    expect_refused(&c, VBSS_ERROR_OUT_OF_RANGE, &after, NULL);
    make_mesh(&after, 15, 0.0);
    expect_ok(remesh_with(&c, &after, NULL, NULL)); /* the stitch is no overlap */
    small_end(&c.s);
}

static vbss_result remesh_in_new_scene(vbss_context *context, void *user)
{
    (void)user;
    vbss_scene *scene = NULL;
    uint32_t body = 0;
    const vbss_scene_config config = vbss_scene_config_default();
    vbss_scene_surface_config surface = vbss_scene_surface_config_default();
    surface.vertex_count = before.p.surface.node_count;
    surface.triangle_count = before.p.surface.triangle_count;
    surface.vertices = before.p.positions[0];
    surface.triangles = before.p.triangles[0];
    surface.compliance_size = 9;
    vbss_result result = vbss_scene_create(context, &config, &scene);
    if (result == VBSS_OK) {
        result = vbss_scene_add_surface(scene, &surface, &body);
    }
    if (result == VBSS_OK) {
        uint64_t one = 0, other = 1;
        expect_ok(vbss_scene_get_hash(scene, &one));
        result = vbss_scene_remesh_surface(scene, body, after.p.positions[0],
                                           after.p.surface.node_count, after.p.triangles[0],
                                           after.p.surface.triangle_count, NULL, NULL);
        expect_ok(vbss_scene_get_hash(scene, &other));
        assert_true((one == other) == (result != VBSS_OK));
    }
    expect_ok(vbss_scene_destroy(scene));
    return result;
}

static void remesh_without_memory_changes_nothing(void **state)
{
    (void)state;
    make_mesh(&before, 2, 0.0);
    make_mesh(&after, 5, 0.0);
    harness_fail_every_allocation(remesh_in_new_scene, NULL);
}

/* ---- compliance */

/* From 4 vertices to 169: the linear system grows. The host states the compliance of the new vertices. */
static void new_vertices_yield_once_their_compliance_is_stated(void **state)
{
    (void)state;
    static double compliance[PAD_NODES];
    stitched c;
    make_mesh(&before, 1, 0.0);
    make_mesh(&after, CELLS, 0.0);
    begin(&c, 1);
    for (uint32_t i = 0; i < PAD_NODES; i++) {
        compliance[i] = 0.02;
    }
    expect_ok(vbss_scene_set_surface_compliance(c.s.scene, c.wall, compliance, 4));
    small_steps(&c.s, 20, H);
    const uint32_t before_blocks = small_object(&c.s)->system->block_capacity;
    /* The host gives the positions of its own vertices, which follow the forces. */
    expect_ok(remesh_with(&c, &after, NULL, NULL));
    const uint32_t blocks = small_object(&c.s)->system->block_capacity;
    assert_int_equal(blocks, before_blocks + CELLS * CELLS + 2 * CELLS + 1 - 4);
    const double rigid = hole_of(&c).position[1];
    small_steps(&c.s, 1, H);
    assert_true(hole_of(&c).position[1] == rigid);
    expect_result(VBSS_ERROR_OUT_OF_RANGE,
                  vbss_scene_set_surface_compliance(c.s.scene, c.wall, compliance, 4));
    expect_ok(vbss_scene_set_surface_compliance(c.s.scene, c.wall, compliance, 169));
    for (int i = 0; i < 6; i++) { /* sticks across all cells */
        (void)small_stick(&c.s, VBSS_SCENE_RIGID_FREE, vec3_make((double)i * 2e-3, 1.6e-3, 9e-3),
                          vec3_make(0.0, 0.0, 4e-3), 1e-3);
    }
    small_steps(&c.s, 60, H);
    assert_true(hole_of(&c).position[1] != rigid);
    small_end(&c.s);
}

/* ---- state */

static void remeshed_scene_is_saved_and_loaded(void **state)
{
    (void)state;
    stitched c;
    harness_memory memory;
    vbss_context *context = harness_context(&memory);
    vbss_scene *loaded = NULL;
    make_mesh(&before, CELLS, 0.0);
    make_mesh(&after, 20, 0.0);
    begin(&c, 0);
    small_steps(&c.s, 20, H);
    const small_state old = small_save(&c.s);
    expect_ok(remesh_with(&c, &after, NULL, NULL));
    expect_result(VBSS_ERROR_CORRUPT, vbss_scene_restore(c.s.scene, old.bytes, old.count));
    small_steps(&c.s, 5, H);
    const small_state saved = small_save(&c.s);
    expect_ok(vbss_scene_load(context, saved.bytes, saved.count, &loaded));
    for (int i = 0; i < 20; i++) {
        uint64_t hash = 0;
        expect_ok(vbss_scene_get_hash(loaded, &hash));
        assert_true(small_hash(&c.s) == hash);
        expect_ok(vbss_scene_step(loaded, H));
        small_steps(&c.s, 1, H);
    }
    free(saved.bytes);
    free(old.bytes);
    expect_ok(vbss_scene_destroy(loaded));
    harness_context_end(context, &memory);
    small_end(&c.s);
}

/* Many changes use neither memory nor numbers of bodies up. */
static void surface_may_be_remeshed_for_ever(void **state)
{
    (void)state;
    stitched c;
    make_mesh(&before, CELLS, 0.0);
    begin(&c, 0);
    make_mesh(&after, CELLS, 0.0);
    uint64_t blocks = 0;
    for (int i = 0; i < 5000; i++) {
        expect_ok(remesh_with(&c, &after, NULL, NULL));
        blocks = i == 0 ? c.s.memory.blocks : blocks;
    }
    assert_true(c.s.memory.blocks == blocks);
    small_steps(&c.s, 5, H);
    small_end(&c.s);
}

int test_remesh_surface(void)
{
    const struct CMUnitTest tests[] = {
        harness_test(stitch_keeps_its_force_on_another_mesh),
        harness_test(stitch_in_a_curved_surface_is_held_by_its_stiffness),
        harness_test(contacts_go_on_after_a_remesh),
        harness_test(host_states_the_place_of_a_hole),
        harness_test(refused_remesh_changes_nothing),
        harness_test(mesh_that_overlaps_a_body_is_refused),
        harness_test(remesh_without_memory_changes_nothing),
        harness_test(new_vertices_yield_once_their_compliance_is_stated),
        harness_test(remeshed_scene_is_saved_and_loaded),
        harness_test(surface_may_be_remeshed_for_ever),
    };
    return cmocka_run_group_tests_name("scene.remesh_surface", tests, NULL, NULL);
}
