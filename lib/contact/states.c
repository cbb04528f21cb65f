/* The states of all rows and the increments of all separators, found together.
 *
 * A primal-dual active set: solve with the rows in their states, look which states the solution has, and
 * again with those, until they are the same. Nothing is taken that was not looked at after its solve. */
#include "contact/contact.h"

static bool solve(contact_set *set, const contact_search *search)
{
    vbss_system *system = search->system;
    vbss_system_take_separators(system);
    for (uint32_t i = 0; i < search->weld_count; i++) {
        vbss_weld_eliminate(&search->welds[i], system);
    }
    vbss_contact_assemble(set, system);
    set->counters.solves++;
    return vbss_system_solve_separators(system);
}

static vec3 moved_by(const contact_row *row, const vbss_system *system)
{
    vec3 u = vec3_zero();
    for (uint32_t p = 0; p < row->term_count; p++) {
        const contact_term *term = &row->terms[p];
        if (system->roles[term->block] == VBSS_ROLE_SEPARATOR) {
            vec3 d = system->solution[term->block];
            u = vec3_add_scaled(u, term->weight, term->turns ? vec3_cross(d, term->arm) : d);
        }
    }
    return u;
}

typedef struct look {
    bool same;
    double residual, pressure; /* largest, N */
} look;

static look look_at_states(contact_set *set, const vbss_system *system)
{
    look l = {true, 0.0, 0.0};
    for (uint32_t i = 0; i < set->count; i++) {
        contact_row *row = &set->rows[i];
        double residual;
        bool same = vbss_contact_next_state(row, moved_by(row, system), &residual);
        l.same = l.same && same;
        l.residual = vbss_larger(residual, l.residual);
        l.pressure = greater(fabs(row->pressure), l.pressure);
    }
    return l;
}

contact_outcome vbss_contact_find_states(contact_set *set, const contact_search *search)
{
    look l = {false, 0.0, 0.0};
    for (uint32_t k = 0; k < search->limit; k++) {
        if (!solve(set, search)) {
            return CONTACT_SINGULAR;
        }
        l = look_at_states(set, search->system);
        set->residual = l.residual;
        if (l.residual <= search->force_share * l.pressure + search->least_force) {
            return CONTACT_FOUND;
        }
    }
    if (l.residual <= search->loose_share * l.pressure) {
        set->counters.loose++;
        return CONTACT_LOOSE;
    }
    return CONTACT_LOST;
}
