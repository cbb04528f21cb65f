/* A pair of features in CCD: its vertices, its distances, and queries over their motion. */
#ifndef VBSS_SCENE_CCD_PAIR_H
#define VBSS_SCENE_CCD_PAIR_H

#include "scene/contacts/contacts.h"
#include "scene/tuning.h"
#include "scene/world/scene_data.h"

/* Whether a vertex of a feature of a drain is at a lip (pair.c). */
bool vbss_scene_touches_lip(const scene_object *s, const collision_candidate *q, bool is_b);

/* Whether a feature touches a lip. It may come nearer to a wall than other features do. */
static inline bool scene_is_on_lip(const scene_object *s, const collision_candidate *q, bool is_b)
{
    return s->bodies[s->body_of_shape[q->shape_a]].kind == SCENE_BODY_DRAIN &&
           s->bodies[s->body_of_shape[q->shape_b]].kind == SCENE_BODY_DRAIN &&
           vbss_scene_touches_lip(s, q, is_b);
}

static inline double scene_ccd_radius(const scene_object *s, const collision_candidate *q,
                                      bool is_b)
{
    return scene_feature_radius(s, q, is_b) *
           (scene_is_on_lip(s, q, is_b) ? 2.0 * SCENE_LIP_RADIUS_RATIO : 1.0);
}

static inline double scene_ccd_contact_distance(const scene_object *s, const collision_candidate *q)
{
    return scene_ccd_radius(s, q, false) + scene_ccd_radius(s, q, true);
}

/* Twice the smaller radius of a pair, m. */
static inline double scene_ccd_thickness(const scene_object *s, const collision_candidate *q)
{
    return 2.0 * vbss_min(scene_ccd_radius(s, q, false), scene_ccd_radius(s, q, true));
}

/* Smallest distance that the penetration tolerance of contacts permits, m. */
static inline double scene_ccd_min_contact_distance(const scene_object *s,
                                                    const collision_candidate *q)
{
    return scene_ccd_contact_distance(s, q) -
           s->solver.penetration_tolerance * scene_ccd_thickness(s, q);
}

/* A pair of features, restricted to an interval of both (NULL: whole features), from a fraction of
 * the substep on. */
typedef struct ccd_query {
    const collision_candidate *candidate;
    const scene_axis_interval *interval;
    double start_fraction;
} ccd_query;

/* ---- pair.c */

/* Writes a query into a lane of the batch, with the smallest distance that contacts permit. */
void vbss_scene_set_batch_query(scene_object *s, const ccd_query *query, uint32_t lane);

/* Tests the first `count` lanes of the batch, which are of one kind of pair. */
void vbss_scene_run_ccd_batch(scene_object *s, uint32_t kind, uint32_t count);

/* Distance of a query's pair at its start, m, and where the closest points are: fractions on two
 * edges, or weights of a triangle's corners. */
double vbss_scene_distance_at_start(const scene_object *s, const ccd_query *query,
                                    double coordinates[3]);

/* ---- contact_scale.c */

/* Contact scale of a pair at the start of the query: below 1 for a suture beside its hole, and for
 * jaws that hold the wall. `extra_reach` enlarges the exclusion radius, m. */
double vbss_scene_contact_scale_at_wall(const scene_object *s, const ccd_query *query,
                                        double contact_distance, double extra_reach);

/* Contact scale of a pair over the whole substep: 0 for pairs excluded at a pin, at a cut, or
 * in jaws. */
double vbss_scene_contact_scale_of_pair(const scene_object *s, const collision_candidate *q,
                                        double contact_distance);

/* ---- time_of_impact.c */

/* Time of impact, as a fraction of the substep, of a pair that came nearer than contacts let it;
 * 1 if it does not come too near. `time` is that of the batch. */
double vbss_scene_refine_time_of_impact(scene_object *s, const collision_candidate *q, double time);

/* ---- swept_pairs.c */

/* Lists all pairs that may meet on the way to the trial state. The list of the broad phase is used
 * again if all vertices stay within their motion bounds. */
scene_substep_outcome vbss_scene_list_ccd_pairs(scene_object *s);

#endif
