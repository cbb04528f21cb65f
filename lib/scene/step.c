/* A step of method OURS:
 *   tool poses -> candidates -> predict -> solve -> guard -> events -> tool forces
 * The middle of it is an attempt at a part of the step, the whole of it at first. One that is not accepted is
 * made again, in halves; after the last the step is cut short where it would harm. In real time a call does no more
 * than so much of it, and the next goes on (call.c). */
#include "base/error.h"
#include "scene/attempt.h"
#include "scene/cuts.h"
#include "scene/events.h"
#include "scene/holes.h"
#include "scene/meshes.h"
#include "scene/rows.h"
#include "scene/scene.h"
#include "scene/step.h"
#include "scene/tools.h"

/* ---- work */

/* Of an attempt, in products of blocks. Rows are found and laid as candidates are looked at. */
enum { COST_OF_CANDIDATE = 60, COST_OF_NODE = 20 };

uint32_t vbss_scene_attempt_cost(const scene_object *s)
{
    return COST_OF_CANDIDATE * s->collision->candidate_count + COST_OF_NODE * s->node_count;
}

static double smallest_part(const scene_object *s)
{
    double part = 1.0;
    for (uint32_t k = 0; k < s->config.halving_limit; k++) {
        part *= 0.5;
    }
    return part;
}

/* What takes too much work as the smallest part is halved further, so many times: what snaps over takes a hundred solves in a 32nd of a
 * millisecond, and few in a 256th. Not without walls, where each part may give 1 mJ (believe.c): a knot that is cut flew apart with 38
 * m/s, where 5 N let go of give 30. */
#define LEAST_OF_SMALLEST 0.125

bool vbss_scene_is_part(const scene_object *s, double size)
{
    double part = 1.0, least = LEAST_OF_SMALLEST * smallest_part(s);
    while (part > least && part != size) {
        part *= 0.5;
    }
    return part == size;
}

void vbss_scene_spend(scene_object *s, uint32_t work)
{
    s->contacts->counters.operations += work;
}

bool vbss_scene_is_spent(const scene_object *s)
{
    return s->most_work > 0 && s->contacts->counters.operations >= s->most_work;
}

/* The first step of a scene is not: what a host has laid out may overlap. */
bool vbss_scene_is_limited(const scene_object *s)
{
    return s->config.mode == VBSS_MODE_REAL_TIME && s->config.work_limit > 0 &&
           s->statistics.steps > 0;
}

/* The least part is finished whatever it takes, or nothing might ever move again; where states cycle, what a search has led
 * to by a limit of its own must do. */
static void limit_work(scene_object *s, const scene_part *part, bool least)
{
    uint64_t before = part->stops ? s->contacts->counters.operations : 0;
    bool limited = vbss_scene_is_limited(s) && (part->stops || !least);
    s->most_work = limited ? before + s->config.work_limit : 0;
}

static void note_work(scene_object *s)
{
    vbss_scene_statistics *c = &s->statistics;
    uint64_t work = s->contacts->counters.operations;
    c->operations += work;
    c->most_operations = work > c->most_operations ? work : c->most_operations;
}

/* ---- an attempt */

/* Share of what is allowed by which a part may go deeper that begins too deep, or is about to be: a load may need a
 * hair more, and on the way out too. */
#define DEEPER 0.1

static void allow_depth(scene_object *s)
{
    s->recovering = false;
    for (uint32_t i = 0; i < s->contacts->count; i++) {
        contact_constraint *row = &s->contacts->constraints[i];
        double share = s->config.penetration_tolerance * row->thickness;
        row->allowed_penetration = vbss_max(share, DEEPER * share - row->start_gap);
        s->recovering = s->recovering || row->fold_allowance - row->start_gap > share;
    }
}

static scene_verdict begin_attempt(scene_object *s, const scene_part *part)
{
    s->statistics.attempts++;
    s->taken = false;
    if (!vbss_scene_find_rows(s, part)) {
        return VERDICT_FULL;
    }
    vbss_scene_spend(s, vbss_scene_attempt_cost(s));
    vbss_scene_predict(s, part);
    vbss_scene_number_blocks(s);
    vbss_scene_set_rows(s, part);
    vbss_scene_recall_rows(s, part);
    allow_depth(s);
    if (vbss_scene_build_pattern(s) != VBSS_OK) {
        return VERDICT_FULL;
    }
    s->contacts->call_budget.has_progress = true;
    return vbss_scene_solve(s, part);
}

