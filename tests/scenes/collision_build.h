/* What the makers of collision sets share. */
#ifndef VBSS_TESTS_SCENES_COLLISION_BUILD_H
#define VBSS_TESTS_SCENES_COLLISION_BUILD_H

#include "base/elementary.h"
#include "base/linear.h"
#include "base/random.h"
#include "scenes/collision_sets.h"

/* The vertices of a query as the generators think of them. */
typedef struct collision_motion {
    vec3 start[4], end[4];
} collision_motion;

/* All with exactly one draw a number: never two draws in one argument list, whose order is open. */
static inline double draw_real(vbss_random *random, double low, double high)
{
    return low + (high - low) * vbss_random_uniform(random);
}

static inline int draw_integer(vbss_random *random, int low, int high)
{
    return low + (int)vbss_random_below(random, (uint32_t)(high - low + 1));
}

static inline bool draw_chance(vbss_random *random, double probability)
{
    return vbss_random_uniform(random) < probability;
}

static inline vec3 draw_vec3(vbss_random *random, double low, double high)
{
    double x = draw_real(random, low, high);
    double y = draw_real(random, low, high);
    double z = draw_real(random, low, high);
    return vec3_make(x, y, z);
}

static inline double draw_power_of_ten(vbss_random *random, double low, double high)
{
    return vbss_exp(2.302585092994046 * draw_real(random, low, high));
}

/* A distance more or less by 10^U(-6, -3). */
static inline double draw_nearly(vbss_random *random, double distance)
{
    double off = draw_power_of_ten(random, -6.0, -3.0);
    return draw_chance(random, 0.5) ? distance + off : distance - off;
}

/* An empty set with room; false when memory is short. */
bool collision_set_begin(collision_set *set, const char *name, uint32_t capacity);
void collision_query_fill(collision_query *query, vbss_pair_kind kind, double thickness,
                          const collision_motion *motion);
/* Fills an empty set to its capacity with what `draw` makes and whose truth is certain. */
typedef void (*collision_draw)(vbss_random *random, collision_motion *m);
void collision_set_fill(collision_set *set, uint32_t capacity, vbss_pair_kind kind,
                        collision_draw draw, vbss_random *random);
/* The same from the beginning, with random numbers of a sequence of its own; false when memory is short. */
bool collision_set_make(collision_set *set, const char *name, uint32_t count, vbss_pair_kind kind,
                        collision_draw draw, uint64_t seed, uint64_t sequence);
/* Lengths in mm; the contact distance of all sets that have one. */
#define COLLISION_THICKNESS 0.25
/* Works out hit and clearance by branch and bound (collision_truth.c). False, and the query is to be
 * drawn anew, when the smallest distance is within COLLISION_UNCERTAIN of D. */
#define COLLISION_UNCERTAIN 1e-10
bool collision_truth(collision_query *query);
/* The distance of the features at a time, in long double. */
long double collision_distance(const collision_query *query, long double t);

#endif
