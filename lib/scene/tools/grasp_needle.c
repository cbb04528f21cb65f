/* Needles in the jaws of graspers: found, grasped, released and sliding.
 *
 * Jaws grasp a needle that they touch from both sides, in the pose that it has. Three bilateral
 * constraints hold it (contacts/grasp_constraints.c). After a step the needle slides and turns
 * in the jaws if the load exceeds their friction limit. */
#include "base/elementary.h"
#include "collision/closest.h"
#include "scene/tools/tools.h"
#include "scene/tuning.h"
#include "scene/world/world.h"

/* ---- frames */

/* Frame of a point of the arc, in the needle's frame: x outward, y toward the tip, z along the
 * axis of the arc. */
static pose arc_frame(const needle_object *n, double arc)
{
    double sine, cosine;
    vbss_sincos(-0.5 * arc / n->config.radius, &sine, &cosine);
    return pose_make(vbss_needle_point(n, arc), quat_make(cosine, 0.0, 0.0, sine));
}

static pose held_frame(const scene_rigid *needle, const scene_needle_grasp *grasp, pose principal)
{
    return pose_mul(vbss_scene_needle_frame(needle, principal),
                    arc_frame(needle->needle, grasp->arc));
}

void vbss_scene_emit_needle_grasp_event(scene_object *s, vbss_scene_event_kind kind,
                                        const scene_body *tool)
{
    scene_grasp_event of = {.tool = tool->number};
    vbss_scene_describe_needle_grasp(s, tool, &of.grasp);
    of.logged_number = (uint32_t)(1e6 * of.grasp.arc_length);
    vbss_scene_emit_grasp_event(s, kind, &of);
}

/* ---- grasping */

/* Largest distance of a wire beyond the tip at which friction holds it, m. The contact normals lean
 * outward there, by an angle whose sine is the distance over that of the axes. Up to the friction
 * angle the jaws hold the wire; beyond it they push it out. */
static double max_overhang(const scene_rigid *tool, const scene_rigid *needle)
{
    double friction = sqrt(tool->friction * needle->friction);
    double sine = friction / sqrt(1.0 + friction * friction);
    double touching =
        vbss_grasper_current_jaws(tool->grasper)->radius + needle->needle->config.wire_radius;
    return sine * touching;
}

/* Jaw angle at which round jaws touch a wire between them, rad. `direction` is that of the wire
 * in the jaws' frame, unit. Beyond the tip it touches the round ends. Near the pivot, where jaws
 * cannot open so far, it is in them only because the host has put it there. Returns 0 if friction
 * does not hold the wire: it is too steep, or too far beyond the tip. */
static double touching_angle(const scene_rigid *tool, const scene_rigid *needle, vec3 direction,
                             double from_pivot)
{
    const grasper_jaws *jaws = vbss_grasper_current_jaws(tool->grasper);
    double touching = jaws->radius + needle->needle->config.wire_radius,
           flat = sqrt(direction.x * direction.x + direction.y * direction.y);
    double across = flat > 0.0 ? fabs(direction.y) / flat : 1.0;
    double overhang = vbss_max(from_pivot - jaws->length, 0.0);
    if (across < SCENE_NEEDLE_MIN_ACROSS || overhang > max_overhang(tool, needle)) {
        return 0.0;
    }
    double apart = overhang > 0.0 ? sqrt(touching * touching - overhang * overhang) : touching;
    double angle =
        vbss_grasper_touching_angle(2.0 * (apart / across - jaws->radius), from_pivot - overhang);
    return vbss_min(angle, jaws->opening);
}

