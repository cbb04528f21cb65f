/* How the two features of a row lie: normal, gap, terms, how far they have slid.
 *
 * A side of a row is a point that moves with its body: a mean of nodes, or a point of a rigid body's
 * surface. Where it was when the part began is known too, which is what friction is about. */
#include "scene/scene.h"

#include "collision/closest.h"

/* Weights of a node and its neighbours that make the point of a smooth curve: on a polygon round a circle they
 * give Coulomb friction the law of the rope to second order of the turn between segments. */
#define SMOOTH_NODE (11.0 / 12.0)
#define SMOOTH_NEIGHBOUR (1.0 / 24.0)
/* r of the law, N/m: of rows that a thread takes part in. Larger by a thousand, states cycle. */
#define THREAD_AUGMENTATION 3.0
/* The same of rigid bodies alone, as a share of mass / h^2: well below the inertia that a point of them has, or
 * slip one way and the other way follow each other. */
#define RIGID_AUGMENTATION 0.01
/* A normal that turns by more than 60 degrees in one part belongs to another side. */
#define SAME_SIDE 0.5
/* Share of the distance of touching below which axes may be about to pass. */
#define STILL_APART 0.5
/* Axes nearer than this have no direction, m. */
#define NO_DISTANCE 1e-12

typedef struct side {
    vec3 begin[2], ahead[2], trial[2]; /* ends of the feature's axis: ahead is where they may go */
    double radius;
    uint32_t nodes; /* of a thread that take part; 0: a capsule */
    uint32_t node;
    vec3 moved[2]; /* a jaw's axis: against its body */
} side;

/* ---- what a feature is */

static side segment_side(const scene_object *s, const scene_body *b, uint32_t segment)
{
    const vec3 *ways = s->ways + b->thread.first_node;
    const thread_object *t = b->thread.thread;
    side d = {.radius = t->config.radius, .nodes = 2, .node = segment};
    for (uint32_t k = 0; k < 2; k++) {
        d.begin[k] = t->now.x[segment + k];
        d.ahead[k] = vec3_add(d.begin[k], ways[segment + k]);
        d.trial[k] = t->trial[segment + k];
    }
    return d;
}

/* Of the node and its neighbours; ends of the thread alone. */
static bool is_smoothed(const thread_object *t, uint32_t node)
{
    return node > 0 && node + 1 < t->node_count;
}

static vec3 smooth_point(const thread_object *t, const vec3 *x, uint32_t node)
{
    if (!is_smoothed(t, node)) {
        return x[node];
    }
    vec3 beside = vec3_add(x[node - 1], x[node + 1]);
    return vec3_add_scaled(vec3_scale(x[node], SMOOTH_NODE), SMOOTH_NEIGHBOUR, beside);
}

static side node_side(const scene_object *s, const scene_body *b, uint32_t node, bool smooth)
{
    const vec3 *ways = s->ways + b->thread.first_node;
    const thread_object *t = b->thread.thread;
    side d = {.radius = t->config.radius, .nodes = 1, .node = node};
    d.begin[0] = d.begin[1] = smooth ? smooth_point(t, t->now.x, node) : t->now.x[node];
    d.ahead[0] = vec3_add(d.begin[0], smooth ? smooth_point(t, ways, node) : ways[node]);
    d.ahead[1] = d.ahead[0];
    d.trial[0] = d.trial[1] = smooth ? smooth_point(t, t->trial, node) : t->trial[node];
    return d;
}

static side capsule_side(const scene_object *s, const scene_body *b, uint32_t capsule)
{
    uint32_t number = b->rigid.first_capsule + capsule;
    const scene_capsule *c = &s->capsules[number];
    const vec3 *ways = s->ways + s->config.node_capacity + 2 * (size_t)number;
    side d = {.radius = c->radius};
    for (int k = 0; k < 2; k++) {
        d.begin[k] = c->now[k];
        d.ahead[k] = vec3_add(c->now[k], ways[k]);
        d.trial[k] = c->trial[k];
        d.moved[k] = vec3_sub(c->local_trial[k], c->local[k]);
    }
    return d;
}

