/* Narrow phase: closest points, normal, gap and contact distance of two features; then Jacobian and
 * tangential displacement of their contact.
 *
 * A side of a contact is a point that moves with its body: a weighted mean of nodes, or a point of
 * a rigid body's surface. Friction needs its displacement since the start of the substep. */
#include "collision/closest.h"
#include "scene/contacts/contacts.h"
#include "scene/tuning.h"
#include "scene/world/world.h"

/* Weights of a node and its neighbours that make the point of a smooth curve: on a polygon round a circle they
 * give Coulomb friction the law of the rope to second order of the turn between segments. Derived. */
#define SMOOTH_NODE (11.0 / 12.0)
#define SMOOTH_NEIGHBOUR (1.0 / 24.0)

/* One of the two features of a contact. It has one vertex if it is a point, two if a segment or
 * edge, three if a triangle. */
typedef struct side {
    const scene_body *body;
    const scene_capsule *capsule; /* NULL unless the body is rigid */
    uint32_t feature, vertex_count;
    uint32_t nodes[3]; /* set only if the body is a drain or static mesh */
    /* a triangle beside a drain's free edge, or beside a node of one; SCENE_NO_FACE: no lip */
    uint32_t lip;
    bool smooth; /* a node, at the point of the smoothed curve there */
    double radius;
} side;

/* AT_PREDICTED: start plus expected displacement */
typedef enum moment { AT_START, AT_PREDICTED, AT_TRIAL } moment;

/* ---- sides */

/* Finds a body by its number. Constraints are sorted by body, so it is mostly the last one. */
static const scene_body *body_of(const scene_object *s, uint32_t number, const scene_body *last)
{
    return last != NULL && last->number == number ? last : vbss_scene_body(s, number);
}

static inline side side_of(const scene_object *s, const contact_constraint *constraint,
                           const scene_body *b, int which)
{
    uint32_t kind = constraint->key.kind,
             feature = which == 0 ? constraint->key.feature_a : constraint->key.feature_b;
    side d; /* `nodes` stay unset unless the body is a drain or static mesh */
    d.body = b;
    d.capsule = NULL;
    d.feature = feature;
    d.lip = SCENE_NO_FACE;
    d.smooth = false;
    bool point =
        which == 0 && (scene_is_node_contact(kind) || kind == VBSS_SCENE_CONTACT_CAPSULE_FLOOR);
    d.vertex_count = point ? 1 : 2;
    if (b->kind == SCENE_BODY_DRAIN) {
        d.vertex_count = vbss_scene_surface_feature_nodes(s, b, kind, which == 1, feature, d.nodes);
        d.radius = 0.5 * b->drain.drain->config.thickness;
        if (kind == VBSS_SCENE_CONTACT_SIDES) {
            d.lip = b->drain.lip_of_side[feature];
        } else if (kind == VBSS_SCENE_CONTACT_POINT_FACE && which == 0) {
            d.lip = b->drain.lip_of_node[feature];
        }
        return d;
    }
    if (b->kind == SCENE_BODY_THREAD) {
        if (kind == VBSS_SCENE_CONTACT_SEGMENTS) {
            d.feature = scene_geometry_of(s, constraint)->segments[which];
        }
        /* end nodes of a thread are not smoothed */
        d.smooth = kind == VBSS_SCENE_CONTACT_NODE_CAPSULE && feature > 0 &&
                   feature + 1 < b->thread.thread->node_count;
        d.radius = b->thread.thread->config.radius;
        return d;
    }
    if (scene_is_mesh(b)) {
        d.vertex_count = vbss_scene_surface_feature_nodes(s, b, kind, which == 1, feature, d.nodes);
        d.radius = s->collision->shapes[b->shape]->radius;
        return d;
    }
    d.capsule = &s->capsules[b->rigid.first_capsule + (point ? feature / 2 : feature)];
    d.radius = d.capsule->radius;
    return d;
}

static vec3 smooth_point(const vec3 *x)
{
    return vec3_add_scaled(vec3_scale(x[0], SMOOTH_NODE), SMOOTH_NEIGHBOUR, vec3_add(x[-1], x[1]));
}

