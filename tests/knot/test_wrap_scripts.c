/* The stories' truth: what the oracle sees when nothing is held, the turns of the thread about the tool, stages. */
#include "base/elementary.h"
#include "fixtures/wrap_scripts.h"

#include <string.h>

#include "harness/harness.h"
#include "oracle/knot_type.h"

#define PI 3.141592653589793

enum { MOMENTS = 40 };

static script_frame frame;

static double moment(int i)
{
    return (double)i / MOMENTS;
}

/* While W holds the tail its end may lie in the loops. */
static void expect_tied(void)
{
    knot_type type,
        wanted = knot_type_of_throws(frame.throws, frame.throw_wraps, frame.throw_signs);
    if (frame.stage != SCRIPT_OPEN && frame.stage != SCRIPT_PASSED) {
        assert_true(knot_type_of(frame.line.x, frame.line.count, &type));
        assert_true(knot_type_same(wanted, type));
    }
}

/* Signed turns of all that is beside W, looking from its tip to its handle (+x). */
static double turns_about_w(void)
{
    const script_tool *w = &frame.tools[SCRIPT_W];
    vec3 tip = w->axis[w->points - 1];
    double sum = 0.0;
    for (uint32_t i = 0; i + 1 < frame.line.count; i++) {
        vec3 a = vec3_sub(frame.line.x[i], tip), b = vec3_sub(frame.line.x[i + 1], tip);
        if (a.x > 0.0 && b.x > 0.0) {
            sum += vbss_atan2(a.y * b.z - a.z * b.y, a.y * b.y + a.z * b.z);
        }
    }
    return sum / (2.0 * PI);
}

/* The turns of the story are those of the thread. */
static void expect_turns(double t)
{
    if (t < 0.44 || frame.tools[SCRIPT_W].axis[2].x > 10e-3) { /* no tail beside it, or no loop */
        expect_near(frame.turns, turns_about_w(), 0.12);
        assert_int_equal(frame.turns == 0.0, frame.sense == 0);
    }
}

/* Strands keep clear of the shaft, but for what the jaws hold. */
static void expect_room(void)
{
    const script_tool *w = &frame.tools[SCRIPT_W];
    vec3 tip = w->axis[2];
    for (uint32_t i = 0; i < frame.line.count; i++) {
        vec3 from = vec3_sub(frame.line.x[i], tip);
        double out = sqrt(from.y * from.y + from.z * from.z);
        if (from.x > 1e-3 && w->held == SCRIPT_HELD_THREAD) {
            assert_true(out > 1.2e-3);
        }
    }
    if (w->held == SCRIPT_HELD_THREAD) {
        vec3 jaws = thread_line_at(&frame.line, w->held_place);
        assert_true(vec3_distance(jaws, tip) < 1.2e-3);
    }
    vec3 needle = frame.tools[SCRIPT_N].axis[1];
    expect_near(0.0, vec3_distance(needle, frame.line.x[frame.line.count - 1]), 1e-15);
}

/* ---- the law, and how each story ends */

static void turns_tie_predicted_knot(void **state)
{
    (void)state;
    for (uint32_t variant = 0; variant < 26; variant++) {
        double turns = 0.5 * (variant % 13) - 3.0;
        bool to_handle = variant >= 13;
        int wraps = to_handle ? 0 : fabs(turns) > 2.0 ? 2 : fabs(turns) > 1.0 ? 1 : 0;
        assert_true(wrap_script_frame(0, variant, 1.0, 240, &frame));
        assert_int_equal(wraps > 0 ? 1 : 0, frame.throws);
        assert_int_equal(wraps, frame.wraps);
        assert_int_equal(wraps == 0 ? 0 : turns > 0.0 ? -1 : 1, frame.sign);
        assert_true(wrap_script_frame(0, variant, 0.44, 240, &frame));
        expect_near(turns, frame.turns, 1e-12);
    }
}

static const struct ending {
    const char *name;
    uint32_t throws;
    bool passes, forms; /* on the way */
} endings[] = {
    {"second throw", 2, true, true},          {"third throw", 3, true, true},
    {"both limbs pulled", 1, true, true},     {"one limb pulled", 1, true, true},
    {"same hand again", 2, true, true},       {"wraps towards the handle", 0, false, false},
    {"bight of the tail", 0, false, false},   {"tail dropped", 0, true, false},
    {"tail backs out", 0, true, true},        {"counter-wrap", 0, false, false},
    {"loop beyond the tip", 0, false, false}, {"loop on the floor", 0, false, false},
    {"needle goes back", 0, false, false},    {"needle withdrawn", 0, true, true},
};
enum { ENDINGS = sizeof endings / sizeof endings[0] };

/* Whether that script has an ending above, which it then has had. */
static bool ends_as_it_says(const char *name, bool passes, bool forms)
{
    size_t k = 0;
    while (k < ENDINGS && strcmp(endings[k].name, name) != 0) {
        k++;
    }
    if (k == ENDINGS) {
        return false;
    }
    assert_int_equal(endings[k].throws, frame.throws);
    assert_int_equal(endings[k].passes, passes);
    assert_int_equal(endings[k].forms, forms);
    bool alternate = frame.throws < 2 ||
                     frame.throw_signs[frame.throws - 1] != frame.throw_signs[frame.throws - 2];
    assert_int_equal(strcmp(name, "same hand again") != 0, alternate);
    assert_int_equal(strcmp(name, "needle withdrawn") == 0, frame.line.tissue_place < 0.0);
    return true;
}

/* One pass through all stories, as each frame takes long to make. */
static void script_knots_turns_holes_and_ends_match(void **state)
{
    (void)state;
    size_t ended = 0;
    for (uint32_t script = 0; script < WRAP_SCRIPTS; script++) {
        const uint32_t variants = wrap_scripts[script].variants;
        uint32_t endings_of_script = 0;
        for (uint32_t variant = 0; variant < variants; variant++) {
            bool passes = false, forms = false;
            for (int i = 0; i <= MOMENTS; i++) {
                assert_true(wrap_script_frame(script, variant, moment(i), 240, &frame));
                expect_tied();
                expect_turns(moment(i));
                expect_room();
                passes = passes || frame.stage == SCRIPT_PASSED;
                forms = forms || frame.stage == SCRIPT_FORMED;
            }
            endings_of_script += ends_as_it_says(wrap_scripts[script].name, passes, forms);
        }
        assert_true(endings_of_script == 0 || endings_of_script == variants);
        ended += endings_of_script > 0;
    }
    assert_int_equal(ended, ENDINGS);
}

static void invalid_scripts_are_rejected(void **state)
{
    (void)state;
    assert_false(wrap_script_frame(WRAP_SCRIPTS, 0, 0.5, 240, &frame));
    assert_false(wrap_script_frame(0, 0, -0.1, 240, &frame));
    assert_false(wrap_script_frame(1, 0, 1.0, 8, &frame));
    assert_false(wrap_script_frame(0, 0, 0.5, STACK_POINTS, &frame));
}

int test_wrap_scripts(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(turns_tie_predicted_knot),
        cmocka_unit_test(script_knots_turns_holes_and_ends_match),
        cmocka_unit_test(invalid_scripts_are_rejected),
    };
    return cmocka_run_group_tests_name("wrap scripts", tests, NULL, NULL);
}
