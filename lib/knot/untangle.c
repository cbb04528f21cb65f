/* Pass moves: a strand that passes over (or under) everything it meets is rerouted where it meets
 * less.
 *
 * Such a strand, from the passage before it to the one after it, may lie anywhere above the rest of
 * the diagram. Without it, the faces beside it merge into one, and the shortest path from face to
 * face is its best position. One such move covers Reidemeister's moves I and II, loops with strands
 * on them, and all sequences of moves III that lead to one of these. */
#include "knot/knot.h"

enum { NONE = 0xffff, GONE = 0xfffe };

/* Side 2 e is the left of the arc from entry e to the next, side 2 e + 1 its right. */
typedef struct knot_pass_move {
    const knot_gauss_code *from; /* a copy of the code, which is rewritten if a move succeeds */
    uint32_t entries, faces;
    uint16_t *mate, *face; /* entry -> mate; side -> face */
    uint16_t *root;        /* face -> first of the faces that merge without the strand */
    uint16_t *distance;    /* face -> number of strands between it and the start of the strand */
    uint16_t *parent_side; /* face -> side from which it was reached */
    uint32_t first, count; /* entries of the strand */
} knot_pass_move;

static uint32_t after(const knot_pass_move *p, uint32_t entry)
{
    return entry + 1 == p->entries ? 0 : entry + 1;
}

static uint32_t before(const knot_pass_move *p, uint32_t entry)
{
    return (entry == 0 ? p->entries : entry) - 1;
}

static uint32_t left_of(const knot_pass_move *p, uint32_t arc)
{
    return p->face[2 * (size_t)arc];
}

static uint32_t right_of(const knot_pass_move *p, uint32_t arc)
{
    return p->face[2 * (size_t)arc + 1];
}

/* ---- faces */

static void find_mates(knot_pass_move *p)
{
    uint16_t *first = p->root;
    for (uint32_t c = 0; c < p->from->n; c++) {
        first[c] = NONE;
    }
    for (uint32_t e = 0; e < p->entries; e++) {
        uint32_t c = p->from->crossing[e], other = first[c];
        if (other == NONE) {
            first[c] = (uint16_t)e;
        } else {
            p->mate[e] = (uint16_t)other;
            p->mate[other] = (uint16_t)e;
        }
    }
}

/* Next side of a face that is kept on the left. */
static uint32_t next_side(const knot_pass_move *p, uint32_t side)
{
    bool along = side % 2 == 0;
    uint32_t here = along ? after(p, side / 2) : side / 2, mate = p->mate[here];
    bool leftward = (p->from->over[here] != 0) == (p->from->sign[p->from->crossing[here]] > 0);
    return leftward == along ? 2 * mate : 2 * before(p, mate) + 1;
}

static void find_faces(knot_pass_move *p)
{
    find_mates(p);
    for (uint32_t side = 0; side < 2 * p->entries; side++) {
        p->face[side] = NONE;
    }
    p->faces = 0;
    for (uint32_t first_side = 0; first_side < 2 * p->entries; first_side++) {
        if (p->face[first_side] == NONE) {
            for (uint32_t side = first_side; p->face[side] == NONE; side = next_side(p, side)) {
                p->face[side] = (uint16_t)p->faces;
            }
            p->faces++;
        }
    }
}

/* ---- shortest path */

static uint32_t root_of(const knot_pass_move *p, uint32_t face)
{
    while (p->root[face] != face) {
        face = p->root[face];
    }
    return face;
}

/* Merges the faces on both sides of the strand's arcs. */
static void merge_faces_along_strand(knot_pass_move *p)
{
    for (uint32_t f = 0; f < p->faces; f++) {
        p->root[f] = (uint16_t)f;
        p->distance[f] = NONE;
    }
    uint32_t arc = before(p, p->first);
    for (uint32_t i = 0; i <= p->count; i++, arc = after(p, arc)) {
        uint32_t left = root_of(p, left_of(p, arc)), right = root_of(p, right_of(p, arc));
        p->root[left > right ? left : right] = (uint16_t)(left > right ? right : left);
    }
    for (uint32_t f = 0; f < p->faces; f++) {
        p->root[f] = p->root[p->root[f]]; /* roots come first */
    }
}

