/* Twist against closed forms: instabilities of a ring and of a straight thread, and the helix. */
#include <math.h>

#include "base/elementary.h"
#include "base/pi.h"
#include "thread/rig.h"

static const double bending = 1e-8, torsion = 0.7e-8; /* N m^2 */
static const double axial = 427.0;                    /* N */

enum { MAX_NODES = 121 };

/* No weight, and two clamps. */
typedef struct held {
    rig r;
    uint32_t low, high;
} held;

static vbss_thread_config held_config(double length, uint32_t segments)
{
    vbss_thread_config c = rig_config(length, segments);
    c.bending_stiffness = bending;
    c.torsional_stiffness = torsion;
    c.axial_stiffness = axial;
    c.gravity[1] = 0.0;
    return c;
}

static void roll(held *b, double angle)
{
    expect_ok(vbss_thread_set_roll(b->r.thread, b->high, angle));
}

/* ---- instabilities */

/* A thread that two clamps hold, and a wave on it. */
typedef struct perturbed {
    uint32_t segments;
    double length, twist, waves;
    vbss_thread_bending kind;
    const vec3 *x;
    double amplitude;
} perturbed;

enum { STEPS = 1000 };

/* Deflections in z of a node at a third of the thread, over a second. */
static void deflect(const perturbed *p, double *deflections)
{
    double numbers[3 * MAX_NODES];
    vec3 moved[MAX_NODES];
    for (uint32_t i = 0; i <= p->segments; i++) {
        const double s = (double)i / p->segments, bump = 16.0 * s * s * (1.0 - s) * (1.0 - s);
        moved[i] = p->x[i];
        moved[i].z += p->amplitude * bump * vbss_sine(p->waves * VBSS_PI * s + 0.4);
        vec3_store(numbers + 3 * (size_t)i, moved[i]);
    }
    vbss_thread_config c = held_config(p->length, p->segments);
    c.bending = p->kind;
    c.positions = numbers;
    held b;
    rig_begin(&b.r, &c);
    b.low = rig_clamp_here(&b.r, 0, vec3_make(1.0, 0.0, 0.0));
    b.high = rig_clamp_here(&b.r, p->segments, vec3_make(1.0, 0.0, 0.0));
    roll(&b, p->twist);
    for (int k = 0; k < STEPS; k++) {
        rig_run(&b.r, 1e-3, 1);
        deflections[k] = rig_position(&b.r, p->segments / 3).z;
    }
    assert_int_equal(0, rig_statistics(&b.r).forced);
    rig_end(&b.r);
}

/* The largest change that the wave makes in the last 0.9 s, over its amplitude. The thread without a wave
 * moves a little, as no state of the mesh is in equilibrium. */
static double growth(perturbed *p)
{
    double with[STEPS], without[STEPS], largest = 0.0;
    p->amplitude = 0.0;
    deflect(p, without);
    p->amplitude = 1e-9;
    deflect(p, with);
    for (int k = STEPS / 10; k < STEPS; k++) {
        largest = fmax(largest, fabs(with[k] - without[k]));
    }
    return largest / p->amplitude;
}

/* A closed ring is a thread clamped at both ends in one place, up to a rigid motion. */
static double growth_of_ring(double twist, vbss_thread_bending kind)
{
    enum { SEGMENTS = 80 };
    vec3 x[SEGMENTS + 1];
    const double length = 0.05, chord = length / SEGMENTS;
    const double radius = kind == VBSS_THREAD_BENDING_SPLINE
                              ? length / VBSS_TWO_PI
                              : 0.5 * chord / vbss_sine(VBSS_PI / SEGMENTS);
    for (int i = 0; i <= SEGMENTS; i++) {
        double sine, cosine;
        vbss_sincos(VBSS_TWO_PI * i / SEGMENTS, &sine, &cosine);
        x[i] = vec3_make(radius * sine, radius * (1.0 - cosine), 0.0);
    }
    perturbed p = {SEGMENTS, length, twist, 5.0, kind, x, 0.0};
    return growth(&p);
}

/* Michell 1889: a ring of a straight rod buckles out of its plane at a twist of 2 pi sqrt(3) EI/GJ. */
static void twisted_ring_buckles_at_michells_twist(void **state)
{
    (void)state;
    const double critical = VBSS_TWO_PI * sqrt(3.0) * bending / torsion;
    for (int kind = 0; kind < 2; kind++) {
        assert_true(growth_of_ring(0.98 * critical, kind) < 10.0);
        assert_true(growth_of_ring(1.02 * critical, kind) > 100.0);
    }
    assert_true(growth_of_ring(-0.98 * critical, VBSS_THREAD_BENDING_SPLINE) < 10.0);
    assert_true(growth_of_ring(-1.02 * critical, VBSS_THREAD_BENDING_SPLINE) > 100.0);
}

static double growth_of_straight_thread(uint32_t segments, double length, double tension,
                                        double torque)
{
    vec3 x[MAX_NODES];
    for (uint32_t i = 0; i <= segments; i++) {
        x[i] = vec3_make(length * (1.0 + tension / axial) * i / segments, 0.0, 0.0);
    }
    perturbed p = {segments, length, torque * length / torsion, 1.0, VBSS_THREAD_BENDING_SPLINE,
                   x,        0.0};
    return growth(&p);
}

/* Greenhill 1883, clamped ends without tension: M L / (2 EI) is the first solution of tan(x) = x. */
static void straight_thread_writhes_at_greenhills_torque(void **state)
{
    (void)state;
    const double critical = 2.0 * 4.493409457909064 * bending / 0.03;
    for (int sign = -1; sign <= 1; sign += 2) {
        assert_true(growth_of_straight_thread(40, 0.03, 0.0, 0.98 * sign * critical) < 10.0);
        assert_true(growth_of_straight_thread(40, 0.03, 0.0, 1.02 * sign * critical) > 100.0);
    }
}

