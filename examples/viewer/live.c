#include "live.h"

#include <string.h>

#define STEP 1e-3

static const live_scene scenes[] = {
    {"throw",
     "a thread that stands up from a drain, to tie a throw",
     "vbss throw single seed 0",
     {0.0F, 0.0F, 0.012F},
     0.0F,
     0.12F},
    {"needle",
     "a needle with a short thread on the floor, beside a drain",
     "vbss needle pass seed 0",
     {0.012F, 0.0F, 0.0F},
     0.0F,
     0.10F},
    {"stitch",
     "the whole task: needle, drain, 150 mm of thread",
     "vbss surgeon seed 0",
     {0.012F, 0.0F, 0.0F},
     0.0F,
     0.10F},
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
    stand *s = l->stage.stand;
    if (l->stage.tasked == NULL) {
        return VBSS_OK;
    }
    TRY(task_create(&l->stage.task, l->stage.tasked, s->record, NULL));
    s->session = l->stage.task.session;
    return VBSS_OK;
}

vbss_result live_create(live *l, const live_scene *scene, const char *log)
{
    memset(l, 0, sizeof *l);
    l->scene = scene;
    l->active = RIGHT;
    TRY(stage_create(&l->stage, scene->note, strlen(scene->note)));
    TRY(stand_begin(l->stage.stand, log, scene->note));
    for (int side = 0; side < SIDES; side++) {
        TRY(mouse_hand_create(&l->hands[side], l->stage.context, l->stage.graspers[side]));
    }
    return begin_task(l);
}

/* ---- a step */

static vbss_result lead(live *l, int side)
{
    mouse_hand *m = &l->hands[side];
    vbss_record *record = l->stage.stand->record;
    TRY(mouse_hand_read(m, l->time));
    TRY(vbss_record_move_grasper(record, m->body, m->in.position, m->in.orientation));
    return vbss_record_set_opening(record, m->body, m->in.jaw);
}

static vbss_result let_go(live *l)
{
    vbss_grasper_state state;
    if (l->stage.stand->support == 0) {
        return VBSS_OK;
    }
    TRY(vbss_grasper_get_state(l->stage.graspers[RIGHT], &state, sizeof state));
    return state.grasp_count > 0 ? stand_let_go(l->stage.stand) : VBSS_OK;
}

vbss_result live_step(live *l)
{
    l->time = STEP * (double)(l->steps + 1);
    TRY(lead(l, LEFT));
    TRY(lead(l, RIGHT));
    TRY(stand_step(l->stage.stand, STEP));
    l->steps++;
    return let_go(l);
}

vbss_result live_end(live *l)
{
    return stand_end(l->stage.stand);
}

void live_destroy(live *l)
{
    stage_destroy(&l->stage);
}
