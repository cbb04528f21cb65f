/* A zlib stream: repeats found through chains of hashes, written with the fixed Huffman code. */
#include "picture.h"

#include <stdlib.h>
#include <string.h>

/* ---- bytes that grow */

void bytes_add(bytes *to, const void *data, size_t count)
{
    if (to->failed || count > SIZE_MAX / 4 - to->count) {
        to->failed = true;
        return;
    }
    if (to->count + count > to->room) {
        size_t room = (to->count + count) * 2 + 1024;
        uint8_t *grown = realloc(to->data, room);
        if (grown == NULL) {
            to->failed = true;
            return;
        }
        to->data = grown;
        to->room = room;
    }
    if (count > 0) {
        memcpy(to->data + to->count, data, count);
        to->count += count;
    }
}

void bytes_free(bytes *b)
{
    free(b->data);
    *b = (bytes){.data = NULL};
}

/* ---- bits, the lowest first */

typedef struct bit_writer {
    bytes *to;
    uint32_t held;
    unsigned held_count;
} bit_writer;

static void put_bits(bit_writer *w, uint32_t value, unsigned count)
{
    w->held |= value << w->held_count;
    w->held_count += count;
    while (w->held_count >= 8) {
        uint8_t byte = (uint8_t)(w->held & 255);
        bytes_add(w->to, &byte, 1);
        w->held >>= 8;
        w->held_count -= 8;
    }
}

/* Huffman codes go out from their highest bit. */
static void put_code(bit_writer *w, uint32_t code, unsigned count)
{
    uint32_t turned = 0;
    for (unsigned i = 0; i < count; i++) {
        turned |= (code >> i & 1) << (count - 1 - i);
    }
    put_bits(w, turned, count);
}

/* ---- the fixed code of RFC 1951, 3.2.6 */

static void put_symbol(bit_writer *w, uint32_t symbol)
{
    if (symbol < 144) {
        put_code(w, 0x30 + symbol, 8);
    } else if (symbol < 256) {
        put_code(w, 0x190 + symbol - 144, 9);
    } else if (symbol < 280) {
        put_code(w, symbol - 256, 7);
    } else {
        put_code(w, 0xc0 + symbol - 280, 8);
    }
}

/* Lengths and distances are told by a symbol, groups of which have one extra bit more each time:
 * `group` of them before the extra bits begin to grow. */
static void split_value(uint32_t value, uint32_t group, uint32_t *symbol, unsigned *extra)
{
    unsigned bits = 0;
    while (value >> bits >= 2 * group) {
        bits++;
    }
    *extra = bits;
    *symbol = bits * group + (value >> bits);
}

static void put_repeat(bit_writer *w, uint32_t length, uint32_t distance)
{
    uint32_t symbol;
    unsigned extra;
    if (length == 258) {
        put_symbol(w, 285);
    } else {
        split_value(length - 3, 4, &symbol, &extra);
        put_symbol(w, 257 + symbol);
        put_bits(w, (length - 3) & ((1u << extra) - 1), extra);
    }
    split_value(distance - 1, 2, &symbol, &extra);
    put_code(w, symbol, 5);
    put_bits(w, (distance - 1) & ((1u << extra) - 1), extra);
}

/* ---- repeats */

enum { WINDOW = 32768, HASHES = 32768, LONGEST = 258, SHORTEST = 3, PATIENCE = 48 };

typedef struct matcher {
    const uint8_t *data;
    size_t count;
    size_t head[HASHES];     /* 1 + where bytes of that hash last began; 0: nowhere */
    size_t previous[WINDOW]; /* the one before it, by place modulo the window */
} matcher;

static size_t hash_at(const uint8_t *b)
{
    uint32_t three = (uint32_t)b[0] | (uint32_t)b[1] << 8 | (uint32_t)b[2] << 16;
    return (three * 0x9e3779b1u) >> 17;
}

static void remember(matcher *m, size_t at)
{
    if (at + SHORTEST <= m->count) {
        size_t hash = hash_at(m->data + at);
        m->previous[at % WINDOW] = m->head[hash];
        m->head[hash] = at + 1;
    }
}

static uint32_t longest_repeat(const matcher *m, size_t at, uint32_t *distance)
{
    uint32_t best = 0;
    if (at + SHORTEST > m->count) {
        return 0;
    }
    uint32_t largest = m->count - at < LONGEST ? (uint32_t)(m->count - at) : LONGEST;
    size_t candidate = m->head[hash_at(m->data + at)];
    for (int tries = 0; candidate != 0 && tries < PATIENCE; tries++) {
        size_t from = candidate - 1;
        if (at - from > WINDOW - 1) {
            break;
        }
        uint32_t length = 0;
        while (length < largest && m->data[from + length] == m->data[at + length]) {
            length++;
        }
        if (length > best) {
            best = length;
            *distance = (uint32_t)(at - from);
        }
        if (best == largest) {
            break;
        }
        candidate = m->previous[from % WINDOW];
    }
    return best >= SHORTEST ? best : 0;
}

static void put_all(bit_writer *w, matcher *m)
{
    size_t at = 0;
    while (at < m->count) {
        uint32_t distance = 0, next_distance = 0;
        uint32_t length = longest_repeat(m, at, &distance);
        remember(m, at);
        /* A longer repeat from the next byte on is worth one byte more. */
        if (length == 0 || (length < 32 && longest_repeat(m, at + 1, &next_distance) > length)) {
            put_symbol(w, m->data[at++]);
            continue;
        }
        put_repeat(w, length, distance);
        for (uint32_t i = 1; i < length; i++) {
            remember(m, at + i);
        }
        at += length;
    }
}

/* ---- the stream of RFC 1950 */

static uint32_t adler32(const uint8_t *data, size_t count)
{
    uint32_t a = 1, b = 0;
    for (size_t i = 0; i < count; i++) {
        a = (a + data[i]) % 65521;
        b = (b + a) % 65521;
    }
    return b << 16 | a;
}

void bytes_add_zlib(bytes *to, const uint8_t *data, size_t count)
{
    matcher *m = calloc(1, sizeof *m);
    if (m == NULL) {
        to->failed = true;
        return;
    }
    m->data = data;
    m->count = count;
    bytes_add(to, (const uint8_t[2]){0x78, 0x9c}, 2);
    bit_writer w = {.to = to};
    put_bits(&w, 1, 1); /* the last block */
    put_bits(&w, 1, 2); /* fixed code */
    put_all(&w, m);
    put_symbol(&w, 256);
    put_bits(&w, 0, (8 - w.held_count) % 8);
    uint32_t sum = adler32(data, count);
    const uint8_t end[4] = {(uint8_t)(sum >> 24), (uint8_t)(sum >> 16 & 255),
                            (uint8_t)(sum >> 8 & 255), (uint8_t)(sum & 255)};
    bytes_add(to, end, sizeof end);
    free(m);
}
