/* Blocks that were given back stay with the process, for later ones of their size. */
#ifndef VBSS_TESTS_HARNESS_BLOCKS_H
#define VBSS_TESTS_HARNESS_BLOCKS_H

#include <stdbool.h>
#include <stddef.h>

/* Aligned to 64 bytes, of which `size` is a multiple; what is in it is not told. Never NULL: without memory it aborts. */
void *harness_block_take(size_t size);
/* What touches it from now on is an error to AddressSanitizer, until it is taken again. */
void harness_block_give_back(void *block, size_t size);
/* It is not taken again before so many bytes more have been given back: none, or with AddressSanitizer those of its own quarantine. */
size_t harness_block_delay(void);
/* Whether AddressSanitizer would complain of a look at it; false without it. */
bool harness_block_is_forbidden(const void *block);

#endif
