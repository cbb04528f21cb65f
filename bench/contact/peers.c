/* The overhand knot on uniform meshes, by ours and by peers: both ends led apart at 25 mm/s until they pull
 * with 2 N, held for a quarter of a second, and a look at what became of the knot. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "collision/closest.h"
#include "contact/bench_contact.h"
#include "contact/peer.h"
#include "contact/pulled_knot.h"

#define SPEED 0.025
#define LOAD_N 2.0
#define STEP_S 1e-3
#define LENGTH 0.15
#define DIAMETER 0.25e-3
enum { MESHES = 3, PEERS = 3, MAX_NODES = 256, MAX_STEPS = 1500, HELD_STEPS = 250 };
static const uint32_t meshes[MESHES] = {61, 121, 241};
/* Of the loose knot, m: on coarse polygons a smaller one would be no knot. */
static const double sizes[MESHES] = {2.5e-3, 1.5e-3, 1e-3};
/* Steps in a row with the load: one alone may be a spike. */
enum { LOADED_STEPS = 3 };

static const contact_peer_scene thread = {DIAMETER, 6.4e-5, 1e-8, 4000.0, 0.3, LOAD_N};

typedef struct peer_knot {
    char name[80];
    const contact_peer *peer;
    uint32_t mesh;
    vec3 start[MAX_NODES], now[MAX_NODES];
    void *body;
    vec3 ends[2];
    uint32_t step_count, loaded, load_step; /* load_step: 0 while the load is not reached */
    double tension;
} peer_knot;

static peer_knot knots[PEERS][MESHES];
static pulled_knot ours[MESHES];

static void shape_of(uint32_t mesh, knot_shape *shape)
{
    knot_shape_init(shape, KNOT_OVERHAND);
    shape->length = LENGTH;
    shape->size = sizes[mesh];
    shape->finest = shape->coarsest = LENGTH / (meshes[mesh] - 1);
    shape->rest = KNOT_REST_CHORDS;
}

static void end_peer(void *user)
{
    peer_knot *k = user;
    if (k->body != NULL) {
        k->peer->destroy(k->body);
        k->body = NULL;
    }
}

static int begin_peer(void *user)
{
    peer_knot *k = user;
    end_peer(k);
    k->ends[0] = k->start[0];
    k->ends[1] = k->start[meshes[k->mesh] - 1];
    k->load_step = k->loaded = k->step_count = 0;
    k->tension = 0.0;
    k->body =
        k->peer->create(&thread, meshes[k->mesh], &k->start[0].x, k->peer->best_step[k->mesh]);
    return k->body != NULL ? 0 : 1;
}

static int step_peer(void *user, uint32_t index)
{
    peer_knot *k = user;
    double a[3], b[3];
    (void)index;
    if (k->tension < LOAD_N && k->load_step == 0) {
        k->ends[0].x -= SPEED * STEP_S;
        k->ends[1].x += SPEED * STEP_S;
    }
    vec3_store(a, k->ends[0]);
    vec3_store(b, k->ends[1]);
    int status = k->peer->step(k->body, a, b, STEP_S);
    k->step_count++;
    k->tension = k->peer->tension(k->body);
    k->loaded = k->tension >= LOAD_N ? k->loaded + 1 : 0;
    if (k->load_step == 0 && k->loaded == LOADED_STEPS) {
        k->load_step = k->step_count;
    }
    return status;
}

/* How many steps it takes is found by making them once. */
static int set_up_peer(void *user)
{
    peer_knot *k = user;
    double rest[MAX_NODES];
    knot_shape shape;
    knot_line line;
    shape_of(k->mesh, &shape);
    if (knot_make(&shape, MAX_NODES, k->start, rest, &line) != VBSS_OK || begin_peer(k) != 0) {
        return 1;
    }
    while (k->step_count < MAX_STEPS &&
           (k->load_step == 0 || k->step_count < k->load_step + HELD_STEPS)) {
        if (step_peer(k, 0) != 0) {
            break;
        }
    }
    return 0;
}

