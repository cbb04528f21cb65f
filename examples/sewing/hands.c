/* The hands, by the clock: one drives the needle along its arc through the tissue, the other draws it out and the thread after it;
 * then both ends of the thread are drawn. */
#include "script.h"

#include <math.h>

#include "base/error.h"
#include "base/rotation.h"

/* The circle of the needle; angles on it from +x, in the sense of its path: down at the left, up at the right. */
static const double height = 4e-3 /* m, of its centre over the surface */,
                    beyond = 2e-3 /* m, of jaws over the needle */;
static const double begin = 200.0 * SCRIPT_DEGREE, driven = 372.0 * SCRIPT_DEGREE,
                    out = 545.0 * SCRIPT_DEGREE; /* of the tip */
static const double behind[2] = {175.0 * SCRIPT_DEGREE,
                                 14.0 * SCRIPT_DEGREE}; /* the tip: the jaws */
static const double retreat = 25e-3 /* m */, draw[3] = {12e-3, 45e-3, 0.0} /* m */,
                    pull = 0.3 /* N */, tail_speed = 30e-3 /* m/s */,
                    tail_stiffness = 50.0 /* N/m */;

/* ---- phases */

typedef enum phase {
    CLOSE,  /* the first hand takes the needle */
    DRIVE,  /* through the tissue, until the tip stands out */
    REACH,  /* the second hand comes beside the tip */
    TAKE,   /* and closes */
    LET_GO, /* the first hand opens, and goes away */
    LEAVE,
    TURN, /* the second turns the needle out */
    DRAW, /* and draws the thread through */
    PULL, /* at the tail too */
    REST, /* both hold */
    DONE
} phase;

static const struct {
    const char *name;
    double seconds;
} phases[DONE] = {{"take the needle", 0.3},
                  {"drive it", 2.2},
                  {"reach for the tip", 0.5},
                  {"take the tip", 0.3},
                  {"let go", 0.3},
                  {"leave", 0.4},
                  {"turn it out", 2.2},
                  {"draw the thread", 1.2},
                  {"pull the tail", 0.9},
                  {"rest", 0.5}};

/* The phase at a time, and which part of it is over, 0 to 1. */
static phase phase_at(double time, double *part)
{
    uint32_t i = 0;
    while (i < DONE && time >= phases[i].seconds) {
        time -= phases[i++].seconds;
    }
    *part = i < DONE ? time / phases[i].seconds : 1.0;
    return (phase)i;
}

const char *sewing_phase(const sewing *s)
{
    double part;
    const phase now = phase_at(s->time, &part);
    return now == DONE ? "done" : phases[now].name;
}

/* ---- poses */

static quat turn_about_z(double angle)
{
    return vbss_quat_from_rotation_vector(vec3_make(0.0, 0.0, angle));
}

pose script_needle(double turned)
{
    return pose_make(vec3_make(0.0, height, 0.0), turn_about_z(turned));
}

pose script_tool(const sewing_hand *hand, vec3 away)
{
    const quat radial = turn_about_z(hand->angle);
    vec3 at = quat_rotate(radial, vec3_make(SCRIPT_RADIUS, 0.0, 0.0));
    at = vec3_add(at, vec3_make(0.0, height, -hand->side * beyond));
    const quat half = hand->side > 0.0 ? quat_identity() : quat_make(0.0, 1.0, 0.0, 0.0);
    return pose_make(vec3_add(at, away), quat_mul(radial, half));
}

void script_begin(sewing *s)
{
    s->turned = begin;
    s->hands[0] = (sewing_hand){.side = 1.0, .angle = begin - behind[0]};
    s->hands[1] = (sewing_hand){.side = -1.0, .angle = driven - behind[1]};
    s->hands[1].tip = vec3_make(0.0, 0.0, -retreat);
}

/* ---- a step */

static double between(double from, double to, double part)
{
    return from + (to - from) * part;
}

static vbss_result place(sewing_hand *hand, double opening)
{
    double position[3], orientation[4];
    pose_store(script_tool(hand, hand->tip), position, orientation);
    VBSS_TRY(vbss_grasper_set_target(hand->tool, position, orientation));
    return vbss_grasper_set_opening(hand->tool, opening);
}

