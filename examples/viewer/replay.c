/* A log in a window, with a time line. */
#include <math.h>
#include <stdio.h>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include "modes.h"
#include "orbit.h"
#include "player.h"

#define STEP 1e-3      /* s, of a log's steps, nearly */
#define JUMP 1.0       /* s, by a key */
#define SMALL_JUMP 0.1 /* with shift */
#define SLOWEST 0.0625 /* of real time */
#define FASTEST 8.0
#define MAX_WORK 0.1 /* s of steps a frame */
#define BAR_TALL 10.0F
#define MICRO 1e6

typedef struct watching {
    const options *o;
    window window;
    show show;
    player player;
    orbit orbit;
    desk desk;
    bool playing, dragging;
    double speed, due; /* simulated s that are to be played yet */
    double clock;
    int64_t wanted; /* step that was asked for; -1: none */
    uint64_t frames;
} watching;

/* ---- what the person does */

static double bar_width(const watching *w)
{
    return (double)w->show.wide - 2.0 * (double)SHOW_MARGIN;
}

static double bar_top(const watching *w)
{
    return (double)w->show.tall - (double)(SHOW_MARGIN + BAR_TALL);
}

static void ask_for(watching *w, double step)
{
    w->wanted = (int64_t)fmin(fmax(floor(step + 0.5), 0.0), (double)w->player.steps);
}

static void ask_at(watching *w, double x)
{
    ask_for(w, (x / (double)w->show.pen.scale - (double)SHOW_MARGIN) / bar_width(w) *
                   (double)w->player.steps);
}

static void on_moved(void *user, double right, double down, double x, double y)
{
    watching *w = user;
    (void)right;
    (void)down;
    (void)y;
    if (w->dragging) {
        ask_at(w, x);
    }
}

static void on_pressed(void *user, int button, bool down, double x, double y)
{
    watching *w = user;
    w->dragging = down && button == GLFW_MOUSE_BUTTON_LEFT &&
                  y / (double)w->show.pen.scale >= bar_top(w) - (double)SHOW_MARGIN;
    if (w->dragging) {
        ask_at(w, x);
    }
}

static void on_arrow(watching *w, int key, bool shift)
{
    const double jump = (shift ? SMALL_JUMP : JUMP) / STEP;
    ask_for(w, (double)w->player.step + (key == GLFW_KEY_COMMA ? -jump : jump));
}

static void on_key(void *user, int key, bool shift)
{
    watching *w = user;
    if (key >= GLFW_KEY_1 && key <= GLFW_KEY_6) {
        w->show.overlays ^= 1U << (key - GLFW_KEY_1);
    } else if (key == GLFW_KEY_7) {
        w->show.overlays ^= SHOW_COACH;
    } else if (key == GLFW_KEY_F1 || key == GLFW_KEY_H) {
        w->show.overlays ^= SHOW_HELP;
    } else if (key == GLFW_KEY_SPACE || key == GLFW_KEY_P) {
        w->playing = !w->playing;
    } else if (key == GLFW_KEY_COMMA || key == GLFW_KEY_PERIOD) {
        on_arrow(w, key, shift);
    } else if (key == GLFW_KEY_S) {
        w->playing = false;
        ask_for(w, (double)w->player.step + (shift ? -1.0 : 1.0));
    } else if (key == GLFW_KEY_EQUAL || key == GLFW_KEY_KP_ADD) {
        w->speed = fmin(2.0 * w->speed, FASTEST);
    } else if (key == GLFW_KEY_MINUS || key == GLFW_KEY_KP_SUBTRACT) {
        w->speed = fmax(0.5 * w->speed, SLOWEST);
    } else if (key == GLFW_KEY_R) {
        ask_for(w, 0.0);
    } else if (key == GLFW_KEY_ESCAPE) {
        window_close(&w->window);
    }
}

/* ---- steps */

/* One step on is made as such, so that its time is seen. */
static void jump(watching *w)
{
    const uint64_t to = (uint64_t)w->wanted;
    w->wanted = -1;
    w->due = 0.0;
    w->show.judged = false;
    w->show.scored = false;
    if (to == w->player.step + 1) {
        (void)player_step(&w->player);
    } else if (to != w->player.step) {
        (void)player_seek(&w->player, to);
    }
}

