/* Memory of threads and their pieces, and the calls on a thread in motion that are rejected. */
#include <stdlib.h>

#include "base/error.h"
#include "subject.h"

/* ---- memory */

/* Four parts of one thread; each order in which they end gives all memory back. */
static void memory_is_returned_in_any_order(void **state)
{
    (void)state;
    for (int order = 0; order < 24; order++) {
        fixture f;
        vbss_thread *parts[4];
        begin(&f);
        f.config.cut_capacity = order % 2 == 0 ? 3 : 5;
        parts[0] = make(&f);
        uint64_t held = f.memory.calls;
        expect_ok(vbss_thread_cut(parts[0], 0.1, &parts[1]));
        expect_ok(vbss_thread_cut(parts[0], 0.05, &parts[2]));
        expect_ok(vbss_thread_cut(parts[1], 0.02, &parts[3]));
        assert_int_equal(f.memory.calls, held);
        int left = order;
        for (int count = 4; count > 0; count--) {
            int taken = left % count;
            left /= count;
            for (int i = 0; i < count; i++) {
                steps(parts[i], 2, 1e-3);
            }
            expect_ok(vbss_thread_destroy(parts[taken]));
            expect_result(VBSS_ERROR_INVALID_HANDLE, vbss_thread_step(parts[taken], 1e-3));
            parts[taken] = parts[count - 1];
        }
        vbss_context_statistics statistics;
        expect_ok(vbss_context_get_statistics(f.context, &statistics, sizeof statistics));
        assert_int_equal(statistics.objects_alive, 0);
        assert_int_equal(statistics.objects_created, 4);
        end(&f);
    }
}

static void context_end_destroys_live_pieces(void **state)
{
    (void)state;
    for (int destroyed = 0; destroyed < 3; destroyed++) {
        fixture f;
        vbss_thread *piece, *far_piece;
        begin(&f);
        f.config.cut_capacity = 4;
        vbss_thread *thread = make(&f), *other = make(&f);
        expect_ok(vbss_thread_cut(thread, 0.1, &piece));
        expect_ok(vbss_thread_cut(piece, 0.02, &far_piece));
        expect_ok(vbss_thread_destroy(destroyed == 0 ? thread : destroyed == 1 ? piece : other));
        end(&f);
    }
}

/* ---- what is left to refuse, on a thread that has lived */

static void bad_moves_are_rejected(void **state)
{
    (void)state;
    subject s;
    begin_subject(&s);
    for (int c = 0; c < 3; c++) {
        for (int k = 0; k < 4; k++) {
            double v[3] = {0.1, 0.1, 0.1};
            const double good[3] = {0.1, 0.1, 0.1};
            vbss_result wanted = k < 3 ? VBSS_ERROR_NOT_FINITE : VBSS_ERROR_OUT_OF_RANGE;
            v[c] = k < 3 ? harness_bad_numbers[k] : 1.1e6;
            unchanged(&s, wanted, vbss_thread_set_attachment_target(s.thread, s.pin, v, NULL));
            unchanged(&s, wanted, vbss_thread_set_attachment_target(s.thread, s.force, v, NULL));
            v[c] = k < 3 ? v[c] : 1e101;
            unchanged(&s, wanted, vbss_thread_set_attachment_target(s.thread, s.clamp, good, v));
            /* A good direction does not move before a bad target is told. */
            unchanged(&s, wanted, vbss_thread_set_attachment_target(s.thread, s.clamp, v, good));
        }
    }
    const double zero[3] = {0.0, 0.0, 0.0};
    const uint32_t none[] = {0, 5, UINT32_MAX};
    unchanged(&s, VBSS_ERROR_OUT_OF_RANGE,
              vbss_thread_set_attachment_target(s.thread, s.clamp, zero, zero));
    unchanged(&s, VBSS_ERROR_INCOMPATIBLE,
              vbss_thread_set_attachment_target(s.thread, s.mass, zero, NULL));
    unchanged(&s, VBSS_ERROR_NULL_ARGUMENT,
              vbss_thread_set_attachment_target(s.thread, s.pin, NULL, zero));
    for (int i = 0; i < 3; i++) {
        vbss_thread_reaction r;
        unchanged(&s, VBSS_ERROR_NOT_FOUND,
                  vbss_thread_set_attachment_target(s.thread, none[i], zero, NULL));
        unchanged(&s, VBSS_ERROR_NOT_FOUND, vbss_thread_detach(s.thread, none[i]));
        unchanged(&s, VBSS_ERROR_NOT_FOUND,
                  vbss_thread_get_reaction(s.thread, none[i], &r, sizeof r));
    }
    end_subject(&s);
}

