/* A scene with a log that has a hash of each step, and what a replay of the log must find: the same bits, forward and sought. */
#ifndef VBSS_TESTS_RECORD_REPLAYED_H
#define VBSS_TESTS_RECORD_REPLAYED_H

#include "fixture.h"

/* What the log is made of, and what else a replay must find after step k; both get `user`. */
typedef struct replayed {
    vbss_scene *scene;
    uint32_t steps, snapshot_interval;
    void *user;
    void (*step)(void *user, uint32_t k);
    void (*check)(void *user, vbss_scene *scene, uint32_t k); /* may be NULL */
} replayed;

uint64_t hash_of(vbss_scene *scene);
/* hashes: of the state before the first step and after each. */
log_bytes replayed_log(const replayed *r, uint64_t *hashes);
/* Each step from the first to the last, then those `sought`, from snapshots inside the log. */
void expect_replayed(const replayed *r, const log_bytes *log, const uint64_t *hashes,
                     const uint32_t *sought, size_t sought_count);

#endif
