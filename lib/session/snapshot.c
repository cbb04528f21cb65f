/* Serialises a session: the task, its events, the detector and the metrics. The scene has its own
 * snapshot, which must be of the same step. */
#include "knot/knot.h"
#include "metrics/metrics.h"
#include "session/session.h"

#define LARGEST_TIME 1e9
#define LARGEST_LENGTH 1e6

static void refuse(vbss_stream *stream, bool wrong)
{
    if (wrong && !stream->trusted) {
        vbss_stream_refuse(stream, VBSS_ERROR_CORRUPT, "no session is like this");
    }
}

static void visit_below(vbss_stream *stream, uint16_t tag, uint32_t *value, uint32_t end)
{
    vbss_stream_u32(stream, tag, value, 1);
    refuse(stream, *value >= end);
}

static void visit_bounded(vbss_stream *stream, uint16_t tag, double *value, double bound)
{
    vbss_stream_f64(stream, tag, value, 1);
    refuse(stream, !(fabs(*value) <= bound));
}

static void visit_choice(vbss_stream *stream, uint16_t tag, int32_t *value, int32_t last)
{
    vbss_stream_i32(stream, tag, value, 1);
    refuse(stream, *value < 0 || *value > last);
}

/* ---- configuration: a snapshot of a session with other values is refused */

static void visit_config(vbss_stream *stream, const vbss_session_config *c)
{
    const uint32_t words[] = {c->thread,          c->needle,
                              c->drain,           c->tools[0],
                              c->tools[1],        c->shears,
                              c->knot_interval,   c->knots != NULL,
                              c->metrics != NULL, (uint32_t)c->gap_measure};
    const double numbers[] = {c->time_limit,   c->dwell,       c->throw_dwell,   c->tail_low,
                              c->tail_high,    c->tail_margin, c->tail_reach,    c->seat_gap,
                              c->seat_release, c->seat_force,  c->avulsed_share, c->break_force,
                              c->lost_share};
    for (size_t i = 0; i < sizeof words / sizeof words[0]; i++) {
        vbss_stream_expect(stream, 1, words[i]);
    }
    for (size_t i = 0; i < sizeof numbers / sizeof numbers[0]; i++) {
        vbss_stream_expect_f64(stream, 2, numbers[i]);
    }
}

/* ---- the task */

static void visit_debounced(vbss_stream *stream, session_debounced_value *debounced, uint32_t end)
{
    visit_below(stream, 10, &debounced->value, end);
    visit_below(stream, 11, &debounced->candidate, end);
    visit_bounded(stream, 12, &debounced->since, LARGEST_TIME);
}

static void visit_holes(vbss_stream *stream, session_object *s)
{
    for (int k = 0; k < SESSION_SIDES; k++) {
        session_hole *hole = &s->holes[k];
        vbss_stream_u32(stream, 20, &hole->id, 1);
        visit_below(stream, 21, &hole->threaded, 2);
        visit_below(stream, 22, &hole->mark, 2);
        visit_bounded(stream, 23, &hole->angle, 4.0);
        visit_bounded(stream, 24, &hole->axial, LARGEST_LENGTH);
        visit_bounded(stream, 25, &hole->deviation_mm, LARGEST_LENGTH);
    }
    vbss_stream_u32(stream, 26, &s->newest_hole, 1);
    vbss_stream_u32(stream, 27, s->stray_holes, SESSION_MAX_STRAYS);
}

static void visit_throw_observation(vbss_stream *stream, session_throw_observation *t)
{
    vbss_stream_i32(stream, 30, &t->wraps, 1);
    vbss_stream_i32(stream, 31, &t->handedness, 1);
    visit_choice(stream, 32, &t->relation, VBSS_METRICS_RELATION_GRANNY);
    refuse(stream, t->wraps < 0 || t->handedness < -1 || t->handedness > 1);
}

static void visit_knot(vbss_stream *stream, session_knot_observation *knot)
{
    uint32_t located = knot->is_located;
    visit_below(stream, 33, &knot->throw_count, SESSION_MAX_THROWS + 1);
    for (int i = 0; i < SESSION_MAX_THROWS; i++) {
        visit_throw_observation(stream, &knot->throws[i]);
    }
    visit_choice(stream, 34, &knot->next_throw, VBSS_KNOT_VERDICT_UNCERTAIN);
    vbss_stream_u32(stream, 35, &knot->faults, 1);
    visit_below(stream, 36, &located, 2);
    visit_bounded(stream, 37, &knot->end_arcs[0], LARGEST_LENGTH);
    visit_bounded(stream, 37, &knot->end_arcs[1], LARGEST_LENGTH);
    knot->is_located = located != 0;
}

