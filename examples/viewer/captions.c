/* What stands on the picture of a scene that is played. */
#include <stdio.h>
#include <string.h>

#include "exercise/places.h"
#include "paragraphs.h"
#include "playing.h"

static const char *const help[] = {
    "mouse: the tool goes with it    wheel: away, nearer",
    "left button: jaws close, open again",
    "right button held: mouse turns, wheel rolls the tool",
    "Tab: the other tool    Space or middle button held: it stays",
    "Shift: finer    A D W S Q E: as mouse and wheel",
    "arrows, page up, page down, Home: the camera",
    "1 contacts  2 forces  3 tension  4 knot  5 task  6 step times  7 coach",
    "P pause, . a frame on    R from the beginning    H this    Esc",
    "aids, without a score: F2 needle's arc  F3 wind  F4 snap roll",
    "F5 slow motion  F6 no sinking  F7 idle tool stays  F8 it follows",
    "G: ghost hands, and without them",
    "X: shears in place of the tool, and back, with empty jaws",
    "gamepad: sticks move, roll; left bumper: turn; right trigger: jaws;",
    "right bumper: the other tool; left trigger: finer",
};

/* The tool that the mouse has, and how far it is above what lies below it. */
static void put_tool(playing *p)
{
    show *s = &p->show;
    vbss_grasper_state tool;
    float at[2], below[2];
    if (vbss_grasper_get_state(person_hand(p)->tool, &tool, sizeof tool) != VBSS_OK) {
        return;
    }
    const double foot[3] = {tool.position[0], tool.position[1], FLOOR_HEIGHT};
    if (!show_place(s, tool.position, at) || !show_place(s, foot, below)) {
        return;
    }
    const float left[2] = {at[0] - 7.0F, at[1]}, right[2] = {at[0] + 7.0F, at[1]};
    pen_line(&s->pen, at, below, 1.2F, 0xffffff50u);
    pen_line(&s->pen, left, right, 1.5F, PEN_GREEN);
    pen_box(&s->pen, below[0] - 3.0F, below[1] - 1.5F, 6.0F, 3.0F, 0xffffff90u);
}

static const char *words_of_hold(const vbss_grasper_state *tool)
{
    return tool->needle != 0       ? ", holds the needle"
           : tool->drain != 0      ? ", holds the drain"
           : tool->grasp_count > 0 ? ", holds the thread"
                                   : "";
}

static const char *words_of_device(const vbss_device_input *in, bool joined)
{
    static const char *const names[] = {"waiting", "ready", "OLD POSE", "LOST"};
    return in->clutched != 0                                   ? "clutch"
           : in->status == VBSS_DEVICE_STATUS_READY && !joined ? "tool comes to the hand"
                                                               : names[in->status];
}

/* What is wrong with a device is said large enough: the tool no longer does what the hand does. */
static void put_device(playing *p, int side, float y)
{
    show *s = &p->show;
    const grip *g = &p->live.grips[side];
    const vbss_device_input *in = &g->in;
    const bool ill = in->stopped != 0 || in->status >= VBSS_DEVICE_STATUS_STALE;
    char line[300], why[120] = "";
    if (ill) {
        arms_explain(p->arms, side, why, sizeof why);
    }
    snprintf(line, sizeof line, "%s hand, %s: %s%s, %.2f N%s%s", side == LEFT ? "left" : "right",
             arms_name(p->arms, side), words_of_device(in, g->joined),
             in->stopped != 0 ? ", STOPPED: outputs off, Enter lets go" : "", g->force,
             why[0] != '\0' ? ", " : "", why);
    pen_box(&s->pen, 0.5F * SHOW_MARGIN, y - 1.4F * SHOW_TEXT, s->wide - SHOW_MARGIN,
            2.0F * SHOW_TEXT, PEN_SHADE);
    pen_text(&s->pen, SHOW_MARGIN, y, SHOW_TEXT, ill ? PEN_RED : PEN_WHITE, line);
}

static void put_devices(playing *p)
{
    float y = p->show.tall - SHOW_MARGIN - 2.2F * SHOW_LINE;
    for (int side = 0; side < SIDES; side++) {
        if (live_by_device(&p->live, side)) {
            put_device(p, side, y);
            y += SHOW_LINE;
        }
    }
}

