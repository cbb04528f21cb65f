#include "surgeon/watch.h"

#include <stdio.h>
#include <string.h>

#define STEP 1e-3
#define MILLI 1e3
#define OFTEN 0.2 /* s: so often it is told how things stand */

/* ---- told */

static void report_state(const surgeon *s, const char *doing)
{
    const stitch *t = &s->stitch;
    const senses *e = &s->see;
    const hand *left = stitch_hand(t, SITE_LEFT), *right = stitch_hand(t, SITE_RIGHT);
    const vec at[2] = {mirror_vec(t->site.rig.mirrored, left->at),
                       mirror_vec(t->site.rig.mirrored, right->at)};
    printf("%7.3f s  %-7s tail %6.1f slit %5.2f  left %6.1f %6.1f %6.1f feels %.2f  right %6.1f "
           "%6.1f %6.1f feels %.2f",
           t->site.rig.time, doing, MILLI * pull_tail(t), MILLI * s->gap, MILLI * at[0].x,
           MILLI * at[0].y, MILLI * at[0].z, v_length(left->pull), MILLI * at[1].x, MILLI * at[1].y,
           MILLI * at[1].z, v_length(right->pull));
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
    snprintf(text, sizeof text, "%.2f s, seed %lu: %s, slit %.2f mm", s->stitch.site.rig.time,
             (unsigned long)w->options.seed, doing, MILLI * s->gap);
    if (!surgeon_show(s, path, text, near ? v3(0.0, 0.0, 0.0) : v3(0.0, 0.0, 0.04),
                      !near                      ? 0.14
                      : s->stage == SURGEON_PASS ? 0.06
                                                 : 0.035)) {
        w->unpainted = true;
    }
}

double watch_feels(const hand *h)
{
    vbss_grasper_state g;
    bool good = vbss_grasper_get_state(h->grasper, &g, sizeof g) == VBSS_OK;
    return good ? v_length(v_load(g.hand_force)) : 0.0;
}

static void observe(watch *w, const surgeon *s, const char *doing, bool changed)
{
    const stitch *t = &s->stitch;
    vbss_scene_statistics c;
    if (vbss_scene_get_statistics(t->site.rig.scene, &c, sizeof c) == VBSS_OK &&
        c.contacts > w->max_contacts) {
        w->max_contacts = c.contacts;
    }
    if (s->stage < SURGEON_DONE) {
        w->left[s->stage] = larger(w->left[s->stage], watch_feels(stitch_hand(t, SITE_LEFT)));
        w->right[s->stage] = larger(w->right[s->stage], watch_feels(stitch_hand(t, SITE_RIGHT)));
    }
    if (w->verbose && (changed || fmod(t->site.rig.time, OFTEN) < STEP)) {
        report_state(s, doing);
    }
    if (changed) {
        watch_album(w, s, doing);
    }
    if (w->folder != NULL && (changed || t->site.rig.time >= w->next)) {
        paint(w, s, doing);
        w->next = t->site.rig.time + w->every;
    }
}

static void keep_time(watch *w, surgeon_stage stage, double time)
{
    if (w->count < WATCH_STEPS) {
        w->steps[w->count++] = (watch_step){.time = time, .stage = stage};
        w->counts[stage]++;
        w->last = stage;
    }
}

static void enter(watch *w, const surgeon *s)
{
    if (s->stage < SURGEON_DONE && w->counts[s->stage] == 0) {
        w->begin[s->stage] = s->stitch.site.rig.time;
    }
    watch_progress(w, s, true);
}

static vbss_result show_guest(const watch *w, surgeon *s)
{
    return w->guest != NULL ? w->guest(w->user, w, s) : VBSS_OK;
}

static vbss_result perform(watch *w, surgeon *s)
{
    const char *before = "";
    TRY(show_guest(w, s));
    while (s->stage < w->options.until && s->stage < SURGEON_DONE &&
           s->stitch.site.rig.time < w->time_limit) {
        surgeon_stage stage = s->stage;
        TRY(surgeon_step(s, STEP));
        keep_time(w, stage, s->stitch.site.rig.took);
        const char *doing = surgeon_doing(s);
        observe(w, s, doing, strcmp(doing, before) != 0);
        if (s->stage != stage) {
            enter(w, s);
        } else {
            watch_progress(w, s, false);
        }
        before = doing;
        TRY(show_guest(w, s));
    }
    return VBSS_OK;
}

vbss_result watch_run(watch *w, surgeon *s, watch_step *steps)
{
    TRY(surgeon_create(s, &w->options));
    const task_plan plan = surgeon_task_plan(&w->options);
    TRY(task_create_as(&w->task, &s->stitch, s->stitch.site.rig.record, NULL, &plan));
    s->stitch.site.rig.session = w->task.session;
    w->began = watch_wall_clock();
    w->steps = steps;
    vbss_result result = perform(w, s);
    w->wall = watch_wall_clock() - w->began;
    (void)vbss_session_get_status(w->task.session, &w->status, sizeof w->status);
    return result != VBSS_OK ? result : throw_rig_end(&s->stitch.site.rig);
}

bool watch_complete(const watch *w)
{
    return w->options.until == SURGEON_DONE && w->status.phase == VBSS_SESSION_PHASE_DONE;
}
