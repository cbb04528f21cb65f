/* The steps of a log made once more, and looked at: forces, slit, punctures, knots, what a step takes here. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "report/stage.h"

enum { JUDGED_EVERY = 50 };

static double now(void)
{
    struct timespec t;
    (void)clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

static double length(const double *v)
{
    return sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
}

static double distance(const double *a, const double *b)
{
    const double v[3] = {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
    return length(v);
}

/* ---- every step */

static vbss_result feel(const facts *f, const stage *s, again_step *step)
{
    for (int k = 0; k < SIDES; k++) {
        vbss_grasper_state state;
        TRY(vbss_grasper_get_state(s->graspers[k], &state, sizeof state));
        for (int side = 0; side < SIDES; side++) {
            if (f->tools[side] == state.body) {
                memcpy(step->pulls[side], state.hand_force, sizeof step->pulls[side]);
                step->force[side] = length(state.hand_force);
            }
        }
    }
    return VBSS_OK;
}

static vbss_result measure_slit(const stage *s, again_step *step)
{
    vbss_view x, edges[SIDES];
    vbss_drain_places places;
    step->gap = step->widest = -1.0;
    if (s->drain == NULL) {
        return VBSS_OK;
    }
    TRY(vbss_drain_get_places(s->drain, &places, sizeof places));
    TRY(vbss_drain_get_view(s->drain, VBSS_DRAIN_POSITIONS, &x, sizeof x));
    TRY(vbss_drain_get_view(s->drain, VBSS_DRAIN_SLIT_LEFT, &edges[LEFT], sizeof x));
    TRY(vbss_drain_get_view(s->drain, VBSS_DRAIN_SLIT_RIGHT, &edges[RIGHT], sizeof x));
    const double *at = x.data;
    const uint32_t *left = edges[LEFT].data, *right = edges[RIGHT].data;
    step->gap =
        distance(at + 3 * (size_t)places.gap_points[0], at + 3 * (size_t)places.gap_points[1]);
    for (uint64_t i = 0; i < edges[LEFT].count && i < edges[RIGHT].count; i++) {
        step->widest =
            fmax(step->widest, distance(at + 3 * (size_t)left[i], at + 3 * (size_t)right[i]));
    }
    return VBSS_OK;
}

/* ---- when something happens */

static bool find_hole(const stage *s, uint32_t id, vbss_hole *hole)
{
    for (uint32_t i = 0; vbss_scene_get_hole(s->scene, i, hole, sizeof *hole) == VBSS_OK; i++) {
        if (hole->id == id) {
            return true;
        }
    }
    return false;
}

static vbss_result keep_puncture(again *a, const stage *s, const happening *e)
{
    const double axis[3] = {1.0, 0.0, 0.0}, centre[3] = {0.0, 0.0, 0.0}; /* in the drain's frame */
    vbss_drain_places places;
    vbss_view rest;
    vbss_hole hole;
    double best = HUGE_VAL;
    if (!find_hole(s, e->number, &hole)) {
        return VBSS_OK;
    }
    if (!facts_room((void **)&a->punctures, &a->puncture_room, a->puncture_count,
                    sizeof *a->punctures)) {
        return VBSS_ERROR_OUT_OF_MEMORY;
    }
    TRY(vbss_drain_get_places(s->drain, &places, sizeof places));
    TRY(vbss_drain_get_view(s->drain, VBSS_DRAIN_REST_POSITIONS, &rest, sizeof rest));
    puncture *p = &a->punctures[a->puncture_count++];
    *p = (puncture){.id = e->number, .step = e->step, .time = e->time, .tube = s->tube};
    memcpy(p->force, hole.force, sizeof p->force);
    for (int mark = 0; mark < 2; mark++) {
        double angle, axial;
        const double *at = (const double *)rest.data + 3 * (size_t)places.marks[mark];
        TRY(vbss_metrics_offset(axis, centre, at, hole.rest_position, &angle, &axial));
        double off = hypot(s->tube * angle, axial);
        if (off < best) {
            best = off;
            p->mark = mark;
            p->angle = angle;
            p->axial = axial;
        }
    }
    return VBSS_OK;
}

static void take_back(again *a, const happening *e)
{
    for (size_t i = 0; i < a->puncture_count; i++) {
        if (a->punctures[i].id == e->number) {
            a->punctures[i].withdrawn = true;
            a->punctures[i].withdrawn_time = e->time;
        }
    }
}

static vbss_result look_at_events(facts *f, const stage *s, uint64_t step, size_t *next)
{
    for (; *next < f->event_count && f->events[*next].step <= step; (*next)++) {
        const happening *e = &f->events[*next];
        if (e->kind == VBSS_EVENT_PUNCTURE && s->drain != NULL) {
            TRY(keep_puncture(&f->again, s, e));
        } else if (e->kind == VBSS_EVENT_WITHDRAWN) {
            take_back(&f->again, e);
        }
    }
    return VBSS_OK;
}