/* ---- terms */

static void add_term(contact_row *row, uint32_t b, double weight)
{
    contact_term *term = &row->terms[row->term_count++];
    *term = (contact_term){.block = b, .weight = weight};
}

void vbss_scene_add_rigid_terms(contact_row *row, const scene_rigid *r, vec3 point, double weight)
{
    contact_term *term = &row->terms[row->term_count + 1];
    add_term(row, r->blocks.first, weight);
    *term = (contact_term){.block = r->blocks.first + 1,
                           .turns = true,
                           .weight = weight,
                           .arm = vec3_sub(point, r->trial.position)};
    row->term_count++;
}

/* A node that is welded to a body moves as that does. */
void vbss_scene_add_node_term(const scene_object *s, contact_row *row, const scene_body *b,
                              uint32_t node, double weight)
{
    const scene_pin *weld = vbss_scene_weld_of(s, b->number, node);
    if (weld == NULL) {
        add_term(row, b->thread.first_block + node, weight);
        return;
    }
    const scene_rigid *r = &vbss_scene_body(s, weld->body)->rigid;
    vbss_scene_add_rigid_terms(row, r, pose_apply(r->trial, weld->point), weight);
}

/* The point at `at` of the feature's axis, `out` away from it, and the terms that move it. */
static void add_terms(const scene_object *s, contact_row *row, const scene_body *b, const side *d,
                      double at, vec3 out, double sign)
{
    if (d->nodes == 0) {
        vec3 point = vec3_add(vec3_lerp(d->trial[0], d->trial[1], at), out);
        vbss_scene_add_rigid_terms(row, &b->rigid, point, sign);
        return;
    }
    if (d->nodes == 2) {
        vbss_scene_add_node_term(s, row, b, d->node, sign * (1.0 - at));
        vbss_scene_add_node_term(s, row, b, d->node + 1, sign * at);
        return;
    }
    bool smooth =
        row->key.kind == VBSS_CONTACT_NODE_CAPSULE && is_smoothed(b->thread.thread, d->node);
    vbss_scene_add_node_term(s, row, b, d->node, sign * (smooth ? SMOOTH_NODE : 1.0));
    if (smooth) {
        vbss_scene_add_node_term(s, row, b, d->node - 1, sign * SMOOTH_NEIGHBOUR);
        vbss_scene_add_node_term(s, row, b, d->node + 1, sign * SMOOTH_NEIGHBOUR);
    }
}

/* How far that point has come since the begin of the part. */
static vec3 way_of(const scene_body *b, const side *d, double at, vec3 out)
{
    vec3 here = vec3_lerp(d->trial[0], d->trial[1], at);
    vec3 way = vec3_sub(here, vec3_lerp(d->begin[0], d->begin[1], at));
    if (d->nodes == 0) { /* the surface turns with the body, beyond what the axis shows */
        const scene_rigid *r = &b->rigid;
        vec3 point = vec3_add(here, out);
        vec3 moved = vec3_lerp(d->moved[0], d->moved[1], at);
        vec3 there =
            pose_apply(r->body.now.at, vec3_sub(pose_apply_inverse(r->trial, point), moved));
        way = vec3_sub(point, there);
    }
    return way;
}

/* ---- rows */

static double friction_of(const scene_object *s, const scene_body *a, const scene_body *b)
{
    if (b == NULL) {
        double floor = s->config.floor_friction;
        return a->kind == BODY_THREAD ? floor : sqrt(a->rigid.friction * floor);
    }
    if (a->kind == BODY_THREAD) {
        return b->kind == BODY_THREAD ? s->config.thread_friction : b->rigid.friction;
    }
    return sqrt(a->rigid.friction * b->rigid.friction);
}

/* Rigid bodies resist by their inertia: of the lighter one. */
static double augmentation_of(const scene_body *a, const scene_body *b, double h)
{
    if (a->kind == BODY_THREAD) {
        return THREAD_AUGMENTATION;
    }
    double mass = a->rigid.body.mass;
    if (b != NULL && b->rigid.kind != VBSS_RIGID_DRIVEN) {
        mass = lesser(mass, b->rigid.body.mass);
    }
    return RIGID_AUGMENTATION * mass / (h * h);
}

