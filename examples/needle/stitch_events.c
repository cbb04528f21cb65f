/* What the step did to the needle's holes, and what follows from it. */
#include "needle/stitch_parts.h"

#define SPRINGS 0.05 /* s: so soon after it has entered the wall may spring off it */

static void punctured(stitch *t, uint32_t id)
{
    vbss_scene_hole hole;
    t->punctures++;
    if (!site_find_hole(&t->site, id, &hole)) {
        return;
    }
    int side = hole.outward ? SITE_LEFT : SITE_RIGHT;
    if (t->holes[side] != 0) {
        t->others++;
        return;
    }
    t->holes[side] = id;
    t->made[side] = hole;
    t->hole[side] = v_load(hole.position);
    if (side == SITE_RIGHT && t->state == STITCH_ENTER) {
        t->gone = hole.arc_length;
        t->entry = v_add(site_mark_at_rest(&t->site, SITE_RIGHT), t->beside);
        stitch_enter_state(t, STITCH_CROSS);
    } else if (side == SITE_LEFT && t->state >= STITCH_CROSS && t->state < STITCH_DRAW) {
        t->ahead = t->gone - hole.arc_length;
        stitch_enter_state(t, STITCH_DRAW);
    }
}

/* To the first mark, with all that was learnt of the walls forgotten. */
static void begin_again(stitch *t)
{
    t->withdraws = t->restarts = false;
    t->beside = t->trim = t->fork = v3(0.0, 0.0, 0.0);
    t->along = t->square = 0.0;
    stitch_enter_support(t, SUPPORT_AWAY);
    stitch_enter_state(t, STITCH_BRING);
}

void stitch_mend(stitch *t)
{
    if (stitch_is_out(t)) {
        begin_again(t);
    } else {
        t->withdraws = true;
        stitch_enter_state(t, STITCH_EASE);
    }
}

/* The needle is back out of the first wall. */
static void withdrawn(stitch *t)
{
    t->holes[SITE_RIGHT] = 0;
    t->punctures = 0;
    if (t->restarts || !t->withdraws) {
        stitch_set_error(t, SITE_RIGHT);
        stitch_set_error(t, SITE_LEFT);
        begin_again(t);
    }
}

/* The tip has left its hole at that side again. */
static void lose_hole(stitch *t, int side, stitch_state then)
{
    t->holes[side] = 0;
    t->punctures--;
    t->awaits_fork = false;
    t->out = side == SITE_LEFT ? 0.0 : t->out;
    stitch_enter_state(t, then);
}

/* Drawn back a little, or as the wall springs back, the needle may leave its hole in the left wall. */
static bool is_drawn_out(stitch *t, uint32_t id)
{
    const bool is = id == t->holes[SITE_LEFT];
    if (is) {
        t->back = 0.0;
        lose_hole(t, SITE_LEFT, STITCH_EASE);
        t->again++;
        stitch_restart_if_often_tried(t);
    }
    return is;
}

/* Back out of the first wall, by intention or not. */
static bool is_withdrawn(stitch *t, uint32_t id)
{
    const bool is = id == t->holes[SITE_RIGHT] && (t->mends || t->restarts || !t->withdraws);
    if (is) {
        withdrawn(t);
    }
    return is;
}

/* The wall springs back from a tip that has entered it, and now and then off it again: that goes on pressing. */
static bool sprang_off(stitch *t, uint32_t id)
{
    const int side = t->state == STITCH_DRAW ? SITE_LEFT : SITE_RIGHT;
    const bool has_just_entered = t->state == STITCH_CROSS || t->state == STITCH_DRAW;
    const bool just = has_just_entered && t->since < SPRINGS && id == t->holes[side];
    if (just) {
        lose_hole(t, side, side == SITE_RIGHT ? STITCH_ENTER : STITCH_LEAVE);
    }
    return just;
}

/* A hole beside the two, made where a wall was folded, is no more. */
static bool has_left_other(stitch *t, uint32_t id)
{
    const bool is = t->others > 0 && id != t->holes[SITE_LEFT] && id != t->holes[SITE_RIGHT];
    t->others -= is ? 1 : 0;
    return is;
}

vbss_result stitch_observe(stitch *t)
{
    const throw_rig *rig = &t->site.rig;
    vbss_scene_hole hole;
    TRY(hand_feel(&t->right));
    TRY(hand_feel(&t->left));
    for (uint32_t i = 0; i < rig->event_count; i++) {
        const vbss_scene_event *e = &rig->events[i];
        if (e->kind == VBSS_SCENE_EVENT_PUNCTURE) {
            punctured(t, e->id);
        } else if (e->kind == VBSS_SCENE_EVENT_WITHDRAWN &&
                   (sprang_off(t, e->id) || is_drawn_out(t, e->id) || is_withdrawn(t, e->id) ||
                    has_left_other(t, e->id))) {
            continue;
        } else if (e->kind == VBSS_SCENE_EVENT_TORN || e->kind == VBSS_SCENE_EVENT_WITHDRAWN) {
            t->others++;
            stitch_fail(t, e->kind == VBSS_SCENE_EVENT_TORN ? "torn out of the jaws" : "withdrawn");
        }
    }
    for (int side = 0; side < 2; side++) {
        if (t->holes[side] != 0 && site_find_hole(&t->site, t->holes[side], &hole)) {
            t->hole[side] = v_mix(t->hole[side], v_load(hole.position), 0.01);
            t->out = side == SITE_LEFT ? hole.arc_length : t->out;
        }
    }
    return VBSS_OK;
}
