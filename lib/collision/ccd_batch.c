/* Batches of queries: four at a time for the conservative method, otherwise one at a time. */
#include "collision/ccd_batch.h"

#include "collision/conservative_advancement.h"

#include <string.h>

static inline double thickness_of(const collision_ccd_batch *batch, uint32_t i)
{
    return batch->thickness != NULL ? batch->thickness[i] : batch->same_thickness;
}

/* Runs the query in column i and stores its result there. */
static void run_scalar(const collision_ccd_options *options, const collision_ccd_batch *batch,
                       uint32_t i, collision_counters *counters)
{
    collision_ccd_query q = {.kind = batch->kind};
    q.thickness = thickness_of(batch, i);
    for (size_t k = 0; k < 4; k++) {
        const double *start = batch->start + 3 * k * batch->stride + i;
        const double *end = batch->end + 3 * k * batch->stride + i;
        q.start[k] = vec3_make(start[0], start[batch->stride], start[2 * batch->stride]);
        q.end[k] = vec3_make(end[0], end[batch->stride], end[2 * batch->stride]);
    }
    collision_ccd_result result;
    vbss_collision_run_ccd(options, &q, &result, counters);
    batch->hit[i] = result.hit;
    if (batch->decision != NULL) {
        batch->decision[i] = result.decision;
    }
    if (batch->time != NULL) {
        batch->time[i] = result.time;
    }
    if (batch->distance != NULL) {
        batch->distance[i] = result.distance;
    }
    if (batch->normal != NULL) {
        batch->normal[i] = result.normal.x;
        batch->normal[batch->stride + i] = result.normal.y;
        batch->normal[2 * batch->stride + i] = result.normal.z;
    }
    for (size_t k = 0; batch->weights != NULL && k < 4; k++) {
        batch->weights[k * batch->stride + i] = result.weights[k];
    }
}

/* ---- four at a time
 *
 * First, every four adjacent queries make one pass, which is enough for most. Pending queries go to
 * a list. Groups of four are taken from the list until it is empty, so no lane waits for
 * another. */

/* Number of queries whose list of open ones fits on the stack. */
enum { BLOCK = 128 };

typedef struct pending_query {
    double time;
    uint32_t column, passes;
} pending_query;

typedef struct block {
    const collision_ccd_options *options;
    const collision_ccd_batch *rows;
    collision_counters *counters;
    uint32_t pending_count;
    pending_query pending[BLOCK];
} block;

static void store_result(const collision_ccd_batch *batch, uint32_t i,
                         const collision_ccd_outcome *o, unsigned lane)
{
    batch->hit[i] = (int32_t)(o->hit >> lane & 1u);
    if (batch->decision != NULL) {
        batch->decision[i] = VBSS_COLLISION_DECISION_PROVED;
    }
    if (batch->time != NULL) {
        batch->time[i] = o->time[lane];
    }
    if (batch->distance != NULL) {
        batch->distance[i] = o->distance[lane];
    }
    for (size_t k = 0; batch->normal != NULL && k < 3; k++) {
        batch->normal[k * batch->stride + i] = o->normal[k][lane];
    }
    for (size_t k = 0; batch->weights != NULL && k < 4; k++) {
        batch->weights[k * batch->stride + i] = o->weights[k][lane];
    }
}

/* Stores four adjacent columns, the usual case. */
static void store_four(const collision_ccd_batch *batch, uint32_t i, const collision_ccd_outcome *o)
{
    for (uint32_t k = 0; k < 4; k++) {
        batch->hit[i + k] = (int32_t)(o->hit >> k & 1u);
    }
    for (uint32_t k = 0; batch->decision != NULL && k < 4; k++) {
        batch->decision[i + k] = VBSS_COLLISION_DECISION_PROVED;
    }
    if (batch->time != NULL) {
        memcpy(batch->time + i, o->time, sizeof o->time);
    }
    if (batch->distance != NULL) {
        memcpy(batch->distance + i, o->distance, sizeof o->distance);
    }
    for (size_t k = 0; batch->normal != NULL && k < 3; k++) {
        memcpy(batch->normal + k * batch->stride + i, o->normal[k], sizeof o->normal[k]);
    }
    for (size_t k = 0; batch->weights != NULL && k < 4; k++) {
        memcpy(batch->weights + k * batch->stride + i, o->weights[k], sizeof o->weights[k]);
    }
}

/* Handles the result of one lane: counts it, adds the query to the list, or runs the scalar
 * code. */
