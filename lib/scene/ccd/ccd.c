/* CCD: tests whether any two features pass through each other between start and trial state of a
 * substep. The public statistics call it the guard.
 *
 * One-sided continuous tests keep axes at half the contact distance: a miss is a proof. Contacts
 * rest near the whole distance, so CCD finds nothing unless something goes wrong. Pairs that start
 * nearer than half the distance must not come much nearer, so that a bad state can be left. */
#include "collision/closest.h"
#include "scene/ccd/ccd.h"
#include "scene/contacts/contacts.h"
#include "scene/tissue/tissue.h"
#include "scene/tools/tools.h"
#include "scene/topology/topology.h"
#include "scene/tuning.h"
#include "scene/world/world.h"

/* ---- motion of vertices */

typedef struct vertex_motion {
    uint32_t count;
    const vec3 *start, *expected, *end;
} vertex_motion;

static vertex_motion vertex_motion_of(scene_object *s, const scene_body *b)
{
    if (b->kind == SCENE_BODY_THREAD) {
        const thread_object *t = b->thread.thread;
        return (vertex_motion){t->node_count, t->now.x,
                               s->step.expected_displacements + b->thread.first_node, t->trial};
    }
    if (b->kind == SCENE_BODY_DRAIN) {
        const drain_object *d = b->drain.drain;
        return (vertex_motion){d->mesh.node_count, d->x, b->drain.expected_displacements, d->trial};
    }
    const scene_rigid *r = &b->rigid;
    uint32_t count = 2 * r->capsule_count;
    vec3 *start = s->scratch.vertices, *end = start + count;
    for (uint32_t i = 0; i < count; i++) {
        start[i] = s->capsules[r->first_capsule + i / 2].now[i % 2];
        end[i] = s->capsules[r->first_capsule + i / 2].trial[i % 2];
    }
    const vec3 *expected =
        s->step.expected_displacements + s->config.node_capacity + 2 * (size_t)r->first_capsule;
    return (vertex_motion){count, start, expected, end};
}

/* Whether all vertices stay within their motion bounds, up to half of the contact margin. The broad
 * phase has swept its boxes over these bounds and enlarged them by the margin. So a vertex within
 * them meets only features of listed pairs. */
static bool is_inside_motion_bounds(const scene_object *s, const vertex_motion *m)
{
    const double margin = SCENE_CCD_MARGIN_RATIO * s->config.contact_margin;
    for (uint32_t i = 0; i < m->count; i++) {
        vec3 expected = vec3_scale(m->expected[i], SCENE_EXTRAPOLATION_RATIO),
             displacement = vec3_sub(m->end[i], m->start[i]);
        bool inside = displacement.x >= vbss_min(0.0, expected.x) - margin &&
                      displacement.x <= vbss_max(0.0, expected.x) + margin &&
                      displacement.y >= vbss_min(0.0, expected.y) - margin &&
                      displacement.y <= vbss_max(0.0, expected.y) + margin &&
                      displacement.z >= vbss_min(0.0, expected.z) - margin &&
                      displacement.z <= vbss_max(0.0, expected.z) + margin;
        if (!inside) { /* also for NaN */
            return false;
        }
    }
    return true;
}

/* Whether all pairs start at about their contact distance: contacts show it for pairs that are
 * near. Pairs excluded at pins and cuts need no CCD. */
static bool do_pairs_start_apart(const scene_object *s)
{
    bool is_apart = !s->step.has_unlisted_pairs;
    for (uint32_t i = 0; is_apart && i < s->contacts->count; i++) {
        const contact_constraint *constraint = &s->contacts->constraints[i];
        const scene_contact_geometry *geometry = scene_geometry_of(s, constraint);
        is_apart =
            constraint->is_bilateral || geometry->start_gap - geometry->overlap_allowance >=
                                            -SCENE_CCD_DEEP_RATIO * geometry->contact_distance;
    }
    return is_apart;
}

