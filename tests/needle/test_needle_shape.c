/* What a needle weighs and where its middle line goes, against sums over its volume and circles drawn anew. */
#include "base/rotation.h"
#include "fixture.h"

/* ---- the volume of a bent wire, summed up point by point */

/* Gauss and Legendre's five points on -1 .. 1, exact up to the ninth power (Abramowitz and Stegun, table 25.4). */
static const double nodes[5] = {-0.906179845938663992797627, -0.538469310105683091036314, 0.0,
                                0.538469310105683091036314, 0.906179845938663992797627};
static const double weights[5] = {0.236926885056189087514264, 0.478628670499366468041292,
                                  0.568888888888888888888889, 0.478628670499366468041292,
                                  0.236926885056189087514264};

enum { ALONG = 24, AROUND = 8 }; /* parts of the arc; corners about the wire: exact up to cos^7 */

typedef void (*summand)(double volume, vec3 at, void *sums);

/* The needle bent about z: the tip at angle 0, the swage at -arc. */
static void sum_over_volume(const vbss_needle_config *c, summand add, void *sums)
{
    double r = c->wire_radius, part = c->arc / ALONG;
    for (int i = 0; i < 5 * ALONG; i++) {
        int along = i / 5;
        double theta = -part * (along + 0.5 + 0.5 * nodes[i % 5]);
        for (int j = 0; j < 5 * AROUND; j++) {
            int around = j / 5;
            double u = 0.5 * r * (1.0 + nodes[j % 5]), psi = 2.0 * PI * around / AROUND;
            double q = c->radius + u * cos(psi);
            double volume = 0.5 * part * weights[i % 5] * 0.5 * r * weights[j % 5] * u *
                            (2.0 * PI / AROUND) * q;
            add(volume, vec3_make(q * cos(theta), q * sin(theta), u * sin(psi)), sums);
        }
    }
}

typedef struct first_sums {
    double volume;
    vec3 from, moment; /* of the way from there */
} first_sums;

static void add_first(double volume, vec3 at, void *sums)
{
    first_sums *s = sums;
    s->volume += volume;
    s->moment = vec3_add_scaled(s->moment, volume, vec3_sub(at, s->from));
}

typedef struct second_sums {
    vec3 centre, axes[3];
    double moments[3][3]; /* of the offsets along two axes */
} second_sums;

static void add_second(double volume, vec3 at, void *sums)
{
    second_sums *s = sums;
    vec3 offset = vec3_sub(at, s->centre);
    for (int i = 0; i < 3; i++) {
        for (int j = 0; j < 3; j++) {
            s->moments[i][j] +=
                volume * vec3_dot(offset, s->axes[i]) * vec3_dot(offset, s->axes[j]);
        }
    }
}

static void expect_exact(vbss_needle *needle)
{
    const vbss_needle_config *c = &inside(needle)->config;
    const vbss_needle_mass m = weigh(needle);
    first_sums first = {.from = vec3_make(c->radius, 0.0, 0.0)};
    sum_over_volume(c, add_first, &first);
    expect_near(1.0, m.mass / (c->density * first.volume), 1e-13);
    expect_near(1.0, m.length / (c->radius * c->arc), 1e-15);
    second_sums second = {.centre = vec3_load(m.centre)};
    vec3 centre = vec3_add_scaled(first.from, 1.0 / first.volume, first.moment);
    expect_near_vec3(centre, second.centre, 1e-13 * c->radius);
    for (int i = 0; i < 3; i++) {
        second.axes[i] = vec3_load(m.axes[i]);
    }
    expect_near_vec3(vec3_cross(second.axes[0], second.axes[1]), second.axes[2], 1e-15);
    sum_over_volume(c, add_second, &second);
    for (int i = 0; i < 3; i++) {
        int j = (i + 1) % 3, k = (i + 2) % 3;
        double wanted = c->density * (second.moments[j][j] + second.moments[k][k]);
        double size = sqrt(second.moments[i][i] * second.moments[j][j]);
        expect_near(1.0, m.inertia[i] / wanted, 2e-13);
        expect_near(0.0, second.moments[i][j], 1e-12 * size);
    }
}

