/* Saving, restoring, hashing, and what results do not depend on. */
#include <stdlib.h>

#include "knot/detector_rig.h"
#include "fixtures/knot_body.h"

/* Few operations a step, so that a reading lasts over many; more, so that it lasts over some; plenty. */
static knot_body_options lives[] = {{VBSS_KNOT_METHOD_TOPOLOGY, 300},
                                    {VBSS_KNOT_METHOD_TOPOLOGY, 2500},
                                    {VBSS_KNOT_METHOD_TOPOLOGY, 15000},
                                    {VBSS_KNOT_METHOD_PROJECTION, 15000}};
enum { LIVES = sizeof lives / sizeof lives[0] };

static const char *const knots[] = {"", "1", "2=1=1", "1x2"};

/* ---- going on */

static void restored_detector_continues_bit_equal(void **state)
{
    (void)state;
    for (int i = 0; i < LIVES; i++) {
        const harness_body body = knot_body(&lives[i]);
        for (size_t before = 1; before < (size_t)2 * MOVING_KNOT_PERIOD; before += 7) {
            harness_save_restore_continue(&body, before, 30);
        }
    }
}

static void pass(vbss_knot_detector *from, vbss_knot_detector *to)
{
    uint64_t count = 0, written;
    expect_result(VBSS_ERROR_CAPACITY, vbss_knot_detector_save(from, NULL, 0, &count));
    uint8_t *bytes = malloc((size_t)count);
    assert_non_null(bytes);
    expect_ok(vbss_knot_detector_save(from, bytes, count, &written));
    assert_int_equal(written, count);
    expect_ok(vbss_knot_detector_restore(to, bytes, count));
    free(bytes);
}

/* One detector lives; in every step, so at every phase of readings, one is restored from it that has lived the same,
 * and one that knows nothing. */
static void try_every_phase(knot_body_options *options, bool seen[KNOT_JOB_DONE])
{
    enum { LIVING, SAME, BLANK, DETECTORS };
    harness_memory memory;
    vbss_context *context = harness_context(&memory);
    void *d[DETECTORS] = {NULL};
    knot_detector *inside[DETECTORS];
    for (int k = 0; k < DETECTORS; k++) {
        expect_ok(knot_body_create(context, options, &d[k]));
        expect_ok(vbss_knot_open(d[k], &inside[k]));
    }
    for (int step = 0; step < 3 * MOVING_KNOT_PERIOD; step++) {
        seen[inside[LIVING]->job.stage] = true;
        expect_ok(vbss_knot_detector_reset(d[BLANK]));
        for (int k = SAME; k < DETECTORS; k++) {
            pass(d[LIVING], d[k]);
            detectors_are_alike(d[LIVING], d[k], false);
            assert_memory_equal(&inside[LIVING]->random, &inside[k]->random,
                                sizeof inside[k]->random);
        }
        for (int k = 0; k < DETECTORS; k++) {
            expect_ok(knot_body_step(d[k]));
            detectors_are_alike(d[LIVING], d[k], true);
        }
    }
    harness_context_end(context, &memory);
}

static void reading_resumes_at_any_point(void **state)
{
    (void)state;
    bool seen[KNOT_JOB_DONE] = {false};
    for (int i = 0; i < LIVES; i++) {
        try_every_phase(&lives[i], seen);
    }
    for (int stage = KNOT_JOB_IDLE; stage < KNOT_JOB_DONE; stage++) {
        assert_true(seen[stage]);
    }
}

static void any_knot_kind_is_restored(void **state)
{
    (void)state;
    detector_rig r, other;
    detector_rig_begin(&r);
    detector_rig_begin(&other);
    detector_rig_create(&r);
    detector_rig_create(&other);
    for (int knot = 0; knot < 4; knot++) {
        if (knot < 3) {
            detector_rig_tie(&r, knots[knot], 120);
        } else {
            detector_rig_figure_eight(&r);
        }
        detector_rig_judge(&r);
        expect_ok(vbss_knot_detector_reset(other.detector));
        pass(r.detector, other.detector);
        detectors_are_alike(r.detector, other.detector, false);
    }
    detector_rig_end(&other);
    detector_rig_end(&r);
}

