/* Kernels that every step pays for: hashing and streaming a state (per byte), turning bodies
 * (per body). */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/hash.h"
#include "base/linear.h"
#include "base/random.h"
#include "base/rotation.h"
#include "base/stream.h"
#include "bench_base.h"

/* Methods of one scene: a name and what is run, all else shared. */
typedef struct kernel {
    const char *name;
    void (*run)(void *user);
} kernel;

static void add_kernels(bench *b, const kernel *rows, size_t count, const bench_batch *shared)
{
    for (size_t i = 0; i < count; i++) {
        bench_batch batch = *shared;
        batch.name = rows[i].name;
        batch.run = rows[i].run;
        bench_add_batch(b, &batch);
    }
}

/* ---- hash: a counter, one body, a whole scene */

enum { HASH_SIZES = 3, MAX_HASH_BYTES = 65536 };
static const uint32_t hash_sizes[HASH_SIZES] = {64, 4096, MAX_HASH_BYTES};
static uint8_t bytes[MAX_HASH_BYTES];
static uint64_t hash_value;

static int fill_bytes(void *user)
{
    (void)user;
    vbss_random random;
    vbss_random_seed(&random, 3, 1);
    for (size_t i = 0; i < sizeof bytes; i++) {
        bytes[i] = (uint8_t)vbss_random_u32(&random);
    }
    return 0;
}

static void run_hash(void *user)
{
    vbss_hash hash;
    vbss_hash_begin(&hash);
    vbss_hash_add(&hash, bytes, *(const uint32_t *)user);
    hash_value = vbss_hash_end(&hash);
    bench_keep_u64(hash_value);
}

/* The hash that many engines use for their state: bytewise FNV-1a. */
static void run_fnv1a(void *user)
{
    uint64_t hash = 0xcbf29ce484222325u;
    for (uint32_t i = 0; i < *(const uint32_t *)user; i++) {
        hash = (hash ^ bytes[i]) * 0x100000001b3u;
    }
    bench_keep_u64(hash);
}

static void add_hash_cases(bench *b)
{
    static char names[HASH_SIZES][2][32];
    static uint32_t sizes[HASH_SIZES];
    for (size_t i = 0; i < HASH_SIZES; i++) {
        sizes[i] = hash_sizes[i];
        for (int peer = 0; peer <= 1; peer++) {
            char *name = names[i][peer];
            snprintf(name, sizeof names[i][peer], "base/hash/%s/%u", peer ? "fnv1a" : "ours",
                     (unsigned)sizes[i]);
            const bench_batch batch = {.name = name,
                                       .user = &sizes[i],
                                       .items = sizes[i],
                                       .setup = fill_bytes,
                                       .run = peer ? run_fnv1a : run_hash};
            bench_add_batch(b, &batch);
        }
    }
}

/* ---- stream: positions and velocities of a thread of 240 nodes */

enum { STATE_VALUES = 240 * 6, STATE_BYTES = STATE_VALUES * 8, STREAM_CAPACITY = 2 * STATE_BYTES };
static double state[STATE_VALUES];
static uint8_t stream_bytes[STREAM_CAPACITY];
static size_t stream_size;

static void visit_state(vbss_stream *stream)
{
    vbss_section outer = vbss_stream_open(stream, VBSS_CODE('B', 'N', 'C', 'H'), 1);
    vbss_stream_f64(stream, 1, state, STATE_VALUES / 2);
    vbss_stream_f64(stream, 2, state + STATE_VALUES / 2, STATE_VALUES / 2);
    vbss_stream_close(stream, outer);
}

static void run_stream_write(void *user)
{
    vbss_stream stream;
    (void)user;
    vbss_stream_begin_write(&stream, stream_bytes, sizeof stream_bytes);
    visit_state(&stream);
    stream_size = stream.position;
    bench_keep_memory(stream_bytes);
}

static void run_stream_read(void *user)
{
    vbss_stream stream;
    (void)user;
    vbss_stream_begin_read(&stream, stream_bytes, stream_size);
    visit_state(&stream);
    bench_keep_memory(state);
}

static void run_stream_hash(void *user)
{
    vbss_stream stream;
    (void)user;
    vbss_stream_begin_hash(&stream);
    visit_state(&stream);
    bench_keep_u64(vbss_hash_end(&stream.hash));
}

/* What a host would do that does not care about other machines. */
static void run_memcpy(void *user)
{
    (void)user;
    memcpy(stream_bytes, state, sizeof state);
    bench_keep_memory(stream_bytes);
}

static int fill_state(void *user)
{
    vbss_random random;
    vbss_random_seed(&random, 4, 1);
    for (size_t i = 0; i < STATE_VALUES; i++) {
        state[i] = vbss_random_normal(&random);
    }
    run_stream_write(user);
    return 0;
}