static side side_of(const scene_object *s, const contact_key *key, const scene_body *b, int which)
{
    uint32_t feature = which == 0 ? key->a : key->b;
    switch (key->kind) {
    case VBSS_CONTACT_SEGMENTS:
        return segment_side(s, b, feature);
    case VBSS_CONTACT_NODE_CAPSULE:
        return which == 0 ? node_side(s, b, feature, true) : capsule_side(s, b, feature);
    case VBSS_CONTACT_SEGMENT_CAPSULE:
        return which == 0 ? segment_side(s, b, feature) : capsule_side(s, b, feature);
    case VBSS_CONTACT_NODE_FLOOR:
        return node_side(s, b, feature, false);
    case VBSS_CONTACT_CAPSULES:
        return capsule_side(s, b, feature);
    default: { /* one end of a capsule */
        side d = capsule_side(s, b, feature / 2);
        d.begin[0] = d.begin[1] = d.begin[feature % 2];
        d.trial[0] = d.trial[1] = d.trial[feature % 2];
        return d;
    }
    }
}

/* From b to a between the closest points of two axes. */
static vec3 closest(const vec3 a[2], const vec3 b[2], double at[2])
{
    vec3 to_b = closest_edges(vec3_sub(a[1], a[0]), vec3_sub(b[1], b[0]), vec3_sub(b[0], a[0]),
                              &at[0], &at[1]);
    return vec3_neg(to_b);
}

/* Gap, terms and slip, once normal and places are known. */
static void place_row(const scene_object *s, contact_row *row, const scene_body *a,
                      const scene_body *b, const side *d, const side *e)
{
    const vec3 n = row->normal;
    vec3 out = vec3_scale(n, -d->radius), here = vec3_lerp(d->trial[0], d->trial[1], row->at[0]);
    row->term_count = 0;
    add_terms(s, row, a, d, row->at[0], out, 1.0);
    row->slid = way_of(a, d, row->at[0], out);
    if (b == NULL) {
        row->gap = vec3_dot(n, here) - s->config.floor_height - d->radius;
        row->point = vec3_add_scaled(vec3_add(here, out), -0.5 * row->gap, n);
        return;
    }
    vec3 there = vec3_lerp(e->trial[0], e->trial[1], row->at[1]);
    vec3 other_out = vec3_scale(n, e->radius);
    add_terms(s, row, b, e, row->at[1], other_out, -1.0);
    row->slid = vec3_sub(row->slid, way_of(b, e, row->at[1], other_out));
    row->gap = vec3_dot(n, vec3_sub(here, there)) - d->radius - e->radius;
    row->point = vec3_add_scaled(vec3_add(here, out), -0.5 * row->gap, n);
}

bool vbss_scene_lay_row(scene_object *s, contact_row *row, double reach)
{
    const scene_body *a = vbss_scene_body(s, row->key.body_a);
    const scene_body *b = vbss_scene_body(s, row->key.body_b);
    const side d = side_of(s, &row->key, a, 0);
    if (b == NULL) {
        row->normal = s->floor_normal;
        row->at[0] = row->at[1] = 0.0;
        row->thickness = 2.0 * d.radius;
        row->gap_before = vec3_dot(row->normal, d.begin[0]) - s->config.floor_height - d.radius;
        return row->gap_before < reach;
    }
    const side e = side_of(s, &row->key, b, 1);
    double at[2];
    vec3 apart = closest(d.begin, e.begin, row->at);
    double distance = vec3_norm(apart);
    /* Axes that meet: as good as any direction that is across both. */
    vec3 across =
        vec3_unit_or(vec3_cross(vec3_sub(d.begin[1], d.begin[0]), vec3_sub(e.begin[1], e.begin[0])),
                     vec3_make(0.0, 1.0, 0.0));
    row->normal = distance > NO_DISTANCE ? vec3_scale(apart, 1.0 / distance) : across;
    double touching = d.radius + e.radius;
    row->thickness = 2.0 * lesser(d.radius, e.radius);
    row->gap_before = distance - touching;
    /* The force acts where they will be: a normal of the begin leans back, and brakes by v h / R. Not of
     * segments, whose normals jump, or turn fast as R is small: velocities that are a little wrong would make
     * them worse, and tight knots tremble. */
    if (row->key.kind == VBSS_CONTACT_SEGMENTS || row->key.kind == VBSS_CONTACT_SEGMENT_CAPSULE) {
        return row->gap_before < reach;
    }
    vec3 then = closest(d.ahead, e.ahead, at);
    double later = vec3_norm(then);
    if (later > STILL_APART * touching && vec3_dot(then, row->normal) > SAME_SIDE * later) {
        row->normal = vec3_scale(then, 1.0 / later);
        row->at[0] = at[0];
        row->at[1] = at[1];
    }
    return row->gap_before < reach;
}