static void events_belong_to_one_step(void **state)
{
    (void)state;
    detector_rig r;
    detector_rig_begin(&r);
    detector_rig_create(&r);
    detector_rig_tie(&r, "1", 80);
    detector_rig_judge(&r);
    assert_int_equal(detector_rig_events(&r, VBSS_KNOT_EVENT_FORMED, NULL), 1);
    pass(r.detector, r.detector); /* what is restored has had none */
    assert_int_equal(detector_rig_view(&r, VBSS_KNOT_VIEW_EVENTS).count, 0);
    detector_rig_steps(&r, 1);
    assert_int_equal(detector_rig_view(&r, VBSS_KNOT_VIEW_EVENTS).count, 0);
    detector_rig_judge(&r); /* nothing new is known */
    assert_int_equal(detector_rig_view(&r, VBSS_KNOT_VIEW_EVENTS).count, 1);
    assert_int_equal(detector_rig_events(&r, VBSS_KNOT_EVENT_READ, NULL), 1);
    expect_ok(vbss_knot_detector_reset(r.detector));
    assert_int_equal(detector_rig_view(&r, VBSS_KNOT_VIEW_EVENTS).count, 0);
    detector_rig_end(&r);
}

/* ---- what results do not depend on */

static void expect_same_results(const detector_rig *a, const detector_rig *b)
{
    vbss_knot_state p = detector_rig_state(a), q = detector_rig_state(b);
    p.steps = q.steps = 0; /* when it was told */
    assert_memory_equal(&p, &q, sizeof p);
    for (uint32_t i = 0; i < p.throw_count; i++) {
        vbss_knot_throw t = detector_rig_throw(a, i), u = detector_rig_throw(b, i);
        assert_memory_equal(&t, &u, sizeof t);
    }
    for (uint32_t i = 0; i < a->input.tool_count; i++) {
        vbss_knot_winding w = detector_rig_winding(a, i), x = detector_rig_winding(b, i);
        assert_memory_equal(&w, &x, sizeof w);
    }
    vbss_knot_detector_statistics f = detector_rig_statistics(a), g = detector_rig_statistics(b);
    f.most_step_work = g.most_step_work = 0;
    assert_memory_equal(&f, &g, sizeof f);
}

static void begin_knot(detector_rig *r, int knot, uint32_t step_budget)
{
    detector_rig_begin(r);
    r->config.step_budget = step_budget;
    detector_rig_create(r);
    detector_rig_tie(r, knots[knot], 100);
    detector_rig_add_tools(r, knot % 2 == 0 ? 3 : 0);
}

static void results_do_not_depend_on_budget(void **state)
{
    (void)state;
    const uint32_t limits[] = {100, 337, 1000, 15000, 1000000000};
    detector_rig slow, r;
    for (int knot = 0; knot < 4; knot++) {
        begin_knot(&slow, knot, 100);
        uint32_t last = detector_rig_read(&slow);
        const vbss_knot_detector_statistics fine = detector_rig_statistics(&slow);
        for (int i = 1; i < 5; i++) {
            begin_knot(&r, knot, limits[i]);
            uint32_t steps = detector_rig_read(&r);
            expect_same_results(&slow, &r);
            assert_true(steps <= last);
            assert_true(steps <= 2 + fine.work / limits[i]); /* every step does its share */
            /* and hardly more: the last piece of it is not divided */
            assert_true(detector_rig_statistics(&r).most_step_work <=
                        limits[i] + fine.most_step_work);
            last = steps;
            detector_rig_end(&r);
        }
        assert_int_equal(last, 2); /* a reading begins in one step, and goes on in the next */
        detector_rig_end(&slow);
    }
}

