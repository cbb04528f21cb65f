/* The score: 600 - t - penalties (Korndorffer et al. 2005), with a reason for each penalty. */
#include "metrics/metrics.h"

/* Text of each kind of penalty. */
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
    "simulated time was lost, which the clock of the score includes",
    "the trainee was assisted",
};

/* Counts and sums the penalties in order; a query may select one of them. */
typedef struct penalty_tally {
    uint32_t count, number;
    double sum;
    vbss_metrics_penalty *wanted;
} penalty_tally;

static void add_penalty(penalty_tally *t, vbss_metrics_penalty_kind kind,
                        const metrics_entry *cause, double measure, double amount)
{
    if (t->wanted != NULL && t->count == t->number) {
        *t->wanted = (vbss_metrics_penalty){.struct_size = sizeof *t->wanted,
                                            .kind = kind,
                                            .number = cause->number,
                                            .tool = cause->tool,
                                            .step = cause->step,
                                            .time = cause->time,
                                            .measure = measure,
                                            .amount = amount,
                                            .text = texts[kind]};
        vec3_store(t->wanted->position, cause->position);
        vec3_store(t->wanted->force, cause->force);
    }
    t->count++;
    t->sum += amount;
}

/* ---- penalties for the work */

static void add_placement_penalties(const metrics_object *m, penalty_tally *t)
{
    for (int i = 0; i < 2; i++) {
        const metrics_entry *puncture = &m->facts[METRICS_PUNCTURE + i];
        if (puncture->is_active && puncture->value[0] > 0.0) {
            add_penalty(t, VBSS_METRICS_PENALTY_DEVIATION, puncture, puncture->value[0],
                        m->config.weight_deviation * puncture->value[0]);
        }
    }
    const metrics_entry *gap = &m->facts[METRICS_GAP];
    if (gap->is_active && gap->value[0] > 0.0) {
        add_penalty(t, VBSS_METRICS_PENALTY_GAP, gap, gap->value[0],
                    m->config.weight_gap * gap->value[0]);
    }
}

static vbss_metrics_tightness tightness(const metrics_object *m)
{
    return m->config.tightness_test == VBSS_METRICS_TEST_STRAIN
               ? vbss_metrics_tightness_by_strain(&m->pull)
               : vbss_metrics_tightness_by_load(&m->pull);
}

static metrics_entry entry_at(const metrics_object *m, double time)
{
    metrics_entry entry = {.tool = VBSS_METRICS_TOOL_NONE, .step = m->last_step, .time = time};
    return entry;
}

static void add_knot_penalties(const metrics_object *m, penalty_tally *t)
{
    vbss_metrics_tightness loose = tightness(m);
    uint32_t active_throws = 0;
    if (loose > VBSS_METRICS_TIGHTNESS_TIGHT) {
        add_penalty(t, VBSS_METRICS_PENALTY_TIGHTNESS, &m->pull.last_change, loose,
                    m->config.weight_tightness * loose);
    }
    for (uint32_t i = 0; i < m->throw_count; i++) {
        active_throws += m->throws[i].is_active;
    }
    if (vbss_metrics_is_stopped(m) && active_throws < m->config.throws_wanted) {
        double missing = m->config.throws_wanted - active_throws;
        metrics_entry end = entry_at(m, vbss_metrics_stop_time(m));
        add_penalty(t, VBSS_METRICS_PENALTY_THROWS, &end, missing,
                    m->config.weight_throw * missing);
    }
    for (uint32_t i = 0; i < m->throw_count; i++) {
        const metrics_entry *tied = &m->throws[i];
        if (tied->is_active && tied->relation == VBSS_METRICS_RELATION_GRANNY) {
            add_penalty(t, VBSS_METRICS_PENALTY_GRANNY, tied, 1.0, m->config.weight_granny);
        }
    }
}

