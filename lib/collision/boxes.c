/* The boxes of a shape's features, from where its nodes are. */
#include "collision/shapes.h"

void vbss_collision_shape_moved(collision_shape *s)
{
    s->boxes_known = s->points_fit = s->edges_fit = s->triangles_fit = false;
}

void vbss_collision_shape_boxes(collision_shape *s)
{
    if (s->boxes_known) {
        return;
    }
    collision_box root = box_none();
    for (uint32_t i = 0; i < s->node_count; i++) {
        const double start[3] = {s->start[i].x, s->start[i].y, s->start[i].z};
        const double end[3] = {s->end[i].x, s->end[i].y, s->end[i].z};
        collision_box *box = &s->point_tree.boxes[i];
        for (int k = 0; k < 3; k++) {
            box->low[k] = lesser(start[k], end[k]) - s->reach;
            box->high[k] = greater(start[k], end[k]) + s->reach;
        }
        box_add(&root, box);
    }
    s->root = root;
    s->boxes_known = true;
}

void vbss_collision_shape_fit_points(collision_shape *s)
{
    if (s->points_fit) {
        return;
    }
    if (vbss_collision_tree_fit(&s->point_tree) && s->near.words > 0) {
        vbss_collision_near_point_lanes(s);
    }
    s->points_fit = true;
}

/* As rounding keeps the order of numbers, the box around enlarged points is the enlarged box around
 * points, to the bit. */
void vbss_collision_shape_fit_edges(collision_shape *s)
{
    if (s->edges_fit) {
        return;
    }
    for (uint32_t i = 0; i < s->edge_count; i++) {
        collision_box box = s->point_tree.boxes[s->edges[i][0]];
        box_add(&box, &s->point_tree.boxes[s->edges[i][1]]);
        s->edge_tree.boxes[i] = box;
    }
    if (vbss_collision_tree_fit(&s->edge_tree) && s->near.words > 0) {
        vbss_collision_near_edge_lanes(s);
    }
    s->edges_fit = true;
}

void vbss_collision_shape_fit_triangles(collision_shape *s)
{
    if (s->triangles_fit) {
        return;
    }
    for (uint32_t i = 0; i < s->triangle_count; i++) {
        collision_box box = s->point_tree.boxes[s->triangles[i][0]];
        box_add(&box, &s->point_tree.boxes[s->triangles[i][1]]);
        box_add(&box, &s->point_tree.boxes[s->triangles[i][2]]);
        s->triangle_tree.boxes[i] = box;
    }
    if (vbss_collision_tree_fit(&s->triangle_tree) && s->near.words > 0) {
        vbss_collision_near_point_lanes(s);
    }
    s->triangles_fit = true;
}
