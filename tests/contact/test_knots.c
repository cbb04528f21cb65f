/* The knots of the scenes are the knots they are called, and calm ones. */
#include "base/elementary.h"
#include "harness/harness.h"
#include "oracle/knot_type.h"
#include "fixtures/knots.h"

#define PI 3.141592653589793

enum { FINE_NODES = 16000 };
static vec3 positions[FINE_NODES];
static double rest_lengths[FINE_NODES];

static knot_line make(const knot_shape *shape)
{
    knot_line line;
    expect_ok(knot_make(shape, FINE_NODES, positions, rest_lengths, &line));
    return line;
}

/* With l (m) everywhere. */
static knot_line make_evenly(knot_shape shape, double l)
{
    shape.finest = shape.coarsest = l;
    return make(&shape);
}

/* Runs `check` on every kind, free and round cylinders of some radii (m; 0: free). */
static void for_all(void (*check)(const knot_shape *shape))
{
    static const double radii[] = {0.0, 1e-3, 2.5e-3, 4e-3};
    for (int kind = 0; kind < KNOT_KINDS; kind++) {
        for (size_t i = 0; i < sizeof radii / sizeof radii[0]; i++) {
            knot_shape shape;
            knot_shape_init(&shape, (knot_kind)kind);
            shape.cylinder = radii[i] > 0.0;
            shape.cylinder_radius = shape.cylinder ? radii[i] : shape.cylinder_radius;
            check(&shape);
        }
    }
}

/* ---- topology */

static void has_its_type(const knot_shape *shape)
{
    for (int mirrored = 0; mirrored < 2; mirrored++) {
        knot_shape s = *shape;
        s.mirrored = mirrored != 0;
        knot_line line = make(&s);
        knot_type type;
        assert_true(knot_type_of(positions, line.node_count, &type));
        assert_true(knot_type_same(type, knot_type_of_kind(s.kind, s.mirrored)));
    }
}

static void each_knot_shape_has_its_type(void **state)
{
    (void)state;
    for_all(has_its_type);
}

/* Turns about the cylinder of the thread whose ends are joined far away, on the side where the tail is. */
static double turns_about_cylinder(const knot_line *line)
{
    double turns = 0.0, x = line->cylinder_begin.x, z = line->cylinder_begin.z;
    uint32_t n = line->node_count;
    vec3 far_away = vec3_make(0.0, 0.0, positions[0].z > z ? 1e3 : -1e3);
    for (uint32_t i = 0; i <= n; i++) {
        vec3 a = i == 0 ? far_away : positions[i - 1], b = i == n ? far_away : positions[i];
        double turn = vbss_atan2(b.z - z, b.x - x) - vbss_atan2(a.z - z, a.x - x);
        turns += turn > PI ? turn - 2.0 * PI : turn < -PI ? turn + 2.0 * PI : turn;
    }
    return turns / (2.0 * PI);
}

static void goes_round(const knot_shape *shape)
{
    if (shape->cylinder) {
        knot_line line = make(shape);
        expect_near(1.0, fabs(turns_about_cylinder(&line)), 1e-9);
        assert_true(line.cylinder_begin.y < 0.0 && line.cylinder_end.y > 0.0);
        expect_same_bits(shape->cylinder_radius, line.cylinder_radius);
    }
}

static void cylinder_passes_through_loop(void **state)
{
    (void)state;
    for_all(goes_round);
}

/* ---- room */

static double clamp(double x)
{
    return x < 0.0 ? 0.0 : x > 1.0 ? 1.0 : x;
}

static double distance(const vec3 *a, const vec3 *b)
{
    vec3 u = vec3_sub(a[1], a[0]), v = vec3_sub(b[1], b[0]), r = vec3_sub(a[0], b[0]);
    double uu = vec3_dot(u, u), vv = vec3_dot(v, v), uv = vec3_dot(u, v);
    double d = uu * vv - uv * uv;
    double s = d > 0.0 ? clamp((uv * vec3_dot(v, r) - vv * vec3_dot(u, r)) / d) : 0.0;
    double t = clamp((uv * s + vec3_dot(v, r)) / vv);
    s = clamp((uv * t - vec3_dot(u, r)) / uu);
    return vec3_norm(vec3_add_scaled(vec3_add_scaled(r, s, u), -t, v));
}

