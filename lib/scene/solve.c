/* Bodies and contacts, one system: linearised until threads have their lengths.
 *
 *   assemble bodies -> condense -> states of the contacts -> all increments -> trial state -> rows
 *
 * Where drains have moved, it looks once more at the forces, with the factor that it has. */
#include "scene/attempt.h"
#include "scene/rows.h"
#include "scene/scene.h"
#include "scene/step.h"

/* What misses the law of contact by less is none; and what may be left where states cycle, after some tries:
 * contact_active_set_options tells the units. */
#define FORCE_SHARE 1e-3
#define LEAST_FORCE 1e-7
#define SLACK 1e-4
#define PATIENCE 6u
#define LOOSE_SHARE 0.05
#define LOOSE_OVERLAP 0.02
/* So many linearisations follow when no more work may be done, with a solve each: lengths come before contacts. */
enum { LAST = 4 };
/* Lengths that are missed by more than this share, and not by half as much as before, will not be found in time. */
#define ASTRAY 0.1
/* Of a linearisation, in products of blocks; and of a further look. */
enum { COST_OF_NODE = 60, COST_OF_ROW = 60, COST_OF_TRIANGLE = 40, COST_OF_LOOK = 12 };
/* Rows keep the normals with which the part began, which is right where things slide by little. Where what has
 * slid far is too near, it goes on with new ones, so often. */
enum { TURNS = 3 };
/* Where a needle in a hole turns farther in a linearisation, rad, another follows, so often, and then the part is halved: its
 * stiff rows would store what a straight way misses of the arc as energy that nobody has put in, and throw the needle. */
#define TURNS_FAR 0.05
enum { TURNINGS = 4 };
/* Numbers beyond this are no motion. */
#define TOO_FAR 1e100

/* ---- one linearisation */

/* What is new in an assembly: all; all but the matrix of drains; right-hand sides, and what else is set is not looked at. */
typedef enum news { NEWS_ALL, NEWS_BUT_DRAINS, NEWS_FORCES } news;

static void clear(scene_object *s, bool but_drains)
{
    for (uint32_t i = 0; i < s->place_count; i++) {
        if (s->bodies[i].kind == BODY_DRAIN) {
            vbss_system_reuse_factor(s->system, s->bodies[i].drain.first_block, but_drains);
        }
    }
    vbss_system_clear(s->system);
}

static void assemble(scene_object *s, const scene_part *part, news what)
{
    const vbss_rigid_substep p = {part->step, part->begin, part->end};
    vbss_system *system = s->system;
    if (what != NEWS_FORCES) {
        clear(s, what == NEWS_BUT_DRAINS);
    }
    for (uint32_t i = 0; i < s->place_count; i++) {
        scene_body *b = &s->bodies[i];
        if (b->kind == BODY_THREAD) {
            VBSS_WIDE_CALL(system->wide, vbss_thread_assemble, b->thread.thread, &b->thread.stage,
                           system, b->thread.first_block);
        } else if (b->kind == BODY_RIGID && b->rigid.kind != VBSS_RIGID_DRIVEN) {
            vbss_rigid_assemble(&b->rigid.body, &p, &b->rigid.predicted, &b->rigid.trial, system,
                                &b->rigid.blocks);
        } else if (b->kind == BODY_DRAIN && what != NEWS_ALL) {
            vbss_drain_assemble_rhs(b->drain.drain, &b->drain.stage, system, b->drain.first_block);
        } else if (b->kind == BODY_DRAIN) {
            vbss_drain_assemble(b->drain.drain, &b->drain.stage, system, b->drain.first_block);
        }
    }
}

/* A short end that is bent carries less compression than a straight thread: if a pivot says so, the stiffness takes in
 * none. False: it takes in none already. */
static bool leave_compression_out(scene_object *s)
{
    bool some = false;
    for (uint32_t i = 0; i < s->place_count; i++) {
        scene_thread *b = &s->bodies[i].thread;
        if (s->bodies[i].kind == BODY_THREAD && b->stage.min_tension < 0.0) {
            b->stage.min_tension = 0.0;
            b->thread->statistics.softened++;
            some = true;
        }
    }
    return some;
}

