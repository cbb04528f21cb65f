#include "trainee/trainee.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#define FRAME 0.016
#define SEES 0.2e-3    /* m: error of the view, standard deviation */
#define SHADE 0.2      /* error of a tension that is read from a colour, share */
#define SPEED 0.10     /* m/s, of a movement in the middle */
#define SHORTEST 0.3   /* s, of a movement */
#define NOTCH_ROLL 0.1 /* rad */
#define BLOCKED 0.75   /* share of a movement that is not made */

enum { STEPS = 16, MAX_MOVEMENTS = 12 };

/* ---- chance */

static double normal_of(uint64_t *random)
{
    double sum = -6.0;
    for (int i = 0; i < 12; i++) {
        sum += hand_chance(random);
    }
    return sum;
}

static double normal(trainee *t)
{
    return normal_of(&t->random);
}

static vec error_of(trainee *t, double size)
{
    return v3(size * normal(t), size * normal(t), size * normal(t));
}

/* ---- sight */

static void observe(trainee *t)
{
    sight *s = &t->past[t->frames % (TRAINEE_DELAY + 1)];
    vbss_needle_state needle;
    vbss_session_status status;
    const stitch *of = t->live.stage.tasked;
    memset(s, 0, sizeof *s);
    for (int side = 0; side < SIDES; side++) {
        vbss_grasper_state tool;
        (void)vbss_grasper_get_state(t->live.stage.graspers[side], &tool, sizeof tool);
        s->tip[side] = v_add(v_load(tool.position), error_of(t, SEES));
        s->jaws[side] = v_scale(-1.0, hand_rotate(tool.orientation, v3(0.0, 0.0, 1.0)));
        s->opens[side] = hand_rotate(tool.orientation, v3(1.0, 0.0, 0.0));
        s->has_needle[side] = tool.needle != 0;
        s->holds[side] = tool.needle != 0 || tool.grasp_count > 0 || tool.drain != 0;
        s->shears[side] = tool.kind == VBSS_GRASPER_KIND_SHEARS;
    }
    (void)vbss_session_get_status(t->live.stage.task.session, &status, sizeof status);
    for (int i = 0; i < 2; i++) {
        s->tension[i] = status.tension[i] * (1.0 + SHADE * normal_of(&t->shades));
    }
    (void)vbss_needle_get_state(of->site.needle, &needle, sizeof needle);
    s->needle = v_add(v_load(needle.tip), error_of(t, SEES));
    s->swage = v_add(v_load(needle.swage), error_of(t, SEES));
    (void)vbss_session_get_coaching(t->live.stage.task.session, &s->coach, sizeof s->coach);
}

const sight *trainee_see(const trainee *t)
{
    uint64_t at = t->frames > TRAINEE_DELAY ? t->frames - TRAINEE_DELAY : 0;
    return &t->past[at % (TRAINEE_DELAY + 1)];
}

vbss_session_phase trainee_phase(const trainee *t)
{
    vbss_session_status status;
    (void)vbss_session_get_status(t->live.stage.task.session, &status, sizeof status);
    return status.phase;
}

bool trainee_has_ended(const trainee *t, vbss_session_exercise_state *state)
{
    return vbss_session_get_exercise(t->live.stage.task.session, state, sizeof *state) == VBSS_OK &&
           (state->outcome != VBSS_SESSION_OUTCOME_NONE ||
            trainee_phase(t) >= VBSS_SESSION_PHASE_DONE);
}

/* The session's events since it was last asked; the trainee does not see them. */
static void print_events(trainee *t)
{
    vbss_session *session = t->live.stage.task.session;
    vbss_session_status status;
    char words[TASK_WORDS];
    (void)vbss_session_get_status(session, &status, sizeof status);
    for (; t->printed < status.event_count; t->printed++) {
        vbss_session_event e;
        if (vbss_session_get_event(session, t->printed, &e, sizeof e) == VBSS_OK &&
            e.kind != VBSS_SESSION_EVENT_AID && e.kind != VBSS_SESSION_EVENT_GOAL) {
            task_words(&e, words);
            printf("    %7.2f s * %s\n", e.time, words);
        }
    }
}