static scene_verdict attempt(scene_object *s)
{
    scene_way *at = &s->way;
    scene_verdict verdict =
        at->at_hand ? vbss_scene_solve_on(s, &at->part) : begin_attempt(s, &at->part);
    at->attempted = at->at_hand = verdict == VERDICT_WAITS;
    at->passed = s->contacts->call_budget.checks_passed;
    return verdict == VERDICT_ACCEPTED ? vbss_scene_guard(s) : verdict;
}

static void count(scene_object *s, scene_verdict verdict)
{
    vbss_scene_statistics *c = &s->statistics;
    c->rejected_states += verdict == VERDICT_STATES;
    c->rejected_stretch += verdict == VERDICT_STRETCH;
    c->rejected_depth += verdict == VERDICT_DEPTH;
    c->rejected_guard += verdict == VERDICT_GUARD;
    c->rejected_singular += verdict == VERDICT_SINGULAR;
    c->rejected_full += verdict == VERDICT_FULL;
}

/* ---- parts */

static void note_errors(scene_object *s)
{
    double stretch = 0.0, depth = 0.0;
    for (uint32_t i = 0; i < s->place_count; i++) {
        if (s->bodies[i].kind == BODY_THREAD) {
            const thread_object *t = s->bodies[i].thread.thread;
            stretch = vbss_max(t->statistics.last_stretch_error, stretch);
        }
    }
    depth = vbss_contact_max_penetration(s->contacts);
    s->statistics.last_stretch_error = stretch;
    s->statistics.stretch_error = vbss_max(stretch, s->statistics.stretch_error);
    s->statistics.last_penetration = depth;
    s->statistics.penetration = vbss_max(depth, s->statistics.penetration);
    s->statistics.loose_stretch += stretch > s->config.stretch_tolerance;
    s->statistics.last_residual = s->contacts->residual;
}

/* Whether no more may be begun in the step: there is no room for it. */
static bool is_over(const scene_object *s, const scene_way *at)
{
    uint64_t another = vbss_scene_attempt_cost(s) + vbss_scene_linearisation_cost(s);
    bool spent = s->contacts->counters.operations + another >= s->config.work_limit;
    return vbss_scene_is_limited(s) && (at->attempts >= s->config.attempt_limit || spent);
}

/* Whether the part is to be tried again: with the ways that are known now, or in halves. */
static bool try_again(scene_object *s, scene_way *at, scene_verdict verdict)
{
    bool bounded = s->config.mode == VBSS_MODE_REAL_TIME && s->config.work_limit == 0;
    bool over = bounded && verdict != VERDICT_FULL && at->attempts >= s->config.attempt_limit;
    bool least = at->size <= at->smallest;
    if (verdict == VERDICT_GUARD && !at->part.again && !over) {
        at->part.again = true;
        return true;
    }
    if (verdict == VERDICT_STATES && least && vbss_scene_is_limited(s) && !at->part.stops) {
        at->part.stops = true;
        return true;
    }
    /* What is deep already is no better for being halved. */
    if (s->turned && !at->part.straight && (least || over || s->recovering)) {
        at->part.straight = true;
        return true;
    }
    at->part.again = at->part.straight = at->part.stops = false;
    if (!least && !over) {
        vbss_scene_unsettle(s);
        at->size *= 0.5;
        return true;
    }
    return false;
}

/* What is too much for the rooms, or no state at all, is no better for waiting. */
static bool may_wait(scene_verdict verdict)
{
    return verdict != VERDICT_FULL && verdict != VERDICT_SINGULAR;
}

/* Hands feel how far their tools are left behind. */
static void pull_from_here(scene_object *s, const scene_part *part)
{
    const vbss_rigid_substep p = {part->step, part->begin, 1.0};
    for (uint32_t i = 0; i < s->place_count; i++) {
        scene_rigid *r = &s->bodies[i].rigid;
        if (s->bodies[i].kind == BODY_RIGID) {
            r->pull = vbss_rigid_coupling_wrench(&r->body, &p, &r->body.now);
        }
    }
}

/* The rest of the step is left out: everything rests where it is, and goes on in the next step, in parts of the
 * size at first. */
