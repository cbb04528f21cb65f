/* Twist: torque at clamps, clamps that come and go, energy, and what a thread keeps. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/pi.h"
#include "base/rotation.h"
#include "thread/fixture.h"
#include "thread/rig.h"

enum { SEGMENTS = 30 };
static const double length = 0.03, torsion = 0.7e-8; /* m, N m^2 */
static const vec3 along = {1.0, 0.0, 0.0};

/* A thread along x without weight, clamped at both ends. */
typedef struct held {
    rig r;
    uint32_t low, high;
} held;

/* Without contacts friction torque changes nothing, so most tests run with it, too. */
static uint32_t friction_torque = 0;

static vbss_thread_config twist_config(void)
{
    vbss_thread_config c = rig_config(length, SEGMENTS);
    c.torsional_stiffness = torsion;
    c.friction_torque = friction_torque;
    c.gravity[1] = 0.0;
    return c;
}

static void held_begin(held *b, const vbss_thread_config *c)
{
    rig_begin(&b->r, c);
    b->low = rig_clamp_here(&b->r, 0, along);
    b->high = rig_clamp_here(&b->r, SEGMENTS, along);
}

static void roll(held *b, uint32_t clamp, double angle)
{
    expect_ok(vbss_thread_set_roll(b->r.thread, clamp, angle));
    rig_run(&b->r, 1e-3, 1);
}

static double twist_of_segment(held *b, uint32_t segment)
{
    vbss_view view;
    expect_ok(vbss_thread_get_view(b->r.thread, VBSS_THREAD_VIEW_TWISTS, &view, sizeof view));
    assert_int_equal(SEGMENTS, view.count);
    return ((const double *)view.data)[segment];
}

static double torque(held *b, uint32_t clamp)
{
    return rig_reaction_torque(&b->r, clamp).x;
}

/* ---- torque */

static void torque_is_stiffness_times_twist(void **state)
{
    (void)state;
    const double rolls[] = {0.5, 2.0, -1.0, 5.0};
    vbss_thread_config c = twist_config();
    held b;
    held_begin(&b, &c);
    for (int k = 0; k < 4; k++) {
        roll(&b, b.high, rolls[k]);
        const double wanted = torsion * rolls[k] / length;
        expect_near(wanted, torque(&b, b.high), 1e-12 * fabs(wanted));
        expect_near(-wanted, torque(&b, b.low), 1e-12 * fabs(wanted));
        expect_near(rolls[k] / length, twist_of_segment(&b, 7), 1e-9);
        const double energy = 0.5 * wanted * rolls[k];
        expect_near(energy, rig_energies(&b.r).twisting, 1e-12 * energy);
        expect_near(0.0, vec3_norm(rig_reaction_force(&b.r, b.high)), 1e-11);
    }
    roll(&b, b.low, rolls[3]);
    expect_near(0.0, torque(&b, b.high), 1e-20);
    rig_end(&b.r);
}

static void torque_is_zero_at_rest_twist(void **state)
{
    (void)state;
    vbss_thread_config c = twist_config();
    c.rest_twist = 50.0;
    held b;
    held_begin(&b, &c);
    rig_run(&b.r, 1e-3, 1);
    expect_near(-torsion * 50.0, torque(&b, b.high), 1e-12 * torsion * 50.0);
    roll(&b, b.high, 50.0 * length);
    expect_near(0.0, torque(&b, b.high), 1e-12 * torsion * 50.0);
    rig_end(&b.r);
}

/* Both clamps turn the thread as one, about y by a full turn: the directors come back with it. */
static void thread_that_turns_as_one_keeps_its_twist(void **state)
{
    (void)state;
    vbss_thread_config c = twist_config();
    held b;
    held_begin(&b, &c);
    roll(&b, b.high, 2.0);
    const double before = torque(&b, b.high);
    for (int k = 1; k <= 100; k++) {
        const quat q = vbss_quat_from_rotation_vector(vec3_make(0.0, VBSS_TWO_PI * k / 100.0, 0.0));
        double direction[3], target[3], origin[3] = {0.0, 0.0, 0.0};
        vec3_store(direction, quat_rotate(q, along));
        vec3_store(target, quat_rotate(q, vec3_make(length, 0.0, 0.0)));
        expect_ok(vbss_thread_set_attachment_target(b.r.thread, b.low, origin, direction));
        expect_ok(vbss_thread_set_attachment_target(b.r.thread, b.high, target, direction));
        rig_run(&b.r, 1e-3, 1);
    }
    rig_run(&b.r, 1e-3, 300);
    expect_near(before, torque(&b, b.high), 1e-3 * before);
    rig_end(&b.r);
}

