/* Every name, fault and notation, the same for mirror images; where the order is not known, what is told
 * is what every order has. */
#include "knot/knot.h"

#include <string.h>

#include "harness/harness.h"

enum { IN_ORDER = VBSS_KNOT_THROW_ORDERED, STRAY = IN_ORDER | VBSS_KNOT_THROW_STRAY };

/* Throws as wraps times handedness, ended by 0. */
static knot_classification result_of(const int *throws, uint32_t flags)
{
    knot_classification v = {.throw_count = 0};
    for (; throws[v.throw_count] != 0; v.throw_count++) {
        int one = throws[v.throw_count];
        v.throws[v.throw_count].wraps = one < 0 ? -one : one;
        v.throws[v.throw_count].handedness = one < 0 ? -1 : 1;
        v.throws[v.throw_count].flags = flags;
    }
    return v;
}

static void mirror(knot_classification *v)
{
    for (uint32_t i = 0; i < v->throw_count; i++) {
        v->throws[i].handedness = -v->throws[i].handedness;
    }
}

static void check(knot_classification v, vbss_knot_name name, uint32_t faults, const char *notation)
{
    for (int i = 0; i < 2; i++) {
        char text[KNOT_NOTATION];
        memset(text, 'q', sizeof text);
        vbss_knot_notation_of(&v, text);
        assert_string_equal(text, notation);
        assert_int_equal(text[KNOT_NOTATION - 1], 0);
        assert_int_equal(vbss_knot_name_of(&v), name);
        assert_int_equal(vbss_knot_faults_of(&v), faults);
        mirror(&v);
    }
}

typedef struct row {
    int throws[KNOT_THROWS + 1];
    vbss_knot_name name;
    uint32_t faults;
    const char *notation;
} row;

#define FIRST VBSS_KNOT_FAULT_FIRST
#define LATER VBSS_KNOT_FAULT_LATER
#define FEW VBSS_KNOT_FAULT_FEW
#define MANY VBSS_KNOT_FAULT_MANY
#define GRANNY VBSS_KNOT_FAULT_GRANNY
#define ORDER VBSS_KNOT_FAULT_ORDER

static const row in_order[] = {
    {{0}, VBSS_KNOT_NAME_NONE, FEW, ""},
    {{1}, VBSS_KNOT_NAME_SINGLE, FEW | FIRST, "1"},
    {{2}, VBSS_KNOT_NAME_DOUBLE, FEW, "2"},
    {{3}, VBSS_KNOT_NAME_TRIPLE, FEW | FIRST, "3"},
    {{4}, VBSS_KNOT_NAME_STACK, FEW | FIRST, "4"},
    {{1, -1}, VBSS_KNOT_NAME_SQUARE, FEW | FIRST, "1=1"},
    {{1, 1}, VBSS_KNOT_NAME_GRANNY, FEW | FIRST | GRANNY, "1x1"},
    {{2, -1}, VBSS_KNOT_NAME_SURGEONS, FEW, "2=1"},
    {{2, 1}, VBSS_KNOT_NAME_SURGEONS_GRANNY, FEW | GRANNY, "2x1"},
    {{1, -2}, VBSS_KNOT_NAME_STACK, FEW | FIRST | LATER, "1=2"},
    {{2, -2}, VBSS_KNOT_NAME_STACK, FEW | LATER, "2=2"},
    {{3, -1}, VBSS_KNOT_NAME_STACK, FEW | FIRST, "3=1"},
    {{2, -1, 1}, VBSS_KNOT_NAME_FLS, 0, "2=1=1"},
    {{2, 1, -1}, VBSS_KNOT_NAME_STACK, GRANNY, "2x1=1"},
    {{2, -1, -1}, VBSS_KNOT_NAME_STACK, GRANNY, "2=1x1"},
    {{1, -1, 1}, VBSS_KNOT_NAME_STACK, FIRST, "1=1=1"},
    {{2, -1, 2}, VBSS_KNOT_NAME_STACK, LATER, "2=1=2"},
    {{2, -1, 1, -1}, VBSS_KNOT_NAME_STACK, MANY, "2=1=1=1"},
    {{1, -1, 1, -1, 1, -1, 1, -1}, VBSS_KNOT_NAME_STACK, MANY | FIRST, "1=1=1=1=1=1=1=1"},
};

