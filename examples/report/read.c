/* What a log says without a scene: where the tools were told to be, and what happened. */
#include <stdlib.h>
#include <string.h>

#include "report/facts.h"

enum { MAX_BODIES = 4096, KINDS = 32 };

bool facts_room(void **array, size_t *room, size_t used, size_t size)
{
    if (used < *room) {
        return true;
    }
    size_t more = *room > 0 ? 2 * *room : 64;
    void *larger = more > SIZE_MAX / size ? NULL : realloc(*array, more * size);
    if (larger == NULL) {
        return false;
    }
    *array = larger;
    *room = more;
    return true;
}

/* ---- which bodies are the tools */

typedef struct seen_body {
    uint64_t moves;
    double x; /* where it was told to be first */
    bool grasper;
} seen_body;

/* Graspers before other bodies, then what is moved most; of two the one that begins more to the left is the left one. */
static void choose_tools(facts *f, const seen_body *bodies)
{
    for (int side = 0; side < SIDES; side++) {
        uint32_t best = 0;
        for (uint32_t i = 1; i < MAX_BODIES; i++) {
            const seen_body *a = &bodies[i], *b = &bodies[best];
            bool better =
                best == 0 || (a->grasper == b->grasper ? a->moves > b->moves : a->grasper);
            if (a->moves > 0 && i != f->tools[LEFT] && better) {
                best = i;
            }
        }
        f->tools[side] = best;
    }
    if (f->tools[RIGHT] == 0 ? bodies[f->tools[LEFT]].x > 0.0
                             : bodies[f->tools[LEFT]].x > bodies[f->tools[RIGHT]].x) {
        uint32_t left = f->tools[LEFT];
        f->tools[LEFT] = f->tools[RIGHT];
        f->tools[RIGHT] = left;
    }
    for (uint32_t i = 1; i < MAX_BODIES; i++) {
        f->others += bodies[i].moves > 0 && i != f->tools[LEFT] && i != f->tools[RIGHT];
    }
}

static bool is_move(const vbss_record_input *input)
{
    return (input->kind == VBSS_RECORD_INPUT_GRASPER_TARGET ||
            input->kind == VBSS_RECORD_INPUT_RIGID_TARGET) &&
           input->words[0] > 0 && input->words[0] < MAX_BODIES;
}

static vbss_result find_tools(facts *f)
{
    static seen_body bodies[MAX_BODIES];
    vbss_replay_logged_step step;
    memset(bodies, 0, sizeof bodies);
    for (uint64_t n = 1; n <= f->steps; n++) {
        TRY(vbss_replay_read(f->log, n, &step, sizeof step));
        for (uint32_t i = 0; i < step.input_count; i++) {
            const vbss_record_input *input = &step.inputs[i];
            if (is_move(input)) {
                seen_body *body = &bodies[input->words[0]];
                body->x = body->moves == 0 ? input->numbers[0] : body->x;
                body->grasper = body->grasper || input->kind == VBSS_RECORD_INPUT_GRASPER_TARGET;
                body->moves++;
            }
        }
    }
    choose_tools(f, bodies);
    return VBSS_OK;
}

/* ---- step by step */

static void hear(const facts *f, const vbss_record_input *input, moment *m)
{
    for (int side = 0; side < SIDES; side++) {
        if (f->tools[side] == 0 || input->words[0] != f->tools[side]) {
            continue;
        }
        if (is_move(input)) {
            memcpy(m->at[side], input->numbers, sizeof m->at[side]);
            m->reported[side] = true;
        } else if (input->kind == VBSS_RECORD_INPUT_SET_OPENING) {
            m->opening[side] = input->numbers[0];
        }
    }
}

static bool keep_happening(facts *f, const happening *h)
{
    if (!facts_room((void **)&f->events, &f->event_room, f->event_count, sizeof *f->events)) {
        return false;
    }
    f->events[f->event_count++] = *h;
    return true;
}

/* A cut by the host is an input and no event; the piece has no name in it. */
static bool keep_cut(facts *f, const vbss_replay_logged_step *step, const vbss_record_input *input)
{
    const happening h = {VBSS_SCENE_EVENT_CUT, input->words[0], UINT32_MAX, 0,
                         step->number,         step->time};
    f->counts[VBSS_SCENE_EVENT_CUT]++;
    return keep_happening(f, &h);
}

