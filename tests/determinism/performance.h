/* A performance of the scripted surgeon of examples/surgeon, as the determinism table hashes it. */
#ifndef VBSS_TESTS_DETERMINISM_PERFORMANCE_H
#define VBSS_TESTS_DETERMINISM_PERFORMANCE_H

#include <stddef.h>
#include <stdint.h>

#include <vblast_ss/base.h>

/* Performs the whole task with a seed's hands, and hashes scene and session after every `every` steps of 1 ms and, if
 * the performance ends before there are `most` hashes, at its end. `count` receives how many there are. */
vbss_result performance_run(uint64_t seed, uint32_t every, uint64_t *hashes, size_t limit,
                            size_t *count);

#endif
