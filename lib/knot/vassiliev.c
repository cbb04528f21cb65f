/* Vassiliev invariants of degree 2 and 3 as sums over subdiagrams of the Gauss diagram (M. Polyak
 * and O. Viro, "Gauss diagram formulas for Vassiliev invariants", International Mathematics
 * Research Notices 1994 (11)). A crossing is an arrow from its over entry to its under entry; each
 * subdiagram counts with the product of its signs.
 *
 * v2: two arrows p and x in the order x under, p over, x over, p under, from entry 0 on.
 * v3: three arrows, independent of the start on the circle. Starting at x under, the circle
 * consists of the part up to x over, and the rest. p leads from the part to the rest, q from the
 * rest to the part, and p over precedes q under. If q over precedes p under, the subdiagram counts
 * half. Otherwise it counts whole, but is found from each of its three arrows. So six times v3 is
 * the sum of 3 for the former and 2 for the latter. */
#include "knot/knot.h"

typedef struct gauss_diagram {
    const knot_gauss_code *code;
    uint32_t entries;
    uint16_t *mate;  /* entry -> the other entry of its crossing */
    uint16_t *under; /* arrows p so far: distance of their under entry from that of x */
    int16_t *sign;   /* and their signs */
} gauss_diagram;

typedef struct sums {
    int64_t twos, sixths; /* v2, and six times v3 */
    uint64_t steps;
} sums;

static void find_mates(gauss_diagram *c)
{
    uint16_t *first = c->under;
    for (uint32_t i = 0; i < c->code->n; i++) {
        first[i] = UINT16_MAX;
    }
    for (uint32_t e = 0; e < c->entries; e++) {
        uint16_t *met = &first[c->code->crossing[e]];
        if (*met == UINT16_MAX) {
            *met = (uint16_t)e;
        } else {
            c->mate[e] = *met;
            c->mate[*met] = (uint16_t)e;
        }
    }
}

/* Distance along the circle from one entry to another. */
static uint32_t distance(const gauss_diagram *c, uint32_t from, uint32_t to)
{
    return to >= from ? to - from : to + c->entries - from;
}

/* Sum over the arrows p so far, for a q over at this distance. */
static int32_t subdiagram_sum(const gauss_diagram *c, uint32_t count, uint32_t q_over)
{
    int32_t sum = 0;
    for (uint32_t i = 0; i < count; i++) {
        sum += c->under[i] < q_over ? 2 * c->sign[i] : 3 * c->sign[i];
    }
    return sum;
}

/* Adds all subdiagrams whose arrow x has its under entry at `start`. */
static void add_subdiagrams(const gauss_diagram *c, uint32_t start, sums *all)
{
    const knot_gauss_code *code = c->code;
    uint32_t length = distance(c, start, c->mate[start]), to_end = c->entries - start, count = 0;
    int64_t twos = 0, sixths = 0;
    for (uint32_t i = 1, e = start + 1; i < length; i++, e++) {
        e = e == c->entries ? 0 : e;
        uint32_t far = distance(c, start, c->mate[e]);
        int8_t sign = code->sign[code->crossing[e]];
        if (far < length) {
            continue;
        }
        if (code->over[e] != 0) {
            c->under[count] = (uint16_t)far;
            c->sign[count] = (int16_t)sign;
            count++;
            twos += far < to_end ? sign : 0;
        } else {
            sixths += (int64_t)sign * subdiagram_sum(c, count, far);
            all->steps += count / 4;
        }
    }
    int8_t sign = code->sign[code->crossing[start]];
    all->twos += twos * sign;
    all->sixths += sixths * sign;
    all->steps += 3 * (uint64_t)length;
}

void vbss_knot_vassiliev(const knot_gauss_code *code, int64_t *v2, int64_t *v3, knot_ops *budget)
{
    uint32_t n = code->n;
    gauss_diagram c = {code, 2 * n, code->scratch, code->scratch + 2 * (size_t)n,
                       (int16_t *)code->scratch + 3 * (size_t)n};
    sums all = {0, 0, 0};
    find_mates(&c);
    for (uint32_t e = 0; e < c.entries; e++) {
        if (code->over[e] == 0) {
            add_subdiagrams(&c, e, &all);
        }
    }
    *v2 = all.twos;
    *v3 = all.sixths / 6;
    *budget -= 50 + 10 * (knot_ops)n + (knot_ops)all.steps;
}
