/* Calls on the scene and its twin, and what must hold after each. */
#include "fuzz/scenes/fuzzed_scene.h"

#include <stdlib.h>
#include <string.h>
#include <time.h>

static double cpu_time(void)
{
    struct timespec now;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

void fuzz_fail(fuzz_scene *f, fuzz_check check, const char *format, ...)
{
    char detail[256];
    va_list arguments;
    if (f->has_failed) {
        return; /* what follows from the first failure says nothing */
    }
    va_start(arguments, format);
    vsnprintf(detail, sizeof detail, format, arguments);
    va_end(arguments);
    f->has_failed = true;
    fuzz_record(f->findings, check, detail);
}

void fuzz_trace(const fuzz_scene *f, const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    if (f->findings->is_traced) {
        printf("    ");
        vprintf(format, arguments);
        printf("\n");
    }
    va_end(arguments);
}

void fuzz_save(fuzz_scene *f, uint32_t k, fuzz_bytes *bytes)
{
    vbss_scene *scene = f->sides[k].scene;
    vbss_result result = vbss_scene_save(scene, bytes->data, bytes->room, &bytes->count);
    if (result == VBSS_ERROR_CAPACITY) {
        bytes->room = 2 * bytes->count;
        free(bytes->data);
        bytes->data = malloc(bytes->room);
        result = vbss_scene_save(scene, bytes->data, bytes->room, &bytes->count);
    }
    if (result != VBSS_OK) {
        fuzz_fail(f, FUZZ_CHECK_STATUS, "saving returns %s", vbss_result_name(result));
    }
}

static bool is_equal(const fuzz_bytes *a, const fuzz_bytes *b)
{
    return a->count == b->count && memcmp(a->data, b->data, a->count) == 0;
}

static uint64_t first_difference(const fuzz_bytes *a, const fuzz_bytes *b)
{
    uint64_t i = 0;
    while (i < a->count && i < b->count && a->data[i] == b->data[i]) {
        i++;
    }
    return i;
}

static void swap_bytes(fuzz_bytes *a, fuzz_bytes *b)
{
    fuzz_bytes other = *a;
    *a = *b;
    *b = other;
}

void fuzz_begin_call(fuzz_scene *f, const char *expression)
{
    char *name = f->findings->function;
    uint32_t i = 0;
    for (; i + 1 < FUZZ_NAME_ROOM && expression[i] != '(' && expression[i] != '\0'; i++) {
        name[i] = expression[i];
    }
    name[i] = '\0';
}

void fuzz_start_clock(fuzz_scene *f)
{
    f->clock = cpu_time();
}

void fuzz_end_on_side(fuzz_scene *f, uint32_t k, vbss_result result)
{
    double seconds = cpu_time() - f->clock;
    f->findings->slowest_call = vbss_max(seconds, f->findings->slowest_call);
    f->results[k] = result;
    if (f->findings->is_traced && k == 0) {
        printf("  call %u: %s: %s\n", f->findings->call, f->findings->function,
               vbss_result_name(result));
        fflush(stdout);
    }
    if (seconds > f->findings->call_limit) {
        fuzz_fail(f, FUZZ_CHECK_HANG, "%.2f s of CPU time", seconds);
    }
}

void fuzz_compare_twins(fuzz_scene *f)
{
    const fuzz_bytes *a = &f->sides[0].snapshot, *b = &f->sides[1].snapshot;
    f->calls_since_comparison = 0;
    fuzz_save(f, 1, &f->sides[1].snapshot);
    if (!is_equal(a, b)) {
        fuzz_fail(f, FUZZ_CHECK_TWIN, "snapshots of %llu and %llu bytes differ from byte %llu on",
                  (unsigned long long)a->count, (unsigned long long)b->count,
                  (unsigned long long)first_difference(a, b));
    }
}

static void check_unchanged(fuzz_scene *f, fuzz_check check)
{
    const fuzz_bytes *after = &f->scratch, *before = &f->sides[0].snapshot;
    if (!is_equal(after, before)) {
        fuzz_fail(f, check, "%s, snapshots of %llu and %llu bytes differ from byte %llu on",
                  vbss_result_name(f->results[0]), (unsigned long long)before->count,
                  (unsigned long long)after->count,
                  (unsigned long long)first_difference(before, after));
    }
}

void fuzz_end_call(fuzz_scene *f)
{
    if (f->results[0] != f->results[1]) {
        fuzz_fail(f, FUZZ_CHECK_STATUS, "%s, of the twin %s", vbss_result_name(f->results[0]),
                  vbss_result_name(f->results[1]));
    }
    fuzz_save(f, 0, &f->scratch);
    if (f->results[0] != VBSS_OK) {
        f->findings->refused++;
        check_unchanged(f, FUZZ_CHECK_REFUSED);
    }
    swap_bytes(&f->scratch, &f->sides[0].snapshot);
    if (++f->calls_since_comparison >= f->comparison_interval) {
        fuzz_compare_twins(f);
    }
}

void fuzz_end_query(fuzz_scene *f)
{
    fuzz_save(f, 0, &f->scratch);
    check_unchanged(f, FUZZ_CHECK_QUERY);
}

void fuzz_begin_checks(fuzz_scene *f)
{
    fuzz_begin_call(f, "vbss_scene_save(");
    fuzz_save(f, 0, &f->sides[0].snapshot);
    fuzz_compare_twins(f);
}
