/* A twisted thread under tension winds about itself: a plectoneme, whose strands touch without friction.
 *
 * Two strands of bending stiffness B touch on a helix of radius r, that of the thread, and angle a from the axis. They
 * minimise the energy if the torque, the tension of the straight parts and the contact force for a unit of length are
 *
 *     M = 2 B sin(a)^3 cos(a) / (r cos(2 a))     T = B sin(a)^4 / r^2 (1/2 + 1/cos(2 a))
 *     p = B sin(a)^4 / (r^3 cos(2 a))
 *
 * and a turn of the end draws in 4 pi r / sin(2 a) of the thread: Clauvelin, Audoly and Neukirch, Macromolecules
 * 41:4479 (2008); the same without thermal motion in Purohit, J Mech Phys Solids 56:1715 (2008). */
#include <math.h>

#include "base/elementary.h"
#include "base/pi.h"
#include "scene/rig.h"

enum { SEGMENTS = 240 };
static const double bending = 1e-8, torsion = 0.7e-8, length = 0.1, radius = 0.5e-3, h = 1e-3;

/* ---- published */

typedef struct helix {
    double tension, torque, pressure, shortening; /* N, N m, N/m, m for a turn of the end */
} helix;

static helix helix_of(double angle)
{
    double sine, cosine, twice_sine, twice_cosine;
    vbss_sincos(angle, &sine, &cosine);
    vbss_sincos(2.0 * angle, &twice_sine, &twice_cosine);
    const double bend = bending * sine * sine * sine / radius;
    return (helix){.tension = bend * sine / radius * (0.5 + 1.0 / twice_cosine),
                   .torque = 2.0 * bend * cosine / twice_cosine,
                   .pressure = bend * sine / (radius * radius * twice_cosine),
                   .shortening = 2.0 * VBSS_TWO_PI * radius / twice_sine};
}

/* ---- simulated */

typedef struct wound {
    scene_rig r;
    uint32_t low, high; /* clamps on the x axis */
    double end, roll;   /* of the high one */
} wound;

/* Moves and rolls the end steadily. */
static void drive(wound *w, double end, double turns, uint32_t steps)
{
    const double first_end = w->end, first_roll = w->roll;
    for (uint32_t k = 1; k <= steps; k++) {
        const double part = (double)k / steps;
        w->end = first_end + part * (end - first_end);
        w->roll = first_roll + part * (VBSS_TWO_PI * turns - first_roll);
        rig_move(&w->r.thread, w->high, vec3_make(w->end, 0.0, 0.0));
        expect_ok(vbss_thread_set_roll(w->r.thread.thread, w->high, w->roll));
        scene_rig_run(&w->r, h, 1);
    }
}

/* Twisted by ten turns while it is straight; then the end comes in by half of the length, with five more. */
static void wound_begin(wound *w)
{
    vec3 x[SEGMENTS + 1];
    for (int i = 0; i <= SEGMENTS; i++) {
        const double s = (double)i / SEGMENTS, bump = 1e-5 * exp(-100.0 * (s - 0.5) * (s - 0.5));
        double sine, cosine;
        vbss_sincos(60.0 * s, &sine, &cosine);
        x[i] = vec3_make(length * s, bump * cosine, bump * sine);
    }
    vbss_scene_config scene = scene_rig_config();
    vbss_thread_config thread = rig_config(length, SEGMENTS);
    scene.thread_friction = 0.0;
    thread.positions = &x[0].x;
    thread.radius = radius;
    thread.bending_stiffness = bending;
    thread.torsional_stiffness = torsion;
    thread.axial_stiffness = 50.0;
    thread.gravity[1] = 0.0;
    thread.drag = 5.0;
    *w = (wound){.end = length};
    scene_rig_begin(&w->r, &scene, &thread);
    w->low = rig_clamp_here(&w->r.thread, 0, vec3_make(1.0, 0.0, 0.0));
    w->high = rig_clamp_here(&w->r.thread, SEGMENTS, vec3_make(1.0, 0.0, 0.0));
    drive(w, length, 10.0, 300);
    drive(w, 0.5 * length, 15.0, 1000);
}

