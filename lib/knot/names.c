/* Name, faults and notation of a knot. All three are the same for the mirror image. Stray throws,
 * in one limb alone, do not belong to the stack.
 *
 * If the order of the throws is unknown, the result contains only properties common to all
 * orders. */
#include "knot/knot.h"

#include <string.h>

typedef struct throw_stack {
    uint32_t count;
    bool in_order; /* or all orders give the same result */
    const vbss_knot_throw *throws[KNOT_THROWS];
} throw_stack;

/* Whether all orders give the same result: for equal throws, and for two throws with equal wraps,
 * up to mirror images. */
static bool is_order_irrelevant(const throw_stack *s)
{
    bool wraps = true, handedness = true;
    for (uint32_t i = 1; i < s->count; i++) {
        wraps = wraps && s->throws[i]->wraps == s->throws[0]->wraps;
        handedness = handedness && s->throws[i]->handedness == s->throws[0]->handedness;
    }
    return wraps && (handedness || s->count == 2);
}

static throw_stack throw_stack_of(const knot_classification *classification)
{
    throw_stack s = {.in_order = true};
    for (uint32_t i = 0; i < classification->throw_count; i++) {
        const vbss_knot_throw *one = &classification->throws[i];
        if ((one->flags & VBSS_KNOT_THROW_STRAY) == 0) {
            s.throws[s.count++] = one;
            s.in_order = s.in_order && (one->flags & VBSS_KNOT_THROW_ORDERED) != 0;
        }
    }
    s.in_order = s.in_order || is_order_irrelevant(&s);
    return s;
}

static bool same_hand(const throw_stack *s, uint32_t i)
{
    return s->throws[i]->handedness == s->throws[i - 1]->handedness;
}

/* ---- the name */

static vbss_knot_name name_of_one(int32_t wraps)
{
    switch (wraps) {
    case 1:
        return VBSS_KNOT_NAME_SINGLE;
    case 2:
        return VBSS_KNOT_NAME_DOUBLE;
    case 3:
        return VBSS_KNOT_NAME_TRIPLE;
    default:
        return VBSS_KNOT_NAME_STACK;
    }
}

static vbss_knot_name name_of_two(const throw_stack *s)
{
    if (s->throws[1]->wraps != 1) {
        return VBSS_KNOT_NAME_STACK;
    }
    switch (s->throws[0]->wraps) {
    case 1:
        return same_hand(s, 1) ? VBSS_KNOT_NAME_GRANNY : VBSS_KNOT_NAME_SQUARE;
    case 2:
        return same_hand(s, 1) ? VBSS_KNOT_NAME_SURGEONS_GRANNY : VBSS_KNOT_NAME_SURGEONS;
    default:
        return VBSS_KNOT_NAME_STACK;
    }
}

static bool is_fls(const throw_stack *s)
{
    return s->count == 3 && s->throws[0]->wraps == 2 && s->throws[1]->wraps == 1 &&
           s->throws[2]->wraps == 1 && !same_hand(s, 1) && !same_hand(s, 2);
}

vbss_knot_name vbss_knot_name_of(const knot_classification *classification)
{
    const throw_stack s = throw_stack_of(classification);
    if (classification->other) {
        return VBSS_KNOT_NAME_OTHER;
    }
    if (s.count == 0) {
        return VBSS_KNOT_NAME_NONE;
    }
    if (!s.in_order) { /* the only name that holds for all orders */
        return VBSS_KNOT_NAME_STACK;
    }
    if (s.count == 1) {
        return name_of_one(s.throws[0]->wraps);
    }
    if (s.count == 2) {
        return name_of_two(&s);
    }
    return is_fls(&s) ? VBSS_KNOT_NAME_FLS : VBSS_KNOT_NAME_STACK;
}

/* ---- faults */

static uint32_t faults_in_order(const throw_stack *s)
{
    uint32_t faults = s->count > 0 && s->throws[0]->wraps != 2 ? VBSS_KNOT_FAULT_FIRST : 0;
    for (uint32_t i = 1; i < s->count; i++) {
        faults |= s->throws[i]->wraps != 1 ? VBSS_KNOT_FAULT_LATER : 0;
        faults |= same_hand(s, i) ? VBSS_KNOT_FAULT_GRANNY : 0;
    }
    return faults;
}

