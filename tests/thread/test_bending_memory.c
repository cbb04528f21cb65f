/* Plastic bending: the bilinear model, what a thread keeps, and what it must not do. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/elementary.h"
#include "base/rotation.h"
#include "thread/bend_rig.h"
#include "thread/fixture.h"

static const double yield = 60.0, hardening = 0.2;

static vbss_thread_config plastic_config(int bending)
{
    vbss_thread_config c = bend_config(bending);
    c.yield_curvature = yield;
    c.yield_hardening = hardening;
    return c;
}

/* ---- moment and curvature */

/* To the yield curvature and back there is no difference to an elastic thread. */
static void bend_below_yield_is_elastic(void **state)
{
    (void)state;
    for (int bending = 0; bending < 2; bending++) {
        vbss_thread_config c = plastic_config(bending);
        bend_rig b;
        bend_begin(&b, &c);
        bend_to(&b, 0.98 * yield, 200, 1e-3);
        bend_to(&b, 0.98 * yield, 200, 1e-3);
        expect_near(BEND_STIFFNESS * 0.98 * yield, bend_moment(&b), 2e-3 * BEND_STIFFNESS * yield);
        assert_true(rig_energies(&b.r).dissipated == 0.0);
        bend_to(&b, 0.0, 200, 1e-3);
        bend_to(&b, 0.0, 200, 1e-3);
        expect_near(0.0, bend_moment(&b), 1e-4 * BEND_STIFFNESS * yield);
        bend_end(&b);
    }
}

/* Loading, unloading, loading to the other side and back: the corners of the loop of a bilinear
 * material with kinematic hardening. */
static void moment_follows_bilinear_loop(void **state)
{
    (void)state;
    const double peak = 3.0 * yield, peak_moment = yield * (1.0 + hardening * 2.0);
    const struct {
        double curvature, moment; /* over EI */
    } corners[] = {
        {0.5 * yield, 0.5 * yield},
        {yield, yield},
        {2.0 * yield, yield * (1.0 + hardening)},
        {peak, peak_moment},
        {peak - yield, peak_moment - yield},
        {peak - 2.0 * yield, peak_moment - 2.0 * yield},
        {0.0, peak_moment - 2.0 * yield - hardening * (peak - 2.0 * yield)},
        {-2.0 * yield, peak_moment - 2.0 * yield - hardening * peak},
        {0.0, peak_moment - 2.0 * yield - hardening * peak + 2.0 * yield},
        {peak, peak_moment},
    };
    for (int bending = 0; bending < 2; bending++) {
        vbss_thread_config c = plastic_config(bending);
        bend_rig b;
        bend_begin(&b, &c);
        for (size_t i = 0; i < sizeof corners / sizeof corners[0]; i++) {
            bend_to(&b, corners[i].curvature, 200, 1e-3);
            bend_to(&b, corners[i].curvature, 300, 1e-3);
            expect_near(corners[i].moment / yield, bend_moment(&b) / BEND_STIFFNESS / yield, 0.015);
        }
        assert_int_equal(0, rig_statistics(&b.r).forced);
        bend_end(&b);
    }
}

static double moment_after_loop(uint32_t steps)
{
    vbss_thread_config c = plastic_config(VBSS_THREAD_BENDING_LOCAL);
    bend_rig b;
    bend_begin(&b, &c);
    bend_to(&b, 150.0, steps, 0.8 / steps);
    bend_to(&b, -30.0, steps, 0.8 / steps);
    double moment = bend_moment(&b) / (BEND_STIFFNESS * yield);
    bend_end(&b);
    return moment;
}

/* The model has no rate: a loop in 25 steps ends where one in 800 steps does. */
static void loop_does_not_depend_on_step(void **state)
{
    (void)state;
    const double moment = moment_after_loop(800);
    expect_near(moment, moment_after_loop(25), 5e-3);
    expect_near(moment, moment_after_loop(100), 2e-3);
}

/* Let go from a circle of curvature k, a thread keeps (1 - hardening) (k - yield): the radii are those
 * of a grasper's shaft, its jaw and a needle holder's tip. */
