#include "trainer/hands.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "throw/replay.h"

#define ROUNDING 1e-6 /* s */

enum { NO_BODY = 0 };

/* ---- a log */

typedef struct reader {
    score *score;
    vbss_replay *replay;
    uint64_t steps;
    uint32_t bodies[HANDS]; /* numbers of the graspers */
} reader;

static bool is_of_tool(const vbss_record_input *in)
{
    return in->kind == VBSS_RECORD_INPUT_GRASPER_TARGET ||
           in->kind == VBSS_RECORD_INPUT_SET_OPENING || in->kind == VBSS_RECORD_INPUT_EXCHANGE;
}

/* The two smallest numbers: right, left. */
static void meet(reader *r, uint32_t body)
{
    uint32_t *right = &r->bodies[RIGHT], *left = &r->bodies[LEFT];
    if (body == *right || body == *left) {
        return;
    }
    if (*right == NO_BODY || body < *right) {
        *left = *right;
        *right = body;
    } else if (*left == NO_BODY || body < *left) {
        *left = body;
    }
}

static void take(const reader *r, const vbss_record_input *in, reported now[HANDS])
{
    for (int side = 0; side < HANDS; side++) {
        reported *t = &now[side];
        if (in->words[0] != r->bodies[side]) {
            continue;
        }
        if (in->kind == VBSS_RECORD_INPUT_SET_OPENING) {
            t->opening = in->numbers[0];
            continue;
        }
        if (in->kind == VBSS_RECORD_INPUT_EXCHANGE) {
            t->kind = (vbss_grasper_kind)in->words[1];
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
    vbss_replay_logged_step step;
    const reported begin = {.orientation = {1.0}, .kind = VBSS_GRASPER_KIND_NEEDLE_DRIVER};
    reported now[HANDS] = {begin, begin};
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
            r->score->reported[side][n - 1] = now[side];
        }
        r->score->duration = step.time;
    }
    return VBSS_OK;
}

/* "vbss surgeon seed 2" and nothing else. */
static void read_note(const vbss_replay_info *info, score *s)
{
    char text[64], whole[sizeof text];
    if (info->note_bytes >= sizeof text) {
        return;
    }
    memcpy(text, info->note, info->note_bytes);
    text[info->note_bytes] = '\0';
    s->of_surgeon = sscanf(text, "vbss surgeon seed %10lu", &s->seed) == 1;
    snprintf(whole, sizeof whole, "vbss surgeon seed %lu", s->seed);
    s->of_surgeon = s->of_surgeon && strcmp(text, whole) == 0;
}

static vbss_result read_log(vbss_context *context, const replay_log *log, score *s)
{
    reader r = {.score = s};
    TRY(vbss_replay_create(context, log->data, log->count, &r.replay));
    vbss_record_log_report report;
    vbss_replay_info info;
    TRY(vbss_replay_get_info(r.replay, &info, sizeof info));
    read_note(&info, s);
    TRY(vbss_record_check_log(context, log->data, log->count, &report, sizeof report));
    r.steps = report.steps;
    TRY(walk(&r, false));
    if (r.bodies[RIGHT] == NO_BODY) {
        return VBSS_ERROR_NOT_FOUND; /* no tool moves in it */
    }
    for (int side = 0; side < HANDS; side++) {
        s->reported[side] = calloc((size_t)r.steps, sizeof *s->reported[side]);
        if (s->reported[side] == NULL) {
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
                 log.count == 0                   ? "cannot be read"
                 : result == VBSS_ERROR_NOT_FOUND ? "no tool moves in it"
                                                  : vbss_result_string(result));
        score_free(s);
    }
    return result == VBSS_OK;
}

void score_free(score *s)
{
    for (int side = 0; side < HANDS; side++) {
        free(s->reported[side]);
        s->reported[side] = NULL;
    }
}

/* ---- a hand */

/* The row of the log's step that is due, in time with its steps though times are sums. */
static reported read_score(follower *f, double time)
{
    const reported *row = f->score->reported[f->side];
    while (f->next + 1 < f->score->count && row[f->next + 1].time <= time + ROUNDING) {
        f->next++;
    }
    return row[f->next];
}

reported follower_want(follower *f, double time)
{
    if (f->score != NULL) {
        return read_score(f, time);
    }
    motion m = f->stage->row->script(f->stage, f->side, time);
    reported w = {.time = time,
                  .orientation = {1.0},
                  .opening = m.opening,
                  .kind = VBSS_GRASPER_KIND_NEEDLE_DRIVER,
                  .known = true};
    v_store(w.position, m.at);
    return w;
}

void follower_measure(void *user, double time, vbss_device_sample *sample)
{
    const reported w = follower_want(user, time);
    if (!w.known) {
        return;
    }
    memcpy(sample->position, w.position, sizeof sample->position);
    memcpy(sample->orientation, w.orientation, sizeof sample->orientation);
    sample->jaw = w.opening;
    sample->tool = w.kind == VBSS_GRASPER_KIND_SHEARS ? VBSS_DEVICE_TOOL_SHEARS
                                                      : VBSS_DEVICE_TOOL_NEEDLE_DRIVER;
    sample->valid = VBSS_DEVICE_HAS_POSITION | VBSS_DEVICE_HAS_ORIENTATION | VBSS_DEVICE_HAS_JAW |
                    VBSS_DEVICE_HAS_TOOL;
}
