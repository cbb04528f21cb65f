/* The Kauffman bracket of a diagram by its state sum: L. H. Kauffman, "State models and the Jones
 * polynomial", Topology 26 (1987). Each crossing has two smoothings, with the factors A and 1 / A.
 * Each closed loop contributes the factor -A^2 - A^-2.
 *
 * A sweep adds one crossing after the other. Later crossings depend on the earlier ones only by the
 * pairing of the open arcs, so one sum replaces all states with the same pairing. 2 k open arcs of
 * a connected part have at most Catalan(k) planar pairings. */
#include "knot/knot.h"
#include "knot/prime_field.h"

#include <string.h>

enum { OVER_IN, OVER_OUT, UNDER_IN, UNDER_OUT };
enum { INDEX_SIZE = 4096, NO_STATE = 0xffff };
_Static_assert(2 * KNOT_BRACKET_STATES <= INDEX_SIZE, "the hash table stays half empty");

void vbss_knot_bracket_arrays(knot_bracket *b, uint32_t crossing_capacity,
                              vbss_array arrays[KNOT_BRACKET_ARRAYS])
{
    const size_t arcs = 2 * (size_t)crossing_capacity;
    b->crossing_capacity = crossing_capacity;
    arrays[0] = (vbss_array){&b->crossings, crossing_capacity, sizeof *b->crossings};
    arrays[1] = (vbss_array){&b->slots, arcs, sizeof *b->slots};
    arrays[2] = (vbss_array){&b->states, KNOT_BRACKET_STATES, sizeof *b->states};
    arrays[3] = (vbss_array){&b->next_states, KNOT_BRACKET_STATES, sizeof *b->next_states};
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
        b->slots[e] = KNOT_BRACKET_SLOTS;
    }
}

void vbss_knot_bracket_begin(knot_bracket *b, const knot_gauss_code *code,
                             const uint32_t a[KNOT_JONES_POINTS])
{
    list_crossings(b, code);
    b->swept_count = 0;
    b->is_full = false;
    b->crossing = NULL;
    memset(b->is_slot_used, 0, sizeof b->is_slot_used);
    b->state_count = 1; /* without crossings: no arc, no loop */
    b->states[0] = (knot_bracket_state){{0}, {0}};
    for (uint32_t i = 0; i < KNOT_JONES_POINTS; i++) {
        uint32_t inverse = field_inverse(a[i]);
        b->a[i] = a[i];
        b->inverse_a[i] = inverse;
        b->loop[i] =
            field_negative(field_add(field_multiply(a[i], a[i]), field_multiply(inverse, inverse)));
        b->states[0].value[i] = 1;
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
            open += b->slots[c->arcs[k]] < KNOT_BRACKET_SLOTS ? 1 : 0;
        }
        if (!c->is_swept && (next == NULL || open > max_open)) {
            next = c;
            max_open = open;
        }
    }
    return next;
}

static uint8_t take_slot(knot_bracket *b)
{
    uint32_t slot = 0;
    while (slot < KNOT_BRACKET_SLOTS && b->is_slot_used[slot]) {
        slot++;
    }
    if (slot < KNOT_BRACKET_SLOTS) {
        b->is_slot_used[slot] = true;
    }
    return (uint8_t)slot;
}

/* Returns false if there are not enough slots. */
static bool open_arcs(knot_bracket *b, const knot_bracket_crossing *c, knot_bracket_addition *add)
{
    for (uint32_t i = 0; i < KNOT_CROSSING_ARCS; i++) {
        uint8_t *slot = &b->slots[c->arcs[i]];
        add->opens[i] = *slot == KNOT_BRACKET_SLOTS;
        if (add->opens[i]) {
            *slot = take_slot(b);
        }
        add->slots[i] = *slot;
        if (*slot == KNOT_BRACKET_SLOTS) {
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
            b->is_slot_used[add->slots[i]] = false;
            b->slots[c->arcs[i]] = KNOT_BRACKET_SLOTS;
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

/* ---- states */

static uint32_t hash_of(const uint8_t mate[KNOT_BRACKET_SLOTS])
{
    uint32_t hash = 0;
    for (uint32_t i = 0; i < KNOT_BRACKET_SLOTS; i++) {
        hash = hash * 31 + mate[i];
    }
    return (hash * 2654435769u) >> 20; /* 12 bits */
}
_Static_assert(INDEX_SIZE == 1 << 12, "as many bits as a hash has");

static void add_state(knot_bracket *b, const knot_bracket_state *s)
{
    uint32_t at = hash_of(s->mate);
    while (b->index[at] != NO_STATE) {
        knot_bracket_state *same = &b->next_states[b->index[at]];
        if (memcmp(same->mate, s->mate, sizeof s->mate) == 0) {
            for (uint32_t i = 0; i < KNOT_JONES_POINTS; i++) {
                same->value[i] = field_add(same->value[i], s->value[i]);
            }
            return;
        }
        at = (at + 1) % INDEX_SIZE;
    }
    if (b->state_count == KNOT_BRACKET_STATES) {
        b->is_full = true;
        return;
    }
    b->index[at] = (uint16_t)b->state_count;
    b->next_states[b->state_count++] = *s;
}

/* Joins two arcs. Returns 1 if that closes a loop. An arc that has just opened is its own mate. */
static uint32_t join(uint8_t mate[KNOT_BRACKET_SLOTS], uint8_t p, uint8_t q)
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
                          knot_bracket_state s)
{
    const uint8_t *slots = add->slots;
    for (uint32_t i = 0; i < KNOT_CROSSING_ARCS; i++) {
        if (add->opens[i]) {
            s.mate[slots[i]] = slots[i];
        }
    }
    uint32_t loops = smoothing == 0 ? join(s.mate, slots[OVER_IN], slots[UNDER_OUT]) +
                                          join(s.mate, slots[UNDER_IN], slots[OVER_OUT])
                                    : join(s.mate, slots[OVER_IN], slots[UNDER_IN]) +
                                          join(s.mate, slots[OVER_OUT], slots[UNDER_OUT]);
    for (uint32_t i = 0; i < KNOT_CROSSING_ARCS; i++) {
        if (add->closes[i]) {
            s.mate[slots[i]] = 0;
        }
    }
    for (uint32_t i = 0; i < KNOT_JONES_POINTS; i++) {
        s.value[i] = field_multiply(s.value[i], add->factors[smoothing][loops][i]);
    }
    add_state(b, &s);
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
    b->old_count = b->state_count;
    b->state_count = b->cursor = 0;
}

static void end_crossing(knot_bracket *b)
{
    close_arcs(b, b->crossing, &b->addition);
    knot_bracket_state *swap = b->states;
    b->states = b->next_states;
    b->next_states = swap;
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
                add_smoothing(b, &b->addition, s, b->states[b->cursor]);
            }
            b->cursor++;
        }
    }
    return b->swept_count == b->crossing_count || b->is_full;
}
