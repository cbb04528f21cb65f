#include "scene/haptic_rig.h"

#include "base/rotation.h"

enum { WINDOW = 250, RESTING_WINDOWS = 2 }; /* WINDOW in steps of 1 ms */
static const double gap = 1e-3;             /* of the tool before it is pressed, m */
static const double felt = 1e-9;            /* energy of 0.2 mm/s at 0.05 kg, J */
static const double wall_radius = 5e-3;     /* m */
/* An arm of a person has 0.37: 6.45 N s/m with 0.554 kg and 135 N/m (Scientific Reports 5:18004, figure 3). */
static const double damping_ratio = 0.3;

/* ---- obstacles */

static quat quarter_turn(vec3 axis)
{
    return vbss_quat_from_rotation_vector(vec3_scale(axis, 0.5 * 3.14159265358979323846));
}

/* A rod below a tool whose shaft points up along z. */
static void place_wall(haptic_rig *r, vbss_scene_rigid_kind kind)
{
    tools_rig *t = &r->needles.tools;
    t->s.rigid.mass = 1e-3;
    t->s.rigid.stiffness = HAPTIC_ELASTIC_STIFFNESS;
    t->s.rigid.damping = 0.0;
    small_create(&t->s);
    small_stick(&t->s, kind, vec3_make(0.0, 0.0, -wall_radius - gap), vec3_make(0.0, 0.03, 0.0),
                wall_radius);
    tools_add(t, vec3_make(0.0, 0.0, t->config.driver_radius));
    tools_close(t, 0);
    r->into = vec3_make(0.0, 0.0, -1.0);
}

/* The drain's axis is along x, and the floor is below it; the shaft points up along y. */
static void place_drain(haptic_rig *r)
{
    tools_rig *t = &r->needles.tools;
    small *s = &t->s;
    s->config.floor = 1;
    s->config.floor_height = -s->drain.radius - 0.5 * s->drain.thickness - 2e-5;
    small_create(s);
    small_drain(s, &r->drain);
    double top = s->drain.radius + 0.5 * s->drain.thickness;
    tools_add_turned(t, vec3_make(0.3e-3, top + t->config.driver_radius + gap, 3e-3),
                     quarter_turn(vec3_make(-1.0, 0.0, 0.0)));
    tools_close(t, 0);
    r->into = vec3_make(0.0, -1.0, 0.0);
}

/* The second tool holds a needle by its middle; the first, whose shaft points along x, lies across it 6 mm farther on. */
static void place_needle(haptic_rig *r)
{
    tools_rig *t = &r->needles.tools;
    const double beside = 6e-3, behind_tip = 7e-3;
    small_create(&t->s);
    needles_hold(&r->needles);
    double height = r->needles.config.wire_radius + t->config.driver_radius + gap;
    double middle = 0.5 * r->needles.config.arc * r->needles.config.radius;
    vec3 crossing = needles_place(&r->needles, middle + beside, NULL);
    tools_add_turned(t, vec3_add(crossing, vec3_make(-behind_tip, 0.0, height)),
                     quarter_turn(vec3_make(0.0, 1.0, 0.0)));
    tools_close(t, 1);
    r->into = vec3_make(0.0, 0.0, -1.0);
}

static void add_arm(haptic_rig *r, const haptic_loop *loop, uint32_t tool)
{
    coupled_arm *arm = &r->arms[r->arm_count++];
    *arm = (coupled_arm){.mass = loop->mass,
                         .stiffness = loop->stiffness,
                         .damping = loop->damping,
                         .delay = loop->delay,
                         .in_device = loop->in_device,
                         .coupling = {loop->coupling_stiffness, loop->coupling_damping}};
    expect_ok(coupled_arm_create(r->needles.tools.s.context, r->needles.tools.tools[tool], arm));
}

void haptic_begin(haptic_rig *r, haptic_obstacle obstacle, const haptic_loop *loop)
{
    memset(r, 0, sizeof *r);
    needles_begin(&r->needles);
    r->needles.tools.config.stiffness = loop->coupling_stiffness;
    r->needles.tools.config.damping = loop->coupling_damping;
    if (obstacle == HAPTIC_DRAIN) {
        place_drain(r);
    } else if (obstacle == HAPTIC_NEEDLE) {
        place_needle(r);
        add_arm(r, loop, 1);
    } else {
        place_wall(r, obstacle == HAPTIC_WALL ? VBSS_SCENE_RIGID_DRIVEN : VBSS_SCENE_RIGID_COUPLED);
    }
    add_arm(r, loop, 0);
}

void haptic_end(haptic_rig *r)
{
    needles_end(&r->needles);
}

