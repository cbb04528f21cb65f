/* Options combine freely; words that are none are refused. */
#include <string.h>

#include "harness/harness.h"
#include "trainer/options.h"

enum { MAX_WORDS = 12 };

static bool read_words(const char *line, options *o)
{
    static char text[512];
    char *words[MAX_WORDS] = {"trainer"}, why[256];
    int count = 1;
    snprintf(text, sizeof text, "%s", line);
    for (char *word = strtok(text, " "); word != NULL; word = strtok(NULL, " ")) {
        assert_true(count < MAX_WORDS);
        words[count++] = word;
    }
    return options_read(count, words, o, why, sizeof why);
}

static void expect_taken(const char *line, options *o)
{
    if (!read_words(line, o)) {
        fail_msg("'%s' was refused", line);
    }
}

static void devices_combine_freely(void **state)
{
    (void)state;
    options o;
    expect_taken("--mock", &o);
    assert_int_equal(o.arm_count, 0);
    expect_taken("--openhaptics", &o);
    assert_int_equal(o.arm_count, 2);
    expect_taken("--openhaptics Left --mock --nidaq", &o);
    assert_int_equal(o.arm_count, 1);
    assert_string_equal(o.arms[LEFT], "Left");
    assert_int_equal(o.handle_count, 2);
    assert_string_equal(o.lines[RIGHT], "Dev1/port0/line1");
    expect_taken("--replay log.vbss --nidaq Dev2/ai3:Dev2/port1/line2 --seconds 2.5", &o);
    assert_int_equal(o.handle_count, 1);
    assert_string_equal(o.inputs[LEFT], "Dev2/ai3");
    assert_string_equal(o.lines[LEFT], "Dev2/port1/line2");
    assert_string_equal(o.replay, "log.vbss");
    assert_true(o.seconds == 2.5);
    expect_taken("--openhaptics A,B --fault nan@1.5+0.25 --fault warm@3", &o);
    assert_string_equal(o.arms[RIGHT], "B");
    assert_int_equal(o.fault_count, 2);
    assert_string_equal(o.faults[0].name, "nan");
    assert_true(o.faults[0].from == 1.5 && o.faults[0].until == 1.75);
    assert_true(o.core_speed < 0.0); /* measured */
    expect_taken("--mock --exercise cut --progress p.txt", &o);
    assert_string_equal(o.exercise, "cut");
    assert_string_equal(o.progress, "p.txt");
    expect_taken("--mock --core-speed 250", &o);
    assert_true(o.core_speed == 250.0);
    expect_taken("--mock --core-speed off", &o);
    assert_true(o.core_speed == 0.0);
    expect_taken("--mock --simulated", &o);
    assert_true(o.core_speed == 0.0);
    expect_taken("--core-speed measure --mock --simulated", &o);
    assert_true(o.core_speed < 0.0);
}

static void unknown_words_are_rejected(void **state)
{
    (void)state;
    static const char *const lines[] = {"--mack",
                                        "--mock more",
                                        "mock",
                                        "--mock --seconds",
                                        "--mock --seconds ten",
                                        "--mock --seconds -1",
                                        "--mock --seconds 1s",
                                        "--mock --seconds nan",
                                        "--mock --seconds 1e99",
                                        "--mock --scene",
                                        "--mock --core-speed",
                                        "--mock --core-speed fast",
                                        "--mock --core-speed 0",
                                        "--mock --core-speed 250x",
                                        "--openhaptics A,B,C",
                                        "--openhaptics A,",
                                        "--openhaptics ,B",
                                        "--mock --nidaq Dev1/ai0",
                                        "--mock --nidaq :Dev1/port0/line0",
                                        "--mock --nidaq Dev1/ai0:",
                                        "--mock --nidaq a:b,c:d,e:f",
                                        "--mock --nidaq a:b,",
                                        "--mock --fault nan",
                                        "--mock --fault @1",
                                        "--mock --fault nan@",
                                        "--mock --fault nan@1+",
                                        "--mock --fault nan@1x",
                                        "--nidaq",
                                        "--openhaptics Left",
                                        "--openhaptics --calibrate",
                                        "--mock --calibrate --calibration file"};
    options o;
    for (size_t i = 0; i < sizeof lines / sizeof *lines; i++) {
        if (read_words(lines[i], &o)) {
            fail_msg("'%s' was taken", lines[i]);
        }
    }
}

static void overlong_names_are_rejected(void **state)
{
    (void)state;
    options o;
    char line[300] = "--openhaptics ";
    memset(line + strlen(line), 'x', 200);
    assert_false(read_words(line, &o));
}

int test_options(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(devices_combine_freely),
        cmocka_unit_test(unknown_words_are_rejected),
        cmocka_unit_test(overlong_names_are_rejected),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