static void visit_throws(vbss_stream *stream, session_object *s)
{
    uint32_t tied = 0;
    for (uint32_t i = 0; i < SESSION_MAX_THROWS; i++) {
        session_throw *t = &s->throws[i];
        visit_throw_observation(stream, &t->value);
        visit_throw_observation(stream, &t->candidate);
        visit_bounded(stream, 38, &t->since, LARGEST_TIME);
        visit_below(stream, 39, &s->tied_by[i], VBSS_METRICS_TOOL_NONE + 1);
        tied += tied == i && t->value.wraps != 0;
    }
    visit_below(stream, 40, &s->throw_count, SESSION_MAX_THROWS + 1);
    visit_below(stream, 41, &s->seated_count, SESSION_MAX_THROWS + 1);
    visit_below(stream, 42, &s->missed_transfers, 1u << SESSION_MAX_THROWS);
    visit_below(stream, 43, &s->transferred, 1u << SESSION_TRANSFERS);
    refuse(stream, s->throw_count != tied || s->seated_count > s->throw_count);
    visit_knot(stream, &s->knot);
}

static void visit_task(vbss_stream *stream, session_object *s)
{
    vbss_stream_u64(stream, 3, &s->steps, 1);
    visit_bounded(stream, 4, &s->time, LARGEST_TIME);
    visit_bounded(stream, 5, &s->end_time, LARGEST_TIME);
    visit_bounded(stream, 55, &s->time_lost, LARGEST_TIME);
    visit_bounded(stream, 56, &s->end_time_lost, LARGEST_TIME);
    visit_bounded(stream, 57, &s->scene_time_paused, LARGEST_TIME);
    vbss_stream_u64(stream, 58, &s->scene_clamped, 1);
    visit_below(stream, 59, &s->is_lossy, 2);
    vbss_stream_u32(stream, 6, &s->thread, 1);
    visit_bounded(stream, 7, &s->thread_length, LARGEST_LENGTH);
    visit_choice(stream, 8, &s->phase, VBSS_SESSION_PHASE_FAILED);
    visit_choice(stream, 9, &s->failure, VBSS_SESSION_FAILURE_LOST);
    visit_holes(stream, s);
    visit_debounced(stream, &s->holding_tools, 4);
    visit_below(stream, 13, &s->last_holder, VBSS_METRICS_TOOL_NONE + 1);
    visit_debounced(stream, &s->tail_set, 2);
    visit_debounced(stream, &s->throw_stage, 8 * (SESSION_MAX_THROWS + 1));
    visit_debounced(stream, &s->newest_seated, 2);
    visit_debounced(stream, &s->knot_faults, 1u << 16);
    visit_debounced(stream, &s->half_hitch, 2);
    visit_debounced(stream, &s->broken, 2);
    visit_throws(stream, s);
    visit_below(stream, 50, &s->cut_limbs, 4);
    visit_bounded(stream, 51, &s->tail_length, LARGEST_LENGTH);
    visit_bounded(stream, 52, &s->gap, LARGEST_LENGTH);
    visit_bounded(stream, 53, &s->tension[0], LARGEST_TIME);
    visit_bounded(stream, 53, &s->tension[1], LARGEST_TIME);
    vbss_stream_u32(stream, 54, &s->metrics_lost, 1);
}

uint64_t vbss_session_task_hash(session_object *s)
{
    vbss_stream stream;
    vbss_stream_begin_hash(&stream);
    visit_config(&stream, &s->config);
    visit_task(&stream, s);
    return vbss_hash_end(&stream.hash);
}

/* ---- events */

static void visit_event(vbss_stream *stream, vbss_session_event *e)
{
    int32_t *const choices[] = {&e->kind,       &e->tool,     &e->stage, &e->wraps,
                                &e->handedness, &e->relation, &e->phase};
    for (size_t i = 0; i < sizeof choices / sizeof choices[0]; i++) {
        vbss_stream_i32(stream, 60, choices[i], 1);
    }
    vbss_stream_u32(stream, 61, &e->number, 1);
    visit_below(stream, 62, &e->undone, 2);
    vbss_stream_u64(stream, 63, &e->ordinal, 1);
    vbss_stream_u64(stream, 64, &e->step, 1);
    vbss_stream_f64(stream, 65, &e->time, 1);
    vbss_stream_f64(stream, 66, e->position, 3);
    vbss_stream_f64(stream, 67, e->force, 3);
    vbss_stream_f64(stream, 68, &e->amount, 1);
    e->struct_size = sizeof *e;
}

static void visit_events(vbss_stream *stream, session_object *s)
{
    uint64_t capacity = s->config.event_capacity;
    vbss_stream_u64(stream, 69, &s->event_count, 1);
    vbss_stream_expect(stream, 70, capacity);
    uint64_t stored = s->event_count < capacity ? s->event_count : capacity;
    for (uint64_t i = s->event_count - stored; i < s->event_count && stream->result == VBSS_OK;
         i++) {
        vbss_session_event *e = vbss_session_event_at(s, i);
        visit_event(stream, e);
        refuse(stream, e->ordinal != i);
    }
    s->events_before_step = s->event_count;
}

/* ---- detector and metrics */

