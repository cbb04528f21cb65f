#include "oracle/passing.h"

#include <stdlib.h>

#include "oracle/sweep.h"

typedef struct piece {
    sweep swept;
    size_t chain, segment;
    bool tool;
} piece;

static void ask(const piece *a, const piece *b, passing_report *report)
{
    bool asked, met = sweep_meets(&a->swept, &b->swept, &asked);
    report->asked += asked;
    if (met && report->passed++ == 0) {
        report->chains[0] = a->chain;
        report->chains[1] = b->chain;
        report->segments[0] = a->segment;
        report->segments[1] = b->segment;
    }
}

/* Pieces that follow each other lie together: what is apart from a box round some of them need not be compared with
 * each. */
enum { TOGETHER = 8 };

typedef struct group {
    const piece *pieces;
    size_t count, tools;
    sweep box;
} group;

static group group_of(const piece *pieces, size_t count)
{
    group g = {pieces, 0, 0, pieces[0].swept};
    while (g.count < TOGETHER && g.count < count) {
        sweep_boxes_join(&g.box, &pieces[g.count].swept);
        g.tools += pieces[g.count++].tool;
    }
    return g;
}

static bool are_neighbours(const piece *a, const piece *b)
{
    return a->chain == b->chain && b->segment == a->segment + 1;
}

static void ask_pair(const piece *a, const piece *b, passing_report *report)
{
    if ((a->tool && b->tool) || are_neighbours(a, b)) {
        return;
    }
    report->pairs++;
    if (!sweep_boxes_apart(&a->swept, &b->swept)) {
        ask(a, b, report);
    }
}

/* Two groups, a before b. */
static bool are_apart(const group *a, const group *b)
{
    return !are_neighbours(&a->pieces[a->count - 1], b->pieces) &&
           sweep_boxes_apart(&a->box, &b->box);
}

/* With all of g, which is later than a. */
static void ask_group(const piece *a, const group *g, passing_report *report)
{
    if (!are_neighbours(a, g->pieces) && sweep_boxes_apart(&a->swept, &g->box)) {
        report->pairs += g->count - (a->tool ? g->tools : 0);
        return;
    }
    for (size_t i = 0; i < g->count; i++) {
        ask_pair(a, &g->pieces[i], report);
    }
}

static void ask_groups(const group *a, const group *b, passing_report *report)
{
    if (are_apart(a, b)) {
        report->pairs += a->count * b->count - a->tools * b->tools;
        return;
    }
    for (size_t i = 0; i < a->count; i++) {
        ask_group(&a->pieces[i], b, report);
    }
}

static void ask_within(const group *g, passing_report *report)
{
    for (size_t i = 0; i < g->count; i++) {
        for (size_t k = i + 1; k < g->count; k++) {
            ask_pair(&g->pieces[i], &g->pieces[k], report);
        }
    }
}

/* False: no memory. */
static bool group_and_ask(const piece *pieces, size_t count, passing_report *report)
{
    size_t group_count = (count + TOGETHER - 1) / TOGETHER;
    group *groups = malloc(group_count * sizeof *groups);
    if (groups == NULL) {
        return false;
    }
    for (size_t i = 0; i < group_count; i++) {
        groups[i] = group_of(pieces + i * TOGETHER, count - i * TOGETHER);
    }
    for (size_t i = 0; i < group_count; i++) {
        ask_within(&groups[i], report);
        for (size_t k = i + 1; k < group_count; k++) {
            ask_groups(&groups[i], &groups[k], report);
        }
    }
    free(groups);
    return true;
}

uint64_t passing_count(const passing_chain *chains, size_t count, passing_report *report)
{
    static const uint32_t next[2] = {0, 1};
    passing_report own = {0};
    size_t segments = 0;
    for (size_t c = 0; c < count; c++) {
        segments += chains[c].nodes > 1 ? chains[c].nodes - 1 : 0;
    }
    piece *pieces = segments > 0 ? malloc(segments * sizeof *pieces) : NULL;
    size_t made = 0;
    for (size_t c = 0; c < count && pieces != NULL; c++) {
        for (size_t i = 0; i + 1 < chains[c].nodes; i++) {
            sweep swept = sweep_make(chains[c].start + i, chains[c].end + i, next, 2);
            pieces[made++] = (piece){swept, c, i, chains[c].tool};
        }
    }
    if (segments > 0 && (pieces == NULL || !group_and_ask(pieces, made, &own))) {
        own.passed = UINT64_MAX; /* no memory: nothing is proven */
    }
    free(pieces);
    if (report != NULL) {
        *report = own;
    }
    return own.passed;
}
