/* Sequences of literal words, each but the last followed by a run of words that stood before:
 *   u8 number of literals << 4 | length of the run - 2, a part of 15 goes on in bytes up to one below 255;
 *   the literals; u16 how many words before the run stood.
 * The last one to three bytes stand behind as they are. */
#include "record/pack.h"

#include <string.h>

#include "base/little_endian.h"

enum { WORD = 4, LEAST_RUN = 2, PART = 15, MORE = 255, FARTHEST = 65535 };

/* ---- packing */

typedef struct packer {
    uint8_t *packed;
    size_t at, room;
    bool full;
} packer;

static void put(packer *p, const uint8_t *bytes, size_t count)
{
    p->full = p->full || count > p->room - p->at;
    if (!p->full) {
        memcpy(p->packed + p->at, bytes, count);
        p->at += count;
    }
}

static void put_byte(packer *p, size_t value)
{
    const uint8_t byte = (uint8_t)value;
    put(p, &byte, 1);
}

static void put_rest(packer *p, size_t number)
{
    if (number >= PART) {
        for (number -= PART; number >= MORE; number -= MORE) {
            put_byte(p, MORE);
        }
        put_byte(p, number);
    }
}

/* run: 0 for the last sequence */
static void put_sequence(packer *p, const uint8_t *literals, size_t count, size_t run, size_t back)
{
    size_t more = run > 0 ? run - LEAST_RUN : 0;
    put_byte(p, (count < PART ? count : PART) << 4 | (more < PART ? more : PART));
    put_rest(p, count);
    put(p, literals, WORD * count);
    if (run > 0) {
        put_rest(p, more);
        put_byte(p, back & 0xffu);
        put_byte(p, back >> 8);
    }
}

static uint32_t place_of(const uint8_t *words)
{
    uint32_t first = (uint32_t)load_little_endian(words, 4);
    uint32_t second = (uint32_t)load_little_endian(words + 4, 4);
    return (first * 0x9e3779b1u ^ second * 0x85ebca77u) >> 20;
}

/* Words from i on that stood the same from `before` on. */
static size_t run_of(const uint8_t *raw, size_t words, size_t before, size_t i)
{
    size_t run = 0;
    while (i + run < words &&
           memcmp(raw + WORD * (before + run), raw + WORD * (i + run), WORD) == 0) {
        run++;
    }
    return run;
}

size_t vbss_log_pack(uint32_t table[LOG_PACK_PLACES], const uint8_t *raw, size_t count,
                     uint8_t *packed, size_t room)
{
    packer p = {.room = room};
    const size_t words = count / WORD < UINT32_MAX ? count / WORD : 0;
    size_t i = 0, literals = 0; /* those before i that no sequence has yet */
    p.packed = packed;
    memset(table, 0, LOG_PACK_PLACES * sizeof table[0]);
    while (i + 1 < words && !p.full) {
        uint32_t *place = &table[place_of(raw + WORD * i)];
        size_t before = *place, run = 0; /* one above */
        if (before > 0 && i - (before - 1) <= FARTHEST) {
            run = run_of(raw, words, before - 1, i);
        }
        *place = (uint32_t)i + 1;
        if (run >= LEAST_RUN) {
            put_sequence(&p, raw + WORD * (i - literals), literals, run, i - (before - 1));
            literals = 0;
            i += run;
        } else {
            literals++;
            i++;
        }
    }
    literals += words - i;
    if (literals > 0) {
        put_sequence(&p, raw + WORD * (words - literals), literals, 0, 0);
    }
    put(&p, raw + WORD * words, count - WORD * words);
    return p.full ? 0 : p.at;
}

/* ---- unpacking */

typedef struct unpacker {
    const uint8_t *packed;
    size_t at, count;
    bool beyond;
} unpacker;

static const uint8_t *get(unpacker *u, size_t count)
{
    static const uint8_t nothing[2];
    u->beyond = u->beyond || count > u->count - u->at;
    if (u->beyond) {
        return nothing;
    }
    u->at += count;
    return u->packed + u->at - count;
}

static size_t get_rest(unpacker *u, size_t part)
{
    size_t number = part, more = MORE;
    while (part == PART && more == MORE) {
        more = *get(u, 1);
        number += more;
    }
    return number;
}

bool vbss_log_unpack(const uint8_t *packed, size_t packed_count, uint8_t *raw, size_t count)
{
    unpacker u = {.packed = packed, .count = packed_count};
    const size_t words = count / WORD, tail = count % WORD;
    for (size_t done = 0; done < words;) {
        size_t parts = *get(&u, 1), literals = get_rest(&u, parts >> 4);
        if (u.beyond || literals > words - done) {
            return false;
        }
        const uint8_t *bytes = get(&u, WORD * literals);
        if (raw != NULL && !u.beyond) {
            memcpy(raw + WORD * done, bytes, WORD * literals);
        }
        done += literals;
        if (done < words) {
            size_t run = get_rest(&u, parts & PART) + LEAST_RUN;
            size_t back = (size_t)load_little_endian(get(&u, 2), 2);
            if (u.beyond || run > words - done || back == 0 || back > done) {
                return false;
            }
            for (size_t i = 0; raw != NULL && i < WORD * run;
                 i++) { /* the run may reach into itself */
                raw[WORD * done + i] = raw[WORD * (done - back) + i];
            }
            done += run;
        }
    }
    const uint8_t *bytes = get(&u, tail);
    if (raw != NULL && !u.beyond) {
        memcpy(raw + WORD * words, bytes, tail);
    }
    return !u.beyond && u.at == u.count;
}