static const row not_in_order[] = {
    {{1}, VBSS_KNOT_NAME_SINGLE, FEW | FIRST, "1"},
    {{1, -1}, VBSS_KNOT_NAME_SQUARE, FEW | FIRST, "1=1"},
    {{1, 1}, VBSS_KNOT_NAME_GRANNY, FEW | FIRST | GRANNY, "1x1"},
    {{2, -1}, VBSS_KNOT_NAME_STACK, FEW | ORDER, "2+1"},
    {{2, 1}, VBSS_KNOT_NAME_STACK, FEW | ORDER | GRANNY, "2+1"},
    {{2, -1, 1}, VBSS_KNOT_NAME_STACK, ORDER, "2+1+1"},
    {{2, 1, 1}, VBSS_KNOT_NAME_STACK, ORDER | GRANNY, "2+1+1"},
    {{1, 1, 1}, VBSS_KNOT_NAME_STACK, FIRST | GRANNY, "1x1x1"},
    {{1, -1, 1}, VBSS_KNOT_NAME_STACK, ORDER | FIRST, "1+1+1"},
    {{3, -3, 1}, VBSS_KNOT_NAME_STACK, ORDER | FIRST | LATER, "3+3+1"},
};

static void names_faults_and_notations(void **state)
{
    (void)state;
    for (size_t i = 0; i < sizeof in_order / sizeof *in_order; i++) {
        const row *r = &in_order[i];
        check(result_of(r->throws, IN_ORDER), r->name, r->faults, r->notation);
    }
    for (size_t i = 0; i < sizeof not_in_order / sizeof *not_in_order; i++) {
        const row *r = &not_in_order[i];
        check(result_of(r->throws, 0), r->name, r->faults, r->notation);
    }
    knot_classification one = result_of((const int[]){2, -1, 1, 0}, IN_ORDER);
    one.throws[2].flags = 0; /* then neither is the order of the others */
    check(one, VBSS_KNOT_NAME_STACK, ORDER, "2+1+1");
}

static void hitches_and_uncertain_readings(void **state)
{
    (void)state;
    knot_classification v = result_of((const int[]){2, -1, 1, 0}, IN_ORDER);
    v.throws[1].flags |= VBSS_KNOT_THROW_HITCH;
    check(v, VBSS_KNOT_NAME_FLS, VBSS_KNOT_FAULT_HITCH, "2=1=1");
    v.reason = VBSS_KNOT_REASON_ENDS;
    check(v, VBSS_KNOT_NAME_FLS, VBSS_KNOT_FAULT_HITCH | VBSS_KNOT_FAULT_UNCERTAIN, "2=1=1");
}

static void non_stack_is_other(void **state)
{
    (void)state;
    knot_classification v = {.other = true};
    check(v, VBSS_KNOT_NAME_OTHER, VBSS_KNOT_FAULT_TYPE, "?");
    v = result_of((const int[]){2, 1, 0}, IN_ORDER);
    v.other = true;
    v.throws[1].flags = STRAY;
    check(v, VBSS_KNOT_NAME_OTHER, VBSS_KNOT_FAULT_TYPE | VBSS_KNOT_FAULT_STRAY, "? (1)");
}

static void knot_in_one_limb_is_ignored(void **state)
{
    (void)state;
    knot_classification v = result_of((const int[]){2, 1, -1, 1, 0}, IN_ORDER);
    v.throws[1].flags = STRAY;
    check(v, VBSS_KNOT_NAME_FLS, VBSS_KNOT_FAULT_STRAY, "2=1=1 (1)");
    v.throws[1].flags = VBSS_KNOT_THROW_STRAY; /* where it is makes no difference */
    check(v, VBSS_KNOT_NAME_FLS, VBSS_KNOT_FAULT_STRAY, "2=1=1 (1)");
    v.throws[0].flags = STRAY | VBSS_KNOT_THROW_HITCH;
    check(v, VBSS_KNOT_NAME_SQUARE, VBSS_KNOT_FAULT_STRAY | FEW | FIRST, "1=1 (2+1)");
    v = result_of((const int[]){3, 0}, STRAY);
    check(v, VBSS_KNOT_NAME_NONE, VBSS_KNOT_FAULT_STRAY | FEW, "(3)");
}

static void long_notation_fits_or_is_marked(void **state)
{
    (void)state;
    knot_classification v =
        result_of((const int[]){99, -99, 99, -99, 99, -99, 99, -99, 0}, IN_ORDER);
    check(v, VBSS_KNOT_NAME_STACK, MANY | FIRST | LATER, "99=99=99=99=99=99=99=99");
    v.throws[7].flags = STRAY;
    v.throws[6].flags = STRAY;
    check(v, VBSS_KNOT_NAME_STACK, MANY | FIRST | LATER | VBSS_KNOT_FAULT_STRAY,
          "99=99=99=99=99=99 (99+99)");
    v = result_of((const int[]){123, -456, 123, -456, 123, -456, 123, -999, 0}, IN_ORDER);
    check(v, VBSS_KNOT_NAME_STACK, MANY | FIRST | LATER, "123=456=123=456=123=456=123=999");
    v.throws[0].wraps = 1234;
    check(v, VBSS_KNOT_NAME_STACK, MANY | FIRST | LATER, "1234=456=123=456=123=456=123..");
    v.throws[0].wraps = 12345;
    check(v, VBSS_KNOT_NAME_STACK, MANY | FIRST | LATER, "12345=456=123=456=123=456=123..");
    v.throws[0].wraps = 123456;
    check(v, VBSS_KNOT_NAME_STACK, MANY | FIRST | LATER, "123456=456=123=456=123=456..");
    for (uint32_t i = 0; i < KNOT_THROWS; i++) {
        v.throws[i].wraps = INT32_MAX;
        v.throws[i].flags |= i > 1 ? VBSS_KNOT_THROW_STRAY : 0;
    }
    check(v, VBSS_KNOT_NAME_STACK, FEW | FIRST | LATER | VBSS_KNOT_FAULT_STRAY,
          "2147483647=2147483647 ..");
}