static void get_thread_vertices(const side *d, const vec3 *x, vec3 vertices[3])
{
    x += d->feature;
    vertices[0] = d->smooth ? smooth_point(x) : x[0];
    vertices[1] = d->vertex_count > 1 ? x[1] : vertices[0];
}

static void get_capsule_vertices(const side *d, const vec3 ends[2], vec3 vertices[3])
{
    vertices[0] = ends[d->vertex_count > 1 ? 0 : d->feature % 2];
    vertices[1] = ends[1];
}

static void get_surface_vertices(const side *d, const vec3 *x, vec3 vertices[3])
{
    vertices[1] = x[d->nodes[0]]; /* also for a point, which has no second vertex */
    for (uint32_t k = 0; k < d->vertex_count; k++) {
        vertices[k] = x[d->nodes[k]];
    }
}

static void get_mesh_vertices(const side *d, scene_vertices x, vec3 vertices[3])
{
    vertices[1] = scene_vertex(x, d->nodes[0]);
    for (uint32_t k = 0; k < d->vertex_count; k++) {
        vertices[k] = scene_vertex(x, d->nodes[k]);
    }
}

/* At the start of the motion the shape has the positions of all nodes of listed pairs. They have the same bits as those that the pose
 * gives. */
static void get_posed_vertices(const side *d, const collision_shape *shape, const pose *at,
                               vec3 vertices[3])
{
    const collision_posed *p = shape->posed;
    for (uint32_t k = 0; k < d->vertex_count; k++) {
        const uint32_t n = d->nodes[k];
        vertices[k] =
            p->mark[n] == p->present_mark ? shape->start[n] : pose_apply(*at, p->local[n]);
    }
    if (d->vertex_count == 1) {
        vertices[1] = vertices[0];
    }
}

/* Vertices of a mesh. The motion of a host surface is known, and needs no prediction. */
static scene_vertices mesh_vertices(const scene_object *s, const scene_body *b, moment when)
{
    if (when == AT_PREDICTED && scene_is_rigid_mesh(b)) {
        return (scene_vertices){s->collision->shapes[b->shape]->posed->local, &b->rigid.expected};
    }
    return when == AT_START ? scene_mesh_vertices(s, b) : scene_mesh_trial_vertices(s, b);
}

/* For threads and capsules only: contacts of drains keep the normal of the start, and need
 * no prediction. */
static void add_displacement(const scene_object *s, const side *d, vec3 vertices[3])
{
    vec3 displacement[3];
    if (d->capsule == NULL) {
        get_thread_vertices(d, s->step.expected_displacements + d->body->thread.first_node,
                            displacement);
    } else {
        size_t number = (size_t)(d->capsule - s->capsules);
        get_capsule_vertices(
            d, s->step.expected_displacements + s->config.node_capacity + 2 * number, displacement);
    }
    vertices[0] = vec3_add(vertices[0], displacement[0]);
    vertices[1] = vec3_add(vertices[1], displacement[1]); /* unused for a point */
}

static void get_vertices(const scene_object *s, const side *d, moment when, vec3 vertices[3])
{
    const scene_body *b = d->body;
    bool trial = when == AT_TRIAL;
    if (b->kind == SCENE_BODY_THREAD) {
        const thread_object *t = b->thread.thread;
        get_thread_vertices(d, trial ? t->trial : t->now.x, vertices);
    } else if (b->kind == SCENE_BODY_DRAIN) {
        const drain_object *own = b->drain.drain;
        get_surface_vertices(d, trial ? own->trial : own->x, vertices);
    } else if (d->capsule == NULL && when == AT_START && scene_is_rigid_mesh(b) &&
               vbss_collision_begins_at(s->collision->shapes[b->shape], &b->rigid.body.now.pose)) {
        get_posed_vertices(d, s->collision->shapes[b->shape], &b->rigid.body.now.pose, vertices);
    } else if (d->capsule == NULL) {
        get_mesh_vertices(d, mesh_vertices(s, b, when), vertices);
    } else {
        get_capsule_vertices(d, trial ? d->capsule->trial : d->capsule->now, vertices);
    }
    if (when == AT_PREDICTED && !scene_is_mesh(b)) {
        add_displacement(s, d, vertices);
    }
}

