/* Reading of one closed curve: reduction, then projections until a diagram decomposes into twist
 * regions, then comparison of invariants. */
#include "knot/knot.h"

void vbss_knot_curve_begin(knot_curve *curve, bool checked)
{
    curve->stage = KNOT_CURVE_REDUCE;
    curve->checked = checked;
    curve->overflowed = curve->has_best = false;
    curve->direction = 0;
    curve->best = 0;
    curve->reading = (knot_reading){.reason = VBSS_KNOT_REASON_NONE};
    curve->counts.closures++;
    vbss_knot_reduction_begin(&curve->reduction, &curve->polygon, NULL, 0);
}

static void end_reading(knot_curve *curve, vbss_knot_reason reason)
{
    curve->reading.reason = reason;
    curve->stage = KNOT_CURVE_READ;
}

/* The first certified diagram ends the search; otherwise the one with the fewest crossings is
 * kept. */
static void store_diagram(knot_curve *curve, bool certified, const knot_factors *factors)
{
    const knot_gauss_code *code = &curve->codes[1 - curve->best],
                          *best = &curve->codes[curve->best];
    if (certified || !curve->has_best || code->n < best->n) {
        curve->best = 1 - curve->best;
        curve->has_best = true;
        curve->reading.crossings = code->n;
        curve->reading.certified = certified;
        curve->reading.factors = *factors;
    }
    curve->stage = KNOT_CURVE_PROJECT;
}

static void project(knot_curve *curve, knot_ops *budget)
{
    knot_gauss_code *code = &curve->codes[1 - curve->best];
    vec3 direction = vbss_knot_direction(curve->direction++);
    curve->counts.projections++;
    knot_diagram_status diagram =
        vbss_knot_project(&curve->projector, &curve->polygon, direction, code, budget);
    if (diagram != KNOT_DIAGRAM_REGULAR) {
        curve->counts.degenerate += diagram == KNOT_DIAGRAM_DEGENERATE;
        curve->counts.overflows += diagram == KNOT_DIAGRAM_FULL;
        curve->overflowed |= diagram == KNOT_DIAGRAM_FULL;
        return;
    }
    vbss_knot_gauss_code_simplify(code, budget);
    knot_factors factors;
    if (vbss_knot_decompose(code, &factors)) {
        store_diagram(curve, true, &factors);
    } else {
        curve->tries = KNOT_TRIES;
        curve->stage = KNOT_CURVE_UNTANGLE;
    }
}

static void untangle(knot_curve *curve, knot_ops *budget)
{
    knot_gauss_code *code = &curve->codes[1 - curve->best];
    if (!vbss_knot_gauss_code_untangle(code, &curve->codes[2], &curve->tries, budget)) {
        knot_factors factors;
        bool certified = vbss_knot_decompose(code, &factors);
        store_diagram(curve, certified, &factors);
    }
}

/* Computes one invariant per call. */
static void compute(knot_curve *curve, knot_ops *budget)
{
    const knot_gauss_code *code = &curve->codes[curve->best];
    knot_reading *r = &curve->reading;
    knot_invariants *v = &r->invariants;
    switch (curve->computed++) {
    case 0:
        v->determinant = vbss_knot_determinant(&curve->algebra, code, budget);
        return;
    case 1:
        vbss_knot_vassiliev(code, &v->v2, &v->v3, budget);
        return;
    case 2:
        v->known = vbss_knot_signature(&curve->algebra, code, KNOT_X_ORDINARY_10000, &v->signature,
                                       budget);
        return;
    case 3:
        v->known = v->known && vbss_knot_signature(&curve->algebra, code, KNOT_X_TRISTRAM_10000,
                                                   &v->signature_tristram, budget);
        return;
    default:
        break;
    }
    if (!v->known) {
        end_reading(curve, VBSS_KNOT_REASON_DEGENERATE);
    } else if (r->certified) {
        bool same = vbss_knot_invariants_same(vbss_knot_invariants_of(&r->factors), *v);
        r->throws = same;
        end_reading(curve, same ? VBSS_KNOT_REASON_NONE : VBSS_KNOT_REASON_CONFLICT);
    } else if (vbss_knot_match(*v, &r->factors)) {
        vbss_knot_jones_begin(&curve->bracket, code, budget);
        curve->stage = KNOT_CURVE_CONFIRM;
    } else {
        end_reading(curve, VBSS_KNOT_REASON_NONE);
    }
}

