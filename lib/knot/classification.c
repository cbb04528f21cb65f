/* Public result of a complete reading: throws with their verdicts, and events for all changes.
 * There is no latch: a throw that the next certain reading does not show is revoked. */
#include "knot/knot.h"

static uint32_t hand_number(int32_t handedness)
{
    return handedness > 0 ? 2 : 1;
}

/* ---- throws */

/* Number of throws of a kind in a reading, minus those of this kind before throw `until` of the
 * classification. */
static int32_t count_left(const knot_reading *r, const knot_classification *v, uint32_t until,
                          const vbss_knot_throw *kind)
{
    int32_t count = 0;
    for (uint32_t i = 0; i < r->factors.count; i++) {
        count += r->factors.factors[i].wraps == kind->wraps &&
                 r->factors.factors[i].handedness == kind->handedness;
    }
    for (uint32_t i = 0; i < until; i++) {
        count -= v->throws[i].wraps == kind->wraps && v->throws[i].handedness == kind->handedness;
    }
    return count;
}

/* Whether the type is proved and the closures agree. */
static bool is_certain(const knot_job *job)
{
    return (job->outward.certified || job->locator.certified) &&
           job->agreeing == job->closure.alternative_count;
}

static void fill_throw(const knot_detector *d, uint32_t number, vbss_knot_throw *to)
{
    const knot_located *from = &d->job.locator.throws[number];
    const knot_input *input = &d->job.input;
    *to = (vbss_knot_throw){.struct_size = sizeof *to,
                            .wraps = from->wraps,
                            .handedness = from->handedness,
                            .reading_step = d->job.step,
                            .formed_step = d->job.step};
    to->flags |= from->ordered ? VBSS_KNOT_THROW_ORDERED : 0u;
    to->flags |= from->stray ? VBSS_KNOT_THROW_STRAY : 0u;
    to->verdict = is_certain(&d->job) && (from->ordered || from->stray)
                      ? VBSS_KNOT_VERDICT_CERTIFIED
                      : VBSS_KNOT_VERDICT_FORMED;
    if (!from->located) {
        return;
    }
    to->flags |= VBSS_KNOT_THROW_LOCATED;
    vbss_knot_places_to_host(input, from->tail_places, to->tail_places);
    vbss_knot_places_to_host(input, from->long_places, to->long_places);
    to->slip = d->job.slips[number];
    to->tail_length = vbss_knot_length(input, 0.0, from->tail_places[0]);
    to->flags |= from->stray || fabs(to->slip) < d->config.slip_limit ? 0u : VBSS_KNOT_THROW_HITCH;
    to->flags |= to->tail_length < d->config.tail_least ? VBSS_KNOT_THROW_REVOCABLE : 0u;
}

/* A throw in one limb alone is stray, wherever it is. */
static void flag_strays(knot_classification *v, const knot_reading *limb)
{
    uint32_t count = knot_was_read(limb) ? limb->factors.count : 0;
    for (uint32_t k = 0; k < count; k++) {
        const knot_factor *f = &limb->factors.factors[k];
        bool found = false;
        for (uint32_t i = v->throw_count; i-- > 0 && !found;) {
            vbss_knot_throw *t = &v->throws[i];
            found = t->wraps == f->wraps && t->handedness == f->handedness &&
                    !(t->flags & VBSS_KNOT_THROW_LOCATED) && !(t->flags & VBSS_KNOT_THROW_STRAY);
            t->flags |= found ? VBSS_KNOT_THROW_STRAY : 0u;
        }
    }
}

/* Certified results require that both limbs show exactly the stray throws. */
static void check_strays(const knot_job *job, knot_classification *v)
{
    uint32_t strays = 0;
    for (uint32_t i = 0; i < v->throw_count; i++) {
        strays += (v->throws[i].flags & VBSS_KNOT_THROW_STRAY) != 0;
    }
    bool agree = knot_was_read(&job->tail) && knot_was_read(&job->long_limb) &&
                 job->tail.factors.count + job->long_limb.factors.count == strays;
    for (uint32_t i = 0; i < v->throw_count && job->closure.has_tissue && !agree; i++) {
        v->throws[i].verdict = VBSS_KNOT_VERDICT_FORMED;
    }
}