static double find_max_displacement(const vertex_motion *m)
{
    double largest = 0.0;
    for (uint32_t i = 0; i < m->count; i++) {
        double square = vec3_norm_squared(vec3_sub(m->end[i], m->start[i]));
        largest = square > largest ? square : largest;
    }
    return sqrt(largest);
}

/* Lists all pairs that may meet on the way to the trial state. The list of the broad phase is used
 * again if all vertices stay within their motion bounds. */
static scene_substep_outcome list_ccd_pairs(scene_object *s)
{
    bool is_expected = true;
    for (uint32_t i = 0; i < s->body_count; i++) {
        if (s->bodies[i].kind != SCENE_BODY_NONE) {
            const vertex_motion m = vertex_motion_of(s, &s->bodies[i]);
            is_expected = is_expected && is_inside_motion_bounds(s, &m);
            /* Pairs at holes use it in either case. */
            s->bodies[i].max_displacement = find_max_displacement(&m);
        }
    }
    s->step.can_skip_slow_pairs = is_expected && do_pairs_start_apart(s);
    for (uint32_t i = 0; i < s->body_count; i++) {
        const scene_body *b = &s->bodies[i];
        if (b->kind == SCENE_BODY_NONE) {
            continue;
        }
        const vertex_motion m = vertex_motion_of(s, b);
        if (is_expected) {
            vbss_collision_set_end_positions(s->collision->shapes[b->shape], m.end);
        } else if (vbss_collision_move(scene_collision(s), b->shape, &m.start->x, &m.end->x,
                                       m.count) != VBSS_OK) {
            return SCENE_SUBSTEP_SINGULAR; /* not finite, or out of range */
        }
        vbss_collision_update_displacements(s->collision->shapes[b->shape]);
    }
    if (!is_expected && vbss_scene_run_broad_phase(s) != VBSS_OK) {
        return SCENE_SUBSTEP_OUT_OF_CAPACITY;
    }
    return SCENE_SUBSTEP_ACCEPTED;
}

/* ---- tests of pairs, in batches */

static void set_batch_vertex(collision_block *batch, size_t vertex, uint32_t lane, vec3 start,
                             vec3 end)
{
    batch->start[3 * vertex][lane] = start.x;
    batch->start[3 * vertex + 1][lane] = start.y;
    batch->start[3 * vertex + 2][lane] = start.z;
    batch->end[3 * vertex][lane] = end.x;
    batch->end[3 * vertex + 1][lane] = end.y;
    batch->end[3 * vertex + 2][lane] = end.z;
}

/* Vertices of a pair: two of each edge, or a point and the corners of a triangle. */
static void vertices_of(const scene_object *s, const collision_candidate *q,
                        const collision_shape *shapes[4], uint32_t vertices[4])
{
    const collision_shape *a = s->collision->shapes[q->shape_a];
    const collision_shape *b = s->collision->shapes[q->shape_b];
    bool edges = q->kind == VBSS_PAIR_EDGE_EDGE;
    for (uint32_t k = 0; k < 4; k++) {
        bool is_a = k < (edges ? 2u : 1u);
        shapes[k] = is_a ? a : b;
        vertices[k] = !edges ? (is_a ? q->a : b->triangles[q->b][k - 1])
                             : (is_a ? a->edges[q->a][k] : b->edges[q->b][k - 2]);
    }
}

/* Whether a feature touches a lip. It may come nearer to a wall than other features do. */
static bool is_on_lip(const scene_object *s, const collision_candidate *q, bool is_b)
{
    const collision_shape *shapes[4];
    uint32_t vertices[4], first = q->kind == VBSS_PAIR_EDGE_EDGE ? 2 : 1;
    const scene_body *a = &s->bodies[s->body_of_shape[q->shape_a]];
    const scene_body *b = &s->bodies[s->body_of_shape[q->shape_b]];
    if (a->kind != SCENE_BODY_DRAIN || b->kind != SCENE_BODY_DRAIN) {
        return false;
    }
    vertices_of(s, q, shapes, vertices);
    const uint32_t *lips = (is_b ? b : a)->drain.lip_of_node;
    bool is_lip = false;
    for (uint32_t k = is_b ? first : 0; k < (is_b ? 4 : first); k++) {
        is_lip = is_lip || lips[vertices[k]] != SCENE_NO_FACE;
    }
    return is_lip;
}

