#include "knot/sum_diagram.h"

#include <string.h>

#include "harness/harness.h"

void sum_begin(sum_diagram *d)
{
    memset(d, 0, sizeof *d);
    d->code = (knot_gauss_code){.capacity = SUM_CROSSINGS,
                                .crossing = d->crossing,
                                .over = d->over,
                                .sign = d->sign,
                                .scratch = d->scratch};
}

void sum_insert(sum_diagram *d, uint32_t at, uint32_t wraps, int handedness, bool over)
{
    const size_t m = 2 * (size_t)wraps + 1, n = d->code.n, behind = 2 * n - at;
    assert_true(n + m <= SUM_CROSSINGS);
    memmove(d->crossing + at + 2 * m, d->crossing + at, behind * sizeof *d->crossing);
    memmove(d->over + at + 2 * m, d->over + at, behind * sizeof *d->over);
    memmove(d->owner + at + 2 * m, d->owner + at, behind * sizeof *d->owner);
    for (size_t i = 0; i < 2 * m; i++) {
        d->crossing[at + i] = (uint16_t)(n + i % m);
        d->over[at + i] = over != (i % 2 == 1);
        d->owner[at + i] = d->blocks;
    }
    memset(d->sign + n, handedness, m);
    d->code.n += (uint32_t)m;
    if (d->wanted.count < KNOT_THROWS) {
        d->wanted.factors[d->wanted.count++] =
            (knot_factor){.wraps = (int32_t)wraps, .handedness = handedness};
    }
    d->blocks++;
}

void sum_swap(sum_diagram *d, uint32_t i, uint32_t j)
{
    uint16_t crossing = d->crossing[i];
    uint8_t over = d->over[i];
    uint32_t owner = d->owner[i];
    d->crossing[i] = d->crossing[j];
    d->crossing[j] = crossing;
    d->over[i] = d->over[j];
    d->over[j] = over;
    d->owner[i] = d->owner[j];
    d->owner[j] = owner;
}

void sum_shift(sum_diagram *d, uint32_t by)
{
    for (uint32_t k = 0; k < by; k++) {
        for (uint32_t i = 1; i < 2 * d->code.n; i++) {
            sum_swap(d, i - 1, i);
        }
    }
}

void sum_stack(sum_diagram *d, uint32_t count, const uint32_t *wraps, const int *signs)
{
    sum_begin(d);
    for (uint32_t i = 0; i < count; i++) {
        sum_insert(d, d->code.n, wraps[i], signs[i], i % 2 == 0);
    }
}

void sum_from_word(sum_diagram *d, uint32_t n, const int *word, const int8_t *signs)
{
    sum_begin(d);
    d->code.n = n;
    memcpy(d->sign, signs, n);
    for (uint32_t i = 0; i < 2 * n; i++) {
        d->crossing[i] = (uint16_t)((word[i] < 0 ? -word[i] : word[i]) - 1);
        d->over[i] = word[i] > 0;
    }
}

/* ---- by definition */

static bool is_closed(const sum_diagram *d, const uint32_t *live, uint32_t from, uint32_t to)
{
    uint32_t seen[SUM_CROSSINGS] = {0}, pairs = 0;
    for (uint32_t i = from; i < to; i++) {
        pairs += ++seen[d->crossing[live[i]]] == 2;
    }
    return 2 * pairs == to - from;
}

static bool is_standard(const sum_diagram *d, const uint32_t *live, uint32_t length)
{
    uint32_t m = length / 2;
    bool good = length % 2 == 0 && m % 2 == 1 && m >= 3;
    for (uint32_t i = 0; i < length && good; i++) {
        uint32_t entry = live[i], next = live[(i + 1) % length];
        good = d->crossing[entry] == d->crossing[live[(i + m) % length]] &&
               d->over[entry] != d->over[next] &&
               d->sign[d->crossing[entry]] == d->sign[d->crossing[next]];
    }
    return good;
}

bool sum_comes_apart(const sum_diagram *d)
{
    uint32_t live[2 * SUM_CROSSINGS] = {0}, count = 2 * d->code.n, blocks = 0;
    for (uint32_t i = 0; i < count; i++) {
        live[i] = i;
    }
    while (count > 0) {
        uint32_t from = 0, length = 2;
        while (!is_closed(d, live, from, from + length)) {
            from = from + length < count ? from + 1 : 0;
            length += from == 0 ? 2 : 0;
            if (length > count) {
                return false;
            }
        }
        if (!is_standard(d, live + from, length) || ++blocks > KNOT_THROWS) {
            return false;
        }
        count -= length;
        memmove(live + from, live + from + length, (count - from) * sizeof *live);
    }
    return true;
}

bool sum_is_nest(const sum_diagram *d)
{
    uint32_t entries = 2 * d->code.n;
    bool nest = true;
    for (uint32_t i = 0; i < entries / 2; i++) {
        nest = nest && d->owner[i] == d->owner[entries - 1 - i];
        for (uint32_t j = 0; j < i; j++) {
            nest = nest && (d->owner[j] != d->owner[i] || d->owner[i - 1] == d->owner[i]);
        }
    }
    return nest;
}
