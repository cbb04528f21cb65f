/* Cases needle/flight/<method>: what free flight costs beside what it gets wrong. A step moves 64 needles by 1 ms, each thrown with a
 * spin of its own of 20 to 30 rad/s; after 200 steps:
 *   angle_error_rad  largest turn from where Runge and Kutta's method in steps of 5 us has the needle
 *   energy_error     largest relative change of the energy of turning
 * Beside ours, rotation alone by explicit Euler and by Runge and Kutta's method in the same steps, in the body's own axes,
 * with the same translation. */
#include <math.h>

#include "base/error.h"
#include "base/hash.h"
#include "base/random.h"
#include "base/rotation.h"
#include "base/stream.h"
#include "needle/bench_needle.h"
#include "needle/needle.h"

enum { NEEDLES = 64, STEPS = 200, FINE = 200 };
#define STEP_S 1e-3

typedef enum method { OURS, EXPLICIT_EULER, RUNGE_KUTTA, METHODS } method;

/* What peers move. */
typedef struct turning {
    quat q;
    vec3 w; /* in the body's own axes */
} turning;

/* One case runs at a time. */
static vbss_context *context;
static vbss_needle *needles[NEEDLES];
static vbss_rigid begun[NEEDLES];
static turning turnings[NEEDLES];
static vec3 positions[NEEDLES], velocities[NEEDLES];
static const method methods[METHODS] = {OURS, EXPLICIT_EULER, RUNGE_KUTTA};

/* ---- Euler's equations */

static vec3 times(vec3 a, vec3 b)
{
    return vec3_make(a.x * b.x, a.y * b.y, a.z * b.z);
}

static vec3 acceleration(vec3 inertia, vec3 w)
{
    vec3 torque = vec3_cross(times(inertia, w), w);
    return vec3_make(torque.x / inertia.x, torque.y / inertia.y, torque.z / inertia.z);
}

static void step_explicit_euler(vec3 inertia, double h, turning *t)
{
    vec3 rate = acceleration(inertia, t->w);
    t->q = vbss_quat_integrate(t->q, quat_rotate(t->q, t->w), h);
    t->w = vec3_add_scaled(t->w, h, rate);
}

static turning slope(vec3 inertia, const turning *t)
{
    quat rate = quat_mul(t->q, quat_make(0.0, 0.5 * t->w.x, 0.5 * t->w.y, 0.5 * t->w.z));
    turning s = {rate, acceleration(inertia, t->w)};
    return s;
}

static turning along(const turning *t, double h, const turning *s)
{
    quat q = quat_make(t->q.w + h * s->q.w, t->q.x + h * s->q.x, t->q.y + h * s->q.y,
                       t->q.z + h * s->q.z);
    turning moved = {q, vec3_add_scaled(t->w, h, s->w)};
    return moved;
}

static void step_runge_kutta(vec3 inertia, double h, turning *t)
{
    turning k1 = slope(inertia, t), at = along(t, 0.5 * h, &k1);
    turning k2 = slope(inertia, &at);
    at = along(t, 0.5 * h, &k2);
    turning k3 = slope(inertia, &at);
    at = along(t, h, &k3);
    turning k4 = slope(inertia, &at);
    at = along(t, h / 6.0, &k1);
    at = along(&at, h / 3.0, &k2);
    at = along(&at, h / 3.0, &k3);
    *t = along(&at, h / 6.0, &k4);
    t->q = quat_unit(t->q);
}

static turning begun_turning(const vbss_rigid *body)
{
    quat q = body->now.pose.orientation;
    turning t = {q, quat_rotate_back(q, body->now.w)};
    return t;
}

/* ---- the flight */

static void end_flight(void *user)
{
    (void)user;
    (void)vbss_context_destroy(context);
    context = NULL;
}

static vbss_result throw_needle(vbss_random *random, uint32_t i)
{
    vbss_needle_config config;
    needle_object *n;
    VBSS_TRY(vbss_needle_config_init(&config, sizeof config));
    vec3 v = vbss_random_direction(random), axis = vbss_random_direction(random);
    double spin = 20.0 + 10.0 * vbss_random_uniform(random);
    vec3_store(config.velocity, v);
    vec3_store(config.angular_velocity, vec3_scale(axis, spin));
    VBSS_TRY(vbss_needle_create(context, &config, &needles[i]));
    VBSS_TRY(vbss_needle_open(needles[i], &n));
    begun[i] = n->body;
    turnings[i] = begun_turning(&n->body);
    positions[i] = n->body.now.pose.position;
    velocities[i] = n->body.now.v;
    return VBSS_OK;
}

