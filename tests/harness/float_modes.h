/* Floating-point modes that a host may have set, all of them other than the library's. */
#ifndef VBSS_TESTS_FLOAT_MODES_H
#define VBSS_TESTS_FLOAT_MODES_H

#include <stdbool.h>
#include <stddef.h>

/* Number of modes; 0 on a processor whose modes this file does not know. */
extern const size_t harness_mode_count;

/* Sets mode k, or the default mode. */
void harness_mode_set(size_t k);
void harness_mode_reset(void);
/* Whether mode k is in force, apart from sticky exception flags. */
bool harness_mode_is(size_t k);
/* Asserts that mode k is still in force, and sets the default mode. Ends what harness_mode_set
 * began. */
void harness_mode_end(size_t k);

#endif
