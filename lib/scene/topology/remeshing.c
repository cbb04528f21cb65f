/* Adaptive meshes. After a step, threads get nodes where they are bent or near an obstacle, and
 * lose nodes where they are straight and alone.
 *
 * All changes of a step are planned before the first is made, far enough apart to be
 * independent. The bounding volume hierarchies of the last CCD find near features. */
#include "collision/closest.h"
#include "scene/tools/tools.h"
#include "scene/topology/topology.h"
#include "scene/tuning.h"
#include "scene/world/world.h"
#include "thread/remesh.h"

/* Capacity, chosen. */
enum { MAX_CHANGES = 64 };

/* ---- near features */

/* A part of a thread's axis, and the range of segments of the same thread to ignore. */
typedef struct probe {
    const scene_body *body;
    vec3 axis[2];
    uint32_t first, end; /* first segment to ignore, and the one after the last */
    bool any;            /* any strand within reach ends the query */
} probe;

typedef struct surroundings {
    double strand, tool, floor; /* smallest gaps, m; INFINITY: none within reach */
    double preferred_length;    /* smallest segment length that these tools ask for, m */
} surroundings;

static bool boxes_overlap(const collision_aabb *a, const collision_aabb *b)
{
    bool overlap = true;
    for (int k = 0; k < 3; k++) {
        overlap = overlap && a->low[k] <= b->high[k] && b->low[k] <= a->high[k];
    }
    return overlap;
}

static collision_aabb bounding_box(const vec3 *axis, double reach)
{
    const double p[3] = {axis[0].x, axis[0].y, axis[0].z}, q[3] = {axis[1].x, axis[1].y, axis[1].z};
    collision_aabb box = {{0.0}, {0.0}};
    for (int k = 0; k < 3; k++) {
        box.low[k] = vbss_min(p[k], q[k]) - reach;
        box.high[k] = vbss_max(p[k], q[k]) + reach;
    }
    return box;
}

static double segment_distance(const vec3 *a, const vec3 *b)
{
    double at[2];
    return vec3_norm(closest_between_edges(vec3_sub(a[1], a[0]), vec3_sub(b[1], b[0]),
                                           vec3_sub(b[0], a[0]), &at[0], &at[1]));
}

/* Also ignores segments across a cut that has not come apart. */
static bool is_ignored(const scene_object *s, const probe *p, const scene_body *b, uint32_t feature)
{
    if (b == p->body) {
        return feature >= p->first && feature < p->end;
    }
    return b->kind == SCENE_BODY_THREAD && p->first < p->end &&
           vbss_scene_is_excluded_across_cut(s, p->body, p->first, b, feature);
}

/* Records the gap to a wall as that to a tool. A wall asks for no segment length, because its
 * radius of curvature is large. */
static void record_wall_gap(const probe *p, double wall_radius, double distance, double within,
                            surroundings *found)
{
    double gap = distance - p->body->thread.thread->config.radius - wall_radius;
    found->tool = gap < within ? vbss_min(gap, found->tool) : found->tool;
}

/* Positions of the nodes of a drain or mesh, m. */
static scene_vertices surface_nodes(const scene_object *s, const scene_body *b)
{
    return b->kind == SCENE_BODY_DRAIN ? (scene_vertices){b->drain.drain->x, NULL}
                                       : scene_mesh_vertices(s, b);
}

static void record_face(const scene_object *s, const probe *p, const scene_body *b, uint32_t face,
                        double within, surroundings *found)
{
    const collision_shape *shape = s->collision->shapes[b->shape];
    const uint32_t *nodes = shape->triangles[face];
    const scene_vertices x = surface_nodes(s, b);
    double weights[3];
    for (int end = 0; end < 2; end++) {
        vec3 corners[3];
        for (int k = 0; k < 3; k++) {
            corners[k] = vec3_sub(scene_vertex(x, nodes[k]), p->axis[end]);
        }
        record_wall_gap(p, shape->radius, vec3_norm(closest_on_triangle(corners, weights)), within,
                        found);
    }
}