static double radius_of(const scene_object *s, const collision_candidate *q, bool is_b)
{
    return scene_feature_radius(s, q, is_b) *
           (is_on_lip(s, q, is_b) ? 2.0 * SCENE_LIP_RADIUS_RATIO : 1.0);
}

static double contact_distance_of(const scene_object *s, const collision_candidate *q)
{
    return radius_of(s, q, false) + radius_of(s, q, true);
}

/* Twice the smaller radius of a pair, m. */
static double thickness_of(const scene_object *s, const collision_candidate *q)
{
    return 2.0 * vbss_min(radius_of(s, q, false), radius_of(s, q, true));
}

/* Smallest distance that the penetration tolerance of contacts permits, m. */
static double min_contact_distance(const scene_object *s, const collision_candidate *q)
{
    return contact_distance_of(s, q) - s->config.penetration_tolerance * thickness_of(s, q);
}

/* A pair of features, restricted to an interval of both (NULL: whole features), from a fraction of
 * the substep on. */
typedef struct ccd_query {
    const collision_candidate *candidate;
    const scene_axis_interval *interval;
    double start_fraction;
} ccd_query;

typedef struct swept_vertices {
    vec3 start[4], end[4];
} swept_vertices;

static void set_swept_vertices(const scene_object *s, const ccd_query *query, swept_vertices *c)
{
    const collision_candidate *q = query->candidate;
    const scene_axis_interval *interval = query->interval;
    const collision_shape *shapes[4];
    uint32_t vertices[4];
    vertices_of(s, q, shapes, vertices);
    for (uint32_t k = 0; k < 4; k++) {
        vec3 start = shapes[k]->start[vertices[k]], end = shapes[k]->end[vertices[k]];
        c->start[k] =
            query->start_fraction > 0.0 ? vec3_lerp(start, end, query->start_fraction) : start;
        c->end[k] = end;
    }
    bool is_a_rigid = s->bodies[s->body_of_shape[q->shape_a]].kind == SCENE_BODY_RIGID;
    for (uint32_t k = 0; interval != NULL && k < 2; k++) {
        uint32_t first_vertex = (k == 0) == is_a_rigid ? 0 : 2;
        scene_clip_axis(c->start + first_vertex, interval->bounds[k]);
        scene_clip_axis(c->end + first_vertex, interval->bounds[k]);
    }
}

static void set_batch_query(scene_object *s, const ccd_query *query, uint32_t lane)
{
    swept_vertices c;
    set_swept_vertices(s, query, &c);
    for (uint32_t k = 0; k < 4; k++) {
        set_batch_vertex(s->scratch.ccd_batch, k, lane, c.start[k], c.end[k]);
    }
    /* Contacts seldom let a pair come nearer. */
    s->scratch.ccd_batch->thickness[lane] = min_contact_distance(s, query->candidate);
}

/* Distance of a query's pair at its start, m, and where the closest points are: fractions on two
 * edges, or weights of a triangle's corners. */
static double distance_at_start(const scene_object *s, const ccd_query *query,
                                double coordinates[3])
{
    swept_vertices c;
    set_swept_vertices(s, query, &c);
    const vec3 *x = c.start;
    if (query->candidate->kind == VBSS_PAIR_POINT_TRIANGLE) {
        const vec3 triangle[3] = {vec3_sub(x[1], x[0]), vec3_sub(x[2], x[0]), vec3_sub(x[3], x[0])};
        return vec3_norm(closest_on_triangle(triangle, coordinates));
    }
    return vec3_norm(closest_between_edges(vec3_sub(x[1], x[0]), vec3_sub(x[3], x[2]),
                                           vec3_sub(x[2], x[0]), &coordinates[0], &coordinates[1]));
}

/* Closest point of the drain at the start of the query, and the fraction of the closest point on
 * the other feature. */
