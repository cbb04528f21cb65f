/* After a step: where adaptive threads are bent or near something they get nodes, where they are straight and alone
 * they lose them. All changes of a step are found before the first is made, far enough from each other that none
 * has to know of the rest; trees that the guard has left find what is near. */
#include "scene/cuts.h"
#include "scene/meshes.h"
#include "scene/tools.h"

#include "collision/closest.h"

#include <string.h>

/* Share of the radius of a tool that is a good length of segments on it. */
#define ON_TOOL 0.25
/* Nodes between two changes of one step, so that neither moves what the other looks at. */
enum { APART = 10, MOST_CHANGES = 64 };
/* Of a segment: more room than any change of a sound mesh takes. Of the gap to what is near, for each of the two
 * that may move. */
#define ROOM 0.05
#define SHARE_OF_GAP 0.25
/* A strand is near itself beyond this arc, in distances from axis to axis: nearer it is only bent. */
#define FAR_ALONG 2.0
/* Nodes at the ends of a cut that has not come apart. */
enum { CUT_END = 4 };

/* ---- what is near */

/* A piece of an axis, and the segments of its own thread that do not count. */
typedef struct probe {
    const scene_body *body;
    vec3 axis[2];
    uint32_t first, end; /* of these segments; after their last */
    bool any;            /* one strand is enough to know */
} probe;

typedef struct around {
    double strand, tool, floor; /* gaps, m; INFINITY: none within */
    double on_tool;             /* least length that the tools within would like, m */
} around;

static bool boxes_meet(const collision_aabb *a, const collision_aabb *b)
{
    bool meet = true;
    for (int k = 0; k < 3; k++) {
        meet = meet && a->low[k] <= b->high[k] && b->low[k] <= a->high[k];
    }
    return meet;
}

static collision_aabb box_around(const vec3 *axis, double reach)
{
    const double p[3] = {axis[0].x, axis[0].y, axis[0].z}, q[3] = {axis[1].x, axis[1].y, axis[1].z};
    collision_aabb box = {{0.0}, {0.0}};
    for (int k = 0; k < 3; k++) {
        box.low[k] = vbss_min(p[k], q[k]) - reach;
        box.high[k] = vbss_max(p[k], q[k]) + reach;
    }
    return box;
}

static double distance(const vec3 *a, const vec3 *b)
{
    double at[2];
    return vec3_norm(closest_between_edges(vec3_sub(a[1], a[0]), vec3_sub(b[1], b[0]),
                                           vec3_sub(b[0], a[0]), &at[0], &at[1]));
}

/* A strand that was cut off is not near the other end of the cut. */
static bool is_ignored(const scene_object *s, const probe *p, const scene_body *b, uint32_t feature)
{
    if (b == p->body) {
        return feature >= p->first && feature < p->end;
    }
    return b->kind == BODY_THREAD && p->first < p->end &&
           vbss_scene_adjoins(s, p->body, p->first, b, feature);
}

/* The surface of a drain leaves room as a tool does, and bends a thread no more than its radius, which is large. */
static void note_wall(const probe *p, const drain_object *d, double apart, double within,
                      around *found)
{
    double gap = apart - p->body->thread.thread->config.radius - 0.5 * d->config.thickness;
    found->tool = gap < within ? vbss_min(gap, found->tool) : found->tool;
}

static void look_at_face(const scene_object *s, const probe *p, const scene_body *b, uint32_t face,
                         double within, around *found)
{
    const uint32_t *nodes = s->collision->shapes[b->shape]->triangles[face];
    const drain_object *d = b->drain.drain;
    double weights[3];
    for (int end = 0; end < 2; end++) {
        vec3 corners[3];
        for (int k = 0; k < 3; k++) {
            corners[k] = vec3_sub(d->x[nodes[k]], p->axis[end]);
        }
        note_wall(p, d, vec3_norm(closest_on_triangle(corners, weights)), within, found);
    }
}