/* Kept when it says something else than before. */
static vbss_result read_knot(facts *f, stage *s, uint64_t step)
{
    again *a = &f->again;
    reading r = {.time = f->moments[step - 1].time, .step = step};
    TRY(stage_judge(s, &r));
    const reading *before = a->reading_count > 0 ? &a->readings[a->reading_count - 1] : NULL;
    if (before != NULL && before->state.verdict == r.state.verdict &&
        before->state.name == r.state.name && before->state.throw_count == r.state.throw_count &&
        before->state.faults == r.state.faults && step < f->steps) {
        return VBSS_OK;
    }
    if (!facts_room((void **)&a->readings, &a->reading_room, a->reading_count,
                    sizeof *a->readings)) {
        return VBSS_ERROR_OUT_OF_MEMORY;
    }
    a->readings[a->reading_count++] = r;
    return VBSS_OK;
}

static vbss_result look(facts *f, stage *s, uint64_t step, double spent, size_t *next)
{
    again *a = &f->again;
    again_step *here = &a->steps[step - 1];
    TRY(stage_follow(s));
    TRY(feel(f, s, here));
    TRY(measure_slit(s, here));
    TRY(vbss_scene_get_statistics(s->scene, &a->scene, sizeof a->scene));
    here->contacts = a->scene.contacts;
    here->spent = spent;
    a->count = step;
    TRY(look_at_events(f, s, step, next));
    TRY(a->watch != NULL ? a->watch(a->user, s, step) : VBSS_OK);
    return step % JUDGED_EVERY == 0 || step == f->steps ? read_knot(f, s, step) : VBSS_OK;
}

/* ---- with its session */

/* Where the session is not the recorded one the scene goes on without. */
static vbss_result step(again *a, stage *s, vbss_replay *replay)
{
    vbss_session_status status;
    if (s->task.session == NULL) {
        return vbss_replay_step(replay, &a->report, sizeof a->report);
    }
    vbss_result result = vbss_session_step(s->task.session, 0.0, 0.0);
    TRY(vbss_session_get_status(s->task.session, &status, sizeof status));
    if (status.steps > a->report.step) { /* the scene's step was made, and agrees */
        a->report.step++;
        a->session.agrees = result == VBSS_OK;
        return a->session.agrees ? VBSS_OK : task_destroy(&s->task);
    }
    return vbss_replay_step(replay, &a->report, sizeof a->report); /* where it is, once more */
}

/* What it told and measured; the tools must be those of the page. */
static vbss_result read_session(facts *f, stage *s)
{
    followed *t = &f->again.session;
    if (s->task.session == NULL || f->again.count == 0) {
        return VBSS_OK;
    }
    TRY(vbss_session_get_status(s->task.session, &t->status, sizeof t->status));
    for (uint64_t i = t->status.first_event; i < t->status.event_count; i++) {
        if (!facts_room((void **)&t->events, &t->room, t->count, sizeof *t->events)) {
            return VBSS_ERROR_OUT_OF_MEMORY;
        }
        TRY(vbss_session_get_event(s->task.session, i, &t->events[t->count], sizeof *t->events));
        t->count++;
    }
    if (f->tools[LEFT] != s->tasked->left.body || f->tools[RIGHT] != s->tasked->right.body) {
        return VBSS_OK;
    }
    t->measured = true;
    TRY(vbss_metrics_config_init(&f->measured.config, sizeof f->measured.config));
    TRY(vbss_metrics_finish(s->task.metrics));
    return facts_take(f, s->task.metrics);
}

/* ---- all of it */

static vbss_result play(facts *f, stage *s)
{
    again *a = &f->again;
    vbss_replay *replay;
    size_t next = 0;
    TRY(stage_create(s, f->info.note, f->info.note_bytes));
    a->name = s->name;
    a->needle = s->needle;
    a->drain = s->drain != NULL;
    a->knots = true;
    TRY(vbss_replay_create(s->context, f->bytes, f->count, &replay));
    TRY(vbss_replay_begin(replay, s->scene));
    TRY(stage_follow_task(s, replay));
    a->session.there = a->session.agrees = s->tasked != NULL;
    TRY(a->watch != NULL ? a->watch(a->user, s, 0) : VBSS_OK);
    for (;;) {
        double begin = now();
        TRY(step(a, s, replay));
        double spent = now() - begin;
        if (a->report.outcome != VBSS_REPLAY_STEPPED || a->report.step > f->steps) {
            return VBSS_OK;
        }
        TRY(look(f, s, a->report.step, spent, &next));
    }
}

const reading *facts_certified(const facts *f)
{
    for (size_t i = f->again.reading_count; i-- > 0;) {
        if (f->again.readings[i].state.verdict == VBSS_KNOT_VERDICT_CERTIFIED) {
            return &f->again.readings[i];
        }
    }
    return NULL;
}

vbss_result facts_again(facts *f)
{
    static stage s;
    again *a = &f->again;
    if (!a->asked || !stage_knows(f->info.note, f->info.note_bytes)) {
        return VBSS_OK;
    }
    a->steps = calloc(f->steps > 0 ? (size_t)f->steps : 1, sizeof *a->steps);
    if (a->steps == NULL) {
        return VBSS_ERROR_OUT_OF_MEMORY;
    }
    a->result = play(f, &s);
    if (a->result != VBSS_OK) {
        const char *text = "";
        if (s.context != NULL) {
            (void)vbss_context_get_last_error(s.context, NULL, &text);
        }
        snprintf(a->problem, sizeof a->problem, "%s", text);
    }
    vbss_result result = read_session(f, &s);
    stage_destroy(&s);
    return result;
}
