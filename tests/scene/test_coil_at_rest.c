/* A thread of 150 mm that is dropped in a heap: it comes to rest, and stays there. */
#include <math.h>

#include "scene/rig.h"

enum { SEGMENTS = 150, MAX_NODES = 301, CAPACITY = 8192 };

static const double pi = 0x1.921fb54442d18p1;
static const double length = 0.15, gravity = 9.81, h = 1e-3;

typedef struct heap {
    uint32_t segments;
    double height, coil, pitch;     /* of a helix about the vertical, its lowest point that high */
    double bending_stiffness, tilt; /* of the floor, rad */
    double pile;                    /* height that it shall have in the end at least, m */
    scene_rig rig;
} heap;

static void begin(heap *d)
{
    vec3 x[MAX_NODES];
    double rest[MAX_NODES], turn = hypot(2.0 * pi * d->coil, d->pitch);
    for (uint32_t i = 0; i <= d->segments; i++) {
        double turns = length * i / d->segments / turn;
        x[i] = vec3_make(d->coil * cos(2.0 * pi * turns), d->height + d->pitch * turns,
                         d->coil * sin(2.0 * pi * turns));
    }
    for (uint32_t i = 0; i < d->segments; i++) {
        rest[i] = vec3_distance(x[i], x[i + 1]);
    }
    vbss_scene_config scene = scene_rig_incline(d->tilt, 0.3);
    scene.contact_capacity = CAPACITY; /* coils lie close at first */
    scene.candidate_capacity = 16 * CAPACITY;
    vbss_thread_config thread = rig_config(1.0, d->segments);
    thread.rest_lengths = rest;
    thread.positions = &x[0].x;
    thread.bending_stiffness = d->bending_stiffness;
    scene_rig_begin(&d->rig, &scene, &thread);
}

static double fastest_in(heap *d, uint32_t steps)
{
    double fastest = 0.0;
    for (uint32_t i = 0; i < steps; i++) {
        scene_rig_run(&d->rig, h, 1);
        fastest = fmax(fastest, rig_fastest(&d->rig.thread));
    }
    return fastest;
}

static void check_rest(heap *d, uint32_t falling)
{
    vec3 before[MAX_NODES], after[MAX_NODES];
    begin(d);
    (void)fastest_in(d, falling);
    double energy = rig_energies(&d->rig.thread).kinetic;
    rig_read(&d->rig.thread, VBSS_THREAD_VIEW_POSITIONS, before);
    double fastest = fastest_in(d, 500), crept = 0.0, top = 0.0;
    rig_read(&d->rig.thread, VBSS_THREAD_VIEW_POSITIONS, after);
    for (uint32_t i = 0; i <= d->segments; i++) {
        crept = fmax(crept, vec3_distance(before[i], after[i]));
        top = fmax(top, after[i].y);
    }
    vbss_scene_statistics s = scene_rig_statistics(&d->rig);
    vec3 force = scene_rig_floor_force(&d->rig);
    double weight = 6.4e-5 * length * gravity;
    expect_near(0.0, energy, 1e-18); /* it has fallen through 2e-6 J and more */
    expect_near(0.0, fastest, 1e-6);
    expect_near(0.0, crept, 0.5e-6); /* 1 um/s */
    assert_true(top >= d->pile);
    assert_true(s.penetration < 0.1 * 0.25e-3);
    assert_int_equal(0, s.clamped);
    /* A node weighs 6e-7 N, a residual of 1e-7 N is none. */
    expect_near(1.0, force.y / weight, 0.01);
    expect_near(0.0, hypot(force.x, force.z) / weight, 0.01);
    scene_rig_end(&d->rig);
}

/* Springs open as it falls and lies flat. */
static void coil_comes_to_rest(void **state)
{
    (void)state;
    heap d = {.segments = SEGMENTS,
              .height = 0.03,
              .coil = 6e-3,
              .pitch = 1e-3,
              .bending_stiffness = 1e-8};
    check_rest(&d, 1000);
}

static void coil_comes_to_rest_on_slope(void **state)
{
    (void)state;
    heap d = {.segments = SEGMENTS,
              .height = 0.03,
              .coil = 6e-3,
              .pitch = 1e-3,
              .bending_stiffness = 1e-8,
              .tilt = 0.15};
    check_rest(&d, 1000);
}

/* Falls on its end, and folds up over itself. */
static void upright_thread_folds_and_comes_to_rest(void **state)
{
    (void)state;
    heap d = {.segments = SEGMENTS,
              .height = 0.02,
              .coil = 0.5e-3,
              .pitch = 0.02,
              .bending_stiffness = 1e-9};
    check_rest(&d, 1500);
}

/* As soft as yarn: coils lie on each other, three diameters high. */
static void soft_coil_stays_piled(void **state)
{
    (void)state;
    heap d = {.segments = SEGMENTS,
              .height = 0.02,
              .coil = 4e-3,
              .pitch = 1e-3,
              .bending_stiffness = 1e-10,
              .pile = 0.6e-3};
    check_rest(&d, 1000);
}

int test_coil_at_rest(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(coil_comes_to_rest),
        cmocka_unit_test(coil_comes_to_rest_on_slope),
        cmocka_unit_test(upright_thread_folds_and_comes_to_rest),
        cmocka_unit_test(soft_coil_stays_piled),
    };
    return cmocka_run_group_tests_name("scene.coil_at_rest", tests, NULL, NULL);
}
