#include "scene/stitch_case.h"

#include "drain/drain.h"
#include "fixtures/solver_of.h"
#include "scene/solve/solve.h"
#include "thread/thread.h"

/* Below this no gain is looked at, J. */
#define MIN_GAIN 1e-6
/* Bodies of a test. */
enum { BODIES = 24 };

/* ---- what holes give */

/* What it does to both, and what it stores more. */
static double given_by(const scene_object *s, const contact_constraint *row, vec3 force)
{
    const suture_hole *hole = &s->holes[row->key.feature_a];
    double before =
        hole->friction_force * hole->friction_force + vec3_norm_squared(hole->transverse_force);
    double given = 0.5 * (vec3_norm_squared(force) - before) / row->stiffness;
    for (uint32_t k = 0; k < row->jacobian_block_count; k++) {
        const contact_jacobian_block *term = &row->jacobian[k];
        vec3 displacement; /* the needle's holes are not looked at */
        if (vbss_scene_find_block_displacement(s, term->block, &displacement) != SCENE_BODY_NONE) {
            given += term->weight * vec3_dot(force, displacement);
        }
    }
    return given;
}

/* Of a part, before it is the state. */
static void see_holes(void *watcher, const scene_object *s)
{
    stitch_case *c = watcher;
    for (uint32_t i = 0; i < s->contacts->count; i++) {
        const contact_constraint *row = &s->contacts->constraints[i];
        if (row->is_sleeve) {
            vec3 found = vec3_add_scaled(row->solution.tangential_force, row->solution.normal_force,
                                         row->normal);
            bool followed = s->config.mode == VBSS_SCENE_MODE_REAL_TIME;
            c->giving += given_by(s, row, followed ? s->contacts->current[i].force : found);
        }
    }
}

/* ---- life */

void stitch_case_begin(stitch_case *c)
{
    memset(c, 0, sizeof *c);
    small_begin(&c->s);
    expect_ok(stitch_scene_init(&c->options));
    c->options.scene.contact_capacity = 4096;
    c->options.scene.candidate_capacity = 65536;
    set_call_operations(&c->options.scene,
                        0); /* work of hands and energy are reckoned step by step */
    c->options.thread.cut_capacity = 2;
    c->h = 1e-3;
}

void stitch_case_make(stitch_case *c)
{
    expect_ok(stitch_scene_create(c->s.context, &c->options, &c->stitch));
    c->s.scene = c->stitch.scene;
    for (int k = 0; k < 2; k++) {
        stitch_case_hand *hand = &c->hands[k];
        hand->thread = c->stitch.thread;
        hand->id = c->stitch.hands[k];
        hand->at = hand->to = c->stitch.at[k];
    }
    stitch_case_reckon(c);
    small_object(&c->s)->on_substep = see_holes;
    small_object(&c->s)->on_substep_data = c;
}

void stitch_case_open(stitch_case *c, uint32_t crossings)
{
    stitch_case_begin(c);
    c->options.crossings = crossings;
    stitch_case_make(c);
}

void stitch_case_end(stitch_case *c)
{
    small_end(&c->s);
}

/* ---- hands */

void stitch_case_target(stitch_case *c, int hand, vec3 to)
{
    double target[3];
    vec3_store(target, to);
    c->hands[hand].to = to;
    expect_ok(
        vbss_thread_set_attachment_target(c->hands[hand].thread, c->hands[hand].id, target, NULL));
}

void stitch_case_shift(stitch_case *c, int hand, vec3 displacement)
{
    stitch_case_target(c, hand, vec3_add(c->hands[hand].to, displacement));
}

void stitch_case_drop(stitch_case *c, int hand)
{
    expect_ok(vbss_thread_detach(c->hands[hand].thread, c->hands[hand].id));
    c->hands[hand].thread = NULL;
}

bool stitch_case_take(stitch_case *c, int hand, uint32_t body, uint32_t node)
{
    stitch_case_hand *own = &c->hands[hand];
    vbss_thread_attachment a;
    expect_ok(vbss_thread_attachment_init(&a, sizeof a));
    a.node = node;
    own->thread = stitch_watch_thread(c->s.scene, body);
    own->at = own->to = small_node(own->thread, node);
    vec3_store(a.position, own->at);
    if (vbss_thread_attach(own->thread, &a, &own->id) != VBSS_OK) {
        own->thread = NULL;
        return false;
    }
    return true;
}

uint32_t stitch_case_cut(stitch_case *c, uint32_t body, double arc)
{
    uint32_t piece = 0;
    if (vbss_scene_cut_thread(c->s.scene, body, arc, &piece) != VBSS_OK) {
        return 0;
    }
    for (int k = 0; k < 2; k++) {
        stitch_case_hand *hand = &c->hands[k];
        vbss_thread_reaction r;
        bool goes = hand->thread == stitch_watch_thread(c->s.scene, body) && hand->thread != NULL &&
                    vbss_thread_get_reaction(hand->thread, hand->id, &r, sizeof r) != VBSS_OK;
        hand->thread = goes ? stitch_watch_thread(c->s.scene, piece) : hand->thread;
    }
    return piece;
}

