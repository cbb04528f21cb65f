/* The paper's response: distance and side are restored, by whom the paper says; then what it leaves
 * open; then what is refused. a lies along x, or in the plane z = 0 for the triangle (then b). */
#include <stdlib.h>

#include "collision/closest.h"
#include "collision/paper_ask.h"

#define EDGE -1, 0, 0, 1, 0, 0
#define TRIANGLE 0, 0, 0, 2, 0, 0, 0, 2, 0
#define D 0.25

static const double equal[4] = {1, 1, 1, 1}, rigid_a[4] = {0, 0, 2, 3}, rigid_b[4] = {2, 3, 0, 0};

static vbss_collision_response respond(vbss_collision_response_variant variant,
                                       const vbss_collision_impact *impact, const question *q,
                                       const double masses[4])
{
    vbss_collision_response r;
    expect_ok(vbss_collision_get_vblast_response(q->kind, variant, impact, q->start, q->end, D,
                                                 masses, &r, sizeof r));
    assert_int_equal(sizeof r, r.struct_size);
    expect_finite(r.direction,
                  (int)((sizeof r - offsetof(vbss_collision_response, direction)) / 8));
    expect_near(1.0, vec3_norm(vec3_load(r.direction)), 1e-15);
    return r;
}

static vbss_collision_response at_end(const question *q, const double masses[4])
{
    return respond(VBSS_COLLISION_RESPONSE_END_OF_STEP, NULL, q, masses);
}

/* From b to a between points with these weights, after the response. */
static vec3 apart_after(const question *q, const double positions[12],
                        const vbss_collision_response *r, const double weights[4])
{
    vec3 apart = vec3_zero();
    for (size_t k = 0; k < 4; k++) {
        vec3 x = vec3_add(vec3_load(positions + 3 * k), vec3_load(r->displacement + 3 * k));
        bool of_a = k < (q->kind == VBSS_COLLISION_PAIR_EDGE_EDGE ? 2 : 1);
        apart = vec3_add_scaled(apart, of_a ? weights[k] : -weights[k], x);
    }
    return apart;
}

static void expect_q(double z, const vbss_collision_response *r)
{
    assert_true(r->direction[0] == 0.0 && r->direction[1] == 0.0 && r->direction[2] == z);
}

/* b, over the middle of a or of itself at z = 1, ends at `end`; a moves by `height`. */
static question sinking(double end, double height)
{
    question q = {VBSS_COLLISION_PAIR_EDGE_EDGE,
                  {EDGE, 0, -1, 1, 0, 1, 1},
                  {-1, 0, height, 1, 0, height, 0, -1, end, 0, 1, end}};
    return q;
}

static const double middle[4] = {.5, .5, .5, .5};

static void expect_restored(const question *q, const vbss_collision_response *r,
                            const double weights[4])
{
    vec3 apart = apart_after(q, q->end, r, weights);
    expect_near(D, vec3_norm(apart), 1e-14);
    expect_near(D, vec3_dot(apart, vec3_load(r->direction)), 1e-14);
}

static void crossed_edges_are_moved_back_by_mover(void **state)
{
    (void)state;
    question q = sinking(-.1, 0);
    vbss_collision_response r = at_end(&q, equal);
    expect_q(-1.0, &r); /* b was above, so from b to a is down */
    expect_near(D + .1, r.depth, 1e-15);
    expect_near(0.0, r.share_a, 0.0);
    expect_near(D + .1, r.displacement[8], 1e-15);
    expect_near(D + .1, r.displacement[11], 1e-15);
    assert_int_equal(0, r.completed);
    expect_restored(&q, &r, middle);
    /* Both came, a by 0.3 and b by 0.9. */
    q = sinking(.1, .3);
    r = at_end(&q, equal);
    expect_near(D + .2, r.depth, 1e-15);
    expect_near(.25, r.share_a, 1e-15);
    assert_int_equal(0, r.completed);
    expect_restored(&q, &r, middle);
    /* Near, not through. */
    q = sinking(.1, 0);
    r = at_end(&q, equal);
    expect_q(-1.0, &r);
    expect_near(D - .1, r.depth, 1e-15);
    expect_restored(&q, &r, middle);
}

