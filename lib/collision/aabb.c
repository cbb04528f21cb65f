/* AABBs of a shape's features, from the positions of its nodes. */
#include "collision/shapes.h"

void vbss_collision_shape_invalidate(collision_shape *s)
{
    s->boxes_valid = false;
    if (s->swept_boxes == NULL) {
        vbss_collision_shape_invalidate_trees(s);
    }
}

void vbss_collision_shape_invalidate_trees(collision_shape *s)
{
    s->point_bvh_valid = s->edge_bvh_valid = s->triangle_bvh_valid = false;
}

void vbss_collision_shape_update_boxes(collision_shape *s)
{
    if (s->boxes_valid) {
        return;
    }
    collision_aabb root = aabb_empty(),
                   *boxes = s->swept_boxes != NULL ? s->swept_boxes : s->point_bvh.boxes;
    for (uint32_t i = 0; i < s->node_count; i++) {
        const double start[3] = {s->start[i].x, s->start[i].y, s->start[i].z};
        const double end[3] = {s->end[i].x, s->end[i].y, s->end[i].z};
        collision_aabb *box = &boxes[i];
        for (int k = 0; k < 3; k++) {
            box->low[k] = vbss_min(start[k], end[k]) - s->inflation;
            box->high[k] = vbss_max(start[k], end[k]) + s->inflation;
        }
        aabb_extend(&root, box);
    }
    s->root = root;
    s->boxes_valid = true;
    if (s->swept_boxes != NULL) {
        vbss_collision_fit_loose_boxes(s);
    }
}

void vbss_collision_shape_refit_points(collision_shape *s)
{
    if (s->point_bvh_valid) {
        return;
    }
    if (vbss_collision_bvh_refit(&s->point_bvh) && s->exclusion.words > 0) {
        vbss_collision_update_excluded_points(s);
    }
    s->point_bvh_valid = true;
}

/* Rounding preserves the order of numbers, so the box around inflated points equals the inflated
 * box around the points to the bit. */
void vbss_collision_shape_refit_edges(collision_shape *s)
{
    if (s->edge_bvh_valid) {
        return;
    }
    for (uint32_t i = 0; i < s->edge_count; i++) {
        collision_aabb box = s->point_bvh.boxes[s->edges[i][0]];
        aabb_extend(&box, &s->point_bvh.boxes[s->edges[i][1]]);
        s->edge_bvh.boxes[i] = box;
    }
    if (vbss_collision_bvh_refit(&s->edge_bvh) && s->exclusion.words > 0) {
        vbss_collision_update_excluded_edges(s);
    }
    s->edge_bvh_valid = true;
}

void vbss_collision_shape_refit_triangles(collision_shape *s)
{
    if (s->triangle_bvh_valid) {
        return;
    }
    for (uint32_t i = 0; i < s->triangle_count; i++) {
        collision_aabb box = s->point_bvh.boxes[s->triangles[i][0]];
        aabb_extend(&box, &s->point_bvh.boxes[s->triangles[i][1]]);
        aabb_extend(&box, &s->point_bvh.boxes[s->triangles[i][2]]);
        s->triangle_bvh.boxes[i] = box;
    }
    if (vbss_collision_bvh_refit(&s->triangle_bvh) && s->exclusion.words > 0) {
        vbss_collision_update_excluded_points(s);
    }
    s->triangle_bvh_valid = true;
}