static uint32_t cost(const scene_object *s, uint32_t on_triangle)
{
    uint32_t sum = COST_OF_NODE * s->node_count + COST_OF_ROW * s->contacts->count;
    for (uint32_t i = 0; i < s->place_count; i++) {
        if (s->bodies[i].kind == BODY_DRAIN) {
            sum += on_triangle * s->bodies[i].drain.drain->mesh.triangle_count;
        }
    }
    return sum;
}

uint32_t vbss_scene_linearisation_cost(const scene_object *s)
{
    return cost(s, COST_OF_TRIANGLE);
}

/* What is left but for a further linearisation and a solve, which is half as much. */
static uint64_t limit_search(const scene_object *s)
{
    uint64_t further = (uint64_t)vbss_scene_linearisation_cost(s) * 3 / 2;
    return s->most_work == 0 ? 0 : further < s->most_work ? s->most_work - further : 1;
}

/* States of the contacts and increments of everything, for what is condensed. */
static scene_verdict find_states(scene_object *s)
{
    scene_shape *at = &s->shape;
    const contact_active_set_options search = {.system = s->system,
                                               .welds = s->welds,
                                               .weld_count = s->weld_count,
                                               .max_solves = s->config.state_limit,
                                               .relative_force_tolerance = FORCE_SHARE,
                                               .absolute_force_tolerance = LEAST_FORCE,
                                               .overlap_tolerance = SLACK,
                                               .max_stalled_solves = PATIENCE,
                                               .loose_force_tolerance = LOOSE_SHARE,
                                               .loose_overlap_tolerance = LOOSE_OVERLAP,
                                               .operation_limit = at->most_work,
                                               .starts_from_current =
                                                   at->goes_on && s->most_work > 0,
                                               .is_resumed = at->waits};
    contact_outcome found = vbss_contact_solve_active_set(s->contacts, &search);
    at->waits = found == CONTACT_SUSPENDED;
    if (found == CONTACT_SUSPENDED) {
        return VERDICT_WAITS;
    }
    if (found == CONTACT_SINGULAR) {
        return VERDICT_SINGULAR;
    }
    for (uint32_t i = 0; i < s->weld_count; i++) {
        s->system->solution[s->welds[i].node] =
            vbss_contact_weld_increment(&s->welds[i], s->system);
    }
    vbss_system_back_substitute(s->system);
    return found == CONTACT_NOT_CONVERGED ? VERDICT_STATES : VERDICT_ACCEPTED;
}

/* Where no more work may be done drains keep their matrix from the linearisation before, in which they have moved by little: of
 * their equations the search solves the forces anew. */
static scene_verdict linearise(scene_object *s, const scene_part *part)
{
    scene_shape *at = &s->shape;
    news what = at->last > 0 ? NEWS_BUT_DRAINS : NEWS_ALL;
    at->most_work = limit_search(s);
    at->goes_on = at->linearisations > 0;
    vbss_scene_spend(s, cost(s, at->last > 0 ? COST_OF_LOOK : COST_OF_TRIANGLE));
    assemble(s, part, what);
    vbss_scene_set_weld_arms(s);
    s->statistics.linearisations++;
    while (!vbss_system_condense(s->system)) {
        if (!leave_compression_out(s)) {
            return VERDICT_SINGULAR;
        }
        assemble(s, part, what);
        vbss_scene_set_weld_arms(s);
    }
    return VERDICT_ACCEPTED;
}

/* ---- the trial state moves on */

static void advance_rigid(scene_object *s, scene_rigid *r)
{
    if (r->kind != VBSS_RIGID_DRIVEN) {
        vbss_rigid_apply_increment(&r->trial, s->system->solution[r->blocks.first],
                                   s->system->solution[r->blocks.first + 1]);
        for (uint32_t c = 0; c < r->capsule_count; c++) {
            vbss_scene_place_trial(&s->capsules[r->first_capsule + c], r->trial);
        }
    }
}

