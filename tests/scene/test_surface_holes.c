/* Holes in host surfaces: threads and needles pass through them as through a drain, the vertices get the forces, and a saved
 * scene goes on to the same bits. */
#include <stdlib.h>

#include "fixtures/pad.h"
#include "scene/surface_rig.h"

#define H 1e-3
#define SIDE 30e-3
#define FRICTION 0.025 /* N, of a slack thread in a hole */
#define LENGTH 20e-3   /* of the thread */
enum { CELLS = 12, SEGMENTS = 40, TRIANGLE = CELLS * CELLS };

static const double shares[3] = {0.2, 0.3, 0.5};
static pad skin;

typedef struct stitched {
    small s;
    vbss_thread *thread;
    uint32_t wall, suture;
    const vec3 *forces; /* on the vertices of a host surface */
} stitched;

static vbss_scene_surface_config surface_of_pad(void)
{
    vbss_scene_surface_config config = vbss_scene_surface_config_default();
    config.vertex_count = skin.surface.node_count;
    config.triangle_count = skin.surface.triangle_count;
    config.vertices = skin.positions[0];
    config.triangles = skin.triangles[0];
    config.thickness = 1e-3;
    config.friction = 0.2;
    config.thread_force = FRICTION;
    return config;
}

static void begin(stitched *c)
{
    small_begin(&c->s);
    pad_make(&skin, CELLS, CELLS, SIDE, SIDE);
    c->s.config.mode = VBSS_SCENE_MODE_OFFLINE;
    c->s.config.floor = 0;
    small_create(&c->s);
}

static void begin_with_surface(stitched *c, uint32_t compliance_size)
{
    begin(c);
    vbss_scene_surface_config config = surface_of_pad();
    config.compliance_size = compliance_size;
    expect_ok(vbss_scene_add_surface(c->s.scene, &config, &c->wall));
}

/* A shell with the same mesh, of which no corner of the hole's triangle moves. */
static void begin_with_shell(stitched *c)
{
    begin(c);
    pad_clamp_columns(&skin, CELLS);
    c->s.drain.surface = &skin.surface;
    c->s.drain.thickness = 1e-3;
    c->s.drain.friction = 0.2;
    c->s.drain.thread_force = FRICTION;
    c->wall = small_drain(&c->s, NULL);
}

/* A thread that goes straight through the wall, in a hole. */
static void add_stitch(stitched *c)
{
    vec3 hole = vec3_zero();
    for (int k = 0; k < 3; k++) {
        hole = vec3_add_scaled(hole, shares[k],
                               vec3_load(skin.positions[skin.triangles[TRIANGLE][k]]));
    }
    const vec3 half = vec3_make(0.0, 0.5 * LENGTH, 0.0);
    c->suture =
        small_thread(&c->s, vec3_add(hole, half), vec3_sub(hole, half), SEGMENTS, &c->thread);
    expect_ok(
        vbss_scene_make_hole(c->s.scene, c->suture, 0.5 * LENGTH, c->wall, TRIANGLE, shares, NULL));
}

static vbss_scene_hole hole_of(const stitched *c)
{
    vbss_scene_hole hole;
    expect_ok(vbss_scene_get_hole(c->s.scene, 0, &hole, sizeof hole));
    return hole;
}

static void read_forces(stitched *c)
{
    vbss_view view;
    expect_ok(vbss_scene_get_surface_view(c->s.scene, c->wall, VBSS_SCENE_SURFACE_VIEW_FORCES,
                                          &view, sizeof view));
    c->forces = view.data;
}

/* ---- against the shell */

/* Both ends are drawn to the same side, harder above: the thread bends in the hole. */
static vbss_scene_hole drawn_hole(stitched *c, double above)
{
    add_stitch(c);
    small_draw(c->thread, 0, vec3_make(0.06, above, 0.0));
    small_draw(c->thread, SEGMENTS, vec3_make(0.03, -0.08, 0.01));
    small_steps(&c->s, 60, H);
    return hole_of(c);
}

