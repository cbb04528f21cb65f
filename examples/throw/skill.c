#include "throw/skill.h"

#include <string.h>

#include "throw/hand.h"

static const hand_skill skills[] = {
    {.name = "expert", .speed = 1.0, .tremor = 1.0, .target_at = 1.0, .hesitation = 0.0},
    {.name = "resident", .speed = 0.8, .tremor = 1.5, .target_at = 1.4, .hesitation = 0.2},
    {.name = "novice", .speed = 0.6, .tremor = 2.0, .target_at = 2.0, .hesitation = 0.5},
};

const hand_skill *skill_named(const char *name)
{
    for (size_t i = 0; i < sizeof skills / sizeof skills[0]; i++) {
        if (strcmp(skills[i].name, name) == 0) {
            return &skills[i];
        }
    }
    return NULL;
}

const hand_skill *skill_or_expert(const hand_skill *skill)
{
    return skill != NULL ? skill : &skills[0];
}

void hesitation_begin(hesitation *h, const hand_skill *skill, uint64_t seed)
{
    *h = (hesitation){.mean = skill->hesitation, .random = seed, .doing = ""};
}

bool hesitates(hesitation *h, const char *doing, double dt)
{
    if (strcmp(h->doing, doing) != 0) {
        h->doing = doing;
        h->left = 2.0 * h->mean * hand_chance(&h->random);
    }
    h->left -= dt;
    return h->left > 0.0;
}