static void place_welded_nodes(scene_object *s)
{
    for (uint32_t i = 0; i < s->config.pin_capacity; i++) {
        const scene_pin *p = &s->pins[i];
        if (p->id != 0 && p->attachment == 0) {
            thread_object *t = vbss_scene_body(s, p->thread)->thread.thread;
            const scene_rigid *r = &vbss_scene_body(s, p->body)->rigid;
            t->trial[p->node] = pose_apply(r->trial, p->point);
        }
    }
}

static void advance(scene_object *s)
{
    scene_shape *e = &s->shape;
    e->finite = e->converged = true;
    e->stretch = 0.0;
    for (uint32_t i = 0; i < s->place_count; i++) {
        scene_body *b = &s->bodies[i];
        if (b->kind == BODY_THREAD) {
            b->thread.left = vbss_thread_apply_increment(
                b->thread.thread, &b->thread.stage, s->system->solution + b->thread.first_block);
        } else if (b->kind == BODY_RIGID) {
            advance_rigid(s, &b->rigid);
        } else if (b->kind == BODY_DRAIN) {
            vbss_drain_apply_increment(b->drain.drain, s->system, b->drain.first_block);
        }
    }
    place_welded_nodes(s);
    for (uint32_t i = 0; i < s->place_count; i++) {
        scene_body *b = &s->bodies[i];
        if (b->kind != BODY_THREAD) {
            continue;
        }
        thread_object *t = b->thread.thread;
        vbss_thread_compute_strains(t, t->trial, t->strains);
        double stretch = vbss_thread_record_stretch(t, t->trial_tension), far = b->thread.left;
        bool near = b->thread.near;
        /* What contact holds is not free to go where the estimate says, nor is it worth so much. */
        bool shape = near || far <= t->config.position_tolerance;
        double tolerance = near ? s->config.stretch_tolerance : t->config.stretch_tolerance;
        e->finite = e->finite && stretch < TOO_FAR;
        e->converged = e->converged && shape && stretch <= tolerance;
        e->stretch = vbss_max_or_nan(stretch, e->stretch);
    }
}

/* ---- how far drains go */

typedef struct drain_moves {
    bool finite, look, too_far; /* worth a further look; halves of the part */
} drain_moves;

static drain_moves note_moves(scene_object *s)
{
    drain_moves m = {true, false, false};
    for (uint32_t i = 0; i < s->place_count; i++) {
        scene_drain *b = &s->bodies[i].drain;
        if (s->bodies[i].kind == BODY_DRAIN) {
            const vbss_drain_config *c = &b->drain->config;
            b->moved = vbss_drain_largest_increment(b->drain, s->system, b->first_block);
            b->drain->statistics.linearisations++;
            m.finite = m.finite && b->moved < TOO_FAR;
            m.look = m.look || b->moved > c->position_tolerance;
            m.too_far = m.too_far || b->moved > DRAIN_MAX_MOVE_RATIO * c->move_limit;
        }
    }
    return m;
}

/* A needle in a hole. */
static bool turns_far(const scene_object *s)
{
    for (uint32_t i = 0; i < s->config.hole_capacity; i++) {
        const suture_hole *hole = &s->holes[i];
        const scene_body *b = hole->id != 0 ? vbss_scene_body(s, hole->needle) : NULL;
        if (b != NULL && vec3_norm(s->system->solution[b->rigid.blocks.first + 1]) > TURNS_FAR) {
            return true;
        }
    }
    return false;
}

static void count_forced(scene_object *s)
{
    for (uint32_t i = 0; i < s->place_count; i++) {
        scene_drain *b = &s->bodies[i].drain;
        if (s->bodies[i].kind == BODY_DRAIN) {
            b->drain->statistics.forced +=
                b->moved > DRAIN_MAX_MOVE_RATIO * b->drain->config.move_limit;
        }
    }
}

/* Whether what the further look found is to be believed: of all drains, and of threads, which its old factor may send
 * anywhere when their segments have turned. */
