/* Restored snapshots: of the present state, earlier ones, and damaged ones. */
#include "fuzz/scenes/fuzzed_scene.h"

#include <stdlib.h>
#include <string.h>

static void copy_bytes(fuzz_bytes *to, const fuzz_bytes *from)
{
    if (to->data == NULL || to->room < from->count) {
        free(to->data);
        to->room = 2 * from->count;
        to->data = malloc(to->room);
    }
    to->count = to->data == NULL ? 0 : from->count;
    if (to->data != NULL) {
        memcpy(to->data, from->data, from->count);
    }
}

/* One of the twins is restored to the state that it has. From then on it must go on as the other. */
static void restore_one(fuzz_scene *f)
{
    const uint32_t k = fuzz_below(f, FUZZ_SIDES);
    const fuzz_bytes *now = &f->sides[0].snapshot;
    fuzz_trace(f, "of the present state, side %u", k);
    fuzz_begin_call(f, "vbss_scene_restore");
    fuzz_start_clock(f);
    vbss_result result = vbss_scene_restore(f->sides[k].scene, now->data, now->count);
    fuzz_end_on_side(f, k, result);
    if (result != VBSS_OK) {
        const char *text = "";
        (void)vbss_context_get_last_error(f->sides[k].context, NULL, &text);
        fuzz_fail(f, FUZZ_CHECK_RESTORE, "the present state is refused: %s: %s",
                  vbss_result_name(result), text);
    }
    fuzz_save(f, 0, &f->sides[0].snapshot);
    fuzz_compare_twins(f);
}

static void keep(fuzz_scene *f)
{
    copy_bytes(&f->earlier, &f->sides[0].snapshot);
}

/* It may be refused: bodies have been added or removed since. */
static void go_back(fuzz_scene *f)
{
    if (f->earlier.count > 0) {
        fuzz_trace(f, "of an earlier state");
        FUZZ_CALL(f, vbss_scene_restore(side->scene, f->earlier.data, f->earlier.count));
        f->witness.was_clear = false;
    }
}

static void restore_damaged(fuzz_scene *f)
{
    fuzz_bytes damaged = {NULL, 0, 0};
    copy_bytes(&damaged, &f->sides[0].snapshot);
    if (fuzz_chance(f, 0.5)) {
        damaged.count = fuzz_below(f, (uint32_t)damaged.count);
    } else {
        const uint32_t at = fuzz_below(f, (uint32_t)damaged.count);
        damaged.data[at] ^= (uint8_t)(1 + fuzz_below(f, 255));
    }
    fuzz_trace(f, "of a damaged state");
    FUZZ_CALL(f, vbss_scene_restore(side->scene, damaged.data, damaged.count));
    if (f->results[0] == VBSS_OK) {
        fuzz_fail(f, FUZZ_CHECK_RESTORE, "a damaged state is accepted");
    }
    free(damaged.data);
}

void fuzz_restore_at_random(fuzz_scene *f)
{
    static void (*const restores[])(fuzz_scene * f) = {restore_one, restore_one, restore_one,
                                                       keep,        go_back,     restore_damaged};
    restores[fuzz_below(f, sizeof restores / sizeof restores[0])](f);
}
