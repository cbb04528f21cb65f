/* Energy that a grasper in a scene hands to a hand on closed paths of one second, by a force that comes so many
 * steps late, less what the hand's own damping takes. All is found in setup; timed is a step on the last path. */
#include <stdio.h>
#include <string.h>

#include "base/error.h"
#include "bench_device.h"
#include "fixtures/hand_path.h"
#include "tool_rig.h"

enum {
    PATHS = 24,
    QUICK_PATHS = 2,
    ROUND = TOOL_RIG_ROUND,
    DELAYS = 3,
    ARMS = 3,
    TIMED = 300,
    MAX_DRAWN = 8 * PATHS
};
static const double arms[ARMS] = {0.0, 2.0, 10.0}; /* N s/m, of the hand */
static const double slides = 1e-4;                 /* m on a round */

typedef struct tool_passivity {
    char name[64];
    tool_meeting what;
    double stiffness, damping;
    uint32_t paths, counted, torn, drawn; /* asked for, and what they were */
    double max_gained[DELAYS][ARMS], max_torn, largest;
    tool_rig rig;
    vec3 home;
    hand_path last;
} tool_passivity;

static vec3 along(const hand_path *path, int step)
{
    return hand_path_at(path, (double)step / ROUND);
}

/* A path on which the thread was torn out, or did not slide where it should, says nothing of its case. */
static bool counts(const tool_passivity *s, double slid_before)
{
    bool holds = tool_rig_holds(&s->rig, 0);
    return s->what < TOOL_HOLDING || (s->what == TOOL_HOLDING && holds) ||
           (holds && tool_rig_slid(&s->rig, 0) - slid_before > slides);
}

static void count(tool_passivity *s, const double work[DELAYS], double paid, double slid_before)
{
    bool torn = s->what >= TOOL_HOLDING && !tool_rig_holds(&s->rig, 0);
    s->drawn++;
    s->torn += torn ? 1 : 0;
    for (int d = 0; torn && d < DELAYS; d++) {
        s->max_torn = vbss_max(s->max_torn, work[d]);
    }
    if (!counts(s, slid_before)) {
        return;
    }
    s->counted++;
    for (int d = 0; d < DELAYS; d++) {
        for (int a = 0; a < ARMS; a++) {
            s->max_gained[d][a] = vbss_max(s->max_gained[d][a], work[d] - arms[a] * paid);
        }
    }
}

/* Twice round: the second round begins and ends in the same state. */
static vbss_result go_round(tool_passivity *s, const hand_path *p)
{
    vec3 late[DELAYS] = {{0.0, 0.0, 0.0}};
    double work[DELAYS] = {0.0}, paid = 0.0, slid_before = 0.0;
    for (int i = 0; i < 2 * ROUND; i++) {
        vec3 x = along(p, i), displacement = vec3_sub(along(p, i + 1), x);
        slid_before = i == ROUND ? tool_rig_slid(&s->rig, 0) : slid_before;
        VBSS_TRY(tool_rig_step_to(&s->rig, 0, vec3_add(s->home, x)));
        memmove(late + 1, late, sizeof late - sizeof late[0]);
        VBSS_TRY(tool_rig_force(&s->rig, 0, &late[0]));
        s->largest = vbss_max(s->largest, vec3_norm(late[0]));
        for (int d = 0; i >= ROUND && d < DELAYS; d++) {
            work[d] += vec3_dot(late[d], displacement);
        }
        paid += i >= ROUND ? ROUND * vec3_norm_squared(displacement) : 0.0;
    }
    count(s, work, paid, slid_before);
    return VBSS_OK;
}

static vbss_result go_all(tool_passivity *s)
{
    vbss_random random;
    vbss_random_seed(&random, 5, 7);
    VBSS_TRY(tool_rig_meet(&s->rig, s->what, s->stiffness, s->damping, &s->home));
    VBSS_TRY(tool_rig_save(&s->rig));
    for (uint32_t i = 0; s->counted < s->paths && i < MAX_DRAWN; i++) {
        s->last = hand_path_draw(&random, 1e-3 + 4e-3 * (i % PATHS) / (PATHS - 1));
        VBSS_TRY(tool_rig_restore(&s->rig));
        VBSS_TRY(go_round(s, &s->last));
    }
    return VBSS_OK;
}

static int setup(void *user)
{
    tool_passivity *s = user;
    s->largest = 0.0;
    s->counted = s->torn = s->drawn = 0;
    s->max_torn = -1e9;
    for (int d = 0; d < DELAYS; d++) {
        for (int a = 0; a < ARMS; a++) {
            s->max_gained[d][a] = -1e9;
        }
    }
    vbss_result result = go_all(s);
    if (result != VBSS_OK) {
        tool_rig_end(&s->rig);
    }
    return result;
}

static int restore(void *user)
{
    tool_passivity *s = user;
    return tool_rig_restore(&s->rig);
}

static int step(void *user, uint32_t index)
{
    tool_passivity *s = user;
    return tool_rig_step_to(&s->rig, 0, vec3_add(s->home, along(&s->last, (int)index)));
}

static uint64_t hash(void *user)
{
    const tool_passivity *s = user;
    return tool_rig_hash(&s->rig);
}

static void finish(void *user, bench_result *result)
{
    const tool_passivity *s = user;
    if (s->counted < s->paths) {
        bench_fail(result, "of %u paths only %u are what they should be", s->drawn, s->counted);
        return;
    }
    for (int a = 0; a < ARMS; a++) {
        for (int d = 0; d < DELAYS; d++) {
            char name[32];
            snprintf(name, sizeof name, "mj_arm%.0f_late%d", arms[a], d);
            bench_counter(result, name, 1e3 * s->max_gained[d][a]);
        }
    }
    bench_counter(result, "largest_N", s->largest);
    bench_counter(result, "paths", s->counted);
    bench_counter(result, "paths_drawn", s->drawn);
    bench_counter(result, "paths_torn", s->torn);
    if (s->torn > 0) {
        bench_counter(result, "mj_torn", 1e3 * s->max_torn);
    }
}

static void teardown(void *user)
{
    tool_passivity *s = user;
    tool_rig_end(&s->rig);
}

void add_tool_passivity_cases(bench *b)
{
    static const double couplings[][2] = {
        {400.0, 5.0}, {1000.0, 5.0}, {2000.0, 5.0}, {2000.0, 10.0}};
    enum { COUPLINGS = sizeof couplings / sizeof couplings[0] };
    static tool_passivity cases[COUPLINGS][TOOL_MEETINGS];
    for (int k = 0; k < COUPLINGS; k++) {
        for (int what = 0; what < TOOL_MEETINGS; what++) {
            tool_passivity *s = &cases[k][what];
            s->what = (tool_meeting)what;
            s->stiffness = couplings[k][0];
            s->damping = couplings[k][1];
            s->paths = bench_is_quick(b) ? QUICK_PATHS : PATHS;
            snprintf(s->name, sizeof s->name, "device/tool-path-%.0f-%.0f/%s", s->stiffness,
                     s->damping, tool_meeting_names[what]);
            const bench_stepped stepped = {.name = s->name,
                                           .user = s,
                                           .steps = TIMED,
                                           .dt_us = 1e3,
                                           .setup = setup,
                                           .restore = restore,
                                           .step = step,
                                           .hash = hash,
                                           .finish = finish,
                                           .teardown = teardown};
            bench_add_stepped(b, &stepped);
        }
    }
}
