/* A thread clamped at one end, bent by its weight or by a load at its tip, against the elastica. */
#include <math.h>

#include "thread/elastica.h"
#include "thread/reference.h"
#include "thread/rig.h"

static const double pi = 0x1.921fb54442d18p1;

/* ---- published solutions, and bounds of the errors with 60 segments, relative or in lengths */

static const struct {
    double parameter;                    /* weight length^2 / EI */
    double x, drop, degrees, curvature;  /* degrees 0: not published */
    double spline, local, angle, torque; /* tip; tip; angle and torque of both */
} heavy[] = {
    {0.1, .99991073, .01249844, .95484, .049997, 4e-10, 4e-6, 7e-8, 8e-5},
    {1.0, .99124640, .12347140, 9.46042, .496933, 5e-9, 4e-5, 1.2e-6, 8e-5},
    {2.0, .96689295, .23850658, 18.42597, .976743, 2.5e-8, 8e-5, 6e-6, 9e-5},
    {5.0, .84665718, .49590504, 39.93543, 2.226893, 2e-7, 2e-4, 4e-5, 1.5e-4},
    {10.0, .65635376, .70019972, 60.31201, 3.742191, 7e-7, 3.5e-4, 8e-5, 3e-4},
    {20.0, .44523205, .82988144, 76.74778, 5.761533, 1.6e-6, 5e-4, 5e-5, 7e-4},
    {50.0, .24501476, .90791712, 87.45932, 9.528469, 4e-6, 5.5e-4, 3e-5, 1.4e-3},
    {100.0, .15922338, .93752394, 89.61675, 13.693239, 6e-6, 5.5e-4, 3e-5, 2e-3},
    {211.896, .10408128, .95805787, 0.0, 20.1499, 8e-6, 5e-4, 8e-6, 2e-3},
    {500.0, .06589004, .97311700, 89.99988, 31.194823, 1.5e-5, 3.5e-4, 2e-7, 1.5e-3},
};
enum { HEAVY = sizeof heavy / sizeof heavy[0] };

/* Mattiasson 1981: how far the tip is drawn back and down, and its angle. */
static const struct {
    double parameter; /* load length^2 / EI */
    double back, down, angle;
    double tip, turned, torque; /* bounds, SPLINE */
} loaded[] = {
    {0.2, .00264655, .06636448, .09963616, 2e-10, 2e-10, 1e-9},
    {1.0, .05643324, .30172077, .46135195, 1.6e-8, 1.2e-8, 5e-9},
    {2.0, .16064172, .49345748, .78174983, 8e-8, 5e-8, 4e-8},
    {5.0, .38762836, .71379152, 1.21536812, 3e-7, 1.2e-7, 3e-7},
    {10.0, .55499560, .81060902, 1.43028554, 8e-7, 1.4e-7, 1e-6},
};
enum { LOADED = sizeof loaded / sizeof loaded[0] };

/* ---- the thread */

typedef struct tip {
    double x, drop, angle, moment;
} tip;

/* EI from the parameter. Stiffer along than silk: the elastica does not stretch. */
static vbss_thread_config heavy_thread(double parameter, uint32_t segments,
                                       vbss_thread_bending bending)
{
    vbss_thread_config c = rig_config(0.15, segments);
    c.bending = bending;
    c.axial_stiffness = 1e5;
    c.bending_stiffness = -c.linear_density * c.gravity[1] * pow(c.length, 3) / parameter;
    return c;
}

static tip relaxed(vbss_thread_config c, double load)
{
    double mass = c.linear_density * c.length;
    /* Drag that damps the slowest motion critically, and steps that follow it. */
    double rate = sqrt(12.4 * c.bending_stiffness / (mass * pow(c.length, 3)) -
                       1.4 * c.gravity[1] / c.length + 1.4 * load / (mass * c.length));
    c.drag = 2.0 * rate;
    c.spectral_radius = 0.0;
    rig r;
    rig_begin(&r, &c);
    uint32_t clamp = rig_clamp(&r, 0, vec3_zero(), vec3_make(1.0, 0.0, 0.0));
    rig_force(&r, r.nodes - 1, vec3_make(0.0, -load, 0.0));
    rig_relax(&r, fmin(0.5 / rate, 0.1), 1e-11 * rate * c.length, 200);
    vec3 a = rig_position(&r, r.nodes - 3), b = rig_position(&r, r.nodes - 2), end = rig_tip(&r);
    double last = atan2(b.y - end.y, end.x - b.x), before = atan2(a.y - b.y, b.x - a.x);
    /* Beyond the last chord's middle the angle changes as a square, or a cube, of what is left. */
    double angle = last + (last - before) / (load > 0.0 ? 6.0 : 14.0);
    tip found = {end.x, -end.y, angle, rig_reaction_torque(&r, clamp).z};
    rig_end(&r);
    return found;
}

