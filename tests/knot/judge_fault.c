/* Whether what a detector says is the truth, from the truth alone: formulas, order, places, words. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "knot/judge.h"

static bool has(const vbss_knot_throw *t, uint32_t flag)
{
    return (t->flags & flag) != 0;
}

/* ---- invariants by formula */

typedef struct numbers {
    int64_t determinant, v2, v3;
    int32_t signature, tristram;
} numbers;

static void add_throw(numbers *n, int64_t k, int32_t s)
{
    n->determinant *= 2 * k + 1;
    n->v2 += k * (k + 1) / 2;
    n->v3 += s * k * (k + 1) * (2 * k + 1) / 6;
    n->signature -= 2 * s * (int32_t)k;
    n->tristram -= k >= 2 ? 2 * s : 0; /* k <= 3 */
}

static numbers numbers_of(const family_case *c)
{
    numbers n = {.determinant = 1};
    for (uint32_t i = 0; i < c->throws; i++) {
        add_throw(&n, c->wraps[i], c->signs[i]);
    }
    if (c->stray_wraps > 0) {
        add_throw(&n, c->stray_wraps, c->stray_sign);
    }
    return n;
}

/* Of 4_1, 5_2, T(3,4) and T(3,5), told apart by their determinants. */
static int32_t signature_of_other(const family_case *c)
{
    int32_t size = c->determinant == 5 ? 0 : c->determinant == 7 ? 2 : c->determinant == 3 ? 6 : 8;
    return c->v3 > 0 ? -size : size;
}

static bool has_numbers(const vbss_knot_state *s, const family_case *c)
{
    if (c->truth == FAMILY_OTHER) {
        return s->determinant == c->determinant && s->v2 == c->v2 && s->v3 == c->v3 &&
               s->signature == signature_of_other(c);
    }
    numbers n = numbers_of(c);
    return s->determinant == n.determinant && s->v2 == n.v2 && s->v3 == n.v3 &&
           s->signature == n.signature && s->signature_tristram == n.tristram;
}

/* ---- throws */

static bool is_of(const vbss_knot_throw *t, int wraps, int sign)
{
    return t->wraps == wraps && t->handedness == sign;
}

static bool is_stray_of(const vbss_knot_throw *t, const family_case *c)
{
    return c->stray_wraps > 0 && is_of(t, c->stray_wraps, c->stray_sign);
}

/* The same throws, and each that has a position has its own. */
static const char *fault_of_stack(const judge_saying *s, const family_case *c)
{
    bool used[STACK_THROWS] = {false};
    uint32_t strays = 0, number = 0;
    for (uint32_t i = 0; i < s->state.throw_count; i++) {
        const vbss_knot_throw *t = &s->throws[i];
        if (has(t, VBSS_KNOT_THROW_STRAY)) {
            strays++;
            if (!is_stray_of(t, c)) {
                return "a stray throw that is none";
            }
            continue;
        }
        if (has(t, VBSS_KNOT_THROW_ORDERED) &&
            !(number < c->throws && is_of(t, c->wraps[number], c->signs[number]))) {
            return "order";
        }
        number++;
        bool found = false;
        for (uint32_t k = 0; k < c->throws && !found; k++) {
            found = !used[k] && is_of(t, c->wraps[k], c->signs[k]);
            used[k] |= found;
        }
        if (!found) {
            return "a throw that is none";
        }
    }
    if (strays != (c->stray_wraps > 0 ? 1 : 0)) {
        return "stray throws";
    }
    return number == c->throws ? NULL : "number of throws";
}

static bool ascend(const double *places, uint32_t count)
{
    bool up = true;
    for (uint32_t i = 1; i < count; i++) {
        up = up && places[i - 1] <= places[i];
    }
    return up;
}

/* Along the thread, inside out; what is stray on its limb. */
static const char *fault_of_places(const judge_saying *s, const family_case *c, bool tail_last)
{
    double inner[2] = {c->line.tissue_place, c->line.tissue_place};
    for (uint32_t i = 0; i < s->state.throw_count; i++) {
        const vbss_knot_throw *t = &s->throws[i];
        if (!has(t, VBSS_KNOT_THROW_LOCATED)) {
            continue;
        }
        const double *low = tail_last ? t->long_places : t->tail_places;
        const double *high = tail_last ? t->tail_places : t->long_places;
        const double places[6] = {0.0, low[0], low[1], high[0], high[1], c->line.count - 1.0};
        if (!ascend(places, 6)) {
            return "places";
        }
        if (!(fabs(t->slip) <= 1.0 && t->tail_length >= 0.0 && isfinite(t->tail_length))) {
            return "slip or tail's length";
        }
        if (c->line.tissue_place < 0.0) {
            continue;
        }
        if (has(t, VBSS_KNOT_THROW_STRAY)) {
            bool before = places[4] <= c->line.tissue_place;
            bool after = places[1] >= c->line.tissue_place;
            if (!(c->stray_in_tail != tail_last ? before : after)) {
                return "limb of the stray throw";
            }
        } else if (!(places[2] <= c->line.tissue_place && places[3] >= c->line.tissue_place)) {
            return "places about the tissue";
        } else if (has(t, VBSS_KNOT_THROW_ORDERED)) {
            /* from the inside out: strands of stacked throws do not overlap */
            if (!(places[2] <= inner[0] && places[3] >= inner[1])) {
                return "places in order";
            }
            inner[0] = places[1];
            inner[1] = places[4];
        }
    }
    return NULL;
}