/* Opens the section of a component. NULL: the session has none, or the stream has failed. */
static void *open_component(vbss_stream *stream, void *handle, const vbss_kind *kind,
                            vbss_section *outer)
{
    vbss_slot *slot;
    if (handle == NULL || stream->result != VBSS_OK) {
        return NULL;
    }
    if (vbss_slot_open(handle, kind, &slot) != VBSS_OK) {
        vbss_stream_refuse(stream, VBSS_ERROR_INVALID_HANDLE, "a part of it was destroyed");
        return NULL;
    }
    *outer = vbss_stream_open(stream, kind->code, kind->version);
    return slot->object;
}

static void visit_components(vbss_stream *stream, const session_object *s)
{
    vbss_section outer;
    void *knots = open_component(stream, s->config.knots, &vbss_knot_kind, &outer);
    if (knots != NULL) {
        vbss_knot_serialise(stream, knots);
        vbss_stream_close(stream, outer);
    }
    void *metrics = open_component(stream, s->config.metrics, &vbss_metrics_kind, &outer);
    if (metrics != NULL) {
        vbss_metrics_serialise(stream, metrics);
        vbss_stream_close(stream, outer);
    }
}

/* The events and loops of the detector's last step do not fit its restored state. */
static void clear_knot_events(const session_object *s)
{
    knot_detector *d;
    if (s->config.knots != NULL && vbss_knot_open(s->config.knots, &d) == VBSS_OK) {
        d->event_count = d->events_lost = d->loop_count = 0;
        d->generation++;
    }
}

/* A session that was never assisted has the bytes of earlier versions. */
static void visit_assistance(vbss_stream *stream, session_object *s)
{
    const uint32_t code = VBSS_CODE('A', 'I', 'D', 'S');
    bool is_read = stream->mode == VBSS_STREAM_READ;
    bool is_there = stream->mode == VBSS_STREAM_HASH ? vbss_session_was_assisted(s)
                    : is_read                        ? vbss_stream_has_section(stream, code)
                                                     : vbss_session_has_assistance(s);
    if (is_there) {
        vbss_section outer = vbss_stream_open(stream, code, 1);
        vbss_session_visit_assistance(stream, s);
        vbss_stream_close(stream, outer);
    } else if (is_read) {
        const vbss_session_assistance set = s->assistance.set;
        s->assistance = (session_assistance){.set = set};
        s->assistance.set.aids = 0;
    }
}

/* A session without an exercise has the bytes of earlier versions. */
static void visit_exercise(vbss_stream *stream, session_object *s)
{
    const uint32_t code = VBSS_CODE('E', 'X', 'E', 'R');
    bool is_read = stream->mode == VBSS_STREAM_READ;
    bool is_there = is_read && s->begins_at ? vbss_stream_has_section(stream, code)
                                            : s->config.exercise != VBSS_SESSION_EXERCISE_NONE;
    session_exercise read = s->exercise;
    if (!is_there) {
        return;
    }
    vbss_section outer = vbss_stream_open(stream, code, 1);
    uint32_t exercise = (uint32_t)s->config.exercise;
    vbss_stream_u32(stream, 98, &exercise, 1);
    refuse(stream, !s->begins_at && exercise != (uint32_t)s->config.exercise);
    vbss_session_visit_exercise(stream, &read);
    vbss_stream_close(stream, outer);
    s->exercise = s->begins_at ? s->exercise : read;
}

static void visit_scene(vbss_stream *stream, session_object *s)
{
    scene_info scene;
    if (vbss_scene_inspect(s->scene, &scene) != VBSS_OK) {
        vbss_stream_refuse(stream, VBSS_ERROR_INVALID_HANDLE, "its scene was destroyed");
        return;
    }
    uint64_t steps = s->scene_steps;
    vbss_stream_u64(stream, 71, &steps, 1);
    if (stream->mode == VBSS_STREAM_READ && !stream->trusted && steps != scene.steps) {
        vbss_stream_refuse(stream, VBSS_ERROR_CORRUPT, "its scene is at another step");
    }
    s->scene_steps = steps;
}

void vbss_session_serialise(vbss_stream *stream, void *object)
{
    session_object *s = object;
    if (stream->version < 2) {
        vbss_stream_refuse(stream, VBSS_ERROR_DATA_VERSION, "it is from before lost time");
        return;
    }
    visit_config(stream, &s->config);
    visit_scene(stream, s);
    visit_task(stream, s);
    visit_events(stream, s);
    visit_components(stream, s);
    visit_assistance(stream, s);
    visit_exercise(stream, s);
    if (s->config.coaching != 0) {
        vbss_section outer = vbss_stream_open(stream, VBSS_CODE('C', 'O', 'A', 'C'), 1);
        vbss_session_visit_coach(stream, s);
        vbss_stream_close(stream, outer);
    }
    if (stream->mode == VBSS_STREAM_READ) {
        clear_knot_events(s);
        s->given[0].is_given = s->given[1].is_given = false;
        s->takes_over = true;
    }
}