static void find_grasp_on_needle(const scene_body *tool, const scene_body *b,
                                 scene_needle_grasp *found, double *beside)
{
    const grasper_object *g = tool->rigid.grasper;
    const needle_object *n = b->rigid.needle;
    pose jaws = vbss_scene_jaw_frame(&tool->rigid, tool->rigid.body.now.pose);
    pose needle =
        pose_mul(pose_inverse(jaws), vbss_scene_needle_frame(&b->rigid, b->rigid.body.now.pose));
    uint32_t pieces = SCENE_NEEDLE_ARC_SAMPLES * n->config.segment_count;
    double length = vbss_needle_length(n) / pieces,
           overhang = max_overhang(&tool->rigid, &b->rigid);
    for (uint32_t i = 0; i < pieces; i++) {
        grasper_jaw_point at;
        vec3 start = pose_apply(needle, vbss_needle_point(n, i * length));
        vec3 end = pose_apply(needle, vbss_needle_point(n, (i + 1) * length));
        if (!vbss_grasper_find_between(g, start, end, overhang, &at) || !(at.offset < *beside)) {
            continue;
        }
        vec3 direction = vec3_unit_or(vec3_sub(end, start), vec3_zero());
        double angle = touching_angle(&tool->rigid, &b->rigid, direction, at.from_pivot);
        if (angle > 0.0) {
            *beside = at.offset;
            *found = (scene_needle_grasp){
                .needle = b->number, .angle = angle, .arc = (i + at.fraction) * length};
            found->pose_in_jaws = pose_mul(needle, arc_frame(n, found->arc));
        }
    }
}

bool vbss_scene_find_needle_in_jaws(const scene_object *s, const scene_body *tool,
                                    scene_needle_grasp *found)
{
    const scene_needle_grasp *before = &tool->rigid.needle_grasp;
    double beside = DBL_MAX;
    *found = (scene_needle_grasp){0};
    for (uint32_t i = 0; i < s->body_count; i++) {
        const scene_body *b = &s->bodies[i];
        bool torn = before->needle == b->number &&
                    before->needs_reopening; /* not before the jaws have opened */
        if (b->kind == SCENE_BODY_RIGID && b->rigid.needle != NULL && !torn &&
            vbss_scene_do_collide(s, tool, b)) {
            find_grasp_on_needle(tool, b, found, &beside);
        }
    }
    return found->needle != 0;
}

void vbss_scene_grasp_needle(scene_object *s, scene_body *tool, const scene_needle_grasp *found)
{
    tool->rigid.needle_grasp = *found;
    vbss_scene_emit_needle_grasp_event(s, VBSS_SCENE_EVENT_GRASP, tool);
}

/* ---- exclusion from contact */

bool vbss_scene_is_needle_in_grasp(const scene_object *s, const scene_body *needle,
                                   uint32_t segment, const scene_body *tool, uint32_t capsule)
{
    const scene_needle_grasp *grasp = &tool->rigid.needle_grasp;
    bool jaw = capsule != GRASPER_SHAFT && capsule != GRASPER_NECK;
    if (tool->rigid.grasper == NULL || !jaw || grasp->needle != needle->number) {
        return false;
    }
    const needle_object *n = needle->rigid.needle;
    double contact_distance =
        s->capsules[tool->rigid.first_capsule + capsule].radius + n->config.wire_radius;
    double reach = SCENE_EXCLUSION_ARC_RATIO * contact_distance;
    return grasp->arc > vbss_needle_vertex_arc(n, segment) - reach &&
           grasp->arc < vbss_needle_vertex_arc(n, segment + 1) + reach;
}

/* ---- releasing */

/* Whether the axes of both jaws are at least this fraction of the contact distance away from the
 * part of the needle that is excluded from contact. */
static bool is_needle_clear(const scene_object *s, const scene_body *tool, double fraction)
{
    const scene_body *b = vbss_scene_body(s, tool->rigid.needle_grasp.needle);
    for (uint32_t k = GRASPER_JAW; k < GRASPER_NECK; k++) {
        const scene_capsule *jaw = &s->capsules[tool->rigid.first_capsule + k];
        vec3 one[2], other[2];
        vbss_scene_transform_capsule(jaw, tool->rigid.body.now.pose, one);
        for (uint32_t i = 0; i < b->rigid.capsule_count; i++) {
            const scene_capsule *c = &s->capsules[b->rigid.first_capsule + i];
            double at[2];
            vbss_scene_transform_capsule(c, b->rigid.body.now.pose, other);
            vec3 separation_vector =
                closest_between_edges(vec3_sub(one[1], one[0]), vec3_sub(other[1], other[0]),
                                      vec3_sub(other[0], one[0]), &at[0], &at[1]);
            if (vbss_scene_is_needle_in_grasp(s, b, i, tool, k) &&
                vec3_norm(separation_vector) < fraction * (jaw->radius + c->radius)) {
                return false;
            }
        }
    }
    return true;
}

