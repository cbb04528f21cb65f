/* What a living needle refuses, without any change: numbers and steps; and the host's floating-point mode. */

#include "fixture.h"
#include "harness/float_modes.h"

typedef struct reported {
    vbss_needle *needle;
    double p[3], q[4], v[3], w[3];
} reported;

static void set_and_expect(const reported *t, vbss_result wanted)
{
    uint64_t hash = hash_of(t->needle), generation = inside(t->needle)->generation;
    expect_result(wanted, vbss_needle_set_state(t->needle, t->p, t->q, t->v, t->w));
    assert_true(wanted == VBSS_OK ||
                (hash_of(t->needle) == hash && inside(t->needle)->generation == generation));
}

static void bad_states_change_nothing(void **state)
{
    (void)state;
    fixture f;
    begin(&f);
    reported good = {
        make(&f), {1.0, 2.0, 3.0}, {1.0, 1.0, 1.0, 1.0}, {4.0, 5.0, 6.0}, {7.0, 8.0, 9.0}};
    set_and_expect(&good, VBSS_OK);
    good.p[0] = 0.5;
    for (int c = 0; c < 13; c++) {
        static const double largest[] = {1e3, 1e100, 1e5, 1e6};
        int which = c < 3 ? 0 : c < 7 ? 1 : c < 10 ? 2 : 3;
        reported t = good;
        double *number = c < 3    ? &t.p[c]
                         : c < 7  ? &t.q[c - 3]
                         : c < 10 ? &t.v[c - 7]
                                  : &t.w[c - 10];
        for (int k = 0; k < 3; k++) {
            *number = harness_bad_numbers[k];
            set_and_expect(&t, VBSS_ERROR_NOT_FINITE);
        }
        *number = -1.001 * largest[which];
        set_and_expect(&t, VBSS_ERROR_OUT_OF_RANGE);
        *number = -largest[which];
        set_and_expect(&t, VBSS_OK);
    }
    reported t = good;
    memset(t.q, 0, sizeof t.q);
    set_and_expect(&t, VBSS_ERROR_OUT_OF_RANGE);
    expect_result(VBSS_ERROR_NULL_ARGUMENT,
                  vbss_needle_set_state(good.needle, NULL, good.q, good.v, good.w));
    end(&f);
}

static void bad_steps_places_and_fields_are_rejected(void **state)
{
    (void)state;
    fixture f;
    begin(&f);
    vec3_store(f.config.gravity, vec3_make(0.0, 0.0, -9.81));
    vbss_needle *needle = make(&f);
    uint64_t hash = hash_of(needle);
    double p[3] = {1.0, 2.0, 3.0};
    vbss_view view;
    const double wrong_steps[] = {0.0, -1e-3, 0.99e-7, 0.1001, DBL_MAX, -DBL_MAX, 5e-324};
    for (int i = 0; i < 7; i++) {
        expect_result(VBSS_ERROR_OUT_OF_RANGE, vbss_needle_step(needle, wrong_steps[i]));
    }
    for (int k = 0; k < 3; k++) {
        double bad = harness_bad_numbers[k];
        expect_result(VBSS_ERROR_NOT_FINITE, vbss_needle_step(needle, bad));
        expect_result(VBSS_ERROR_NOT_FINITE, vbss_needle_get_place(needle, bad, p, NULL));
    }
    expect_result(VBSS_ERROR_OUT_OF_RANGE, vbss_needle_get_place(needle, 10.01, p, NULL));
    expect_result(VBSS_ERROR_OUT_OF_RANGE, vbss_needle_get_place(needle, -10.01, p, NULL));
    expect_result(VBSS_ERROR_NULL_ARGUMENT, vbss_needle_get_place(needle, 0.0, NULL, NULL));
    assert_true(p[0] == 1.0 && p[1] == 2.0 && p[2] == 3.0);
    const vbss_needle_field fields[] = {-1, 1, INT32_MAX, INT32_MIN};
    for (int i = 0; i < 4; i++) {
        expect_result(VBSS_ERROR_OUT_OF_RANGE,
                      vbss_needle_get_view(needle, fields[i], &view, sizeof view));
    }
    expect_result(VBSS_ERROR_NULL_ARGUMENT, vbss_needle_get_hash(needle, NULL));
    expect_result(VBSS_ERROR_NULL_ARGUMENT, vbss_needle_save(needle, NULL, 0, NULL));
    expect_result(VBSS_ERROR_NULL_ARGUMENT, vbss_needle_restore(needle, NULL, 64));
    assert_true(hash_of(needle) == hash);
    expect_ok(vbss_needle_step(needle, 1e-7));
    expect_ok(vbss_needle_step(needle, 0.1));
    end(&f);
}

/* A speed that no host can set, but that a number holds. */
static void non_finite_step_changes_nothing(void **state)
{
    (void)state;
    fixture f;
    begin(&f);
    vbss_needle *needle = make(&f);
    needle_object *n = inside(needle);
    n->body.now.pose.position.y = n->body.now.v.y = 1.79e308;
    uint64_t hash = hash_of(needle), generation = n->generation;
    expect_result(VBSS_ERROR_NOT_FINITE, vbss_needle_step(needle, 0.1));
    assert_true(hash_of(needle) == hash && n->generation == generation);
    end(&f);
}

static void host_mode_does_not_change_motion(void **state)
{
    (void)state;
    fixture f;
    begin(&f);
    vec3_store(f.config.gravity, vec3_make(0.3, 0.1, -9.81));
    vec3_store(f.config.angular_velocity, vec3_make(1.0, 2.0, 3.0));
    vbss_needle *plain = make(&f), *needle = make(&f);
    for (size_t k = 0; k < harness_mode_count; k++) {
        for (int i = 0; i < 20; i++) {
            expect_ok(vbss_needle_step(plain, 1e-3));
            harness_mode_set(k);
            vbss_result result = vbss_needle_step(needle, 1e-3);
            harness_mode_end(k);
            expect_ok(result);
        }
        assert_true(hash_of(needle) == hash_of(plain));
    }
    end(&f);
}

int test_needle_refusals(void)
{
    const struct CMUnitTest tests[] = {
        harness_test(bad_states_change_nothing),
        harness_test(bad_steps_places_and_fields_are_rejected),
        harness_test(non_finite_step_changes_nothing),
        harness_test(host_mode_does_not_change_motion),
    };
    return cmocka_run_group_tests_name("needle.needle_refusals", tests, NULL, NULL);
}