static void record_feature(const scene_object *s, const probe *p, const scene_body *b,
                           uint32_t feature, double within, surroundings *found)
{
    double radius = p->body->thread.thread->config.radius;
    if (is_ignored(s, p, b, feature)) {
        return;
    }
    if (b->kind == SCENE_BODY_THREAD) {
        const thread_object *t = b->thread.thread;
        double gap = segment_distance(p->axis, t->now.x + feature) - radius - t->config.radius;
        found->strand = gap < within ? vbss_min(gap, found->strand) : found->strand;
        return;
    }
    if (scene_has_triangles(b)) {
        const collision_shape *shape = s->collision->shapes[b->shape];
        const scene_vertices x = surface_nodes(s, b);
        const vec3 edge[2] = {scene_vertex(x, shape->edges[feature][0]),
                              scene_vertex(x, shape->edges[feature][1])};
        record_wall_gap(p, shape->radius, segment_distance(p->axis, edge), within, found);
        return;
    }
    const scene_capsule *c = &s->capsules[b->rigid.first_capsule + feature];
    vec3 axis[2];
    vbss_scene_transform_capsule(c, b->rigid.body.now.pose, axis);
    double gap = segment_distance(p->axis, axis) - radius - c->radius;
    if (gap < within) {
        found->tool = vbss_min(gap, found->tool);
        found->preferred_length =
            vbss_min(SCENE_REMESH_TOOL_RATIO * c->radius, found->preferred_length);
    }
}

/* `b` is NULL for the floor. */
static void record_plane(const scene_object *s, const scene_body *b, const probe *p,
                         surroundings *found)
{
    const scene_plane plane = scene_plane_of(s, b);
    for (int end = 0; end < 2; end++) {
        double above =
            scene_height_over(plane, p->axis[end]) - p->body->thread.thread->config.radius;
        found->floor = vbss_min(above, found->floor);
    }
}

/* Finds the gaps below `within`, m. The bounding boxes are those of the last substep and contain
 * the present positions. */
static surroundings find_surroundings(scene_object *s, const probe *p, double within)
{
    collision_object *c = s->collision;
    const double none = (double)INFINITY;
    double radius = p->body->thread.thread->config.radius;
    surroundings found = {none, none, none, none};
    collision_aabb box = bounding_box(p->axis, radius + within);
    for (uint32_t i = 0; i < s->body_count; i++) {
        const scene_body *b = &s->bodies[i];
        if (b->kind == SCENE_BODY_NONE || scene_is_plane(b) ||
            !boxes_overlap(&c->shapes[b->shape]->root, &box)) {
            continue;
        }
        collision_shape *shape = c->shapes[b->shape];
        vbss_collision_shape_refit_edges(shape);
        const collision_aabb there = scene_is_rigid_mesh(b)
                                         ? vbss_collision_box_in_frame(&box, b->rigid.body.now.pose)
                                         : box; /* in the frame of the trees */
        uint32_t *near = b->kind == SCENE_BODY_DRAIN ? b->drain.near_features
                         : scene_is_mesh(b)          ? b->rigid.mesh.near_features
                                                     : s->scratch.near_features;
        uint32_t count = VBSS_WIDE_CALL(c->wide, vbss_collision_bvh_query, &c->search,
                                        &shape->edge_bvh, &there, near);
        for (uint32_t k = 0; k < count; k++) {
            record_feature(s, p, b, near[k], within, &found);
            if (p->any && found.strand < within) {
                return found;
            }
        }
        if (scene_has_triangles(b)) {
            vbss_collision_shape_refit_triangles(shape);
            count = VBSS_WIDE_CALL(c->wide, vbss_collision_bvh_query, &c->search,
                                   &shape->triangle_bvh, &there, near);
            for (uint32_t k = 0; k < count; k++) {
                record_face(s, p, b, near[k], within, &found);
            }
        }
    }
    if (s->config.floor != 0) {
        record_plane(s, NULL, p, &found);
    }
    for (uint32_t i = 0; i < s->body_count; i++) {
        if (scene_is_plane(&s->bodies[i])) {
            record_plane(s, &s->bodies[i], p, &found);
        }
    }
    return found;
}

