/* A step of method OURS:
 *   tool poses -> candidates -> predict -> solve -> guard -> events -> tool forces
 * The middle of it is an attempt at a part of the step, the whole of it at first. One that is not accepted is
 * made again, in halves; after the last the step is cut short where it would harm. */
#include "scene/scene.h"

/* ---- as it was, if the step fails */

static vbss_result keep(scene_object *s)
{
    for (uint32_t i = 0; i < s->place_count; i++) {
        scene_body *b = &s->bodies[i];
        if (b->kind == BODY_THREAD) {
            thread_object *t = b->thread.thread;
            VBSS_TRY(vbss_thread_layout(t));
            vbss_thread_copy_motion(t, &t->kept, &t->now);
            b->thread.kept = t->statistics;
            b->thread.kept_fresh = t->fresh;
            b->thread.kept_settling = t->settling;
            b->thread.kept_part = t->last_part;
            t->statistics.last_iterations = 0;
        } else if (b->kind == BODY_RIGID) {
            b->rigid.kept = b->rigid.body.now;
            b->rigid.kept_pull = b->rigid.pull;
        } else if (b->kind == BODY_DRAIN) {
            vbss_scene_keep_drain(&b->drain);
        }
    }
    vbss_scene_keep_tools(s);
    s->kept = s->statistics;
    s->kept_pace = s->pace;
    vbss_contact_mark(s->contacts);
    return VBSS_OK;
}

static void go_back(scene_object *s)
{
    for (uint32_t i = 0; i < s->place_count; i++) {
        scene_body *b = &s->bodies[i];
        if (b->kind == BODY_THREAD) {
            thread_object *t = b->thread.thread;
            vbss_thread_copy_motion(t, &t->now, &t->kept);
            t->statistics = b->thread.kept;
            t->fresh = b->thread.kept_fresh;
            t->settling = b->thread.kept_settling;
            t->last_part = b->thread.kept_part;
        } else if (b->kind == BODY_RIGID) {
            b->rigid.body.now = b->rigid.kept;
            b->rigid.pull = b->rigid.kept_pull;
        } else if (b->kind == BODY_DRAIN) {
            vbss_scene_return_drain(&b->drain);
        }
    }
    vbss_scene_return_tools(s);
    s->statistics = s->kept;
    s->pace = s->kept_pace;
    vbss_contact_return(s->contacts);
    vbss_scene_begin_events(s);
    s->generation++;
}

/* ---- work */

/* Of an attempt, in products of blocks. Rows are found and laid as candidates are looked at. */
enum { COST_OF_CANDIDATE = 60, COST_OF_NODE = 20 };

static uint32_t cost_of_attempt(const scene_object *s)
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
    s->contacts->counters.work += work;
}

bool vbss_scene_is_spent(const scene_object *s)
{
    return s->most_work > 0 && s->contacts->counters.work >= s->most_work;
}

/* The first step of a scene is not: what a host has laid out may overlap. */
static bool is_limited(const scene_object *s)
{
    return s->config.mode == VBSS_MODE_REAL_TIME && s->config.work_limit > 0 &&
           s->statistics.steps > 0;
}

/* The least part is finished whatever it takes, or nothing might ever move again; where states cycle, what a search has led
 * to by a limit of its own must do. */
static void limit_work(scene_object *s, const scene_part *part, bool least)
{
    uint64_t before = part->stops ? s->contacts->counters.work : 0;
    bool limited = is_limited(s) && (part->stops || !least);
    s->most_work = limited ? before + s->config.work_limit : 0;
}

static void note_work(scene_object *s)
{
    vbss_scene_statistics *c = &s->statistics;
    uint64_t work = s->contacts->counters.work;
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
        contact_row *row = &s->contacts->rows[i];
        double share = s->config.penetration_tolerance * row->thickness;
        row->depth_allowed = greater(share, DEEPER * share - row->gap_before);
        s->recovering = s->recovering || row->eased - row->gap_before > share;
    }
}

static scene_verdict attempt(scene_object *s, const scene_part *part)
{
    s->statistics.attempts++;
    s->taken = false;
    if (!vbss_scene_find_rows(s, part)) {
        return VERDICT_FULL;
    }
    vbss_scene_spend(s, cost_of_attempt(s));
    vbss_scene_predict(s, part);
    vbss_scene_number_blocks(s);
    vbss_scene_set_rows(s, part);
    vbss_scene_recall_rows(s, part);
    allow_depth(s);
    if (vbss_scene_build_pattern(s) != VBSS_OK) {
        return VERDICT_FULL;
    }
    scene_verdict verdict = vbss_scene_solve(s, part);
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
            stretch = greater(t->statistics.last_stretch_error, stretch);
        }
    }
    depth = vbss_contact_depth(s->contacts);
    s->statistics.last_stretch_error = stretch;
    s->statistics.stretch_error = greater(stretch, s->statistics.stretch_error);
    s->statistics.last_penetration = depth;
    s->statistics.penetration = greater(depth, s->statistics.penetration);
    s->statistics.loose_stretch += stretch > s->config.stretch_tolerance;
    s->statistics.last_residual = s->contacts->residual;
}

typedef struct progress {
    scene_part part;
    double begun, size, smallest,
        least; /* shares of the step; dyadic, so that parts sum to 1 exactly */
    uint32_t attempts;
} progress;

/* Whether no more may be begun in the step: there is no room for it. */
static bool is_over(const scene_object *s, const progress *at)
{
    uint64_t another = cost_of_attempt(s) + vbss_scene_linearisation_cost(s);
    bool spent = s->contacts->counters.work + another >= s->config.work_limit;
    return is_limited(s) && (at->attempts >= s->config.attempt_limit || spent);
}

