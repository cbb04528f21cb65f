/* The matrix that a drain keeps from step to step while it moves little. */
#include "drain/drain_rig.h"

#define STEP 1e-3

/* Both marks, pinned where they are. */
static void pin_marks(drain_rig *r, uint32_t ids[2])
{
    for (int side = 0; side < 2; side++) {
        ids[side] = drain_rig_pin_here(r, r->places.marks[side]);
    }
}

static void begin_pinned(drain_rig *r, uint32_t ids[2])
{
    drain_rig_begin(r);
    r->config.tear_stress = 1e12;
    drain_rig_make(r);
    pin_marks(r, ids);
}

/* Towards each other, by so much in a step. */
static void close_marks(drain_rig *r, const uint32_t ids[2], double by)
{
    for (int side = 0; side < 2; side++) {
        vec3 here = drain_rig_position(r, r->places.marks[side]);
        here.z += side == 0 ? by : -by;
        drain_rig_move(r, ids[side], here);
    }
    drain_rig_run(r, STEP, 1);
}

static uint64_t matrices(drain_rig *r)
{
    return drain_rig_statistics(r).matrices;
}

static void drain_at_rest_needs_one_matrix(void **state)
{
    (void)state;
    drain_rig r;
    drain_rig_begin(&r);
    drain_rig_make(&r);
    drain_rig_run(&r, STEP, 200);
    assert_int_equal(matrices(&r), 1);
    assert_int_equal(drain_rig_statistics(&r).linearisations, 200);
    drain_rig_run(&r, 0.5 * STEP, 10); /* its entries depend on the length of a step */
    assert_int_equal(matrices(&r), 2);
    drain_rig_end(&r);
}

/* The twin is edited before each step, without a change, so it makes all its matrices. Seen here: 0.037 um at 20 mm/s,
 * 20 matrices of 60. */
static void kept_matrix_moves_the_drain_as_a_new_one(void **state)
{
    (void)state;
    static vec3 x[DRAIN_RIG_NODES];
    drain_rig rigs[2];
    uint32_t ids[2][2];
    double worst = 0.0;
    for (int k = 0; k < 2; k++) {
        begin_pinned(&rigs[k], ids[k]);
    }
    for (int step = 0; step < 60; step++) {
        expect_ok(vbss_drain_set_state(rigs[1].drain, NULL, NULL,
                                       drain_rig_count(&rigs[1], VBSS_DRAIN_VIEW_POSITIONS)));
        for (int k = 0; k < 2; k++) {
            close_marks(&rigs[k], ids[k], 20e-6);
        }
        drain_rig_copy(&rigs[1], x);
        worst = vbss_max_or_nan(drain_rig_distance(&rigs[0], x), worst);
    }
    assert_true(worst > 0.0 && worst < 0.1e-6);
    assert_int_equal(matrices(&rigs[1]), 60);
    assert_in_range(matrices(&rigs[0]), 10, 30);
    drain_rig_end(&rigs[1]);
    drain_rig_end(&rigs[0]);
}

/* At each step of a motion, so also where the matrix is an old one. */
static void restored_drain_goes_on_with_its_matrix(void **state)
{
    (void)state;
    enum { STEPS = 12, ROOM = 1 << 16 };
    static uint8_t bytes[ROOM];
    drain_rig rigs[2];
    uint32_t ids[2][2], kept = 0;
    uint64_t count;
    for (int k = 0; k < 2; k++) {
        begin_pinned(&rigs[k], ids[k]);
    }
    for (int step = 0; step < STEPS; step++) {
        const uint64_t before = matrices(&rigs[0]);
        close_marks(&rigs[0], ids[0], 20e-6);
        expect_ok(vbss_drain_save(rigs[0].drain, bytes, sizeof bytes, &count));
        expect_ok(vbss_drain_restore(rigs[1].drain, bytes, count));
        kept += matrices(&rigs[0]) == before;
        for (int k = 0; k < 2; k++) {
            close_marks(&rigs[k], ids[k], 5e-6);
        }
        assert_true(drain_rig_hash(&rigs[0]) == drain_rig_hash(&rigs[1]));
    }
    assert_in_range(kept, 3, STEPS - 3);
    drain_rig_end(&rigs[1]);
    drain_rig_end(&rigs[0]);
}

/* A spring is part of the matrix, its target is not. */
static void edits_make_a_new_matrix(void **state)
{
    (void)state;
    drain_rig r;
    drain_rig_begin(&r);
    drain_rig_make(&r);
    uint32_t mark = r.places.marks[0];
    vec3 place = drain_rig_position(&r, mark);
    drain_rig_run(&r, STEP, 2);
    assert_int_equal(matrices(&r), 1);
    uint32_t id = drain_rig_spring(&r, mark, place, 50.0);
    drain_rig_run(&r, STEP, 2);
    assert_int_equal(matrices(&r), 2);
    place.z += 1e-6;
    drain_rig_move(&r, id, place);
    drain_rig_run(&r, STEP, 2);
    assert_int_equal(matrices(&r), 2);
    drain_rig_detach(&r, id);
    drain_rig_run(&r, STEP, 2);
    assert_int_equal(matrices(&r), 3);
    drain_rig_end(&r);
}

int test_drain_tangent(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(drain_at_rest_needs_one_matrix),
        cmocka_unit_test(kept_matrix_moves_the_drain_as_a_new_one),
        cmocka_unit_test(restored_drain_goes_on_with_its_matrix),
        cmocka_unit_test(edits_make_a_new_matrix),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
