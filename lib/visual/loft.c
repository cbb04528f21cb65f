/* Lofts: surfaces made by moving a section along a line, ring by ring, with domes at the ends. */
#include "base/elementary.h"
#include "base/pi.h"
#include "visual/visual.h"

/* ---- sections */

/* A polygon with n sides deviates from its circle by r (1 - cos(pi / n)) <= r (pi / n)^2 / 2. */
static uint32_t count_sides(const visual_object *v, double radius)
{
    double sides = VBSS_PI * sqrt(0.5 * radius / v->config.tube_tolerance);
    double limited = vbss_min(vbss_max(sides, 6.0), v->config.side_limit);
    return (uint32_t)(limited + 0.999);
}

static void add_point(visual_section *s, double u, double v, double nu, double nv,
                      double perimeter_fraction)
{
    s->position[s->count][0] = u;
    s->position[s->count][1] = v;
    s->normal[s->count][0] = nu;
    s->normal[s->count][1] = nv;
    s->perimeter_fraction[s->count] = perimeter_fraction;
    s->joins_next[s->count++] = true;
}

void vbss_visual_round_section(const visual_object *v, double radius, visual_section *section)
{
    const uint32_t sides = count_sides(v, radius);
    section->count = 0;
    section->dome_rings = (sides + 3) / 4 < 2 ? 2 : (sides + 3) / 4;
    for (uint32_t i = 0; i <= sides; i++) {
        double fraction = (double)i / (double)sides, sine, cosine;
        vbss_sincos(i == sides ? 0.0 : 2.0 * VBSS_PI * fraction, &sine, &cosine);
        add_point(section, cosine, sine, cosine, sine, fraction); /* the seam has two points */
    }
    section->joins_next[sides] = false;
}

void vbss_visual_jaw_section(const visual_object *v, double radius, visual_section *section)
{
    const uint32_t sides = (count_sides(v, radius) + 1) / 2;
    section->count = 0;
    section->dome_rings = (sides + 1) / 2 < 2 ? 2 : (sides + 1) / 2;
    add_point(section, -1.0, -1.0, 0.0, -1.0, 0.0);
    for (uint32_t i = 0; i <= sides; i++) {
        double fraction = (double)i / (double)sides, sine, cosine;
        vbss_sincos(VBSS_PI * (fraction - 0.5), &sine, &cosine);
        add_point(section, cosine, sine, cosine, sine, 0.15 + 0.4 * fraction);
    }
    add_point(section, -1.0, 1.0, 0.0, 1.0, 0.7);
    section->joins_next[section->count - 1] = false;
    add_point(section, -1.0, 1.0, -1.0, 0.0, 0.7);
    add_point(section, -1.0, -1.0, -1.0, 0.0, 1.0);
    section->joins_next[section->count - 1] = false;
}

double vbss_visual_max_chord(double curvature, double tolerance)
{
    return sqrt(8.0 * tolerance / vbss_max(curvature, 1e-12));
}

/* ---- rings */

visual_loft vbss_visual_begin_loft(const visual_object *v, visual_frame *f,
                                   const visual_section *section)
{
    visual_loft loft = {v, f, section, 0, false, false};
    return loft;
}

static void connect_rings(const visual_loft *l, uint32_t ring)
{
    for (uint32_t i = 0; i + 1 < l->section->count; i++) {
        if (l->section->joins_next[i]) {
            uint32_t a = l->previous + i, b = ring + i;
            visual_add_triangle(l->v, l->frame, a, a + 1, b);
            visual_add_triangle(l->v, l->frame, a + 1, b + 1, b);
        }
    }
}

/* `ring_is_last`: the ring comes after the pole; otherwise before it. */
static void connect_pole(const visual_loft *l, uint32_t pole, uint32_t ring, bool ring_is_last)
{
    for (uint32_t i = 0; i + 1 < l->section->count; i++) {
        if (l->section->joins_next[i]) {
            uint32_t a = ring + i, b = ring + i + 1;
            visual_add_triangle(l->v, l->frame, pole, ring_is_last ? b : a, ring_is_last ? a : b);
        }
    }
}

void vbss_visual_add_ring(visual_loft *loft, const visual_ring *ring)
{
    const visual_section *s = loft->section;
    const uint32_t first = loft->frame->vertex_count;
    const vec3 second = vec3_cross(ring->tangent, ring->normal);
    loft->frame->vertex_count += s->count;
    for (uint32_t i = 0; i < s->count; i++) {
        vec3 across =
            vec3_add_scaled(vec3_scale(ring->normal, s->position[i][0]), s->position[i][1], second);
        vec3 out =
            vec3_add_scaled(vec3_scale(ring->normal, s->normal[i][0]), s->normal[i][1], second);
        out = vec3_add_scaled(vec3_scale(out, ring->radial), ring->axial, ring->tangent);
        visual_point p = {vec3_add_scaled(ring->centre, ring->radius, across),
                          out,
                          {s->perimeter_fraction[i], ring->arc_length},
                          vec3_make(ring->arc_length, ring->radius * s->position[i][0],
                                    ring->radius * s->position[i][1]),
                          ring->value};
        visual_set_vertex(loft->v, loft->frame, first + i, &p);
    }
    if (loft->has_previous && loft->previous_is_pole) {
        connect_pole(loft, loft->previous, first, true);
    } else if (loft->has_previous) {
        connect_rings(loft, first);
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
        double sine, cosine;
        vbss_sincos(0.5 * VBSS_PI * ((double)step / (double)rings), &sine, &cosine);
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
    visual_loft loft = vbss_visual_begin_loft(v, f, section);
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
