/* Many configurations out of one thread whose truth is known: vertices come, go and move where it is proved that this
 * is free (fixtures/swept.h), ends stay outermost; then the whole is mirrored, turned round, carried away, scaled, and
 * points are doubled or put on edges. Each is a configuration of its own with the truth that follows. */
#ifndef VBSS_TESTS_KNOT_DERIVE_H
#define VBSS_TESTS_KNOT_DERIVE_H

#include "base/random.h"
#include "knot/judge.h"
#include "fixtures/swept.h"

typedef struct derivation {
    family_case from; /* what is moved about: its line is that of the last step */
    swept_line line, spare;
    uint32_t marks[3]; /* vertices: hole, tissue, hole */
    bool has_marks;
    vec3 out[2];                    /* each end is outermost that way */
    uint64_t moved, removed, split; /* vertices so far */
} derivation;

/* False when it cannot be told how the ends go on. */
bool derive_begin(derivation *d, const family_case *from);
/* Another configuration of the same thread: moves in their number and size, and what comes after them, are drawn. */
void derive_move(derivation *d, vbss_random *random);

/* What is done to the whole in the end. */
typedef struct derive_whole {
    bool mirrored, reversed;
    quat turn;
    double scale;      /* of the size, then */
    vec3 shift;        /* m */
    double doubled;    /* share of the points that are given twice */
    uint32_t inserted; /* points on edges, anywhere */
    bool no_tissue;    /* nobody knows where it is: only where no throw is stray */
    uint64_t seed;     /* of those */
} derive_whole;
derive_whole derive_plain(void);
derive_whole derive_draw(vbss_random *random);
/* Fewer are doubled or inserted when there is no room. */
void derive_whole_of(const family_case *from, const derive_whole *how, family_case *to);

/* A case of a family, so many configurations made of it, each judged and counted; every fourth is given from the long
 * limb's end on. False when the case could not be made. */
bool derive_and_judge(judge *j, const family *f, uint64_t seed, uint32_t segments,
                      uint32_t configurations, judge_counts *counts);

#endif