static void pause_for_now(scene_object *s, const scene_way *at, double size)
{
    double left = 1.0 - at->part.begin;
    vbss_scene_add_event(s, VBSS_EVENT_CLAMPED, 0, 0, (uint32_t)(65536.0 * left));
    s->statistics.paused++;
    s->statistics.time_paused += left * at->part.step;
    s->pace = size;
    s->lagging = true;
    pull_from_here(s, &at->part);
}

/* Whether a part that failed may be tried in the next step; and of which size. The smallest is halved further only for the work it took, and
 * if it was there for all of it. */
static bool waits(const scene_object *s, const scene_way *at, double *size)
{
    bool small = at->size <= at->smallest;
    bool worked = s->contacts->is_stopped_early || vbss_scene_is_spent(s);
    *size = small && at->size < at->begun ? at->size : 0.5 * at->size;
    return is_over(s, at) && (!small || (worked && at->size > at->least));
}

static void cut_short(scene_object *s, scene_way *at, scene_verdict verdict)
{
    double lost = 1.0 - vbss_scene_clamp(s, verdict, &at->part);
    double share = lost * (at->part.end - at->part.begin);
    vbss_scene_add_event(s, VBSS_EVENT_CLAMPED, 0, 0, (uint32_t)(65536.0 * share));
    vbss_scene_unsettle(s);
    s->lagging = true;
}

static void go_on(scene_object *s, scene_way *at)
{
    note_errors(s);
    at->part.again = at->part.straight = at->part.stops = false;
    at->part.begin = at->part.end;
    double pairs = at->part.begin / (2.0 * at->size);
    if (at->size < 1.0 && floor(pairs) == pairs) {
        at->size *= 2.0;
    }
}

static void aim(scene_object *s)
{
    scene_way *at = &s->way;
    at->part.end = at->part.begin + at->size;
    at->part.h = at->part.step * at->size;
    at->part.smallest = at->size <= at->smallest;
    limit_work(s, &at->part, at->size <= at->least);
}

/* An attempt begins, or goes on. */
static scene_verdict take_up(scene_object *s)
{
    scene_way *at = &s->way;
    contact_call_budget *slot = &s->contacts->call_budget;
    if (!at->attempted) {
        aim(s);
        at->before = s->contacts->counters.operations;
        slot->checks_passed = 0;
    }
    /* With the ways of the attempt before it nobody else could make it once more. */
    const uint64_t end = slot->operation_limit;
    slot->operation_limit = at->part.again ? 0 : end;
    scene_verdict verdict = attempt(s);
    slot->operation_limit = end;
    return verdict;
}

/* Makes an attempt once more that waits and is not at hand: nothing of it is in a saved state but how far it was. */
static void make_again(scene_object *s)
{
    scene_way *at = &s->way;
    contact_call_budget *slot = &s->contacts->call_budget;
    const contact_counters counters = s->contacts->counters;
    s->contacts->counters.operations = at->before;
    aim(s);
    *slot = (contact_call_budget){
        .operation_limit = slot->operation_limit, .is_replay = true, .replay_checks = at->passed};
    (void)attempt(s);
    slot->is_replay = slot->has_progress = false;
    s->contacts->counters = counters;
    vbss_scene_return_statistics(s);
}

static void accept(scene_object *s)
{
    vbss_scene_commit(s, &s->way.part);
    s->statistics.recovering += s->recovering;
    s->lagging = false;
    s->taken = true;
}

/* What is left of the step waits where the slot has no room for another attempt. */
static bool is_for_later(const scene_object *s)
{
    const contact_call_budget *slot = &s->contacts->call_budget;
    uint64_t work = s->contacts->counters.operations + vbss_scene_attempt_cost(s);
    return !s->way.attempted && !s->way.part.again && slot->operation_limit > 0 &&
           slot->has_progress && work > slot->operation_limit;
}

