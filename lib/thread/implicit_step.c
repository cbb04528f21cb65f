/* Method OURS, one step: predict -> (measure -> assemble -> solve) until good -> commit.
 *
 * The prediction is inertial, so the first linearisation starts close and one is enough while the
 * motion is smooth. Where a motion starts (a new thread, a changed attachment), a very short step of
 * backward Euler finds the accelerations first. A try that does not converge is undone and made again
 * in halves, by backward Euler. */
#include "thread/thread.h"

#include <string.h>

/* The first part of a step in which a motion starts, as a share of it. */
#define FIRST_PART (1.0 / 64.0)
/* A step that needs more linearisations is no smooth motion; the next ones are made by backward Euler,
 * which damps what it cannot resolve. */
enum { SMOOTH_ITERATIONS = 4, SETTLING_STEPS = 2 };
/* Linearisations in which the pull of rest curvature follows the shape. */
enum { REST_PULL_UPDATES = 30 };
/* Strain beyond the tension's that the prediction of a smooth motion does not reach. */
#define SMOOTH_STRAIN 0.03
/* The same for what follows the short first part of a start, whose accelerations hold for that only. */
#define STARTING_STRAIN 1e-3
/* Strain from which a prediction is no start for the iteration. */
#define HOPELESS_STRAIN 0.5
/* More compression than any thread carries. */
#define ALL_OF_THE_COMPRESSION (-1e30)

/* ---- one try */

/* A segment that is turned over at the start of the iteration stays so: a fold that nothing made. */
static bool turns_a_segment_over(const thread_object *t)
{
    const vec3 *x = t->now.x, *y = t->trial;
    for (uint32_t i = 0; i + 1 < t->node_count; i++) {
        if (vec3_dot(vec3_sub(x[i + 1], x[i]), vec3_sub(y[i + 1], y[i])) < 0.0) {
            return true;
        }
    }
    return false;
}

static void start_from_rest(thread_object *t)
{
    for (uint32_t i = 0; i < t->node_count; i++) {
        t->trial[i] = t->held[i] != 0 ? t->trial[i] : t->now.x[i];
    }
}

/* The largest strain of the trial state beyond that of the tensions. */
static double strain_beyond_tension(const thread_object *t)
{
    double largest = 0.0, compliance = 1.0 / t->config.axial_stiffness;
    for (uint32_t i = 0; i + 1 < t->node_count; i++) {
        double strain = t->strains[i].excess * t->inverse_rest[i];
        double beyond = fabs(strain - t->now.tension[i] * compliance);
        largest = vbss_larger(beyond, largest);
    }
    return largest;
}

/* False: this is no smooth motion. A taut thread is let go, an end jerks: accelerations of the past are
 * worth nothing then, and would feed energy. A prediction that is no start at all is replaced by the old
 * positions. */
static bool predict(thread_object *t, thread_stage *stage)
{
    vbss_integration_predict(stage->integration, 3 * (size_t)t->node_count, &t->now.x->x,
                             &t->now.v->x, &t->now.a->x, &t->now.q->x, &t->x_predicted->x,
                             &t->v_predicted->x, &t->a_predicted->x);
    memcpy(t->trial, t->x_predicted, t->node_count * sizeof *t->trial);
    memcpy(t->trial_tension, t->now.tension, t->node_count * sizeof *t->trial_tension);
    for (uint32_t place = 0; place < t->config.attachment_capacity; place++) {
        const thread_attachment *a = &t->attachments[place];
        if (a->id != 0 && t->held[a->node] == place + 1) {
            t->trial[a->node] = vbss_thread_attachment_position(a, stage->part_end);
        }
    }
    vbss_thread_set_clamps(t, stage->part_end);
    vbss_thread_measure(t, t->trial, t->strains);
    double strain = strain_beyond_tension(t);
    bool hopeless = !(strain <= HOPELESS_STRAIN) || turns_a_segment_over(t);
    if (hopeless) {
        start_from_rest(t);
        vbss_thread_measure(t, t->trial, t->strains);
        strain = strain_beyond_tension(t);
        t->statistics.softened++;
    }
    stage->sound_strain = strain + HOPELESS_STRAIN;
    return !hopeless && strain <= (t->last_part == 0.0 ? STARTING_STRAIN : SMOOTH_STRAIN);
}