static void check_stream(void *user, bench_result *result)
{
    vbss_stream stream;
    double written = state[STATE_VALUES - 1];
    fill_state(user);
    state[STATE_VALUES - 1] = 0.0;
    vbss_stream_begin_read(&stream, stream_bytes, stream_size);
    visit_state(&stream);
    // NOLINTNEXTLINE(bugprone-suspicious-memory-comparison): equal to the bit is what is meant
    if (stream.result != VBSS_OK || memcmp(&written, &state[STATE_VALUES - 1], 8) != 0) {
        bench_fail(result, "the state read is not the state written");
    }
    bench_counter(result, "stream_bytes", (double)stream_size);
}

static void add_stream_cases(bench *b)
{
    static const kernel rows[] = {
        {"base/stream-write/ours", run_stream_write},
        {"base/stream-write/memcpy", run_memcpy},
        {"base/stream-read/ours", run_stream_read},
        {"base/stream-hash/ours", run_stream_hash},
    };
    const bench_batch shared = {.items = STATE_BYTES, .setup = fill_state, .finish = check_stream};
    add_kernels(b, rows, sizeof rows / sizeof rows[0], &shared);
}

/* ---- quaternions: one step of 1 ms at up to 30 rad/s, against the exact turn in long double */

enum { BODIES = 1024 };
#define STEP_S 1e-3
static quat orientations[BODIES], turned[BODIES];
static vec3 omegas[BODIES];

static int fill_orientations(void *user)
{
    (void)user;
    vbss_random random;
    vbss_random_seed(&random, 5, 1);
    for (size_t i = 0; i < BODIES; i++) {
        vec3 axis = vbss_random_direction(&random);
        vec3 turn = vec3_scale(axis, 3.0 * vbss_random_uniform(&random));
        orientations[i] = vbss_quat_from_rotation_vector(turn);
        vec3 spin = vbss_random_direction(&random);
        omegas[i] = vec3_scale(spin, 30.0 * vbss_random_uniform(&random));
    }
    return 0;
}

static void run_integrate(void *user)
{
    (void)user;
    for (size_t i = 0; i < BODIES; i++) {
        turned[i] = vbss_quat_integrate(orientations[i], omegas[i], STEP_S);
    }
    bench_keep_memory(turned);
}

/* The usual shortcut: q + h/2 omega q, made unit again. First order, so fast. */
static void run_euler(void *user)
{
    (void)user;
    for (size_t i = 0; i < BODIES; i++) {
        quat q = orientations[i];
        vec3 w = vec3_scale(omegas[i], 0.5 * STEP_S);
        quat d = quat_mul(quat_make(0.0, w.x, w.y, w.z), q);
        turned[i] = quat_unit(quat_make(q.w + d.w, q.x + d.x, q.y + d.y, q.z + d.z));
    }
    bench_keep_memory(turned);
}

/* Largest difference of a component between the computed and the exact turn. */
static double turn_error(quat q, quat before, vec3 omega)
{
    long double x = (long double)omega.x, y = (long double)omega.y, z = (long double)omega.z;
    long double rate = sqrtl(x * x + y * y + z * z), half = 0.5L * rate * (long double)STEP_S;
    long double s = rate > 0.0L ? sinl(half) / rate : 0.0L;
    long double t[4] = {cosl(half), s * x, s * y, s * z};
    long double p[4] = {(long double)before.w, (long double)before.x, (long double)before.y,
                        (long double)before.z};
    long double exact[4] = {t[0] * p[0] - t[1] * p[1] - t[2] * p[2] - t[3] * p[3],
                            t[0] * p[1] + t[1] * p[0] + t[2] * p[3] - t[3] * p[2],
                            t[0] * p[2] - t[1] * p[3] + t[2] * p[0] + t[3] * p[1],
                            t[0] * p[3] + t[1] * p[2] - t[2] * p[1] + t[3] * p[0]};
    const double computed[4] = {q.w, q.x, q.y, q.z};
    double largest = 0.0;
    for (size_t i = 0; i < 4; i++) {
        double error = (double)fabsl((long double)computed[i] - exact[i]);
        largest = error > largest ? error : largest;
    }
    return largest;
}

static void check_turns(void *user, bench_result *result)
{
    (void)user;
    double largest = 0.0;
    for (size_t i = 0; i < BODIES; i++) {
        double error = turn_error(turned[i], orientations[i], omegas[i]);
        largest = error > largest ? error : largest;
    }
    bench_counter(result, "component_error", largest);
}

static void add_quaternion_cases(bench *b)
{
    static const kernel rows[] = {
        {"base/quat-integrate/ours", run_integrate},
        {"base/quat-integrate/euler", run_euler},
    };
    const bench_batch shared = {.items = BODIES, .setup = fill_orientations, .finish = check_turns};
    add_kernels(b, rows, sizeof rows / sizeof rows[0], &shared);
}

void add_kernel_cases(bench *b)
{
    add_hash_cases(b);
    add_stream_cases(b);
    add_quaternion_cases(b);
}