static void look_at(const scene_object *s, const probe *p, const scene_body *b, uint32_t feature,
                    double within, around *found)
{
    double radius = p->body->thread.thread->config.radius;
    if (is_ignored(s, p, b, feature)) {
        return;
    }
    if (b->kind == BODY_THREAD) {
        const thread_object *t = b->thread.thread;
        double gap = distance(p->axis, t->now.x + feature) - radius - t->config.radius;
        found->strand = gap < within ? vbss_min(gap, found->strand) : found->strand;
        return;
    }
    if (b->kind == BODY_DRAIN) {
        const uint32_t *side = s->collision->shapes[b->shape]->edges[feature];
        const drain_object *d = b->drain.drain;
        const vec3 edge[2] = {d->x[side[0]], d->x[side[1]]};
        note_wall(p, d, distance(p->axis, edge), within, found);
        return;
    }
    const scene_capsule *c = &s->capsules[b->rigid.first_capsule + feature];
    vec3 axis[2];
    vbss_scene_place_capsule(c, b->rigid.body.now.pose, axis);
    double gap = distance(p->axis, axis) - radius - c->radius;
    if (gap < within) {
        found->tool = vbss_min(gap, found->tool);
        found->on_tool = vbss_min(ON_TOOL * c->radius, found->on_tool);
    }
}

/* What is nearer than that. Boxes are those of the last part, which hold all that is there now. */
static around look_around(scene_object *s, const probe *p, double within)
{
    collision_object *c = s->collision;
    const double none = (double)INFINITY;
    double radius = p->body->thread.thread->config.radius;
    around found = {none, none, none, none};
    collision_aabb box = box_around(p->axis, radius + within);
    for (uint32_t i = 0; i < s->place_count; i++) {
        const scene_body *b = &s->bodies[i];
        if (b->kind == BODY_GONE || !boxes_meet(&c->shapes[b->shape]->root, &box)) {
            continue;
        }
        collision_shape *shape = c->shapes[b->shape];
        vbss_collision_shape_refit_edges(shape);
        uint32_t *near = b->kind == BODY_DRAIN ? b->drain.near : s->near;
        uint32_t count = VBSS_WIDE_CALL(c->wide, vbss_collision_bvh_query, &c->search,
                                        &shape->edge_bvh, &box, near);
        for (uint32_t k = 0; k < count; k++) {
            look_at(s, p, b, near[k], within, &found);
            if (p->any && found.strand < within) {
                return found;
            }
        }
        if (b->kind == BODY_DRAIN) {
            vbss_collision_shape_refit_triangles(shape);
            count = VBSS_WIDE_CALL(c->wide, vbss_collision_bvh_query, &c->search,
                                   &shape->triangle_bvh, &box, near);
            for (uint32_t k = 0; k < count; k++) {
                look_at_face(s, p, b, near[k], within, &found);
            }
        }
    }
    for (int end = 0; s->config.floor != 0 && end < 2; end++) {
        double above = vec3_dot(p->axis[end], s->floor_normal) - s->config.floor_height - radius;
        found.floor = vbss_min(above, found.floor);
    }
    return found;
}

/* Nodes low and high with what is between them left out, and what is nearer than an arc along the thread. */
static probe probe_of(const scene_body *b, uint32_t low, uint32_t high, double arc)
{
    const thread_object *t = b->thread.thread;
    probe p = {b, {t->now.x[low], t->now.x[high]}, low, high, false};
    for (double left = arc; p.first > 0 && left > 0.0;) {
        left -= t->rest[--p.first];
    }
    for (double left = arc; p.end + 1 < t->node_count && left > 0.0;) {
        left -= t->rest[p.end++];
    }
    return p;
}

static around around_segments(scene_object *s, const scene_body *b, uint32_t low, uint32_t high,
                              double within)
{
    double apart = within + 2.0 * b->thread.thread->config.radius;
    probe p = probe_of(b, low, high, FAR_ALONG * apart);
    p.any = true;
    return look_around(s, &p, within);
}

