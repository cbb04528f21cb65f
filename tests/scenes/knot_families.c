#include "scenes/knot_families.h"

#include <string.h>

#include "base/random.h"
#include "scenes/clutter.h"
#include "scenes/family_odd.h"
#include "scenes/isotopy.h"

enum { BASE_SEGMENTS = 500, CARRY_TRIES = 6 };

/* ---- what all are made of */

bool family_stack(uint32_t throws, uint64_t n, double limb, family_case *made)
{
    throw_stack stack;
    throw_stack_init(&stack);
    for (uint32_t i = 0; i < throws; i++, n /= 6) {
        throw_stack_add(&stack, (int)(n % 3) + 1, n % 6 < 3 ? 1 : -1);
    }
    stack.segments = throws > 4 ? 2 * BASE_SEGMENTS : BASE_SEGMENTS;
    stack.limb = limb;
    *made = (family_case){.truth = FAMILY_THROWS, .throws = throws};
    memcpy(made->wraps, stack.wraps, sizeof made->wraps);
    memcpy(made->signs, stack.signs, sizeof made->signs);
    return throw_stack_make(&stack, &made->line);
}

bool family_carry(uint64_t seed, uint32_t segments, double strength, double jumps,
                  family_case *made)
{
    for (uint64_t k = 0; k < CARRY_TRIES; k++) {
        isotopy way;
        isotopy_init(&way, CARRY_TRIES * seed + k);
        way.strength = strength * (1.0 - (double)k / CARRY_TRIES);
        way.jumps = jumps;
        way.segments = segments;
        if (isotopy_apply(&way, &made->line, &made->line)) {
            return true;
        }
    }
    return false;
}

/* ---- stacks */

static const double strengths[4] = {0.15, 0.35, 0.6, 0.9};

static bool carried(uint32_t throws, uint64_t types, uint64_t seed, uint32_t segments,
                    family_case *made)
{
    return family_stack(throws, seed % types, 60e-3, made) &&
           family_carry(seed, segments, strengths[(seed / types + seed) % 4], 0.0, made);
}

static bool one_throw(uint64_t seed, uint32_t segments, family_case *made)
{
    return carried(1, 6, seed, segments, made);
}

static bool two_throws(uint64_t seed, uint32_t segments, family_case *made)
{
    return carried(2, 36, seed, segments, made);
}

static bool three_throws(uint64_t seed, uint32_t segments, family_case *made)
{
    return carried(3, 216, seed, segments, made);
}

/* Four to eight. */
static bool high_stacks(uint64_t seed, uint32_t segments, family_case *made)
{
    vbss_random random;
    vbss_random_seed(&random, seed, 7);
    uint64_t n = vbss_random_u64(&random);
    return family_stack(4 + (uint32_t)(seed % 5), n, 60e-3, made) &&
           family_carry(seed, segments, 0.3, 0.0, made);
}

/* As formulas make them, on even or uneven segments, tight or loose, with short or long limbs. */
static bool plain_stacks(uint64_t seed, uint32_t segments, family_case *made)
{
    if (!family_stack(3, seed % 216, 60e-3, made)) {
        return false;
    }
    vbss_random random;
    vbss_random_seed(&random, seed, 8);
    throw_stack stack;
    throw_stack_init(&stack);
    for (uint32_t i = 0; i < made->throws; i++) {
        throw_stack_add(&stack, made->wraps[i], made->signs[i]);
    }
    stack.size = 0.7e-3 + 1.3e-3 * vbss_random_uniform(&random);
    stack.depth = 5.0 * stack.size;
    stack.tail = 5e-3 + 15e-3 * vbss_random_uniform(&random);
    stack.limb = 20e-3 + 80e-3 * vbss_random_uniform(&random);
    stack.coarseness = 2.0 + 6.0 * vbss_random_uniform(&random);
    stack.unevenness = 0.5 * vbss_random_uniform(&random);
    stack.segments = segments;
    stack.seed = seed;
    return throw_stack_make(&stack, &made->line);
}

/* Single vertices have moved at random: nothing like a thread. */
static bool crumpled(uint64_t seed, uint32_t segments, family_case *made)
{
    return family_stack(3, seed % 216, 60e-3, made) &&
           family_carry(seed, segments, strengths[seed % 3], 2.0, made);
}

/* The long limb lies over the knot many times, with curls; the tail a little. */
static bool cluttered(uint64_t seed, uint32_t segments, family_case *made)
{
    clutter over = {.tail = false,
                    .up = {0.0, 0.0, 1.0},
                    .reach = 8e-3,
                    .slope = 0.05,
                    .passes = 4 + (uint32_t)(seed % 9)};
    clutter aside = {
        .tail = true, .up = {-1.0, 0.0, 0.0}, .reach = 4e-3, .slope = 0.1, .passes = 3};
    return family_stack(3, seed % 216, 3e-3, made) && clutter_limb(&made->line, &over, seed) &&
           clutter_limb(&made->line, &aside, seed + 1) &&
           family_carry(seed, segments, strengths[seed % 3], 0.0, made);
}

static bool mirrored(uint64_t seed, uint32_t segments, family_case *made)
{
    if (!carried(3, 216, seed, segments, made)) {
        return false;
    }
    thread_line_mirror(&made->line);
    for (uint32_t i = 0; i < made->throws; i++) {
        made->signs[i] = -made->signs[i];
    }
    return true;
}

static bool reversed(uint64_t seed, uint32_t segments, family_case *made)
{
    if (!carried(3, 216, seed, segments, made)) {
        return false;
    }
    thread_line_reverse(&made->line);
    return true;
}

/* ---- the table */

const family families[FAMILIES] = {
    {"one throw", 6, 30, one_throw},
    {"two throws", 36, 45, two_throws},
    {"three throws", 216, 60, three_throws},
    {"high stacks", 1, 160, high_stacks},
    {"plain stacks", 216, 120, plain_stacks},
    {"crumpled", 216, 60, crumpled},
    {"cluttered", 216, 80, cluttered},
    {"mirrored", 216, 60, mirrored},
    {"reversed", 216, 60, reversed},
    {"crossed ends", 1, 30, family_crossed_ends},
    {"bight", 18, 80, family_bight},
    {"tangled unknot", 1, 30, family_tangle},
    {"stray", 72, 80, family_stray},
    {"round its own limb", 36, 60, family_own_limb},
    {"beside the drain", 36, 60, family_beside_drain},
    {"withdrawn", 6, 30, family_withdrawn},
    {"wraps", 26, 60, family_wraps},
    {"torus knots", 10, 60, family_torus},
    {"other knots", 8, 60, family_other},
    {"ends inside", 216, 60, family_ends_inside},
};

const family *family_named(const char *name)
{
    for (int i = 0; i < FAMILIES; i++) {
        if (strcmp(families[i].name, name) == 0) {
            return &families[i];
        }
    }
    return NULL;
}
