/* Method TOPOLOGY: when a reading starts, and how much of it each step does. */
#include "knot/knot.h"
#include "knot/tuning.h"

static vbss_result create_topology(knot_detector *d)
{
    static const uint32_t no_rows[4]; /* data of a view is never NULL */
    d->loop_rows = no_rows;
    return VBSS_OK;
}

static void destroy_topology(vbss_context *context, knot_detector *d)
{
    (void)context;
    (void)d;
}

/* Whether the thread is wrapped about a tool or held by one, so that a throw may follow. */
static bool is_tying(const knot_detector *d)
{
    bool tying = false;
    for (uint32_t i = 0; i < d->input.tool_count; i++) {
        tying |= d->tools[i].wrapped || d->tools[i].held == VBSS_KNOT_HELD_THREAD;
    }
    return tying;
}

static bool is_due(const knot_detector *d)
{
    uint32_t interval = d->config.interval;
    if (interval == 0 && is_tying(d)) {
        interval = KNOT_TYING_INTERVAL;
    }
    return d->reading_due || (interval > 0 && d->steps >= d->job_start_step + interval);
}

static void begin_reading(knot_detector *d)
{
    if (vbss_knot_job_is_active(&d->job)) { /* the reading is dropped, but its work counts */
        vbss_knot_count_job(&d->job, &d->statistics);
    }
    vbss_knot_input_copy(&d->job.input, &d->input);
    vbss_knot_job_begin(&d->job, &d->config, d->steps);
    d->job.input.may_have_passed = d->thread_may_differ;
    d->job_start_step = d->steps;
    d->reading_due = d->thread_may_differ = false;
}

static void end_reading(knot_detector *d, bool follows)
{
    vbss_knot_classify(d, follows);
    d->thread_may_differ |= !follows && d->classification.reason != VBSS_KNOT_REASON_NONE;
    d->job.stage = KNOT_JOB_IDLE;
}

/* A reading starts in one step and continues from the next on, so that no step pays for both. */
static void read_topology(knot_detector *d)
{
    if (vbss_knot_job_is_active(&d->job)) {
        knot_ops budget = d->config.step_budget, before = d->job.ops_used;
        bool done = vbss_knot_job_resume(&d->job, &d->config, &budget);
        uint64_t ops = (uint64_t)(d->job.ops_used - before);
        d->statistics.most_step_work =
            ops > d->statistics.most_step_work ? ops : d->statistics.most_step_work;
        if (done) {
            end_reading(d, !d->job.input.may_have_passed);
        }
    } else if (is_due(d)) {
        begin_reading(d);
    }
}

static void read_immediately(knot_detector *d)
{
    knot_ops budget = INT64_MAX;
    begin_reading(d);
    vbss_knot_job_resume(&d->job, &d->config, &budget);
    end_reading(d, false);
}

static void step_topology(knot_detector *d, bool immediate)
{
    vbss_knot_classify_next(d);
    if (immediate) {
        read_immediately(d);
    } else {
        read_topology(d);
    }
}

const knot_method vbss_knot_topology = {create_topology, destroy_topology, step_topology};
