/* The order that no diagram shows is known from before, as long as the thread was followed. */
#include <string.h>

#include <vblast_ss/knot.h>

#include "harness/harness.h"
#include "fixtures/knot_families.h"

static family_case tied;
static thread_line plain;
static harness_memory memory;
static vbss_context *context;
static vbss_knot_detector *detector;

static void begin(void)
{
    context = harness_context(&memory);
    expect_ok(vbss_knot_detector_create(context, NULL, &detector));
}

static void end(void)
{
    expect_ok(vbss_knot_detector_destroy(detector));
    harness_context_end(context, &memory);
}

static vbss_knot_input input_of(const thread_line *line)
{
    vbss_knot_input in;
    expect_ok(vbss_knot_input_init(&in, sizeof in));
    in.point_count = line->count;
    in.points = &line->x[0].x;
    in.hole_count = 2;
    memcpy(in.hole_places, line->hole_places, sizeof in.hole_places);
    vec3_store(in.away, line->away);
    return in;
}

/* Until what was shown first has been read. */
static void follow(const thread_line *line, bool may_have_passed)
{
    vbss_knot_input in = input_of(line);
    vbss_knot_state state;
    in.may_have_passed = may_have_passed;
    expect_ok(vbss_knot_detector_get_state(detector, &state, sizeof state));
    const uint64_t began = state.steps;
    do {
        expect_ok(vbss_knot_detector_step(detector, &in));
        in.may_have_passed = 0; /* told once */
        expect_ok(vbss_knot_detector_get_state(detector, &state, sizeof state));
        assert_true(state.steps < began + 10000);
    } while (state.reading_step <= began);
}

static void expect_notation(const char *wanted)
{
    char text[32];
    expect_ok(vbss_knot_detector_get_notation(detector, text, sizeof text));
    assert_string_equal(wanted, text);
}

static void notation_of(const family_case *c, char text[32])
{
    size_t used = 0;
    for (uint32_t i = 0; i < c->throws; i++) {
        if (i > 0) {
            text[used++] = c->signs[i] == c->signs[i - 1] ? 'x' : '=';
        }
        text[used++] = (char)('0' + c->wraps[i]);
    }
    text[used] = 0;
}

/* The n-th thread of three throws that shows what they are and not in which order. */
static bool find_unordered(uint64_t *seed)
{
    for (; *seed < 4000; ++*seed) {
        char text[32];
        if (!family_named("three throws")->make(*seed, 60, &tied)) {
            continue;
        }
        vbss_knot_input in = input_of(&tied.line);
        expect_ok(vbss_knot_detector_judge(detector, &in));
        expect_ok(vbss_knot_detector_get_notation(detector, text, sizeof text));
        if (strchr(text, '+') != NULL) {
            return true;
        }
    }
    return false;
}

/* The same throws, plainly. */
static void make_plain(uint32_t throws)
{
    throw_stack stack;
    throw_stack_init(&stack);
    for (uint32_t i = 0; i < throws; i++) {
        throw_stack_add(&stack, tied.wraps[i], tied.signs[i]);
    }
    assert_true(throw_stack_make(&stack, &plain));
}

static void order_is_remembered(void **state)
{
    (void)state;
    uint64_t seed = 0;
    char wanted[32];
    begin();
    for (int found = 0; found < 2; found++, seed++) {
        assert_true(find_unordered(&seed));
        notation_of(&tied, wanted);
        for (uint32_t throws = 2; throws <= 3;
             throws++) { /* all that are there, or all but the last */
            expect_ok(vbss_knot_detector_reset(detector));
            make_plain(throws);
            follow(&plain, false);
            follow(&tied.line, false);
            expect_notation(wanted);
        }
        follow(&tied.line, true); /* it may be another thread */
        vbss_knot_state now;
        expect_ok(vbss_knot_detector_get_state(detector, &now, sizeof now));
        assert_true((now.faults & VBSS_KNOT_FAULT_ORDER) != 0);
        assert_int_equal(VBSS_KNOT_VERDICT_FORMED, now.verdict);
    }
    end();
}

/* What was certain stays so, what came is no surer than it is. */
static void certainty_is_remembered(void **state)
{
    (void)state;
    uint64_t seed = 0;
    begin();
    assert_true(find_unordered(&seed));
    expect_ok(vbss_knot_detector_reset(detector));
    make_plain(2);
    follow(&plain, false);
    follow(&tied.line, false);
    for (uint32_t i = 0; i < 3; i++) {
        vbss_knot_throw t;
        expect_ok(vbss_knot_detector_get_throw(detector, i, &t, sizeof t));
        assert_true((t.flags & VBSS_KNOT_THROW_ORDERED) != 0);
        assert_int_equal(tied.wraps[i], t.wraps);
        assert_int_equal(tied.signs[i], t.handedness);
        if (i == 2) {
            assert_int_equal(VBSS_KNOT_VERDICT_FORMED, t.verdict);
        }
    }
    end();
}

/* The first thread with an end inside that cannot be told. */
static void make_uncertain(thread_line *line)
{
    static family_case open;
    vbss_knot_state now = {.verdict = VBSS_KNOT_VERDICT_NONE};
    for (uint64_t seed = 0; now.verdict != VBSS_KNOT_VERDICT_UNCERTAIN; seed++) {
        assert_true(seed < 1000);
        if (family_named("ends inside")->make(seed, 120, &open)) {
            vbss_knot_input in = input_of(&open.line);
            expect_ok(vbss_knot_detector_judge(detector, &in));
            expect_ok(vbss_knot_detector_get_state(detector, &now, sizeof now));
        }
    }
    *line = open.line;
}

/* It may be another thread, and its first reading tells nothing: the next one must not follow the thread before. */
static void uncertainty_survives_empty_reading(void **state)
{
    (void)state;
    static thread_line unknown;
    uint64_t seed = 0;
    begin();
    make_uncertain(&unknown);
    assert_true(find_unordered(&seed));
    for (int doubted = 0; doubted < 2; doubted++) {
        vbss_knot_state now;
        expect_ok(vbss_knot_detector_reset(detector));
        make_plain(3);
        follow(&plain, false);
        follow(&unknown, doubted == 1);
        expect_ok(vbss_knot_detector_get_state(detector, &now, sizeof now));
        assert_int_equal(VBSS_KNOT_VERDICT_UNCERTAIN, now.verdict);
        follow(&tied.line, false);
        expect_ok(vbss_knot_detector_get_state(detector, &now, sizeof now));
        assert_int_equal(doubted, (now.faults & VBSS_KNOT_FAULT_ORDER) != 0);
    }
    end();
}

int test_detector_history(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(order_is_remembered),
        cmocka_unit_test(certainty_is_remembered),
        cmocka_unit_test(uncertainty_survives_empty_reading),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