/* ---- looks */

static const thread_object *thread_of(const stitch_case *c, uint32_t body)
{
    thread_object *t = NULL;
    vbss_thread *thread = stitch_watch_thread(c->s.scene, body);
    return thread != NULL && vbss_thread_open(thread, &t) == VBSS_OK ? t : NULL;
}

uint32_t stitch_case_nodes(const stitch_case *c, uint32_t body)
{
    const thread_object *t = thread_of(c, body);
    return t == NULL ? 0 : t->node_count;
}

double stitch_case_length(const stitch_case *c, uint32_t body)
{
    const thread_object *t = thread_of(c, body);
    assert_non_null(t);
    return vbss_thread_arc_length(t, t->node_count - 1);
}

vec3 stitch_case_node(const stitch_case *c, uint32_t body, uint32_t node)
{
    return small_node(stitch_watch_thread(c->s.scene, body), node);
}

double stitch_case_fastest(const stitch_case *c)
{
    double fastest = 0.0;
    for (uint32_t body = 1; body < BODIES; body++) {
        const thread_object *t = thread_of(c, body);
        for (uint32_t i = 0; t != NULL && i < t->node_count; i++) {
            fastest = vbss_max_or_nan(vec3_norm(t->now.v[i]), fastest);
        }
    }
    return fastest;
}

bool stitch_case_hole(const stitch_case *c, int side, vbss_scene_hole *hole)
{
    return stitch_scene_hole(&c->stitch, side, hole);
}

/* ---- the ledger */

/* Springs of contacts and of holes. */
static double energy_of_contacts(const stitch_case *c)
{
    double energy = 0.0;
    vbss_scene_hole holes[STITCH_WATCH_HOLES];
    vbss_view forces = small_view(&c->s, VBSS_SCENE_VIEW_CONTACT_FORCES);
    vbss_view names = small_view(&c->s, VBSS_SCENE_VIEW_CONTACTS);
    for (uint64_t i = 0; i < forces.count; i++) {
        const uint32_t kind = ((const uint32_t *)names.data)[5 * i];
        double square = vec3_norm_squared(((const vec3 *)forces.data)[i]);
        energy +=
            kind == VBSS_SCENE_CONTACT_HOLE ? 0.0 : square / c->options.scene.contact_stiffness;
    }
    uint32_t count = stitch_watch_holes(c->s.scene, holes);
    for (uint32_t i = 0; i < count; i++) {
        energy += vec3_norm_squared(vec3_load(holes[i].force)) / c->options.drain.hole_stiffness;
    }
    return 0.5 * energy;
}

double stitch_case_energy(const stitch_case *c)
{
    vbss_drain_energies e = {0};
    double energy = energy_of_contacts(c);
    if (c->stitch.drain != NULL) {
        expect_ok(vbss_drain_get_energies(c->stitch.drain, &e, sizeof e));
    }
    for (uint32_t body = 1; body < BODIES; body++) {
        vbss_thread *thread = stitch_watch_thread(c->s.scene, body);
        if (thread != NULL) {
            energy += small_thread_energy(thread, c->options.thread.axial_stiffness);
        }
    }
    return energy + e.total;
}

void stitch_case_reckon(stitch_case *c)
{
    c->first = stitch_case_energy(c);
    c->work = c->max_work = c->excess = 0.0;
}

/* Reactions are without what presses on the node itself, or on the segments at it: the hand bears some of that too. All of
 * it is more. */
static double work_at(const stitch_case *c, uint32_t body, uint32_t node, vec3 displacement)
{
    double work = 0.0;
    vbss_view forces = small_view(&c->s, VBSS_SCENE_VIEW_CONTACT_FORCES);
    vbss_view names = small_view(&c->s, VBSS_SCENE_VIEW_CONTACTS);
    for (uint64_t i = 0; i < forces.count; i++) {
        const uint32_t *name = (const uint32_t *)names.data + 5 * i;
        double along = vec3_dot(((const vec3 *)forces.data)[i], displacement);
        bool at_a = name[1] == body && name[2] + 2 > node && name[2] < node + 2;
        bool at_b = name[3] == body && name[4] + 2 > node && name[4] < node + 2;
        bool hole = name[0] == VBSS_SCENE_CONTACT_HOLE;
        work += hole ? 0.0 : at_a ? fmax(-along, 0.0) : at_b ? fmax(along, 0.0) : 0.0;
    }
    return work;
}

static uint32_t body_of(const stitch_case *c, const vbss_thread *thread)
{
    uint32_t body = 1;
    while (body < BODIES && stitch_watch_thread(c->s.scene, body) != thread) {
        body++;
    }
    return body;
}

