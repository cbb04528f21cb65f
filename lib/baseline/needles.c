/* Needles of the baseline. A needle follows the first tool whose jaws have closed on it,
 * exactly. A second tool waits until the first releases the needle, and leads it from then on. A
 * free needle flies, lands on the floor, and stays in the walls that it passes through:
 * docs/explanation/paper-needle.md. */
#include "baseline/scene.h"

#include "collision/closest.h"
#include "scene/tools/tools.h"
#include "scene/tuning.h"

/* Jaws hold a needle that lies across them: cosine of the largest angle, 45 degrees, between the
 * needle and the width of the jaws. Chosen. */
#define MIN_ACROSS 0.70710678118654752

/* ---- landing: the floor pushes the ends of capsules up and never pulls them down, so a needle
 * does not bounce */

/* The end of a capsule, on which the floor acts upward. */
typedef struct corner {
    vec3 arm, turn;       /* arm from the centre of mass; rotation by a unit impulse */
    double rise, impulse; /* rise by a unit impulse; sum of the impulses so far */
} corner;

typedef struct landing {
    const scene_rigid *needle;
    vec3 up;
    double height; /* smallest height of the wire's centre line, m */
    pose at;       /* pose without the floor */
    vec3 moved, turned;
    corner corners[NEEDLE_MAX_SEGMENTS + 1];
} landing;

static void set_corner(landing *l, uint32_t i)
{
    const vbss_rigid *body = &l->needle->body;
    const needle_object *n = l->needle->needle;
    corner *c = &l->corners[i];
    vec3 local =
        pose_apply_inverse(l->needle->frame, vbss_needle_point(n, vbss_needle_vertex_arc(n, i)));
    c->arm = quat_rotate(l->at.orientation, local);
    vec3 own = quat_rotate_back(l->at.orientation, vec3_cross(c->arm, l->up));
    own = vec3_make(own.x / body->inertia.x, own.y / body->inertia.y, own.z / body->inertia.z);
    c->turn = quat_rotate(l->at.orientation, own);
    c->rise = 1.0 / body->mass + vec3_dot(l->up, vec3_cross(c->turn, c->arm));
    c->impulse = 0.0;
}

static double height_of(const landing *l, const corner *c)
{
    vec3 moved = vec3_add(l->moved, vec3_cross(l->turned, c->arm));
    return vec3_dot(l->up, vec3_add(vec3_add(l->at.position, c->arm), moved)) - l->height;
}

/* One round of projected Gauss-Seidel. Returns the largest displacement of a corner, m. */
static double make_round(landing *l, uint32_t count)
{
    double max_displacement = 0.0;
    for (uint32_t i = 0; i < count; i++) {
        corner *c = &l->corners[i];
        double before = c->impulse;
        c->impulse = vbss_max(0.0, before - height_of(l, c) / c->rise);
        double more = c->impulse - before;
        l->moved = vec3_add_scaled(l->moved, more / l->needle->body.mass, l->up);
        l->turned = vec3_add_scaled(l->turned, more, c->turn);
        max_displacement = vbss_max(max_displacement, fabs(more) * c->rise);
    }
    return max_displacement;
}

static void begin_landing(landing *l, pose at, uint32_t count)
{
    l->at = at;
    l->moved = l->turned = vec3_zero();
    for (uint32_t i = 0; i < count; i++) {
        set_corner(l, i);
    }
}

static void land(const scene_object *s, const scene_rigid *r, pose *at)
{
    double thickness = r->needle->config.wire_radius + s->config.baseline->scene_thickness,
           below = 0.0;
    uint32_t count = r->needle->config.segment_count + 1;
    landing l;
    l.needle = r;
    l.up = s->floor_normal;
    l.height = s->config.floor_height + thickness;
    begin_landing(&l, *at, count);
    for (int i = 0; i < BASELINE_LANDING_ROUNDS &&
                    make_round(&l, count) > BASELINE_MIN_DEPTH_RATIO * thickness;
         i++) {
    }
    vbss_rigid_apply_increment(at, l.moved, l.turned);
    begin_landing(&l, *at, count);
    for (uint32_t i = 0; i < count; i++) { /* the rotation is finite, not linear */
        below = vbss_min(below, height_of(&l, &l.corners[i]));
    }
    at->position = vec3_add_scaled(at->position, -below, s->floor_normal);
}

