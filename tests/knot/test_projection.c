/* Diagrams of closed polygons: known knots, the same knot from everywhere, and what is refused. */
#include "base/elementary.h"
#include "knot/diagram.h"

#include <string.h>

#include "oracle/knot_type.h"

static diagram d;

static int begin(void **state)
{
    (void)state;
    diagram_begin(&d, DIAGRAM_CROSSINGS);
    return 0;
}

static int end(void **state)
{
    (void)state;
    diagram_end(&d);
    return 0;
}

static const vec3 up = {0.0, 0.0, 1.0};

static void project_up(void)
{
    assert_int_equal(KNOT_DIAGRAM_REGULAR, diagram_project(&d, up));
}

static void set_polygon(const vec3 *x, uint32_t count)
{
    memcpy(d.x, x, count * sizeof *x);
    d.polygon.count = count;
}

/* ---- known diagrams */

static void trefoil_alternates_with_its_sign(void **state)
{
    (void)state;
    diagram_torus(&d, 2, 3, 40);
    project_up();
    diagram_expect_code("aBcAbC", "+++", &d.code);
    diagram_mirror(&d);
    project_up();
    diagram_expect_code("AbCaBc", "---", &d.code);
    diagram_torus(&d, 2, -3, 40);
    project_up();
    assert_int_equal(-1, d.code.sign[0]);
}

/* The house calls right-handed what the scenes and the oracle do. */
static void throw_crossings_have_its_sign(void **state)
{
    (void)state;
    for (int mirrored = 0; mirrored < 2; mirrored++) {
        diagram_knot(&d, KNOT_OVERHAND, mirrored != 0, 0.3e-3, 10.0);
        diagram_project_plain(&d, 0);
        knot_ops work = 0;
        vbss_knot_gauss_code_simplify(&d.code, &work);
        diagram_expect_code(d.code.over[0] != 0 ? "AbCaBc" : "aBcAbC",
                            mirrored != 0 ? "---" : "+++", &d.code);
        knot_type type = knot_type_of_kind(KNOT_OVERHAND, mirrored != 0);
        assert_int_equal(type.v3, d.code.sign[0]);
    }
}

static void figure_eight_has_two_of_each_sign(void **state)
{
    (void)state;
    diagram_figure_eight(&d, 64);
    project_up();
    assert_int_equal(4, d.code.n);
    int sum = 0;
    for (uint32_t e = 0; e < 8; e++) {
        assert_int_not_equal(d.code.over[e], d.code.over[(e + 1) % 8]);
        sum += d.code.sign[d.code.crossing[e]];
    }
    assert_int_equal(0, sum);
    assert_int_equal(5, diagram_determinant(&d.code));
    assert_int_equal(-1, diagram_v2(&d.code));
}

