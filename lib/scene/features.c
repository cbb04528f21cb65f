/* How the two features of a row lie: normal, gap, terms, how far they have slid.
 *
 * A side of a row is a point that moves with its body: a mean of nodes, or a point of a rigid body's
 * surface. Where it was when the part began is known too, which is what friction is about. */
#include "scene/around_holes.h"
#include "scene/pins.h"
#include "scene/rows.h"
#include "scene/tools.h"

#include "collision/closest.h"

/* Weights of a node and its neighbours that make the point of a smooth curve: on a polygon round a circle they
 * give Coulomb friction the law of the rope to second order of the turn between segments. */
#define SMOOTH_NODE (11.0 / 12.0)
#define SMOOTH_NEIGHBOUR (1.0 / 24.0)
/* r of the law, N/m: of rows that nodes take part in. Larger by a thousand, states cycle. */
#define NODE_AUGMENTATION 3.0
/* A node of a thread that lies on the floor presses it by its weight alone, some uN: it would be held within 2 pm, and bear
 * alone what pulls along the thread; they would let go one after the other, a solve each. m */
#define SPENT_ON_FLOOR 1e-7
/* The same of rigid bodies alone, as a share of mass / h^2: well below the inertia that a point of them has, or
 * slip one way and the other way follow each other. */
#define RIGID_AUGMENTATION 0.01
/* A normal that turns by more than 60 degrees in one part belongs to another side. */
#define SAME_SIDE 0.5
/* Share of the distance of touching below which axes may be about to pass. */
#define STILL_APART 0.5
/* Axes nearer than this have no direction, m. */
#define NO_DISTANCE 1e-12

/* One of the two features of a row, and its corners: of a point one, of the axis of a segment two, of a face three. */
typedef struct side {
    const scene_body *body;
    const scene_capsule *capsule; /* of a rigid body */
    uint32_t feature, corners;
    uint32_t nodes[3]; /* of a drain */
    uint32_t
        lip; /* of a free edge of a drain, or a node there: a triangle beside it; else SCENE_NO_FACE */
    bool smooth; /* a node: of the curve that is smoothed there */
    double radius;
} side;

typedef enum moment { BEGIN, AHEAD, TRIAL } moment; /* ahead: where it may go */

/* ---- what a feature is */

/* Rows come by bodies, so it is mostly the last one. */
static const scene_body *body_of(const scene_object *s, uint32_t number, const scene_body *last)
{
    return last != NULL && last->number == number ? last : vbss_scene_body(s, number);
}

