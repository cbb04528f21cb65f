/* A step of VBLaST-SS (Qi et al. 2017); docs/explanation/paper-scene.md describes it in full.
 *   tool poses -> needles -> threads and drains, each with its own explicit substeps
 *   -> passes of detection and response, until no pair hits -> events -> tool forces
 * Rigid bodies follow their targets, whatever is in the way; needles follow tools or fly. The
 * method has no friction, and no CCD after the responses. */
#include "base/error.h"
#include "baseline/divergence.h"
#include "baseline/drain.h"
#include "baseline/scene.h"
#include "baseline/thread.h"
#include "scene/solve/solve.h"
#include "scene/step/step.h"
#include "scene/tissue/tissue.h"
#include "scene/tools/tools.h"
#include "scene/topology/topology.h"

/* ---- checkpoint and rollback */

static vbss_result keep(scene_object *s)
{
    for (uint32_t i = 0; i < s->body_count; i++) {
        scene_body *b = &s->bodies[i];
        if (b->kind == SCENE_BODY_THREAD) {
            thread_object *t = b->thread.thread;
            VBSS_TRY(vbss_thread_update_derived(t));
            vbss_thread_copy_state(t, &t->saved, &t->now);
            b->thread.checkpoint.statistics = t->statistics;
            t->baseline->saved_statistics = t->baseline->statistics;
        } else if (b->kind == SCENE_BODY_DRAIN) {
            vbss_scene_checkpoint_drain(&b->drain);
            b->drain.drain->statistics.last_move = 0.0;
        }
    }
    vbss_scene_checkpoint_tools(s);
    vbss_scene_checkpoint_pin_targets(s);
    s->checkpoint.statistics = s->report.statistics;
    return VBSS_OK;
}

static void go_back(scene_object *s)
{
    for (uint32_t i = 0; i < s->body_count; i++) {
        if (s->bodies[i].kind == SCENE_BODY_THREAD) {
            thread_object *t = s->bodies[i].thread.thread;
            vbss_thread_copy_state(t, &t->now, &t->saved);
            t->statistics = s->bodies[i].thread.checkpoint.statistics;
            t->baseline->statistics = t->baseline->saved_statistics;
        } else if (s->bodies[i].kind == SCENE_BODY_DRAIN) {
            vbss_scene_rollback_drain(&s->bodies[i].drain);
        }
    }
    vbss_scene_rollback_tools(s);
    vbss_scene_rollback_pin_targets(s);
    s->report.statistics = s->checkpoint.statistics;
    s->baseline->contact_count = 0;
    vbss_scene_clear_logged_events(s);
    s->events.pending_count = s->events.pending_lost = 0;
    s->report.generation++;
}

/* ---- motion without contacts */

/* Sets the axes of the capsules at both ends of the step, for the tests and for the broad phase. */
static vbss_result move_rigid(scene_object *s, const scene_body *b, scene_rigid *r, double h)
{
    const vbss_rigid_substep whole = {h, 0.0, 1.0};
    uint32_t count = 2 * r->capsule_count;
    vec3 *start = s->scratch.vertices, *end = start + count;
    if (r->needle == NULL) { /* needles have their prediction already */
        r->predicted = vbss_rigid_target_motion(&r->body, &whole);
    }
    r->trial = r->predicted.pose;
    for (uint32_t i = 0; i < r->capsule_count; i++) {
        scene_capsule *c = &s->capsules[r->first_capsule + i];
        vbss_scene_transform_capsule(c, r->body.now.pose, c->now);
        vbss_scene_transform_trial_capsule(c, r->trial);
        for (uint32_t k = 0; k < 2; k++) {
            start[2 * i + k] = c->now[k];
            end[2 * i + k] = c->trial[k];
        }
    }
    return vbss_collision_set_motion(scene_collision(s), b->shape, &start->x, &end->x, count);
}

static vbss_result move_bodies(scene_object *s, double h)
{
    for (uint32_t i = 0; i < s->body_count; i++) {
        scene_body *b = &s->bodies[i];
        if (b->kind == SCENE_BODY_THREAD) {
            VBSS_TRY(vbss_baseline_thread_step(b->thread.thread, h));
        } else if (b->kind == SCENE_BODY_RIGID) {
            VBSS_TRY(move_rigid(s, b, &b->rigid, h));
        } else if (b->kind == SCENE_BODY_DRAIN) {
            VBSS_TRY(vbss_baseline_move_drain(b->drain.drain, h));
        }
    }
    return VBSS_OK;
}

/* ---- passes */

static vbss_result check_bodies(const scene_object *s)
{
    for (uint32_t i = 0; i < s->body_count; i++) {
        const scene_body *b = &s->bodies[i];
        if (b->kind == SCENE_BODY_THREAD) {
            VBSS_TRY(vbss_baseline_check_thread(b->thread.thread));
        } else if (b->kind == SCENE_BODY_DRAIN) {
            VBSS_TRY(vbss_baseline_check_drain(b->drain.drain));
        }
    }
    return VBSS_OK;
}