/* Vector from the closest point of b to that of a. `at` gets the place of both: for two segments,
 * the fraction on each; for a point and a segment, 0 and the fraction; for a point and a triangle,
 * the weights of its second and third corner. */
static inline vec3 closest_separation(const side *d, const side *e, const vec3 a[3],
                                      const vec3 b[3], double at[2])
{
    if (e->vertex_count == 3) {
        double weights[3];
        const vec3 corners[3] = {vec3_sub(b[0], a[0]), vec3_sub(b[1], a[0]), vec3_sub(b[2], a[0])};
        vec3 to = closest_on_triangle(corners, weights);
        at[0] = weights[1];
        at[1] = weights[2];
        return vec3_neg(to);
    }
    vec3 along = vec3_sub(b[1], b[0]);
    if (d->vertex_count == 1) {
        vec3 to = vec3_sub(a[0], b[0]);
        at[0] = 0.0;
        at[1] = closest_on_edge(along, to);
        return vec3_add_scaled(to, -at[1], along);
    }
    return vec3_neg(
        closest_between_edges(vec3_sub(a[1], a[0]), along, vec3_sub(b[0], a[0]), &at[0], &at[1]));
}

/* ---- lips: against another wall, the flat face of a cut is a line across its own wall */

static bool is_flat(const side *d, const side *e)
{
    return d->lip != SCENE_NO_FACE && e->body->kind == SCENE_BODY_DRAIN;
}

/* Distance of the surface from the wall's middle, or from the line of a lip, m. */
static double radius_against(const side *d, const side *e)
{
    return is_flat(d, e) ? 2.0 * SCENE_LIP_RADIUS_RATIO * d->radius : d->radius;
}

static double contact_distance_of(const side *d, const side *e)
{
    return radius_against(d, e) + radius_against(e, d);
}

/* An edge that ends at a lip is round there. The lip ends in the same node, and its contact has the
 * same point. */
static bool ends_at_lip(const side *d, double at)
{
    bool end = at == 0.0 || at == 1.0;
    return d->vertex_count == 2 && d->lip == SCENE_NO_FACE && end &&
           d->body->drain.lip_of_node[d->nodes[at == 1.0 ? 1 : 0]] != SCENE_NO_FACE;
}

/* Whether the contact of a lip has the same point. */
static bool is_covered_by_lips(const side *d, const side *e, const scene_contact_geometry *geometry)
{
    return d->body->kind == SCENE_BODY_DRAIN && e->body->kind == SCENE_BODY_DRAIN &&
           (ends_at_lip(d, geometry->barycentric[0]) || ends_at_lip(e, geometry->barycentric[1]));
}

static vec3 normal_of_lip(const scene_object *s, const side *d, moment when)
{
    const uint32_t *nodes = s->collision->shapes[d->body->shape]->triangles[d->lip];
    const side face = {.body = d->body, .vertex_count = 3, .nodes = {nodes[0], nodes[1], nodes[2]}};
    vec3 x[3];
    get_vertices(s, &face, when, x);
    return vec3_unit_or(vec3_cross(vec3_sub(x[1], x[0]), vec3_sub(x[2], x[0])), vec3_zero());
}

/* Vector along the line of a lip, from one rounded end to the other; zero for a round feature. */
static vec3 line_through_lip(const scene_object *s, const side *d, const side *e, moment when)
{
    const double height = 2.0 * (1.0 - 2.0 * SCENE_LIP_RADIUS_RATIO) * d->radius;
    return is_flat(d, e) ? vec3_scale(normal_of_lip(s, d, when), height) : vec3_zero();
}

/* Separation of two walls of which at least one is a lip: from the line of e to the line of d.
 * `mid_separation` is that of their middles. `lip_thickness`: the part of it that is wall, m. */
