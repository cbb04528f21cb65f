/* Snapshots of scenes that were cut: handles of pieces, cuts that are undone, whose a snapshot is. */
#include <stdlib.h>

#include "scene/cut_rig.h"

/* ---- handles and views of pieces */

static void line(small *s, vbss_thread **thread)
{
    small_begin(s);
    small_create(s);
    s->thread.cut_capacity = 2;
    (void)small_thread(s, vec3_zero(), vec3_make(0.02, 0.0, 0.0), 20, thread);
}

static void piece_lives_as_long_as_its_cut(void **state)
{
    (void)state;
    small s;
    vbss_thread *thread, *first, *second, *found;
    line(&s, &thread);
    uint64_t hashes[4] = {small_hash(&s)};
    small_state uncut = small_save(&s);
    (void)cut_at(&s, 1, 10.5e-3, &first);
    hashes[1] = small_hash(&s);
    small_state once = small_save(&s);
    (void)cut_at(&s, 2, 5e-3, &second);
    hashes[2] = small_hash(&s);
    small_state twice = small_save(&s);
    assert_true(hashes[0] != hashes[1] && hashes[1] != hashes[2] && hashes[0] != hashes[2]);
    const small_state states[] = {uncut, once, twice};
    static const int order[] = {0, 2, 1, 2, 0, 1, 0, 0, 2, 2};
    for (size_t i = 0; i < sizeof order / sizeof order[0]; i++) {
        int k = order[i];
        vbss_thread_statistics statistics;
        expect_ok(vbss_scene_restore(s.scene, states[k].bytes, states[k].count));
        assert_true(small_hash(&s) == hashes[k]);
        cut_expect_sound(small_object(&s));
        expect_result(k >= 1 ? VBSS_OK : VBSS_ERROR_INVALID_HANDLE,
                      vbss_thread_get_statistics(first, &statistics, sizeof statistics));
        expect_result(k >= 2 ? VBSS_OK : VBSS_ERROR_INVALID_HANDLE,
                      vbss_thread_get_statistics(second, &statistics, sizeof statistics));
        expect_result(k >= 1 ? VBSS_OK : VBSS_ERROR_NOT_FOUND,
                      vbss_scene_get_thread(s.scene, 2, &found));
        assert_ptr_equal(found, k >= 1 ? first : NULL);
        assert_int_equal(cut_nodes(thread), k == 0 ? 21 : 12);
        small_steps(&s, 3, 1e-3);
        cut_expect_sound(small_object(&s));
    }
    /* What was not cut can be, and a cut that was undone made elsewhere. */
    expect_ok(vbss_scene_restore(s.scene, once.bytes, once.count));
    assert_int_equal(cut_at(&s, 1, 3e-3, &found), 3);
    assert_ptr_equal(found, second);
    assert_int_equal(cut_nodes(second), 9);
    free(uncut.bytes);
    free(once.bytes);
    free(twice.bytes);
    small_end(&s);
}

/* Nothing is left in a place of the piece that it had before. */
static void undone_cut_repeats_bit_equal(void **state)
{
    (void)state;
    small s;
    vbss_thread *thread;
    uint64_t hashes[8], again[8];
    line(&s, &thread);
    small_pin_ends(&s, 1, 21);
    s.config.floor = 1;
    small_state uncut = small_save(&s);
    for (int i = 0; i < 8; i++) {
        (void)(i == 0 ? cut_at(&s, 1, 10.5e-3, NULL) : i == 4 ? cut_at(&s, 2, 5e-3, NULL) : 0);
        hashes[i] = small_hash(&s);
        small_steps(&s, 3, 1e-3);
    }
    expect_ok(vbss_scene_restore(s.scene, uncut.bytes, uncut.count));
    for (int i = 0; i < 8; i++) {
        (void)(i == 0 ? cut_at(&s, 1, 10.5e-3, NULL) : i == 4 ? cut_at(&s, 2, 5e-3, NULL) : 0);
        again[i] = small_hash(&s);
        small_steps(&s, 3, 1e-3);
    }
    assert_int_equal(harness_first_difference(hashes, again, 8), 8);
    free(uncut.bytes);
    small_end(&s);
}

