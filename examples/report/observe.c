/* What is seen of a session while its steps are made: forces, slit, punctures, knots, what a step takes. */
#include <math.h>
#include <string.h>

#include "report/stage.h"

enum { JUDGED_EVERY = 50 };
/* s, as in a session: the slip measure swings while a throw is drawn tight. */
#define HITCH_DWELL 2.0

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
        if (s->graspers[k] == NULL) {
            continue;
        }
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
    TRY(vbss_drain_get_view(s->drain, VBSS_DRAIN_VIEW_POSITIONS, &x, sizeof x));
    TRY(vbss_drain_get_view(s->drain, VBSS_DRAIN_VIEW_SLIT_LEFT, &edges[LEFT], sizeof x));
    TRY(vbss_drain_get_view(s->drain, VBSS_DRAIN_VIEW_SLIT_RIGHT, &edges[RIGHT], sizeof x));
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

static bool find_hole(const stage *s, uint32_t id, vbss_scene_hole *hole)
{
    for (uint32_t i = 0; vbss_scene_get_hole(s->scene, i, hole, sizeof *hole) == VBSS_OK; i++) {
        if (hole->id == id) {
            return true;
        }
    }
    return false;
}

static vbss_result keep_puncture(again *a, const stage *s, uint32_t id, double time)
{
    const double axis[3] = {1.0, 0.0, 0.0}, centre[3] = {0.0, 0.0, 0.0}; /* in the drain's frame */
    vbss_drain_places places;
    vbss_view rest;
    vbss_scene_hole hole;
    double best = HUGE_VAL;
    if (!find_hole(s, id, &hole)) {
        return VBSS_OK;
    }
    if (!facts_room((void **)&a->punctures, &a->puncture_room, a->puncture_count,
                    sizeof *a->punctures)) {
        return VBSS_ERROR_OUT_OF_MEMORY;
    }
    TRY(vbss_drain_get_places(s->drain, &places, sizeof places));
    TRY(vbss_drain_get_view(s->drain, VBSS_DRAIN_VIEW_REST_POSITIONS, &rest, sizeof rest));
    puncture *p = &a->punctures[a->puncture_count++];
    *p = (puncture){.id = id, .step = a->count, .time = time, .tube = s->tube};
    memcpy(p->force, hole.force, sizeof p->force);
    for (int mark = 0; mark < 2; mark++) {
        double angle, axial;
        const double *at = (const double *)rest.data + 3 * (size_t)places.marks[mark];
        TRY(vbss_metrics_get_offset(axis, centre, at, hole.rest_position, &angle, &axial));
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

static void take_back(again *a, uint32_t id, double time)
{
    for (size_t i = 0; i < a->puncture_count; i++) {
        if (a->punctures[i].id == id) {
            a->punctures[i].withdrawn = true;
            a->punctures[i].withdrawn_time = time;
        }
    }
}

/* Those of the step that was made last. */
static vbss_result observe_events(again *a, const stage *s, double time)
{
    for (uint32_t i = 0; s->rig != NULL && i < s->rig->event_count; i++) {
        const vbss_scene_event *e = &s->rig->events[i];
        if (e->kind == VBSS_SCENE_EVENT_PUNCTURE && s->drain != NULL) {
            TRY(keep_puncture(a, s, e->id, time));
        } else if (e->kind == VBSS_SCENE_EVENT_WITHDRAWN) {
            take_back(a, e->id, time);
        }
    }
    return VBSS_OK;
}

static bool says_the_same(const reading *a, const reading *b)
{
    return a->state.verdict == b->state.verdict && a->state.name == b->state.name &&
           a->state.throw_count == b->state.throw_count && a->state.faults == b->state.faults;
}

static void debounce_hitch(again *a, reading *r)
{
    const uint32_t fault = VBSS_KNOT_FAULT_HITCH, flag = VBSS_KNOT_THROW_HITCH;
    bool hitch = (r->state.faults & fault) != 0;
    if (hitch != a->hitch_candidate) {
        a->hitch_candidate = hitch;
        a->hitch_since = r->time;
    }
    a->hitch = r->time - a->hitch_since >= HITCH_DWELL ? hitch : a->hitch;
    r->state.faults = (r->state.faults & ~fault) | (a->hitch ? fault : 0);
    for (uint32_t i = 0; i < MAX_THROWS && !a->hitch; i++) {
        r->throws[i].flags &= ~flag;
    }
}

/* Kept when it says something else than before, and the last one always. */
static vbss_result read_knot(again *a, stage *s, bool last)
{
    reading r = {.time = a->time, .step = a->count};
    TRY(stage_judge(s, &r));
    debounce_hitch(a, &r);
    if (!last && a->reading_count > 0 && says_the_same(&a->readings[a->reading_count - 1], &r)) {
        return VBSS_OK;
    }
    if (!facts_room((void **)&a->readings, &a->reading_room, a->reading_count,
                    sizeof *a->readings)) {
        return VBSS_ERROR_OUT_OF_MEMORY;
    }
    a->readings[a->reading_count++] = r;
    return VBSS_OK;
}

/* ---- a session, from its first step to its last */

vbss_result facts_observe_begin(facts *f, stage *s)
{
    again *a = &f->again;
    a->name = s->name;
    a->needle = s->needle;
    a->drain = s->drain != NULL;
    a->knots = s->rig != NULL;
    a->session.there = a->session.agrees = s->tasked != NULL;
    return a->watch != NULL ? a->watch(a->user, s, 0, 0.0) : VBSS_OK;
}

vbss_result facts_observe(facts *f, stage *s, double time, double cpu_time)
{
    again *a = &f->again;
    if (!facts_room((void **)&a->steps, &a->step_room, (size_t)a->count, sizeof *a->steps)) {
        return VBSS_ERROR_OUT_OF_MEMORY;
    }
    again_step *here = &a->steps[a->count];
    memset(here, 0, sizeof *here);
    TRY(feel(f, s, here));
    TRY(measure_slit(s, here));
    TRY(vbss_scene_get_statistics(s->scene, &a->scene, sizeof a->scene));
    here->contacts = a->scene.contacts;
    here->cpu_time = cpu_time;
    a->count++;
    a->time = time;
    TRY(observe_events(a, s, time));
    TRY(a->watch != NULL ? a->watch(a->user, s, a->count, time) : VBSS_OK);
    return a->knots && a->count % JUDGED_EVERY == 0 ? read_knot(a, s, false) : VBSS_OK;
}

vbss_result facts_observe_end(facts *f, stage *s)
{
    again *a = &f->again;
    const bool read =
        !a->knots || (a->reading_count > 0 && a->readings[a->reading_count - 1].step == a->count);
    return read ? VBSS_OK : read_knot(a, s, true);
}

/* What it told and measured; the tools must be those of the page. */
static vbss_result observe_exercise(followed *t, const stage *s)
{
    const uint32_t room = sizeof t->measures / sizeof t->measures[0];
    TRY(vbss_session_get_exercise(s->task.session, &t->exercise, sizeof t->exercise));
    for (uint32_t i = 0; i < t->exercise.measure_count && i < room; i++) {
        TRY(vbss_session_get_measure(s->task.session, i, &t->measures[i], sizeof t->measures[i]));
        t->measure_count = i + 1;
    }
    return VBSS_OK;
}

vbss_result facts_observe_session(facts *f, stage *s)
{
    followed *t = &f->again.session;
    if (s->task.session == NULL || f->again.count == 0) {
        return VBSS_OK;
    }
    TRY(vbss_session_get_status(s->task.session, &t->status, sizeof t->status));
    TRY(observe_exercise(t, s));
    for (uint64_t i = t->status.first_event; i < t->status.event_count; i++) {
        if (!facts_room((void **)&t->events, &t->room, t->count, sizeof *t->events)) {
            return VBSS_ERROR_OUT_OF_MEMORY;
        }
        TRY(vbss_session_get_event(s->task.session, i, &t->events[t->count], sizeof *t->events));
        t->count++;
    }
    if (f->tools[LEFT] != stitch_hand(s->tasked, SITE_LEFT)->body ||
        f->tools[RIGHT] != stitch_hand(s->tasked, SITE_RIGHT)->body) {
        return VBSS_OK;
    }
    t->measured = true;
    TRY(vbss_metrics_config_init(&f->measured.config, sizeof f->measured.config));
    TRY(vbss_metrics_finish(s->task.metrics));
    return facts_take(f, s->task.metrics);
}

bool facts_are_of_exercise(const facts *f)
{
    return f->again.session.exercise.exercise != VBSS_SESSION_EXERCISE_NONE;
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