/* ---- a step */

void haptic_step(haptic_rig *r)
{
    double now = 1e-3 * (double)r->step++;
    for (uint32_t i = 0; i < r->arm_count; i++) {
        expect_ok(coupled_arm_read(&r->arms[i], now));
    }
    small_steps(&r->needles.tools.s, 1, 1e-3);
    for (uint32_t i = 0; i < r->arm_count; i++) {
        expect_ok(coupled_arm_write(&r->arms[i], now));
        coupled_arm_advance(&r->arms[i]);
    }
}

/* ---- measures */

/* Sums of the force on an arm over the steps at rest. */
typedef struct force_sums {
    vec3 force;
    double square;
    int steps;
} force_sums;

static void count_step(haptic_rig *r, haptic_measures *m, force_sums *sums, int step)
{
    for (uint32_t i = 0; i < r->arm_count; i++) {
        const coupled_arm *arm = &r->arms[i];
        m->largest_force = vbss_max(m->largest_force, vec3_norm(arm->written));
        m->asked = vbss_max(m->asked, vec3_norm(arm->asked));
        if (step < 0) {
            continue;
        }
        double *energy = &m->energy[step / WINDOW];
        *energy = vbss_max(*energy, coupled_arm_energy(arm));
        if (step >= (HAPTIC_WINDOWS - RESTING_WINDOWS) * WINDOW) {
            sums[i].force = vec3_add(sums[i].force, arm->written);
            sums[i].square += vec3_norm_squared(arm->written);
            sums[i].steps++;
        }
    }
}

static void finish(const haptic_rig *r, haptic_measures *m, const force_sums *sums)
{
    for (uint32_t i = 0; i < r->arm_count; i++) {
        vec3 mean = vec3_scale(sums[i].force, 1.0 / sums[i].steps);
        double variance = sums[i].square / sums[i].steps - vec3_norm_squared(mean);
        m->ripple = vbss_max(m->ripple, sqrt(vbss_max(variance, 0.0)));
        m->pressed = i == 0 ? vec3_norm(mean) : m->pressed;
    }
}

haptic_measures haptic_press(haptic_rig *r, double speed, double force)
{
    coupled_arm *arm = &r->arms[0];
    haptic_measures m = {.largest_force = 0.0};
    force_sums sums[HAPTIC_ARMS] = {{.steps = 0}};
    const double stiffness = r->needles.tools.config.stiffness;
    const double depth = gap + r->arm_count * force * (1.0 / arm->stiffness + 1.0 / stiffness);
    const int moving = (int)(1e3 * depth / speed) + 1;
    const vec3 start = arm->target;
    for (int i = -moving; i < HAPTIC_WINDOWS * WINDOW; i++) {
        double share = vbss_min(1.0, 1.0 + (double)(i + 1) / moving);
        arm->target = vec3_add_scaled(start, depth * share, r->into);
        haptic_step(r);
        count_step(r, &m, sums, i);
    }
    finish(r, &m, sums);
    return m;
}

haptic_measures haptic_measure(haptic_obstacle obstacle, const haptic_loop *loop, double speed)
{
    const double pressed = 1.0; /* N */
    haptic_rig r;
    haptic_begin(&r, obstacle, loop);
    haptic_measures m = haptic_press(&r, speed, pressed);
    haptic_end(&r);
    return m;
}

/* Two modes that beat change the largest energy of a window by less than 5 %. */
bool haptic_grows(const haptic_measures *m)
{
    const double beat = 1.05;
    for (int i = 1; i < HAPTIC_WINDOWS; i++) {
        if (m->energy[i] > beat * m->energy[i - 1] && m->energy[i] > felt) {
            return true;
        }
    }
    return false;
}

void haptic_expect_limit(const haptic_measures *m)
{
    vbss_output_config limits;
    expect_ok(vbss_output_config_init(&limits, sizeof limits));
    assert_true(m->largest_force <= limits.max_force * (1.0 + 1e-12));
}

void haptic_expect_rest(const haptic_measures *m)
{
    haptic_expect_limit(m);
    assert_false(haptic_grows(m));
    assert_true(m->ripple < 0.02);
}

double haptic_hand_damping(const haptic_loop *loop)
{
    return 2.0 * damping_ratio * sqrt(loop->stiffness * loop->mass);
}

double haptic_min_damping(const haptic_loop *loop, double frequency, double late)
{
    const double k = loop->coupling_stiffness, b = loop->coupling_damping;
    double impedance = k * k / (frequency * frequency) + b * b;
    return impedance * (1.0 - cos(frequency * late)) / (2.0 * b);
}
