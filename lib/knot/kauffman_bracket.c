/* The Kauffman bracket of a diagram by its state sum: L. H. Kauffman, "State models and the Jones
 * polynomial", Topology 26 (1987). Each crossing has two smoothings, with the factors A and 1 / A.
 * Each closed loop contributes the factor -A^2 - A^-2.
 *
 * A sweep adds one crossing after the other. An arc is open if only one of its ends is at a swept
 * crossing. Later crossings depend on the swept ones only by the pairing of the open arcs, so one
 * sum replaces all states with the same pairing. The number of pairings is limited, not the number
 * of crossings: 2 k open arcs in one face of the swept part have at most Catalan(k) pairings. */
#include "knot/knot.h"
#include "knot/prime_field.h"

#include <string.h>

enum { OVER_IN, OVER_OUT, UNDER_IN, UNDER_OUT };
enum { INDEX_SIZE = 4096, NO_PAIRING = 0xffff };
_Static_assert(2 * KNOT_BRACKET_PAIRINGS <= INDEX_SIZE, "the hash table stays half empty");

void vbss_knot_bracket_arrays(knot_bracket *b, uint32_t crossing_capacity,
                              vbss_array arrays[KNOT_BRACKET_ARRAYS])
{
    const size_t arcs = 2 * (size_t)crossing_capacity;
    b->crossing_capacity = crossing_capacity;
    arrays[0] = (vbss_array){&b->crossings, crossing_capacity, sizeof *b->crossings};
    arrays[1] = (vbss_array){&b->ends, arcs, sizeof *b->ends};
    arrays[2] = (vbss_array){&b->pairings, KNOT_BRACKET_PAIRINGS, sizeof *b->pairings};
    arrays[3] = (vbss_array){&b->next_pairings, KNOT_BRACKET_PAIRINGS, sizeof *b->next_pairings};
    arrays[4] = (vbss_array){&b->index, INDEX_SIZE, sizeof *b->index};
}

/* Arc e leads from entry e of the code to the next entry. */
static void list_crossings(knot_bracket *b, const knot_gauss_code *code)
{
    const uint32_t entries = 2 * code->n;
    b->crossing_count = code->n;
    for (uint32_t e = 0; e < entries; e++) {
        knot_bracket_crossing *c = &b->crossings[code->crossing[e]];
        uint32_t in = code->over[e] != 0 ? OVER_IN : UNDER_IN;
        c->arcs[in] = (uint16_t)((e == 0 ? entries : e) - 1);
        c->arcs[in + 1] = (uint16_t)e;
        c->sign = code->sign[code->crossing[e]];
        c->is_swept = false;
        b->ends[e] = KNOT_BRACKET_ENDS;
    }
}

void vbss_knot_bracket_begin(knot_bracket *b, const knot_gauss_code *code,
                             const uint32_t a[KNOT_JONES_POINTS])
{
    list_crossings(b, code);
    b->swept_count = 0;
    b->is_full = false;
    b->crossing = NULL;
    memset(b->is_end_used, 0, sizeof b->is_end_used);
    b->pairing_count = 1; /* without crossings: no arc, no loop */
    b->pairings[0] = (knot_bracket_pairing){{0}, {0}};
    for (uint32_t i = 0; i < KNOT_JONES_POINTS; i++) {
        uint32_t inverse = field_inverse(a[i]);
        b->a[i] = a[i];
        b->inverse_a[i] = inverse;
        b->loop[i] =
            field_negative(field_add(field_multiply(a[i], a[i]), field_multiply(inverse, inverse)));
        b->pairings[0].value[i] = 1;
    }
}

/* ---- the next crossing */

/* The crossing with the most open arcs comes next, which keeps the number of open arcs small. */
static knot_bracket_crossing *next_crossing(const knot_bracket *b)
{
    knot_bracket_crossing *next = NULL;
    uint32_t max_open = 0;
    for (uint32_t i = 0; i < b->crossing_count; i++) {
        knot_bracket_crossing *c = &b->crossings[i];
        uint32_t open = 0;
        for (uint32_t k = 0; k < KNOT_CROSSING_ARCS && !c->is_swept; k++) {
            open += b->ends[c->arcs[k]] < KNOT_BRACKET_ENDS ? 1 : 0;
        }
        if (!c->is_swept && (next == NULL || open > max_open)) {
            next = c;
            max_open = open;
        }
    }
    return next;
}

static uint8_t take_end(knot_bracket *b)
{
    uint32_t end = 0;
    while (end < KNOT_BRACKET_ENDS && b->is_end_used[end]) {
        end++;
    }
    if (end < KNOT_BRACKET_ENDS) {
        b->is_end_used[end] = true;
    }
    return (uint8_t)end;
}

/* Returns false if too many arcs are open. */
static bool open_arcs(knot_bracket *b, const knot_bracket_crossing *c, knot_bracket_addition *add)
{
    for (uint32_t i = 0; i < KNOT_CROSSING_ARCS; i++) {
        uint8_t *end = &b->ends[c->arcs[i]];
        add->opens[i] = *end == KNOT_BRACKET_ENDS;
        if (add->opens[i]) {
            *end = take_end(b);
        }
        add->ends[i] = *end;
        if (*end == KNOT_BRACKET_ENDS) {
            return false;
        }
    }
    for (uint32_t i = 0; i < KNOT_CROSSING_ARCS; i++) {
        bool is_loop = false; /* both ends of the arc are here */
        for (uint32_t k = 0; k < KNOT_CROSSING_ARCS; k++) {
            is_loop = is_loop || (k != i && c->arcs[k] == c->arcs[i]);
        }
        add->closes[i] = !add->opens[i] || is_loop;
    }
    return true;
}