static void go_on(watching *w)
{
    const double now = window_clock(), elapsed = fmin(now - w->clock, 0.2);
    double longest = 0.0;
    w->clock = now;
    if (orbit_step(&w->orbit, &w->window, (float)elapsed)) {
        w->show.camera = orbit_camera(&w->orbit);
    }
    if (w->wanted >= 0) {
        jump(w);
        return;
    }
    w->due = w->playing
                 ? w->due + (w->o->frame_steps > 0 ? STEP * w->o->frame_steps : elapsed * w->speed)
                 : 0.0;
    while (w->due >= STEP) {
        const double before = show_clock();
        if (!player_step(&w->player)) {
            w->playing = false;
            break;
        }
        longest = fmax(longest, show_clock() - before);
        w->due -= STEP;
        if (w->o->frame_steps == 0 && window_clock() - now > MAX_WORK) {
            w->due = 0.0; /* slow motion */
        }
    }
    if (w->playing) {
        show_time(&w->show, (float)(MICRO * longest));
    }
}

/* ---- on the picture */

static const char *const help[] = {
    "Space: play, pause    S: a step on, with Shift back",
    ", .: a second back, on; with Shift a tenth",
    "+ -: faster, slower    R: to the beginning    click the line: there",
    "arrows, page up, page down, Home: the camera",
    "1 contacts  2 forces  3 tension  4 knot  5 task  6 step times    H this",
};

static void put_line_of_time(watching *w)
{
    show *s = &w->show;
    const float x = SHOW_MARGIN, y = (float)bar_top(w), wide = (float)bar_width(w);
    const float part =
        w->player.steps > 0 ? (float)((double)w->player.step / (double)w->player.steps) : 0.0F;
    char line[120];
    pen_box(&s->pen, x, y, wide, BAR_TALL, PEN_SHADE);
    pen_box(&s->pen, x, y, wide * part, BAR_TALL, PEN_BLUE);
    pen_box(&s->pen, x + wide * part - 2.0F, y - 3.0F, 4.0F, BAR_TALL + 6.0F, PEN_WHITE);
    snprintf(line, sizeof line, "%.3f of %.3f s, step %llu, speed %g%s%s", w->player.time,
             w->player.length, (unsigned long long)w->player.step, w->speed,
             w->playing ? "" : ", paused",
             w->player.differs ? ", NOT AS RECORDED FROM HERE ON" : "");
    pen_text(&s->pen, x, y - 8.0F, SHOW_TEXT, w->player.differs ? PEN_RED : PEN_WHITE, line);
}

static void report(watching *w)
{
    (void)overlay_judge(&w->show, w->player.time);
    printf("frame %llu step %llu of %llu time %.3f playing %d speed %g looks %u knot %d %u %s",
           (unsigned long long)w->frames, (unsigned long long)w->player.step,
           (unsigned long long)w->player.steps, w->player.time, w->playing, w->speed,
           (unsigned)w->show.overlays, (int)w->show.knot.state.verdict,
           (unsigned)w->show.knot.state.throw_count,
           w->show.knot.notation[0] != '\0' ? w->show.knot.notation : "-");
    status_print(&w->show, w->player.time);
    printf(" renewed %u size %d %d\n", w->window.renewed, w->show.renderer.lens.width,
           w->show.renderer.lens.height);
    fflush(stdout);
}

static bool draw(watching *w)
{
    if (w->player.jumped && w->player.stage.rig->cuts > 0) {
        w->show.overlays &= ~(uint32_t)SHOW_KNOT; /* which piece it is, is not known after a jump */
    }
    w->window.give_up = w->o->renew > 0 && w->frames == (uint64_t)w->o->renew;
    if (!window_ready(&w->window, &w->show) || !show_draw(&w->show, w->player.time)) {
        return false;
    }
    put_line_of_time(w);
    if ((w->show.overlays & SHOW_HELP) != 0) {
        overlay_help(&w->show, help, (int)(sizeof help / sizeof *help));
    }
    return window_show(&w->window, &w->show);
}

static bool watch(watching *w)
{
    if (!player_open(&w->player, w->o->log) || !show_stage(&w->show, &w->player.stage)) {
        return false;
    }
    orbit_begin(&w->orbit, (point3){0.0F, 0.0F, 2e-3F}, CAMERA_ASIDE, CAMERA_AWAY);
    w->show.camera = orbit_camera(&w->orbit);
    w->clock = window_clock();
    ask_for(w, w->o->from / STEP);
    while (window_listen(&w->window, &w->desk)) {
        go_on(w);
        if (!draw(w)) {
            return false;
        }
        w->frames++;
        if (w->o->report != 0) {
            report(w);
        }
    }
    return !w->player.differs;
}

int mode_replay(const options *o)
{
    static watching w;
    w.o = o;
    w.playing = true;
    w.speed = 1.0;
    w.desk = (desk){&w, on_moved, NULL, on_pressed, on_key};
    if (!window_begin(&w.window, &w.show, o->width, o->height, o->overlays)) {
        return MODE_NO_OPENGL;
    }
    bool good = watch(&w);
    player_close(&w.player);
    window_end(&w.window, &w.show);
    return good ? 0 : 1;
}