static void released_thread_keeps_residual_curvature(void **state)
{
    (void)state;
    const double radii[] = {2.5e-3, 4e-3, 8e-3};
    /* No reverse yield: hardening (k - yield) < yield. */
    const double high_yield = 90.0;
    for (int k = 0; k < 6; k++) {
        vbss_thread_config c = plastic_config(k % 2);
        c.yield_curvature = high_yield;
        bend_rig b;
        double curvature = 1.0 / radii[k / 2];
        bend_begin(&b, &c);
        const double kept = (1.0 - hardening) * (curvature - high_yield);
        bend_to(&b, curvature, 300, 1e-2);
        /* The bending waves of a sudden release would yield further. */
        bend_to(&b, 1.05 * kept, 300, 1e-2);
        bend_release(&b);
        rig_relax(&b.r, 5e-3, 1e-6, 2000);
        for (uint32_t i = 5; i < BEND_SEGMENTS - 4; i++) {
            double now = bend_component(&b, VBSS_THREAD_VIEW_CURVATURES, i);
            double plastic = bend_component(&b, VBSS_THREAD_VIEW_PLASTIC_CURVATURES, i);
            expect_near(kept / curvature, now / curvature, 0.02);
            expect_near(kept / curvature, plastic / curvature, 0.02);
        }
        expect_near(0.0, rig_energies(&b.r).kinetic, 1e-15);
        bend_end(&b);
    }
}

/* ---- energy */

/* Relative error of the energy balance over a slow loop of loading and unloading. The work is that of
 * the moment by the trapezoidal rule: pure bending needs no force. */
static double balance_error(const vbss_thread_config *c, double h)
{
    const double turns[] = {150.0, -60.0, 40.0};
    bend_rig b;
    bend_begin(&b, c);
    double work = 0.0, moment = 0.0, angle = 0.0, dissipated = 0.0;
    for (size_t i = 0; i < sizeof turns / sizeof turns[0]; i++) {
        uint32_t steps = (uint32_t)(0.4 / h + 0.5);
        double from = b.curvature;
        for (uint32_t k = 1; k <= steps; k++) {
            /* without a jolt at the start */
            double part = 0.5 - 0.5 * vbss_cosine(3.14159265358979 * k / steps);
            bend_to(&b, from + (turns[i] - from) * part, 1, h);
            work += 0.5 * (bend_moment(&b) + moment) * (bend_angle(&b) - angle);
            moment = bend_moment(&b);
            angle = bend_angle(&b);
            vbss_thread_energies e = rig_energies(&b.r);
            assert_true(e.dissipated >= dissipated && e.bending >= 0.0);
            dissipated = e.dissipated;
        }
    }
    double stored = rig_energies(&b.r).total;
    bend_end(&b);
    assert_true(dissipated > 0.5 * work);
    return fabs(work - stored - dissipated) / work;
}

static void work_is_stored_or_dissipated(void **state)
{
    (void)state;
    for (int k = 0; k < 6; k++) {
        vbss_thread_config c = plastic_config(k % 2);
        if (k / 2 > 0) {
            c.relaxation_ratio = 0.5;
            c.relaxation_time = 0.05;
            c.yield_curvature = k / 2 == 1 ? 0.0 : yield;
        }
        double error = balance_error(&c, 2e-3);
        if (!(error < 2e-3)) {
            fail_msg("case %d: error %g", k, error);
        }
    }
}

/* ---- a thread that has been bent in space */

enum { SET_NODES = 31 };

static vbss_thread_config space_config(int bending)
{
    vbss_thread_config c = rig_config(0.03, SET_NODES - 1);
    c.bending = bending;
    c.gravity[1] = 0.0;
    c.yield_curvature = yield;
    c.yield_hardening = hardening;
    return c;
}

/* A helix of curvature 200 and torsion 100 /m, at equal chords. */
static void place_on_helix(rig *r)
{
    vec3 x[SET_NODES];
    const double square = 200.0 * 200.0 + 100.0 * 100.0, speed = sqrt(square);
    const double radius = 200.0 / square, pitch = 100.0 / square;
    for (uint32_t i = 0; i < SET_NODES; i++) {
        double sine, cosine;
        vbss_sincos(speed * 1e-3 * i, &sine, &cosine);
        x[i] = vec3_make(radius * cosine, radius * sine, pitch * speed * 1e-3 * i);
    }
    rig_place(r, x, NULL);
}