/* An assisted trial gets no score, whether its aids are on or off. */
static void put_aids(playing *p)
{
    static const char *const names[] = {"needle's arc",     "wind",       "snap roll",
                                        "slow motion",      "no sinking", "idle tool stays",
                                        "idle tool follows"};
    char line[200] = "assisted, no score:";
    size_t used = strlen(line);
    if (!p->live.aided) {
        return;
    }
    for (size_t i = 0; i < sizeof names / sizeof *names; i++) {
        if ((p->live.aids >> i & 1U) != 0) {
            used += (size_t)snprintf(line + used, sizeof line - used, "  %s", names[i]);
        }
    }
    const float y = p->show.tall - SHOW_MARGIN - 1.1F * SHOW_LINE;
    pen_box(&p->show.pen, 0.5F * SHOW_MARGIN, y - 1.4F * SHOW_TEXT, 480.0F, 2.0F * SHOW_TEXT,
            PEN_SHADE);
    pen_text(&p->show.pen, SHOW_MARGIN, y, SHOW_TEXT, PEN_YELLOW, line);
}

/* The exercise's goal; its measures once it has ended. */
static void put_exercise(playing *p)
{
    show *s = &p->show;
    vbss_session_exercise_state e;
    vbss_session_measure m;
    char words[PRACTICE_LINE], line[300];
    if (p->o->exercise == NULL ||
        vbss_session_get_exercise(p->live.stage.task.session, &e, sizeof e) != VBSS_OK) {
        return;
    }
    const bool ended = e.outcome != VBSS_SESSION_OUTCOME_NONE,
               passed = e.outcome == VBSS_SESSION_OUTCOME_PASSED;
    const float below = ended ? (float)(e.measure_count + 3) : 2.2F;
    float y = s->tall - SHOW_MARGIN - below * SHOW_LINE;
    paragraphs sentence = {.count = 0};
    snprintf(line, sizeof line, "%s%s",
             !ended   ? "exercise: "
             : passed ? "PASSED: "
                      : "NOT PASSED: ",
             e.sentence);
    paragraphs_add(&sentence, paragraphs_room(s),
                   !ended   ? PEN_WHITE
                   : passed ? PEN_GREEN
                            : PEN_RED,
                   line);
    paragraphs_put(s, &sentence, below);
    for (uint32_t i = 0; ended && i < e.measure_count; i++) {
        y += SHOW_LINE;
        if (vbss_session_get_measure(p->live.stage.task.session, i, &m, sizeof m) == VBSS_OK) {
            practice_words(&m, words);
            pen_box(&s->pen, 0.5F * SHOW_MARGIN, y - 1.4F * SHOW_TEXT, 480.0F, 2.0F * SHOW_TEXT,
                    PEN_SHADE);
            pen_text(&s->pen, SHOW_MARGIN, y, SHOW_TEXT, m.is_met != 0 ? PEN_WHITE : PEN_RED,
                     words);
        }
    }
    if (p->noted) {
        pen_text(&s->pen, SHOW_MARGIN, y + SHOW_LINE, SHOW_TEXT, PEN_WHITE, p->progress);
    }
}

static void put_state(playing *p)
{
    show *s = &p->show;
    const float y = s->tall - SHOW_MARGIN;
    const bool led = live_by_device(&p->live, p->live.active);
    const mouse_hand *m = person_hand(p);
    char line[200], of_tool[120] = "";
    vbss_grasper_state tool;
    if (!led && vbss_grasper_get_state(m->tool, &tool, sizeof tool) == VBSS_OK) {
        snprintf(of_tool, sizeof of_tool, "%s tool, jaws %s%s%s%s   ",
                 p->live.active == LEFT ? "left" : "right", m->closes ? "closed" : "open",
                 words_of_hold(&tool), m->clutched ? ", stays" : "",
                 p->window.taken || p->window.has_pad ? "" : "   click to lead it");
    }
    snprintf(line, sizeof line, "%s%s%s%s", of_tool, p->paused ? "paused   " : "",
             p->window.has_pad    ? "gamepad   "
             : p->window.lost_pad ? "THE GAMEPAD IS GONE   "
                                  : "",
             p->window.taken ? "" : "H for help");
    pen_box(&s->pen, 0.5F * SHOW_MARGIN, y - 1.4F * SHOW_TEXT, s->wide - SHOW_MARGIN,
            2.0F * SHOW_TEXT, PEN_SHADE);
    const float end = pen_text(&s->pen, SHOW_MARGIN, y, SHOW_TEXT,
                               p->window.lost_pad ? PEN_RED : PEN_WHITE, line);
    if (!p->paused && p->o->frame_steps == 0 && p->real_time_factor < 0.9) {
        snprintf(line, sizeof line, "slow motion, %.2f of real time", p->real_time_factor);
        pen_text(&s->pen, end + 2.0F * SHOW_TEXT, y, SHOW_TEXT, PEN_YELLOW, line);
    }
}

void captions_put(playing *p)
{
    put_devices(p);
    if (!live_by_device(&p->live, p->live.active)) {
        put_tool(p);
    }
    put_state(p);
    put_aids(p);
    put_exercise(p);
    if ((p->show.overlays & SHOW_HELP) != 0) {
        overlay_help(&p->show, help, (int)(sizeof help / sizeof *help));
    }
}
