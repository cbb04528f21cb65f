/* A haptic thread steps a scene at 1 kHz while a renderer thread makes its meshes at 60 Hz.
 *
 *     threads [steps]      default: 2000 steps, which take 2 s; runs without a renderer and with one
 *
 * The haptic thread owns the scene, its context and the replica. It publishes after each step. The renderer owns a second
 * context with a visual, and takes the newest state once a frame. No locks, and no thread ever waits for the other one.
 * Prints what the slots of the haptic thread take, in processor time, and how many are longer than 1 ms. What is worth
 * copying stands under "the two threads". */
#include <locale.h>
#include <pthread.h>
#include <stdatomic.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include <vblast_ss/vblast_ss.h>

#define STEP 1e-3 /* s */
enum { STEP_NS = 1000000, FRAME_NS = 16666667, MAX_STEPS = 100000, DEFAULT_STEPS = 2000 };

#define TRY(call)                     \
    do {                              \
        vbss_result result_ = (call); \
        if (result_ != VBSS_OK) {     \
            return result_;           \
        }                             \
    } while (0)

/* ---- clocks */

static double seconds(clockid_t clock)
{
    struct timespec t;
    clock_gettime(clock, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

/* Sleeps until the next slot. A late thread does not catch up, because a device wants equal distances. */
static void wait_for_slot(struct timespec *next, long length)
{
    struct timespec now;
    next->tv_nsec += length;
    next->tv_sec += next->tv_nsec / 1000000000;
    next->tv_nsec %= 1000000000;
    clock_gettime(CLOCK_MONOTONIC, &now);
    if (now.tv_sec > next->tv_sec || (now.tv_sec == next->tv_sec && now.tv_nsec > next->tv_nsec)) {
        *next = now;
    }
    clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, next, NULL);
}

/* ---- the scene: a thread across a drain, a needle on the floor, two tools */

typedef struct world {
    vbss_context *context;
    vbss_scene *scene;
    vbss_grasper *tools[2];
    vbss_replica *replica;
    uint32_t body; /* number of the body that was added last */
} world;

static vbss_result add_thread(world *w)
{
    vbss_thread_config c;
    vbss_thread *thread;
    TRY(vbss_thread_config_init(&c, sizeof c));
    c.segment_count = 100;
    c.length = 0.1;
    c.start[0] = -0.05; /* straight along x, above the drain */
    c.start[2] = 0.012;
    c.gravity[1] = 0.0;
    c.gravity[2] = -9.81;
    TRY(vbss_thread_create(w->context, &c, &thread));
    return vbss_scene_add_thread(w->scene, thread, &w->body);
}

static vbss_result add_drain(world *w)
{
    vbss_drain_config c;
    vbss_drain *drain;
    TRY(vbss_drain_config_init(&c, sizeof c));
    TRY(vbss_drain_create(w->context, &c, &drain));
    return vbss_scene_add_drain(w->scene, drain, &w->body);
}

static vbss_result add_needle(world *w)
{
    vbss_needle_config c;
    vbss_needle *needle;
    TRY(vbss_needle_config_init(&c, sizeof c));
    c.position[0] = 0.04;
    c.gravity[2] = -9.81;
    TRY(vbss_needle_create(w->context, &c, &needle));
    return vbss_scene_add_needle(w->scene, needle, &w->body);
}

/* Stands in for two haptic arms: both tips go up and down beside the drain, and the handles open and close. */
static vbss_result move_tools(world *w, int step)
{
    for (int i = 0; i < 2; i++) {
        const int turn = (step + 200 * i) % 400;
        const double share = (turn < 200 ? turn : 400 - turn) / 200.0;
        const double tip[3] = {i == 0 ? -0.02 : 0.02, 0.0, 0.008 + 0.01 * share};
        TRY(vbss_grasper_set_target(w->tools[i], tip, NULL));
        TRY(vbss_grasper_set_opening(w->tools[i], share));
    }
    return VBSS_OK;
}

static vbss_result create_world(world *w)
{
    vbss_scene_config c;
    memset(w, 0, sizeof *w);
    TRY(vbss_context_create(NULL, &w->context));
    TRY(vbss_scene_config_init(&c, sizeof c));
    c.capsule_capacity = 64;
    c.floor = 1;
    c.floor_normal[1] = 0.0;
    c.floor_normal[2] = 1.0;
    c.floor_height = -0.007;
    TRY(vbss_scene_create(w->context, &c, &w->scene));
    TRY(add_thread(w));
    TRY(add_drain(w));
    TRY(add_needle(w));
    for (int i = 0; i < 2; i++) {
        TRY(vbss_grasper_create(w->context, NULL, &w->tools[i]));
    }
    TRY(move_tools(w, 0));
    for (int i = 0; i < 2; i++) {
        TRY(vbss_scene_add_grasper(w->scene, w->tools[i], &w->body));
    }
    return vbss_replica_create(w->scene, NULL, &w->replica);
}

/* ---- the two threads */

typedef struct haptic {
    world world;
    int steps, has_reader;
    atomic_bool has_ended;
    double *step_times, *publish_times; /* processor time, s */
    vbss_result result;
} haptic;

/* One slot of the haptic thread. A real host reads its devices first, and writes forces before it publishes. */
static vbss_result run_slot(haptic *h, int step)
{
    const double begin = seconds(CLOCK_THREAD_CPUTIME_ID);
    TRY(move_tools(&h->world, step));
    TRY(vbss_scene_step(h->world.scene, STEP));
    const double stepped = seconds(CLOCK_THREAD_CPUTIME_ID);
    if (h->has_reader) {
        TRY(vbss_replica_publish(h->world.replica, h->world.scene));
    }
    h->step_times[step] = stepped - begin;
    h->publish_times[step] = seconds(CLOCK_THREAD_CPUTIME_ID) - stepped;
    return VBSS_OK;
}

static void *run_haptic(void *user)
{
    haptic *h = user;
    struct timespec next;
    clock_gettime(CLOCK_MONOTONIC, &next);
    for (int step = 0; step < h->steps && h->result == VBSS_OK; step++) {
        h->result = run_slot(h, step);
        wait_for_slot(&next, STEP_NS);
    }
    atomic_store(&h->has_ended, true);
    return NULL;
}

typedef struct renderer {
    haptic *haptic;
    uint64_t frames, new_frames, missed, last, vertices;
    int is_ordered;
    vbss_result result;
} renderer;

/* One frame. A real host uploads the vertices and draws. */
static vbss_result draw_frame(renderer *r, vbss_visual *visual)
{
    vbss_replica_state state;
    vbss_visual_statistics drawn;
    TRY(vbss_replica_take(r->haptic->world.replica, &state, sizeof state));
    r->frames++;
    if (state.is_new == 0) {
        return VBSS_OK; /* what was drawn before still holds */
    }
    TRY(vbss_visual_update(visual));
    TRY(vbss_visual_get_statistics(visual, &drawn, sizeof drawn));
    r->is_ordered = r->is_ordered && state.number > r->last;
    r->last = state.number;
    r->missed = state.missed;
    r->vertices = drawn.vertices;
    r->new_frames++;
    return VBSS_OK;
}

static vbss_result draw_frames(renderer *r, vbss_context *context)
{
    struct timespec next;
    vbss_visual *visual;
    bool has_ended = false;
    TRY(vbss_visual_create(context, NULL, &visual));
    TRY(vbss_visual_add_replica(visual, r->haptic->world.replica, NULL));
    clock_gettime(CLOCK_MONOTONIC, &next);
    while (!has_ended) {
        has_ended = atomic_load(&r->haptic->has_ended); /* the last state was published before */
        TRY(draw_frame(r, visual));
        wait_for_slot(&next, FRAME_NS);
    }
    return VBSS_OK;
}

/* The renderer has a context of its own, so its calls and those of the haptic thread are independent. */
static void *run_renderer(void *user)
{
    renderer *r = user;
    vbss_context *context;
    r->result = vbss_context_create(NULL, &context);
    if (r->result == VBSS_OK) {
        r->result = draw_frames(r, context);
        vbss_context_destroy(context);
    }
    return NULL;
}

/* ---- both runs */

static int compare(const void *a, const void *b)
{
    const double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

/* Sorts the times. */
static void print_times(const char *name, double *times, int count)
{
    qsort(times, (size_t)count, sizeof *times, compare);
    printf("  %-8s median %6.1f us, 99 %% %6.1f us, largest %7.1f us\n", name,
           1e6 * times[count / 2], 1e6 * times[count * 99 / 100], 1e6 * times[count - 1]);
}

static void report(haptic *h, const renderer *r)
{
    int longer = 0, caused = 0;
    for (int i = 0; i < h->steps; i++) {
        const double slot = h->step_times[i] + h->publish_times[i];
        longer += slot > STEP;
        caused += slot > STEP && h->step_times[i] <= STEP;
    }
    printf("%s a renderer: %d slots, %d of them longer than 1 ms, %d only because of publishing\n",
           h->has_reader ? "with" : "without", h->steps, longer, caused);
    print_times("step", h->step_times, h->steps);
    if (h->has_reader) {
        print_times("publish", h->publish_times, h->steps);
        printf(
            "  renderer: %llu frames, %llu with a new state of %llu vertices, %llu states missed\n",
            (unsigned long long)r->frames, (unsigned long long)r->new_frames,
            (unsigned long long)r->vertices, (unsigned long long)r->missed);
    }
}

/* Returns whether all went well: no error, states in order, and the last one drawn. */
static int run(haptic *h, int has_reader)
{
    pthread_t threads[2];
    renderer r = {.haptic = h, .is_ordered = 1};
    h->has_reader = has_reader;
    h->result = create_world(&h->world);
    atomic_store(&h->has_ended, false);
    int good = h->result == VBSS_OK && pthread_create(&threads[0], NULL, run_haptic, h) == 0;
    if (good) {
        const int reads = has_reader && pthread_create(&threads[1], NULL, run_renderer, &r) == 0;
        pthread_join(threads[0], NULL);
        if (reads) {
            pthread_join(threads[1], NULL);
        }
        good = h->result == VBSS_OK && r.result == VBSS_OK && r.is_ordered && reads == has_reader &&
               r.last == (has_reader ? (uint64_t)h->steps : 0);
        report(h, &r);
    }
    if (!good) {
        const char *text = "";
        (void)vbss_context_get_last_error(h->world.context, NULL, &text);
        fprintf(stderr, "haptic thread: %s (%s), renderer: %s\n", vbss_result_string(h->result),
                text, vbss_result_string(r.result));
    }
    /* The renderer has finished, so the replica may go with its context. */
    return vbss_context_destroy(h->world.context) == VBSS_OK && good;
}

int main(int argc, char **argv)
{
    static haptic h;
    (void)setlocale(LC_NUMERIC, "C"); /* numbers with a decimal point */
    h.steps = argc > 1 ? (int)strtol(argv[1], NULL, 10) : DEFAULT_STEPS;
    if (h.steps < 1 || h.steps > MAX_STEPS) {
        fprintf(stderr, "steps: 1 to %d\n", MAX_STEPS);
        return 2;
    }
    h.step_times = calloc((size_t)h.steps, sizeof *h.step_times);
    h.publish_times = calloc((size_t)h.steps, sizeof *h.publish_times);
    const int good = h.step_times != NULL && h.publish_times != NULL && run(&h, 0) && run(&h, 1);
    free(h.step_times);
    free(h.publish_times);
    return good ? 0 : 1;
}