/* Free, it takes a set and comes to rest. */
static void make_set_thread(rig *r, int bending)
{
    vbss_thread_config c = space_config(bending);
    c.drag = 500.0;
    c.relaxation_ratio = 0.3;
    c.relaxation_time = 1e-3;
    rig_begin(r, &c);
    place_on_helix(r);
    rig_run(r, 1e-3, 3000);
    assert_true(rig_fastest(r) < 1e-7);
    assert_true(rig_energies(r).dissipated > 0.0);
    vec3 plastic[SET_NODES];
    rig_read(r, VBSS_THREAD_VIEW_PLASTIC_CURVATURES, plastic);
    assert_true(vec3_norm(plastic[15]) > 50.0);
}

static void rotate_all(vec3 *x, quat turn)
{
    for (uint32_t i = 0; i < SET_NODES; i++) {
        x[i] = quat_rotate(turn, x[i]);
    }
}

/* Turned by any angle about any axis, it stays at rest. */
static void turned_thread_has_no_force(void **state)
{
    (void)state;
    const quat turns[] = {
        {0.0, 0.0, 0.0, 1.0}, {0.5, 0.5, 0.5, 0.5}, {0.6, 0.8, 0.0, 0.0}, {-0.28, 0.0, 0.96, 0.0}};
    for (int k = 0; k < 8; k++) {
        rig r;
        vec3 x[SET_NODES], v[SET_NODES];
        make_set_thread(&r, k % 2);
        double before = rig_energies(&r).total, dissipated = rig_energies(&r).dissipated;
        rig_read(&r, VBSS_THREAD_VIEW_POSITIONS, x);
        rotate_all(x, turns[k / 2]);
        memset(v, 0, sizeof v);
        rig_place(&r, x, v);
        expect_near(before, rig_energies(&r).total, 1e-9 * before);
        rig_run(&r, 1e-3, 20);
        assert_true(rig_fastest(&r) < 1e-8);
        expect_near(dissipated, rig_energies(&r).dissipated, 1e-9 * dissipated);
        rig_end(&r);
    }
}

/* Momentum and shape of a set thread that spins freely about an axis for 0.2 s, a third of a turn;
 * the third axis is along the thread in its middle. */
static void spinning_set_thread_keeps_shape_and_momentum(void **state)
{
    (void)state;
    for (int k = 0; k < 6; k++) {
        rig r;
        vec3 x[SET_NODES], v[SET_NODES], plastic[SET_NODES], after[SET_NODES];
        vbss_thread_config c = space_config(k % 2);
        c.yield_curvature = 60.0;
        rig_begin(&r, &c);
        place_on_helix(&r);
        /* Held by strong damping until it has its set. */
        for (int i = 0; i < 400; i++) {
            memset(v, 0, sizeof v);
            rig_place(&r, NULL, v);
            rig_run(&r, 1e-3, 1);
        }
        rig_read(&r, VBSS_THREAD_VIEW_POSITIONS, x);
        vec3 axis = vec3_unit_or(vec3_sub(x[16], x[14]), vec3_zero());
        axis = k / 2 == 0 ? vec3_make(1.0, 0.0, 0.0) : k / 2 == 1 ? vec3_make(0.0, 0.6, 0.8) : axis;
        for (uint32_t i = 0; i < SET_NODES; i++) {
            v[i] = vec3_scale(vec3_cross(axis, vec3_sub(x[i], x[15])), 10.0);
        }
        rig_place(&r, NULL, v);
        rig_read(&r, VBSS_THREAD_VIEW_PLASTIC_CURVATURES, plastic);
        vbss_thread_momentum before = rig_momentum(&r);
        rig_run(&r, 1e-3, 200);
        vbss_thread_momentum now = rig_momentum(&r);
        rig_read(&r, VBSS_THREAD_VIEW_PLASTIC_CURVATURES, after);
        vec3 spin = vec3_load(before.angular);
        double change = vec3_distance(spin, vec3_load(now.angular)) / vec3_norm(spin);
        if (!(change < 2e-3)) {
            fail_msg("case %d: angular momentum changes by %g", k, change);
        }
        for (uint32_t i = 3; i + 3 < SET_NODES; i++) {
            expect_near(vec3_norm(plastic[i]), vec3_norm(after[i]), 0.02 * vec3_norm(plastic[i]));
        }
        rig_end(&r);
    }
}

