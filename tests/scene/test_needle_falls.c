/* A needle that falls on the floor: it does not bounce, gains no energy, and comes to rest with its weight on the floor. */
#include "base/rotation.h"
#include "scene/needles_rig.h"

#define GRAVITY 9.81
static const double pi = 0x1.921fb54442d18p1;

static void begin(needles_rig *r)
{
    needles_begin(r);
    r->tools.s.config.floor = 1;
    r->tools.s.config.capsule_capacity = 64;
    vec3_store(r->tools.s.config.floor_normal, vec3_make(0.0, 0.0, 1.0));
    small_create(&r->tools.s);
    r->config.gravity[2] = -GRAVITY;
}

/* ---- looks */

/* Of the ends of the axes of its capsules above the floor, less the radius of the wire. */
static double height(const needles_rig *r)
{
    vbss_view view;
    double smallest = DBL_MAX;
    expect_ok(vbss_needle_get_view(r->needle, VBSS_NEEDLE_VIEW_POINTS, &view, sizeof view));
    for (uint64_t i = 0; i < view.count; i++) {
        double at[3];
        memcpy(at, (const char *)view.data + i * view.stride_bytes, sizeof at);
        smallest = vbss_min(smallest, at[2]);
    }
    return smallest - r->config.wire_radius;
}

static vec3 floor_force(const needles_rig *r)
{
    vbss_view keys = small_view(&r->tools.s, VBSS_SCENE_VIEW_CONTACTS);
    vec3 sum = vec3_zero();
    for (uint64_t i = 0; i < keys.count; i++) {
        uint32_t key[5];
        memcpy(key, (const char *)keys.data + i * keys.stride_bytes, sizeof key);
        assert_int_equal(key[0], VBSS_SCENE_CONTACT_CAPSULE_FLOOR);
        assert_int_equal(key[1], r->body);
        sum = vec3_add(sum, small_vector(&r->tools.s, VBSS_SCENE_VIEW_CONTACT_FORCES, i));
    }
    return sum;
}

static double speed(const needles_rig *r)
{
    const vbss_rigid_motion *now =
        &vbss_scene_body(small_object(&r->tools.s), r->body)->rigid.body.now;
    return vec3_norm(now->v) + r->config.radius * vec3_norm(now->w);
}

/* ---- dropped */

static void turn_by(needles_rig *r, vec3 first, vec3 then)
{
    quat q = quat_mul(vbss_quat_from_rotation_vector(then), vbss_quat_from_rotation_vector(first));
    const double turn[4] = {q.w, q.x, q.y, q.z};
    memcpy(r->config.orientation, turn, sizeof turn);
}

/* So that its lowest place is there; it is not in the scene yet, and made but to look. */
static void lift(needles_rig *r, double above)
{
    r->config.position[2] = 0.0;
    expect_ok(vbss_needle_create(r->tools.s.context, &r->config, &r->needle));
    r->config.position[2] = above - height(r);
    expect_ok(vbss_needle_destroy(r->needle));
    needles_add(r);
}

typedef struct fall {
    double lowest;     /* below the floor, m */
    double bounce;     /* above it after it has touched, m */
    double rise;       /* of energy in a step, the largest, J */
    double resting_at; /* when it was last faster than 1 mm/s, s */
    double lost;       /* energy, J */
} fall;

static fall watch(needles_rig *r, uint32_t steps)
{
    fall f = {0.0, 0.0, 0.0, 0.0, 0.0};
    double first = needles_energy(r), energy = first;
    bool touched = false;
    for (uint32_t i = 0; i < steps; i++) {
        tools_steps(&r->tools, 1);
        double now = needles_energy(r), above = height(r);
        touched = touched || small_statistics(&r->tools.s).contacts > 0;
        f.lowest = vbss_max(f.lowest, -above);
        f.bounce = touched ? vbss_max(f.bounce, above) : 0.0;
        f.rise = vbss_max(f.rise, now - energy);
        f.resting_at = speed(r) > 1e-3 ? (i + 1) * 1e-3 : f.resting_at;
        energy = now;
    }
    f.lost = first - energy;
    return f;
}

static void expect_rest(const needles_rig *r)
{
    double weight = GRAVITY * needles_mass(r).mass;
    vec3 force = floor_force(r), own = vec3_load(small_rigid(&r->tools.s, r->body).contact_force);
    expect_near(1.0, force.z / weight, 1e-6);
    expect_near(0.0, hypot(force.x, force.y) / weight, 1e-6);
    expect_near(0.0, vec3_distance(force, own) / weight, 1e-9);
    expect_near(0.0, needles_state(r).tip[2] - r->config.wire_radius, 1e-8); /* flat */
    expect_near(0.0, needles_state(r).swage[2] - r->config.wire_radius, 1e-8);
    assert_int_equal(small_statistics(&r->tools.s).clamped, 0);
    assert_int_equal(small_statistics(&r->tools.s).paused, 0);
}

