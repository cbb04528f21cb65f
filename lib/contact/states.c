/* The states of all rows and the increments of all separators, found together.
 *
 * A primal-dual active set: solve with the rows in their states, look which states the solution has, and
 * again with those, until they are the same. Nothing is taken that was not looked at after its solve. A solve
 * that leads too far is followed part of the way, and the next goes on from the states there. */
#include "contact/contact.h"

#include <string.h>

/* Of a solve, in products of blocks beside its own, for each separator: taken out, put in; and the rows between them. */
enum { COST_OF_SEPARATOR = 70 };

static uint64_t cost(const vbss_system *system)
{
    uint32_t separators = system->active_count - system->run_count;
    return system->elimination.products + (uint64_t)COST_OF_SEPARATOR * separators;
}

static bool solve(contact_set *set, const contact_search *search)
{
    vbss_system *system = search->system;
    vbss_system_take_separators(system);
    for (uint32_t i = 0; i < search->weld_count; i++) {
        vbss_weld_eliminate(&search->welds[i], system);
    }
    vbss_contact_assemble(set, system);
    set->counters.solves++;
    set->counters.work += cost(system);
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
        vec3 u = moved_by(row, search->system);
        double missed = vbss_contact_next_state(row, u, next);
        set->there[i] = (contact_stand){u, vbss_contact_linear_force(row, u)};
        if (is_open(&row->is)) {
            double overlap = missed / (row->stiffness * row->thickness);
            if (overlap <= search->slack) { /* a hair is no reason to close */
                *next = row->is;
                overlap = 0.0;
            }
            l.overlap = vbss_max_or_nan(overlap, l.overlap);
        } else {
            l.force = vbss_max_or_nan(missed, l.force);
            /* What a grasp pulls with says nothing of how much a contact matters. */
            l.pressure = vbss_max(row->bilateral ? 0.0 : next->pressure, l.pressure);
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

/* ---- how far to follow a solve
 *
 * What the last solve led to and what this one leads to both balance, and so does all between them with forces
 * between theirs. What those miss the law by does work along the way: while it is negative the law still
 * drives on, and where it is zero contacts would come to rest. With given bounds of friction, that is
 * where the energy is least along the way. */

/* Nothing is cut when the work at the end is no larger than this share of that at the begin; and the place is
 * good enough with such a share of that, or after so many looks. */
#define DRIVEN_BACK 0.5
#define AT_REST 0.1
enum { LOOKS = 8, HALVES = 8 };
/* Less than this share is no way to get on. False position that ends below a share and not at rest is gone on with by halves:
 * below SHORT_WAY, once rows have been softened below SHORTEST. */
#define SHORTEST 0.005
#define SHORT_WAY 0.1
/* Where the law does not drive at all, and what comes is worse. */
#define DOUBTED 0.5

/* False position; an end that stays twice counts half (Illinois). Where a row closes on the way work rises so sharply that
 * this stays before it, all states would be as they were, and the next solve would lead to the same place: then halves, and
 * what is beyond. */
static double share_to_follow(contact_set *set, bool wide, bool softened)
{
    vbss_contact_begin_work(set, wide);
    double low = 0.0, high = 1.0, at_low = vbss_contact_work(set, wide, low),
           at_high = vbss_contact_work(set, wide, high);
    const double begin = -at_low;
    if (!(begin > 0.0)) { /* friction alone may drive there, and knows no least energy */
        return at_high > -begin ? DOUBTED : 1.0;
    }
    if (!(at_high > DRIVEN_BACK * begin)) {
        return 1.0;
    }
    double share = high, found = at_high;
    for (int k = 0, side = 0; k < LOOKS && fabs(found) > AT_REST * begin; k++) {
        share = low - at_low * (high - low) / (at_high - at_low);
        found = vbss_contact_work(set, wide, share);
        if (found > 0.0) {
            high = share;
            at_high = found;
            at_low *= side > 0 ? 0.5 : 1.0;
            side = 1;
        } else {
            low = share;
            at_low = found;
            at_high *= side < 0 ? 0.5 : 1.0;
            side = -1;
        }
    }
    if (share >= (softened ? SHORTEST : SHORT_WAY) || fabs(found) <= AT_REST * begin) {
        return vbss_max(share, SHORTEST);
    }
    for (int k = 0; k < HALVES && fabs(found) > AT_REST * begin; k++) {
        share = 0.5 * (low + high);
        found = vbss_contact_work(set, wide, share);
        if (found > 0.0) {
            high = share;
        } else {
            low = share;
        }
    }
    return vbss_max(fabs(found) > AT_REST * begin ? high : share, SHORTEST);
}

/* Where the next solve goes on from; before the first there may be nothing. */
static void follow(contact_set *set, const contact_search *search, bool first, bool softened)
{
    double share = first ? 1.0 : share_to_follow(set, search->system->wide, softened);
    for (uint32_t i = 0; i < set->count; i++) {
        if (share < 1.0) {
            set->here[i] = contact_between(&set->here[i], &set->there[i], share);
            vbss_contact_state_at(&set->rows[i], &set->here[i], &set->next[i]);
        } else {
            set->here[i] = set->there[i];
        }
    }
    if (search->most_work > 0) {
        vbss_system_follow(search->system, share);
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

/* What comes nearer to the law with each solve is not left before it is there. */
static void note_missed(contact_stage *at, const contact_search *search, const look *l, bool first)
{
    double missed = vbss_max(l->force / (l->pressure + search->least_force), l->overlap);
    at->stalled++;
    if (first || missed <= 0.5 * at->missed) {
        at->missed = missed;
        at->stalled = 0;
    }
}

static void scale_stiffness(contact_set *set, contact_stage *at, double factor)
{
    for (uint32_t i = 0; i < set->count; i++) {
        if (!set->rows[i].bilateral) {        /* nothing about those is to be found */
            set->rows[i].stiffness *= factor; /* a power of two: exact */
        }
    }
    at->softness *= factor;
    at->solves = 0;
}

static void soften_or_stiffen(contact_set *set, contact_stage *at, const look *l, double little)
{
    at->solves++;
    if (at->softness < 1.0) {
        bool settled = l->overlap <= SOFT_OVERLAP && l->force <= little;
        if (settled || at->solves == SOFT_SOLVES) {
            scale_stiffness(set, at, STIFFER);
        }
        return;
    }
    bool deep = at->solves <= DEEP_SOLVES && l->overlap > DEEP;
    if (!at->softened && (deep || at->solves == LOST_SOLVES)) {
        at->softened = true;
        scale_stiffness(set, at, SOFTEST);
    }
}

/* What the last solve is worth: a result, or none yet. */
static contact_outcome judge(const contact_search *search, const contact_stage *at, const look *l)
{
    double none = search->force_share * l->pressure + search->least_force;
    double little = search->loose_share * l->pressure + search->least_force;
    if (at->softness < 1.0) { /* of another stiffness than the rows' */
        return CONTACT_LOST;
    }
    if (l->overlap == 0.0 && l->force <= none) {
        return CONTACT_FOUND;
    }
    /* States may cycle, where friction and two neighbouring rows contradict each other: what is missed
     * is small then, and the next part finds it. */
    bool patient = at->softened || at->stalled + 1 >= search->patience;
    bool loose = patient && l->overlap <= search->loose_overlap && l->force <= little;
    return loose ? CONTACT_LOOSE : CONTACT_LOST;
}

static bool is_spent(const contact_set *set, const contact_search *search)
{
    return search->most_work > 0 && set->counters.work + cost(search->system) > search->most_work;
}

bool vbss_contact_must_wait(contact_set *set, uint64_t work)
{
    contact_slot *slot = &set->slot;
    bool over = slot->end > 0 && slot->begun && set->counters.work + work > slot->end;
    if (slot->again ? slot->passed == slot->stopped : over) {
        return true;
    }
    slot->passed++;
    slot->begun = true;
    return false;
}

static contact_outcome search_states(contact_set *set, const contact_search *search,
                                     contact_stage *at)
{
    while (at->begun < search->limit) {
        if (vbss_contact_must_wait(set, cost(search->system))) {
            return CONTACT_WAITS;
        }
        const bool first = at->begun++ == 0;
        if (!solve(set, search)) {
            return CONTACT_SINGULAR;
        }
        const look l = look_at_rows(set, search);
        note_missed(at, search, &l, first);
        contact_outcome outcome = judge(search, at, &l);
        set->residual = l.force;
        if (outcome == CONTACT_LOST) {
            follow(set, search, first && !search->goes_on, at->softened);
            if (is_spent(set, search)) {
                vbss_system_stop_there(search->system);
                set->stopped = true;
                outcome = CONTACT_LOOSE;
            }
        } else { /* from there a further linearisation goes on */
            memcpy(set->here, set->there, set->count * sizeof *set->here);
        }
        take_found(set);
        if (outcome != CONTACT_LOST) {
            set->counters.loose += outcome == CONTACT_LOOSE;
            return outcome;
        }
        soften_or_stiffen(set, at, &l, search->loose_share * l.pressure + search->least_force);
    }
    return CONTACT_LOST;
}

/* Nothing has moved yet, and forces are what they were. */
static void begin_way(contact_set *set, const contact_search *search)
{
    vbss_system_begin_way(search->system);
    for (uint32_t i = 0; search->goes_on && i < set->count; i++) {
        set->here[i].u = vec3_zero();
    }
}

contact_outcome vbss_contact_find_states(contact_set *set, const contact_search *search)
{
    contact_stage *at = &set->stage;
    if (!search->resumes) {
        *at = (contact_stage){.softness = 1.0};
        set->stopped = false;
        if (search->most_work > 0) {
            begin_way(set, search);
        }
    }
    contact_outcome found = search_states(set, search, at);
    if (found != CONTACT_WAITS) {
        scale_stiffness(set, at, 1.0 / at->softness);
    }
    return found;
}

void vbss_contact_note_found(contact_set *set)
{
    for (uint32_t i = 0; i < set->count; i++) {
        set->found_before[i] = set->rows[i].is;
    }
    set->stopped_before = set->stopped;
}

void vbss_contact_return_to_found(contact_set *set)
{
    for (uint32_t i = 0; i < set->count; i++) {
        contact_found *is = &set->rows[i].is;
        *is = set->found_before[i];
        set->here[i].force = vec3_add_scaled(is->rubbing, is->pressure, set->rows[i].normal);
    }
    set->stopped = set->stopped_before;
}