/* ---- order by history: throws that were ordered and are still present keep their order; a new
 * throw is outermost */

static int32_t count_kind(const knot_classification *v, const vbss_knot_throw *kind)
{
    int32_t count = 0;
    for (uint32_t i = 0; i < v->throw_count; i++) {
        count += v->throws[i].wraps == kind->wraps && v->throws[i].handedness == kind->handedness;
    }
    return count;
}

/* Whether all throws have the given order flag and none is stray. */
static bool is_plain(const knot_classification *v, uint32_t ordered)
{
    bool plain = true;
    for (uint32_t i = 0; i < v->throw_count; i++) {
        plain = plain &&
                (v->throws[i].flags & (VBSS_KNOT_THROW_ORDERED | VBSS_KNOT_THROW_STRAY)) == ordered;
    }
    return plain;
}

static void put_first(knot_classification *v, uint32_t at, const vbss_knot_throw *kind,
                      bool is_certain)
{
    uint32_t found = at;
    while (found < v->throw_count && (v->throws[found].wraps != kind->wraps ||
                                      v->throws[found].handedness != kind->handedness)) {
        found++;
    }
    if (found < v->throw_count) {
        vbss_knot_throw moving = v->throws[found];
        v->throws[found] = v->throws[at];
        v->throws[at] = moving;
        v->throws[at].verdict = is_certain ? kind->verdict : v->throws[at].verdict;
    }
}

static void order_by_history(const knot_classification *before, knot_classification *v,
                             bool is_certain)
{
    bool grown = v->throw_count == before->throw_count || v->throw_count == before->throw_count + 1;
    bool matches = grown && before->throw_count > 0 && is_plain(before, VBSS_KNOT_THROW_ORDERED) &&
                   is_plain(v, 0);
    for (uint32_t i = 0; i < before->throw_count && matches; i++) {
        matches = count_kind(v, &before->throws[i]) >= count_kind(before, &before->throws[i]);
    }
    if (!matches) {
        return;
    }
    for (uint32_t i = 0; i < before->throw_count; i++) {
        put_first(v, i, &before->throws[i], is_certain);
    }
    for (uint32_t i = 0; i < v->throw_count; i++) {
        v->throws[i].flags |= VBSS_KNOT_THROW_ORDERED;
    }
}

static void flag_relations(knot_classification *v, const knot_reading *tools, bool has_tools)
{
    const vbss_knot_throw *before = NULL;
    for (uint32_t i = 0; i < v->throw_count; i++) {
        vbss_knot_throw *t = &v->throws[i];
        if (has_tools && knot_was_read(tools) && count_left(tools, v, i, t) <= 0) {
            t->flags |= VBSS_KNOT_THROW_REVOCABLE;
        }
        if (t->flags & VBSS_KNOT_THROW_STRAY) {
            continue;
        }
        if (before != NULL && before->handedness == t->handedness) {
            t->flags |= VBSS_KNOT_THROW_GRANNY;
        }
        before = t;
    }
}

static void list_throws(const knot_detector *d, bool follows, knot_classification *v)
{
    const knot_job *job = &d->job;
    *v = (knot_classification){.reason = VBSS_KNOT_REASON_NONE};
    v->other = !job->outward.throws;
    if (v->other) {
        return;
    }
    v->throw_count = job->outward.factors.count;
    for (uint32_t i = 0; i < v->throw_count; i++) {
        fill_throw(d, i, &v->throws[i]);
    }
    flag_strays(v, &job->tail);
    flag_strays(v, &job->long_limb);
    check_strays(job, v);
    if (follows) {
        order_by_history(&d->classification, v, is_certain(job));
    }
    flag_relations(v, &job->tools, job->has_tools);
}

/* ---- changes */

static bool is_same_throw(const vbss_knot_throw *a, const vbss_knot_throw *b)
{
    return a->wraps == b->wraps && a->handedness == b->handedness &&
           ((a->flags ^ b->flags) & VBSS_KNOT_THROW_STRAY) == 0;
}

