/* Questions in rows: four at a time by the conservative method, one at a time by the others. */
#include "collision/rows.h"

#include "collision/conservative.h"

#include <string.h>

static inline double thickness_of(const collision_rows *rows, uint32_t i)
{
    return rows->thickness != NULL ? rows->thickness[i] : rows->same_thickness;
}

/* One question, and what it answers, in column i. */
static void ask_alone(const collision_rules *rules, const collision_rows *rows, uint32_t i,
                      collision_counters *counters)
{
    collision_question q = {.kind = rows->kind};
    q.thickness = thickness_of(rows, i);
    for (size_t k = 0; k < 4; k++) {
        const double *start = rows->start + 3 * k * rows->stride + i;
        const double *end = rows->end + 3 * k * rows->stride + i;
        q.start[k] = vec3_make(start[0], start[rows->stride], start[2 * rows->stride]);
        q.end[k] = vec3_make(end[0], end[rows->stride], end[2 * rows->stride]);
    }
    collision_answer answer;
    vbss_collision_ask(rules, &q, &answer, counters);
    rows->hit[i] = answer.hit;
    if (rows->decision != NULL) {
        rows->decision[i] = answer.decision;
    }
    if (rows->time != NULL) {
        rows->time[i] = answer.time;
    }
    if (rows->distance != NULL) {
        rows->distance[i] = answer.distance;
    }
    if (rows->normal != NULL) {
        rows->normal[i] = answer.normal.x;
        rows->normal[rows->stride + i] = answer.normal.y;
        rows->normal[2 * rows->stride + i] = answer.normal.z;
    }
    for (size_t k = 0; rows->weights != NULL && k < 4; k++) {
        rows->weights[k * rows->stride + i] = answer.weights[k];
    }
}

/* ---- four at a time
 *
 * First every four neighbours make one pass, which is all that most need. Those that are still open wait
 * in a list, out of which four others are made until it is empty: so no lane waits for another. */

/* A block of questions whose list of the open ones stands on the stack. */
enum { BLOCK = 128 };

typedef struct waiting {
    double time;
    uint32_t column, passes;
} waiting;

typedef struct block {
    const collision_rules *rules;
    const collision_rows *rows;
    collision_counters *counters;
    uint32_t open;
    waiting list[BLOCK];
} block;

static void store_answer(const collision_rows *rows, uint32_t i, const collision_outcome *o,
                         unsigned lane)
{
    rows->hit[i] = (int32_t)(o->hit >> lane & 1u);
    if (rows->decision != NULL) {
        rows->decision[i] = VBSS_DECISION_PROVED;
    }
    if (rows->time != NULL) {
        rows->time[i] = o->time[lane];
    }
    if (rows->distance != NULL) {
        rows->distance[i] = o->distance[lane];
    }
    for (size_t k = 0; rows->normal != NULL && k < 3; k++) {
        rows->normal[k * rows->stride + i] = o->normal[k][lane];
    }
    for (size_t k = 0; rows->weights != NULL && k < 4; k++) {
        rows->weights[k * rows->stride + i] = o->weights[k][lane];
    }
}

/* Four columns side by side, the usual case. */
static void store_four(const collision_rows *rows, uint32_t i, const collision_outcome *o)
{
    for (uint32_t k = 0; k < 4; k++) {
        rows->hit[i + k] = (int32_t)(o->hit >> k & 1u);
    }
    for (uint32_t k = 0; rows->decision != NULL && k < 4; k++) {
        rows->decision[i + k] = VBSS_DECISION_PROVED;
    }
    if (rows->time != NULL) {
        memcpy(rows->time + i, o->time, sizeof o->time);
    }
    if (rows->distance != NULL) {
        memcpy(rows->distance + i, o->distance, sizeof o->distance);
    }
    for (size_t k = 0; rows->normal != NULL && k < 3; k++) {
        memcpy(rows->normal + k * rows->stride + i, o->normal[k], sizeof o->normal[k]);
    }
    for (size_t k = 0; rows->weights != NULL && k < 4; k++) {
        memcpy(rows->weights + k * rows->stride + i, o->weights[k], sizeof o->weights[k]);
    }
}

