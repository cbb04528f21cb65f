/* Queries: the report, throws, phases, penalties, and arrays. */
#include "base/api_call.h"
#include "base/check.h"
#include "base/config.h"
#include "base/elementary.h"
#include "base/error.h"
#include "metrics/metrics.h"

_Static_assert(sizeof(vbss_metrics_report) == 232, "published size");
_Static_assert(sizeof(vbss_metrics_throw) == 104, "published size");
_Static_assert(sizeof(vbss_metrics_phase) == 40, "published size");
_Static_assert(sizeof(vbss_metrics_penalty) ==
                   VBSS_SIZE_WITH_POINTERS(vbss_metrics_penalty, 96u, 1u),
               "no hidden padding");
static const uint32_t report_sizes[] = {192, 232, 0}, throw_sizes[] = {104, 0},
                      phase_sizes[] = {40, 0},
                      penalty_sizes[] = {VBSS_SIZE_WITH_POINTERS(vbss_metrics_penalty, 96u, 1u), 0};
static const vbss_layout report_layout = {"vbss_metrics_report", NULL, report_sizes};
static const vbss_layout throw_layout = {"vbss_metrics_throw", NULL, throw_sizes};
static const vbss_layout phase_layout = {"vbss_metrics_phase", NULL, phase_sizes};
static const vbss_layout penalty_layout = {"vbss_metrics_penalty", NULL, penalty_sizes};

#define MILLIMETRES 1e3

/* ---- the clock of the task: from the appearance of the needle until both tails are cut */

bool vbss_metrics_is_stopped(const metrics_object *m)
{
    return m->facts[METRICS_CUT].is_active && m->facts[METRICS_CUT + 1].is_active;
}

double vbss_metrics_stop_time(const metrics_object *m)
{
    return vbss_metrics_is_stopped(m)
               ? vbss_max(m->facts[METRICS_CUT].time, m->facts[METRICS_CUT + 1].time)
               : m->last_time;
}

double vbss_metrics_task_time(const metrics_object *m)
{
    const metrics_entry *appeared = &m->facts[METRICS_APPEARED];
    return appeared->is_active ? vbss_max(vbss_metrics_stop_time(m) - appeared->time, 0.0) : 0.0;
}

double vbss_metrics_task_time_lost(const metrics_object *m)
{
    const metrics_entry *appeared = &m->facts[METRICS_APPEARED];
    const metrics_entry *first_cut = &m->facts[METRICS_CUT], *second_cut = first_cut + 1;
    double lost_at_stop = vbss_metrics_is_stopped(m)
                              ? vbss_max(first_cut->time_lost, second_cut->time_lost)
                              : m->time_lost;
    return appeared->is_active ? vbss_max(lost_at_stop - appeared->time_lost, 0.0) : 0.0;
}

/* ---- the report */

static void report_facts(const metrics_object *m, vbss_metrics_report *r)
{
    static const struct {
        metrics_fact fact;
        uint32_t flag;
    } known[] = {{METRICS_APPEARED, VBSS_METRICS_FLAG_STARTED},
                 {METRICS_GAP, VBSS_METRICS_FLAG_GAP},
                 {METRICS_AVULSED, VBSS_METRICS_FLAG_AVULSED},
                 {METRICS_BROKEN, VBSS_METRICS_FLAG_BROKEN}};
    static const uint32_t puncture[2] = {VBSS_METRICS_FLAG_PUNCTURE_0,
                                         VBSS_METRICS_FLAG_PUNCTURE_1};
    static const uint32_t tail[2] = {VBSS_METRICS_FLAG_TAIL_0, VBSS_METRICS_FLAG_TAIL_1};
    for (size_t i = 0; i < sizeof known / sizeof known[0]; i++) {
        r->flags |= m->facts[known[i].fact].is_active ? known[i].flag : 0u;
    }
    for (int i = 0; i < 2; i++) {
        const metrics_entry *cut = &m->facts[METRICS_CUT + i],
                            *length = cut->is_active ? cut : &m->facts[METRICS_TAIL + i];
        if (m->facts[METRICS_PUNCTURE + i].is_active) {
            r->flags |= puncture[i];
            r->deviation_mm[i] = m->facts[METRICS_PUNCTURE + i].value[0];
        }
        if (length->is_active) {
            r->flags |= tail[i];
            r->tail_mm[i] = MILLIMETRES * length->value[0];
        }
    }
    if (m->facts[METRICS_GAP].is_active) {
        r->gap_mm = m->facts[METRICS_GAP].value[0];
        r->gap_largest_mm = m->facts[METRICS_GAP].value[1];
    }
}