/* ---- before a step: targets */

static bool is_in_a_wall(const scene_object *s, const scene_body *b)
{
    for (uint32_t i = 0; i < s->config.hole_capacity; i++) {
        if (s->holes[i].id != 0 && s->holes[i].needle == b->number) {
            return true;
        }
    }
    return false;
}

static vbss_rigid_motion fly(const scene_object *s, const scene_rigid *r,
                             const vbss_rigid_substep *whole)
{
    vbss_rigid body = r->body;
    vbss_rigid_motion flown;
    vbss_rigid_predict(&body, whole, &flown);
    pose at = flown.pose;
    if (s->config.floor != 0) {
        land(s, r, &at);
    }
    vbss_rigid_commit(&body, whole, &flown, &at);
    return body.now;
}

static void set_needle_target(const scene_object *s, scene_body *b, double h)
{
    scene_rigid *r = &b->rigid;
    const vbss_rigid_substep whole = {h, 0.0, 1.0};
    uint32_t leader = baseline_body_of(s, b)->leader;
    if (leader != 0) {
        const scene_rigid *tool = &vbss_scene_body(s, leader)->rigid;
        r->body.target_end = pose_mul(tool->body.target_end, tool->needle_grasp.pose_in_jaws);
        r->predicted = vbss_rigid_target_motion(&r->body, &whole);
    } else if (is_in_a_wall(s, b)) {
        r->predicted = (vbss_rigid_motion){r->body.now.pose, vec3_zero(), vec3_zero()};
    } else {
        r->predicted = fly(s, r, &whole);
        r->body.target_end = r->predicted.pose;
    }
}

static bool is_needle(const scene_body *b)
{
    return b->kind == SCENE_BODY_RIGID && b->rigid.needle != NULL;
}

void vbss_baseline_set_needle_targets(scene_object *s, double h)
{
    bool any = false;
    for (uint32_t i = 0; i < s->body_count; i++) {
        if (is_needle(&s->bodies[i])) {
            set_needle_target(s, &s->bodies[i], h);
            any = true;
        }
    }
    if (any) {
        vbss_scene_set_pin_targets(s);
    }
}

/* ---- after a step: leaders */

static const scene_body *needle_of(const scene_object *s, const scene_body *tool)
{
    return vbss_scene_body(s, tool->rigid.needle_grasp.needle);
}

static bool has_closed_on_one(const scene_body *b)
{
    return b->kind == SCENE_BODY_RIGID && b->rigid.grasper != NULL &&
           b->rigid.needle_grasp.needle != 0;
}

/* The needle keeps its present pose relative to the tool. */
static void lead(scene_object *s, scene_body *tool)
{
    const scene_body *needle = needle_of(s, tool);
    baseline_body_of(s, needle)->leader = tool->number;
    tool->rigid.needle_grasp.pose_in_jaws =
        pose_mul(pose_inverse(tool->rigid.body.now.pose), needle->rigid.body.now.pose);
    vbss_scene_emit_needle_grasp_event(s, VBSS_SCENE_EVENT_GRASP, tool);
}

static void let_go(scene_object *s, scene_body *tool)
{
    baseline_body *needle = baseline_body_of(s, needle_of(s, tool));
    if (needle->leader == tool->number) {
        needle->leader = 0;
        vbss_scene_emit_needle_grasp_event(s, VBSS_SCENE_EVENT_RELEASE, tool);
    }
    tool->rigid.needle_grasp = (scene_needle_grasp){0};
}

/* Returns the tool that has closed on the needle first, or NULL if none waits. */
static scene_body *next_leader(const scene_object *s, const scene_body *needle)
{
    scene_body *first = NULL;
    for (uint32_t i = 0; i < s->body_count; i++) {
        scene_body *b = &s->bodies[i];
        if (has_closed_on_one(b) && b->rigid.needle_grasp.needle == needle->number &&
            (first == NULL || b->rigid.needle_grasp.age > first->rigid.needle_grasp.age)) {
            first = b;
        }
    }
    return first;
}

