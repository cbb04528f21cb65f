#include "throw/hand.h"

#include <string.h>

#include "throw/wire.h"

#define PI 3.14159265358979324
#define LAG 0.04
#define ACCELERATION 1.5
#define STRONG 4.0 /* N; twice as much stops it */
#define ROLL_SPEED 4.0
#define FACE_SPEED 4.0 /* rad/s */
/* Of the coupling, N/m and N s/m: no arm is there that would buzz. */
#define STIFFNESS 2000.0
#define DAMPING 10.0
#define JAW_SPEED 8.0 /* of the handle's opening, 1/s */
#define TREMOR_LOW 9.0
#define TREMOR_HIGH 12.0

double hand_chance(uint64_t *state)
{
    uint64_t z = (*state += 0x9e3779b97f4a7c15u);
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return (double)((z ^ (z >> 31)) >> 11) * 0x1p-53;
}

static vec any_direction(uint64_t *state)
{
    double z = 2.0 * hand_chance(state) - 1.0;
    double angle = 2.0 * PI * hand_chance(state);
    double r = sqrt(1.0 - z * z);
    return v3(r * vbss_cos(angle), r * vbss_sin(angle), z);
}

/* ---- the pose that a trocar leaves: where the tip is, and how the tool is rolled */

void hand_orientation(vec x, vec y, vec z, double q[4])
{
    double trace = x.x + y.y + z.z;
    if (trace > 0.0) {
        q[0] = 1.0 + trace;
        q[1] = y.z - z.y;
        q[2] = z.x - x.z;
        q[3] = x.y - y.x;
    } else if (x.x > y.y && x.x > z.z) {
        q[0] = y.z - z.y;
        q[1] = 1.0 + x.x - y.y - z.z;
        q[2] = y.x + x.y;
        q[3] = z.x + x.z;
    } else if (y.y > z.z) {
        q[0] = z.x - x.z;
        q[1] = y.x + x.y;
        q[2] = 1.0 + y.y - x.x - z.z;
        q[3] = z.y + y.z;
    } else {
        q[0] = x.y - y.x;
        q[1] = z.x + x.z;
        q[2] = z.y + y.z;
        q[3] = 1.0 + z.z - x.x - y.y;
    }
    double length = sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
    for (int i = 0; i < 4; i++) {
        q[i] /= length;
    }
}

/* The bend lies beside the tip, toward +y of the tool, so the shaft does not point from the tip to the trocar. */
static void orient_through_trocar(hand *h, vec tip, double q[4])
{
    vec to = v_sub(h->trocar, tip), n = v_unit(to);
    double sine = hand_reach(h) * vbss_sin(h->shape.driver_bend) / v_length(to);
    double cosine = sqrt(1.0 - sine * sine);
    h->roll = v_unit(v_across(h->roll, n));
    vec y = v_along(v_scale(cosine, h->roll), sine, n);
    vec z = v_along(v_scale(cosine, n), -sine, h->roll);
    hand_orientation(v_cross(y, z), y, z, q);
}

/* A free tool is as its hand is. */
static void show(hand *h, vec tip)
{
    h->shown = tip;
    if (h->shape.has_trocar) {
        orient_through_trocar(h, tip, h->shown_orientation);
    } else {
        memcpy(h->shown_orientation, h->face, sizeof h->face);
    }
}

void hand_stiffen(vbss_grasper_config *shape)
{
    shape->stiffness = STIFFNESS;
    shape->damping = DAMPING;
}

vbss_result hand_create_with(hand *h, throw_rig *s, const hand_nature *nature,
                             const vbss_grasper_config *shape, vec tip, vec point, double opening)
{
    memset(h, 0, sizeof *h);
    h->rig = s;
    h->nature = *nature;
    h->random = nature->seed;
    h->side = 1.0;
    h->shape = *shape;
    h->trocar = v_load(shape->trocar);
    h->through = shape->has_trocar != 0;
    h->goal = h->at = tip;
    h->point = h->roll = point;
    h->face[0] = h->wanted_face[0] = 1.0;
    h->limit = 0.05;
    h->tool = VBSS_DEVICE_TOOL_NEEDLE_DRIVER;
    for (int i = 0; i < 2; i++) {
        h->shake[i] = any_direction(&h->random);
        h->phase[i] = 2.0 * PI * hand_chance(&h->random);
    }
    h->opening = h->wanted_opening = opening;
    show(h, tip);
    return wire_create(h);
}