static double tip_error(const elastica *e, tip t)
{
    return hypot(t.x - e->x, t.drop - e->drop) / e->length;
}

static double error_of(vbss_thread_config c, double load)
{
    elastica e = elastica_solve(&c, load);
    return tip_error(&e, relaxed(c, load));
}

/* ---- tests */

static void reference_matches_publication(void **state)
{
    (void)state;
    for (int i = 0; i < HEAVY; i++) {
        vbss_thread_config c = heavy_thread(heavy[i].parameter, 1, VBSS_THREAD_BENDING_LOCAL);
        elastica e = elastica_solve(&c, 0.0);
        expect_near(heavy[i].x, e.x / e.length, 6e-9);
        expect_near(heavy[i].drop, e.drop / e.length, 6e-9);
        if (heavy[i].degrees > 0.0) {
            expect_near(heavy[i].degrees, e.angle * 180.0 / pi, 6e-6);
        }
        expect_near(heavy[i].curvature, e.moment * e.length / e.bending, 6e-5);
    }
    for (int i = 0; i < LOADED; i++) {
        vbss_thread_config c = rig_config(0.15, 1);
        c.gravity[1] = 0.0;
        elastica e =
            elastica_solve(&c, loaded[i].parameter * c.bending_stiffness / pow(c.length, 2));
        expect_near(loaded[i].back, 1.0 - e.x / e.length, 6e-9);
        expect_near(loaded[i].down, e.drop / e.length, 6e-9);
        expect_near(loaded[i].angle, e.angle, 6e-9);
    }
}

static void heavy_cantilever_matches_elastica(void **state)
{
    (void)state;
    for (int i = 0; i < 2 * HEAVY; i++) {
        int row = i / 2;
        vbss_thread_bending bending =
            i % 2 == 0 ? VBSS_THREAD_BENDING_SPLINE : VBSS_THREAD_BENDING_LOCAL;
        vbss_thread_config c = heavy_thread(heavy[row].parameter, 60, bending);
        elastica e = elastica_solve(&c, 0.0);
        tip t = relaxed(c, 0.0);
        bool spline = bending == VBSS_THREAD_BENDING_SPLINE;
        expect_near(0.0, tip_error(&e, t), spline ? heavy[row].spline : heavy[row].local);
        expect_near(e.angle, t.angle, heavy[row].angle);
        /* Weight acts on nodes: its moment is off by length^2 / 12 of a segment at the clamp. */
        expect_near(1.0, t.moment / e.moment, heavy[row].torque);
    }
}

static void tip_load_matches_elastica(void **state)
{
    (void)state;
    for (int i = 0; i < LOADED; i++) {
        vbss_thread_config c = heavy_thread(1.0, 60, VBSS_THREAD_BENDING_SPLINE);
        c.gravity[1] = 0.0;
        double load = loaded[i].parameter * c.bending_stiffness / pow(c.length, 2);
        elastica e = elastica_solve(&c, load);
        tip t = relaxed(c, load);
        expect_near(0.0, tip_error(&e, t), loaded[i].tip);
        expect_near(e.angle, t.angle, loaded[i].turned);
        expect_near(1.0, t.moment / e.moment, loaded[i].torque);
    }
}

/* The power of the segment length with which the error falls from 15 to 120 segments. */
static double order_of(double parameter, vbss_thread_bending bending, bool at_the_tip)
{
    double error[2];
    for (int fine = 0; fine < 2; fine++) {
        vbss_thread_config c = heavy_thread(at_the_tip ? 1.0 : parameter, fine ? 120 : 15, bending);
        double load = at_the_tip ? parameter * c.bending_stiffness / pow(c.length, 2) : 0.0;
        c.gravity[1] = at_the_tip ? 0.0 : c.gravity[1];
        error[fine] = error_of(c, load);
    }
    return log2(error[0] / error[1]) / 3.0;
}

static void spline_bending_is_fourth_order(void **state)
{
    (void)state;
    assert_true(order_of(0.1, VBSS_THREAD_BENDING_SPLINE, false) >= 3.5);
    assert_true(order_of(1.0, VBSS_THREAD_BENDING_SPLINE, false) >= 3.5);
    assert_true(order_of(1.0, VBSS_THREAD_BENDING_SPLINE, true) >= 3.5);
}

static void local_bending_is_second_order(void **state)
{
    (void)state;
    assert_true(order_of(1.0, VBSS_THREAD_BENDING_LOCAL, false) >= 1.85);
    assert_true(order_of(2.0, VBSS_THREAD_BENDING_LOCAL, false) >= 1.85);
    assert_true(order_of(1.0, VBSS_THREAD_BENDING_LOCAL, true) >= 1.85);
}

