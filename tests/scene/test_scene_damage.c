/* Snapshots that were damaged: refused, or taken as the states that they are. */
#include <stdlib.h>

#include "fixtures/baseline_of.h"
#include "scene/small.h"

/* Pins of each kind, contacts, events; small, so that each bit can be turned over. */
static void small_life(small *s, vbss_method method)
{
    small_begin(s);
    bool ours = method == VBSS_METHOD_IMPLICIT;
    s->config.method = s->thread.method = method;
    baseline_of(&s->thread.baseline)->thread_substeps =
        20; /* else as many as absurd tensions ask for */
    s->config.floor = ours;
    s->config.pin_capacity = 4;
    s->thread.attachment_capacity = 3;
    small_create(s);
    uint32_t line = small_thread(s, vec3_make(0.0, 1e-3, 0.0), vec3_make(8e-3, 1e-3, 0.0), 8, NULL);
    vec3 half = vec3_make(0.0, 0.0, 2e-3);
    s->rigid.gravity[1] = -9.81;
    vbss_scene_rigid_kind kind = ours ? VBSS_SCENE_RIGID_FREE : VBSS_SCENE_RIGID_DRIVEN;
    small_stick(s, kind, vec3_make(8e-3, 1e-3, 0.0), half, 1e-3);
    small_stick(s, VBSS_SCENE_RIGID_DRIVEN, vec3_make(4e-3, 2e-3, 0.0), half, 5e-4);
    small_pin(s, line, 0, 0);
    small_pin(s, line, 8, 2);
    small_pin(s, line, 4, 3);
    small_steps(s, 6, 1e-3);
    assert_true(!ours || small_statistics(s).contacts > 0);
}

static uint32_t step_damaged(small *s, const small_state *good, size_t at, uint8_t *bad)
{
    uint32_t taken = 0;
    for (int bit = 0; bit < 8; bit++) {
        memcpy(bad, good->bytes, good->count);
        bad[at] ^= (uint8_t)(1u << bit);
        harness_seal_snapshot(bad, good->count);
        if (vbss_scene_restore(s->scene, bad, good->count) == VBSS_OK) {
            taken++;
            for (int i = 0; i < 2; i++) { /* whatever comes of it, it is told */
                vbss_result result = vbss_scene_step(s->scene, 1e-3);
                assert_true(result == VBSS_OK || result == VBSS_ERROR_CAPACITY ||
                            result == VBSS_ERROR_NOT_FINITE || result == VBSS_ERROR_OUT_OF_RANGE);
            }
        }
    }
    return taken;
}

/* What is damaged under a right checksum is refused, or is a state, from which steps go on or are refused:
 * nothing else may happen. */
static void step_all_damaged(vbss_method method)
{
    small s;
    small_life(&s, method);
    small_state good = small_save(&s);
    uint8_t *bad = malloc(good.count);
    assert_non_null(bad);
    uint32_t taken = 0;
    for (size_t at = 16; at < good.count - 8; at++) {
        taken += step_damaged(&s, &good, at, bad);
    }
    assert_true(taken > 1000);
    expect_ok(vbss_scene_restore(s.scene, good.bytes, good.count));
    small_steps(&s, 1, 1e-3);
    free(bad);
    free(good.bytes);
    small_end(&s);
}

static void accepted_damaged_states_can_be_stepped(void **state)
{
    (void)state;
    step_all_damaged(VBSS_METHOD_IMPLICIT);
    step_all_damaged(VBSS_METHOD_VBLAST);
}

static void snapshot_of_newer_version_is_rejected(void **state)
{
    (void)state;
    small s;
    small_life(&s, VBSS_METHOD_IMPLICIT);
    small_state good = small_save(&s);
    uint64_t hash = small_hash(&s);
    uint32_t reported = 0;
    for (size_t at = 0; at + 16 < good.count;
         at++) { /* versions of sections, whatever their place */
        if (good.bytes[at] == 0xfe && good.bytes[at + 1] == 0xff && good.bytes[at + 3] == 0) {
            uint8_t kept = good.bytes[at + 2];
            good.bytes[at + 2] = 0x7f;
            harness_seal_snapshot(good.bytes, good.count);
            reported +=
                vbss_scene_restore(s.scene, good.bytes, good.count) == VBSS_ERROR_DATA_VERSION;
            good.bytes[at + 2] = kept;
            assert_true(small_hash(&s) == hash);
        }
    }
    assert_int_equal(reported, 2); /* of the scene, and of its thread */
    free(good.bytes);
    small_end(&s);
}

/* What a snapshot with a right checksum may hold: finite, and no place where anything could be. */
static void absurd_states_end_finite_or_are_reported(void **state)
{
    (void)state;
    const double absurd[] = {1e10, 1e30, 1e100, 1e160, 1e300, -DBL_MAX};
    for (int k = 0; k < 6 * 7; k++) {
        small s;
        small_life(&s, VBSS_METHOD_IMPLICIT);
        scene_object *o = small_object(&s);
        thread_object *t = o->bodies[0].thread.thread;
        vbss_rigid *loose = &o->bodies[1].rigid.body, *driven = &o->bodies[2].rigid.body;
        double *fields[7] = {&t->now.x[5].y,
                             &t->now.v[5].y,
                             &t->now.q[3].x,
                             &t->now.tension[2],
                             &loose->now.v.y,
                             &loose->now.w.x,
                             &driven->target_end.position.y};
        *fields[k / 6] = absurd[k % 6];
        uint64_t hash = small_hash(&s);
        vbss_result result = vbss_scene_step(s.scene, 1e-3);
        if (result != VBSS_OK) {
            assert_true(result == VBSS_ERROR_NOT_FINITE || result == VBSS_ERROR_CAPACITY);
            assert_true(small_hash(&s) == hash);
        }
        small_state kept = small_save(&s); /* reading refuses what is not finite */
        expect_ok(vbss_scene_restore(s.scene, kept.bytes, kept.count));
        (void)vbss_scene_step(s.scene, 1e-3);
        free(kept.bytes);
        small_end(&s);
    }
}

int test_scene_damage(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(accepted_damaged_states_can_be_stepped),
        cmocka_unit_test(snapshot_of_newer_version_is_rejected),
        cmocka_unit_test(absurd_states_end_finite_or_are_reported),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
