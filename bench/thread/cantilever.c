/* Stepped scene: the thread of peer.h is released and falls for 0.1 s without drag; nothing else is
 * timed. Each method takes its own largest stable step, where it is cheapest for its error, but ours
 * takes that of a haptic device. Beside the time stand
 *   dynamic_tip_error_mm: of the free end after the fall;
 *   static_tip_error_mm: of the free end after 6 s with a drag of 8 1/s, by steps of the same dt;
 *   stretch_max: the largest error of length in the fall;
 *   largest_dt_us: the largest stable step, see peer.h;
 *   us_per_ms_at_1ms, us_per_ms_at_largest_dt: the fall by other steps, left out where unstable. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/hash.h"
#include "thread/bench_thread.h"
#include "thread/cantilever.h"

enum { SIZES = 4, METHODS = 7, FIRST_PEER = 3, NAME_SIZE = 64 };
static const uint32_t sizes[SIZES] = {30, 60, 120, 240};

/* A tip this far from the static one has not settled. */
#define DAMPED_MM 1.0

/* N = 480, BDF2 with steps of 10 us; N = 240 agrees within 5 um. Not made by this library. */
static const double fallen_tip[3] = {132.9157e-3, -46.2432e-3, 0.0};

static const struct {
    const char *name;
    const cantilever_method *method; /* NULL: not here */
} methods[METHODS] = {
    {"ours", &cantilever_ours},
    {"ours-local", &cantilever_ours_local},
    {"paper", &cantilever_paper},
#if defined(BENCH_HAVE_BULLET)
    {"bullet-multibody", &cantilever_bullet_multibody},
    {"bullet-softbody", &cantilever_bullet_softbody},
#else
    {"bullet-multibody", NULL},
    {"bullet-softbody", NULL},
#endif
#if defined(BENCH_HAVE_MUJOCO)
    {"mujoco", &cantilever_mujoco},
    {"mujoco-damped", &cantilever_mujoco_damped},
#else
    {"mujoco", NULL},
    {"mujoco-damped", NULL},
#endif
};

/* What takes too long: minutes in a full run, more than a few seconds in a quick one. */
typedef enum slow_part { RELAX_STEPS, EVERYTHING } slow_part;
static const struct {
    const char *method;
    uint32_t size;
    slow_part part;
    bool only_quick;
} left_out[] = {
    {"paper", 240, RELAX_STEPS, true},        {"bullet-multibody", 240, RELAX_STEPS, true},
    {"mujoco", 60, RELAX_STEPS, true},        {"mujoco", 120, RELAX_STEPS, false},
    {"mujoco", 120, EVERYTHING, true},        {"mujoco", 240, EVERYTHING, false},
    {"mujoco-damped", 240, EVERYTHING, true},
};

typedef struct fall {
    char name[NAME_SIZE], static_name[NAME_SIZE];
    const cantilever_method *method;
    cantilever_setup setup;
    double largest_dt;
    bool relaxes; /* the static tip is looked for */
    bool quick;
    void *thread;
    double stretch; /* largest so far */
} fall;

static fall falls[SIZES][METHODS];
static bool measured[METHODS];

static bool is_left_out(const bench *b, const char *method, uint32_t size, slow_part part)
{
    for (size_t i = 0; i < sizeof left_out / sizeof left_out[0]; i++) {
        if (left_out[i].size == size && left_out[i].part == part &&
            (bench_is_quick(b) || !left_out[i].only_quick) &&
            strcmp(left_out[i].method, method) == 0) {
            return true;
        }
    }
    return false;
}

static bool same(double a, double b)
{
    return fabs(a - b) <= 1e-9 * b;
}

/* ---- the timed scene */

static void end_fall(void *user)
{
    fall *f = user;
    if (f->thread != NULL) {
        f->method->destroy(f->thread);
        f->thread = NULL;
    }
}

static int begin_fall(void *user)
{
    fall *f = user;
    end_fall(f);
    f->thread = f->method->create(&f->setup);
    f->stretch = 0.0;
    return f->thread != NULL ? 0 : 1;
}

static uint32_t count_fall_steps(void *user)
{
    const fall *f = user;
    return cantilever_steps(CANTILEVER_FALL_S, f->setup.dt);
}

static int step_fall(void *user, uint32_t index)
{
    fall *f = user;
    (void)index;
    return f->method->step(f->thread);
}

