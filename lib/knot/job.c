/* A reading of the topology of what was shown at one step, from the copy to all that verdicts need, in pieces that
 * a budget of work can stop between. */
#include "knot/knot.h"

bool vbss_knot_job_is_active(const knot_job *job)
{
    return job->stage != KNOT_JOB_IDLE && job->stage != KNOT_JOB_DONE;
}

/* A thread without extent has no knot; its determinants would be smaller than numbers can be. */
#define LEAST_FAR 1e-9

static knot_reading no_knot(void)
{
    knot_reading r = {.certified = true, .throws = true};
    r.invariants = vbss_knot_invariants_of(&r.factors);
    return r;
}

void vbss_knot_job_begin(knot_job *job, const vbss_knot_config *config, uint64_t step)
{
    job->step = step;
    job->spent = 0;
    job->curve = 0;
    job->curve_began = false;
    job->agreeing = 0;
    job->outward = job->tail = job->long_limb = job->tools = (knot_reading){.throws = false};
    job->reader.counts = (knot_counts){0};
    job->reader.direction_limit = config->direction_limit;
    job->locating.stage = KNOT_LOCATE_DONE;
    job->locating.count = 0;
    vbss_knot_closing_of(&job->closing, config, &job->scene);
    job->has_tools = job->closing.tail_hold >= 0.0 || job->closing.long_hold >= 0.0;
    vbss_knot_core_begin(&job->core, &job->closing, &job->scene);
    job->stage = KNOT_JOB_CORE;
    if (job->closing.far < LEAST_FAR) {
        job->outward = job->tail = job->long_limb = no_knot();
        job->closing.others = 0;
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
        return job->closing.has_tissue;
    case KNOT_CURVE_TOOLS:
        return job->has_tools;
    default:
        return true;
    }
}

/* The reduced thread between the first vertices at or after two places. */
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
    const knot_closing *c = &job->closing;
    const knot_polygon *core = &job->core.polygon;
    const double last = core->place[core->count - 1];
    const uint32_t other = job->curve >= KNOT_CURVE_OTHERS ? job->curve - KNOT_CURVE_OTHERS + 1 : 0;
    double from = 0.0, until = last;
    knot_way tail = vbss_knot_way_out(core->x[0], c->tail_out[other]);
    knot_way end = vbss_knot_way_out(core->x[core->count - 1], c->long_out[other]);
    knot_way away =
        vbss_knot_way_out(vbss_knot_point_at(&job->scene, job->scene.tissue_place), c->away);
    if (job->curve == KNOT_CURVE_TAIL) {
        until = job->scene.tissue_place;
        end = away;
    } else if (job->curve == KNOT_CURVE_LONG) {
        from = job->scene.tissue_place;
        tail = away;
    } else if (job->curve == KNOT_CURVE_TOOLS) {
        if (c->tail_hold >= 0.0) {
            from = c->tail_hold;
            tail = c->tail_way;
        }
        if (c->long_hold >= 0.0) {
            until = c->long_hold;
            end = c->long_way;
        }
    }
    knot_polygon *polygon = &job->reader.polygon;
    vbss_knot_close_begin(c, polygon, &tail);
    add_core(polygon, core, from, until);
    vbss_knot_close_end(c, polygon, &tail, &end);
    vbss_knot_curve_begin(&job->reader, job->curve == KNOT_CURVE_OUTWARD);
}

static void take_reading(knot_job *job)
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

static void read_curves(knot_job *job, const vbss_knot_config *config, knot_work *work)
{
    if (job->curve_began) {
        if (vbss_knot_curve_go_on(&job->reader, work)) {
            take_reading(job);
            job->curve_began = false;
            job->curve++;
        }
    } else if (job->curve >= KNOT_CURVE_OTHERS + job->closing.others) {
        vbss_knot_locating_begin(&job->locating, &job->reader, &job->scene, &job->closing,
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

/* ---- the whole */

bool vbss_knot_job_go_on(knot_job *job, const vbss_knot_config *config, knot_work *work)
{
    const knot_work had = *work;
    while (*work > 0 && vbss_knot_job_is_active(job)) {
        switch (job->stage) {
        case KNOT_JOB_CORE:
            if (vbss_knot_core_go_on(&job->core, work)) {
                job->stage = KNOT_JOB_CURVES;
            }
            break;
        case KNOT_JOB_CURVES:
            read_curves(job, config, work);
            break;
        case KNOT_JOB_LOCATE:
            if (vbss_knot_locating_go_on(&job->locating, &job->reader, work)) {
                job->stage = KNOT_JOB_DONE;
            }
            break;
        default:
            break;
        }
    }
    job->spent += had - *work;
    return job->stage == KNOT_JOB_DONE;
}

void vbss_knot_count_job(const knot_job *job, vbss_knot_statistics *figures)
{
    const knot_counts *c = &job->reader.counts;
    figures->closures += c->closures;
    figures->certified += c->certified;
    figures->projections += c->projections;
    figures->degenerate += c->degenerate;
    figures->overflows += c->overflows;
    figures->removed += c->removed + job->core.reduction.removed;
    figures->work += (uint64_t)job->spent;
}
