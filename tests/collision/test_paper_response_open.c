/* The paper's response where the paper leaves it open, and arguments it refuses. */
#include "collision/paper_ask.h"

#define EDGE -1, 0, 0, 1, 0, 0
#define TRIANGLE 0, 0, 0, 2, 0, 0, 0, 2, 0
#define D 0.25

static const double equal[4] = {1, 1, 1, 1};

static vbss_collision_response respond(const question *q, const vbss_collision_impact *impact,
                                       const double masses[4])
{
    vbss_collision_response r;
    expect_ok(vbss_collision_get_vblast_response(q->kind, VBSS_COLLISION_RESPONSE_END_OF_STEP,
                                                 impact, q->start, q->end, D, masses, &r,
                                                 sizeof r));
    expect_finite(r.direction,
                  (int)((sizeof r - offsetof(vbss_collision_response, direction)) / 8));
    expect_near(1.0, vec3_norm(vec3_load(r.direction)), 1e-15);
    return r;
}

static void expect_open(double x, double y, double z, double depth, double share,
                        const vbss_collision_response *r)
{
    assert_int_equal(1, r->completed);
    expect_near(x, r->direction[0], 1e-15);
    expect_near(y, r->direction[1], 1e-15);
    expect_near(z, r->direction[2], 1e-15);
    expect_near(depth, r->depth, 1e-15);
    expect_near(share, r->share_a, 1e-15);
}

static void masses_share_without_closing_motion(void **state)
{
    (void)state;
    question rests = {
        VBSS_COLLISION_PAIR_EDGE_EDGE, {EDGE, 0, -1, .1, 0, 1, .1}, {EDGE, 0, -1, .1, 0, 1, .1}};
    question slides = {VBSS_COLLISION_PAIR_EDGE_EDGE,
                       {EDGE, -.5, -1, .1, -.5, 1, .1},
                       {EDGE, 0, -1, .1, 0, 1, .1}};
    question together = {VBSS_COLLISION_PAIR_EDGE_EDGE,
                         {EDGE, 0, -1, .1, 0, 1, .1},
                         {-1, 0, .7, 1, 0, .7, 0, -1, .8, 0, 1, .8}};
    const double masses[4] = {3, 3, 1, 1};
    const question *asked[] = {&rests, &slides, &together};
    for (int k = 0; k < 3; k++) {
        vbss_collision_response r = respond(asked[k], NULL, masses);
        expect_open(0, 0, -1, D - .1, .75, &r);
        expect_near(-.75 * (D - .1), r.displacement[2], 1e-15);
        expect_near(.25 * (D - .1), r.displacement[8], 1e-15);
    }
}

static void touching_features_return_to_start_positions(void **state)
{
    (void)state;
    question edges = {
        VBSS_COLLISION_PAIR_EDGE_EDGE, {EDGE, 0, -1, -1, 0, 1, -1}, {EDGE, 0, -1, 0, 0, 1, 0}};
    vbss_collision_response r = respond(&edges, NULL, equal);
    expect_open(0, 0, 1, D, 0, &r);
    question point = {
        VBSS_COLLISION_PAIR_POINT_TRIANGLE, {.5, .5, 1, TRIANGLE}, {.5, .5, 0, TRIANGLE}};
    r = respond(&point, NULL, equal);
    expect_open(0, 0, 1, D, 1, &r);
    /* In one plane at all times: no w, but closest points at the start. */
    question flat = {
        VBSS_COLLISION_PAIR_EDGE_EDGE, {EDGE, 0, 1, 0, 0, 3, 0}, {EDGE, 0, -1, 0, 0, 1, 0}};
    r = respond(&flat, NULL, equal);
    expect_open(0, -1, 0, D, 0, &r);
}

static void features_touching_twice_use_fallback_normal(void **state)
{
    (void)state;
    question q = {VBSS_COLLISION_PAIR_EDGE_EDGE,
                  {EDGE, 0, -1, 0, 0, 1, 0},
                  {-1, 0, .5, 1, 0, .5, 0, -1, .5, 0, 1, .5}};
    vbss_collision_impact hit = ask(VBSS_COLLISION_METHOD_VBLAST, D, &q).impact;
    assert_int_equal(1, hit.hit);
    hit.normal[0] = .6;
    hit.normal[1] = 0.0;
    hit.normal[2] = .8;
    vbss_collision_response r = respond(&q, &hit, equal);
    expect_open(-.6, 0, -.8, D, .5, &r);
    r = respond(&q, NULL, equal); /* the normal of both; its sign is free as nothing closes */
    expect_open(0, 0, 1, D, .5, &r);
    question apart = {
        VBSS_COLLISION_PAIR_EDGE_EDGE, {EDGE, 0, -1, 0, 0, 1, 0}, {EDGE, 0, -1, 0, 0, 1, 0}};
    apart.end[2] = apart.end[5] = 1e-14; /* too little to say where, enough to say who closes in */
    r = respond(&apart, NULL, equal);
    expect_open(0, 0, -1, D, 1, &r);
    question along = {
        VBSS_COLLISION_PAIR_EDGE_EDGE, {EDGE, 0, 0, 0, 2, 0, 0}, {EDGE, 0, 0, 0, 2, 0, 0}};
    r = respond(&along, NULL, equal);
    assert_int_equal(1, r.completed);
    expect_near(0.0, r.direction[0], 0.0); /* any normal */
    expect_near(D, r.depth, 0.0);
}

