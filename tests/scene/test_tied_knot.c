/* Knots that are tied throw by throw, as a surgeon does: what is tied stays what it is, lies throw on throw and
 * bears the load. */
#include <stdlib.h>

#include "scene/tied.h"

static void expect_tied(knot_kind kind, double extent, double taken_up)
{
    tied t;
    tied_init(&t, kind);
    tied_begin(&t);
    tied_tie(&t);
    tied_expect_tight(&t, extent, taken_up);
    tied_end(&t);
}

static void square_knot_tied_in_turn_is_tight(void **state)
{
    (void)state;
    expect_tied(KNOT_SQUARE, 0.8e-3, 22e-3);
}

static void granny_tied_in_turn_is_tight(void **state)
{
    (void)state;
    expect_tied(KNOT_GRANNY, 0.9e-3, 22.5e-3);
}

static void half_hitches_pulled_by_ends_are_tight(void **state)
{
    (void)state;
    expect_tied(KNOT_HALF_HITCHES, 0.9e-3, 23e-3);
}

static void overhand_without_post_is_tight(void **state)
{
    tied t;
    (void)state;
    tied_init(&t, KNOT_OVERHAND);
    t.options.knot.cylinder = false;
    tied_begin(&t);
    tied_tie(&t);
    tied_expect_tight(&t, 0.5e-3, 3.2e-3);
    tied_end(&t);
}

/* ---- the same again */

static void restored_tying_continues_bit_equal(void **state)
{
    enum { BEFORE = 260, AFTER = 120 }; /* from where the first throw is kept by slipping fingers */
    static uint64_t hashes[AFTER];
    tied t;
    (void)state;
    tied_init(&t, KNOT_SQUARE);
    tied_begin(&t);
    for (int i = 0; i < BEFORE; i++) {
        expect_ok(tied_knot_step(&t.knot, TIED_STEP));
    }
    assert_int_equal(1, tied_knot_stage(&t.knot));
    assert_true(t.knot.grips[0].id != 0 && t.knot.grips[1].id != 0);
    uint64_t count = 0;
    expect_result(VBSS_ERROR_CAPACITY, vbss_scene_save(t.knot.scene, NULL, 0, &count));
    uint8_t *bytes = malloc(count);
    assert_non_null(bytes);
    expect_ok(vbss_scene_save(t.knot.scene, bytes, count, &count));
    tied_knot saved = t.knot;
    for (int i = 0; i < AFTER; i++) {
        expect_ok(tied_knot_step(&t.knot, TIED_STEP));
        expect_ok(tied_knot_hash(&t.knot, &hashes[i]));
    }
    assert_true(t.knot.grips[0].node != saved.grips[0].node); /* or nothing slipped */
    expect_ok(vbss_scene_restore(t.knot.scene, bytes, count));
    t.knot = saved;
    for (int i = 0; i < AFTER; i++) {
        uint64_t hash = 0;
        expect_ok(tied_knot_step(&t.knot, TIED_STEP));
        expect_ok(tied_knot_hash(&t.knot, &hash));
        assert_int_equal(hashes[i], hash);
    }
    free(bytes);
    tied_end(&t);
}

int test_tied_knot(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(square_knot_tied_in_turn_is_tight),
        cmocka_unit_test(granny_tied_in_turn_is_tight),
        cmocka_unit_test(half_hitches_pulled_by_ends_are_tight),
        cmocka_unit_test(overhand_without_post_is_tight),
        cmocka_unit_test(restored_tying_continues_bit_equal),
    };
    return cmocka_run_group_tests_name("tied_knot", tests, NULL, NULL);
}