static inline side side_of(const scene_object *s, const contact_constraint *row,
                           const scene_body *b, int which)
{
    uint32_t kind = row->key.kind, feature = which == 0 ? row->key.feature_a : row->key.feature_b;
    side d; /* its nodes are looked at where they are set */
    d.body = b;
    d.capsule = NULL;
    d.feature = feature;
    d.lip = SCENE_NO_FACE;
    d.smooth = false;
    bool point = which == 0 && (scene_is_of_node(kind) || kind == VBSS_CONTACT_CAPSULE_FLOOR);
    d.corners = point ? 1 : 2;
    if (b->kind == BODY_DRAIN) {
        d.corners = vbss_scene_nodes_of(s, b, kind, which == 1, feature, d.nodes);
        d.radius = 0.5 * b->drain.drain->config.thickness;
        if (kind == VBSS_CONTACT_SIDES) {
            d.lip = b->drain.lip_of_side[feature];
        } else if (kind == VBSS_CONTACT_POINT_FACE && which == 0) {
            d.lip = b->drain.lip_of_node[feature];
        }
        return d;
    }
    if (b->kind == BODY_THREAD) {
        /* ends of the thread alone are as they are */
        d.smooth = kind == VBSS_CONTACT_NODE_CAPSULE && feature > 0 &&
                   feature + 1 < b->thread.thread->node_count;
        d.radius = b->thread.thread->config.radius;
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

static void axis_of_thread(const side *d, const vec3 *x, vec3 axis[3])
{
    x += d->feature;
    axis[0] = d->smooth ? smooth_point(x) : x[0];
    axis[1] = d->corners > 1 ? x[1] : axis[0];
}

static void axis_of_capsule(const side *d, const vec3 ends[2], vec3 axis[3])
{
    axis[0] = ends[d->corners > 1 ? 0 : d->feature % 2];
    axis[1] = ends[1];
}

static void axis_of_drain(const side *d, const vec3 *x, vec3 axis[3])
{
    axis[1] = x[d->nodes[0]]; /* of a point too, which has no other */
    for (uint32_t k = 0; k < d->corners; k++) {
        axis[k] = x[d->nodes[k]];
    }
}

/* Of a thread or a capsule: rows of drains keep their normals, and look at nothing ahead. */
static void add_way(const scene_object *s, const side *d, vec3 axis[3])
{
    vec3 way[3];
    if (d->capsule == NULL) {
        axis_of_thread(d, s->ways + d->body->thread.first_node, way);
    } else {
        size_t number = (size_t)(d->capsule - s->capsules);
        axis_of_capsule(d, s->ways + s->config.node_capacity + 2 * number, way);
    }
    axis[0] = vec3_add(axis[0], way[0]);
    axis[1] = vec3_add(axis[1], way[1]); /* of a point nobody looks at it */
}

static void axis_of(const scene_object *s, const side *d, moment when, vec3 axis[3])
{
    const scene_body *b = d->body;
    bool trial = when == TRIAL;
    if (b->kind == BODY_THREAD) {
        const thread_object *t = b->thread.thread;
        axis_of_thread(d, trial ? t->trial : t->now.x, axis);
    } else if (b->kind == BODY_DRAIN) {
        const drain_object *own = b->drain.drain;
        axis_of_drain(d, trial ? own->trial : own->x, axis);
    } else {
        axis_of_capsule(d, trial ? d->capsule->trial : d->capsule->now, axis);
    }
    if (when == AHEAD) {
        add_way(s, d, axis);
    }
}

/* From b to a between the closest points of both features. Where these are: of two segments, the share of each; of a point and
 * a segment, the second; of a point and a face, the weights of its last two corners. */
static inline vec3 closest(const side *d, const side *e, const vec3 a[3], const vec3 b[3],
                           double at[2])
{
    if (e->corners == 3) {
        double weights[3];
        const vec3 corners[3] = {vec3_sub(b[0], a[0]), vec3_sub(b[1], a[0]), vec3_sub(b[2], a[0])};
        vec3 to = closest_on_triangle(corners, weights);
        at[0] = weights[1];
        at[1] = weights[2];
        return vec3_neg(to);
    }
    vec3 along = vec3_sub(b[1], b[0]);
    if (d->corners == 1) {
        vec3 to = vec3_sub(a[0], b[0]);
        at[0] = 0.0;
        at[1] = closest_on_edge(along, to);
        return vec3_add_scaled(to, -at[1], along);
    }
    return vec3_neg(
        closest_between_edges(vec3_sub(a[1], a[0]), along, vec3_sub(b[0], a[0]), &at[0], &at[1]));
}

/* ---- lips: what is cut is flat, as high as the wall. Against another wall, a lip is a line through its own. */

static bool is_flat(const side *d, const side *e)
{
    return d->lip != SCENE_NO_FACE && e->body->kind == BODY_DRAIN;
}

/* From the middle of a wall, or the line through it. */
static double radius_against(const side *d, const side *e)
{
    return is_flat(d, e) ? 2.0 * SCENE_LIP * d->radius : d->radius;
}

static double touching_of(const side *d, const side *e)
{
    return radius_against(d, e) + radius_against(e, d);
}

/* A side that ends at a lip is round, and that lip, which ends there too, sees the same. */
static bool ends_at_lip(const side *d, double at)
{
    bool end = at == 0.0 || at == 1.0;
    return d->corners == 2 && d->lip == SCENE_NO_FACE && end &&
           d->body->drain.lip_of_node[d->nodes[at == 1.0 ? 1 : 0]] != SCENE_NO_FACE;
}

static bool is_seen_by_lips(const side *d, const side *e, const contact_constraint *row)
{
    return d->body->kind == BODY_DRAIN && e->body->kind == BODY_DRAIN &&
           (ends_at_lip(d, row->barycentric[0]) || ends_at_lip(e, row->barycentric[1]));
}

static vec3 normal_of_lip(const scene_object *s, const side *d, moment when)
{
    const uint32_t *nodes = s->collision->shapes[d->body->shape]->triangles[d->lip];
    const side face = {.body = d->body, .corners = 3, .nodes = {nodes[0], nodes[1], nodes[2]}};
    vec3 x[3];
    axis_of(s, &face, when, x);
    return vec3_unit_or(vec3_cross(vec3_sub(x[1], x[0]), vec3_sub(x[2], x[0])), vec3_zero());
}

/* From one rounded end to the other; of what is round itself, nothing. */
static vec3 line_through(const scene_object *s, const side *d, const side *e, moment when)
{
    const double height = 2.0 * (1.0 - 2.0 * SCENE_LIP) * d->radius;
    return is_flat(d, e) ? vec3_scale(normal_of_lip(s, d, when), height) : vec3_zero();
}

/* From the line through the wall of e to that of d, where the middles are `middles` apart; and what of that is wall. */
static vec3 between_lines(const scene_object *s, const side *d, const side *e, moment when,
                          vec3 middles, double *walls)
{
    double at[2];
    vec3 one = line_through(s, d, e, when), other = line_through(s, e, d, when);
    vec3 begins = vec3_sub(vec3_scale(vec3_sub(one, other), 0.5), middles);
    vec3 apart = vec3_neg(closest_between_edges(one, other, begins, &at[0], &at[1]));
    double distance = vec3_norm(apart);
    *walls = vec3_dot(apart, middles) / vbss_max(distance, DBL_MIN) - distance;
    return apart;
}

/* Beside a hole. */
static bool is_cut(const contact_constraint *row)
{
    return row->axis_interval[0][0] > 0.0 || row->axis_interval[0][1] < 1.0;
}

/* From b to a between the surfaces' middles where they are nearest: where that is on both, and what of it is wall. */
static inline vec3 apart_of(const scene_object *s, const contact_constraint *row, const side *d,
                            const side *e, moment when, double at[2], double *walls)
{
    vec3 one[3], other[3];
    axis_of(s, d, when, one);
    axis_of(s, e, when, other);
    bool cut = is_cut(row);
    if (cut) {
        scene_cut_axis(one, row->axis_interval[0]);
        scene_cut_axis(other, row->axis_interval[1]);
    }
    vec3 apart = closest(d, e, one, other, at);
    for (int k = 0; cut && k < 2; k++) {
        at[k] = row->axis_interval[k][0] +
                at[k] * (row->axis_interval[k][1] - row->axis_interval[k][0]);
    }
    *walls = 0.0;
    return is_flat(d, e) || is_flat(e, d) ? between_lines(s, d, e, when, apart, walls) : apart;
}

/* The share of each corner in the point that the row is about. */
static inline void weigh(const side *d, const contact_constraint *row, int which, double weights[3])
{
    weights[0] = 1.0;
    weights[1] = weights[2] = 0.0;
    if (d->corners == 2) {
        weights[0] = 1.0 - row->barycentric[which];
        weights[1] = row->barycentric[which];
    } else if (d->corners == 3) {
        weights[0] = 1.0 - row->barycentric[0] - row->barycentric[1];
        weights[1] = row->barycentric[0];
        weights[2] = row->barycentric[1];
    }
}

static inline vec3 point_of(const side *d, const vec3 axis[3], const double weights[3])
{
    if (d->corners == 2) {
        return vec3_lerp(axis[0], axis[1], weights[1]);
    }
    if (d->corners == 1) {
        return axis[0];
    }
    vec3 point = vec3_add_scaled(vec3_scale(axis[0], weights[0]), weights[1], axis[1]);
    return vec3_add_scaled(point, weights[2], axis[2]);
}

/* ---- terms */

static void add_term(contact_constraint *row, uint32_t b, double weight)
{
    contact_jacobian_block *term = &row->jacobian[row->jacobian_block_count++];
    *term = (contact_jacobian_block){.block = b, .weight = weight};
}

void vbss_scene_add_rigid_terms(contact_constraint *row, const scene_rigid *r, vec3 point,
                                double weight)
{
    contact_jacobian_block *term = &row->jacobian[row->jacobian_block_count + 1];
    add_term(row, r->blocks.first, weight);
    *term = (contact_jacobian_block){.block = r->blocks.first + 1,
                                     .is_rotation = true,
                                     .weight = weight,
                                     .arm = vec3_sub(point, r->trial.position)};
    row->jacobian_block_count++;
}

/* A node that is welded to a body moves as that does. */
void vbss_scene_add_node_term(const scene_object *s, contact_constraint *row, const scene_body *b,
                              uint32_t node, double weight)
{
    const scene_pin *weld =
        b->thread.thread->welded[node] != 0 ? vbss_scene_weld_of(s, b->number, node) : NULL;
    if (weld == NULL) {
        add_term(row, b->thread.first_block + node, weight);
        return;
    }
    const scene_rigid *r = &vbss_scene_body(s, weld->body)->rigid;
    vbss_scene_add_rigid_terms(row, r, pose_apply(r->trial, weld->point), weight);
}

/* The terms that move `point` of the surface. */
static void add_terms(const scene_object *s, contact_constraint *row, const side *d,
                      const double weights[3], vec3 point, double sign)
{
    const scene_body *b = d->body;
    if (d->capsule != NULL) {
        vbss_scene_add_rigid_terms(row, &b->rigid, point, sign);
    } else if (b->kind == BODY_DRAIN) {
        for (uint32_t k = 0; k < d->corners && k < 3; k++) {
            uint32_t place = b->drain.drain->order.block_index[d->nodes[k]];
            add_term(row, b->drain.first_block + place, sign * weights[k]);
        }
    } else if (d->corners > 1) {
        vbss_scene_add_node_term(s, row, b, d->feature, sign * weights[0]);
        vbss_scene_add_node_term(s, row, b, d->feature + 1, sign * weights[1]);
    } else {
        vbss_scene_add_node_term(s, row, b, d->feature, sign * (d->smooth ? SMOOTH_NODE : 1.0));
        if (d->smooth) {
            vbss_scene_add_node_term(s, row, b, d->feature - 1, sign * SMOOTH_NEIGHBOUR);
            vbss_scene_add_node_term(s, row, b, d->feature + 1, sign * SMOOTH_NEIGHBOUR);
        }
    }
}

/* Where that point was when the part began: of a rigid body's surface, which turns beyond what its axis shows. */
static vec3 point_at_begin(const side *d, double at, vec3 point)
{
    const scene_rigid *r = &d->body->rigid;
    const scene_capsule *c = d->capsule;
    uint32_t first = d->corners == 1 ? d->feature % 2 : 0, last = d->corners == 1 ? first : 1;
    /* a jaw's axis goes against its body */
    vec3 moved = vec3_lerp(vec3_sub(c->local_trial[first], c->local[first]),
                           vec3_sub(c->local_trial[last], c->local[last]), at);
    return pose_apply(r->body.now.pose, vec3_sub(pose_apply_inverse(r->trial, point), moved));
}

/* ---- rows */

/* What it says of all others. */
static double own_friction(const scene_object *s, const scene_body *b)
{
    return b == NULL                ? s->config.floor_friction
           : b->kind == BODY_THREAD ? s->config.thread_friction
           : b->kind == BODY_RIGID  ? b->rigid.friction
                                    : b->drain.drain->config.friction;
}

static bool is_thread(const scene_body *b)
{
    return b != NULL && b->kind == BODY_THREAD;
}

/* What a thread rubs on says how; of two others the geometric mean counts. */
static double friction_of(const scene_object *s, const scene_body *a, const scene_body *b)
{
    if (is_thread(a) || is_thread(b)) {
        return own_friction(s, is_thread(a) ? b : a);
    }
    return sqrt(own_friction(s, a) * own_friction(s, b));
}

/* Rigid bodies resist by their inertia: of the lighter one. */
static double augmentation_of(const scene_body *a, const scene_body *b, double h)
{
    if (a->kind != BODY_RIGID || (b != NULL && b->kind != BODY_RIGID)) {
        return NODE_AUGMENTATION;
    }
    double mass = a->rigid.body.mass;
    if (b != NULL && b->rigid.kind != VBSS_RIGID_DRIVEN) {
        mass = vbss_min(mass, b->rigid.body.mass);
    }
    return RIGID_AUGMENTATION * mass / (h * h);
}

/* One side of a row, once normal and places are known: its terms, how far its point has come since the part began,
 * and where that is. `out` is from the axis, or the middle of a wall, to the surface. */
static vec3 place_side(const scene_object *s, contact_constraint *row, const side *d, int which,
                       vec3 out, double sign)
{
    vec3 axis[3], before[3], began;
    double weights[3];
    axis[2] = before[2] = vec3_zero(); /* of a face alone it is another */
    weigh(d, row, which, weights);
    axis_of(s, d, TRIAL, axis);
    vec3 here = point_of(d, axis, weights), point = vec3_add(here, out);
    add_terms(s, row, d, weights, point, sign);
    if (d->capsule != NULL) {
        began = point_at_begin(d, d->corners > 1 ? row->barycentric[which] : 0.0, point);
        row->relative_displacement =
            vec3_add_scaled(row->relative_displacement, sign, vec3_sub(point, began));
    } else {
        axis_of(s, d, BEGIN, before);
        began = point_of(d, before, weights);
        row->relative_displacement =
            vec3_add_scaled(row->relative_displacement, sign, vec3_sub(here, began));
    }
    return here;
}

static void place_row(const scene_object *s, contact_constraint *row, const side *d, const side *e)
{
    const vec3 n = row->normal;
    row->jacobian_block_count = 0;
    row->relative_displacement = vec3_zero();
    vec3 out = vec3_scale(n, -d->radius), here = place_side(s, row, d, 0, out, 1.0);
    if (e == NULL) {
        row->gap = vec3_dot(n, here) - s->config.floor_height - d->radius;
    } else {
        vec3 there = place_side(s, row, e, 1, vec3_scale(n, e->radius), -1.0);
        row->gap = vec3_dot(n, vec3_sub(here, there)) - touching_of(d, e) - row->lip_thickness +
                   row->overlap_allowance;
    }
    row->point = vec3_add_scaled(vec3_add(here, out), -0.5 * row->gap, n);
}

/* Whether normals of the begin will do: those of segments jump, or turn fast as their radius is small; velocities
 * that are a little wrong would make them worse, and tight knots tremble. */
static bool keeps_normal(const contact_constraint *row)
{
    return row->key.kind == VBSS_CONTACT_SEGMENTS ||
           row->key.kind == VBSS_CONTACT_SEGMENT_CAPSULE || row->key.kind == VBSS_CONTACT_SIDES ||
           row->key.kind == VBSS_CONTACT_POINT_FACE;
}

/* Within the face, not on a side of it. */
static bool is_within(const contact_constraint *row)
{
    return row->barycentric[0] > 0.0 && row->barycentric[1] > 0.0 &&
           row->barycentric[0] + row->barycentric[1] < 1.0;
}

/* Features that meet: as good as any direction that is across both. */
static vec3 across(const scene_object *s, const side *d, const side *e)
{
    vec3 one[3], other[3];
    axis_of(s, d, BEGIN, one);
    axis_of(s, e, BEGIN, other);
    vec3 from = e->corners == 3 ? vec3_sub(other[2], other[0]) : vec3_sub(one[1], one[0]);
    vec3 normal = vec3_cross(from, vec3_sub(other[1], other[0]));
    return vec3_unit_or(normal, vec3_make(0.0, 1.0, 0.0));
}

bool vbss_scene_lay_row(const scene_object *s, contact_constraint *row, const scene_body *a,
                        const scene_body *b, double reach)
{
    const side d = side_of(s, row, a, 0);
    if (b == NULL) {
        vec3 one[3];
        axis_of(s, &d, BEGIN, one);
        row->normal = s->floor_normal;
        row->barycentric[0] = row->barycentric[1] = 0.0;
        row->thickness = 2.0 * d.radius;
        row->contact_distance = d.radius;
        row->start_gap = vec3_dot(row->normal, one[0]) - s->config.floor_height - d.radius;
        return row->start_gap < reach;
    }
    const side e = side_of(s, row, b, 1);
    vec3 apart = apart_of(s, row, &d, &e, BEGIN, row->barycentric, &row->lip_thickness);
    double distance = vec3_norm(apart), touching = touching_of(&d, &e);
    row->thickness = 2.0 * vbss_min(d.radius, e.radius); /* of lips too: they are soft */
    row->contact_distance = touching;
    row->start_gap = distance - touching;
    if (!(row->start_gap < reach) || (e.corners == 3 && !is_within(row)) ||
        is_seen_by_lips(&d, &e, row)) {
        return false;
    }
    row->normal = distance > NO_DISTANCE ? vec3_scale(apart, 1.0 / distance) : across(s, &d, &e);
    if (keeps_normal(row)) {
        return true;
    }
    /* The force acts where they will be: a normal of the begin leans back, and brakes by v h / R. */
    double at[2], walls;
    vec3 then = apart_of(s, row, &d, &e, AHEAD, at, &walls);
    double later = vec3_norm(then);
    if (later > STILL_APART * touching && vec3_dot(then, row->normal) > SAME_SIDE * later) {
        row->normal = vec3_scale(then, 1.0 / later);
        row->barycentric[0] = at[0];
        row->barycentric[1] = at[1];
        row->lip_thickness = walls;
    }
    return true;
}

typedef enum look_at_row { SET, REFRESH, LAY_AGAIN, MEASURE } look_at_row;

static void lay_again(const scene_object *s, contact_constraint *row, const side *d, const side *e)
{
    row->normal = vec3_unit_or(apart_of(s, row, d, e, TRIAL, row->barycentric, &row->lip_thickness),
                               row->normal);
    row->previous_force = vbss_contact_rotate_to_tangent_plane(row->previous_force, row->normal);
    row->solution.slip_direction = vec3_unit_or(
        vbss_contact_rotate_to_tangent_plane(row->solution.slip_direction, row->normal),
        row->solution.slip_direction);
}

static void measure(const scene_object *s, contact_constraint *row, const side *d, const side *e)
{
    double at[2], walls;
    row->gap = vec3_norm(apart_of(s, row, d, e, TRIAL, at, &walls)) - touching_of(d, e) +
               row->overlap_allowance;
}

static void look(const scene_object *s, contact_constraint *row, const side *d, const side *e,
                 look_at_row how)
{
    if (how == MEASURE && e != NULL) {
        measure(s, row, d, e);
    }
    if (how == LAY_AGAIN && e != NULL) {
        lay_again(s, row, d, e);
    }
    if (how != MEASURE) {
        place_row(s, row, d, e);
    }
}

static void look_at_all(scene_object *s, look_at_row how, double h)
{
    const scene_body *a = NULL, *b = NULL;
    for (uint32_t i = 0; i < s->contacts->count; i++) {
        contact_constraint *row = &s->contacts->constraints[i];
        if (row->is_bilateral) {
            if (how != MEASURE) {
                vbss_scene_lay_grasp_row(s, row);
            }
            continue;
        }
        a = body_of(s, row->key.body_a, a);
        b = row->key.body_b == 0 ? NULL : body_of(s, row->key.body_b, b);
        if (how == SET) {
            row->friction = friction_of(s, a, b);
            row->stiffness = s->config.contact_stiffness;
            row->augmentation = augmentation_of(a, b, h);
            row->elastic_slip_limit =
                row->key.kind == VBSS_CONTACT_NODE_FLOOR ? SPENT_ON_FLOOR : 0.0;
        }
        const side d = side_of(s, row, a, 0);
        if (b == NULL) {
            look(s, row, &d, NULL, how);
        } else {
            const side e = side_of(s, row, b, 1);
            look(s, row, &d, &e, how);
        }
    }
}

/* What rows are beside where they lie; the first look at their trial state is along the normal that they
 * had when the part began. */
void vbss_scene_set_rows(scene_object *s, const scene_part *part)
{
    s->part_length = part->h;
    look_at_all(s, SET, part->h);
}

void vbss_scene_refresh_rows(scene_object *s)
{
    look_at_all(s, REFRESH, 0.0);
}

void vbss_scene_lay_rows_again(scene_object *s)
{
    look_at_all(s, LAY_AGAIN, 0.0);
}

void vbss_scene_measure_gaps(scene_object *s)
{
    look_at_all(s, MEASURE, 0.0);
}