static scene_wall_point find_nearest_wall_point(const scene_object *s, const ccd_query *query,
                                                bool first, const scene_body *drain,
                                                double *fraction)
{
    const collision_candidate *q = query->candidate;
    const uint32_t feature = first ? q->b : q->a;
    double coordinates[3];
    scene_wall_point wall_point;
    (void)distance_at_start(s, query, coordinates);
    if (q->kind == VBSS_PAIR_POINT_TRIANGLE) {
        *fraction = 0.0;
        wall_point =
            vbss_scene_wall_point_at_time(drain, feature, coordinates, query->start_fraction);
    } else {
        double on_other = coordinates[first ? 0 : 1], on_side = coordinates[first ? 1 : 0];
        if (query->interval != NULL) {
            const double(*intervals)[2] = query->interval->bounds;
            on_other = intervals[0][0] + on_other * (intervals[0][1] - intervals[0][0]);
            on_side = intervals[1][0] + on_side * (intervals[1][1] - intervals[1][0]);
        }
        *fraction = on_other;
        const uint32_t *side = s->collision->shapes[drain->shape]->edges[feature];
        wall_point =
            vbss_scene_wall_point_on_edge_at_time(drain, side, on_side, query->start_fraction);
    }
    return wall_point;
}

/* Contact scale of a pair at the start of the query: below 1 for a suture beside its hole, and for
 * jaws that hold the wall. `extra_reach` enlarges the exclusion radius, m. */
static double contact_scale_at_wall(const scene_object *s, const ccd_query *query,
                                    double contact_distance, double extra_reach)
{
    const collision_candidate *q = query->candidate;
    const scene_body *a = &s->bodies[s->body_of_shape[q->shape_a]];
    const scene_body *b = &s->bodies[s->body_of_shape[q->shape_b]];
    bool first = a->kind != SCENE_BODY_DRAIN, point = q->kind == VBSS_PAIR_POINT_TRIANGLE;
    const scene_body *other = first ? a : b, *drain = first ? b : a;
    bool holds_wall =
        other->kind == SCENE_BODY_RIGID && other->rigid.wall_grasp.drain == drain->number;
    if (other->kind == SCENE_BODY_DRAIN || drain->kind != SCENE_BODY_DRAIN ||
        !(holds_wall || vbss_scene_is_suture(other))) {
        return 1.0;
    }
    double fraction;
    const scene_wall_point wall_point = find_nearest_wall_point(s, query, first, drain, &fraction);
    return vbss_scene_contact_scale_at(s, other, point, first ? q->a : q->b, fraction, drain,
                                       &wall_point,
                                       SCENE_EXCLUSION_ARC_RATIO * contact_distance + extra_reach);
}

/* Contact scale of a pair over the whole substep: 0 for pairs excluded at a pin, at a cut, or
 * in jaws. */
static double contact_scale_of_pair(const scene_object *s, const collision_candidate *q,
                                    double contact_distance)
{
    const scene_body *a = &s->bodies[s->body_of_shape[q->shape_a]];
    const scene_body *b = &s->bodies[s->body_of_shape[q->shape_b]];
    if (a->kind == SCENE_BODY_DRAIN || b->kind == SCENE_BODY_DRAIN) {
        const ccd_query query = {q, NULL, 0.0};
        return contact_scale_at_wall(s, &query, contact_distance,
                                     a->max_displacement + b->max_displacement);
    }
    if (a->kind == SCENE_BODY_THREAD && b->kind == SCENE_BODY_THREAD) {
        return vbss_scene_is_excluded_across_cut(s, a, q->a, b, q->b) ? 0.0 : 1.0;
    }
    if (a->kind == b->kind) {
        bool is_held = vbss_scene_is_needle_in_grasp(s, a, q->a, b, q->b) ||
                       vbss_scene_is_needle_in_grasp(s, b, q->b, a, q->a);
        return is_held ? 0.0 : 1.0;
    }
    bool is_excluded = a->kind == SCENE_BODY_THREAD
                           ? vbss_scene_is_excluded_at_pin(s, a, q->a, b, q->b, contact_distance)
                           : vbss_scene_is_excluded_at_pin(s, b, q->b, a, q->a, contact_distance);
    return is_excluded ? 0.0 : 1.0;
}