static void coincident_points_separate(void **state)
{
    (void)state;
    question q = {VBSS_COLLISION_PAIR_EDGE_EDGE, {0}, {0}};
    expect_near(D, respond(&q, NULL, equal).depth, 0.0);
    q.kind = VBSS_COLLISION_PAIR_POINT_TRIANGLE;
    expect_near(D, respond(&q, NULL, equal).depth, 0.0);
    q.start[2] = 1.0; /* the point falls on a triangle without area */
    vbss_collision_response r = respond(&q, NULL, equal);
    expect_open(0, 0, 1, D, 1, &r);
}

static void edges_turned_by_right_angle_count_as_uncrossed(void **state)
{
    (void)state;
    question q = {
        VBSS_COLLISION_PAIR_EDGE_EDGE, {EDGE, 0, -1, 1, 0, 1, 1}, {EDGE, 0, .1, -1, 0, .1, 1}};
    vbss_collision_response r = respond(&q, NULL, equal);
    expect_open(0, -1, 0, D - .1, 0, &r);
}

static void separated_features_are_unchanged(void **state)
{
    (void)state;
    question q = {
        VBSS_COLLISION_PAIR_EDGE_EDGE, {EDGE, 0, -1, 1, 0, 1, 1}, {EDGE, 0, -1, .5, 0, 1, .5}};
    vbss_collision_response r = respond(&q, NULL, equal);
    expect_open(0, 0, -1, 0, 0, &r);
}

static void other_side_moves_at_held_vertex(void **state)
{
    (void)state;
    question q = {
        VBSS_COLLISION_PAIR_EDGE_EDGE, {EDGE, 1, 0, 1, 1, 2, 1}, {EDGE, 1, 0, -.1, 1, 2, -.1}};
    const double held[4] = {1, 1, 0, 1}, both_held[4] = {1, 0, 0, 1};
    vbss_collision_response r = respond(&q, NULL, held); /* b moved, but it cannot be put back */
    expect_open(0, 0, -1, D + .1, 1, &r);
    expect_near(-(D + .1), r.displacement[5], 1e-15);
    r = respond(&q, NULL, both_held);
    expect_open(0, 0, -1, D + .1, .5, &r);
    for (int k = 0; k < 12; k++) {
        assert_true(r.displacement[k] == 0.0);
    }
    /* So near to it that the other end would have to be flung. */
    q.start[8] = q.start[11] = 1.0;
    q.start[7] = q.end[7] = -1e-7;
    r = respond(&q, NULL, held);
    expect_open(0, 0, -1, D + .1, 1, &r);
}

/* Rounding gives this triangle a normal. */
static void degenerate_triangle_has_no_plane(void **state)
{
    (void)state;
    question q = {VBSS_COLLISION_PAIR_POINT_TRIANGLE,
                  {-1, -1, 0, 0, 0, 0, .1, .2, .3, .3, .6, .9},
                  {-.1, -.1, 0, 0, 0, 0, .1, .2, .3, .3, .6, .9}};
    assert_true(.2 * .9 != .3 * .6);
    vbss_collision_response r = respond(&q, NULL, equal);
    expect_open(-sqrt(.5), -sqrt(.5), 0, D - .1 * sqrt(2.0), 1, &r);
}

/* `respond` looks at every number. */
static void answers_are_whole(harness_source *source, void *user)
{
    (void)user;
    drawn how = harness_draw_below(source, 2) != 0 ? DRAWN_WILD : DRAWN_INTEGERS;
    question q = draw_question(source, how);
    double masses[4] = {0, 0, 0, 1};
    for (int k = 0; k < 3; k++) {
        masses[k] = fabs(draw_coordinate(source, how));
    }
    respond(&q, NULL, masses);
}

static void degenerate_features_give_no_nan(void **state)
{
    (void)state;
    harness_property("response answers are whole", 20000, answers_are_whole, NULL);
}

/* ---- refusals */

typedef struct call {
    vbss_collision_pair_kind kind;
    vbss_collision_response_variant variant;
    const vbss_collision_impact *impact;
    const double *start, *end;
    double thickness;
    const double *masses;
    uint32_t size;
} call;

