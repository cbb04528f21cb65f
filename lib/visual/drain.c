/* Draws a drain as a wall of finite thickness: chooses the divisions of its edges, plans the
 * vertices, and reuses the unchanged parts of earlier frames. */
#include "base/simd_dispatch.h"
#include "visual/visual.h"

static uint32_t count_divisions(const visual_object *v, double chord_error)
{
    double divisions = sqrt(chord_error / v->config.surface_tolerance);
    return (uint32_t)vbss_max(vbss_min(divisions, v->config.division_limit) + 0.999, 1.0);
}

/* Sets the layout of the wall for this number of divisions. Returns whether the frame has room for it. */
static bool set_layout(const visual_object *v, visual_frame *f, visual_wall *w, uint32_t divisions)
{
    const scene_drain_info *d = w->drain;
    w->divisions = divisions;
    w->face_count = d->node_count + d->edge_count * (divisions - 1) +
                    d->triangle_count * visual_interior_vertices(divisions);
    f->vertex_count = w->first_vertex + visual_wall_vertices(w);
    f->triangle_count = w->first_triangle + visual_wall_triangles(w);
    return f->vertex_count <= v->config.vertex_capacity &&
           f->triangle_count <= v->config.triangle_capacity;
}

/* Writes the vertices on the edges. Their curves tell how many divisions are needed, so those of
 * the last frame are tried first. Returns false if the wall does not fit. */
static bool write_edges(const visual_object *v, visual_frame *f, visual_wall *w, uint32_t expected)
{
    if (!set_layout(v, f, w, expected)) {
        w->divisions = 1; /* no vertices on edges */
    }
    for (;;) {
        const double error = VBSS_WIDE_CALL(v->wide, vbss_visual_write_wall_edges, w);
        const uint32_t needed = count_divisions(v, error), tried = w->divisions;
        if (!set_layout(v, f, w, needed)) {
            return false;
        }
        if (needed == tried) {
            return true;
        }
    }
}

static bool is_same_mesh(const visual_wall_record *a, const visual_wall_record *b)
{
    return a->drain == b->drain && a->divisions == b->divisions;
}

/* The back frame may still have the topology of this wall, from two updates ago. Walls before it
 * have overwritten no vertices and triangles from here on. */
static void write_topology(const visual_object *v, visual_frame *f, const visual_wall *w,
                           const visual_wall_record *record)
{
    const visual_frame *shown = &v->frames[v->front];
    const visual_wall_record *earlier = &f->walls[f->wall_count],
                             *last = &shown->walls[f->wall_count];
    if (is_same_mesh(earlier, record) && earlier->first_vertex == record->first_vertex &&
        earlier->first_triangle == record->first_triangle) {
        return;
    }
    if (is_same_mesh(last, record)) {
        vbss_visual_copy_wall_topology(w, shown, last);
    } else {
        vbss_visual_write_wall_topology(w);
    }
}

static void write_wall(const visual_object *v, visual_frame *f, visual_wall *w, const void *drain)
{
    const visual_wall_record *shown = &v->frames[v->front].walls[f->wall_count];
    VBSS_WIDE_CALL(v->wide, vbss_visual_find_wall_normals, w);
    if (!write_edges(v, f, w, shown->drain == drain ? shown->divisions : 1)) {
        return;
    }
    VBSS_WIDE_CALL(v->wide, vbss_visual_write_wall, w);
    const visual_wall_record record = {drain, w->divisions, w->first_vertex, w->first_triangle};
    write_topology(v, f, w, &record);
    f->walls[f->wall_count++] = record;
}

static void add_mark_decals(const visual_object *v, visual_frame *f, const scene_drain_info *d)
{
    for (int k = 0; k < 2; k++) {
        if (d->marks[k] != SCENE_INSPECT_NONE) {
            vbss_visual_add_decal(v, f, VBSS_VISUAL_SPOT_MARK, d->rest_positions[d->marks[k]],
                                  v->config.mark_radius);
        }
    }
}

void vbss_visual_draw_drain(visual_object *v, visual_frame *f, const scene_drain_info *d,
                            const void *identity)
{
    if (vbss_visual_fits(v, f)) {
        visual_wall w = {.drain = d,
                         .normals = v->node_vectors,
                         .rim_count = 2 * d->edge_count - 3 * d->triangle_count,
                         .first_vertex = f->vertex_count,
                         .first_triangle = f->triangle_count,
                         .half_thickness = 0.5 * d->thickness,
                         .origin = v->origin,
                         .outer = &f->vertices[f->vertex_count],
                         .triangles = &f->triangles[f->triangle_count]};
        write_wall(v, f, &w, identity);
    }
    add_mark_decals(v, f, d);
}
