/* Serialisation of a detector. For a reading in progress, only its input and the operations used
 * are stored; restoring repeats the reading up to that point. */
#include "base/check.h"
#include "base/stream.h"
#include "knot/knot.h"

static void visit_config(vbss_stream *stream, const vbss_knot_detector_config *c)
{
    const uint32_t words[] = {(uint32_t)c->method,  c->point_capacity,  c->tool_capacity,
                              c->crossing_capacity, c->direction_limit, c->closure_count,
                              c->closure_tolerance, c->step_budget,     c->interval};
    const double numbers[] = {c->tail_reach, c->tail_least, c->wrap_turns, c->slip_limit,
                              c->plane_offset};
    for (size_t i = 0; i < sizeof words / sizeof words[0]; i++) {
        vbss_stream_expect(stream, 1, words[i]);
    }
    for (size_t i = 0; i < sizeof numbers / sizeof numbers[0]; i++) {
        vbss_stream_expect_f64(stream, 2, numbers[i]);
    }
}

/* ---- tools */

static void visit_tools(vbss_stream *stream, knot_detector *d)
{
    vbss_stream_count(stream, 10, &d->input.tool_count, d->config.tool_capacity);
    vbss_stream_count(stream, 11, &d->input.point_count, d->config.point_capacity);
    for (uint32_t i = 0; i < d->config.tool_capacity; i++) {
        knot_tool_state *t = &d->tools[i];
        vbss_stream_bool(stream, 12, &t->wrapped);
        vbss_stream_bool(stream, 13, &t->wrong_sense);
        vbss_stream_i32(stream, 14, &t->held, 1);
        vbss_stream_f64(stream, 15, &t->winding.turns, 1);
        vbss_stream_f64(stream, 16, &t->winding.run_turns, 1);
        vbss_stream_f64(stream, 17, t->winding.run_places, 2);
        vbss_stream_f64(stream, 18, t->winding.run_heights, 2);
        vbss_stream_u32(stream, 19, &t->winding.runs, 1);
        vbss_stream_i32(stream, 20, &t->winding.sense, 1);
    }
}

/* ---- results */

static void visit_state(vbss_stream *stream, vbss_knot_state *s)
{
    int32_t *const choices[] = {&s->name,         &s->verdict,    &s->reason,
                                &s->next_verdict, &s->next_wraps, &s->next_handedness,
                                &s->certified,    &s->signature,  &s->signature_tristram,
                                &s->ends_free};
    uint32_t *const words[] = {&s->faults,           &s->next_tool, &s->loops,
                               &s->undone,           &s->crossings, &s->closures,
                               &s->closures_agreeing};
    for (size_t i = 0; i < sizeof choices / sizeof choices[0]; i++) {
        vbss_stream_i32(stream, 30, choices[i], 1);
    }
    for (size_t i = 0; i < sizeof words / sizeof words[0]; i++) {
        vbss_stream_u32(stream, 31, words[i], 1);
    }
    uint64_t invariants[] = {(uint64_t)s->determinant, (uint64_t)s->v2, (uint64_t)s->v3};
    vbss_stream_u64(stream, 32, invariants, 3);
    s->determinant = (int64_t)invariants[0];
    s->v2 = (int64_t)invariants[1];
    s->v3 = (int64_t)invariants[2];
    vbss_stream_u64(stream, 33, &s->steps, 1);
    vbss_stream_u64(stream, 34, &s->reading_step, 1);
}

static void visit_throw(vbss_stream *stream, vbss_knot_throw *t)
{
    vbss_stream_i32(stream, 40, &t->verdict, 1);
    vbss_stream_i32(stream, 41, &t->wraps, 1);
    vbss_stream_i32(stream, 42, &t->handedness, 1);
    vbss_stream_u32(stream, 43, &t->flags, 1);
    vbss_stream_f64(stream, 44, t->tail_places, 2);
    vbss_stream_f64(stream, 45, t->long_places, 2);
    vbss_stream_f64(stream, 46, &t->slip, 1);
    vbss_stream_f64(stream, 47, &t->tail_length, 1);
    vbss_stream_u64(stream, 48, &t->formed_step, 1);
    vbss_stream_u64(stream, 49, &t->reading_step, 1);
    t->struct_size = sizeof *t;
    if (t->wraps < 1 || t->wraps > 1000000 || (t->handedness != 1 && t->handedness != -1)) {
        vbss_stream_refuse(stream, VBSS_ERROR_CORRUPT, "no throw has such wraps or handedness");
    }
}

static void visit_classification(vbss_stream *stream, knot_detector *d)
{
    knot_classification *v = &d->classification;
    vbss_stream_count(stream, 50, &v->throw_count, KNOT_THROWS);
    d->state.throw_count = v->throw_count;
    vbss_stream_bool(stream, 51, &v->other);
    vbss_stream_i32(stream, 52, &v->reason, 1);
    for (uint32_t i = 0; i < v->throw_count; i++) {
        visit_throw(stream, &v->throws[i]);
    }
}

static void visit_figures(vbss_stream *stream, vbss_knot_detector_statistics *f)
{
    uint64_t *const counts[] = {&f->readings,    &f->closures,       &f->certified, &f->uncertain,
                                &f->projections, &f->degenerate,     &f->overflows, &f->removed,
                                &f->work,        &f->most_step_work, &f->most_work, &f->revoked};
    for (size_t i = 0; i < sizeof counts / sizeof counts[0]; i++) {
        vbss_stream_u64(stream, 60, counts[i], 1);
    }
}

/* ---- reading in progress */

