/* A closed way of a hand that takes a second: three harmonics in each direction, from the origin and back. What
 * tests and benches of passivity lead a hand along. */
#ifndef VBSS_TESTS_SCENES_HAND_PATH_H
#define VBSS_TESTS_SCENES_HAND_PATH_H

#include "base/linear.h"
#include "base/random.h"

enum { HAND_PATH_HARMONICS = 3 };

typedef struct hand_path {
    vec3 sine[HAND_PATH_HARMONICS], cosine[HAND_PATH_HARMONICS];
} hand_path;
/* size: amplitude of the first harmonic, m; that of the k-th is a k-th of it. */
hand_path hand_path_draw(vbss_random *random, double size);
/* Where it is at a time, s, in any round; m. */
vec3 hand_path_at(const hand_path *path, double time);

#endif
