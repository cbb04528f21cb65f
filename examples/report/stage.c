#include "report/stage.h"

#include <stdio.h>
#include <string.h>

#include "exercise/practice.h"
#include "surgeon/surgeon.h"
#include "throw/trial.h"

/* ---- notes */

enum { MAX_WORDS = 96 };

/* "vbss throw surgeons seed 2" and nothing else; "vbss surgeon seed 2", whose kind is empty, or "vbss surgeon 120 seed 2", whose
 * thread has so many segments, or "vbss surgeon left seed 2", who is left-handed. */
typedef struct words {
    char program[16], kind[32];
    unsigned long seed;
} words;

static bool read_note(const void *note, size_t count, words *w)
{
    char text[MAX_WORDS];
    int end = 0;
    memset(w, 0, sizeof *w);
    if (count == 0 || count >= sizeof text || memchr(note, '\0', count) != NULL) {
        return false;
    }
    memcpy(text, note, count);
    text[count] = '\0';
    int got = sscanf(text, "vbss %15s %31s seed %10lu%n", w->program, w->kind, &w->seed, &end);
    if (got != 3) {
        w->kind[0] = '\0';
        got = 1 + sscanf(text, "vbss %15s seed %10lu%n", w->program, &w->seed, &end);
    }
    return got == 3 && end == (int)count;
}

static bool is_throw(const words *w)
{
    return strcmp(w->program, "throw") == 0 && trial_kind_of(w->kind) < TRIAL_KINDS;
}

static bool is_stitch(const words *w)
{
    return strcmp(w->program, "needle") == 0 && strcmp(w->kind, "pass") == 0;
}

/* Of a surgeon's thread; 0: as the surgeon has it. */
static uint32_t segments_of(const words *w)
{
    return strcmp(w->kind, "120") == 0 ? 120 : strcmp(w->kind, "60") == 0 ? 60 : 0;
}

static bool is_left_handed(const words *w)
{
    return strcmp(w->kind, "left") == 0;
}

static bool is_surgeon(const words *w)
{
    return strcmp(w->program, "surgeon") == 0 &&
           (w->kind[0] == '\0' || segments_of(w) > 0 || is_left_handed(w));
}

static bool is_exercise(const words *w)
{
    return strcmp(w->program, "exercise") == 0 && w->seed == 0 &&
           practice_named(w->kind) != VBSS_SESSION_EXERCISE_NONE;
}

/* Its bodies are added as it goes on, which a log has all of. */
static bool is_pad(const words *w)
{
    return strcmp(w->program, "pad") == 0 && w->kind[0] == '\0';
}

bool stage_knows(const void *note, size_t count)
{
    words w;
    return read_note(note, count, &w) &&
           (is_throw(&w) || is_stitch(&w) || is_surgeon(&w) || is_exercise(&w) || is_pad(&w));
}

/* ---- scenes */

static vbss_result make_throw(stage *s, const words *w)
{
    static throw_rig st;
    static hand hands[SIDES]; /* for their tools */
    const trial_options o = {.kind = (trial_kind)trial_kind_of(w->kind), .seed = w->seed};
    memset(&st, 0, sizeof st);
    s->name = "two hands that tie a knot (examples/throw)";
    s->rig = &st;
    vbss_result result = trial_set_up(&o, &st, hands);
    s->graspers[LEFT] = hands[LEFT].grasper;
    s->graspers[RIGHT] = hands[RIGHT].grasper;
    return result;
}

static void show_stitch(stage *s, const stitch *t)
{
    s->graspers[LEFT] = stitch_hand(t, SITE_LEFT)->grasper;
    s->graspers[RIGHT] = stitch_hand(t, SITE_RIGHT)->grasper;
    s->drain = t->site.drain;
    s->tube = t->site.tube;
    s->needle = t->site.needle_body;
}

static const char surgeon_name[] = "a scripted surgeon (examples/surgeon)";

static vbss_result make_stitch(stage *s, const words *w)
{
    static stitch t;
    const surgeon_options usual = {
        .seed = w->seed, .segments = segments_of(w), .left_handed = is_left_handed(w)};
    stitch_plan plan;
    memset(&t, 0, sizeof t);
    s->rig = &t.site.rig;
    if (is_surgeon(w) || is_exercise(w)) {
        s->name = is_exercise(w) ? "an exercise (examples/exercise)" : surgeon_name;
        s->exercise = is_exercise(w) ? practice_named(w->kind) : VBSS_SESSION_EXERCISE_NONE;
        s->tasked = &t;
        surgeon_plan(&usual, &plan);
    } else {
        s->name = "two hands that pass a needle (examples/needle)";
        stitch_plan_usual(&plan);
    }
    vbss_result result = stitch_create(&t, w->seed, &plan);
    show_stitch(s, &t);
    s->spacing = THREAD_LENGTH / plan.site.segments;
    return result;
}

void stage_watch(stage *s, stitch *t, const task *k)
{
    memset(s, 0, sizeof *s);
    s->name = surgeon_name;
    s->rig = &t->site.rig;
    s->context = s->rig->context;
    s->scene = s->rig->scene;
    s->tasked = t;
    s->task = *k;
    show_stitch(s, t);
    s->spacing = SEGMENT;
}