static void keeps_away(const knot_shape *shape)
{
    double diameter = 2.0 * shape->thread_radius, l = 0.15e-3;
    knot_line line = make_evenly(*shape, l);
    for (uint32_t i = 0; i + 1 < line.node_count; i++) {
        for (uint32_t j = i + 2; j + 1 < line.node_count; j++) {
            if ((j - i - 1) * l >= 1.6 * diameter) {
                assert_true(distance(positions + i, positions + j) >= 1.3 * diameter);
            }
        }
        vec3 axis[2] = {line.cylinder_begin, line.cylinder_end};
        double reach = shape->cylinder_radius + shape->thread_radius;
        assert_true(!shape->cylinder || distance(positions + i, axis) >= 1.3 * reach);
    }
}

static void strands_clear_each_other_and_cylinder(void **state)
{
    (void)state;
    for_all(keeps_away);
}

static void is_as_large_as_asked(const knot_shape *shape)
{
    knot_shape s = *shape;
    s.size = 5.5 * s.thread_radius; /* the least that is taken */
    keeps_away(&s);
    s.size = 1.7e-3;
    s.length = 0.3;
    keeps_away(&s);
}

static void strands_clear_at_any_scale(void **state)
{
    (void)state;
    for_all(is_as_large_as_asked);
}

/* Curvature at node i of an evenly meshed curve, by differences; 1/m. */
static vec3 curvature(uint32_t i, double l)
{
    vec3 twice =
        vec3_sub(vec3_add(positions[i - 1], positions[i + 1]), vec3_scale(positions[i], 2.0));
    return vec3_scale(twice, 1.0 / (l * l));
}

static void is_at_rest(const knot_shape *shape)
{
    double l = 10e-6;
    knot_line line = make_evenly(*shape, l);
    for (uint32_t i = 1; i + 2 < line.node_count; i++) {
        vec3 here = curvature(i, l), there = curvature(i + 1, l);
        assert_true(vec3_norm(here) * shape->size <= 1.0);
        /* A curve whose curvature jumps would jump by some tenths. */
        assert_true(vec3_distance(here, there) * shape->size <= 0.06);
    }
}

static void curvature_is_small_and_continuous(void **state)
{
    (void)state;
    for_all(is_at_rest);
}

/* ---- ends */

static void leaves_straight(const knot_shape *shape)
{
    knot_line line = make(shape);
    uint32_t last = line.node_count - 1;
    for (uint32_t i = 0; i < last; i++) {
        vec3 along = vec3_sub(positions[i + 1], positions[i]);
        if (i < line.knot_first || i >= line.knot_last) {
            expect_near(rest_lengths[i], along.x, 1e-15); /* y and z: nothing is left for them */
            expect_near(0.0, along.y, 1e-15);
            expect_near(0.0, along.z, 1e-15);
        }
    }
    assert_true(line.knot_first > 0 && line.knot_last < last);
    expect_near(0.0, positions[last].y, 1e-15);
    /* Beyond all else of the thread: pulled, they go nowhere but out. */
    for (uint32_t i = line.knot_first; i <= line.knot_last; i++) {
        assert_true(positions[i].x > positions[0].x && positions[i].x < positions[last].x);
    }
}

static void ends_leave_straight_and_opposite(void **state)
{
    (void)state;
    for_all(leaves_straight);
}

static void tail_length_is_configurable(void **state)
{
    (void)state;
    knot_shape shape;
    knot_shape_init(&shape, KNOT_FLS);
    shape.tail = 0.015;
    knot_line line = make(&shape);
    double before = 0.0, knot = 0.0;
    for (uint32_t i = 0; i < line.knot_last; i++) {
        *(i < line.knot_first ? &before : &knot) += rest_lengths[i];
    }
    expect_near(0.015, before, 1e-15);
    expect_near(line.knot_length, knot, 1e-15);
}

/* ---- mesh */

static void is_graded(const knot_shape *shape)
{
    knot_line line = make(shape);
    double sum = 0.0, l = 0.0;
    uint32_t coarse = 0;
    for (uint32_t i = 0; i + 1 < line.node_count; i++) {
        bool in_knot = i >= line.knot_first && i < line.knot_last;
        double ratio = i == 0 ? 1.0 : vbss_max(rest_lengths[i] / l, l / rest_lengths[i]);
        l = rest_lengths[i];
        assert_true(ratio <= shape->ratio * 1.02); /* 1.02: the knot's own l is rounded down */
        assert_true(l <= (in_knot ? shape->finest : shape->coarsest) * (1.0 + 1e-12));
        assert_true(l >= 0.9 * shape->finest);
        coarse += l > 0.9 * shape->coarsest ? 1 : 0;
        sum += l;
    }
    expect_near(shape->length, sum, 1e-14);
    assert_true(coarse >= 2);
    assert_true(line.node_count <= KNOT_NODES);
}

