/* A scene in a window, under two hands of one mouse. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include "live.h"
#include "modes.h"
#include "orbit.h"

#define FINE 0.25       /* of a movement, with shift */
#define KEY_METRES 0.03 /* a second */
#define MOST_STEPS 50   /* a frame: what takes longer is slow motion */
#define MICRO 1e6

typedef struct playing {
    const options *o;
    window window;
    show show;
    live live;
    orbit orbit;
    desk desk;
    bool paused, once; /* one frame's steps */
    bool again;        /* from the beginning */
    double clock;      /* of the last frame, s */
    double pace;       /* simulated over real, smoothed */
    uint64_t frames;
    double motion[2]; /* counts that came, since the beginning */
    double next;      /* picture, s */
} playing;

static mouse_hand *active(playing *p)
{
    return &p->live.hands[p->live.active];
}

/* ---- what the person does */

static double grain(const playing *p)
{
    return window_is_down(&p->window, GLFW_KEY_LEFT_SHIFT) ? FINE : 1.0;
}

static bool is_turning(const playing *p)
{
    return glfwGetMouseButton(p->window.handle, GLFW_MOUSE_BUTTON_RIGHT) == GLFW_PRESS;
}

static void on_moved(void *user, double right, double down, double x, double y)
{
    playing *p = user;
    (void)x;
    (void)y;
    if (p->window.taken) {
        const double g = grain(p);
        p->motion[0] += right;
        p->motion[1] += down;
        mouse_hand_move(active(p), is_turning(p), g * right, -g * down, 0.0);
    }
}

static void on_wheeled(void *user, double notches)
{
    playing *p = user;
    mouse_hand_move(active(p), is_turning(p), 0.0, 0.0, grain(p) * notches);
}

static void on_pressed(void *user, int button, bool down, double x, double y)
{
    playing *p = user;
    (void)x;
    (void)y;
    if (down && !p->window.taken) {
        window_take_pointer(&p->window, true);
    } else if (down && button == GLFW_MOUSE_BUTTON_LEFT) {
        active(p)->closes = !active(p)->closes;
    }
}

static void on_key(void *user, int key, bool shift)
{
    playing *p = user;
    (void)shift;
    if (key >= GLFW_KEY_1 && key <= GLFW_KEY_6) {
        p->show.looks ^= 1U << (key - GLFW_KEY_1);
    } else if (key == GLFW_KEY_F1 || key == GLFW_KEY_H) {
        p->show.looks ^= SHOW_HELP;
    } else if (key == GLFW_KEY_TAB) {
        p->live.active = p->live.active == LEFT ? RIGHT : LEFT;
    } else if (key == GLFW_KEY_P) {
        p->paused = !p->paused;
    } else if (key == GLFW_KEY_PERIOD) {
        p->once = p->paused;
    } else if (key == GLFW_KEY_R) {
        p->again = true;
    } else if (key == GLFW_KEY_ESCAPE) {
        if (p->window.taken) {
            window_take_pointer(&p->window, false);
        } else {
            window_close(&p->window);
        }
    }
}

/* Keys shift as the mouse does, in its counts. */
static void move_by_keys(playing *p, double seconds)
{
    const window *w = &p->window;
    const double counts = grain(p) * KEY_METRES * seconds / active(p)->mapping.mouse_metres;
    const double notches = grain(p) * KEY_METRES * seconds / active(p)->mapping.mouse_depth;
    const double right = window_is_down(w, GLFW_KEY_D) - window_is_down(w, GLFW_KEY_A);
    const double up = window_is_down(w, GLFW_KEY_W) - window_is_down(w, GLFW_KEY_S);
    const double away = window_is_down(w, GLFW_KEY_E) - window_is_down(w, GLFW_KEY_Q);
    mouse_hand_move(active(p), false, counts * right, counts * up, notches * away);
}

static vbss_result clutch(playing *p)
{
    const bool held = window_is_down(&p->window, GLFW_KEY_SPACE) ||
                      glfwGetMouseButton(p->window.handle, GLFW_MOUSE_BUTTON_MIDDLE) == GLFW_PRESS;
    for (int side = 0; side < SIDES; side++) {
        TRY(mouse_hand_clutch(&p->live.hands[side], held && side == p->live.active));
    }
    return VBSS_OK;
}

/* ---- steps */