typedef struct measured {
    double tension, torque, contact_force; /* of all contacts */
    double radius, angle;                  /* of the helix */
} measured;

/* Of either strand, WINDOW segments that begin LOOP segments from the end of the plectoneme. */
enum { LOOP = 17, WINDOW = 24 };

/* Sum of the indices of nodes that touch. */
static int sum_of_touching_nodes(const vec3 *x)
{
    double smallest = 1e3;
    int found = 0;
    for (int sum = SEGMENTS - 60; sum <= SEGMENTS + 60; sum++) {
        const int last = sum / 2 - LOOP;
        double distance = 0.0;
        for (int k = last - WINDOW; k <= last; k++) {
            distance += vec3_distance(x[k], x[sum - k]);
        }
        found = distance < smallest ? sum : found;
        smallest = fmin(distance, smallest);
    }
    return found;
}

static measured measure(wound *w)
{
    vec3 x[SEGMENTS + 1], across = vec3_zero(), middle[2] = {{0}};
    rig_read(&w->r.thread, VBSS_THREAD_VIEW_POSITIONS, x);
    const int sum = sum_of_touching_nodes(x), last = sum / 2 - LOOP, first = last - WINDOW;
    double distance = 0.0, turned = 0.0;
    for (int k = first; k <= last; k++) {
        const vec3 before = across;
        across = vec3_sub(x[sum - k], x[k]);
        distance += vec3_norm(across) / (WINDOW + 1);
        middle[k > first] = vec3_lerp(x[k], x[sum - k], 0.5);
        if (k > first) {
            turned += atan2(vec3_norm(vec3_cross(before, across)), vec3_dot(before, across));
        }
    }
    measured m = {.tension = rig_reaction_force(&w->r.thread, w->high).x,
                  .torque = rig_reaction_torque(&w->r.thread, w->high).x,
                  .contact_force = scene_rig_contact_pressure(&w->r),
                  .radius = 0.5 * distance};
    m.angle = atan2(m.radius * turned, vec3_distance(middle[0], middle[1]));
    const helix published = helix_of(m.angle);
    print_message("angle %.2f degrees; over theory: tension %.4f, torque %.4f, radius %.4f\n",
                  m.angle * 360.0 / VBSS_TWO_PI, m.tension / published.tension,
                  m.torque / published.torque, m.radius / radius);
    return m;
}

/* Corners of the strands interlock, so the tension depends a little on the past. */
static void plectoneme_has_published_shape_and_loads(void **state)
{
    (void)state;
    const double turns[] = {15.0, 18.0, 21.0};
    double grown[3];
    wound w;
    measured m = {0};
    wound_begin(&w);
    for (int k = 0; k < 3; k++) {
        drive(&w, w.end, turns[k], 150);
        drive(&w, w.end, turns[k], 400);
        m = measure(&w);
        const helix published = helix_of(m.angle);
        expect_near(1.0, m.torque / published.torque, 0.01);
        expect_near(1.0, m.tension / published.tension, 0.025);
        expect_near(1.0, m.radius / radius, 0.03);
        grown[k] = m.angle;
    }
    assert_true(grown[1] > 1.05 * grown[0] && grown[2] > 1.05 * grown[1]);

    /* Along the published line the plectoneme grows under constant load. */
    const helix published = helix_of(m.angle);
    const double more = 2.0, drawn = more * published.shortening;
    drive(&w, w.end - drawn, turns[2] + more, 300);
    drive(&w, w.end, turns[2] + more, 400);
    const measured after = measure(&w);
    expect_near(1.0, after.torque / m.torque, 0.005);
    expect_near(1.0, after.tension / m.tension, 0.025);
    expect_near(1.0, (after.contact_force - m.contact_force) / (0.5 * drawn * published.pressure),
                0.02);
    assert_int_equal(0, scene_rig_statistics(&w.r).clamped);
    scene_rig_end(&w.r);
}

int test_plectoneme(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(plectoneme_has_published_shape_and_loads),
    };
    return cmocka_run_group_tests_name("scene.plectoneme", tests, NULL, NULL);
}
