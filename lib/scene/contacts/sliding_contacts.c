/* Sliding contacts: two threads that slide over each other touch where they cross at the end of the substep.
 *
 * A contact acts on one point of each thread. If both were those that are nearest at the start, they would leave the
 * crossing by the distance d that the threads slide in the substep. On a thread of curvature 1/R the contact force p then
 * has a component p d/R along the thread, which brakes it as if friction were larger by d/R: 0.06 in a tight knot at
 * 20 mm/s and 1 ms. So both points move to the crossing at the end, on to neighbouring segments if necessary. The normal
 * stays, because a thread that slides along itself keeps its shape.
 *
 * The segments follow from the expected motion and stay, because the sparsity depends on them. The points on them are
 * part of the Newton iteration: each linearisation moves them with the trial state, and contains their derivative
 * (vbss_contact_assemble). If they followed from the expected motion alone, a thread that comes to rest would be pushed
 * on by p (d - actual slide)/R, like a mass of p h^2/R, which is thousands of times its own. */
#include "scene/contacts/contacts.h"
#include "scene/tuning.h"
#include "scene/world/world.h"

#include <math.h>

/* A contact point on a thread at the start of the substep. */
typedef struct thread_point {
    const scene_thread *body;
    uint32_t segment;
    double fraction; /* of the segment */
} thread_point;

static thread_point start_point(const scene_object *s, const contact_constraint *constraint,
                                uint32_t which)
{
    const contact_key *key = &constraint->key;
    return (thread_point){&vbss_scene_body(s, which == 0 ? key->body_a : key->body_b)->thread,
                          which == 0 ? key->feature_a : key->feature_b,
                          scene_geometry_of(s, constraint)->start_barycentric[which]};
}

static vec3 segment_vector(const thread_point *p, uint32_t segment)
{
    const vec3 *x = p->body->thread->now.x + segment;
    return vec3_sub(x[1], x[0]);
}

static double segment_length(const thread_point *p, uint32_t segment)
{
    return vec3_norm(segment_vector(p, segment));
}

static vec3 expected_displacement(const scene_object *s, const thread_point *p)
{
    const vec3 *u = s->step.expected_displacements + p->body->first_node + p->segment;
    return vec3_lerp(u[0], u[1], p->fraction);
}

static vec3 trial_displacement(const thread_point *p)
{
    const vec3 *now = p->body->thread->now.x + p->segment,
               *trial = p->body->thread->trial + p->segment;
    return vec3_lerp(vec3_sub(trial[0], now[0]), vec3_sub(trial[1], now[1]), p->fraction);
}

/* How far the crossing moves along thread a and b for a displacement u of a relative to b: slide = gradient . u. The
 * slides solve
 *     u + slide_a tangent_a = slide_b tangent_b
 * by damped least squares. Parallel threads cross nowhere; they get points that are opposite each other. */
static void find_gradients(const thread_point points[2], vec3 gradients[2])
{
    const vec3 a = vec3_unit_or(segment_vector(&points[0], points[0].segment), vec3_zero()),
               b = vec3_unit_or(segment_vector(&points[1], points[1].segment), vec3_zero());
    const double cosine = vec3_dot(a, b), diagonal = 1.0 + SCENE_SLIDE_DAMPING,
                 scale = 1.0 / (diagonal * diagonal - cosine * cosine);
    gradients[0] = vec3_scale(vec3_add_scaled(vec3_scale(b, cosine), -diagonal, a), scale);
    gradients[1] = vec3_scale(vec3_add_scaled(vec3_scale(b, diagonal), -cosine, a), scale);
}

/* Moves a point along its thread, but not beyond the ends. */
static void slide_point(thread_point *p, double distance)
{
    double length = segment_length(p, p->segment), at = p->fraction * length + distance;
    while (at < 0.0 && p->segment > 0) {
        length = segment_length(p, --p->segment);
        at += length;
    }
    while (at > length && p->segment + 2 < p->body->thread->node_count) {
        at -= length;
        length = segment_length(p, ++p->segment);
    }
    p->fraction = length > 0.0 ? vbss_min(vbss_max(at / length, 0.0), 1.0) : 0.0;
}

