/* The file of a trainee's progress: counted, replaced as a whole, and never written to when it is not one. */
#include <stdio.h>
#include <string.h>
#include <unistd.h>

#include "exercise/progress.h"
#include "harness/harness.h"

#define FILE_NAME "test_progress.txt"

static void write_text(const char *text)
{
    FILE *file = fopen(FILE_NAME, "w");
    assert_non_null(file);
    assert_true(fputs(text, file) >= 0);
    assert_int_equal(fclose(file), 0);
}

static void read_text(char text[500])
{
    FILE *file = fopen(FILE_NAME, "r");
    assert_non_null(file);
    text[fread(text, 1, 499, file)] = '\0';
    (void)fclose(file);
}

static vbss_session_exercise_state state_of(vbss_session_exercise exercise, bool passed,
                                            uint32_t aids, double time)
{
    return (vbss_session_exercise_state){.exercise = exercise,
                                         .outcome = passed ? VBSS_SESSION_OUTCOME_PASSED
                                                           : VBSS_SESSION_OUTCOME_FAILED,
                                         .aids_used = aids,
                                         .time = time};
}

static void ended_exercises_are_counted(void **state)
{
    (void)state;
    progress p;
    char why[200], text[500];
    const vbss_session_exercise_state ended[] = {
        state_of(VBSS_SESSION_EXERCISE_CUT, false, 0, 5.0),
        state_of(VBSS_SESSION_EXERCISE_CUT, true, 8, 6.0),
        state_of(VBSS_SESSION_EXERCISE_CUT, true, 0, 9.0),
        state_of(VBSS_SESSION_EXERCISE_CUT, true, 0, 7.5),
        state_of(VBSS_SESSION_EXERCISE_TAKE_NEEDLE, false, 0, 60.0)};
    (void)remove(FILE_NAME);
    for (size_t i = 0; i < sizeof ended / sizeof ended[0]; i++) {
        assert_true(progress_note(FILE_NAME, &ended[i], &p, why, sizeof why));
    }
    read_text(text);
    assert_string_equal(text, "vblast_ss progress 1\n# exercise attempts passed unaided best\n"
                              "take_needle 1 0 0 0.000\ncut 4 3 2 7.500\n");
    assert_int_equal(access(FILE_NAME ".new", F_OK), -1);
    assert_true(progress_read(&p, FILE_NAME, why, sizeof why));
    assert_int_equal(p.rows[VBSS_SESSION_EXERCISE_CUT].unaided, 2);
}

static void comments_and_empty_lines_are_left_out(void **state)
{
    (void)state;
    progress p;
    char why[200];
    write_text("vblast_ss progress 1\r\n\n# mine\npass_mark 2 1 1 12.5\n");
    assert_true(progress_read(&p, FILE_NAME, why, sizeof why));
    assert_int_equal(p.rows[VBSS_SESSION_EXERCISE_PASS_MARK].attempts, 2);
}

static void a_bad_file_is_kept_and_the_line_is_reported(void **state)
{
    (void)state;
    static const struct {
        const char *text, *wanted;
    } rows[] = {
        {"", "line 0"},
        {"my letters\n", "line 1: this is no file of progress"},
        {"vblast_ss progress 2\n", "line 1"},
        {"vblast_ss progress 1\ncut 1 1 1 5.0\ncut 1 1 1 5.0\n",
         "line 3: the exercise occurs twice"},
        {"vblast_ss progress 1\ndance 1 1 1 5.0\n", "line 2: no such exercise"},
        {"vblast_ss progress 1\ncut 1 2 1 5.0\n", "line 2: no such counts"},
        {"vblast_ss progress 1\ncut 1 1 1 nan\n", "line 2: no such counts"},
        {"vblast_ss progress 1\ncut 1 1 1\n", "line 2: not a name"},
        {"vblast_ss progress 1\ncut 1 1 1 5.0 9\n", "line 2: not a name"},
    };
    const vbss_session_exercise_state ended = state_of(VBSS_SESSION_EXERCISE_CUT, true, 0, 5.0);
    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++) {
        progress p;
        char why[200] = "", text[500];
        write_text(rows[i].text);
        assert_false(progress_note(FILE_NAME, &ended, &p, why, sizeof why));
        if (strstr(why, rows[i].wanted) == NULL) {
            fail_msg("'%s' is the message about '%s'", why, rows[i].text);
        }
        read_text(text);
        assert_string_equal(text, rows[i].text);
    }
}

static void a_folder_that_does_not_exist_is_reported(void **state)
{
    (void)state;
    progress p = {.rows = {{0}}};
    char why[200] = "";
    assert_false(progress_write(&p, "no/such/folder/file", why, sizeof why));
    assert_non_null(strstr(why, "no/such/folder/file"));
}

int test_progress(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(ended_exercises_are_counted),
        cmocka_unit_test(comments_and_empty_lines_are_left_out),
        cmocka_unit_test(a_bad_file_is_kept_and_the_line_is_reported),
        cmocka_unit_test(a_folder_that_does_not_exist_is_reported),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
