/* Random scenes under random calls: see fuzzed_scene.h for what must hold.
 *
 *   scene_fuzzer [--seed S] [--first K] [--scenes N] [--calls N] [--seconds T] [--resume FILE]
 *   scene_fuzzer [--seed S] [--calls N] --scene K       this scene alone; prints each call
 *
 * The scenes run in a child process, so that a crash ends only one of them. With --resume, each range of scenes that
 * is complete is a line of the file; a run that was interrupted goes on after the last one. A file belongs to one
 * build: other executables ignore its lines. */
#include <errno.h>
#include <signal.h>
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/time.h>
#include <sys/wait.h>
#include <unistd.h>

#include "base/hash.h"
#include "fuzz/scenes/fuzzed_scene.h"

enum { RANGE = 50, KILL_AFTER = 60 /* CPU time of a scene, s */ };

typedef struct options {
    uint64_t seed, first, scenes, calls;
    double seconds;
    const char *resume;
    bool is_traced;
    uint64_t executable; /* its hash */
} options;

static uint64_t hash_file(const char *path)
{
    uint8_t bytes[65536];
    size_t count;
    vbss_hash hash;
    FILE *file = fopen(path, "rb");
    vbss_hash_begin(&hash);
    while (file != NULL && (count = fread(bytes, 1, sizeof bytes, file)) > 0) {
        vbss_hash_add(&hash, bytes, count);
    }
    if (file != NULL) {
        fclose(file);
    }
    return vbss_hash_end(&hash);
}

static bool read_option(options *o, const char *name, const char *value)
{
    uint64_t *numbers[] = {&o->seed, &o->first, &o->scenes, &o->calls, &o->first};
    const char *const names[] = {"--seed", "--first", "--scenes", "--calls", "--scene"};
    for (uint32_t i = 0; i < 5; i++) {
        if (strcmp(name, names[i]) == 0) {
            char *end;
            *numbers[i] = strtoull(value, &end, 10);
            if (i == 4) {
                o->scenes = 1;
                o->is_traced = true;
            }
            return *end == '\0' && end != value;
        }
    }
    if (strcmp(name, "--seconds") == 0) {
        o->seconds = strtod(value, NULL);
        return o->seconds > 0.0;
    }
    if (strcmp(name, "--resume") == 0) {
        o->resume = value;
        return true;
    }
    return false;
}

static bool read_options(int argc, char **argv, options *o)
{
    *o = (options){.seed = 1, .scenes = 100, .calls = 100, .seconds = 1.0};
    o->executable = hash_file(argv[0]);
    for (int i = 1; i < argc; i += 2) {
        if (i + 1 == argc || !read_option(o, argv[i], argv[i + 1])) {
            return false;
        }
    }
    return true;
}

/* ---- ranges that are complete */

static bool is_done(const options *o, uint64_t first, uint64_t *failures)
{
    char line[256];
    bool found = false;
    FILE *file = o->resume != NULL ? fopen(o->resume, "r") : NULL;
    while (file != NULL && fgets(line, sizeof line, file) != NULL) {
        uint64_t executable, seed, calls, begin, count, failed;
        if (strchr(line, '\n') != NULL && /* a line that was cut off is none */
            sscanf(line, "%" SCNx64 " %" SCNu64 " %" SCNu64 " %" SCNu64 " %" SCNu64 " %" SCNu64,
                   &executable, &seed, &calls, &begin, &count, &failed) == 6 &&
            executable == o->executable && seed == o->seed && calls == o->calls && begin == first &&
            count == RANGE) {
            found = true;
            *failures = failed;
        }
    }
    if (file != NULL) {
        fclose(file);
    }
    return found;
}

static void write_done(const options *o, uint64_t first, uint64_t failures)
{
    FILE *file = o->resume != NULL ? fopen(o->resume, "a") : NULL;
    if (file != NULL) {
        fprintf(file, "%" PRIx64 " %" PRIu64 " %" PRIu64 " %" PRIu64 " %d %" PRIu64 "\n",
                o->executable, o->seed, o->calls, first, RANGE, failures);
        fclose(file);
    } else if (o->resume != NULL) {
        fprintf(stderr, "%s: %s\n", o->resume, strerror(errno));
    }
}

/* ---- processes */

/* The child: a scene that never ends is ended by the timer's signal. */
static void run_scenes(fuzz_findings *findings, const options *o, uint64_t first, uint64_t end)
{
    const struct itimerval timer = {.it_value = {.tv_sec = KILL_AFTER}};
    for (uint64_t scene = first; scene < end; scene++) {
        setitimer(ITIMER_VIRTUAL, &timer, NULL);
        fuzz_run_scene(findings, o->seed, scene, (uint32_t)o->calls);
    }
}

/* Runs the scenes of a range, each at most once. False: no process could be made. */
static bool run_range(fuzz_findings *findings, const options *o, uint64_t first, uint64_t end)
{
    while (first < end) {
        int status;
        fflush(stdout);
        findings->scene = first;
        findings->function[0] = '\0';
        const pid_t child = fork();
        if (child == 0) {
            run_scenes(findings, o, first, end);
            fflush(stdout);
            exit(0); /* not _exit: sanitizers look for leaks */
        }
        if (child < 0 || waitpid(child, &status, 0) != child) {
            perror("scene_fuzzer");
            return false;
        }
        if (WIFEXITED(status) && WEXITSTATUS(status) == 0) {
            return true;
        }
        char detail[64];
        snprintf(detail, sizeof detail, WIFSIGNALED(status) ? "signal %d" : "exit code %d",
                 WIFSIGNALED(status) ? WTERMSIG(status) : WEXITSTATUS(status));
        fuzz_record(findings,
                    WIFSIGNALED(status) && WTERMSIG(status) == SIGVTALRM ? FUZZ_CHECK_HANG
                                                                         : FUZZ_CHECK_CRASH,
                    detail);
        first = findings->scene + 1;
    }
    return true;
}

static bool run_all(fuzz_findings *findings, const options *o)
{
    const uint64_t end = o->first + o->scenes;
    for (uint64_t first = o->first; first < end; first += RANGE) {
        const bool is_whole = first + RANGE <= end;
        uint64_t failures;
        if (is_whole && is_done(o, first, &failures)) {
            findings->failures += failures;
            findings->scenes += RANGE;
            continue;
        }
        const uint64_t before = findings->failures;
        if (!run_range(findings, o, first, is_whole ? first + RANGE : end)) {
            return false;
        }
        if (is_whole) {
            write_done(o, first, findings->failures - before);
        }
    }
    return true;
}

int main(int argc, char **argv)
{
    options o;
    if (!read_options(argc, argv, &o)) {
        fprintf(
            stderr,
            "usage: %s [--seed S] [--first K] [--scenes N | --scene K] [--calls N] [--seconds T] "
            "[--resume FILE]\n",
            argv[0]);
        return 2;
    }
    fuzz_findings *findings = fuzz_share_findings();
    if (findings == NULL) {
        perror("scene_fuzzer");
        return 2;
    }
    findings->seed = o.seed;
    findings->call_limit = o.seconds;
    findings->is_traced = o.is_traced;
    if (!run_all(findings, &o)) {
        return 2;
    }
    fuzz_print_summary(findings);
    return findings->failures == 0 ? 0 : 1;
}