static bool is_tool_sound(const knot_tool *t, uint32_t points)
{
    bool sound = t->point_count >= 2 && t->point_count <= KNOT_AXIS_POINTS &&
                 t->held >= VBSS_KNOT_HELD_NOTHING && t->held <= VBSS_KNOT_HELD_NEEDLE &&
                 t->held_place >= 0.0 && t->held_place <= points - 1.0;
    for (uint32_t i = 0; i < t->point_count && sound; i++) {
        double x[3];
        vec3_store(x, t->axis[i]);
        sound = vbss_max_abs(x, 3) <= 1e3 &&
                (i == 0 || (vec3_distance(t->axis[i], t->axis[i - 1]) >= 1e-9 &&
                            t->radius[i - 1] >= 0.0 && t->radius[i - 1] <= 1.0));
    }
    return sound;
}

static void visit_tool(vbss_stream *stream, knot_tool *t, uint32_t points)
{
    vbss_stream_count(stream, 70, &t->point_count, KNOT_AXIS_POINTS);
    vbss_stream_i32(stream, 71, &t->held, 1);
    vbss_stream_f64(stream, 72, &t->held_place, 1);
    for (uint32_t i = 0; i < t->point_count; i++) {
        vbss_stream_f64(stream, 73, &t->axis[i].x, 3);
    }
    vbss_stream_f64(stream, 74, t->radius, KNOT_AXIS_POINTS - 1);
    if (!is_tool_sound(t, points)) {
        vbss_stream_refuse(stream, VBSS_ERROR_CORRUPT, "no tool is like this");
    }
}

/* Whether places are numbers of the host's points, in one direction. */
static bool are_places_sound(const knot_input *input, const vbss_knot_detector_config *config)
{
    bool sound = true;
    for (uint32_t i = 0; i < input->point_count && sound; i++) {
        double at = input->places[i];
        sound = at >= 0.0 && at < config->point_capacity && at == floor(at);
        if (i > 0 && sound) {
            bool ascends = input->places[1] > input->places[0];
            sound = ascends ? at > input->places[i - 1] : at < input->places[i - 1];
        }
    }
    return sound;
}

static void visit_scene(vbss_stream *stream, const vbss_knot_detector_config *config,
                        knot_input *input)
{
    vbss_stream_count(stream, 80, &input->point_count, config->point_capacity);
    vbss_stream_count(stream, 81, &input->tool_count, config->tool_capacity);
    if (stream->result != VBSS_OK || input->point_count == 0) {
        vbss_stream_refuse(stream, VBSS_ERROR_CORRUPT, "a thread without points");
        return;
    }
    vbss_stream_bool(stream, 82, &input->has_holes);
    vbss_stream_bool(stream, 87, &input->may_have_passed);
    vbss_stream_f64(stream, 83, &input->tissue_place, 1);
    vbss_stream_f64(stream, 84, &input->away.x, 3);
    vbss_stream_f64(stream, 85, &input->points[0].x, 3 * (size_t)input->point_count);
    vbss_stream_f64(stream, 86, input->places, input->point_count);
    for (uint32_t i = 0; i < input->tool_count && stream->result == VBSS_OK; i++) {
        visit_tool(stream, &input->tools[i], input->point_count);
    }
    double away[3];
    vec3_store(away, input->away);
    bool sound = vbss_max_abs(away, 3) <= 1.0 + 1e-9 && input->tissue_place >= -1.0 &&
                 input->tissue_place <= input->point_count - 1.0 &&
                 input->has_holes == (input->tissue_place >= 0.0) &&
                 vbss_max_abs(&input->points[0].x, 3 * (size_t)input->point_count) <= 1e3 &&
                 are_places_sound(input, config);
    if (!sound) {
        vbss_stream_refuse(stream, VBSS_ERROR_CORRUPT, "no thread is like this");
    }
}

static void visit_job(vbss_stream *stream, knot_detector *d)
{
    knot_job *job = &d->job;
    bool active = vbss_knot_job_is_active(job);
    uint64_t ops = (uint64_t)job->ops_used, step = job->step;
    vbss_stream_bool(stream, 90, &active);
    if (!active) {
        if (stream->mode == VBSS_STREAM_READ) {
            job->stage = KNOT_JOB_IDLE;
        }
        return;
    }
    vbss_stream_u64(stream, 91, &step, 1);
    vbss_stream_u64(stream, 92, &ops, 1);
    visit_scene(stream, &d->config, &job->input);
    if (stream->mode != VBSS_STREAM_READ) {
        return;
    }
    job->stage = KNOT_JOB_IDLE;
    if (stream->result != VBSS_OK) {
        return;
    }
    knot_ops budget = ops > INT64_MAX ? INT64_MAX : (knot_ops)ops;
    vbss_knot_job_begin(job, &d->config, step);
    if (vbss_knot_job_resume(job, &d->config, &budget) || job->ops_used != (knot_ops)ops) {
        job->stage = KNOT_JOB_IDLE;
        vbss_stream_refuse(stream, VBSS_ERROR_CORRUPT, "a reading does not stop after such work");
    }
}

void vbss_knot_serialise(vbss_stream *stream, void *object)
{
    knot_detector *d = object;
    visit_config(stream, &d->config);
    vbss_stream_u64(stream, 3, &d->steps, 1);
    vbss_stream_u64(stream, 4, &d->job_start_step, 1);
    vbss_stream_bool(stream, 5, &d->reading_due);
    vbss_stream_bool(stream, 7, &d->thread_may_differ);
    vbss_random_serialise(stream, 6, &d->random);
    visit_tools(stream, d);
    visit_state(stream, &d->state);
    visit_classification(stream, d);
    visit_figures(stream, &d->statistics);
    visit_job(stream, d);
}
