/* The work that what balances misses the law by does along the way of a solve, four rows at a time: it is looked at often. Bits
 * are those of vbss_contact_force. */
#include "base/vlanes.h"
#include "contact/contact.h"

/* ---- rows and both ends of the way, by fours */

static void set_lane(double to[3][LANES], uint32_t lane, vec3 v)
{
    to[0][lane] = v.x;
    to[1][lane] = v.y;
    to[2][lane] = v.z;
}

static void set_row(contact_four *f, uint32_t lane, const contact_row *row,
                    const contact_stand *from, const contact_stand *to)
{
    set_lane(f->normal, lane, row->normal);
    set_lane(f->slid, lane, row->slid);
    set_lane(f->held, lane, row->held);
    set_lane(f->from_u, lane, from->u);
    set_lane(f->to_u, lane, to->u);
    set_lane(f->from_force, lane, from->force);
    set_lane(f->to_force, lane, to->force);
    f->gap[lane] = row->gap;
    f->stiffness[lane] = row->stiffness;
    f->along[lane] = contact_stiffness_along(row);
    f->friction[lane] = row->friction;
    f->ties[lane] = row->bilateral ? 1.0 : 0.0;
    f->sleeve[lane] = row->sleeve;
}

void VBSS_WIDE_NAME(vbss_contact_begin_work)(contact_set *set)
{
    static const contact_row none; /* beside the last */
    static const contact_stand rest;
    for (uint32_t first = 0; first < set->count; first += LANES) {
        for (uint32_t lane = 0; lane < LANES; lane++) {
            uint32_t i = first + lane;
            bool there = i < set->count;
            set_row(&set->fours[first / LANES], lane, there ? &set->rows[i] : &none,
                    there ? &set->here[i] : &rest, there ? &set->there[i] : &rest);
        }
    }
}

/* ---- the work */

static inline vlanes load(const double from[3][LANES])
{
    vlanes v = {lanes_load(from[0]), lanes_load(from[1]), lanes_load(from[2])};
    return v;
}

static inline lanes minus(lanes a)
{
    return lanes_scale(-1.0, a);
}

static inline vlanes between(vlanes a, vlanes b, double share)
{
    return v_add(v_scale(a, lanes_splat(1.0 - share)), v_scale(b, lanes_splat(share)));
}

/* Twin of vbss_contact_force, but for sleeves. */
static inline vlanes force_of_four(const contact_four *f, vlanes u)
{
    const lanes zero = lanes_splat(0.0), friction = lanes_load(f->friction);
    const vlanes n = load(f->normal), none = {zero, zero, zero};
    const lanes_mask ties = lanes_less(zero, lanes_load(f->ties));
    lanes pressure =
        lanes_times(minus(lanes_load(f->stiffness)), lanes_add(lanes_load(f->gap), v_dot(n, u)));
    vlanes moved = v_add(load(f->slid), u);
    moved = v_add_scaled(moved, minus(v_dot(moved, n)), n);
    vlanes rubbing = v_add_scaled(load(f->held), minus(lanes_load(f->along)), moved);
    lanes size = lanes_sqrt(v_dot(rubbing, rubbing)), most = lanes_times(friction, pressure);
    lanes_mask cut = lanes_and(lanes_not(ties), lanes_less(most, size));
    rubbing = v_select(cut, v_scale(rubbing, lanes_div(most, size)), rubbing);
    lanes_mask rubs = lanes_or(lanes_less(friction, zero), lanes_less(zero, friction));
    vlanes force = v_select(rubs, v_add_scaled(rubbing, pressure, n), v_scale(n, pressure));
    return v_select(lanes_or(ties, lanes_less(zero, pressure)), force, none);
}

static inline void work_of_four(const contact_four *f, double share, double work[LANES])
{
    const vlanes from = load(f->from_u), to = load(f->to_u);
    vlanes at = between(load(f->from_force), load(f->to_force), share);
    vlanes missed = v_sub(at, force_of_four(f, between(from, to, share)));
    lanes_store(work, v_dot(missed, v_sub(to, from)));
}

static double work_of_sleeve(const contact_set *set, uint32_t i, double share)
{
    const contact_stand *here = &set->here[i], *there = &set->there[i];
    const contact_stand at = contact_between(here, there, share);
    vec3 missed = vec3_sub(at.force, vbss_contact_force(&set->rows[i], at.u));
    return vec3_dot(missed, vec3_sub(there->u, here->u));
}

/* Added up in the order of the rows. */
double VBSS_WIDE_NAME(vbss_contact_work)(const contact_set *set, double share)
{
    double sum = 0.0;
    for (uint32_t first = 0; first < set->count; first += LANES) {
        const contact_four *f = &set->fours[first / LANES];
        double of_row[LANES];
        work_of_four(f, share, of_row);
        for (uint32_t k = 0; k < LANES && first + k < set->count; k++) {
            sum += f->sleeve[k] ? work_of_sleeve(set, first + k, share) : of_row[k];
        }
    }
    return sum;
}