/* Greenhill 1883 with a tension T: a long thread writhes at M^2 = 4 EI T. Deflections y + i z are sums of 1, s,
 * and exp(i p s) times cos(q s) and i sin(q s), with p = M / (2 EI) and q^2 = p^2 - T / EI. This is the determinant of
 * the conditions at two clamps. */
static double clamped_determinant(double torque, double tension, double length)
{
    const double half = 0.5 * length, p = 0.5 * torque / bending,
                 q = sqrt(p * p - tension / bending);
    double sp, cp, sq, cq;
    vbss_sincos(p * half, &sp, &cp);
    vbss_sincos(q * half, &sq, &cq);
    /* of both functions: the value across the even one, and both parts of the slope */
    const double value[2] = {sp * cq, cp * sq};
    const double slope[2][2] = {{-q * sq * cp - p * cq * sp, -p * sq * cp - q * cq * sp},
                                {-q * sq * sp + p * cq * cp, -p * sq * sp + q * cq * cp}};
    return slope[0][0] * (value[1] - half * slope[1][1]) -
           slope[0][1] * (value[0] - half * slope[1][0]);
}

/* The first torque above that of a long thread at which the determinant vanishes. */
static double clamped_threshold(double tension, double length)
{
    const double limit = 2.0 * sqrt(bending * tension), part = 1e-4;
    double low = limit * (1.0 + part), high = low;
    const bool sign = clamped_determinant(low, tension, length) > 0.0;
    while ((clamped_determinant(high, tension, length) > 0.0) == sign) {
        low = high;
        high += part * limit;
    }
    for (int i = 0; i < 40; i++) {
        const double middle = 0.5 * (low + high);
        const bool same = (clamped_determinant(middle, tension, length) > 0.0) == sign;
        *(same ? &low : &high) = middle;
    }
    return low;
}

static void tense_thread_writhes_at_greenhills_torque(void **state)
{
    (void)state;
    const double tension = 4e-4, length = 0.1, limit = 2.0 * sqrt(bending * tension);
    const double critical = clamped_threshold(tension, length);
    expect_near(1.0, critical / limit, 0.015); /* long: 20 sqrt(EI/T) */
    assert_true(growth_of_straight_thread(120, length, tension, 0.98 * critical) < 10.0);
    assert_true(growth_of_straight_thread(120, length, tension, 1.02 * critical) > 100.0);
}

/* ---- the helix */

/* Love 1927, section 271: a straight rod, bent and twisted into a helix of radius r and pitch angle a, needs
 * a force F along the axis and a moment H t + EI curvature b at its end, with the torque H and
 * F = cos(a)/r (H - EI sin(a) cos(a)/r). */
static void helix_needs_force_and_moment_of_love(void **state)
{
    (void)state;
    enum { SEGMENTS = 60 };
    const double radius = 5e-3, length = 0.036, twists[] = {0.0, 80.0, 160.0, -60.0};
    double sine, cosine;
    vbss_sincos(VBSS_PI / 6.0, &sine, &cosine);
    const double curvature = cosine * cosine / radius, torsion_of_curve = sine * cosine / radius;
    for (int k = 0; k < 4; k++) {
        double numbers[3 * (SEGMENTS + 1)];
        vec3 x[SEGMENTS + 1], tangent[2] = {{0}}, binormal = vec3_zero();
        for (int i = 0; i <= SEGMENTS; i++) {
            const double s = length * i / SEGMENTS;
            double up, along;
            vbss_sincos(s * cosine / radius, &up, &along);
            x[i] = vec3_make(radius * along, radius * up, s * sine);
            vec3_store(numbers + 3 * (size_t)i, x[i]);
            tangent[i > 0] = vec3_make(-cosine * up, cosine * along, sine);
            binormal = vec3_make(sine * up, -sine * along, cosine);
        }
        vbss_thread_config c = held_config(length, SEGMENTS);
        c.positions = numbers;
        c.drag = 50.0;
        held b;
        rig_begin(&b.r, &c);
        b.low = rig_clamp_here(&b.r, 0, tangent[0]);
        b.high = rig_clamp_here(&b.r, SEGMENTS, tangent[1]);
        roll(&b, twists[k] * length);
        rig_run(&b.r, 1e-3, 1);
        rig_relax(&b.r, 1e-3, 1e-7, 4000);
        for (uint32_t i = 0; i <= SEGMENTS; i++) {
            expect_near(0.0, vec3_distance(x[i], rig_position(&b.r, i)) / radius, 0.005);
        }
        const double torque = torsion * twists[k];
        const double force = cosine / radius * (torque - bending * torsion_of_curve);
        const vec3 moment =
            vec3_add_scaled(vec3_scale(tangent[1], torque), bending * curvature, binormal);
        const vec3 measured = rig_reaction_force(&b.r, b.high),
                   measured_moment = rig_reaction_torque(&b.r, b.high);
        const double moment_scale = bending * curvature, force_scale = moment_scale / radius;
        expect_near(0.0, vec3_distance(vec3_make(0.0, 0.0, force), measured) / force_scale, 0.02);
        expect_near(0.0, vec3_distance(moment, measured_moment) / moment_scale, 0.02);
        rig_end(&b.r);
    }
}

int test_twist_equilibria(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(twisted_ring_buckles_at_michells_twist),
        cmocka_unit_test(straight_thread_writhes_at_greenhills_torque),
        cmocka_unit_test(tense_thread_writhes_at_greenhills_torque),
        cmocka_unit_test(helix_needs_force_and_moment_of_love),
    };
    return cmocka_run_group_tests_name("thread.twist_equilibria", tests, NULL, NULL);
}