void vbss_scene_release_needle_grasp(scene_object *s, scene_body *tool)
{
    scene_needle_grasp *grasp = &tool->rigid.needle_grasp;
    if (grasp->needle == 0 || !(vbss_grasper_commanded_angle(tool->rigid.grasper) > grasp->angle)) {
        return;
    }
    grasp->needs_reopening = false;
    if (!grasp->is_released) {
        vbss_scene_emit_needle_grasp_event(s, VBSS_SCENE_EVENT_RELEASE, tool);
        grasp->is_released = true;
        grasp->force = grasp->torque = vec3_zero();
        if (is_needle_clear(s, tool, SCENE_RELEASE_CLEARANCE_RATIO)) {
            *grasp = (scene_needle_grasp){0};
        }
    }
}

void vbss_scene_remove_needle_grasps_of(scene_object *s, uint32_t number)
{
    for (uint32_t i = 0; i < s->body_count; i++) {
        scene_rigid *r = &s->bodies[i].rigid;
        if (s->bodies[i].kind == SCENE_BODY_RIGID &&
            (s->bodies[i].number == number || r->needle_grasp.needle == number)) {
            r->needle_grasp = (scene_needle_grasp){0};
        }
    }
}

/* ---- the clamp */

scene_clamp_corner vbss_scene_clamp_corner(const scene_rigid *needle, pose needle_principal,
                                           const scene_rigid *tool, pose tool_principal, uint32_t k)
{
    const scene_needle_grasp *grasp = &tool->needle_grasp;
    vec3 local = vbss_grasper_needle_clamp_point(tool->grasper, grasp->pose_in_jaws.position, k);
    pose jaws = vbss_scene_jaw_frame(tool, tool_principal);
    pose frame = held_frame(needle, grasp, needle_principal);
    return (scene_clamp_corner){pose_apply(jaws, local),
                                pose_apply(frame, pose_apply_inverse(grasp->pose_in_jaws, local))};
}

/* ---- after a step */

/* Force and torque of the clamp on the needle about the grasped point, in the jaws' frame. */
static grasper_needle_load clamp_load(const scene_rigid *needle, const scene_rigid *tool)
{
    const scene_needle_grasp *grasp = &tool->needle_grasp;
    pose jaws = vbss_scene_jaw_frame(tool, tool->body.now.pose);
    grasper_needle_load load = {.force = vec3_zero(), .torque = vec3_zero()};
    for (uint32_t k = 0; k < GRASPER_NEEDLE_POINTS; k++) {
        const scene_clamp_corner c =
            vbss_scene_clamp_corner(needle, needle->body.now.pose, tool, tool->body.now.pose, k);
        vec3 separation_vector =
            quat_rotate_back(jaws.orientation, vec3_sub(c.jaw_point, c.needle_point));
        vec3 force =
            vec3_scale(separation_vector, vbss_grasper_needle_clamp_stiffness(tool->grasper));
        vec3 arm = vec3_sub(
            vbss_grasper_needle_clamp_point(tool->grasper, grasp->pose_in_jaws.position, k),
            grasp->pose_in_jaws.position);
        load.force = vec3_add(load.force, force);
        load.torque = vec3_add(load.torque, vec3_cross(arm, force));
    }
    return load;
}

/* Grasps the needle at the point of its arc that is in the middle of the jaws, if it has slid
 * sideways. Returns false if the arc ends before that point, or if the needle has left the jaws
 * sideways. */
