/* The slope of the line search, four constraints at a time because it is evaluated often. Forces
 * have the same bits as those of vbss_contact_force. */
#include "base/vlanes.h"
#include "contact/contact.h"

/* ---- constraints and both iterates in batches of four */

static void set_lane(double to[3][LANES], uint32_t lane, vec3 v)
{
    to[0][lane] = v.x;
    to[1][lane] = v.y;
    to[2][lane] = v.z;
}

static void set_constraint(contact_simd_batch *batch, uint32_t lane,
                           const contact_constraint *constraint, const contact_iterate *current,
                           const contact_iterate *candidate)
{
    set_lane(batch->normal, lane, constraint->normal);
    set_lane(batch->relative_displacement, lane, constraint->relative_displacement);
    set_lane(batch->previous_force, lane, constraint->previous_force);
    set_lane(batch->current_u, lane, current->u);
    set_lane(batch->candidate_u, lane, candidate->u);
    set_lane(batch->current_force, lane, current->force);
    set_lane(batch->candidate_force, lane, candidate->force);
    batch->gap[lane] = constraint->gap;
    batch->stiffness[lane] = constraint->stiffness;
    batch->tangential_stiffness[lane] = contact_tangential_stiffness(constraint);
    batch->friction[lane] = constraint->friction;
    batch->bilateral[lane] = constraint->is_bilateral ? 1.0 : 0.0;
    batch->is_sleeve[lane] = constraint->is_sleeve;
}

void VBSS_WIDE_NAME(vbss_contact_begin_line_search)(contact_set *set)
{
    static const contact_constraint none; /* pads the last batch */
    static const contact_iterate rest;
    for (uint32_t first = 0; first < set->count; first += LANES) {
        for (uint32_t lane = 0; lane < LANES; lane++) {
            uint32_t i = first + lane;
            bool there = i < set->count;
            set_constraint(&set->simd_batches[first / LANES], lane,
                           there ? &set->constraints[i] : &none, there ? &set->current[i] : &rest,
                           there ? &set->candidate[i] : &rest);
        }
    }
}

/* ---- the slope */

static inline vlanes load(const double from[3][LANES])
{
    vlanes v = {lanes_load(from[0]), lanes_load(from[1]), lanes_load(from[2])};
    return v;
}

static inline lanes negate(lanes a)
{
    return lanes_scale(-1.0, a);
}

static inline vlanes interpolate(vlanes a, vlanes b, double fraction)
{
    return v_add(v_scale(a, lanes_splat(1.0 - fraction)), v_scale(b, lanes_splat(fraction)));
}

/* Contact law of vbss_contact_force in lanes, except for sleeves. */
static inline vlanes force_of_batch(const contact_simd_batch *batch, vlanes u)
{
    const lanes zero = lanes_splat(0.0), friction = lanes_load(batch->friction);
    const vlanes n = load(batch->normal), none = {zero, zero, zero};
    const lanes_mask bilateral = lanes_less(zero, lanes_load(batch->bilateral));
    lanes normal_force = lanes_times(negate(lanes_load(batch->stiffness)),
                                     lanes_add(lanes_load(batch->gap), v_dot(n, u)));
    vlanes tangential_displacement = v_add(load(batch->relative_displacement), u);
    tangential_displacement =
        v_add_scaled(tangential_displacement, negate(v_dot(tangential_displacement, n)), n);
    vlanes tangential_force =
        v_add_scaled(load(batch->previous_force), negate(lanes_load(batch->tangential_stiffness)),
                     tangential_displacement);
    lanes size = lanes_sqrt(v_dot(tangential_force, tangential_force)),
          max_friction = lanes_times(friction, normal_force);
    lanes_mask is_slipping = lanes_and(lanes_not(bilateral), lanes_less(max_friction, size));
    tangential_force = v_select(
        is_slipping, v_scale(tangential_force, lanes_div(max_friction, size)), tangential_force);
    lanes_mask has_friction = lanes_or(lanes_less(friction, zero), lanes_less(zero, friction));
    vlanes force =
        v_select(lanes_or(bilateral, has_friction), v_add_scaled(tangential_force, normal_force, n),
                 v_scale(n, normal_force));
    return v_select(lanes_or(bilateral, lanes_less(zero, normal_force)), force, none);
}

static inline void slopes_of_batch(const contact_simd_batch *batch, double fraction,
                                   double slopes[LANES])
{
    const vlanes from = load(batch->current_u), to = load(batch->candidate_u);
    vlanes force = interpolate(load(batch->current_force), load(batch->candidate_force), fraction);
    vlanes residual = v_sub(force, force_of_batch(batch, interpolate(from, to, fraction)));
    lanes_store(slopes, v_dot(residual, v_sub(to, from)));
}

static double slope_of_sleeve(const contact_set *set, uint32_t i, double fraction)
{
    const contact_iterate *current = &set->current[i], *candidate = &set->candidate[i];
    const contact_iterate iterate = contact_iterate_lerp(current, candidate, fraction);
    vec3 residual = vec3_sub(iterate.force, vbss_contact_force(&set->constraints[i], iterate.u));
    return vec3_dot(residual, vec3_sub(candidate->u, current->u));
}

/* The sum runs in the order of the constraints. */
double VBSS_WIDE_NAME(vbss_contact_line_search_slope)(const contact_set *set, double fraction)
{
    double sum = 0.0;
    for (uint32_t first = 0; first < set->count; first += LANES) {
        const contact_simd_batch *batch = &set->simd_batches[first / LANES];
        double slopes[LANES];
        slopes_of_batch(batch, fraction, slopes);
        for (uint32_t k = 0; k < LANES && first + k < set->count; k++) {
            sum += batch->is_sleeve[k] ? slope_of_sleeve(set, first + k, fraction) : slopes[k];
        }
    }
    return sum;
}