static void mass_and_inertia_are_of_volume(void **state)
{
    (void)state;
    static const double arcs[] = {0.1, 0.5, 1.5707963267948966, PI, 4.5, 6.0};
    fixture f;
    begin(&f);
    for (size_t i = 0; i < sizeof arcs / sizeof arcs[0]; i++) {
        f.config.arc = arcs[i];
        f.config.radius = 10.5e-3;
        f.config.wire_radius = 0.35e-3;
        expect_exact(make(&f));
        f.config.wire_radius = 0.2 * f.config.radius; /* a thick one */
        expect_exact(make(&f));
        f.config.radius = 1.0; /* and a hair */
        f.config.wire_radius = 1e-6;
        expect_exact(make(&f));
    }
    end(&f);
}

/* The half circle of thin wire, as textbooks have it: centre at 2 R/pi. */
static void thin_half_circle_matches_textbook(void **state)
{
    (void)state;
    fixture f;
    begin(&f);
    f.config.wire_radius = 1e-6;
    const vbss_needle_mass m = weigh(make(&f));
    double r = f.config.radius, unit = m.mass * r * r;
    expect_near_vec3(vec3_make(0.0, -2.0 / PI * r, 0.0), vec3_load(m.centre), 1e-8 * r);
    expect_near(0.5 * unit, m.inertia[0], 1e-7 * unit);
    expect_near((0.5 - 4.0 / (PI * PI)) * unit, m.inertia[1], 1e-7 * unit);
    expect_near((1.0 - 4.0 / (PI * PI)) * unit, m.inertia[2], 1e-7 * unit);
    expect_near_vec3(vec3_make(0.0, -1.0, 0.0), vec3_load(m.axes[0]), 1e-15);
    expect_near_vec3(vec3_make(1.0, 0.0, 0.0), vec3_load(m.axes[1]), 1e-15);
    expect_near_vec3(vec3_make(0.0, 0.0, 1.0), vec3_load(m.axes[2]), 1e-15);
    end(&f);
}

/* ---- the middle line */

static void place(vbss_needle *needle, double arc_length, vec3 *position, vec3 *direction)
{
    double p[3], d[3];
    expect_ok(vbss_needle_get_place(needle, arc_length, p, d));
    *position = vec3_load(p);
    *direction = vec3_load(d);
}

/* At any pose. */
static void begin_turned(fixture *f, pose *at)
{
    begin(f);
    *at = pose_make(vec3_make(0.1, -0.2, 0.3),
                    vbss_quat_from_rotation_vector(vec3_make(0.7, -0.4, 1.1)));
    vec3_store(f->config.position, at->position);
    set_orientation(f, at->orientation);
}

static void ends_match_header(void **state)
{
    (void)state;
    static const double arcs[] = {PI, 0.1, 2.0, 6.0};
    fixture f;
    pose at;
    begin_turned(&f, &at);
    for (size_t i = 0; i < sizeof arcs / sizeof arcs[0]; i++) {
        f.config.arc = arcs[i];
        double a = arcs[i], r = f.config.radius;
        const vbss_needle_state s = get_state(make(&f));
        vec3 swage = vec3_make(r * cos(a), -r * sin(a), 0.0);
        expect_near_vec3(pose_apply(at, vec3_make(r, 0.0, 0.0)), vec3_load(s.tip), 1e-15);
        expect_near_vec3(pose_apply(at, swage), vec3_load(s.swage), 1e-15);
        expect_near_vec3(quat_rotate(at.orientation, vec3_make(0.0, 1.0, 0.0)),
                         vec3_load(s.tip_direction), 1e-15);
        expect_near_vec3(quat_rotate(at.orientation, vec3_make(-sin(a), -cos(a), 0.0)),
                         vec3_load(s.swage_direction), 1e-15);
    }
    end(&f);
}

