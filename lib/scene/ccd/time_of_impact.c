/* Time of impact of a pair: near holes the contact scale changes on the way. */
#include "scene/ccd/pair.h"
#include "scene/tissue/tissue.h"
#include "scene/tools/tools.h"
#include "scene/topology/topology.h"

/* Time at which a query's pair comes as near as `thickness`, as a fraction of the substep; 1 if it
 * does not. */
static double time_of_approach(scene_object *s, const ccd_query *query, double thickness)
{
    vbss_scene_set_batch_query(s, query, 0);
    s->scratch.ccd_batch->thickness[0] = thickness;
    vbss_scene_run_ccd_batch(s, query->candidate->kind, 1);
    return s->scratch.ccd_batch->hit[0] != 0
               ? query->start_fraction +
                     (1.0 - query->start_fraction) * s->scratch.ccd_batch->time[0]
               : 1.0;
}

/* Contact scales of a query: at its start, and the smallest during its motion, which may lead into
 * a hole. `leaves_hole`: it starts in a hole, where no distance is too small. */
typedef struct contact_scales {
    double at_start, during_motion;
    bool leaves_hole;
} contact_scales;

/* Whether a query's pair is farther apart at its end than `distance`. */
static bool does_part(const scene_object *s, const ccd_query *query, double distance)
{
    const ccd_query end = {query->candidate, query->interval, 1.0};
    double coordinates[3];
    return vbss_scene_distance_at_start(s, &end, coordinates) > distance;
}

/* Time of impact of a pair that hit, as a fraction of the substep; 1 if it does not come too near.
 * A pair that starts near has a contact that keeps it apart. One that starts farther away may have
 * none, so it has to keep the contact distance. Axes that meet have no side: they may part, and only
 * that. */
static double time_of_impact(scene_object *s, const ccd_query *query, contact_scales scales)
{
    double coordinates[3], contact_distance = scene_ccd_contact_distance(s, query->candidate),
                           distance = vbss_scene_distance_at_start(s, query, coordinates);
    double ccd_distance = SCENE_CCD_DISTANCE_RATIO * scales.at_start * contact_distance;
    if (distance >= contact_distance + s->solver.contact_margin) {
        double reduction = (1.0 - scales.during_motion) * contact_distance;
        return time_of_approach(
            s, query,
            vbss_max(scene_ccd_min_contact_distance(s, query->candidate) - reduction,
                     ccd_distance));
    }
    bool near = distance <= ccd_distance * (1.0 + 2.0 * s->collision->ccd_options.tolerance);
    double hit =
        time_of_approach(s, query, near ? SCENE_CCD_RATIO_WHEN_NEARER * distance : ccd_distance);
    if (hit < 1.0 && distance < SCENE_CCD_MIN_DISTANCE_RATIO * ccd_distance &&
        !scales.leaves_hole) {
        bool has_no_side = distance <= SCENE_MIN_DISTANCE_RATIO * contact_distance;
        return has_no_side && does_part(s, query, distance) ? 1.0 : query->start_fraction;
    }
    return hit;
}

/* Bounds the relative displacement of two features in the substep, m. */
static double total_displacement_of(const scene_object *s, const collision_candidate *q)
{
    return s->bodies[s->body_of_shape[q->shape_a]].max_displacement +
           s->bodies[s->body_of_shape[q->shape_b]].max_displacement;
}

/* Time of impact of a suture and a wall near holes. The contact scale changes on the way, so it is
 * evaluated again at each hit. A point that leaves its hole is tested from the last sample inside
 * the hole. */
static double time_of_impact_at_holes(scene_object *s, const collision_candidate *q,
                                      const scene_axis_interval *interval,
                                      double scale_during_motion)
{
    const double contact_distance = scene_ccd_contact_distance(s, q);
    const double total_displacement = total_displacement_of(s, q);
    const double slow_interval =
        total_displacement > 0.0
            ? SCENE_CCD_SLOW_MOTION_RATIO * contact_distance / total_displacement
            : 1.0;
    const double sample_interval = vbss_max(1.0 / SCENE_CCD_HOLE_EVALUATIONS, slow_interval);
    ccd_query query = {q, interval, 0.0};
    bool starts_in_hole = false;
    for (uint32_t i = 0; i < SCENE_CCD_HOLE_QUERIES && query.start_fraction < 1.0; i++) {
        contact_scales scales = {
            starts_in_hole ? 0.0
                           : vbss_scene_contact_scale_at_wall(s, &query, contact_distance, 0.0),
            scale_during_motion, false};
        if (scales.at_start <= 0.0) {
            const ccd_query next = {q, interval,
                                    vbss_min(query.start_fraction + sample_interval, 1.0)};
            scales.at_start = vbss_scene_contact_scale_at_wall(s, &next, contact_distance, 0.0);
            scales.leaves_hole = true;
            starts_in_hole = scales.at_start <= 0.0;
            if (starts_in_hole) {
                query.start_fraction = next.start_fraction;
                continue;
            }
        }
        const ccd_query hit = {q, interval, time_of_impact(s, &query, scales)};
        if (hit.start_fraction >= 1.0) {
            return 1.0;
        }
        const double scale_at_hit =
            vbss_scene_contact_scale_at_wall(s, &hit, contact_distance, 0.0);
        if (scale_at_hit >= scales.at_start) {
            return hit.start_fraction;
        }
        double min_start = scale_at_hit > 0.0 ? 0.0
                                              : query.start_fraction +
                                                    sample_interval / SCENE_CCD_HOLE_EVALUATIONS;
        query.start_fraction = vbss_min(vbss_max(hit.start_fraction, min_start), 1.0);
    }
    return query.start_fraction;
}

