/* A host of a whole scene in C: two hands at 1 kHz with forces, meshes at 60 Hz in another thread, events, a cut, a snapshot
 * and a log. scene_host.cpp does the same in C++. Exit code 1: a restored or replayed state differs. */
#include <locale.h>
#include <math.h>
#include <pthread.h>
#include <stdatomic.h>
#include <stdbool.h>
#include <stdio.h>
#include <string.h>
#include <time.h>

#include <vblast_ss/vblast_ss.h>

#define TRY(call)                     \
    do {                              \
        vbss_result result_ = (call); \
        if (result_ != VBSS_OK) {     \
            return result_;           \
        }                             \
    } while (0)

#define HALF 0.707106781186 /* of the square root of 2 */
enum { STEPS = 1000, LOG_BYTES = 1 << 24, SNAPSHOT_BYTES = 1 << 20 };

typedef struct hand {
    double z, largest_force;
} hand;

typedef struct host {
    vbss_context *context;
    hand hands[2];
    vbss_device *devices[2];
    vbss_scene *scene;
    vbss_grasper *tools[2];
    vbss_replica *replica;
    vbss_record *record;
    uint32_t thread_body;
    uint8_t log[LOG_BYTES], snapshot[SNAPSHOT_BYTES];
    uint64_t log_size, snapshot_size, snapshot_hash;
    int late;
    atomic_bool has_ended;
    vbss_result result;
} host;

static double seconds(void *user)
{
    struct timespec t;
    (void)user;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

/* Sleeps until a time of seconds(); returns at once if it has passed. */
static void sleep_until(double time)
{
    const struct timespec t = {(time_t)time, (long)(1e9 * (time - floor(time)))};
    clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &t, NULL);
}

static void print_message(void *user, vbss_log_level level, const char *text)
{
    (void)user, (void)level;
    puts(text);
}

static vbss_result create_context(vbss_context **context)
{
    vbss_context_config config = vbss_context_config_default();
    config.log = print_message;
    config.log_level = VBSS_LOG_WARNING;
    return vbss_context_create(&config, context);
}

/* ---- a hand, which stands in for a haptic arm: it moves along a path, and keeps the largest force */

static vbss_result read_hand(void *user, double now, vbss_device_sample *sample)
{
    const double position[3] = {0.01 * sin(2.0 * now), 0.02 + 0.01 * (1.0 - cos(2.0 * now)),
                                ((hand *)user)->z};
    const double down[4] = {HALF, -HALF, 0.0, 0.0};
    memcpy(sample->position, position, sizeof position);
    memcpy(sample->orientation, down, sizeof down);
    sample->jaw = now > 0.4 && now < 0.6 ? 1.0 : 0.0;
    sample->valid = VBSS_DEVICE_HAS_POSITION | VBSS_DEVICE_HAS_ORIENTATION | VBSS_DEVICE_HAS_JAW;
    sample->time = now;
    return VBSS_OK;
}

static vbss_result write_hand(void *user, double now, const vbss_output_result *output)
{
    const double *f = output->force;
    hand *h = user;
    (void)now;
    h->largest_force = fmax(h->largest_force, sqrt(f[0] * f[0] + f[1] * f[1] + f[2] * f[2]));
    return VBSS_OK;
}

static vbss_result move_tool(host *h, int i, double now)
{
    vbss_device_input input;
    TRY(vbss_device_read(h->devices[i], now, &input, sizeof input));
    TRY(vbss_grasper_set_target(h->tools[i], input.position, input.orientation));
    return vbss_grasper_set_opening(h->tools[i], input.jaw);
}

/* ---- the scene */

static vbss_result add_drain(host *h)
{
    vbss_drain *drain;
    uint32_t body;
    vbss_drain_config config = vbss_drain_config_default();
    config.position[1] = config.radius + config.thickness / 2; /* on the floor */
    config.position[2] = -0.06;
    TRY(vbss_drain_create(h->context, &config, &drain));
    return vbss_scene_add_drain(h->scene, drain, &body);
}

