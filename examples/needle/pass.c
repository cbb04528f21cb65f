#include "needle/pass.h"

#include <stdio.h>
#include <stdlib.h>
#include <time.h>

#define STEP 1e-3

static double now(void)
{
    struct timespec t;
    (void)clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

/* ---- what is felt */

static void note(double *largest, double force)
{
    *largest = force > *largest ? force : *largest;
}

static bool is_wall_on_needle(const stitch *t, const uint32_t *contact)
{
    bool touches =
        contact[0] == VBSS_SCENE_CONTACT_POINT_FACE || contact[0] == VBSS_SCENE_CONTACT_SIDES;
    return touches && contact[1] == t->site.needle_body && contact[3] == t->site.drain_body;
}

static vbss_result feel_wall(const stitch *t, pass_outcome *out)
{
    vbss_view contacts, forces;
    vec sum = v3(0.0, 0.0, 0.0);
    vbss_scene *scene = t->site.rig.scene;
    TRY(vbss_scene_get_view(scene, VBSS_SCENE_VIEW_CONTACTS, &contacts, sizeof contacts));
    TRY(vbss_scene_get_view(scene, VBSS_SCENE_VIEW_CONTACT_FORCES, &forces, sizeof forces));
    for (uint64_t i = 0; i < contacts.count; i++) {
        const char *contact = (const char *)contacts.data + i * contacts.stride_bytes;
        if (is_wall_on_needle(t, (const uint32_t *)contact)) {
            sum = v_add(sum, ((const vec *)forces.data)[i]);
        }
    }
    if (t->state == STITCH_ENTER) {
        note(&out->wall[SITE_RIGHT], v_length(sum));
    } else if (t->state == STITCH_LEAVE) {
        note(&out->wall[SITE_LEFT], v_length(sum));
    }
    return VBSS_OK;
}

static vbss_result feel(const stitch *t, pass_outcome *out)
{
    const hand *hands[2] = {&t->left, &t->right};
    TRY(feel_wall(t, out));
    for (int side = 0; side < 2; side++) {
        vbss_grasper_state s;
        vbss_scene_hole hole;
        TRY(vbss_grasper_get_state(hands[side]->grasper, &s, sizeof s));
        note(&out->hand[side], v_length(v_load(s.hand_force)));
        if (t->holes[side] != 0 && site_find_hole(&t->site, t->holes[side], &hole)) {
            note(&out->hole[side], v_length(v_load(hole.force)));
        }
    }
    if (t->right.holds) {
        vbss_scene_grasp grasp;
        TRY(vbss_scene_get_grasp(t->site.rig.scene, t->right.body, 0, &grasp, sizeof grasp));
        out->slid = grasp.slid;
    }
    return VBSS_OK;
}

/* ---- what is shown */

static const char *stage_of(stitch_state state)
{
    static const char *const stages[STITCH_FAILED + 1] = {
        [STITCH_REACH] = "1-lying", [STITCH_BRING] = "2-taken", [STITCH_ENTER] = "3-aimed",
        [STITCH_CROSS] = "4-entry", [STITCH_LEAVE] = "5-lumen", [STITCH_DRAW] = "6-exit",
        [STITCH_DONE] = "7-through"};
    return stages[state];
}

static void show(const stitch *t, const pass_options *o, pass_outcome *out)
{
    const char *stage = stage_of(t->state);
    if (o->verbose) {
        printf("  %7.3f s  %s\n", t->site.rig.time, stitch_name(t->state));
    }
    if (o->folder != NULL && stage != NULL) {
        char path[512], text[96];
        snprintf(path, sizeof path, "%s/%s.png", o->folder, stage);
        snprintf(text, sizeof text, "%.2f s, seed %lu: %s", t->site.rig.time,
                 (unsigned long)o->seed, stage + 2);
        out->painted = show_picture(t, path, text) && out->painted;
    }
}

/* ---- the trial */

static vbss_result pass(stitch *t, const pass_options *o, pass_outcome *out)
{
    stitch_state before = STITCH_LIE;
    while (t->state < STITCH_DONE && t->site.rig.time < o->time_limit && out->count < PASS_STEPS) {
        TRY(stitch_lead(t, STEP));
        double begin = now();
        TRY(throw_rig_step(&t->site.rig, STEP));
        out->steps[out->count++] = now() - begin;
        TRY(stitch_observe(t));
        TRY(feel(t, out));
        if (t->state != before) {
            show(t, o, out);
            before = t->state;
        }
    }
    return throw_rig_end(&t->site.rig);
}

static int by_size(const void *a, const void *b)
{
    double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

static vbss_result read_outcome(const stitch *t, pass_outcome *out)
{
    out->good = stitch_is_through(t, out->off);
    for (int side = 0; side < 2; side++) {
        if (t->holes[side] != 0) { /* in the step in which it was made */
            note(&out->wall[side], v_length(v_load(t->made[side].force)));
        }
    }
    out->state = stitch_name(t->state);
    out->why = t->why != NULL ? t->why : "";
    out->punctures = t->punctures;
    out->others = t->others;
    out->tries = t->tries + 1;
    out->again = t->again;
    out->out = t->out;
    out->time = t->site.rig.time;
    qsort(out->steps, out->count, sizeof *out->steps, by_size);
    return vbss_scene_get_statistics(t->site.rig.scene, &out->scene, sizeof out->scene);
}

vbss_result pass_run(const pass_options *o, pass_outcome *out)
{
    static stitch t;
    char note[64];
    double *steps = out->steps;
    *out = (pass_outcome){.steps = steps, .painted = true};
    stitch_plan plan;
    stitch_plan_usual(&plan);
    vbss_result result = stitch_create(&t, o->seed, &plan);
    snprintf(note, sizeof note, "vbss needle pass seed %lu", (unsigned long)o->seed);
    result = result ? result : throw_rig_begin(&t.site.rig, o->log, note);
    result = result ? result : pass(&t, o, out);
    result = result ? result : read_outcome(&t, out);
    throw_rig_destroy(&t.site.rig);
    return result;
}
