/* Needles in the jaws of graspers: taken by jaws that touch them from both sides, held by three rows, let go as they were.
 * Between two steps what was pulled or turned too hard slides. */
#include "base/elementary.h"
#include "scene/events.h"
#include "scene/rows.h"
#include "scene/scene.h"
#include "scene/tools.h"

#include "collision/closest.h"

/* The arc is looked at in so many straight pieces a capsule. */
enum { PIECES = 4 };
/* Of a needle between jaws, the least that the normal of both it and the jaws may be across the mouth: one that stands
 * steeper is pushed aside. */
#define LEAST_ACROSS 0.8
/* As a share of touching: what was let go is still between the jaws. */
#define STILL_BETWEEN 0.5
/* Held farther aside than this share of the jaws' radius, it is held by another place of its arc. */
#define ASIDE 0.25
/* Of its way along the jaws' width, below which that is not looked for: it lies along the jaws. */
#define MIN_ALONG 0.5

/* ---- frames */

/* Of a place on the arc, in the needle's frame: outward, toward the tip, along its axis. */
static pose frame_at(const needle_object *n, double arc)
{
    double sine, cosine;
    vbss_sincos(-0.5 * arc / n->config.radius, &sine, &cosine);
    return pose_make(vbss_needle_point(n, arc), quat_make(cosine, 0.0, 0.0, sine));
}

static pose held_place(const scene_rigid *needle, const scene_hold *hold, pose principal)
{
    return pose_mul(vbss_scene_needle_at(needle, principal), frame_at(needle->needle, hold->arc));
}

static scene_rigid *needle_of(const scene_object *s, const scene_hold *hold)
{
    return &vbss_scene_body(s, hold->needle)->rigid;
}

bool vbss_scene_holds_needle(const scene_object *s, uint32_t tool)
{
    const scene_body *b = vbss_scene_body(s, tool);
    if (b == NULL || b->kind != BODY_RIGID || b->rigid.hold.needle == 0 || b->rigid.hold.let_go) {
        return false;
    }
    /* By method PAPER another tool may lead. */
    return s->config.method == VBSS_METHOD_OURS || needle_of(s, &b->rigid.hold)->leader == tool;
}

static void tell(scene_object *s, vbss_event_kind kind, const scene_body *tool)
{
    const scene_hold *hold = &tool->rigid.hold;
    vbss_scene_add_event(s, kind, hold->needle, tool->number, (uint32_t)(1e6 * hold->arc));
}

/* ---- taking */

/* The angle at which round jaws touch a wire that goes that way between them. */
static double touching_angle(const grasper_object *g, double wire, vec3 way, double from_pivot)
{
    double jaw = vbss_grasper_current_jaws(g)->radius, flat = sqrt(way.x * way.x + way.y * way.y);
    double across = flat > 0.0 ? fabs(way.y) / flat : 1.0;
    if (across < LEAST_ACROSS) {
        return 0.0;
    }
    return vbss_grasper_touching_angle(2.0 * ((jaw + wire) / across - jaw), from_pivot);
}

static void look_along(const scene_body *tool, const scene_body *b, scene_hold *found,
                       double *beside)
{
    const grasper_object *g = tool->rigid.grasper;
    const needle_object *n = b->rigid.needle;
    pose jaws = vbss_scene_jaws_of(&tool->rigid, tool->rigid.body.now.pose);
    pose needle =
        pose_mul(pose_inverse(jaws), vbss_scene_needle_at(&b->rigid, b->rigid.body.now.pose));
    uint32_t pieces = PIECES * n->config.segment_count;
    double length = vbss_needle_length(n) / pieces;
    for (uint32_t i = 0; i < pieces; i++) {
        grasper_jaw_point at;
        vec3 begin = pose_apply(needle, vbss_needle_point(n, i * length));
        vec3 end = pose_apply(needle, vbss_needle_point(n, (i + 1) * length));
        if (!vbss_grasper_find_between(g, begin, end, &at) || !(at.offset < *beside)) {
            continue;
        }
        double angle =
            touching_angle(g, n->config.wire_radius,
                           vec3_unit_or(vec3_sub(end, begin), vec3_zero()), at.from_pivot);
        if (angle > 0.0) {
            *beside = at.offset;
            *found = (scene_hold){
                .needle = b->number, .angle = angle, .arc = (i + at.fraction) * length};
            found->at = pose_mul(needle, frame_at(n, found->arc));
        }
    }
}

bool vbss_scene_find_needle(const scene_object *s, const scene_body *tool, scene_hold *found)
{
    const scene_hold *before = &tool->rigid.hold;
    double beside = DBL_MAX;
    *found = (scene_hold){0};
    for (uint32_t i = 0; i < s->place_count; i++) {
        const scene_body *b = &s->bodies[i];
        bool torn = before->needle == b->number && before->torn; /* not before they have opened */
        if (b->kind == BODY_RIGID && b->rigid.needle != NULL && !torn) {
            look_along(tool, b, found, &beside);
        }
    }
    return found->needle != 0;
}

