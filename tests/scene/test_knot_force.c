/* A loose overhand knot that is pulled slowly: what the ends feel is what bending takes up, and friction.
 *
 * Without friction the pull is the slope of the elastic energy; with it, the strands that slide against each
 * other as fast as the ends part add mu times the sum of the forces between them. Contacts are softer
 * than by default, as forces are small: single pairs of segments that take over from each other press evenly. */
#include <math.h>

#include "scene/rig.h"
#include "fixtures/knots.h"

static const double h = 1e-3;

static void begin(scene_rig *r, const knot_shape *shape, double friction,
                  vbss_thread_bending bending)
{
    vec3 x[KNOT_NODES];
    double rest[KNOT_NODES];
    knot_line line;
    expect_ok(knot_make(shape, KNOT_NODES, x, rest, &line));
    vbss_scene_config scene = scene_rig_config();
    vbss_thread_config thread = rig_config(1.0, line.node_count - 1);
    scene.thread_friction = friction;
    scene.contact_stiffness = 2e4;
    thread.rest_lengths = rest;
    thread.positions = &x[0].x;
    thread.bending = bending;
    thread.axial_stiffness = 4000.0;
    thread.gravity[1] = 0.0;
    thread.drag = 10.0;
    scene_rig_begin(r, &scene, &thread);
}

/* A loop of about 8 mm radius. */
static knot_shape loose(knot_kind kind, vbss_thread_bending bending)
{
    knot_shape shape;
    knot_shape_init(&shape, kind);
    shape.size = 2.5e-3;
    shape.finest = 0.3e-3;
    shape.rest = bending == VBSS_THREAD_BENDING_SPLINE ? KNOT_REST_ARCS : KNOT_REST_CHORDS;
    return shape;
}

static const struct {
    knot_kind kind;
    vbss_thread_bending bending;
} knots[] = {{KNOT_OVERHAND, VBSS_THREAD_BENDING_SPLINE},
             {KNOT_OVERHAND, VBSS_THREAD_BENDING_LOCAL},
             {KNOT_DOUBLE_OVERHAND, VBSS_THREAD_BENDING_SPLINE}};
enum { KNOTS = 3 };

static void frictionless_pull_is_energy_gradient(void **state)
{
    (void)state;
    for (int i = 0; i < KNOTS; i++) {
        scene_rig r;
        knot_shape shape = loose(knots[i].kind, knots[i].bending);
        begin(&r, &shape, 0.0, knots[i].bending);
        scene_pull p = scene_pull_begin(&r);
        scene_rig_run(&r, h, 300);
        scene_pull_run(&r, &p, h, 2.5e-3, 400);
        for (int window = 0; window < 2; window++) {
            scene_pull_means m = scene_pull_observe(&r, &p, h, 2.5e-3, 500);
            expect_near(1.0, m.force / m.energy_slope, 0.02);
        }
        scene_rig_end(&r);
    }
}

/* Of one turn it also has the size that Audoly, Clauvelin and Neukirch (2007) derive for loose knots. */
static void friction_adds_pressure_times_coefficient(void **state)
{
    (void)state;
    const double frictions[] = {0.1, 0.3, 0.1};
    for (int i = 0; i < KNOTS; i++) {
        scene_rig r;
        knot_shape shape = loose(knots[i].kind, knots[i].bending);
        begin(&r, &shape, frictions[i], knots[i].bending);
        scene_pull p = scene_pull_begin(&r);
        scene_rig_run(&r, h, 300);
        scene_pull_run(&r, &p, h, 5e-3, 400); /* until all of it slides */
        scene_pull_means m = scene_pull_observe(&r, &p, h, 5e-3, 400);
        double rubbing = m.force - m.energy_slope;
        expect_near(1.0, rubbing / (frictions[i] * m.pressure), 0.01);
        if (i == 0) {
            double bent = 0.5 * 1e-8 * m.curvature * m.curvature;
            double sum = 0.492 * 1e-8 * m.curvature * sqrt(m.curvature / 0.125e-3);
            expect_near(1.0, m.force / (bent + frictions[i] * sum), 0.1);
        }
        scene_rig_end(&r);
    }
}

/* ---- tight */

static void tight_knot_holds(void **state)
{
    (void)state;
    scene_rig r;
    knot_shape shape;
    knot_shape_init(&shape, KNOT_OVERHAND);
    double kept = scene_pull_tight(&r, &shape, 2.0);
    expect_near(3.0e-3, kept, 0.15e-3);
    scene_rig_run(&r, h, 200);
    uint32_t middle = r.thread.nodes / 2;
    vec3 before = rig_position(&r.thread, middle);
    scene_rig_run(&r, h, 200);
    expect_near(0.0, vec3_distance(before, rig_position(&r.thread, middle)), 1e-9);
    expect_near(0.0, rig_fastest(&r.thread), 1e-9);
    assert_true(rig_tension(&r.thread, 0) > 0.5);
    assert_int_equal(0, scene_rig_statistics(&r).clamped);
    scene_rig_end(&r);
}

int test_knot_force(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(frictionless_pull_is_energy_gradient),
        cmocka_unit_test(friction_adds_pressure_times_coefficient),
        cmocka_unit_test(tight_knot_holds),
    };
    return cmocka_run_group_tests_name("scene.knot_force", tests, NULL, NULL);
}