static bool visit_neighbour(knot_pass_move *p, uint32_t side, uint32_t distance)
{
    uint32_t here = p->root[p->face[side]], there = p->root[p->face[side ^ 1u]];
    if (p->distance[here] != distance || p->distance[there] != NONE) {
        return false;
    }
    p->distance[there] = (uint16_t)(distance + 1);
    p->parent_side[there] = (uint16_t)side;
    return true;
}

/* Number of strands that the path crosses; `count` if no path is shorter. */
static uint32_t find_shortest_path(knot_pass_move *p, knot_ops *budget)
{
    uint32_t first_arc = before(p, p->first), behind = (p->first + p->count) % p->entries;
    uint32_t end = p->root[left_of(p, before(p, behind))];
    p->distance[p->root[left_of(p, first_arc)]] = 0;
    bool reached = true;
    for (uint32_t d = 0; p->distance[end] == NONE && reached && d + 1 < p->count; d++) {
        reached = false;
        /* all arcs except those of the strand */
        for (uint32_t arc = behind; arc != first_arc; arc = after(p, arc)) {
            reached |= visit_neighbour(p, 2 * arc, d) || visit_neighbour(p, 2 * arc + 1, d);
        }
        *budget -= 3 * (knot_ops)p->entries;
    }
    return p->distance[end] < p->count ? p->distance[end] : p->count;
}

/* ---- the code with the rerouted strand */

typedef struct knot_writer {
    const knot_pass_move *p;
    knot_gauss_code *to;
    uint16_t *number;  /* old crossing, then new crossing -> its number in the new code */
    uint16_t *crossed; /* arc -> 1 + the new crossing on it, or 0 */
    uint16_t *sides;   /* new crossing -> side from which the strand reaches the other strand */
    uint32_t length, visited;
} knot_writer;

static void write_entry(knot_writer *w, uint32_t crossing, int8_t sign, bool over, double at)
{
    knot_gauss_code *to = w->to;
    if (w->number[crossing] == NONE) {
        to->sign[w->visited] = sign;
        w->number[crossing] = (uint16_t)w->visited++;
    }
    to->crossing[w->length] = w->number[crossing];
    to->over[w->length] = over;
    to->position[w->length++] = at;
}

/* Writes passage i of the strand, or of the strand that it crosses there. */
static void write_new(knot_writer *w, uint32_t i, bool of_strand, double at)
{
    const knot_gauss_code *from = w->p->from;
    bool is_over = from->over[w->p->first] != 0, from_left = w->sides[i] % 2 == 0;
    write_entry(w, from->n + i, is_over == from_left ? 1 : -1, is_over == of_strand, at);
}

/* Distributes the positions over the old range of the strand. A strand that spans the ends of the
 * code goes to the end with the larger part of it. */
static void write_strand(knot_writer *w, uint32_t first, uint32_t count, uint32_t crossings)
{
    const double *at = w->p->from->position;
    double step = count > 1 ? (at[first + count - 1] - at[first]) / (crossings + 1) : 0.0;
    for (uint32_t i = 0; i < crossings; i++) {
        write_new(w, i, true, at[first] + (i + 1) * step);
    }
}

