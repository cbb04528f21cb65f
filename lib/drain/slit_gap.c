/* Gap of the slit: between its edges in the middle of the wall, as in the published method, and
 * between the lips, which are as high as the wall. */
#include "base/api_call.h"
#include "base/config.h"
#include "base/error.h"
#include "collision/closest.h"
#include "drain/drain.h"

_Static_assert(sizeof(vbss_drain_gap) == 96, "published size");
static const uint32_t gap_sizes[] = {32, 96, 0};
static const vbss_layout gap_layout = {"vbss_drain_gap", NULL, gap_sizes};

/* Vector from the inner to the outer face at a node of the slit, along the mean normal of the
 * triangles beside it. */
static vec3 wall_vector(const drain_object *d, int side, uint32_t i)
{
    const drain_mesh *m = &d->mesh;
    vec3 normal = vec3_zero();
    for (uint32_t k = i > 0 ? i - 1 : 0; k <= i && k + 1 < m->slit_count; k++) {
        const uint32_t *n = m->triangles[m->lip_triangles[side][k]];
        vec3 cross = vec3_cross(vec3_sub(d->x[n[1]], d->x[n[0]]), vec3_sub(d->x[n[2]], d->x[n[0]]));
        normal = vec3_add(normal, vec3_unit_or(cross, vec3_zero()));
    }
    return vec3_scale(vec3_unit_or(normal, vec3_zero()), d->config.thickness);
}

/* Distance of the lines through the wall at two opposite nodes, m. `lips`: their closest points. */
static double opening_at(const drain_object *d, uint32_t i, vec3 lips[2])
{
    const drain_mesh *m = &d->mesh;
    vec3 inner_points[2], wall_vectors[2];
    double at[2];
    for (int side = DRAIN_LEFT; side <= DRAIN_RIGHT; side++) {
        wall_vectors[side] = wall_vector(d, side, i);
        inner_points[side] =
            vec3_add_scaled(d->x[m->slit_nodes[side][i]], -0.5, wall_vectors[side]);
    }
    vec3 between = vec3_sub(inner_points[DRAIN_RIGHT], inner_points[DRAIN_LEFT]);
    vec3 closest = closest_between_edges(wall_vectors[DRAIN_LEFT], wall_vectors[DRAIN_RIGHT],
                                         between, &at[0], &at[1]);
    for (int side = DRAIN_LEFT; side <= DRAIN_RIGHT; side++) {
        lips[side] = vec3_add_scaled(inner_points[side], at[side], wall_vectors[side]);
    }
    return vec3_norm(closest);
}

vbss_result vbss_drain_get_gap(vbss_drain *drain, vbss_drain_gap *gap, uint32_t struct_size)
{
    VBSS_ENTER(drain);
    drain_object *d;
    VBSS_TRY(vbss_drain_open(drain, &d));
    const drain_mesh *m = &d->mesh;
    if (m->slit_count == 0) {
        return vbss_fail(d->context, VBSS_ERROR_INCOMPATIBLE, "a drain with a surface has no slit");
    }
    vbss_drain_gap own = {.struct_size = sizeof own};
    vec3 lips[2],
        between = vec3_sub(d->x[m->slit_middle[DRAIN_RIGHT]], d->x[m->slit_middle[DRAIN_LEFT]]);
    own.gap = vec3_norm(between);
    own.signed_gap = vec3_dot(between, quat_rotate(d->frame.orientation, vec3_make(0.0, 0.0, 1.0)));
    for (uint32_t i = 0; i < m->slit_count; i++) {
        double distance =
            vec3_distance(d->x[m->slit_nodes[DRAIN_LEFT][i]], d->x[m->slit_nodes[DRAIN_RIGHT][i]]);
        if (distance > own.largest) {
            own.largest = distance;
            own.largest_pair = i;
        }
        double opening = opening_at(d, i, lips);
        own.widest_opening = vbss_max(own.widest_opening, opening);
        if (i == m->slit_count / 2) {
            own.opening = opening;
            vec3_store(own.lips[DRAIN_LEFT], lips[DRAIN_LEFT]);
            vec3_store(own.lips[DRAIN_RIGHT], lips[DRAIN_RIGHT]);
        }
    }
    return vbss_struct_write(d->context, &gap_layout, &own, gap, struct_size);
}
