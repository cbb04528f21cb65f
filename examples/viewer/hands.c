/* A scene in a window, under two hands of one mouse. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "exercise/practice.h"
#include "exercise/progress.h"
#include "exercise/starts.h"
#include "playing.h"

#define MAX_STEPS 50 /* a frame: what takes longer is slow motion */
#define MICRO 1e6

/* ---- steps */

/* So many that the scene's time goes as fast as the clock, unless that is too many. */
static int count_steps(playing *p, double elapsed)
{
    if (p->paused && !p->once) {
        return 0;
    }
    p->once = false;
    if (p->o->frame_steps > 0) {
        return p->o->frame_steps;
    }
    return (int)fmin(fmax(floor(elapsed * 1e3 + 0.5), 1.0), MAX_STEPS);
}

static vbss_result make_steps(playing *p, int count)
{
    double longest = 0.0;
    for (int i = 0; i < count; i++) {
        const double begin = show_clock();
        TRY(live_step(&p->live));
        longest = fmax(longest, show_clock() - begin);
    }
    if (count > 0) {
        show_time(&p->show, (float)(MICRO * longest));
    }
    return VBSS_OK;
}

/* ---- a frame */

static void step_camera(playing *p, double elapsed)
{
    if (orbit_step(&p->orbit, &p->window, (float)fmin(elapsed, 0.1))) {
        p->show.camera = orbit_camera(&p->orbit);
        mouse_hand_set_camera(&p->live.hands[LEFT], &p->show.camera);
        mouse_hand_set_camera(&p->live.hands[RIGHT], &p->show.camera);
    }
}

/* A script may want fewer pictures than there are frames. */
static bool draw(playing *p)
{
    if (p->live.time < p->next) {
        return true;
    }
    p->next = p->live.time + p->o->every;
    p->window.give_up = p->o->renew > 0 && p->frames == (uint64_t)p->o->renew;
    if (!window_ready(&p->window, &p->show) || !show_draw(&p->show, p->live.time)) {
        return false;
    }
    captions_put(p);
    return window_show(&p->window, &p->show);
}

static vbss_result go_on(playing *p)
{
    const double now = window_clock(), elapsed = now - p->clock;
    p->clock = now;
    step_camera(p, elapsed);
    TRY(person_pull(p, p->o->frame_steps > 0 ? 1e-3 * p->o->frame_steps : fmin(elapsed, 0.1)));
    const int count = count_steps(p, elapsed);
    p->real_time_factor += 0.05 * (1e-3 * count / fmax(elapsed, 1e-3) - p->real_time_factor);
    TRY(make_steps(p, count));
    return ghosts_step(p, 1e-3 * count);
}

/* ---- a session */

static vbss_result create(playing *p, const live_scene *scene)
{
    const options *o = p->o;
    p->noted = false;
    return o->exercise != NULL ? live_create_exercise(&p->live, practice_named(o->exercise),
                                                      &p->states, p->arms, o->keep)
                               : live_create(&p->live, scene, o->seed, p->arms, o->keep);
}

/* Counts the exercise once, when it has its outcome. */
static void note_outcome(playing *p)
{
    vbss_session_exercise_state e;
    progress all;
    if (p->noted || p->o->exercise == NULL || p->o->progress == NULL ||
        vbss_session_get_exercise(p->live.stage.task.session, &e, sizeof e) != VBSS_OK ||
        e.outcome == VBSS_SESSION_OUTCOME_NONE) {
        return;
    }
    p->noted = true;
    if (progress_note(p->o->progress, &e, &all, p->progress, sizeof p->progress)) {
        const progress_row *row = &all.rows[e.exercise];
        snprintf(p->progress, sizeof p->progress, "%u of %u passed, %u without aids", row->passed,
                 row->attempts, row->unaided);
    } else {
        fprintf(stderr, "viewer: %s; the file stays as it is\n", p->progress);
    }
}

static bool succeeds(const playing *p, vbss_result result)
{
    const char *text = "";
    if (result != VBSS_OK) {
        (void)vbss_context_get_last_error(p->live.stage.context, NULL, &text);
        fprintf(stderr, "viewer: %s: %s\n", vbss_result_string(result), text);
    }
    return result == VBSS_OK;
}

static bool begin(playing *p)
{
    const live_scene *scene = live_find(p->o->live);
    if (p->arms != NULL && !arms_open(p->arms)) {
        return false;
    }
    const vbss_result result = create(p, scene);
    if (result != VBSS_OK) {
        fprintf(stderr, "viewer: %s: %s\n", scene->name, vbss_result_string(result));
        if (p->o->exercise != NULL) {
            fprintf(stderr, "viewer: `exercise_starts FILE` makes the file for --starts\n");
        }
        return false;
    }
    orbit_begin(&p->orbit, p->live.view.target, p->live.view.aside, p->live.view.away);
    p->show.camera = orbit_camera(&p->orbit);
    mouse_hand_set_camera(&p->live.hands[LEFT], &p->show.camera);
    mouse_hand_set_camera(&p->live.hands[RIGHT], &p->show.camera);
    p->again = false;
    p->next = 0.0;
    p->real_time_factor = 1.0;
    p->clock = window_clock();
    return show_stage(&p->show, &p->live.stage) && succeeds(p, ghosts_begin(p));
}

static bool play(playing *p)
{
    while (!p->again && window_listen(&p->window, &p->desk)) {
        if (p->o->lockstep != 0 && !reporting_grants(p)) {
            continue;
        }
        if (!succeeds(p, go_on(p))) {
            return false;
        }
        note_outcome(p);
        if (!draw(p)) {
            return false;
        }
        p->frames++;
        if (p->o->report != 0) {
            reporting_frame(p);
        }
    }
    return true;
}

static bool play_sessions(playing *p)
{
    bool good;
    do {
        good = begin(p) && play(p) && live_end(&p->live) == VBSS_OK;
        if (p->arms != NULL) {
            arms_shut(p->arms);
        }
        live_destroy(&p->live);
    } while (good && p->again);
    return good;
}

int mode_live(const options *o)
{
    static playing p;
    p.o = o;
    p.desk = person_desk(&p);
    if (live_find(o->live) == NULL) {
        fprintf(stderr, "viewer: there is no scene %s; there are\n", o->live);
        for (size_t i = 0; live_at(i) != NULL; i++) {
            fprintf(stderr, "  %-8s %s\n", live_at(i)->name, live_at(i)->what);
        }
        return 2;
    }
    if (o->exercise != NULL && practice_named(o->exercise) == VBSS_SESSION_EXERCISE_NONE) {
        fprintf(stderr, "viewer: there is no exercise %s\n", o->exercise);
        return 2;
    }
    char why[300];
    if (o->starts != NULL && !starts_read(&p.states, o->starts, why, sizeof why)) {
        fprintf(stderr, "viewer: %s\n", why);
        return 2;
    }
    if (!ghosts_read(&p)) {
        return 2;
    }
    if (o->hands != NULL || o->device_words > 0) {
        p.arms = arms_read(o->device_words, (char **)o->devices, o->hands);
        if (p.arms == NULL) {
            return 2;
        }
    }
    int status = MODE_NO_OPENGL;
    if (window_begin(&p.window, &p.show, o->width, o->height, o->overlays)) {
        status = play_sessions(&p) ? 0 : 1;
        window_end(&p.window, &p.show);
    }
    arms_free(p.arms);
    starts_free(&p.states);
    ghost_track_free(&p.track);
    return status;
}