void trainee_say(trainee *t, const char *what)
{
    const vbss_session_coaching *c = &trainee_see(t)->coach;
    if (t->verbose) {
        vbss_session_status status;
        (void)vbss_session_get_status(t->live.stage.task.session, &status, sizeof status);
        print_events(t);
        printf("  %6.2f s, slit %.2f mm, %s: %s [%.1f mm, %.2f rad, %.2f turns, %.2f N, %.2f mm; "
               "pulls %.2f, %.2f N] %s\n",
               t->live.time, 1e3 * status.gap, what, c->sentence, 1e3 * c->distance, c->angle,
               c->turns, c->force, 1e3 * c->length, trainee_see(t)->tension[0],
               trainee_see(t)->tension[1], c->mistake_sentence);
        fflush(stdout);
    }
}

/* ---- time */

/* What is counted of the try; the trainee does not see it. */
static void count(trainee *t)
{
    vbss_session_status status;
    (void)vbss_session_get_status(t->live.stage.task.session, &status, sizeof status);
    t->tension = fmax(t->tension, fmax(status.tension[0], status.tension[1]));
    for (int side = 0; side < SIDES; side++) {
        vbss_grasper_state tool;
        (void)vbss_grasper_get_state(t->live.stage.graspers[side], &tool, sizeof tool);
        t->force = fmax(t->force, v_length(v_load(tool.hand_force)));
    }
}

static bool pass_frame(trainee *t)
{
    vbss_session_exercise_state state;
    for (int i = 0; i < STEPS; i++) {
        if (live_step(&t->live) != VBSS_OK) {
            return false;
        }
        count(t);
    }
    t->frames++;
    observe(t);
    return !trainee_has_ended(t, &state);
}

bool trainee_wait(trainee *t, int frames)
{
    for (int i = 0; i < frames; i++) {
        if (!pass_frame(t)) {
            return false;
        }
    }
    return true;
}

bool trainee_finish_motion(trainee *t)
{
    return trainee_wait(t, TRAINEE_DELAY + 6); /* and the tool is there */
}

/* ---- done */

/* Counts of the mouse and notches of the wheel. */
static void push(trainee *t, int side, vec by)
{
    mouse_hand *m = &t->live.hands[side];
    vec right = v_load(m->mapping.right), up = v_load(m->mapping.up), away = v_cross(up, right);
    mouse_hand_move(m, false, v_dot(by, right) / m->mapping.mouse_metres,
                    v_dot(by, up) / m->mapping.mouse_metres,
                    v_dot(by, away) / m->mapping.mouse_depth);
}

bool trainee_move(trainee *t, int side, vec by)
{
    double length = v_length(by), time = fmax(SHORTEST, 1.5 * length / SPEED), before = 0.0;
    int frames = (int)ceil(time / FRAME);
    by = v_add(by, error_of(t, t->noise * length));
    t->live.active = side;
    for (int i = 1; i <= frames; i++) {
        double x = (double)i / frames,
               now = x * x * x * (10.0 + x * (6.0 * x - 15.0)); /* least jerk */
        push(t, side, v_scale(now - before, by));
        before = now;
        if (!trainee_wait(t, 1)) {
            return false;
        }
    }
    return trainee_finish_motion(t);
}

bool trainee_go(trainee *t, int side, vec to, double near)
{
    for (int i = 0; i < MAX_MOVEMENTS; i++) {
        vec by = v_sub(to, trainee_see(t)->tip[side]);
        if (v_length(by) < near) {
            return true;
        }
        if (!trainee_move(t, side, by)) {
            return false;
        }
        vec left = v_sub(to, trainee_see(t)->tip[side]);
        if (v_length(left) > BLOCKED * v_length(by) && v_length(by) > 1e-3) {
            return trainee_move(t, side,
                                v_scale(-0.7, left)); /* against something: it does not push on */
        }
    }
    return true;
}

bool trainee_roll(trainee *t, int side, double angle)
{
    int notches = (int)floor(fabs(angle) / NOTCH_ROLL + 0.5);
    for (int i = 0; i < notches; i++) {
        mouse_hand_move(&t->live.hands[side], true, 0.0, 0.0, angle > 0.0 ? 1.0 : -1.0);
        if (!trainee_wait(t, 3)) {
            return false;
        }
    }
    return trainee_finish_motion(t);
}

#define TURN_SPEED 1.5 /* rad/s, on average */
#define TURNED 0.995   /* cosine */
#define TURNED_WELL 0.9995

/* The turn about an axis in the plane of the picture that takes one direction to the other: a mouse turns no tool about the line of
 * sight. */
