/* Posed meshes: meshes that move as rigid bodies, without a refit of their trees.
 *
 * In the frame of the start, a node at p moves along a straight line by f (M p + d), where M and d follow
 * from the two poses. Over the box of the mesh these displacements have bounds along each axis. A
 * feature of another shape can only come near nodes in its own box, in that frame, extended by the
 * opposite of the bounds. So one query of a tree at rest finds all of them. The pairs do not depend
 * on earlier searches. */
#include "collision/shapes.h"
#include "collision/tuning.h"

#include <string.h>

void vbss_collision_list_posed_arrays(const collision_shape *s, collision_posed *p,
                                      vbss_array arrays[COLLISION_POSED_ARRAYS])
{
    const uint32_t features = collision_max_features(s);
    const uint32_t found = features > s->node_count ? features : s->node_count;
    const vbss_array all[COLLISION_POSED_ARRAYS] = {
        {&p->local, s->node_count, sizeof *p->local},
        {&p->set_nodes, s->node_count, sizeof *p->set_nodes},
        {&p->mark, s->node_count, sizeof *p->mark},
        {&p->found, found, sizeof *p->found}};
    memcpy(arrays, all, sizeof all);
}

void vbss_collision_free_posed(vbss_context *context, collision_shape *s)
{
    vbss_array arrays[COLLISION_POSED_ARRAYS];
    if (s->posed == NULL) {
        return;
    }
    vbss_collision_list_posed_arrays(s, s->posed, arrays);
    vbss_release_arrays(context, arrays, COLLISION_POSED_ARRAYS);
    vbss_release(context, s->posed, 1, sizeof *s->posed);
    s->posed = NULL;
}

/* ---- boxes under affine maps */

static mat3 absolute(mat3 a)
{
    for (int i = 0; i < 3; i++) {
        for (int k = 0; k < 3; k++) {
            a.m[i][k] = fabs(a.m[i][k]);
        }
    }
    return a;
}

static double largest_of(vec3 v)
{
    return vbss_max(fabs(v.x), vbss_max(fabs(v.y), fabs(v.z)));
}

/* A box by its centre and half its sides. */
typedef struct middle_box {
    vec3 centre, half;
} middle_box;

/* Box around the image of a box, enlarged against rounding. */
static middle_box map_box(mat3 map, vec3 offset, middle_box box)
{
    const vec3 centre = vec3_add(offset, mat3_mul_vec3(map, box.centre));
    const vec3 half = mat3_mul_vec3(absolute(map), box.half);
    const double pad = COLLISION_POSED_PADDING *
                       (largest_of(offset) + largest_of(box.centre) + largest_of(box.half));
    return (middle_box){centre, vec3_add(half, vec3_make(pad, pad, pad))};
}

static middle_box middle_of(const collision_aabb *box)
{
    return (middle_box){
        vec3_make(0.5 * (box->low[0] + box->high[0]), 0.5 * (box->low[1] + box->high[1]),
                  0.5 * (box->low[2] + box->high[2])),
        vec3_make(0.5 * (box->high[0] - box->low[0]), 0.5 * (box->high[1] - box->low[1]),
                  0.5 * (box->high[2] - box->low[2]))};
}

static collision_aabb box_of(middle_box m)
{
    return (collision_aabb){
        {m.centre.x - m.half.x, m.centre.y - m.half.y, m.centre.z - m.half.z, 0.0},
        {m.centre.x + m.half.x, m.centre.y + m.half.y, m.centre.z + m.half.z, 0.0}};
}

/* Map of the world into the frame of a pose. Its rounding errors are relative to both positions. */
static middle_box into_frame(const collision_aabb *box, pose at)
{
    const mat3 back = mat3_transpose(quat_to_mat3(at.orientation));
    middle_box m = middle_of(box);
    const double pad = COLLISION_POSED_PADDING * (largest_of(at.position) + largest_of(m.centre));
    m.centre = vec3_sub(m.centre, at.position);
    m.half = vec3_add(m.half, vec3_make(pad, pad, pad));
    return map_box(back, vec3_zero(), m);
}

collision_aabb vbss_collision_box_in_frame(const collision_aabb *box, pose at)
{
    return box_of(into_frame(box, at));
}

/* Bounds of the displacements of all nodes, in the frame of the start. */
static middle_box displacements_of(const collision_posed *p)
{
    const mat3 back = mat3_transpose(quat_to_mat3(p->start.orientation));
    const mat3 turn = mat3_mul(back, quat_to_mat3(p->end.orientation));
    const mat3 map = mat3_scale(mat3_sub(turn, mat3_identity()), p->extrapolation);
    const vec3 moved = mat3_mul_vec3(back, vec3_sub(p->end.position, p->start.position));
    middle_box bounds =
        map_box(map, vec3_scale(moved, p->extrapolation), (middle_box){p->centre, p->half});
    const double pad = COLLISION_POSED_PADDING * largest_of(p->start.position);
    bounds.half = vec3_add(bounds.half, vec3_make(pad, pad, pad));
    return bounds;
}

