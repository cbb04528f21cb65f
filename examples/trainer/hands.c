#include "trainer/hands.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "throw/replay.h"

enum { NOBODY = 0 };

/* ---- a log */

typedef struct reader {
    score *score;
    vbss_replay *replay;
    uint64_t steps;
    uint32_t bodies[HANDS]; /* numbers of the graspers */
} reader;

static bool is_of_tool(const vbss_log_input *in)
{
    return in->kind == VBSS_INPUT_MOVE_GRASPER || in->kind == VBSS_INPUT_SET_OPENING;
}

/* The two smallest numbers: right, left. */
static void meet(reader *r, uint32_t body)
{
    uint32_t *right = &r->bodies[RIGHT], *left = &r->bodies[LEFT];
    if (body == *right || body == *left) {
        return;
    }
    if (*right == NOBODY || body < *right) {
        *left = *right;
        *right = body;
    } else if (*left == NOBODY || body < *left) {
        *left = body;
    }
}

static void take(const reader *r, const vbss_log_input *in, told now[HANDS])
{
    for (int side = 0; side < HANDS; side++) {
        told *t = &now[side];
        if (in->words[0] != r->bodies[side]) {
            continue;
        }
        if (in->kind == VBSS_INPUT_SET_OPENING) {
            t->opening = in->numbers[0];
            continue;
        }
        memcpy(t->position, in->numbers, sizeof t->position);
        if (in->words[1] != 0) {
            memcpy(t->orientation, in->numbers + 3, sizeof t->orientation);
        }
        t->known = true;
    }
}

/* First who moves, then where to. */
static vbss_result walk(reader *r, bool store)
{
    vbss_log_step step;
    told now[HANDS] = {{.orientation = {1.0}}, {.orientation = {1.0}}};
    for (uint64_t n = 1; n <= r->steps; n++) {
        TRY(vbss_replay_read(r->replay, n, &step, sizeof step));
        for (uint32_t i = 0; i < step.input_count; i++) {
            if (!is_of_tool(&step.inputs[i])) {
                continue;
            }
            if (store) {
                take(r, &step.inputs[i], now);
            } else {
                meet(r, step.inputs[i].words[0]);
            }
        }
        for (int side = 0; store && side < HANDS; side++) {
            now[side].time = step.time - step.h;
            r->score->told[side][n - 1] = now[side];
        }
        r->score->duration = step.time;
    }
    return VBSS_OK;
}

static vbss_result read_log(vbss_context *context, const replay_log *log, score *s)
{
    reader r = {.score = s};
    TRY(vbss_replay_create(context, log->data, log->count, &r.replay));
    vbss_log_report report;
    TRY(vbss_log_check(context, log->data, log->count, &report, sizeof report));
    r.steps = report.steps;
    TRY(walk(&r, false));
    if (r.bodies[RIGHT] == NOBODY) {
        return VBSS_ERROR_OUT_OF_RANGE; /* no tool moves in it */
    }
    for (int side = 0; side < HANDS; side++) {
        s->told[side] = calloc((size_t)r.steps, sizeof *s->told[side]);
        if (s->told[side] == NULL) {
            return VBSS_ERROR_OUT_OF_MEMORY;
        }
    }
    s->count = (size_t)r.steps;
    return walk(&r, true);
}

bool score_read(score *s, const char *path, char *why, size_t bytes)
{
    vbss_context *context = NULL;
    memset(s, 0, sizeof *s);
    replay_log log = replay_read(path);
    vbss_result result = VBSS_ERROR_TRUNCATED;
    if (log.count > 0) {
        result = vbss_context_create(NULL, &context);
        result = result == VBSS_OK ? read_log(context, &log, s) : result;
        (void)vbss_context_destroy(context);
    }
    free(log.data);
    if (result != VBSS_OK) {
        snprintf(why, bytes, "%s",
                 log.count == 0                      ? "cannot be read"
                 : result == VBSS_ERROR_OUT_OF_RANGE ? "no tool moves in it"
                                                     : vbss_result_string(result));
        score_free(s);
    }
    return result == VBSS_OK;
}

void score_free(score *s)
{
    for (int side = 0; side < HANDS; side++) {
        free(s->told[side]);
        s->told[side] = NULL;
    }
}

/* ---- a hand */

static void follow_score(follower *f, double time, vbss_device_sample *sample)
{
    const told *row = f->score->told[f->side];
    while (f->next + 1 < f->score->count && row[f->next + 1].time <= time) {
        f->next++;
    }
    row += f->next;
    if (!row->known) {
        return;
    }
    memcpy(sample->position, row->position, sizeof sample->position);
    memcpy(sample->orientation, row->orientation, sizeof sample->orientation);
    sample->jaw = row->opening;
    sample->valid = VBSS_DEVICE_HAS_POSITION | VBSS_DEVICE_HAS_ORIENTATION | VBSS_DEVICE_HAS_JAW;
}

void follower_measure(void *user, double time, vbss_device_sample *sample)
{
    follower *f = user;
    if (f->score != NULL) {
        follow_score(f, time, sample);
        return;
    }
    motion w = f->stage->row->script(f->stage, f->side, time);
    v_store(sample->position, w.at);
    sample->jaw = w.opening;
    sample->valid = VBSS_DEVICE_HAS_POSITION | VBSS_DEVICE_HAS_ORIENTATION | VBSS_DEVICE_HAS_JAW;
}