static vec3 lip_separation(const scene_object *s, const side *d, const side *e, moment when,
                           vec3 mid_separation, double *lip_thickness)
{
    double at[2];
    vec3 one = line_through_lip(s, d, e, when), other = line_through_lip(s, e, d, when);
    vec3 offset = vec3_sub(vec3_scale(vec3_sub(one, other), 0.5), mid_separation);
    vec3 separation_vector = vec3_neg(closest_between_edges(one, other, offset, &at[0], &at[1]));
    double distance = vec3_norm(separation_vector);
    *lip_thickness =
        vec3_dot(separation_vector, mid_separation) / vbss_max(distance, DBL_MIN) - distance;
    return separation_vector;
}

/* Whether only an interval of the axis is tested, beside a hole. */
static bool is_clipped(const scene_contact_geometry *geometry)
{
    return geometry->axis_interval[0][0] > 0.0 || geometry->axis_interval[0][1] < 1.0;
}

/* Separation of two features, from b to a, between their axes, middle surfaces, or lines of lips.
 * `at`: places of the closest points. `lip_thickness`: as for two lips, else 0. */
static inline vec3 separation_of(const scene_object *s, const scene_contact_geometry *geometry,
                                 const side *d, const side *e, moment when, double at[2],
                                 double *lip_thickness)
{
    vec3 one[3], other[3];
    get_vertices(s, d, when, one);
    get_vertices(s, e, when, other);
    bool clipped = is_clipped(geometry);
    if (clipped) {
        scene_clip_axis(one, geometry->axis_interval[0]);
        scene_clip_axis(other, geometry->axis_interval[1]);
    }
    vec3 separation_vector = closest_separation(d, e, one, other, at);
    for (int k = 0; clipped && k < 2; k++) {
        at[k] = geometry->axis_interval[k][0] +
                at[k] * (geometry->axis_interval[k][1] - geometry->axis_interval[k][0]);
    }
    *lip_thickness = 0.0;
    return is_flat(d, e) || is_flat(e, d)
               ? lip_separation(s, d, e, when, separation_vector, lip_thickness)
               : separation_vector;
}

/* Barycentric weights of a side's vertices in the contact point. */
static inline void compute_weights(const side *d, const scene_contact_geometry *geometry, int which,
                                   double weights[3])
{
    weights[0] = 1.0;
    weights[1] = weights[2] = 0.0;
    if (d->vertex_count == 2) {
        weights[0] = 1.0 - geometry->barycentric[which];
        weights[1] = geometry->barycentric[which];
    } else if (d->vertex_count == 3) {
        weights[0] = 1.0 - geometry->barycentric[0] - geometry->barycentric[1];
        weights[1] = geometry->barycentric[0];
        weights[2] = geometry->barycentric[1];
    }
}

static inline vec3 point_of(const side *d, const vec3 vertices[3], const double weights[3])
{
    if (d->vertex_count == 2) {
        return vec3_lerp(vertices[0], vertices[1], weights[1]);
    }
    if (d->vertex_count == 1) {
        return vertices[0];
    }
    vec3 point = vec3_add_scaled(vec3_scale(vertices[0], weights[0]), weights[1], vertices[1]);
    return vec3_add_scaled(point, weights[2], vertices[2]);
}

/* ---- Jacobian */

/* Adds the Jacobian blocks of `point` on the surface of one side. `sign`: 1 for side a, -1 for
 * side b. */