static void count_throws(const metrics_object *m, vbss_metrics_report *r)
{
    for (uint32_t i = 0; i < m->throw_count; i++) {
        const metrics_entry *tied = &m->throws[i];
        if (tied->is_active) {
            r->throw_count++;
            r->square_count += tied->relation == VBSS_METRICS_RELATION_SQUARE;
            r->granny_count += tied->relation == VBSS_METRICS_RELATION_GRANNY;
            r->unknown_count += tied->relation == VBSS_METRICS_RELATION_UNKNOWN;
        }
    }
}

static void count_incidents(const metrics_object *m, vbss_metrics_report *r)
{
    for (uint32_t i = 0; i < m->incident_count; i++) {
        const metrics_entry *entry = &m->incidents[i];
        if (!entry->is_active) {
            continue;
        }
        if (entry->kind == VBSS_METRICS_EVENT_PUNCTURE) {
            r->attempts[entry->number]++;
        }
        r->transfers += entry->kind == VBSS_METRICS_EVENT_TRANSFER;
        r->transfers_missed += entry->kind == VBSS_METRICS_EVENT_TRANSFER_MISSED;
        r->drops += entry->kind == VBSS_METRICS_EVENT_DROP;
        r->host_penalties += entry->kind == VBSS_METRICS_EVENT_HOST;
    }
}

static void report_motion(const metrics_object *m, vbss_metrics_report *r)
{
    const metrics_hand *a = &m->hands[0], *b = &m->hands[1];
    r->samples = m->samples;
    r->ticks = a->tick_count > b->tick_count ? a->tick_count : b->tick_count;
    r->ticks_lost = vbss_metrics_ticks_lost(m);
    for (int i = 0; i < METRICS_HANDS; i++) {
        r->outliers[i] = m->hands[i].outlier_count;
        r->jumps[i] = m->hands[i].jump_count;
    }
}

static void report_time(const metrics_object *m, vbss_metrics_report *r)
{
    r->time = vbss_metrics_task_time(m);
    r->time_lost = vbss_metrics_task_time_lost(m);
    r->time_simulated = vbss_max(r->time - r->time_lost, 0.0);
    r->flags |= r->time >= m->config.max_time ? VBSS_METRICS_FLAG_TIMEOUT : 0;
    r->flags |= vbss_metrics_is_time_lost(r->time_lost, r->time, m->config.lost_share)
                    ? VBSS_METRICS_FLAG_TIME_LOST
                    : 0;
}

vbss_result vbss_metrics_get_report(vbss_metrics *metrics, vbss_metrics_report *report,
                                    uint32_t struct_size)
{
    VBSS_ENTER(metrics);
    metrics_object *m;
    VBSS_TRY(vbss_metrics_open(metrics, &m));
    vbss_metrics_report r = {.struct_size = sizeof r};
    metrics_score score = vbss_metrics_compute_score(m, 0, NULL);
    report_facts(m, &r);
    count_throws(m, &r);
    count_incidents(m, &r);
    report_motion(m, &r);
    report_time(m, &r);
    r.tightness_pull = vbss_metrics_tightness_by_load(&m->pull);
    r.tightness_strain = vbss_metrics_tightness_by_strain(&m->pull);
    r.pull_held = m->pull.longest_hold;
    r.pull_strain = m->pull.strain;
    r.drawn_in_mm = MILLIMETRES * m->pull.drawn_in;
    r.throw_records = m->throw_count;
    r.phase_count = m->phase_count;
    r.penalty_count = score.count;
    r.score = score.score;
    r.penalties = score.penalties;
    r.flags |= vbss_metrics_is_stopped(m) ? VBSS_METRICS_FLAG_STOPPED : 0;
    r.flags |= m->is_finished ? VBSS_METRICS_FLAG_FINISHED : 0;
    r.flags |= vbss_metrics_is_assisted(m) ? VBSS_METRICS_FLAG_ASSISTED : 0;
    r.flags |= score.is_final ? VBSS_METRICS_FLAG_FINAL : 0;
    return vbss_struct_write(m->context, &report_layout, &r, report, struct_size);
}

/* ---- single records */

static vbss_result check_index(const metrics_object *m, const char *what, uint32_t index,
                               uint32_t count)
{
    return index < count
               ? VBSS_OK
               : vbss_fail(m->context, VBSS_ERROR_NOT_FOUND, "%s %u of %u", what, index, count);
}

vbss_result vbss_metrics_get_throw(vbss_metrics *metrics, uint32_t index,
                                   vbss_metrics_throw *record, uint32_t struct_size)
{
    VBSS_ENTER(metrics);
    metrics_object *m;
    VBSS_TRY(vbss_metrics_open(metrics, &m));
    VBSS_TRY(check_index(m, "throw", index, m->throw_count));
    const metrics_entry *entry = &m->throws[index];
    vbss_metrics_throw own = {.struct_size = sizeof own,
                              .number = entry->number,
                              .standing = entry->is_active,
                              .tool = entry->tool,
                              .wraps = entry->wraps,
                              .handedness = entry->handedness,
                              .relation = entry->relation,
                              .step = entry->step,
                              .time = entry->time,
                              .undone_time = entry->undone_time};
    vec3_store(own.position, entry->position);
    vec3_store(own.force, entry->force);
    return vbss_struct_write(m->context, &throw_layout, &own, record, struct_size);
}