static void emit_revoked(knot_detector *d, uint32_t i)
{
    const vbss_knot_throw *t = &d->classification.throws[i];
    d->statistics.revoked++;
    vbss_knot_emit_event(d, VBSS_KNOT_EVENT_REVOKED, i, (uint32_t)t->wraps,
                         hand_number(t->handedness));
}

static void emit_changes(knot_detector *d, knot_classification *v)
{
    knot_classification *old = &d->classification;
    uint32_t same = 0;
    while (same < old->throw_count && same < v->throw_count &&
           is_same_throw(&old->throws[same], &v->throws[same])) {
        v->throws[same].formed_step = old->throws[same].formed_step;
        same++;
    }
    for (uint32_t i = old->throw_count; i-- > same;) {
        emit_revoked(d, i);
    }
    for (uint32_t i = 0; i < v->throw_count; i++) {
        const vbss_knot_throw *t = &v->throws[i];
        bool was_certified = i < same && old->throws[i].verdict == VBSS_KNOT_VERDICT_CERTIFIED;
        bool is_certified = t->verdict == VBSS_KNOT_VERDICT_CERTIFIED;
        uint32_t wraps = (uint32_t)t->wraps, hand = hand_number(t->handedness);
        if (i >= same) {
            bool stray = (t->flags & VBSS_KNOT_THROW_STRAY) != 0;
            vbss_knot_emit_event(d, stray ? VBSS_KNOT_EVENT_STRAY : VBSS_KNOT_EVENT_FORMED, i,
                                 wraps, hand);
        }
        if (is_certified && !was_certified) {
            vbss_knot_emit_event(d, VBSS_KNOT_EVENT_CERTIFIED, i, wraps, hand);
        } else if (was_certified && !is_certified) {
            emit_revoked(d, i);
        }
    }
}

static vbss_knot_verdict lowest_certainty(const knot_classification *v)
{
    if (v->reason != VBSS_KNOT_REASON_NONE) {
        return VBSS_KNOT_VERDICT_UNCERTAIN;
    }
    if (v->other) {
        return VBSS_KNOT_VERDICT_FORMED;
    }
    vbss_knot_verdict lowest =
        v->throw_count > 0 ? VBSS_KNOT_VERDICT_CERTIFIED : VBSS_KNOT_VERDICT_NONE;
    for (uint32_t i = 0; i < v->throw_count; i++) {
        lowest = v->throws[i].verdict < lowest ? v->throws[i].verdict : lowest;
    }
    return lowest;
}

/* ---- the throw being tied */

/* The one throw that would be added by withdrawing the tools. */
static const knot_factor *added_by_tools(const knot_job *job)
{
    const knot_factors *now = &job->outward.factors, *then = &job->tools.factors;
    const knot_factor *added = NULL;
    uint32_t matched = 0;
    if (!job->has_tools || !knot_was_read(&job->tools) || !knot_was_read(&job->outward)) {
        return NULL;
    }
    bool used[KNOT_THROWS] = {false};
    for (uint32_t i = 0; i < then->count; i++) {
        bool found = false;
        for (uint32_t k = 0; k < now->count && !found; k++) {
            found = !used[k] && now->factors[k].wraps == then->factors[i].wraps &&
                    now->factors[k].handedness == then->factors[i].handedness;
            used[k] |= found;
        }
        matched += found;
        added = found ? added : &then->factors[i];
    }
    return matched == now->count && then->count == matched + 1 ? added : NULL;
}

/* Wraps from winding: k < |w| <= k + 1 signed turns toward the tip give k wraps, left-handed for w
 * > 0. */
static void set_wrapping(vbss_knot_state *state, uint32_t tool, const knot_winding *w)
{
    int32_t wraps = 0;
    while (wraps < 99 && fabs(w->run_turns) > wraps + 1.0) {
        wraps++;
    }
    state->next_verdict = VBSS_KNOT_VERDICT_WRAPPING;
    state->next_tool = tool;
    state->next_wraps = w->sense > 0 ? wraps : 0;
    state->next_handedness = w->run_turns > 0.0 ? -1 : 1;
}