/* So many that the scene's time goes as fast as the clock, unless that is too many. */
static int count_steps(playing *p, double elapsed)
{
    if (p->paused && !p->once) {
        return 0;
    }
    p->once = false;
    if (p->o->frame_steps > 0) {
        return p->o->frame_steps;
    }
    return (int)fmin(fmax(floor(elapsed * 1e3 + 0.5), 1.0), MOST_STEPS);
}

static vbss_result make_steps(playing *p, int count)
{
    double longest = 0.0;
    for (int i = 0; i < count; i++) {
        const double begin = show_clock();
        TRY(live_step(&p->live));
        longest = fmax(longest, show_clock() - begin);
    }
    if (count > 0) {
        show_time(&p->show, (float)(MICRO * longest));
    }
    return VBSS_OK;
}

/* ---- on the picture */

static const char *const help[] = {
    "mouse: the tool goes with it    wheel: away, nearer",
    "left button: jaws close, open again",
    "right button held: mouse turns, wheel rolls the tool",
    "Tab: the other tool    Space or middle button held: it stays",
    "Shift: finer    A D W S Q E: as mouse and wheel",
    "arrows, page up, page down, Home: the camera",
    "1 contacts  2 forces  3 tension  4 knot  5 task  6 step times",
    "P pause, . a frame on    R from the beginning    H this    Esc",
};