/* ---- clamps that come and go */

static void new_clamp_keeps_twist_on_both_sides(void **state)
{
    (void)state;
    vbss_thread_config c = twist_config();
    held b;
    held_begin(&b, &c);
    roll(&b, b.high, 2.0);
    const uint32_t middle = rig_clamp_here(&b.r, 10, along);
    rig_run(&b.r, 1e-3, 1);
    expect_near(torsion * 2.0 / length, torque(&b, b.high), 1e-12 * torsion);
    expect_near(torsion * 2.0 / length, -torque(&b, b.low), 1e-12 * torsion);
    expect_near(0.0, torque(&b, middle), 1e-12 * torsion);
    roll(&b, middle, 0.5);
    expect_near(2.0 / length + 0.5 / (length / 3.0), twist_of_segment(&b, 9), 1e-9);
    expect_near(2.0 / length - 0.5 / (2.0 * length / 3.0), twist_of_segment(&b, 10), 1e-9);
    expect_near(torsion * 0.5 * (4.5 / length), torque(&b, middle), 1e-12 * torsion);
    expect_ok(vbss_thread_detach(b.r.thread, middle));
    rig_run(&b.r, 1e-3, 1);
    expect_near(torsion * 2.0 / length, torque(&b, b.high), 1e-12 * torsion);
    rig_end(&b.r);
}

static void free_end_lets_twist_go(void **state)
{
    (void)state;
    vbss_thread_config c = twist_config();
    held b;
    held_begin(&b, &c);
    roll(&b, b.high, 3.0);
    expect_ok(vbss_thread_detach(b.r.thread, b.high));
    rig_run(&b.r, 1e-3, 1);
    expect_near(0.0, torque(&b, b.low), 1e-20);
    expect_near(0.0, twist_of_segment(&b, 3), 1e-20);
    b.high = rig_clamp_here(&b.r, SEGMENTS, along);
    rig_run(&b.r, 1e-3, 1);
    expect_near(0.0, torque(&b, b.high), 1e-20);
    roll(&b, b.high, 1.0);
    expect_near(torsion / length, torque(&b, b.high), 1e-12 * torsion);
    rig_end(&b.r);
}

static void cut_lets_twist_go(void **state)
{
    (void)state;
    vbss_thread_config c = twist_config();
    c.cut_capacity = 1;
    held b;
    held_begin(&b, &c);
    const uint32_t middle = rig_clamp_here(&b.r, 20, along);
    roll(&b, b.high, 3.0);
    vbss_thread *piece = NULL;
    vbss_thread_reaction reaction;
    expect_ok(vbss_thread_cut(b.r.thread, 0.0145, &piece));
    rig_run(&b.r, 1e-3, 1);
    expect_ok(vbss_thread_step(piece, 1e-3));
    expect_near(0.0, torque(&b, b.low), 1e-20);
    expect_ok(vbss_thread_get_reaction(piece, b.high, &reaction, sizeof reaction));
    expect_near(torsion * 3.0 / (length / 3.0), reaction.torque[0], 1e-12 * torsion);
    expect_ok(vbss_thread_get_reaction(piece, middle, &reaction, sizeof reaction));
    expect_near(-torsion * 3.0 / (length / 3.0), reaction.torque[0], 1e-12 * torsion);
    expect_ok(vbss_thread_destroy(piece));
    rig_end(&b.r);
}

/* ---- energy */

