/* Sliding contacts: two strands that slide over each other touch where they cross at the end of the substep.
 *
 * A contact acts on a point of each strand, along a normal across both. While a strand of curvature 1/R slides by d, its
 * segment at the contact turns by d/R. Against the normal of the start the contact force p then has a component
 * p d/R along the strand, which brakes it as if friction were larger by d/R: 0.07 in a tight knot at 20 mm/s and 1 ms. So
 * the points move to where the crossing will be, on to neighbouring segments if necessary, and the normal turns until
 * it is perpendicular to the strands there.
 *
 * The turn comes from the shape of the strand and the slide, not from the velocities of both ends of the segment. A
 * strand that slides along itself keeps its shape, and noise in those velocities would make tight knots tremble. */
#include "scene/contacts/contacts.h"
#include "scene/tuning.h"
#include "scene/world/world.h"

/* A strand at a contact. */
typedef struct contact_strand {
    const thread_object *thread;
    uint32_t segment;
    double fraction;
    vec3 displacement; /* expected, of the contact point, m */
} contact_strand;

static contact_strand strand_at(const scene_object *s, uint32_t number, uint32_t segment,
                                double fraction)
{
    const scene_body *b = vbss_scene_body(s, number);
    const vec3 *displacements = s->step.expected_displacements + b->thread.first_node + segment;
    return (contact_strand){b->thread.thread, segment, fraction,
                            vec3_lerp(displacements[0], displacements[1], fraction)};
}

static vec3 segment_of(const thread_object *t, uint32_t segment)
{
    return vec3_sub(t->now.x[segment + 1], t->now.x[segment]);
}

static vec3 tangent_of(const contact_strand *strand)
{
    return vec3_unit_or(segment_of(strand->thread, strand->segment), vec3_zero());
}

/* Curvature vector at the middle of a segment, 1/m: derivative of the tangent along the strand. */
static vec3 curvature_of(const contact_strand *strand)
{
    const thread_object *t = strand->thread;
    const uint32_t middle = strand->segment;
    const uint32_t before = middle > 0 ? middle - 1 : middle,
                   after = middle + 2 < t->node_count ? middle + 1 : middle;
    const vec3 first = segment_of(t, before), last = segment_of(t, after);
    const double length = vec3_norm(segment_of(t, middle)),
                 between = 0.5 * (vec3_norm(first) + vec3_norm(last)) +
                           (before < middle && middle < after ? length : 0.0);
    vec3 turn = vec3_sub(vec3_unit_or(last, vec3_zero()), vec3_unit_or(first, vec3_zero()));
    return between > 0.0 ? vec3_scale(turn, 1.0 / between) : vec3_zero();
}

/* Distances along both strands from the points of the start to those that cross at the end, m. In the tangent
 * plane they solve
 *     displacement_a + slides[0] tangent_a = displacement_b + slides[1] tangent_b
 * by damped least squares. Parallel strands cross nowhere; they get points that are opposite each other. */
static void find_slides(const contact_strand *a, const contact_strand *b, double limit,
                        double slides[2])
{
    const vec3 tangents[2] = {tangent_of(a), tangent_of(b)};
    const vec3 motion = vec3_sub(b->displacement, a->displacement);
    const double cosine = vec3_dot(tangents[0], tangents[1]), diagonal = 1.0 + SCENE_SLIDE_DAMPING,
                 along_a = vec3_dot(tangents[0], motion), along_b = vec3_dot(tangents[1], motion),
                 determinant = diagonal * diagonal - cosine * cosine;
    slides[0] = (diagonal * along_a - cosine * along_b) / determinant;
    slides[1] = (cosine * along_a - diagonal * along_b) / determinant;
    for (int k = 0; k < 2; k++) {
        slides[k] = vbss_min(vbss_max(slides[k], -limit), limit);
    }
}

/* Moves the contact point along the strand, but not beyond its ends. */
static void slide_point(contact_strand *strand, double distance)
{
    const thread_object *t = strand->thread;
    double length = vec3_norm(segment_of(t, strand->segment));
    double at = strand->fraction * length + distance;
    while (at < 0.0 && strand->segment > 0) {
        length = vec3_norm(segment_of(t, --strand->segment));
        at += length;
    }
    while (at > length && strand->segment + 2 < t->node_count) {
        at -= length;
        length = vec3_norm(segment_of(t, ++strand->segment));
    }
    strand->fraction = length > 0.0 ? vbss_min(vbss_max(at / length, 0.0), 1.0) : 0.0;
}

/* Cosine of the angle between the normal and the strand at its contact point at the end. At a node no segment is
 * perpendicular to the normal. There only the turn of the strand counts. `start`: the strand at the start. */
static double lean_of(const contact_strand *start, const contact_strand *end, double slide,
                      vec3 normal)
{
    const bool is_at_node = start->fraction == 0.0 || start->fraction == 1.0;
    const contact_strand *at = is_at_node ? start : end;
    const double lean = is_at_node ? 0.0 : vec3_dot(tangent_of(end), normal);
    return lean - slide * vec3_dot(curvature_of(at), normal);
}

/* Turns the normal so that it leans against neither strand, by damped least squares: the part of the leans in
 * which parallel strands differ has no solution. The sum and the difference of both leans separate. */
static vec3 turn_normal(vec3 normal, const vec3 tangents[2], const double leans[2])
{
    const double cosine = vec3_dot(tangents[0], tangents[1]), sum = 1.0 + cosine,
                 difference = 1.0 - cosine;
    const double both = 0.5 * sum * (leans[0] + leans[1]) / (sum * sum + SCENE_SLIDE_DAMPING);
    const double apart =
        0.5 * difference * (leans[0] - leans[1]) / (difference * difference + SCENE_SLIDE_DAMPING);
    const vec3 turn =
        vec3_add(vec3_scale(tangents[0], both + apart), vec3_scale(tangents[1], both - apart));
    const double size = vec3_norm(turn);
    const double share = size > SCENE_MAX_NORMAL_TURN ? SCENE_MAX_NORMAL_TURN / size : 1.0;
    return vec3_unit_or(vec3_add_scaled(normal, -share, turn), normal);
}

static void slide_contact(const scene_object *s, contact_constraint *constraint)
{
    const contact_key *key = &constraint->key;
    scene_contact_geometry *geometry = scene_geometry_of(s, constraint);
    const contact_strand start[2] = {
        strand_at(s, key->body_a, key->feature_a, geometry->barycentric[0]),
        strand_at(s, key->body_b, key->feature_b, geometry->barycentric[1])};
    contact_strand end[2] = {start[0], start[1]};
    vec3 tangents[2];
    double slides[2], leans[2];
    find_slides(&start[0], &start[1], SCENE_MAX_SLIDE_RATIO * geometry->contact_distance, slides);
    for (int k = 0; k < 2; k++) {
        slide_point(&end[k], slides[k]);
        leans[k] = lean_of(&start[k], &end[k], slides[k], constraint->normal);
        tangents[k] = tangent_of(&end[k]);
        geometry->segments[k] = end[k].segment;
        geometry->barycentric[k] = end[k].fraction;
    }
    constraint->normal = turn_normal(constraint->normal, tangents, leans);
}

void vbss_scene_slide_contacts(scene_object *s)
{
    for (uint32_t i = 0; i < s->contacts->count; i++) {
        if (s->contacts->constraints[i].key.kind == VBSS_CONTACT_SEGMENTS) {
            slide_contact(s, &s->contacts->constraints[i]);
        }
    }
}
