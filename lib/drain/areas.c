/* Node areas and angular widths at rest. Both halves are summed in the same order, so that mirrored
 * triangles have the same bits. */
#include "base/pi.h"
#include "drain/mesh.h"

static double area_of(const drain_mesh *m, const uint32_t triangle[3])
{
    vec3 a = m->rest[triangle[0]];
    vec3 u = vec3_sub(m->rest[triangle[1]], a), v = vec3_sub(m->rest[triangle[2]], a);
    return 0.5 * vec3_norm(vec3_cross(u, v));
}

/* No triangle crosses the top or the bottom line, so absolute angles are enough. */
static double width_of(const drain_mesh *m, const uint32_t triangle[3])
{
    double low = VBSS_PI, high = 0.0;
    for (int k = 0; k < 3; k++) {
        double angle = fabs(m->angle[triangle[k]]);
        low = vbss_min(low, angle);
        high = vbss_max(high, angle);
    }
    return high - low;
}

void vbss_drain_compute_areas(drain_mesh *m)
{
    for (uint32_t i = 0; i < m->node_count; i++) {
        m->node_area[i] = 0.0;
    }
    for (uint32_t t = 0; t < m->triangle_count; t++) {
        double third = area_of(m, m->triangles[t]) / 3.0;
        for (int k = 0; k < 3; k++) {
            m->node_area[m->triangles[t][k]] += third;
        }
        m->angular_width[t] = width_of(m, m->triangles[t]);
    }
}
