#include "live.h"

#include <stdio.h>
#include <string.h>

#include "exercise/practice.h"

#define STEP 1e-3

enum { NOTE = 64 };

static const live_scene scenes[] = {
    {"throw",
     "a thread that stands up from a drain, to tie a throw",
     "vbss throw single seed",
     {{0.0F, 0.0F, 0.012F}, 0.0F, 0.12F}},
    {"needle",
     "a needle with a short thread on the floor, beside a drain",
     "vbss needle pass seed",
     {{0.012F, 0.0F, 0.0F}, 0.0F, 0.10F}},
    {"stitch",
     "the whole task: needle, drain, 150 mm of thread",
     "vbss surgeon seed",
     {{0.012F, 0.0F, 0.0F}, 0.0F, 0.10F}},
    {"stitch-120",
     "the same with a thread of 120 segments, for a slow machine",
     "vbss surgeon 120 seed",
     {{0.012F, 0.0F, 0.0F}, 0.0F, 0.10F}},
    {"stitch-60",
     "the same with 60 segments",
     "vbss surgeon 60 seed",
     {{0.012F, 0.0F, 0.0F}, 0.0F, 0.10F}},
};

const live_scene *live_at(size_t number)
{
    return number < sizeof scenes / sizeof *scenes ? &scenes[number] : NULL;
}

const live_scene *live_find(const char *name)
{
    for (size_t i = 0; live_at(i) != NULL; i++) {
        if (strcmp(scenes[i].name, name) == 0) {
            return &scenes[i];
        }
    }
    return NULL;
}

/* ---- made */

/* Steps go through the session then. */
static vbss_result begin_task(live *l)
{
    throw_rig *s = l->stage.rig;
    if (l->stage.tasked == NULL) {
        return VBSS_OK;
    }
    const task_plan plan = {.coaching = true};
    TRY(task_create_as(&l->stage.task, l->stage.tasked, s->record, NULL, &plan));
    s->session = l->stage.task.session;
    return VBSS_OK;
}

bool live_by_device(const live *l, int side)
{
    return l->arms != NULL && arms_device(l->arms, side) != NULL;
}

static vbss_result begin_hand(live *l, int side)
{
    vbss_grasper_state tool;
    TRY(vbss_grasper_get_state(l->stage.graspers[side], &tool, sizeof tool));
    grip_begin(&l->grips[side], tool.target_position);
    return mouse_hand_create(&l->hands[side], l->stage.context, l->stage.graspers[side]);
}

static void begin(live *l, const live_scene *scene, arms *a)
{
    memset(l, 0, sizeof *l);
    l->scene = scene;
    l->view = scene->view;
    l->arms = a;
    l->active = live_by_device(l, RIGHT) && !live_by_device(l, LEFT) ? LEFT : RIGHT;
}

vbss_result live_take_over(live *l, const live_scene *scene, arms *a, stitch *t, const task *k)
{
    begin(l, scene, a);
    stage_watch(&l->stage, t, k);
    TRY(begin_hand(l, LEFT));
    return begin_hand(l, RIGHT);
}

vbss_result live_create(live *l, const live_scene *scene, unsigned long seed, arms *a,
                        const char *log)
{
    char note[NOTE];
    begin(l, scene, a);
    snprintf(note, sizeof note, "%s %lu", scene->note, seed);
    TRY(stage_create(&l->stage, note, strlen(note)));
    TRY(throw_rig_begin(l->stage.rig, log, note));
    TRY(begin_hand(l, LEFT));
    TRY(begin_hand(l, RIGHT));
    if (l->stage.tasked != NULL) {
        TRY(live_show_tools(l));
    }
    return begin_task(l);
}

vbss_result live_create_exercise(live *l, vbss_session_exercise exercise,
                                 const start_states *states, arms *a, const char *log)
{
    char note[PRACTICE_NOTE];
    begin(l, live_find("stitch"), a);
    practice_note(exercise, note);
    TRY(stage_create(&l->stage, note, strlen(note)));
    TRY(practice_begin(&l->stage.task, l->stage.tasked, exercise, states));
    TRY(practice_record(&l->stage.task, l->stage.rig, exercise, log));
    TRY(begin_hand(l, LEFT));
    TRY(begin_hand(l, RIGHT));
    return live_show_tools(l);
}

/* ---- a step */

static vbss_result report_tool(const live *l, int side, const double at[3], const double turned[4],
                               double opening)
{
    vbss_grasper *tool = l->stage.graspers[side];
    TRY(vbss_grasper_set_target(tool, at, turned));
    return vbss_grasper_set_opening(tool, opening);
}

/* ---- aids */

