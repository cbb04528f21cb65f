/* A stitch in a host surface against the same stitch in a shell. The host's own model is that shell, outside of the
 * scene, so the only difference is the coupling: the host states how far each vertex gives way in a step, without the blocks between
 * vertices. */
#include <stdlib.h>

#include <vblast_ss/scene_surface.h>

#include "fixtures/pad.h"
#include "scene/small.h"

#define H 1e-3
#define SIDE 30e-3
#define LENGTH 20e-3 /* of the thread */
#define ARM 60.0     /* N/m, of the springs that draw its ends */
#define FRICTION 0.1 /* N: the thread sticks */
enum {
    CELLS = 10,
    SEGMENTS = 40,
    TRIANGLE = CELLS * CELLS + CELLS,
    NODES = (CELLS + 1) * (CELLS + 1)
};

static const double shares[3] = {0.2, 0.3, 0.5};
static pad skin;

typedef struct stitched {
    small s;
    vbss_drain *shell; /* in the scene, or the host's */
    vbss_thread *thread;
    uint32_t wall, suture;
    double compliance[3][9],
        coupling[3][3][9]; /* of the corners: blocks, and all blocks between them, m/N */
} stitched;

static const uint32_t *corners(void)
{
    return skin.triangles[TRIANGLE];
}

static void begin(stitched *c)
{
    memset(c, 0, sizeof *c);
    small_begin(&c->s);
    pad_make(&skin, CELLS, CELLS, SIDE, SIDE);
    pad_clamp_frame(&skin);
    c->s.config.mode = VBSS_SCENE_MODE_OFFLINE;
    c->s.config.floor = 0;
    small_create(&c->s);
    c->s.drain.surface = &skin.surface;
    c->s.drain.thickness = 1e-3;
    c->s.drain.young_modulus = 0.3e6;
    c->s.drain.thread_force = FRICTION;
    c->s.drain.tear_stress = 1e9;
    c->s.drain.attachment_capacity = 8;
}

/* Through the hole, up and down; both ends are drawn to the side and up by springs. */
static void add_thread(stitched *c)
{
    vec3 hole = vec3_zero();
    for (int k = 0; k < 3; k++) {
        hole = vec3_add_scaled(hole, shares[k], vec3_load(skin.positions[corners()[k]]));
    }
    const vec3 half = vec3_make(0.0, 0.5 * LENGTH, 0.0);
    c->suture =
        small_thread(&c->s, vec3_add(hole, half), vec3_sub(hole, half), SEGMENTS, &c->thread);
    expect_ok(
        vbss_scene_make_hole(c->s.scene, c->suture, 0.5 * LENGTH, c->wall, TRIANGLE, shares, NULL));
    for (uint32_t end = 0; end < 2; end++) {
        vbss_thread_attachment hand;
        uint32_t id;
        const vec3 at = vec3_add(vec3_add_scaled(hole, end == 0 ? 1.0 : -1.0, half),
                                 vec3_make(1.5e-3, 3e-3, 0.5e-3));
        expect_ok(vbss_thread_attachment_init(&hand, sizeof hand));
        hand.kind = VBSS_THREAD_ATTACHMENT_SPRING;
        hand.node = end * SEGMENTS;
        hand.stiffness = ARM;
        hand.damping = 0.5;
        vec3_store(hand.position, at);
        expect_ok(vbss_thread_attach(c->thread, &hand, &id));
    }
}

static vbss_scene_hole hole_of(const stitched *c)
{
    vbss_scene_hole hole;
    expect_ok(vbss_scene_get_hole(c->s.scene, 0, &hole, sizeof hole));
    return hole;
}

/* ---- the host */

static vec3 node_of(const stitched *c, uint32_t node)
{
    vbss_view x;
    expect_ok(vbss_drain_get_view(c->shell, VBSS_DRAIN_VIEW_POSITIONS, &x, sizeof x));
    return ((const vec3 *)x.data)[node];
}

