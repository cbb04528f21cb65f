/* XXH64 with seed 0, the hash of snapshots and logs; any xxhash tool can check it. */
#ifndef VBSS_BASE_HASH_H
#define VBSS_BASE_HASH_H

#include <stddef.h>
#include <stdint.h>

typedef struct vbss_hash {
    uint64_t lanes[4];  /* accumulators */
    uint64_t length;    /* bytes so far */
    uint8_t buffer[32]; /* the last length % 32 bytes, which do not fill a stripe yet */
} vbss_hash;
/* Starts a hash. */
void vbss_hash_begin(vbss_hash *hash);
/* Adds bytes. Pieces of any size give the hash of the whole; `bytes` may be NULL if count is 0. */
void vbss_hash_add(vbss_hash *hash, const void *bytes, size_t count);
/* Hash of all bytes added so far; more bytes may follow. */
uint64_t vbss_hash_end(const vbss_hash *hash);

#endif
