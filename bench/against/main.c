/* Runs one subject of the paired bench once:
 *
 *   against_subjects list              names of all subjects, one a line; "seeded" after those that depend on the seed
 *   against_subjects run NAME SEED     counters, one "name value" a line; "times N"; then the CPU time of N steps, ns */
#include <locale.h>
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/error.h"
#include "harness/clock.h"
#include "against/subject.h"

static const subject *const subjects[] = {&free_thread, &held_double_overhand, &tightened_fls,
                                          &poked_drain, &scene_at_rest,        &whole_task};
enum { SUBJECTS = sizeof subjects / sizeof subjects[0] };

typedef struct step_list {
    uint64_t *ns;
    uint32_t count, room;
} step_list;

static vbss_result keep(step_list *times, uint64_t ns)
{
    if (times->count == times->room) {
        uint32_t room = times->room == 0 ? 1u << 12 : 2 * times->room;
        uint64_t *longer = realloc(times->ns, room * sizeof *longer);
        if (longer == NULL) {
            return VBSS_ERROR_OUT_OF_MEMORY;
        }
        times->ns = longer;
        times->room = room;
    }
    times->ns[times->count++] = ns;
    return VBSS_OK;
}

/* All zero without a scene. */
static vbss_result read_counters(const subject *s, vbss_scene_statistics *counters)
{
    memset(counters, 0, sizeof *counters);
    return s->scene != NULL ? vbss_scene_get_statistics(s->scene(), counters, sizeof *counters)
                            : VBSS_OK;
}

static vbss_result run_steps(const subject *s, step_list *times)
{
    const bench_clock clock = bench_system_clock();
    const bench_timer_cost cost = bench_measure_timer(&clock);
    while (s->goes_on()) {
        const bench_interval began = bench_interval_begin(&clock);
        VBSS_TRY(s->step());
        const bench_interval taken = bench_interval_net(bench_interval_end(&clock, began), cost);
        VBSS_TRY(keep(times, s->taken != NULL ? (uint64_t)(1e9 * s->taken()) : taken.cpu_ns));
    }
    return VBSS_OK;
}

static vbss_result report(const subject *s, const vbss_scene_statistics *first,
                          const step_list *times)
{
    vbss_scene_statistics last;
    uint64_t hash;
    VBSS_TRY(read_counters(s, &last));
    VBSS_TRY(s->hash(&hash));
    printf("step_s %.17g\n", SUBJECT_STEP);
    printf("hash %016" PRIx64 "\n", hash);
    printf("done %d\n", s->is_done == NULL || s->is_done());
    if (s->scene != NULL) {
        printf("operations %" PRIu64 "\n", last.operations - first->operations);
        printf("left_out_s %.17g\n", last.time_paused - first->time_paused);
        printf("truncated %" PRIu64 "\n", last.clamped - first->clamped);
    }
    printf("times %" PRIu32 "\n", times->count);
    for (uint32_t i = 0; i < times->count; i++) {
        printf("%" PRIu64 "\n", times->ns[i]);
    }
    return VBSS_OK;
}

static vbss_result run(const subject *s, uint64_t seed)
{
    step_list times = {0};
    vbss_scene_statistics first;
    vbss_result result = s->begin(seed);
    if (result == VBSS_OK) {
        result = read_counters(s, &first);
    }
    if (result == VBSS_OK) {
        result = run_steps(s, &times);
    }
    if (result == VBSS_OK) {
        result = report(s, &first, &times);
    }
    s->end();
    free(times.ns);
    return result;
}

static void list(void)
{
    for (int i = 0; i < SUBJECTS; i++) {
        printf("%s%s\n", subjects[i]->name, subjects[i]->is_seeded ? " seeded" : "");
    }
}

static int run_named(const char *name, uint64_t seed)
{
    for (int i = 0; i < SUBJECTS; i++) {
        if (strcmp(subjects[i]->name, name) == 0) {
            vbss_result result = run(subjects[i], seed);
            if (result != VBSS_OK) {
                fprintf(stderr, "%s: %s\n", name, vbss_result_name(result));
            }
            return result == VBSS_OK ? 0 : 1;
        }
    }
    fprintf(stderr, "there is no subject %s\n", name);
    return 2;
}

int main(int argc, char **argv)
{
    (void)setlocale(LC_NUMERIC, "C"); /* numbers with a decimal point */
    if (argc == 2 && strcmp(argv[1], "list") == 0) {
        list();
        return 0;
    }
    if (argc == 4 && strcmp(argv[1], "run") == 0) {
        return run_named(argv[2], strtoull(argv[3], NULL, 10));
    }
    fprintf(stderr, "usage: against_subjects list | run NAME SEED\n");
    return 2;
}