/* How far the nodes beside a change may be moved: a share of the least gap of any segment there. What is nearer
 * along the thread than it may touch itself does not count. */
static double room_among(scene_object *s, const scene_body *b, uint32_t low, uint32_t high,
                         double most)
{
    const thread_object *t = b->thread.thread;
    double arc = s->collision->config.exclusion * 2.0 * t->config.radius,
           least = most / SHARE_OF_GAP;
    uint32_t last = t->node_count - 1;
    for (uint32_t k = low; k < high && k < last; k++) {
        probe p = probe_of(b, k, k + 1, arc);
        around a = look_around(s, &p, least);
        least = vbss_min(vbss_min(a.strand, a.tool), vbss_min(a.floor, least));
    }
    return vbss_max(SHARE_OF_GAP * least, 0.0);
}

/* ---- where nothing changes */

static bool is_cut_end(const scene_object *s, const scene_body *b, uint32_t low, uint32_t high)
{
    if (b->thread.before != 0 && low < CUT_END) {
        return true;
    }
    for (uint32_t i = 0; i < s->place_count; i++) {
        const scene_body *piece = &s->bodies[i];
        if (piece->kind == BODY_THREAD && piece->thread.before == b->number) {
            return high + CUT_END >= b->thread.thread->node_count;
        }
    }
    return false;
}

static bool is_held(const scene_object *s, const scene_body *b, uint32_t low, uint32_t high)
{
    const thread_object *t = b->thread.thread;
    if (vbss_thread_has_attached_node(t, low, high) || is_cut_end(s, b, low, high)) {
        return true;
    }
    for (uint32_t i = 0; i < s->config.grasp_capacity; i++) {
        const scene_grasp *g = &s->grasps[i];
        for (uint32_t k = low; g->id != 0 && g->thread == b->number && k < high; k++) {
            if (k + 1 < t->node_count && vbss_scene_is_held_at(s, g, k, 2.0 * t->config.radius)) {
                return true;
            }
        }
    }
    return false;
}

/* ---- the plan of a step */

typedef struct plan {
    scene_body *body;
    uint32_t count, comers, most;
    mesh_change
        changes[MOST_CHANGES]; /* from the end of the thread on: those before keep their numbers */
} plan;

static bool is_apart(const plan *p, uint32_t at)
{
    for (uint32_t i = 0; i < p->count; i++) {
        uint32_t other = p->changes[i].at;
        if ((at > other ? at - other : other - at) < APART) {
            return false;
        }
    }
    return true;
}

static void add(plan *p, uint32_t at, bool removes, double room)
{
    uint32_t to = p->count++;
    while (to > 0 && p->changes[to - 1].at < at) {
        p->changes[to] = p->changes[to - 1];
        to--;
    }
    p->changes[to] = (mesh_change){at, removes, room};
    p->comers += !removes;
}

static bool wants_division(scene_object *s, const scene_body *b, uint32_t segment)
{
    const thread_object *t = b->thread.thread;
    const vbss_thread_config *c = &t->config;
    double l = t->rest[segment];
    if (l <= REMESH_LENGTH_TOLERANCE * c->finest_length) {
        return false;
    }
    if (vbss_thread_needs_refinement(t, segment)) {
        return true;
    }
    around a = around_segments(s, b, segment, segment + 1, c->near_distance);
    return a.strand < c->near_distance || REMESH_LENGTH_TOLERANCE * a.on_tool < l;
}

static bool has_room_for_nodes(const scene_object *s, const thread_object *t, uint32_t comers)
{
    uint32_t spares = 0;
    for (uint32_t i = 0; i < s->place_count; i++) {
        spares += s->bodies[i].reserved && s->bodies[i].kind == BODY_GONE;
    }
    return comers < t->node_capacity - t->node_count &&
           s->node_count + comers + 2 * spares < s->node_capacity; /* two for each cut */
}

