/* A flat throw measures 0, a half hitch on a straight post 1 or -1, by which limb is straight; whatever the segments. */
#include <vblast_ss/knot.h>

#include "base/elementary.h"
#include "knot/knot.h"

#include "harness/harness.h"
#include "fixtures/knots.h"

#define PI 3.141592653589793

/* ---- by formula: two limbs that wind about one axis */

enum { HELIX_POINTS = 1200 };

typedef struct helices {
    uint32_t count, half; /* points; of one limb */
    vec3 x[2 * HELIX_POINTS];
} helices;

/* Limbs of these radii, 4 turns up by 1 each; down the tail, up the long limb. */
static void wind(helices *p, double tail, double longer, uint32_t segments)
{
    p->half = segments + 1;
    p->count = 2 * p->half;
    for (uint32_t i = 0; i <= segments; i++) {
        double turns = 4.0 * i / segments, sine, cosine;
        vbss_sincos(2.0 * PI * turns, &sine, &cosine);
        p->x[segments - i] = vec3_make(tail * cosine, tail * sine, turns);
        p->x[p->half + i] = vec3_make(-longer * cosine, -longer * sine, turns);
    }
}

static double measure_one(const knot_input *input, const knot_located *own)
{
    static knot_slip_room room;
    double slips[KNOT_THROWS];
    vbss_knot_measure_slips(input, own, 1, &room, slips);
    return slips[0];
}

/* Of a throw in the middle, which spans `share` of each limb and is `shift` segments off it. */
static double slip_of(helices *p, double share, double shift)
{
    const knot_input input = {.point_count = p->count, .points = p->x, .tissue_place = -1.0};
    double middle = 0.5 * (p->half - 1.0), reach = 0.5 * share * (p->half - 1.0);
    const knot_located own = {.located = true,
                              .ordered = true,
                              .wraps = 1,
                              .handedness = 1,
                              .tail_places = {middle + shift - reach, middle + shift + reach},
                              .long_places = {p->half + middle - reach, p->half + middle + reach}};
    return measure_one(&input, &own);
}

/* (cT - cL) / (cT + cL) of the curvatures r / (r r + c c), where 2 pi c is the rise of a turn. */
static double exact_slip(double tail, double longer)
{
    double rise = 1.0 / (4.0 * PI * PI);
    double a = tail / (tail * tail + rise), b = longer / (longer * longer + rise);
    return (a - b) / (a + b);
}

/* A throw that turns over step by step: the axis moves from the middle into one limb. */
static void capsizing_helices_measure_as_by_formula(void **state)
{
    (void)state;
    helices p;
    double before = -1.0;
    for (int i = 0; i <= 20; i++) {
        double aside = 0.05 * i, tail = 0.1 * (1.0 + aside), longer = 0.1 * (1.0 - aside);
        double exact = exact_slip(tail, longer), errors[2];
        for (int k = 0; k < 2; k++) {
            wind(&p, tail, longer, k == 0 ? 48 : 96);
            errors[k] = fabs(slip_of(&p, 0.15, 0.0) - exact);
        }
        assert_true(errors[0] < 7e-3 && errors[1] < 0.35 * errors[0] + 1e-9); /* second order */
        wind(&p, tail, longer, 192);
        double now = slip_of(&p, 0.15, 0.0);
        assert_true(now > before);
        before = now;
        wind(&p, longer, tail, 192);
        expect_near(-now, slip_of(&p, 0.15, 0.0), 1e-4);
    }
    expect_near(1.0, before, 1e-12);
}

/* More segments than pieces. */
static void fine_segments_measure_the_same(void **state)
{
    (void)state;
    helices p;
    for (uint32_t segments = 100; segments < HELIX_POINTS; segments += 91) {
        wind(&p, 0.15, 0.08, segments);
        expect_near(exact_slip(0.15, 0.08), slip_of(&p, 0.12, 0.0), 4e-3);
    }
}

/* The places of a throw jump by segments from one reading to the next. */
static void places_that_move_by_segments_hardly_matter(void **state)
{
    (void)state;
    helices p;
    wind(&p, 0.15, 0.08, 48);
    double before = slip_of(&p, 0.12, -3.0);
    for (int i = -300; i <= 300; i++) {
        double now = slip_of(&p, 0.12, 0.01 * i);
        expect_near(exact_slip(0.15, 0.08), now, 1e-2);
        expect_near(before, now, 2e-4);
        before = now;
    }
    expect_near(exact_slip(0.15, 0.08), slip_of(&p, 0.08, 0.0), 1e-2);
    expect_near(exact_slip(0.15, 0.08), slip_of(&p, 0.16, 0.0), 1e-2);
}