static void write_code(knot_writer *w, uint32_t crossings)
{
    const knot_pass_move *p = w->p;
    const knot_gauss_code *from = p->from;
    uint32_t last = p->entries - 1, until_end = p->entries - p->first;
    uint32_t ahead = p->count < until_end ? p->count : until_end, rest = p->count - ahead;
    uint32_t first = ahead >= rest ? p->first : 0, count = ahead >= rest ? ahead : rest;
    for (uint32_t e = 0; e <= last; e++) {
        if (e == 0 && w->crossed[last] != 0) {
            write_new(w, w->crossed[last] - 1u, false, 0.5 * from->position[0]);
        }
        if (e == first) {
            write_strand(w, first, count, crossings);
        }
        if (w->number[from->crossing[e]] != GONE) {
            write_entry(w, from->crossing[e], from->sign[from->crossing[e]], from->over[e] != 0,
                        from->position[e]);
        }
        if (e < last && w->crossed[e] != 0) {
            write_new(w, w->crossed[e] - 1u, false,
                      0.5 * (from->position[e] + from->position[e + 1]));
        }
    }
}

static void reroute_strand(const knot_pass_move *p, knot_gauss_code *to, uint32_t crossings)
{
    const knot_gauss_code *from = p->from;
    uint32_t behind = (p->first + p->count) % p->entries;
    /* shorter than the old strand, which has at most n entries */
    uint16_t *sides = p->parent_side + p->faces;
    uint32_t face = p->root[left_of(p, before(p, behind))];
    for (uint32_t i = crossings; i-- > 0;) {
        sides[i] = p->parent_side[face];
        face = p->root[p->face[sides[i]]];
    }
    /* The faces are no longer needed. */
    knot_writer w = {.p = p, .to = to, .number = p->face, .sides = sides};
    w.crossed = w.number + 2 * (size_t)from->n;
    for (uint32_t i = 0; i < 2 * from->n; i++) {
        w.number[i] = NONE;
        w.crossed[i] = 0;
    }
    for (uint32_t i = 0, e = p->first; i < p->count; i++, e = after(p, e)) {
        w.number[from->crossing[e]] = GONE;
    }
    for (uint32_t i = 0; i < crossings; i++) {
        w.crossed[sides[i] / 2u] = (uint16_t)(i + 1);
    }
    write_code(&w, crossings);
    to->n = from->n - p->count + crossings;
}

/* ---- one strand after the other */

/* Finds the strand that starts at this entry, if there is one. */
static bool find_strand(knot_pass_move *p, uint32_t first)
{
    const uint8_t *over = p->from->over;
    if (over[before(p, first)] == over[first]) {
        return false;
    }
    p->first = first;
    p->count = 0;
    for (uint32_t e = first; over[e] == over[first]; e = after(p, e)) {
        p->count++;
    }
    return true;
}

static bool reduce_crossings(knot_gauss_code *code, knot_gauss_code *spare, uint32_t *tries,
                             knot_ops *budget)
{
    vbss_knot_gauss_code_copy(spare, code);
    knot_pass_move p = {.from = spare, .entries = 2 * code->n};
    p.mate = code->crossing; /* it is rewritten or restored later */
    p.face = code->scratch;
    p.root = spare->scratch;
    find_faces(&p);
    p.distance = p.root + p.faces;
    p.parent_side = p.distance + p.faces;
    *budget -= 10 * (knot_ops)p.entries;
    for (uint32_t first = 0; first < p.entries; first++) {
        if (!find_strand(&p, first)) {
            continue;
        }
        if (*tries == 0) {
            break;
        }
        --*tries;
        *budget -= 4 * (knot_ops)p.faces;
        merge_faces_along_strand(&p);
        uint32_t crossings = find_shortest_path(&p, budget);
        if (crossings < p.count) {
            reroute_strand(&p, code, crossings);
            return true;
        }
    }
    vbss_knot_gauss_code_copy(code, spare);
    return false;
}

bool vbss_knot_gauss_code_untangle(knot_gauss_code *code, knot_gauss_code *spare, uint32_t *tries,
                                   knot_ops *budget)
{
    /* scratch needs three numbers for each face, and the path */
    if (code->n <= 2 || code->n + 2 > spare->capacity) {
        return false;
    }
    bool lowered = reduce_crossings(code, spare, tries, budget);
    if (lowered) {
        vbss_knot_gauss_code_simplify(code, budget);
    }
    return lowered;
}