static double min_radius(const scene_object *s, const scene_body *b, uint32_t shape)
{
    /* The radius of a rigid shape is that of its thickest capsule. */
    double smallest = s->collision->shapes[shape]->radius;
    if (b->kind == SCENE_BODY_DRAIN) {
        return 2.0 * SCENE_LIP_RADIUS_RATIO * smallest;
    }
    for (uint32_t i = 0; b->kind == SCENE_BODY_RIGID && i < b->rigid.capsule_count; i++) {
        smallest = vbss_min(s->capsules[b->rigid.first_capsule + i].radius, smallest);
    }
    return smallest;
}

/* Whether the features of a pair move too little to pass through each other. This needs all pairs
 * to start apart. */
static bool is_slow_pair(const scene_object *s, const collision_candidate *q)
{
    const scene_body *a = &s->bodies[s->body_of_shape[q->shape_a]];
    const scene_body *b = &s->bodies[s->body_of_shape[q->shape_b]];
    return s->step.can_skip_slow_pairs &&
           a->max_displacement + b->max_displacement <=
               SCENE_CCD_SLOW_MOTION_RATIO * contact_distance_of(s, q);
}

/* Skips all pairs of the same two shapes if none of them moves enough, or if nothing could keep
 * them apart. Returns the index of the first pair of other shapes. */
static uint32_t skip_slow_pairs(const scene_object *s, uint32_t first)
{
    const collision_object *c = s->collision;
    const collision_candidate *q = &c->candidates[first];
    const scene_body *a = &s->bodies[s->body_of_shape[q->shape_a]];
    const scene_body *b = &s->bodies[s->body_of_shape[q->shape_b]];
    double contact_distance = min_radius(s, a, q->shape_a) + min_radius(s, b, q->shape_b);
    uint32_t next = first;
    double displacement = a->max_displacement + b->max_displacement;
    bool is_slow = s->step.can_skip_slow_pairs &&
                   displacement <= SCENE_CCD_SLOW_MOTION_RATIO * contact_distance;
    bool is_ignored = scene_is_prescribed(a) && scene_is_prescribed(b) &&
                      (displacement == 0.0 || vbss_scene_is_overlap(s, a, b));
    if (is_slow || is_ignored) {
        while (next < c->candidate_count && c->candidates[next].shape_a == q->shape_a &&
               c->candidates[next].shape_b == q->shape_b) {
            next++;
        }
    }
    return next;
}

static void run_ccd_batch(scene_object *s, uint32_t kind, uint32_t count)
{
    collision_block *batch = s->scratch.ccd_batch;
    const collision_ccd_batch queries = {.kind = (vbss_pair_kind)kind,
                                         .count = count,
                                         .stride = COLLISION_BLOCK_SIZE,
                                         .start = batch->start[0],
                                         .end = batch->end[0],
                                         .thickness = batch->thickness,
                                         .hit = batch->hit,
                                         .decision = batch->decision,
                                         .time = batch->time};
    vbss_collision_run_ccd_batch(&s->collision->ccd_options, s->collision->wide, &queries,
                                 &s->collision->counters);
}

/* Time at which a query's pair comes as near as `thickness`, as a fraction of the substep; 1 if it
 * does not. */
