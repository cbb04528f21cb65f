/* Sliding contacts: where two strands cross at the end of a substep.
 *
 * The force of a contact acts on two points of the strands. While a strand slides over another by a distance d, the
 * points that were nearest at the start of the substep go d beyond the crossing. On a strand of curvature 1/R a force there
 * has a component p d/R along the strand, which brakes it like friction that is larger by d/R. So the
 * contact moves to the points that will be at the crossing at the end, as the expected displacements tell. The
 * normal stays: a strand that slides along itself leaves the shape of the crossing as it is. */
#include "scene/contacts/contacts.h"
#include "scene/tuning.h"
#include "scene/world/world.h"

/* A strand at a contact. */
typedef struct strand {
    const thread_object *thread;
    vec3 tangent, displacement; /* at the contact point */
} strand;

static strand strand_at(const scene_object *s, const scene_body *b, uint32_t segment,
                        double fraction, vec3 normal)
{
    const vec3 *x = b->thread.thread->now.x + segment;
    const vec3 *displacements = s->step.expected_displacements + b->thread.first_node + segment;
    vec3 along = vec3_sub(x[1], x[0]);
    along = vec3_add_scaled(along, -vec3_dot(along, normal), normal);
    return (strand){b->thread.thread, vec3_unit_or(along, vec3_zero()),
                    vec3_lerp(displacements[0], displacements[1], fraction)};
}

/* Distances along both strands from the points at the crossing at the start to those at its end, m. They solve
 *     displacement_a + slide[0] tangent_a = displacement_b + slide[1] tangent_b
 * in the tangent plane by damped least squares: strands that are parallel cross nowhere, and the nearest
 * points of both that are opposite each other in the end serve as well. */
static void find_slides(const strand *a, const strand *b, double slides[2])
{
    vec3 motion = vec3_sub(b->displacement, a->displacement);
    double cosine = vec3_dot(a->tangent, b->tangent), diagonal = 1.0 + SCENE_SLIDE_DAMPING;
    double along_a = vec3_dot(a->tangent, motion), along_b = vec3_dot(b->tangent, motion);
    double determinant = diagonal * diagonal - cosine * cosine;
    slides[0] = (diagonal * along_a - cosine * along_b) / determinant;
    slides[1] = (cosine * along_a - diagonal * along_b) / determinant;
}

/* Moves a point of a strand along it, on to other segments if necessary, but not beyond its ends. */
static void slide_point(const thread_object *t, double distance, uint32_t *segment,
                        double *fraction)
{
    const vec3 *x = t->now.x;
    double length = vec3_distance(x[*segment], x[*segment + 1]);
    double at = *fraction * length + distance;
    while (at < 0.0 && *segment > 0) {
        --*segment;
        length = vec3_distance(x[*segment], x[*segment + 1]);
        at += length;
    }
    while (at > length && *segment + 2 < t->node_count) {
        at -= length;
        ++*segment;
        length = vec3_distance(x[*segment], x[*segment + 1]);
    }
    *fraction = length > 0.0 ? vbss_min(vbss_max(at / length, 0.0), 1.0) : *fraction;
}

void vbss_scene_slide_contacts(scene_object *s)
{
    for (uint32_t i = 0; i < s->contacts->count; i++) {
        contact_constraint *constraint = &s->contacts->constraints[i];
        const contact_key *key = &constraint->key;
        scene_contact_geometry *geometry = scene_geometry_of(s, constraint);
        if (key->kind != VBSS_CONTACT_SEGMENTS) {
            continue;
        }
        const strand a = strand_at(s, vbss_scene_body(s, key->body_a), key->feature_a,
                                   geometry->barycentric[0], constraint->normal);
        const strand b = strand_at(s, vbss_scene_body(s, key->body_b), key->feature_b,
                                   geometry->barycentric[1], constraint->normal);
        double slides[2], limit = geometry->contact_distance;
        find_slides(&a, &b, slides);
        slide_point(a.thread, vbss_min(vbss_max(slides[0], -limit), limit), &geometry->segments[0],
                    &geometry->barycentric[0]);
        slide_point(b.thread, vbss_min(vbss_max(slides[1], -limit), limit), &geometry->segments[1],
                    &geometry->barycentric[1]);
    }
}