/* Time of impact of a needle and an edge whose closest points are excluded at a hole: tests the
 * needle's axis outside its holes. */
static double time_of_impact_beside_holes(scene_object *s, const collision_candidate *q)
{
    const scene_body *a = &s->bodies[s->body_of_shape[q->shape_a]];
    const scene_body *b = &s->bodies[s->body_of_shape[q->shape_b]];
    bool first = scene_is_needle(a);
    const scene_body *needle = first ? a : b, *wall = first ? b : a;
    if (q->kind != VBSS_COLLISION_PAIR_EDGE_EDGE || !scene_is_wall(wall) ||
        !scene_is_needle(needle)) {
        return 1.0;
    }
    const double contact_distance = scene_ccd_contact_distance(s, q);
    const double reach = SCENE_EXCLUSION_ARC_RATIO * contact_distance;
    scene_axis_interval interval = {.started = false};
    double earliest = 1.0;
    while (vbss_scene_next_axis_interval(s, needle, first ? q->a : q->b, wall, first ? q->b : q->a,
                                         reach, &interval)) {
        const ccd_query query = {q, &interval, 0.0};
        if (time_of_approach(s, &query, scene_ccd_min_contact_distance(s, q)) < 1.0) {
            double scale = vbss_scene_contact_scale_at_wall(s, &query, contact_distance,
                                                            total_displacement_of(s, q));
            earliest = vbss_min(time_of_impact_at_holes(s, q, &interval, scale), earliest);
        }
    }
    return earliest;
}

static bool is_of_suture_and_wall(const scene_object *s, const collision_candidate *q)
{
    const scene_body *a = &s->bodies[s->body_of_shape[q->shape_a]];
    const scene_body *b = &s->bodies[s->body_of_shape[q->shape_b]];
    return (scene_is_wall(a) && vbss_scene_is_suture(b)) ||
           (scene_is_wall(b) && vbss_scene_is_suture(a));
}

static bool is_of_needle_and_wall(const scene_object *s, const collision_candidate *q)
{
    const scene_body *a = &s->bodies[s->body_of_shape[q->shape_a]];
    const scene_body *b = &s->bodies[s->body_of_shape[q->shape_b]];
    return (scene_is_wall(a) && scene_is_needle(b)) || (scene_is_wall(b) && scene_is_needle(a));
}

/* Whether a pair that starts near stays beyond half the contact distance, as most that hit do.
 * Needles at walls are excepted: they are tested by intervals, which may start farther away. */
static bool stays_beyond_ccd_distance(scene_object *s, const ccd_query *query)
{
    double coordinates[3], distance = vbss_scene_distance_at_start(s, query, coordinates),
                           contact_distance = scene_ccd_contact_distance(s, query->candidate);
    const double ccd_distance = SCENE_CCD_DISTANCE_RATIO * contact_distance *
                                (1.0 + 2.0 * s->collision->ccd_options.tolerance);
    vbss_collision_store_separation(s->collision, query->candidate, distance);
    return distance < contact_distance + s->solver.contact_margin &&
           vbss_collision_stays_separated(s->collision, query->candidate, ccd_distance) &&
           !is_of_needle_and_wall(s, query->candidate);
}

double vbss_scene_refine_time_of_impact(scene_object *s, const collision_candidate *q, double time)
{
    const ccd_query query = {q, NULL, 0.0};
    if (stays_beyond_ccd_distance(s, &query)) {
        return 1.0;
    }
    const double scale = vbss_scene_contact_scale_of_pair(s, q, scene_ccd_contact_distance(s, q));
    double coordinates[3];
    if (scale < 1.0 && is_of_suture_and_wall(s, q)) {
        return vbss_min(time_of_impact_at_holes(s, q, NULL, scale),
                        time_of_impact_beside_holes(s, q));
    }
    if (scale <= 0.0) {
        return 1.0;
    }
    double listed_distance = scene_ccd_contact_distance(s, q) + s->solver.contact_margin;
    return scale >= 1.0 && vbss_scene_distance_at_start(s, &query, coordinates) >= listed_distance
               ? time
               : time_of_impact(s, &query, (contact_scales){scale, scale, false});
}