/* ---- name, faults, notation: again, from the truth */

static vbss_knot_name name_of(const family_case *c)
{
    static const struct {
        uint32_t throws;
        int wraps[2];
        bool same;
        vbss_knot_name name;
    } named[] = {
        {1, {1, 0}, false, VBSS_KNOT_NAME_SINGLE},
        {1, {2, 0}, false, VBSS_KNOT_NAME_DOUBLE},
        {1, {3, 0}, false, VBSS_KNOT_NAME_TRIPLE},
        {2, {1, 1}, false, VBSS_KNOT_NAME_SQUARE},
        {2, {1, 1}, true, VBSS_KNOT_NAME_GRANNY},
        {2, {2, 1}, false, VBSS_KNOT_NAME_SURGEONS},
        {2, {2, 1}, true, VBSS_KNOT_NAME_SURGEONS_GRANNY},
    };
    bool fls = c->throws == 3 && c->wraps[0] == 2 && c->wraps[1] == 1 && c->wraps[2] == 1 &&
               c->signs[0] == c->signs[2] && c->signs[1] != c->signs[0];
    for (size_t i = 0; i < sizeof named / sizeof named[0] && !fls; i++) {
        bool same = c->throws == 2 && c->signs[0] == c->signs[1];
        if (c->throws == named[i].throws && c->wraps[0] == named[i].wraps[0] &&
            (c->throws == 1 || c->wraps[1] == named[i].wraps[1]) && same == named[i].same) {
            return named[i].name;
        }
    }
    return fls ? VBSS_KNOT_NAME_FLS : c->throws == 0 ? VBSS_KNOT_NAME_NONE : VBSS_KNOT_NAME_STACK;
}

static uint32_t faults_of(const family_case *c)
{
    uint32_t faults = c->throws > 0 && c->wraps[0] != 2 ? VBSS_KNOT_FAULT_FIRST : 0;
    for (uint32_t i = 1; i < c->throws; i++) {
        faults |= c->wraps[i] != 1 ? VBSS_KNOT_FAULT_LATER : 0;
        faults |= c->signs[i] == c->signs[i - 1] ? VBSS_KNOT_FAULT_GRANNY : 0;
    }
    faults |= c->throws < 3 ? VBSS_KNOT_FAULT_FEW : 0;
    faults |= c->throws > 3 ? VBSS_KNOT_FAULT_MANY : 0;
    return faults | (c->stray_wraps > 0 ? VBSS_KNOT_FAULT_STRAY : 0);
}

static void write_notation(const family_case *c, char text[40])
{
    size_t n = 0;
    for (uint32_t i = 0; i < c->throws; i++) {
        if (i > 0) {
            text[n++] = c->signs[i] == c->signs[i - 1] ? 'x' : '=';
        }
        text[n++] = (char)('0' + c->wraps[i]);
    }
    text[n] = '\0';
    if (c->stray_wraps > 0) {
        snprintf(text + n, 40 - n, "%s(%d)", n > 0 ? " " : "", c->stray_wraps);
    }
}

static const char *fault_of_words(const judge_saying *s, const family_case *c)
{
    char text[40];
    write_notation(c, text);
    if (s->state.name != name_of(c)) {
        return "name";
    }
    if ((s->state.faults & ~(uint32_t)VBSS_KNOT_FAULT_HITCH) != faults_of(c)) {
        return "faults";
    }
    return strcmp(text, s->notation) == 0 ? NULL : "notation";
}

/* ---- the whole */

const char *judge_fault(const judge_saying *s, const family_case *c, bool tail_last)
{
    if (c->truth == FAMILY_OPEN || judge_is_uncertain(s)) {
        return NULL;
    }
    if ((s->state.name == VBSS_KNOT_NAME_OTHER) != (c->truth == FAMILY_OTHER)) {
        return "a stack of throws or not";
    }
    if (!has_numbers(&s->state, c)) {
        return "invariants";
    }
    if (c->truth == FAMILY_OTHER) {
        bool plain = s->state.throw_count == 0 && s->state.verdict == VBSS_KNOT_VERDICT_FORMED &&
                     (s->state.faults & VBSS_KNOT_FAULT_TYPE) != 0 && strcmp(s->notation, "?") == 0;
        return plain ? NULL : "what is said of another knot";
    }
    const char *fault = fault_of_stack(s, c);
    fault = fault != NULL ? fault : fault_of_places(s, c, tail_last);
    if (fault == NULL && judge_is_ordered(s)) {
        fault = fault_of_words(s, c);
    }
    bool none = s->state.verdict == VBSS_KNOT_VERDICT_NONE;
    return fault == NULL && none != (s->state.throw_count == 0) ? "verdict" : fault;
}