/* Moves the trial state by the solution. Returns the largest distance that forces left out of balance
 * would move a node: what a further linearisation could change. */
static double advance(thread_object *t, const thread_stage *stage)
{
    const vbss_integration *in = stage->integration;
    const vec3 *u = t->system->solution;
    double largest = 0.0, mobility = 1.0 / (in->inertia * t->config.linear_density);
    for (uint32_t i = 0; i + 1 < t->node_count; i++) {
        const thread_strain *s = &t->strains[i];
        const thread_arc *arc = &t->arcs[i];
        double inverse_rest = t->inverse_rest[i],
               stiffness = t->config.axial_stiffness * inverse_rest;
        vec3 e = vec3_sub(u[i + 1], u[i]);
        double along = vec3_dot(s->tangent, e), longer = along;
        if (arc->share > 0.0) {
            vec3 bent = vec3_zero();
            for (uint32_t a = 0; a < 4; a++) {
                if (arc->factor[a] != 0.0) {
                    bent = vec3_add_scaled(bent, arc->factor[a], u[i + a - 1]);
                }
            }
            longer += 2.0 * arc->share * vec3_dot(s->curvature, bent);
        }
        double tension = stiffness * (s->excess + longer);
        double old = t->trial_tension[i];
        double pull = old > stage->least_pull ? old : stage->least_pull;
        vec3 across = vec3_add_scaled(e, -along, s->tangent);
        double turned = vec3_norm(across) * inverse_rest;
        /* The tension's turn was taken with the old tension, and to first order. */
        double left = turned * (fabs(tension - pull) + 0.5 * fabs(tension) * turned);
        left *= mobility * inverse_rest;
        largest = vbss_larger(left, largest);
        t->trial_tension[i] = tension;
    }
    for (uint32_t i = 0; i < t->node_count; i++) {
        t->trial[i] = vec3_add(t->trial[i], u[i]);
    }
    return largest;
}

typedef enum outcome { CONVERGED, UNCONVERGED, BROKEN } outcome;

static bool solve(thread_object *t, const thread_stage *stage)
{
    vbss_system_clear(t->system);
    VBSS_WIDE_CALL(t->system->wide, vbss_thread_assemble, t, stage, t->system, 0);
    if (!vbss_system_condense(t->system)) {
        return false;
    }
    vbss_system_take_separators(t->system);
    return vbss_system_solve(t->system);
}

/* With all of the compression convergence is quadratic; where the stiffness is not positive then, with
 * what a straight thread carries inside, at a free end (a tenth less, as lengths and bends differ), and
 * with none. */
static double with_less_compression(const thread_stage *stage)
{
    double inside = -1.8 * stage->carried, at_end = -0.9 * stage->carried;
    return stage->least_pull < inside ? inside : stage->least_pull < at_end ? at_end : 0.0;
}

/* What rest curvature pulls in the trial state. Where a thread is nearly straight its direction may flip
 * for ever, so it stays after some linearisations. */
static void update_rest_pull(thread_object *t)
{
    memset(t->rest_pull, 0, t->node_count * sizeof *t->rest_pull);
    vbss_thread_add_rest_curvature(t, t->trial, t->rest_pull);
}

static double largest_increment(const thread_object *t)
{
    double largest = 0.0;
    for (uint32_t i = 0; i < t->node_count; i++) {
        largest = vbss_larger(vec3_norm(t->system->solution[i]), largest);
    }
    return largest;
}