/* ---- state */

/* A piece keeps what its nodes had, and the thread the rest. */
static void cut_thread_keeps_set(void **state)
{
    (void)state;
    fixture f;
    begin(&f);
    f.config = bend_config(VBSS_THREAD_BENDING_SPLINE);
    f.config.yield_curvature = yield;
    f.config.cut_capacity = 2;
    vec3 x[BEND_SEGMENTS + 1];
    for (uint32_t i = 0; i <= BEND_SEGMENTS; i++) {
        double sine, cosine;
        vbss_sincos(0.15 * i, &sine, &cosine);
        x[i] = vec3_make(5e-3 * sine, 5e-3 * cosine, 0.0);
    }
    f.config.positions = &x[0].x;
    vbss_thread *thread = make(&f), *piece = NULL, *tail = NULL;
    steps(thread, 50, 1e-3);
    vec3 kept[BEND_SEGMENTS + 1];
    for (uint32_t i = 0; i <= BEND_SEGMENTS; i++) {
        kept[i] = vector_at(thread, VBSS_THREAD_VIEW_PLASTIC_CURVATURES, i);
    }
    double dissipated = energies_of(thread).dissipated;
    assert_true(vec3_norm(kept[10]) > 50.0);
    const double l = BEND_LENGTH / BEND_SEGMENTS;
    expect_ok(vbss_thread_cut(thread, 8.4 * l, &piece)); /* inside segment 8 */
    expect_ok(vbss_thread_cut(piece, 5.6 * l, &tail));   /* at node 14 */
    for (uint32_t i = 0; i <= 8; i++) {
        expect_near_vec3(kept[i], vector_at(thread, VBSS_THREAD_VIEW_PLASTIC_CURVATURES, i), 0.0);
    }
    for (uint32_t i = 9; i < 14; i++) {
        expect_near_vec3(kept[i], vector_at(piece, VBSS_THREAD_VIEW_PLASTIC_CURVATURES, i - 8),
                         0.0);
    }
    for (uint32_t i = 15; i <= BEND_SEGMENTS; i++) {
        expect_near_vec3(kept[i], vector_at(tail, VBSS_THREAD_VIEW_PLASTIC_CURVATURES, i - 14),
                         0.0);
    }
    expect_near(dissipated, energies_of(thread).dissipated, 0.0);
    expect_near(0.0, energies_of(piece).dissipated, 0.0);
    steps(thread, 50, 1e-3);
    steps(piece, 50, 1e-3);
    steps(tail, 50, 1e-3);
    assert_true(all_finite(thread) && all_finite(piece) && all_finite(tail));
    end(&f);
}

/* Saved in a bend and restored into another thread, it goes on with the same bits; a thread without
 * memory, or with another yield, refuses the state. */
static void restored_thread_continues_with_same_bits(void **state)
{
    (void)state;
    vbss_thread_config c = plastic_config(VBSS_THREAD_BENDING_SPLINE);
    c.relaxation_ratio = 0.5;
    bend_rig b;
    bend_begin(&b, &c);
    bend_to(&b, 150.0, 100, 1e-3);
    static uint8_t bytes[65536];
    uint64_t count = 0, wanted = 0, hash = 0;
    expect_ok(vbss_thread_save(b.r.thread, bytes, sizeof bytes, &count));
    bend_to(&b, 20.0, 100, 1e-3);
    expect_ok(vbss_thread_get_hash(b.r.thread, &wanted));
    expect_ok(vbss_thread_restore(b.r.thread, bytes, count));
    b.curvature = 150.0;
    bend_to(&b, 20.0, 100, 1e-3);
    expect_ok(vbss_thread_get_hash(b.r.thread, &hash));
    assert_true(wanted == hash);
    for (int k = 0; k < 3; k++) {
        vbss_thread *other = NULL;
        vbss_thread_config d = c;
        d.yield_curvature = k == 0 ? 0.0 : k == 1 ? 61.0 : c.yield_curvature;
        d.relaxation_ratio = k == 0 ? 0.0 : k == 2 ? 0.25 : c.relaxation_ratio;
        expect_ok(vbss_thread_create(b.r.context, &d, &other));
        expect_result(VBSS_ERROR_CORRUPT, vbss_thread_restore(other, bytes, count));
        expect_ok(vbss_thread_destroy(other));
    }
    bend_end(&b);
}

