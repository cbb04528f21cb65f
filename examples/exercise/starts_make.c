/* The scripted surgeon works through the task, and its states are saved where exercises start. */
#include <stdlib.h>
#include <string.h>

#include "exercise/starts.h"
#include "ghost/gather.h"
#include "surgeon/surgeon.h"

#define STEP 1e-3
#define SHOWN_STEPS 500
#define GHOST_STEPS 40
#define LONGEST 240.0 /* s of the task: a surgeon that has not succeeded by then will not */

enum { SEEDS = 10 };

typedef struct maker {
    surgeon surgeon;
    task task;
    start_states states; /* each in memory of its own */
    ghost_rows rows;
    bool has_ghost; /* is wanted */
} maker;

static void forget(start_states *s)
{
    for (int i = 0; i < START_PLACES; i++) {
        free(s->at[i].scene);
        free(s->at[i].session);
    }
    memset(s, 0, sizeof *s);
}

static vbss_result save(const maker *m, start_state *state)
{
    vbss_scene *scene = m->surgeon.stitch.site.rig.scene;
    vbss_session *session = m->task.session;
    (void)vbss_scene_save(scene, NULL, 0, &state->scene_bytes); /* asks for the sizes */
    (void)vbss_session_save(session, NULL, 0, &state->session_bytes);
    state->scene = malloc(state->scene_bytes);
    state->session = malloc(state->session_bytes);
    if (state->scene == NULL || state->session == NULL) {
        return VBSS_ERROR_OUT_OF_MEMORY;
    }
    TRY(vbss_scene_save(scene, state->scene, state->scene_bytes, &state->scene_bytes));
    return vbss_session_save(session, state->session, state->session_bytes, &state->session_bytes);
}

/* The place that the surgeon has reached; START_NEW: none. */
static start_place place_of(const surgeon *s, const vbss_session_status *now)
{
    if (s->stage == SURGEON_PASS && s->stitch.state == STITCH_TARGET &&
        now->phase == VBSS_SESSION_PHASE_APPROACH) {
        return START_HELD;
    }
    return s->stage == SURGEON_TIE && now->phase == VBSS_SESSION_PHASE_THROW_1      ? START_STITCHED
           : s->stage == SURGEON_SECOND && now->phase == VBSS_SESSION_PHASE_THROW_2 ? START_SECOND
           : s->stage == SURGEON_CUT && now->phase == VBSS_SESSION_PHASE_CUT        ? START_TIED
                                                                                    : START_NEW;
}

static vbss_result work(maker *m, void (*shown)(void *user, double seconds), void *user)
{
    surgeon *s = &m->surgeon;
    vbss_session_status now;
    for (uint64_t i = 0;
         m->has_ghost ? s->stage != SURGEON_DONE : m->states.at[START_TIED].scene == NULL; i++) {
        TRY(surgeon_step(s, STEP));
        TRY(vbss_session_get_status(m->task.session, &now, sizeof now));
        start_place place = place_of(s, &now);
        if (place != START_NEW && m->states.at[place].scene == NULL) {
            TRY(save(m, &m->states.at[place]));
        }
        if (m->has_ghost && i % GHOST_STEPS == 0) {
            TRY(ghost_gather(&m->rows, &s->stitch, m->task.session));
        }
        if (s->stage > SURGEON_DONE || (s->stage == SURGEON_DONE && !m->has_ghost) ||
            now.time > LONGEST) {
            return VBSS_ERROR_NOT_FOUND;
        }
        if (shown != NULL && i % SHOWN_STEPS == 0) {
            shown(user, now.time);
        }
    }
    return VBSS_OK;
}

static bool perform(maker *m, uint64_t seed, void (*shown)(void *user, double seconds), void *user)
{
    const surgeon_options o = {.seed = seed, .coaching = true};
    const task_plan plan = {.coaching = true};
    vbss_result result = surgeon_create(&m->surgeon, &o);
    if (result == VBSS_OK) {
        throw_rig *rig = &m->surgeon.stitch.site.rig;
        result = task_create_as(&m->task, &m->surgeon.stitch, rig->record, NULL, &plan);
        rig->session = m->task.session;
    }
    result = result == VBSS_OK ? work(m, shown, user) : result;
    throw_rig_destroy(&m->surgeon.stitch.site.rig);
    bool has_all = result == VBSS_OK;
    for (int i = START_NEW + 1; i < START_PLACES; i++) {
        has_all = has_all && m->states.at[i].scene != NULL;
    }
    return has_all;
}

bool starts_make(start_states *s, ghost_track *hands, void (*shown)(void *user, double seconds),
                 void *user)
{
    static maker m;
    memset(s, 0, sizeof *s);
    for (uint64_t seed = 0; seed < SEEDS; seed++) {
        memset(&m, 0, sizeof m);
        m.has_ghost = hands != NULL;
        if (perform(&m, seed, shown, user) && (hands == NULL || ghost_finish(&m.rows, hands))) {
            *s = m.states;
            return true;
        }
        ghost_rows_free(&m.rows);
        forget(&m.states);
    }
    return false;
}
