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

/* One of the two features of a row. Its axis is a segment; of a node or the end of a capsule, a point. */
typedef struct side {
    const scene_body *body;
    const scene_capsule *capsule; /* NULL: of a thread */
    uint32_t feature;
    bool point, smooth; /* a node: of the curve that is smoothed there */
    double radius;
} side;

typedef enum moment { BEGIN, AHEAD, TRIAL } moment; /* ahead: where it may go */

/* ---- what a feature is */

/* Rows come by bodies, so it is mostly the last one. */
static const scene_body *body_of(const scene_object *s, uint32_t number, const scene_body *last)
{
    return last != NULL && last->number == number ? last : vbss_scene_body(s, number);
}

static side side_of(const scene_object *s, const contact_row *row, const scene_body *b, int which)
{
    uint32_t kind = row->key.kind, feature = which == 0 ? row->key.a : row->key.b;
    side d = {.body = b, .feature = feature};
    if (b->kind == BODY_THREAD) {
        d.point = kind == VBSS_CONTACT_NODE_CAPSULE || kind == VBSS_CONTACT_NODE_FLOOR;
        /* ends of the thread alone are as they are */
        d.smooth = kind == VBSS_CONTACT_NODE_CAPSULE && feature > 0 &&
                   feature + 1 < b->thread.thread->node_count;
        d.radius = b->thread.thread->config.radius;
        return d;
    }
    d.point = kind == VBSS_CONTACT_CAPSULE_FLOOR;
    d.capsule = &s->capsules[b->rigid.first_capsule + (d.point ? feature / 2 : feature)];
    d.radius = d.capsule->radius;
    return d;
}

static vec3 smooth_point(const vec3 *x)
{
    return vec3_add_scaled(vec3_scale(x[0], SMOOTH_NODE), SMOOTH_NEIGHBOUR, vec3_add(x[-1], x[1]));
}

static void axis_of_thread(const side *d, const vec3 *x, vec3 axis[2])
{
    x += d->feature;
    axis[0] = d->smooth ? smooth_point(x) : x[0];
    axis[1] = d->point ? axis[0] : x[1];
}

static void axis_of_capsule(const side *d, const vec3 ends[2], vec3 axis[2])
{
    uint32_t end = d->point ? d->feature % 2 : 0;
    axis[0] = ends[end];
    axis[1] = d->point ? axis[0] : ends[1];
}

static void axis_of(const scene_object *s, const side *d, moment when, vec3 axis[2])
{
    bool thread = d->capsule == NULL, trial = when == TRIAL;
    if (thread) {
        const thread_object *t = d->body->thread.thread;
        axis_of_thread(d, trial ? t->trial : t->now.x, axis);
    } else {
        axis_of_capsule(d, trial ? d->capsule->trial : d->capsule->now, axis);
    }
    if (when != AHEAD) {
        return;
    }
    vec3 way[2];
    if (thread) {
        axis_of_thread(d, s->ways + d->body->thread.first_node, way);
    } else {
        size_t number = (size_t)(d->capsule - s->capsules);
        axis_of_capsule(d, s->ways + s->config.node_capacity + 2 * number, way);
    }
    axis[0] = vec3_add(axis[0], way[0]);
    axis[1] = vec3_add(axis[1], way[1]);
}

/* From b to a between the closest points of their axes; of the two only a may be a point. */
static vec3 closest(const side *d, const vec3 a[2], const vec3 b[2], double at[2])
{
    vec3 along = vec3_sub(b[1], b[0]);
    if (d->point) {
        vec3 to = vec3_sub(a[0], b[0]);
        at[0] = 0.0;
        at[1] = closest_on_edge(along, to);
        return vec3_add_scaled(to, -at[1], along);
    }
    return vec3_neg(
        closest_edges(vec3_sub(a[1], a[0]), along, vec3_sub(b[0], a[0]), &at[0], &at[1]));
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
    const scene_pin *weld =
        b->thread.thread->welded[node] != 0 ? vbss_scene_weld_of(s, b->number, node) : NULL;
    if (weld == NULL) {
        add_term(row, b->thread.first_block + node, weight);
        return;
    }
    const scene_rigid *r = &vbss_scene_body(s, weld->body)->rigid;
    vbss_scene_add_rigid_terms(row, r, pose_apply(r->trial, weld->point), weight);
}

