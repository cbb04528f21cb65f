/* Closest points of features that touch, and what the functions refuse. */
#include "closest_reference.h"

/* ---- features that meet, all in the plane of x and y: numbers whose products are exact */

static const struct {
    feature a, b;
} meeting[] = {
    {{2, {0, 0, 0, 4, 0, 0}}, {2, {1, 0, 0, 1, 2, 0}}},             /* end on inside */
    {{2, {0, 0, 0, 4, 0, 0}}, {2, {5, 5, 0, 4, 0, 0}}},             /* same end */
    {{2, {0, 0, 0, 4, 0, 0}}, {2, {1, 0, 0, 3, 0, 0}}},             /* on each other */
    {{2, {0, 0, 0, 4, 0, 0}}, {2, {4, 0, 0, 0, 0, 0}}},             /* the same */
    {{2, {0, 0, 0, 4, 0, 0}}, {2, {2, -2, 0, 2, 2, 0}}},            /* crossing */
    {{2, {0, 0, 0, 4, 0, 0}}, {2, {2, 0, 0, 2, 0, 0}}},             /* a point on an edge */
    {{2, {1, 2, 0, 1, 2, 0}}, {2, {1, 2, 0, 1, 2, 0}}},             /* points */
    {{1, {0, 0, 0}}, {3, {0, 0, 0, 4, 0, 0, 0, 4, 0}}},             /* at corners */
    {{1, {0, 4, 0}}, {3, {0, 0, 0, 4, 0, 0, 0, 4, 0}}},             /* */
    {{1, {2, 0, 0}}, {3, {0, 0, 0, 4, 0, 0, 0, 4, 0}}},             /* on edges */
    {{1, {2, 2, 0}}, {3, {0, 0, 0, 4, 0, 0, 0, 4, 0}}},             /* */
    {{1, {1, 1, 0}}, {3, {0, 0, 0, 4, 0, 0, 0, 4, 0}}},             /* inside */
    {{1, {1, 0, 0}}, {3, {0, 0, 0, 4, 0, 0, 2, 0, 0}}},             /* without area */
    {{1, {1, 2, 0}}, {3, {1, 2, 0, 1, 2, 0, 1, 2, 0}}},             /* all a point */
    {{2, {-1, 0, 0, -4, 1, 0}}, {3, {-1, 0, 0, 4, 0, 0, 0, 4, 0}}}, /* end at a corner */
    {{2, {1, 1, 0, 9, 9, 0}}, {3, {0, 0, 0, 4, 0, 0, 0, 4, 0}}},    /* from inside to outside */
    {{2, {1, 1, 0, 1, 2, 0}}, {3, {0, 0, 0, 4, 0, 0, 0, 4, 0}}},    /* inside */
    {{2, {1, -4, 0, 1, 4, 0}}, {3, {0, 0, 0, 4, 0, 0, 2, 0, 0}}},   /* through one without area */
};

static void touching_features_have_no_normal(void **state)
{
    (void)state;
    for (size_t i = 0; i < sizeof meeting / sizeof meeting[0]; i++) {
        feature a = meeting[i].a;
        vbss_collision_closest c = expect_closest(&a, &meeting[i].b, 1e-15);
        assert_true(c.distance == 0.0 && c.normal[0] == 0.0 && c.normal[2] == 0.0);
        assert_memory_equal(c.point_a, c.point_b, sizeof c.point_a);
        for (int k = 0; k < a.count; k++) { /* lifted */
            a.x[3 * k + 2] = 0.5;
        }
        c = expect_closest(&a, &meeting[i].b, 1e-15);
        assert_true(c.distance == 0.5 && c.normal[2] == -1.0);
    }
}

/* ---- what is refused */

/* Doubles of a and of b. */
static const int numbers[KINDS][2] = {{6, 6}, {3, 9}, {6, 9}, {6, 6}};

typedef struct arguments {
    kind which;
    double a[9], b[9];
} arguments;

static arguments good_arguments(kind which)
{
    return (arguments){
        which, {0.0, 0.0, 1.0, 1.0, 2.0, 3.0}, {4.0, 0.0, 0.0, 6.0, 2.0, 1.0, 5.0, 8.0, 1.0}};
}

static void expect_refused(vbss_result wanted, const arguments *with, bool null_a, bool null_b,
                           uint32_t size)
{
    unsigned char out[256], before[256];
    memset(out, 0xa5, sizeof out);
    memcpy(before, out, sizeof out);
    expect_result(
        wanted, closest(with->which, null_a ? NULL : with->a, null_b ? NULL : with->b, out, size));
    assert_memory_equal(out, before, sizeof out);
}

