/* A thread pulled over a fixed cylinder, loaded at its other end: the law of the rope, T2 = T1 exp(mu angle).
 *
 * Where the thread is straight its tension is larger by EI / (2 R^2) than where the cylinder bends it, as
 * the pull and the energy of bending keep their sum along a rod that nothing rubs; the law is that of the
 * latter. For more than half a turn the thread is a helix, so that strands do not touch: it bends by
 * cos^2 / R over a length angle R / cos, so the angle counts times the cosine. */
#include <math.h>

#include "scene/rig.h"

enum { MAX_NODES = 400 };

static const double pi = 0x1.921fb54442d18p1;
static const double radius = 2.5e-3, thread_radius = 0.125e-3, bending_stiffness = 1e-8;
static const double load = 0.1, load_length = 15e-3,
                    pull_length = 10e-3; /* N; straight, at the start */

typedef struct capstan {
    double turns, fineness; /* length of segments over the cylinder's radius */
    double friction, axial_stiffness, speed;
    vbss_thread_bending bending;
    /* what follows */
    double angle; /* that counts */
    double cosine, contact_length;
    vec3 loaded, pulled; /* where the ends are pulled to */
    double segment;
    uint32_t end, weight; /* attachments */
    vec3 at;              /* of the pulled end */
    scene_rig rig;
} capstan;

/* ---- making */

/* Touching with its smooth points, as long as it is. */
static void wind(const capstan *c, uint32_t segments, double slope, vec3 *x, double *rest)
{
    double middle = radius + thread_radius, turn = c->segment * c->cosine / middle;
    double outside = middle / (11.0 / 12.0 + cos(turn) / 12.0);
    for (uint32_t i = 0; i <= segments; i++) {
        double s = i * c->segment - load_length, on = fmin(fmax(s, 0.0), c->contact_length);
        double angle = on * c->cosine / middle;
        vec3 tangent = vec3_make(sin(angle) * c->cosine, cos(angle) * c->cosine, slope * c->cosine);
        vec3 point = vec3_make(-outside * cos(angle), outside * sin(angle), slope * middle * angle);
        x[i] = vec3_add_scaled(point, s - on, tangent);
    }
    for (uint32_t i = 0; i < segments; i++) {
        double s = (i + 0.5) * c->segment - load_length;
        rest[i] = vec3_distance(x[i], x[i + 1]);
        if (c->bending == VBSS_THREAD_BENDING_SPLINE && s > 0.0 && s < c->contact_length) {
            rest[i] *= 1.0 + turn * turn * c->cosine * c->cosine / 24.0; /* of the arc */
        }
    }
}

static void begin(capstan *c)
{
    double whole = 2.0 * pi * c->turns, middle = radius + thread_radius;
    double slope = c->turns > 0.5 ? 1e-3 / (2.0 * pi * middle) : 0.0; /* 1 mm a turn */
    c->cosine = 1.0 / sqrt(1.0 + slope * slope);
    c->contact_length = whole * middle / c->cosine;
    c->angle = whole * c->cosine;
    c->loaded = vec3_make(0.0, -c->cosine, -slope * c->cosine);
    c->pulled = vec3_make(sin(whole) * c->cosine, cos(whole) * c->cosine, slope * c->cosine);
    double length = load_length + c->contact_length + pull_length;
    uint32_t segments = (uint32_t)ceil(length / (c->fineness * radius));
    c->segment = length / segments;
    vec3 x[MAX_NODES];
    double rest[MAX_NODES];
    assert_true(segments < MAX_NODES);
    wind(c, segments, slope, x, rest);

    vbss_scene_config scene = scene_rig_config();
    vbss_thread_config thread = rig_config(1.0, segments);
    thread.rest_lengths = rest;
    thread.positions = &x[0].x;
    thread.bending = c->bending;
    thread.axial_stiffness = c->axial_stiffness;
    thread.gravity[1] = 0.0;
    thread.drag = 100.0; /* of the straight part: 2e-6 N */
    scene_rig_begin(&c->rig, &scene, &thread);
    vbss_scene_capsule capsule;
    vbss_scene_rigid_config body =
        scene_rig_capsule(VBSS_SCENE_RIGID_DRIVEN, &capsule, vec3_make(0.0, 0.0, -0.02),
                          vec3_make(0.0, 0.0, 0.02), radius);
    body.friction = c->friction;
    scene_rig_add(&c->rig, &body);
    c->weight = rig_force(&c->rig.thread, 0, vec3_zero());
    c->end = rig_pin_here(&c->rig.thread, segments);
    c->at = x[segments];
    for (int i = 1; i <= 50; i++) {
        rig_move(&c->rig.thread, c->weight, vec3_scale(c->loaded, load * i / 50.0));
        scene_rig_run(&c->rig, 1e-3, 1);
    }
}

/* ---- pulling */

static double ratio(capstan *c)
{
    double bent = c->cosine * c->cosine / (radius + thread_radius);
    double less = 0.5 * bending_stiffness * bent * bent;
    double pull = vec3_dot(rig_reaction_force(&c->rig.thread, c->end), c->pulled);
    return log((pull - less) / (load - less));
}

typedef struct ratios {
    double mean, smallest, largest; /* of log(T2 / T1) */
} ratios;

