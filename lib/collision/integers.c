/* Arithmetic of integers of any size. */
#include "collision/integers.h"

#include <stddef.h>

enum { LIMB_BITS = 32 };

/* Not memset: every library function counts with 4 KiB of stack (docs/reference/abi.md). */
static void clear_limbs(uint32_t *limbs, uint32_t count)
{
    for (uint32_t i = 0; i < count; i++) {
        limbs[i] = 0;
    }
}

static uint32_t *allocate_limbs(workspace *w, uint32_t count)
{
    if (w->full || count > w->capacity - w->used) {
        w->full = true;
        return NULL;
    }
    uint32_t *limbs = w->limbs + w->used;
    w->used += count;
    return limbs;
}

/* The integer in `limbs`, which must be the last allocation; frees leading zero limbs. */
static integer normalise(workspace *w, const uint32_t *limbs, uint32_t count, int32_t sign)
{
    while (count > 0 && limbs[count - 1] == 0) {
        count--;
    }
    uint32_t first = (uint32_t)(limbs - w->limbs);
    w->used = first + count;
    integer a = {(uint16_t)first, (uint16_t)count, count > 0 ? sign : 0};
    return a;
}

static const uint32_t *limbs_of(const workspace *w, integer a)
{
    return w->limbs + a.first;
}

integer vbss_integer_make(workspace *w, uint64_t magnitude, uint32_t shift, int32_t sign)
{
    uint32_t whole = shift / LIMB_BITS, rest = shift % LIMB_BITS, count = whole + 3;
    uint32_t *limbs = magnitude == 0 ? NULL : allocate_limbs(w, count);
    if (limbs == NULL) {
        return integer_zero();
    }
    clear_limbs(limbs, count);
    uint64_t low = (uint32_t)magnitude, high = magnitude >> LIMB_BITS;
    low <<= rest;
    high = (high << rest) + (low >> LIMB_BITS);
    limbs[whole] = (uint32_t)low;
    limbs[whole + 1] = (uint32_t)high;
    limbs[whole + 2] = (uint32_t)(high >> LIMB_BITS);
    return normalise(w, limbs, count, sign);
}

static int compare(const workspace *w, integer a, integer b)
{
    const uint32_t *of_a = limbs_of(w, a), *of_b = limbs_of(w, b);
    if (a.count != b.count) {
        return a.count < b.count ? -1 : 1;
    }
    for (uint32_t i = a.count; i > 0; i--) {
        if (of_a[i - 1] != of_b[i - 1]) {
            return of_a[i - 1] < of_b[i - 1] ? -1 : 1;
        }
    }
    return 0;
}

integer vbss_integer_add(workspace *w, integer a, integer b)
{
    if (a.sign == 0 || b.sign == 0) {
        return a.sign == 0 ? b : a;
    }
    int order = compare(w, a, b);
    if (order < 0) {
        integer swap = a;
        a = b;
        b = swap;
    }
    if (a.sign != b.sign && order == 0) {
        return integer_zero();
    }
    uint32_t *limbs = allocate_limbs(w, a.count + 1u);
    if (limbs == NULL) {
        return integer_zero();
    }
    const uint32_t *of_a = limbs_of(w, a), *of_b = limbs_of(w, b);
    uint64_t carry = 0;
    for (uint32_t i = 0; i < a.count; i++) {
        uint64_t here = of_a[i], other = i < b.count ? of_b[i] : 0;
        /* A borrow sets all upper bits, so the next iteration subtracts one. */
        uint64_t sum = a.sign == b.sign ? here + other + carry : here - other - carry;
        limbs[i] = (uint32_t)sum;
        carry = (sum >> LIMB_BITS) & 1u;
    }
    limbs[a.count] = a.sign == b.sign ? (uint32_t)carry : 0;
    return normalise(w, limbs, a.count + 1u, a.sign);
}

integer vbss_integer_subtract(workspace *w, integer a, integer b)
{
    return vbss_integer_add(w, a, integer_negated(b));
}

integer vbss_integer_multiply(workspace *w, integer a, integer b)
{
    if (a.sign == 0 || b.sign == 0) {
        return integer_zero();
    }
    uint32_t count = (uint32_t)a.count + b.count;
    uint32_t *limbs = allocate_limbs(w, count);
    if (limbs == NULL) {
        return integer_zero();
    }
    const uint32_t *of_a = limbs_of(w, a), *of_b = limbs_of(w, b);
    clear_limbs(limbs, count);
    for (uint32_t i = 0; i < a.count; i++) {
        uint64_t carry = 0, here = of_a[i];
        for (uint32_t k = 0; k < b.count; k++) {
            carry += here * of_b[k] + limbs[i + k];
            limbs[i + k] = (uint32_t)carry;
            carry >>= LIMB_BITS;
        }
        limbs[i + b.count] = (uint32_t)carry;
    }
    return normalise(w, limbs, count, a.sign * b.sign);
}

integer vbss_integer_shift(workspace *w, integer a, uint32_t bits)
{
    if (a.sign == 0 || bits == 0) {
        return a;
    }
    uint32_t whole = bits / LIMB_BITS, rest = bits % LIMB_BITS;
    uint32_t count = a.count + whole + 1;
    uint32_t *limbs = allocate_limbs(w, count);
    if (limbs == NULL) {
        return integer_zero();
    }
    clear_limbs(limbs, whole);
    uint64_t carry = 0;
    for (uint32_t i = 0; i < a.count; i++) {
        carry += (uint64_t)w->limbs[a.first + i] << rest;
        limbs[whole + i] = (uint32_t)carry;
        carry >>= LIMB_BITS;
    }
    limbs[whole + a.count] = (uint32_t)carry;
    return normalise(w, limbs, count, a.sign);
}

void vbss_integers_compact(workspace *w, uint32_t mark, integer *const *live, int count)
{
    uint32_t from = mark; /* limbs below the mark stay in place */
    w->used = mark;
    for (;;) {
        /* Move the lowest integer first, so that nothing is overwritten before it is read. */
        const integer *lowest = NULL;
        for (int i = 0; i < count; i++) {
            const integer *a = live[i];
            if (a->sign != 0 && a->first >= from && (lowest == NULL || a->first < lowest->first)) {
                lowest = a;
            }
        }
        if (lowest == NULL) {
            return;
        }
        uint32_t source = lowest->first, size = lowest->count;
        for (uint32_t i = 0; i < size; i++) { /* ascending order, so the ranges may overlap */
            w->limbs[w->used + i] = w->limbs[source + i];
        }
        for (int i = 0; i < count; i++) {
            if (live[i]->sign != 0 && live[i]->first == source) {
                live[i]->first = (uint16_t)w->used;
            }
        }
        w->used += size;
        from = source + 1; /* above all integers that have moved */
    }
}