static vec turn_between(const vbss_mapping_config *c, vec from, vec to)
{
    vec away = v_cross(v_load(c->up), v_load(c->right)), axis = v_cross(away, v_sub(to, from));
    if (v_length(axis) < 1e-6) {
        return v3(0.0, 0.0, 0.0);
    }
    axis = v_unit(axis);
    vec a = v_along(from, -v_dot(from, axis), axis), b = v_along(to, -v_dot(to, axis), axis);
    return v_scale(atan2(v_dot(axis, v_cross(a, b)), v_dot(a, b)), axis);
}

static bool turn(trainee *t, int side, vec to, double turned)
{
    mouse_hand *m = &t->live.hands[side];
    vec right = v_load(m->mapping.right), up = v_load(m->mapping.up);
    t->live.active = side;
    for (int i = 0; i < 6; i++) {
        vec now = trainee_see(t)->jaws[side], by = turn_between(&m->mapping, now, to);
        if (v_dot(now, to) > turned) {
            return true;
        }
        by = v_scale(1.0 + t->noise * normal(t), by);
        int frames = (int)ceil(fmax(SHORTEST, v_length(by) / TURN_SPEED) / FRAME);
        for (int k = 0; k < frames; k++) {
            mouse_hand_move(m, true, v_dot(by, up) / m->mapping.mouse_radians / frames,
                            -v_dot(by, right) / m->mapping.mouse_radians / frames, 0.0);
            if (!trainee_wait(t, 1)) {
                return false;
            }
        }
        if (!trainee_finish_motion(t)) {
            return false;
        }
    }
    return true;
}

bool trainee_turn(trainee *t, int side, vec to)
{
    return turn(t, side, to, TURNED);
}

bool trainee_turn_well(trainee *t, int side, vec to)
{
    return turn(t, side, to, TURNED_WELL);
}

/* Angle between the direction and the plane across the opening, about the jaws' axis. */
static double off_across(const trainee *t, int side, vec direction)
{
    const sight *s = trainee_see(t);
    vec wide = v_cross(s->jaws[side], s->opens[side]);
    double along = v_dot(direction, s->opens[side]), across = v_dot(direction, wide);
    return across < 0.0 ? atan2(-along, -across) : atan2(along, across);
}

bool trainee_roll_across(trainee *t, int side, vec direction)
{
    double sign = 1.0, before = off_across(t, side, direction);
    for (int i = 0; i < 4 && fabs(before) > 0.15; i++) {
        if (!trainee_roll(t, side, sign * before)) {
            return false;
        }
        double now = off_across(t, side, direction);
        sign = fabs(now) > fabs(before) ? -sign : sign;
        before = now;
    }
    return true;
}

bool trainee_jaws(trainee *t, int side, bool closes)
{
    t->live.hands[side].closes = closes;
    return trainee_finish_motion(t) && trainee_wait(t, 20);
}

bool trainee_aid(trainee *t, uint32_t aid)
{
    return live_toggle_aid(&t->live, aid) == VBSS_OK && trainee_wait(t, 10);
}

bool trainee_follow(trainee *t, bool follows)
{
    bool does = (t->live.aids & (uint32_t)VBSS_SESSION_AID_FOLLOW) != 0;
    return does == follows || trainee_aid(t, VBSS_SESSION_AID_FOLLOW);
}

bool trainee_exchange(trainee *t, int side)
{
    (void)live_exchange(&t->live, side);
    return trainee_finish_motion(t);
}

/* ---- made */

void trainee_wake(trainee *t, uint64_t seed)
{
    memset(t, 0, sizeof *t);
    t->random = seed * 7919 + 17;
    t->shades = seed * 104729 + 29;
    t->noise = 0.06;
}

void trainee_open_eyes(trainee *t)
{
    const live_view *v = &t->live.view;
    const camera c = camera_from(v->target, v->aside, CAMERA_DOWN, v->away);
    mouse_hand_set_camera(&t->live.hands[LEFT], &c);
    mouse_hand_set_camera(&t->live.hands[RIGHT], &c);
    t->frames = 0;
    observe(t);
}

vbss_result trainee_begin(trainee *t, vbss_session_exercise exercise, const start_states *states,
                          uint64_t seed, const char *log)
{
    trainee_wake(t, seed);
    TRY(live_create_exercise(&t->live, exercise, states, NULL, log));
    trainee_open_eyes(t);
    return VBSS_OK;
}

void trainee_end(trainee *t)
{
    (void)live_end(&t->live);
    live_destroy(&t->live);
}