static void falling_needle_comes_to_rest_at_any_orientation(void **state)
{
    (void)state;
    /* Flat; upright on its tip, which is below its middle of mass; on both ends; on its back: each leaning a little. But
     * for the first it falls over then, and from its tip it rocks on its arc before. */
    const double forward[4] = {0.0, -atan(0.5 * pi), 0.0, 0.0};
    const double upright[4] = {0.05, -1.52, -1.52, 1.52};
    const double at_rest[4] = {0.1, 0.5, 0.2, 0.2};
    for (int k = 0; k < 4; k++) {
        needles_rig r;
        begin(&r);
        turn_by(&r, vec3_make(0.0, 0.0, forward[k]), vec3_make(upright[k], 0.02, 0.0));
        lift(&r, 20e-3);
        fall f = watch(&r, 3000);
        assert_true(f.resting_at < at_rest[k]);
        assert_true(f.lowest < 0.02 * r.config.wire_radius);
        assert_true(f.bounce < 20e-6);
        assert_true(f.rise < 1e-5 * f.lost);
        expect_rest(&r);
        needles_end(&r);
    }
}

/* ---- rolling */

/* On its back, upright: a ring that rolls about its contact, its middle of mass d below its centre, has the frequency
 * sqrt(g d / (k^2 + (R - d)^2)) of small swings, R the outer radius and k that of gyration about the middle of mass. */
static double rocking_period(const needles_rig *r)
{
    const vbss_needle_mass m = needles_mass(r);
    double below = vec3_norm(vec3_load(m.centre)), moment = 0.0;
    for (int i = 0; i < 3; i++) {
        moment = fabs(m.axes[i][2]) > 0.5 ? m.inertia[i] : moment;
    }
    double arm = r->config.radius + r->config.wire_radius - below;
    return 2.0 * pi * sqrt((moment / m.mass + arm * arm) / (GRAVITY * below));
}

/* Capsules are a polygon of 64 sides: a twentieth of a radian each, to swings of a fifth. Hardly anything tilts what
 * stands upright in its plane, but as of an inverted pendulum a hair of it grows: after a second it lies. */
static void needle_rolls_on_its_arc(void **state)
{
    (void)state;
    needles_rig r;
    double outer, spin = 5.0, fastest = 0.0, slip = 0.0, turned_back = 0.0;
    uint32_t turns = 0;
    begin(&r);
    outer = r.config.radius + r.config.wire_radius;
    r.config.segment_count = 64;
    r.config.friction = 1.0;
    r.config.angular_velocity[1] = spin;
    r.config.velocity[0] = spin * outer;
    turn_by(&r, vec3_zero(), vec3_make(0.5 * pi, 0.0, 0.0));
    lift(&r, 0.0);
    for (uint32_t i = 0; turns < 5 && i < 600; i++) {
        tools_steps(&r.tools, 1);
        vbss_needle_state s = needles_state(&r);
        double now = s.angular_velocity[1];
        slip = vbss_max(slip, fabs(s.velocity[0] - now * outer));
        fastest = vbss_max(fastest, fabs(now) * outer);
        if (spin * now < 0.0) {
            double at = (i + 1 - now / (now - spin)) * 1e-3, half = 0.5 * rocking_period(&r);
            expect_near(turns == 0 ? 0.5 * half : half, at - turned_back, 0.04 * half);
            turned_back = at;
            turns++;
        }
        spin = now;
    }
    assert_int_equal(turns, 5);
    assert_true(slip < 2e-3 * fastest);
    fall f = watch(&r, 2400);
    assert_true(f.resting_at > 0.0 && f.resting_at < 1.0);
    assert_true(f.lowest < 0.1 * r.config.wire_radius);
    assert_true(f.bounce < 20e-6);
    assert_true(f.rise < 1e-5 * f.lost);
    expect_rest(&r);
    needles_end(&r);
}

int test_needle_falls(void)
{
    const struct CMUnitTest tests[] = {
        harness_test(falling_needle_comes_to_rest_at_any_orientation),
        harness_test(needle_rolls_on_its_arc),
    };
    return cmocka_run_group_tests_name("scene.needle_falls", tests, NULL, NULL);
}
