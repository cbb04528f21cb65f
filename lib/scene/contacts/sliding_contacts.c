/* Sliding contacts: two threads that slide over each other touch where they cross at the end of the substep.
 *
 * A contact acts on one point of each thread. If both were those that are nearest at the start, they would leave the
 * crossing by the distance d that the threads slide in the substep. On a thread of curvature 1/R the contact force p then
 * has a component p d/R along the thread, which brakes it as if friction were larger by d/R: 0.06 in a tight knot at
 * 20 mm/s and 1 ms. So both points move to where the crossing will be, on to neighbouring segments if
 * necessary. The normal stays, because a thread that slides along itself keeps its shape. */
#include "scene/contacts/contacts.h"
#include "scene/tuning.h"
#include "scene/world/world.h"

#include <math.h>

/* A contact point on a thread at the start of the substep. */
typedef struct thread_point {
    const thread_object *thread;
    uint32_t segment;
    double fraction;   /* of the segment */
    vec3 tangent;      /* unit vector */
    vec3 displacement; /* expected, m */
} thread_point;

static vec3 segment_of(const thread_object *t, uint32_t segment)
{
    return vec3_sub(t->now.x[segment + 1], t->now.x[segment]);
}

static thread_point point_at(const scene_object *s, uint32_t number, uint32_t segment,
                             double fraction)
{
    const scene_body *b = vbss_scene_body(s, number);
    const vec3 *displacements = s->step.expected_displacements + b->thread.first_node + segment;
    return (thread_point){b->thread.thread, segment, fraction,
                          vec3_unit_or(segment_of(b->thread.thread, segment), vec3_zero()),
                          vec3_lerp(displacements[0], displacements[1], fraction)};
}

/* Distances along both threads to the points that cross at the end, m. They solve
 *     displacement_a + slides[0] tangent_a = displacement_b + slides[1] tangent_b
 * by damped least squares. Parallel threads cross nowhere; they get points that are opposite each other. */
static void find_slides(const thread_point *a, const thread_point *b, double slides[2])
{
    const vec3 motion = vec3_sub(b->displacement, a->displacement);
    const double cosine = vec3_dot(a->tangent, b->tangent), diagonal = 1.0 + SCENE_SLIDE_DAMPING,
                 along_a = vec3_dot(a->tangent, motion), along_b = vec3_dot(b->tangent, motion),
                 determinant = diagonal * diagonal - cosine * cosine;
    slides[0] = (diagonal * along_a - cosine * along_b) / determinant;
    slides[1] = (cosine * along_a - diagonal * along_b) / determinant;
}

/* Moves a point along its thread, but not beyond the ends. */
static void slide_point(thread_point *p, double distance)
{
    double length = vec3_norm(segment_of(p->thread, p->segment));
    double at = p->fraction * length + distance;
    while (at < 0.0 && p->segment > 0) {
        length = vec3_norm(segment_of(p->thread, --p->segment));
        at += length;
    }
    while (at > length && p->segment + 2 < p->thread->node_count) {
        at -= length;
        length = vec3_norm(segment_of(p->thread, ++p->segment));
    }
    p->fraction = length > 0.0 ? vbss_min(vbss_max(at / length, 0.0), 1.0) : 0.0;
}

static void slide_contact(const scene_object *s, const contact_constraint *constraint)
{
    const contact_key *key = &constraint->key;
    scene_contact_geometry *geometry = scene_geometry_of(s, constraint);
    thread_point points[2] = {point_at(s, key->body_a, key->feature_a, geometry->barycentric[0]),
                              point_at(s, key->body_b, key->feature_b, geometry->barycentric[1])};
    const double limit = SCENE_MAX_SLIDE_RATIO * geometry->contact_distance;
    double slides[2];
    find_slides(&points[0], &points[1], slides);
    /* A thread that flies does not slide along itself, and its velocity does not tell where it will cross. */
    const bool is_slow = fabs(slides[0]) <= limit && fabs(slides[1]) <= limit;
    for (int k = 0; is_slow && k < 2; k++) {
        if (slides[k] != 0.0) {
            slide_point(&points[k], slides[k]);
            geometry->segments[k] = points[k].segment;
            geometry->barycentric[k] = points[k].fraction;
        }
    }
}

void vbss_scene_slide_contacts(scene_object *s)
{
    for (uint32_t i = 0; i < s->contacts->count; i++) {
        if (s->contacts->constraints[i].key.kind == VBSS_SCENE_CONTACT_SEGMENTS) {
            slide_contact(s, &s->contacts->constraints[i]);
        }
    }
}