/* The tail winds wider below, the long limb above: windows of neighbours end at each other's middle. */
static void neighbours_are_measured_apart(void **state)
{
    (void)state;
    helices p = {.half = 97, .count = 194};
    for (uint32_t i = 0; i < p.half; i++) {
        double turns = 4.0 * i / 96.0, above = vbss_min(vbss_max(turns - 1.5, 0.0), 1.0), sine,
               cosine;
        double tail = 0.15 - 0.07 * above, longer = 0.08 + 0.07 * above;
        vbss_sincos(2.0 * PI * turns, &sine, &cosine);
        p.x[96 - i] = vec3_make(tail * cosine, tail * sine, turns);
        p.x[97 + i] = vec3_make(-longer * cosine, -longer * sine, turns);
    }
    const knot_input input = {.point_count = p.count, .points = p.x, .tissue_place = -1.0};
    const knot_located throws[2] = {
        {.located = true, .ordered = true, .tail_places = {70, 74}, .long_places = {119, 123}},
        {.located = true, .ordered = true, .tail_places = {22, 26}, .long_places = {167, 171}}};
    static knot_slip_room room;
    double slips[KNOT_THROWS];
    vbss_knot_measure_slips(&input, throws, 2, &room, slips);
    expect_near(exact_slip(0.15, 0.08), slips[0], 0.02);
    expect_near(-slips[0], slips[1], 1e-3);
}

static void limbs_that_do_not_cross_or_bend_measure_zero(void **state)
{
    (void)state;
    helices p;
    wind(&p, 0.0, 0.0, 48); /* on one line */
    expect_near(0.0, slip_of(&p, 0.2, 0.0), 0.0);
    wind(&p, 0.1, 0.1, 48);
    expect_near(0.0, slip_of(&p, 0.0, 0.0), 0.0);
    wind(&p, 0.15, 0.08, 48);
    for (uint32_t i = 0; i < p.count; i++) {
        p.x[i].y = 0.0; /* in one plane */
    }
    expect_near(0.0, slip_of(&p, 0.2, 0.0), 0.0);
}

/* A bend that lies apart from the crossing counts less than the same bend at it. */
static void bends_count_where_limbs_cross(void **state)
{
    (void)state;
    double before = -1.0;
    for (int i = 0; i < 6; i++) {
        /* the tail goes along x and bends where the long limb crosses it; that bends `off` beyond */
        double off = 0.5 * i;
        helices p = {.count = 12, .half = 6};
        const vec3 x[12] = {{-3, 0, 0},   {-2, 0, 0},    {-1, 0, 0},        {0, 0, 0},
                            {1, 0.3, 0},  {2, 0.6, 0},   {20, 20, 0},       {0.2, -3, 1},
                            {0.2, -1, 1}, {0.2, off, 1}, {0.5, off + 1, 1}, {0.8, off + 2, 1}};
        for (uint32_t k = 0; k < p.count; k++) {
            p.x[k] = x[k];
        }
        const knot_input input = {
            .point_count = p.count, .points = p.x, .has_holes = true, .tissue_place = 6.0};
        const knot_located own = {
            .located = true, .tail_places = {2.0, 4.0}, .long_places = {8.0, 10.0}};
        double now = measure_one(&input, &own);
        assert_true(now > before + 0.05 && (i > 0 || now < 0.0));
        before = now;
    }
    assert_true(before > 0.25);
}

/* ---- knots, with the places that the detector finds */

typedef struct measured {
    uint32_t throws;
    double slips[4];
    uint32_t flags[4];
} measured;

typedef struct knot_options {
    double size, finest; /* m; of the loose knot, and of its segments */
    bool mirrored, turned, swapped;
} knot_options;

/* A rotation about no axis of the knot. */
static vec3 turned(vec3 x)
{
    vec3 y = vec3_make(0.8 * x.x - 0.6 * x.y, 0.6 * x.x + 0.8 * x.y, x.z);
    return vec3_make(y.x, 0.28 * y.y - 0.96 * y.z, 0.96 * y.y + 0.28 * y.z);
}

