/* Files of the programs with hands: a killed program, a full quota and a second writer lose nothing that was complete. */
#include <signal.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include "harness/harness.h"
#include "throw/log_file.h"
#include "trainer/calibration.h"

#define LOG "trainer_log_file.vbss"
#define CALIBRATION "trainer_log_file.txt"

enum { PIECE = 1000, LIMIT = 4500 };

/* Stands for a quota: files end there. */
static void limit_file_size(rlim_t bytes)
{
    const struct rlimit limit = {bytes, bytes};
    assert_int_equal(setrlimit(RLIMIT_FSIZE, &limit), 0);
}

static uint8_t *make_piece(uint8_t value)
{
    static uint8_t bytes[PIECE];
    memset(bytes, value, PIECE);
    return bytes;
}

/* The file holds so many pieces, numbered from 0, and nothing else. */
static void expect_pieces(uint32_t count)
{
    static uint8_t found[16 * PIECE];
    FILE *file = fopen(LOG, "rb");
    assert_non_null(file);
    size_t size = fread(found, 1, sizeof found, file);
    assert_int_equal(fclose(file), 0);
    assert_int_equal(size, count * PIECE);
    for (uint32_t i = 0; i < count; i++) {
        assert_memory_equal(found + (size_t)i * PIECE, make_piece((uint8_t)i), PIECE);
    }
}

static bool write_pieces(log_file *f, uint32_t first, uint32_t end)
{
    bool good = true;
    for (uint32_t i = first; i < end && good; i++) {
        good = log_file_write(f, make_piece((uint8_t)i), PIECE);
    }
    return good;
}

/* Runs `program` in a process of its own, its errors in a file. Returns how it ended. */
static int run_apart(int (*program)(void), char *errors, size_t size)
{
    int how, pipes[2];
    assert_int_equal(pipe(pipes), 0);
    pid_t child = fork();
    assert_true(child >= 0);
    if (child == 0) {
        dup2(pipes[1], STDERR_FILENO);
        _exit(program());
    }
    close(pipes[1]);
    size_t length = 0;
    for (ssize_t count = 1; count > 0 && length + 1 < size;
         length += count > 0 ? (size_t)count : 0) {
        count = read(pipes[0], errors + length, size - 1 - length);
    }
    errors[length] = '\0';
    close(pipes[0]);
    assert_true(waitpid(child, &how, 0) == child);
    return how;
}

static int be_killed(void)
{
    log_file f;
    if (!log_file_open(&f, LOG) || !write_pieces(&f, 0, 5)) {
        return 1;
    }
    raise(SIGKILL);
    return 2;
}

static void killed_writer_loses_no_complete_piece(void **state)
{
    (void)state;
    char errors[256];
    int how = run_apart(be_killed, errors, sizeof errors);
    assert_true(WIFSIGNALED(how) && WTERMSIG(how) == SIGKILL);
    expect_pieces(5);
}

static int exceed_quota(void)
{
    log_file f;
    if (!log_file_open(&f, LOG)) {
        return 1;
    }
    limit_file_size(LIMIT);
    bool good = write_pieces(&f, 0, 10);
    bool more = log_file_write(&f, make_piece(10), PIECE);
    log_file_close(&f);
    return good || more ? 2 : 0;
}

static void full_quota_is_reported_and_keeps_complete_pieces(void **state)
{
    (void)state;
    char errors[256];
    assert_int_equal(run_apart(exceed_quota, errors, sizeof errors), 0);
    assert_string_equal(errors, LOG ": File too large; the log ends after 4000 bytes\n");
    expect_pieces(4);
}

static int write_as_well(void)
{
    log_file f;
    return log_file_open(&f, LOG) ? 1 : 0;
}

static void second_writer_is_refused_and_changes_nothing(void **state)
{
    (void)state;
    log_file f;
    char errors[256];
    assert_true(log_file_open(&f, LOG));
    assert_true(write_pieces(&f, 0, 3));
    assert_int_equal(run_apart(write_as_well, errors, sizeof errors), 0);
    assert_non_null(strstr(errors, "another program is writing this file"));
    assert_true(write_pieces(&f, 3, 6));
    log_file_close(&f);
    expect_pieces(6);
    assert_true(log_file_open(&f, LOG)); /* the lock is gone */
    log_file_close(&f);
    expect_pieces(0);
}

static void device_and_missing_folder_are_reported(void **state)
{
    (void)state;
    log_file f;
    if (access("/dev/full", W_OK) == 0) {
        assert_true(log_file_open(&f, "/dev/full"));
        assert_false(log_file_write(&f, make_piece(0), PIECE));
        log_file_close(&f);
    }
    assert_false(log_file_open(&f, "no such folder/log.vbss"));
    assert_true(log_file_open(&f, NULL) && log_file_write(&f, make_piece(0), PIECE));
    log_file_close(&f);
}

static calibration of_scale(double scale)
{
    calibration c;
    expect_ok(calibration_init(&c));
    c.known[LEFT] = true;
    c.hands[LEFT].scale = scale;
    return c;
}

static int write_calibration_beyond_quota(void)
{
    calibration other = of_scale(3.0);
    signal(SIGXFSZ, SIG_IGN);
    limit_file_size(20);
    return calibration_write(&other, CALIBRATION) ? 1 : 0;
}

static void failed_calibration_keeps_old_one(void **state)
{
    (void)state;
    calibration old = of_scale(2.0), found;
    char why[128], errors[256];
    assert_true(calibration_write(&old, CALIBRATION));
    assert_int_equal(run_apart(write_calibration_beyond_quota, errors, sizeof errors), 0);
    expect_ok(calibration_init(&found));
    assert_true(calibration_read(&found, CALIBRATION, why, sizeof why));
    assert_true(found.hands[LEFT].scale == 2.0);
    assert_true(access(CALIBRATION ".new", F_OK) != 0);
}

int test_log_file(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(killed_writer_loses_no_complete_piece),
        cmocka_unit_test(full_quota_is_reported_and_keeps_complete_pieces),
        cmocka_unit_test(second_writer_is_refused_and_changes_nothing),
        cmocka_unit_test(device_and_missing_folder_are_reported),
        cmocka_unit_test(failed_calibration_keeps_old_one),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