/* Other knots can have the determinant, signatures, v2 and v3 of throws, or of the unknot. The Jones
 * polynomial distinguishes all that are known. */
static void confirm(knot_curve *curve, knot_ops *budget)
{
    knot_reading *r = &curve->reading;
    if (!vbss_knot_bracket_resume(&curve->bracket, budget)) {
        return;
    }
    if (!vbss_knot_jones_end(&curve->bracket, &r->invariants)) {
        end_reading(curve, VBSS_KNOT_REASON_CAPACITY);
        return;
    }
    knot_invariants sum = vbss_knot_invariants_of(&r->factors);
    vbss_knot_jones_of(&r->factors, &sum);
    r->throws = vbss_knot_invariants_same(sum, r->invariants);
    if (!r->throws) {
        r->factors = (knot_factors){.count = 0};
    }
    end_reading(curve, VBSS_KNOT_REASON_NONE);
}

static void finish_projecting(knot_curve *curve)
{
    if (!curve->has_best) {
        end_reading(curve,
                    curve->overflowed ? VBSS_KNOT_REASON_CAPACITY : VBSS_KNOT_REASON_DEGENERATE);
        return;
    }
    curve->counts.certified += curve->reading.certified;
    if (curve->reading.certified && !curve->checked) {
        curve->reading.throws = true;
        curve->reading.invariants = vbss_knot_invariants_of(&curve->reading.factors);
        end_reading(curve, VBSS_KNOT_REASON_NONE);
        return;
    }
    curve->computed = 0;
    curve->stage = KNOT_CURVE_COMPUTE;
    if (curve->codes[curve->best].n > curve->algebra.capacity) {
        end_reading(curve, VBSS_KNOT_REASON_CAPACITY);
    }
}

bool vbss_knot_curve_resume(knot_curve *curve, knot_ops *budget)
{
    while (*budget > 0 && curve->stage != KNOT_CURVE_READ) {
        switch (curve->stage) {
        case KNOT_CURVE_REDUCE:
            if (vbss_knot_reduction_resume(&curve->reduction, budget)) {
                curve->counts.removed += curve->reduction.removed;
                curve->stage = KNOT_CURVE_PROJECT;
            }
            break;
        case KNOT_CURVE_PROJECT:
            if (curve->reading.certified || curve->direction >= curve->direction_limit) {
                finish_projecting(curve);
            } else {
                project(curve, budget);
            }
            break;
        case KNOT_CURVE_UNTANGLE:
            untangle(curve, budget);
            break;
        case KNOT_CURVE_COMPUTE:
            compute(curve, budget);
            break;
        case KNOT_CURVE_CONFIRM:
            confirm(curve, budget);
            break;
        case KNOT_CURVE_READ:
            break;
        }
    }
    return curve->stage == KNOT_CURVE_READ;
}

/* ---- comparison */

static bool same_throws(const knot_factors *a, const knot_factors *b)
{
    bool same = a->count == b->count;
    for (uint32_t i = 0; i < a->count && same; i++) {
        const knot_factor *f = &a->factors[i];
        same = vbss_knot_count_factors(a, f->wraps, f->handedness) ==
               vbss_knot_count_factors(b, f->wraps, f->handedness);
    }
    return same;
}

/* Whether only the Jones polynomial distinguishes the curve from throws, or from the unknot. */
static bool is_refuted(const knot_reading *r)
{
    return r->invariants.jones_known && !r->throws;
}

bool vbss_knot_readings_agree(const knot_reading *a, const knot_reading *b)
{
    if (a->reason != VBSS_KNOT_REASON_NONE || b->reason != VBSS_KNOT_REASON_NONE) {
        return false;
    }
    if (a->certified && b->certified) {
        return same_throws(&a->factors, &b->factors);
    }
    return is_refuted(a) == is_refuted(b) &&
           vbss_knot_invariants_same(a->invariants, b->invariants);
}