/* Whether the part is to be tried again: with the ways that are known now, or in halves. */
static bool try_again(scene_object *s, progress *at, scene_verdict verdict)
{
    bool bounded = s->config.mode == VBSS_MODE_REAL_TIME && s->config.work_limit == 0;
    bool over = bounded && verdict != VERDICT_FULL && at->attempts >= s->config.attempt_limit;
    bool least = at->size <= at->smallest;
    if (verdict == VERDICT_GUARD && !at->part.again && !over) {
        at->part.again = true;
        return true;
    }
    if (verdict == VERDICT_STATES && least && is_limited(s) && !at->part.stops) {
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
    const vbss_rigid_part p = {part->step, part->begin, 1.0};
    for (uint32_t i = 0; i < s->place_count; i++) {
        scene_rigid *r = &s->bodies[i].rigid;
        if (s->bodies[i].kind == BODY_RIGID) {
            r->pull = vbss_rigid_coupling_pull(&r->body, &p, &r->body.now);
        }
    }
}

/* The rest of the step is left out: everything rests where it is, and goes on in the next step, in parts of the
 * size at first. */
static void pause_for_now(scene_object *s, const progress *at, double size)
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
static bool waits(const scene_object *s, const progress *at, double *size)
{
    bool small = at->size <= at->smallest;
    bool worked = s->contacts->stopped || vbss_scene_is_spent(s);
    *size = small && at->size < at->begun ? at->size : 0.5 * at->size;
    return is_over(s, at) && (!small || (worked && at->size > at->least));
}

static void cut_short(scene_object *s, progress *at, scene_verdict verdict)
{
    double lost = 1.0 - vbss_scene_clamp(s, verdict, &at->part);
    double share = lost * (at->part.end - at->part.begin);
    vbss_scene_add_event(s, VBSS_EVENT_CLAMPED, 0, 0, (uint32_t)(65536.0 * share));
    vbss_scene_unsettle(s);
    s->lagging = true;
}

static void go_on(scene_object *s, progress *at)
{
    note_errors(s);
    at->part.again = at->part.straight = at->part.stops = false;
    at->part.begin = at->part.end;
    double pairs = at->part.begin / (2.0 * at->size);
    if (at->size < 1.0 && floor(pairs) == pairs) {
        at->size *= 2.0;
    }
}

static vbss_result make_parts(scene_object *s, double h)
{
    const double smallest = smallest_part(s);
    const double least = vbss_scene_has(s, BODY_DRAIN) ? LEAST_OF_SMALLEST * smallest : smallest;
    progress at = {.part = {.step = h},
                   .begun = s->pace,
                   .size = s->pace,
                   .smallest = smallest,
                   .least = least};
    scene_part *part = &at.part;
    s->pace = 1.0;
    while (part->begin < 1.0) {
        part->end = part->begin + at.size;
        part->h = h * at.size;
        part->smallest = at.size <= at.smallest;
        limit_work(s, part, at.size <= least);
        scene_verdict verdict = attempt(s, part);
        at.attempts++;
        if (verdict == VERDICT_ACCEPTED) {
            vbss_scene_commit(s, part);
            s->statistics.recovering += s->recovering;
            s->lagging = false;
            s->taken = true;
        } else {
            double next;
            count(s, verdict);
            if (waits(s, &at, &next) && may_wait(verdict)) {
                vbss_scene_unsettle(s);
                vbss_scene_stay(s);
                pause_for_now(s, &at, next);
                break;
            }
            if (try_again(s, &at, verdict)) {
                continue;
            }
            if (verdict == VERDICT_FULL) { /* nothing is known of what would be met */
                return vbss_fail(
                    s->context, VBSS_ERROR_CAPACITY,
                    "scene step: more is near than candidate_capacity %u or contact_capacity %u",
                    s->config.candidate_capacity, s->config.contact_capacity);
            }
            cut_short(s, &at, verdict);
        }
        go_on(s, &at);
        if (part->begin < 1.0 && is_over(s, &at)) {
            pause_for_now(s, &at, lesser(2.0 * at.size, 1.0)); /* this one did */
            break;
        }
    }
    return VBSS_OK;
}

/* ---- the step */

static void arrive(scene_object *s, double h)
{
    for (uint32_t i = 0; i < s->place_count; i++) {
        scene_body *b = &s->bodies[i];
        if (b->kind == BODY_THREAD) {
            thread_object *t = b->thread.thread;
            vbss_thread_finish_step(t, h);
            t->settling -= t->settling > 0;
            b->thread.calm = b->thread.near ? 0 : b->thread.calm + (b->thread.calm < 16);
            for (uint32_t k = 0; s->lagging && k < t->config.attachment_capacity; k++) {
                thread_attachment *a = &t->attachments[k];
                if (a->id != 0 && vbss_thread_holds(a->kind)) {
                    a->position = t->now.x[a->node]; /* held back; it goes on from here */
                }
            }
        } else if (b->kind == BODY_RIGID) {
            scene_rigid *r = &b->rigid;
            r->body.begin =
                r->kind == VBSS_RIGID_DRIVEN && s->lagging ? r->body.now.at : r->body.end;
        }
    }
}

vbss_result vbss_scene_ours_step(scene_object *s, double h)
{
    VBSS_TRY(keep(s));
    vbss_scene_begin_events(s);
    vbss_scene_take_tools(s, h);
    s->lagging = false;
    s->contacts->counters.work = 0;
    vbss_result result = make_parts(s, h);
    if (result != VBSS_OK) {
        go_back(s);
        return result;
    }
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
    s->statistics.loose_states = s->contacts->counters.loose;
    s->statistics.separators = s->system->active_count - s->system->run_count;
    return VBSS_OK;
}