static bool keep_event(facts *f, const vbss_replay_logged_step *step, const uint32_t *e)
{
    f->counts[e[0] < KINDS ? e[0] : 0]++;
    if (e[0] == VBSS_SCENE_EVENT_TOUCH || e[0] == VBSS_SCENE_EVENT_PART) {
        return true; /* counted, and too many to be shown */
    }
    return keep_happening(f, &(happening){e[0], e[1], e[2], e[3], step->number, step->time});
}

static vbss_result read_steps(facts *f)
{
    vbss_replay_logged_step step;
    for (uint64_t n = 1; n <= f->steps; n++) {
        TRY(vbss_replay_read(f->log, n, &step, sizeof step));
        moment *m = &f->moments[n - 1];
        if (n > 1) {
            *m = m[-1];
        }
        m->time = step.time;
        m->h = step.h;
        m->lost += step.time_lost;
        for (uint32_t i = 0; i < step.input_count; i++) {
            hear(f, &step.inputs[i], m);
            if (step.inputs[i].kind == VBSS_RECORD_INPUT_CUT &&
                !keep_cut(f, &step, &step.inputs[i])) {
                return VBSS_ERROR_OUT_OF_MEMORY;
            }
        }
        for (uint32_t i = 0; i < step.event_count; i++) {
            if (!keep_event(f, &step, step.events + 4 * (size_t)i)) {
                return VBSS_ERROR_OUT_OF_MEMORY;
            }
        }
    }
    return VBSS_OK;
}

/* ---- what is held from when to when */

/* Of a thread that was cut meanwhile the piece has another number: then what the tool took last. */
static void let_go(facts *f, const happening *e)
{
    holding *last = NULL;
    for (size_t i = f->holding_count; i-- > 0;) {
        holding *h = &f->holdings[i];
        if (h->ended == 0 && f->tools[h->side] == e->second) {
            last = last == NULL || h->thing == e->first ? h : last;
            if (h->thing == e->first) {
                break;
            }
        }
    }
    if (last != NULL) {
        last->to = e->time;
        last->ended = e->kind;
    }
}

static vbss_result find_holdings(facts *f)
{
    for (size_t i = 0; i < f->event_count; i++) {
        const happening *e = &f->events[i];
        if (e->kind == VBSS_SCENE_EVENT_RELEASE || e->kind == VBSS_SCENE_EVENT_TORN) {
            let_go(f, e);
        }
        for (int side = 0; e->kind == VBSS_SCENE_EVENT_GRASP && side < SIDES; side++) {
            if (f->tools[side] != 0 && e->second == f->tools[side]) {
                if (!facts_room((void **)&f->holdings, &f->holding_room, f->holding_count,
                                sizeof *f->holdings)) {
                    return VBSS_ERROR_OUT_OF_MEMORY;
                }
                f->holdings[f->holding_count++] =
                    (holding){side, e->first, e->time, facts_end(f), 0};
            }
        }
    }
    return VBSS_OK;
}

vbss_result facts_read(facts *f)
{
    TRY(vbss_context_create(NULL, &f->context));
    TRY(vbss_record_check_log(f->context, f->bytes, f->count, &f->check, sizeof f->check));
    TRY(vbss_replay_create(f->context, f->bytes, f->count, &f->log));
    TRY(vbss_replay_get_info(f->log, &f->info, sizeof f->info));
    f->steps = f->check.steps;
    f->moments = calloc(f->steps > 0 ? (size_t)f->steps : 1, sizeof *f->moments);
    if (f->moments == NULL) {
        return VBSS_ERROR_OUT_OF_MEMORY;
    }
    TRY(find_tools(f));
    TRY(read_steps(f));
    return find_holdings(f);
}

void facts_destroy(facts *f)
{
    measured *m = &f->measured;
    for (int side = 0; side < SIDES; side++) {
        free(m->speed[side]);
        free(m->force[side]);
    }
    free(m->penalties);
    free(m->throws);
    free(f->phases);
    free(f->again.steps);
    free(f->again.readings);
    free(f->again.punctures);
    free(f->again.session.events);
    free(f->holdings);
    free(f->events);
    free(f->moments);
    free(f->bytes);
    if (f->context != NULL) {
        (void)vbss_context_destroy(f->context);
    }
}