/* Called after each step, which is when stretch is looked at. */
static uint64_t hash_fall(void *user)
{
    fall *f = user;
    double tip[3];
    vbss_hash hash;
    f->method->tip(f->thread, tip);
    double stretch = f->method->stretch(f->thread);
    f->stretch = stretch <= f->stretch ? f->stretch : stretch; /* NaN stays */
    vbss_hash_begin(&hash);
    vbss_hash_add(&hash, tip, sizeof tip);
    return vbss_hash_end(&hash);
}

/* ---- what is found out beside it */

static void finish_fall(void *user, bench_result *result)
{
    fall *f = user;
    double tip[3], timed = f->setup.dt, largest = f->largest_dt;
    uint32_t segments = f->setup.segments, tries = f->quick ? 2 : 5;
    f->method->tip(f->thread, tip);
    bench_simulated_step(result, timed * 1e6);
    double us_per_ms = bench_counter_value(result, "us_per_ms");
    if (f->relaxes) {
        bench_counter(result, "static_tip_error_mm",
                      cantilever_relax_mm(f->method, segments, timed));
    }
    bench_counter(result, "dynamic_tip_error_mm", cantilever_distance_mm(tip, fallen_tip));
    bench_counter(result, "stretch_max", f->stretch);
    bench_counter(result, "largest_dt_us", largest * 1e6);
    if (same(timed, 1e-3)) {
        bench_counter(result, "us_per_ms_at_1ms", us_per_ms);
    } else if (largest > 1e-3 || f->method->divides) {
        bench_counter(result, "us_per_ms_at_1ms",
                      cantilever_us_per_ms(f->method, segments, 1e-3, tries));
    }
    if (same(timed, largest) || f->method->divides) {
        bench_counter(result, "us_per_ms_at_largest_dt", us_per_ms);
    } else {
        bench_counter(result, "us_per_ms_at_largest_dt",
                      cantilever_us_per_ms(f->method, segments, largest, tries));
        double off = cantilever_relax_mm(f->method, segments, largest);
        if (!(off < DAMPED_MM)) {
            bench_fail(result, "%g mm from the static tip by steps of largest_dt", off);
        }
    }
    for (size_t m = 0; m < METHODS; m++) {
        measured[m] = measured[m] || methods[m].method == f->method;
    }
}

/* ---- registration */

static void add_fall(bench *b, size_t m, size_t size)
{
    const cantilever_method *method = methods[m].method;
    fall *f = &falls[size][m];
    snprintf(f->name, sizeof f->name, "thread/cantilever/%s/%u", methods[m].name,
             (unsigned)sizes[size]);
    snprintf(f->static_name, sizeof f->static_name, "thread/cantilever-static/%s/%u",
             methods[m].name, (unsigned)sizes[size]);
    if (method == NULL) {
        bench_add_skipped(b, f->name, "its library was not there when this was built");
        return;
    }
    if (is_left_out(b, methods[m].name, sizes[size], EVERYTHING)) {
        bench_add_skipped(b, f->name, "takes too long");
        return;
    }
    f->method = method;
    f->setup.segments = sizes[size];
    f->largest_dt = method->largest_dt[size];
    f->setup.dt = method->dt[size] > 0.0 ? method->dt[size] : f->largest_dt;
    f->relaxes = !is_left_out(b, methods[m].name, sizes[size], RELAX_STEPS);
    f->quick = bench_is_quick(b);
    bench_add_stepped(b, &(bench_stepped){.name = f->name,
                                          .user = f,
                                          .count = count_fall_steps,
                                          .deadline_us = same(f->setup.dt, 1e-3) ? 1000.0 : 0.0,
                                          .restore = begin_fall,
                                          .step = step_fall,
                                          .hash = hash_fall,
                                          .finish = finish_fall,
                                          .teardown = end_fall});
    if (!f->relaxes) {
        bench_add_skipped(b, f->static_name, "settling takes too long");
    }
}

void add_cantilever_cases(bench *b)
{
    for (size_t size = 0; size < SIZES; size++) {
        for (size_t m = 0; m < METHODS; m++) {
            add_fall(b, m, size);
        }
    }
}

void print_cantilever_notes(void)
{
    bool peers = false;
    for (size_t m = 0; m < METHODS; m++) {
        if (measured[m]) {
            printf("%s: %s\n", methods[m].name, methods[m].method->note);
            peers = peers || m >= FIRST_PEER;
        }
    }
    if (peers) {
        printf(
            "Peers are the system's packages: Debian's are built for any x86-64, without AVX.\n");
    }
}
