/* Logs to be damaged, and all that can be done with one that is. */
#ifndef VBSS_TESTS_RECORD_DAMAGE_H
#define VBSS_TESTS_RECORD_DAMAGE_H

#include "fixture.h"

#define HEAD VBSS_CODE('H', 'E', 'A', 'D')
#define SNAP VBSS_CODE('S', 'N', 'A', 'P')
#define STEP VBSS_CODE('S', 'T', 'E', 'P')
#define ENDS VBSS_CODE('E', 'N', 'D', 'S')

typedef struct damage {
    stage s; /* where logs are replayed; as it was when the good one began */
    log_bytes good;
    uint32_t steps;
} damage;

static inline void damage_begin(damage *d, uint32_t steps)
{
    stage recorded;
    stage_begin(&recorded, NULL);
    stage_begin(&d->s, NULL);
    d->good = log_of(&recorded, NULL, steps);
    d->steps = steps;
    stage_end(&recorded);
}

static inline void damage_end(damage *d)
{
    log_free(&d->good);
    stage_end(&d->s);
}

/* All that can be done with a log, on a copy that ends where it ends; the first failure and the number of
 * steps that check and replay agree on. */
static inline vbss_result damage_read(damage *d, const log_bytes *log, uint64_t *steps)
{
    vbss_replay *replay;
    vbss_replay_report report = {0};
    uint8_t *exact = malloc(log->count > 0 ? log->count : 1);
    assert_non_null(exact);
    memcpy(exact, log->bytes, log->count);
    *steps = 0;
    vbss_result checked = vbss_replay_create(d->s.context, exact, log->count, &replay);
    assert_true((replay == NULL) == (checked != VBSS_OK));
    if (checked == VBSS_OK) {
        checked = vbss_replay_check(replay, steps);
        if (vbss_replay_begin(replay, d->s.scene) == VBSS_OK) {
            vbss_result result = replay_all(replay, &report);
            assert_true((result != VBSS_OK) == (report.outcome == VBSS_REPLAY_OUTCOME_STOPPED));
            assert_true(report.step <= *steps);
            assert_true(report.outcome != VBSS_REPLAY_OUTCOME_ENDED || checked == VBSS_OK);
        }
        expect_ok(vbss_replay_destroy(replay));
    }
    free(exact);
    return checked;
}

static inline void damage_expect(damage *d, const log_bytes *log, vbss_result wanted,
                                 uint64_t steps)
{
    uint64_t found;
    expect_result(wanted, damage_read(d, log, &found));
    assert_int_equal(found, steps);
    assert_true(wanted == VBSS_OK || strlen(last_text(d->s.context)) > 0);
}

/* The one word of a field of the scene's configuration in the head of a log. */
static inline uint8_t *damage_config_word(const log_bytes *log, uint8_t tag)
{
    const uint8_t header[8] = {tag, 0, 3, 0, 1, 0, 0, 0};
    const log_place head = log_find(log, HEAD, 1);
    uint8_t *at = log->bytes + head.at;
    while (memcmp(at, "CONF", 4) != 0) {
        at++;
    }
    for (at += 4; memcmp(at, header, sizeof header) != 0; at += 12) {
        assert_true(at + 12 < log->bytes + head.next); /* all before it are words too */
    }
    return at + 8;
}

/* A log with records left out, moved or doubled: places of `from` in the order of `order`, 0 ends. */
static inline log_bytes damage_shuffled(const log_bytes *from, const log_place *order)
{
    log_bytes log = {malloc(2 * from->count), 8};
    assert_non_null(log.bytes);
    memcpy(log.bytes, from->bytes, 8);
    for (; order->next != 0; order++) {
        memcpy(log.bytes + log.count, from->bytes + order->at, order->next - order->at);
        log.count += order->next - order->at;
    }
    return log;
}

#endif
