/* The last resort: when no attempt is accepted, as much of the trial state as does no harm is taken.
 *
 * Everything moves the same share of its way, tools as well: so nothing is torn, and the path is a prefix of
 * one that the guard has looked at. What was fast is slow afterwards. Counted, with the share lost. */
#include "base/rotation.h"
#include "scene/attempt.h"
#include "scene/holes.h"
#include "scene/rows.h"
#include "scene/scene.h"

/* Of the way to the first hit; and of the velocity that is left. */
#define SAFE_SHARE 0.9
#define VELOCITY_LEFT 0.1
/* Halves of the share that are tried before nothing moves at all. */
enum { SHORTENINGS = 4 };
/* A trial state that is longer than this is no state to go to. */
#define UNSOUND_STRETCH 0.05

/* Whether the trial state is one to go to at least in part, and how far. What is stretched less than now is: what was
 * stretched by an earlier cut would stay so for ever. */
static double sound_share(scene_object *s, scene_verdict verdict)
{
    double stretch = 0.0;
    for (uint32_t i = 0; i < s->place_count; i++) {
        const thread_object *t = s->bodies[i].thread.thread;
        if (s->bodies[i].kind == BODY_THREAD && !vbss_thread_max_tension_decreased(t)) {
            stretch = vbss_max_or_nan(vbss_thread_strain_beyond_tension(t), stretch);
        }
    }
    if (verdict == VERDICT_SINGULAR || verdict == VERDICT_FULL || !(stretch <= UNSOUND_STRETCH)) {
        return 0.0;
    }
    scene_verdict seen = vbss_scene_guard(s);
    if (seen != VERDICT_ACCEPTED && seen != VERDICT_GUARD) {
        return 0.0; /* nobody has looked at all of it */
    }
    return s->earliest < 1.0 ? SAFE_SHARE * s->earliest : 1.0;
}

/* ---- the trial state becomes the share of itself */

static void shorten_thread(thread_object *t, double share)
{
    for (uint32_t i = 0; i < t->node_count; i++) {
        /* At 0 it may be no state at all, not even finite. */
        vec3 way = share > 0.0 ? vec3_sub(t->trial[i], t->now.x[i]) : vec3_zero();
        t->trial[i] = vec3_add_scaled(t->now.x[i], share, way);
    }
}

static void shorten_rigid(scene_object *s, scene_rigid *r, double share)
{
    const pose begin = r->body.now.pose, whole = r->trial;
    r->trial = begin;
    if (share > 0.0) {
        vec3 way = vec3_sub(whole.position, begin.position);
        vec3 turn = vbss_quat_to_rotation_vector(
            quat_mul(whole.orientation, quat_conjugate(begin.orientation)));
        r->trial.position = vec3_add_scaled(begin.position, share, way);
        r->trial.orientation = quat_unit(
            quat_mul(vbss_quat_from_rotation_vector(vec3_scale(turn, share)), begin.orientation));
    }
    for (uint32_t c = 0; c < r->capsule_count; c++) {
        scene_capsule *capsule = &s->capsules[r->first_capsule + c];
        for (int k = 0; k < 2; k++) {
            vec3 way = vec3_sub(capsule->local_trial[k], capsule->local[k]);
            capsule->local_trial[k] = vec3_add_scaled(capsule->local[k], share, way);
        }
        vbss_scene_place_trial(capsule, r->trial);
    }
}

/* ---- and the state */

static void take_thread(thread_object *t, double h)
{
    for (uint32_t i = 0; i < t->node_count; i++) {
        vec3 way = vec3_sub(t->trial[i], t->now.x[i]);
        t->now.x[i] = t->trial[i];
        t->now.v[i] = vec3_scale(way, VELOCITY_LEFT / h);
        t->now.a[i] = t->now.q[i] = vec3_zero();
    }
    vbss_thread_compute_strains(t, t->now.x, t->strains);
    for (uint32_t i = 0; i + 1 < t->node_count; i++) {
        t->now.tension[i] =
            t->config.axial_stiffness * t->strains[i].elongation * t->inverse_rest[i];
    }
    (void)vbss_thread_record_stretch(t, t->now.tension);
    t->is_acceleration_unknown = true;
    t->statistics.substeps++;
    t->statistics.forced++;
}

