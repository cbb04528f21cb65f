#include "surgeon/watch.h"

#include <stdio.h>
#include <stdlib.h>
#include <time.h>

#define STEP 1e-3
#define MILLI 1e3
#define MICRO 1e6
#define OFTEN 0.2 /* s: so often it is told how things stand */

static double now(void)
{
    struct timespec t;
    (void)clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

/* ---- told */

static void tell_state(const surgeon *s, const char *doing)
{
    const stitch *t = &s->stitch;
    const senses *e = &s->see;
    printf("%7.3f s  %-7s tail %6.1f slit %5.2f  left %6.1f %6.1f %6.1f feels %.2f  right %6.1f "
           "%6.1f %6.1f feels %.2f",
           t->site.stand.time, doing, MILLI * pull_tail(t), MILLI * s->gap, MILLI * t->left.at.x,
           MILLI * t->left.at.y, MILLI * t->left.at.z, v_length(t->left.pull),
           MILLI * t->right.at.x, MILLI * t->right.at.y, MILLI * t->right.at.z,
           v_length(t->right.pull));
    if (s->stage >= SURGEON_TIE) {
        printf("  turns %.2f, %.1f to %.1f behind the tip, angle %.1f radius %.1f", e->turns,
               MILLI * e->first_s, MILLI * e->last_s, s->tie.phi, MILLI * s->tie.rho);
    }
    printf("\n");
    fflush(stdout);
}

static void paint(watch *w, const surgeon *s, const char *doing)
{
    char path[512], text[96];
    bool over = s->stage == SURGEON_OVER || s->stage == SURGEON_BACK;
    bool near = s->stage == SURGEON_PASS || (!over && s->tie.state >= THROW_SEAT);
    snprintf(path, sizeof path, "%s/%03d-%s.png", w->folder, w->pictures++, doing);
    snprintf(text, sizeof text, "%.2f s, seed %lu: %s, slit %.2f mm", s->stitch.site.stand.time,
             (unsigned long)w->options.seed, doing, MILLI * s->gap);
    if (!surgeon_show(s, path, text, near ? v3(0.0, 0.0, 0.0) : v3(0.0, 0.0, 0.04),
                      !near                      ? 0.14
                      : s->stage == SURGEON_PASS ? 0.06
                                                 : 0.035)) {
        printf("%s cannot be painted\n", path);
    }
}

static double hand_feels(const hand *h)
{
    vbss_grasper_state g;
    bool good = vbss_grasper_get_state(h->grasper, &g, sizeof g) == VBSS_OK;
    return good ? v_length(v_load(g.hand_force)) : 0.0;
}

static void look(watch *w, const surgeon *s, const char *doing, bool changed)
{
    const stitch *t = &s->stitch;
    if (s->stage < SURGEON_DONE) {
        w->left[s->stage] = fmax(w->left[s->stage], hand_feels(&t->left));
        w->right[s->stage] = fmax(w->right[s->stage], hand_feels(&t->right));
    }
    if (w->verbose && (changed || fmod(t->site.stand.time, OFTEN) < STEP)) {
        tell_state(s, doing);
    }
    if (w->folder != NULL && (changed || t->site.stand.time >= w->next)) {
        paint(w, s, doing);
        w->next = t->site.stand.time + w->every;
    }
}

vbss_result watch_run(watch *w, surgeon *s)
{
    const char *before = "";
    TRY(surgeon_create(s, &w->options));
    TRY(task_create_within(&w->task, &s->stitch, s->stitch.site.stand.record, NULL,
                           surgeon_time_limit(&w->options)));
    s->stitch.site.stand.session = w->task.session;
    while (s->stage < w->options.until && s->stage < SURGEON_DONE &&
           s->stitch.site.stand.time < w->most) {
        surgeon_stage stage = s->stage;
        double begin = now();
        TRY(surgeon_step(s, STEP));
        if (w->counts[stage] < WATCH_STEPS) {
            w->times[stage][w->counts[stage]++] = now() - begin;
        }
        const char *doing = surgeon_doing(s);
        look(w, s, doing, strcmp(doing, before) != 0);
        before = doing;
    }
    return stand_end(&s->stitch.site.stand);
}

/* ---- in the end */

static int by_size(const void *a, const void *b)
{
    double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

static double quantile(const watch *w, int stage, double share)
{
    uint32_t count = w->counts[stage], i = (uint32_t)(share * count);
    return MICRO * w->times[stage][i < count ? i : count - 1];
}

void watch_tell(watch *w, const surgeon *s, vbss_result result)
{
    const stand *st = &s->stitch.site.stand;
    vbss_scene_statistics c;
    printf("seed %lu: %s, %s %s after %.2f s\n", (unsigned long)w->options.seed,
           vbss_result_name(result), surgeon_doing(s), s->why != NULL ? s->why : "", st->time);
    printf("  holes %.2f and %.2f mm off their marks; tail %.1f mm; slit %.2f mm before the throw, "
           "%.2f mm now; throw '%s' of handedness %d\n",
           MILLI * s->off[SITE_RIGHT], MILLI * s->off[SITE_LEFT], MILLI * s->tail,
           MILLI * s->gap_before, MILLI * s->gap, s->tie.formed.notation, s->tie.formed.handedness);
    for (int i = 0; i < SURGEON_DONE; i++) {
        if (w->counts[i] == 0) {
            continue;
        }
        qsort(w->times[i], w->counts[i], sizeof *w->times[i], by_size);
        printf("  %-6s %5u steps, median %.0f us, p99 %.0f, p99.9 %.0f, longest %.0f; hands feel "
               "up to "
               "%.2f and %.2f N\n",
               surgeon_stage_name((surgeon_stage)i), (unsigned)w->counts[i], quantile(w, i, 0.5),
               quantile(w, i, 0.99), quantile(w, i, 0.999), quantile(w, i, 1.0), w->left[i],
               w->right[i]);
    }
    if (vbss_scene_get_statistics(st->scene, &c, sizeof c) == VBSS_OK) {
        printf("  clamped %lu, paused %lu\n", (unsigned long)c.clamped, (unsigned long)c.paused);
    }
    fflush(stdout);
}
