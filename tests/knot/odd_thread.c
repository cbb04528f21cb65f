#include "knot/odd_thread.h"

#include <math.h>

judge odd_judge;
static judge twin;
vec3 odd_x[ODD_MAX];
judge_saying odd_said;

void odd_begin(uint32_t points, uint32_t crossings)
{
    judge *both[] = {&odd_judge, &twin};
    for (int i = 0; i < 2; i++) {
        judge_begin(both[i]);
        both[i]->config.point_capacity = points;
        both[i]->config.crossing_capacity = crossings;
        assert_true(judge_make(both[i]));
    }
}

void odd_end(void)
{
    judge_end(&odd_judge);
    judge_end(&twin);
}

static void expect_finite(const judge_saying *s, uint32_t count)
{
    for (uint32_t i = 0; i < s->state.throw_count; i++) {
        const vbss_knot_throw *t = &s->throws[i];
        const double places[] = {t->tail_places[0], t->tail_places[1], t->long_places[0],
                                 t->long_places[1]};
        for (int k = 0; k < 4; k++) {
            assert_true(places[k] >= 0.0 && places[k] <= count - 1.0);
        }
        assert_true(fabs(t->slip) <= 1.0);
        assert_true(t->tail_length >= 0.0 && isfinite(t->tail_length));
    }
}

/* Of `odd_x`: the same twice. */
void odd_hear(uint32_t count, bool tissue)
{
    judge_saying again;
    vbss_knot_input in;
    uint64_t hash, other;
    expect_ok(vbss_knot_input_init(&in, sizeof in));
    in.points = &odd_x[0].x;
    in.point_count = count;
    if (tissue) {
        in.hole_count = 1;
        in.hole_places[0] = 0.5 * count;
        in.away[2] = -1.0;
    }
    expect_ok(judge_hear(&odd_judge, &in, &odd_said));
    expect_ok(judge_hear(&twin, &in, &again));
    assert_memory_equal(&odd_said, &again, sizeof odd_said);
    expect_ok(vbss_knot_detector_get_hash(odd_judge.detector, &hash));
    expect_ok(vbss_knot_detector_get_hash(twin.detector, &other));
    assert_true(hash == other);
    expect_finite(&odd_said, count);
    bool uncertain = judge_is_uncertain(&odd_said);
    assert_int_equal(uncertain, odd_said.state.reason != VBSS_KNOT_REASON_NONE);
    assert_int_equal(uncertain, (odd_said.state.faults & VBSS_KNOT_FAULT_UNCERTAIN) != 0);
}

void odd_expect_no_knot(void)
{
    assert_int_equal(odd_said.state.verdict, VBSS_KNOT_VERDICT_NONE);
    assert_int_equal(odd_said.state.name, VBSS_KNOT_NAME_NONE);
    assert_true(odd_said.state.determinant == 1 && odd_said.state.v2 == 0 &&
                odd_said.state.v3 == 0);
}
