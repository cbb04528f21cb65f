/* Families of threads with their truth, by name: for tests, bench and examples of what tells knots. */
#ifndef VBSS_TESTS_SCENES_KNOT_FAMILIES_H
#define VBSS_TESTS_SCENES_KNOT_FAMILIES_H

#include <stdint.h>

#include "scenes/throw_stack.h"

typedef enum family_truth {
    FAMILY_THROWS, /* so many stacked throws; none: no knot. Perhaps a stray one beside them */
    FAMILY_OTHER,  /* a knot that is no stack of throws, with these invariants */
    FAMILY_OPEN    /* none: an end lies inside */
} family_truth;

typedef struct family_case {
    thread_line line; /* its tissue_place is negative when there is no tissue */
    family_truth truth;
    uint32_t throws; /* from the tissue outward */
    int wraps[STACK_THROWS], signs[STACK_THROWS];
    int stray_wraps, stray_sign; /* a knot in one limb alone; 0 wraps: none */
    bool stray_in_tail;
    int64_t determinant, v2, v3; /* OTHER */
} family_case;

typedef struct family {
    const char *name;
    uint32_t period;         /* seeds below it are different types (or shapes); 1: all alike */
    uint32_t least_segments; /* with which most seeds can be made */
    bool (*make)(uint64_t seed, uint32_t segments, family_case *made);
} family;

enum { FAMILIES = 20 };
extern const family families[FAMILIES];

/* The family of that name; NULL when there is none. */
const family *family_named(const char *name);

#endif
