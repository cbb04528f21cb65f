/* Forces, reactions and accelerations against finite differences of the energy: shapes, rest
 * lengths and attachments at random, so that every kind of stretch between clamps is met. */
#include <math.h>

#include "base/rotation.h"
#include "thread/rig.h"

enum { MAX_NODES = 16, MAX_ATTACHMENTS = 5 * MAX_NODES };

typedef struct scene {
    rig r;
    double rest_lengths[MAX_NODES];
    vec3 x[MAX_NODES], v[MAX_NODES];
    vec3 held_by[MAX_NODES]; /* sum of what attachments but masses do */
    vec3 moving[MAX_NODES];  /* from the reactions of masses */
    double drag;
    uint32_t mass_ids[MAX_NODES];
    uint32_t clamp_ids[MAX_NODES]; /* 0: none */
    vec3 directions[MAX_NODES];
    uint32_t others[MAX_ATTACHMENTS], other_count;
} scene;

static const double mass = 1e-3; /* on every node: its reaction tells the acceleration */
static const vec3 gravity = {1.0, -9.81, 2.0};

/* ---- making one */

static vec3 draw_direction(harness_source *source)
{
    vec3 d = harness_draw_vec3(source, -0.7, 0.7);
    return vec3_unit_or(vec3_add(d, vec3_make(1.0, 0.0, 0.0)), vec3_make(1.0, 0.0, 0.0));
}

/* Segments of 4 to 16 mm, or all of 10 mm; nodes off a line by up to a third of that. */
static void draw_shape(harness_source *source, scene *s, uint32_t nodes)
{
    bool equal = harness_draw_below(source, 3) == 0;
    double along = 0.0;
    for (uint32_t i = 0; i < nodes; i++) {
        s->x[i] = harness_draw_vec3(source, -0.003, 0.003);
        s->x[i].x += along;
        s->v[i] = harness_draw_vec3(source, -0.1, 0.1);
        s->rest_lengths[i] = equal ? 0.01 : 0.01 * pow(2.0, harness_draw_real(source, -1.3, 0.7));
        along += s->rest_lengths[i];
    }
}

static void add_other(scene *s, uint32_t id)
{
    s->others[s->other_count++] = id;
}

/* Clamps at regular distances of 1 to 9 segments, or here and there. */
static void draw_attachments(harness_source *source, scene *s)
{
    rig *r = &s->r;
    uint32_t spacing = 1 + harness_draw_below(source, 9);
    uint32_t first = harness_draw_below(source, spacing);
    bool regular = harness_draw_below(source, 2) == 0;
    for (uint32_t i = 0; i < r->nodes; i++) {
        bool clamped = regular ? i % spacing == first : harness_draw_below(source, 4) == 0;
        vec3 aside = harness_draw_vec3(source, -0.01, 0.01);
        s->directions[i] = draw_direction(source);
        s->clamp_ids[i] = 0;
        if (clamped) {
            add_other(s, s->clamp_ids[i] = rig_clamp_here(r, i, s->directions[i]));
        } else if (harness_draw_below(source, 6) == 0) {
            add_other(s, rig_pin_here(r, i));
        }
        if (harness_draw_below(source, 4) == 0) {
            add_other(s, rig_spring(r, i, vec3_add(s->x[i], aside), 20.0, 0.1));
        }
        if (harness_draw_below(source, 4) == 0) {
            add_other(s, rig_force(r, i, vec3_scale(aside, 10.0)));
        }
        s->mass_ids[i] = rig_mass(r, i, mass);
    }
}

static void draw_scene(harness_source *source, scene *s, double rest_curvature)
{
    uint32_t nodes = 2 + harness_draw_below(source, MAX_NODES - 1);
    draw_shape(source, s, nodes);
    vbss_thread_config c = rig_config(1.0, nodes - 1);
    c.rest_lengths = s->rest_lengths;
    c.bending =
        harness_draw_below(source, 3) == 0 ? VBSS_THREAD_BENDING_LOCAL : VBSS_THREAD_BENDING_SPLINE;
    c.attachment_capacity = MAX_ATTACHMENTS;
    c.axial_stiffness = 5.0;
    c.bending_stiffness = 1e-5;
    c.rest_curvature = rest_curvature;
    c.drag = s->drag = harness_draw_real(source, 0.0, 20.0);
    c.stretch_tolerance = c.position_tolerance = 1e-12;
    vec3_store(c.gravity, gravity);
    rig_begin(&s->r, &c);
    rig_place(&s->r, s->x, s->v);
    s->other_count = 0;
    draw_attachments(source, s);
}

/* ---- the slope of the energy */

/* From the values at -2, -1, 1, 2 times the distance: off by the fourth power of it. */
static double slope_of(const double energy[4], double distance)
{
    return (8.0 * (energy[2] - energy[1]) - (energy[3] - energy[0])) / (12.0 * distance);
}

static const double offsets[4] = {-2.0, -1.0, 1.0, 2.0};

typedef struct slope {
    double potential, gravity;
} slope;

static slope energy_slope(scene *s, uint32_t node, vec3 along)
{
    const double distance = 1e-6;
    double potential[4], weight[4];
    vec3 home = s->x[node];
    for (int k = 0; k < 4; k++) {
        s->x[node] = vec3_add_scaled(home, offsets[k] * distance, along);
        rig_place(&s->r, s->x, NULL);
        vbss_thread_energies e = rig_energies(&s->r);
        potential[k] = e.total - e.kinetic;
        weight[k] = e.gravity;
    }
    s->x[node] = home;
    rig_place(&s->r, s->x, NULL);
    return (slope){slope_of(potential, distance), slope_of(weight, distance)};
}