/* What must be the same for the state of a cut scene to be one of this scene. */
static void snapshot_of_other_cuts_is_rejected(void **state)
{
    (void)state;
    for (int k = 0; k < 4; k++) {
        small s, other;
        vbss_thread *thread, *theirs;
        line(&s, &thread);
        uint32_t piece = cut_at(&s, 1, 10.5e-3, NULL);
        if (k == 3) {
            expect_ok(vbss_scene_remove(s.scene, piece));
        }
        small_state kept = small_save(&s);
        small_begin(&other);
        small_create(&other);
        other.thread.cut_capacity = k == 0 ? 0 : k == 1 ? 1 : 2;
        (void)small_thread(&other, vec3_zero(), vec3_make(0.02, 0.0, 0.0), k == 2 ? 21 : 20,
                           &theirs);
        uint64_t hash = small_hash(&other);
        expect_result(VBSS_ERROR_CORRUPT, vbss_scene_restore(other.scene, kept.bytes, kept.count));
        assert_true(small_hash(&other) == hash);
        small_steps(&other, 1, 1e-3);
        free(kept.bytes);
        small_end(&other);
        small_end(&s);
    }
}

/* States that nobody saved. */
static void impossible_pieces_are_rejected(void **state)
{
    (void)state;
    small s;
    vbss_thread *thread, *gone;
    line(&s, &thread);
    uint32_t first = cut_at(&s, 1, 10.5e-3, NULL), second = cut_at(&s, 1, 5e-3, NULL);
    scene_body *b = vbss_scene_body(small_object(&s), second);
    b->number = first; /* twice */
    small_state kept = small_save(&s);
    b->number = second;
    uint64_t hash = small_hash(&s);
    expect_result(VBSS_ERROR_CORRUPT, vbss_scene_restore(s.scene, kept.bytes, kept.count));
    assert_true(small_hash(&s) == hash);
    free(kept.bytes);
    b->thread.cut_from = /* a tool */
        small_stick(&s, VBSS_SCENE_RIGID_DRIVEN, vec3_make(0.0, 0.1, 0.0), vec3_zero(), 1e-3);
    kept = small_save(&s);
    b->thread.cut_from = 0;
    hash = small_hash(&s);
    expect_result(VBSS_ERROR_CORRUPT, vbss_scene_restore(s.scene, kept.bytes, kept.count));
    assert_true(small_hash(&s) == hash);
    free(kept.bytes);
    small_end(&s);

    small both[2]; /* more nodes than the thread had when it was added */
    for (int k = 0; k < 2; k++) {
        uint32_t body;
        small_begin(&both[k]);
        small_create(&both[k]);
        both[k].thread.cut_capacity = 2;
        both[k].thread.segment_count = 20;
        expect_ok(vbss_thread_create(both[k].context, &both[k].thread, &thread));
        expect_ok(vbss_thread_cut(thread, k == 0 ? 0.12 : 0.06, &gone));
        expect_ok(vbss_scene_add_thread(both[k].scene, thread, &body));
    }
    kept = small_save(&both[0]);
    hash = small_hash(&both[1]);
    expect_result(VBSS_ERROR_CORRUPT, vbss_scene_restore(both[1].scene, kept.bytes, kept.count));
    assert_true(small_hash(&both[1]) == hash);
    cut_expect_sound(small_object(&both[1]));
    free(kept.bytes);
    small_end(&both[1]);
    small_end(&both[0]);
}

int test_cuts_state(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(piece_lives_as_long_as_its_cut),
        cmocka_unit_test(undone_cut_repeats_bit_equal),
        cmocka_unit_test(snapshot_of_other_cuts_is_rejected),
        cmocka_unit_test(impossible_pieces_are_rejected),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
