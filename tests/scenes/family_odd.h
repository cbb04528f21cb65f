/* Families that are no plain stacks of throws, and what all are made with. For knot_families.c. */
#ifndef VBSS_TESTS_SCENES_FAMILY_ODD_H
#define VBSS_TESTS_SCENES_FAMILY_ODD_H

#include <stdint.h>

#include "scenes/knot_families.h"

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
