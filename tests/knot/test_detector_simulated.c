/* Knots that are really tied, in contact and tight, are told from the first step to the last. */
#include <string.h>

#include <vblast_ss/knot.h>

#include "harness/harness.h"
#include "fixtures/tied_knot.h"

static tied_knot knot;

/* Where the thread lies lowest there would be tissue. */
static vbss_knot_input input_of(vbss_view *positions)
{
    vbss_knot_input in;
    expect_ok(vbss_knot_input_init(&in, sizeof in));
    expect_ok(vbss_thread_get_view(knot.thread, VBSS_THREAD_VIEW_POSITIONS, positions,
                                   sizeof *positions));
    const double *x = positions->data;
    uint32_t lowest = 0;
    for (uint32_t i = 0; i < positions->count; i++) {
        lowest = x[3 * i + 2] < x[3 * lowest + 2] ? i : lowest;
    }
    in.points = x;
    in.point_count = (uint32_t)positions->count;
    in.hole_count = 1;
    in.hole_places[0] = lowest;
    in.away[2] = -1.0;
    return in;
}

typedef struct tied_case {
    knot_kind kind;
    bool mirrored;
    const char *notation;
    vbss_knot_name name;
    uint32_t steps;
} tied_case;

static void tie(const tied_case *c)
{
    harness_memory memory;
    vbss_context *context = harness_context(&memory);
    vbss_knot_detector *detector;
    vbss_knot_state state;
    tied_knot_options options;
    expect_ok(vbss_knot_detector_create(context, NULL, &detector));
    expect_ok(tied_knot_init(&options, c->kind));
    options.knot.mirrored = c->mirrored;
    expect_ok(tied_knot_create(context, &options, &knot));
    for (uint32_t step = 0; step < c->steps; step++) {
        char text[32];
        vbss_view positions;
        expect_ok(tied_knot_step(&knot, 1e-3));
        vbss_knot_input in = input_of(&positions);
        expect_ok(vbss_knot_detector_step(detector, &in));
        expect_ok(vbss_knot_detector_get_state(detector, &state, sizeof state));
        if (state.reading_step == 0) {
            assert_true(step < 40); /* the first reading takes some steps */
            continue;
        }
        expect_ok(vbss_knot_detector_get_notation(detector, text, sizeof text));
        assert_string_equal(c->notation, text);
        assert_int_equal(c->name, state.name);
        assert_int_equal(VBSS_KNOT_VERDICT_CERTIFIED, state.verdict);
    }
    assert_true(tied_knot_done(&knot));
    for (uint32_t i = 0; i < state.throw_count; i++) { /* flat, and where the hands left it */
        vbss_knot_throw t;
        expect_ok(vbss_knot_detector_get_throw(detector, i, &t, sizeof t));
        assert_true((t.flags & VBSS_KNOT_THROW_LOCATED) != 0);
        assert_true((t.flags & VBSS_KNOT_THROW_HITCH) == 0);
        int wanted = c->kind == KNOT_GRANNY || i % 2 == 0 ? 1 : -1;
        assert_int_equal(c->mirrored ? -wanted : wanted, t.handedness);
    }
    expect_ok(vbss_knot_detector_destroy(detector));
    expect_ok(tied_knot_destroy(&knot));
    harness_context_end(context, &memory);
}

static void small_knots_stay_certified(void **state)
{
    (void)state;
    static const tied_case cases[] = {
        {KNOT_OVERHAND, false, "1", VBSS_KNOT_NAME_SINGLE, 600},
        {KNOT_DOUBLE_OVERHAND, true, "2", VBSS_KNOT_NAME_DOUBLE, 600},
        {KNOT_SQUARE, false, "1=1", VBSS_KNOT_NAME_SQUARE, 1600},
        {KNOT_GRANNY, false, "1x1", VBSS_KNOT_NAME_GRANNY, 1600},
        {KNOT_SURGEON, true, "2=1", VBSS_KNOT_NAME_SURGEONS, 1600},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        tie(&cases[i]);
    }
}

static void task_knot_stays_certified(void **state)
{
    (void)state;
    static const tied_case task = {KNOT_FLS, false, "2=1=1", VBSS_KNOT_NAME_FLS, 2400};
    tie(&task);
}

int test_detector_simulated(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(small_knots_stay_certified),
        cmocka_unit_test(task_knot_stays_certified),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
