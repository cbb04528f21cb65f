/* What a detector says does not depend on where a thread lies, how finely it is told, or which limb is the tail; and a
 * mirror shows the other hand. */
#include <math.h>

#include "knot/cases.h"
#include "knot/derive.h"

/* ---- what stays the same */

/* Half hitches are a matter of places, which a diagram shows so or so. */
static uint32_t faults_of(const judge_saying *s)
{
    return s->state.faults & ~(uint32_t)VBSS_KNOT_FAULT_HITCH;
}

static void expect_same_knot(const judge_saying *a, const judge_saying *b, int hand)
{
    assert_false(judge_is_uncertain(a) || judge_is_uncertain(b));
    assert_true(a->state.determinant == b->state.determinant && a->state.v2 == b->state.v2);
    assert_true(a->state.v3 == hand * b->state.v3);
    assert_int_equal(a->state.signature, hand * b->state.signature);
    assert_int_equal(a->state.signature_tristram, hand * b->state.signature_tristram);
    assert_int_equal(a->state.throw_count, b->state.throw_count);
    if (!judge_is_ordered(a) || !judge_is_ordered(b)) {
        return;
    }
    assert_int_equal(a->state.name, b->state.name);
    assert_int_equal(faults_of(a), faults_of(b));
    assert_string_equal(a->notation, b->notation);
    for (uint32_t i = 0; i < a->state.throw_count; i++) {
        assert_int_equal(a->throws[i].wraps, b->throws[i].wraps);
        assert_int_equal(a->throws[i].handedness, hand * b->throws[i].handedness);
    }
}

static void expect_same_truth(const family_case *c, const derive_whole *how, int hand)
{
    static family_case other;
    judge_saying first, second;
    derive_whole_of(c, how, &other);
    cases_hear(c, &first);
    cases_hear(&other, &second);
    const char *fault = judge_fault(&second, &other, false);
    if (fault != NULL) {
        fail_msg("%s: \"%s\", \"%s\"", fault, first.notation, second.notation);
    }
    expect_same_knot(&first, &second, hand);
}

static void mirror(const family_case *c)
{
    derive_whole how = derive_plain();
    how.mirrored = true;
    expect_same_truth(c, &how, -1);
}

static void mirror_flips_handedness(void **state)
{
    (void)state;
    on_all_cases(mirror);
}

static void swap_limbs(const family_case *c)
{
    derive_whole how = derive_plain();
    how.reversed = true;
    expect_same_truth(c, &how, 1);
}

static void limbs_can_be_exchanged(void **state)
{
    (void)state;
    on_all_cases(swap_limbs);
}

static void carry_away(const family_case *c)
{
    vbss_random random;
    vbss_random_seed(&random, c->line.count, (uint64_t)(1e9 * fabs(c->line.x[0].x)));
    for (int k = 0; k < 8; k++) {
        derive_whole how = derive_draw(&random), plain = derive_plain();
        how.mirrored = how.reversed = false;
        how.inserted = 0;
        how.doubled = 0.0;
        how.scale = k == 1 ? 1e-3 : k == 2 ? 1e3 : 1.0;
        double far = k == 3 ? 1.0 : k == 4 ? 10.0 : k == 5 ? 100.0 : 0.0;
        how.shift = vec3_scale(vbss_random_direction(&random), far);
        how.turn = k == 0 ? plain.turn : how.turn;
        expect_same_truth(c, &how, 1);
    }
}

static void scale_and_position_invariance(void **state)
{
    (void)state;
    on_all_cases(carry_away);
}

static void refine(const family_case *c)
{
    derive_whole how = derive_plain();
    for (uint64_t k = 0; k < 4; k++) {
        how.seed = k;
        how.doubled = k == 0 ? 0.5 : 0.0;
        how.inserted = k == 0 ? 0 : k == 1 ? 1000 : 100;
        expect_same_truth(c, &how, 1);
    }
}

static void resampling_invariance(void **state)
{
    (void)state;
    on_all_cases(refine);
}

static void coarsen(const family_case *c)
{
    static derivation d;
    judge_saying first, second;
    if (!derive_begin(&d, c)) {
        return;
    }
    vbss_random random;
    vbss_random_seed(&random, c->line.count, 5);
    cases_hear(c, &first);
    for (int k = 0; k < 4; k++) {
        derive_move(&d, &random);
        cases_hear(&d.from, &second);
        assert_null(judge_fault(&second, &d.from, false));
        expect_same_knot(&first, &second, 1);
    }
}

static void isotopy_invariance(void **state)
{
    (void)state;
    on_all_cases(coarsen);
}

int test_detector_invariance(void)
{
    const struct CMUnitTest tests[] = {
        harness_test(mirror_flips_handedness),
        harness_test(limbs_can_be_exchanged),
        harness_test(scale_and_position_invariance),
        harness_test(resampling_invariance),
        harness_test(isotopy_invariance),
    };
    return cmocka_run_group_tests(tests, begin_cases, end_cases);
}
