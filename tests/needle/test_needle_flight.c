/* Free flight: what is kept over many steps, how near the true motion is, falling and drag in closed form. */
#include "base/rotation.h"
#include "fixture.h"
#include "solver/rigid_rig.h"

/* ---- a tumbling needle */

/* Any pose; turning in the needle's own principal axes, middle of the arc, across it, z. */
static vbss_needle *begin_turning(fixture *f, vec3 own)
{
    begin(f);
    quat q = vbss_quat_from_rotation_vector(vec3_make(0.3, -0.8, 0.5));
    vec3_store(f->config.position, vec3_make(0.02, 0.01, -0.03));
    set_orientation(f, q);
    vbss_needle *needle = make(f);
    const vbss_needle_mass m = weigh(needle);
    vec3 turning = vec3_zero();
    for (int i = 0; i < 3; i++) {
        turning = vec3_add_scaled(turning, (&own.x)[i], vec3_load(m.axes[i]));
    }
    double w[3];
    vec3_store(w, quat_rotate(q, turning));
    expect_ok(vbss_needle_set_state(needle, f->config.position, NULL, NULL, w));
    return needle;
}

/* Of what hosts see. */
static vec3 angular_momentum(vbss_needle *needle)
{
    const vbss_needle_state s = get_state(needle);
    const vbss_needle_mass m = weigh(needle);
    quat q = quat_make(s.orientation[0], s.orientation[1], s.orientation[2], s.orientation[3]);
    vec3 own = quat_rotate_back(q, vec3_load(s.angular_velocity)), sum = vec3_zero();
    for (int i = 0; i < 3; i++) {
        vec3 axis = vec3_load(m.axes[i]);
        sum = vec3_add_scaled(sum, m.inertia[i] * vec3_dot(axis, own), axis);
    }
    return quat_rotate(q, sum);
}

static double energy(vbss_needle *needle)
{
    vbss_needle_energies e;
    expect_ok(vbss_needle_get_energies(needle, &e, sizeof e));
    expect_near(e.total, e.kinetic + e.gravity, 0.0);
    return e.total;
}

static vec3 centre(vbss_needle *needle)
{
    const vbss_needle_state s = get_state(needle);
    quat q = quat_make(s.orientation[0], s.orientation[1], s.orientation[2], s.orientation[3]);
    return pose_apply(pose_make(vec3_load(s.position), q), vec3_load(weigh(needle).centre));
}

/* The middle of its moments belongs to the middle of the arc: about it, it turns over for ever. */
static const vec3 tumbling = {30.0, 0.03, 0.03};

typedef struct drift {
    double momentum, energy, early_energy; /* the largest change of all steps, relative */
    double straight;                       /* farthest of the centre of mass from its line, m */
    double min_alignment; /* of the middle axis with the angular momentum, its cosine */
} drift;

static drift fly(double h, uint32_t early, uint32_t all)
{
    fixture f;
    drift d = {.min_alignment = 1.0};
    vbss_needle *needle = begin_turning(&f, tumbling);
    vec3 spin = angular_momentum(needle), x = centre(needle), v = inside(needle)->body.now.v;
    double e = energy(needle);
    for (uint32_t i = 1; i <= all; i++) {
        steps(needle, h, 1);
        double off = vec3_distance(spin, angular_momentum(needle)) / vec3_norm(spin);
        double change = fabs(energy(needle) / e - 1.0);
        vec3 wanted = vec3_add_scaled(x, i * h, v);
        vec3 axis =
            quat_rotate(inside(needle)->body.now.pose.orientation, vec3_make(1.0, 0.0, 0.0));
        d.momentum = fmax(d.momentum, off);
        d.energy = fmax(d.energy, change);
        d.early_energy = i <= early ? d.energy : d.early_energy;
        d.straight = fmax(d.straight, vec3_distance(wanted, centre(needle)));
        d.min_alignment = fmin(d.min_alignment, vec3_dot(axis, spin) / vec3_norm(spin));
    }
    end(&f);
    return d;
}

static void tumbling_conserves_angular_momentum_and_energy(void **state)
{
    (void)state;
    const drift d = fly(1e-3, 10000, 100000);
    expect_near(0.0, d.momentum, 1e-12);
    expect_near(0.0, d.straight, 1e-12);
    assert_true(d.min_alignment < -0.99); /* it has turned over */
    expect_near(0.0, d.energy, 2e-5);
    expect_near(d.early_energy, d.energy, 1e-3 * d.energy); /* swings, but does not drift */
    const drift fine = fly(5e-4, 1000, 10000);
    expect_near(4.0, d.energy / fine.energy, 0.1);
}

/* ---- how near the true motion is */

