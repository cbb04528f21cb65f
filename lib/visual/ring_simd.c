/* The vertices of a ring, four at a time. */
#include "base/simd_dispatch.h"
#include "visual/vertex_lanes.h"

/* Combines the components of four points in the axes of the ring. */
static inline vlanes across_line(vlanes first, vlanes second,
                                 const double (*of)[VISUAL_MAX_SECTION_POINTS], uint32_t point)
{
    return v_add_scaled(v_scale(first, lanes_load(&of[0][point])), lanes_load(&of[1][point]),
                        second);
}

static void write_points(const visual_section *s, const visual_ring *ring, vec3 origin,
                         visual_vertex *out)
{
    const vlanes centre = v_splat(ring->centre), first = v_splat(ring->normal),
                 second = v_splat(vec3_cross(ring->tangent, ring->normal)),
                 forward = v_splat(vec3_scale(ring->tangent, ring->axial)), shift = v_splat(origin);
    const lanes radius = lanes_splat(ring->radius), radial = lanes_splat(ring->radial);
    for (uint32_t i = 0; i < s->distinct; i += LANES) {
        const uint32_t point = next_four(i, s->distinct);
        vlanes across = across_line(first, second, s->position, point), normal = across;
        if (s->shape != VISUAL_ROUND) {
            normal = across_line(first, second, s->normal, point);
        }
        visual_store_points(&out[point], 1, v_sub(v_add_scaled(centre, radius, across), shift),
                            v_add(v_scale(normal, radial), forward));
    }
    if (s->distinct < s->count) {
        memcpy(out[s->distinct].position, out->position, sizeof out->position);
        memcpy(out[s->distinct].normal, out->normal, sizeof out->normal);
    }
}

static void write_attributes(const visual_loft *loft, const visual_ring *ring, visual_vertex *out)
{
    const float arc_length = visual_to_float(ring->arc_length),
                value = visual_to_float(ring->value);
    for (uint32_t i = 0; i < loft->section->count; i++) {
        out[i].texture[0] = loft->section->perimeter_fraction[i];
        out[i].texture[1] = out[i].material[0] = arc_length;
        out[i].material[1] = loft->across[i][0];
        out[i].material[2] = loft->across[i][1];
        out[i].value = value;
    }
}

void VBSS_WIDE_NAME(vbss_visual_write_ring)(const visual_loft *loft, const visual_ring *ring,
                                            visual_vertex *out)
{
    write_points(loft->section, ring, loft->v->origin, out);
    write_attributes(loft, ring, out);
}

void VBSS_WIDE_NAME(vbss_visual_write_strip)(const visual_section *section, uint32_t first,
                                             uint32_t *out)
{
    const uint32_t *strip = section->strip[0];
    for (uint32_t i = 0; i < 6 * section->joint_count; i++) {
        out[i] = strip[i] + first;
    }
}