/* Over so many lengths of a segment, as ripples have that period. */
static ratios pull(capstan *c, double segments)
{
    const double h = 1e-3;
    uint32_t steps = (uint32_t)(segments * c->segment / (fabs(c->speed) * h) + 0.5);
    ratios r = {0.0, 1e3, -1e3};
    for (uint32_t i = 0; i < steps; i++) {
        c->at = vec3_add_scaled(c->at, c->speed * h, c->pulled);
        rig_move(&c->rig.thread, c->end, c->at);
        scene_rig_run(&c->rig, h, 1);
        double now = ratio(c);
        r.mean += now / steps;
        r.smallest = fmin(r.smallest, now);
        r.largest = fmax(r.largest, now);
    }
    return r;
}

static capstan half_turn(double friction)
{
    capstan c = {.turns = 0.5,
                 .fineness = 0.25,
                 .friction = friction,
                 .axial_stiffness = 4000.0,
                 .speed = 0.01,
                 .bending = VBSS_THREAD_BENDING_SPLINE};
    return c;
}

/* The elastic thread slides everywhere after one or two millimetres. */
static double start_segments(const capstan *c)
{
    return ceil(2e-3 / c->segment);
}

static double pulled_over(capstan *c)
{
    begin(c);
    (void)pull(c, start_segments(c));
    ratios r = pull(c, 4.0);
    scene_rig_end(&c->rig);
    return r.mean;
}

static void check_law(vbss_thread_bending bending, double tolerance)
{
    const double turns[] = {0.5, 1.0, 2.0}, stiffness[] = {427.0, 4000.0};
    for (int i = 0; i < 18; i++) {
        capstan c = half_turn(0.1 * (1 + i % 3));
        c.turns = turns[i / 3 % 3];
        c.axial_stiffness = stiffness[i / 9];
        c.bending = bending;
        double got = pulled_over(&c);
        expect_near(1.0, got / (c.friction * c.angle), tolerance);
    }
}

static void tension_follows_capstan_equation(void **state)
{
    (void)state;
    check_law(VBSS_THREAD_BENDING_SPLINE, 0.01);
}

static void tension_follows_capstan_equation_with_local_bending(void **state)
{
    (void)state;
    check_law(VBSS_THREAD_BENDING_LOCAL, 0.005);
}

static void capstan_error_is_second_order_in_segment_length(void **state)
{
    (void)state;
    const double fineness[] = {0.85, 0.5, 0.25, 0.125}, tolerance[] = {0.03, 0.022, 0.006, 0.0018};
    for (int b = 0; b < 2; b++) {
        for (int i = 0; i < 4; i++) {
            capstan c = half_turn(0.3);
            c.turns = 1.5;
            c.fineness = fineness[i];
            c.bending = b == 0 ? VBSS_THREAD_BENDING_SPLINE : VBSS_THREAD_BENDING_LOCAL;
            double got = pulled_over(&c);
            expect_near(1.0, got / (c.friction * c.angle), tolerance[i]);
        }
    }
}

/* Ten times as fast too: nothing brakes but friction. */
static void frictionless_tension_is_constant(void **state)
{
    (void)state;
    const double speeds[] = {0.01, 0.1};
    for (int i = 0; i < 2; i++) {
        capstan c = half_turn(0.0);
        c.speed = speeds[i];
        double got = pulled_over(&c);
        expect_near(0.0, got, 0.003);
    }
}

static void friction_reverses_with_pull(void **state)
{
    (void)state;
    capstan c = half_turn(0.3);
    begin(&c);
    (void)pull(&c, start_segments(&c));
    ratios forth = pull(&c, 4.0);
    c.speed = -c.speed;
    (void)pull(&c, 1.0);
    ratios back = pull(&c, 4.0);
    scene_rig_end(&c.rig);
    expect_near(1.0, forth.mean / (0.3 * pi), 0.01);
    expect_near(-1.0, back.mean / (0.3 * pi), 0.01);
    assert_true(back.largest < -0.28 * pi); /* never to and fro */
}

/* Of the largest ratio that friction could hold: 99 % is held, without creep. */
static void load_below_capstan_limit_holds(void **state)
{
    (void)state;
    capstan c = half_turn(0.3);
    begin(&c);
    (void)pull(&c, start_segments(&c));
    expect_ok(vbss_thread_detach(c.rig.thread.thread, c.end));
    uint32_t last = c.rig.thread.nodes - 1;
    double pulls = load * exp(0.99 * 0.3 * pi);
    rig_force(&c.rig.thread, last, vec3_scale(c.pulled, pulls));
    scene_rig_run(&c.rig, 1e-3, 500);
    vec3 before = rig_position(&c.rig.thread, last);
    scene_rig_run(&c.rig, 1e-3, 2000);
    double crept = vec3_distance(before, rig_position(&c.rig.thread, last));
    scene_rig_end(&c.rig);
    expect_near(0.0, crept, 1e-9);
}

int test_capstan(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(tension_follows_capstan_equation),
        cmocka_unit_test(tension_follows_capstan_equation_with_local_bending),
        cmocka_unit_test(capstan_error_is_second_order_in_segment_length),
        cmocka_unit_test(frictionless_tension_is_constant),
        cmocka_unit_test(friction_reverses_with_pull),
        cmocka_unit_test(load_below_capstan_limit_holds),
    };
    return cmocka_run_group_tests_name("scene.capstan", tests, NULL, NULL);
}
