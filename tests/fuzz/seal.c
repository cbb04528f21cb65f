#include <string.h>

#include "base/hash.h"
#include "base/little_endian.h"
#include "base/stream.h"
#include "fuzz/fuzz.h"

#define SNAPSHOT VBSS_CODE('S', 'N', 'A', 'P')
#define STATE VBSS_CODE('s', 't', 'a', 't')

void seal_snapshot(uint8_t *bytes, size_t count)
{
    enum { DESCRIBED_FORMAT = 2, HEADER = 16, DESCRIBED_HEADER = 24, CHECKSUM = 8 };
    vbss_hash hash;
    const size_t header = count > 4 && bytes[4] == DESCRIBED_FORMAT ? DESCRIBED_HEADER : HEADER;
    if (count < header + CHECKSUM) {
        return;
    }
    const uint64_t room = count - header - CHECKSUM;
    if (header == DESCRIBED_HEADER) { /* both parts fill the room, wherever the border is */
        const uint64_t state = load_little_endian(bytes + 8, 8) % (room + 1);
        store_little_endian(bytes + 8, state, 8);
        store_little_endian(bytes + 16, room - state, 8);
    } else {
        store_little_endian(bytes + 8, room, 8);
    }
    vbss_hash_begin(&hash);
    vbss_hash_add(&hash, bytes, count - 8);
    store_little_endian(bytes + count - 8, vbss_hash_end(&hash), 8);
}

/* section 8, number 8 + 8, count 8 + 4, header 8, the snapshot, end 8; a packed one has a newer version */
static void seal_inside(uint8_t *section, size_t count)
{
    enum { BEFORE = 44, AFTER = 8 };
    uint32_t code = count > BEFORE + AFTER ? (uint32_t)load_little_endian(section + 4, 4) : 0;
    uint64_t version = code == 0 ? 0 : load_little_endian(section + 2, 2);
    if ((code == SNAPSHOT && version <= 2) || (code == STATE && version == 1)) {
        seal_snapshot(section + BEFORE, count - BEFORE - AFTER);
    }
}

void seal_log(uint8_t *bytes, size_t count)
{
    uint8_t before[8];
    if (count < 8) {
        return;
    }
    memcpy(before, bytes, 8);
    for (size_t at = 8; count - at >= 16;) {
        const bool coded = (bytes[at + 3] & 0xc0u) == 0xc0u; /* a step as bits */
        size_t front = coded ? 4 : 8;
        size_t length = (size_t)load_little_endian(bytes + at, front / 2);
        if (length > count - at - front - 8 || (coded && length > 0x3fff)) {
            return;
        }
        store_little_endian(bytes + at + front / 2, ~(uint64_t)length, front / 2);
        if (!coded) {
            seal_inside(bytes + at + front, length);
        }
        vbss_hash hash;
        vbss_hash_begin(&hash);
        vbss_hash_add(&hash, before, 8);
        vbss_hash_add(&hash, bytes + at, front + length);
        store_little_endian(before, vbss_hash_end(&hash), 8);
        memcpy(bytes + at + front + length, before, 8);
        at += front + length + 8;
    }
}
