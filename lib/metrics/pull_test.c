/* The pull test: whether a knot holds, by load and by strain. */
#include "base/api_call.h"
#include "base/check.h"
#include "base/config.h"
#include "base/error.h"
#include "metrics/metrics.h"
#include "metrics/tuning.h"

_Static_assert(sizeof(vbss_metrics_pull) == 72, "published size");
static const vbss_metrics_pull defaults = {.struct_size = sizeof(vbss_metrics_pull), .tied = 1};
static const uint32_t sizes[] = {72, 0};
static const vbss_layout layout = {"vbss_metrics_pull", &defaults, sizes};

vbss_result vbss_metrics_pull_init(vbss_metrics_pull *pull, uint32_t struct_size)
{
    return vbss_config_init(&layout, pull, struct_size);
}

static vbss_result check_pull_reading(const metrics_object *m, const vbss_metrics_pull *p)
{
    vbss_context *context = m->context;
    VBSS_TRY(vbss_check_range(context, p->begins, 0.0, 1.0, "begins"));
    VBSS_TRY(vbss_check_range(context, p->tied, 0.0, 1.0, "tied"));
    VBSS_TRY(vbss_check_range(context, p->reserved, 0.0, 0.0, "reserved"));
    VBSS_TRY(vbss_metrics_check_time(m, p->time));
    for (int i = 0; i < METRICS_HANDS; i++) {
        VBSS_TRY(vbss_check_range(context, p->strain[i], -1.0, 1.0, "strain"));
        VBSS_TRY(vbss_check_range(context, p->force[i], 0.0, METRICS_LARGEST_FORCE, "force"));
    }
    return vbss_check_range(context, p->drawn_in, -METRICS_LARGEST_POSITION,
                            METRICS_LARGEST_POSITION, "drawn_in");
}

/* Our criterion: the knot bears the force for the required time, and less than the limit is drawn
 * in. The test ends when this is reached. */
static void update_hold(const vbss_metrics_config *c, metrics_pull *pull,
                        const vbss_metrics_pull *p)
{
    double min_force = vbss_min(p->force[0], p->force[1]);
    if (pull->is_tight || pull->is_untied) {
        return;
    }
    if (p->tied == 0) {
        pull->is_untied = 1;
        return;
    }
    if (min_force < (pull->is_holding ? METRICS_HOLD_HYSTERESIS : 1.0) * c->pull_force) {
        pull->is_holding = 0;
    } else if (!pull->is_holding) {
        pull->is_holding = 1;
        pull->hold_start = p->time;
    }
    pull->drawn_in = vbss_max(pull->drawn_in, p->drawn_in);
    pull->has_slipped = pull->drawn_in >= c->slip_limit;
    if (pull->is_holding) {
        pull->longest_hold = vbss_max(pull->longest_hold, p->time - pull->hold_start);
        pull->is_tight = !pull->has_slipped && pull->longest_hold >= c->pull_time;
    }
}

/* By strain: that on both sides has reached the threshold (Qi et al. 2017, section 6). */
static void update_strain(const vbss_metrics_config *c, metrics_pull *pull,
                          const vbss_metrics_pull *p)
{
    double threshold =
        c->strain_threshold > 0.0 ? c->strain_threshold : c->pull_force / c->stiffness;
    double min_strain = vbss_min(p->strain[0], p->strain[1]);
    if (p->tied != 0 && !pull->is_untied) {
        pull->strain = vbss_max(pull->strain, min_strain);
        pull->has_reached_strain |= min_strain >= threshold;
    }
}

vbss_result vbss_metrics_add_pull(vbss_metrics *metrics, const vbss_metrics_pull *pull)
{
    VBSS_ENTER(metrics);
    metrics_object *m;
    vbss_metrics_pull p;
    VBSS_TRY(vbss_metrics_edit(metrics, &m));
    VBSS_TRY(vbss_config_read(m->context, &layout, pull, &p));
    VBSS_TRY(check_pull_reading(m, &p));
    metrics_pull next = p.begins != 0 ? (metrics_pull){.has_readings = 0} : m->pull;
    update_strain(&m->config, &next, &p);
    update_hold(&m->config, &next, &p);
    next.has_readings = 1;
    if (p.begins != 0 || !m->pull.has_readings ||
        vbss_metrics_tightness_by_load(&next) != vbss_metrics_tightness_by_load(&m->pull) ||
        vbss_metrics_tightness_by_strain(&next) != vbss_metrics_tightness_by_strain(&m->pull)) {
        next.last_change =
            (metrics_entry){.tool = VBSS_METRICS_TOOL_NONE, .step = p.step, .time = p.time};
    }
    m->pull = next;
    vbss_metrics_advance_clock(m, p.time, p.step);
    return VBSS_OK;
}

/* ---- results */

vbss_metrics_tightness vbss_metrics_tightness_by_load(const metrics_pull *pull)
{
    return pull->is_untied     ? VBSS_METRICS_TIGHTNESS_UNTIED
           : pull->is_tight    ? VBSS_METRICS_TIGHTNESS_TIGHT
           : pull->has_slipped ? VBSS_METRICS_TIGHTNESS_SLIPS
                               : VBSS_METRICS_TIGHTNESS_UNKNOWN;
}

vbss_metrics_tightness vbss_metrics_tightness_by_strain(const metrics_pull *pull)
{
    return pull->has_reached_strain ? VBSS_METRICS_TIGHTNESS_TIGHT
           : pull->is_untied        ? VBSS_METRICS_TIGHTNESS_UNTIED
           : pull->has_readings     ? VBSS_METRICS_TIGHTNESS_SLIPS
                                    : VBSS_METRICS_TIGHTNESS_UNKNOWN;
}