/* Torque and rolling do the work. Without drag all of it is in the thread, which is slack and coils. */
static void work_of_rolling_is_stored(void **state)
{
    (void)state;
    enum { STEPS = 4000 };
    vbss_thread_config c = twist_config();
    held b;
    held_begin(&b, &c);
    vec3 x[SEGMENTS + 1];
    for (uint32_t i = 0; i <= SEGMENTS; i++) {
        const double s = (double)i / SEGMENTS;
        x[i] = vec3_make(length * s, 0.0, 1e-4 * s * s * (1.0 - s) * (1.0 - s));
    }
    rig_place(&b.r, x, NULL);
    for (int k = 1; k <= STEPS; k++) {
        rig_move(&b.r, b.high, vec3_make(length * (1.0 - 0.3 * k / STEPS), 0.0, 0.0));
        rig_run(&b.r, 1e-4, 1);
    }
    const double start = rig_energies(&b.r).total, turns = 1.2 * VBSS_TWO_PI;
    double work = 0.0, before = torque(&b, b.high);
    for (int k = 1; k <= STEPS; k++) {
        expect_ok(vbss_thread_set_roll(b.r.thread, b.high, turns * k / STEPS));
        rig_run(&b.r, 1e-4, 1);
        const double now = torque(&b, b.high);
        work += 0.5 * (now + before) * turns / STEPS;
        before = now;
    }
    const vbss_thread_energies e = rig_energies(&b.r);
    assert_true(work < 0.7 * 0.5 * torsion * turns * turns / length);
    expect_near(1.0, (e.total - start) / work, 0.01);
    rig_end(&b.r);
}

/* ---- views, snapshots, configurations */

static void directors_turn_by_the_twist(void **state)
{
    (void)state;
    vbss_thread_config c = twist_config();
    held b;
    held_begin(&b, &c);
    roll(&b, b.low, 0.3);
    roll(&b, b.high, 6.3);
    vec3 d[SEGMENTS];
    vbss_view view;
    expect_ok(
        vbss_thread_get_view(b.r.thread, VBSS_THREAD_VIEW_MATERIAL_DIRECTORS, &view, sizeof view));
    assert_int_equal(SEGMENTS, view.count);
    memcpy(d, view.data, sizeof d);
    for (int i = 0; i < SEGMENTS; i++) {
        expect_near(0.0, d[i].x, 1e-12);
        expect_near(1.0, vec3_norm(d[i]), 1e-12);
        if (i > 0) {
            expect_near(6.0 / SEGMENTS, asin(vec3_dot(along, vec3_cross(d[i - 1], d[i]))), 1e-9);
        }
    }
    rig_end(&b.r);
}

static void restored_thread_continues_with_same_bits(void **state)
{
    (void)state;
    vbss_thread_config c = twist_config();
    held b, other;
    held_begin(&b, &c);
    rig_begin(&other.r, &c);
    for (int k = 0; k < 100; k++) {
        roll(&b, b.high, 0.1 * k);
    }
    expect_ok(vbss_thread_set_roll(b.r.thread, b.high, 12.0));
    uint8_t bytes[65536];
    uint64_t count, hashes[2];
    expect_ok(vbss_thread_save(b.r.thread, bytes, sizeof bytes, &count));
    expect_ok(vbss_thread_restore(other.r.thread, bytes, count));
    rig_run(&b.r, 1e-3, 50);
    rig_run(&other.r, 1e-3, 50);
    expect_ok(vbss_thread_get_hash(b.r.thread, &hashes[0]));
    expect_ok(vbss_thread_get_hash(other.r.thread, &hashes[1]));
    assert_true(hashes[0] == hashes[1]);
    rig_end(&other.r);
    rig_end(&b.r);
}

static void set_state_keeps_twist(void **state)
{
    (void)state;
    vbss_thread_config c = twist_config();
    held b;
    held_begin(&b, &c);
    roll(&b, b.high, 2.0);
    const double before = rig_energies(&b.r).twisting;
    vec3 x[SEGMENTS + 1];
    rig_read(&b.r, VBSS_THREAD_VIEW_POSITIONS, x);
    x[9].y += 1e-4;
    x[12].z += 1e-4;
    rig_place(&b.r, x, NULL);
    expect_near(before, rig_energies(&b.r).twisting, 1e-15 * before);
    rig_end(&b.r);
}

