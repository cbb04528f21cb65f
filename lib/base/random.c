/* Random numbers: PCG32 (O'Neill 2014), 64-bit state, permuted output XSH-RR. */
#include "base/elementary.h"
#include "base/linear.h"
#include "base/random.h"
#include "base/stream.h"

#define MULTIPLIER 6364136223846793005u

void vbss_random_seed(vbss_random *random, uint64_t seed, uint64_t sequence)
{
    random->increment = (sequence << 1) | 1u;
    /* the state after one step from zero, plus the seed */
    random->state = random->increment + seed;
    random->state = random->state * MULTIPLIER + random->increment;
}

uint32_t vbss_random_u32(vbss_random *random)
{
    uint64_t old = random->state;
    random->state = old * MULTIPLIER + random->increment;
    uint32_t shifted = (uint32_t)(((old >> 18) ^ old) >> 27);
    uint32_t turn = (uint32_t)(old >> 59);
    return (shifted >> turn) | (shifted << ((32u - turn) & 31u));
}

uint64_t vbss_random_u64(vbss_random *random)
{
    uint64_t high = vbss_random_u32(random);
    return high << 32 | vbss_random_u32(random);
}

uint32_t vbss_random_below(vbss_random *random, uint32_t bound)
{
    /* Draws below 2^32 mod bound would make small results likelier, so they are rejected. */
    uint32_t surplus = (0u - bound) % bound;
    uint32_t drawn;
    do {
        drawn = vbss_random_u32(random);
    } while (drawn < surplus);
    return drawn % bound;
}

double vbss_random_uniform(vbss_random *random)
{
    return (double)(vbss_random_u64(random) >> 11) * 0x1p-53;
}

/* A uniform point of the open disk or ball, by rejection. Excludes the centre; returns the squared
 * radius. */
static double inside_ball(vbss_random *random, double *coordinates, int dimension)
{
    double r2;
    do {
        r2 = 0.0;
        for (int i = 0; i < dimension; i++) {
            coordinates[i] = 2.0 * vbss_random_uniform(random) - 1.0;
            r2 += coordinates[i] * coordinates[i];
        }
    } while (r2 >= 1.0 || r2 < 1e-20);
    return r2;
}

double vbss_random_normal(vbss_random *random)
{
    /* Marsaglia's polar method. The second number of the pair is dropped to keep the state
     * small. */
    double p[2];
    double r2 = inside_ball(random, p, 2);
    return p[0] * sqrt(-2.0 * vbss_log(r2) / r2);
}

vec3 vbss_random_direction(vbss_random *random)
{
    double p[3];
    double r2 = inside_ball(random, p, 3);
    return vec3_scale(vec3_load(p), 1.0 / sqrt(r2));
}

void vbss_random_serialise(vbss_stream *stream, uint16_t tag, vbss_random *random)
{
    uint64_t words[2] = {random->state, random->increment};
    vbss_stream_u64(stream, tag, words, 2);
    if (words[1] % 2u == 0) {
        vbss_stream_refuse(stream, VBSS_ERROR_CORRUPT, "a random sequence must be odd");
    }
    if (stream->result == VBSS_OK) {
        random->state = words[0];
        random->increment = words[1];
    }
}