static uint32_t count_peer(void *user)
{
    const peer_knot *k = user;
    return k->step_count;
}

static void finish_peer(void *user, bench_result *result)
{
    peer_knot *k = user;
    uint32_t n = meshes[k->mesh];
    knot_type found, right = knot_type_of_kind(KNOT_OVERHAND, false);
    double length = 0.0, stretch = 0.0;
    (void)k->peer->read(k->body, &k->now[0].x);
    for (uint32_t i = 0; i + 1 < n; i++) {
        double rest = vec3_distance(k->start[i], k->start[i + 1]);
        stretch = vbss_max(vec3_distance(k->now[i], k->now[i + 1]) / rest - 1.0, stretch);
        length += rest;
    }
    bool kept = knot_type_of(k->now, n, &found) && knot_type_same(found, right);
    double smallest = pulled_knot_min_distance(k->now, n, NULL, length / (n - 1), 1.6 * DIAMETER);
    bench_simulated_step(result, 1e6 * STEP_S);
    bench_counter(result, "penetration_um", 1e6 * vbss_max(DIAMETER - smallest, 0.0));
    bench_counter(result, "stretch_max", stretch);
    bench_counter(result, "topology_kept", kept ? 1.0 : 0.0);
    bench_counter(result, "force_N", k->tension);
    bench_counter(result, "taken_up_mm", 1e3 * (length - vec3_distance(k->now[0], k->now[n - 1])));
    bench_counter(result, "loaded", k->load_step != 0 ? 1.0 : 0.0);
}

/* `fast`: meshes, from the coarsest on, that take less than some seconds a repetition. */
static void add_peer(bench *b, size_t which, const contact_peer *peer, uint32_t fast)
{
    for (uint32_t mesh = 0; mesh < MESHES; mesh++) {
        peer_knot *k = &knots[which][mesh];
        k->peer = peer;
        k->mesh = mesh;
        snprintf(k->name, sizeof k->name, "contact/overhand-uniform/%s/%u", peer->name,
                 (unsigned)meshes[mesh]);
        if (mesh >= (bench_is_quick(b) ? 1 : fast)) {
            bench_add_skipped(b, k->name, "too slow to be repeated");
            continue;
        }
        bench_add_stepped(b, &(bench_stepped){.name = k->name,
                                              .user = k,
                                              .dt_us = 1e6 * STEP_S,
                                              .setup = set_up_peer,
                                              .count = count_peer,
                                              .restore = begin_peer,
                                              .step = step_peer,
                                              .finish = finish_peer,
                                              .teardown = end_peer});
    }
}

void add_peer_cases(bench *b)
{
    for (uint32_t mesh = 0; mesh < MESHES; mesh++) {
        pulled_knot *k = &ours[mesh];
        pulled_knot_init(k, KNOT_OVERHAND, VBSS_METHOD_IMPLICIT);
        k->hold_steps = HELD_STEPS; /* as peers */
        shape_of(mesh, &k->options.knot);
        k->options.knot.rest = KNOT_REST_ARCS;
        snprintf(k->name, sizeof k->name, "contact/overhand-uniform/ours/%u",
                 (unsigned)meshes[mesh]);
        pulled_knot_add(b, k);
    }
#if defined(BENCH_HAVE_BULLET)
    add_peer(b, 0, &contact_bullet_multibody, 1);
    add_peer(b, 1, &contact_bullet_softbody, MESHES);
#else
    bench_add_skipped(b, "contact/overhand-uniform/bullet", "Bullet is not installed");
#endif
#if defined(BENCH_HAVE_MUJOCO)
    add_peer(b, 2, &contact_mujoco, 1);
#else
    bench_add_skipped(b, "contact/overhand-uniform/mujoco", "MuJoCo is not installed");
#endif
#if !defined(BENCH_HAVE_BULLET) && !defined(BENCH_HAVE_MUJOCO)
    (void)add_peer;
#endif
}
