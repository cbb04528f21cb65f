#include "throw/catch.h"

#include <string.h>

#define BEFORE 6e-3     /* of the jaws, from the place, before they advance */
#define ADVANCE 0.03    /* m/s */
#define ALIGNED 0.2     /* cosine of opening and thread */
#define LEVEL 0.3       /* sine */
#define TURNED 0.15     /* rad */
#define LONG_TURNED 1.5 /* s: no farther then */
#define CLEAR 3e-3      /* of the bend from drain and floor */
#define LEARN 4.0       /* 1/s, of the correction */
#define PATIENCE 3.0    /* s */
#define A_WHILE 1.0     /* s */
#define PUSHED 0.03     /* s, of what is felt on the way to the thread, which is something else */
#define LOST 12e-3      /* m: after so long an advance the thread goes with the jaws */
#define OFF 15e-3       /* m, back from there */
#define OFF_UP 2.0      /* so much more upward than out of the jaws' plane */
#define BACK_TIME 0.6   /* s, at most */
#define BACK_SPEED 0.05
enum { TRIES = 5 };

void catch_begin(catch_run *t, senses *see, hand *h, uint32_t node, double opening, double speed)
{
    memset(t, 0, sizeof *t);
    t->see = see;
    t->hand = h;
    t->node = node;
    t->behind = GRASP_BEHIND;
    t->opening = opening;
    t->speed = speed;
}

static void enter(catch_run *t, catch_state state)
{
    t->state = state;
    t->since = 0.0;
}

static const hand_pose *pose_of(const catch_run *t)
{
    return t->hand == t->see->w ? &t->see->tool_w : &t->see->tool_c;
}

static vec direction(const senses *s, uint32_t node)
{
    uint32_t from = node > 3 ? node - 3 : 0, to = node + 3 < s->nodes ? node + 3 : s->nodes - 1;
    return v_unit(v_sub(s->x[to], s->x[from]));
}

/* How a tool would stand with its jaws at a place, rolled so. */
typedef struct stance {
    vec handle, opening, bend;
} stance;

static stance stance_at(const hand *h, vec place, vec n, double far, vec roll)
{
    double bend = h->shape.driver_bend, sine = hand_reach(h) * vbss_sin(bend) / far;
    double cosine = sqrt(1.0 - sine * sine);
    vec y = v_along(v_scale(cosine, roll), sine, n), z = v_along(v_scale(cosine, n), -sine, roll);
    stance s = {.handle = v_along(v_scale(vbss_sin(bend), y), vbss_cos(bend), z),
                .opening = v_cross(y, z)};
    s.bend = v_along(place, hand_reach(h) - GRASP_BEHIND, s.handle);
    return s;
}

static double clearance(const hand *h, vec bend)
{
    return smaller(height_above_drain(bend), bend.z - FLOOR_HEIGHT) - h->shape.shaft_radius;
}

vec catch_point(const senses *s, const hand *h, uint32_t node)
{
    const hand_pose *p = h == s->w ? &s->tool_w : &s->tool_c;
    vec trocar = seen(h, h->trocar), place = s->x[node], tangent = direction(s, node),
        best = p->handle;
    vec to = v_sub(trocar, place), n = v_unit(to), now = v_unit(v_across(p->handle, n));
    vec side = v_cross(n, now);
    double smallest = 1e9;
    for (int i = -18; i < 18; i++) {
        double angle = 3.14159265358979 / 18.0 * i;
        vec roll = v_along(v_scale(vbss_cos(angle), now), vbss_sin(angle), side);
        stance t = stance_at(h, place, n, v_length(to), roll);
        double across = v_dot(t.opening, tangent) / ALIGNED;
        double near = larger(0.0, CLEAR - clearance(h, t.bend)) / 1e-3;
        double cost = across * across + near * near + angle * angle;
        if (cost < smallest) {
            smallest = cost;
            best = roll;
        }
    }
    return best;
}

/* Where the place is, seen from the jaws' grasping point. */
static vec off(const catch_run *t)
{
    const hand_pose *p = pose_of(t);
    return v_sub(t->see->x[t->node], v_along(p->tip, t->behind, p->handle));
}

/* The jaws open to both sides of the thread. */
static bool is_aligned(const catch_run *t)
{
    const senses *s = t->see;
    return fabs(v_dot(pose_of(t)->opening, direction(s, t->node))) < ALIGNED;
}