static void twist_refuses_what_it_does_not_work_with(void **state)
{
    (void)state;
    fixture f;
    begin(&f);
    for (int k = 0; k < 7; k++) {
        vbss_thread_config c = f.config;
        c.torsional_stiffness = k >= 5 ? 0.0 : torsion;
        c.friction_torque = k == 6;
        c.method = k == 0 ? VBSS_METHOD_VBLAST : VBSS_METHOD_IMPLICIT;
        c.mesh = k == 1 ? VBSS_THREAD_MESH_ADAPTIVE : VBSS_THREAD_MESH_FIXED;
        c.rest_curvature = k == 2 ? 20.0 : 0.0;
        c.yield_curvature = k == 3 ? 100.0 : 0.0;
        c.relaxation_ratio = k == 4 ? 1.0 : 0.0;
        c.rest_twist = k == 5 ? 10.0 : 0.0;
        vbss_thread *thread = NULL;
        expect_result(VBSS_ERROR_INCOMPATIBLE, vbss_thread_create(f.context, &c, &thread));
        assert_null(thread);
        const char *text = NULL;
        expect_ok(vbss_context_get_last_error(f.context, NULL, &text));
        assert_non_null(strstr(text, k == 5   ? "rest_twist"
                                     : k == 6 ? "friction_torque"
                                              : "torsional_stiffness"));
    }
    vbss_thread_config c = f.config;
    vbss_thread *thread = NULL;
    c.torsional_stiffness = torsion;
    c.friction_torque = 2;
    expect_result(VBSS_ERROR_OUT_OF_RANGE, vbss_thread_create(f.context, &c, &thread));
    end(&f);
}

static void roll_needs_clamp_of_thread_with_twist(void **state)
{
    (void)state;
    for (int k = 0; k < 2; k++) {
        vbss_thread_config c = twist_config();
        c.torsional_stiffness = k == 0 ? 0.0 : torsion;
        rig r;
        rig_begin(&r, &c);
        const uint32_t clamp = rig_clamp_here(&r, 0, along), pin = rig_pin_here(&r, 3);
        uint64_t hashes[2];
        expect_ok(vbss_thread_get_hash(r.thread, &hashes[0]));
        expect_result(VBSS_ERROR_INCOMPATIBLE, vbss_thread_set_roll(r.thread, pin, 1.0));
        expect_result(VBSS_ERROR_NOT_FOUND, vbss_thread_set_roll(r.thread, 99, 1.0));
        if (k == 0) {
            expect_result(VBSS_ERROR_INCOMPATIBLE, vbss_thread_set_roll(r.thread, clamp, 1.0));
        } else {
            expect_result(VBSS_ERROR_NOT_FINITE,
                          vbss_thread_set_roll(r.thread, clamp, (double)NAN));
            expect_result(VBSS_ERROR_OUT_OF_RANGE, vbss_thread_set_roll(r.thread, clamp, 2e6));
        }
        expect_ok(vbss_thread_get_hash(r.thread, &hashes[1]));
        assert_true(hashes[0] == hashes[1]);
        rig_end(&r);
    }
}

static int ask_for_friction_torque(void **state)
{
    (void)state;
    friction_torque = 1;
    return 0;
}

int test_twist(void)
{
    const struct CMUnitTest models[] = {
        cmocka_unit_test(torque_is_stiffness_times_twist),
        cmocka_unit_test(torque_is_zero_at_rest_twist),
        cmocka_unit_test(thread_that_turns_as_one_keeps_its_twist),
        cmocka_unit_test(new_clamp_keeps_twist_on_both_sides),
        cmocka_unit_test(free_end_lets_twist_go),
        cmocka_unit_test(cut_lets_twist_go),
        cmocka_unit_test(work_of_rolling_is_stored),
        cmocka_unit_test(directors_turn_by_the_twist),
        cmocka_unit_test(restored_thread_continues_with_same_bits),
        cmocka_unit_test(set_state_keeps_twist),
    };
    const struct CMUnitTest refusals[] = {
        cmocka_unit_test(twist_refuses_what_it_does_not_work_with),
        cmocka_unit_test(roll_needs_clamp_of_thread_with_twist),
    };
    const int failed = cmocka_run_group_tests_name("thread.twist", models, NULL, NULL) +
                       cmocka_run_group_tests_name("thread.twist: refusals", refusals, NULL, NULL);
    return failed + cmocka_run_group_tests_name("thread.twist: friction torque", models,
                                                ask_for_friction_torque, NULL);
}