/* ---- all stacks of at most four throws, in all orders */

static const int hands[6] = {1, -1, 2, -2, 3, -3};

/* Only 2=1=1 is the FLS knot, and it alone has no fault. */
static void only_one_type_is_faultless(void **state)
{
    (void)state;
    uint32_t found = 0;
    for (int i = 0; i < 216; i++) {
        const int throws[4] = {hands[i / 36], hands[i / 6 % 6], hands[i % 6], 0};
        knot_classification v = result_of(throws, IN_ORDER);
        char text[KNOT_NOTATION];
        vbss_knot_notation_of(&v, text);
        bool fls = strcmp(text, "2=1=1") == 0;
        assert_int_equal(vbss_knot_name_of(&v) == VBSS_KNOT_NAME_FLS, fls);
        assert_int_equal(vbss_knot_faults_of(&v) == 0, fls);
        for (uint32_t k = 0; k < 3; k++) {
            assert_int_equal(text[2 * (size_t)k], '0' + v.throws[k].wraps);
        }
        for (int k = 0; k < 2; k++) {
            assert_int_equal(text[2 * k + 1], (throws[k] < 0) == (throws[k + 1] < 0) ? 'x' : '=');
        }
        found += fls;
    }
    assert_int_equal(found, 2);
}

typedef struct summary {
    uint32_t orders, faults; /* that all have */
    vbss_knot_name name;     /* of all, or STACK */
    char notation[KNOT_NOTATION];
    bool alike; /* all are written the same */
} summary;

static void take_in(summary *s, const int *throws)
{
    knot_classification v = result_of(throws, IN_ORDER);
    char text[KNOT_NOTATION];
    vbss_knot_name name = vbss_knot_name_of(&v);
    vbss_knot_notation_of(&v, text);
    if (s->orders++ == 0) {
        *s = (summary){.orders = 1, .faults = vbss_knot_faults_of(&v), .name = name, .alike = true};
        memcpy(s->notation, text, sizeof text);
    }
    s->faults &= vbss_knot_faults_of(&v);
    s->name = s->name == name ? name : VBSS_KNOT_NAME_STACK;
    s->alike = s->alike && strcmp(text, s->notation) == 0;
}

static void check_all_orders(const int *throws, uint32_t count)
{
    summary s = {.orders = 0};
    for (uint32_t order = 0; order < 24; order++) { /* Lehmer's code: takes one of what is left */
        int left[5] = {throws[0], throws[1], throws[2], throws[3], 0}, permuted[5] = {0};
        for (uint32_t i = 0, rest = order; i < count; i++) {
            uint32_t k = rest % (count - i);
            rest /= count - i;
            permuted[i] = left[k];
            memmove(left + k, left + k + 1, (4 - k) * sizeof *left);
        }
        take_in(&s, permuted);
    }
    knot_classification v = result_of(throws, 0);
    assert_int_equal(vbss_knot_name_of(&v), s.name);
    assert_int_equal(vbss_knot_faults_of(&v), s.faults | (s.alike ? 0 : ORDER));
    char text[KNOT_NOTATION];
    vbss_knot_notation_of(&v, text);
    assert_int_equal(strchr(text, '+') == NULL, s.alike);
    assert_true(!s.alike || strcmp(text, s.notation) == 0);
}

static void without_order_common_faults_are_reported(void **state)
{
    (void)state;
    for (uint32_t count = 1, all = 6; count <= 4; count++, all *= 6) {
        for (uint32_t i = 0; i < all; i++) {
            int throws[5] = {0};
            for (uint32_t k = 0, rest = i; k < count; k++, rest /= 6) {
                throws[k] = hands[rest % 6];
            }
            check_all_orders(throws, count);
        }
    }
}

int test_names(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(names_faults_and_notations),
        cmocka_unit_test(hitches_and_uncertain_readings),
        cmocka_unit_test(non_stack_is_other),
        cmocka_unit_test(knot_in_one_limb_is_ignored),
        cmocka_unit_test(long_notation_fits_or_is_marked),
        cmocka_unit_test(only_one_type_is_faultless),
        cmocka_unit_test(without_order_common_faults_are_reported),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
