/* The last resort: when no attempt is accepted, as much of the trial state as does no harm is taken.
 *
 * Everything moves the same share of its way, tools as well: so nothing is torn, and the path is a prefix of
 * one that the guard has looked at. What was fast is slow afterwards. Counted, with the share lost. */
#include "scene/scene.h"

/* Of the way to the first hit; and of the velocity that is left. */
#define SAFE_SHARE 0.9
#define VELOCITY_LEFT 0.1
/* A trial state that is longer than this is no state to go to. */
#define UNSOUND_STRETCH 0.05

static double sound_share(scene_object *s, scene_verdict verdict)
{
    double stretch = 0.0;
    for (uint32_t i = 0; i < s->place_count; i++) {
        if (s->bodies[i].kind == BODY_THREAD) {
            const thread_object *t = s->bodies[i].thread.thread;
            stretch = vbss_larger(vbss_thread_strain_beyond_tension(t), stretch);
        }
    }
    if (verdict == VERDICT_SINGULAR || !(stretch <= UNSOUND_STRETCH)) {
        return 0.0;
    }
    if (verdict != VERDICT_GUARD && vbss_scene_guard(s) == VERDICT_SINGULAR) {
        return 0.0;
    }
    return s->earliest < 1.0 ? SAFE_SHARE * s->earliest : 1.0;
}

static void take_thread(scene_thread *b, double share, double h)
{
    thread_object *t = b->thread;
    double speed = VELOCITY_LEFT * share / h;
    for (uint32_t i = 0; i < t->node_count; i++) {
        vec3 way = vec3_sub(t->trial[i], t->now.x[i]);
        way = share > 0.0 ? way : vec3_zero(); /* of no state at all: not even finite */
        t->now.x[i] = vec3_add_scaled(t->now.x[i], share, way);
        t->now.v[i] = vec3_scale(way, speed);
        t->now.a[i] = t->now.q[i] = vec3_zero();
        t->trial[i] = t->now.x[i];
    }
    vbss_thread_measure(t, t->now.x, t->strains);
    for (uint32_t i = 0; i + 1 < t->node_count; i++) {
        t->now.tension[i] = t->config.axial_stiffness * t->strains[i].excess * t->inverse_rest[i];
    }
    (void)vbss_thread_note_stretch(t, t->now.tension);
    t->fresh = true;
    t->statistics.substeps++;
    t->statistics.forced++;
}

static void take_rigid(scene_object *s, scene_rigid *r, double share, double h)
{
    vbss_rigid_motion *now = &r->body.now;
    vec3 way = vec3_sub(r->trial.position, now->at.position);
    vec3 turn = vbss_quat_to_rotation_vector(
        quat_mul(r->trial.orientation, quat_conjugate(now->at.orientation)));
    if (share == 0.0) {
        way = turn = vec3_zero();
    }
    now->at.position = vec3_add_scaled(now->at.position, share, way);
    now->at.orientation = quat_unit(
        quat_mul(vbss_quat_from_rotation_vector(vec3_scale(turn, share)), now->at.orientation));
    now->v = vec3_scale(way, VELOCITY_LEFT * share / h);
    now->w = vec3_scale(turn, VELOCITY_LEFT * share / h);
    r->trial = now->at;
    for (uint32_t c = 0; c < r->capsule_count; c++) {
        scene_capsule *capsule = &s->capsules[r->first_capsule + c];
        vbss_scene_place_capsule(capsule, r->trial, capsule->trial);
    }
}

double vbss_scene_clamp(scene_object *s, scene_verdict verdict, const scene_part *part)
{
    double share = sound_share(s, verdict);
    for (uint32_t i = 0; i < s->place_count; i++) {
        if (s->bodies[i].kind == BODY_THREAD) {
            take_thread(&s->bodies[i].thread, share, part->h);
        } else if (s->bodies[i].kind == BODY_RIGID) {
            take_rigid(s, &s->bodies[i].rigid, share, part->h);
        }
    }
    s->statistics.parts++;
    s->statistics.clamped++;
    return share;
}