static bool is_believed(scene_object *s)
{
    bool all = true;
    for (uint32_t i = 0; i < s->place_count; i++) {
        scene_drain *b = &s->bodies[i].drain;
        if (s->bodies[i].kind == BODY_THREAD) {
            const scene_thread *a = &s->bodies[i].thread;
            double missed =
                vbss_thread_linearisation_error(a->thread, s->system->solution + a->first_block);
            all = all && missed <= s->config.stretch_tolerance;
        }
        if (s->bodies[i].kind == BODY_DRAIN) {
            double correction = vbss_drain_largest_increment(b->drain, s->system, b->first_block);
            bool small = correction < DRAIN_MAX_CORRECTION_RATIO * b->moved ||
                         correction <= b->drain->config.position_tolerance;
            b->drain->statistics.last_correction = correction;
            b->drain->statistics.corrections_dropped += !small;
            all = all && small;
        }
    }
    return all;
}

/* Whether one of them has gone so far that one more linearisation follows. */
static bool goes_far(const scene_object *s)
{
    for (uint32_t i = 0; i < s->place_count; i++) {
        const scene_drain *b = &s->bodies[i].drain;
        if (s->bodies[i].kind == BODY_DRAIN && b->moved > b->drain->config.move_limit) {
            return true;
        }
    }
    return false;
}

/* Forces of where a linearisation has led to, to be solved for with its factor. */
static void begin_look(scene_object *s, const scene_part *part)
{
    s->shape.most_work = limit_search(s);
    s->shape.goes_on = s->shape.looked = true;
    vbss_scene_spend(s, cost(s, COST_OF_LOOK));
    vbss_contact_save_solution(s->contacts);
    assemble(s, part, NEWS_FORCES);
    vbss_scene_set_weld_arms(s);
    vbss_system_condense_rhs(s->system);
}

/* What is not believed is left. */
static scene_verdict end_look(scene_object *s, scene_verdict found)
{
    if (found != VERDICT_ACCEPTED || !is_believed(s)) {
        vbss_contact_restore_solution(s->contacts);
        return VERDICT_ACCEPTED;
    }
    advance(s);
    vbss_scene_refresh_rows(s);
    return s->shape.finite ? VERDICT_ACCEPTED : VERDICT_SINGULAR;
}

/* ---- the shape */

/* Only where no more than a last search may follow, and not in the smallest part, which must be found. */
static bool is_astray(const scene_object *s, const scene_part *part, double before)
{
    double stretch = s->shape.stretch;
    bool ends = s->most_work > 0 && s->contacts->counters.operations >= limit_search(s);
    return ends && !part->smallest && stretch > ASTRAY && stretch > 0.5 * before;
}

/* The trial state goes where a search has led to; and whether a further look shall follow. */
static scene_verdict move_on(scene_object *s, const scene_part *part, bool *looks)
{
    scene_shape *at = &s->shape;
    drain_moves moves = note_moves(s);
    double before = at->stretch;
    bool turns = turns_far(s);
    advance(s);
    if (!at->finite || !moves.finite) {
        return VERDICT_SINGULAR;
    }
    vbss_scene_refresh_rows(s);
    bool unsettled = moves.too_far || (turns && at->turnings == TURNINGS);
    if ((unsettled && !part->smallest) || is_astray(s, part, before)) {
        return VERDICT_STRETCH;
    }
    if (!vbss_scene_may_yet_believe(s, part)) {
        return VERDICT_STATES;
    }
    if (turns && at->turnings < TURNINGS) {
        at->converged = false;
        at->turnings++;
    }
    *looks = at->converged && moves.look && !at->looked;
    return VERDICT_ACCEPTED;
}

