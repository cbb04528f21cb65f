/* Gauss codes: planarity, and simplification by Reidemeister moves I and II. */
#include "knot/knot.h"

#include <string.h>

enum { NO_ENTRY = 0xffff };

void vbss_knot_gauss_code_arrays(knot_gauss_code *code, uint32_t capacity,
                                 vbss_array arrays[KNOT_GAUSS_CODE_ARRAYS])
{
    code->capacity = capacity;
    arrays[0] = (vbss_array){&code->crossing, 2 * (size_t)capacity, sizeof *code->crossing};
    arrays[1] = (vbss_array){&code->over, 2 * (size_t)capacity, sizeof *code->over};
    arrays[2] = (vbss_array){&code->position, 2 * (size_t)capacity, sizeof *code->position};
    arrays[3] = (vbss_array){&code->sign, capacity, sizeof *code->sign};
    arrays[4] = (vbss_array){&code->scratch, 4 * (size_t)capacity, sizeof *code->scratch};
}

void vbss_knot_gauss_code_copy(knot_gauss_code *to, const knot_gauss_code *from)
{
    size_t entries = 2 * (size_t)from->n;
    to->n = from->n;
    memcpy(to->crossing, from->crossing, entries * sizeof *to->crossing);
    memcpy(to->over, from->over, entries * sizeof *to->over);
    memcpy(to->position, from->position, entries * sizeof *to->position);
    memcpy(to->sign, from->sign, from->n * sizeof *to->sign);
}

/* Finds the other entry of each entry's crossing. Returns false unless every crossing has two
 * entries, one over and one under. */
static bool find_mates(const knot_gauss_code *code, uint16_t *mate, uint16_t *first)
{
    for (uint32_t c = 0; c < code->n; c++) {
        first[c] = NO_ENTRY;
    }
    for (uint32_t e = 0; e < 2 * code->n; e++) {
        uint32_t c = code->crossing[e];
        mate[e] = NO_ENTRY;
        if (c >= code->n) {
            return false;
        }
        if (first[c] == NO_ENTRY) {
            first[c] = (uint16_t)e;
            continue;
        }
        uint32_t other = first[c];
        if (mate[other] != NO_ENTRY || code->over[e] == code->over[other]) {
            return false;
        }
        mate[e] = (uint16_t)other;
        mate[other] = (uint16_t)e;
    }
    return true; /* n pairs in 2 n entries */
}

/* ---- planarity: Euler's formula for one closed curve */

enum { FORWARD = 1, BACKWARD = 2 };

/* Traces a face on the left, starting on the arc after entry e. */
static void trace_face(const knot_gauss_code *code, const uint16_t *mate, uint16_t *seen,
                       uint32_t e, uint32_t direction)
{
    uint32_t last = 2 * code->n - 1;
    while ((seen[e] & direction) == 0) {
        seen[e] |= (uint16_t)direction;
        uint32_t here = direction == BACKWARD ? e : e == last ? 0 : e + 1;
        /* Seen along the curve, the other strand crosses from right to left. */
        bool leftward = (code->over[here] != 0) == (code->sign[code->crossing[here]] > 0);
        uint32_t other = mate[here];
        bool onward = leftward == (direction == FORWARD);
        e = onward ? other : other == 0 ? last : other - 1;
        direction = onward ? FORWARD : BACKWARD;
    }
}

bool vbss_knot_gauss_code_is_planar(const knot_gauss_code *code)
{
    uint16_t *mate = code->scratch, *seen = code->scratch + 2 * (size_t)code->n;
    if (code->n == 0) {
        return true;
    }
    if (!find_mates(code, mate, seen)) {
        return false;
    }
    memset(seen, 0, 2 * (size_t)code->n * sizeof *seen);
    uint32_t faces = 0;
    for (uint32_t e = 0; e < 2 * code->n; e++) {
        for (uint32_t direction = FORWARD; direction <= BACKWARD; direction++) {
            faces += (seen[e] & direction) == 0 ? 1 : 0;
            trace_face(code, mate, seen, e, direction);
        }
    }
    return faces == code->n + 2;
}

/* ---- moves I and II on a ring of linked entries
 *
 * Meanwhile `crossing` holds mates and `over` holds flags. Entries to be tested again are on a
 * stack, which is stored in the links of removed entries; every move frees more of them than it
 * pushes. */

enum { OVER = 1, POSITIVE = 2, GONE = 4 };

typedef struct knot_ring {
    uint16_t *mate, *next, *previous;
    uint8_t *flags;
    uint32_t left; /* number of entries left */
    /* a removed entry: its `next` is the one below, its `previous` the entry to test */
    uint32_t stack;
} knot_ring;

