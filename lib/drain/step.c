/* A step of a drain alone: (assemble -> solve -> look again at the forces -> solve) -> commit, in halves where a node
 * would go far.
 *
 * The tangent is made anew in every step: one that is kept fails as soon as the surface has turned by 0.1 to 0.2 rad. The
 * second look at the forces, with the same factor, leaves a tenth of the error; its correction is dropped when it is
 * not small, as after a snap it may point anywhere (docs/drain.md). */
#include "base/error.h"
#include "drain/drain.h"

static double finish_solution(drain_object *d)
{
    vbss_system_load_schur_complement(d->system);
    bool solved = vbss_system_solve(d->system);
    return solved ? vbss_drain_largest_increment(d, d->system, 0) : (double)INFINITY;
}

/* Largest increments of the tangent's solve and of the second look. False: there is no solution. */
typedef struct moves {
    double first, second;
} moves;

static bool linearise(drain_object *d, const drain_stage *stage, moves *m)
{
    *m = (moves){0.0, 0.0};
    vbss_system_clear(d->system);
    vbss_drain_assemble(d, stage, d->system, 0);
    if (!vbss_system_condense(d->system)) {
        return false;
    }
    m->first = finish_solution(d);
    if (!(m->first < 1e100)) {
        return false;
    }
    vbss_drain_follow(d, d->system, 0);
    if (m->first <= d->config.position_tolerance) {
        return true;
    }
    vbss_drain_assemble_rhs(d, stage, d->system, 0);
    vbss_system_condense_rhs(d->system);
    m->second = finish_solution(d);
    if (m->second < DRAIN_BELIEVED * m->first) {
        vbss_drain_follow(d, d->system, 0);
    } else {
        d->statistics.corrections_dropped++;
    }
    return true;
}

/* False: no solution. Too far: what has been found is worth nothing if the part can be halved. */
static bool try_part(drain_object *d, const drain_stage *stage, bool may_halve, bool *too_far)
{
    moves m = {0.0, 0.0}; /* of the last linearisation */
    uint32_t limit = d->config.linearisation_limit;
    *too_far = false;
    vbss_drain_begin_part(d);
    for (uint32_t k = 0; k < limit; k++) {
        if (!linearise(d, stage, &m)) {
            return false;
        }
        d->statistics.linearisations++;
        if (k == 0 && m.first > d->config.move_limit) {
            limit++;
            *too_far = m.first > DRAIN_TOO_FAR * d->config.move_limit;
            d->statistics.forced += *too_far && !may_halve;
        }
        if (*too_far && may_halve) {
            return true;
        }
        if (m.first <= d->config.position_tolerance) {
            break;
        }
    }
    d->statistics.last_correction = m.second;
    return true;
}

/* The parts are dyadic, so they sum to 1 exactly. */
static bool make_parts(drain_object *d, double h, drain_stage *stage)
{
    double begin = 0.0, part = 1.0, smallest = 1.0;
    for (uint32_t k = 0; k < d->config.halving_limit; k++) {
        smallest *= 0.5;
    }
    while (begin < 1.0) {
        bool too_far;
        *stage = (drain_stage){h * part, begin + part};
        if (!try_part(d, stage, part > smallest, &too_far)) {
            return false;
        }
        if (too_far && part > smallest) {
            part *= 0.5;
            continue;
        }
        vbss_drain_commit(d, stage->h);
        begin += part;
    }
    return d->statistics.last_move < 1e100;
}

/* ---- the step */

static vbss_result know_pattern(drain_object *d)
{
    uint32_t first;
    if (!d->pattern_known) {
        vbss_system_begin_pattern(d->system);
        VBSS_TRY(vbss_drain_register(d, d->system, NULL, &first));
        VBSS_TRY(vbss_system_analyse(d->system));
        vbss_drain_aim(d, d->system);
        d->pattern_known = true;
    }
    return VBSS_OK;
}

vbss_result vbss_drain_implicit_step(drain_object *d, double h)
{
    drain_stage stage = {h, 1.0}; /* of the last part */
    VBSS_TRY(know_pattern(d));
    if (!make_parts(d, h, &stage)) {
        return VBSS_ERROR_NOT_FINITE;
    }
    vbss_drain_arrive(d, stage.h);
    return VBSS_OK;
}