/* Probe from node `low` to node `high`. It ignores the segments between them and those within an
 * arc length on either side. */
static probe make_probe(const scene_body *b, uint32_t low, uint32_t high, double arc)
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

static surroundings find_surroundings_of_segments(scene_object *s, const scene_body *b,
                                                  uint32_t low, uint32_t high, double within)
{
    double axis_distance = within + 2.0 * b->thread.thread->config.radius;
    probe p = make_probe(b, low, high, SCENE_REMESH_SELF_ARC_RATIO * axis_distance);
    p.any = true;
    return find_surroundings(s, &p, within);
}

/* Largest displacement allowed for nodes beside a change, m: a fraction of the smallest gap of
 * any segment there. Segments of the same thread that are excluded from contact do not count. */
static double max_shift_among(scene_object *s, const scene_body *b, uint32_t low, uint32_t high,
                              double limit)
{
    const thread_object *t = b->thread.thread;
    double arc = s->collision->config.exclusion * 2.0 * t->config.radius,
           min_gap = limit / SCENE_REMESH_GAP_RATIO;
    uint32_t last = t->node_count - 1;
    for (uint32_t k = low; k < high && k < last; k++) {
        probe p = make_probe(b, k, k + 1, arc);
        surroundings a = find_surroundings(s, &p, min_gap);
        min_gap = vbss_min(vbss_min(a.strand, a.tool), vbss_min(a.floor, min_gap));
    }
    return vbss_max(SCENE_REMESH_GAP_RATIO * min_gap, 0.0);
}

/* ---- where the mesh must not change */