static void add_jacobian(const scene_object *s, contact_constraint *constraint, const side *d,
                         const double weights[3], vec3 point, double sign)
{
    const scene_body *b = d->body;
    if (scene_is_compliant(scene_host_surface_of(b))) {
        for (uint32_t k = 0; k < d->vertex_count && k < 3; k++) {
            vbss_scene_add_jacobian_block(constraint,
                                          scene_first_vertex_block(&b->rigid) +
                                              b->rigid.surface->touched_index[d->nodes[k]],
                                          sign * weights[k]);
        }
    } else if (b->kind == SCENE_BODY_RIGID) {
        vbss_scene_add_rigid_jacobian(constraint, &b->rigid, point, sign);
    } else if (b->kind == SCENE_BODY_DRAIN) {
        for (uint32_t k = 0; k < d->vertex_count && k < 3; k++) {
            uint32_t order_index = b->drain.drain->order.block_index[d->nodes[k]];
            vbss_scene_add_jacobian_block(constraint, b->drain.first_block + order_index,
                                          sign * weights[k]);
        }
    } else if (d->vertex_count > 1) {
        const uint32_t first = constraint->jacobian_block_count;
        vbss_scene_add_node_jacobian(s, constraint, b, d->feature, sign * weights[0]);
        vbss_scene_add_node_jacobian(s, constraint, b, d->feature + 1, sign * weights[1]);
        if (constraint->is_sliding) {
            vbss_scene_set_slide_derivatives(constraint, first, b, d->feature, sign < 0.0);
        }
    } else {
        vbss_scene_add_node_jacobian(s, constraint, b, d->feature,
                                     sign * (d->smooth ? SMOOTH_NODE : 1.0));
        if (d->smooth) {
            vbss_scene_add_node_jacobian(s, constraint, b, d->feature - 1, sign * SMOOTH_NEIGHBOUR);
            vbss_scene_add_node_jacobian(s, constraint, b, d->feature + 1, sign * SMOOTH_NEIGHBOUR);
        }
    }
}

/* Position at the start of the substep of a point on a rigid body's surface. The point turns with
 * the body, also about the capsule's own axis. */
static vec3 point_at_start(const side *d, double at, vec3 point)
{
    const scene_rigid *r = &d->body->rigid;
    const scene_capsule *c = d->capsule;
    uint32_t first = d->vertex_count == 1 ? d->feature % 2 : 0,
             last = d->vertex_count == 1 ? first : 1;
    /* motion of a jaw relative to its body */
    vec3 moved = vec3_lerp(vec3_sub(c->local_trial[first], c->local[first]),
                           vec3_sub(c->local_trial[last], c->local[last]), at);
    return pose_apply(r->body.now.pose, vec3_sub(pose_apply_inverse(r->trial, point), moved));
}

/* ---- contacts */

static double body_friction(const scene_object *s, const scene_body *b)
{
    return b == NULL                      ? s->settings.floor_friction
           : b->kind == SCENE_BODY_THREAD ? s->settings.thread_friction
           : b->kind == SCENE_BODY_RIGID  ? b->rigid.friction
                                          : b->drain.friction;
}

static bool is_thread(const scene_body *b)
{
    return b != NULL && b->kind == SCENE_BODY_THREAD;
}

/* With a thread, the friction of the other body counts; else the geometric mean. */
static double pair_friction(const scene_object *s, const scene_body *a, const scene_body *b)
{
    if (is_thread(a) || is_thread(b)) {
        return body_friction(s, is_thread(a) ? b : a);
    }
    return sqrt(body_friction(s, a) * body_friction(s, b));
}

/* Augmentation r, N/m. Contacts of rigid bodies only scale it with the mass of the lighter one. */
static double augmentation_of(const scene_body *a, const scene_body *b, double h)
{
    if (a->kind != SCENE_BODY_RIGID || (b != NULL && b->kind != SCENE_BODY_RIGID) ||
        scene_is_compliant(scene_host_surface_of(b))) {
        return SCENE_NODE_AUGMENTATION;
    }
    double mass = a->rigid.body.mass;
    if (b != NULL && b->rigid.kind != VBSS_SCENE_RIGID_DRIVEN) {
        mass = vbss_min(mass, b->rigid.body.mass);
    }
    return SCENE_RIGID_AUGMENTATION * mass / (h * h);
}

/* Updates one side of a contact whose normal and closest points are known: its Jacobian and its
 * part of the displacement. `out` points from the axis, or the middle of a wall, to the surface.
 * Returns the point on the axis or middle surface. */
