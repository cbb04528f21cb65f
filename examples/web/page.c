#include "page.h"

#include <string.h>

#include "session.h"

static page_session session;

page_session *page_get(void)
{
    return &session;
}

stage *page_stage(page_session *p)
{
    return p->plays ? &p->player.stage : &p->live.stage;
}

/* ---- made */

void page_clear(page_session *p)
{
    if (p->plays) {
        player_close(&p->player);
    } else if (p->there) {
        live_destroy(&p->live);
    }
    tracked_reset();
    memset(p, 0, sizeof *p);
    p->aspect = 1.0F;
}

static vbss_result begin_picture(page_session *p)
{
    vbss_visual_config c;
    TRY(vbss_visual_config_init(&c, sizeof c));
    TRY(vbss_visual_create(page_stage(p)->context, &c, &p->visual));
    return vbss_visual_add_scene(p->visual, page_stage(p)->scene, NULL);
}

vbss_result page_complete(page_session *p, vbss_result made)
{
    const vbss_result result = made == VBSS_OK ? begin_picture(p) : made;
    p->there = true;
    if (result != VBSS_OK) {
        page_clear(p);
        return result;
    }
    const live_view *view = &p->live.view;
    page_set_camera((double)view->aside, (double)CAMERA_DOWN, (double)view->away, 1.0);
    return VBSS_OK;
}

int32_t page_begin(int32_t scene, uint32_t seed)
{
    page_session *p = &session;
    const live_scene *known = scene >= 0 ? live_at((size_t)scene) : NULL;
    if (known == NULL) {
        return VBSS_ERROR_OUT_OF_RANGE;
    }
    page_clear(p);
    return page_complete(p, live_create(&p->live, known, seed, tracked_arms(), PAGE_LOG));
}

int32_t page_end(void)
{
    return session.there && !session.plays ? live_end(&session.live) : VBSS_ERROR_WRONG_STATE;
}

int32_t page_step(int32_t count)
{
    if (!session.there) {
        return VBSS_ERROR_WRONG_STATE;
    }
    if (session.plays) {
        return page_play(&session, count);
    }
    for (int32_t i = 0; i < count; i++) {
        TRY(session.script != NULL ? session.script() : live_step(&session.live));
    }
    return VBSS_OK;
}

const char *page_problem(void)
{
    const char *text = "";
    if (page_stage(&session)->context != NULL) {
        (void)vbss_context_get_last_error(page_stage(&session)->context, NULL, &text);
    }
    return text;
}

uint64_t page_scene_hash(void)
{
    uint64_t hash = 0;
    if (session.there) {
        (void)vbss_scene_get_hash(page_stage(&session)->scene, &hash);
    }
    return hash;
}

uint64_t page_session_hash(void)
{
    uint64_t hash = 0;
    if (session.there && page_stage(&session)->task.session != NULL) {
        (void)vbss_session_get_hash(page_stage(&session)->task.session, &hash);
    }
    return hash;
}

/* ---- mouse and keys */

static bool has_side(int32_t side)
{
    return session.there && !session.plays && side >= 0 && side < SIDES;
}

void page_move(int32_t side, int32_t turns, double right, double up, double away)
{
    if (has_side(side)) {
        mouse_hand_move(&session.live.hands[side], turns != 0, right, up, away);
    }
}

void page_close(int32_t side, int32_t closes)
{
    if (has_side(side)) {
        session.live.hands[side].closes = closes != 0;
    }
}

void page_pull(int32_t side, double right, double up, double away, double nod, double turn,
               double roll, double grain)
{
    const double axes[6] = {right, up, away, nod, turn, roll};
    if (has_side(side)) {
        mouse_hand_pull(&session.live.hands[side], axes, grain);
    }
}

int32_t page_clutch(int32_t side, int32_t held)
{
    return has_side(side) ? mouse_hand_clutch(&session.live.hands[side], held != 0)
                          : VBSS_ERROR_OUT_OF_RANGE;
}

int32_t page_exchange(int32_t side)
{
    vbss_grasper_state tool;
    if (!has_side(side)) {
        return VBSS_ERROR_OUT_OF_RANGE;
    }
    vbss_grasper *grasper = session.live.stage.graspers[side];
    TRY(vbss_grasper_get_state(grasper, &tool, sizeof tool));
    return vbss_grasper_exchange(grasper, tool.kind == VBSS_GRASPER_KIND_SHEARS
                                              ? VBSS_GRASPER_KIND_NEEDLE_DRIVER
                                              : VBSS_GRASPER_KIND_SHEARS);
}

vbss_result page_take_mouse(page_session *p, int side)
{
    mouse_hand *m = &p->live.hands[side];
    TRY(vbss_device_destroy(m->device));
    TRY(mouse_hand_create(m, p->live.stage.context, p->live.stage.graspers[side]));
    mouse_hand_set_camera(m, &p->camera);
    return VBSS_OK;
}