static void add_incident_penalties(const metrics_object *m, penalty_tally *t)
{
    const vbss_metrics_config *c = &m->config;
    for (uint32_t i = 0; i < m->incident_count; i++) {
        const metrics_entry *entry = &m->incidents[i];
        if (!entry->is_active) {
            continue;
        }
        switch (entry->kind) {
        case VBSS_METRICS_EVENT_PUNCTURE:
            add_penalty(t, VBSS_METRICS_PENALTY_ATTEMPT, entry, 1.0, c->weight_attempt);
            break;
        case VBSS_METRICS_EVENT_DROP:
            add_penalty(t, VBSS_METRICS_PENALTY_DROP, entry, 1.0, c->weight_drop);
            break;
        case VBSS_METRICS_EVENT_TRANSFER_MISSED:
            add_penalty(t, VBSS_METRICS_PENALTY_TRANSFER, entry, 1.0, c->weight_transfer);
            break;
        case VBSS_METRICS_EVENT_HOST:
            add_penalty(t, VBSS_METRICS_PENALTY_HOST, entry, entry->value[0],
                        c->weight_host * entry->value[0]);
            break;
        default: /* a transfer has no penalty */
            break;
        }
    }
}

/* Lost time costs nothing, but makes the score incomparable. */
static void add_lost_time(const metrics_object *m, penalty_tally *t)
{
    double lost = vbss_metrics_task_time_lost(m);
    if (vbss_metrics_is_time_lost(lost, vbss_metrics_task_time(m), m->config.lost_share)) {
        metrics_entry end = entry_at(m, vbss_metrics_stop_time(m));
        add_penalty(t, VBSS_METRICS_PENALTY_TIME_LOST, &end, lost, 0.0);
    }
}

/* ---- conditions that take the rest of the score */

/* The first aid; NULL: the trainee was not assisted. */
static const metrics_entry *find_assistance(const metrics_object *m)
{
    for (uint32_t i = 0; i < m->incident_count; i++) {
        const metrics_entry *entry = &m->incidents[i];
        if (entry->is_active && entry->kind == VBSS_METRICS_EVENT_ASSISTED) {
            return entry;
        }
    }
    return NULL;
}

bool vbss_metrics_is_assisted(const metrics_object *m)
{
    return find_assistance(m) != NULL;
}

static bool add_final_penalties(const metrics_object *m, penalty_tally *t)
{
    const metrics_entry none = {.is_active = 0}, *assisted = find_assistance(m);
    const metrics_entry *avulsed = &m->facts[METRICS_AVULSED], *broken = &m->facts[METRICS_BROKEN];
    double time = vbss_metrics_task_time(m), max_time = m->config.max_time;
    bool late = time >= max_time, unfinished = m->is_finished && !vbss_metrics_is_stopped(m);
    const struct {
        bool is_so;
        vbss_metrics_penalty_kind kind;
        metrics_entry why;
    } ends[] = {
        {late, VBSS_METRICS_PENALTY_TIMEOUT,
         entry_at(m, m->facts[METRICS_APPEARED].time + max_time)},
        {avulsed->is_active != 0, VBSS_METRICS_PENALTY_AVULSED, *avulsed},
        {broken->is_active != 0, VBSS_METRICS_PENALTY_BROKEN, *broken},
        {unfinished, VBSS_METRICS_PENALTY_INCOMPLETE, entry_at(m, m->last_time)},
        {assisted != NULL, VBSS_METRICS_PENALTY_ASSISTED, assisted != NULL ? *assisted : none},
    };
    bool ended = false;
    for (size_t i = 0; i < sizeof ends / sizeof ends[0]; i++) {
        if (ends[i].is_so) {
            double remaining = vbss_max(max_time - time - t->sum, 0.0);
            add_penalty(t, ends[i].kind, &ends[i].why, 0.0, remaining);
            ended = true;
        }
    }
    return ended;
}

metrics_score vbss_metrics_compute_score(const metrics_object *m, uint32_t number,
                                         vbss_metrics_penalty *wanted)
{
    penalty_tally t = {.number = number, .wanted = wanted};
    add_placement_penalties(m, &t);
    add_knot_penalties(m, &t);
    add_incident_penalties(m, &t);
    add_lost_time(m, &t);
    bool ended = add_final_penalties(m, &t);
    bool known = m->facts[METRICS_PUNCTURE].is_active && m->facts[METRICS_PUNCTURE + 1].is_active &&
                 m->facts[METRICS_GAP].is_active && tightness(m) != VBSS_METRICS_TIGHTNESS_UNKNOWN;
    double remaining = vbss_max(m->config.max_time - vbss_metrics_task_time(m) - t.sum, 0.0);
    bool started = m->facts[METRICS_APPEARED].is_active != 0;
    metrics_score score = {started && !ended ? remaining : 0.0, t.sum, t.count,
                           ended || (started && vbss_metrics_is_stopped(m) && known)};
    return score;
}
