/* What came of a performance: stages and times, what was measured, the knot, the score, what steps took, what was counted. */
#include <stdio.h>

#include "knots/words.h"
#include "surgeon/watch.h"
#include "throw/counts.h"

#define MILLI 1e3
enum { NOTATION = 32, PHASES = VBSS_SESSION_PHASE_FAILED + 1 };

/* ---- the hands' stages, and what their steps took */

static void report_stages(const watch *w)
{
    printf("  %-7s%9s%9s%9s%8s%8s%8s%9s%9s%10s\n", "stage", "begins s", "takes s", "CPU s",
           "p50 us", "p99", "p99.9", "longest", "left, N", "right, N");
    const watch_step *steps = w->steps;
    watch_sort_stages(w->steps, w->count);
    for (int i = 0; i < SURGEON_DONE; i++) {
        const uint32_t count = w->counts[i];
        double sum = 0.0;
        for (uint32_t k = 0; k < count; k++) {
            sum += steps[k].time;
        }
        if (count > 0) {
            printf("  %-7s%9.2f%9.2f%9.2f%8.0f%8.0f%8.0f%9.0f%9.2f%10.2f\n",
                   surgeon_stage_name((surgeon_stage)i), w->begin[i], count / MILLI, sum,
                   watch_quantile(steps, count, 0.5), watch_quantile(steps, count, 0.99),
                   watch_quantile(steps, count, 0.999), watch_quantile(steps, count, 1.0),
                   w->left[i], w->right[i]);
        }
        steps += count;
    }
}

static void report_steps(watch *w, const surgeon *s)
{
    vbss_scene_statistics c = {0};
    watch_step *all = w->steps;
    double sum = 0.0;
    uint32_t count = w->count, late = 0;
    for (uint32_t i = 0; i < count; i++) {
        sum += all[i].time;
        late += all[i].time > 1e-3;
    }
    if (count == 0) {
        return;
    }
    watch_sort(all, count);
    printf("  a call of 1 ms with devices, session and log, us of this thread's CPU, one run: p50 "
           "%.0f, p99 %.0f, p99.9 %.0f, longest %.0f; %.2f %% above 1 ms\n",
           watch_quantile(all, count, 0.5), watch_quantile(all, count, 0.99),
           watch_quantile(all, count, 0.999), watch_quantile(all, count, 1.0),
           100.0 * late / count);
    (void)vbss_scene_get_statistics(s->stitch.site.rig.scene, &c, sizeof c);
    const double made = count / MILLI - c.time_paused;
    printf("  %.2f s simulated of %.2f s, in %.2f s of CPU: real-time factor %.2f; %.2f s by the "
           "clock, pictures and all\n",
           made, count / MILLI, sum, made / sum, w->wall);
}

/* ---- the task */

static void report_outcome(const watch *w, const surgeon *s, vbss_result result)
{
    printf("seed %lu: %s\n", (unsigned long)w->options.seed,
           watch_complete(w) ? "the task is complete" : "the task is not complete");
    printf("  the hands: %s, %s%s%s after %.2f s; the session: phase '%s', %s\n",
           vbss_result_name(result), surgeon_doing(s), s->why != NULL ? ": " : "",
           s->why != NULL ? s->why : "", s->stitch.site.rig.time, task_phase_name(w->status.phase),
           task_failure_name(w->status.failure));
}

static void report_phases(const watch *w, const vbss_metrics_report *r)
{
    double durations[PHASES] = {0.0};
    uint32_t visits[PHASES] = {0};
    for (uint32_t i = 0; i < r->phase_count; i++) {
        vbss_metrics_phase p;
        if (vbss_metrics_get_phase(w->task.metrics, i, &p, sizeof p) == VBSS_OK &&
            p.number < PHASES) {
            durations[p.number] += p.end - p.begin;
            visits[p.number]++;
        }
    }
    printf("  phases, s:");
    for (int i = 0; i < PHASES; i++) {
        if (visits[i] > 0) {
            printf(" %s %.2f%s;", task_phase_name(i), durations[i],
                   visits[i] > 1 ? " (again)" : "");
        }
    }
    printf(" in all %.2f\n", r->time);
}

static const char *words_of_tightness(vbss_metrics_tightness t)
{
    return t == VBSS_METRICS_TIGHTNESS_TIGHT    ? "tight"
           : t == VBSS_METRICS_TIGHTNESS_SLIPS  ? "slips"
           : t == VBSS_METRICS_TIGHTNESS_UNTIED ? "untied"
                                                : "not tested";
}

static void report_tails(const surgeon *s, const vbss_metrics_report *r)
{
    static const uint32_t known[2] = {VBSS_METRICS_FLAG_TAIL_0, VBSS_METRICS_FLAG_TAIL_1};
    static const char *const names[2] = {"short", "needle's"};
    printf("  %u transfers, %u drops", (unsigned)r->transfers, (unsigned)r->drops);
    if (s->tail > 0.0) {
        printf("; tail %.1f mm when it was set", MILLI * s->tail);
    }
    for (int i = 0; i < 2; i++) {
        if ((r->flags & known[i]) != 0) {
            printf("; the %s one %.1f mm in the end", names[i], r->tail_mm[i]);
        }
    }
    printf("\n");
}