static bool recentre_grasp(const needle_object *n, const grasper_object *g,
                           scene_needle_grasp *grasp)
{
    vec3 direction = quat_rotate(grasp->pose_in_jaws.orientation, vec3_make(0.0, 1.0, 0.0));
    double lateral = grasp->pose_in_jaws.position.y, radius = vbss_grasper_current_jaws(g)->radius;
    if (fabs(lateral) > SCENE_NEEDLE_REGRASP_OFFSET * radius &&
        fabs(direction.y) >= SCENE_NEEDLE_MIN_ALONG) {
        double arc = grasp->arc + lateral / direction.y; /* arc length grows away from the tip */
        pose other = pose_mul(pose_inverse(arc_frame(n, grasp->arc)), arc_frame(n, arc));
        grasp->pose_in_jaws = pose_mul(grasp->pose_in_jaws, other);
        grasp->pose_in_jaws.orientation = quat_unit(grasp->pose_in_jaws.orientation);
        grasp->arc = arc;
    }
    return grasp->arc >= 0.0 && grasp->arc <= vbss_needle_length(n) &&
           fabs(grasp->pose_in_jaws.position.y) <= radius;
}

static void update_needle_grasp(scene_object *s, scene_body *tool, double h)
{
    scene_rigid *r = &tool->rigid;
    scene_needle_grasp *grasp = &r->needle_grasp;
    const scene_rigid *needle = vbss_scene_held_needle(s, grasp);
    pose jaws = vbss_scene_jaw_frame(r, r->body.now.pose);
    grasper_needle_load load = clamp_load(needle, r);
    load.jaw_force = r->grasper->jaw_force / vbss_scene_count_grasps(s, tool->number);
    load.h = h;
    grasp->force = quat_rotate(jaws.orientation, load.force);
    grasp->torque = quat_rotate(jaws.orientation, load.torque);
    grasp->limit = vbss_grasper_friction_limit(r->grasper, load.jaw_force);
    grasper_needle_slip change =
        vbss_grasper_yield_needle(r->grasper, &grasp->pose_in_jaws, &grasp->age, &load);
    bool is_sliding = change.slip > 0.0 || change.rotation > 0.0;
    if (is_sliding && !grasp->is_sliding) {
        vbss_scene_emit_needle_grasp_event(s, VBSS_SCENE_EVENT_SLIP, tool);
    }
    grasp->is_sliding = is_sliding;
    grasp->slid += change.slip;
    grasp->turned += change.rotation;
    if (change.has_escaped || !recentre_grasp(needle->needle, r->grasper, grasp)) {
        grasp->arc = vbss_max(0.0, vbss_min(grasp->arc, vbss_needle_length(needle->needle)));
        vbss_scene_emit_needle_grasp_event(s, VBSS_SCENE_EVENT_TORN, tool);
        grasp->is_released = grasp->needs_reopening = true;
        grasp->force = grasp->torque = vec3_zero();
    }
}

void vbss_scene_update_needle_grasps(scene_object *s, double h)
{
    for (uint32_t i = 0; i < s->body_count; i++) {
        scene_body *b = &s->bodies[i];
        if (b->kind != SCENE_BODY_RIGID || b->rigid.needle_grasp.needle == 0) {
            continue;
        }
        if (!b->rigid.needle_grasp.is_released) {
            update_needle_grasp(s, b, h);
        } else if (is_needle_clear(s, b, 1.0)) {
            b->rigid.needle_grasp = (scene_needle_grasp){0};
        }
    }
}

/* ---- description for hosts */

void vbss_scene_describe_needle_grasp(const scene_object *s, const scene_body *tool,
                                      vbss_scene_grasp *grasp)
{
    const scene_needle_grasp *needle_grasp = &tool->rigid.needle_grasp;
    const scene_rigid *needle = vbss_scene_held_needle(s, needle_grasp);
    grasp->body = needle_grasp->needle;
    grasp->arc_length = needle_grasp->arc;
    grasp->limit = needle_grasp->limit;
    grasp->slid = needle_grasp->slid;
    vec3_store(grasp->position, held_frame(needle, needle_grasp, needle->body.now.pose).position);
    vec3_store(grasp->force, needle_grasp->force);
}