/* A step of the shell with forces on the corners. */
static void step_shell(stitched *c, const vec3 forces[3])
{
    uint32_t ids[3];
    for (int k = 0; k < 3; k++) {
        vbss_drain_attachment load;
        expect_ok(vbss_drain_attachment_init(&load, sizeof load));
        load.kind = VBSS_DRAIN_ATTACHMENT_FORCE;
        load.node = corners()[k];
        vec3_store(load.force, forces[k]);
        expect_ok(vbss_drain_attach(c->shell, &load, &ids[k]));
    }
    expect_ok(vbss_drain_step(c->shell, H));
    for (int k = 0; k < 3; k++) {
        expect_ok(vbss_drain_detach(c->shell, ids[k]));
    }
}

static small_state save_shell(const stitched *c)
{
    small_state saved = {NULL, 0};
    (void)vbss_drain_save(c->shell, NULL, 0, &saved.count); /* its size */
    saved.bytes = malloc((size_t)saved.count);
    assert_non_null(saved.bytes);
    expect_ok(vbss_drain_save(c->shell, saved.bytes, saved.count, &saved.count));
    return saved;
}

/* How far the corners give way in a step to a small force on each of them. */
static void measure_compliance(stitched *c)
{
    const double force = 1e-5;
    const vec3 none[3] = {{0}};
    const small_state saved = save_shell(c);
    vec3 still[3];
    step_shell(c, none);
    for (int k = 0; k < 3; k++) {
        still[k] = node_of(c, corners()[k]);
    }
    for (int k = 0; k < 9; k++) {
        vec3 forces[3] = {{0}};
        double unit[3] = {0.0, 0.0, 0.0};
        unit[k % 3] = force;
        forces[k / 3] = vec3_load(unit);
        expect_ok(vbss_drain_restore(c->shell, saved.bytes, saved.count));
        step_shell(c, forces);
        for (int i = 0; i < 3; i++) {
            const vec3 moved =
                vec3_scale(vec3_sub(node_of(c, corners()[i]), still[i]), 1.0 / force);
            c->coupling[i][k / 3][k % 3] = moved.x;
            c->coupling[i][k / 3][3 + k % 3] = moved.y;
            c->coupling[i][k / 3][6 + k % 3] = moved.z;
        }
    }
    expect_ok(vbss_drain_restore(c->shell, saved.bytes, saved.count));
    free(saved.bytes);
}

static double trace_of(const double c[9])
{
    return c[0] + c[4] + c[8];
}

/* The block of each corner. `covers`: larger, as if the forces on the other corners were on this one. */
static void state_compliance(stitched *c, bool covers)
{
    static double all[NODES][9];
    memset(all, 0, sizeof all);
    for (int k = 0; k < 3; k++) {
        double *own = all[corners()[k]], sum = 0.0;
        for (int i = 0; i < 3; i++) {
            sum += trace_of(c->coupling[k][i]);
        }
        const double factor = covers ? sum / trace_of(c->coupling[k][k]) : 1.0;
        for (int e = 0; e < 9; e++) {
            own[e] = 0.5 * factor * (c->coupling[k][k][e] + c->coupling[k][k][e % 3 * 3 + e / 3]);
        }
        memcpy(c->compliance[k], own, sizeof c->compliance[k]);
    }
    expect_ok(vbss_scene_set_surface_compliance(c->s.scene, c->wall, all[0], 9 * NODES));
}

/* The shell goes where it goes without the thread, the scene solves, and the shell takes the same step with the forces. */
static void step_host(stitched *c)
{
    static double vertices[NODES][3];
    const vec3 none[3] = {{0}};
    const small_state saved = save_shell(c);
    step_shell(c, none);
    for (uint32_t i = 0; i < NODES; i++) {
        vec3_store(vertices[i], node_of(c, i));
    }
    expect_ok(vbss_drain_restore(c->shell, saved.bytes, saved.count));
    free(saved.bytes);
    expect_ok(vbss_scene_move_surface(c->s.scene, c->wall, vertices[0], NODES));
    small_steps(&c->s, 1, H);
    vbss_view f;
    expect_ok(vbss_scene_get_surface_view(c->s.scene, c->wall, VBSS_SCENE_SURFACE_VIEW_FORCES, &f,
                                          sizeof f));
    vec3 forces[3];
    for (int k = 0; k < 3; k++) {
        forces[k] = ((const vec3 *)f.data)[corners()[k]];
    }
    step_shell(c, forces);
}