static int begin_flight(void *user)
{
    vbss_random random;
    end_flight(user);
    vbss_random_seed(&random, 8, 1);
    vbss_result result = vbss_context_create(NULL, &context);
    for (uint32_t i = 0; i < NEEDLES && result == VBSS_OK; i++) {
        result = throw_needle(&random, i);
    }
    return (int)result;
}

static int step_flight(void *user, uint32_t index)
{
    method by = *(const method *)user;
    (void)index;
    for (uint32_t i = 0; i < NEEDLES; i++) {
        if (by == OURS) {
            vbss_result result = vbss_needle_step(needles[i], STEP_S);
            if (result != VBSS_OK) {
                return (int)result;
            }
            continue;
        }
        if (by == EXPLICIT_EULER) {
            step_explicit_euler(begun[i].inertia, STEP_S, &turnings[i]);
        } else {
            step_runge_kutta(begun[i].inertia, STEP_S, &turnings[i]);
        }
        positions[i] = vec3_add_scaled(positions[i], STEP_S, velocities[i]);
    }
    return 0;
}

/* Ours, among the peers' numbers. */
static void show_ours(const void *user)
{
    for (uint32_t i = 0; *(const method *)user == OURS && i < NEEDLES; i++) {
        needle_object *n = NULL;
        if (vbss_needle_open(needles[i], &n) == VBSS_OK) {
            turnings[i] = begun_turning(&n->body);
            positions[i] = n->body.now.pose.position;
        }
    }
}

static uint64_t hash_flight(void *user)
{
    vbss_stream stream;
    show_ours(user);
    vbss_stream_begin_hash(&stream);
    for (uint32_t i = 0; i < NEEDLES; i++) {
        vbss_stream_f64(&stream, 1, &turnings[i].q.w, 4);
        vbss_stream_f64(&stream, 2, &turnings[i].w.x, 3);
        vbss_stream_f64(&stream, 3, &positions[i].x, 3);
    }
    return vbss_hash_end(&stream.hash);
}

static double energy_of(vec3 inertia, vec3 w)
{
    return 0.5 * vec3_dot(times(inertia, w), w);
}

static void check_flight(void *user, bench_result *result)
{
    double angle = 0.0, change = 0.0;
    show_ours(user);
    for (uint32_t i = 0; i < NEEDLES; i++) {
        vec3 inertia = begun[i].inertia;
        turning exact = begun_turning(&begun[i]);
        double before = energy_of(inertia, exact.w), after = energy_of(inertia, turnings[i].w);
        for (uint32_t k = 0; k < FINE * STEPS; k++) {
            step_runge_kutta(inertia, STEP_S / FINE, &exact);
        }
        quat apart = quat_mul(turnings[i].q, quat_conjugate(exact.q));
        vec3 turn = vbss_quat_to_rotation_vector(apart);
        angle = vbss_max(vec3_norm(turn), angle);
        change = vbss_max(fabs(after / before - 1.0), change);
    }
    bench_counter(result, "angle_error_rad", angle);
    bench_counter(result, "energy_error", change);
}

void add_flights(bench *b)
{
    static const char *const names[METHODS] = {[OURS] = "needle/flight/ours",
                                               [EXPLICIT_EULER] = "needle/flight/explicit-euler",
                                               [RUNGE_KUTTA] = "needle/flight/runge-kutta"};
    for (int m = 0; m < METHODS; m++) {
        const bench_stepped stepped = {.name = names[m],
                                       .user = (void *)&methods[m],
                                       .steps = STEPS,
                                       .dt_us = STEP_S * 1e6,
                                       .deadline_us = 1000.0,
                                       .restore = begin_flight,
                                       .step = step_flight,
                                       .hash = hash_flight,
                                       .finish = check_flight,
                                       .teardown = end_flight};
        bench_add_stepped(b, &stepped);
    }
}