static vec3 update_side(const scene_object *s, contact_constraint *constraint, const side *d,
                        int which, vec3 out, double sign)
{
    const scene_contact_geometry *geometry = scene_geometry_of(s, constraint);
    vec3 vertices[3], start_vertices[3], start_point;
    double weights[3];
    vertices[2] = start_vertices[2] = vec3_zero(); /* only a triangle has a third vertex */
    compute_weights(d, geometry, which, weights);
    get_vertices(s, d, AT_TRIAL, vertices);
    if (scene_is_static_mesh(d->body)) { /* the system does not know it, as it never moves */
        return point_of(d, vertices, weights);
    }
    vec3 centre = point_of(d, vertices, weights), point = vec3_add(centre, out);
    add_jacobian(s, constraint, d, weights, point, sign);
    if (scene_is_rigid_mesh(d->body)) { /* the point of the surface, which turns with the body */
        const scene_rigid *r = &d->body->rigid;
        start_point = pose_apply(r->body.now.pose, pose_apply_inverse(r->trial, point));
        constraint->relative_displacement =
            vec3_add_scaled(constraint->relative_displacement, sign, vec3_sub(point, start_point));
    } else if (d->capsule != NULL) {
        start_point =
            point_at_start(d, d->vertex_count > 1 ? geometry->barycentric[which] : 0.0, point);
        constraint->relative_displacement =
            vec3_add_scaled(constraint->relative_displacement, sign, vec3_sub(point, start_point));
    } else {
        get_vertices(s, d, AT_START, start_vertices);
        start_point = point_of(d, start_vertices, weights);
        constraint->relative_displacement =
            vec3_add_scaled(constraint->relative_displacement, sign, vec3_sub(centre, start_point));
    }
    return centre;
}

static void update_geometry(const scene_object *s, contact_constraint *constraint, const side *d,
                            const side *e)
{
    scene_contact_geometry *geometry = scene_geometry_of(s, constraint);
    const vec3 n = constraint->normal;
    constraint->jacobian_block_count = 0;
    constraint->relative_displacement = vec3_zero();
    vec3 out = vec3_scale(n, -d->radius), centre_a = update_side(s, constraint, d, 0, out, 1.0);
    if (e == NULL) {
        const scene_plane plane = scene_plane_of(s, vbss_scene_body(s, constraint->key.body_b));
        constraint->gap = vec3_dot(n, centre_a) - plane.height - d->radius;
    } else {
        vec3 centre_b = update_side(s, constraint, e, 1, vec3_scale(n, e->radius), -1.0);
        constraint->gap = vec3_dot(n, vec3_sub(centre_a, centre_b)) - contact_distance_of(d, e) -
                          geometry->lip_thickness + geometry->overlap_allowance;
    }
    if (s->step.spring_capacity > 0) { /* some thread has friction torque */
        vbss_scene_add_roll_jacobian(s, constraint, d->body, false);
        vbss_scene_add_roll_jacobian(s, constraint, e != NULL ? e->body : NULL, true);
    }
    geometry->point = vec3_add_scaled(vec3_add(centre_a, out), -0.5 * constraint->gap, n);
}

static bool is_mesh_edge(const side *e)
{
    return e->vertex_count == 2 && scene_is_mesh(e->body);
}

/* Whether a contact keeps the normal of the start of the substep. Normals of segments jump, or turn
 * fast because the radius is small. A prediction from inexact velocities makes them worse, and
 * tight knots tremble. */
static bool keeps_start_normal(const contact_constraint *constraint, const side *d, const side *e)
{
    return constraint->key.kind == VBSS_SCENE_CONTACT_SEGMENTS ||
           constraint->key.kind == VBSS_SCENE_CONTACT_SEGMENT_CAPSULE ||
           (constraint->key.kind == VBSS_SCENE_CONTACT_SIDES &&
            (!is_mesh_edge(e) || d->body->kind == SCENE_BODY_DRAIN)) ||
           constraint->key.kind == VBSS_SCENE_CONTACT_POINT_FACE;
}

/* Whether the closest point is inside the triangle, not on one of its edges. */
static bool is_inside_face(const scene_contact_geometry *geometry)
{
    return geometry->barycentric[0] > 0.0 && geometry->barycentric[1] > 0.0 &&
           geometry->barycentric[0] + geometry->barycentric[1] < 1.0;
}