void vbss_knot_classify_next(knot_detector *d)
{
    vbss_knot_state *state = &d->state;
    const knot_winding *strongest = NULL;
    bool passed = state->next_verdict == VBSS_KNOT_VERDICT_PASSED;
    for (uint32_t i = 0; i < d->input.tool_count; i++) {
        const knot_winding *w = &d->tools[i].winding;
        if (d->tools[i].wrapped &&
            (strongest == NULL || fabs(w->run_turns) > fabs(strongest->run_turns))) {
            strongest = w;
            if (!passed) {
                set_wrapping(state, i, w);
            }
        }
    }
    if (strongest == NULL && !passed) {
        state->next_verdict = VBSS_KNOT_VERDICT_NONE;
        state->next_wraps = state->next_handedness = 0;
        state->next_tool = 0;
    }
}

static void classify_passed(knot_detector *d)
{
    vbss_knot_state *state = &d->state;
    const knot_factor *added = added_by_tools(&d->job);
    bool had = state->next_verdict == VBSS_KNOT_VERDICT_PASSED;
    if (added == NULL) {
        state->next_verdict = VBSS_KNOT_VERDICT_NONE; /* or the result of winding */
    } else {
        if (!had || state->next_wraps != added->wraps ||
            state->next_handedness != added->handedness) {
            uint32_t tool = state->next_tool; /* the tool about which the thread winds */
            vbss_knot_emit_event(d, VBSS_KNOT_EVENT_PASSED, tool, (uint32_t)added->wraps,
                                 hand_number(added->handedness));
        }
        state->next_verdict = VBSS_KNOT_VERDICT_PASSED;
        state->next_wraps = added->wraps;
        state->next_handedness = added->handedness;
    }
    vbss_knot_classify_next(d);
}

/* ---- the complete classification */

static vbss_knot_reason reason_of(const knot_detector *d)
{
    const knot_job *job = &d->job;
    if (job->outward.reason != VBSS_KNOT_REASON_NONE) {
        return job->outward.reason;
    }
    uint32_t differing = job->closure.alternative_count - job->agreeing;
    return differing > d->config.closure_tolerance ? VBSS_KNOT_REASON_ENDS : VBSS_KNOT_REASON_NONE;
}

static void publish_reading(knot_detector *d)
{
    const knot_job *job = &d->job;
    const knot_reading *r = &job->outward;
    vbss_knot_state *s = &d->state;
    s->crossings = r->crossings;
    s->certified = r->certified || job->locator.certified;
    s->signature = r->invariants.signature;
    s->signature_tristram = r->invariants.signature_tristram;
    s->determinant = r->invariants.determinant;
    s->v2 = r->invariants.v2;
    s->v3 = r->invariants.v3;
    s->closures = job->closure.alternative_count;
    s->closures_agreeing = job->agreeing;
    s->ends_free = job->closure.ends_free;
    s->reading_step = job->step;
}

void vbss_knot_classify(knot_detector *d, bool follows)
{
    knot_classification v;
    vbss_knot_reason reason = reason_of(d);
    publish_reading(d);
    if (reason == VBSS_KNOT_REASON_NONE) {
        list_throws(d, follows, &v);
        emit_changes(d, &v);
        d->classification = v;
        classify_passed(d);
    } else { /* keeps the throws, which are no longer certain */
        d->statistics.uncertain++;
        if (d->classification.reason != reason) {
            vbss_knot_emit_event(d, VBSS_KNOT_EVENT_UNCERTAIN, (uint32_t)reason, 0, 0);
        }
        d->classification.reason = reason;
        if (!d->job.has_tools) {
            d->state.next_verdict = VBSS_KNOT_VERDICT_NONE;
            vbss_knot_classify_next(d);
        }
    }
    vbss_knot_state *s = &d->state;
    s->name = vbss_knot_name_of(&d->classification);
    s->faults = vbss_knot_faults_of(&d->classification);
    s->throw_count = d->classification.throw_count;
    s->verdict = lowest_certainty(&d->classification);
    s->reason = reason;
    d->statistics.readings++;
    if (d->statistics.most_work < (uint64_t)d->job.ops_used) {
        d->statistics.most_work = (uint64_t)d->job.ops_used;
    }
    vbss_knot_count_job(&d->job, &d->statistics);
    vbss_knot_emit_event(d, VBSS_KNOT_EVENT_READ, s->throw_count, (uint32_t)s->name,
                         (uint32_t)s->verdict);
}
