/* Energy handed to a hand on closed paths of one second, by a spring and damper whose force comes one or two steps
 * late, through an output stage with its defaults. No scene: what couplings of a scene do is measured there. */
#include <stdio.h>
#include <string.h>

#include "device/device.h"

#include "bench_device.h"
#include "fixtures/hand_path.h"

enum { PATHS = 200, ROUND = 1000, MAX_DELAY = 2 };
static const double stiffness = 400.0;

typedef struct passivity {
    double coupling_damping, arm_damping; /* N s/m */
    double max_gained, mean_gained;       /* J */
    uint64_t interventions;
    char name[64];
    uint32_t delay; /* steps */
    bool stage;
} passivity;

static vec3 along(const hand_path *path, int step)
{
    return hand_path_at(path, (double)step / ROUND);
}

/* The path is gone round twice: the second round begins and ends in the same state. */
static double gained(passivity *s, const hand_path *p)
{
    vbss_output_config config;
    output_state stage;
    output_demand demand = {.age = 0.0};
    vec3 late[MAX_DELAY + 1] = {{0.0, 0.0, 0.0}};
    double work = 0.0;
    vbss_output_config_init(&config, sizeof config);
    vbss_output_init_state(&config, &stage);
    for (int i = 0; i < 2 * ROUND; i++) {
        vec3 x = along(p, i), next = along(p, i + 1), before = along(p, i - 1);
        memmove(late + 1, late, sizeof late - sizeof late[0]);
        late[0] = vec3_add_scaled(vec3_scale(x, -stiffness), -s->coupling_damping * ROUND,
                                  vec3_sub(x, before));
        demand.force = late[s->delay];
        vec3 out = demand.force;
        if (s->stage) {
            s->interventions +=
                vbss_output_advance(&config, &stage, 1.0 / ROUND, &demand) != 0 ? 1 : 0;
            out = stage.force;
        }
        vec3 displacement = vec3_sub(next, x);
        double paid = s->arm_damping * ROUND * vec3_norm_squared(displacement);
        work += i >= ROUND ? vec3_dot(out, displacement) - paid : 0.0;
    }
    return work;
}

static void run(void *user)
{
    passivity *s = user;
    vbss_random random;
    vbss_random_seed(&random, 5, 7);
    s->max_gained = -1e9;
    s->mean_gained = 0.0;
    s->interventions = 0;
    for (int i = 0; i < PATHS; i++) {
        double size = 1e-3 + 4e-3 * i / PATHS;
        hand_path p = hand_path_draw(&random, size);
        double work = gained(s, &p);
        s->max_gained = vbss_max(s->max_gained, work);
        s->mean_gained += work / PATHS;
    }
}

static void finish(void *user, bench_result *result)
{
    const passivity *s = user;
    bench_counter(result, "most_gained_mj", 1e3 * s->max_gained);
    bench_counter(result, "mean_gained_mj", 1e3 * s->mean_gained);
    bench_counter(result, "interventions", (double)s->interventions);
}

void add_passivity_cases(bench *b)
{
    static passivity cases[] = {
        {.delay = 1},
        {.delay = 1, .stage = true},
        {.delay = 2},
        {.delay = 2, .stage = true},
        {.delay = 1, .stage = true, .coupling_damping = 0.6},
        {.delay = 2, .stage = true, .coupling_damping = 1.0},
        {.delay = 1, .stage = true, .arm_damping = 1.0},
        {.delay = 2, .stage = true, .arm_damping = 1.0},
    };
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        passivity *s = &cases[i];
        snprintf(s->name, sizeof s->name, "device/closed-path/%s-late-%u-damping-%.1f-arm-%.1f",
                 s->stage ? "stage" : "none", (unsigned)s->delay, s->coupling_damping,
                 s->arm_damping);
        const bench_batch batch = {
            .name = s->name, .user = s, .items = PATHS * 2 * ROUND, .run = run, .finish = finish};
        bench_add_batch(b, &batch);
    }
}
