/* Codes of connected sums of T(2, m), block by block, and the answer to them by definition. */
#ifndef VBSS_TESTS_KNOT_SUM_DIAGRAM_H
#define VBSS_TESTS_KNOT_SUM_DIAGRAM_H

#include "knot/knot.h"

enum { SUM_CROSSINGS = 256 };

typedef struct sum_diagram {
    knot_gauss_code code; /* its arrays are those below */
    uint16_t crossing[2 * SUM_CROSSINGS], scratch[4 * SUM_CROSSINGS];
    uint8_t over[2 * SUM_CROSSINGS];
    int8_t sign[SUM_CROSSINGS];
    uint32_t owner[2 * SUM_CROSSINGS]; /* the block of each entry */
    uint32_t blocks;
    knot_factors wanted; /* in the order of insertion */
} sum_diagram;

/* Without crossings. */
void sum_begin(sum_diagram *d);
/* Puts a whole block before entry `at`. */
void sum_insert(sum_diagram *d, uint32_t at, uint32_t wraps, int handedness, bool over);
/* Each block in the middle of the one before. */
void sum_stack(sum_diagram *d, uint32_t count, const uint32_t *wraps, const int *signs);
/* Any code: letters 1 to n, positive where over. */
void sum_from_word(sum_diagram *d, uint32_t n, const int *word, const int8_t *signs);

void sum_swap(sum_diagram *d, uint32_t i, uint32_t j);
/* The same diagram with the point at infinity so many entries on. */
void sum_shift(sum_diagram *d, uint32_t by);

/* Whether the smallest interval that holds all of its crossings is a block, again and again. */
bool sum_comes_apart(const sum_diagram *d);
/* Blocks in whole halves, and the same from behind. */
bool sum_is_nest(const sum_diagram *d);

#endif
