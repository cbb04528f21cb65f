/* Random numbers: PCG32 with XSH-RR output, with the same sequence on every machine. */
#ifndef VBSS_BASE_RANDOM_H
#define VBSS_BASE_RANDOM_H

#include <stdint.h>

#include "base/linear.h"
#include "base/stream.h"

typedef struct vbss_random {
    uint64_t state, increment;
} vbss_random;
/* Different values of `sequence` give independent sequences for one seed. */
void vbss_random_seed(vbss_random *random, uint64_t seed, uint64_t sequence);
uint32_t vbss_random_u32(vbss_random *random);
uint64_t vbss_random_u64(vbss_random *random);
/* uniform in [0, bound), unbiased; bound > 0 */
uint32_t vbss_random_below(vbss_random *random, uint32_t bound);
double vbss_random_uniform(vbss_random *random); /* uniform in [0, 1), 53 bits */
/* normal with mean 0 and standard deviation 1 */
double vbss_random_normal(vbss_random *random);
vec3 vbss_random_direction(vbss_random *random); /* uniform on the unit sphere */
/* Visits the generator's state as one field with this tag. */
void vbss_random_serialise(vbss_stream *stream, uint16_t tag, vbss_random *random);

#endif