static double time_of_approach(scene_object *s, const ccd_query *query, double thickness)
{
    set_batch_query(s, query, 0);
    s->scratch.ccd_batch->thickness[0] = thickness;
    run_ccd_batch(s, query->candidate->kind, 1);
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

/* Time of impact of a pair that hit, as a fraction of the substep; 1 if it does not come too near.
 * A pair that starts near has a contact that keeps it apart. One that starts farther away may have
 * none, so it has to keep the contact distance. */
static double time_of_impact(scene_object *s, const ccd_query *query, contact_scales scales)
{
    double coordinates[3], contact_distance = contact_distance_of(s, query->candidate),
                           distance = distance_at_start(s, query, coordinates);
    double ccd_distance = SCENE_CCD_DISTANCE_RATIO * scales.at_start * contact_distance;
    if (distance >= contact_distance + s->config.contact_margin) {
        double reduction = (1.0 - scales.during_motion) * contact_distance;
        return time_of_approach(
            s, query,
            vbss_max(min_contact_distance(s, query->candidate) - reduction, ccd_distance));
    }
    bool near = distance <= ccd_distance * (1.0 + 2.0 * s->collision->ccd_options.tolerance);
    double hit =
        time_of_approach(s, query, near ? SCENE_CCD_RATIO_WHEN_NEARER * distance : ccd_distance);
    return hit < 1.0 && distance < SCENE_CCD_MIN_DISTANCE_RATIO * ccd_distance &&
                   !scales.leaves_hole
               ? query->start_fraction
               : hit;
}

/* Time of impact of a suture and a wall near holes. The contact scale changes on the way, so it is
 * evaluated again at each hit. A point that leaves its hole is tested from the last sample inside
 * the hole. */
static double time_of_impact_at_holes(scene_object *s, const collision_candidate *q,
                                      const scene_axis_interval *interval)
{
    const double contact_distance = contact_distance_of(s, q);
    const double total_displacement = s->bodies[s->body_of_shape[q->shape_a]].max_displacement +
                                      s->bodies[s->body_of_shape[q->shape_b]].max_displacement;
    const double sample_interval =
        vbss_max(1.0 / SCENE_CCD_HOLE_EVALUATIONS,
                 SCENE_CCD_SLOW_MOTION_RATIO * contact_distance / total_displacement);
    ccd_query query = {q, interval, 0.0};
    const double scale_during_motion =
        contact_scale_at_wall(s, &query, contact_distance, total_displacement);
    for (uint32_t i = 0; i < SCENE_CCD_HOLE_QUERIES && query.start_fraction < 1.0; i++) {
        contact_scales scales = {contact_scale_at_wall(s, &query, contact_distance, 0.0),
                                 scale_during_motion, false};
        if (scales.at_start <= 0.0) {
            const ccd_query next = {q, interval,
                                    vbss_min(query.start_fraction + sample_interval, 1.0)};
            scales.at_start = contact_scale_at_wall(s, &next, contact_distance, 0.0);
            scales.leaves_hole = true;
            if (scales.at_start <= 0.0) {
                query.start_fraction = next.start_fraction;
                continue;
            }
        }
        const ccd_query hit = {q, interval, time_of_impact(s, &query, scales)};
        if (hit.start_fraction >= 1.0) {
            return 1.0;
        }
        const double scale_at_hit = contact_scale_at_wall(s, &hit, contact_distance, 0.0);
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
    bool first = a->kind == SCENE_BODY_RIGID;
    const scene_body *needle = first ? a : b, *drain = first ? b : a;
    if (q->kind != VBSS_PAIR_EDGE_EDGE || drain->kind != SCENE_BODY_DRAIN ||
        needle->kind != SCENE_BODY_RIGID || needle->rigid.needle == NULL) {
        return 1.0;
    }
    const double reach = SCENE_EXCLUSION_ARC_RATIO * contact_distance_of(s, q);
    scene_axis_interval interval = {.started = false};
    double earliest = 1.0;
    while (vbss_scene_next_axis_interval(s, needle, first ? q->a : q->b, drain, first ? q->b : q->a,
                                         reach, &interval)) {
        const ccd_query query = {q, &interval, 0.0};
        if (time_of_approach(s, &query, min_contact_distance(s, q)) < 1.0) {
            earliest = vbss_min(time_of_impact_at_holes(s, q, &interval), earliest);
        }
    }
    return earliest;
}

static bool is_of_suture_and_wall(const scene_object *s, const collision_candidate *q)
{
    const scene_body *a = &s->bodies[s->body_of_shape[q->shape_a]];
    const scene_body *b = &s->bodies[s->body_of_shape[q->shape_b]];
    return (a->kind == SCENE_BODY_DRAIN && vbss_scene_is_suture(b)) ||
           (b->kind == SCENE_BODY_DRAIN && vbss_scene_is_suture(a));
}

static bool is_of_needle_and_wall(const scene_object *s, const collision_candidate *q)
{
    const scene_body *a = &s->bodies[s->body_of_shape[q->shape_a]];
    const scene_body *b = &s->bodies[s->body_of_shape[q->shape_b]];
    return (a->kind == SCENE_BODY_DRAIN && b->kind == SCENE_BODY_RIGID &&
            b->rigid.needle != NULL) ||
           (b->kind == SCENE_BODY_DRAIN && a->kind == SCENE_BODY_RIGID && a->rigid.needle != NULL);
}

/* Whether a pair that starts near stays beyond half the contact distance, as most that hit do.
 * Needles at walls are excepted: they are tested by intervals, which may start farther away. */
static bool stays_beyond_ccd_distance(scene_object *s, const ccd_query *query)
{
    double coordinates[3], distance = distance_at_start(s, query, coordinates),
                           contact_distance = contact_distance_of(s, query->candidate);
    const double ccd_distance = SCENE_CCD_DISTANCE_RATIO * contact_distance *
                                (1.0 + 2.0 * s->collision->ccd_options.tolerance);
    vbss_collision_store_separation(s->collision, query->candidate, distance);
    return distance < contact_distance + s->config.contact_margin &&
           vbss_collision_stays_separated(s->collision, query->candidate, ccd_distance) &&
           !is_of_needle_and_wall(s, query->candidate);
}

/* Time of impact of a pair that came nearer than contacts let it. */
static double refine_time_of_impact(scene_object *s, const collision_candidate *q, double time)
{
    const ccd_query query = {q, NULL, 0.0};
    if (stays_beyond_ccd_distance(s, &query)) {
        return 1.0;
    }
    const double scale = contact_scale_of_pair(s, q, contact_distance_of(s, q));
    double coordinates[3];
    if (scale < 1.0 && is_of_suture_and_wall(s, q)) {
        return vbss_min(time_of_impact_at_holes(s, q, NULL), time_of_impact_beside_holes(s, q));
    }
    if (scale <= 0.0) {
        return 1.0;
    }
    double listed_distance = contact_distance_of(s, q) + s->config.contact_margin;
    return scale >= 1.0 && distance_at_start(s, &query, coordinates) >= listed_distance
               ? time
               : time_of_impact(s, &query, (contact_scales){scale, scale, false});
}

/* Gathers the next candidates of one kind that need a test, from `*next` on. Returns their number,
 * and their indices. */
static uint32_t gather_batch(scene_object *s, uint32_t *next,
                             uint32_t indices[COLLISION_BLOCK_SIZE])
{
    const collision_object *c = s->collision;
    uint32_t count = 0;
    for (; *next < c->candidate_count && count < COLLISION_BLOCK_SIZE; ++*next) {
        const collision_candidate *q = &c->candidates[*next];
        bool is_other_shape_pair =
            *next == 0 || q->shape_a != q[-1].shape_a || q->shape_b != q[-1].shape_b;
        uint32_t first_of_others = is_other_shape_pair ? skip_slow_pairs(s, *next) : *next;
        if (first_of_others > *next || is_slow_pair(s, q)) {
            *next = first_of_others > *next ? first_of_others - 1 : *next;
            continue;
        }
        if (count > 0 && q->kind != c->candidates[indices[0]].kind) {
            break;
        }
        s->report.statistics.guard_pairs++;
        if (scene_is_known_apart(s, q, 0.0)) {
            continue;
        }
        set_batch_query(s, &(ccd_query){q, NULL, 0.0}, count);
        indices[count++] = *next;
    }
    return count;
}

static scene_touching_pair bodies_of(const scene_object *s, const collision_candidate *q)
{
    return (scene_touching_pair){s->bodies[s->body_of_shape[q->shape_a]].number,
                                 s->bodies[s->body_of_shape[q->shape_b]].number};
}

/* Notes an impact if it is the first. */
static void record_impact(scene_object *s, double time, scene_touching_pair bodies)
{
    if (time < s->step.time_of_impact) {
        s->step.time_of_impact = time;
        s->step.first_impact = bodies;
    }
}

static void find_first_impact(scene_object *s)
{
    const collision_object *c = s->collision;
    uint32_t indices[COLLISION_BLOCK_SIZE], count, next = 0;
    while ((count = gather_batch(s, &next, indices)) > 0) {
        double time[COLLISION_BLOCK_SIZE];
        bool hit[COLLISION_BLOCK_SIZE];
        run_ccd_batch(s, c->candidates[indices[0]].kind, count);
        for (uint32_t i = 0; i < count; i++) { /* the tests below overwrite the batch */
            hit[i] = s->scratch.ccd_batch->hit[i] != 0;
            time[i] = s->scratch.ccd_batch->time[i];
        }
        for (uint32_t i = 0; i < count; i++) {
            const collision_candidate *q = &c->candidates[indices[i]];
            if (hit[i]) {
                record_impact(s, refine_time_of_impact(s, q, time[i]), bodies_of(s, q));
            }
        }
    }
}

/* ---- floor */

static double time_of_floor_impact(const scene_object *s, vec3 start, vec3 end, double radius)
{
    double start_height = vec3_dot(start, s->floor_normal) - s->config.floor_height;
    double end_height = vec3_dot(end, s->floor_normal) - s->config.floor_height;
    double min_height = SCENE_CCD_FLOOR_RATIO * radius;
    if (start_height < min_height) { /* started too low already */
        min_height = start_height - (1.0 - SCENE_CCD_RATIO_WHEN_NEARER) * fabs(start_height);
    }
    return end_height >= min_height ? 1.0
                                    : (start_height - min_height) / (start_height - end_height);
}

static void find_first_floor_impact(scene_object *s)
{
    for (uint32_t i = 0; s->config.floor != 0 && i < s->body_count; i++) {
        const scene_body *b = &s->bodies[i];
        const thread_object *t = b->thread.thread;
        const scene_rigid *r = &b->rigid;
        double earliest = 1.0;
        for (uint32_t k = 0; scene_active_kind(b) == SCENE_BODY_THREAD && k < t->node_count; k++) {
            double impact_time =
                time_of_floor_impact(s, t->now.x[k], t->trial[k], t->config.radius);
            earliest = vbss_min(impact_time, earliest);
        }
        for (uint32_t k = 0; scene_active_kind(b) == SCENE_BODY_RIGID && k < 2 * r->capsule_count;
             k++) {
            const scene_capsule *c = &s->capsules[r->first_capsule + k / 2];
            double impact_time = time_of_floor_impact(s, c->now[k % 2], c->trial[k % 2], c->radius);
            earliest = vbss_min(impact_time, earliest);
        }
        const drain_object *d = b->drain.drain;
        for (uint32_t k = 0; scene_active_kind(b) == SCENE_BODY_DRAIN && k < d->mesh.node_count;
             k++) {
            double impact_time =
                time_of_floor_impact(s, d->x[k], d->trial[k], 0.5 * d->config.thickness);
            earliest = vbss_min(impact_time, earliest);
        }
        record_impact(s, earliest, (scene_touching_pair){b->number, 0});
    }
}

scene_substep_outcome vbss_scene_run_ccd(scene_object *s)
{
    scene_substep_outcome outcome = list_ccd_pairs(s);
    if (outcome != SCENE_SUBSTEP_ACCEPTED) {
        return outcome;
    }
    vbss_scene_find_trial_slides(s);
    s->step.time_of_impact = 1.0;
    find_first_impact(s);
    find_first_floor_impact(s);
    return s->step.time_of_impact < 1.0 ? SCENE_SUBSTEP_CCD_HIT : SCENE_SUBSTEP_ACCEPTED;
}