vbss_result hand_create(hand *h, throw_rig *s, const hand_nature *nature, vec trocar, vec tip,
                        vec point, double opening)
{
    vbss_grasper_config shape;
    TRY(vbss_grasper_config_init(&shape, sizeof shape));
    TRY(vbss_grasper_config_preset(&shape, VBSS_GRASPER_PRESET_ANGLED));
    /* shears like the driver, so that a hand knows one tool */
    shape.shears_length = shape.driver_length;
    shape.shears_bend = shape.driver_bend;
    shape.shears_neck = shape.driver_neck;
    shape.exchange_distance = EXCHANGE_DISTANCE;
    hand_stiffen(&shape);
    shape.has_trocar = 1;
    v_store(shape.trocar, trocar);
    return hand_create_with(h, s, nature, &shape, tip, point, opening);
}

/* ---- what it is told */

void hand_go(hand *h, vec tip, double speed)
{
    h->goal = seen(h, tip);
    h->limit = speed * h->nature.speed;
}

void hand_turn(hand *h, vec point)
{
    h->point = seen(h, point);
}

void hand_face(hand *h, const double q[4])
{
    h->through = false;
    memcpy(h->wanted_face, q, sizeof h->wanted_face);
}

void hand_through(hand *h, vec point)
{
    if (!h->through) {
        h->roll = hand_rotate(h->face, v3(0.0, 1.0, 0.0));
        h->point = h->roll;
    }
    h->through = true;
    h->trocar = point;
}

void hand_open(hand *h, double opening)
{
    h->wanted_opening = opening;
}

void hand_take_tool(hand *h, vbss_device_tool tool)
{
    h->tool = tool;
}

void hand_yield(hand *h, const hand_pose *p, vec *carrot, vec knot, double felt, double dt)
{
    double speed = clamp(0.02 * felt, 0.002, 0.02) * h->nature.speed;
    *carrot = v_along(*carrot, speed * dt, v_unit(v_sub(knot, p->tip)));
    hand_go(h, *carrot, 0.05);
}

void hand_target(hand *h, double size)
{
    h->target_at = v_scale(size, any_direction(&h->random));
}

/* ---- how it moves */

/* Nobody presses on against what is felt as hard: what jams is let be. */
static vec give(const hand *h, vec velocity)
{
    double force = v_length(h->felt);
    vec direction = v_unit(h->felt);
    double against =
        larger(-v_dot(velocity, direction), 0.0) * clamp(force / STRONG - 1.0, 0.0, 1.0);
    return force > STRONG ? v_along(velocity, against, direction) : velocity;
}

static void follow(hand *h, double dt)
{
    vec to_goal = v_sub(v_add(h->goal, h->target_at), h->at);
    double stop =
        sqrt(2.0 * 0.7 * ACCELERATION * v_length(to_goal)); /* from where it can still stop */
    vec wanted = v_limit(v_scale(1.0 / LAG, to_goal), smaller(h->limit, stop));
    vec change = v_limit(v_sub(wanted, h->velocity), ACCELERATION * dt);
    h->velocity = give(h, v_add(h->velocity, change));
    h->at = v_along(h->at, dt, h->velocity);
}

/* About the line from tip to trocar, to where it shall point. */
static double angle_to_turn(const hand *h, vec *now, vec *side)
{
    vec n = v_unit(v_sub(h->trocar, h->at));
    vec wanted = v_unit(v_across(h->point, n));
    *now = v_unit(v_across(h->roll, n));
    *side = v_cross(n, *now);
    return vbss_atan2(v_dot(wanted, *side), v_dot(wanted, *now));
}

bool hand_is_turned(const hand *h, double within)
{
    vec now, side;
    return fabs(angle_to_turn(h, &now, &side)) < within;
}

static void turn(hand *h, double dt)
{
    double limit = ROLL_SPEED * h->nature.speed * dt;
    vec now, side;
    double angle = clamp(angle_to_turn(h, &now, &side) * dt / LAG, -limit, limit);
    h->roll = v_along(v_scale(vbss_cos(angle), now), vbss_sin(angle), side);
}