/* A thread swaged to a needle. */
static vbss_result add_suture(host *h)
{
    vbss_needle *needle;
    vbss_needle_state pose;
    vbss_thread *thread;
    uint32_t needle_body, pin;
    vbss_needle_config curved = vbss_needle_config_default();
    curved.position[0] = curved.radius;
    curved.position[1] = 0.03;
    curved.gravity[1] = -9.81;
    curved.orientation[0] = curved.orientation[1] = HALF;
    TRY(vbss_needle_create(h->context, &curved, &needle));
    TRY(vbss_scene_add_needle(h->scene, needle, &needle_body));
    TRY(vbss_needle_get_state(needle, &pose, sizeof pose));
    vbss_thread_config silk = vbss_thread_config_default();
    silk.cut_capacity = 1;
    memcpy(silk.start, pose.swage, sizeof silk.start);
    memcpy(silk.direction, pose.swage_direction, sizeof silk.direction);
    TRY(vbss_thread_create(h->context, &silk, &thread));
    TRY(vbss_scene_add_thread(h->scene, thread, &h->thread_body));
    return vbss_scene_pin_thread(h->scene, h->thread_body, 0, needle_body, NULL, &pin);
}

static vbss_result add_tool(host *h, int i)
{
    uint32_t body;
    vbss_device_adapter adapter = vbss_device_adapter_default();
    h->hands[i].z = 0.02 + 0.04 * i;
    adapter.user = &h->hands[i];
    adapter.read = read_hand;
    adapter.write = write_hand;
    TRY(vbss_device_create(h->context, &adapter, NULL, NULL, &h->devices[i]));
    TRY(vbss_grasper_create(h->context, NULL, &h->tools[i]));
    TRY(move_tool(h, i, 0.0));
    return vbss_scene_add_grasper(h->scene, h->tools[i], &body);
}

static vbss_result create_scene(host *h)
{
    vbss_core_speed speed;
    vbss_solver_options solver = vbss_solver_options_default();
    vbss_scene_config config = vbss_scene_config_default();
    TRY(create_context(&h->context));
    TRY(vbss_core_speed_measure(h->context, seconds, NULL, &speed, sizeof speed));
    solver.operations_per_us = speed.operations_per_us;
    config.solver = &solver;
    config.floor = 1;
    TRY(vbss_scene_create(h->context, &config, &h->scene));
    TRY(add_drain(h));
    TRY(add_suture(h));
    TRY(add_tool(h, 0));
    TRY(add_tool(h, 1));
    TRY(vbss_scene_prepare(h->scene));
    TRY(vbss_replica_create(h->scene, NULL, &h->replica));
    TRY(vbss_record_create(h->scene, NULL, &h->record));
    return vbss_scene_set_recorder(h->scene, h->record);
}

/* ---- the haptic thread */

/* A host with a file writes the bytes instead. */
static vbss_result take_log(host *h)
{
    const uint8_t *bytes;
    uint64_t count;
    TRY(vbss_record_take(h->record, &bytes, &count));
    if (count > LOG_BYTES - h->log_size) {
        return VBSS_ERROR_CAPACITY;
    }
    memcpy(h->log + h->log_size, bytes, count);
    h->log_size += count;
    return VBSS_OK;
}

static vbss_result cut(host *h)
{
    uint32_t piece;
    TRY(vbss_scene_cut_thread(h->scene, h->thread_body, 0.04, &piece));
    TRY(vbss_scene_save(h->scene, h->snapshot, SNAPSHOT_BYTES, &h->snapshot_size));
    return vbss_scene_get_hash(h->scene, &h->snapshot_hash);
}

static vbss_result run_slot(host *h, double now)
{
    vbss_scene_event events[64];
    uint32_t count;
    TRY(move_tool(h, 0, now));
    TRY(move_tool(h, 1, now));
    TRY(vbss_scene_step(h->scene, 1e-3));
    for (int i = 0; i < 2; i++) {
        vbss_grasper_state tool;
        vbss_output_command command = vbss_output_command_default();
        TRY(vbss_grasper_get_state(h->tools[i], &tool, sizeof tool));
        memcpy(command.force, tool.hand_force, sizeof command.force);
        TRY(vbss_device_write(h->devices[i], now, &command, NULL, 0));
    }
    TRY(vbss_replica_publish(h->replica, h->scene));
    TRY(vbss_scene_take_events(h->scene, events, sizeof *events, 64, &count, NULL));
    for (uint32_t i = 0; i < count; i++) {
        printf("%.3f s: event %d of body %u\n", events[i].time, events[i].kind, events[i].body_a);
    }
    return take_log(h);
}