/* A clamp that takes and frees a bent node leaves the set there. */
static void clamp_leaves_set_of_node(void **state)
{
    (void)state;
    vbss_thread_config c = plastic_config(VBSS_THREAD_BENDING_LOCAL);
    bend_rig b;
    bend_begin(&b, &c);
    bend_to(&b, 200.0, 300, 1e-3);
    bend_to(&b, 130.0, 300, 1e-3); /* unloaded: it does not yield */
    double kept = bend_component(&b, VBSS_THREAD_VIEW_PLASTIC_CURVATURES, 10);
    vec3 direction = vec3_sub(rig_position(&b.r, 11), rig_position(&b.r, 9));
    uint32_t clamp = rig_clamp_here(&b.r, 10, direction);
    rig_run(&b.r, 1e-3, 50);
    expect_ok(vbss_thread_detach(b.r.thread, clamp));
    rig_run(&b.r, 1e-3, 50);
    expect_near(kept, bend_component(&b, VBSS_THREAD_VIEW_PLASTIC_CURVATURES, 10), 0.02 * kept);
    bend_end(&b);
}

/* ---- configurations */

static void memory_refuses_what_it_does_not_work_with(void **state)
{
    (void)state;
    fixture f;
    begin(&f);
    for (int k = 0; k < 6; k++) {
        vbss_thread_config c = f.config;
        c.yield_curvature = k % 2 == 0 ? 100.0 : 0.0;
        c.relaxation_ratio = k % 2 == 0 ? 0.0 : 1.0;
        c.method = k / 2 == 0 ? VBSS_METHOD_VBLAST : VBSS_METHOD_IMPLICIT;
        c.mesh = k / 2 == 1 ? VBSS_THREAD_MESH_ADAPTIVE : VBSS_THREAD_MESH_FIXED;
        c.rest_curvature = k / 2 == 2 ? 20.0 : 0.0;
        vbss_thread *thread = NULL;
        expect_result(VBSS_ERROR_INCOMPATIBLE, vbss_thread_create(f.context, &c, &thread));
        assert_null(thread);
    }
    end(&f);
}

/* Parameters of a branch that is off do not change a bit. */
static void memory_that_is_off_changes_no_bits(void **state)
{
    (void)state;
    uint64_t hashes[2];
    for (int k = 0; k < 2; k++) {
        fixture f;
        begin(&f);
        f.config.yield_hardening = k == 0 ? 0.0 : 0.5;
        f.config.relaxation_time = k == 0 ? 1.0 : 0.01;
        vbss_thread *thread = make(&f);
        hold(thread, VBSS_THREAD_ATTACHMENT_PIN, 0, vec3_zero());
        steps(thread, 100, 1e-3);
        hashes[k] = hash_of(thread);
        assert_int_equal(0, view_of(thread, VBSS_THREAD_VIEW_PLASTIC_CURVATURES).count);
        end(&f);
    }
    assert_true(hashes[0] == hashes[1]);
}

int test_bending_memory(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(bend_below_yield_is_elastic),
        cmocka_unit_test(moment_follows_bilinear_loop),
        cmocka_unit_test(loop_does_not_depend_on_step),
        cmocka_unit_test(released_thread_keeps_residual_curvature),
        cmocka_unit_test(work_is_stored_or_dissipated),
        cmocka_unit_test(turned_thread_has_no_force),
        cmocka_unit_test(spinning_set_thread_keeps_shape_and_momentum),
        cmocka_unit_test(cut_thread_keeps_set),
        cmocka_unit_test(restored_thread_continues_with_same_bits),
        cmocka_unit_test(clamp_leaves_set_of_node),
        cmocka_unit_test(memory_refuses_what_it_does_not_work_with),
        cmocka_unit_test(memory_that_is_off_changes_no_bits),
    };
    return cmocka_run_group_tests_name("thread.bending_memory", tests, NULL, NULL);
}