vbss_result vbss_scene_go_through(scene_object *s)
{
    scene_way *at = &s->way;
    scene_part *part = &at->part;
    if (at->attempted && !at->at_hand) {
        make_again(s);
    }
    at->waits = true;
    while (part->begin < 1.0) {
        if (is_for_later(s)) {
            return VBSS_OK;
        }
        scene_verdict verdict = take_up(s);
        if (verdict == VERDICT_WAITS) {
            return VBSS_OK;
        }
        at->attempts++;
        if (verdict == VERDICT_ACCEPTED) {
            accept(s);
        } else {
            double next;
            count(s, verdict);
            if (waits(s, at, &next) && may_wait(verdict)) {
                vbss_scene_unsettle(s);
                vbss_scene_stay(s);
                pause_for_now(s, at, next);
                break;
            }
            if (try_again(s, at, verdict)) {
                continue;
            }
            if (verdict == VERDICT_FULL) { /* nothing is known of what would be met */
                return vbss_fail(
                    s->context, VBSS_ERROR_CAPACITY,
                    "scene step: more is near than candidate_capacity %u or contact_capacity %u",
                    s->config.candidate_capacity, s->config.contact_capacity);
            }
            cut_short(s, at, verdict);
        }
        go_on(s, at);
        if (part->begin < 1.0 && is_over(s, at)) {
            pause_for_now(s, at, vbss_min(2.0 * at->size, 1.0)); /* this one did */
            break;
        }
    }
    at->waits = false;
    return VBSS_OK;
}

void vbss_scene_give_up(scene_object *s)
{
    scene_way *at = &s->way;
    if (!at->attempted) { /* between two parts: rows are those of the next, as no saved state has any */
        at->before = at->work;
        at->passed = 0;
    }
    if (!at->at_hand) {
        make_again(s);
    }
    vbss_scene_unsettle(s);
    vbss_scene_stay(s);
    pause_for_now(s, at, at->size);
    at->waits = at->attempted = at->at_hand = false;
}

/* ---- the step */

void vbss_scene_take_parts(scene_object *s)
{
    s->way.smallest = smallest_part(s);
    s->way.least =
        vbss_scene_has(s, BODY_DRAIN) ? LEAST_OF_SMALLEST * s->way.smallest : s->way.smallest;
}

void vbss_scene_begin_step(scene_object *s, double h)
{
    scene_way *at = &s->way;
    at->part = (scene_part){.step = h};
    at->begun = at->size = s->pace;
    vbss_scene_take_parts(s);
    at->attempts = 0;
    s->pace = 1.0;
    vbss_scene_note_holes(s);
    vbss_scene_take_told(s);
    for (uint32_t i = 0; i < s->place_count; i++) {
        scene_body *b = &s->bodies[i];
        if (b->kind == BODY_THREAD) {
            b->thread.thread->statistics.last_iterations = 0;
        } else if (b->kind == BODY_DRAIN) {
            b->drain.drain->statistics.last_move = 0.0;
        }
    }
    vbss_scene_take_tools(s, h);
    s->lagging = false;
    s->contacts->counters.operations = 0;
}

static void arrive(scene_object *s, double h)
{
    for (uint32_t i = 0; i < s->place_count; i++) {
        scene_body *b = &s->bodies[i];
        if (b->kind == BODY_THREAD) {
            thread_object *t = b->thread.thread;
            vbss_thread_finish_step(t, h);
            t->damped_steps_left -= t->damped_steps_left > 0;
            b->thread.calm = b->thread.near ? 0 : b->thread.calm + (b->thread.calm < 16);
            for (uint32_t k = 0; s->lagging && k < t->config.attachment_capacity; k++) {
                thread_attachment *a = &t->attachments[k];
                if (a->id != 0 && vbss_thread_prescribes_motion(a->kind)) {
                    a->position = t->now.x[a->node]; /* held back; it goes on from here */
                }
            }
        } else if (b->kind == BODY_RIGID) {
            scene_rigid *r = &b->rigid;
            r->body.target_start =
                r->kind == VBSS_RIGID_DRIVEN && s->lagging ? r->body.now.pose : r->body.target_end;
        }
    }
}

void vbss_scene_finish_step(scene_object *s)
{
    const double h = s->way.part.step;
    arrive(s, h);
    vbss_scene_arrive_drains(s, h);
    vbss_scene_part_pieces(s);
    vbss_scene_note_touches(s);
    vbss_scene_note_forces(s);
    vbss_scene_settle_holes(s);
    vbss_scene_settle_tools(s, h);
    vbss_scene_adapt_meshes(s);
    vbss_scene_leave_short_threads(s);
    note_work(s);
    s->statistics.rows = s->contacts->count;
    s->statistics.state_solves = s->contacts->counters.solves;
    s->statistics.loose_states = s->contacts->counters.inexact;
    s->statistics.separators = s->system->unknown_count - s->system->interior_count;
}