/* Against Runge and Kutta's method after 0.2 s: orientation, rad, and angular velocity, relative. */
static double flight_error(double h, vec3 own)
{
    fixture f;
    vbss_needle *needle = begin_turning(&f, own);
    const vbss_rigid_motion wanted = rigid_fine(&inside(needle)->body, vec3_zero(), 0.2, 20000);
    steps(needle, h, (uint32_t)(0.2 / h + 0.5));
    const vbss_rigid_motion got = inside(needle)->body.now;
    double error = rigid_turn(got.pose.orientation, wanted.pose.orientation);
    error = fmax(error, vec3_distance(got.w, wanted.w) / vec3_norm(wanted.w));
    end(&f);
    return error;
}

static void orientation_error_is_second_order(void **state)
{
    (void)state;
    static const vec3 spins[] = {{20.0, 5.0, -10.0}, {30.0, 0.3, 0.3}, {-4.0, 25.0, 7.0}};
    for (size_t i = 0; i < sizeof spins / sizeof spins[0]; i++) {
        double coarse = flight_error(2e-3, spins[i]), middle = flight_error(1e-3, spins[i]);
        double fine = flight_error(5e-4, spins[i]);
        expect_near(4.0, coarse / middle, 0.1);
        expect_near(4.0, middle / fine, 0.05);
        assert_true(middle < 1e-3);
    }
}

/* Nothing to approximate: about a principal axis it turns as far as it should. */
static void principal_axis_rotation_is_exact(void **state)
{
    (void)state;
    for (int axis = 0; axis < 3; axis++) {
        double own[3] = {0.0, 0.0, 0.0};
        own[axis] = 2.5 * PI; /* a quarter of a turn and one whole in a second */
        fixture f;
        vbss_needle *needle = begin_turning(&f, vec3_load(own));
        quat before = inside(needle)->body.now.pose.orientation;
        vec3 w = vec3_load(get_state(needle).angular_velocity);
        steps(needle, 1e-2, 100);
        quat wanted = quat_mul(vbss_quat_from_rotation_vector(w), before);
        expect_near(0.0, rigid_turn(wanted, inside(needle)->body.now.pose.orientation), 1e-11);
        expect_near_vec3(w, vec3_load(get_state(needle).angular_velocity), 1e-11);
        end(&f);
    }
}

static void rotation_about_z_drives_tip_forward(void **state)
{
    (void)state;
    fixture f;
    begin(&f);
    f.config.angular_velocity[2] = 2.0;
    vbss_needle *needle = make(&f);
    const vbss_needle_state before = get_state(needle);
    steps(needle, 1e-5, 1);
    const vbss_needle_state after = get_state(needle);
    vec3 displacement = vec3_sub(vec3_load(after.tip), vec3_load(before.tip));
    expect_near(2.0 * f.config.radius * 1e-5,
                vec3_dot(displacement, vec3_load(before.tip_direction)), 1e-11);
    expect_near(0.0, vec3_norm(vec3_load(before.velocity)), 1e-16);
    expect_near(0.0, vec3_norm(vec3_load(after.position)), 1e-11); /* only the centre flies on */
    end(&f);
}

static void reported_velocity_is_of_origin(void **state)
{
    (void)state;
    fixture f;
    vbss_needle *needle = begin_turning(&f, vec3_make(20.0, 5.0, -10.0));
    double h = 1e-5;
    steps(needle, h, 1);
    vec3 before = vec3_load(get_state(needle).position);
    steps(needle, h, 1);
    vec3 v = vec3_load(get_state(needle).velocity);
    steps(needle, h, 1);
    vec3 after = vec3_load(get_state(needle).position);
    assert_true(vec3_norm(v) > 1e-5);
    expect_near_vec3(vec3_scale(vec3_sub(after, before), 0.5 / h), v, 1e-8);
    end(&f);
}

static void overfast_rotation_is_damped(void **state)
{
    (void)state;
    fixture f;
    begin(&f);
    f.config.angular_velocity[2] = 1e6;
    vbss_needle *needle = make(&f);
    steps(needle, 1e-3, 1);
    expect_near(0.5 * PI / 1e-3, get_state(needle).angular_velocity[2], 1e-9);
    f.config.angular_velocity[2] = 0.499 * PI / 1e-3;
    needle = make(&f);
    steps(needle, 1e-3, 1000);
    expect_near(0.499 * PI / 1e-3, get_state(needle).angular_velocity[2], 1e-9);
    end(&f);
}

/* ---- falling */

static const vec3 gravity = {0.3, -0.2, -9.81}, thrown = {0.5, 1.0, 2.0};