static void turn_clamp(scene *s, uint32_t node, vec3 rotation)
{
    quat turn = vbss_quat_from_rotation_vector(rotation);
    expect_ok(vbss_thread_detach(s->r.thread, s->clamp_ids[node]));
    s->clamp_ids[node] = rig_clamp_here(&s->r, node, quat_rotate(turn, s->directions[node]));
}

static double turn_slope(scene *s, uint32_t node, vec3 axis)
{
    const double angle = 1e-4;
    double energy[4];
    for (int k = 0; k < 4; k++) {
        turn_clamp(s, node, vec3_scale(axis, offsets[k] * angle));
        vbss_thread_energies e = rig_energies(&s->r);
        energy[k] = e.total;
    }
    turn_clamp(s, node, vec3_zero());
    return slope_of(energy, angle);
}

/* ---- the property */

static void note_what_acts(scene *s)
{
    rig *r = &s->r;
    rig_read(r, VBSS_THREAD_VIEW_POSITIONS, s->x);
    rig_read(r, VBSS_THREAD_VIEW_VELOCITIES, s->v);
    for (uint32_t i = 0; i < r->nodes; i++) {
        /* A mass pulls with what gravity does beyond its acceleration and drag. */
        vec3 pull = vec3_scale(rig_reaction_force(r, s->mass_ids[i]), 1.0 / mass);
        s->moving[i] = vec3_sub(gravity, pull);
        s->held_by[i] = vec3_zero();
    }
    for (uint32_t k = 0; k < s->other_count; k++) {
        vbss_thread_reaction a;
        expect_ok(vbss_thread_get_reaction(r->thread, s->others[k], &a, sizeof a));
        s->held_by[a.node] = vec3_add(s->held_by[a.node], vec3_load(a.force));
    }
}

/* mass (acceleration + drag velocity) = attachments - slope of the energy, at every node. */
static void check_forces(scene *s, double tolerance)
{
    for (uint32_t i = 0; i < s->r.nodes; i++) {
        vec3 moving = s->moving[i];
        vec3 axes[3] = {vec3_make(1.0, 0.0, 0.0), vec3_make(0.0, 1.0, 0.0),
                        vec3_make(0.0, 0.0, 1.0)};
        for (int c = 0; c < 3; c++) {
            slope e = energy_slope(s, i, axes[c]);
            double node_mass = -e.gravity / vec3_dot(gravity, axes[c]);
            expect_near(vec3_dot(s->held_by[i], axes[c]),
                        node_mass * vec3_dot(moving, axes[c]) + e.potential, tolerance);
        }
    }
}

static void check_torques(scene *s, const vec3 *torques, double tolerance)
{
    for (uint32_t i = 0; i < s->r.nodes; i++) {
        if (s->clamp_ids[i] != 0) {
            vec3 slopes;
            slopes.x = turn_slope(s, i, vec3_make(1.0, 0.0, 0.0));
            slopes.y = turn_slope(s, i, vec3_make(0.0, 1.0, 0.0));
            slopes.z = turn_slope(s, i, vec3_make(0.0, 0.0, 1.0));
            expect_near_vec3(torques[i], slopes, tolerance);
        }
    }
}

static void read_torques(scene *s, vec3 *torques)
{
    for (uint32_t i = 0; i < s->r.nodes; i++) {
        torques[i] =
            s->clamp_ids[i] != 0 ? rig_reaction_torque(&s->r, s->clamp_ids[i]) : vec3_zero();
    }
}

static void forces_are_slopes(harness_source *source, void *user)
{
    const double *rest_curvature = user;
    scene s;
    draw_scene(source, &s, *rest_curvature);
    rig_run(&s.r, 1e-3, 1 + harness_draw_below(source, 3));
    vec3 torques[MAX_NODES] = {{0.0, 0.0, 0.0}};
    read_torques(&s, torques);
    note_what_acts(&s);
    bool curved = *rest_curvature > 0.0;
    check_forces(&s, curved ? 2e-5 : 5e-7);
    check_torques(&s, torques, curved ? 2e-9 : 2e-12);
    rig_end(&s.r);
}

static void force_is_negative_energy_gradient(void **state)
{
    (void)state;
    double rest_curvature = 0.0;
    harness_property("forces are slopes", 40, forces_are_slopes, &rest_curvature);
}

static void force_is_negative_energy_gradient_with_rest_curvature(void **state)
{
    (void)state;
    double rest_curvature = 80.0;
    harness_property("forces are slopes, curved at rest", 25, forces_are_slopes, &rest_curvature);
}

/* From the last node but one the spline reaches beyond the end of the thread: it must not. */
static void single_clamp_gradient(void **state)
{
    (void)state;
    for (uint32_t nodes = 2; nodes <= MAX_NODES; nodes++) {
        for (uint32_t node = 0; node < nodes; node++) {
            vbss_thread_config c = rig_config(0.01 * (nodes - 1), nodes - 1);
            c.gravity[1] = 0.0;
            rig r;
            rig_begin(&r, &c);
            rig_clamp_here(&r, node, vec3_make(1.0, 0.0, 0.0));
            rig_run(&r, 1e-3, 1);
            expect_near(0.0, rig_fastest(&r), 1e-10);
            expect_near(0.0, rig_energies(&r).bending, 1e-19);
            rig_end(&r);
        }
    }
}

int test_gradient(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(single_clamp_gradient),
        harness_test(force_is_negative_energy_gradient),
        harness_test(force_is_negative_energy_gradient_with_rest_curvature),
    };
    return cmocka_run_group_tests_name("thread.gradient", tests, NULL, NULL);
}