/* What came of the lane of a question: its answer is counted, or it waits, or it is asked alone. */
static inline void settle(block *b, uint32_t column, const collision_four *four,
                          const collision_outcome *o, unsigned lane)
{
    unsigned bit = 1u << lane;
    uint32_t passes = four->passes[lane];
    uint32_t limit = conservative_pass_limit(b->rules->pass_limit, thickness_of(b->rows, column));
    bool open = (o->open & bit) != 0;
    if ((o->left & bit) != 0 || (open && passes >= limit) || passes > limit) {
        ask_alone(b->rules, b->rows, column, b->counters);
    } else if (open) {
        waiting w = {four->time[lane], column, passes};
        b->list[b->open++] = w;
    } else {
        b->counters->queries++;
        b->counters->hits += (o->hit & bit) != 0;
        b->counters->passes += (o->filtered & bit) != 0 ? 0 : passes;
    }
}

/* Four questions from wherever they stand. */
typedef struct gathered {
    double start[12 * 4], end[12 * 4], thickness[4];
} gathered;

static void gather(const collision_rows *rows, uint32_t column, size_t lane, gathered *g)
{
    g->thickness[lane] = thickness_of(rows, column);
    for (size_t row = 0; row < 12; row++) {
        g->start[4 * row + lane] = rows->start[row * rows->stride + column];
        g->end[4 * row + lane] = rows->end[row * rows->stride + column];
    }
}

/* A first pass of `count` questions from i on. */
static void pass_first(block *b, bool wide, uint32_t i, uint32_t count)
{
    const collision_rows *rows = b->rows;
    double same[4] = {rows->same_thickness, rows->same_thickness, rows->same_thickness,
                      rows->same_thickness};
    collision_four four = {
        rows->start + i, rows->end + i, rows->thickness != NULL ? rows->thickness + i : same,
        rows->stride,    {0.0},         {0}};
    collision_outcome outcome;
    gathered g;
    if (count < 4) { /* the last one is repeated */
        for (uint32_t lane = 0; lane < 4; lane++) {
            gather(rows, lane < count ? i + lane : i + count - 1, lane, &g);
        }
        four.start = g.start;
        four.end = g.end;
        four.thickness = g.thickness;
        four.stride = 4;
    }
    VBSS_WIDE_CALL(wide, vbss_collision_four, b->rules, rows->kind, true, &four, &outcome);
    if (count == 4) {
        store_four(rows, i, &outcome);
    }
    if (count == 4 && (outcome.open | outcome.left | outcome.filtered) == 0) {
        b->counters->queries += 4;
        b->counters->passes += 4;
        b->counters->hits += (outcome.hit & 1u) + (outcome.hit >> 1 & 1u) +
                             (outcome.hit >> 2 & 1u) + (outcome.hit >> 3 & 1u);
        return;
    }
    for (unsigned lane = 0; lane < count; lane++) {
        if (count < 4) {
            store_answer(rows, i + lane, &outcome, lane);
        }
        settle(b, i + lane, &four, &outcome, lane);
    }
}

/* Passes for the last four that wait, or as many as there are; those still open wait again. */
static void pass_on(block *b, bool wide)
{
    uint32_t count = b->open < 4 ? b->open : 4, columns[4];
    gathered g;
    collision_four four = {g.start, g.end, g.thickness, 4, {0.0}, {0}};
    collision_outcome outcome;
    b->open -= count;
    for (uint32_t lane = 0; lane < 4; lane++) {
        const waiting *w = &b->list[b->open + (lane < count ? lane : count - 1)];
        gather(b->rows, w->column, lane, &g);
        columns[lane] = w->column;
        four.time[lane] = w->time;
        four.passes[lane] = w->passes;
    }
    VBSS_WIDE_CALL(wide, vbss_collision_four, b->rules, b->rows->kind, false, &four, &outcome);
    for (unsigned lane = 0; lane < count; lane++) {
        if ((outcome.open >> lane & 1u) == 0) {
            store_answer(b->rows, columns[lane], &outcome, lane);
        }
        settle(b, columns[lane], &four, &outcome, lane);
    }
}

void vbss_collision_ask_rows(const collision_rules *rules, bool wide, const collision_rows *rows,
                             collision_counters *counters)
{
    if (rules->method != VBSS_COLLISION_CONSERVATIVE) {
        for (uint32_t i = 0; i < rows->count; i++) {
            ask_alone(rules, rows, i, counters);
        }
        return;
    }
    block b = {.rules = rules, .rows = rows, .counters = counters};
    for (uint32_t i = 0; i < rows->count; i += 4) {
        pass_first(&b, wide, i, rows->count - i < 4 ? rows->count - i : 4);
        while (b.open > BLOCK - 4) { /* room for the next four */
            pass_on(&b, wide);
        }
    }
    while (b.open > 0) {
        pass_on(&b, wide);
    }
}