static void take_rigid(scene_rigid *r, double h)
{
    vbss_rigid_motion *now = &r->body.now;
    vec3 way = vec3_sub(r->trial.position, now->pose.position);
    vec3 turn = vbss_quat_to_rotation_vector(
        quat_mul(r->trial.orientation, quat_conjugate(now->pose.orientation)));
    now->pose = r->trial;
    now->v = vec3_scale(way, VELOCITY_LEFT / h);
    now->w = vec3_scale(turn, VELOCITY_LEFT / h);
}

static void take_drain(drain_object *d, double h)
{
    vbss_drain_commit(d, h);
    for (uint32_t i = 0; i < d->mesh.node_count; i++) {
        d->v[i] = vec3_scale(d->v[i], VELOCITY_LEFT);
    }
}

static void shorten(scene_object *s, double share)
{
    for (uint32_t i = 0; i < s->place_count; i++) {
        if (s->bodies[i].kind == BODY_THREAD) {
            shorten_thread(s->bodies[i].thread.thread, share);
        } else if (s->bodies[i].kind == BODY_RIGID) {
            shorten_rigid(s, &s->bodies[i].rigid, share);
        } else if (s->bodies[i].kind == BODY_DRAIN) {
            vbss_scene_shorten_drain(&s->bodies[i].drain, share);
        }
    }
}

/* Bodies that turn do not shorten along the straight ways that the guard has looked at: it looks again. */
static double shorten_safely(scene_object *s, double share)
{
    shorten(s, share);
    for (uint32_t k = 0; k < SHORTENINGS && share > 0.0; k++) {
        if (vbss_scene_guard(s) == VERDICT_ACCEPTED) {
            return share;
        }
        shorten(s, 0.5);
        share *= 0.5;
    }
    shorten(s, 0.0);
    return 0.0;
}

/* Rows say what contact does where things are now, not what the attempt that is thrown away would have done. */
static void settle_rows(scene_object *s)
{
    vbss_scene_lay_rows_again(s);
    s->contacts->is_stopped_early = false; /* nothing of the search is left in them */
    for (uint32_t i = 0; i < s->contacts->count; i++) {
        contact_constraint *row = &s->contacts->constraints[i];
        if (row->is_bilateral) {
            contact_solution now;
            (void)vbss_contact_update_solution(row, vec3_zero(), &now);
            row->solution = now;
            continue;
        }
        double pressure = vbss_max(-row->stiffness * row->gap, 0.0),
               most = row->friction * pressure;
        vec3 rubbing = vbss_contact_rotate_to_tangent_plane(row->previous_force, row->normal);
        double size = vec3_norm(rubbing);
        row->solution = (contact_solution){
            .status = pressure > 0.0 ? CONTACT_STICK : CONTACT_OPEN,
            .normal_force = pressure,
            .tangential_force = size > most ? vec3_scale(rubbing, most / size) : rubbing};
    }
}

void vbss_scene_stay(scene_object *s)
{
    shorten(s, 0.0);
    settle_rows(s);
}

double vbss_scene_clamp(scene_object *s, scene_verdict verdict, const scene_part *part)
{
    const vbss_rigid_substep p = {part->step, part->begin, part->end};
    double share = shorten_safely(s, sound_share(s, verdict));
    vbss_scene_show_part(s);
    settle_rows(s);
    for (uint32_t i = 0; i < s->place_count; i++) {
        if (s->bodies[i].kind == BODY_THREAD) {
            take_thread(s->bodies[i].thread.thread, part->h);
        } else if (s->bodies[i].kind == BODY_RIGID) {
            scene_rigid *r = &s->bodies[i].rigid;
            take_rigid(r, part->h);
            r->pull = vbss_rigid_coupling_wrench(&r->body, &p, &r->body.now);
        } else if (s->bodies[i].kind == BODY_DRAIN) {
            take_drain(s->bodies[i].drain.drain, part->h);
        }
    }
    vbss_scene_commit_capsules(s);
    vbss_scene_move_holes(s);
    s->statistics.parts++;
    s->statistics.clamped++;
    return share;
}