static inline void finish_lane(block *b, uint32_t column, const collision_ccd_lanes *four,
                               const collision_ccd_outcome *o, unsigned lane)
{
    unsigned bit = 1u << lane;
    uint32_t passes = four->passes[lane];
    uint32_t limit = conservative_pass_limit(b->options->pass_limit, thickness_of(b->rows, column));
    bool is_pending = (o->pending & bit) != 0;
    if ((o->fallback & bit) != 0 || (is_pending && passes >= limit) || passes > limit) {
        run_scalar(b->options, b->rows, column, b->counters);
    } else if (is_pending) {
        pending_query w = {four->time[lane], column, passes};
        b->pending[b->pending_count++] = w;
    } else {
        b->counters->queries++;
        b->counters->hits += (o->hit & bit) != 0;
        b->counters->passes += (o->filtered & bit) != 0 ? 0 : passes;
    }
}

/* Four queries gathered from any columns. */
typedef struct gathered {
    double start[12 * 4], end[12 * 4], thickness[4];
} gathered;

static void gather(const collision_ccd_batch *batch, uint32_t column, size_t lane, gathered *g)
{
    g->thickness[lane] = thickness_of(batch, column);
    for (size_t row = 0; row < 12; row++) {
        g->start[4 * row + lane] = batch->start[row * batch->stride + column];
        g->end[4 * row + lane] = batch->end[row * batch->stride + column];
    }
}

/* First pass of `count` queries from i on. */
static void run_first_pass(block *b, bool wide, uint32_t i, uint32_t count)
{
    const collision_ccd_batch *batch = b->rows;
    double same[4] = {batch->same_thickness, batch->same_thickness, batch->same_thickness,
                      batch->same_thickness};
    collision_ccd_lanes four = {
        batch->start + i, batch->end + i, batch->thickness != NULL ? batch->thickness + i : same,
        batch->stride,    {0.0},          {0}};
    collision_ccd_outcome outcome;
    gathered g;
    if (count < 4) { /* the last query is repeated */
        for (uint32_t lane = 0; lane < 4; lane++) {
            gather(batch, lane < count ? i + lane : i + count - 1, lane, &g);
        }
        four.start = g.start;
        four.end = g.end;
        four.thickness = g.thickness;
        four.stride = 4;
    }
    VBSS_WIDE_CALL(wide, vbss_collision_advance_lanes, b->options, batch->kind, true, &four,
                   &outcome);
    if (count == 4) {
        store_four(batch, i, &outcome);
    }
    if (count == 4 && (outcome.pending | outcome.fallback | outcome.filtered) == 0) {
        b->counters->queries += 4;
        b->counters->passes += 4;
        b->counters->hits += (outcome.hit & 1u) + (outcome.hit >> 1 & 1u) +
                             (outcome.hit >> 2 & 1u) + (outcome.hit >> 3 & 1u);
        return;
    }
    for (unsigned lane = 0; lane < count; lane++) {
        if (count < 4) {
            store_result(batch, i + lane, &outcome, lane);
        }
        finish_lane(b, i + lane, &four, &outcome, lane);
    }
}

/* Passes for the last four pending queries, or all that are left. Those still pending return to the
 * list. */
static void run_next_pass(block *b, bool wide)
{
    uint32_t count = b->pending_count < 4 ? b->pending_count : 4, columns[4];
    gathered g;
    collision_ccd_lanes four = {g.start, g.end, g.thickness, 4, {0.0}, {0}};
    collision_ccd_outcome outcome;
    b->pending_count -= count;
    for (uint32_t lane = 0; lane < 4; lane++) {
        const pending_query *w = &b->pending[b->pending_count + (lane < count ? lane : count - 1)];
        gather(b->rows, w->column, lane, &g);
        columns[lane] = w->column;
        four.time[lane] = w->time;
        four.passes[lane] = w->passes;
    }
    VBSS_WIDE_CALL(wide, vbss_collision_advance_lanes, b->options, b->rows->kind, false, &four,
                   &outcome);
    for (unsigned lane = 0; lane < count; lane++) {
        if ((outcome.pending >> lane & 1u) == 0) {
            store_result(b->rows, columns[lane], &outcome, lane);
        }
        finish_lane(b, columns[lane], &four, &outcome, lane);
    }
}

void vbss_collision_run_ccd_batch(const collision_ccd_options *options, bool wide,
                                  const collision_ccd_batch *batch, collision_counters *counters)
{
    if (!options->method->has_lanes) {
        for (uint32_t i = 0; i < batch->count; i++) {
            run_scalar(options, batch, i, counters);
        }
        return;
    }
    block b = {.options = options, .rows = batch, .counters = counters};
    for (uint32_t i = 0; i < batch->count; i += 4) {
        run_first_pass(&b, wide, i, batch->count - i < 4 ? batch->count - i : 4);
        while (b.pending_count > BLOCK - 4) { /* keeps room for the next four */
            run_next_pass(&b, wide);
        }
    }
    while (b.pending_count > 0) {
        run_next_pass(&b, wide);
    }
}
