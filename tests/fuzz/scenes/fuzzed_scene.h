/* A random scene under random calls, and its twin.
 *
 * Two contexts hold the same scene, and every call is made on both. After a call the snapshots of both
 * must be equal, although at random calls one of the two is restored from a snapshot. A call that is
 * refused must leave the snapshot as it was. A witness far from all other bodies must never stand
 * still. Everything random follows from the seed and the number of the scene. */
#ifndef VBSS_TESTS_FUZZ_SCENES_FUZZED_SCENE_H
#define VBSS_TESTS_FUZZ_SCENES_FUZZED_SCENE_H

#include "fuzz/scenes/findings.h"
#include "harness/harness.h"

enum { FUZZ_SIDES = 2, FUZZ_MAX_BODIES = 64, FUZZ_SCRIPT_LENGTH = 32, FUZZ_MAX_WITNESS_NODES = 8 };

typedef enum fuzz_kind {
    FUZZ_NONE,
    FUZZ_THREAD,
    FUZZ_DRAIN,
    FUZZ_NEEDLE,
    FUZZ_GRASPER,
    FUZZ_RIGID
} fuzz_kind;

/* What a host knows of a body. The number of the body is its index in the table. */
typedef struct fuzz_body {
    fuzz_kind kind;
    bool is_removed; /* the handle is the host's again */
    bool has_target; /* a grasper, or a driven or coupled body */
    vec3 tip, velocity;
    quat turn;
} fuzz_body;

typedef struct fuzz_bytes {
    uint8_t *data;
    uint64_t count, room;
} fuzz_bytes;

/* The scene or its twin. */
typedef struct fuzz_side {
    vbss_context *context;
    vbss_scene *scene;
    void *handles[FUZZ_MAX_BODIES]; /* of threads, drains, needles and graspers, by number */
    fuzz_bytes snapshot;            /* of the twin: as of the last comparison */
} fuzz_side;

/* A body far from all others. */
typedef struct fuzz_witness {
    uint32_t number;           /* 0: none */
    vec3 position;             /* before the call */
    bool was_clear;            /* no other body was near before the call */
    uint32_t stationary_steps; /* consecutive steps in which it did not move */
    uint64_t full_attempts;    /* attempts without room for their contacts, before the call */
} fuzz_witness;

typedef enum fuzz_action {
    FUZZ_STEP,
    FUZZ_CLOSE, /* jaws */
    FUZZ_OPEN
} fuzz_action;

typedef struct fuzz_scripted_call {
    fuzz_action action;
    uint32_t tool;
} fuzz_scripted_call;

typedef struct fuzz_scene {
    fuzz_findings *findings;
    harness_source source;
    vbss_scene_config config;
    fuzz_side sides[FUZZ_SIDES];
    fuzz_body bodies[FUZZ_MAX_BODIES];
    uint32_t last_number;
    fuzz_witness witness;
    fuzz_bytes earlier; /* an earlier snapshot of the scene */
    fuzz_bytes scratch;
    uint32_t comparison_interval, calls_since_comparison;
    double h; /* the usual step, s */
    fuzz_scripted_call script[FUZZ_SCRIPT_LENGTH];
    uint32_t script_length, script_position;
    /* The call in progress. */
    vbss_result results[FUZZ_SIDES];
    double clock;
    bool has_failed;
} fuzz_scene;

/* Builds the scene of this number, makes random calls and destroys it. */
void fuzz_run_scene(fuzz_findings *findings, uint64_t seed, uint64_t scene, uint32_t calls);

/* ---- calls and checks (calls.c) */