/* Rounding gives their lines a normal, which is not to be believed. */
static void crossed_parallel_edges_are_moved_back(void **state)
{
    (void)state;
    question q = {VBSS_COLLISION_PAIR_EDGE_EDGE,
                  {0, 0, 0, .1, .2, .3, 3, 0, -1, 4, 2, 2},
                  {0, 0, 0, .1, .2, .3, -.3, 0, .1, .7, 2, 3.1}};
    vbss_collision_response r = at_end(&q, equal);
    assert_int_equal(0, r.completed);
    expect_near(-3.0 / sqrt(10.0), r.direction[0], 1e-14);
    expect_near(1.0 / sqrt(10.0), r.direction[2], 1e-14);
    expect_near(D + .1 * sqrt(10.0), r.depth, 1e-14);
    vec3 x[4];
    double at_a, at_b; /* any pair of points is closest; the library takes these */
    load_at(&q, 1.0, 1.0, x);
    closest_between_edges(vec3_sub(x[1], x[0]), vec3_sub(x[3], x[2]), vec3_sub(x[2], x[0]), &at_a,
                          &at_b);
    const double weights[4] = {1.0 - at_a, at_a, 1.0 - at_b, at_b};
    expect_restored(&q, &r, weights);
}

static void chase_fractions_leave_unit_interval(void **state)
{
    (void)state;
    question q = sinking(-1.2, -1); /* a flees by 1, b follows by 2.2 */
    vbss_collision_response r = at_end(&q, equal);
    expect_near(-1.0 / 1.2, r.share_a, 1e-14);
    assert_int_equal(0, r.completed);
    expect_restored(&q, &r, middle);
    assert_true(r.displacement[2] > 0.0); /* a is drawn back towards b, its motion undone */
}

static void rigid_side_stays(void **state)
{
    (void)state;
    const double *masses[] = {rigid_a, rigid_b};
    for (int k = 0; k < 2; k++) {
        question q = sinking(-.1, k == 0 ? .1 : 0); /* whoever it was that moved */
        vbss_collision_response r = at_end(&q, masses[k]);
        expect_near(k, r.share_a, 0.0);
        assert_int_equal(0, r.completed);
        expect_restored(&q, &r, middle);
        for (int i = 0; i < 6; i++) {
            assert_true(r.displacement[6 * k + i] == 0.0);
        }
    }
}

static void point_triangle_response_is_analogous(void **state)
{
    (void)state;
    const double weights[4] = {1, .5, .25, .25}, rigid_point[4] = {0, 1, 2, 3};
    const double rigid_triangle[4] = {5, 0, 0, 0};
    question q = {
        VBSS_COLLISION_PAIR_POINT_TRIANGLE, {.5, .5, 1, TRIANGLE}, {.5, .5, -.1, TRIANGLE}};
    const double *masses[] = {equal, rigid_point, rigid_triangle};
    const double shares[] = {1, 0, 1};
    for (int k = 0; k < 3; k++) {
        vbss_collision_response r = at_end(&q, masses[k]);
        expect_q(1.0, &r);
        expect_near(D + .1, r.depth, 1e-15);
        expect_near(shares[k], r.share_a, 0.0);
        assert_int_equal(0, r.completed);
        expect_restored(&q, &r, weights);
    }
    /* Beside the triangle, the vector from the corner counts. */
    question out = {
        VBSS_COLLISION_PAIR_POINT_TRIANGLE, {-.06, -.08, 1, TRIANGLE}, {-.06, -.08, 0, TRIANGLE}};
    vbss_collision_response r = at_end(&out, equal);
    expect_near(D - .1, r.depth, 1e-15);
    expect_near(-.6, r.direction[0], 1e-14);
    assert_int_equal(1, r.completed); /* in the plane at the end, so it has no side there */
}

