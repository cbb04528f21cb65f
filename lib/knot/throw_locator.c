/* Places of the throws on the thread, and their order.
 *
 * The thread is reduced again, but only between fixed vertices, so that the crossings of its
 * diagrams have places. If a diagram decomposes, it shows the throws' strands, nested about the
 * tissue (throw_places.c). Sub-chains cut between the throws must then contain exactly the inner
 * throws (sub_chains.c). If no diagram decomposes, or a sub-chain does not agree, places and order
 * stay unknown.
 * (Shrinking sub-chains until they lose a throw was tried: the ray of a cut limb may undo an inner
 * throw as well as the outermost one, and 2 orders of 130 000 were wrong.) */
#include "knot/knot.h"

#include <string.h>

enum { ROUNDS = 6 };

/* Segments between vertices that stay, a round; 0: none stay. */
static const uint32_t spacings[ROUNDS] = {6, 16, 0, 10, 24, 4};

/* ---- rounds */

static void begin_check(knot_locator *l)
{
    l->certified = true;
    l->level = 0;
    l->reading = false;
    l->stage = KNOT_LOCATE_CHECK;
}

/* Starts a round: closes the thread. The place of the tissue is fixed, and its ray is an
 * obstacle. */
static void begin_round(knot_locator *l, knot_curve *curve)
{
    const knot_input *input = l->input;
    const double last = input->point_count - 1.0, tissue = input->tissue_place;
    knot_polygon *p = &l->polygon;
    knot_extension tail =
        vbss_knot_straight_extension(input->points[0], l->closure->tail_directions[0]);
    knot_extension end = vbss_knot_straight_extension(input->points[input->point_count - 1],
                                                      l->closure->long_directions[0]);
    vbss_knot_close_begin(l->closure, p, &tail);
    if (l->closure->has_tissue) {
        vbss_knot_polygon_add_thread(p, input, 0.0, tissue);
        vec3 in = p->x[p->count - 1];
        p->is_fixed[p->count - 1] = true;
        l->ray = (knot_edge){in, vec3_add_scaled(in, l->closure->far_distance, l->closure->away)};
        vbss_knot_polygon_add_thread(p, input, tissue, last);
    } else {
        vbss_knot_polygon_add_thread(p, input, 0.0, last);
    }
    vbss_knot_close_end(l->closure, p, &tail, &end);
    /* far away: there is no thread between them */
    p->is_fixed[0] = p->is_fixed[p->count - 1] = true;
    uint32_t spacing = spacings[l->round++];
    for (uint32_t i = 1; i < p->count && spacing > 0; i += spacing) {
        p->is_fixed[i] = true;
    }
    vbss_knot_reduction_begin(&curve->reduction, p, &l->ray, l->closure->has_tissue ? 1 : 0);
    l->direction = 0;
    l->stage = KNOT_LOCATE_REDUCE;
}

static void reduce(knot_locator *l, knot_curve *curve, knot_ops *budget)
{
    if (vbss_knot_reduction_resume(&curve->reduction, budget)) {
        curve->counts.removed += curve->reduction.removed;
        l->stage = KNOT_LOCATE_PROJECT;
    }
}

/* Lists the throws without places. */
static void set_unordered(knot_locator *l)
{
    l->count = l->whole->factors.count;
    for (uint32_t i = 0; i < l->count; i++) {
        const knot_factor *f = &l->whole->factors.factors[i];
        l->throws[i] = (knot_located){
            .wraps = f->wraps, .handedness = f->handedness, .ordered = l->count == 1};
    }
    l->stage = KNOT_LOCATE_DONE;
}

static void end_round(knot_locator *l, knot_curve *curve)
{
    if (l->has_spare) {
        memcpy(l->throws, l->spare, sizeof l->throws);
        l->has_spare = false;
        begin_check(l);
    } else if (l->round < ROUNDS) {
        begin_round(l, curve);
    } else {
        set_unordered(l);
    }
}

/* ---- diagrams */

static bool is_same_stack(const knot_locator *l)
{
    bool same = true;
    for (uint32_t i = 0; i < l->count && same; i++) {
        const knot_located *a = &l->throws[i], *b = &l->spare[i];
        same = a->wraps == b->wraps && a->handedness == b->handedness && a->stray == b->stray &&
               a->ordered == b->ordered;
    }
    return same;
}

/* Whether a throw spans less of the thread than before, and still lies between the same
 * neighbours. */