/* What rows are beside where they lie; the first look at their trial state is along the normal that they
 * had when the part began. */
void vbss_scene_set_rows(scene_object *s, const scene_part *part)
{
    for (uint32_t i = 0; i < s->contacts->count; i++) {
        contact_row *row = &s->contacts->rows[i];
        if (row->bilateral) {
            vbss_scene_lay_grasp_row(s, row);
            continue;
        }
        const scene_body *a = vbss_scene_body(s, row->key.body_a);
        const scene_body *b = vbss_scene_body(s, row->key.body_b);
        const side d = side_of(s, &row->key, a, 0);
        const side e = b == NULL ? d : side_of(s, &row->key, b, 1);
        row->friction = friction_of(s, a, b);
        row->stiffness = s->config.contact_stiffness;
        row->augmentation = augmentation_of(a, b, part->h);
        place_row(s, row, a, b, &d, &e);
    }
}

void vbss_scene_refresh_rows(scene_object *s)
{
    for (uint32_t i = 0; i < s->contacts->count; i++) {
        contact_row *row = &s->contacts->rows[i];
        if (row->bilateral) {
            vbss_scene_lay_grasp_row(s, row);
            continue;
        }
        const scene_body *a = vbss_scene_body(s, row->key.body_a);
        const scene_body *b = vbss_scene_body(s, row->key.body_b);
        const side d = side_of(s, &row->key, a, 0);
        const side e = b == NULL ? d : side_of(s, &row->key, b, 1);
        place_row(s, row, a, b, &d, &e);
    }
}

void vbss_scene_lay_rows_again(scene_object *s)
{
    for (uint32_t i = 0; i < s->contacts->count; i++) {
        contact_row *row = &s->contacts->rows[i];
        if (row->bilateral) {
            vbss_scene_lay_grasp_row(s, row);
            continue;
        }
        const scene_body *a = vbss_scene_body(s, row->key.body_a);
        const scene_body *b = vbss_scene_body(s, row->key.body_b);
        const side d = side_of(s, &row->key, a, 0);
        const side e = b == NULL ? d : side_of(s, &row->key, b, 1);
        if (b != NULL) {
            vec3 apart = closest(d.trial, e.trial, row->at);
            row->normal = vec3_unit_or(apart, row->normal);
            row->held = vbss_contact_turn_into_plane(row->held, row->normal);
            row->is.way =
                vec3_unit_or(vbss_contact_turn_into_plane(row->is.way, row->normal), row->is.way);
        }
        place_row(s, row, a, b, &d, &e);
    }
}

void vbss_scene_measure_gaps(scene_object *s)
{
    for (uint32_t i = 0; i < s->contacts->count; i++) {
        contact_row *row = &s->contacts->rows[i];
        const scene_body *b = vbss_scene_body(s, row->key.body_b);
        if (b != NULL && !row->bilateral) {
            const side d = side_of(s, &row->key, vbss_scene_body(s, row->key.body_a), 0);
            const side e = side_of(s, &row->key, b, 1);
            double at[2];
            row->gap = vec3_norm(closest(d.trial, e.trial, at)) - d.radius - e.radius;
        }
    }
}