/* Restores D at the time of impact; at the end, what was passed since remains. */
static void time_of_impact_shifts_with_thickness(void **state)
{
    (void)state;
    const double corners[4] = {1, .5, .25, .25};
    question edges = sinking(-.1, 0);
    question point = {
        VBSS_COLLISION_PAIR_POINT_TRIANGLE, {.5, .5, 1, TRIANGLE}, {.5, .5, -.1, TRIANGLE}};
    const question *asked[] = {&edges, &point};
    const double *weights[] = {middle, corners};
    const vbss_collision_method methods[] = {VBSS_COLLISION_METHOD_VBLAST,
                                             VBSS_COLLISION_METHOD_CUBIC,
                                             VBSS_COLLISION_METHOD_CONSERVATIVE};
    for (int k = 0; k < 6; k++) {
        const question *q = asked[k / 3];
        vbss_collision_impact hit = ask(methods[k % 3], 0.0, q).impact;
        expect_near(10.0 / 11.0, hit.time, 1e-12);
        vbss_collision_response r = respond(VBSS_COLLISION_RESPONSE_TIME_OF_IMPACT, &hit, q, equal);
        expect_near(k < 3 ? -1.0 : 1.0, r.direction[2], 1e-14);
        expect_near(D, r.depth, 0.0);
        expect_near(k < 3 ? 0.0 : 1.0, r.share_a, 1e-14);
        assert_int_equal(0, r.completed);
        double then[12];
        for (int i = 0; i < 12; i++) {
            then[i] = (1.0 - hit.time) * q->start[i] + hit.time * q->end[i];
        }
        vec3 direction = vec3_load(r.direction);
        expect_near(D, vec3_dot(apart_after(q, then, &r, weights[k / 3]), direction), 1e-12);
        expect_near(D - .1, vec3_dot(apart_after(q, q->end, &r, weights[k / 3]), direction), 1e-12);
    }
}

/* Through, and found near at the end: its normal leads on, its time is that of the end. */
static void end_hit_is_resolved_at_end(void **state)
{
    (void)state;
    question q = sinking(-.1, 0);
    vbss_collision_impact hit = ask(VBSS_COLLISION_METHOD_VBLAST, D, &q).impact;
    assert_true(hit.time == 1.0 && hit.normal[2] == -1.0);
    vbss_collision_response r = respond(VBSS_COLLISION_RESPONSE_TIME_OF_IMPACT, &hit, &q, equal);
    vbss_collision_response same = at_end(&q, equal);
    assert_memory_equal(&same, &r, sizeof r);
    expect_restored(&q, &r, middle);
}

/* ---- any hit */

/* The contact points come to lie D apart along q, whoever moves; only what may move does. */
static void restores_contact_points(harness_source *source, void *user)
{
    uint32_t *restored = user;
    question q = draw_question(source, DRAWN_EVENLY);
    double masses[4], sum = 0.0;
    for (int k = 0; k < 4; k++) {
        masses[k] = harness_draw_below(source, 3) != 0 ? harness_draw_real(source, .1, 10.0) : 0.0;
        sum += masses[k];
    }
    vbss_collision_impact hit = ask(VBSS_COLLISION_METHOD_CUBIC, 0.0, &q).impact;
    if (hit.hit == 0 || sum == 0.0) {
        return;
    }
    vbss_collision_response r = respond(VBSS_COLLISION_RESPONSE_TIME_OF_IMPACT, &hit, &q, masses);
    vec3 at_impact = vec3_sub(vec3_load(hit.point_a), vec3_load(hit.point_b)), moved = vec3_zero();
    double scale = 1.0;
    for (size_t k = 0; k < 4; k++) {
        bool of_a = k < (q.kind == VBSS_COLLISION_PAIR_EDGE_EDGE ? 2 : 1);
        vec3 displacement = vec3_load(r.displacement + 3 * k);
        moved = vec3_add_scaled(moved, of_a ? hit.weights[k] : -hit.weights[k], displacement);
        scale = vec3_norm(displacement) > scale ? vec3_norm(displacement) : scale;
        assert_true(masses[k] > 0.0 || vec3_norm(displacement) == 0.0);
    }
    vec3 wanted = vec3_scale(vec3_load(r.direction), D);
    expect_near(0.0, vec3_distance(wanted, vec3_add(at_impact, moved)), 1e-12 * scale);
    ++*restored;
}

static void contact_points_move_by_depth(void **state)
{
    (void)state;
    uint32_t restored = 0;
    harness_property("response restores", 10000, restores_contact_points, &restored);
    assert_true(getenv("VBSS_PROPERTY_CASE") != NULL || restored > 500);
}

int test_paper_response(void)
{
    const struct CMUnitTest tests[] = {
        harness_test(crossed_edges_are_moved_back_by_mover),
        harness_test(crossed_parallel_edges_are_moved_back),
        harness_test(chase_fractions_leave_unit_interval),
        harness_test(rigid_side_stays),
        harness_test(point_triangle_response_is_analogous),
        harness_test(time_of_impact_shifts_with_thickness),
        harness_test(end_hit_is_resolved_at_end),
        harness_test(contact_points_move_by_depth),
    };
    return cmocka_run_group_tests_name("paper_response", tests, NULL, NULL);
}