/* From where the jaws come: across the thread, in their own plane, from above; where that plane is level, from the side on which they
 * are, or they would sweep the thread aside. */
static vec approach(const catch_run *t)
{
    vec normal = v_unit(v_cross(pose_of(t)->opening, direction(t->see, t->node)));
    double away = fabs(normal.z) > LEVEL ? normal.z : -v_dot(normal, off(t));
    return away < 0.0 ? v_scale(-1.0, normal) : normal;
}

static vec before(const catch_run *t, double distance)
{
    vec grasp = v_along(t->see->x[t->node], -t->behind, pose_of(t)->handle);
    return v_along(grasp, distance, approach(t));
}

/* Out of the jaws' plane and upward, until what was pushed is let alone; then it is aimed at anew. */
static void draw_back(catch_run *t)
{
    if (++t->tries >= TRIES) {
        enter(t, CATCH_MISSED);
        return;
    }
    vec retreat = v_unit(v_along(approach(t), OFF_UP, v3(0.0, 0.0, 1.0)));
    t->off = v_along(pose_of(t)->tip, OFF, retreat);
    t->pushed = 0.0;
    hand_target(t->hand, t->hand->nature.target_end);
    enter(t, CATCH_BACK);
}

static bool pushes(catch_run *t, double dt)
{
    bool pressed = t->minds > 0.0 && !t->hand->holds && v_length(t->hand->felt) > t->minds;
    t->pushed = pressed ? t->pushed + dt : 0.0;
    return t->pushed > PUSHED;
}

static void come(catch_run *t)
{
    const hand_pose *p = pose_of(t);
    vec at = before(t, BEFORE);
    bool turned = hand_is_turned(t->hand, TURNED) || t->since > LONG_TURNED;
    bool there = v_distance(p->tip, at) < 2e-3 && turned;
    hand_go(t->hand, at, t->speed);
    hand_open(t->hand, there && is_aligned(t) ? t->opening : t->hand->wanted_opening);
    if (there && t->hand->opening > 0.95 * t->opening) {
        t->correction = v3(0.0, 0.0, 0.0);
        t->begun = p->tip;
        enter(t, CATCH_ADVANCE);
    } else if (t->since > PATIENCE) {
        draw_back(t);
    }
}

static void advance(catch_run *t, double dt)
{
    const hand_pose *p = pose_of(t);
    vec missing = off(t), across = v_cross(p->opening, p->handle);
    bool between = fabs(v_dot(missing, across)) < 0.35e-3 &&
                   fabs(v_dot(missing, p->handle)) < 0.8e-3 &&
                   fabs(v_dot(missing, p->opening)) < 1e-3;
    if (v_length(missing) < 4e-3) {
        t->correction = v_limit(v_along(t->correction, LEARN * dt, missing), 3e-3);
    }
    hand_go(t->hand, v_add(t->correction, before(t, 0.0)), ADVANCE);
    if (between || (t->resolute && t->since > A_WHILE)) {
        enter(t, CATCH_CLOSE);
    } else if (v_distance(p->tip, t->begun) > LOST || t->since > PATIENCE) {
        draw_back(t);
    }
}

static void close_jaws(catch_run *t)
{
    hand_go(t->hand, v_add(t->correction, before(t, 0.0)), ADVANCE);
    hand_open(t->hand, 0.0);
    if (t->hand->holds) {
        enter(t, CATCH_HELD);
    } else if (t->since > 0.5) {
        draw_back(t);
    }
}

static void go_back(catch_run *t)
{
    hand_open(t->hand, t->opening);
    hand_go(t->hand, t->off, BACK_SPEED);
    if (t->since > BACK_TIME || v_distance(pose_of(t)->tip, t->off) < 2e-3) {
        enter(t, CATCH_COME);
    }
}

void catch_step(catch_run *t, double dt)
{
    t->since += dt;
    if (t->state <= CATCH_CLOSE && pushes(t, dt)) {
        draw_back(t);
    }
    switch (t->state) {
    case CATCH_COME:
        come(t);
        break;
    case CATCH_ADVANCE:
        advance(t, dt);
        break;
    case CATCH_CLOSE:
        close_jaws(t);
        break;
    case CATCH_BACK:
        go_back(t);
        break;
    default:
        break;
    }
}