static void close_arcs(knot_bracket *b, const knot_bracket_crossing *c,
                       const knot_bracket_addition *add)
{
    for (uint32_t i = 0; i < KNOT_CROSSING_ARCS; i++) {
        if (add->closes[i]) {
            b->is_end_used[add->ends[i]] = false;
            b->ends[c->arcs[i]] = KNOT_BRACKET_ENDS;
        }
    }
}

/* Smoothing 0 follows the direction of the curve; its factor is A at a right-handed crossing. */
static void set_factors(const knot_bracket *b, int8_t sign, knot_bracket_addition *add)
{
    for (uint32_t i = 0; i < KNOT_JONES_POINTS; i++) {
        add->factors[0][0][i] = sign > 0 ? b->a[i] : b->inverse_a[i];
        add->factors[1][0][i] = sign > 0 ? b->inverse_a[i] : b->a[i];
        for (uint32_t s = 0; s < KNOT_SMOOTHINGS; s++) {
            for (uint32_t loops = 1; loops < KNOT_SMOOTHING_LOOPS; loops++) {
                add->factors[s][loops][i] =
                    field_multiply(add->factors[s][loops - 1][i], b->loop[i]);
            }
        }
    }
}

/* ---- pairings */

static uint32_t hash_of(const uint8_t mate[KNOT_BRACKET_ENDS])
{
    uint32_t hash = 0;
    for (uint32_t i = 0; i < KNOT_BRACKET_ENDS; i++) {
        hash = hash * 31 + mate[i];
    }
    return (hash * 2654435769u) >> 20; /* 12 bits */
}
_Static_assert(INDEX_SIZE == 1 << 12, "as many bits as a hash has");

static void add_pairing(knot_bracket *b, const knot_bracket_pairing *s)
{
    uint32_t at = hash_of(s->mate);
    while (b->index[at] != NO_PAIRING) {
        knot_bracket_pairing *same = &b->next_pairings[b->index[at]];
        if (memcmp(same->mate, s->mate, sizeof s->mate) == 0) {
            for (uint32_t i = 0; i < KNOT_JONES_POINTS; i++) {
                same->value[i] = field_add(same->value[i], s->value[i]);
            }
            return;
        }
        at = (at + 1) % INDEX_SIZE;
    }
    if (b->pairing_count == KNOT_BRACKET_PAIRINGS) {
        b->is_full = true;
        return;
    }
    b->index[at] = (uint16_t)b->pairing_count;
    b->next_pairings[b->pairing_count++] = *s;
}

/* Joins two arcs. Returns 1 if that closes a loop. An arc that has just opened is its own mate. */
static uint32_t join(uint8_t mate[KNOT_BRACKET_ENDS], uint8_t p, uint8_t q)
{
    uint8_t far_p = mate[p], far_q = mate[q];
    if (far_p == q) {
        return 1;
    }
    mate[far_p] = far_q;
    mate[far_q] = far_p;
    return 0;
}

static void add_smoothing(knot_bracket *b, const knot_bracket_addition *add, uint32_t smoothing,
                          knot_bracket_pairing s)
{
    const uint8_t *ends = add->ends;
    for (uint32_t i = 0; i < KNOT_CROSSING_ARCS; i++) {
        if (add->opens[i]) {
            s.mate[ends[i]] = ends[i];
        }
    }
    uint32_t loops = smoothing == 0 ? join(s.mate, ends[OVER_IN], ends[UNDER_OUT]) +
                                          join(s.mate, ends[UNDER_IN], ends[OVER_OUT])
                                    : join(s.mate, ends[OVER_IN], ends[UNDER_IN]) +
                                          join(s.mate, ends[OVER_OUT], ends[UNDER_OUT]);
    for (uint32_t i = 0; i < KNOT_CROSSING_ARCS; i++) {
        if (add->closes[i]) {
            s.mate[ends[i]] = 0;
        }
    }
    for (uint32_t i = 0; i < KNOT_JONES_POINTS; i++) {
        s.value[i] = field_multiply(s.value[i], add->factors[smoothing][loops][i]);
    }
    add_pairing(b, &s);
}

/* ---- the sweep */

static void begin_crossing(knot_bracket *b)
{
    knot_bracket_crossing *c = next_crossing(b);
    c->is_swept = true;
    b->crossing = c;
    b->is_full = !open_arcs(b, c, &b->addition);
    set_factors(b, c->sign, &b->addition);
    memset(b->index, 0xff, INDEX_SIZE * sizeof *b->index);
    b->old_count = b->pairing_count;
    b->pairing_count = b->cursor = 0;
}

static void end_crossing(knot_bracket *b)
{
    close_arcs(b, b->crossing, &b->addition);
    knot_bracket_pairing *swap = b->pairings;
    b->pairings = b->next_pairings;
    b->next_pairings = swap;
    b->crossing = NULL;
    b->swept_count++;
}

bool vbss_knot_bracket_resume(knot_bracket *b, knot_ops *budget)
{
    while (*budget > 0 && b->swept_count < b->crossing_count && !b->is_full) {
        if (b->crossing == NULL) {
            *budget -= 100 + (knot_ops)b->crossing_count;
            begin_crossing(b);
        } else if (b->cursor == b->old_count) {
            *budget -= 10;
            end_crossing(b);
        } else {
            *budget -= 50;
            for (uint32_t s = 0; s < KNOT_SMOOTHINGS; s++) {
                add_smoothing(b, &b->addition, s, b->pairings[b->cursor]);
            }
            b->cursor++;
        }
    }
    return b->swept_count == b->crossing_count || b->is_full;
}
