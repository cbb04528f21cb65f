/* A step: the hands go where the script has them, pull as hard as they feel, and the scene follows. */
#include "pad.h"

#include <math.h>

#include "base/error.h"

static const double tight = 0.3 /* N, of tail and assistant: as much as closes a bite */,
                    returning = 1.5 /* s, of hands that have tied */,
                    speed = 60e-3 /* m/s, of a hand that pulls */, arm = 50.0 /* N/m */;
enum {
    STUMP = 16, /* nodes of the limb beyond the jaws that hold it, when the needle is cut off */
    EAR = 14    /* of either end beyond the knot */
};
static const double followed = 25e-3; /* m of thread from the skin to the assistant */
enum {
    BESIDE_NEEDLE = 4,     /* segment whose tension the second hand feels */
    VARY_THROW = PAD_BITES /* first number of the variations of throws */
};

static double segment_length(const pad_suture *s)
{
    return s->length / s->segments;
}

pad_suture *pad_current(pad *p)
{
    return &p->sutures[p->bite == 0 ? 0 : 1];
}

/* ---- pulling */

static vbss_result feel(pad *p)
{
    const pad_suture *s = pad_current(p);
    vbss_view tensions;
    VBSS_TRY(
        vbss_thread_get_view(s->thread, VBSS_THREAD_VIEW_TENSIONS, &tensions, sizeof tensions));
    p->tension = s->has_needle ? ((const double *)tensions.data)[BESIDE_NEEDLE] : 0.0;
    return VBSS_OK;
}

/* Over the incision and away from it, where the tail would be tied. */
static vbss_result pull_tail(pad *p)
{
    pad_suture *s = &p->sutures[1];
    if (p->tail.attachment == 0) {
        VBSS_TRY(scripted_take(&p->tail, s->thread, s->segments, arm));
    }
    const vec3 goal = vec3_make(45e-3, 30e-3, pad_place(1) - 35e-3);
    return scripted_pull_toward(&p->tail, s->thread, goal, tight, speed * PAD_STEP);
}

/* ---- the knot */

/* The needle of the stitch is cut off, and goes with its end of the thread. */
static vbss_result cut_needle_off(pad *p)
{
    pad_suture *s = &p->sutures[0];
    const uint32_t end = s->thread_body;
    const double place = segment_length(s) * (double)(p->tie.c.node - STUMP);
    VBSS_TRY(vbss_scene_cut_thread(p->scene, end, place, &s->thread_body));
    VBSS_TRY(vbss_scene_get_thread(p->scene, s->thread_body, &s->thread));
    VBSS_TRY(vbss_scene_remove(p->scene, end));
    VBSS_TRY(vbss_scene_remove(p->scene, s->needle_body));
    s->has_needle = false;
    return VBSS_OK;
}

/* Both ends of the tied stitch, a little beyond the knot. */
static vbss_result cut_ends(pad *p)
{
    pad_suture *s = &p->sutures[0];
    const tie_thread *seen = &p->tie.thread;
    const double limb = segment_length(s) * (double)(seen->limb_root - EAR),
                 tail = segment_length(s) * (double)(seen->tail_root + EAR);
    const uint32_t end = s->thread_body;
    uint32_t rest;
    VBSS_TRY(vbss_scene_cut_thread(p->scene, end, tail, &rest));
    VBSS_TRY(vbss_scene_remove(p->scene, rest));
    VBSS_TRY(vbss_scene_cut_thread(p->scene, end, limb, &s->thread_body));
    VBSS_TRY(vbss_scene_remove(p->scene, end));
    return vbss_scene_get_thread(p->scene, s->thread_body, &s->thread);
}

vbss_result pad_see_stitch(pad *p)
{
    return tie_see(&p->tie, p->sutures[0].thread_body, segment_length(&p->sutures[0]));
}

vbss_result pad_follow_knot(pad *p)
{
    VBSS_TRY(pad_see_stitch(p));
    return tie_follow(&p->tie);
}

static vbss_result begin_tie(pad *p)
{
    p->is_tying = true;
    VBSS_TRY(tie_begin(&p->tie, p->context, p->scene, vec3_make(0.0, 0.0, pad_place(0)), p->hands));
    VBSS_TRY(pad_see_stitch(p));
    return tie_judge(&p->tie);
}

static void return_hand(const pad *p, int which, tie_hand *h)
{
    scripted_hand goal = p->hands[which];
    const vec3 centre = pad_direct_hand(p, which, &goal);
    const pose tool = scripted_tool(&goal, centre);
    tie_go(h, tool.position, 0.15);
    h->wanted_turn = tool.orientation;
    h->opening = pad_hand_is_open(p, which) ? SCRIPTED_OPENING : 0.0;
}

/* Then both hands go to where the next needle is. */
static vbss_result tie(pad *p)
{
    pad_tie *t = &p->tie;
    const tie_state before = t->state;
    const uint32_t body = t->thread.body;
    VBSS_TRY(pad_see_stitch(p));
    VBSS_TRY(t->thread.body != body ? tie_judge(t) : VBSS_OK);
    t->lips = pad_across(p, pad_place(0));
    t->off = pad_vary(p->seed, VARY_THROW + t->throws);
    if (t->state == TIE_DONE) {
        return_hand(p, 0, &t->c);
        return_hand(p, 1, &t->w);
    }
    VBSS_TRY(tie_step(t, PAD_STEP));
    VBSS_TRY(pad_hold_knot(p, before == TIE_PULL && t->state == TIE_EASE));
    if (before == TIE_TAKE && t->state == TIE_PLACE) {
        VBSS_TRY(cut_needle_off(p));
    } else if (before == TIE_EASE && t->state == TIE_LEAVE) {
        VBSS_TRY(cut_ends(p));
    } else if (before == TIE_LEAVE && t->state == TIE_DONE) {
        p->bite = 1;
        p->phase = PAD_OFFER;
        p->since = p->pulled = 0.0;
    } else if (t->state == TIE_DONE && t->since > returning) {
        p->is_tying = false;
        return pad_add_suture(p, 1, scripted_needle(pad_needle_centre(p), pad_needle_turned(p)));
    }
    return VBSS_OK;
}

