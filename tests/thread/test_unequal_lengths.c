/* A mesh whose neighbouring segments differ by a factor of 20 has the tension of an even one: the force across a segment
 * that statics demands. */
#include <math.h>

#include "thread/rig.h"
#include "thread/thread.h"

enum { SEGMENTS = 60 };

static const double length = 0.15, span = 0.1;

typedef enum mesh { EVEN, ALTERNATING, RANDOM } mesh;

static void make_lengths(mesh kind, uint64_t seed, double rest[SEGMENTS])
{
    vbss_random random;
    double sum = 0.0;
    vbss_random_seed(&random, seed, 0);
    for (int i = 0; i < SEGMENTS; i++) {
        double exponent = kind == EVEN          ? 0.0
                          : kind == ALTERNATING ? (double)(i % 2)
                                                : vbss_random_uniform(&random);
        rest[i] = pow(20.0, exponent);
        sum += rest[i];
    }
    for (int i = 0; i < SEGMENTS; i++) {
        rest[i] *= length / sum;
    }
}

/* Hangs between two pins at the same height, at rest. */
static void hang(rig *r, const double rest[SEGMENTS], vbss_thread_bending bending)
{
    double x[SEGMENTS + 1][3], arc = 0.0;
    vbss_thread_config c = rig_config(length, SEGMENTS);
    c.rest_lengths = rest;
    c.bending = bending;
    c.drag = 30.0;
    c.spectral_radius = 0.0;
    c.positions = x[0];
    double down = sqrt(length * length - span * span);
    for (int i = 0; i <= SEGMENTS; i++) {
        double share = arc / length;
        x[i][0] = span * share;
        x[i][1] = -down * fmin(share, 1.0 - share);
        x[i][2] = 0.0;
        arc += i < SEGMENTS ? rest[i] : 0.0;
    }
    rig_begin(r, &c);
}

typedef struct shape {
    double sag;
    double tension[SEGMENTS], middle[SEGMENTS]; /* N; arc length, m */
    double lowest;                              /* smallest tension, N */
    double heaviest;                            /* weight of the longest segment, N */
} shape;

static shape measure(mesh kind, uint64_t seed, vbss_thread_bending bending)
{
    rig r;
    shape s = {.lowest = 1.0};
    double rest[SEGMENTS], arc = 0.0;
    make_lengths(kind, seed, rest);
    hang(&r, rest, bending);
    uint32_t pin = rig_pin_here(&r, 0);
    rig_pin_here(&r, SEGMENTS);
    rig_relax(&r, 0.05, 1e-9, 400);
    thread_object *t;
    expect_ok(vbss_thread_open(r.thread, &t));
    vec3 force = vec3_neg(rig_reaction_force(&r, pin)); /* of what is behind on what is before */
    for (uint32_t i = 0; i < SEGMENTS; i++) {
        vec3 chord = vec3_sub(rig_position(&r, i + 1), rig_position(&r, i));
        force = vec3_add_scaled(force, t->mass[i], vec3_make(0.0, 9.81, 0.0));
        double wanted = vec3_dot(force, vec3_unit_or(chord, vec3_zero()));
        s.tension[i] = rig_tension(&r, i);
        s.middle[i] = arc + 0.5 * rest[i];
        arc += rest[i];
        expect_near(wanted, s.tension[i], 1e-9);
        s.sag = fmax(s.sag, -rig_position(&r, i).y);
        s.lowest = fmin(s.lowest, s.tension[i]);
        s.heaviest = fmax(s.heaviest, 9.81 * t->config.linear_density * rest[i]);
    }
    rig_end(&r);
    return s;
}

/* Tension of an even mesh at that arc length. */
static double tension_at(const shape *even, double arc)
{
    double place = arc * SEGMENTS / length - 0.5;
    int i = place < 0.0 ? 0 : place > SEGMENTS - 2.0 ? SEGMENTS - 2 : (int)place;
    return even->tension[i] + (place - i) * (even->tension[i + 1] - even->tension[i]);
}

static void unequal_mesh_has_tension_of_equal_one(void **state)
{
    (void)state;
    for (int bending = VBSS_THREAD_BENDING_SPLINE; bending <= VBSS_THREAD_BENDING_LOCAL;
         bending++) {
        shape even = measure(EVEN, 0, bending);
        for (uint64_t seed = 0; seed < 6; seed++) {
            shape s = measure(seed == 0 ? ALTERNATING : RANDOM, seed, bending);
            double worst = 0.0;
            for (int i = 0; i < SEGMENTS; i++) {
                worst = fmax(worst, fabs(s.tension[i] - tension_at(&even, s.middle[i])));
            }
            assert_true(worst < 0.5 * s.heaviest); /* where loads are lumped differently */
            expect_near(even.lowest, s.lowest, 0.01 * even.lowest);
            expect_near(even.sag, s.sag, 1e-3 * even.sag);
        }
    }
}

/* Hanging straight down: the weight below, whatever the lengths. */
static void hanging_thread_carries_weight_below(void **state)
{
    (void)state;
    for (uint64_t seed = 0; seed < 6; seed++) {
        rig r;
        double rest[SEGMENTS], arc = 0.0;
        thread_object *t;
        make_lengths(seed == 0 ? ALTERNATING : RANDOM, seed, rest);
        vbss_thread_config c = rig_config(length, SEGMENTS);
        c.rest_lengths = rest;
        c.direction[0] = 0.0;
        c.direction[1] = -1.0;
        c.drag = 30.0;
        rig_begin(&r, &c);
        rig_pin_here(&r, 0);
        rig_run(&r, 1e-3, 2000);
        expect_ok(vbss_thread_open(r.thread, &t));
        double below = 0.0;
        for (uint32_t i = 0; i <= SEGMENTS; i++) {
            below += t->mass[i] * 9.81;
        }
        for (uint32_t i = 0; i < SEGMENTS; i++) {
            below -= t->mass[i] * 9.81;
            arc += rest[i];
            expect_near(below, rig_tension(&r, i), 1e-12);
            /* The weight of half a segment and its neighbours at most from the continuous one. */
            double wanted = c.linear_density * 9.81 * (length - arc + 0.5 * rest[i]);
            expect_near(wanted, rig_tension(&r, i), c.linear_density * 9.81 * 2e-3);
        }
        rig_end(&r);
    }
}

int test_unequal_lengths(void)
{
    const struct CMUnitTest tests[] = {
        harness_test(unequal_mesh_has_tension_of_equal_one),
        harness_test(hanging_thread_carries_weight_below),
    };
    return cmocka_run_group_tests_name("thread.unequal_lengths", tests, NULL, NULL);
}
