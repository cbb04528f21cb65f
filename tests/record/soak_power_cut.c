/* Soak: a process that records is killed at any moment, as by a loss of power, and what it leaves in its file may lack
 * a last few bytes as well. The file opens, says where it ends, replays to its last complete step, goes on from there
 * and then replays as a whole. */
#include <errno.h>
#include <signal.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

#include "fuzz/fuzz.h"
#include "harness/harness.h"

enum { MAX_STEPS = 4000, MORE_STEPS = 20, NANO = 1000 * 1000 };

typedef struct cut {
    harness_soak *soak;
    vbss_random random;
    vbss_context *context;
    vbss_scene *scene;
    char path[64];
    uint8_t *bytes;
    size_t count;
} cut;

#define OR_FAIL(c, call)                                                              \
    do {                                                                              \
        vbss_result result_ = (call);                                                 \
        if (result_ != VBSS_OK) {                                                     \
            harness_soak_fail((c)->soak, "%s: %s", #call, vbss_result_name(result_)); \
            return false;                                                             \
        }                                                                             \
    } while (0)

static bool open_scene(cut *c)
{
    OR_FAIL(c, vbss_context_create(NULL, &c->context));
    OR_FAIL(c, small_scene_create(c->context, &c->scene));
    return true;
}

static bool close_scene(cut *c)
{
    OR_FAIL(c, vbss_context_destroy(c->context));
    return true;
}

/* ---- the process that is killed */

/* In pieces of any size, so that it dies between and within records. */
static bool put(vbss_random *random, int file, const uint8_t *bytes, size_t count)
{
    while (count > 0) {
        size_t piece = 1 + vbss_random_below(random, 700);
        ssize_t done = write(file, bytes, piece < count ? piece : count);
        if (done < 0 && errno != EINTR) {
            return false;
        }
        bytes += done > 0 ? done : 0;
        count -= done > 0 ? (size_t)done : 0;
    }
    return true;
}

static bool record_on(cut *c, vbss_record *record, int file, uint32_t first, uint32_t steps)
{
    const uint8_t *bytes;
    uint64_t count;
    OR_FAIL(c, vbss_scene_set_recorder(c->scene, record));
    for (uint32_t i = 0; i < steps; i++) {
        uint32_t step = first + i; /* what there is no room for often is told at first only */
        OR_FAIL(c, small_scene_drive(c->scene, step < 30 ? step : 6 + step % 20));
        OR_FAIL(c, vbss_scene_step(c->scene, 1e-3));
        if (i % 3 == 0) {
            OR_FAIL(c, vbss_record_take(record, &bytes, &count));
            if (!put(&c->random, file, bytes, (size_t)count)) {
                return false;
            }
        }
    }
    OR_FAIL(c, vbss_record_end(record));
    OR_FAIL(c, vbss_record_take(record, &bytes, &count));
    return put(&c->random, file, bytes, (size_t)count);
}

static bool record_file(cut *c, int file)
{
    vbss_record_config config;
    vbss_record *record;
    OR_FAIL(c, vbss_record_config_init(&config, sizeof config));
    config.snapshot_interval = 1 + vbss_random_below(&c->random, 200);
    config.hash_interval = 1 + vbss_random_below(&c->random, 3);
    return open_scene(c) && (vbss_record_create(c->scene, &config, &record) == VBSS_OK) &&
           record_on(c, record, file, 0, MAX_STEPS);
}

static bool kill_a_recorder(cut *c)
{
    uint32_t milliseconds = 1 + vbss_random_below(&c->random, 150);
    struct timespec pause = {0, (long)milliseconds * NANO};
    int file = mkstemp(c->path), how;
    pid_t child = file < 0 ? -1 : fork();
    if (child < 0) {
        harness_soak_fail(c->soak, "no file or no process");
        return false;
    }
    if (child == 0) {
        _exit(record_file(c, file) ? 0 : 3);
    }
    nanosleep(&pause, NULL);
    kill(child, SIGKILL);
    bool good = waitpid(child, &how, 0) == child && (WIFSIGNALED(how) || WEXITSTATUS(how) == 0);
    if (!good) {
        harness_soak_fail(c->soak, "the recorder has failed by itself");
    }
    return close(file) == 0 && good;
}

/* ---- what is left */

/* But for its last bytes. */
static bool read_file(cut *c, uint32_t lost)
{
    FILE *file = fopen(c->path, "rb");
    if (file == NULL || fseek(file, 0, SEEK_END) != 0) {
        return false;
    }
    size_t size = (size_t)ftell(file);
    free(c->bytes);
    c->count = size > lost ? size - lost : size;
    c->bytes = malloc(c->count + 1);
    rewind(file);
    return c->bytes != NULL && fread(c->bytes, 1, c->count, file) == c->count && fclose(file) == 0;
}

/* All complete steps replay, and no more. */
static bool replay_all(cut *c, uint64_t steps, vbss_result wanted)
{
    vbss_replay *replay;
    vbss_replay_report report;
    vbss_result result;
    OR_FAIL(c, vbss_replay_create(c->context, c->bytes, c->count, &replay));
    OR_FAIL(c, vbss_replay_begin(replay, c->scene));
    do {
        result = vbss_replay_step(replay, &report, sizeof report);
    } while (report.outcome == VBSS_REPLAY_OUTCOME_STEPPED);
    if (result != wanted || report.step != steps || report.outcome == VBSS_REPLAY_OUTCOME_DIFFERS) {
        harness_soak_fail(c->soak, "replay: %s after step %llu of %llu", vbss_result_name(result),
                          (unsigned long long)report.step, (unsigned long long)steps);
    }
    OR_FAIL(c, vbss_replay_destroy(replay));
    return true;
}

static bool go_on(cut *c, uint64_t steps)
{
    vbss_replay *replay;
    vbss_record *record;
    uint64_t position;
    OR_FAIL(c, vbss_replay_create(c->context, c->bytes, c->count, &replay));
    OR_FAIL(c, vbss_replay_begin(replay, c->scene));
    OR_FAIL(c, vbss_record_resume(replay, NULL, &record, &position));
    FILE *file = fopen(c->path, "r+b");
    bool good = file != NULL && ftruncate(fileno(file), (off_t)position) == 0 &&
                fseek(file, 0, SEEK_END) == 0 &&
                record_on(c, record, fileno(file), (uint32_t)steps, MORE_STEPS) &&
                fclose(file) == 0;
    OR_FAIL(c, vbss_record_destroy(record));
    OR_FAIL(c, vbss_replay_destroy(replay));
    return good;
}

static bool check_log(cut *c)
{
    vbss_record_log_report report;
    bool loses = vbss_random_below(&c->random, 3) == 0;
    if (!read_file(c, loses ? vbss_random_below(&c->random, 500) : 0)) {
        return false;
    }
    OR_FAIL(c, vbss_record_check_log(c->context, c->bytes, c->count, &report, sizeof report));
    bool ended = report.result == VBSS_OK;
    if (!ended && report.result != VBSS_ERROR_TRUNCATED) {
        harness_soak_fail(c->soak, "what is left is %s", vbss_result_name(report.result));
    }
    harness_soak_figure(c->soak, "bytes", (double)c->count);
    harness_soak_figure(c->soak, "steps", (double)report.steps);
    harness_soak_figure(c->soak, "snapshots", (double)report.snapshots);
    if (report.good_bytes == 0) {
        return true; /* killed before it had begun */
    }
    return replay_all(c, report.steps, report.result) && go_on(c, report.steps) &&
           read_file(c, 0) && replay_all(c, report.steps + MORE_STEPS, VBSS_OK);
}

static void run(harness_soak *soak)
{
    cut c = {.soak = soak, .path = "/tmp/power_cut.XXXXXX"};
    vbss_random_seed(&c.random, soak->seed, 1);
    if (!kill_a_recorder(&c) || !open_scene(&c) || !check_log(&c) || !close_scene(&c)) {
        harness_soak_fail(soak, "could not go on");
    }
    free(c.bytes);
    unlink(c.path);
}

int main(int argc, char **argv)
{
    return harness_soak_main(argc, argv, run);
}