/* Part of the way of the chord between the two, the shorter way round. */
static void face(hand *h, double dt)
{
    double limit = FACE_SPEED * h->nature.speed * dt, dot = 0.0, length = 0.0;
    for (int i = 0; i < 4; i++) {
        dot += h->face[i] * h->wanted_face[i];
    }
    double angle = 2.0 * vbss_acos(smaller(fabs(dot), 1.0));
    double share = angle * dt > LAG * limit ? limit / angle : dt / LAG;
    for (int i = 0; i < 4; i++) {
        double wanted = dot < 0.0 ? -h->wanted_face[i] : h->wanted_face[i];
        h->face[i] += share * (wanted - h->face[i]);
        length += h->face[i] * h->face[i];
    }
    for (int i = 0; i < 4; i++) {
        h->face[i] /= sqrt(length);
    }
}

static vec tremor(const hand *h)
{
    double low = vbss_sin(2.0 * PI * TREMOR_LOW * h->time + h->phase[0]);
    double high = vbss_sin(2.0 * PI * TREMOR_HIGH * h->time + h->phase[1]);
    double size = h->nature.tremor / sqrt(2.0);
    return v_along(v_scale(size * low, h->shake[0]), size * high, h->shake[1]);
}

vbss_result hand_step(hand *h, double dt)
{
    double limit = JAW_SPEED * h->nature.speed * dt;
    h->time += dt;
    follow(h, dt);
    if (h->through) {
        turn(h, dt);
    }
    if (h->through && !h->shape.has_trocar) {
        orient_through_trocar(h, h->at, h->wanted_face);
    }
    face(h, dt);
    h->opening += clamp(h->wanted_opening - h->opening, -limit, limit);
    show(h, v_add(h->at, tremor(h)));
    return wire_report(h);
}

/* ---- what it feels and where it is */

vbss_result hand_feel(hand *h)
{
    vbss_grasper_state state;
    vbss_scene_grasp grasp;
    TRY(vbss_grasper_get_state(h->grasper, &state, sizeof state));
    TRY(wire_feel(h, &state));
    h->felt = mirror_vec(h->rig->mirrored, v_load(state.hand_force));
    h->holds = state.grasp_count > 0;
    if (!h->holds) {
        h->pull = v3(0.0, 0.0, 0.0);
        return VBSS_OK;
    }
    TRY(vbss_scene_get_grasp(h->rig->scene, h->body, 0, &grasp, sizeof grasp));
    h->held_thread = grasp.body;
    h->place = throw_rig_place(h->rig, grasp.arc_length);
    h->node = (uint32_t)(h->place + 0.5);
    h->pull = seen_scene(h, v_scale(-1.0, v_load(grasp.force)));
    if (state.needle != 0) { /* the needle leans on the tool as well, which no hand feels */
        h->pull = v_limit(h->pull, v_length(v_load(state.hand_force)));
    }
    return VBSS_OK;
}

vec hand_rotate(const double q[4], vec v)
{
    vec r = v3(q[1], q[2], q[3]), t = v_scale(2.0, v_cross(r, v));
    return v_add(v_along(v, q[0], t), v_cross(r, t));
}

vbss_result hand_observe(const hand *h, hand_pose *pose)
{
    vbss_grasper_state s;
    double bend = h->shape.driver_bend;
    TRY(vbss_grasper_get_state(h->grasper, &s, sizeof s));
    vec tip = v_load(s.position),
        jaws = hand_rotate(s.orientation, v3(0.0, vbss_sin(bend), vbss_cos(bend)));
    vec shaft = hand_rotate(s.orientation, v3(0.0, 0.0, 1.0));
    vec corner = v_along(tip, hand_reach(h), jaws);
    pose->tip = seen_scene(h, tip);
    pose->handle = seen_scene(h, jaws);
    pose->bend = seen_scene(h, corner);
    pose->trocar = seen_scene(h, v_along(corner, h->shape.shaft_length, shaft));
    pose->opening = seen_scene(h, hand_rotate(s.orientation, v3(1.0, 0.0, 0.0)));
    return VBSS_OK;
}