static vbss_result hold_tail(sewing *s)
{
    vbss_view x;
    vbss_thread_attachment hand;
    VBSS_TRY(vbss_thread_get_view(s->thread, VBSS_THREAD_VIEW_POSITIONS, &x, sizeof x));
    VBSS_TRY(vbss_thread_attachment_init(&hand, sizeof hand));
    hand.kind = VBSS_THREAD_ATTACHMENT_SPRING;
    hand.node = s->segments;
    hand.stiffness = tail_stiffness;
    hand.damping = 0.1;
    s->tail_target = vec3_load((const double *)x.data + 3 * (size_t)s->segments);
    vec3_store(hand.position, s->tail_target);
    return vbss_thread_attach(s->thread, &hand, &s->tail);
}

/* The tail is drawn to the left and up, until it bears the pull. */
static vbss_result pull_tail(sewing *s)
{
    vbss_thread_reaction reaction;
    if (s->tail == 0) {
        VBSS_TRY(hold_tail(s));
    }
    VBSS_TRY(vbss_thread_get_reaction(s->thread, s->tail, &reaction, sizeof reaction));
    const double lacking = 1.0 - vec3_norm(vec3_load(reaction.force)) / pull;
    const vec3 goal = vec3_make(-90e-3, 70e-3, 0.0);
    const vec3 direction = vec3_unit_or(vec3_sub(goal, s->tail_target), vec3_zero());
    const double step = tail_speed * SEWING_STEP * fmax(-1.0, fmin(1.0, 4.0 * lacking));
    s->tail_target = vec3_add_scaled(s->tail_target, step, direction);
    double target[3];
    vec3_store(target, s->tail_target);
    return vbss_thread_set_attachment_target(s->thread, s->tail, target, NULL);
}

static vbss_result move_hands(sewing *s)
{
    double part;
    const phase now = phase_at(s->time, &part);
    sewing_hand *first = &s->hands[0], *second = &s->hands[1];
    if (now == DRIVE) {
        s->turned = between(begin, driven, part);
    } else if (now == TURN) {
        s->turned = between(driven, out, part);
    }
    if (now <= LEAVE) {
        first->angle = (now < LEAVE ? s->turned : driven) - behind[0];
        first->tip = vec3_make(0.0, 0.0, now == LEAVE ? retreat * part : 0.0);
    }
    second->angle = (now >= TURN ? s->turned : driven) - behind[1];
    second->tip = vec3_zero();
    if (now <= REACH) {
        second->tip = vec3_make(0.0, 0.0, -retreat * (now == REACH ? 1.0 - part : 1.0));
    } else if (now >= DRAW) {
        second->tip = vec3_scale(vec3_load(draw), now == DRAW ? part : 1.0);
    }
    VBSS_TRY(place(first, now < LET_GO ? 0.0 : SCRIPT_OPENING));
    VBSS_TRY(place(second, now >= TAKE ? 0.0 : SCRIPT_OPENING));
    return now >= PULL ? pull_tail(s) : VBSS_OK;
}

static vbss_result count_events(sewing *s)
{
    vbss_scene_event events[64];
    uint32_t count = 64;
    while (count == 64) {
        VBSS_TRY(vbss_scene_take_events(s->scene, events, sizeof events[0], 64, &count, NULL));
        for (uint32_t i = 0; i < count; i++) {
            s->punctures += events[i].kind == VBSS_SCENE_EVENT_PUNCTURE;
            s->passed += events[i].kind == VBSS_SCENE_EVENT_PASSED;
        }
    }
    return VBSS_OK;
}

/* The tissue goes where it goes without the stitch, the scene adds the forces, and the tissue bears them in the same step. */
vbss_result sewing_step(sewing *s, bool *is_done)
{
    static double vertices[SEWING_VERTICES][3];
    vbss_view forces;
    double part;
    VBSS_TRY(move_hands(s));
    fem_predict(&s->tissue, vertices);
    VBSS_TRY(vbss_scene_move_surface(s->scene, s->surface, vertices[0], SEWING_VERTICES));
    VBSS_TRY(vbss_scene_step(s->scene, SEWING_STEP));
    VBSS_TRY(vbss_scene_get_surface_view(s->scene, s->surface, VBSS_SCENE_SURFACE_VIEW_FORCES,
                                         &forces, sizeof forces));
    fem_apply(&s->tissue, (const double(*)[3])forces.data);
    s->time += SEWING_STEP;
    *is_done = phase_at(s->time, &part) == DONE;
    return count_events(s);
}
