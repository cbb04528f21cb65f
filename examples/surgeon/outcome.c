/* What came of a performance, for programs: one line of JSON. */
#include <inttypes.h>
#include <stdio.h>

#include "surgeon/watch.h"

#define MILLI 1e3
enum { NOTATION = 32, PHASES = VBSS_SESSION_PHASE_FAILED + 1 };

static void write_knot(FILE *out, const watch *w)
{
    vbss_knot_state k;
    char notation[NOTATION] = "";
    if (vbss_knot_detector_get_state(w->task.knots, &k, sizeof k) == VBSS_OK &&
        vbss_knot_detector_get_notation(w->task.knots, notation, sizeof notation) == VBSS_OK) {
        fprintf(out, ", \"notation\": \"%s\", \"certified\": %s, \"faults\": %" PRIu32, notation,
                k.verdict == VBSS_KNOT_VERDICT_CERTIFIED ? "true" : "false", k.faults);
    }
}

static void write_phases(FILE *out, const watch *w, const vbss_metrics_report *r)
{
    double seconds[PHASES] = {0.0};
    for (uint32_t i = 0; i < r->phase_count; i++) {
        vbss_metrics_phase p;
        if (vbss_metrics_get_phase(w->task.metrics, i, &p, sizeof p) == VBSS_OK &&
            p.number < PHASES) {
            seconds[p.number] += p.end - p.begin;
        }
    }
    const char *separator = "";
    fprintf(out, ", \"phases_s\": {");
    for (int i = 0; i < PHASES; i++) {
        if (seconds[i] > 0.0) {
            fprintf(out, "%s\"%s\": %.3f", separator, task_phase_name(i), seconds[i]);
            separator = ", ";
        }
    }
    fprintf(out, "}");
}

static const vbss_metrics_tool tools[2] = {VBSS_METRICS_TOOL_LEFT, VBSS_METRICS_TOOL_RIGHT};

static void write_motion(FILE *out, const watch *w)
{
    static const char *const names[2] = {"left", "right"};
    for (int i = 0; i < 2; i++) {
        vbss_metrics_motion m;
        if (vbss_metrics_get_motion(w->task.metrics, tools[i], VBSS_METRICS_PHASE_ALL, &m,
                                    sizeof m) == VBSS_OK) {
            fprintf(out,
                    ", \"%s\": {\"path_m\": %.4f, \"idle_share\": %.4f, \"force_peak_N\": %.3f, "
                    "\"force_integral_Ns\": %.2f}",
                    names[i], m.path_length, m.idle_share, m.force_peak, m.force_integral);
        }
    }
}

double watch_largest_force(const watch *w)
{
    double largest = 0.0;
    for (int i = 0; i < 2; i++) {
        vbss_metrics_motion m;
        if (vbss_metrics_get_motion(w->task.metrics, tools[i], VBSS_METRICS_PHASE_ALL, &m,
                                    sizeof m) != VBSS_OK) {
            return (double)INFINITY;
        }
        largest = larger(largest, m.force_peak);
    }
    return largest;
}

static void write_measures(FILE *out, const watch *w, const surgeon *s)
{
    vbss_metrics_report r;
    if (vbss_metrics_get_report(w->task.metrics, &r, sizeof r) != VBSS_OK) {
        return;
    }
    fprintf(out,
            ", \"time_s\": %.3f, \"deviation_mm\": [%.3f, %.3f], \"drops\": %" PRIu32
            ", \"transfers\": %" PRIu32 ", \"transfers_missed\": %" PRIu32
            ", \"withdrawn\": %" PRIu32 ", \"score\": %.1f",
            r.time, r.deviation_mm[0], r.deviation_mm[1], r.drops, r.transfers, r.transfers_missed,
            r.attempts[0] + r.attempts[1], r.score);
    if ((r.flags & VBSS_METRICS_FLAG_GAP) != 0) {
        fprintf(out, ", \"gap_mm\": %.3f", r.gap_mm);
    }
    if (s->gap_before > 0.0) {
        fprintf(out, ", \"slit_before_mm\": %.3f", MILLI * s->gap_before);
    }
    write_phases(out, w, &r);
    write_motion(out, w);
}

static void write_counts(FILE *out, const watch *w, const surgeon *s)
{
    vbss_scene_statistics c;
    double cpu = 0.0;
    for (uint32_t i = 0; i < w->count; i++) {
        cpu += w->steps[i].time;
    }
    if (vbss_scene_get_statistics(s->stitch.site.rig.scene, &c, sizeof c) == VBSS_OK) {
        fprintf(out, ", \"left_out_s\": %.4f, \"truncated\": %" PRIu64 ", \"operations\": %" PRIu64,
                c.time_paused, c.clamped, c.operations);
    }
    fprintf(out, ", \"cpu_s\": %.2f", cpu);
}

bool watch_write_outcome(FILE *out, const watch *w, const surgeon *s, vbss_result result,
                         bool is_good)
{
    const hand_skill *skill = skill_or_expert(w->options.skill);
    fprintf(out,
            "{\"seed\": %" PRIu64
            ", \"skill\": \"%s\", \"left_handed\": %s, \"good\": %s, \"result\": \"%s\", "
            "\"complete\": %s, \"stage\": \"%s\", \"doing\": \"%s\", \"why\": \"%s\", "
            "\"hands_s\": %.3f, \"slit_mm\": %.4f",
            w->options.seed, skill->name, w->options.left_handed ? "true" : "false",
            is_good ? "true" : "false", vbss_result_name(result),
            watch_complete(w) ? "true" : "false", surgeon_stage_name(w->last), surgeon_doing(s),
            s->why != NULL ? s->why : "", s->stitch.site.rig.time, MILLI * s->gap);
    if (w->task.session != NULL) {
        fprintf(out, ", \"phase\": \"%s\", \"failure\": \"%s\", \"seated\": %u",
                task_phase_name(w->status.phase), task_failure_name(w->status.failure),
                (unsigned)w->status.seated);
        write_knot(out, w);
        write_measures(out, w, s);
    }
    write_counts(out, w, s);
    fprintf(out, "}\n");
    return fflush(out) == 0 && ferror(out) == 0;
}