static void report_slit(const surgeon *s, const vbss_metrics_report *r)
{
    printf("  slit %.2f mm in the end (%.2f between the edges' middles)", MILLI * s->gap,
           MILLI * s->edges);
    if (s->gap_before > 0.0) {
        printf("; %.2f before the first throw", MILLI * s->gap_before);
    }
    if ((r->flags & VBSS_METRICS_FLAG_GAP) != 0) {
        printf("; as it is scored %.2f, at the widest %.2f", r->gap_mm, r->gap_largest_mm);
    }
    printf("\n");
}

static void report_measures(const surgeon *s, const vbss_metrics_report *r)
{
    printf(
        "  holes %.2f and %.2f mm off their marks; tightness by the pull test: %s, by the strain: "
        "%s\n",
        r->deviation_mm[0], r->deviation_mm[1], words_of_tightness(r->tightness_pull),
        words_of_tightness(r->tightness_strain));
    report_slit(s, r);
    report_tails(s, r);
}

static void report_score(const watch *w, const vbss_metrics_report *r)
{
    printf("  score %.1f of 600 in the style of MISTELS%s: %.1f for the time", r->score,
           (r->flags & VBSS_METRICS_FLAG_FINAL) != 0 ? "" : ", provisional", -r->time);
    for (uint32_t i = 0; i < r->penalty_count; i++) {
        vbss_metrics_penalty p;
        if (vbss_metrics_get_penalty(w->task.metrics, i, &p, sizeof p) == VBSS_OK) {
            printf("; %.1f %s", p.amount > 0.0 ? -p.amount : 0.0, p.text);
        }
    }
    printf("\n");
}

static void report_knot(const watch *w)
{
    vbss_knot_state k;
    char notation[NOTATION] = "", words[WORD_TAGS];
    if (vbss_knot_detector_get_state(w->task.knots, &k, sizeof k) != VBSS_OK ||
        vbss_knot_detector_get_notation(w->task.knots, notation, sizeof notation) != VBSS_OK) {
        return;
    }
    words_of_faults(k.faults, words);
    printf("  knot: %s, %s (%s); %s; %u throws tied, %u seated\n",
           notation[0] != '\0' ? notation : "none", words_of_result(k.verdict),
           words_of_name(k.name), words, (unsigned)w->status.throws, (unsigned)w->status.seated);
    for (uint32_t i = 0; i < k.throw_count; i++) {
        vbss_knot_throw t;
        if (vbss_knot_detector_get_throw(w->task.knots, i, &t, sizeof t) == VBSS_OK) {
            words_of_throw(&t, words);
            printf("    throw %u: %s\n", (unsigned)i + 1, words);
        }
    }
}

/* ---- counts */

static void report_counts(const watch *w, const surgeon *s)
{
    const hand *hands[2] = {stitch_hand(&s->stitch, SITE_LEFT),
                            stitch_hand(&s->stitch, SITE_RIGHT)};
    static const char *const names[2] = {"left device", "right device"};
    vbss_scene_statistics c;
    if (vbss_scene_get_statistics(s->stitch.site.rig.scene, &c, sizeof c) == VBSS_OK) {
        counts_report_scene(&c);
        printf("  most contacts at a time %u; %lu steps of which a part waited, %.1f ms in all; "
               "%u steps finished beyond the limit of a call\n",
               (unsigned)w->max_contacts, (unsigned long)c.paused, MILLI * c.time_paused,
               (unsigned)c.overdue);
    }
    for (int i = 0; i < 2; i++) {
        vbss_device_statistics in;
        vbss_output_statistics out;
        double largest = 0.0;
        for (int k = 0; k < SURGEON_DONE; k++) {
            largest = larger(largest, i == 0 ? w->left[k] : w->right[k]);
        }
        if (vbss_device_get_statistics(hands[i]->device, &in, sizeof in) == VBSS_OK &&
            vbss_device_get_output_statistics(hands[i]->device, &out, sizeof out) == VBSS_OK) {
            counts_report_device(names[i], &in, &out, largest);
        }
    }
}

void watch_report(watch *w, const surgeon *s, vbss_result result)
{
    vbss_metrics_report r;
    printf("\n");
    report_outcome(w, s, result);
    report_stages(w);
    if (w->task.session != NULL &&
        vbss_metrics_get_report(w->task.metrics, &r, sizeof r) == VBSS_OK) {
        report_phases(w, &r);
        report_measures(s, &r);
        report_knot(w);
        report_score(w, &r);
    }
    report_steps(w, s);
    report_counts(w, s);
    if (w->unpainted) {
        printf("  A PICTURE COULD NOT BE MADE\n");
    }
    fflush(stdout);
}