/* Normal of features at a distance from each other. `separation` has that length. */
static vec3 normal_along(const scene_object *s, const side *e,
                         const scene_contact_geometry *geometry, moment when, vec3 separation,
                         double distance)
{
    return is_mesh_edge(e) ? vbss_scene_mesh_normal(s, e->body, mesh_vertices(s, e->body, when),
                                                    e->feature, geometry->barycentric[1],
                                                    geometry->contact_distance, separation)
                           : vec3_scale(separation, 1.0 / distance);
}

/* Normal of features that intersect: any direction across both will do. */
static vec3 fallback_normal(const scene_object *s, const side *d, const side *e)
{
    vec3 one[3], other[3];
    get_vertices(s, d, AT_START, one);
    get_vertices(s, e, AT_START, other);
    vec3 from = e->vertex_count == 3 ? vec3_sub(other[2], other[0]) : vec3_sub(one[1], one[0]);
    vec3 normal = vec3_cross(from, vec3_sub(other[1], other[0]));
    return vec3_unit_or(normal, vec3_make(0.0, 1.0, 0.0));
}

bool vbss_scene_run_narrow_phase(const scene_object *s, contact_constraint *constraint,
                                 const scene_body *a, const scene_body *b, double reach)
{
    scene_contact_geometry *geometry = scene_geometry_of(s, constraint);
    const side d = side_of(s, constraint, a, 0);
    if (b == NULL || scene_is_plane(b)) {
        const scene_plane plane = scene_plane_of(s, b);
        vec3 one[3];
        get_vertices(s, &d, AT_START, one);
        constraint->normal = plane.normal;
        geometry->barycentric[0] = geometry->barycentric[1] = 0.0;
        constraint->thickness = 2.0 * d.radius;
        geometry->contact_distance = d.radius;
        geometry->start_gap = scene_height_over(plane, one[0]) - d.radius;
        return geometry->start_gap < reach;
    }
    const side e = side_of(s, constraint, b, 1);
    vec3 separation_vector = separation_of(s, geometry, &d, &e, AT_START, geometry->barycentric,
                                           &geometry->lip_thickness);
    double distance = vec3_norm(separation_vector), contact_distance = contact_distance_of(&d, &e);
    constraint->thickness = 2.0 * vbss_min(d.radius, e.radius); /* lips too, as they are soft */
    geometry->contact_distance = contact_distance;
    geometry->start_gap = distance - contact_distance;
    if (!(geometry->start_gap < reach) || (e.vertex_count == 3 && !is_inside_face(geometry)) ||
        is_covered_by_lips(&d, &e, geometry)) {
        return false;
    }
    constraint->normal = distance > SCENE_MIN_DISTANCE_RATIO * contact_distance
                             ? normal_along(s, &e, geometry, AT_START, separation_vector, distance)
                             : fallback_normal(s, &d, &e);
    if (keeps_start_normal(constraint, &d, &e)) {
        return true;
    }
    /* The force acts at the end of the substep. The normal of the start would lean back and brake
     * by v h / R. */
    double at[2], lip_thickness;
    vec3 predicted = separation_of(s, geometry, &d, &e, AT_PREDICTED, at, &lip_thickness);
    double predicted_distance = vec3_norm(predicted);
    if (predicted_distance > SCENE_MIN_PREDICTED_RATIO * contact_distance &&
        vec3_dot(predicted, constraint->normal) > SCENE_MIN_NORMAL_COSINE * predicted_distance) {
        geometry->barycentric[0] = at[0];
        geometry->barycentric[1] = at[1];
        constraint->normal =
            normal_along(s, &e, geometry, AT_PREDICTED, predicted, predicted_distance);
        geometry->lip_thickness = lip_thickness;
    }
    return true;
}

typedef enum geometry_update {
    INIT_CONTACT,
    REFRESH_GEOMETRY,
    REFRESH_NORMAL,
    MEASURE_GAP
} geometry_update;

