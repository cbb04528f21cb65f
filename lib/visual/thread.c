/* Draws a thread as a tube about its spline, divided where it bends, with rotation-minimising
 * frames. */
#include "visual/visual.h"

/* Double reflection (Wang, Juettler, Zheng and Liu 2008, Table I): first in the bisecting plane of
 * the two points, then in that of the two tangents. The error is of fourth order in the
 * distance. */
vec3 vbss_visual_transport_normal(vec3 from, vec3 tangent, vec3 normal, vec3 to, vec3 tangent_there)
{
    vec3 displacement = vec3_sub(to, from), mirrored = normal, mirrored_tangent = tangent;
    double length = vec3_norm_squared(displacement);
    if (length > 0.0) {
        mirrored =
            vec3_add_scaled(normal, -2.0 * vec3_dot(displacement, normal) / length, displacement);
        mirrored_tangent =
            vec3_add_scaled(tangent, -2.0 * vec3_dot(displacement, tangent) / length, displacement);
    }
    vec3 turn = vec3_sub(tangent_there, mirrored_tangent);
    double turned = vec3_norm_squared(turn);
    if (turned > 1e-20) {
        mirrored = vec3_add_scaled(mirrored, -2.0 * vec3_dot(turn, mirrored) / turned, turn);
    }
    /* Removes the component along the tangent that rounding has left. */
    mirrored = vec3_add_scaled(mirrored, -vec3_dot(mirrored, tangent_there), tangent_there);
    return vec3_unit_or(mirrored, vec3_any_normal(tangent_there));
}

/* The first section turns as little as possible from one frame to the next. */
static vec3 first_normal(const visual_object *v, const vbss_thread *thread, vec3 tangent)
{
    const visual_frame *shown = &v->frames[v->front];
    for (uint32_t i = 0; i < shown->tube_start_count; i++) {
        const visual_tube_start *start = &shown->tube_starts[i];
        if (start->thread == thread) {
            vec3 turned = quat_rotate(quat_between(start->tangent, tangent), start->normal);
            turned = vec3_add_scaled(turned, -vec3_dot(turned, tangent), tangent);
            return vec3_unit_or(turned, vec3_any_normal(tangent));
        }
    }
    return vec3_any_normal(tangent);
}

static uint32_t count_divisions(const visual_object *v, const visual_segment *s, double radius)
{
    double curvature = sqrt(vbss_max(vec3_norm_squared(s->start_second_derivative),
                                     vec3_norm_squared(s->end_second_derivative)));
    /* The outer side of a bent tube has longer chords than its line. */
    double chord =
        vbss_visual_max_chord(curvature * (1.0 + curvature * radius), v->config.tube_tolerance);
    double divisions = vbss_min(s->length / chord, v->config.division_limit);
    return (uint32_t)vbss_max(divisions + 0.999, 1.0);
}

static double tension_at(const scene_thread_info *t, uint32_t node)
{
    const double *tension = t->tensions;
    if (node == 0 || node + 1 == t->node_count) {
        return tension[node == 0 ? 0 : node - 1];
    }
    return 0.5 * (tension[node - 1] + tension[node]);
}

typedef struct tube {
    visual_loft loft;
    visual_ring ring; /* the last ring */
    bool has_ring;
} tube;

static void add_section(tube *w, visual_object *v, visual_frame *f, const vbss_thread *thread,
                        vec3 centre, vec3 slope)
{
    visual_ring *r = &w->ring;
    vec3 fallback = w->has_ring ? r->tangent : vec3_make(1.0, 0.0, 0.0);
    vec3 tangent = vec3_unit_or(slope, fallback);
    r->normal = w->has_ring ? vbss_visual_transport_normal(r->centre, r->tangent, r->normal, centre,
                                                           tangent)
                            : first_normal(v, thread, tangent);
    r->centre = centre;
    r->tangent = tangent;
    if (!w->has_ring) {
        if (f->tube_start_count < v->config.part_capacity) {
            f->tube_starts[f->tube_start_count++] = (visual_tube_start){thread, tangent, r->normal};
        }
        vbss_visual_add_dome(&w->loft, r, true);
        w->has_ring = true;
    }
    vbss_visual_add_ring(&w->loft, r);
}

void vbss_visual_draw_thread(visual_object *v, visual_frame *f, const vbss_thread *thread)
{
    const scene_thread_info t = vbss_scene_inspect_thread(thread);
    const uint32_t segments = t.node_count - 1;
    const double radius = t.radius;
    const visual_section *section = vbss_visual_round_section(v, radius);
    vbss_visual_solve_spline(t.positions, t.rest_lengths, t.node_count, v->node_vectors,
                             v->elimination_ratios);
    tube w;
    vbss_visual_begin_loft(&w.loft, v, f, section);
    w.ring = (visual_ring){.radius = radius, .radial = 1.0};
    w.has_ring = false;
    double arc = 0.0;
    for (uint32_t i = 0; i < segments; i++) {
        const visual_segment s = {t.positions[i], t.positions[i + 1], v->node_vectors[i],
                                  v->node_vectors[i + 1], t.rest_lengths[i]};
        const uint32_t divisions = count_divisions(v, &s, radius);
        const double start_tension = tension_at(&t, i), end_tension = tension_at(&t, i + 1);
        for (uint32_t k = 0; k < divisions + (i + 1 == segments); k++) {
            double fraction = (double)k / (double)divisions;
            w.ring.arc_length = arc + fraction * s.length;
            w.ring.value = start_tension + fraction * (end_tension - start_tension);
            add_section(&w, v, f, thread, vbss_visual_segment_point(&s, fraction),
                        vbss_visual_segment_derivative(&s, fraction));
        }
        arc += s.length;
    }
    vbss_visual_add_dome(&w.loft, &w.ring, false);
}
