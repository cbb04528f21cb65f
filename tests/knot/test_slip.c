/* A flat half knot measures near 0, a half hitch on a straight post near 1 or -1, by which limb is straight. */
#include "base/elementary.h"
#include "knot/knot.h"

#include "harness/harness.h"
#include "fixtures/knots.h"

#define PI 3.141592653589793

typedef struct polyline {
    uint32_t count;
    vec3 x[KNOT_NODES];
} polyline;

static double slip_of(const polyline *p, double t0, double t1, double l0, double l1)
{
    polyline copy = *p;
    const knot_input scene = {.point_count = copy.count, .points = copy.x};
    return vbss_knot_slip(&scene, (const double[]){t0, t1}, (const double[]){l0, l1});
}

/* ---- by formula */

/* `steps` segments that turn by `angle` about z, up by `rise` each. */
static void helix(polyline *p, vec3 from, uint32_t steps, double angle, double rise)
{
    for (uint32_t i = 0; i <= steps; i++) {
        double a = angle * i;
        vec3 on = vec3_make(vbss_cos(a), vbss_sin(a), rise * i);
        p->x[p->count++] = vec3_add(from, on);
    }
}

static void total_turning_is_sum_of_angles(void **state)
{
    (void)state;
    polyline p = {.count = 0};
    helix(&p, vec3_zero(), 40, 0.1, 0.0);                          /* 0 to 40 */
    helix(&p, vec3_make(5.0, 0.0, 0.0), 40, 0.3, 0.0);             /* 41 to 81 */
    expect_near(-0.5, slip_of(&p, 10.0, 20.0, 50.0, 60.0), 1e-13); /* 1 and 3 */
    expect_near(0.5, slip_of(&p, 50.0, 60.0, 10.0, 20.0), 1e-13);
    expect_near(0.0, slip_of(&p, 10.0, 20.0, 10.0, 20.0), 0.0);
    expect_near(-0.5, slip_of(&p, 10.5, 20.25, 50.75, 60.5), 1e-13);
    expect_near((0.05 - 3.0) / (0.05 + 3.0), slip_of(&p, 10.25, 10.75, 50.0, 60.0), 1e-13);
    /* given the other way round */
    expect_near(-0.5, slip_of(&p, 20.0, 10.0, 60.0, 50.0), 1e-13);
}

/* A tight throw has few points: one that entered or left it whole would change its slip by a jump. */
static void slip_is_continuous_in_places(void **state)
{
    (void)state;
    polyline p = {.count = 0};
    helix(&p, vec3_zero(), 40, 1.5, 0.1);
    double before = slip_of(&p, 10.0, 12.0, 20.0, 22.0);
    for (int i = 1; i <= 2000; i++) {
        double now = slip_of(&p, 10.0, 12.0 + 1e-3 * i, 20.0, 22.0);
        assert_true(fabs(now - before) < 1e-3);
        before = now;
    }
    expect_near(1.0 / 3.0, before, 1e-12);
}

static void no_turning_is_zero(void **state)
{
    (void)state;
    polyline p = {.count = 20};
    for (uint32_t i = 0; i < p.count; i++) {
        p.x[i] = vec3_make(i, 0.0, 0.0);
    }
    expect_near(0.0, slip_of(&p, 0.0, 5.0, 10.0, 15.0), 0.0);
    expect_near(0.0, slip_of(&p, 5.0, 5.0, 10.0, 10.0), 0.0);
    p.x[3].y = 1e-6;
    expect_near(1.0, slip_of(&p, 0.0, 5.0, 10.0, 15.0), 0.0);
    expect_near(1.0, slip_of(&p, -7.0, 5.0, 10.0, 99.0), 0.0); /* beyond the ends is nothing */
    expect_near(0.0, slip_of(&p, -7.0, -5.0, 88.0, 99.0), 0.0);
}

/* What reverses on the spot has turned by half a turn. */
static void sharp_turns_count_fully(void **state)
{
    (void)state;
    polyline p = {.count = 6,
                  .x = {{0, 0, 0}, {1, 0, 0}, {0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {1, 2, 0}}};
    expect_near((PI - 0.5 * PI) / (1.5 * PI), slip_of(&p, 0.0, 1.5, 2.5, 5.0), 1e-15);
}

/* ---- knots */

static knot_line make(knot_kind kind, bool mirrored, bool cylinder, polyline *p)
{
    knot_shape shape;
    knot_line line;
    double rest_lengths[KNOT_NODES];
    knot_shape_init(&shape, kind);
    shape.mirrored = mirrored;
    shape.cylinder = cylinder;
    expect_ok(knot_make(&shape, KNOT_NODES, p->x, rest_lengths, &line));
    p->count = line.node_count;
    return line;
}

static void flat_throw_slip_is_zero(void **state)
{
    (void)state;
    polyline p;
    for (int i = 0; i < 8; i++) {
        knot_line line =
            make(i < 4 ? KNOT_OVERHAND : KNOT_DOUBLE_OVERHAND, i % 2 == 0, i / 2 % 2 == 0, &p);
        double first = line.knot_first, last = line.knot_last;
        double part = (last - first) / 4.0; /* of the knot; in the middle is the loop */
        expect_near(0.0, slip_of(&p, first, first + part, last - part, last), 1e-3);
        assert_true(fabs(slip_of(&p, first, first + part, last - part, last - 0.5 * part)) > 0.1);
    }
}

/* From the first to the last node within the hitches' length along the post: it lies on the x axis. */
static void find(const polyline *p, bool post, double length, double places[2])
{
    places[0] = places[1] = -1.0;
    for (uint32_t i = 0; i < p->count; i++) {
        double off = sqrt(p->x[i].y * p->x[i].y + p->x[i].z * p->x[i].z);
        bool is_on = post ? off < 1e-7 : off > 1e-4 && off < 2e-3;
        if (is_on && fabs(p->x[i].x) < length) {
            places[0] = places[0] < 0.0 ? i : places[0];
            places[1] = i;
        }
    }
}

static void half_hitch_on_post_slip_is_one(void **state)
{
    (void)state;
    polyline p, turned;
    for (int i = 0; i < 8; i++) {
        make(i < 4 ? KNOT_HALF_HITCHES : KNOT_REVERSED_HALF_HITCHES, i % 2 == 0, i / 2 % 2 == 0,
             &p);
        double hitch[2], post[2], n = p.count - 1;
        find(&p, false, 2e-3, hitch);
        find(&p, true, 2e-3, post);
        assert_true(hitch[1] - hitch[0] > 40.0 && post[1] - post[0] > 10.0);
        expect_near(1.0, slip_of(&p, hitch[0], hitch[1], post[0], post[1]), 1e-5);
        expect_near(-1.0, slip_of(&p, post[0], post[1], hitch[0], hitch[1]), 1e-5);
        turned = p; /* the tail is the post */
        for (uint32_t k = 0; k < p.count; k++) {
            turned.x[k] = p.x[p.count - 1 - k];
        }
        expect_near(-1.0, slip_of(&turned, n - post[1], n - post[0], n - hitch[1], n - hitch[0]),
                    1e-5);
    }
}

int test_slip(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(total_turning_is_sum_of_angles),
        cmocka_unit_test(slip_is_continuous_in_places),
        cmocka_unit_test(no_turning_is_zero),
        cmocka_unit_test(sharp_turns_count_fully),
        cmocka_unit_test(flat_throw_slip_is_zero),
        cmocka_unit_test(half_hitch_on_post_slip_is_one),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