/* ---- jaws that have just closed */

/* Finds the point of a needle that is nearest to the centre line of the jaws, nearer than
 * *nearest, where the needle lies across the jaws. */
static void find_needle_grasp(const scene_body *tool, const scene_body *b,
                              scene_needle_grasp *found, double *nearest)
{
    const needle_object *n = b->rigid.needle;
    double jaw = vbss_grasper_current_jaws(tool->rigid.grasper)->length;
    pose jaws = vbss_scene_jaw_frame(&tool->rigid, tool->rigid.body.now.pose);
    pose needle = pose_mul(b->rigid.body.now.pose, pose_inverse(b->rigid.frame));
    pose seen = pose_mul(pose_inverse(jaws), needle);
    uint32_t pieces = BASELINE_NEEDLE_ARC_SAMPLES * n->config.segment_count;
    double length = vbss_needle_length(n) / pieces;
    for (uint32_t i = 0; i < pieces; i++) {
        double at[2];
        vec3 begin = pose_apply(seen, vbss_needle_point(n, i * length));
        vec3 end = pose_apply(seen, vbss_needle_point(n, (i + 1) * length));
        vec3 apart =
            closest_between_edges(vec3_sub(end, begin), vec3_make(0.0, 0.0, -jaw), vec3_neg(begin),
                                  &at[0], &at[1]); /* jaws point along -z from their pivot */
        double arc = (i + at[0]) * length;
        vec3 direction = quat_rotate(seen.orientation, vbss_needle_direction(n, arc));
        if (vec3_norm(apart) <= *nearest && fabs(direction.y) >= MIN_ACROSS) {
            *nearest = vec3_norm(apart);
            *found = (scene_needle_grasp){
                .needle = b->number, .arc = arc, .pose_in_jaws = pose_identity()};
        }
    }
}

static void take(scene_object *s, scene_body *tool)
{
    scene_needle_grasp found = {0};
    double nearest = tool->rigid.grasper->config.baseline->grasper_distance;
    for (uint32_t i = 0; i < s->body_count; i++) {
        if (is_needle(&s->bodies[i])) {
            find_needle_grasp(tool, &s->bodies[i], &found, &nearest);
        }
    }
    if (found.needle != 0) {
        tool->rigid.needle_grasp = found;
        baseline_body_of(s, tool)->has_closed_jaws =
            false; /* jaws that hold a needle take no node */
    }
}

void vbss_baseline_update_needles(scene_object *s, double h)
{
    for (uint32_t i = 0; i < s->body_count; i++) {
        scene_body *b = &s->bodies[i];
        if (has_closed_on_one(b)) {
            b->rigid.needle_grasp.age += h;
            if (b->rigid.grasper->jaw_angle > 0.0) {
                let_go(s, b);
            }
        }
    }
    for (uint32_t i = 0; i < s->body_count; i++) {
        scene_body *b = &s->bodies[i];
        if (b->kind == SCENE_BODY_RIGID && b->rigid.grasper != NULL &&
            baseline_body_of(s, b)->has_closed_jaws &&
            b->rigid.grasper->kind == VBSS_GRASPER_KIND_NEEDLE_DRIVER) {
            take(s, b);
        }
    }
    for (uint32_t i = 0; i < s->body_count; i++) {
        scene_body *first = is_needle(&s->bodies[i]) && s->baseline->bodies[i].leader == 0
                                ? next_leader(s, &s->bodies[i])
                                : NULL;
        if (first != NULL) {
            lead(s, first);
        }
    }
}

void vbss_baseline_forget_leader(scene_object *s, uint32_t number)
{
    for (uint32_t i = 0; i < s->body_count; i++) {
        baseline_body *own = &s->baseline->bodies[i];
        own->leader = own->leader == number ? 0 : own->leader;
    }
}
