/* Holes of the baseline. Where algorithm 3 has detected that a needle passed through a wall, the
 * particles of that triangle follow the needle by their weights, like responses to contacts. The
 * wall around the hole does not collide with the needle: docs/explanation/paper-needle.md. */
#include "base/error.h"
#include "baseline/drain.h"
#include "baseline/scene.h"
#include "scene/tissue/tissue.h"

/* ---- motion of the particles at holes */

static pose needle_at_end(const scene_rigid *r)
{
    return pose_mul(r->trial, pose_inverse(r->frame));
}

/* Slides the hole along the needle's tangent to the nearest point, and returns the displacement
 * from the hole to that point. */
static vec3 displacement_to_needle(suture_hole *hole, const scene_rigid *r, vec3 here)
{
    const needle_object *n = r->needle;
    vec3 seen = pose_apply_inverse(needle_at_end(r), here);
    vec3 off = vec3_sub(seen, vbss_needle_point(n, hole->arc));
    vbss_hole_set_arc(hole, hole->arc - vec3_dot(off, vbss_needle_direction(n, hole->arc)));
    return vec3_sub(pose_apply(needle_at_end(r), vbss_needle_point(n, hole->arc)), here);
}

/* Moves the point of the triangle by the displacement. Each corner moves in proportion to its
 * weight over its mass. Returns mass times displacement. */
static vec3 carry_triangle(const suture_hole *hole, drain_object *d, vec3 displacement, double h)
{
    const uint32_t *node = d->mesh.triangles[hole->triangle];
    double light[3], sum = 0.0;
    vec3 push = vec3_zero();
    for (int k = 0; k < 3; k++) { /* pinned corners stay */
        light[k] =
            d->baseline->free_mass[node[k]] > 0.0 ? hole->barycentric[k] / d->mass[node[k]] : 0.0;
        sum += hole->barycentric[k] * light[k];
    }
    for (int k = 0; k < 3 && sum > 0.0; k++) {
        vec3 own = vec3_scale(displacement, light[k] / sum);
        d->x[node[k]] = vec3_add(d->x[node[k]], own);
        d->v[node[k]] = vec3_add_scaled(d->v[node[k]], 1.0 / h, own);
        push = vec3_add_scaled(push, light[k] > 0.0 ? d->mass[node[k]] : 0.0, own);
    }
    return push;
}

static vbss_result carry(scene_object *s, uint32_t i, double h)
{
    suture_hole *hole = &s->holes[i];
    const scene_rigid *r = &vbss_scene_body(s, hole->needle)->rigid;
    drain_object *d = vbss_scene_body(s, hole->wall)->drain.drain;
    const contact_key key = {VBSS_SCENE_CONTACT_HOLE, hole->needle, i, hole->wall, 0};
    vec3 displacement = displacement_to_needle(
        hole, r, vbss_drain_point(d, d->x, hole->triangle, hole->barycentric));
    vec3 push = carry_triangle(hole, d, displacement, h);
    if (vec3_norm(displacement) < BASELINE_MIN_DEPTH_RATIO * d->config.thickness ||
        vec3_norm_squared(push) == 0.0) {
        return VBSS_OK;
    }
    s->baseline->counts.responses++;
    return vbss_baseline_record_contact(s, &key, vec3_unit_or(displacement, vec3_zero()),
                                        vec3_neg(push));
}

vbss_result vbss_baseline_carry_holes(scene_object *s, double h)
{
    for (uint32_t i = 0; i < s->config.hole_capacity; i++) {
        if (s->holes[i].id != 0) {
            VBSS_TRY(carry(s, i, h));
        }
    }
    return VBSS_OK;
}

void vbss_baseline_locate_hole_contact(const scene_object *s, scene_contact_record *hit)
{
    const suture_hole *hole = &s->holes[hit->key.feature_a];
    const drain_object *d = vbss_scene_body(s, hole->wall)->drain.drain;
    hit->point = vbss_drain_point(d, d->x, hole->triangle, hole->barycentric);
    hit->gap = 0.0;
}

/* ---- pairs that do not collide */

