/* Every family's truth is that of the oracle, for all its types. */
#include "fixtures/knot_families.h"

#include <string.h>

#include "harness/harness.h"
#include "oracle/knot_type.h"

static family_case made, again;
static thread_line limb;

static knot_type truth_of(const family_case *c)
{
    if (c->truth == FAMILY_OTHER) {
        return (knot_type){c->determinant, c->v2, c->v3};
    }
    int wraps[STACK_THROWS + 1], signs[STACK_THROWS + 1];
    uint32_t throws = c->throws;
    memcpy(wraps, c->wraps, sizeof c->wraps);
    memcpy(signs, c->signs, sizeof c->signs);
    if (c->stray_wraps > 0) {
        wraps[throws] = c->stray_wraps;
        signs[throws++] = c->stray_sign;
    }
    return knot_type_of_throws(throws, wraps, signs);
}

static void expect_type(knot_type wanted, const vec3 *x, uint32_t count)
{
    knot_type type;
    assert_true(knot_type_of(x, count, &type));
    assert_int_equal(wanted.determinant, type.determinant);
    assert_int_equal(wanted.v2, type.v2);
    assert_int_equal(wanted.v3, type.v3);
}

/* One limb closed over the tissue's ray: a stray knot in it, or none. */
static void expect_limb(const family_case *c, bool tail)
{
    bool stray = c->stray_wraps > 0 && c->stray_in_tail == tail;
    limb = c->line;
    if (!tail) {
        thread_line_reverse(&limb);
    }
    uint32_t last = (uint32_t)ceil(limb.tissue_place);
    limb.x[last] = thread_line_at(&limb, limb.tissue_place);
    limb.x[last + 1] = vec3_add_scaled(limb.x[last], 1.0, limb.away);
    expect_type(knot_type_of_throws(stray ? 1 : 0, &c->stray_wraps, &c->stray_sign), limb.x,
                last + 2);
}

static void expect_truth(const family_case *c)
{
    if (c->truth == FAMILY_OPEN) {
        return;
    }
    expect_type(truth_of(c), c->line.x, c->line.count);
    for (int tail = 0; tail < 2 && c->line.tissue_place >= 0.0; tail++) {
        expect_limb(c, tail == 1);
    }
}

/* With few segments and with many; nearly all seeds can be made. 72 spread over the types of a large family. */
static void check_family(const family *f)
{
    static const uint32_t more[4] = {0, 60, 120, 240};
    uint32_t seeds = f->period < 24 ? 24 : f->period > 72 ? 72 : f->period, failures = 0;
    for (uint32_t i = 0; i < seeds; i++) {
        if (f->make(f->period > 72 ? 5 * i : i, f->min_segments + more[i % 4], &made)) {
            expect_truth(&made);
        } else {
            failures++;
        }
    }
    if (20 * failures > seeds) {
        fail_msg("%s: %u of %u seeds were refused", f->name, failures, seeds);
    }
}

static void families_match_ground_truth(void **state)
{
    (void)state;
    for (int i = 0; i < FAMILIES; i++) {
        check_family(&families[i]);
    }
}

static void three_throw_types_are_complete_and_correct(void **state)
{
    (void)state;
    const family *three = family_named("three throws");
    bool seen[216] = {false};
    uint32_t types = 0;
    for (uint32_t seed = 0; seed < 216; seed++) {
        assert_true(three->make(seed, 240, &made));
        expect_truth(&made);
        uint32_t number = 0;
        for (int i = 0; i < 3; i++) {
            number = 6 * number + 2 * (uint32_t)(made.wraps[i] - 1) + (made.signs[i] > 0 ? 1 : 0);
        }
        types += seen[number] ? 0 : 1;
        seen[number] = true;
    }
    assert_int_equal(216, types);
}

static void families_have_segment_count_and_repeat(void **state)
{
    (void)state;
    for (int i = 0; i < FAMILIES; i++) {
        uint32_t segments = families[i].min_segments + 50;
        assert_true(families[i].make(5, segments, &made));
        assert_true(families[i].make(5, segments, &again));
        assert_int_equal(made.line.count, again.line.count);
        assert_memory_equal(made.line.x, again.line.x, made.line.count * sizeof made.line.x[0]);
        if (made.truth != FAMILY_OPEN) {
            assert_int_equal(segments + 1, made.line.count);
        }
        assert_ptr_equal(&families[i], family_named(families[i].name));
    }
    assert_null(family_named("none"));
}

int test_families(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(families_match_ground_truth),
        cmocka_unit_test(three_throw_types_are_complete_and_correct),
        cmocka_unit_test(families_have_segment_count_and_repeat),
    };
    return cmocka_run_group_tests_name("families", tests, NULL, NULL);
}
