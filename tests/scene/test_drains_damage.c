/* Snapshots of scenes with a drain that were damaged: refused, or taken as the states that they are. */
#include <stdlib.h>

#include "scene/drains_rig.h"

/* A drain with attachments of each kind, a tool and a thread on it. */
static vbss_drain *begin_life(small *s, drain_hands *hands)
{
    expect_ok(drain_hands_init(hands));
    hands->drain_config.attachment_capacity = 3;
    vbss_drain *drain = drains_rig_begin(s, hands);
    vbss_drain_places places;
    vbss_drain_attachment a;
    uint32_t id;
    expect_ok(vbss_drain_get_places(drain, &places, sizeof places));
    const uint32_t nodes[] = {places.marks[0], places.gap_points[0], places.marks[0]};
    for (int32_t kind = VBSS_DRAIN_ATTACHMENT_PIN; kind <= VBSS_DRAIN_ATTACHMENT_SPRING; kind++) {
        expect_ok(vbss_drain_attachment_init(&a, sizeof a));
        a.kind = kind;
        a.node = nodes[kind];
        a.stiffness = 10.0;
        a.force[1] = 1e-3;
        vec3_store(a.position, drains_rig_object(drain)->x[a.node]);
        expect_ok(vbss_drain_attach(drain, &a, &id));
    }
    drains_rig_steps(s, 70);
    assert_true(small_statistics(s).contacts > 0);
    return drain;
}

/* What is damaged under a right checksum is refused, or is a state, from which steps go on or are refused: nothing else may
 * happen. Of a few thousand bytes each bit of which is turned over in turn, one here and there. */
static void accepted_damaged_states_can_be_stepped(void **state)
{
    enum { APART = 37 };
    (void)state;
    small s;
    drain_hands hands;
    uint32_t taken = 0, refused = 0;
    (void)begin_life(&s, &hands);
    small_state good = small_save(&s);
    uint8_t *bad = malloc(good.count);
    assert_non_null(bad);
    for (size_t at = 16; at < good.count - 8; at += APART) {
        memcpy(bad, good.bytes, good.count);
        bad[at] ^= (uint8_t)(1u << at / APART % 8);
        harness_seal_snapshot(bad, good.count);
        uint64_t hash = small_hash(&s);
        if (vbss_scene_restore(s.scene, bad, good.count) != VBSS_OK) {
            assert_true(small_hash(&s) == hash);
            refused++;
            continue;
        }
        taken++;
        vbss_result result = vbss_scene_step(s.scene, 1e-3);
        assert_true(result == VBSS_OK || result == VBSS_ERROR_CAPACITY ||
                    result == VBSS_ERROR_NOT_FINITE || result == VBSS_ERROR_OUT_OF_RANGE);
    }
    assert_true(taken > 100);
    assert_true(refused > 20);
    expect_ok(vbss_scene_restore(s.scene, good.bytes, good.count));
    small_steps(&s, 1, 1e-3);
    free(bad);
    free(good.bytes);
    small_end(&s);
}

/* What a snapshot with a right checksum may hold: finite, and no place where anything could be. */
static void absurd_states_end_finite_or_are_reported(void **state)
{
    enum { FIELDS = 8, NUMBERS = 6 };
    (void)state;
    const double absurd[NUMBERS] = {1e10, 1e30, 1e100, 1e160, 1e300, DBL_MAX};
    uint32_t refused = 0, stepped = 0;
    for (int k = 0; k < FIELDS * NUMBERS; k++) {
        small s;
        drain_hands hands;
        drain_object *d = drains_rig_object(begin_life(&s, &hands));
        uint32_t loose = d->attachments[1].node;
        double *fields[FIELDS] = {&d->x[loose].y,
                                  &d->x[loose + 1].x,
                                  &d->v[loose].y,
                                  &d->v[loose + 1].z,
                                  &d->attachments[0].target.x,
                                  &d->attachments[1].force.z,
                                  &d->attachments[2].target.y,
                                  &d->attachments[2].stiffness};
        *fields[k / NUMBERS] = absurd[k % NUMBERS];
        small_state kept = small_save(&s);
        uint64_t hash = small_hash(&s);
        vbss_result result = vbss_scene_restore(s.scene, kept.bytes, kept.count);
        free(kept.bytes);
        assert_true(small_hash(&s) == hash);
        if (result != VBSS_OK) { /* as no host can have made it */
            expect_result(VBSS_ERROR_CORRUPT, result);
            refused++;
        } else {
            result = vbss_scene_step(s.scene, 1e-3);
            stepped += result == VBSS_OK;
            assert_true(result == VBSS_OK || result == VBSS_ERROR_NOT_FINITE ||
                        result == VBSS_ERROR_CAPACITY);
            assert_true(result == VBSS_OK || small_hash(&s) == hash);
            kept = small_save(&s); /* reading refuses what is not finite */
            expect_ok(vbss_scene_restore(s.scene, kept.bytes, kept.count));
            (void)vbss_scene_step(s.scene, 1e-3);
            free(kept.bytes);
        }
        small_end(&s);
    }
    assert_int_equal(refused, FIELDS / 2 * NUMBERS);
    assert_true(stepped > 0);
}

int test_drains_damage(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(accepted_damaged_states_can_be_stepped),
        cmocka_unit_test(absurd_states_end_finite_or_are_reported),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