/* Fraction of `segment` that is at a distance along the thread. Outside the segment its line goes on. */
static double fraction_of(const thread_point *p, double distance, uint32_t segment)
{
    const double length = segment_length(p, segment);
    double at = p->fraction * segment_length(p, p->segment) + distance;
    for (uint32_t k = segment; k < p->segment; k++) {
        at += segment_length(p, k);
    }
    for (uint32_t k = p->segment; k < segment; k++) {
        at -= segment_length(p, k);
    }
    return length > 0.0 ? at / length : 0.0;
}

static double slide_limit(const scene_contact_geometry *geometry)
{
    return SCENE_MAX_SLIDE_RATIO * geometry->contact_distance;
}

static void find_slides(const contact_constraint *constraint, vec3 displacement, double slides[2])
{
    slides[0] = vec3_dot(constraint->slide_gradients[0], displacement);
    slides[1] = vec3_dot(constraint->slide_gradients[1], displacement);
}

static void predict_slide(const scene_object *s, contact_constraint *constraint)
{
    scene_contact_geometry *geometry = scene_geometry_of(s, constraint);
    geometry->start_barycentric[0] = geometry->barycentric[0];
    geometry->start_barycentric[1] = geometry->barycentric[1];
    thread_point points[2] = {start_point(s, constraint, 0), start_point(s, constraint, 1)};
    find_gradients(points, constraint->slide_gradients);
    /* The iteration starts from the state at the start, so the points are ahead of it. */
    find_slides(
        constraint,
        vec3_sub(expected_displacement(s, &points[0]), expected_displacement(s, &points[1])),
        constraint->slide_leads);
    /* A thread that flies does not slide along itself, and its velocity does not tell where it will cross. */
    constraint->is_sliding = fabs(constraint->slide_leads[0]) <= slide_limit(geometry) &&
                             fabs(constraint->slide_leads[1]) <= slide_limit(geometry);
    for (int k = 0; constraint->is_sliding && k < 2; k++) {
        slide_point(&points[k], constraint->slide_leads[k]);
        geometry->segments[k] = points[k].segment;
        geometry->barycentric[k] = points[k].fraction;
    }
}

void vbss_scene_predict_slides(scene_object *s)
{
    for (uint32_t i = 0; i < s->contacts->count; i++) {
        if (s->contacts->constraints[i].key.kind == VBSS_SCENE_CONTACT_SEGMENTS) {
            predict_slide(s, &s->contacts->constraints[i]);
        }
    }
}

void vbss_scene_update_slide(const scene_object *s, contact_constraint *constraint)
{
    scene_contact_geometry *geometry = scene_geometry_of(s, constraint);
    const thread_point points[2] = {start_point(s, constraint, 0), start_point(s, constraint, 1)};
    double slides[2];
    find_gradients(points, constraint->slide_gradients);
    find_slides(constraint,
                vec3_sub(trial_displacement(&points[0]), trial_displacement(&points[1])), slides);
    const double limit = slide_limit(geometry),
                 largest = vbss_max(fabs(slides[0]), fabs(slides[1])),
                 scale = largest > limit ? limit / largest : 1.0;
    for (int k = 0; k < 2; k++) {
        geometry->barycentric[k] =
            fraction_of(&points[k], scale * slides[k], geometry->segments[k]);
        constraint->slide_leads[k] = 0.0;
        if (scale < 1.0) { /* the points stay at the limit */
            constraint->slide_gradients[k] = vec3_zero();
        }
    }
}

void vbss_scene_set_slide_derivatives(contact_constraint *constraint, uint32_t first,
                                      const scene_body *thread, uint32_t segment, bool is_on_side_b)
{
    const vec3 *x = thread->thread.thread->now.x + segment;
    const double length = vec3_norm(vec3_sub(x[1], x[0]));
    if (constraint->jacobian_block_count != first + 2 || !(length > 0.0)) {
        return;
    }
    contact_jacobian_block *blocks = &constraint->jacobian[first];
    blocks[1].weight_derivative = (is_on_side_b ? -1.0 : 1.0) / length;
    blocks[0].weight_derivative = -blocks[1].weight_derivative;
    blocks[0].is_on_side_b = blocks[1].is_on_side_b = is_on_side_b;
}
