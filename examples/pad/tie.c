/* One throw after the other, from the state that the hands see. */
#include "tie.h"

#include "base/error.h"

static const char *const names[] = {"take the limb",
                                    "hold the limb over the stitch",
                                    "wind it round the jaws",
                                    "reach for the tail",
                                    "take the tail",
                                    "draw it through",
                                    "back out of the turns",
                                    "lower the hands",
                                    "pull the throw tight",
                                    "ease",
                                    "cut the ends",
                                    "done",
                                    "failed"};

const char *tie_state_name(tie_state state)
{
    return names[state];
}

uint32_t tie_present_throw(const pad_tie *t)
{
    return t->throws + (t->state < TIE_LOWER ? 1 : 0);
}

void tie_enter(pad_tie *t, tie_state state)
{
    t->state = state;
    t->since = 0.0;
}

void tie_fail(pad_tie *t, const char *why)
{
    t->why = why;
    tie_enter(t, TIE_FAILED);
}

double tie_length(const tie_thread *thread, uint32_t from, uint32_t to)
{
    return thread->segment * ((double)to - (double)from);
}

vbss_result tie_begin(pad_tie *t, vbss_context *context, vbss_scene *scene, vec3 stitch,
                      scripted_hand hands[2])
{
    *t = (pad_tie){.scene = scene, .stitch = stitch, .side = 1.0, .slack = 0.96};
    tie_take_over(&t->c, &hands[0], SCRIPTED_OPENING);
    tie_take_over(&t->w, &hands[1], 0.0);
    VBSS_TRY(vbss_knot_detector_create(context, NULL, &t->detector));
    return vbss_knot_detector_create(context, NULL, &t->counter);
}

vbss_result tie_see(pad_tie *t, uint32_t body, double segment)
{
    vbss_view x;
    t->thread.body = body;
    t->thread.segment = segment;
    VBSS_TRY(vbss_scene_get_thread(t->scene, body, &t->thread.thread));
    VBSS_TRY(vbss_thread_get_view(t->thread.thread, VBSS_THREAD_VIEW_POSITIONS, &x, sizeof x));
    t->thread.x = (const vec3 *)x.data;
    t->thread.count = (uint32_t)x.count;
    VBSS_TRY(tie_feel(&t->w, t->scene, &t->thread));
    return tie_feel(&t->c, t->scene, &t->thread);
}

static vbss_result lead(pad_tie *t, double dt)
{
    switch (t->state) {
    case TIE_TAKE:
        tie_take(t);
        return VBSS_OK;
    case TIE_PLACE:
        tie_place(t);
        return VBSS_OK;
    case TIE_WIND:
        return tie_wind(t, dt);
    case TIE_REACH:
        tie_reach(t, dt);
        return VBSS_OK;
    case TIE_CLOSE:
        return tie_close(t, dt);
    case TIE_DRAW:
        return tie_draw(t, dt);
    case TIE_BACK:
        tie_back(t);
        return VBSS_OK;
    case TIE_LOWER:
        tie_lower(t, dt);
        return VBSS_OK;
    case TIE_PULL:
        return tie_pull(t, dt);
    case TIE_EASE:
        return tie_ease(t, dt);
    case TIE_LEAVE:
        tie_leave(t);
        return VBSS_OK;
    default:
        return VBSS_OK;
    }
}

vbss_result tie_step(pad_tie *t, double dt)
{
    t->since += dt;
    if (t->state > TIE_TAKE && t->state < TIE_LEAVE && !t->c.holds) {
        tie_fail(t, "the limb is lost");
    }
    VBSS_TRY(lead(t, dt));
    VBSS_TRY(tie_move(&t->w, dt));
    return tie_move(&t->c, dt);
}