static outcome iterate(thread_object *t, thread_stage *stage)
{
    const bool curved = t->config.rest_curvature > 0.0;
    if (curved) {
        update_rest_pull(t);
    }
    for (uint32_t k = 0; k < t->config.iteration_limit; k++) {
        t->statistics.iterations++;
        t->statistics.last_iterations++;
        while (!solve(t, stage)) {
            if (stage->least_pull == 0.0) {
                return BROKEN;
            }
            stage->least_pull = with_less_compression(stage);
            t->statistics.softened++;
        }
        double left = advance(t, stage);
        if (curved && k < REST_PULL_UPDATES) {
            /* The pull follows the shape late: nothing is known until the shape stands. */
            left = vbss_larger(largest_increment(t), left);
            update_rest_pull(t);
            t->statistics.softened += k + 1 == REST_PULL_UPDATES; /* from now on it stays */
        }
        vbss_thread_measure(t, t->trial, t->strains);
        double error = vbss_thread_note_stretch(t, t->trial_tension);
        if (!(error < 1e100)) {
            return BROKEN;
        }
        if (error <= t->config.stretch_tolerance && left <= t->config.position_tolerance) {
            return CONVERGED;
        }
    }
    return UNCONVERGED;
}

/* Where the last try found nothing sound: all free nodes stop where they are; counted with `forced`.
 * False: not even that is finite. */
static bool stop(thread_object *t)
{
    start_from_rest(t);
    vbss_thread_measure(t, t->trial, t->strains);
    for (uint32_t i = 0; i + 1 < t->node_count; i++) {
        t->trial_tension[i] = t->config.axial_stiffness * t->strains[i].excess * t->inverse_rest[i];
    }
    for (uint32_t i = 0; i < t->node_count; i++) {
        t->x_predicted[i] = t->trial[i];
        t->v_predicted[i] = t->a_predicted[i] = vec3_zero();
    }
    double largest = strain_beyond_tension(t);
    (void)vbss_thread_note_stretch(t, t->trial_tension);
    return largest < 1e100;
}

/* A held node has the speed at which it was taken along. The recursion of the integration would make
 * it ring: it is driven here, not driving. */
static void set_held_motion(thread_object *t, const vbss_integration *in)
{
    for (uint32_t i = 0; i < t->node_count; i++) {
        if (t->held[i] != 0) {
            vec3 speed = vec3_scale(vec3_sub(t->trial[i], t->now.x[i]), 1.0 / in->h);
            vec3 turn = vec3_scale(vec3_sub(speed, t->now.v[i]), 1.0 / in->h);
            vec3 moved = vec3_scale(turn, 1.0 / in->inertia);
            t->x_predicted[i] = vec3_sub(t->trial[i], moved);
            t->v_predicted[i] = vec3_add_scaled(speed, -in->rate, moved);
            t->a_predicted[i] = vec3_add_scaled(turn, -in->follow, moved);
        }
    }
}

static void commit(thread_object *t, const vbss_integration *in)
{
    set_held_motion(t, in);
    memcpy(t->now.x, t->trial, t->node_count * sizeof *t->trial);
    memcpy(t->now.tension, t->trial_tension, t->node_count * sizeof *t->trial_tension);
    vbss_integration_follow(in, 3 * (size_t)t->node_count, &t->trial->x, &t->x_predicted->x,
                            &t->v_predicted->x, &t->a_predicted->x, &t->now.v->x, &t->now.a->x,
                            &t->now.q->x);
    if (t->config.damping > 0.0) {
        /* Implicit in the rate: stable for any of them. */
        double share = t->config.damping * in->h / (1.0 + t->config.damping * in->h);
        vbss_thread_damp_sections(t, share);
    }
    vbss_thread_statistics *s = &t->statistics;
    s->substeps++;
    s->stretch_error =
        s->last_stretch_error > s->stretch_error ? s->last_stretch_error : s->stretch_error;
}

/* ---- the step: parts, which attachments cross evenly */

typedef struct attempt {
    vbss_integration integration;
    bool damped; /* by backward Euler */
    bool sound;  /* not far from where the try started */
    outcome found;
} attempt;

/* The compression under which a straight thread with its inertia as foundation buckles at a free end:
 * sqrt(EI k), k = inertia * linear density; twice that inside. Less where that wave would be shorter
 * than two segments. */
