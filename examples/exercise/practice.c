#include "exercise/practice.h"

#include <stdio.h>
#include <string.h>

#define MILLI 1e3
#define DEGREES 57.29577951308232

vbss_session_exercise practice_named(const char *name)
{
    for (vbss_session_exercise e = 1; e < VBSS_SESSION_EXERCISE_COUNT; e++) {
        if (strcmp(name, vbss_session_exercise_name(e)) == 0) {
            return e;
        }
    }
    return VBSS_SESSION_EXERCISE_NONE;
}

start_place practice_place(vbss_session_exercise exercise)
{
    static const start_place places[VBSS_SESSION_EXERCISE_COUNT] = {
        START_NEW, START_NEW, START_HELD, START_STITCHED, START_STITCHED, START_SECOND, START_TIED};
    return places[exercise];
}

void practice_note(vbss_session_exercise exercise, char note[PRACTICE_NOTE])
{
    snprintf(note, PRACTICE_NOTE, "vbss exercise %s seed 0", vbss_session_exercise_name(exercise));
}

/* ---- the session */

vbss_result practice_follow(task *k, const stitch *t, vbss_session_exercise exercise,
                            vbss_replay *replay)
{
    const task_plan plan = {.coaching = true, .exercise = exercise};
    return task_create_as(k, t, NULL, replay, &plan);
}

vbss_result practice_begin(task *k, const stitch *t, vbss_session_exercise exercise,
                           const start_states *states)
{
    start_place place = practice_place(exercise);
    const start_state *state = states != NULL ? &states->at[place] : NULL;
    if (place == START_NEW) {
        return practice_follow(k, t, exercise, NULL);
    }
    if (state == NULL || state->scene == NULL) {
        return VBSS_ERROR_NOT_FOUND;
    }
    TRY(vbss_scene_restore(t->site.rig.scene, state->scene, state->scene_bytes));
    TRY(practice_follow(k, t, exercise, NULL));
    return vbss_session_begin_at(k->session, state->session, state->session_bytes);
}

vbss_result practice_record(const task *k, throw_rig *rig, vbss_session_exercise exercise,
                            const char *log)
{
    char note[PRACTICE_NOTE];
    practice_note(exercise, note);
    TRY(throw_rig_begin(rig, log, note));
    rig->session = k->session;
    return vbss_session_set_record(k->session, rig->record);
}

/* ---- words */

static void put_number(char *text, size_t bytes, const vbss_session_measure *m, double value)
{
    switch (m->kind) {
    case VBSS_SESSION_MEASURE_TIME:
        snprintf(text, bytes, "%.1f s", value);
        break;
    case VBSS_SESSION_MEASURE_GRASP_ANGLE:
    case VBSS_SESSION_MEASURE_ENTRY_ANGLE:
        snprintf(text, bytes, "%.0f degrees", DEGREES * value);
        break;
    case VBSS_SESSION_MEASURE_DEVIATION:
    case VBSS_SESSION_MEASURE_GAP:
    case VBSS_SESSION_MEASURE_SHORT_TAIL:
    case VBSS_SESSION_MEASURE_LONG_TAIL:
        snprintf(text, bytes, "%.2f mm", MILLI * value);
        break;
    case VBSS_SESSION_MEASURE_TENSION:
        snprintf(text, bytes, "%.2f N", value);
        break;
    case VBSS_SESSION_MEASURE_GRASP_SHARE:
        snprintf(text, bytes, "%.2f", value);
        break;
    default:
        snprintf(text, bytes, "%.0f", value);
        break;
    }
}

void practice_words(const vbss_session_measure *m, char words[PRACTICE_LINE])
{
    char value[24] = "not known", low[24], high[24];
    if (m->is_known != 0) {
        put_number(value, sizeof value, m, m->value);
    }
    put_number(low, sizeof low, m, m->low);
    put_number(high, sizeof high, m, m->high);
    if (m->low == m->high) {
        snprintf(words, PRACTICE_LINE, "%s: %s, wanted %s", m->name, value, high);
    } else if (m->low == 0.0) {
        snprintf(words, PRACTICE_LINE, "%s: %s, at most %s", m->name, value, high);
    } else {
        snprintf(words, PRACTICE_LINE, "%s: %s, wanted %s to %s", m->name, value, low, high);
    }
}
