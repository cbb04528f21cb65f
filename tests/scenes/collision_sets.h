/* Sets of continuous collision queries with their truth, the same for tests and bench and, for a seed, the
 * same on every machine.
 *
 * Truth means: closed features, closed interval of time, touching is a hit, the given doubles are exact;
 * with thickness D: hit if the smallest distance over time is at most D. */
#ifndef VBSS_TESTS_SCENES_COLLISION_SETS_H
#define VBSS_TESTS_SCENES_COLLISION_SETS_H

#include <stdbool.h>

#include <vblast_ss/collision.h>

typedef struct collision_query {
    vbss_pair_kind kind;
    double thickness;          /* D; same unit as the coordinates */
    double start[12], end[12]; /* as vbss_edges_test and vbss_point_triangle_test take them */
    bool hit;                  /* the truth */
    /* Smallest distance over time minus D, right to 1e-9 from 0 to 1 % of D. An upper bound of it that
     * lies on the right side of 0, and of 1 % of D, elsewhere. NAN when it was not computed. */
    double clearance;
} collision_query;

typedef struct collision_set {
    char name[40];
    uint32_t count;
    collision_query *queries;
} collision_set;

void collision_set_release(collision_set *set);
/* Of coordinates and truth. */
uint64_t collision_set_hash(const collision_set *set);

/* ---- capsules: the hard families, one after the other, lengths in mm, D = 0.25 */
extern const char *const collision_family_names[];
extern const uint32_t collision_family_count;
/* `count` queries whose truth is certain; false when memory is short. */
bool collision_set_family(uint32_t family, uint32_t count, uint64_t seed, collision_set *set);

/* ---- points and triangles, the same unit and D: hard families */
extern const char *const collision_sheet_names[];
extern const uint32_t collision_sheet_count;
bool collision_set_sheet(uint32_t family, uint32_t count, uint64_t seed, collision_set *set);

/* ---- capsules: a thread tied into a trefoil and pulled tight through its contacts; all pairs a broad
 * phase gives in some hundred steps; lengths in mm, D = 0.25. The typical load. */
bool collision_set_thread(uint64_t seed, collision_set *set);

/* ---- zero thickness: degenerate queries. The truth comes from an oracle that the caller gives, as
 * this library has none: tests/oracle (exact rational arithmetic). NULL: all are told as misses. */
typedef bool (*collision_oracle)(const collision_query *query);
extern const char *const collision_degenerate_names[];
extern const uint32_t collision_degenerate_count;
bool collision_set_degenerate(uint32_t which, vbss_pair_kind kind, uint32_t count, uint64_t seed,
                              collision_oracle oracle, collision_set *set);

#endif
