/* What is rigid: needles, graspers, capsules of other bodies. */
#include "visual/visual.h"

/* ---- needles: a wire from the swage to the tip, which becomes thin like an ogive */

static visual_ring wire_ring(const needle_object *n, pose body_pose, double arc_length)
{
    vec3 point = vbss_needle_point(n, arc_length);
    visual_ring ring = {
        .centre = pose_apply(body_pose, point),
        .tangent = quat_rotate(body_pose.orientation, vbss_needle_direction(n, arc_length)),
        .normal = quat_rotate(body_pose.orientation, vec3_unit_or(point, vec3_make(1.0, 0.0, 0.0))),
        .radius = n->config.wire_radius,
        .radial = 1.0,
        .arc_length = -arc_length};
    return ring;
}

/* r = wire (1 - (1 - u)^2) at the share u of the tip's length: round at the tip, smooth where the wire begins. */
static visual_ring tip_ring(const needle_object *n, pose body_pose, double tip, double fraction)
{
    visual_ring ring = wire_ring(n, body_pose, fraction * tip);
    double remaining = 1.0 - fraction, slope = 2.0 * ring.radius * remaining / tip;
    double scale = 1.0 / sqrt(1.0 + slope * slope);
    ring.radius *= 1.0 - remaining * remaining;
    ring.radial = scale;
    ring.axial = slope * scale;
    return ring;
}

void vbss_visual_draw_needle(const visual_object *v, visual_frame *f, const needle_object *n)
{
    enum { TIP_RINGS = 8 };
    const vbss_needle_config *c = &n->config;
    const double length = vbss_needle_length(n), tip = vbss_min(v->config.tip_length, 0.5 * length);
    const bool thin = tip > c->wire_radius;
    const double body = thin ? length - tip : length;
    const double outside = (1.0 + c->wire_radius / c->radius) / c->radius;
    const double chord = vbss_visual_max_chord(outside, v->config.tube_tolerance);
    const uint32_t rings = (uint32_t)vbss_min(body / chord + 1.0, 1024.0);
    const pose body_pose = vbss_needle_pose(n);
    visual_section section;
    vbss_visual_round_section(v, c->wire_radius, &section);
    visual_loft loft = vbss_visual_begin_loft(v, f, &section);
    visual_ring ring = wire_ring(n, body_pose, length);
    vbss_visual_add_dome(&loft, &ring, true);
    for (uint32_t i = 0; i <= rings; i++) {
        ring = wire_ring(n, body_pose, length - body * ((double)i / (double)rings));
        vbss_visual_add_ring(&loft, &ring);
    }
    if (!thin) {
        vbss_visual_add_dome(&loft, &ring, false);
        return;
    }
    for (int i = 1; i <= TIP_RINGS; i++) { /* closer where the tip is rounder */
        double remaining = 1.0 - (double)i / (double)TIP_RINGS;
        ring = tip_ring(n, body_pose, tip, remaining * (0.4 + 0.6 * remaining));
        if (i == TIP_RINGS) {
            vbss_visual_add_pole(&loft, &ring);
        } else {
            vbss_visual_add_ring(&loft, &ring);
        }
    }
}

/* ---- graspers */

enum { PIECE_SHAFT = 0, PIECE_NECK = 1, PIECE_JAW = 2 };

/* What is round: shaft and neck. Both lie across the tool's x. */
static void draw_cylinder(const visual_object *v, visual_frame *f, const grasper_object *g,
                          const grasper_capsule *c, double value)
{
    const pose body_pose = g->tool_pose;
    vec3 axis = vec3_sub(c->axis[0], c->axis[1]); /* toward the jaws */
    vec3 forward = vec3_unit_or(
        axis, quat_rotate(vbss_grasper_jaw_frame(g).orientation, vec3_make(0.0, 0.0, -1.0)));
    visual_section section;
    vbss_visual_round_section(v, c->radius, &section);
    const visual_capsule capsule = {pose_apply(body_pose, c->axis[1]),
                                    pose_apply(body_pose, c->axis[0]),
                                    quat_rotate(body_pose.orientation, forward),
                                    quat_rotate(body_pose.orientation, vec3_make(1.0, 0.0, 0.0)),
                                    c->radius,
                                    c->radius,
                                    value};
    vbss_visual_add_capsule(v, f, &section, &capsule);
}

/* Half round, flat toward the other jaw; blades become thin. `side` is 1 of the jaw at +x, else -1. */
static void draw_jaw(const visual_object *v, visual_frame *f, const grasper_object *g,
                     const grasper_capsule *c, double side)
{
    const pose body_pose = g->tool_pose;
    vec3 forward = vec3_unit_or(vec3_sub(c->axis[1], c->axis[0]), vec3_make(0.0, 0.0, -1.0));
    vec3 opening = vec3_make(side, 0.0, 0.0); /* the jaws' x is the tool's */
    vec3 outward = vec3_add_scaled(opening, -vec3_dot(opening, forward), forward);
    visual_section section;
    vbss_visual_jaw_section(v, c->radius, &section);
    const visual_capsule capsule = {
        pose_apply(body_pose, c->axis[0]),
        pose_apply(body_pose, c->axis[1]),
        quat_rotate(body_pose.orientation, forward),
        quat_rotate(body_pose.orientation, vec3_unit_or(outward, vec3_make(0.0, 1.0, 0.0))),
        c->radius,
        g->kind == VBSS_GRASPER_SHEARS ? 0.4 * c->radius : c->radius,
        PIECE_JAW};
    vbss_visual_add_capsule(v, f, &section, &capsule);
}

void vbss_visual_draw_grasper(const visual_object *v, visual_frame *f, const grasper_object *g)
{
    grasper_capsule capsules[GRASPER_CAPSULES];
    vbss_grasper_compute_capsules(g, g->jaw_angle, capsules);
    draw_cylinder(v, f, g, &capsules[GRASPER_SHAFT], PIECE_SHAFT);
    draw_cylinder(v, f, g, &capsules[GRASPER_NECK], PIECE_NECK);
    draw_jaw(v, f, g, &capsules[GRASPER_JAW], 1.0);
    draw_jaw(v, f, g, &capsules[GRASPER_JAW + 1], -1.0);
}

/* ---- other rigid bodies */

void vbss_visual_draw_rigid(const visual_object *v, visual_frame *f, const scene_object *s,
                            const scene_rigid *body)
{
    for (uint32_t i = 0; i < body->capsule_count; i++) {
        const scene_capsule *c = &s->capsules[body->first_capsule + i];
        vec3 axis[2];
        vbss_scene_transform_capsule(c, body->body.now.pose, axis);
        vec3 along = vec3_unit_or(vec3_sub(axis[1], axis[0]), vec3_make(0.0, 0.0, 1.0));
        visual_section section;
        vbss_visual_round_section(v, c->radius, &section);
        /* Turned with the body, so that it is seen to turn. */
        vec3 across =
            quat_rotate(body->body.now.pose.orientation,
                        vec3_any_normal(quat_rotate_back(body->body.now.pose.orientation, along)));
        const visual_capsule capsule = {axis[0], axis[1], along, across, c->radius, c->radius, 0.0};
        vbss_visual_add_capsule(v, f, &section, &capsule);
    }
}