/* The terms that move `point` of the surface, at `at` of the feature's axis. */
static void add_terms(const scene_object *s, contact_row *row, const side *d, double at, vec3 point,
                      double sign)
{
    const scene_body *b = d->body;
    if (d->capsule != NULL) {
        vbss_scene_add_rigid_terms(row, &b->rigid, point, sign);
    } else if (!d->point) {
        vbss_scene_add_node_term(s, row, b, d->feature, sign * (1.0 - at));
        vbss_scene_add_node_term(s, row, b, d->feature + 1, sign * at);
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
    uint32_t first = d->point ? d->feature % 2 : 0, last = d->point ? first : 1;
    /* a jaw's axis goes against its body */
    vec3 moved = vec3_lerp(vec3_sub(c->local_trial[first], c->local[first]),
                           vec3_sub(c->local_trial[last], c->local[last]), at);
    return pose_apply(r->body.now.at, vec3_sub(pose_apply_inverse(r->trial, point), moved));
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

/* One side of a row, once normal and places are known: its terms, how far its point has come since the part began,
 * and where its axis is. `out` is from the axis to the surface. */
static vec3 place_side(const scene_object *s, contact_row *row, const side *d, double at, vec3 out,
                       double sign)
{
    vec3 axis[2], before[2];
    axis_of(s, d, TRIAL, axis);
    vec3 here = vec3_lerp(axis[0], axis[1], at), point = vec3_add(here, out), began;
    add_terms(s, row, d, at, point, sign);
    if (d->capsule != NULL) {
        began = point_at_begin(d, at, point);
        row->slid = vec3_add_scaled(row->slid, sign, vec3_sub(point, began));
    } else {
        axis_of(s, d, BEGIN, before);
        began = vec3_lerp(before[0], before[1], at);
        row->slid = vec3_add_scaled(row->slid, sign, vec3_sub(here, began));
    }
    return here;
}

static void place_row(const scene_object *s, contact_row *row, const side *d, const side *e)
{
    const vec3 n = row->normal;
    row->term_count = 0;
    row->slid = vec3_zero();
    vec3 out = vec3_scale(n, -d->radius), here = place_side(s, row, d, row->at[0], out, 1.0);
    if (e == NULL) {
        row->gap = vec3_dot(n, here) - s->config.floor_height - d->radius;
    } else {
        vec3 there = place_side(s, row, e, row->at[1], vec3_scale(n, e->radius), -1.0);
        row->gap = vec3_dot(n, vec3_sub(here, there)) - d->radius - e->radius;
    }
    row->point = vec3_add_scaled(vec3_add(here, out), -0.5 * row->gap, n);
}

/* Whether normals of the begin will do: those of segments jump, or turn fast as their radius is small; velocities
 * that are a little wrong would make them worse, and tight knots tremble. */
static bool keeps_normal(const contact_row *row)
{
    return row->key.kind == VBSS_CONTACT_SEGMENTS || row->key.kind == VBSS_CONTACT_SEGMENT_CAPSULE;
}

bool vbss_scene_lay_row(const scene_object *s, contact_row *row, const scene_body *a,
                        const scene_body *b, double reach)
{
    vec3 one[2], other[2];
    const side d = side_of(s, row, a, 0);
    axis_of(s, &d, BEGIN, one);
    if (b == NULL) {
        row->normal = s->floor_normal;
        row->at[0] = row->at[1] = 0.0;
        row->thickness = 2.0 * d.radius;
        row->gap_before = vec3_dot(row->normal, one[0]) - s->config.floor_height - d.radius;
        return row->gap_before < reach;
    }
    const side e = side_of(s, row, b, 1);
    axis_of(s, &e, BEGIN, other);
    vec3 apart = closest(&d, one, other, row->at);
    double distance = vec3_norm(apart), touching = d.radius + e.radius;
    row->thickness = 2.0 * lesser(d.radius, e.radius);
    row->gap_before = distance - touching;
    if (!(row->gap_before < reach)) {
        return false;
    }
    if (distance > NO_DISTANCE) {
        row->normal = vec3_scale(apart, 1.0 / distance);
    } else { /* axes that meet: as good as any direction that is across both */
        vec3 across = vec3_cross(vec3_sub(one[1], one[0]), vec3_sub(other[1], other[0]));
        row->normal = vec3_unit_or(across, vec3_make(0.0, 1.0, 0.0));
    }
    if (keeps_normal(row)) {
        return true;
    }
    /* The force acts where they will be: a normal of the begin leans back, and brakes by v h / R. */
    double at[2];
    axis_of(s, &d, AHEAD, one);
    axis_of(s, &e, AHEAD, other);
    vec3 then = closest(&d, one, other, at);
    double later = vec3_norm(then);
    if (later > STILL_APART * touching && vec3_dot(then, row->normal) > SAME_SIDE * later) {
        row->normal = vec3_scale(then, 1.0 / later);
        row->at[0] = at[0];
        row->at[1] = at[1];
    }
    return true;
}

typedef enum look_at_row { SET, REFRESH, LAY_AGAIN, MEASURE } look_at_row;

static void lay_again(const scene_object *s, contact_row *row, const side *d, const side *e)
{
    vec3 one[2], other[2];
    axis_of(s, d, TRIAL, one);
    axis_of(s, e, TRIAL, other);
    row->normal = vec3_unit_or(closest(d, one, other, row->at), row->normal);
    row->held = vbss_contact_turn_into_plane(row->held, row->normal);
    row->is.way = vec3_unit_or(vbss_contact_turn_into_plane(row->is.way, row->normal), row->is.way);
}

static void measure(const scene_object *s, contact_row *row, const side *d, const side *e)
{
    vec3 one[2], other[2];
    double at[2];
    axis_of(s, d, TRIAL, one);
    axis_of(s, e, TRIAL, other);
    row->gap = vec3_norm(closest(d, one, other, at)) - d->radius - e->radius;
}

static void look(const scene_object *s, contact_row *row, const side *d, const side *e,
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
        contact_row *row = &s->contacts->rows[i];
        if (row->bilateral) {
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