static void entries_report_positions(void **state)
{
    (void)state;
    static const vec3 x[] = {{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {1, 4, 1}, {1, -4, 1}, {0, -4, 0}};
    set_polygon(x, 6);
    project_up();
    diagram_expect_code("aA", "+", &d.code);
    expect_near(0.25, d.code.position[0], 1e-12);
    expect_near(3.5, d.code.position[1], 1e-12);
}

static void long_edges_cross(void **state)
{
    (void)state;
    static const vec3 far[] = {{10, 10, 0}, {10, 0, 1}, {0, 10, 1}};
    for (uint32_t i = 0; i < 40; i++) {
        d.x[i] = vec3_make(0.01 * i, 0.0, 0.0);
    }
    memcpy(d.x + 40, far, sizeof far);
    d.polygon.count = 43;
    project_up();
    diagram_expect_code("aA", "-", &d.code);
    assert_true(d.code.position[0] > 39.0 && d.code.position[0] < 40.0);
    assert_true(d.code.position[1] > 41.0 && d.code.position[1] < 42.0);
}

static void planar_curve_has_no_crossings(void **state)
{
    (void)state;
    d.polygon.count = 50;
    for (uint32_t i = 0; i < 50; i++) {
        double s, c, r = i % 2 == 0 ? 1.0 : 0.4; /* a star */
        vbss_sincos(0x1.921fb54442d18p2 * i / 50, &s, &c);
        d.x[i] = vec3_make(r * c, r * s, 0.7 * r * c - 0.2 * r * s);
    }
    for (uint32_t k = 0; k < 64; k++) {
        assert_int_equal(KNOT_DIAGRAM_REGULAR, diagram_project(&d, vbss_knot_direction(k)));
        assert_int_equal(0, d.code.n);
    }
    d.polygon.count = 3;
    project_up();
}

/* ---- the same knot */

/* Which is known; NULL: what comes first is what is wanted. */
static void expect_same_from_everywhere(const knot_type *wanted, uint32_t directions)
{
    int64_t determinant = wanted != NULL ? wanted->determinant : -1;
    int64_t v2 = wanted != NULL ? wanted->v2 : 0;
    uint32_t plain = 0;
    for (uint32_t k = 0; k < directions; k++) {
        if (diagram_project(&d, vbss_knot_direction(k)) == KNOT_DIAGRAM_REGULAR) {
            plain++;
            knot_ops work = 0;
            vbss_knot_gauss_code_simplify(&d.code, &work);
            v2 = determinant < 0 ? diagram_v2(&d.code) : v2;
            determinant = determinant < 0 ? diagram_determinant(&d.code) : determinant;
            assert_int_equal(determinant, diagram_determinant(&d.code));
            assert_int_equal(v2, diagram_v2(&d.code));
        }
    }
    assert_true(10 * plain >= 9 * directions);
}

static void scene_knots_are_view_invariant(void **state)
{
    (void)state;
    static const double finest[] = {0.2e-3, 0.5e-3}, far[] = {3.0, 10.0, 100.0};
    for (int kind = 0; kind < KNOT_KINDS; kind++) {
        knot_type wanted = knot_type_of_kind((knot_kind)kind, kind % 2 != 0);
        for (int variant = 0; variant < 6; variant++) {
            diagram_knot(&d, (knot_kind)kind, kind % 2 != 0, finest[variant % 2], far[variant / 2]);
            expect_same_from_everywhere(&wanted, 16);
        }
    }
}

static void torus_knots_are_view_invariant(void **state)
{
    (void)state;
    static const int pairs[][2] = {{2, 1}, {2, 5}, {3, 2}, {3, 4}, {4, 5}, {5, 7}, {7, -3}};
    for (size_t i = 0; i < sizeof pairs / sizeof pairs[0]; i++) {
        int p = pairs[i][0], q = pairs[i][1];
        knot_type wanted = {p % 2 == 0   ? (q < 0 ? -q : q)
                            : q % 2 == 0 ? p
                                         : 1,
                            (p * p - 1) * (q * q - 1) / 24, 0};
        diagram_torus(&d, p, q, 250);
        expect_same_from_everywhere(&wanted, 16);
    }
}

static void any_polygon_is_the_same_from_everywhere(harness_source *source, void *user)
{
    (void)user;
    diagram_random(&d, source, 4 + harness_draw_below(source, 24));
    expect_same_from_everywhere(NULL, 10);
}

/* Turned in its numbers, and seen as the mirror shows it. */
static void any_polygon_keeps_its_diagram(harness_source *source, void *user)
{
    (void)user;
    diagram_random(&d, source, 4 + harness_draw_below(source, 40));
    uint32_t k = diagram_project_plain(&d, harness_draw_below(source, 20));
    vbss_knot_gauss_code_copy(&d.spare, &d.code);
    vec3 direction = vbss_knot_direction(k);
    uint32_t count = d.polygon.count, shift = harness_draw_below(source, count);
    vec3 x[DIAGRAM_VERTICES];
    memcpy(x, d.x, sizeof x);
    for (uint32_t i = 0; i < count; i++) {
        d.x[i] = vec3_scale(x[(i + shift) % count], 1024.0);
    }
    assert_int_equal(KNOT_DIAGRAM_REGULAR, diagram_project(&d, direction));
    assert_int_equal(d.spare.n, d.code.n);
    uint32_t entries = 2 * d.code.n, first = 0;
    while (first < entries && d.spare.position[first] < shift) {
        first++;
    }
    for (uint32_t e = 0; e < entries; e++) {
        uint32_t other = (e + first) % entries;
        double at = d.spare.position[other] - shift;
        expect_near(at < 0.0 ? at + count : at, d.code.position[e], 1e-6);
        assert_int_equal(d.spare.over[other], d.code.over[e]);
        assert_int_equal(d.spare.sign[d.spare.crossing[other]], d.code.sign[d.code.crossing[e]]);
    }
    for (uint32_t i = 0; i < count; i++) {
        d.x[i] = vec3_sub(x[i], vec3_scale(direction, 2.0 * vec3_dot(direction, x[i])));
    }
    assert_int_equal(KNOT_DIAGRAM_REGULAR, diagram_project(&d, direction));
    assert_int_equal(d.spare.n, d.code.n);
    for (uint32_t e = 0; e < entries; e++) {
        assert_int_equal(d.spare.crossing[e], d.code.crossing[e]);
        assert_int_not_equal(d.spare.over[e], d.code.over[e]);
        assert_int_equal(-d.spare.sign[d.spare.crossing[e]], d.code.sign[d.code.crossing[e]]);
    }
}

static void polygons_are_view_invariant(void **state)
{
    (void)state;
    harness_property("same from everywhere", 300, any_polygon_is_the_same_from_everywhere, NULL);
    harness_property("keeps its diagram", 300, any_polygon_keeps_its_diagram, NULL);
}

/* ---- what is refused */

static void expect_degenerate(const vec3 *x, uint32_t count)
{
    set_polygon(x, count);
    assert_int_equal(KNOT_DIAGRAM_DEGENERATE, diagram_project(&d, up));
    diagram_mirror(&d);
    assert_int_equal(KNOT_DIAGRAM_DEGENERATE, diagram_project(&d, up));
}

static void uncertain_crossing_is_degenerate(void **state)
{
    (void)state;
    static const vec3 on_an_edge[] = {{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {1, 0, 1}, {0, 4, 1}};
    static const vec3 just_over[] = {{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {1, -1e-7, 1}, {0, 4, 1}};
    static const vec3 on_a_vertex[] = {{0, 0, 0}, {2, 0, 0},  {4, 0, 0}, {4, 4, 0},
                                       {2, 4, 1}, {2, -4, 1}, {0, -4, 0}};
    static const vec3 along[] = {{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {5, 4, 1},
                                 {3, 0, 1}, {1, 0, 1}, {0, 4, 0}};
    static const vec3 back[] = {{0, 0, 0}, {4, 0, 0}, {2, 0, 1}, {2, 4, 1}};
    static const vec3 upright[] = {{0, 0, 0}, {4, 0, 0}, {4, 0, 1}, {2, 4, 1}};
    static const vec3 touching[] = {{0, 0, 0},     {4, 0, 0},      {4, 4, 0},
                                    {1, 4, 1e-13}, {1, -4, 1e-13}, {0, -4, 0}};
    static const vec3 three_at_once[] = {{-2, 0, 0}, {2, 0, 0},  {2, 2, 0}, {-2, -2, 1},
                                         {2, -3, 1}, {2, -2, 2}, {-2, 2, 2}};
    static const vec3 side_by_side[] = {{0, 0, 0},  {4, 0, 0},         {4, 4, 0},        {1, 4, 1},
                                        {1, -4, 1}, {1 + 1e-7, -4, 1}, {1 + 1e-7, 2, 1}, {3, 2, 1},
                                        {3, 5, 1},  {-1, 5, 1},        {-1, -1, 0}};
    expect_degenerate(side_by_side, 11);
    expect_degenerate(on_an_edge, 5);
    expect_degenerate(just_over, 5);
    expect_degenerate(on_a_vertex, 7);
    expect_degenerate(along, 7);
    expect_degenerate(back, 4);
    expect_degenerate(upright, 4);
    expect_degenerate(touching, 6);
    expect_degenerate(three_at_once, 7);
}

static void small_gap_is_resolved(void **state)
{
    (void)state;
    static const vec3 x[] = {{0, 0, 0},     {4, 0, 0},      {4, 4, 0},
                             {1, 4, 1e-10}, {1, -4, 1e-10}, {0, -4, 0}};
    set_polygon(x, 6);
    project_up();
    assert_int_equal(1, d.code.n);
}

/* Turns of a coil lie on each other when seen along it. */
static void coil_along_axis_is_degenerate(void **state)
{
    (void)state;
    d.polygon.count = 104;
    for (uint32_t i = 0; i < 100; i++) {
        double s, c;
        vbss_sincos(0x1.921fb54442d18p2 * i / 20, &s, &c);
        d.x[i] = vec3_make(c, s, 0.05 * i);
    }
    d.x[100] = vec3_make(8.0, -1.0, 5.0);
    d.x[101] = vec3_make(8.0, -1.0, 2.0);
    d.x[102] = vec3_make(9.0, -0.5, -4.0);
    d.x[103] = vec3_make(8.0, 1.0, -4.0);
    assert_int_equal(KNOT_DIAGRAM_DEGENERATE, diagram_project(&d, up));
    const knot_type none = {1, 0, 0};
    expect_same_from_everywhere(&none, 30);
}

static void non_finite_numbers_are_degenerate(void **state)
{
    (void)state;
    diagram_torus(&d, 2, 3, 40);
    for (int k = 0; k < 3; k++) {
        d.x[7].y = harness_bad_numbers[k];
        assert_int_equal(KNOT_DIAGRAM_DEGENERATE, diagram_project(&d, up));
    }
    for (uint32_t i = 0; i < 40; i++) {
        d.x[i] = vec3_zero();
    }
    assert_int_equal(KNOT_DIAGRAM_DEGENERATE, diagram_project(&d, up));
}

static void full_code_is_reported(void **state)
{
    (void)state;
    static diagram small;
    for (uint32_t capacity = 1; capacity <= 3; capacity++) {
        diagram_begin(&small, capacity);
        diagram_torus(&small, 2, 3, 40);
        assert_int_equal(capacity < 3 ? KNOT_DIAGRAM_FULL : KNOT_DIAGRAM_REGULAR,
                         diagram_project(&small, up));
        diagram_end(&small);
    }
}

/* ---- directions */

static void directions_are_generic_and_spread(void **state)
{
    (void)state;
    for (uint32_t k = 0; k < 64; k++) {
        vec3 a = vbss_knot_direction(k);
        expect_near(1.0, vec3_norm(a), 1e-15);
        for (int i = 0; i < 27; i++) {
            int x = i % 3 - 1, y = i / 3 % 3 - 1, z = i / 9 - 1;
            vec3 b = vec3_make(x, y, z);
            assert_true(i == 13 || vec3_dot(a, vec3_unit_or(b, up)) < vbss_cos(0.07));
        }
        for (uint32_t j = 0; j < k; j++) {
            double smallest = k < 4 ? 0.9 : k < 12 ? 0.52 : 0.2;
            assert_true(fabs(vec3_dot(a, vbss_knot_direction(j))) < vbss_cos(smallest));
        }
    }
    expect_near(1.0, vec3_norm(vbss_knot_direction(UINT32_MAX)), 1e-15);
}

int test_projection(void)
{
    const struct CMUnitTest tests[] = {
        harness_test(trefoil_alternates_with_its_sign),
        harness_test(throw_crossings_have_its_sign),
        harness_test(figure_eight_has_two_of_each_sign),
        harness_test(entries_report_positions),
        harness_test(long_edges_cross),
        harness_test(planar_curve_has_no_crossings),
        harness_test(scene_knots_are_view_invariant),
        harness_test(torus_knots_are_view_invariant),
        harness_test(polygons_are_view_invariant),
        harness_test(uncertain_crossing_is_degenerate),
        harness_test(small_gap_is_resolved),
        harness_test(coil_along_axis_is_degenerate),
        harness_test(non_finite_numbers_are_degenerate),
        harness_test(full_code_is_reported),
        harness_test(directions_are_generic_and_spread),
    };
    return cmocka_run_group_tests_name("projection", tests, begin, end);
}