/* ---- motion */

void vbss_collision_begin_posed_set(collision_shape *s)
{
    collision_posed *p = s->posed;
    p->set_count = 0;
    s->max_displacement = 0.0;
    p->present_mark++;
    if (p->present_mark == 0) { /* after 2^32 motions */
        memset(p->mark, 0, s->node_count * sizeof *p->mark);
        p->present_mark = 1;
    }
}

/* Sets the end of a node's motion and its displacement. */
static void set_end(collision_shape *s, uint32_t node)
{
    const collision_posed *p = s->posed;
    const vec3 start = s->start[node], end = pose_apply(p->end, p->local[node]);
    s->end[node] = p->extrapolation == 1.0
                       ? end
                       : vec3_add_scaled(start, p->extrapolation, vec3_sub(end, start));
    s->displacement[node] = vec3_distance(start, s->end[node]);
    s->max_displacement = vbss_max(s->displacement[node], s->max_displacement);
}

void vbss_collision_set_end_pose(collision_shape *s, pose end)
{
    collision_posed *p = s->posed;
    p->end = end;
    p->extrapolation = 1.0;
    s->max_displacement = 0.0;
    for (uint32_t i = 0; i < p->set_count; i++) {
        set_end(s, p->set_nodes[i]);
    }
}

static bool is_same_pose(const pose *a, const pose *b)
{
    return a->position.x == b->position.x && a->position.y == b->position.y &&
           a->position.z == b->position.z && a->orientation.w == b->orientation.w &&
           a->orientation.x == b->orientation.x && a->orientation.y == b->orientation.y &&
           a->orientation.z == b->orientation.z;
}

bool vbss_collision_begins_at(const collision_shape *s, const pose *at)
{
    return is_same_pose(&s->posed->start, at);
}

/* Bound of the magnitude of each component of the displacement of any node from one pose to another. */
static vec3 largest_components(const collision_shape *s, pose from, pose to)
{
    const collision_posed *p = s->posed;
    if (is_same_pose(&from, &to)) {
        return vec3_zero();
    }
    const mat3 map = mat3_sub(quat_to_mat3(to.orientation), quat_to_mat3(from.orientation));
    const middle_box moved =
        map_box(map, vec3_sub(to.position, from.position), (middle_box){p->centre, p->half});
    return vec3_make(fabs(moved.centre.x) + moved.half.x, fabs(moved.centre.y) + moved.half.y,
                     fabs(moved.centre.z) + moved.half.z);
}

double vbss_collision_largest_offset(const collision_shape *s, pose from, pose to)
{
    const vec3 moved = largest_components(s, from, to);
    return vbss_max_or_nan(moved.x, vbss_max_or_nan(moved.y, moved.z));
}

double vbss_collision_largest_distance(const collision_shape *s, pose from, pose to)
{
    return vec3_norm(largest_components(s, from, to));
}

/* ---- searches */

/* A cube around all places of the nodes, whatever the orientations: a twentieth of the cost of the box. */
void vbss_collision_update_posed_cube(collision_shape *s)
{
    const collision_posed *p = s->posed;
    const vec3 moved = vec3_sub(p->end.position, p->start.position);
    const vec3 end = vec3_add_scaled(p->start.position, p->extrapolation, moved);
    const double start_at[3] = {p->start.position.x, p->start.position.y, p->start.position.z};
    const double end_at[3] = {end.x, end.y, end.z};
    const double reach =
        p->reach * (fabs(1.0 - p->extrapolation) + p->extrapolation) + s->inflation;
    for (int k = 0; k < 3; k++) {
        const double pad =
            COLLISION_CUBE_PADDING * (fabs(start_at[k]) + fabs(end_at[k]) + largest_of(moved));
        s->root.low[k] = vbss_min(start_at[k], end_at[k]) - (reach + pad);
        s->root.high[k] = vbss_max(start_at[k], end_at[k]) + (reach + pad);
    }
    s->loose_root = s->root;
}

