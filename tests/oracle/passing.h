/* Whether anything passed through anything between two recorded states, decided exactly: a bound in floating
 * point, each with a proof, for nearly all pairs of segments, rational arithmetic (oracle.h) for the rest. It
 * shares no code and no idea with the library's own continuous tests. */
#ifndef VBSS_TESTS_ORACLE_PASSING_H
#define VBSS_TESTS_ORACLE_PASSING_H

#include <stddef.h>
#include <stdint.h>

#include "base/linear.h"

/* Segments between consecutive nodes, which move in straight lines, all at the same time. A capsule's axis
 * is a chain of two nodes. */
typedef struct passing_chain {
    const vec3 *start, *end; /* `nodes` each */
    size_t nodes;
    bool tool; /* asked against threads only, not against itself or other tools */
} passing_chain;

typedef struct passing_report {
    uint64_t pairs;                /* of segments that share no node */
    uint64_t asked;                /* of them, those that exact arithmetic decided */
    uint64_t passed;               /* of these, those that met */
    size_t chains[2], segments[2]; /* of one that met */
} passing_report;

/* How many pairs of segments had a point in common, of no thickness, at some time from start to end, touching
 * included: 0 proves that nothing passed. Pairs with a coordinate that is not finite count as met. The
 * report may be NULL. */
uint64_t passing_count(const passing_chain *chains, size_t count, passing_report *report);

#endif