/* Makes a call on both sides. `expression` uses `side` and may use `k`, the index of the side. */
#define FUZZ_CALL(f, expression)                    \
    do {                                            \
        fuzz_begin_call((f), #expression);          \
        for (uint32_t k = 0; k < FUZZ_SIDES; k++) { \
            const fuzz_side *side = &(f)->sides[k]; \
            fuzz_start_clock(f);                    \
            fuzz_end_on_side((f), k, (expression)); \
        }                                           \
        fuzz_end_call(f);                           \
    } while (0)

/* Makes a call on the scene alone, which must change nothing. */
#define FUZZ_QUERY(f, expression)               \
    do {                                        \
        const fuzz_side *side = &(f)->sides[0]; \
        fuzz_begin_call((f), #expression);      \
        fuzz_start_clock(f);                    \
        fuzz_end_on_side((f), 0, (expression)); \
        fuzz_end_query(f);                      \
    } while (0)

void fuzz_begin_call(fuzz_scene *f, const char *expression);
void fuzz_start_clock(fuzz_scene *f);
void fuzz_end_on_side(fuzz_scene *f, uint32_t k, vbss_result result);
void fuzz_end_call(fuzz_scene *f);
void fuzz_end_query(fuzz_scene *f);
void fuzz_fail(fuzz_scene *f, fuzz_check check, const char *format, ...) VBSS_PRINTF(3, 4);
/* Arguments of the next call, printed when calls are. */
void fuzz_trace(const fuzz_scene *f, const char *format, ...) VBSS_PRINTF(2, 3);
/* Saves a side into a buffer that grows. */
void fuzz_save(fuzz_scene *f, uint32_t k, fuzz_bytes *bytes);
void fuzz_compare_twins(fuzz_scene *f);
/* Takes the state of both sides as the one that the next call begins with. */
void fuzz_begin_checks(fuzz_scene *f);

/* ---- the witness, and numbers that must stay finite (witness.c) */

void fuzz_add_witness(fuzz_scene *f);
void fuzz_check_after_step(fuzz_scene *f);

/* ---- random scenes and bodies (bodies.c, tools.c) */

bool fuzz_build_scene(fuzz_scene *f);
void fuzz_add_random_body(fuzz_scene *f);
void fuzz_add_thread(fuzz_scene *f);
void fuzz_add_drain(fuzz_scene *f);
uint32_t fuzz_add_needle(fuzz_scene *f);
void fuzz_add_rigid(fuzz_scene *f);
/* A grasper with its jaws around a thread or a needle, if there is one: `body`, or 0: any. */
uint32_t fuzz_add_grasper(fuzz_scene *f, uint32_t body);
/* A needle, two graspers around it, and the script that exchanges it. */
void fuzz_add_exchange(fuzz_scene *f);
/* Adds a body that the host has to the scene, whatever its kind. */
void fuzz_add_handle(fuzz_scene *f, fuzz_kind kind, void *const handles[FUZZ_SIDES]);
/* The number that a call has assigned. */
void fuzz_register(fuzz_scene *f, uint32_t number, fuzz_kind kind, void *const handles[FUZZ_SIDES]);
void fuzz_move_tool(fuzz_scene *f, uint32_t number);
/* A pose of a grasper whose jaws are around a place of a body. False: it has no such place. */
bool fuzz_set_target(fuzz_scene *f, uint32_t body, pose *at);

/* ---- random calls (edits.c, restores.c, steps.c) */

void fuzz_make_random_call(fuzz_scene *f);
void fuzz_edit_at_random(fuzz_scene *f);
void fuzz_restore_at_random(fuzz_scene *f);
void fuzz_query_at_random(fuzz_scene *f);
void fuzz_step(fuzz_scene *f);

/* ---- random choices (choices.c). No two in one list of arguments: compilers differ in their order. */

uint32_t fuzz_below(fuzz_scene *f, uint32_t bound);
bool fuzz_chance(fuzz_scene *f, double probability);
double fuzz_real(fuzz_scene *f, double low, double high);
/* Mostly near the lower bound. */
double fuzz_small(fuzz_scene *f, double low, double high);
vec3 fuzz_direction(fuzz_scene *f);
/* At most so long, mostly short. */
vec3 fuzz_vector(fuzz_scene *f, double length);
vec3 fuzz_point(fuzz_scene *f); /* in the middle of the scene, m */
quat fuzz_turn(fuzz_scene *f);
pose fuzz_pose(fuzz_scene *f);
/* A number that is mostly the given one, and now and then a bad one. */
double fuzz_spoil(fuzz_scene *f, double value);
uint32_t fuzz_spoil_number(fuzz_scene *f, uint32_t number);
/* The number of a body of this kind, mostly in the scene; 0: there is none. */
uint32_t fuzz_choose(fuzz_scene *f, fuzz_kind kind);
uint32_t fuzz_pick(fuzz_scene *f, const uint32_t *values, uint32_t count);
#define FUZZ_PICK(f, ...)                           \
    fuzz_pick((f), (const uint32_t[]){__VA_ARGS__}, \
              (uint32_t)(sizeof((uint32_t[]){__VA_ARGS__}) / sizeof(uint32_t)))

#endif
