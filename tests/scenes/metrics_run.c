#include "scenes/metrics_run.h"

#include "base/elementary.h"
#include "base/error.h"

vbss_result metrics_run_create(vbss_context *context, vbss_metrics **metrics)
{
    vbss_metrics_config config;
    VBSS_TRY(vbss_metrics_config_init(&config, sizeof config));
    config.duration = 5.0; /* a little less than the run */
    config.incident_capacity = 16;
    config.phase_capacity = 8;
    config.throw_capacity = 8;
    config.weight_granny = 3.0;
    config.weight_attempt = 2.0;
    return vbss_metrics_create(context, &config, metrics);
}

/* ---- events: at a step, what, which, whether it is undone */

static const struct {
    uint64_t step;
    vbss_metrics_event_kind kind;
    uint32_t number, undone;
    double amount;
} script[] = {
    {3, VBSS_METRICS_EVENT_NEEDLE_APPEARS, 0, 0, 0.0},
    {3, VBSS_METRICS_EVENT_PHASE, 1, 0, 0.0},
    {20, VBSS_METRICS_EVENT_PUNCTURE, 0, 0, 0.0},
    {30, VBSS_METRICS_EVENT_PUNCTURE, 0, 1, 0.0},
    {44, VBSS_METRICS_EVENT_PUNCTURE, 0, 0, 0.0},
    {50, VBSS_METRICS_EVENT_DROP, 2, 0, 0.0},
    {60, VBSS_METRICS_EVENT_PUNCTURE, 1, 0, 0.0},
    {70, VBSS_METRICS_EVENT_PHASE, 2, 0, 0.0},
    {75, VBSS_METRICS_EVENT_TAIL, 0, 0, 0.018},
    {80, VBSS_METRICS_EVENT_THROW, 0, 0, 0.0},
    {100, VBSS_METRICS_EVENT_TRANSFER, 0, 0, 0.0},
    {120, VBSS_METRICS_EVENT_THROW, 1, 0, 0.0},
    {130, VBSS_METRICS_EVENT_THROW, 1, 1, 0.0},
    {140, VBSS_METRICS_EVENT_THROW, 1, 0, 0.0},
    {150, VBSS_METRICS_EVENT_TRANSFER_MISSED, 0, 0, 0.0},
    {170, VBSS_METRICS_EVENT_THROW, 2, 0, 0.0},
    {180, VBSS_METRICS_EVENT_GAP, 0, 0, 0.0009},
    {185, VBSS_METRICS_EVENT_HOST, 7, 0, 4.5},
    {190, VBSS_METRICS_EVENT_PHASE, 3, 0, 0.0},
    {200, VBSS_METRICS_EVENT_TAIL_CUT, 0, 0, 0.004},
    {210, VBSS_METRICS_EVENT_TAIL_CUT, 1, 0, 0.005},
    {250, VBSS_METRICS_EVENT_PHASE, 1, 0, 0.0},
};

static void fill_event(size_t i, double time, vbss_metrics_event *e)
{
    e->kind = script[i].kind;
    e->number = script[i].number;
    e->undone = script[i].undone;
    e->amount = script[i].amount;
    e->tool = (vbss_metrics_tool)(i % 3);
    e->step = script[i].step;
    e->time = time;
    e->position[0] = 0.001 * (double)i;
    e->other[1] = 0.0007;
    e->force[2] = 1.0 + (double)i;
    e->angle = 0.05;
    e->axial = -0.0006;
    e->wraps = e->number == 0 ? 2 : 1;
    e->handedness = e->number % 2 == 0 ? 1 : -1;
    e->relation = e->kind == VBSS_METRICS_EVENT_THROW ? (vbss_metrics_relation)e->number + 1 : 0;
}

static vbss_result tell_events(vbss_metrics *metrics, uint64_t step, double time)
{
    for (size_t i = 0; i < sizeof script / sizeof script[0]; i++) {
        vbss_metrics_event e;
        if (script[i].step == step) {
            VBSS_TRY(vbss_metrics_event_init(&e, sizeof e));
            fill_event(i, time, &e);
            VBSS_TRY(vbss_metrics_add_event(metrics, &e));
        }
    }
    return VBSS_OK;
}

/* Both pull; from step 260 on it creeps. */
static vbss_result pull(vbss_metrics *metrics, uint64_t step, double time)
{
    vbss_metrics_pull p;
    VBSS_TRY(vbss_metrics_pull_init(&p, sizeof p));
    double force = 0.08 * (double)(step - 220);
    p.begins = step == 220;
    p.step = step;
    p.time = time;
    for (int i = 0; i < 2; i++) {
        p.force[i] = vbss_min(force, 2.1);
        p.strain[i] = p.force[i] / 427.0;
    }
    p.drawn_in = step > 260 ? 5e-5 * (double)(step - 260) : 0.0;
    return vbss_metrics_add_pull(metrics, &p);
}

/* ---- hands: the right one is gone for a while */

static void fill_sample(uint64_t step, double time, vbss_metrics_sample *s)
{
    double slow, fast, other;
    vbss_sincos(2.0 * time, &slow, &other);
    vbss_sincos(7.0 * time, &fast, &other);
    bool away = step > 90 && step < 115;
    s->valid = away ? 5u : 15u;
    s->step = step;
    s->time = time;
    s->position[0][0] = 0.02 * slow;
    s->position[0][1] = 0.005 * fast;
    s->position[1][0] = 0.1 + 0.015 * fast * slow;
    s->position[1][2] = 0.01 * slow;
    s->force[0][2] = 1.0 + fast;
    s->force[1][0] = 0.5 * slow;
}

vbss_result metrics_run_step(vbss_metrics *metrics)
{
    metrics_object *m;
    vbss_metrics_sample s;
    VBSS_TRY(vbss_metrics_open(metrics, &m));
    uint64_t step = m->samples;
    double time = 0.5 + 0.017 * (double)step + 0.004 * vbss_sin(1.7 * (double)step);
    VBSS_TRY(tell_events(metrics, step, time));
    if (step >= 220) {
        VBSS_TRY(pull(metrics, step, time));
    }
    VBSS_TRY(vbss_metrics_sample_init(&s, sizeof s));
    fill_sample(step, time, &s);
    return vbss_metrics_add_sample(metrics, &s);
}