static void bad_numbers_are_rejected_without_output(void **state)
{
    (void)state;
    const uint32_t size = sizeof(vbss_collision_closest);
    for (kind which = EDGES; which < KINDS; which++) {
        for (int i = 0; i < numbers[which][0] + numbers[which][1]; i++) {
            for (int k = 0; k < 5; k++) {
                arguments bad = good_arguments(which);
                int in_b = i - numbers[which][0];
                double *x = in_b < 0 ? &bad.a[i] : &bad.b[in_b];
                *x = k < 3 ? harness_bad_numbers[k] : k == 3 ? 1.01e30 : -DBL_MAX;
                expect_refused(k < 3 ? VBSS_ERROR_NOT_FINITE : VBSS_ERROR_OUT_OF_RANGE, &bad, false,
                               false, size);
            }
        }
        arguments good = good_arguments(which);
        expect_refused(VBSS_ERROR_NULL_ARGUMENT, &good, true, false, size);
        expect_refused(VBSS_ERROR_NULL_ARGUMENT, &good, false, true, size);
        expect_result(VBSS_ERROR_NULL_ARGUMENT, closest(which, good.a, good.b, NULL, size));
    }
}

static void bad_radii_are_rejected_without_output(void **state)
{
    (void)state;
    const double bad[] = {-1e-9, 1.01e30, harness_bad_numbers[0], harness_bad_numbers[1]};
    const double good[] = {0.0, -0.0, 1e30};
    arguments x = good_arguments(CAPSULES);
    for (int i = 0; i < 4; i++) {
        vbss_result wanted = i < 2 ? VBSS_ERROR_OUT_OF_RANGE : VBSS_ERROR_NOT_FINITE;
        for (int of_b = 0; of_b < 2; of_b++) {
            vbss_collision_closest c, before;
            memset(&c, 0xa5, sizeof c);
            before = c;
            expect_result(wanted,
                          vbss_collision_closest_capsules(x.a, of_b ? 0.5 : bad[i], x.b,
                                                          of_b ? bad[i] : 0.5, &c, sizeof c));
            assert_memory_equal(&c, &before, sizeof c);
            c.distance = (double)NAN;
            expect_ok(vbss_collision_closest_capsules(x.a, good[i % 3], x.b, 0.5, &c, sizeof c));
            assert_true(c.distance < 100.0);
        }
    }
}

static void answer_size_protocol(void **state)
{
    (void)state;
    const uint32_t own = sizeof(vbss_collision_closest), never[] = {4097, 0xa5a5a5a5u, UINT32_MAX};
    for (kind which = EDGES; which < KINDS; which++) {
        arguments good = good_arguments(which);
        vbss_collision_closest c;
        expect_ok(closest(which, good.a, good.b, &c, own));
        for (uint32_t size = 0; size < own; size++) {
            expect_refused(VBSS_ERROR_STRUCT_SIZE, &good, false, false, size);
        }
        for (int i = 0; i < 3; i++) {
            expect_refused(VBSS_ERROR_STRUCT_SIZE, &good, false, false, never[i]);
        }
        unsigned char out[256];
        memset(out, 0xff, sizeof out);
        expect_ok(closest(which, good.a, good.b, out, 200));
        assert_memory_equal(out, &c, own); /* struct_size, too, is what was filled */
        for (uint32_t i = own; i < sizeof out; i++) {
            assert_int_equal(out[i], i < 200 ? 0 : 0xff);
        }
    }
}

static void largest_coordinates_are_answered(void **state)
{
    (void)state;
    for (kind which = EDGES; which < KINDS; which++) {
        for (unsigned i = 0; i < 256; i++) {
            arguments x = good_arguments(which);
            for (unsigned k = 0; k < 9; k++) { /* some pattern of signs */
                x.a[k] = ((i * 37u) >> (k % 8) & 1u) != 0 ? 1e30 : -1e30;
                x.b[k] = ((i * 101u + 7u) >> (k * 3 % 8) & 1u) != 0 ? 1e30 : -1e30;
            }
            vbss_collision_closest c;
            expect_ok(closest(which, x.a, x.b, &c, sizeof c));
            const double *first = &c.distance;
            for (size_t k = 0; k < (sizeof c - 8) / sizeof *first; k++) {
                assert_true(isfinite(first[k]));
            }
        }
    }
}

int test_closest_cases(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(touching_features_have_no_normal),
        cmocka_unit_test(bad_numbers_are_rejected_without_output),
        cmocka_unit_test(bad_radii_are_rejected_without_output),
        cmocka_unit_test(answer_size_protocol),
        cmocka_unit_test(largest_coordinates_are_answered),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
