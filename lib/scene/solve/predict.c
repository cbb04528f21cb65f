/* Prediction: trial state and integration scheme that a substep starts from. */
#include "scene/contacts/contacts.h"
#include "scene/solve/solve.h"
#include "scene/tuning.h"
#include "scene/world/world.h"
#include "thread/tuning.h"

#include <string.h>

static bool needs_damping(const scene_thread *b, double h)
{
    const thread_object *t = b->thread;
    double previous_h = t->previous_h;
    /* Accelerations of a substep of very different length would gain energy. */
    bool has_h_changed = previous_h > 0.0 && !(h < THREAD_MAX_LENGTH_RATIO * previous_h &&
                                               previous_h < THREAD_MAX_LENGTH_RATIO * h);
    return t->is_acceleration_unknown || t->damped_steps_left > 0 || b->has_contacts ||
           b->is_welded || b->contact_free_steps < SCENE_DAMPED_STEPS_AFTER_CONTACT ||
           has_h_changed;
}

static void predict_thread(scene_thread *b, const scene_substep *substep)
{
    thread_object *t = b->thread;
    thread_substep *inputs = &b->substep;
    *inputs = (thread_substep){.integration = &b->integration,
                               .step_length = substep->step_length,
                               .end_fraction = substep->end_fraction};
    b->is_damped = needs_damping(b, substep->h);
    if (!b->is_damped) {
        b->integration = vbss_integration_generalised_alpha(substep->h, t->config.spectral_radius);
        b->is_damped = !vbss_thread_predict(t, inputs);
    }
    if (b->is_damped) {
        b->integration = vbss_integration_backward_euler(substep->h);
        (void)vbss_thread_predict(t, inputs);
    }
    /* A thread in contact starts from the committed state. Gaps are measured there, and a predicted
     * node might already be on the other side. */
    if (b->has_contacts || b->is_welded) {
        vbss_thread_reset_trial(t);
        vbss_thread_compute_strains(t, t->trial, t->strains);
    }
    inputs->buckling_load = vbss_thread_buckling_load(t, b->integration.inertia);
    inputs->min_tension = -THREAD_END_COMPRESSION * inputs->buckling_load;
}

static void predict_rigid(scene_object *s, scene_rigid *r, const scene_substep *substep)
{
    const vbss_rigid_substep p = {substep->step_length, substep->start_fraction,
                                  substep->end_fraction};
    if (r->kind == VBSS_SCENE_RIGID_DRIVEN) {
        r->predicted = vbss_rigid_target_motion(&r->body, &p);
        r->trial = r->predicted.pose;
    } else {
        vbss_rigid_predict(&r->body, &p, &r->predicted);
        r->trial = r->body.now.pose;
    }
    for (uint32_t c = 0; c < r->capsule_count; c++) {
        vbss_scene_transform_trial_capsule(&s->capsules[r->first_capsule + c], r->trial);
    }
}

/* The trial state of a frozen body is where it is, also that of nodes whose motion is prescribed. The
 * same holds for bodies that never move. */
static void hold_body(scene_object *s, scene_body *b)
{
    if (b->kind == SCENE_BODY_THREAD) {
        thread_object *t = b->thread.thread;
        /* Prescribed nodes as well: their trial positions are those of the attempt that failed. */
        memcpy(t->trial, t->now.x, t->node_count * sizeof *t->trial);
        vbss_thread_compute_strains(t, t->trial, t->strains);
    } else if (b->kind == SCENE_BODY_RIGID) {
        scene_rigid *r = &b->rigid;
        r->predicted = r->body.now;
        r->trial = r->body.now.pose;
        for (uint32_t c = 0; c < r->capsule_count; c++) {
            vbss_scene_transform_trial_capsule(&s->capsules[r->first_capsule + c], r->trial);
        }
    } else if (b->kind == SCENE_BODY_DRAIN) {
        vbss_drain_reset_trial(b->drain.drain);
    }
}

void vbss_scene_predict(scene_object *s, const scene_substep *substep)
{
    vbss_scene_choose_rolls(s);
    for (uint32_t i = 0; i < s->body_count; i++) {
        scene_body *b = &s->bodies[i];
        if (b->is_frozen || scene_is_static_mesh(b) || scene_is_plane(b)) {
            hold_body(s, b);
        } else if (b->kind == SCENE_BODY_THREAD) {
            predict_thread(&b->thread, substep);
        } else if (b->kind == SCENE_BODY_RIGID) {
            predict_rigid(s, &b->rigid, substep);
        } else if (b->kind == SCENE_BODY_DRAIN) {
            b->drain.substep = (drain_substep){substep->h, substep->end_fraction};
            b->drain.max_increment = b->drain.drain->statistics.last_correction = 0.0;
            vbss_drain_reset_trial(b->drain.drain);
        }
    }
}