static vbss_result search(scene_object *s)
{
    VBSS_TRY(check_bodies(s));
    return vbss_baseline_find_candidates(s);
}

static vbss_result make_passes(scene_object *s, double h)
{
    baseline_scene_counts *counts = &s->baseline->counts;
    *counts = (baseline_scene_counts){0};
    s->baseline->contact_count = 0;
    while (!counts->has_converged && counts->passes < s->config.baseline->scene_pass_limit) {
        VBSS_TRY(search(s));
        VBSS_TRY(vbss_baseline_run_pass(s, h));
        counts->passes++;
        counts->has_converged = counts->responses == 0;
    }
    if (counts->has_converged) {
        return VBSS_OK;
    }
    return search(s); /* the last pass has moved features next to others */
}

/* ---- the end of the step */

static void finish_motion(scene_object *s, double h)
{
    for (uint32_t i = 0; i < s->body_count; i++) {
        scene_body *b = &s->bodies[i];
        if (b->kind == SCENE_BODY_THREAD) {
            vbss_thread_finish_step(b->thread.thread, h);
        } else if (b->kind == SCENE_BODY_RIGID) {
            b->rigid.body.now = b->rigid.predicted;
            b->rigid.body.target_start = b->rigid.body.target_end;
        } else if (b->kind == SCENE_BODY_DRAIN) {
            vbss_baseline_finish_drain(b->drain.drain);
            vbss_drain_finish_step(b->drain.drain, h);
        }
    }
}

static void note_counts(scene_object *s)
{
    const baseline_scene_counts *counts = &s->baseline->counts;
    vbss_baseline_statistics *own = &s->baseline->statistics;
    own->passes += counts->passes;
    own->tested_pairs += counts->tested_pairs;
    own->unconverged_steps += !counts->has_converged;
    own->last_candidates = s->collision->candidate_count;
}

static void note_errors(scene_object *s, double h)
{
    vbss_scene_statistics *c = &s->report.statistics;
    double stretch = 0.0, depth = vbss_baseline_measure_contacts(s, h);
    for (uint32_t i = 0; i < s->body_count; i++) {
        if (s->bodies[i].kind == SCENE_BODY_THREAD) {
            thread_object *t = s->bodies[i].thread.thread;
            vbss_baseline_record_stretch(t); /* responses have stretched the thread again */
            stretch = vbss_max(t->statistics.last_stretch_error, stretch);
        }
    }
    c->last_stretch_error = stretch;
    c->stretch_error = vbss_max(stretch, c->stretch_error);
    c->last_penetration = depth;
    c->penetration = vbss_max(depth, c->penetration);
    c->loose_stretch += stretch > s->solver.stretch_tolerance;
    c->parts++;
}

/* A hand that leads a coupled body feels the same force as one that drives it. */
static void note_hands(scene_object *s)
{
    for (uint32_t i = 0; i < s->body_count; i++) {
        scene_rigid *r = &s->bodies[i].rigid;
        if (s->bodies[i].kind == SCENE_BODY_RIGID && r->kind == VBSS_SCENE_RIGID_COUPLED) {
            r->coupling_wrench.force = vec3_neg(r->force);
            r->coupling_wrench.torque = vec3_neg(r->torque);
        }
    }
}

static void update_tools(scene_object *s, double h)
{
    vbss_baseline_update_needles(s, h);
    vbss_baseline_update_grasps(s);
    vbss_scene_make_cuts(s);
    vbss_scene_publish_tools(s);
    for (uint32_t i = 0; i < s->body_count; i++) {
        scene_body *b = &s->bodies[i];
        if (b->kind == SCENE_BODY_RIGID && b->rigid.grasper != NULL) {
            b->rigid.grasper->hand_force = vbss_baseline_hand_force(s, b);
        }
    }
}

vbss_result vbss_baseline_scene_step(scene_object *s, double h)
{
    const scene_substep whole = {
        .step_length = h, .start_fraction = 0.0, .end_fraction = 1.0, .h = h};
    VBSS_TRY(keep(s));
    vbss_scene_clear_logged_events(s);
    vbss_scene_record_holes_before_step(s);
    vbss_scene_apply_tool_targets(s, h);
    vbss_baseline_set_carried_targets(s);
    vbss_baseline_set_needle_targets(s, h);
    vbss_scene_set_capsule_trials(s, &whole);
    vbss_result result = move_bodies(s, h);
    if (result == VBSS_OK) {
        result = make_passes(s, h);
    }
    if (result != VBSS_OK) {
        go_back(s);
        return result;
    }
    note_counts(s);
    note_errors(s, h);
    finish_motion(s, h);
    vbss_scene_commit_capsules(s);
    vbss_scene_update_cut_exclusions(s);
    vbss_scene_update_touching_pairs(s);
    vbss_scene_collect_forces(s);
    vbss_scene_locate_touch_events(s);
    note_hands(s);
    vbss_baseline_update_holes(s);
    update_tools(s, h);
    vbss_scene_publish_events(s, 0, h);
    return VBSS_OK;
}