/* ---- the running suture */

/* Where the running thread leaves the skin towards its needle: arc length, m. */
static double last_hole(const pad *p)
{
    vbss_scene_hole hole;
    double first = p->sutures[1].length;
    for (uint32_t i = 0; vbss_scene_get_hole(p->scene, i, &hole, sizeof hole) == VBSS_OK; i++) {
        const bool is_of_it = hole.thread == p->sutures[1].thread_body;
        first = is_of_it && hole.arc_length < first ? hole.arc_length : first;
    }
    return first;
}

/* Between two bites an assistant follows: holds the thread tight behind the last bite, over the finished part. */
static vbss_result follow(pad *p)
{
    pad_suture *s = &p->sutures[1];
    if (p->bite < 2) {
        return VBSS_OK;
    }
    if (p->phase == PAD_OFFER && p->assistant.attachment == 0) {
        const double along = last_hole(p) - followed;
        const uint32_t node = (uint32_t)(along / s->length * s->segments + 0.5);
        VBSS_TRY(scripted_take(&p->assistant, s->thread, node, arm));
    }
    if (p->phase >= PAD_TURN && p->assistant.attachment != 0) {
        return scripted_release(&p->assistant, s->thread);
    }
    if (p->assistant.attachment != 0) {
        const vec3 goal = vec3_make(-30e-3, 30e-3, pad_place(p->bite - 1) - 30e-3);
        return scripted_pull_toward(&p->assistant, s->thread, goal, tight, speed * PAD_STEP);
    }
    return VBSS_OK;
}

/* ---- phases */

static vbss_result end_bite(pad *p)
{
    if (p->bite == 0) {
        return begin_tie(p);
    }
    p->bite++;
    p->phase = PAD_OFFER;
    return VBSS_OK;
}

static vbss_result advance(pad *p, bool *is_done)
{
    while (p->since >= pad_phase_time(p->bite, p->phase) - 0.5 * PAD_STEP && !*is_done &&
           !p->is_tying) {
        const bool missed = p->phase == PAD_TURN && p->punctures != 2 * (p->bite + 1); /* a lip */
        p->since = 0.0;
        if (!missed && p->phase + 1 < PAD_PHASES) {
            p->pulled = p->phase == PAD_OFFER ? 0.0 : p->pulled;
            p->phase = (pad_phase)(p->phase + 1);
            p->drawn = p->phase == PAD_DRAW ? 0.0 : p->drawn;
        } else if (!missed && p->bite + 1 < PAD_BITES) {
            VBSS_TRY(end_bite(p));
        } else {
            *is_done = true;
        }
    }
    return VBSS_OK;
}

static vbss_result place_hands(pad *p)
{
    for (int i = 0; i < 2; i++) {
        const vec3 centre = pad_direct_hand(p, i, &p->hands[i]);
        const double opening = pad_hand_is_open(p, i) ? SCRIPTED_OPENING : 0.0;
        VBSS_TRY(scripted_place_hand(&p->hands[i], centre, opening));
    }
    return VBSS_OK;
}

static vbss_result count_events(pad *p)
{
    vbss_scene_event events[64];
    uint32_t count = 64;
    while (count == 64) {
        VBSS_TRY(vbss_scene_take_events(p->scene, events, sizeof events[0], 64, &count, NULL));
        for (uint32_t i = 0; i < count; i++) {
            const vbss_scene_event_kind kind = events[i].kind;
            p->punctures += kind == VBSS_SCENE_EVENT_PUNCTURE;
            p->others += kind == VBSS_SCENE_EVENT_WITHDRAWN ||
                         kind == VBSS_SCENE_EVENT_UNTHREADED || kind == VBSS_SCENE_EVENT_TORN;
        }
    }
    return VBSS_OK;
}

static vbss_result sew(pad *p)
{
    VBSS_TRY(feel(p));
    if (p->phase == PAD_TIGHTEN && p->bite > 0) {
        pad_tighten(p);
    }
    if (p->phase == PAD_DRAW && pad_follows(p)) {
        p->drawn = fmin(p->drawn + pad_draw_step(p), 1.0);
    }
    VBSS_TRY(place_hands(p));
    VBSS_TRY(p->bite > 1 || (p->bite == 1 && p->phase == PAD_TIGHTEN) ? pull_tail(p) : VBSS_OK);
    return follow(p);
}

vbss_result pad_step(pad *p, bool *is_done)
{
    *is_done = false;
    VBSS_TRY(p->is_tying ? VBSS_OK : advance(p, is_done));
    if (*is_done) {
        return VBSS_OK;
    }
    VBSS_TRY(p->is_tying ? tie(p) : sew(p));
    *is_done = p->tie.state == TIE_FAILED;
    VBSS_TRY(vbss_scene_step(p->scene, PAD_STEP));
    VBSS_TRY(pad_write_log(p));
    p->since += p->is_tying || pad_waits(p) ? 0.0 : PAD_STEP;
    p->time += PAD_STEP;
    VBSS_TRY(p->tie.state == TIE_DONE ? pad_follow_knot(p) : VBSS_OK);
    return count_events(p);
}
