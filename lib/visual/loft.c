/* Lofts: surfaces made by moving a section along a line, ring by ring, with domes at the ends. */
#include <stddef.h>

#include "base/simd_dispatch.h"
#include "visual/visual.h"

static uint32_t find_kept_triangles(const visual_loft_record *last, const visual_loft_record *now)
{
    const bool same = last->shape == now->shape && last->sides == now->sides &&
                      last->first_vertex == now->first_vertex &&
                      last->first_triangle == now->first_triangle;
    return same ? last->end_triangle : 0;
}

void vbss_visual_begin_loft(visual_loft *loft, const visual_object *v, visual_frame *f,
                            const visual_section *section)
{
    loft->v = v;
    loft->frame = f;
    loft->section = section;
    loft->record = NULL;
    loft->kept_triangles = 0;
    loft->has_previous = loft->previous_is_pole = false;
    loft->scale = -1.0;
    if (f->loft_count < VISUAL_LOFTS_PER_PART * v->config.part_capacity) {
        const visual_loft_record now = {section->shape, section->sides, f->vertex_count,
                                        f->triangle_count, 0};
        loft->record = &f->lofts[f->loft_count++];
        loft->kept_triangles = find_kept_triangles(loft->record, &now);
        *loft->record = now;
    }
}

/* ---- triangles */

static void connect_rings(const visual_loft *l)
{
    visual_frame *f = l->frame;
    const uint32_t first = f->triangle_count;
    f->triangle_count += 2 * l->section->joint_count;
    if (f->triangle_count > l->kept_triangles &&
        f->triangle_count <= l->v->config.triangle_capacity) {
        VBSS_WIDE_CALL(l->v->wide, vbss_visual_write_strip, l->section, l->previous,
                       f->triangles[first]);
    }
}

/* `ring_is_last`: the ring comes after the pole; otherwise before it. */
static void connect_pole(const visual_loft *l, uint32_t pole, uint32_t ring, bool ring_is_last)
{
    for (uint32_t i = 0; i < l->section->joint_count; i++) {
        uint32_t a = ring + l->section->joints[i], b = a + 1;
        visual_add_triangle(l->v, l->frame, pole, ring_is_last ? b : a, ring_is_last ? a : b);
    }
}

static void end_triangles(visual_loft *l)
{
    if (l->record != NULL) {
        l->record->end_triangle = l->frame->triangle_count;
    }
}

/* ---- rings and poles */

/* The points of all rings with the same radius have the same coordinates across the line. */
static void scale_section(visual_loft *l, double radius)
{
    for (uint32_t i = 0; i < l->section->count; i++) {
        l->across[i][0] = visual_to_float(radius * l->section->position[0][i]);
        l->across[i][1] = visual_to_float(radius * l->section->position[1][i]);
    }
    l->scale = radius;
}

void vbss_visual_add_ring(visual_loft *loft, const visual_ring *ring)
{
    visual_frame *f = loft->frame;
    const uint32_t first = f->vertex_count;
    f->vertex_count += loft->section->count;
    if (f->vertex_count <= loft->v->config.vertex_capacity) {
        if (ring->radius != loft->scale) {
            scale_section(loft, ring->radius);
        }
        VBSS_WIDE_CALL(loft->v->wide, vbss_visual_write_ring, loft, ring, &f->vertices[first]);
    }
    if (loft->has_previous && loft->previous_is_pole) {
        connect_pole(loft, loft->previous, first, true);
    } else if (loft->has_previous) {
        connect_rings(loft);
    }
    loft->previous = first;
    loft->has_previous = true;
    loft->previous_is_pole = false;
}

void vbss_visual_add_pole(visual_loft *loft, const visual_ring *ring)
{
    const uint32_t index = loft->frame->vertex_count++;
    vec3 out = vec3_scale(ring->tangent, loft->has_previous ? 1.0 : -1.0);
    visual_point p = {ring->centre,
                      out,
                      {0.5, ring->arc_length},
                      vec3_make(ring->arc_length, 0.0, 0.0),
                      ring->value};
    visual_set_vertex(loft->v, loft->frame, index, &p);
    if (loft->has_previous) {
        end_triangles(loft);
        connect_pole(loft, index, loft->previous, false);
    }
    loft->previous = index;
    loft->has_previous = loft->previous_is_pole = true;
}

void vbss_visual_add_dome(visual_loft *loft, const visual_ring *ring, bool at_start)
{
    const uint32_t rings = loft->section->dome_rings;
    const double sign = at_start ? -1.0 : 1.0;
    visual_ring r = *ring;
    for (uint32_t k = 0; k <= rings; k++) {
        /* From the pole to the ring, or from the ring to the pole. The caller adds the ring. */
        uint32_t step = at_start ? rings - k : k;
        const double sine = loft->section->dome_sine[step];
        const double cosine = loft->section->dome_cosine[step];
        if (step == 0) {
            continue;
        }
        double offset = sign * ring->radius * sine;
        r.centre = vec3_add_scaled(ring->centre, offset, ring->tangent);
        r.arc_length = ring->arc_length + offset;
        r.radius = ring->radius * cosine;
        r.radial = cosine;
        r.axial = sign * sine;
        if (step == rings) {
            vbss_visual_add_pole(loft, &r);
        } else {
            vbss_visual_add_ring(loft, &r);
        }
    }
}

void vbss_visual_add_capsule(const visual_object *v, visual_frame *f, const visual_section *section,
                             const visual_capsule *c)
{
    const double length = vec3_dot(vec3_sub(c->end, c->start), c->tangent);
    visual_loft loft;
    vbss_visual_begin_loft(&loft, v, f, section);
    visual_ring ring = {c->start, c->tangent, c->normal, c->radius, 1.0, 0.0, 0.0, c->value};
    vbss_visual_add_dome(&loft, &ring, true);
    /* If the capsule tapers, its normals lean forward. */
    double taper = length > 0.0 ? (c->radius - c->end_radius) / length : 0.0;
    double scale = 1.0 / sqrt(1.0 + taper * taper);
    ring.radial = scale;
    ring.axial = taper * scale;
    vbss_visual_add_ring(&loft, &ring);
    if (length > 0.0) {
        ring.centre = c->end;
        ring.arc_length = length;
        ring.radius = c->end_radius;
        vbss_visual_add_ring(&loft, &ring);
    }
    vbss_visual_add_dome(&loft, &ring, false);
}
