/* Draws a thread as a tube about its spline, divided where it bends, with rotation-minimising
 * frames. */
#include "base/simd_dispatch.h"
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
static vec3 first_normal(const visual_object *v, const void *thread, vec3 tangent)
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

static uint32_t count_divisions(const visual_object *v, const visual_line *line, uint32_t segment,
                                double radius)
{
    const vec3 *at = &line->second_derivatives[segment];
    double curvature = sqrt(vbss_max(vec3_norm_squared(at[0]), vec3_norm_squared(at[1])));
    /* The outer side of a bent tube has longer chords than its line. */
    double chord =
        vbss_visual_max_chord(curvature * (1.0 + curvature * radius), v->config.tube_tolerance);
    double divisions = vbss_min(line->lengths[segment] / chord, v->config.division_limit);
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
    visual_object *v;
    visual_frame *frame;
    const void *thread; /* its identity */
    visual_line line;
    visual_line_points points; /* those whose rings come next */
    visual_loft loft;
    visual_ring ring; /* the last ring */
    bool has_ring;
} tube;

/* Turns the ring to the frame of the first point. */
static void begin_tube(tube *w, vec3 centre, vec3 tangent)
{
    visual_frame *f = w->frame;
    visual_ring *r = &w->ring;
    r->centre = centre;
    r->tangent = vec3_norm_squared(tangent) != 0.0 ? tangent : vec3_make(1.0, 0.0, 0.0);
    r->normal = first_normal(w->v, w->thread, r->tangent);
    if (f->tube_start_count < w->v->config.part_capacity) {
        f->tube_starts[f->tube_start_count++] =
            (visual_tube_start){w->thread, r->tangent, r->normal};
    }
    vbss_visual_add_dome(&w->loft, r, true);
    w->has_ring = true;
}

/* Turns the ring to the frame of the next point. */
static void move_ring(visual_ring *r, vec3 centre, vec3 tangent)
{
    tangent = vec3_norm_squared(tangent) != 0.0 ? tangent : r->tangent;
    r->normal = vbss_visual_transport_normal(r->centre, r->tangent, r->normal, centre, tangent);
    r->centre = centre;
    r->tangent = tangent;
}

/* Adds the rings of the points so far. A frame depends on the one before it, and that chain takes
 * as long as all other work. So a ring is written when the next frame is under way already. */
static void add_sections(tube *w)
{
    visual_line_points *p = &w->points;
    visual_ring *r = &w->ring, last;
    VBSS_WIDE_CALL(w->v->wide, vbss_visual_find_line_points, &w->line, p);
    for (uint32_t i = 0; i < p->count; i++) {
        last = *r;
        r->arc_length = p->arc_length[i];
        r->value = p->value[i];
        if (w->has_ring) {
            move_ring(r, p->centre[i], p->tangent[i]);
        } else {
            begin_tube(w, p->centre[i], p->tangent[i]);
        }
        if (i > 0) {
            vbss_visual_add_ring(&w->loft, &last);
        }
    }
    vbss_visual_add_ring(&w->loft, r);
    p->count = 0;
}

static void add_point(tube *w, uint32_t segment, double fraction, double arc_length, double value)
{
    visual_line_points *p = &w->points;
    if (p->count == VISUAL_LINE_POINTS) {
        add_sections(w);
    }
    p->segment[p->count] = segment;
    p->fraction[p->count] = fraction;
    p->arc_length[p->count] = arc_length;
    p->value[p->count++] = value;
}

static void add_points(tube *w, const scene_thread_info *t)
{
    const uint32_t segments = t->node_count - 1;
    double arc = 0.0;
    for (uint32_t i = 0; i < segments; i++) {
        const double length = t->rest_lengths[i];
        const uint32_t divisions = count_divisions(w->v, &w->line, i, t->radius);
        const double start_tension = tension_at(t, i), end_tension = tension_at(t, i + 1);
        for (uint32_t k = 0; k < divisions + (i + 1 == segments); k++) {
            const double fraction = (double)k / (double)divisions;
            add_point(w, i, fraction, arc + fraction * length,
                      start_tension + fraction * (end_tension - start_tension));
        }
        arc += length;
    }
    add_sections(w);
}

void vbss_visual_draw_thread(visual_object *v, visual_frame *f, const scene_thread_info *thread,
                             const void *identity)
{
    tube w;
    vbss_visual_solve_spline(thread->positions, thread->rest_lengths, thread->node_count,
                             v->node_vectors, v->elimination_ratios);
    w.v = v;
    w.frame = f;
    w.thread = identity;
    w.line = (visual_line){thread->positions, v->node_vectors, thread->rest_lengths};
    w.points.count = 0;
    vbss_visual_begin_loft(&w.loft, v, f, vbss_visual_round_section(v, thread->radius));
    w.ring = (visual_ring){.radius = thread->radius, .radial = 1.0};
    w.has_ring = false;
    add_points(&w, thread);
    vbss_visual_add_dome(&w.loft, &w.ring, false);
}
