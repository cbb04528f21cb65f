/* The score: 600 - t - penalties (Korndorffer et al. 2005), each penalty with its reason. */
#include "metrics/metrics.h"

/* What a penalty says, by its kind. */
static const char *const texts[] = {
    "",
    "the needle went through away from its mark",
    "the slit gapes",
    "the knot slips or comes apart",
    "throws are missing",
    "a throw lies the same way round as the one before: a granny",
    "a puncture was withdrawn",
    "something was dropped",
    "the needle did not change hands",
    "a penalty of the host",
    "the time is up",
    "the drain was torn off",
    "the thread broke or was cut early",
    "finished before both tails were cut",
};

/* All penalties in their order pass through here; one may be wanted. */
typedef struct tally {
    uint32_t count, number;
    double sum;
    vbss_metrics_penalty *wanted;
} tally;

static void take(tally *t, vbss_metrics_penalty_kind kind, const metrics_note *why, double measure,
                 double amount)
{
    if (t->wanted != NULL && t->count == t->number) {
        *t->wanted = (vbss_metrics_penalty){.struct_size = sizeof *t->wanted,
                                            .kind = kind,
                                            .number = why->number,
                                            .tool = why->tool,
                                            .step = why->step,
                                            .time = why->time,
                                            .measure = measure,
                                            .amount = amount,
                                            .text = texts[kind]};
        vec3_store(t->wanted->position, why->position);
        vec3_store(t->wanted->force, why->force);
    }
    t->count++;
    t->sum += amount;
}

/* ---- what was done */

static void judge_places(const metrics_object *m, tally *t)
{
    for (int i = 0; i < 2; i++) {
        const metrics_note *puncture = &m->facts[METRICS_PUNCTURE + i];
        if (puncture->standing && puncture->value[0] > 0.0) {
            take(t, VBSS_METRICS_PENALTY_DEVIATION, puncture, puncture->value[0],
                 m->config.weight_deviation * puncture->value[0]);
        }
    }
    const metrics_note *gap = &m->facts[METRICS_GAPES];
    if (gap->standing && gap->value[0] > 0.0) {
        take(t, VBSS_METRICS_PENALTY_GAP, gap, gap->value[0], m->config.weight_gap * gap->value[0]);
    }
}

static vbss_metrics_tightness tightness(const metrics_object *m)
{
    return m->config.tightness_method == VBSS_METHOD_PAPER ? vbss_metrics_tightness_paper(&m->pull)
                                                           : vbss_metrics_tightness_ours(&m->pull);
}

static metrics_note now(const metrics_object *m, double time)
{
    metrics_note note = {.tool = VBSS_METRICS_NO_TOOL, .step = m->step, .time = time};
    return note;
}

static void judge_knot(const metrics_object *m, tally *t)
{
    vbss_metrics_tightness loose = tightness(m);
    uint32_t standing = 0;
    if (loose > VBSS_METRICS_TIGHTNESS_TIGHT) {
        take(t, VBSS_METRICS_PENALTY_TIGHTNESS, &m->pull.last, loose,
             m->config.weight_tightness * loose);
    }
    for (uint32_t i = 0; i < m->throw_count; i++) {
        standing += m->throws[i].standing;
    }
    if (vbss_metrics_stopped(m) && standing < m->config.throws_wanted) {
        double missing = m->config.throws_wanted - standing;
        metrics_note end = now(m, vbss_metrics_stop_time(m));
        take(t, VBSS_METRICS_PENALTY_THROWS, &end, missing, m->config.weight_throw * missing);
    }
    for (uint32_t i = 0; i < m->throw_count; i++) {
        const metrics_note *tied = &m->throws[i];
        if (tied->standing && tied->relation == VBSS_METRICS_RELATION_GRANNY) {
            take(t, VBSS_METRICS_PENALTY_GRANNY, tied, 1.0, m->config.weight_granny);
        }
    }
}

static void judge_incidents(const metrics_object *m, tally *t)
{
    const vbss_metrics_config *c = &m->config;
    for (uint32_t i = 0; i < m->incident_count; i++) {
        const metrics_note *note = &m->incidents[i];
        if (!note->standing) {
            continue;
        }
        switch (note->kind) {
        case VBSS_METRICS_EVENT_PUNCTURE:
            take(t, VBSS_METRICS_PENALTY_ATTEMPT, note, 1.0, c->weight_attempt);
            break;
        case VBSS_METRICS_EVENT_DROP:
            take(t, VBSS_METRICS_PENALTY_DROP, note, 1.0, c->weight_drop);
            break;
        case VBSS_METRICS_EVENT_TRANSFER_MISSED:
            take(t, VBSS_METRICS_PENALTY_TRANSFER, note, 1.0, c->weight_transfer);
            break;
        case VBSS_METRICS_EVENT_HOST:
            take(t, VBSS_METRICS_PENALTY_HOST, note, note->value[0],
                 c->weight_host * note->value[0]);
            break;
        default: /* a transfer costs nothing */
            break;
        }
    }
}

/* ---- what takes all that is left */

static bool judge_ends(const metrics_object *m, tally *t)
{
    const metrics_note *avulsed = &m->facts[METRICS_AVULSED], *broken = &m->facts[METRICS_BROKEN];
    double time = vbss_metrics_time(m), most = m->config.max_time;
    bool late = time >= most, unfinished = m->finished && !vbss_metrics_stopped(m);
    const struct {
        bool is_so;
        vbss_metrics_penalty_kind kind;
        metrics_note why;
    } ends[] = {
        {late, VBSS_METRICS_PENALTY_TIMEOUT, now(m, m->facts[METRICS_APPEARED].time + most)},
        {avulsed->standing != 0, VBSS_METRICS_PENALTY_AVULSED, *avulsed},
        {broken->standing != 0, VBSS_METRICS_PENALTY_BROKEN, *broken},
        {unfinished, VBSS_METRICS_PENALTY_INCOMPLETE, now(m, m->now)},
    };
    bool ended = false;
    for (size_t i = 0; i < sizeof ends / sizeof ends[0]; i++) {
        if (ends[i].is_so) {
            double left = vbss_max(most - time - t->sum, 0.0);
            take(t, ends[i].kind, &ends[i].why, 0.0, left);
            ended = true;
        }
    }
    return ended;
}

metrics_score vbss_metrics_judge(const metrics_object *m, uint32_t number,
                                 vbss_metrics_penalty *wanted)
{
    tally t = {.number = number, .wanted = wanted};
    judge_places(m, &t);
    judge_knot(m, &t);
    judge_incidents(m, &t);
    bool ended = judge_ends(m, &t);
    bool known = m->facts[METRICS_PUNCTURE].standing && m->facts[METRICS_PUNCTURE + 1].standing &&
                 m->facts[METRICS_GAPES].standing && tightness(m) != VBSS_METRICS_TIGHTNESS_UNKNOWN;
    double left = vbss_max(m->config.max_time - vbss_metrics_time(m) - t.sum, 0.0);
    bool started = m->facts[METRICS_APPEARED].standing != 0;
    metrics_score score = {started && !ended ? left : 0.0, t.sum, t.count,
                           ended || (started && vbss_metrics_stopped(m) && known)};
    return score;
}
