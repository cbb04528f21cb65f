/* Rows of what is near a drain: a point of whatever it is and a triangle, two sides, a node and the floor.
 *
 * A point touches a triangle where its closest point is within; where that is on a side, the side's own rows see it. */
#include "scene/scene.h"

#include "collision/closest.h"

/* What is proved to be far is so by more than rounding: share of the distance. */
#define PROVED (1.0 + 1e-9)
/* Planes between two features: more seldom part them. */
enum { WAYS_TRIED = 3 };

uint32_t vbss_scene_nodes_of(const scene_object *s, const scene_body *drain, uint32_t kind,
                             bool is_b, uint32_t feature, uint32_t nodes[3])
{
    const collision_shape *shape = s->collision->shapes[drain->shape];
    if (kind == VBSS_CONTACT_SIDES) {
        nodes[0] = shape->edges[feature][0];
        nodes[1] = shape->edges[feature][1];
        return 2;
    }
    if (kind == VBSS_CONTACT_POINT_FACE && is_b) {
        for (int k = 0; k < 3; k++) {
            nodes[k] = shape->triangles[feature][k];
        }
        return 3;
    }
    nodes[0] = feature;
    return 1;
}

/* The ways of a feature's vertices: of a drain gathered into room. */
static const vec3 *ways_of(const scene_object *s, const scene_body *b, const contact_key *key,
                           bool is_b, vec3 room[3], uint32_t *count)
{
    uint32_t feature = is_b ? key->b : key->a, nodes[3];
    bool side = key->kind == VBSS_CONTACT_SIDES;
    if (b->kind == BODY_DRAIN) {
        *count = vbss_scene_nodes_of(s, b, key->kind, is_b, feature, nodes);
        for (uint32_t k = 0; k < *count; k++) {
            room[k] = b->drain.ways[nodes[k]];
        }
        return room;
    }
    *count = side ? 2 : 1;
    if (b->kind == BODY_THREAD) {
        return s->ways + b->thread.first_node + feature;
    }
    const vec3 *first = s->ways + s->config.node_capacity + 2 * (size_t)b->rigid.first_capsule;
    return first + (side ? 2 * (size_t)feature : feature); /* ends stand two by two */
}

/* ---- most pairs whose boxes meet have a gap that is no row */

static vec3 middle_of(const vec3 *x, uint32_t count)
{
    vec3 sum = x[0];
    for (uint32_t k = 1; k < count; k++) {
        sum = vec3_add(sum, x[k]);
    }
    return vec3_scale(sum, 1.0 / count);
}

/* The corner that is farthest along a way. */
static vec3 farthest_along(const vec3 *x, uint32_t count, vec3 way)
{
    double most = vec3_dot(x[0], way);
    uint32_t at = 0;
    for (uint32_t k = 1; k < count; k++) {
        double along = vec3_dot(x[k], way);
        at = along > most ? k : at;
        most = along > most ? along : most;
    }
    return x[at];
}

/* Whether a plane parts two features by a distance: then no points of them are nearer. It is across a way from points of
 * one to points of the other, from middle to middle at first; then across a shorter one, towards the corners that lie
 * nearest along it (Gilbert 1966, An iterative procedure for computing the minimum of a quadratic form on a convex
 * set). */
static bool are_parted(const vec3 *a, uint32_t count_a, const vec3 *b, uint32_t count_b,
                       double distance)
{
    double least = PROVED * distance, square = least * least;
    vec3 way = vec3_sub(middle_of(b, count_b), middle_of(a, count_a));
    for (int k = 0; k < WAYS_TRIED; k++) {
        vec3 corners =
            vec3_sub(farthest_along(b, count_b, vec3_neg(way)), farthest_along(a, count_a, way));
        double apart = vec3_dot(corners, way);
        if (apart > 0.0 && apart * apart > square * vec3_norm_squared(way)) {
            return true;
        }
        vec3 on = vec3_sub(corners, way);
        way = vec3_add_scaled(way, closest_on_edge(on, vec3_neg(way)), on);
    }
    return false;
}

/* A feature where the part begins, and how far its corners may go. features.c finds corners for any row; asked of every
 * pair, that way takes what leaving pairs out saves (docs/contact.md). */
typedef struct feature {
    vec3 corners[3];
    uint32_t count;
    double radius, farthest;
} feature;

