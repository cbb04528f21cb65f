/* How good the hands are. It shows in what their devices deliver, and nowhere else. */
#ifndef VBSS_EXAMPLES_THROW_SKILL_H
#define VBSS_EXAMPLES_THROW_SKILL_H

#include <stdbool.h>
#include <stdint.h>

/* Expert hands differ from seed to seed in speed and tremor; these are shares of what such a seed has. The figures are ours: no source
 * gives them. */
typedef struct hand_skill {
    const char *name;
    double speed;     /* of all motions */
    double tremor;    /* its size */
    double target_at; /* every error of aim */
    double
        hesitation; /* s: mean of how long both hands stay where they are before each thing they do */
} hand_skill;

/* expert, resident, novice; NULL: there is none of that name. */
const hand_skill *skill_named(const char *name);
/* The same; NULL: the expert. */
const hand_skill *skill_or_expert(const hand_skill *skill);

/* One who thinks before each thing to do. */
typedef struct hesitation {
    double mean; /* s */
    uint64_t random;
    const char *doing; /* the last thing */
    double left;       /* s */
} hesitation;

void hesitation_begin(hesitation *h, const hand_skill *skill, uint64_t seed);
/* Whether the hands stay where they are in the coming step, now that this is to be done; of 0 to twice the mean. */
bool hesitates(hesitation *h, const char *doing, double dt);

#endif
