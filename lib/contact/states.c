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

/* ---- the look after a solve */

/* Of an open row, overlap is what misses the law; of a closed one, a force. */
typedef struct look {
    double force, pressure; /* largest, N */
    double overlap;         /* largest, as a share of the thickness */
} look;

static bool is_open(const contact_found *found)
{
    return found->state == CONTACT_OPEN;
}

static look look_at_rows(contact_set *set, const contact_search *search)
{
    look l = {0.0, 0.0, 0.0};
    for (uint32_t i = 0; i < set->count; i++) {
        const contact_row *row = &set->rows[i];
        contact_found *next = &set->next[i];
        double missed = vbss_contact_next_state(row, moved_by(row, search->system), next);
        if (is_open(&row->is)) {
            double overlap = missed / (row->stiffness * row->thickness);
            if (overlap <= search->slack) { /* a hair is no reason to close */
                *next = row->is;
                overlap = 0.0;
            }
            l.overlap = vbss_larger(overlap, l.overlap);
        } else {
            l.force = vbss_larger(missed, l.force);
            l.pressure = greater(next->pressure, l.pressure);
        }
    }
    return l;
}

static void take_found(contact_set *set)
{
    for (uint32_t i = 0; i < set->count; i++) {
        set->rows[i].is = set->next[i];
    }
}

/* ---- the search */

/* From this overlap on, as a share of the thickness, rows that close all at once would throw
 * each other about; and after so many solves they do. Then all are softened, and stiffened again in steps as
 * their states settle, or after some solves. */
#define DEEP 0.2
enum { DEEP_SOLVES = 2, LOST_SOLVES = 9, SOFT_SOLVES = 5 };
#define SOFTEST (1.0 / 256.0)
#define STIFFER 16.0
/* What is settled while soft. */
#define SOFT_OVERLAP 0.05

typedef struct stage {
    double softness;
    uint32_t solves; /* with this softness */
    bool softened;   /* it has been, and will not be again */
} stage;

static void scale_stiffness(contact_set *set, stage *at, double factor)
{
    for (uint32_t i = 0; i < set->count; i++) {
        set->rows[i].stiffness *= factor; /* a power of two: exact */
    }
    at->softness *= factor;
    at->solves = 0;
}

/* True: what was found is that of another stiffness than the rows', and no result. */
static bool soften_or_stiffen(contact_set *set, stage *at, const look *l, double little)
{
    if (at->softness < 1.0) {
        bool settled = l->overlap <= SOFT_OVERLAP && l->force <= little;
        if (settled || at->solves == SOFT_SOLVES) {
            scale_stiffness(set, at, STIFFER);
        }
        return true;
    }
    bool deep = at->solves <= DEEP_SOLVES && l->overlap > DEEP;
    if (!at->softened && (deep || at->solves == LOST_SOLVES)) {
        at->softened = true;
        scale_stiffness(set, at, SOFTEST);
        return true;
    }
    return false;
}

static contact_outcome search_states(contact_set *set, const contact_search *search, stage *at)
{
    for (uint32_t k = 0; k < search->limit; k++) {
        if (!solve(set, search)) {
            return CONTACT_SINGULAR;
        }
        const look l = look_at_rows(set, search);
        double none = search->force_share * l.pressure + search->least_force;
        double little = search->loose_share * l.pressure + search->least_force;
        set->residual = l.force;
        take_found(set);
        at->solves++;
        if (soften_or_stiffen(set, at, &l, little)) {
            continue;
        }
        if (l.overlap == 0.0 && l.force <= none) {
            return CONTACT_FOUND;
        }
        /* States may cycle, where friction and two neighbouring rows contradict each other: what is missed
         * is small then, and the next part finds it. */
        bool patient = at->softened || at->solves >= search->patience;
        if (patient && l.overlap <= search->loose_overlap && l.force <= little) {
            set->counters.loose++;
            return CONTACT_LOOSE;
        }
    }
    return CONTACT_LOST;
}

contact_outcome vbss_contact_find_states(contact_set *set, const contact_search *search)
{
    stage at = {.softness = 1.0};
    contact_outcome found = search_states(set, search, &at);
    scale_stiffness(set, &at, 1.0 / at.softness);
    return found;
}
