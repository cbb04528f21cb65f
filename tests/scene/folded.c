#include "scene/folded.h"

#include "drain/drain.h"
#include "harness/harness.h"

static vec3 across(vec3 from, vec3 along, vec3 to)
{
    vec3 offset = vec3_sub(to, from);
    return vec3_add_scaled(offset, -vec3_dot(offset, along) / vec3_norm_squared(along), along);
}

/* The normals of two triangles on both sides of one, weighed by their areas: against that of the one. */
static bool is_folded(const vec3 *x, const uint32_t corners[3], uint32_t beyond, int opposite)
{
    vec3 p = x[corners[opposite]], a = x[corners[(opposite + 1) % 3]],
         b = x[corners[(opposite + 2) % 3]];
    vec3 along = vec3_sub(b, a), inward = across(a, along, p),
         outward = across(a, along, x[beyond]);
    double inner = vec3_norm(inward);
    /* so far the neighbour reaches to the other side of the side, in heights of the triangle */
    return !(vec3_dot(outward, inward) / (inner * inner) < 1.0);
}

uint32_t folded_triangles(const vbss_drain *drain)
{
    drain_object *d;
    uint32_t count = 0;
    expect_ok(vbss_drain_open(drain, &d));
    for (uint32_t t = 0; t < d->mesh.triangle_count; t++) {
        const uint32_t *n = d->mesh.triangles[t];
        const vec3 *x = d->x, *rest = d->mesh.rest;
        double area = vec3_norm(vec3_cross(vec3_sub(x[n[1]], x[n[0]]), vec3_sub(x[n[2]], x[n[0]])));
        double whole = vec3_norm(
            vec3_cross(vec3_sub(rest[n[1]], rest[n[0]]), vec3_sub(rest[n[2]], rest[n[0]])));
        bool inverted = !(area > 0.01 * whole);
        for (int k = 0; k < 3; k++) {
            uint32_t beyond = d->mesh.opposite_node[t][k];
            inverted = inverted || (beyond != DRAIN_NONE && is_folded(x, n, beyond, k));
        }
        count += inverted;
    }
    return count;
}
