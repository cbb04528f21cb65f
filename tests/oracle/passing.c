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

static void ask_all(const piece *pieces, size_t count, passing_report *report)
{
    for (size_t i = 0; i < count; i++) {
        const piece *a = &pieces[i];
        for (size_t j = i + 1; j < count; j++) {
            const piece *b = &pieces[j];
            if ((a->tool && b->tool) || (a->chain == b->chain && j == i + 1)) {
                continue;
            }
            report->pairs++;
            if (!sweep_boxes_apart(&a->swept, &b->swept)) {
                ask(a, b, report);
            }
        }
    }
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
    if (pieces != NULL) {
        size_t made = 0;
        for (size_t c = 0; c < count; c++) {
            for (size_t i = 0; i + 1 < chains[c].nodes; i++) {
                sweep swept = sweep_make(chains[c].start + i, chains[c].end + i, next, 2);
                pieces[made++] = (piece){swept, c, i, chains[c].tool};
            }
        }
        ask_all(pieces, made, &own);
        free(pieces);
    } else if (segments > 0) {
        own.passed = UINT64_MAX; /* no memory: nothing is proven */
    }
    if (report != NULL) {
        *report = own;
    }
    return own.passed;
}