void vbss_collision_update_posed_box(collision_shape *s)
{
    collision_posed *p = s->posed;
    const middle_box displacements = displacements_of(p);
    p->moved_low = vec3_sub(displacements.centre, displacements.half);
    p->moved_high = vec3_add(displacements.centre, displacements.half);
    const mat3 from = quat_to_mat3(p->start.orientation), to = quat_to_mat3(p->end.orientation);
    const vec3 moved = vec3_sub(p->end.position, p->start.position);
    const mat3 map = mat3_add_scaled(from, p->extrapolation, mat3_sub(to, from));
    const middle_box all = {p->centre, p->half};
    collision_aabb box = box_of(map_box(from, p->start.position, all));
    const collision_aabb end =
        box_of(map_box(map, vec3_add_scaled(p->start.position, p->extrapolation, moved), all));
    aabb_extend(&box, &end);
    for (int k = 0; k < 3; k++) {
        box.low[k] -= s->inflation;
        box.high[k] += s->inflation;
    }
    s->root = s->loose_root = box;
}

void vbss_collision_begin_posed_search(collision_shape *s)
{
    collision_posed *p = s->posed;
    vbss_collision_begin_posed_set(s);
    p->previous = p->searched;
    p->searched = p->start;
    p->search_count = p->search_count < 2 ? p->search_count + 1 : 2;
}

static bool do_overlap(const collision_aabb *a, const collision_aabb *b)
{
    bool overlap = true;
    for (int k = 0; k < 3; k++) {
        overlap = overlap && a->low[k] <= b->high[k] && b->low[k] <= a->high[k];
    }
    return overlap;
}

static bool is_near_others(const collision_object *c, const collision_shape *s)
{
    bool is_near = false;
    for (uint32_t i = 0; i < c->active_count && !is_near; i++) {
        const collision_shape *other = c->shapes[c->active_shapes[i]];
        is_near = other->posed == NULL && do_overlap(&s->root, &other->loose_root);
    }
    return is_near;
}

/* The pairs of a posed mesh are listed again in every search, as long as there may be some. The box is inside the cube, so
 * it is not needed where nothing is in that. */
void vbss_collision_find_near_posed(collision_object *c)
{
    for (uint32_t i = 0; i < c->active_count; i++) {
        collision_shape *s = c->shapes[c->active_shapes[i]];
        if (s->posed == NULL) {
            continue;
        }
        bool is_near = is_near_others(c, s);
        if (is_near) {
            vbss_collision_update_posed_box(s);
            is_near = is_near_others(c, s);
        }
        s->posed->was_near = s->posed->is_near;
        s->posed->is_near = is_near;
        s->has_new_loose_boxes = s->has_new_loose_boxes || is_near || s->posed->was_near;
    }
}

void vbss_collision_set_posed_nodes(collision_shape *s, const uint32_t *nodes, uint32_t count)
{
    collision_posed *p = s->posed;
    for (uint32_t k = 0; k < count; k++) {
        const uint32_t n = nodes[k];
        if (p->mark[n] == p->present_mark) {
            continue;
        }
        p->mark[n] = p->present_mark;
        p->set_nodes[p->set_count++] = n;
        s->start[n] = pose_apply(p->start, p->local[n]);
        set_end(s, n);
        s->search_displacement[n] =
            p->search_count == 2 ? vec3_distance(pose_apply(p->previous, p->local[n]), s->start[n])
                                 : (double)INFINITY;
        const double start[3] = {s->start[n].x, s->start[n].y, s->start[n].z};
        const double end[3] = {s->end[n].x, s->end[n].y, s->end[n].z};
        for (int i = 0; i < 3; i++) {
            s->swept_boxes[n].low[i] = vbss_min(start[i], end[i]) - s->inflation;
            s->swept_boxes[n].high[i] = vbss_max(start[i], end[i]) + s->inflation;
        }
    }
}

/* Extends a box in the frame of the start, so that it contains every place at the start from which a node may
 * come into it. */
static void extend_back(const collision_posed *p, collision_aabb *box)
{
    const double low[3] = {p->moved_low.x, p->moved_low.y, p->moved_low.z};
    const double high[3] = {p->moved_high.x, p->moved_high.y, p->moved_high.z};
    for (int k = 0; k < 3; k++) {
        box->low[k] -= vbss_max(0.0, high[k]);
        box->high[k] -= vbss_min(0.0, low[k]);
    }
}

uint32_t vbss_collision_query_posed(collision_object *c, const collision_shape *mesh,
                                    const collision_bvh *tree, const collision_shape *other,
                                    collision_feature_nodes feature)
{
    const collision_posed *p = mesh->posed;
    collision_aabb box = other->swept_boxes[feature.nodes[0]];
    for (uint32_t k = 1; k < feature.count; k++) {
        aabb_extend(&box, &other->swept_boxes[feature.nodes[k]]);
    }
    if (!do_overlap(&box, &mesh->root)) {
        return 0;
    }
    collision_aabb local = vbss_collision_box_in_frame(&box, p->start);
    extend_back(p, &local);
    return VBSS_WIDE_CALL(c->wide, vbss_collision_bvh_query, &c->search, tree, &local, p->found);
}