static void bad_steps_states_and_cuts_are_rejected(void **state)
{
    (void)state;
    subject s;
    begin_subject(&s);
    vbss_thread *piece = s.thread;
    double x[39], v[39];
    for (int k = 0; k < 3; k++) {
        double bad = harness_bad_numbers[k];
        unchanged(&s, VBSS_ERROR_NOT_FINITE, vbss_thread_step(s.thread, bad));
        unchanged(&s, VBSS_ERROR_NOT_FINITE, vbss_thread_cut(s.thread, bad, &piece));
        assert_null(piece);
        for (int i = 0; i < 39; i++) {
            memset(x, 0, sizeof x);
            memset(v, 0, sizeof v);
            x[i] = bad;
            unchanged(&s, VBSS_ERROR_NOT_FINITE, vbss_thread_set_state(s.thread, x, v, 13));
            x[i] = 1001.0;
            unchanged(&s, VBSS_ERROR_OUT_OF_RANGE, vbss_thread_set_state(s.thread, x, NULL, 13));
            x[i] = 0.0;
            v[i] = bad;
            unchanged(&s, VBSS_ERROR_NOT_FINITE, vbss_thread_set_state(s.thread, NULL, v, 13));
            v[i] = -1.1e5;
            unchanged(&s, VBSS_ERROR_OUT_OF_RANGE, vbss_thread_set_state(s.thread, x, v, 13));
        }
    }
    const double wrong_steps[] = {0.0, -1e-3, 0.99e-7, 0.1001, DBL_MAX, -DBL_MAX, 5e-324};
    const double wrong_places[] = {-1e-9, 0.0, 0.15, 0.1501, DBL_MAX, 0.0001, 0.1499};
    for (int i = 0; i < 7; i++) {
        unchanged(&s, VBSS_ERROR_OUT_OF_RANGE, vbss_thread_step(s.thread, wrong_steps[i]));
        unchanged(&s, VBSS_ERROR_OUT_OF_RANGE, vbss_thread_cut(s.thread, wrong_places[i], &piece));
        assert_null(piece);
    }
    const uint32_t wrong_counts[] = {0, 12, 14, UINT32_MAX};
    for (int i = 0; i < 4; i++) {
        unchanged(&s, VBSS_ERROR_OUT_OF_RANGE,
                  vbss_thread_set_state(s.thread, x, v, wrong_counts[i]));
    }
    unchanged(&s, VBSS_ERROR_NULL_ARGUMENT, vbss_thread_cut(s.thread, 0.1, NULL));
    unchanged(&s, VBSS_ERROR_NULL_ARGUMENT, vbss_thread_get_hash(s.thread, NULL));
    expect_ok(vbss_thread_cut(s.thread, 0.1, &piece));
    s.hash = hash_of(s.thread);
    unchanged(&s, VBSS_ERROR_CAPACITY, vbss_thread_cut(s.thread, 0.05, &piece));
    assert_null(piece);
    end_subject(&s);
}

int test_thread_memory(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(memory_is_returned_in_any_order),
        cmocka_unit_test(context_end_destroys_live_pieces),
        cmocka_unit_test(bad_moves_are_rejected),
        cmocka_unit_test(bad_steps_states_and_cuts_are_rejected),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
