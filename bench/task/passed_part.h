/* What is kept of the parts of a step, and what is known beside it: between passed.c, which keeps, and passed_ask.c, which asks. */
#ifndef VBSS_BENCH_TASK_PASSED_PART_H
#define VBSS_BENCH_TASK_PASSED_PART_H

#include "scene/api/api.h"
#include "scene/world/world.h"
#include "task/passed.h"

enum { MAX_CHAINS = 64, MAX_HOLES = 32, MAX_GRASPS = 16 };

typedef enum chain_kind { CHAIN_THREAD, CHAIN_TOOL, CHAIN_NEEDLE } chain_kind;

/* A chain in a part: where its nodes are in `begin` and `end`, and its body. */
typedef struct chain {
    chain_kind kind;
    uint32_t body;
    size_t first, count;
    double begins; /* along its body, m: of a needle from the tip */
} chain;

typedef struct part {
    chain chains[MAX_CHAINS];
    size_t chain_count, node_count, room;
    vec3 *start, *end; /* of all chains, then of the drain */
    size_t drain_first;
} part;

/* A tool's number, and the thread that its jaws hold, where along it, m. */
typedef struct held {
    uint32_t tool, thread;
    double arc;
} held;

struct passed {
    vbss_scene *scene;
    const scene_object *object;
    part *parts;
    size_t part_count, part_room;
    bool failed; /* no memory or room */
    vbss_scene_hole before[MAX_HOLES], now[MAX_HOLES];
    uint32_t before_count, now_count;
    held held_before[MAX_GRASPS], held_now[MAX_GRASPS];
    uint32_t held_before_count, held_now_count;
    const drain_object *drain;
    uint32_t (*sides)[2], (*triangles)[3]; /* of the wall, or of what is not round a hole */
    uint64_t step;
    passed_counts counts;
};

/* passed_ask.c: adds to the counts what met in a part. */
void passed_ask_part(passed *p, const part *t);

#endif
