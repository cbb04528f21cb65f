#include "oracle/surface.h"

#include <stdlib.h>

#include "oracle/sweep.h"

typedef struct piece {
    sweep swept;
    passing_feature is;
    uint32_t nodes[3];
    const passing_surface *surface; /* NULL: of a chain */
} piece;

/* In the order of their begins along x: who begins beyond the end of another meets no more. */
typedef struct location {
    double low;
    size_t piece;
    const passing_surface *surface; /* here too: most pairs need no more to be left */
} place;

typedef struct all_pieces {
    piece *pieces;
    place *order;
    size_t count;
} all_pieces;

/* ---- gathering */

static void add(all_pieces *all, const passing_surface *surface, const vec3 *start, const vec3 *end,
                const uint32_t *nodes, passing_feature is)
{
    piece *p = &all->pieces[all->count];
    *p = (piece){.swept = sweep_make(start, end, nodes, is.corners), .is = is, .surface = surface};
    for (uint32_t k = 0; k < is.corners; k++) {
        p->nodes[k] = nodes[k];
    }
    all->order[all->count] = (place){p->swept.low.x, all->count, surface};
    all->count++;
}

static void add_chain(all_pieces *all, const passing_chain *c, size_t of)
{
    for (uint32_t i = 0; i < c->nodes; i++) {
        const uint32_t nodes[2] = {i, i + 1};
        add(all, NULL, c->start, c->end, nodes, (passing_feature){of, i, 1});
        if (i + 1 < c->nodes) {
            add(all, NULL, c->start, c->end, nodes, (passing_feature){of, i, 2});
        }
    }
}

static void add_surface(all_pieces *all, const passing_surface *s, size_t of)
{
    for (uint32_t i = 0; i < s->nodes; i++) {
        add(all, s, s->start, s->end, &i, (passing_feature){of, i, 1});
    }
    for (size_t i = 0; i < s->side_count; i++) {
        add(all, s, s->start, s->end, s->sides + 2 * i, (passing_feature){of, i, 2});
    }
    for (size_t i = 0; i < s->triangle_count; i++) {
        add(all, s, s->start, s->end, s->triangles + 3 * i, (passing_feature){of, i, 3});
    }
}

static sweep box_of_chains(const passing_chain *chains, size_t count)
{
    sweep box = {.low = vec3_make(HUGE_VAL, HUGE_VAL, HUGE_VAL),
                 .high = vec3_make(-HUGE_VAL, -HUGE_VAL, -HUGE_VAL)};
    for (size_t c = 0; c < count; c++) {
        for (uint32_t i = 0; i < chains[c].nodes; i++) {
            const sweep node = sweep_make(chains[c].start, chains[c].end, &i, 1);
            sweep_boxes_join(&box, &node);
        }
    }
    return box;
}

static void add_if_beside(all_pieces *all, const sweep *chains, const passing_surface *s,
                          const uint32_t *nodes, passing_feature is)
{
    add(all, s, s->start, s->end, nodes, is);
    all->count -= sweep_boxes_apart(&all->pieces[all->count - 1].swept, chains);
}

/* Of a surface that only chains are asked with what may meet them: no points, as chains have no triangles. */
static void add_beside(all_pieces *all, const sweep *chains, const passing_surface *s, size_t of)
{
    for (size_t i = 0; i < s->side_count; i++) {
        add_if_beside(all, chains, s, s->sides + 2 * i, (passing_feature){of, i, 2});
    }
    for (size_t i = 0; i < s->triangle_count; i++) {
        add_if_beside(all, chains, s, s->triangles + 3 * i, (passing_feature){of, i, 3});
    }
}

static int compare(const void *one, const void *other)
{
    const place *a = one, *b = other;
    if (a->low != b->low) {
        return a->low < b->low ? -1 : 1;
    }
    return (a->piece > b->piece) - (a->piece < b->piece);
}

/* ---- asking */

static bool are_near(const piece *a, const piece *b)
{
    for (uint32_t i = 0; i < a->is.corners; i++) {
        const uint64_t *row = a->surface->near + a->nodes[i] * a->surface->words;
        for (uint32_t k = 0; k < b->is.corners; k++) {
            if ((row[b->nodes[k] / 64] >> b->nodes[k] % 64 & 1u) != 0) {
                return true;
            }
        }
    }
    return false;
}

static void ask(const piece *a, const piece *b, passing_surface_report *report)
{
    bool edges = a->is.corners == 2 && b->is.corners == 2, asked;
    bool face = a->is.corners + b->is.corners == 4 && !edges;
    if ((!edges && !face) || sweep_boxes_apart(&a->swept, &b->swept) ||
        (a->surface == b->surface && are_near(a, b))) {
        return;
    }
    bool swapped = a->is.corners == 3;
    const piece *one = swapped ? b : a, *other = swapped ? a : b;
    bool met = sweep_meets(&one->swept, &other->swept, &asked);
    report->asked += asked;
    if (met && report->passed++ == 0) {
        report->first[0] = one->is;
        report->first[1] = other->is;
    }
}

/* Chains are not asked with each other here, and not every surface with itself. */
static bool are_asked(const passing_surface *a, const passing_surface *b)
{
    return a != b || (a != NULL && a->near != NULL);
}

static void ask_all(all_pieces *all, passing_surface_report *report)
{
    qsort(all->order, all->count, sizeof *all->order, compare);
    for (size_t i = 0; i < all->count; i++) {
        const place *at = &all->order[i];
        const piece *a = &all->pieces[at->piece];
        for (size_t k = i + 1; k < all->count && all->order[k].low <= a->swept.high.x; k++) {
            const place *other = &all->order[k];
            if (are_asked(at->surface, other->surface)) {
                ask(a, &all->pieces[other->piece], report);
            }
        }
    }
}

uint64_t passing_surfaces(const passing_surface *surfaces, size_t surface_count,
                          const passing_chain *chains, size_t chain_count,
                          passing_surface_report *report)
{
    size_t largest = 0;
    for (size_t c = 0; c < chain_count; c++) {
        largest += 2 * chains[c].nodes;
    }
    for (size_t k = 0; k < surface_count; k++) {
        largest += surfaces[k].nodes + surfaces[k].side_count + surfaces[k].triangle_count;
    }
    *report = (passing_surface_report){0};
    all_pieces all = {malloc((largest + 1) * sizeof *all.pieces),
                      malloc((largest + 1) * sizeof *all.order), 0};
    if (all.pieces == NULL || all.order == NULL) {
        report->passed = UINT64_MAX; /* nothing is proven */
    } else {
        for (size_t c = 0; c < chain_count; c++) {
            add_chain(&all, &chains[c], c);
        }
        if (surface_count == 1 && surfaces[0].near == NULL) {
            const sweep box = box_of_chains(chains, chain_count);
            add_beside(&all, &box, &surfaces[0], chain_count);
        } else {
            for (size_t k = 0; k < surface_count; k++) {
                add_surface(&all, &surfaces[k], chain_count + k);
            }
        }
        ask_all(&all, report);
    }
    free(all.pieces);
    free(all.order);
    return report->passed;
}
