#include "knots/reported.h"

#include <string.h>

#include "base/error.h"
#include "knot/judge.h"

static uint64_t hash_of(const void *bytes, size_t count)
{
    vbss_hash hash;
    vbss_hash_begin(&hash);
    vbss_hash_add(&hash, bytes, count);
    return vbss_hash_end(&hash);
}

/* ---- the whole reading */

static vbss_result listen(vbss_knot_detector *detector, judge_saying *s)
{
    memset(s, 0, sizeof *s);
    VBSS_TRY(vbss_knot_detector_get_state(detector, &s->state, sizeof s->state));
    for (uint32_t i = 0; i < s->state.throw_count; i++) {
        VBSS_TRY(vbss_knot_detector_get_throw(detector, i, &s->throws[i], sizeof s->throws[i]));
    }
    return vbss_knot_detector_get_notation(detector, s->notation, sizeof s->notation);
}

reported reported_by_judge(vbss_knot_detector *detector, const family_case *truth)
{
    judge_saying s;
    if (listen(detector, &s) != VBSS_OK) {
        return (reported){.wrong = true, .fault = "nothing"};
    }
    reported t = {.hash = hash_of(&s, sizeof s),
                  .fault = judge_fault(&s, truth, false),
                  .uncertain = judge_is_uncertain(&s),
                  .certified = judge_is_certified(&s),
                  .ordered = judge_is_ordered(&s),
                  .orderable = truth->throws > 1 && truth->truth == FAMILY_THROWS,
                  .crossings = s.state.crossings};
    t.wrong = t.fault != NULL;
    t.right = !t.wrong && !t.uncertain && truth->truth != FAMILY_OPEN;
    return t;
}

/* ---- one closed curve */

static uint32_t count_kind(const family_case *truth, int wraps, int sign)
{
    uint32_t count = truth->stray_wraps == wraps && truth->stray_sign == sign;
    for (uint32_t i = 0; i < truth->throws; i++) {
        count += truth->wraps[i] == wraps && truth->signs[i] == sign;
    }
    return count;
}

static bool same_throws(const knot_factors *f, const family_case *truth)
{
    bool same = f->count == truth->throws + (truth->stray_wraps > 0);
    for (uint32_t i = 0; i < f->count && same; i++) {
        const knot_factor *one = &f->factors[i];
        uint32_t count = 0;
        for (uint32_t k = 0; k < f->count; k++) {
            count +=
                f->factors[k].wraps == one->wraps && f->factors[k].handedness == one->handedness;
        }
        same = count == count_kind(truth, one->wraps, one->handedness);
    }
    return same;
}

reported reported_by_closure(const knot_reading *r, const family_case *truth)
{
    const knot_invariants *v = &r->invariants;
    const int64_t said[] = {r->reason, r->crossings,   r->certified,
                            r->throws, v->determinant, v->v2,
                            v->v3,     v->signature,   r->throws ? r->factors.count : 0};
    bool same = r->throws && same_throws(&r->factors, truth);
    if (truth->truth == FAMILY_OTHER) {
        same = !r->throws && v->determinant == truth->determinant && v->v2 == truth->v2 &&
               v->v3 == truth->v3;
    }
    reported t = {.hash = hash_of(said, sizeof said),
                  .uncertain = r->reason != VBSS_KNOT_REASON_NONE,
                  .certified = r->certified,
                  .crossings = r->crossings};
    bool has_truth = truth->truth != FAMILY_OPEN && !t.uncertain;
    t.right = has_truth && same;
    t.wrong = has_truth && !same;
    t.fault = t.wrong ? "type" : NULL;
    return t;
}

/* ---- counting */

void reported_add(reported_counts *c, const reported *t)
{
    if (c->wrong == 0 && t->wrong) {
        c->first_fault = t->fault;
    }
    c->configurations++;
    c->right += t->right;
    c->wrong += t->wrong;
    c->uncertain += t->uncertain;
    c->certified += t->certified;
    c->orderable += t->orderable;
    c->ordered += t->orderable && t->ordered;
    c->crossings += t->crossings;
}

void reported_report(const reported_counts *c, bench_result *result)
{
    bench_counter(result, "configurations", (double)c->configurations);
    bench_counter(result, "right", (double)c->right);
    bench_counter(result, "wrong", (double)c->wrong);
    bench_counter(result, "uncertain", (double)c->uncertain);
    bench_counter(result, "certified", (double)c->certified);
    if (c->orderable > 0) {
        bench_counter(result, "orderable", (double)c->orderable);
        bench_counter(result, "ordered", (double)c->ordered);
    }
    bench_counter(result, "crossings", (double)c->crossings / (double)c->configurations);
    if (c->wrong > 0) {
        bench_fail(result, "%u wrong verdicts, the first: %s", (unsigned)c->wrong, c->first_fault);
    }
}
