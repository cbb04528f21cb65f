#include "knots/shown_set.h"

#include <stdlib.h>

#include "knot/derive.h"
#include "knot/judge.h"

/* Threads made of a family, seeds tried for each, and how far seeds are apart: prime to all periods. */
enum { POOL = 128, TRIES = 4, APART = 7 };

static shown_set kept;

void shown_set_end(void)
{
    free(kept.cases);
    free(kept.inputs);
    kept = (shown_set){.count = 0};
}

static uint32_t make_pool(const family *of, uint32_t segments, uint32_t wanted, family_case *pool)
{
    uint32_t made = 0;
    for (uint64_t seed = 0; seed < (uint64_t)TRIES * wanted && made < wanted; seed++) {
        made += of->make(APART * seed, segments, &pool[made]);
    }
    return made;
}

static quat random_turn(uint64_t seed)
{
    vbss_random random;
    double q[4];
    vbss_random_seed(&random, seed, 31);
    for (int i = 0; i < 4; i++) {
        q[i] = vbss_random_normal(&random);
    }
    return quat_unit(quat_make(q[0], q[1], q[2], q[3]));
}

static void show(const family_case *pool, uint32_t made)
{
    for (uint32_t i = 0, which = 0, round = 0; i < kept.count; i++) {
        derive_whole how = derive_plain();
        how.mirrored = (round & 1) != 0;
        how.reversed = (round & 2) != 0;
        how.turn = random_turn(i);
        derive_whole_of(&pool[which], &how, &kept.cases[i]);
        kept.inputs[i] = judge_input_of(&kept.cases[i].line);
        if (++which == made) {
            which = 0;
            round++;
        }
    }
}

const shown_set *shown_set_of(const family *of, uint32_t segments, uint32_t count)
{
    if (kept.count == count && kept.family == of && kept.segments == segments) {
        return &kept;
    }
    shown_set_end();
    uint32_t wanted = count < POOL ? count : POOL;
    family_case *pool = malloc(wanted * sizeof *pool);
    uint32_t made = pool != NULL ? make_pool(of, segments, wanted, pool) : 0;
    if (made > 0 && made > wanted / 4) {
        kept = (shown_set){.family = of, .segments = segments, .count = count};
        kept.cases = malloc(count * sizeof *kept.cases);
        kept.inputs = calloc(count, sizeof *kept.inputs);
        if (kept.cases != NULL && kept.inputs != NULL) {
            show(pool, made);
        } else {
            shown_set_end();
        }
    }
    free(pool);
    return kept.count > 0 ? &kept : NULL;
}
