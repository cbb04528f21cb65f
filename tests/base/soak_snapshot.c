/* Soak: a body's snapshots under random damage, against a model that knows what is allowed. */
#include <stdlib.h>
#include <string.h>

#include "base/snapshot.h"
#include "harness/harness.h"
#include "fixtures/rod_body.h"

enum { ROUNDS = 2000 };

static void run(harness_soak *soak)
{
    vbss_random random;
    vbss_random_seed(&random, soak->seed, 1);
    vbss_context *context;
    rod_config config;
    rod *handle;
    vbss_slot *slot;
    rod_config_init(&config, sizeof config);
    config.node_count = 2 + vbss_random_below(&random, 20);
    config.seed = soak->seed;
    if (vbss_context_create(NULL, &context) != VBSS_OK ||
        rod_create(context, &config, &handle) != VBSS_OK ||
        vbss_slot_open(handle, &rod_kind, &slot) != VBSS_OK) {
        harness_soak_fail(soak, "cannot start");
        return;
    }
    double refused = 0, taken = 0;
    for (int round = 0; round < ROUNDS; round++) {
        size_t count = 0, written = 0;
        uint64_t before = 0, after = 0;
        rod_step(handle, 1e-3);
        vbss_snapshot_size(slot, &count);
        uint8_t *bytes = malloc(count);
        vbss_snapshot_save(slot, bytes, count, &written);
        rod_step(handle, 1e-3);
        vbss_snapshot_hash(slot, &before);
        uint32_t hits = vbss_random_below(&random, 4);
        for (uint32_t i = 0; i < hits; i++) {
            bytes[vbss_random_below(&random, (uint32_t)count)] ^=
                (uint8_t)(1u << vbss_random_below(&random, 8));
        }
        bool sealed = vbss_random_below(&random, 2) == 0;
        if (sealed) {
            harness_seal_snapshot(bytes, count); /* now only the visitor can tell */
        }
        vbss_result result = vbss_snapshot_restore(slot, bytes, count);
        vbss_snapshot_hash(slot, &after);
        if (result != VBSS_OK && after != before) {
            harness_soak_fail(soak, "round %d: refused and changed", round);
        }
        if (result == VBSS_OK && after == before) {
            harness_soak_fail(soak, "round %d: taken and not changed", round);
        }
        if (result == VBSS_OK && hits > 0 && !sealed) {
            /* Two hits on one bit undo each other. */
            uint8_t *again = malloc(count);
            vbss_snapshot_save(slot, again, count, &written);
            if (memcmp(again, bytes, count) != 0) {
                harness_soak_fail(soak, "round %d: damage went unseen", round);
            }
            free(again);
        }
        (result == VBSS_OK ? &taken : &refused)[0] += 1;
        free(bytes);
    }
    harness_soak_figure(soak, "refused", refused);
    harness_soak_figure(soak, "taken", taken);
    vbss_context_destroy(context);
}

int main(int argc, char **argv)
{
    return harness_soak_main(argc, argv, run);
}