static vbss_needle *begin_falling(fixture *f, double drag)
{
    begin(f);
    f->config.drag = drag;
    vec3_store(f->config.gravity, gravity);
    vec3_store(f->config.velocity, thrown);
    vec3_store(f->config.angular_velocity, vec3_make(10.0, -5.0, 3.0)); /* it falls all the same */
    return make(f);
}

static void fall_follows_backward_euler_parabola(void **state)
{
    (void)state;
    fixture f;
    double h = 1e-3;
    vbss_needle *needle = begin_falling(&f, 0.0);
    vec3 x = centre(needle), v = inside(needle)->body.now.v;
    for (int i = 1; i <= 1000; i++) {
        steps(needle, h, 1);
        double t = i * h;
        vec3 wanted = vec3_add_scaled(vec3_add_scaled(x, t, v), 0.5 * t * (t + h), gravity);
        expect_near_vec3(wanted, centre(needle), 1e-12);
        expect_near_vec3(vec3_add_scaled(v, t, gravity), inside(needle)->body.now.v, 1e-12);
    }
    end(&f);
}

/* v = v_end + (v_0 - v_end) k^n with v_end = g / drag and k = 1 / (1 + h drag), and x its sum. */
static void drag_follows_backward_euler_and_converges(void **state)
{
    (void)state;
    double drag = 3.0, errors[3];
    for (int k = 0; k < 3; k++) {
        double h = 4e-3 / (double)(1 << k);
        uint32_t count = (uint32_t)(0.8 / h + 0.5);
        fixture f;
        vbss_needle *needle = begin_falling(&f, drag);
        vec3 x = centre(needle), v = inside(needle)->body.now.v, spin = angular_momentum(needle);
        vec3 last = vec3_scale(gravity, 1.0 / drag), over = vec3_sub(v, last);
        steps(needle, h, count);
        double left = pow(1.0 + h * drag, -(double)count), exact = exp(-0.8 * drag);
        vec3 steady = vec3_add_scaled(x, 0.8, last);
        vec3 wanted = vec3_add_scaled(steady, (1.0 - left) / drag, over);
        expect_near_vec3(wanted, centre(needle), 1e-12);
        expect_near_vec3(vec3_add_scaled(last, left, over), inside(needle)->body.now.v, 1e-12);
        expect_near_vec3(vec3_scale(spin, left), angular_momentum(needle), 1e-12 * vec3_norm(spin));
        vec3 true_place = vec3_add_scaled(steady, (1.0 - exact) / drag, over);
        errors[k] = vec3_distance(true_place, centre(needle));
        end(&f);
    }
    expect_near(2.0, errors[0] / errors[1], 0.02);
    expect_near(2.0, errors[1] / errors[2], 0.01);
    assert_true(errors[2] < 1e-3);
}

static void fall_energy_is_reported(void **state)
{
    (void)state;
    fixture f;
    vbss_needle *needle = begin_falling(&f, 0.0);
    vbss_needle_energies e;
    expect_ok(vbss_needle_get_energies(needle, &e, sizeof e));
    const vbss_needle_mass m = weigh(needle);
    vec3 v = inside(needle)->body.now.v, w = vec3_load(get_state(needle).angular_velocity);
    double turning = 0.5 * vec3_dot(w, angular_momentum(needle));
    expect_near(0.5 * m.mass * vec3_norm_squared(v) + turning, e.kinetic, 1e-15 * e.kinetic);
    expect_near(-m.mass * vec3_dot(gravity, centre(needle)), e.gravity, 1e-15 * e.kinetic);
    /* Backward Euler takes m (h g)^2 / 2 in every step. */
    double h = 1e-3, taken = 0.5 * m.mass * vec3_norm_squared(vec3_scale(gravity, h));
    double before = energy(needle);
    needle_object *n = inside(needle);
    n->body.now.w = vec3_zero(); /* the fall alone */
    before -= turning;
    steps(needle, h, 500);
    expect_near(before - 500.0 * taken, energy(needle), 1e-12 * before);
    end(&f);
}

int test_needle_flight(void)
{
    const struct CMUnitTest tests[] = {
        harness_test(tumbling_conserves_angular_momentum_and_energy),
        harness_test(orientation_error_is_second_order),
        harness_test(principal_axis_rotation_is_exact),
        harness_test(rotation_about_z_drives_tip_forward),
        harness_test(reported_velocity_is_of_origin),
        harness_test(overfast_rotation_is_damped),
        harness_test(fall_follows_backward_euler_parabola),
        harness_test(drag_follows_backward_euler_and_converges),
        harness_test(fall_energy_is_reported),
    };
    return cmocka_run_group_tests_name("needle.needle_flight", tests, NULL, NULL);
}
