/* The law of a hole: transverse stiffness, and friction along the suture. */
#include "base/stream.h"
#include "suture/suture.h"
#include "suture/tuning.h"

/* First version of the stream in which threads pass through holes: a format, derived. */
enum { VERSION_WITH_THREADS = 5 };

vec3 vbss_wall_point(const suture_wall *wall, const vec3 *x, uint32_t triangle,
                     const double barycentric[3])
{
    const uint32_t *node = wall->triangles[triangle];
    vec3 point = vec3_scale(x[node[0]], barycentric[0]);
    point = vec3_add_scaled(point, barycentric[1], x[node[1]]);
    return vec3_add_scaled(point, barycentric[2], x[node[2]]);
}

vec3 vbss_hole_point(const suture_hole *hole, const suture_wall *wall, const vec3 *x)
{
    return vbss_wall_point(wall, x, hole->triangle, hole->barycentric);
}

/* 0 at the entry of a tip, 1 from its length on. */
static double tip_fraction(const suture_hole *hole, const vbss_drain_config *c, double arc)
{
    const double depth = arc - hole->entry_arc;
    return depth < c->tip_length ? vbss_max(depth / c->tip_length, 0.0) : 1.0;
}

/* The puncture force fades while the tip passes through, and does not return. */
static double needle_force_forward(const suture_hole *hole, const vbss_drain_config *c)
{
    const double remaining = 1.0 - tip_fraction(hole, c, hole->max_arc);
    return c->hole_force + remaining * vbss_max(c->puncture_force - c->hole_force, 0.0);
}

/* Nothing cuts on the way back: a tip is held by friction, which grows as it becomes thicker. */
static double needle_force_back(const suture_hole *hole, const vbss_drain_config *c)
{
    return c->hole_force * tip_fraction(hole, c, hole->arc);
}

/* Fraction of the transition from the needle's law to the thread's, over the length of a tip, so
 * that nothing jumps. */
static double thread_fraction(const suture_curve *curve, const vbss_drain_config *config,
                              double distance)
{
    if (curve->needle != NULL && distance <= 0.0) {
        return 0.0;
    }
    return curve->needle == NULL || distance >= config->tip_length ? 1.0
                                                                   : distance / config->tip_length;
}

hole_yield_limit vbss_hole_yield_limit(const suture_hole *hole, const vbss_drain_config *config,
                                       const suture_curve *curve, const suture_curve_point *point)
{
    hole_yield_limit b = {{needle_force_forward(hole, config), needle_force_back(hole, config)},
                          {config->hole_friction, config->hole_friction}};
    double past_swage = point->arc - curve->swage_arc, capstan[2];
    if (curve->thread == NULL || (curve->needle != NULL && past_swage <= 0.0)) {
        return b;
    }
    const uint32_t last = curve->thread->node_count - 1;
    const uint32_t end = last < SUTURE_NEEDLE_BENT_SEGMENTS ? last : SUTURE_NEEDLE_BENT_SEGMENTS;
    const double bent_length = vbss_thread_arc_length(curve->thread, end);
    const double fraction = thread_fraction(curve, config, past_swage - bent_length);
    vbss_suture_capstan_friction(curve, point, config->hole_friction, capstan);
    const double of_thread = thread_fraction(curve, config, past_swage);
    for (int k = 0; k < 2; k++) {
        b.force[k] += of_thread * (config->thread_force - b.force[k]);
        b.friction[k] += fraction * (capstan[k] - b.friction[k]);
    }
    return b;
}

/* A hole at a larger arc length means that the suture has moved toward the tip. */
void vbss_hole_set_constraint(const suture_hole *hole, const vbss_drain_config *config,
                              double start_arc, const suture_curve_point *now, vec3 drain, double h,
                              contact_constraint *constraint)
{
    constraint->normal = now->tangent;
    constraint->curvature = now->curvature;
    constraint->relative_displacement = vec3_sub(now->position, drain);
    constraint->relative_displacement =
        vec3_add_scaled(constraint->relative_displacement, now->arc - start_arc, now->tangent);
    constraint->gap = 0.0;
    constraint->previous_force = vec3_scale(now->tangent, hole->friction_force);
    constraint->stiffness = config->hole_stiffness;
    constraint->viscous_stiffness = config->hole_damping / h;
}

void vbss_hole_set_arc(suture_hole *hole, double arc)
{
    hole->arc = arc;
    hole->max_arc = vbss_max(hole->max_arc, arc);
}

void vbss_hole_store_forces(suture_hole *hole, const contact_constraint *constraint)
{
    contact_solution solution;
    (void)vbss_contact_update_solution(constraint, vec3_zero(), &solution);
    hole->friction_force = solution.normal_force;
    hole->transverse_force = solution.tangential_force;
}

void vbss_hole_serialise(vbss_stream *stream, uint16_t first_tag, suture_hole *hole)
{
    uint32_t words[] = {hole->needle, hole->wall, hole->triangle, hole->is_outward, hole->thread};
    uint32_t count = stream->version >= VERSION_WITH_THREADS ? 5 : 4;
    double *numbers[] = {&hole->entry_arc, &hole->arc, &hole->max_arc, &hole->friction_force};
    vbss_stream_u32(stream, first_tag, &hole->id, 1);
    if (hole->id == 0 && stream->mode == VBSS_STREAM_READ) {
        *hole = (suture_hole){0};
    }
    if (hole->id == 0) {
        return;
    }
    if (stream->mode == VBSS_STREAM_READ && count == 4) {
        words[4] = 0; /* the hole that is overwritten may have been on a thread */
    }
    vbss_stream_u32(stream, first_tag, words, count);
    vbss_stream_f64(stream, first_tag + 1, hole->barycentric, 3);
    for (size_t i = 0; i < sizeof numbers / sizeof numbers[0]; i++) {
        vbss_stream_f64(stream, first_tag + 2, numbers[i], 1);
    }
    vbss_stream_f64(stream, first_tag + 3, &hole->transverse_force.x, 3);
    if (words[3] > 1) {
        vbss_stream_refuse(stream, VBSS_ERROR_CORRUPT, "no such flag");
    }
    hole->needle = words[0];
    hole->wall = words[1];
    hole->triangle = words[2];
    hole->is_outward = words[3] != 0;
    hole->thread = words[4];
}

bool vbss_hole_is_valid(const suture_hole *hole)
{
    double sum = 0.0;
    bool inside = true;
    for (int k = 0; k < 3; k++) {
        sum += hole->barycentric[k];
        inside = inside && hole->barycentric[k] >= 0.0;
    }
    return (hole->needle == 0) != (hole->thread == 0) && inside && fabs(sum - 1.0) < 1e-9 &&
           hole->entry_arc <= 0.0 && hole->entry_arc >= -1.0 && isfinite(hole->arc) &&
           isfinite(hole->max_arc) && hole->max_arc >= hole->entry_arc &&
           isfinite(hole->friction_force) && vec3_is_finite(hole->transverse_force);
}