static void expect_forces_of_shell(double above, bool slides)
{
    stitched own, shell;
    begin_with_surface(&own, 0);
    const vbss_scene_hole in_surface = drawn_hole(&own, above);
    begin_with_shell(&shell);
    const vbss_scene_hole in_shell = drawn_hole(&shell, above);
    const double force = vec3_norm(vec3_load(in_shell.force));
    assert_true(force > 0.03);
    assert_true((fabs(in_shell.arc_length - 0.5 * LENGTH) > 0.3e-3) == slides);
    assert_true(vec3_distance(vec3_load(in_surface.force), vec3_load(in_shell.force)) <
                0.02 * force);
    expect_near(in_shell.friction, in_surface.friction, 0.02 * force);
    expect_near(in_shell.arc_length, in_surface.arc_length, 0.02e-3);
    small_end(&own.s);
    small_end(&shell.s);
}

static void hole_has_the_forces_of_the_same_hole_in_a_shell(void **state)
{
    (void)state;
    expect_forces_of_shell(0.08, false);
    expect_forces_of_shell(0.11, true);
}

/* ---- forces on vertices */

/* The corners of the triangle share the force by the weights; no other vertex has any. */
static void expect_shares(stitched *c, double force, double tolerance)
{
    double sum = 0.0;
    read_forces(c);
    for (uint32_t i = 0; i < skin.surface.node_count; i++) {
        sum += vec3_norm(c->forces[i]);
    }
    for (int k = 0; k < 3; k++) {
        const vec3 on_vertex = c->forces[skin.triangles[TRIANGLE][k]];
        sum -= vec3_norm(on_vertex);
        expect_near(shares[k] * force, on_vertex.y, tolerance * force);
    }
    expect_near(0.0, sum, 1e-12);
}

static void corners_share_the_force_of_a_hole(void **state)
{
    (void)state;
    stitched c;
    begin_with_surface(&c, 0);
    add_stitch(&c);
    const double force = 0.8 * FRICTION;
    small_draw(c.thread, 0, vec3_make(0.0, force, 0.0));
    small_steps(&c.s, 300, H);
    assert_true(fabs(hole_of(&c).arc_length - 0.5 * LENGTH) < 0.1e-3);
    expect_shares(&c, force, 0.01);
    expect_near(force, small_rigid(&c.s, c.wall).contact_force[1], 0.01 * force);
    small_end(&c.s);
}

/* Each vertex gives way by its compliance times its share. */
static void vertices_yield_to_a_hole(void **state)
{
    (void)state;
    static double compliance[PAD_NODES];
    stitched c;
    vbss_view view;
    begin_with_surface(&c, 1);
    add_stitch(&c);
    for (uint32_t i = 0; i < skin.surface.node_count; i++) {
        compliance[i] = 0.02 * (1.0 + 0.01 * i);
    }
    expect_ok(
        vbss_scene_set_surface_compliance(c.s.scene, c.wall, compliance, skin.surface.node_count));
    const double force = 0.8 * FRICTION;
    small_draw(c.thread, 0, vec3_make(0.0, force, 0.0));
    small_steps(&c.s, 300, H);
    expect_shares(&c, force, 0.01);
    expect_ok(vbss_scene_get_surface_view(c.s.scene, c.wall, VBSS_SCENE_SURFACE_VIEW_POSITIONS,
                                          &view, sizeof view));
    const vec3 *x = view.data;
    double sunk = 0.0;
    for (uint32_t i = 0; i < skin.surface.node_count; i++) {
        const vec3 moved = vec3_sub(x[i], vec3_load(skin.positions[i]));
        expect_near(0.0, vec3_norm(vec3_add_scaled(moved, -compliance[i], c.forces[i])), 1e-12);
    }
    for (int k = 0; k < 3; k++) {
        sunk += shares[k] * shares[k] * compliance[skin.triangles[TRIANGLE][k]] * force;
    }
    expect_near(sunk, hole_of(&c).position[1], 0.01 * sunk);
    small_end(&c.s);
}

/* ---- puncture */

#define PUNCTURE_FORCE 0.5

/* A needle below the wall, with its tip upward at the hole, is pushed up. Returns the number of punctures. */
static uint32_t push_needle(stitched *c, double force, vbss_scene_event *puncture)
{
    const double push[3] = {0.0, force, 0.0};
    vbss_needle_config config = vbss_needle_config_default();
    vbss_needle *needle;
    uint32_t punctures = 0;
    config.drag = 1e5; /* it goes on slowly, as in a hand */
    vec3_store(config.position, vec3_make(1e-3 - config.radius, -1.2e-3, 1e-3));
    expect_ok(vbss_needle_create(c->s.context, &config, &needle));
    expect_ok(vbss_scene_add_needle(c->s.scene, needle, &c->suture));
    for (int i = 0; i < 40; i++) {
        vbss_needle_state state;
        expect_ok(vbss_needle_get_state(needle, &state, sizeof state));
        expect_ok(vbss_scene_apply_force(c->s.scene, c->suture, push, state.tip, NULL));
        small_steps(&c->s, 1, H);
        punctures += small_events(&c->s, VBSS_SCENE_EVENT_PUNCTURE, puncture);
    }
    return punctures;
}

