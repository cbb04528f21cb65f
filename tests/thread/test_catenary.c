/* Threads that do not resist bending: the catenary, and what hangs straight down. */
#include <math.h>

#include "thread/rig.h"

enum { MAX_NODES = 161 };

/* 0.15 m between two pins 0.1 m apart: parameter and sag. */
static const double span = 0.1, length = 0.15, a = 0.030823647, sag = 0.050263326;

typedef struct errors {
    double sag, pull, end, shape,
        tension; /* relative; of tensions two segments or more from the pins */
} errors;

static vec3 catenary(double s)
{
    double from_middle = s - 0.5 * length;
    double x = 0.5 * span + a * asinh(from_middle / a);
    return vec3_make(x, hypot(a, from_middle) - hypot(a, 0.5 * length), 0.0);
}

/* Pinned at both ends, let go from a V. */
static void hang(rig *r, uint32_t segments, vbss_thread_bending bending, uint32_t pins[2])
{
    vbss_thread_config c = rig_config(length, segments);
    c.bending = bending;
    c.bending_stiffness = 0.0;
    c.drag = 30.0;
    c.spectral_radius = 0.0;
    vec3 x[MAX_NODES];
    double across = span / segments, down = sqrt(length * length - span * span) / segments;
    for (uint32_t i = 0; i <= segments; i++) {
        uint32_t below = i < segments - i ? i : segments - i;
        x[i] = vec3_make(across * i, -down * below, 0.0);
    }
    rig_begin(r, &c);
    rig_place(r, x, NULL);
    pins[0] = rig_pin_here(r, 0);
    pins[1] = rig_pin_here(r, segments);
    rig_relax(r, 0.05, 1e-10, 100);
}

static errors hang_and_compare(uint32_t segments, vbss_thread_bending bending)
{
    rig r;
    uint32_t pins[2];
    hang(&r, segments, bending, pins);
    const double weight = 6.4e-5 * 9.81; /* of a metre */
    vec3 left = rig_reaction_force(&r, pins[0]), right = rig_reaction_force(&r, pins[1]);
    /* Equal on both sides, and together the weight. */
    expect_near_vec3(vec3_make(-left.x, left.y, 0.0), right, 1e-15);
    expect_near(0.5 * length * weight, left.y, 1e-15);
    errors e = {.sag = fabs(-rig_position(&r, segments / 2).y / sag - 1.0),
                .pull = fabs(right.x / (weight * a) - 1.0),
                .end = fabs(vec3_norm(right) / (weight * hypot(a, 0.5 * length)) - 1.0)};
    for (uint32_t i = 0; i <= segments; i++) {
        vec3 off = vec3_sub(rig_position(&r, i), catenary(length * i / segments));
        e.shape = fmax(e.shape, vec3_norm(off) / length);
    }
    for (uint32_t i = 2; i + 2 < segments; i++) {
        double wanted = weight * hypot(a, length * (i + 0.5) / segments - 0.5 * length);
        e.tension = fmax(e.tension, fabs(rig_tension(&r, i) / wanted - 1.0));
    }
    rig_end(&r);
    return e;
}

static void pinned_chain_is_catenary(void **state)
{
    (void)state;
    assert_true(fabs(2.0 * a * sinh(0.5 * span / a) / length - 1.0) < 1e-7);
    const struct {
        uint32_t segments;
        vbss_thread_bending bending;
        errors bound;
    } cases[] = {
        {20, VBSS_THREAD_BENDING_SPLINE, {3e-4, 3e-4, 6e-5, 2e-4, 6e-3}},
        {80, VBSS_THREAD_BENDING_SPLINE, {1.5e-6, 1.5e-6, 4e-7, 1.2e-5, 5e-4}},
        {20, VBSS_THREAD_BENDING_LOCAL, {2.5e-3, 9e-4, 1.3e-4, 8e-4, 1.3e-2}},
        {80, VBSS_THREAD_BENDING_LOCAL, {1.5e-4, 5e-5, 7e-6, 5e-5, 8e-4}},
    };
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        errors e = hang_and_compare(cases[i].segments, cases[i].bending);
        expect_near(0.0, e.sag, cases[i].bound.sag);
        expect_near(0.0, e.pull, cases[i].bound.pull);
        expect_near(0.0, e.end, cases[i].bound.end);
        expect_near(0.0, e.shape, cases[i].bound.shape);
        expect_near(0.0, e.tension, cases[i].bound.tension);
    }
}

/* Along any line: each segment carries what hangs below it, and stretches by that over EA. */
static void hanging_thread_tension_is_weight_below(void **state)
{
    (void)state;
    const vec3 down = {2.0, -6.0, 3.0}; /* 7 m/s^2 */
    vbss_thread_config c = rig_config(length, 12);
    vec3_store(c.gravity, down);
    vec3_store(c.direction, down);
    c.bending = VBSS_THREAD_BENDING_SPLINE;
    c.drag = 100.0;
    c.spectral_radius = 0.0;
    rig r;
    rig_begin(&r, &c);
    uint32_t pin = rig_pin_here(&r, 0);
    rig_mass(&r, 12, 0.5);
    rig_relax(&r, 0.05, 1e-12, 200);
    double segment = c.linear_density * length / 12.0 * 7.0; /* weight of one */
    for (uint32_t i = 0; i < 12; i++) {
        double below = 0.5 * 7.0 + segment * (11.5 - i);
        /* The mass of the segments next to the ends is spread over three nodes. */
        bool inner = i >= 2 && i < 10;
        expect_near(below, rig_tension(&r, i), inner ? 5e-9 : 0.2 * segment);
    }
    double total = 0.5 * 7.0 + 12.0 * segment;
    expect_near_vec3(vec3_scale(down, -total / 7.0), rig_reaction_force(&r, pin), 1e-9);
    double longer = (0.5 * 7.0 + 6.0 * segment) * length / c.axial_stiffness;
    expect_near(length + longer, vec3_norm(rig_tip(&r)), 1e-12);
    rig_end(&r);
}

int test_catenary(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(pinned_chain_is_catenary),
        cmocka_unit_test(hanging_thread_tension_is_weight_below),
    };
    return cmocka_run_group_tests_name("thread.catenary", tests, NULL, NULL);
}
