/* The arc length of what is nearest to a point: of the arc, and of the straight lines beyond its ends. */
#include "fixture.h"

static const double arcs[] = {PI, 2.0, 5.0};

static needle_object *begin_with(fixture *f, double arc)
{
    begin(f);
    f->config.arc = arc;
    return inside(make(f));
}

/* Across the line, in its plane and along z. */
static vec3 beside(const needle_object *n, double at, double outward, double up)
{
    vec3 d = vbss_needle_direction(n, at), out = vec3_cross(d, vec3_make(0.0, 0.0, 1.0));
    vec3 p = vec3_add_scaled(vbss_needle_point(n, at), outward, out);
    return vec3_add_scaled(p, up, vec3_make(0.0, 0.0, 1.0));
}

static void points_beside_arc_have_its_arc_length(void **state)
{
    (void)state;
    for (int k = 0; k < 3; k++) {
        fixture f;
        needle_object *n = begin_with(&f, arcs[k]);
        double length = vbss_needle_length(n);
        for (int i = 0; i <= 20; i++) {
            double at = length * (0.01 + 0.98 * i / 20.0);
            for (int j = -2; j <= 2; j++) {
                double off = 1e-3 * j;
                expect_near(at, vbss_needle_nearest_arc(n, beside(n, at, off, -off)), 1e-15);
            }
        }
        end(&f);
    }
}

static void arc_length_continues_beyond_ends(void **state)
{
    (void)state;
    for (int k = 0; k < 3; k++) {
        fixture f;
        needle_object *n = begin_with(&f, arcs[k]);
        double length = vbss_needle_length(n);
        for (int i = 1; i <= 150; i++) {
            double far = 1e-5 * i;
            for (int j = -2; j <= 2; j++) {
                double off = 0.25e-3 * j;
                expect_near(-far, vbss_needle_nearest_arc(n, beside(n, -far, off, off)), 1e-15);
                vec3 behind = beside(n, length + far, off, off);
                expect_near(length + far, vbss_needle_nearest_arc(n, behind), 1e-15);
            }
        }
        end(&f);
    }
}

/* What slides over an end does not jump there. */
static void arc_length_is_continuous_across_ends(void **state)
{
    (void)state;
    for (int k = 0; k < 3; k++) {
        fixture f;
        needle_object *n = begin_with(&f, arcs[k]);
        const double ends[] = {0.0, vbss_needle_length(n)};
        for (int e = 0; e < 2; e++) {
            double before = vbss_needle_nearest_arc(n, beside(n, ends[e] - 1e-5, 1e-4, 1e-4));
            for (int i = -99; i <= 100; i++) {
                double at = ends[e] + 1e-7 * i;
                double now = vbss_needle_nearest_arc(n, beside(n, at, 1e-4, 1e-4));
                expect_near(1e-7, now - before, 1e-13);
                before = now;
            }
        }
        end(&f);
    }
}

/* None of ten thousand places on it is nearer. */
static void nothing_of_the_line_is_nearer(harness_source *source, void *user)
{
    enum { PLACES = 10000 };
    const needle_object *n = user;
    double length = vbss_needle_length(n), far = 1e-3;
    double at = harness_draw_real(source, 0.0, length);
    double off = harness_draw_real(source, -1e-3, 1e-3);
    double up = harness_draw_real(source, -1e-3, 1e-3);
    vec3 point = beside(n, at, off, up);
    double smallest = vec3_distance(point, vbss_needle_point(n, vbss_needle_nearest_arc(n, point)));
    for (int i = 0; i <= PLACES; i++) {
        double place = -far + (length + 2.0 * far) * i / PLACES;
        assert_true(vec3_distance(point, vbss_needle_point(n, place)) > smallest - 1e-12);
    }
}

static void nearest_point_is_minimal(void **state)
{
    (void)state;
    for (int k = 0; k < 3; k++) {
        fixture f;
        needle_object *n = begin_with(&f, arcs[k]);
        harness_property("nearest", 40, nothing_of_the_line_is_nearer, n);
        end(&f);
    }
}

int test_needle_nearest(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(points_beside_arc_have_its_arc_length),
        cmocka_unit_test(arc_length_continues_beyond_ends),
        cmocka_unit_test(arc_length_is_continuous_across_ends),
        harness_test(nearest_point_is_minimal),
    };
    return cmocka_run_group_tests_name("needle.needle_nearest", tests, NULL, NULL);
}