static void places_lie_on_arc_at_length(void **state)
{
    (void)state;
    fixture f;
    pose at;
    begin_turned(&f, &at);
    f.config.arc = 4.0;
    vbss_needle *needle = make(&f);
    double length = weigh(needle).length, r = f.config.radius, ds = 1e-6 * length;
    for (int i = 0; i <= 40; i++) {
        double s = length * i / 40.0;
        vec3 p, d, before, after, unused;
        place(needle, s, &p, &d);
        vec3 own = pose_apply_inverse(at, p);
        expect_near(r, vec3_norm(own), 1e-15);
        expect_near(0.0, own.z, 1e-15);
        expect_near_vec3(vec3_make(r * cos(s / r), -r * sin(s / r), 0.0), own, 1e-15);
        expect_near(1.0, vec3_norm(d), 1e-15);
        place(needle, s - ds, &before, &unused);
        place(needle, s + ds, &after, &unused);
        expect_near_vec3(vec3_scale(vec3_sub(before, after), 0.5 / ds), d, 1e-5);
    }
    end(&f);
}

static void line_is_straight_beyond_ends(void **state)
{
    (void)state;
    fixture f;
    pose at;
    begin_turned(&f, &at);
    vbss_needle *needle = make(&f);
    double length = weigh(needle).length;
    const vbss_needle_state s = get_state(needle);
    const double distances[] = {1e-9, 1e-3, 0.3, 9.9};
    for (int i = 0; i < 4; i++) {
        vec3 p, d;
        place(needle, -distances[i], &p, &d);
        expect_near_vec3(vec3_load(s.tip_direction), d, 1e-15);
        expect_near_vec3(vec3_add_scaled(vec3_load(s.tip), distances[i], d), p,
                         1e-15 * (1.0 + distances[i]));
        place(needle, length + distances[i], &p, &d);
        expect_near_vec3(vec3_load(s.swage_direction), vec3_neg(d), 1e-15);
        expect_near_vec3(vec3_add_scaled(vec3_load(s.swage), -distances[i], d), p,
                         2e-15 * (1.0 + distances[i]));
    }
    double p[3];
    expect_ok(vbss_needle_get_place(needle, 0.0, p, NULL));
    expect_near_vec3(vec3_load(s.tip), vec3_load(p), 0.0);
    end(&f);
}

static void view_shows_capsule_ends_on_arc(void **state)
{
    (void)state;
    static const uint32_t counts[] = {2, 8, 64};
    fixture f;
    pose at;
    begin_turned(&f, &at);
    vec3_store(f.config.angular_velocity, vec3_make(3.0, 20.0, -10.0));
    for (int k = 0; k < 3; k++) {
        f.config.segment_count = counts[k];
        vbss_needle *needle = make(&f);
        vbss_view view;
        expect_ok(vbss_needle_get_view(needle, VBSS_NEEDLE_VIEW_POINTS, &view, sizeof view));
        uint64_t generation = view.generation;
        steps(needle, 1e-3, 10);
        expect_ok(vbss_needle_get_view(needle, VBSS_NEEDLE_VIEW_POINTS, &view, sizeof view));
        assert_true(view.generation != generation);
        assert_int_equal(view.type, VBSS_VIEW_TYPE_F64);
        assert_int_equal(view.components, 3);
        assert_int_equal(view.stride_bytes, 24);
        assert_int_equal(view.count, counts[k] + 1);
        const double *points = view.data;
        for (uint32_t i = 0; i <= counts[k]; i++) {
            vec3 p, d;
            place(needle, weigh(needle).length * i / counts[k], &p, &d);
            expect_near_vec3(p, vec3_load(points + 3 * (size_t)i), 1e-15);
        }
        const vbss_needle_state s = get_state(needle);
        expect_near_vec3(vec3_load(s.tip), vec3_load(points), 0.0);
        expect_near_vec3(vec3_load(s.swage), vec3_load(points + 3 * (size_t)counts[k]), 0.0);
    }
    end(&f);
}

int test_needle_shape(void)
{
    const struct CMUnitTest tests[] = {
        harness_test(mass_and_inertia_are_of_volume),
        harness_test(thin_half_circle_matches_textbook),
        harness_test(ends_match_header),
        harness_test(places_lie_on_arc_at_length),
        harness_test(line_is_straight_beyond_ends),
        harness_test(view_shows_capsule_ends_on_arc),
    };
    return cmocka_run_group_tests_name("needle.needle_shape", tests, NULL, NULL);
}
