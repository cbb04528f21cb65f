/* Stepped scene: N free bodies that spin and drift. Each step turns and moves every body; the hash
 * after it is the stream's. It exercises the harness as later suites will: a family over N, an
 * error against the exact motion, and the exponent of its growth. */
#include <math.h>
#include <stdio.h>

#include "base/hash.h"
#include "base/linear.h"
#include "base/random.h"
#include "base/rotation.h"
#include "base/stream.h"
#include "bench_base.h"

enum { FAMILY = 4, MAX_BODIES = 4096, STEPS = 1000 };
#define STEP_S 1e-3

typedef struct spinning_bodies {
    char name[48];
    uint32_t count;
} spinning_bodies;

static spinning_bodies family[FAMILY] = {
    {.count = 64}, {.count = 256}, {.count = 1024}, {.count = MAX_BODIES}};

/* One case runs at a time. */
static double positions[3 * MAX_BODIES], orientations[4 * MAX_BODIES];
static vec3 velocities[MAX_BODIES], omegas[MAX_BODIES];

static int place_bodies(void *user)
{
    const spinning_bodies *scene = user;
    vbss_random random;
    vbss_random_seed(&random, 6, 1);
    for (size_t i = 0; i < scene->count; i++) {
        const double upright[4] = {1.0, 0.0, 0.0, 0.0};
        for (size_t k = 0; k < 4; k++) {
            orientations[4 * i + k] = upright[k];
        }
        vec3_store(&positions[3 * i], vec3_zero());
        velocities[i] = vbss_random_direction(&random);
        vec3 axis = vbss_random_direction(&random);
        omegas[i] = vec3_scale(axis, 30.0 * vbss_random_uniform(&random));
    }
    return 0;
}

static int step_bodies(void *user, uint32_t index)
{
    const spinning_bodies *scene = user;
    (void)index;
    for (size_t i = 0; i < scene->count; i++) {
        double *o = &orientations[4 * i], *p = &positions[3 * i];
        quat q = vbss_quat_integrate(quat_make(o[0], o[1], o[2], o[3]), omegas[i], STEP_S);
        o[0] = q.w;
        o[1] = q.x;
        o[2] = q.y;
        o[3] = q.z;
        vec3_store(p, vec3_add_scaled(vec3_load(p), STEP_S, velocities[i]));
    }
    return 0;
}

static uint64_t hash_bodies(void *user)
{
    const spinning_bodies *scene = user;
    vbss_stream stream;
    vbss_stream_begin_hash(&stream);
    vbss_stream_f64(&stream, 1, positions, (size_t)scene->count * 3);
    vbss_stream_f64(&stream, 2, orientations, (size_t)scene->count * 4);
    return vbss_hash_end(&stream.hash);
}

/* At constant angular velocity the exact orientation is one turn about the axis. */
static void check_bodies(void *user, bench_result *result)
{
    const spinning_bodies *scene = user;
    double largest = 0.0;
    for (size_t i = 0; i < scene->count; i++) {
        const double *o = &orientations[4 * i];
        vec3 omega = omegas[i];
        double rate = vec3_norm(omega), half = 0.5 * rate * STEP_S * STEPS;
        double s = rate > 0.0 ? sin(half) / rate : 0.0;
        quat exact = quat_make(cos(half), s * omega.x, s * omega.y, s * omega.z);
        quat apart = quat_mul(quat_make(o[0], o[1], o[2], o[3]), quat_conjugate(exact));
        double angle = 2.0 * vec3_norm(vec3_make(apart.x, apart.y, apart.z));
        largest = angle > largest ? angle : largest;
    }
    bench_counter(result, "angle_error_rad", largest);
}

void add_spinning_bodies_cases(bench *b)
{
    for (size_t i = 0; i < FAMILY; i++) {
        spinning_bodies *scene = &family[i];
        snprintf(scene->name, sizeof scene->name, "base/spinning-bodies/ours/%u",
                 (unsigned)scene->count);
        const bench_stepped stepped = {.name = scene->name,
                                       .user = scene,
                                       .steps = STEPS,
                                       .dt_us = STEP_S * 1e6,
                                       .deadline_us = 1000.0,
                                       .restore = place_bodies,
                                       .step = step_bodies,
                                       .hash = hash_bodies,
                                       .finish = check_bodies};
        bench_add_stepped(b, &stepped);
    }
    const bench_growth growth = {.name = "base/spinning-bodies/ours",
                                 .family = "base/spinning-bodies/ours"};
    bench_add_growth(b, &growth);
}
