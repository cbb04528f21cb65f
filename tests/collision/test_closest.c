/* Closest points of features at rest: the smallest distance there is, in answers that are whole. */
#include "base/elementary.h"
#include "closest_reference.h"

/* ---- features at random */

enum { EVENLY, INTEGERS, SLIVERS, SAME_VERTICES, SCALED, FAR_OFF, SHAPES };

static void draw_features(harness_source *source, kind which, int how, feature *a, feature *b)
{
    *a = (feature){.count = which == POINT_TRIANGLE ? 1 : 2};
    *b = (feature){.count = which == EDGES ? 2 : 3};
    double scale = how == SCALED ? ldexp(1.0, (int)harness_draw_below(source, 1059) - 960) : 1.0;
    double far_off = how == FAR_OFF ? 1000.0 : 0.0;
    for (int k = 0; k < 9; k++) {
        double of_a = harness_draw_real(source, -1.0, 1.0);
        double of_b = harness_draw_real(source, -1.0, 1.0);
        a->x[k] = how == INTEGERS ? nearbyint(2.0 * of_a) : scale * of_a + far_off;
        b->x[k] = how == INTEGERS ? nearbyint(2.0 * of_b) : scale * of_b + far_off;
    }
    if (how == SAME_VERTICES) {
        set_vertex(b, 1, vertex(harness_draw_below(source, 2) != 0 ? a : b, 0));
    } else if (how == SLIVERS) { /* the last vertex is near the line of two others */
        vec3 foot = vec3_lerp(vertex(b, 0), which == EDGES ? vertex(a, 1) : vertex(b, 1),
                              harness_draw_real(source, -0.5, 1.5));
        double height = vbss_exp(-harness_draw_real(source, 2.0, 37.0));
        vec3 off = harness_draw_vec3(source, -1.0, 1.0);
        set_vertex(b, b->count - 1, vec3_add_scaled(foot, height, off));
    }
}

static void random_features(harness_source *source, void *user)
{
    const int *how = user;
    feature a, b;
    draw_features(source, (kind)how[0], how[1], &a, &b);
    expect_closest(&a, &b, 1e-14);
}

static void distance_is_minimal(void **state)
{
    (void)state;
    for (int i = 0; i < CAPSULES * SHAPES; i++) {
        int how[2] = {i / SHAPES, i % SHAPES};
        harness_property("smallest distance", how[0] == EDGE_TRIANGLE ? 50 : 600, random_features,
                         how);
    }
}

/* Edges of length 1 and 2, the second turned by an angle: about the line that joins the nearest points,
 * which lie inside; or away from a, so that the nearest point of b is an end. */
static void nearly_parallel(harness_source *source, void *user)
{
    (void)user;
    bool inside = harness_draw_below(source, 2) != 0, turned = harness_draw_below(source, 2) != 0;
    bool meet = harness_draw_below(source, 3) == 0;
    double angle = vbss_exp(-harness_draw_real(source, 2.3, 27.7)); /* 0.1 to 1e-12 */
    double gap = vbss_exp(-harness_draw_real(source, 0.0, 20.0));
    gap = meet ? 0.0 : gap;
    double s = harness_draw_real(source, 0.2, 0.8), u = harness_draw_real(source, 0.2, 0.8);
    vec3 begin = harness_draw_vec3(source, -1.0, 1.0);
    quat frame = harness_draw_unit_quat(source);
    vec3 e = quat_rotate(frame, vec3_make(turned ? -1.0 : 1.0, 0.0, 0.0));
    vec3 tilt = quat_rotate(frame, vec3_make(0.0, inside ? angle : 0.0, inside ? 0.0 : angle));
    vec3 along_b = vec3_scale(vec3_add(e, tilt), 2.0);
    vec3 on_a = vec3_add_scaled(begin, s, quat_rotate(frame, vec3_make(1.0, 0.0, 0.0)));
    vec3 on_b = vec3_add_scaled(on_a, gap, quat_rotate(frame, vec3_make(0.0, 0.0, 1.0)));
    vec3 b0 = inside ? vec3_add_scaled(on_b, -u, along_b) : on_b, b1 = vec3_add(b0, along_b);
    feature a = {.count = 2}, b = {.count = 2};
    set_vertex(&a, 0, begin);
    set_vertex(&a, 1, vec3_add(begin, quat_rotate(frame, vec3_make(1.0, 0.0, 0.0))));
    uint32_t first = harness_draw_below(source, 2);
    set_vertex(&b, (int)first, b0);
    set_vertex(&b, 1 - (int)first, b1);
    bool swap = harness_draw_below(source, 2) != 0;
    double found = expect_closest(swap ? &b : &a, swap ? &a : &b, 1e-13).distance;
    expect_near(gap, found, 3e-13);
}

static void nearly_parallel_edges_have_exact_distance(void **state)
{
    (void)state;
    harness_property("nearly parallel", 5000, nearly_parallel, NULL);
}