static bool is_cut_end(const scene_object *s, const scene_body *b, uint32_t low, uint32_t high)
{
    if (b->thread.cut_from != 0 && low < SCENE_CUT_END_NODES) {
        return true;
    }
    for (uint32_t i = 0; i < s->body_count; i++) {
        const scene_body *piece = &s->bodies[i];
        if (piece->kind == SCENE_BODY_THREAD && piece->thread.cut_from == b->number) {
            return high + SCENE_CUT_END_NODES >= b->thread.thread->node_count;
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
        const scene_thread_grasp *g = &s->thread_grasps[i];
        for (uint32_t k = low; g->id != 0 && g->thread == b->number && k < high; k++) {
            if (k + 1 < t->node_count &&
                vbss_scene_is_segment_in_grasp(s, g, k, 2.0 * t->config.radius)) {
                return true;
            }
        }
    }
    return false;
}

/* ---- the plan of a step */

typedef struct plan {
    scene_body *body;
    uint32_t count, added_nodes, max_changes;
    /* in descending order of position, so that a change does not renumber those after it */
    mesh_change changes[MAX_CHANGES];
} plan;

static bool is_apart(const plan *p, uint32_t at)
{
    for (uint32_t i = 0; i < p->count; i++) {
        uint32_t other = p->changes[i].at;
        if ((at > other ? at - other : other - at) < SCENE_REMESH_MIN_NODES_BETWEEN) {
            return false;
        }
    }
    return true;
}

static void add_change(plan *p, uint32_t at, bool removes, double max_shift)
{
    uint32_t to = p->count++;
    while (to > 0 && p->changes[to - 1].at < at) {
        p->changes[to] = p->changes[to - 1];
        to--;
    }
    p->changes[to] = (mesh_change){at, removes, max_shift};
    p->added_nodes += !removes;
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
    surroundings a = find_surroundings_of_segments(s, b, segment, segment + 1, c->near_distance);
    return a.strand < c->near_distance || REMESH_LENGTH_TOLERANCE * a.preferred_length < l;
}

static bool has_node_capacity(const scene_object *s, const thread_object *t, uint32_t added_nodes)
{
    uint32_t spares = 0;
    for (uint32_t i = 0; i < s->body_count; i++) {
        spares += s->bodies[i].is_reserved && s->bodies[i].kind == SCENE_BODY_NONE;
    }
    return added_nodes < t->node_capacity - t->node_count &&
           s->node_count + added_nodes + 2 * spares < s->node_capacity; /* two nodes for each cut */
}

static void plan_division(scene_object *s, plan *p, uint32_t segment)
{
    thread_object *t = p->body->thread.thread;
    uint32_t at = vbss_thread_first_segment_to_split(t, segment);
    uint32_t low = at > 1 ? at - 2 : 0;
    if (!is_apart(p, at)) {
        return;
    }
    if (!has_node_capacity(s, t, p->added_nodes)) {
        t->statistics.refused_capacity++;
    } else if (is_held(s, p->body, low, at + 3)) {
        t->statistics.refused_held++;
    } else {
        add_change(
            p, at, false,
            max_shift_among(s, p->body, low, at + 3, SCENE_REMESH_SHIFT_RATIO * t->rest[at]));
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
    surroundings a =
        find_surroundings_of_segments(s, p->body, node - 1, node + 1, t->config.clear_distance);
    double max_shift = 0.0;
    if (a.strand == (double)INFINITY && REMESH_LENGTH_TOLERANCE * a.preferred_length >= l) {
        max_shift = max_shift_among(s, p->body, low, node + 3, SCENE_REMESH_SHIFT_RATIO * l);
    }
    if (max_shift > 0.0) {
        add_change(p, node, true, max_shift);
    } else {
        t->statistics.refused_near++;
    }
}

/* ---- the changes */

static void make_changes(scene_object *s, const plan *p)
{
    thread_object *t = p->body->thread.thread;
    for (uint32_t i = 0; i < p->count; i++) {
        if (!vbss_scene_apply_mesh_change(s, p->body, &p->changes[i])) {
            t->statistics.refused_near++;
        }
    }
    vbss_collision_resize_chain(s->collision, p->body->shape, t->node_count, t->rest);
    vbss_scene_sort_warm_start(s);
    vbss_scene_number_nodes(s);
    s->step.pattern_hash = 0;
    s->report.generation++;
}

/* Updates the boxes of shapes that the last substep has not moved, as those after a cut. Returns
 * false if a position is invalid. */
static bool update_shape_boxes(scene_object *s)
{
    for (uint32_t i = 0; i < s->body_count; i++) {
        const scene_body *b = &s->bodies[i];
        if (b->kind != SCENE_BODY_THREAD || s->collision->shapes[b->shape]->boxes_valid) {
            continue;
        }
        const thread_object *t = b->thread.thread;
        if (vbss_collision_set_motion(scene_collision(s), b->shape, &t->now.x->x, &t->now.x->x,
                                      t->node_count) != VBSS_OK) {
            return false;
        }
        vbss_collision_shape_update_boxes(s->collision->shapes[b->shape]);
    }
    return true;
}

static void adapt_mesh(scene_object *s, scene_body *b)
{
    thread_object *t = b->thread.thread;
    plan p = {.body = b, .max_changes = t->config.mesh_operations};
    for (uint32_t k = 0; k < REMESH_CHECKS_PER_STEP && p.count < p.max_changes; k++) {
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
    for (uint32_t i = 0; i < s->body_count; i++) {
        scene_body *b = &s->bodies[i];
        if (b->kind == SCENE_BODY_THREAD && thread_is_adaptive(b->thread.thread) &&
            update_shape_boxes(s)) {
            adapt_mesh(s, b);
        }
    }
}
