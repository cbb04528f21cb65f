/* Features of very different size, very small ones, and directions that nearly fail: where a certificate
 * that loses its digits would tell a miss. */
#include <string.h>

#include "harness/harness.h"

static vbss_collision_impact ask(double thickness, const double start[12], const double end[12])
{
    vbss_collision_config config;
    vbss_collision_impact impact;
    expect_ok(vbss_collision_config_init(&config, sizeof config));
    config.thickness = thickness;
    expect_ok(vbss_collision_test_edges(&config, start, end, &impact, sizeof impact));
    return impact;
}

/* Edge a, of length L, turns about its begin and sweeps over a short edge b that moves along its path:
 * they cross. The shorter b, the smaller all products with their common normal. */
static bool sweep_hits(double thickness, double length, double half, int k)
{
    double x = length * (0.2 + 0.003 * k), away = thickness + 128.0 * DBL_EPSILON * length;
    const double start[12] = {0, 0, 0, length, 0, 0, x, -half, 1.05 * away, x, half, 1.05 * away};
    const double end[12] = {0, 0, 0, length, 0, length, x, -half, 0.4 * away, x, half, 0.4 * away};
    return ask(thickness, start, end).hit != 0;
}

static void short_edge_beside_long_edge_is_hit(void **state)
{
    (void)state;
    double length = 1.0;
    for (int i = 0; i < 17; i++) {
        double half = length * 1e-20;
        for (int n = 0; n < 60 && half > 1e-290; n++) {
            for (int k = 0; k < 20; k++) {
                assert_true(sweep_hits(0.0, length, half, k));
                if (length < 1e-13) {
                    assert_true(sweep_hits(1e-30, length, half, k));
                }
            }
            half *= 1e-4;
        }
        length *= 1e-3;
    }
}

/* The same question in any unit has the same answer. */
static void an_answer_without_thickness_has_no_unit(harness_source *source, void *user)
{
    (void)user;
    double start[12], end[12], units[] = {0x1p-20, 0x1p-100, 0x1p-170, 0x1p-300, 0x1p-900, 0x1p40};
    for (int i = 0; i < 12; i++) {
        start[i] = (double)harness_draw_below(source, 5) - 2.0;
        end[i] = (double)harness_draw_below(source, 5) - 2.0;
    }
    vbss_collision_impact wanted = ask(0.0, start, end);
    for (size_t u = 0; u < sizeof units / sizeof units[0]; u++) {
        double s[12], e[12];
        for (int i = 0; i < 12; i++) {
            s[i] = units[u] * start[i];
            e[i] = units[u] * end[i];
        }
        vbss_collision_impact got = ask(0.0, s, e);
        assert_int_equal(wanted.hit, got.hit);
        assert_true(got.decision != VBSS_COLLISION_DECISION_UNDECIDED);
    }
}

static void queries_in_any_unit(void **state)
{
    (void)state;
    harness_property("no unit", 2000, an_answer_without_thickness_has_no_unit, NULL);
}

/* Crossings through the inside, at a good angle: the time is that of the crossing. */
static void crossing_at(harness_source *source, void *user)
{
    uint32_t *hits = user;
    double start[12], end[12];
    vec3 a = harness_draw_vec3(source, -1.0, 1.0), b = harness_draw_vec3(source, -1.0, 1.0);
    vec3 n = vec3_cross(a, b), place = harness_draw_vec3(source, -1.0, 1.0);
    double when = harness_draw_real(source, 0.05, 0.95), size = vec3_norm(n);
    if (size < 0.2) {
        return;
    }
    for (int k = 0; k < 2; k++) {
        double sign = k == 0 ? -1.0 : 1.0;
        vec3_store(start + 3 * (size_t)k, vec3_add_scaled(place, sign, a));
        vec3_store(end + 3 * (size_t)k, vec3_add_scaled(place, sign, a));
        vec3 at = vec3_add_scaled(place, sign, b);
        vec3_store(start + 6 + 3 * (size_t)k, vec3_add_scaled(at, when, n));
        vec3_store(end + 6 + 3 * (size_t)k, vec3_add_scaled(at, when - 1.0, n));
    }
    vbss_collision_impact impact = ask(0.0, start, end);
    assert_int_equal(impact.hit, 1);
    assert_int_equal(impact.decision, VBSS_COLLISION_DECISION_EXACT);
    assert_true(impact.time <= when + 1e-13);
    expect_near(when, impact.time, 1e-11);
    assert_true(impact.distance < 1e-12);
    ++*hits;
}

static void crossing_time_is_accurate(void **state)
{
    (void)state;
    uint32_t hits = 0;
    harness_property("crossing", 500, crossing_at, &hits);
    assert_true(hits > 200);
}

/* ---- motion that turns: passes are many, hits are told near their place all the same */

typedef struct turning {
    uint32_t hits, far, max_passes;
} turning;

static void turning_at(harness_source *source, void *user)
{
    turning *t = user;
    double start[12], end[12];
    for (int i = 0; i < 12; i++) {
        start[i] = harness_draw_real(source, -1.0, 1.0);
        end[i] = harness_draw_real(source, -1.0, 1.0);
    }
    vbss_collision_impact impact = ask(0.0, start, end);
    if (impact.hit != 0) {
        t->hits++;
        t->far += impact.distance > 1e-12;
        t->max_passes = impact.passes > t->max_passes ? impact.passes : t->max_passes;
        assert_true(impact.distance < 1e-2);
    }
}

static void thin_hit_place_is_accurate(void **state)
{
    (void)state;
    turning t = {0};
    harness_property("turning", 10000, turning_at, &t);
    assert_true(t.hits > 1000 && t.far < t.hits / 100);
    assert_true(t.max_passes > 32 && t.max_passes <= 256);
}

/* ---- small integers, and one number of which the last bit is `places` below their first */

static void spread(harness_source *source, void *user)
{
    double start[12], end[12];
    uint32_t *hits = user, place = harness_draw_below(source, 24);
    for (int i = 0; i < 12; i++) {
        start[i] = (double)harness_draw_below(source, 5) - 2.0;
        end[i] = (double)harness_draw_below(source, 5) - 2.0;
    }
    double tiny =
        harness_draw_real(source, 1.0, 2.0) * 0x1p-196; /* 2 has bit 1, the last is -248 */
    *(place < 12 ? &start[place] : &end[place - 12]) = tiny;
    vbss_collision_impact impact = ask(0.0, start, end);
    assert_true(impact.decision != VBSS_COLLISION_DECISION_UNDECIDED);
    *hits += impact.hit != 0;
}

static void scattered_magnitudes_are_decided_without_object(void **state)
{
    (void)state;
    uint32_t hits = 0;
    harness_property("spread", 20000, spread, &hits);
    assert_true(hits > 1000);
}

int test_extremes(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(short_edge_beside_long_edge_is_hit),
        harness_test(queries_in_any_unit),
        harness_test(crossing_time_is_accurate),
        harness_test(thin_hit_place_is_accurate),
        harness_test(scattered_magnitudes_are_decided_without_object),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