static void take_drain(const scene_object *s, const scene_body *b, const contact_key *key,
                       bool is_b, feature *f)
{
    const drain_object *d = b->drain.drain;
    uint32_t nodes[3];
    f->count = vbss_scene_nodes_of(s, b, key->kind, is_b, is_b ? key->b : key->a, nodes);
    for (uint32_t k = 0; k < f->count; k++) {
        f->corners[k] = d->x[nodes[k]];
    }
    f->radius = 0.5 * d->config.thickness;
    f->farthest = b->drain.longest;
}

/* Of a thread or a rigid body: a segment's two corners, or one point. */
static void take_other(const scene_object *s, const scene_body *b, const contact_key *key,
                       bool is_b, feature *f)
{
    const vec3 *ways = ways_of(s, b, key, is_b, NULL, &f->count), *x;
    uint32_t number = is_b ? key->b : key->a;
    if (b->kind == BODY_THREAD) {
        x = b->thread.thread->now.x + number;
        f->radius = b->thread.thread->config.radius;
    } else {
        bool side = f->count == 2;
        const scene_capsule *c =
            &s->capsules[b->rigid.first_capsule + (side ? number : number / 2)];
        x = side ? c->now : c->now + number % 2;
        f->radius = c->radius;
    }
    double square = 0.0;
    for (uint32_t k = 0; k < f->count; k++) {
        f->corners[k] = x[k];
        square = vbss_larger(vec3_norm_squared(ways[k]), square);
    }
    f->farthest = sqrt(square);
}

static void take(const scene_object *s, const scene_body *b, const contact_key *key, bool is_b,
                 feature *f)
{
    if (b->kind == BODY_DRAIN) {
        take_drain(s, b, key, is_b, f);
    } else {
        take_other(s, b, key, is_b, f);
    }
}

/* Whether they are too far from each other for a row, whatever they do in the part. What goes where it is told is told
 * elsewhere. */
static bool are_far(const scene_object *s, const contact_key *key, const scene_body *a,
                    const scene_body *b)
{
    feature one, other;
    take(s, a, key, false, &one);
    take(s, b, key, true, &other);
    double reach = SCENE_AHEAD * (one.farthest + other.farthest);
    double distance = one.radius + other.radius + reach + s->config.contact_margin;
    return are_parted(one.corners, one.count, other.corners, other.count, distance) &&
           !(vbss_scene_is_given(s, a, key->kind, false, key->a) &&
             vbss_scene_is_given(s, b, key->kind, true, key->b));
}

/* ---- rows */

static bool add_row(scene_object *s, const contact_key *key, const scene_body *a,
                    const scene_body *b)
{
    if (are_far(s, key, a, b)) {
        return true;
    }
    vec3 room_a[3], room_b[3];
    scene_meeting m = {.a = a, .b = b};
    m.ways_a = ways_of(s, a, key, false, room_a, &m.count_a);
    m.ways_b = ways_of(s, b, key, true, room_b, &m.count_b);
    return vbss_scene_add_row(s, key, &m);
}

bool vbss_scene_add_surface_row(scene_object *s, const collision_candidate *q)
{
    const scene_body *a = &s->bodies[s->shape_places[q->shape_a]];
    const scene_body *b = &s->bodies[s->shape_places[q->shape_b]];
    if (q->kind == VBSS_PAIR_POINT_TRIANGLE) {
        const contact_key key = {VBSS_CONTACT_POINT_FACE, a->number, q->a, b->number, q->b};
        return add_row(s, &key, a, b);
    }
    bool swapped = b->kind != BODY_DRAIN;
    const contact_key key = {VBSS_CONTACT_SIDES, swapped ? b->number : a->number,
                             swapped ? q->b : q->a, swapped ? a->number : b->number,
                             swapped ? q->a : q->b};
    return add_row(s, &key, swapped ? b : a, swapped ? a : b);
}

bool vbss_scene_add_drain_floor_rows(scene_object *s, const scene_body *b)
{
    const drain_object *d = b->drain.drain;
    for (uint32_t i = 0; i < d->mesh.node_count; i++) {
        const contact_key key = {VBSS_CONTACT_DRAIN_FLOOR, b->number, i, 0, 0};
        if (!vbss_scene_add_floor_row(s, &key, b, d->x[i], 0.5 * d->config.thickness,
                                      b->drain.ways[i])) {
            return false;
        }
    }
    return true;
}