/* The tool that the mouse has, and how far it is above what lies below it. */
static void put_tool(playing *p)
{
    show *s = &p->show;
    vbss_grasper_state tool;
    float at[2], below[2];
    if (vbss_grasper_get_state(active(p)->tool, &tool, sizeof tool) != VBSS_OK) {
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

static void put_state(playing *p)
{
    show *s = &p->show;
    const float y = s->tall - SHOW_MARGIN;
    char line[200];
    vbss_grasper_state tool;
    if (vbss_grasper_get_state(active(p)->tool, &tool, sizeof tool) != VBSS_OK) {
        return;
    }
    snprintf(line, sizeof line, "%s tool, jaws %s%s%s%s%s",
             p->live.active == LEFT ? "left" : "right", active(p)->closes ? "closed" : "open",
             words_of_hold(&tool), active(p)->clutched ? ", stays" : "",
             p->paused ? ", paused" : "", p->window.taken ? "" : "   click to take it, H for help");
    pen_box(&s->pen, 0.5F * SHOW_MARGIN, y - 1.4F * SHOW_TEXT, 480.0F, 2.0F * SHOW_TEXT, PEN_SHADE);
    pen_text(&s->pen, SHOW_MARGIN, y, SHOW_TEXT, PEN_WHITE, line);
    if (!p->paused && p->o->frame_steps == 0 && p->pace < 0.9) {
        snprintf(line, sizeof line, "slow motion, %.2f of real time", p->pace);
        pen_text(&s->pen, SHOW_MARGIN + 490.0F, y, SHOW_TEXT, PEN_YELLOW, line);
    }
}

/* ---- a line a frame, for who plays by a script */

static void tell(playing *p)
{
    static const char *const names[SIDES] = {"left", "right"};
    const vec *x = stand_nodes(p->live.stage.stand);
    const uint32_t last = p->live.stage.stand->nodes - 1;
    (void)overlay_judge(&p->show, p->live.time);
    printf("frame %llu time %.3f active %s taken %d motion %.1f %.1f",
           (unsigned long long)p->frames, p->live.time, names[p->live.active], p->window.taken,
           p->motion[0], p->motion[1]);
    for (int side = 0; side < SIDES; side++) {
        vbss_grasper_state tool;
        const mouse_hand *m = &p->live.hands[side];
        if (vbss_grasper_get_state(m->tool, &tool, sizeof tool) != VBSS_OK) {
            continue;
        }
        const double *q = tool.orientation, *f = tool.hand_force;
        printf(" %s %.3f %.3f %.3f told %.3f %.3f %.3f turned %.4f %.4f %.4f %.4f jaw %.3f holds "
               "%u needle %u force %.4f",
               names[side], 1e3 * tool.position[0], 1e3 * tool.position[1], 1e3 * tool.position[2],
               1e3 * m->in.position[0], 1e3 * m->in.position[1], 1e3 * m->in.position[2], q[0],
               q[1], q[2], q[3], m->in.jaw, (unsigned)tool.grasp_count, (unsigned)tool.needle,
               sqrt(f[0] * f[0] + f[1] * f[1] + f[2] * f[2]));
    }
    printf(" ends %.3f %.3f %.3f %.3f %.3f %.3f knot %d %u %s size %d %d\n", 1e3 * x[0].x,
           1e3 * x[0].y, 1e3 * x[0].z, 1e3 * x[last].x, 1e3 * x[last].y, 1e3 * x[last].z,
           (int)p->show.knot.state.verdict, (unsigned)p->show.knot.state.throw_count,
           p->show.knot.notation[0] != '\0' ? p->show.knot.notation : "-",
           p->show.renderer.lens.width, p->show.renderer.lens.height);
    fflush(stdout);
}

/* ---- a frame */

static void look_round(playing *p, double elapsed)
{
    if (orbit_step(&p->orbit, &p->window, (float)fmin(elapsed, 0.1))) {
        p->show.camera = orbit_camera(&p->orbit);
        mouse_hand_look(&p->live.hands[LEFT], &p->show.camera);
        mouse_hand_look(&p->live.hands[RIGHT], &p->show.camera);
    }
}

/* A script may want fewer pictures than there are frames. */
static bool draw(playing *p)
{
    if (p->live.time < p->next) {
        return true;
    }
    p->next = p->live.time + p->o->every;
    if (!show_draw(&p->show, p->live.time)) {
        return false;
    }
    put_tool(p);
    put_state(p);
    if ((p->show.looks & SHOW_HELP) != 0) {
        overlay_help(&p->show, help, (int)(sizeof help / sizeof *help));
    }
    return window_show(&p->window, &p->show);
}

static vbss_result go_on(playing *p)
{
    const double now = window_clock(), elapsed = now - p->clock;
    p->clock = now;
    look_round(p, elapsed);
    move_by_keys(p, p->o->frame_steps > 0 ? 1e-3 * p->o->frame_steps : fmin(elapsed, 0.1));
    TRY(clutch(p));
    const int count = count_steps(p, elapsed);
    p->pace += 0.05 * (1e-3 * count / fmax(elapsed, 1e-3) - p->pace);
    return make_steps(p, count);
}

/* ---- a session */

static bool begin(playing *p)
{
    const live_scene *scene = live_find(p->o->live);
    const vbss_result result = live_create(&p->live, scene, p->o->keep);
    if (result != VBSS_OK) {
        fprintf(stderr, "viewer: %s: %s\n", scene->name, vbss_result_string(result));
        return false;
    }
    orbit_begin(&p->orbit, scene->target, scene->aside, scene->away);
    p->show.camera = orbit_camera(&p->orbit);
    mouse_hand_look(&p->live.hands[LEFT], &p->show.camera);
    mouse_hand_look(&p->live.hands[RIGHT], &p->show.camera);
    p->again = false;
    p->next = 0.0;
    p->pace = 1.0;
    p->clock = window_clock();
    return show_stage(&p->show, &p->live.stage);
}

static bool play(playing *p)
{
    while (!p->again && window_listen(&p->window, &p->desk)) {
        const vbss_result result = go_on(p);
        if (result != VBSS_OK) {
            const char *text = "";
            (void)vbss_context_get_last_error(p->live.stage.context, NULL, &text);
            fprintf(stderr, "viewer: %s: %s\n", vbss_result_string(result), text);
            return false;
        }
        if (!draw(p)) {
            return false;
        }
        p->frames++;
        if (p->o->tell != 0) {
            tell(p);
        }
    }
    return true;
}

static bool play_sessions(playing *p)
{
    bool good;
    do {
        good = begin(p) && play(p) && live_end(&p->live) == VBSS_OK;
        live_destroy(&p->live);
    } while (good && p->again);
    return good;
}

int mode_live(const options *o)
{
    static playing p;
    p.o = o;
    p.desk = (desk){&p, on_moved, on_wheeled, on_pressed, on_key};
    if (live_find(o->live) == NULL) {
        fprintf(stderr, "viewer: there is no scene %s; there are\n", o->live);
        for (size_t i = 0; live_at(i) != NULL; i++) {
            fprintf(stderr, "  %-8s %s\n", live_at(i)->name, live_at(i)->what);
        }
        return 2;
    }
    if (!window_begin(&p.window, &p.show, o->width, o->height, o->looks)) {
        return MODE_NO_OPENGL;
    }
    bool good = play_sessions(&p);
    window_end(&p.window, &p.show);
    return good ? 0 : 1;
}