/* One linearisation with its searches; or what is left of it. */
static scene_verdict make_linearisation(scene_object *s, const scene_part *part)
{
    scene_shape *at = &s->shape;
    scene_verdict verdict;
    if (at->phase == SHAPE_LINEARISES) {
        if (vbss_contact_must_suspend(s->contacts, vbss_scene_linearisation_cost(s))) {
            return VERDICT_WAITS;
        }
        verdict = linearise(s, part);
        if (verdict != VERDICT_ACCEPTED) {
            return verdict;
        }
        at->phase = SHAPE_SEARCHES;
    }
    if (at->phase == SHAPE_SEARCHES) {
        bool looks = false;
        verdict = find_states(s);
        verdict = verdict == VERDICT_ACCEPTED ? move_on(s, part, &looks) : verdict;
        if (verdict != VERDICT_ACCEPTED) {
            return verdict;
        }
        if (looks) {
            begin_look(s, part);
            at->phase = SHAPE_LOOKS;
        }
    }
    if (at->phase == SHAPE_LOOKS) {
        verdict = find_states(s);
        verdict = verdict == VERDICT_WAITS ? verdict : end_look(s, verdict);
        if (verdict != VERDICT_ACCEPTED) {
            return verdict;
        }
    }
    if (at->converged && goes_far(s) && !at->went_on) { /* one more, with a further look */
        at->converged = at->looked = false;
        at->went_on = true;
    }
    at->phase = SHAPE_LINEARISES;
    at->linearisations++;
    at->last += vbss_scene_is_spent(s);
    return VERDICT_ACCEPTED;
}

static void begin_shape(scene_shape *at)
{
    at->phase = SHAPE_LINEARISES;
    at->turnings = at->last = 0;
    at->waits = at->looked = at->went_on = at->converged = false;
    at->stretch = (double)INFINITY;
}

/* Linearises until threads have their lengths. */
static scene_verdict find_shape(scene_object *s, const scene_part *part)
{
    scene_shape *at = &s->shape;
    while (at->linearisations < s->config.linearisation_limit && !at->converged &&
           at->last < LAST) {
        scene_verdict verdict = make_linearisation(s, part);
        if (verdict != VERDICT_ACCEPTED) {
            return verdict;
        }
    }
    count_forced(s);
    if (!vbss_scene_believes(s, part)) {
        return VERDICT_STATES;
    }
    bool found = at->converged || at->stretch <= s->config.stretch_tolerance;
    return found ? VERDICT_ACCEPTED : VERDICT_STRETCH;
}

static scene_verdict find_shapes(scene_object *s, const scene_part *part)
{
    scene_shape *at = &s->shape;
    for (;;) {
        scene_verdict verdict = find_shape(s, part);
        if (verdict != VERDICT_ACCEPTED) {
            s->turned = verdict != VERDICT_WAITS && at->normals > 0;
            return verdict;
        }
        bool shallow = vbss_contact_penetration_is_allowed(s->contacts);
        vbss_scene_measure_gaps(s);
        if (vbss_contact_penetration_is_allowed(s->contacts)) {
            return VERDICT_ACCEPTED;
        }
        if (at->normals == (part->straight ? 0u : (uint32_t)TURNS) || vbss_scene_is_spent(s) ||
            at->linearisations >= s->config.linearisation_limit) {
            /* The next part pushes apart what has slid so far; and counts as recovering. */
            s->turned = !part->straight;
            return shallow && part->straight ? VERDICT_ACCEPTED : VERDICT_DEPTH;
        }
        vbss_scene_lay_rows_again(s);
        at->normals++;
        begin_shape(at);
    }
}

scene_verdict vbss_scene_solve(scene_object *s, const scene_part *part)
{
    s->shape.linearisations = s->shape.normals = 0;
    s->turned = false;
    for (uint32_t i = 0; i < s->place_count; i++) {
        if (s->bodies[i].kind == BODY_THREAD &&
            s->bodies[i].thread.thread->config.rest_curvature > 0.0) {
            vbss_thread_update_rest_curvature_forces(s->bodies[i].thread.thread);
        }
    }
    begin_shape(&s->shape);
    return find_shapes(s, part);
}

scene_verdict vbss_scene_solve_on(scene_object *s, const scene_part *part)
{
    for (uint32_t i = 0; i < s->place_count; i++) {
        if (s->bodies[i].kind == BODY_THREAD) { /* views measure there, too */
            thread_object *t = s->bodies[i].thread.thread;
            vbss_thread_compute_strains(t, t->trial, t->strains);
        }
    }
    return find_shapes(s, part);
}