static void begin_host(stitched *c)
{
    begin(c);
    expect_ok(vbss_drain_create(c->s.context, &c->s.drain, &c->shell));
    vbss_scene_surface_config config = vbss_scene_surface_config_default();
    config.vertex_count = NODES;
    config.triangle_count = skin.surface.triangle_count;
    config.vertices = skin.positions[0];
    config.triangles = skin.triangles[0];
    config.thickness = 1e-3;
    config.thread_force = FRICTION;
    config.compliance_size = 9;
    expect_ok(vbss_scene_add_surface(c->s.scene, &config, &c->wall));
    add_thread(c);
}

/* ---- comparison */

typedef struct result {
    vec3 force, host_hole, scene_hole;
    double gap; /* between stated and true displacement of the hole by the force, m */
} result;

static vec3 apply(const double c[9], vec3 f)
{
    return vec3_make(c[0] * f.x + c[1] * f.y + c[2] * f.z, c[3] * f.x + c[4] * f.y + c[5] * f.z,
                     c[6] * f.x + c[7] * f.y + c[8] * f.z);
}

/* By the stated blocks, and by all of them. */
static vec3 gap_of(const stitched *c, vec3 force)
{
    vec3 sum = vec3_zero();
    for (int k = 0; k < 3; k++) {
        sum = vec3_add_scaled(sum, shares[k] * shares[k], apply(c->compliance[k], force));
        for (int i = 0; i < 3; i++) {
            sum = vec3_add_scaled(sum, -shares[k] * shares[i], apply(c->coupling[k][i], force));
        }
    }
    return sum;
}

static result run_shell(void)
{
    stitched c;
    begin(&c);
    c.wall = small_drain(&c.s, &c.shell);
    add_thread(&c);
    small_steps(&c.s, 600, H);
    const vbss_scene_hole hole = hole_of(&c);
    const result r = {.force = vec3_load(hole.force), .scene_hole = vec3_load(hole.position)};
    small_end(&c.s);
    return r;
}

static result run_host(bool covers)
{
    stitched c;
    begin_host(&c);
    for (int i = 0; i < 600; i++) {
        if (i % 10 == 0) { /* the shell stiffens as it bends */
            measure_compliance(&c);
            state_compliance(&c, covers);
        }
        step_host(&c);
    }
    const vbss_scene_hole hole = hole_of(&c);
    result r = {.force = vec3_load(hole.force), .scene_hole = vec3_load(hole.position)};
    for (int k = 0; k < 3; k++) {
        r.host_hole = vec3_add_scaled(r.host_hole, shares[k], node_of(&c, corners()[k]));
    }
    r.gap = vec3_norm(gap_of(&c, vec3_neg(r.force)));
    small_end(&c.s);
    return r;
}

/* The hole is at different places for host and scene: by the force times the compliance that the stated blocks have too much or too little. The
 * springs at the ends of the thread turn this distance into a force. */
static void expect_bounds(bool covers, double share)
{
    const result shell = run_shell(), host = run_host(covers);
    const double force = vec3_norm(shell.force), apart = vec3_distance(shell.force, host.force);
    const double distance = vec3_distance(host.host_hole, host.scene_hole);
    assert_true(force > 0.03 && shell.scene_hole.y > 2e-3);
    assert_true(apart < share * force);
    assert_true(apart < 2.0 * ARM * distance);
    expect_near(host.gap, distance, 0.03e-3);
}

static void hole_has_the_force_of_a_shell_within_a_tenth(void **state)
{
    (void)state;
    expect_bounds(false, 0.1);
}

static void larger_blocks_bring_it_within_three_per_cent(void **state)
{
    (void)state;
    expect_bounds(true, 0.03);
}

int test_surface_accuracy(void)
{
    const struct CMUnitTest tests[] = {
        harness_test(hole_has_the_force_of_a_shell_within_a_tenth),
        harness_test(larger_blocks_bring_it_within_three_per_cent),
    };
    return cmocka_run_group_tests_name("scene.surface_accuracy", tests, NULL, NULL);
}