static measured measure(knot_kind kind, const knot_options *o)
{
    static vec3 x[4 * KNOT_NODES];
    static double rest_lengths[4 * KNOT_NODES];
    knot_shape shape;
    knot_line line;
    measured found = {0};
    knot_shape_init(&shape, kind);
    shape.size = o->size;
    shape.finest = o->finest;
    shape.mirrored = o->mirrored;
    shape.cylinder = true;
    expect_ok(knot_make(&shape, 4 * KNOT_NODES, x, rest_lengths, &line));
    uint32_t n = line.node_count, tissue = n / 2; /* the lowest point of the loop */
    for (uint32_t i = n / 4; i < n - n / 4; i++) {
        tissue = x[i].z < x[tissue].z ? i : tissue;
    }
    vec3 away = vec3_make(0.0, 0.0, -1.0);
    for (uint32_t i = 0; i < n && o->turned; i++) {
        x[i] = turned(x[i]);
    }
    away = o->turned ? turned(away) : away;
    for (uint32_t i = 0; i < n / 2 && o->swapped; i++) {
        vec3 other = x[i];
        x[i] = x[n - 1 - i];
        x[n - 1 - i] = other;
    }
    vbss_context *context;
    vbss_knot_detector *detector;
    vbss_knot_detector_config config = vbss_knot_detector_config_default();
    vbss_knot_input input = vbss_knot_input_default();
    vbss_knot_state s;
    config.point_capacity = 4 * KNOT_NODES;
    expect_ok(vbss_context_create(NULL, &context));
    expect_ok(vbss_knot_detector_create(context, &config, &detector));
    input.points = &x[0].x;
    input.point_count = n;
    input.hole_count = 1;
    input.hole_places[0] = o->swapped ? n - 1.0 - tissue : tissue;
    vec3_store(input.holes[0], x[o->swapped ? n - 1 - tissue : tissue]);
    vec3_store(input.away, away);
    expect_ok(vbss_knot_detector_judge(detector, &input));
    expect_ok(vbss_knot_detector_get_state(detector, &s, sizeof s));
    assert_int_equal(s.verdict, VBSS_KNOT_VERDICT_CERTIFIED);
    found.throws = s.throw_count;
    for (uint32_t i = 0; i < s.throw_count; i++) {
        vbss_knot_throw t;
        expect_ok(vbss_knot_detector_get_throw(detector, i, &t, sizeof t));
        assert_true((t.flags & (uint32_t)VBSS_KNOT_THROW_LOCATED) != 0);
        assert_true((t.flags & (uint32_t)VBSS_KNOT_THROW_STRAY) == 0);
        found.slips[i] = t.slip;
        found.flags[i] = t.flags;
    }
    expect_ok(vbss_context_destroy(context));
    return found;
}

static const double finest_of[] = {0.1e-3, 0.2e-3, 0.3e-3, 0.5e-3};

static void flat_knots_measure_zero_with_any_segments(void **state)
{
    (void)state;
    static const knot_kind flat[] = {KNOT_OVERHAND, KNOT_DOUBLE_OVERHAND, KNOT_SQUARE,
                                     KNOT_GRANNY,   KNOT_SURGEON,         KNOT_FLS};
    for (int i = 0; i < 6; i++) {
        for (int k = 0; k < 8; k++) {
            const knot_options o = {
                .size = 0.7e-3, .finest = finest_of[k / 2], .mirrored = k % 2 == 1};
            measured m = measure(flat[i], &o);
            assert_int_equal(m.throws, i < 2 ? 1 : i < 5 ? 2 : 3);
            for (uint32_t t = 0; t < m.throws; t++) {
                assert_true(fabs(m.slips[t]) < 0.02);
                assert_true((m.flags[t] & (uint32_t)VBSS_KNOT_THROW_HITCH) == 0);
            }
        }
    }
}

static void half_hitches_on_a_straight_post_measure_one(void **state)
{
    (void)state;
    for (int k = 0; k < 12; k++) {
        bool swapped = k >= 6;
        const knot_options o = {.size = 0.7e-3,
                                .finest = finest_of[k / 2 % 3],
                                .mirrored = k % 2 == 1,
                                .turned = k % 4 == 3,
                                .swapped = swapped};
        for (int i = 0; i < 2; i++) {
            measured m = measure(i == 0 ? KNOT_HALF_HITCHES : KNOT_REVERSED_HALF_HITCHES, &o);
            assert_int_equal(m.throws, 2);
            for (uint32_t t = 0; t < 2; t++) {
                expect_near(swapped ? -1.0 : 1.0, m.slips[t], 0.01);
                assert_true((m.flags[t] & (uint32_t)VBSS_KNOT_THROW_HITCH) != 0);
            }
        }
    }
}

int test_slip(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(capsizing_helices_measure_as_by_formula),
        cmocka_unit_test(fine_segments_measure_the_same),
        cmocka_unit_test(places_that_move_by_segments_hardly_matter),
        cmocka_unit_test(neighbours_are_measured_apart),
        cmocka_unit_test(limbs_that_do_not_cross_or_bend_measure_zero),
        cmocka_unit_test(bends_count_where_limbs_cross),
        cmocka_unit_test(flat_knots_measure_zero_with_any_segments),
        cmocka_unit_test(half_hitches_on_a_straight_post_measure_one),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