static void expect_refused(vbss_result wanted, call c)
{
    vbss_collision_response r, untouched;
    memset(&r, 0x55, sizeof r);
    memcpy(&untouched, &r, sizeof r);
    expect_result(wanted,
                  vbss_collision_get_vblast_response(c.kind, c.variant, c.impact, c.start, c.end,
                                                     c.thickness, c.masses, &r, c.size));
    assert_memory_equal(&untouched, &r, sizeof r);
}

static void bad_arguments_are_rejected(void **state)
{
    (void)state;
    question q = {
        VBSS_COLLISION_PAIR_EDGE_EDGE, {EDGE, 0, -1, 1, 0, 1, 1}, {EDGE, 0, -1, -.1, 0, 1, -.1}};
    vbss_collision_impact hit = ask(VBSS_COLLISION_METHOD_VBLAST, 0.0, &q).impact;
    const call good = {q.kind, VBSS_COLLISION_RESPONSE_TIME_OF_IMPACT, &hit, q.start, q.end, D,
                       equal,  sizeof(vbss_collision_response)};
    vbss_collision_response r;
    expect_ok(vbss_collision_get_vblast_response(good.kind, good.variant, good.impact, good.start,
                                                 good.end, D, good.masses, &r, good.size));
    expect_result(VBSS_ERROR_NULL_ARGUMENT, vbss_collision_get_vblast_response(
                                                good.kind, good.variant, good.impact, good.start,
                                                good.end, D, good.masses, NULL, good.size));
#define REFUSED(wanted, field, value) \
    do {                              \
        call c = good;                \
        c.field = (value);            \
        expect_refused(wanted, c);    \
    } while (0)
    REFUSED(VBSS_ERROR_OUT_OF_RANGE, kind, 2);
    REFUSED(VBSS_ERROR_OUT_OF_RANGE, variant, -1);
    REFUSED(VBSS_ERROR_NULL_ARGUMENT, impact, NULL);
    REFUSED(VBSS_ERROR_NULL_ARGUMENT, start, NULL);
    REFUSED(VBSS_ERROR_NULL_ARGUMENT, end, NULL);
    REFUSED(VBSS_ERROR_NULL_ARGUMENT, masses, NULL);
    REFUSED(VBSS_ERROR_OUT_OF_RANGE, thickness, -1e-9);
    REFUSED(VBSS_ERROR_NOT_FINITE, thickness, (double)NAN);
    REFUSED(VBSS_ERROR_STRUCT_SIZE, size, sizeof(vbss_collision_response) - 8);
    double numbers[12], far[12] = {1.1e30};
    for (int k = 0; k < 3; k++) {
        memcpy(numbers, q.end, sizeof numbers);
        numbers[7] = harness_bad_numbers[k];
        REFUSED(VBSS_ERROR_NOT_FINITE, start, numbers);
        REFUSED(VBSS_ERROR_NOT_FINITE, end, numbers);
        REFUSED(VBSS_ERROR_NOT_FINITE, masses, numbers + 4);
    }
    REFUSED(VBSS_ERROR_OUT_OF_RANGE, start, far);
    const double none[4] = {0}, negative[4] = {1, 1, -1, 1};
    REFUSED(VBSS_ERROR_OUT_OF_RANGE, masses, none);
    REFUSED(VBSS_ERROR_OUT_OF_RANGE, masses, negative);
    vbss_collision_impact bad[7];
    for (int k = 0; k < 7; k++) {
        bad[k] = hit;
    }
    bad[0].hit = 0;
    bad[1].normal[0] = 1.0;
    bad[2].weights[1] = .6;
    bad[3].weights[2] = -.5;
    bad[4].normal[2] = (double)NAN;
    bad[5].struct_size = 7;
    bad[6].time = 1.5;
    const vbss_result wanted[] = {VBSS_ERROR_OUT_OF_RANGE, VBSS_ERROR_OUT_OF_RANGE,
                                  VBSS_ERROR_OUT_OF_RANGE, VBSS_ERROR_OUT_OF_RANGE,
                                  VBSS_ERROR_NOT_FINITE,   VBSS_ERROR_STRUCT_SIZE,
                                  VBSS_ERROR_OUT_OF_RANGE};
    for (int k = 0; k < 7; k++) {
        REFUSED(wanted[k], impact, &bad[k]);
    }
}

int test_paper_response_open(void)
{
    const struct CMUnitTest tests[] = {
        harness_test(masses_share_without_closing_motion),
        harness_test(touching_features_return_to_start_positions),
        harness_test(features_touching_twice_use_fallback_normal),
        harness_test(coincident_points_separate),
        harness_test(edges_turned_by_right_angle_count_as_uncrossed),
        harness_test(separated_features_are_unchanged),
        harness_test(other_side_moves_at_held_vertex),
        harness_test(degenerate_triangle_has_no_plane),
        harness_test(degenerate_features_give_no_nan),
        harness_test(bad_arguments_are_rejected),
    };
    return cmocka_run_group_tests_name("paper_response_open", tests, NULL, NULL);
}