static void pierce(harness_source *source, void *user)
{
    (void)user;
    feature a, b;
    draw_features(source, EDGE_TRIANGLE, EVENLY, &a, &b);
    vec3 e = vec3_sub(vertex(&b, 1), vertex(&b, 0)), f = vec3_sub(vertex(&b, 2), vertex(&b, 0));
    double v = harness_draw_real(source, 0.05, 0.45), w = harness_draw_real(source, 0.05, 0.45);
    vec3 where = vec3_add_scaled(vec3_add_scaled(vertex(&b, 0), v, e), w, f);
    vec3 from = vertex(&a, 0), n = vec3_unit_or(vec3_cross(e, f), vec3_zero());
    double height = fabs(vec3_dot(vec3_sub(from, where), n));
    if (height < 0.05 || vec3_norm(vec3_cross(e, f)) < 0.05) {
        return;
    }
    set_vertex(&a, 1, vec3_add_scaled(where, 0.5, vec3_sub(where, from)));
    vbss_collision_closest c = expect_closest(&a, &b, 1e-15);
    assert_true(c.distance == 0.0 && vec3_norm(vec3_load(c.normal)) == 0.0);
    expect_near(2.0 / 3.0, c.weights_a[1], 1e-12);
    expect_near(v, c.weights_b[1], 1e-12);
    expect_near(w, c.weights_b[2], 1e-12);
    set_vertex(&a, 1, vec3_add_scaled(where, -1e-3, vec3_sub(where, from))); /* ends before it */
    expect_near(1e-3 * height, expect_closest(&a, &b, 1e-14).distance, 1e-14);
}

static void edge_through_triangle_has_zero_distance(void **state)
{
    (void)state;
    harness_property("pierce", 100, pierce, NULL);
}

static void capsules_of(harness_source *source, void *user)
{
    feature a, b;
    vbss_collision_closest axes, c;
    draw_features(source, EDGES, *(const int *)user, &a, &b);
    double radius_a = harness_draw_real(source, 0.0, 0.5);
    double radius_b = harness_draw_real(source, 0.0, 0.5);
    expect_ok(vbss_collision_closest_segments(a.x, b.x, &axes, sizeof axes));
    expect_ok(vbss_collision_closest_capsules(a.x, radius_a, b.x, radius_b, &c, sizeof c));
    expect_same_bits(axes.distance - radius_a - radius_b, c.distance);
    assert_memory_equal(axes.normal, c.normal, sizeof c.normal);
    assert_memory_equal(axes.weights_a, c.weights_a, 2 * sizeof c.weights_a);
    bool meet = axes.distance == 0.0; /* then the points are those of the axes */
    vec3 n = vec3_load(c.normal), on_a = vec3_load(c.point_a), on_b = vec3_load(c.point_b);
    vec3 on_axis = vec3_load(axes.point_a), apart = vec3_sub(on_b, on_a);
    expect_near(0.0, vec3_distance(vec3_add_scaled(on_axis, radius_a, n), on_a), 1e-14);
    expect_near(0.0, vec3_distance(vec3_scale(n, meet ? 0.0 : c.distance), apart), 1e-14);
}

static void capsule_distance_is_between_surfaces(void **state)
{
    (void)state;
    int evenly = EVENLY, integers = INTEGERS; /* whose axes often meet */
    harness_property("capsules", 500, capsules_of, &evenly);
    harness_property("capsules of integers", 500, capsules_of, &integers);
}

/* ---- what changes nothing */

static void expect_same(const vbss_collision_closest *wanted, bool exchanged, const feature *a,
                        const feature *b)
{
    vbss_collision_closest c = expect_closest(a, b, 1e-14);
    double sign = exchanged ? -1.0 : 1.0;
    const double *on_a = exchanged ? c.point_b : c.point_a;
    const double *on_b = exchanged ? c.point_a : c.point_b;
    expect_near(wanted->distance, c.distance, 1e-15);
    for (int k = 0; k < 3; k++) { /* of nearly parallel edges no more is sure */
        expect_near(wanted->point_a[k], on_a[k], 1e-10);
        expect_near(wanted->point_b[k], on_b[k], 1e-10);
        expect_near(wanted->normal[k], sign * c.normal[k], 1e-10);
    }
}

static void exchange(feature *f, int i, int k)
{
    vec3 kept = vertex(f, i);
    set_vertex(f, i, vertex(f, k));
    set_vertex(f, k, kept);
}

static void exchanges(harness_source *source, void *user)
{
    (void)user;
    feature a, b;
    kind which = (kind)harness_draw_below(source, EDGE_TRIANGLE);
    draw_features(source, which, EVENLY, &a, &b);
    vbss_collision_closest c = expect_closest(&a, &b, 1e-14);
    exchange(&a, 0, a.count - 1);
    expect_same(&c, false, &a, &b);
    for (int k = 0; k < b.count; k++) {
        exchange(&b, k, (k + 1) % b.count);
        expect_same(&c, false, &a, &b);
    }
    if (which == EDGES) {
        expect_same(&c, true, &b, &a);
    }
}

static void vertex_and_edge_order_does_not_matter(void **state)
{
    (void)state;
    harness_property("exchanges", 300, exchanges, NULL);
}

int test_closest(void)
{
    const struct CMUnitTest tests[] = {
        harness_test(distance_is_minimal),
        harness_test(nearly_parallel_edges_have_exact_distance),
        harness_test(edge_through_triangle_has_zero_distance),
        harness_test(capsule_distance_is_between_surfaces),
        harness_test(vertex_and_edge_order_does_not_matter),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
