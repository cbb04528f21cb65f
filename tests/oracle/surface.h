/* Whether anything passed through a surface of triangles, or a surface through itself, between two recorded states,
 * decided exactly: edges and sides, points and triangles. The companion of passing.h, which asks chains alone. */
#ifndef VBSS_TESTS_ORACLE_SURFACE_H
#define VBSS_TESTS_ORACLE_SURFACE_H

#include "oracle/passing.h"

typedef struct passing_surface {
    const vec3 *start, *end; /* `nodes` each, which move in straight lines */
    size_t nodes;
    const uint32_t *triangles, *sides; /* three nodes each; two */
    size_t triangle_count, side_count;
    /* A row of bits for each node: those that are near it along the surface, itself too. Features of which any nodes
     * are near are not asked. NULL: the surface is not asked with itself. */
    const uint64_t *near;
    size_t words; /* of a row */
} passing_surface;

/* One of two features that met: of a chain or, beyond the last of them, of a surface. */
typedef struct passing_feature {
    size_t of, number;
    uint32_t corners; /* 1: a node; 2: a segment or side; 3: a triangle */
} passing_feature;

typedef struct passing_surface_report {
    uint64_t asked;           /* pairs that exact arithmetic decided */
    uint64_t passed;          /* of these, those that met */
    passing_feature first[2]; /* that met */
} passing_surface_report;

/* How many pairs, one of a surface at least, had a point in common at some time from start to end, touching included. */
uint64_t passing_surfaces(const passing_surface *surfaces, size_t surface_count,
                          const passing_chain *chains, size_t chain_count,
                          passing_surface_report *report);

#endif