static knot_ring ring_of(knot_gauss_code *code)
{
    uint32_t count = 2 * code->n;
    knot_ring r = {code->crossing, code->scratch, code->scratch + count,
                   code->over,     count,         NO_ENTRY};
    uint16_t *first = code->scratch;
    for (uint32_t c = 0; c < code->n; c++) {
        first[c] = NO_ENTRY;
    }
    for (uint32_t e = 0; e < count; e++) {
        uint32_t c = code->crossing[e], other = first[c];
        r.flags[e] =
            (uint8_t)((code->over[e] != 0 ? OVER : 0) | (code->sign[c] > 0 ? POSITIVE : 0));
        if (other == NO_ENTRY) {
            first[c] = (uint16_t)e;
        } else {
            r.mate[e] = (uint16_t)other;
            r.mate[other] = (uint16_t)e;
        }
    }
    for (uint32_t e = 0; e < count; e++) {
        r.next[e] = (uint16_t)(e + 1 == count ? 0 : e + 1);
        r.previous[e] = (uint16_t)(e == 0 ? count - 1 : e - 1);
    }
    return r;
}

/* Unlinks two successive entries. Returns the entry before them. */
static uint32_t unlink_two(knot_ring *r, uint32_t first, uint32_t second)
{
    uint32_t before = r->previous[first], behind = r->next[second];
    r->next[before] = (uint16_t)behind;
    r->previous[behind] = (uint16_t)before;
    r->flags[first] |= GONE;
    r->flags[second] |= GONE;
    r->left -= 2;
    return before;
}

static void push_entry(knot_ring *r, uint32_t at, uint32_t freed)
{
    r->next[freed] = (uint16_t)r->stack;
    r->previous[freed] = (uint16_t)at;
    r->stack = freed;
}

/* Applies a move to entry e and the next one, if possible. */
static bool apply_move(knot_ring *r, uint32_t e)
{
    uint32_t next = r->next[e], mate = r->mate[e], mate_of_next = r->mate[next];
    if (next == mate) { /* move I: a loop */
        push_entry(r, unlink_two(r, e, next), e);
        return true;
    }
    bool same_direction = r->next[mate] == mate_of_next,
         opposite_direction = r->next[mate_of_next] == mate;
    if (!(same_direction || opposite_direction) ||
        ((r->flags[e] ^ r->flags[next]) & (OVER | POSITIVE)) != POSITIVE) {
        return false;
    }
    /* move II: one strand passes over the other and back */
    uint32_t before = unlink_two(r, e, next);
    uint32_t first = same_direction ? mate : mate_of_next,
             second = same_direction ? mate_of_next : mate;
    uint32_t before_mates = unlink_two(r, first, second);
    push_entry(r, before, e);
    push_entry(r, before_mates, first);
    return true;
}

static void apply_moves(knot_ring *r)
{
    uint32_t count = r->left;
    for (uint32_t e = 0; e < count; e++) {
        uint32_t at = e;
        while (at != NO_ENTRY) {
            if ((r->flags[at] & GONE) == 0) {
                apply_move(r, at);
            }
            uint32_t freed = r->stack;
            at = freed == NO_ENTRY ? NO_ENTRY : r->previous[freed];
            r->stack = freed == NO_ENTRY ? NO_ENTRY : r->next[freed];
        }
    }
}

/* Turns the remaining entries into a code again, in order. The links are no longer needed: the
 * first passage of a crossing stores its number in `next` of the second. */
static void compact_code(knot_gauss_code *code, const knot_ring *r, uint32_t count)
{
    uint32_t to = 0, visited = 0;
    for (uint32_t e = 0; e < count; e++) {
        uint8_t flags = r->flags[e];
        if ((flags & GONE) != 0) {
            continue;
        }
        uint32_t mate = r->mate[e];
        if (mate > e) {
            code->sign[visited] = (flags & POSITIVE) != 0 ? 1 : -1;
            r->next[mate] = r->next[e] = (uint16_t)visited++;
        }
        code->crossing[to] = r->next[e];
        code->over[to] = (flags & OVER) != 0;
        code->position[to++] = code->position[e];
    }
    code->n = visited;
}

void vbss_knot_gauss_code_simplify(knot_gauss_code *code, knot_ops *budget)
{
    uint32_t count = 2 * code->n;
    *budget -= 4 * (knot_ops)count;
    if (count > 0) {
        knot_ring ring = ring_of(code);
        apply_moves(&ring);
        compact_code(code, &ring, count);
    }
}
