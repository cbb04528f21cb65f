/* Surfaces of hosts: checks, counts, and their copies in the mesh and the drain. */
#include "drain/surface.h"

#include "base/check.h"
#include "base/config.h"
#include "base/error.h"
#include "base/hash.h"
#include "base/memory.h"

#include <string.h>

_Static_assert(sizeof(vbss_drain_surface) == VBSS_SIZE_WITH_POINTERS(vbss_drain_surface, 16u, 5u),
               "published size");

static const vbss_drain_surface defaults = {.struct_size = sizeof(vbss_drain_surface)};
static const uint32_t surface_sizes[] = {VBSS_SIZE_WITH_POINTERS(vbss_drain_surface, 16u, 5u), 0};
static const vbss_layout surface_layout = {"vbss_drain_surface", &defaults, surface_sizes};

vbss_result vbss_drain_surface_init(vbss_drain_surface *surface, uint32_t struct_size)
{
    return vbss_config_init(&surface_layout, surface, struct_size);
}

/* ---- checks */

/* The arrays of a triangle, each of which may be missing. */
static vbss_result check_values(vbss_context *context, const double *values, uint32_t count,
                                double low, double high, const char *name)
{
    for (uint32_t i = 0; values != NULL && i < count; i++) {
        VBSS_TRY(vbss_check_range(context, values[i], low, high, name));
    }
    return VBSS_OK;
}

static vbss_result check_triangles(vbss_context *context, const vbss_drain_surface *s)
{
    for (uint32_t t = 0; t < s->triangle_count; t++) {
        const uint32_t *node = s->triangles + 3 * (size_t)t;
        for (int k = 0; k < 3; k++) {
            if (node[k] >= s->node_count) {
                return vbss_fail(context, VBSS_ERROR_OUT_OF_RANGE,
                                 "surface: triangle %u has node %u, and there are %u nodes", t,
                                 node[k], s->node_count);
            }
        }
        if (node[0] == node[1] || node[1] == node[2] || node[2] == node[0]) {
            return vbss_fail(context, VBSS_ERROR_OUT_OF_RANGE,
                             "surface: triangle %u has a node twice", t);
        }
    }
    return VBSS_OK;
}

vbss_result vbss_drain_read_surface(vbss_context *context, const vbss_drain_surface *surface,
                                    vbss_drain_surface *own)
{
    VBSS_TRY(vbss_config_read(context, &surface_layout, surface, own));
    VBSS_TRY(vbss_check_range(context, own->node_count, 3.0, DRAIN_MAX_SURFACE_NODES,
                              "node_count of the surface"));
    VBSS_TRY(vbss_check_range(context, own->triangle_count, 1.0, 2.0 * DRAIN_MAX_SURFACE_NODES,
                              "triangle_count of the surface"));
    VBSS_TRY(vbss_check_range(context, own->anchor_count, 0.0, own->node_count,
                              "anchor_count of the surface"));
    VBSS_TRY(vbss_check_pointer(context, own->positions, "positions of the surface"));
    VBSS_TRY(vbss_check_pointer(context, own->triangles, "triangles of the surface"));
    if (own->anchor_count > 0) {
        VBSS_TRY(vbss_check_pointer(context, own->anchors, "anchors of the surface"));
    }
    const size_t numbers = 3 * (size_t)own->node_count;
    VBSS_TRY(vbss_check_finite(context, own->positions, numbers, "positions of the surface"));
    VBSS_TRY(vbss_check_range(context, vbss_max_abs(own->positions, numbers), 0.0, 1.0,
                              "positions of the surface"));
    VBSS_TRY(check_values(context, own->thickness, own->triangle_count, 1e-6, 0.1,
                          "thickness of the surface"));
    VBSS_TRY(check_values(context, own->young_modulus, own->triangle_count, 1e3, 1e12,
                          "young_modulus of the surface"));
    return check_triangles(context, own);
}

/* ---- counts */

/* The sides of all triangles, as lists by the node where they begin. */
typedef struct side_lists {
    uint32_t *first; /* per node: a side, or DRAIN_NONE */
    uint32_t *next;  /* per side: the next one from the same node */
    const uint32_t *triangles;
} side_lists;

/* Side k of triangle t has number 3 t + k and leads from corner k to corner k + 1. */
static uint32_t end_of_side(const side_lists *l, uint32_t side)
{
    return l->triangles[side % 3 == 2 ? side - 2 : side + 1];
}

static bool has_side(const side_lists *l, uint32_t from, uint32_t to)
{
    uint32_t side = l->first[from];
    while (side != DRAIN_NONE && end_of_side(l, side) != to) {
        side = l->next[side];
    }
    return side != DRAIN_NONE;
}

/* Counts the edges. Refuses an edge that two triangles list in the same direction, and a node without a
 * triangle. */
static vbss_result count_edges(vbss_context *context, const vbss_drain_surface *s, side_lists *l,
                               uint32_t *edges)
{
    *edges = 0;
    for (uint32_t i = 0; i < s->node_count; i++) {
        l->first[i] = DRAIN_NONE;
    }
    for (uint32_t side = 0; side < 3 * s->triangle_count; side++) {
        const uint32_t from = l->triangles[side], to = end_of_side(l, side);
        if (has_side(l, from, to)) {
            return vbss_fail(context, VBSS_ERROR_OUT_OF_RANGE,
                             "surface: two triangles list the edge from node %u to node %u in this "
                             "direction; neighbours list it in opposite directions, and no edge "
                             "has three triangles",
                             from, to);
        }
        *edges += !has_side(l, to, from);
        l->next[side] = l->first[from];
        l->first[from] = side;
    }
    for (uint32_t i = 0; i < s->node_count; i++) {
        if (l->first[i] == DRAIN_NONE) {
            return vbss_fail(context, VBSS_ERROR_OUT_OF_RANGE, "surface: node %u is in no triangle",
                             i);
        }
    }
    return VBSS_OK;
}

