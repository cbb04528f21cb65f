/* XXH64 with seed 0, from its published specification. */
#include <string.h>

#include "base/hash.h"
#include "base/little_endian.h"

#define PRIME_1 0x9E3779B185EBCA87u
#define PRIME_2 0xC2B2AE3D27D4EB4Fu
#define PRIME_3 0x165667B19E3779F9u
#define PRIME_4 0x85EBCA77C2B2AE63u
#define PRIME_5 0x27D4EB2F165667C5u

static uint64_t rotate(uint64_t x, unsigned bits)
{
    return (x << bits) | (x >> (64u - bits));
}

static uint64_t mix_lane(uint64_t lane, uint64_t word)
{
    return rotate(lane + word * PRIME_2, 31) * PRIME_1;
}

/* Mixes all whole stripes of 32 bytes. The lanes are local, so that they stay in registers. */
static void mix_stripes(uint64_t lanes[4], const uint8_t *p, size_t count)
{
    uint64_t a = lanes[0], b = lanes[1], c = lanes[2], d = lanes[3];
    for (; count >= 32; count -= 32, p += 32) {
        a = mix_lane(a, load_little_endian(p, 8));
        b = mix_lane(b, load_little_endian(p + 8, 8));
        c = mix_lane(c, load_little_endian(p + 16, 8));
        d = mix_lane(d, load_little_endian(p + 24, 8));
    }
    lanes[0] = a;
    lanes[1] = b;
    lanes[2] = c;
    lanes[3] = d;
}

void vbss_hash_begin(vbss_hash *hash)
{
    memset(hash, 0, sizeof *hash);
    hash->lanes[0] = PRIME_1 + PRIME_2;
    hash->lanes[1] = PRIME_2;
    hash->lanes[2] = 0;
    hash->lanes[3] = 0u - PRIME_1;
}

/* Most pieces are headers of fields and single numbers: eight bytes. */
static void add_word(vbss_hash *hash, size_t buffered, const uint8_t *p)
{
    memcpy(hash->buffer + buffered, p, 8);
    if (buffered == 24) {
        mix_stripes(hash->lanes, hash->buffer, 32);
    }
}

static void add_bytes(vbss_hash *hash, size_t buffered, const uint8_t *p, size_t count)
{
    if (buffered > 0) {
        size_t missing = 32u - buffered;
        size_t copied = count < missing ? count : missing;
        copy_short(hash->buffer + buffered, p, copied);
        p += copied;
        count -= copied;
        if (copied < missing) {
            return;
        }
        mix_stripes(hash->lanes, hash->buffer, 32);
    }
    if (count >= 32) {
        mix_stripes(hash->lanes, p, count);
    }
    copy_short(hash->buffer, p + count / 32 * 32, count % 32);
}

void vbss_hash_add(vbss_hash *hash, const void *bytes, size_t count)
{
    if (count == 0) {
        return; /* bytes may be NULL */
    }
    const size_t buffered = (size_t)(hash->length % 32u);
    hash->length += count;
    if (count == 8 && buffered <= 24) {
        add_word(hash, buffered, bytes);
    } else {
        add_bytes(hash, buffered, bytes, count);
    }
}

uint64_t vbss_hash_end(const vbss_hash *hash)
{
    uint64_t h = PRIME_5;
    if (hash->length >= 32) {
        h = rotate(hash->lanes[0], 1) + rotate(hash->lanes[1], 7) + rotate(hash->lanes[2], 12) +
            rotate(hash->lanes[3], 18);
        for (int i = 0; i < 4; i++) {
            h = (h ^ mix_lane(0, hash->lanes[i])) * PRIME_1 + PRIME_4;
        }
    }
    h += hash->length;
    const uint8_t *p = hash->buffer;
    size_t left = (size_t)(hash->length % 32u);
    for (; left >= 8; left -= 8, p += 8) {
        h = rotate(h ^ mix_lane(0, load_little_endian(p, 8)), 27) * PRIME_1 + PRIME_4;
    }
    if (left >= 4) {
        h = rotate(h ^ load_little_endian(p, 4) * PRIME_1, 23) * PRIME_2 + PRIME_3;
        p += 4;
        left -= 4;
    }
    for (; left > 0; left--, p++) {
        h = rotate(h ^ *p * PRIME_5, 11) * PRIME_1;
    }
    h = (h ^ (h >> 33)) * PRIME_2;
    h = (h ^ (h >> 29)) * PRIME_3;
    return h ^ (h >> 32);
}