static double carried_load(const thread_object *t, double inertia)
{
    double foundation = inertia * t->config.linear_density, bending = t->config.bending_stiffness;
    double l = t->shortest_rest, shortest_wave = 4.0 / (l * l); /* square of its number */
    double load = sqrt(bending * foundation);
    if (foundation > bending * shortest_wave * shortest_wave) {
        load = 0.5 * (bending * shortest_wave + foundation / shortest_wave);
    }
    return load;
}

static attempt try_part(thread_object *t, double h, double begin, double end)
{
    attempt a;
    double length = h * (end - begin), last = t->last_part;
    /* Accelerations carried over from a step of quite another length would gain energy. */
    bool another = last > 0.0 && !(length < 2.1 * last && last < 2.1 * length);
    thread_stage stage = {&a.integration, h, end, ALL_OF_THE_COMPRESSION, 0.0, 0.0};
    a.damped = t->fresh || t->settling > 0 || another;
    if (!a.damped) {
        a.integration = vbss_integration_generalised_alpha(length, t->config.spectral_radius);
        a.damped = !predict(t, &stage);
        t->settling = a.damped ? SETTLING_STEPS + 1 : 0; /* it was 0 */
    }
    if (a.damped) {
        a.integration = vbss_integration_backward_euler(length);
        (void)predict(t, &stage);
    }
    stage.carried = carried_load(t, a.integration.inertia);
    a.found = iterate(t, &stage);
    a.sound = a.found != BROKEN && strain_beyond_tension(t) <= stage.sound_strain;
    return a;
}

static double smallest_part(const thread_object *t)
{
    double part = 1.0;
    for (uint32_t k = 0; k < t->config.halving_limit; k++) {
        part *= 0.5;
    }
    return part;
}

/* The parts are dyadic, so they sum to 1 exactly. False: no finite state was found. */
static bool make_parts(thread_object *t, double h)
{
    const double smallest = smallest_part(t);
    double begin = 0.0, part = t->fresh ? FIRST_PART : 1.0;
    while (begin < 1.0) {
        double end = begin + part < 1.0 ? begin + part : 1.0;
        bool last_chance = part <= (t->fresh ? FIRST_PART * smallest : smallest);
        attempt a = try_part(t, h, begin, end);
        if (a.found != CONVERGED && !last_chance) {
            t->statistics.rejections++;
            t->settling = SETTLING_STEPS + 1;
            part *= 0.5;
            continue;
        }
        if (a.found != CONVERGED) {
            t->statistics.forced++;
            if (!a.sound && !stop(t)) {
                if (begin > 0.0) {
                    vbss_thread_copy_motion(t, &t->now, &t->kept);
                }
                return false;
            }
        }
        if (begin == 0.0 && end < 1.0) {
            vbss_thread_copy_motion(t, &t->kept, &t->now);
        }
        commit(t, &a.integration);
        t->statistics.first_order += a.damped;
        part = t->fresh ? 1.0 : part;
        t->last_part = t->fresh ? 0.0 : a.integration.h; /* a start says nothing of lengths */
        t->fresh = false;
        begin = end;
    }
    return true;
}

vbss_result vbss_thread_implicit_step(thread_object *t, double h)
{
    const vbss_thread_statistics before = t->statistics;
    const bool fresh = t->fresh;
    const uint32_t settling = t->settling;
    const double last_part = t->last_part;
    t->statistics.last_iterations = 0;
    if (!make_parts(t, h)) {
        t->statistics = before;
        t->fresh = fresh;
        t->settling = settling;
        t->last_part = last_part;
        return vbss_fail(t->context, VBSS_ERROR_NOT_FINITE,
                         "thread step: no finite state after step %llu",
                         (unsigned long long)before.steps);
    }
    t->settling -= t->settling > 0;
    if (t->statistics.last_iterations > SMOOTH_ITERATIONS && t->settling < SETTLING_STEPS) {
        t->settling = SETTLING_STEPS;
    }
    return VBSS_OK;
}