static void plan_division(scene_object *s, plan *p, uint32_t segment)
{
    thread_object *t = p->body->thread.thread;
    uint32_t at = vbss_thread_first_segment_to_split(t, segment);
    uint32_t low = at > 1 ? at - 2 : 0;
    if (!is_apart(p, at)) {
        return;
    }
    if (!has_room_for_nodes(s, t, p->comers)) {
        t->statistics.refused_capacity++;
    } else if (is_held(s, p->body, low, at + 3)) {
        t->statistics.refused_held++;
    } else {
        add(p, at, false, room_among(s, p->body, low, at + 3, ROOM * t->rest[at]));
    }
}

static void plan_removal(scene_object *s, plan *p, uint32_t node)
{
    thread_object *t = p->body->thread.thread;
    uint32_t low = node > 2 ? node - 3 : 0;
    if (!is_apart(p, node) || !vbss_thread_can_coarsen(t, node) ||
        !vbss_thread_is_straight(t, node)) {
        return;
    }
    if (is_held(s, p->body, low, node + 2)) {
        t->statistics.refused_held++;
        return;
    }
    double l = t->rest[node - 1] + t->rest[node];
    around a = around_segments(s, p->body, node - 1, node + 1, t->config.clear_distance);
    double room = 0.0;
    if (a.strand == (double)INFINITY && REMESH_LENGTH_TOLERANCE * a.on_tool >= l) {
        room = room_among(s, p->body, low, node + 3, ROOM * l);
    }
    if (room > 0.0) {
        add(p, node, true, room);
    } else {
        t->statistics.refused_near++;
    }
}

/* ---- the changes */

static void make_changes(scene_object *s, const plan *p)
{
    thread_object *t = p->body->thread.thread;
    for (uint32_t i = 0; i < p->count; i++) {
        if (!vbss_scene_change_mesh(s, p->body, &p->changes[i])) {
            t->statistics.refused_near++;
        }
    }
    vbss_collision_resize_chain(s->collision, p->body->shape, t->node_count, t->rest);
    vbss_scene_order_memory(s);
    vbss_scene_number_nodes(s);
    s->pattern = 0;
    s->generation++;
}

/* Shapes that the last part has not moved: what a cut has left. False: no place for a shape. */
static bool place_shapes(scene_object *s)
{
    for (uint32_t i = 0; i < s->place_count; i++) {
        const scene_body *b = &s->bodies[i];
        if (b->kind != BODY_THREAD || s->collision->shapes[b->shape]->boxes_valid) {
            continue;
        }
        const thread_object *t = b->thread.thread;
        if (vbss_collision_move(scene_collision(s), b->shape, &t->now.x->x, &t->now.x->x,
                                t->node_count) != VBSS_OK) {
            return false;
        }
        vbss_collision_shape_update_boxes(s->collision->shapes[b->shape]);
    }
    return true;
}

static void adapt(scene_object *s, scene_body *b)
{
    thread_object *t = b->thread.thread;
    plan p = {.body = b, .most = t->config.mesh_operations};
    for (uint32_t k = 0; k < REMESH_CHECKS_PER_STEP && p.count < p.most; k++) {
        uint32_t segment = vbss_thread_next_segment_to_check(t);
        if (wants_division(s, b, segment)) {
            plan_division(s, &p, segment);
        } else if (segment > 0) {
            plan_removal(s, &p, segment);
        }
    }
    if (p.count > 0) {
        make_changes(s, &p);
    }
    vbss_thread_record_node_count(t);
}

void vbss_scene_adapt_meshes(scene_object *s)
{
    for (uint32_t i = 0; i < s->place_count; i++) {
        scene_body *b = &s->bodies[i];
        if (b->kind == BODY_THREAD && thread_is_adaptive(b->thread.thread) && place_shapes(s)) {
            adapt(s, b);
        }
    }
}
