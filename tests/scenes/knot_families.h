/* Families of threads with their truth, by name: for tests, bench and examples of what tells knots. */
#ifndef VBSS_TESTS_SCENES_KNOT_FAMILIES_H
#define VBSS_TESTS_SCENES_KNOT_FAMILIES_H

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

/* Private: the families that are no plain stacks (family_odd.c). */
bool family_crossed_ends(uint64_t seed, uint32_t segments, family_case *made);
bool family_bight(uint64_t seed, uint32_t segments, family_case *made);
bool family_tangle(uint64_t seed, uint32_t segments, family_case *made);
bool family_stray(uint64_t seed, uint32_t segments, family_case *made);
bool family_own_limb(uint64_t seed, uint32_t segments, family_case *made);
bool family_beside_drain(uint64_t seed, uint32_t segments, family_case *made);
bool family_withdrawn(uint64_t seed, uint32_t segments, family_case *made);
bool family_wraps(uint64_t seed, uint32_t segments, family_case *made);
bool family_torus(uint64_t seed, uint32_t segments, family_case *made);
bool family_other(uint64_t seed, uint32_t segments, family_case *made);
bool family_ends_inside(uint64_t seed, uint32_t segments, family_case *made);
/* Carries made->line through an isotopy of the seed; milder ones when that cannot be done. */
bool family_carry(uint64_t seed, uint32_t segments, double strength, double jumps,
                  family_case *made);
/* A stack of throws of type number n of 6^throws as made->line and truth, finely. */
bool family_stack(uint32_t throws, uint64_t n, double limb, family_case *made);

#endif