static uint32_t punctures_under(double force, double puncture_force)
{
    stitched c;
    vbss_scene_event event = {.kind = 0};
    begin(&c);
    vbss_scene_surface_config config = surface_of_pad();
    config.puncture_force = puncture_force;
    expect_ok(vbss_scene_add_surface(c.s.scene, &config, &c.wall));
    const uint32_t punctures = push_needle(&c, force, &event);
    if (punctures > 0) {
        assert_true(event.body_a == c.suture && event.body_b == c.wall);
        assert_true(event.value >= PUNCTURE_FORCE && event.value < 2.0 * force);
        assert_true(hole_of(&c).needle == c.suture && hole_of(&c).drain == c.wall);
        assert_true(hole_of(&c).arc_length > 0.1e-3); /* it went on */
    }
    small_end(&c.s);
    return punctures;
}

static void needle_enters_above_the_puncture_force(void **state)
{
    (void)state;
    assert_int_equal(punctures_under(0.6 * PUNCTURE_FORCE, PUNCTURE_FORCE), 0);
    assert_int_equal(punctures_under(1.6 * PUNCTURE_FORCE, PUNCTURE_FORCE), 1);
    assert_int_equal(punctures_under(1.6 * PUNCTURE_FORCE, 0.0), 0);
}

/* ---- state */

static void loaded_scene_has_the_hole(void **state)
{
    (void)state;
    stitched c;
    harness_memory memory;
    vbss_context *context = harness_context(&memory);
    vbss_scene *loaded = NULL;
    begin_with_surface(&c, 1);
    add_stitch(&c);
    small_draw(c.thread, 0, vec3_make(0.01, 2.0 * FRICTION, 0.0));
    small_steps(&c.s, 20, H);
    const small_state saved = small_save(&c.s);
    expect_ok(vbss_scene_load(context, saved.bytes, saved.count, &loaded));
    for (int i = 0; i < 20; i++) {
        uint64_t hash = 0;
        expect_ok(vbss_scene_get_hash(loaded, &hash));
        assert_int_equal(small_hash(&c.s), hash);
        expect_ok(vbss_scene_step(loaded, H));
        small_steps(&c.s, 1, H);
    }
    free(saved.bytes);
    expect_ok(vbss_scene_destroy(loaded));
    harness_context_end(context, &memory);
    small_end(&c.s);
}

/* A hole of another triangle than the surface has, or in a body without a wall. */
static void refused_holes_change_nothing(void **state)
{
    (void)state;
    stitched c;
    begin_with_surface(&c, 0);
    add_stitch(&c);
    const uint64_t hash = small_hash(&c.s);
    expect_result(VBSS_ERROR_OUT_OF_RANGE,
                  vbss_scene_make_hole(c.s.scene, c.suture, 0.5 * LENGTH, c.wall,
                                       skin.surface.triangle_count, shares, NULL));
    expect_result(VBSS_ERROR_INCOMPATIBLE, vbss_scene_make_hole(c.s.scene, c.suture, 0.5 * LENGTH,
                                                                c.suture, TRIANGLE, shares, NULL));
    expect_result(VBSS_ERROR_IN_USE, vbss_scene_make_hole(c.s.scene, c.suture, 0.5 * LENGTH, c.wall,
                                                          TRIANGLE, shares, NULL));
    assert_true(small_hash(&c.s) == hash);
    small_end(&c.s);
}

int test_surface_holes(void)
{
    const struct CMUnitTest tests[] = {
        harness_test(hole_has_the_forces_of_the_same_hole_in_a_shell),
        harness_test(corners_share_the_force_of_a_hole),
        harness_test(vertices_yield_to_a_hole),
        harness_test(needle_enters_above_the_puncture_force),
        harness_test(loaded_scene_has_the_hole),
        harness_test(refused_holes_change_nothing),
    };
    return cmocka_run_group_tests_name("scene.surface_holes", tests, NULL, NULL);
}