static bool is_better_place(const knot_locator *l, uint32_t i)
{
    const knot_located *t = &l->throws[i], *inner = &l->spare[i], *outer = &l->spare[i];
    if (t->ordered) {
        inner = i > 0 ? inner - 1 : inner;
        outer = i + 1 < l->count && l->spare[i + 1].ordered ? outer + 1 : outer;
    }
    return vbss_knot_extent_of(t) < vbss_knot_extent_of(&l->spare[i]) &&
           (inner == &l->spare[i] || vbss_knot_is_inside(inner, t)) &&
           (outer == &l->spare[i] || vbss_knot_is_inside(t, outer));
}

/* Among all diagrams that show the same stack, each throw gets the places where it spans the least
 * of the thread, because one of its crossings may appear far from the others. Rerouted strands have
 * no places of their own; such diagrams are used only until there is another one. */
static void store_better_places(knot_locator *l, const knot_gauss_code *code,
                                const knot_factors *factors)
{
    l->stage = KNOT_LOCATE_PROJECT;
    if (!vbss_knot_locate_throws(l, code, factors) ||
        !vbss_knot_has_first_throws(l, l->whole, l->count) ||
        (l->closure->has_tissue && !vbss_knot_strays_agree(l))) {
        return;
    }
    if (!l->has_spare || (l->spare_is_rerouted && !l->is_rerouted)) {
        memcpy(l->spare, l->throws, sizeof l->throws);
        l->has_spare = true;
        l->spare_is_rerouted = l->is_rerouted;
    } else if (l->spare_is_rerouted == l->is_rerouted && is_same_stack(l)) {
        for (uint32_t i = 0; i < l->count; i++) {
            if (is_better_place(l, i)) {
                l->spare[i] = l->throws[i];
            }
        }
    }
}

static void project(knot_locator *l, knot_curve *curve, knot_ops *budget)
{
    knot_gauss_code *code = &curve->codes[0];
    knot_factors factors;
    if (l->direction >= l->direction_limit) {
        end_round(l, curve);
        return;
    }
    vec3 direction = vbss_knot_direction(l->direction++);
    curve->counts.projections++;
    if (vbss_knot_project(&curve->projector, &l->polygon, direction, code, budget) !=
        KNOT_DIAGRAM_REGULAR) {
        return;
    }
    vbss_knot_gauss_code_simplify(code, budget);
    l->is_rerouted = false;
    if (vbss_knot_decompose(code, &factors)) {
        store_better_places(l, code, &factors);
    } else if (!l->has_spare || l->spare_is_rerouted) {
        l->tries = KNOT_TRIES;
        l->stage = KNOT_LOCATE_UNTANGLE;
    }
}

static void untangle(knot_locator *l, knot_curve *curve, knot_ops *budget)
{
    knot_gauss_code *code = &curve->codes[0];
    knot_factors factors;
    if (vbss_knot_gauss_code_untangle(code, &curve->codes[1], &l->tries, budget)) {
        l->is_rerouted = true;
        return;
    }
    l->stage = KNOT_LOCATE_PROJECT;
    if (l->is_rerouted && vbss_knot_decompose(code, &factors)) {
        store_better_places(l, code, &factors);
    }
}

/* ---- the complete search */

void vbss_knot_locator_begin(knot_locator *l, knot_curve *curve, const knot_input *input,
                             const knot_closure *closure, const knot_reading *whole,
                             const knot_reading *tail, const knot_reading *long_limb,
                             uint32_t direction_limit)
{
    l->input = input;
    l->closure = closure;
    l->whole = whole;
    l->limbs[0] = tail;
    l->limbs[1] = long_limb;
    l->count = 0;
    l->certified = false;
    l->has_spare = false;
    /* twice as many, because they also serve the places */
    l->direction_limit = 2 * direction_limit;
    l->round = 0;
    l->stage = KNOT_LOCATE_DONE;
    if (!whole->throws || whole->factors.count == 0) {
        return;
    }
    begin_round(l, curve);
    if (closure->has_tissue && !(knot_was_read(tail) && knot_was_read(long_limb))) {
        set_unordered(l);
    }
}

bool vbss_knot_locator_resume(knot_locator *l, knot_curve *curve, knot_ops *budget)
{
    while (*budget > 0 && l->stage != KNOT_LOCATE_DONE) {
        switch (l->stage) {
        case KNOT_LOCATE_REDUCE:
            reduce(l, curve, budget);
            break;
        case KNOT_LOCATE_PROJECT:
            project(l, curve, budget);
            break;
        case KNOT_LOCATE_UNTANGLE:
            untangle(l, curve, budget);
            break;
        case KNOT_LOCATE_CHECK:
            vbss_knot_check_order(l, curve, budget);
            break;
        case KNOT_LOCATE_DONE:
            break;
        }
    }
    return l->stage == KNOT_LOCATE_DONE;
}