void vbss_scene_take_needle(scene_object *s, scene_body *tool, const scene_hold *found)
{
    tool->rigid.hold = *found;
    tell(s, VBSS_EVENT_GRASP, tool);
}

/* ---- what does not touch */

bool vbss_scene_is_in_jaws(const scene_object *s, const scene_body *needle, uint32_t segment,
                           const scene_body *tool, uint32_t capsule)
{
    const scene_hold *hold = &tool->rigid.hold;
    bool jaw = capsule != GRASPER_SHAFT && capsule != GRASPER_NECK;
    if (tool->rigid.grasper == NULL || !jaw || hold->needle != needle->number) {
        return false;
    }
    const needle_object *n = needle->rigid.needle;
    double touching =
        s->capsules[tool->rigid.first_capsule + capsule].radius + n->config.wire_radius;
    double reach = SCENE_PIN_ARC * touching;
    return hold->arc > vbss_needle_vertex_arc(n, segment) - reach &&
           hold->arc < vbss_needle_vertex_arc(n, segment + 1) + reach;
}

/* ---- letting go */

/* Whether the axes of both jaws are that share of touching away from what was let go. */
static bool is_clear(const scene_object *s, const scene_body *tool, double share)
{
    const scene_body *b = vbss_scene_body(s, tool->rigid.hold.needle);
    for (uint32_t k = GRASPER_JAW; k < GRASPER_NECK; k++) {
        const scene_capsule *jaw = &s->capsules[tool->rigid.first_capsule + k];
        vec3 one[2], other[2];
        vbss_scene_place_capsule(jaw, tool->rigid.body.now.pose, one);
        for (uint32_t i = 0; i < b->rigid.capsule_count; i++) {
            const scene_capsule *c = &s->capsules[b->rigid.first_capsule + i];
            double at[2];
            vbss_scene_place_capsule(c, b->rigid.body.now.pose, other);
            vec3 apart =
                closest_between_edges(vec3_sub(one[1], one[0]), vec3_sub(other[1], other[0]),
                                      vec3_sub(other[0], one[0]), &at[0], &at[1]);
            if (vbss_scene_is_in_jaws(s, b, i, tool, k) &&
                vec3_norm(apart) < share * (jaw->radius + c->radius)) {
                return false;
            }
        }
    }
    return true;
}

void vbss_scene_let_needle_go(scene_object *s, scene_body *tool)
{
    scene_hold *hold = &tool->rigid.hold;
    if (hold->needle == 0 || !(vbss_grasper_commanded_angle(tool->rigid.grasper) > hold->angle)) {
        return;
    }
    hold->torn = false;
    if (!hold->let_go) {
        tell(s, VBSS_EVENT_RELEASE, tool);
        hold->let_go = true;
        hold->force = hold->torque = vec3_zero();
        if (is_clear(s, tool, STILL_BETWEEN)) {
            *hold = (scene_hold){0};
        }
    }
}

void vbss_scene_forget_holds_of(scene_object *s, uint32_t number)
{
    for (uint32_t i = 0; i < s->place_count; i++) {
        scene_rigid *r = &s->bodies[i].rigid;
        if (s->bodies[i].kind == BODY_RIGID &&
            (s->bodies[i].number == number || r->hold.needle == number)) {
            r->hold = (scene_hold){0};
        }
        if (s->bodies[i].kind == BODY_RIGID && r->leader == number) { /* PAPER */
            r->leader = 0;
        }
    }
}

/* ---- rows */

bool vbss_scene_add_hold_rows(scene_object *s)
{
    for (uint32_t i = 0; i < s->place_count; i++) {
        const scene_body *b = &s->bodies[i];
        for (uint32_t k = 0; vbss_scene_holds_needle(s, b->number) && k < GRASPER_NEEDLE_POINTS;
             k++) {
            const contact_key key = {VBSS_CONTACT_GRASP, b->rigid.hold.needle, k, b->number, 0};
            if (vbss_scene_add_tie(s, &key) == NULL) {
                return false;
            }
        }
    }
    return true;
}

/* A corner of the clamp, and where the needle has it when both are there. */
typedef struct corner {
    vec3 there, here;
} corner;

static corner corner_of(const scene_rigid *needle, pose needle_principal, const scene_rigid *tool,
                        pose tool_principal, uint32_t k)
{
    const scene_hold *hold = &tool->hold;
    vec3 local = vbss_grasper_needle_clamp_point(tool->grasper, hold->at.position, k);
    pose jaws = vbss_scene_jaws_of(tool, tool_principal);
    pose place = held_place(needle, hold, needle_principal);
    return (corner){pose_apply(jaws, local),
                    pose_apply(place, pose_apply_inverse(hold->at, local))};
}

