/* Draws rigid bodies: needles, graspers, and the capsules of other bodies. */
#include "visual/visual.h"

/* ---- needles: a wire from the swage to the tip, which has the shape of an ogive */

static visual_ring wire_ring(const scene_needle_info *n, double arc_length)
{
    const scene_line_point p = vbss_scene_inspect_needle_point(n, arc_length);
    const vec3 normal = vec3_unit_or(p.position, vec3_make(1.0, 0.0, 0.0));
    visual_ring ring = {.centre = pose_apply(n->pose, p.position),
                        .tangent = quat_rotate(n->pose.orientation, p.direction),
                        .normal = quat_rotate(n->pose.orientation, normal),
                        .radius = n->wire_radius,
                        .radial = 1.0,
                        .arc_length = -arc_length};
    return ring;
}

/* Radius wire (1 - (1 - u)^2) at the fraction u of the length of the tip: round at the very tip,
 * and smooth where the wire begins. */
static visual_ring tip_ring(const scene_needle_info *n, double tip, double fraction)
{
    visual_ring ring = wire_ring(n, fraction * tip);
    double remaining = 1.0 - fraction, slope = 2.0 * ring.radius * remaining / tip;
    double scale = 1.0 / sqrt(1.0 + slope * slope);
    ring.radius *= 1.0 - remaining * remaining;
    ring.radial = scale;
    ring.axial = slope * scale;
    return ring;
}

void vbss_visual_draw_needle(visual_object *v, visual_frame *f, const scene_needle_info *n)
{
    enum { TIP_RINGS = 8 }; /* chosen */
    const double length = n->length, tip = vbss_min(v->config.tip_length, 0.5 * length);
    const bool thin = tip > n->wire_radius;
    const double body = thin ? length - tip : length;
    const double outside = (1.0 + n->wire_radius / n->arc_radius) / n->arc_radius;
    const double chord = vbss_visual_max_chord(outside, v->config.tube_tolerance);
    const uint32_t rings = (uint32_t)vbss_min(body / chord + 1.0, 1024.0);
    const visual_section *section = vbss_visual_round_section(v, n->wire_radius);
    visual_loft loft;
    vbss_visual_begin_loft(&loft, v, f, section);
    visual_ring ring = wire_ring(n, length);
    vbss_visual_add_dome(&loft, &ring, true);
    for (uint32_t i = 0; i <= rings; i++) {
        ring = wire_ring(n, length - body * ((double)i / (double)rings));
        vbss_visual_add_ring(&loft, &ring);
    }
    if (!thin) {
        vbss_visual_add_dome(&loft, &ring, false);
        return;
    }
    for (int i = 1; i <= TIP_RINGS; i++) { /* closer toward the round end */
        double remaining = 1.0 - (double)i / (double)TIP_RINGS;
        ring = tip_ring(n, tip, remaining * (0.4 + 0.6 * remaining));
        if (i == TIP_RINGS) {
            vbss_visual_add_pole(&loft, &ring);
        } else {
            vbss_visual_add_ring(&loft, &ring);
        }
    }
}

/* ---- graspers */

enum { PIECE_SHAFT = 0, PIECE_NECK = 1, PIECE_JAW = 2 };

/* Draws the shaft or the neck. Both are perpendicular to the x axis of the tool. */
static void draw_cylinder(visual_object *v, visual_frame *f, const scene_grasper_info *g,
                          const scene_capsule_info *c, double value)
{
    const pose body_pose = g->pose;
    vec3 axis = vec3_sub(c->axis[0], c->axis[1]); /* toward the jaws */
    vec3 forward = vec3_unit_or(axis, g->forward);
    const visual_section *section = vbss_visual_round_section(v, c->radius);
    const visual_capsule capsule = {pose_apply(body_pose, c->axis[1]),
                                    pose_apply(body_pose, c->axis[0]),
                                    quat_rotate(body_pose.orientation, forward),
                                    quat_rotate(body_pose.orientation, vec3_make(1.0, 0.0, 0.0)),
                                    c->radius,
                                    c->radius,
                                    value};
    vbss_visual_add_capsule(v, f, section, &capsule);
}

/* Draws a jaw. The blades of shears taper. `side` is 1 for the jaw at +x, and -1 for the other. */
static void draw_jaw(visual_object *v, visual_frame *f, const scene_grasper_info *g,
                     const scene_capsule_info *c, double side)
{
    const pose body_pose = g->pose;
    vec3 forward = vec3_unit_or(vec3_sub(c->axis[1], c->axis[0]), vec3_make(0.0, 0.0, -1.0));
    vec3 opening = vec3_make(side, 0.0, 0.0); /* jaws and tool have the same x axis */
    vec3 outward = vec3_add_scaled(opening, -vec3_dot(opening, forward), forward);
    const visual_section *section = vbss_visual_jaw_section(v, c->radius);
    const visual_capsule capsule = {
        pose_apply(body_pose, c->axis[0]),
        pose_apply(body_pose, c->axis[1]),
        quat_rotate(body_pose.orientation, forward),
        quat_rotate(body_pose.orientation, vec3_unit_or(outward, vec3_make(0.0, 1.0, 0.0))),
        c->radius,
        g->kind == VBSS_GRASPER_KIND_SHEARS ? 0.4 * c->radius : c->radius,
        PIECE_JAW};
    vbss_visual_add_capsule(v, f, section, &capsule);
}

void vbss_visual_draw_grasper(visual_object *v, visual_frame *f, const scene_grasper_info *g)
{
    draw_cylinder(v, f, g, &g->shaft, PIECE_SHAFT);
    draw_cylinder(v, f, g, &g->neck, PIECE_NECK);
    draw_jaw(v, f, g, &g->jaws[0], 1.0);
    draw_jaw(v, f, g, &g->jaws[1], -1.0);
}

/* ---- other rigid bodies */

void vbss_visual_draw_capsule(visual_object *v, visual_frame *f, quat orientation,
                              const scene_capsule_info *c)
{
    vec3 along = vec3_unit_or(vec3_sub(c->axis[1], c->axis[0]), vec3_make(0.0, 0.0, 1.0));
    const visual_section *section = vbss_visual_round_section(v, c->radius);
    /* The section turns with the body, so that its rotation is visible. */
    vec3 across = quat_rotate(orientation, vec3_any_normal(quat_rotate_back(orientation, along)));
    const visual_capsule capsule = {c->axis[0], c->axis[1], along, across,
                                    c->radius,  c->radius,  0.0};
    vbss_visual_add_capsule(v, f, section, &capsule);
}