vbss_result vbss_metrics_get_phase(vbss_metrics *metrics, uint32_t index, vbss_metrics_phase *phase,
                                   uint32_t struct_size)
{
    VBSS_ENTER(metrics);
    metrics_object *m;
    VBSS_TRY(vbss_metrics_open(metrics, &m));
    VBSS_TRY(check_index(m, "phase", index, m->phase_count));
    const metrics_phase *entry = &m->phases[index];
    bool ended = index + 1 < m->phase_count;
    vbss_metrics_phase own = {.struct_size = sizeof own,
                              .number = entry->number,
                              .ended = ended,
                              .step = entry->step,
                              .begin = entry->start_time};
    own.end = ended ? entry[1].start_time : vbss_max(vbss_metrics_stop_time(m), entry->start_time);
    return vbss_struct_write(m->context, &phase_layout, &own, phase, struct_size);
}

vbss_result vbss_metrics_get_penalty(vbss_metrics *metrics, uint32_t index,
                                     vbss_metrics_penalty *penalty, uint32_t struct_size)
{
    VBSS_ENTER(metrics);
    metrics_object *m;
    vbss_metrics_penalty own = {.struct_size = sizeof own};
    VBSS_TRY(vbss_metrics_open(metrics, &m));
    metrics_score score = vbss_metrics_compute_score(m, index, &own);
    VBSS_TRY(check_index(m, "penalty", index, score.count));
    return vbss_struct_write(m->context, &penalty_layout, &own, penalty, struct_size);
}

vbss_result vbss_metrics_get_view(vbss_metrics *metrics, vbss_metrics_field field, vbss_view *view,
                                  uint32_t struct_size)
{
    VBSS_ENTER(metrics);
    metrics_object *m;
    VBSS_TRY(vbss_metrics_open(metrics, &m));
    if (field < VBSS_METRICS_VIEW_LEFT_SPEED || field > VBSS_METRICS_VIEW_RIGHT_FORCE) {
        return vbss_fail(m->context, VBSS_ERROR_OUT_OF_RANGE, "metrics have no field %d", field);
    }
    const metrics_hand *h = &m->hands[field % METRICS_HANDS];
    const double *const arrays[] = {h->speed, h->jerk, h->peak};
    const uint32_t counts[] = {h->tick_count, h->tick_count, h->force_count};
    int quantity = field / METRICS_HANDS;
    const vbss_view own = {.type = VBSS_VIEW_TYPE_F64,
                           .components = 1,
                           .stride_bytes = sizeof(double),
                           .count = counts[quantity],
                           .data = arrays[quantity],
                           .generation = m->generation};
    return vbss_struct_write(m->context, &vbss_view_layout, &own, view, struct_size);
}

/* ---- offset of a point from a mark, for hosts that have no angles */

vbss_result vbss_metrics_get_offset(const double axis[3], const double centre[3],
                                    const double mark[3], const double place[3], double *angle,
                                    double *axial)
{
    VBSS_ENTER(NULL);
    const double *const given[] = {axis, centre, mark, place};
    for (size_t i = 0; i < sizeof given / sizeof given[0]; i++) {
        VBSS_TRY(vbss_check_pointer(NULL, given[i], "point"));
        VBSS_TRY(vbss_check_vector(NULL, given[i], METRICS_LARGEST_POSITION, "point"));
    }
    VBSS_TRY(vbss_check_pointer(NULL, angle, "angle"));
    VBSS_TRY(vbss_check_pointer(NULL, axial, "axial"));
    VBSS_TRY(vbss_check_range(NULL, vec3_norm(vec3_load(axis)), 1e-9, 1e4, "axis"));
    vec3 along = vec3_unit_or(vec3_load(axis), vec3_zero());
    vec3 from = vec3_sub(vec3_load(mark), vec3_load(centre));
    vec3 to = vec3_sub(vec3_load(place), vec3_load(centre));
    double from_height = vec3_dot(from, along), to_height = vec3_dot(to, along);
    from = vec3_add_scaled(from, -from_height, along);
    to = vec3_add_scaled(to, -to_height, along);
    if (!(vec3_norm(from) > 1e-9 && vec3_norm(to) > 1e-9)) {
        return VBSS_ERROR_OUT_OF_RANGE;
    }
    *angle = vbss_arc_tangent(vec3_dot(vec3_cross(from, to), along), vec3_dot(from, to));
    *axial = to_height - from_height;
    return VBSS_OK;
}