static void mesh_is_fine_in_knot_and_coarsens_away(void **state)
{
    (void)state;
    for_all(is_graded);
}

static void standard_mesh_node_counts(void **state)
{
    (void)state;
    static const uint32_t nodes[KNOT_KINDS][2] = {{151, 182}, {179, 208}, {208, 237}, {238, 267},
                                                  {238, 267}, {274, 303}, {332, 361}, {243, 288},
                                                  {251, 303}, {296, 325}};
    for (int kind = 0; kind < KNOT_KINDS; kind++) {
        for (int cylinder = 0; cylinder < 2; cylinder++) {
            knot_shape shape;
            knot_shape_init(&shape, (knot_kind)kind);
            shape.cylinder = cylinder != 0;
            assert_int_equal(nodes[kind][cylinder], make(&shape).node_count);
        }
    }
}

/* Between nodes of a coarse mesh lie 50 segments of a fine one. */
static void arc_is_of_curve_and_chord_of_nodes(void **state)
{
    (void)state;
    static vec3 coarse[FINE_NODES];
    knot_shape shape;
    knot_shape_init(&shape, KNOT_DOUBLE_OVERHAND);
    shape.rest = KNOT_REST_CHORDS;
    knot_line line = make_evenly(shape, 1e-3);
    for (uint32_t i = 0; i < line.node_count; i++) {
        coarse[i] = positions[i];
        assert_true(i == 0 || rest_lengths[i - 1] == vec3_distance(positions[i - 1], positions[i]));
    }
    shape.rest = KNOT_REST_ARCS;
    make_evenly(shape, 20e-6);
    for (uint32_t i = 0; i + 1 < line.node_count; i++) {
        double sum = 0.0;
        expect_near(0.0, vec3_distance(coarse[i], positions[(size_t)50 * i]), 1e-14);
        for (uint32_t k = 50 * i; k < 50 * i + 50; k++) {
            expect_near(20e-6, rest_lengths[k], 1e-18);
            sum += vec3_distance(positions[k], positions[k + 1]);
        }
        expect_near(1e-3, sum, 2e-8); /* chords of 20 um where the radius is 1.1 mm */
    }
}

/* ---- refusals */

static void refuses(vbss_result wanted, knot_shape shape)
{
    knot_line line;
    expect_result(wanted, knot_make(&shape, FINE_NODES, positions, rest_lengths, &line));
}

static void impossible_knot_is_rejected(void **state)
{
    (void)state;
    knot_shape good, shape;
    knot_line line;
    knot_shape_init(&good, KNOT_SQUARE);
    expect_result(VBSS_ERROR_CAPACITY, knot_make(&good, 10, positions, rest_lengths, &line));
    assert_int_equal(238, line.node_count);
    expect_ok(knot_make(&good, 238, positions, rest_lengths, &line));
    shape = good;
    shape.length = 0.05;
    refuses(VBSS_ERROR_OUT_OF_RANGE, shape);
    shape = good;
    shape.tail = 0.1;
    refuses(VBSS_ERROR_OUT_OF_RANGE, shape);
    shape = good;
    shape.kind = KNOT_KINDS;
    refuses(VBSS_ERROR_OUT_OF_RANGE, shape);
    shape = good;
    shape.size = 5.0 * shape.thread_radius;
    refuses(VBSS_ERROR_OUT_OF_RANGE, shape);
    shape = good;
    shape.finest = 3e-3;
    refuses(VBSS_ERROR_OUT_OF_RANGE, shape);
    shape = good;
    shape.length = harness_bad_numbers[0];
    refuses(VBSS_ERROR_OUT_OF_RANGE, shape);
    shape = good;
    shape.cylinder = true;
    shape.cylinder_radius = 0.5; /* more than there are control points for */
    refuses(VBSS_ERROR_CAPACITY, shape);
}

int test_knots(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(each_knot_shape_has_its_type),
        cmocka_unit_test(cylinder_passes_through_loop),
        cmocka_unit_test(strands_clear_each_other_and_cylinder),
        cmocka_unit_test(strands_clear_at_any_scale),
        cmocka_unit_test(curvature_is_small_and_continuous),
        cmocka_unit_test(ends_leave_straight_and_opposite),
        cmocka_unit_test(tail_length_is_configurable),
        cmocka_unit_test(mesh_is_fine_in_knot_and_coarsens_away),
        cmocka_unit_test(standard_mesh_node_counts),
        cmocka_unit_test(arc_is_of_curve_and_chord_of_nodes),
        cmocka_unit_test(impossible_knot_is_rejected),
    };
    return cmocka_run_group_tests_name("knots", tests, NULL, NULL);
}