vbss_result stage_create(stage *s, const void *note, size_t count)
{
    words w;
    memset(s, 0, sizeof *s);
    if (!read_note(note, count, &w)) {
        return VBSS_ERROR_OUT_OF_RANGE;
    }
    if (is_pad(&w)) {
        s->name = "a pad of skin that two hands sew (examples/pad)";
        return vbss_context_create(NULL, &s->context);
    }
    vbss_result result = is_throw(&w) ? make_throw(s, &w) : make_stitch(s, &w);
    s->context = s->rig->context;
    s->scene = s->rig->scene;
    return result;
}

vbss_result stage_begin(stage *s, vbss_replay *replay, const uint32_t tools[SIDES])
{
    if (s->rig != NULL) {
        return vbss_replay_begin(replay, s->scene);
    }
    TRY(vbss_replay_load_scene(replay, &s->scene));
    for (int side = 0; side < SIDES; side++) {
        TRY(tools[side] != 0 ? vbss_scene_get_grasper(s->scene, tools[side], &s->graspers[side])
                             : VBSS_OK);
    }
    return VBSS_OK;
}

void stage_destroy(stage *s)
{
    if (s->rig != NULL) {
        throw_rig_destroy(s->rig);
    } else if (s->context != NULL) {
        (void)vbss_context_destroy(s->context);
    }
}

vbss_result stage_follow(stage *s)
{
    return s->rig != NULL ? throw_rig_follow(s->rig) : VBSS_OK;
}

vbss_result stage_follow_task(stage *s, vbss_replay *replay)
{
    const task_plan plan = {.coaching = true}; /* whatever the log's did: its hashes do not tell */
    if (s->exercise != VBSS_SESSION_EXERCISE_NONE) {
        return practice_follow(&s->task, s->tasked, s->exercise, replay);
    }
    return s->tasked != NULL ? task_create_as(&s->task, s->tasked, NULL, replay, &plan) : VBSS_OK;
}

vbss_result stage_step(stage *s, vbss_replay *replay, vbss_replay_report *report, bool *agrees)
{
    if (s->task.session != NULL) {
        vbss_session_status status;
        vbss_result result = vbss_session_step(s->task.session, 0.0, 0.0);
        TRY(vbss_session_get_status(s->task.session, &status, sizeof status));
        if (status.steps > report->step) { /* the scene's step was made, and agrees */
            report->step++;
            *agrees = result == VBSS_OK;
            return *agrees ? VBSS_OK : task_destroy(&s->task);
        }
    }
    return vbss_replay_step(replay, report, sizeof *report); /* or where it is, once more */
}

/* ---- the knot */

/* Laid out through two marks. */
static void show_laid(const stage *s, vbss_knot_input *in)
{
    const vec *x = throw_rig_nodes(s->rig);
    in->points = &x[0].x;
    in->point_count = s->rig->nodes;
    in->hole_count = 2;
    for (int i = 0; i < 2; i++) {
        v_store(in->holes[i], x[s->rig->marks[i]]);
        in->hole_places[i] = s->rig->marks[i];
    }
    in->away[2] = -1.0;
}

/* The piece of thread that goes through two holes, the tail's first; 0: there is none. Its nodes are equally far
 * apart from the needle on. */
static uint32_t show_holes(const stage *s, vbss_knot_input *in)
{
    vbss_scene_hole all[2];
    uint32_t count = 0;
    for (uint32_t i = 0; count < 2; i++) {
        if (vbss_scene_get_hole(s->scene, i, &all[count], sizeof all[count]) != VBSS_OK) {
            return 0;
        }
        count += all[count].thread != 0;
    }
    int tail = all[0].arc_length > all[1].arc_length ? 0 : 1;
    for (int i = 0; i < 2; i++) {
        const vbss_scene_hole *hole = &all[i == 0 ? tail : 1 - tail];
        memcpy(in->holes[i], hole->position, sizeof hole->position);
        in->hole_places[i] = hole->arc_length / s->spacing;
    }
    in->hole_count = 2;
    in->away[2] = -1.0;
    return all[0].thread == all[1].thread ? all[0].thread : 0;
}

/* Sewn, from the needle on; without holes nothing is tied. */
static vbss_result show_sewn(const stage *s, vbss_knot_input *in)
{
    vbss_thread *thread = s->rig->thread;
    vbss_view view;
    uint32_t piece = show_holes(s, in);
    in->reversed = 1;
    if (piece == 0) {
        in->hole_count = 0;
    } else {
        TRY(vbss_scene_get_thread(s->scene, piece, &thread));
    }
    TRY(vbss_thread_get_view(thread, VBSS_THREAD_VIEW_POSITIONS, &view, sizeof view));
    in->points = view.data;
    in->point_count = (uint32_t)view.count;
    return VBSS_OK;
}

/* The thread alone, whatever the tools hold. */
vbss_result stage_judge(stage *s, reading *r)
{
    vbss_knot_input in;
    if (s->detector == NULL) {
        TRY(vbss_knot_detector_create(s->context, NULL, &s->detector));
    }
    TRY(vbss_knot_input_init(&in, sizeof in));
    if (s->drain == NULL) {
        show_laid(s, &in);
    } else {
        TRY(show_sewn(s, &in));
    }
    TRY(vbss_knot_detector_judge(s->detector, &in));
    TRY(vbss_knot_detector_get_state(s->detector, &r->state, sizeof r->state));
    for (uint32_t i = 0; i < r->state.throw_count && i < MAX_THROWS; i++) {
        TRY(vbss_knot_detector_get_throw(s->detector, i, &r->throws[i], sizeof r->throws[i]));
    }
    return vbss_knot_detector_get_notation(s->detector, r->notation, sizeof r->notation);
}