/* Faults in every order: no double throw; more than one throw that is not single; hands that cannot
 * alternate. */
static uint32_t faults_in_every_order(const throw_stack *s)
{
    uint32_t double_throws = 0, not_single = 0;
    int32_t hands = 0;
    for (uint32_t i = 0; i < s->count; i++) {
        double_throws += s->throws[i]->wraps == 2;
        not_single += s->throws[i]->wraps != 1;
        hands += s->throws[i]->handedness;
    }
    uint32_t faults = VBSS_KNOT_FAULT_ORDER;
    faults |= double_throws == 0 ? VBSS_KNOT_FAULT_FIRST : 0;
    faults |= not_single > 1 ? VBSS_KNOT_FAULT_LATER : 0;
    return faults | (hands > 1 || hands < -1 ? VBSS_KNOT_FAULT_GRANNY : 0);
}

uint32_t vbss_knot_faults_of(const knot_classification *classification)
{
    const throw_stack s = throw_stack_of(classification);
    uint32_t faults =
        classification->reason != VBSS_KNOT_REASON_NONE ? VBSS_KNOT_FAULT_UNCERTAIN : 0;
    faults |= s.count < classification->throw_count ? VBSS_KNOT_FAULT_STRAY : 0;
    for (uint32_t i = 0; i < s.count; i++) {
        faults |= s.throws[i]->flags & VBSS_KNOT_THROW_HITCH ? VBSS_KNOT_FAULT_HITCH : 0;
    }
    if (classification->other) { /* without a stack there are no throws to count */
        return faults | VBSS_KNOT_FAULT_TYPE;
    }
    faults |= s.count < 3 ? VBSS_KNOT_FAULT_FEW : 0;
    faults |= s.count > 3 ? VBSS_KNOT_FAULT_MANY : 0;
    return faults | (s.in_order ? faults_in_order(&s) : faults_in_every_order(&s));
}

/* ---- notation */

/* Nothing is omitted silently: a truncated text ends in "..". */
typedef struct writer {
    char *text;
    uint32_t length, safe; /* the last length that leaves room for ".." */
    bool full;
} writer;

/* Appends a sign (0 for none) and a number (0 for none). */
static void append(writer *w, char sign, int32_t number)
{
    char piece[12];
    uint32_t count = 0;
    for (int32_t rest = number; rest > 0; rest /= 10) {
        piece[count++] = (char)('0' + rest % 10);
    }
    if (sign != 0) {
        piece[count++] = sign;
    }
    w->full = w->full || w->length + count >= KNOT_NOTATION;
    if (w->full) {
        return;
    }
    while (count > 0) {
        w->text[w->length++] = piece[--count];
    }
    w->safe = w->length + 2 < KNOT_NOTATION ? w->length : w->safe;
}

static void append_strays(writer *w, const knot_classification *classification)
{
    char sign = '(';
    for (uint32_t i = 0; i < classification->throw_count; i++) {
        if (classification->throws[i].flags & VBSS_KNOT_THROW_STRAY) {
            append(w, sign, classification->throws[i].wraps);
            sign = '+';
        }
    }
    append(w, ')', 0);
}

void vbss_knot_notation_of(const knot_classification *classification, char text[KNOT_NOTATION])
{
    static const char joints[] = {'\0', '=', 'x', '+'};
    const throw_stack s = throw_stack_of(classification);
    writer w = {.text = text};
    memset(text, 0, KNOT_NOTATION);
    if (classification->other) {
        append(&w, '?', 0);
    }
    for (uint32_t i = 0; i < s.count && !classification->other; i++) {
        uint32_t joint = 0;
        if (i > 0) {
            joint = !s.in_order ? 3 : same_hand(&s, i) ? 2 : 1;
        }
        append(&w, joints[joint], s.throws[i]->wraps);
    }
    if (s.count < classification->throw_count) {
        if (w.length > 0) {
            append(&w, ' ', 0);
        }
        append_strays(&w, classification);
    }
    if (w.full) {
        memset(text + w.safe, 0, KNOT_NOTATION - w.safe);
        text[w.safe] = text[w.safe + 1] = '.';
    }
}