/* Of implicit steps the force at the end counts, which is rather more than less. */
static double work_of_hands(stitch_case *c, double *largest)
{
    double work = 0.0;
    for (int k = 0; k < 2; k++) {
        stitch_case_hand *hand = &c->hands[k];
        vbss_thread_reaction r;
        if (hand->thread == NULL) {
            continue;
        }
        expect_ok(vbss_thread_get_reaction(hand->thread, hand->id, &r, sizeof r));
        vec3 now = small_node(hand->thread, r.node), force = vec3_load(r.force);
        vec3 displacement = vec3_sub(now, hand->at);
        double beside = work_at(c, body_of(c, hand->thread), r.node, displacement);
        work += vec3_dot(force, displacement) + beside;
        *largest +=
            fmax(vec3_norm(force), vec3_norm(hand->force)) * vec3_norm(displacement) + beside;
        hand->force = force;
        hand->at = now;
    }
    return work;
}

/* Where something was left out, contacts in the views are those of what was thrown away. */
static bool was_whole(stitch_case *c)
{
    vbss_scene_statistics s = small_statistics(&c->s);
    bool whole = s.paused + s.clamped == c->broken;
    c->broken = s.paused + s.clamped;
    return whole;
}

static void book(stitch_case *c)
{
    double largest = 0.0, energy = stitch_case_energy(c), *beyond = c->beyond;
    c->work += work_of_hands(c, &largest);
    c->max_work = fmax(c->max_work, fabs(c->work));
    assert_true(isfinite(energy));
    for (int k = 3; k > 0; k--) {
        beyond[k] = beyond[k - 1] + largest;
    }
    beyond[0] = energy;
    c->booked = was_whole(c) ? c->booked + 1 : 0;
    c->given += c->booked > 0 ? c->giving : 0.0;
    c->max_given = fmax(c->max_given, c->given);
    c->giving = 0.0;
    if (c->booked > 0) {
        c->excess = fmax(c->excess, energy - c->first - c->work);
    }
    if (c->booked > 1) {
        c->shown = fmax(c->shown, beyond[0] - beyond[1]);
    }
    if (c->booked > 3) {
        c->jump = fmax(c->jump, fmin(beyond[0], beyond[1]) - fmax(beyond[2], beyond[3]));
    }
}

/* ---- steps */

void stitch_case_step(stitch_case *c)
{
    small_steps(&c->s, 1, c->h);
    c->steps++;
    const step_events events = step_events_of(c->s.scene);
    memset(c->happened, 0, sizeof c->happened);
    for (uint32_t i = 0; i < events.count; i++) {
        const uint32_t kind = (uint32_t)events.of[i].kind;
        assert_true(kind < STITCH_CASE_EVENTS);
        c->happened[kind]++;
        c->counts[kind]++;
    }
    if (c->stitch.drain != NULL) {
        stitch_watch_observe(&c->watch, c->s.scene, c->stitch.drain);
    }
    assert_true(isfinite(stitch_case_fastest(c)));
    book(c);
}

void stitch_case_wait(stitch_case *c, uint32_t steps)
{
    for (uint32_t i = 0; i < steps; i++) {
        stitch_case_step(c);
    }
}

void stitch_case_pull(stitch_case *c, int hand, vec3 displacement, double speed)
{
    uint32_t steps = (uint32_t)ceil(vec3_norm(displacement) / (speed * c->h));
    for (uint32_t i = 0; i < steps; i++) {
        stitch_case_shift(c, hand, vec3_scale(displacement, 1.0 / steps));
        stitch_case_step(c);
    }
}

/* ---- what it was like */

void stitch_case_finish(stitch_case *c, const char *name, double share)
{
    vbss_scene_statistics s = small_statistics(&c->s);
    print_message("%s: %llu steps, %llu parts; rejected %llu states %llu stretch %llu depth %llu "
                  "guard; clamped %llu, "
                  "paused %llu, loose %llu; overlap %.0f um, stretch %.1e (%llu loose); %u "
                  "crossings, %u holes; from hole %.2f, "
                  "from suture %.2f; %llu away, %llu missed; work %.3g mJ, excess %.3g mJ, jump "
                  "%.3g mJ; %.2g m/s\n",
                  name, (unsigned long long)s.steps, (unsigned long long)s.parts,
                  (unsigned long long)s.rejected_states, (unsigned long long)s.rejected_stretch,
                  (unsigned long long)s.rejected_depth, (unsigned long long)s.rejected_guard,
                  (unsigned long long)s.clamped, (unsigned long long)s.paused,
                  (unsigned long long)s.loose_states, 1e6 * s.penetration, s.stretch_error,
                  (unsigned long long)s.loose_stretch, c->watch.crossings, c->watch.holes,
                  c->watch.farthest, c->watch.loosest, (unsigned long long)c->watch.away,
                  (unsigned long long)c->watch.missed, 1e3 * c->max_work, 1e3 * c->excess,
                  1e3 * c->jump, stitch_case_fastest(c));
    assert_int_equal(c->watch.away, 0);
    assert_int_equal(c->watch.missed, 0);
    assert_true(s.stretch_error <= solver_values(&c->options.scene).stretch_tolerance ||
                s.loose_stretch > 0);
    assert_true(c->excess <= share * c->max_work + MIN_GAIN);
    stitch_case_end(c);
}