static void *run_haptic(void *user)
{
    host *h = user;
    const double begin = seconds(NULL);
    double slot = begin;
    for (int step = 0; step < STEPS && h->result == VBSS_OK; step++) {
        sleep_until(slot);
        h->result = run_slot(h, seconds(NULL) - begin);
        h->late += seconds(NULL) > slot + 1e-3;
        slot = fmax(slot + 1e-3, seconds(NULL)); /* a late thread does not catch up */
        if (step == STEPS / 2 && h->result == VBSS_OK) {
            h->result = cut(h);
        }
    }
    atomic_store(&h->has_ended, true);
    return NULL;
}

/* ---- the renderer, in a context of its own, until the haptic thread ends */

static vbss_result draw(host *h, vbss_context *context)
{
    vbss_visual *visual;
    TRY(vbss_visual_create(context, NULL, &visual));
    TRY(vbss_visual_add_replica(visual, h->replica, NULL));
    double frame = seconds(NULL);
    while (!atomic_load(&h->has_ended)) {
        vbss_replica_state state;
        vbss_view vertices;
        sleep_until(frame += 1.0 / 60.0);
        TRY(vbss_replica_take(h->replica, &state, sizeof state));
        if (state.is_new != 0) {
            TRY(vbss_visual_update(visual));
            TRY(vbss_visual_get_view(visual, VBSS_VISUAL_VIEW_VERTICES, &vertices,
                                     sizeof vertices));
        }
    }
    return VBSS_OK;
}

/* ---- after the run */

static vbss_result replay(host *h, vbss_context *context, uint64_t *hash)
{
    vbss_replay *replay;
    vbss_replay_report report;
    vbss_scene *scene;
    TRY(vbss_replay_create(context, h->log, h->log_size, &replay));
    TRY(vbss_replay_load_scene(replay, &scene));
    do {
        TRY(vbss_replay_step(replay, &report, sizeof report));
    } while (report.outcome == VBSS_REPLAY_OUTCOME_STEPPED);
    return vbss_scene_get_hash(scene, hash);
}

/* Whether a restored and a replayed scene have the hashes of the run. */
static vbss_result compare(host *h, vbss_context *context, bool *are_equal)
{
    uint64_t last, restored, replayed;
    TRY(vbss_scene_get_hash(h->scene, &last));
    TRY(vbss_record_end(h->record));
    TRY(take_log(h));
    TRY(vbss_scene_restore(h->scene, h->snapshot, h->snapshot_size));
    TRY(vbss_scene_get_hash(h->scene, &restored));
    TRY(replay(h, context, &replayed));
    *are_equal = restored == h->snapshot_hash && replayed == last;
    return VBSS_OK;
}

static vbss_result run(host *h, vbss_context *context, bool *are_equal)
{
    pthread_t haptic;
    TRY(create_scene(h));
    if (pthread_create(&haptic, NULL, run_haptic, h) != 0) {
        return VBSS_ERROR_OUT_OF_MEMORY;
    }
    const vbss_result drawn = draw(h, context);
    pthread_join(haptic, NULL);
    TRY(h->result);
    TRY(drawn);
    return compare(h, context, are_equal);
}

int main(void)
{
    static host h;
    vbss_context *context = NULL; /* of the renderer, and then of the replay */
    bool are_equal = false;
    (void)setlocale(LC_NUMERIC, "C"); /* numbers with a decimal point */
    const vbss_result created = create_context(&context);
    const vbss_result result = created == VBSS_OK ? run(&h, context, &are_equal) : created;
    printf("%d of %d slots late, largest force %.3f N, %s, hashes %s\n", h.late, STEPS,
           fmax(h.hands[0].largest_force, h.hands[1].largest_force), vbss_result_string(result),
           are_equal ? "equal" : "different");
    vbss_context_destroy(context);
    vbss_context_destroy(h.context);
    return are_equal ? 0 : 1;
}