static bool has_node_of(const drain_object *d, const uint32_t side[2], uint32_t triangle)
{
    for (int k = 0; k < 3; k++) {
        uint32_t node = d->mesh.triangles[triangle][k];
        if (side[0] == node || side[1] == node) {
            return true;
        }
    }
    return false;
}

bool vbss_baseline_is_in_hole(const scene_object *s, const scene_body *needle, uint32_t capsule,
                              const scene_body *drain, uint32_t side)
{
    const needle_object *n = needle->rigid.needle;
    const drain_object *d = drain->drain.drain;
    const uint32_t *nodes = s->collision->shapes[drain->shape]->edges[side];
    double reach = SCENE_EXCLUSION_ARC_RATIO * (n->config.wire_radius + 0.5 * d->config.thickness);
    for (uint32_t i = 0; i < s->config.hole_capacity; i++) {
        const suture_hole *hole = &s->holes[i];
        if (hole->id != 0 && hole->needle == needle->number && hole->wall == drain->number &&
            hole->arc > vbss_needle_vertex_arc(n, capsule) - reach &&
            hole->arc < vbss_needle_vertex_arc(n, capsule + 1) + reach &&
            has_node_of(d, nodes, hole->triangle)) {
            return true;
        }
    }
    return false;
}

/* ---- after a step */

/* Stores the contact forces of walls on needles at their holes. */
static void note_forces(scene_object *s)
{
    for (uint32_t i = 0; i < s->config.hole_capacity; i++) {
        s->holes[i].transverse_force = vec3_zero();
    }
    for (uint32_t i = 0; i < s->baseline->contact_count; i++) {
        const scene_contact_record *hit = &s->baseline->contacts[i];
        if (hit->key.kind == VBSS_SCENE_CONTACT_HOLE) {
            s->holes[hit->key.feature_a].transverse_force = hit->force;
        }
    }
}

static void find_punctures(scene_object *s, const scene_body *needle, const scene_body *drain)
{
    const scene_rigid *r = &needle->rigid;
    baseline_toggle *toggles = baseline_body_of(s, needle)->toggles;
    const drain_object *d = drain->drain.drain;
    pose at = vbss_scene_needle_frame(r, r->body.now.pose);
    const suture_curve line = {.needle = r->needle, .needle_pose = at};
    baseline_probe probe = {.needle = needle->number,
                            .drain = drain->number,
                            .wall = d,
                            .holes = s->holes,
                            .hole_count = s->config.hole_capacity};
    suture_hole made;
    vbss_baseline_set_probe_points(r->needle, at, d->config.thickness, probe.points);
    while (vbss_baseline_find_puncture(&probe, toggles, &made)) {
        made.arc = vbss_suture_nearest_point(
                       &line, 0.0, vbss_drain_point(d, d->x, made.triangle, made.barycentric))
                       .arc;
        made.max_arc = vbss_max(made.arc, 0.0);
        vbss_scene_add_hole(s, &made, 0.0);
    }
    vbss_baseline_update_toggles(&probe, toggles);
}

void vbss_baseline_update_holes(scene_object *s)
{
    note_forces(s);
    vbss_scene_close_exited_holes(s, false);
    for (uint32_t i = 0; i < s->body_count; i++) {
        scene_body *needle = &s->bodies[i];
        bool is_needle = needle->kind == SCENE_BODY_RIGID && needle->rigid.needle != NULL;
        for (uint32_t k = 0; is_needle && k < s->body_count; k++) {
            if (s->bodies[k].kind == SCENE_BODY_DRAIN) {
                find_punctures(s, needle, &s->bodies[k]);
            }
        }
    }
}

void vbss_baseline_forget_toggles(scene_object *s, uint32_t number)
{
    for (uint32_t i = 0; i < s->body_count; i++) {
        baseline_toggle *toggles = s->baseline->bodies[i].toggles;
        for (int k = 0; s->bodies[i].kind == SCENE_BODY_RIGID && k < BASELINE_TOGGLES; k++) {
            if (toggles[k].drain == number) {
                toggles[k] = (baseline_toggle){0};
            }
        }
    }
}
