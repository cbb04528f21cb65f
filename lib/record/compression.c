/* Compression of four-byte words by literals and matches (LZ77).
 *
 * The compressed bytes are sequences of literal words and a match. Literals that end the words have
 * no match after them.
 *
 *     u8   number of literals << 4 | length of the match - 2
 *     the literals
 *     u16  offset of the match: its distance back, in words
 *
 * A nibble of 15 is extended by bytes that are added to it, up to and including the first below
 * 255. Extensions precede the literals and the offset, respectively. The last one to three bytes
 * follow uncompressed. */
#include "record/compression.h"

#include <string.h>

#include "base/little_endian.h"

enum { WORD_BYTES = 4, MIN_MATCH = 2, NIBBLE_MAX = 15, EXTENSION_MAX = 255, MAX_OFFSET = 65535 };

/* ---- compression */

typedef struct compressor {
    uint8_t *compressed;
    size_t position, capacity;
    bool is_full;
} compressor;

static void append_bytes(compressor *p, const uint8_t *bytes, size_t count)
{
    p->is_full = p->is_full || count > p->capacity - p->position;
    if (!p->is_full) {
        memcpy(p->compressed + p->position, bytes, count);
        p->position += count;
    }
}

static void append_byte(compressor *p, size_t value)
{
    const uint8_t byte = (uint8_t)value;
    append_bytes(p, &byte, 1);
}

static void put_length_extension(compressor *p, size_t number)
{
    if (number >= NIBBLE_MAX) {
        for (number -= NIBBLE_MAX; number >= EXTENSION_MAX; number -= EXTENSION_MAX) {
            append_byte(p, EXTENSION_MAX);
        }
        append_byte(p, number);
    }
}

/* `match` is 0 in the last sequence. */
static void put_sequence(compressor *p, const uint8_t *literals, size_t count, size_t match,
                         size_t offset)
{
    size_t extra = match > 0 ? match - MIN_MATCH : 0;
    append_byte(p, (count < NIBBLE_MAX ? count : NIBBLE_MAX) << 4 |
                       (extra < NIBBLE_MAX ? extra : NIBBLE_MAX));
    put_length_extension(p, count);
    append_bytes(p, literals, WORD_BYTES * count);
    if (match > 0) {
        put_length_extension(p, extra);
        append_byte(p, offset & 0xffu);
        append_byte(p, offset >> 8);
    }
}

static uint32_t hash_words(const uint8_t *words)
{
    uint32_t first = (uint32_t)load_little_endian(words, 4);
    uint32_t second = (uint32_t)load_little_endian(words + 4, 4);
    return (first * 0x9e3779b1u ^ second * 0x85ebca77u) >> 20;
}

/* Number of words from i on that equal those from `candidate` on. */
static size_t match_length(const uint8_t *raw, size_t words, size_t candidate, size_t i)
{
    size_t match = 0;
    while (i + match < words && memcmp(raw + WORD_BYTES * (candidate + match),
                                       raw + WORD_BYTES * (i + match), WORD_BYTES) == 0) {
        match++;
    }
    return match;
}

size_t vbss_log_compress(uint32_t table[LOG_HASH_TABLE_SIZE], const uint8_t *raw, size_t count,
                         uint8_t *compressed, size_t capacity)
{
    compressor p = {.capacity = capacity};
    const size_t words = count / WORD_BYTES < UINT32_MAX ? count / WORD_BYTES : 0;
    size_t i = 0, literals = 0; /* literals: words before i that are not written yet */
    p.compressed = compressed;
    memset(table, 0, LOG_HASH_TABLE_SIZE * sizeof table[0]);
    while (i + 1 < words && !p.is_full) {
        uint32_t *entry = &table[hash_words(raw + WORD_BYTES * i)];
        size_t candidate = *entry, match = 0; /* index + 1; 0: none */
        if (candidate > 0 && i - (candidate - 1) <= MAX_OFFSET) {
            match = match_length(raw, words, candidate - 1, i);
        }
        *entry = (uint32_t)i + 1;
        if (match >= MIN_MATCH) {
            put_sequence(&p, raw + WORD_BYTES * (i - literals), literals, match,
                         i - (candidate - 1));
            literals = 0;
            i += match;
        } else {
            literals++;
            i++;
        }
    }
    literals += words - i;
    if (literals > 0) {
        put_sequence(&p, raw + WORD_BYTES * (words - literals), literals, 0, 0);
    }
    append_bytes(&p, raw + WORD_BYTES * words, count - WORD_BYTES * words);
    return p.is_full ? 0 : p.position;
}

/* ---- decompression */

typedef struct decompressor {
    const uint8_t *compressed;
    size_t position, count;
    bool overrun;
} decompressor;

static const uint8_t *read_bytes(decompressor *u, size_t count)
{
    static const uint8_t nothing[2];
    u->overrun = u->overrun || count > u->count - u->position;
    if (u->overrun) {
        return nothing;
    }
    u->position += count;
    return u->compressed + u->position - count;
}

static size_t get_length(decompressor *u, size_t nibble)
{
    size_t number = nibble, extra = EXTENSION_MAX;
    while (nibble == NIBBLE_MAX && extra == EXTENSION_MAX) {
        extra = *read_bytes(u, 1);
        number += extra;
    }
    return number;
}

bool vbss_log_decompress(const uint8_t *compressed, size_t compressed_count, uint8_t *raw,
                         size_t count)
{
    decompressor u = {.compressed = compressed, .count = compressed_count};
    const size_t words = count / WORD_BYTES, tail = count % WORD_BYTES;
    for (size_t done = 0; done < words;) {
        size_t token = *read_bytes(&u, 1), literals = get_length(&u, token >> 4);
        if (u.overrun || literals > words - done) {
            return false;
        }
        const uint8_t *bytes = read_bytes(&u, WORD_BYTES * literals);
        if (raw != NULL && !u.overrun) {
            memcpy(raw + WORD_BYTES * done, bytes, WORD_BYTES * literals);
        }
        done += literals;
        if (done < words) {
            size_t match = get_length(&u, token & NIBBLE_MAX) + MIN_MATCH;
            size_t offset = (size_t)load_little_endian(read_bytes(&u, 2), 2);
            if (u.overrun || match > words - done || offset == 0 || offset > done) {
                return false;
            }
            /* Byte by byte, because a match may overlap its own copy. */
            for (size_t i = 0; raw != NULL && i < WORD_BYTES * match; i++) {
                raw[WORD_BYTES * done + i] = raw[WORD_BYTES * (done - offset) + i];
            }
            done += match;
        }
    }
    const uint8_t *bytes = read_bytes(&u, tail);
    if (raw != NULL && !u.overrun) {
        memcpy(raw + WORD_BYTES * words, bytes, tail);
    }
    return !u.overrun && u.position == u.count;
}