static void paper_thread_sag(void **state)
{
    (void)state;
    const double bounds[2] = {1.0e-5, 4e-7};
    for (int fine = 0; fine < 2; fine++) {
        tip t = relaxed(rig_config(0.15, fine ? 120 : 30), 0.0);
        expect_near(0.0, hypot(t.x - hanging_tip.x, t.drop + hanging_tip.y), bounds[fine]);
    }
}

static void clamp_at_either_end_is_equivalent(void **state)
{
    (void)state;
    for (int i = 0; i < 2; i++) {
        vbss_thread_config c = rig_config(0.15, 20);
        c.bending = i == 0 ? VBSS_THREAD_BENDING_SPLINE : VBSS_THREAD_BENDING_LOCAL;
        tip forward = relaxed(c, 0.0);
        c.start[0] = 0.15;
        c.direction[0] = -1.0;
        c.drag = 20.0;
        c.spectral_radius = 0.0;
        rig r;
        rig_begin(&r, &c);
        uint32_t clamp = rig_clamp(&r, 20, vec3_zero(), vec3_make(-1.0, 0.0, 0.0));
        rig_relax(&r, 0.05, 1e-11, 200);
        expect_near_vec3(vec3_make(forward.x, -forward.drop, 0.0), rig_position(&r, 0), 1e-10);
        expect_near(1.0, rig_reaction_torque(&r, clamp).z / forward.moment, 1e-8);
        rig_end(&r);
    }
}

/* ---- unequal rest lengths */

typedef uint32_t (*division)(uint32_t refinement, double *rest_lengths);
enum { MAX_COUNT = 400 };

/* Fine at the clamp, 1 to 8. */
static uint32_t graded(uint32_t refinement, double *rest_lengths)
{
    uint32_t count = 0;
    double finest = 1e-3 / refinement;
    expect_ok(vbss_thread_grade_lengths(0.15, 0.0, finest, 8.0 * finest, pow(1.2, 1.0 / refinement),
                                        rest_lengths, MAX_COUNT, &count));
    return count;
}

/* From 3 mm to 12 mm at one node. */
static uint32_t abrupt(uint32_t refinement, double *rest_lengths)
{
    uint32_t half = 10 * refinement;
    for (uint32_t k = 0; k < half; k++) {
        rest_lengths[k] = 3e-3 / refinement;
        rest_lengths[half + k] = 12e-3 / refinement;
    }
    return 2 * half;
}

/* Long and short in turn: nowhere smooth. */
static uint32_t alternating(uint32_t refinement, double *rest_lengths)
{
    uint32_t pairs = 10 * refinement;
    for (uint32_t k = 0; k < pairs; k++) {
        rest_lengths[2 * (size_t)k] = 12e-3 / refinement;
        rest_lengths[2 * (size_t)k + 1] = 3e-3 / refinement;
    }
    return 2 * pairs;
}

/* Error with the division four times as fine, and the order from there. */
static double unequal_error(division divide, vbss_thread_bending bending, double *order)
{
    double error[2], rest_lengths[MAX_COUNT];
    for (uint32_t fine = 0; fine < 2; fine++) {
        uint32_t count = divide(fine ? 4 : 1, rest_lengths);
        vbss_thread_config c = heavy_thread(5.0, count, bending);
        c.rest_lengths = rest_lengths;
        error[fine] = error_of(c, 0.0);
    }
    *order = 0.5 * log2(error[0] / error[1]);
    return error[1];
}

static void uneven_segments_sag_as_even(void **state)
{
    (void)state;
    const struct {
        division divide;
        vbss_thread_bending bending;
        double error, order;
    } cases[] = {
        {graded, VBSS_THREAD_BENDING_SPLINE, 5e-8, 3.7},
        {abrupt, VBSS_THREAD_BENDING_SPLINE, 3e-6, 2.7},
        {alternating, VBSS_THREAD_BENDING_SPLINE, 1.2e-4, 1.7},
        {graded, VBSS_THREAD_BENDING_LOCAL, 7e-5, 1.9},
        {abrupt, VBSS_THREAD_BENDING_LOCAL, 1.5e-4, 1.9},
        {alternating, VBSS_THREAD_BENDING_LOCAL, 2.2e-4, 1.6},
    };
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        double order;
        expect_near(0.0, unequal_error(cases[i].divide, cases[i].bending, &order), cases[i].error);
        assert_true(order >= cases[i].order);
    }
}

int test_cantilever(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(reference_matches_publication),
        cmocka_unit_test(heavy_cantilever_matches_elastica),
        cmocka_unit_test(tip_load_matches_elastica),
        cmocka_unit_test(spline_bending_is_fourth_order),
        cmocka_unit_test(local_bending_is_second_order),
        cmocka_unit_test(paper_thread_sag),
        cmocka_unit_test(clamp_at_either_end_is_equivalent),
        cmocka_unit_test(uneven_segments_sag_as_even),
    };
    return cmocka_run_group_tests_name("thread.cantilever", tests, NULL, NULL);
}