static void refresh_normal(const scene_object *s, contact_constraint *constraint, const side *d,
                           const side *e)
{
    scene_contact_geometry *geometry = scene_geometry_of(s, constraint);
    vec3 direction =
        separation_of(s, geometry, d, e, AT_TRIAL, geometry->barycentric, &geometry->lip_thickness);
    if (is_mesh_edge(e)) {
        direction =
            vbss_scene_mesh_normal(s, e->body, mesh_vertices(s, e->body, AT_TRIAL), e->feature,
                                   geometry->barycentric[1], geometry->contact_distance, direction);
    }
    constraint->normal = vec3_unit_or(direction, constraint->normal);
    constraint->previous_force =
        vbss_contact_rotate_to_tangent_plane(constraint->previous_force, constraint->normal);
    constraint->solution.slip_direction =
        vec3_unit_or(vbss_contact_rotate_to_tangent_plane(constraint->solution.slip_direction,
                                                          constraint->normal),
                     constraint->solution.slip_direction);
}

static void measure_gap(const scene_object *s, contact_constraint *constraint, const side *d,
                        const side *e)
{
    const scene_contact_geometry *geometry = scene_geometry_of(s, constraint);
    double at[2], lip_thickness;
    side a = *d, b = *e;
    if (constraint->key.kind == VBSS_SCENE_CONTACT_SEGMENTS) { /* the start gap is theirs */
        a.feature = constraint->key.feature_a;
        b.feature = constraint->key.feature_b;
    }
    constraint->gap = vec3_norm(separation_of(s, geometry, &a, &b, AT_TRIAL, at, &lip_thickness)) -
                      contact_distance_of(d, e) + geometry->overlap_allowance;
}

/* `e` is NULL for a plane, whose normal is constant. */
static void update_contact(const scene_object *s, contact_constraint *constraint, const side *d,
                           const side *e, geometry_update update)
{
    if (update == MEASURE_GAP && e != NULL) {
        measure_gap(s, constraint, d, e);
    }
    if (update == REFRESH_NORMAL && e != NULL) {
        refresh_normal(s, constraint, d, e);
    }
    if (update == REFRESH_GEOMETRY && constraint->is_sliding) {
        vbss_scene_update_slide(s, constraint);
    }
    if (update != MEASURE_GAP) {
        update_geometry(s, constraint, d, e);
    }
}

static void update_contacts(scene_object *s, geometry_update update, double h)
{
    const scene_body *a = NULL, *b = NULL;
    for (uint32_t i = 0; i < s->contacts->count; i++) {
        contact_constraint *constraint = &s->contacts->constraints[i];
        if (constraint->is_bilateral) {
            if (update != MEASURE_GAP) {
                vbss_scene_update_bilateral_constraint(s, constraint);
            }
            continue;
        }
        a = body_of(s, constraint->key.body_a, a);
        b = constraint->key.body_b == 0 ? NULL : body_of(s, constraint->key.body_b, b);
        if (update == INIT_CONTACT) {
            constraint->friction = pair_friction(s, a, b);
            constraint->stiffness = s->config.contact_stiffness;
            constraint->augmentation = augmentation_of(a, b, h);
            constraint->elastic_slip_limit =
                constraint->key.kind == VBSS_SCENE_CONTACT_NODE_FLOOR
                    ? SCENE_FLOOR_ELASTIC_SLIP_RATIO * constraint->thickness
                    : 0.0;
        }
        const side d = side_of(s, constraint, a, 0);
        if (b == NULL || scene_is_plane(b)) {
            update_contact(s, constraint, &d, NULL, update);
        } else {
            const side e = side_of(s, constraint, b, 1);
            update_contact(s, constraint, &d, &e, update);
        }
    }
}

/* The first solve evaluates gaps along the normals of the start of the substep. */
void vbss_scene_init_contacts(scene_object *s, const scene_substep *substep)
{
    s->step.substep_length = substep->h;
    update_contacts(s, INIT_CONTACT, substep->h);
}

void vbss_scene_refresh_contacts(scene_object *s)
{
    update_contacts(s, REFRESH_GEOMETRY, 0.0);
}

void vbss_scene_refresh_normals(scene_object *s)
{
    update_contacts(s, REFRESH_NORMAL, 0.0);
}

void vbss_scene_measure_gaps(scene_object *s)
{
    update_contacts(s, MEASURE_GAP, 0.0);
}
