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
    sweep box;
    size_t count, tools;
} group;

static group group_of(const piece *pieces, size_t count)
{
    group g = {pieces[0].swept, 0, 0};
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

/* With j .. j + g->count - 1, later than a. */
static void ask_group(const piece *a, const piece *j, const group *g, passing_report *report)
{
    if (!are_neighbours(a, j) && sweep_boxes_apart(&a->swept, &g->box)) {
        report->pairs += g->count - (a->tool ? g->tools : 0);
        return;
    }
    for (size_t i = 0; i < g->count; i++) {
        ask_pair(a, j + i, report);
    }
}

static void ask_all(const piece *pieces, size_t count, const group *groups, passing_report *report)
{
    for (size_t i = 0; i < count; i++) {
        size_t own = i / TOGETHER, end = own * TOGETHER + groups[own].count;
        for (size_t j = i + 1; j < end; j++) {
            ask_pair(&pieces[i], &pieces[j], report);
        }
        for (size_t j = end; j < count; j += TOGETHER) {
            ask_group(&pieces[i], &pieces[j], &groups[j / TOGETHER], report);
        }
    }
}

/* False: no memory. */
static bool group_and_ask(const piece *pieces, size_t count, passing_report *report)
{
    group *groups = malloc((count + TOGETHER - 1) / TOGETHER * sizeof *groups);
    if (groups == NULL) {
        return false;
    }
    for (size_t i = 0; i < count; i += TOGETHER) {
        groups[i / TOGETHER] = group_of(pieces + i, count - i);
    }
    ask_all(pieces, count, groups, report);
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
