/* Where everything would go, and how: what the part of a step starts from. */
#include "scene/attempt.h"
#include "scene/scene.h"

/* Steps after the last neighbour has gone that are still made by backward Euler, which damps what contact
 * has stirred. */
enum { CALM_STEPS = 3 };

static bool is_damped(const scene_thread *b, double h)
{
    const thread_object *t = b->thread;
    double last = t->previous_h;
    /* Accelerations carried over from a part of quite another length would gain energy. */
    bool another = last > 0.0 && !(h < 2.1 * last && last < 2.1 * h);
    return t->is_acceleration_unknown || t->damped_steps_left > 0 || b->near || b->welded ||
           b->calm < CALM_STEPS || another;
}

static void predict_thread(scene_thread *b, const scene_part *part)
{
    thread_object *t = b->thread;
    thread_substep *stage = &b->stage;
    *stage = (thread_substep){
        .integration = &b->integration, .step_length = part->step, .end_fraction = part->end};
    b->damped = is_damped(b, part->h);
    if (!b->damped) {
        b->integration = vbss_integration_generalised_alpha(part->h, t->config.spectral_radius);
        b->damped = !vbss_thread_predict(t, stage);
    }
    if (b->damped) {
        b->integration = vbss_integration_backward_euler(part->h);
        (void)vbss_thread_predict(t, stage);
    }
    if (b->near ||
        b->welded) { /* gaps are known where the part begins, and what lies behind a gap is not */
        vbss_thread_reset_trial(t);
        vbss_thread_compute_strains(t, t->trial, t->strains);
    }
    stage->buckling_load = vbss_thread_buckling_load(t, b->integration.inertia);
    stage->min_tension = -0.9 * stage->buckling_load;
}

static void predict_rigid(scene_object *s, scene_rigid *r, const scene_part *part)
{
    const vbss_rigid_substep p = {part->step, part->begin, part->end};
    if (r->kind == VBSS_RIGID_DRIVEN) {
        r->predicted = vbss_rigid_target_motion(&r->body, &p);
        r->trial = r->predicted.pose;
    } else {
        vbss_rigid_predict(&r->body, &p, &r->predicted);
        r->trial = r->body.now.pose;
    }
    for (uint32_t c = 0; c < r->capsule_count; c++) {
        vbss_scene_place_trial(&s->capsules[r->first_capsule + c], r->trial);
    }
}

void vbss_scene_predict(scene_object *s, const scene_part *part)
{
    for (uint32_t i = 0; i < s->place_count; i++) {
        scene_body *b = &s->bodies[i];
        if (b->kind == BODY_THREAD) {
            predict_thread(&b->thread, part);
        } else if (b->kind == BODY_RIGID) {
            predict_rigid(s, &b->rigid, part);
        } else if (b->kind == BODY_DRAIN) {
            b->drain.stage = (drain_substep){part->h, part->end};
            b->drain.moved = b->drain.drain->statistics.last_correction = 0.0;
            vbss_drain_reset_trial(b->drain.drain);
        }
    }
}
