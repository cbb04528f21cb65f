/* Degenerate motions on small integers, from which the degenerate sets are made. */
#ifndef VBSS_TESTS_SCENES_COLLISION_INTEGERS_H
#define VBSS_TESTS_SCENES_COLLISION_INTEGERS_H

#include "scenes/collision_build.h"

typedef void (*collision_maker)(vbss_random *random, vbss_pair_kind kind, collision_motion *m);

void collision_make_integers(vbss_random *random, vbss_pair_kind kind, collision_motion *m);
void collision_make_planar(vbss_random *random, vbss_pair_kind kind, collision_motion *m);
void collision_make_collinear(vbss_random *random, vbss_pair_kind kind, collision_motion *m);
void collision_make_zero_length(vbss_random *random, vbss_pair_kind kind, collision_motion *m);
void collision_make_parallel(vbss_random *random, vbss_pair_kind kind, collision_motion *m);
void collision_make_shared(vbss_random *random, vbss_pair_kind kind, collision_motion *m);
void collision_make_symmetric(vbss_random *random, vbss_pair_kind kind, collision_motion *m);
void collision_make_touch_at_end(vbss_random *random, vbss_pair_kind kind, collision_motion *m);
void collision_make_graze(vbss_random *random, vbss_pair_kind kind, collision_motion *m);

/* Any of these. */
void collision_make_any(vbss_random *random, vbss_pair_kind kind, collision_motion *m);

#endif
