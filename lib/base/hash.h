/* Hash: XXH64 with seed 0, so that any xxhash tool can check a file. */
#ifndef VBSS_BASE_HASH_H
#define VBSS_BASE_HASH_H

#include <stddef.h>
#include <stdint.h>

typedef struct vbss_hash {
    uint64_t lanes[4];
    uint64_t length;
    uint8_t buffer[32];
} vbss_hash;
void vbss_hash_begin(vbss_hash *hash);
void vbss_hash_add(vbss_hash *hash, const void *bytes, size_t count);
uint64_t vbss_hash_end(const vbss_hash *hash);

#endif