static vbss_result check_anchors(vbss_context *context, const vbss_drain_surface *s,
                                 uint32_t *is_anchor)
{
    memset(is_anchor, 0, s->node_count * sizeof *is_anchor);
    for (uint32_t i = 0; i < s->anchor_count; i++) {
        const uint32_t node = s->anchors[i];
        if (node >= s->node_count || is_anchor[node] != 0) {
            return vbss_fail(
                context, VBSS_ERROR_OUT_OF_RANGE, "surface: anchor %u is node %u, %s", i, node,
                node >= s->node_count ? "which does not exist" : "which is an anchor already");
        }
        is_anchor[node] = 1;
    }
    return VBSS_OK;
}

vbss_result vbss_drain_plan_surface(vbss_context *context, drain_mesh *m)
{
    const vbss_drain_surface *s = m->options.surface;
    const size_t sides = 3 * (size_t)s->triangle_count;
    side_lists l = {.triangles = s->triangles};
    const vbss_array arrays[] = {{&l.first, s->node_count, sizeof *l.first},
                                 {&l.next, sides, sizeof *l.next}};
    vbss_result result = vbss_allocate_arrays(context, arrays, 2, "edges of a surface");
    if (result == VBSS_OK) {
        result = check_anchors(context, s, l.first);
    }
    if (result == VBSS_OK) {
        result = count_edges(context, s, &l, &m->edge_count);
    }
    vbss_release_arrays(context, arrays, 2);
    m->node_count = s->node_count;
    m->triangle_count = s->triangle_count;
    m->anchor_count = s->anchor_count;
    return result;
}

/* ---- copies */

/* A surface has no axis, so its material coordinates are x and z at rest. */
void vbss_drain_fill_surface(drain_mesh *m)
{
    const vbss_drain_surface *s = m->options.surface;
    for (uint32_t i = 0; i < m->node_count; i++) {
        m->rest[i] = vec3_load(s->positions + 3 * (size_t)i);
        m->angle[i] = 0.0;
        m->material_coordinates[i][0] = m->rest[i].z;
        m->material_coordinates[i][1] = m->rest[i].x;
    }
    memcpy(m->triangles, s->triangles, m->triangle_count * sizeof *m->triangles);
    if (m->anchor_count > 0) {
        memcpy(m->anchors, s->anchors, m->anchor_count * sizeof *m->anchors);
    }
}

static vbss_result copy_values(drain_object *d, const double *values, double **own)
{
    const uint32_t count = d->mesh.triangle_count;
    if (values == NULL) {
        return VBSS_OK;
    }
    *own = vbss_allocate(d->context, count, sizeof **own, "surface of a drain");
    if (*own == NULL) {
        return VBSS_ERROR_OUT_OF_MEMORY;
    }
    memcpy(*own, values, count * sizeof **own);
    return VBSS_OK;
}

static uint64_t hash_of(const vbss_drain_surface *s)
{
    const size_t nodes = s->node_count, triangles = s->triangle_count;
    const uint64_t counts[] = {nodes, triangles, s->anchor_count, s->thickness != NULL,
                               s->young_modulus != NULL};
    vbss_hash hash;
    vbss_hash_begin(&hash);
    vbss_hash_add(&hash, counts, sizeof counts);
    vbss_hash_add(&hash, s->positions, 3 * nodes * sizeof *s->positions);
    vbss_hash_add(&hash, s->triangles, 3 * triangles * sizeof *s->triangles);
    vbss_hash_add(&hash, s->anchors, s->anchor_count * sizeof *s->anchors);
    vbss_hash_add(&hash, s->thickness, s->thickness != NULL ? triangles * sizeof(double) : 0);
    vbss_hash_add(&hash, s->young_modulus,
                  s->young_modulus != NULL ? triangles * sizeof(double) : 0);
    return vbss_hash_end(&hash);
}

vbss_result vbss_drain_copy_surface(drain_object *d)
{
    const vbss_drain_surface *s = d->config.surface;
    if (s == NULL) {
        return VBSS_OK;
    }
    VBSS_TRY(copy_values(d, s->thickness, &d->triangle_thickness));
    VBSS_TRY(copy_values(d, s->young_modulus, &d->triangle_young_modulus));
    d->surface = *s;
    d->surface.positions = &d->mesh.rest->x;
    d->surface.triangles = d->mesh.triangles[0];
    d->surface.anchors = d->mesh.anchors;
    d->surface.thickness = d->triangle_thickness;
    d->surface.young_modulus = d->triangle_young_modulus;
    d->surface_hash = hash_of(&d->surface);
    d->config.surface = &d->surface;
    d->mesh.options.surface = &d->surface;
    return VBSS_OK;
}

void vbss_drain_free_surface(vbss_context *context, drain_object *d)
{
    const uint32_t count = d->mesh.triangle_count;
    vbss_release(context, d->triangle_thickness, count, sizeof *d->triangle_thickness);
    vbss_release(context, d->triangle_young_modulus, count, sizeof *d->triangle_young_modulus);
}
