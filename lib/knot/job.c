/* One reading of the topology, from the copied input to all results, in pieces that fit a budget of
 * operations. */
#include "knot/knot.h"
#include "knot/tuning.h"

bool vbss_knot_job_is_active(const knot_job *job)
{
    return job->stage != KNOT_JOB_IDLE && job->stage != KNOT_JOB_DONE;
}

static knot_reading no_knot(void)
{
    knot_reading r = {.certified = true, .throws = true};
    r.invariants = vbss_knot_invariants_of(&r.factors);
    return r;
}

void vbss_knot_job_begin(knot_job *job, const vbss_knot_detector_config *config, uint64_t step)
{
    job->step = step;
    job->ops_used = 0;
    job->curve = 0;
    job->curve_began = false;
    job->agreeing = 0;
    job->outward = job->tail = job->long_limb = job->tools = (knot_reading){.throws = false};
    job->reader.counts = (knot_counts){0};
    job->reader.direction_limit = config->direction_limit;
    job->locator.stage = KNOT_LOCATE_DONE;
    job->locator.count = 0;
    vbss_knot_closure_init(&job->closure, config, &job->input);
    job->has_tools = job->closure.tail_hold >= 0.0 || job->closure.long_hold >= 0.0;
    vbss_knot_core_begin(&job->core, &job->closure, &job->input);
    job->stage = KNOT_JOB_CORE;
    if (job->closure.far_distance < KNOT_MIN_EXTENT) {
        job->outward = job->tail = job->long_limb = no_knot();
        job->closure.alternative_count = 0;
        job->has_tools = false;
        job->stage = KNOT_JOB_LOCATE;
    }
}

/* ---- the closed curves */

static bool is_wanted(const knot_job *job, uint32_t curve)
{
    switch (curve) {
    case KNOT_CURVE_OUTWARD:
        return true;
    case KNOT_CURVE_TAIL:
    case KNOT_CURVE_LONG:
        return job->closure.has_tissue;
    case KNOT_CURVE_TOOLS:
        return job->has_tools;
    default:
        return true;
    }
}

/* Appends the part of the reduced thread between two places. */
static void add_core(knot_polygon *to, const knot_polygon *core, double from, double until)
{
    for (uint32_t i = 0; i < core->count; i++) {
        if (core->place[i] >= from && core->place[i] <= until) {
            vbss_knot_polygon_add(to, core->x[i], core->place[i], false);
        }
    }
}

static void begin_curve(knot_job *job)
{
    const knot_closure *c = &job->closure;
    const knot_polygon *core = &job->core.polygon;
    const double last = core->place[core->count - 1];
    const uint32_t other = job->curve >= KNOT_CURVE_OTHERS ? job->curve - KNOT_CURVE_OTHERS + 1 : 0;
    double from = 0.0, until = last;
    knot_extension tail = vbss_knot_straight_extension(core->x[0], c->tail_directions[other]);
    knot_extension end =
        vbss_knot_straight_extension(core->x[core->count - 1], c->long_directions[other]);
    knot_extension away = vbss_knot_straight_extension(
        vbss_knot_point_at(&job->input, job->input.tissue_place), c->away);
    if (job->curve == KNOT_CURVE_TAIL) {
        until = job->input.tissue_place;
        end = away;
    } else if (job->curve == KNOT_CURVE_LONG) {
        from = job->input.tissue_place;
        tail = away;
    } else if (job->curve == KNOT_CURVE_TOOLS) {
        if (c->tail_hold >= 0.0) {
            from = c->tail_hold;
            tail = c->tail_extension;
        }
        if (c->long_hold >= 0.0) {
            until = c->long_hold;
            end = c->long_extension;
        }
    }
    knot_polygon *polygon = &job->reader.polygon;
    vbss_knot_close_begin(c, polygon, &tail);
    add_core(polygon, core, from, until);
    vbss_knot_close_end(c, polygon, &tail, &end);
    vbss_knot_curve_begin(&job->reader, job->curve == KNOT_CURVE_OUTWARD);
}

static void store_reading(knot_job *job)
{
    const knot_reading *r = &job->reader.reading;
    switch (job->curve) {
    case KNOT_CURVE_OUTWARD:
        job->outward = *r;
        break;
    case KNOT_CURVE_TAIL:
        job->tail = *r;
        break;
    case KNOT_CURVE_LONG:
        job->long_limb = *r;
        break;
    case KNOT_CURVE_TOOLS:
        job->tools = *r;
        break;
    default:
        job->agreeing += vbss_knot_readings_agree(&job->outward, r);
        break;
    }
}

static void read_curves(knot_job *job, const vbss_knot_detector_config *config, knot_ops *budget)
{
    if (job->curve_began) {
        if (vbss_knot_curve_resume(&job->reader, budget)) {
            store_reading(job);
            job->curve_began = false;
            job->curve++;
        }
    } else if (job->curve >= KNOT_CURVE_OTHERS + job->closure.alternative_count) {
        vbss_knot_locator_begin(&job->locator, &job->reader, &job->input, &job->closure,
                                &job->outward, &job->tail, &job->long_limb,
                                config->direction_limit);
        job->stage = KNOT_JOB_LOCATE;
    } else if (!is_wanted(job, job->curve)) {
        job->curve++;
    } else {
        begin_curve(job);
        job->curve_began = true;
    }
}

/* ---- the complete job */

bool vbss_knot_job_resume(knot_job *job, const vbss_knot_detector_config *config, knot_ops *budget)
{
    const knot_ops had = *budget;
    while (*budget > 0 && vbss_knot_job_is_active(job)) {
        switch (job->stage) {
        case KNOT_JOB_CORE:
            if (vbss_knot_core_resume(&job->core, budget)) {
                job->stage = KNOT_JOB_CURVES;
            }
            break;
        case KNOT_JOB_CURVES:
            read_curves(job, config, budget);
            break;
        case KNOT_JOB_LOCATE:
            if (vbss_knot_locator_resume(&job->locator, &job->reader, budget)) {
                vbss_knot_measure_slips(&job->input, job->locator.throws, job->locator.count,
                                        &job->slip_room, job->slips);
                job->stage = KNOT_JOB_DONE;
            }
            break;
        default:
            break;
        }
    }
    job->ops_used += had - *budget;
    return job->stage == KNOT_JOB_DONE;
}

void vbss_knot_count_job(const knot_job *job, vbss_knot_detector_statistics *statistics)
{
    const knot_counts *c = &job->reader.counts;
    statistics->closures += c->closures;
    statistics->certified += c->certified;
    statistics->projections += c->projections;
    statistics->degenerate += c->degenerate;
    statistics->overflows += c->overflows;
    statistics->removed += c->removed + job->core.reduction.removed;
    statistics->work += (uint64_t)job->ops_used;
}