static void judge_equals_stepping_to_end(void **state)
{
    (void)state;
    detector_rig stepped, judged;
    for (int knot = 0; knot < 4; knot++) {
        begin_knot(&stepped, knot, 300);
        begin_knot(&judged, knot, 300);
        detector_rig_read(&stepped);
        detector_rig_judge(&judged);
        assert_int_equal(detector_rig_state(&judged).steps, 1);
        expect_same_results(&stepped, &judged);
        detector_rig_end(&judged);
        detector_rig_end(&stepped);
    }
}

/* A reading under way is dropped for one of what is shown now, and leaves nothing behind. */
static void judge_discards_current_reading(void **state)
{
    (void)state;
    detector_rig r, fresh;
    begin_knot(&r, 2, 300);
    begin_knot(&fresh, 1, 300);
    detector_rig_judge(&fresh);
    for (uint32_t steps = 1; steps < 100; steps += 1 + steps / 3) {
        expect_ok(vbss_knot_detector_reset(r.detector));
        detector_rig_tie(&r, knots[2], 100);
        detector_rig_steps(&r, steps);
        vbss_knot_detector_statistics before = detector_rig_statistics(&r);
        detector_rig_tie(&r, knots[1], 100);
        r.input.tool_count = 0;
        detector_rig_judge(&r);
        vbss_knot_detector_statistics after = detector_rig_statistics(&r),
                                      own = detector_rig_statistics(&fresh);
        assert_true(after.readings == before.readings + 1);
        assert_true(after.work == before.work + own.work); /* what was done was done */
        assert_true(after.closures == before.closures + own.closures);
        assert_true(after.removed == before.removed + own.removed);
        vbss_knot_state p = detector_rig_state(&r), q = detector_rig_state(&fresh);
        assert_int_equal(p.reading_step, steps + 1);
        assert_int_equal(p.steps, steps + 1);
        p.reading_step = q.reading_step;
        p.steps = q.steps;
        assert_memory_equal(&p, &q, sizeof p);
        detector_rig_expect_notation(&r, knots[1]);
    }
    detector_rig_end(&fresh);
    detector_rig_end(&r);
}

/* ---- hashes */

static void hash_covers_all_state(void **state)
{
    (void)state;
    enum { STEPS = MOVING_KNOT_PERIOD };
    uint64_t seen[STEPS + 8];
    uint32_t count = 0;
    detector_rig r;
    begin_knot(&r, 2, 300);
    seen[count++] = detector_rig_hash(&r);
    for (int i = 0; i < STEPS; i++) {
        detector_rig_steps(&r, 1);
        seen[count++] = detector_rig_hash(&r);
        assert_true(detector_rig_hash(&r) == seen[count - 1]); /* looking changes nothing */
    }
    detector_rig_judge(&r);
    seen[count++] = detector_rig_hash(&r);
    for (int i = 0; i < 3; i++) { /* of a thread that is being read every number counts */
        expect_ok(vbss_knot_detector_reset(r.detector));
        r.points[50][i] += 1e-12;
        detector_rig_steps(&r, 1);
        seen[count++] = detector_rig_hash(&r);
    }
    for (uint32_t i = 0; i < count; i++) {
        for (uint32_t k = 0; k < i; k++) {
            assert_true(seen[i] != seen[k]);
        }
    }
    detector_rig_end(&r);
}

int test_detector_state(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(restored_detector_continues_bit_equal),
        cmocka_unit_test(reading_resumes_at_any_point),
        cmocka_unit_test(any_knot_kind_is_restored),
        cmocka_unit_test(events_belong_to_one_step),
        cmocka_unit_test(results_do_not_depend_on_budget),
        cmocka_unit_test(judge_equals_stepping_to_end),
        cmocka_unit_test(judge_discards_current_reading),
        cmocka_unit_test(hash_covers_all_state),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