vbss_result live_toggle_aid(live *l, uint32_t aid)
{
    vbss_session_assistance a;
    if (l->stage.rig->session == NULL) {
        return VBSS_OK;
    }
    TRY(vbss_session_assistance_init(&a, sizeof a));
    l->aids ^= aid;
    l->aided = true;
    a.aids = l->aids;
    return vbss_session_set_assistance(l->stage.rig->session, &a);
}

vbss_result live_exchange(live *l, int side)
{
    vbss_grasper *grasper = l->stage.graspers[side];
    vbss_grasper_state tool;
    TRY(vbss_grasper_get_state(grasper, &tool, sizeof tool));
    return vbss_grasper_exchange(grasper, tool.kind == VBSS_GRASPER_KIND_SHEARS
                                              ? VBSS_GRASPER_KIND_NEEDLE_DRIVER
                                              : VBSS_GRASPER_KIND_SHEARS);
}

static vbss_result give_hand(const live *l, int side, const double at[3], const double turned[4],
                             double opening, bool is_origin)
{
    vbss_session_hand input;
    TRY(vbss_session_hand_init(&input, sizeof input));
    memcpy(input.position, at, sizeof input.position);
    memcpy(input.orientation, turned, sizeof input.orientation);
    input.opening = opening;
    input.is_origin = is_origin;
    return vbss_session_move_hand(l->stage.rig->session, side, &input);
}

/* The mouse turns a tool about the axes that this has now, whatever the aids have made of its turns. Its desk has no edge: the path of a
 * mouse that winds is longer than the reach of a tool. */
static vbss_result lead_aided_mouse(live *l, int side)
{
    mouse_hand *m = &l->hands[side];
    vbss_grasper_state tool;
    TRY(vbss_grasper_get_state(l->stage.graspers[side], &tool, sizeof tool));
    if (l->steps > 0) {
        memcpy(m->sample.orientation, tool.target_orientation, sizeof m->sample.orientation);
        mouse_hand_centre(m);
        TRY(give_hand(l, side, m->in.position, m->sample.orientation, m->in.jaw, true));
    }
    TRY(mouse_hand_read(m, l->time));
    return give_hand(l, side, m->in.position, m->in.orientation, m->in.jaw, false);
}

/* ---- hands */

static vbss_result send_target(live *l, int side, const double at[3], const double turned[4],
                               double opening)
{
    return l->aided ? give_hand(l, side, at, turned, opening, false)
                    : report_tool(l, side, at, turned, opening);
}

/* Of devices: the begin of the step, as logs have it. */
static double device_clock(const live *l)
{
    return arms_clock(l->arms, STEP * (double)l->steps);
}

static vbss_result lead(live *l, int side)
{
    mouse_hand *m = &l->hands[side];
    grip *g = &l->grips[side];
    bool known = true;
    if (!live_by_device(l, side)) {
        if (l->aided) {
            return lead_aided_mouse(l, side);
        }
        TRY(mouse_hand_read(m, l->time));
        return report_tool(l, side, m->in.position, m->in.orientation, m->in.jaw);
    }
    TRY(grip_read(g, arms_device(l->arms, side), device_clock(l), STEP, &known));
    return known ? send_target(l, side, g->reported, g->in.orientation, g->jaw) : VBSS_OK;
}

static vbss_result feel(live *l, int side)
{
    vbss_grasper_state tool;
    if (!live_by_device(l, side)) {
        return VBSS_OK;
    }
    TRY(vbss_grasper_get_state(l->stage.graspers[side], &tool, sizeof tool));
    double late = grip_late(l->stage.rig->scene, STEP);
    return grip_write(&l->grips[side], arms_device(l->arms, side), device_clock(l), &tool, late);
}

static vbss_result let_go(live *l)
{
    vbss_grasper_state state;
    if (l->stage.rig->support == 0) {
        return VBSS_OK;
    }
    TRY(vbss_grasper_get_state(l->stage.graspers[RIGHT], &state, sizeof state));
    return state.grasp_count > 0 ? throw_rig_release_limb(l->stage.rig) : VBSS_OK;
}

vbss_result live_step(live *l)
{
    l->time = STEP * (double)(l->steps + 1);
    TRY(lead(l, LEFT));
    TRY(lead(l, RIGHT));
    TRY(throw_rig_advance(l->stage.rig, STEP));
    TRY(feel(l, LEFT));
    TRY(feel(l, RIGHT));
    l->steps++;
    return let_go(l);
}

vbss_result live_end(live *l)
{
    return throw_rig_end(l->stage.rig);
}

void live_destroy(live *l)
{
    stage_destroy(&l->stage);
}
