/* The witness, and numbers that must stay finite.
 *
 * The witness falls freely, far above all other bodies, which move within a few metres of the origin. It has no
 * candidates, so nothing may hold it back: at most one step offline, and three calls in real time (six with the smallest budget,
 * while a step waits behind another one). */
#include "fixtures/solver_of.h"
#include "fuzz/scenes/fuzzed_scene.h"

#define HEIGHT 10.0
/* A body above this height, m, or that may come that high in a step is too near to the witness. */
#define CEILING 3.0
#define SMALLEST_BUDGET 1000 /* operations of a call */

static void add_capsule(fuzz_scene *f)
{
    const vbss_scene_capsule ball = {{0.0, 0.0, 0.0}, {1e-3, 0.0, 0.0}, 1e-3};
    vbss_scene_rigid_config config;
    uint32_t number = 0;
    vbss_scene_rigid_config_init(&config, sizeof config);
    config.kind = VBSS_SCENE_RIGID_FREE;
    config.capsules = &ball;
    config.capsule_count = 1;
    config.position[1] = HEIGHT;
    config.velocity[1] = -0.1;
    config.gravity[1] = -9.81;
    FUZZ_CALL(f, vbss_scene_add_rigid(side->scene, &config, &number));
    if (f->results[0] == VBSS_OK) {
        fuzz_register(f, number, FUZZ_RIGID, (void *[FUZZ_SIDES]){NULL, NULL});
    }
}

static void add_thread(fuzz_scene *f)
{
    vbss_thread_config config;
    vbss_thread *threads[FUZZ_SIDES];
    vbss_thread_config_init(&config, sizeof config);
    config.segment_count = 2;
    config.length = 0.01;
    config.start[1] = HEIGHT;
    for (uint32_t k = 0; k < FUZZ_SIDES; k++) {
        if (vbss_thread_create(f->sides[k].context, &config, &threads[k]) != VBSS_OK) {
            fuzz_fail(f, FUZZ_CHECK_SETUP, "no thread as a witness");
            return;
        }
    }
    fuzz_add_handle(f, FUZZ_THREAD, (void *[FUZZ_SIDES]){threads[0], threads[1]});
}

/* The position of a body, the largest height of any of its points, and its speed. */
typedef struct body_motion {
    vec3 position;
    double top, speed;
    bool is_finite;
} body_motion;

static void add_point(body_motion *motion, vec3 position, vec3 velocity)
{
    motion->position = position;
    motion->top = vbss_max(position.y, motion->top);
    motion->speed = vbss_max(vec3_norm(velocity), motion->speed);
    motion->is_finite = motion->is_finite && vec3_is_finite(position) && vec3_is_finite(velocity);
}

static bool find_thread_motion(const fuzz_scene *f, uint32_t number, body_motion *motion)
{
    vbss_thread *thread;
    vbss_view x, v;
    if (vbss_scene_get_thread(f->sides[0].scene, number, &thread) != VBSS_OK) {
        return false;
    }
    (void)vbss_thread_get_view(thread, VBSS_THREAD_VIEW_POSITIONS, &x, sizeof x);
    (void)vbss_thread_get_view(thread, VBSS_THREAD_VIEW_VELOCITIES, &v, sizeof v);
    for (uint64_t i = 0; i < x.count; i++) {
        const char *position = (const char *)x.data + i * x.stride_bytes;
        const char *velocity = (const char *)v.data + i * v.stride_bytes;
        add_point(motion, vec3_load((const double *)(const void *)position),
                  vec3_load((const double *)(const void *)velocity));
    }
    return true;
}

static bool find_motion(const fuzz_scene *f, uint32_t number, body_motion *motion)
{
    vbss_scene_rigid_state state;
    *motion = (body_motion){.top = -1e300, .is_finite = true};
    if (vbss_scene_get_rigid(f->sides[0].scene, number, &state, sizeof state) != VBSS_OK) {
        return find_thread_motion(f, number, motion);
    }
    add_point(motion, vec3_load(state.position), vec3_load(state.velocity));
    return true;
}

void fuzz_add_witness(fuzz_scene *f)
{
    const uint32_t last = f->last_number;
    /* By the baseline method, free rigid bodies stay where they are. */
    if (fuzz_chance(f, 0.5) && f->config.method == VBSS_METHOD_IMPLICIT) {
        add_capsule(f);
    } else {
        add_thread(f);
    }
    if (f->last_number > last) {
        body_motion motion;
        (void)find_motion(f, f->last_number, &motion);
        f->witness = (fuzz_witness){.number = f->last_number, .position = motion.position};
    }
}

/* A scene without room for its contacts says so and does not know which bodies are free. */
static bool has_had_room(fuzz_scene *f, const vbss_scene_statistics *statistics)
{
    const bool has_room = statistics->rejected_full == f->witness.full_attempts;
    f->witness.full_attempts = statistics->rejected_full;
    return has_room;
}

/* Calls in which a body that touches nothing may stay where it is. The smallest budget of a call ends it after a substep or two, so
 * a step that is behind another one waits for as many calls again. */
static uint32_t stationary_limit(const fuzz_scene *f, const vbss_scene_statistics *statistics)
{
    const uint32_t operations = call_operations(&f->config);
    const bool waits = statistics->behind > 1 && operations > 0 && operations <= SMALLEST_BUDGET;
    return f->config.mode == VBSS_SCENE_MODE_OFFLINE ? 1 : waits ? 6 : 3;
}

static void check_witness(fuzz_scene *f, bool is_clear)
{
    body_motion motion;
    vbss_scene_statistics statistics;
    fuzz_witness *w = &f->witness;
    if (w->number == 0 || !find_motion(f, w->number, &motion)) {
        return;
    }
    (void)vbss_scene_get_statistics(f->sides[0].scene, &statistics, sizeof statistics);
    const bool is_alone = is_clear && w->was_clear && has_had_room(f, &statistics);
    const bool has_moved = vec3_distance(motion.position, w->position) > 0.0;
    w->stationary_steps = has_moved || !is_alone ? 0 : w->stationary_steps + 1;
    w->position = motion.position;
    w->was_clear = is_clear;
    if (w->stationary_steps > stationary_limit(f, &statistics)) {
        fuzz_fail(f, FUZZ_CHECK_IS_STALLED, "%s, for %u steps, step_budget %u, call_budget %u",
                  f->config.mode == VBSS_SCENE_MODE_OFFLINE ? "offline" : "real time",
                  w->stationary_steps, step_operations(&f->config), call_operations(&f->config));
    }
}

void fuzz_check_after_step(fuzz_scene *f)
{
    bool is_clear = true;
    /* Shears make pieces of threads, which no table knows. */
    for (uint32_t i = 1; i < f->last_number + 4; i++) {
        body_motion motion;
        if (!find_motion(f, i, &motion)) {
            continue;
        }
        if (!motion.is_finite) {
            fuzz_fail(f, FUZZ_CHECK_NOT_FINITE, "body %u", i);
        }
        is_clear =
            is_clear && (i == f->witness.number || motion.top + 0.1 * motion.speed < CEILING);
    }
    check_witness(f, is_clear);
}
