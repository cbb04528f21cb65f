/* The stiffest coupling with which a hand of a mass, pressed to a wall at 1 kHz, comes to rest in 3 s: found by
 * bisection on stiffnesses 5 % apart, for both walls; the lesser counts. All is found in setup. */
#include <stdio.h>
#include <string.h>

#include "base/error.h"
#include "bench_device.h"
#include "tool_rig.h"

enum { MAX_DELAY = 2, STEPS = 3000, RUNGS = 128, QUICK_RUNGS = 4 };
static const double pressed = 1.0, speed = 0.05, rest = 1e-5; /* N; m/s; m */

typedef struct tool_wall {
    char name[64];
    double mass, arm_damping, damping;
    int delay, rungs;
    double stiffest[2]; /* N/m, below and beside; 0: none is */
    tool_rig rig;
    vec3 home;
} tool_wall;

static double rung(int i)
{
    double stiffness = 100.0;
    for (int k = 0; k < i; k++) {
        stiffness *= 1.05;
    }
    return stiffness;
}

/* The hand moves by what it feels in small steps within one of the scene. */
static vbss_result swing(tool_wall *s, vec3 in, double *swung)
{
    enum { FINE = 20 };
    const double fine = 1.0 / (TOOL_RIG_ROUND * FINE);
    double x = 0.0, v = speed, late[MAX_DELAY + 1] = {0.0}, low = 1.0, high = -1.0;
    for (int i = 0; i < STEPS && fabs(x) < 0.1; i++) {
        vec3 force;
        VBSS_TRY(tool_rig_step_to(&s->rig, 0, vec3_add_scaled(s->home, x, in)));
        VBSS_TRY(tool_rig_force(&s->rig, 0, &force));
        memmove(late + 1, late, sizeof late - sizeof late[0]);
        late[0] = vec3_dot(force, in);
        for (int k = 0; k < FINE; k++) {
            v += fine * (pressed + late[s->delay] - s->arm_damping * v) / s->mass;
            x += fine * v;
        }
        low = i >= STEPS - 500 ? vbss_min(low, x) : low;
        high = i >= STEPS - 500 ? vbss_max(high, x) : high;
    }
    *swung = fabs(x) < 0.1 ? high - low : 1.0;
    return VBSS_OK;
}

static vbss_result rests(tool_wall *s, tool_meeting wall, double stiffness, bool *does)
{
    double swung = 1.0;
    vec3 in = wall == TOOL_WALL_BELOW ? vec3_make(0.0, 0.0, -1.0) : vec3_make(-1.0, 0.0, 0.0);
    vbss_result result = tool_rig_meet(&s->rig, wall, stiffness, s->damping, &s->home);
    result = result == VBSS_OK ? swing(s, in, &swung) : result;
    tool_rig_end(&s->rig);
    *does = swung < rest;
    return result;
}

static vbss_result find(tool_wall *s, tool_meeting wall, double *stiffest)
{
    int low = -1, high = s->rungs; /* it rests at low, not at high */
    while (high - low > 1) {
        int middle = (low + high) / 2;
        bool does;
        VBSS_TRY(rests(s, wall, rung(middle), &does));
        low = does ? middle : low;
        high = does ? high : middle;
    }
    *stiffest = low < 0 ? 0.0 : rung(low);
    return VBSS_OK;
}

static int setup(void *user)
{
    tool_wall *s = user;
    vbss_result result = find(s, TOOL_WALL_BELOW, &s->stiffest[0]);
    result = result == VBSS_OK ? find(s, TOOL_WALL_BESIDE, &s->stiffest[1]) : result;
    if (result == VBSS_OK) { /* for what is timed: a tool that stays pressed to the wall */
        result = tool_rig_meet(&s->rig, TOOL_WALL_BELOW, 400.0, s->damping, &s->home);
    }
    result = result == VBSS_OK ? tool_rig_save(&s->rig) : result;
    if (result != VBSS_OK) {
        tool_rig_end(&s->rig);
    }
    return result;
}

static int restore(void *user)
{
    tool_wall *s = user;
    return tool_rig_restore(&s->rig);
}

static int step(void *user, uint32_t index)
{
    tool_wall *s = user;
    (void)index;
    return tool_rig_steps(&s->rig, 1);
}

static void finish(void *user, bench_result *result)
{
    const tool_wall *s = user;
    bench_counter(result, "below_N_per_m", s->stiffest[0]);
    bench_counter(result, "beside_N_per_m", s->stiffest[1]);
    bench_counter(result, "stiffest_N_per_m", vbss_min(s->stiffest[0], s->stiffest[1]));
}

static void teardown(void *user)
{
    tool_wall *s = user;
    tool_rig_end(&s->rig);
}

void add_tool_wall_cases(bench *b)
{
    static const double masses[] = {0.1, 0.2}, arms[] = {0.0, 5.0}, dampings[] = {2.0, 5.0, 10.0};
    static tool_wall cases[24];
    for (int i = 0; i < 24; i++) {
        tool_wall *s = &cases[i];
        s->damping = dampings[i / 8];
        s->delay = 1 + i / 4 % 2;
        s->mass = masses[i / 2 % 2];
        s->arm_damping = arms[i % 2];
        s->rungs = bench_is_quick(b) ? QUICK_RUNGS : RUNGS;
        snprintf(s->name, sizeof s->name, "device/tool-wall-%.0f-late-%d/%.1fkg-arm-%.0f",
                 s->damping, s->delay, s->mass, s->arm_damping);
        const bench_stepped stepped = {.name = s->name,
                                       .user = s,
                                       .steps = 20,
                                       .dt_us = 1e3,
                                       .setup = setup,
                                       .restore = restore,
                                       .step = step,
                                       .finish = finish,
                                       .teardown = teardown};
        if (!bench_is_quick(b) || i % 8 == 0) {
            bench_add_stepped(b, &stepped);
        }
    }
}
