/* The pull test: whether a knot holds, by ours and as the paper decides it. */
#include "base/check.h"
#include "base/config.h"
#include "base/error.h"
#include "metrics/metrics.h"

_Static_assert(sizeof(vbss_metrics_pull) == 72, "published size");
static const vbss_metrics_pull defaults = {.struct_size = sizeof(vbss_metrics_pull), .tied = 1};
static const uint32_t sizes[] = {72, 0};
static const vbss_layout layout = {"vbss_metrics_pull", &defaults, sizes};

/* While it lasts, a pull may be so much weaker: hands and controllers are not steady. */
#define HOLD 0.9

vbss_result vbss_metrics_pull_init(vbss_metrics_pull *pull, uint32_t struct_size)
{
    return vbss_config_init(&layout, pull, struct_size);
}

static vbss_result check(const metrics_object *m, const vbss_metrics_pull *p)
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
    return vbss_check_range(context, p->drawn_in, -METRICS_LARGEST_PLACE, METRICS_LARGEST_PLACE,
                            "drawn_in");
}

/* Ours: borne for the time, with less than the limit drawn in. Once that is shown, the test is over. */
static void hold(const vbss_metrics_config *c, metrics_pull *pull, const vbss_metrics_pull *p)
{
    double weaker = vbss_min(p->force[0], p->force[1]);
    if (pull->tight || pull->untied) {
        return;
    }
    if (p->tied == 0) {
        pull->untied = 1;
        return;
    }
    if (weaker < (pull->holding ? HOLD : 1.0) * c->pull_force) {
        pull->holding = 0;
    } else if (!pull->holding) {
        pull->holding = 1;
        pull->hold_began = p->time;
    }
    pull->drawn_in = vbss_max(pull->drawn_in, p->drawn_in);
    pull->slipped = pull->drawn_in >= c->slip_limit;
    if (pull->holding) {
        pull->held = vbss_max(pull->held, p->time - pull->hold_began);
        pull->tight = !pull->slipped && pull->held >= c->pull_time;
    }
}

/* The paper's: the strain on both sides has reached the threshold (Qi et al. 2017, section 6). */
static void stretch(const vbss_metrics_config *c, metrics_pull *pull, const vbss_metrics_pull *p)
{
    double threshold =
        c->strain_threshold > 0.0 ? c->strain_threshold : c->pull_force / c->stiffness;
    double smaller = vbss_min(p->strain[0], p->strain[1]);
    if (p->tied != 0 && !pull->untied) {
        pull->strain = vbss_max(pull->strain, smaller);
        pull->strained |= smaller >= threshold;
    }
}

vbss_result vbss_metrics_add_pull(vbss_metrics *metrics, const vbss_metrics_pull *pull)
{
    metrics_object *m;
    vbss_metrics_pull p;
    VBSS_TRY(vbss_metrics_edit(metrics, &m));
    VBSS_TRY(vbss_config_read(m->context, &layout, pull, &p));
    VBSS_TRY(check(m, &p));
    metrics_pull next = p.begins != 0 ? (metrics_pull){.pulled = 0} : m->pull;
    stretch(&m->config, &next, &p);
    hold(&m->config, &next, &p);
    next.pulled = 1;
    if (p.begins != 0 || !m->pull.pulled ||
        vbss_metrics_tightness_ours(&next) != vbss_metrics_tightness_ours(&m->pull) ||
        vbss_metrics_tightness_paper(&next) != vbss_metrics_tightness_paper(&m->pull)) {
        next.last = (metrics_note){.tool = VBSS_METRICS_NO_TOOL, .step = p.step, .time = p.time};
    }
    m->pull = next;
    vbss_metrics_tell_time(m, p.time, p.step);
    return VBSS_OK;
}

/* ---- verdicts */

vbss_metrics_tightness vbss_metrics_tightness_ours(const metrics_pull *pull)
{
    return pull->untied    ? VBSS_METRICS_TIGHTNESS_UNTIED
           : pull->tight   ? VBSS_METRICS_TIGHTNESS_TIGHT
           : pull->slipped ? VBSS_METRICS_TIGHTNESS_SLIPS
                           : VBSS_METRICS_TIGHTNESS_UNKNOWN;
}

vbss_metrics_tightness vbss_metrics_tightness_paper(const metrics_pull *pull)
{
    return pull->strained ? VBSS_METRICS_TIGHTNESS_TIGHT
           : pull->untied ? VBSS_METRICS_TIGHTNESS_UNTIED
           : pull->pulled ? VBSS_METRICS_TIGHTNESS_SLIPS
                          : VBSS_METRICS_TIGHTNESS_UNKNOWN;
}