void vbss_scene_lay_hold_row(scene_object *s, contact_constraint *row)
{
    const scene_rigid *needle = &vbss_scene_body(s, row->key.body_a)->rigid;
    const scene_rigid *tool = &vbss_scene_body(s, row->key.body_b)->rigid;
    const corner c = corner_of(needle, needle->trial, tool, tool->trial, row->key.feature_a);
    vbss_scene_lay_spring(row, tool, c.here, c.there);
    row->stiffness = vbss_grasper_needle_clamp_stiffness(tool->grasper);
    row->tangential_stiffness_ratio = 0.0; /* the same in all directions */
    vbss_scene_add_rigid_terms(row, needle, c.here, 1.0);
    vbss_scene_add_rigid_terms(row, tool, c.there, -1.0);
}

/* ---- after a step */

/* Force and torque about the middle of what is held. */
static grasper_needle_load load_of(const scene_rigid *needle, const scene_rigid *tool)
{
    const scene_hold *hold = &tool->hold;
    pose jaws = vbss_scene_jaws_of(tool, tool->body.now.pose);
    grasper_needle_load load = {.force = vec3_zero(), .torque = vec3_zero()};
    for (uint32_t k = 0; k < GRASPER_NEEDLE_POINTS; k++) {
        const corner c = corner_of(needle, needle->body.now.pose, tool, tool->body.now.pose, k);
        vec3 apart = quat_rotate_back(jaws.orientation, vec3_sub(c.there, c.here));
        vec3 force = vec3_scale(apart, vbss_grasper_needle_clamp_stiffness(tool->grasper));
        vec3 arm = vec3_sub(vbss_grasper_needle_clamp_point(tool->grasper, hold->at.position, k),
                            hold->at.position);
        load.force = vec3_add(load.force, force);
        load.torque = vec3_add(load.torque, vec3_cross(arm, force));
    }
    return load;
}

/* What has slid aside is held by another place of its arc, by the one that is in the middle of the jaws; false: it has no
 * such place any more, or has gone aside without one. */
static bool hold_elsewhere(const needle_object *n, const grasper_object *g, scene_hold *hold)
{
    vec3 way = quat_rotate(hold->at.orientation, vec3_make(0.0, 1.0, 0.0));
    double aside = hold->at.position.y, radius = vbss_grasper_current_jaws(g)->radius;
    if (fabs(aside) > ASIDE * radius && fabs(way.y) >= MIN_ALONG) {
        double arc = hold->arc + aside / way.y; /* arc length grows away from the tip */
        pose other = pose_mul(pose_inverse(frame_at(n, hold->arc)), frame_at(n, arc));
        hold->at = pose_mul(hold->at, other);
        hold->at.orientation = quat_unit(hold->at.orientation);
        hold->arc = arc;
    }
    return hold->arc >= 0.0 && hold->arc <= vbss_needle_length(n) &&
           fabs(hold->at.position.y) <= radius;
}

static void settle(scene_object *s, scene_body *tool, double h)
{
    scene_rigid *r = &tool->rigid;
    scene_hold *hold = &r->hold;
    const scene_rigid *needle = needle_of(s, hold);
    pose jaws = vbss_scene_jaws_of(r, r->body.now.pose);
    grasper_needle_load load = load_of(needle, r);
    load.jaw_force = r->grasper->jaw_force / vbss_scene_count_grasps(s, tool->number);
    load.h = h;
    hold->force = quat_rotate(jaws.orientation, load.force);
    hold->torque = quat_rotate(jaws.orientation, load.torque);
    hold->limit = vbss_grasper_friction_limit(r->grasper, load.jaw_force);
    grasper_needle_slip change =
        vbss_grasper_yield_needle(r->grasper, &hold->at, &hold->age, &load);
    bool gives_way = change.slip > 0.0 || change.rotation > 0.0;
    if (gives_way && !hold->sliding) {
        tell(s, VBSS_EVENT_SLIP, tool);
    }
    hold->sliding = gives_way;
    hold->slid += change.slip;
    hold->turned += change.rotation;
    if (change.has_escaped || !hold_elsewhere(needle->needle, r->grasper, hold)) {
        hold->arc = vbss_max(0.0, vbss_min(hold->arc, vbss_needle_length(needle->needle)));
        tell(s, VBSS_EVENT_TORN, tool);
        hold->let_go = hold->torn = true;
        hold->force = hold->torque = vec3_zero();
    }
}

void vbss_scene_settle_holds(scene_object *s, double h)
{
    for (uint32_t i = 0; i < s->place_count; i++) {
        scene_body *b = &s->bodies[i];
        if (b->kind != BODY_RIGID || b->rigid.hold.needle == 0) {
            continue;
        }
        if (!b->rigid.hold.let_go) {
            settle(s, b, h);
        } else if (is_clear(s, b, 1.0)) {
            b->rigid.hold = (scene_hold){0};
        }
    }
}

/* ---- looking */

void vbss_scene_show_hold(const scene_object *s, const scene_body *tool, vbss_grasp *grasp)
{
    const scene_hold *hold = &tool->rigid.hold;
    const scene_rigid *needle = needle_of(s, hold);
    grasp->thread = hold->needle;
    grasp->arc_length = hold->arc;
    grasp->limit = hold->limit;
    grasp->slid = hold->slid;
    vec3_store(grasp->position, held_place(needle, hold, needle->body.now.pose).position);
    vec3_store(grasp->force, hold->force);
}
