/* Closing of jaws: objects between them stop them and are then grasped or cut. */
#include "scene/tools/tools.h"
#include "scene/tuning.h"
#include "scene/world/world.h"

/* Smallest angle to which the jaws can close around the objects that they grasp, rad. */
static double held_angle(const scene_object *s, const scene_body *tool)
{
    const scene_needle_grasp *needle_grasp = &tool->rigid.needle_grasp;
    const scene_wall_grasp *wall_grasp = &tool->rigid.wall_grasp;
    double angle = vbss_scene_has_needle_grasp(s, tool->number) ? needle_grasp->angle : 0.0;
    angle = vbss_scene_has_wall_grasp(s, tool->number) ? vbss_max(wall_grasp->angle, angle) : angle;
    for (uint32_t i = 0; i < s->config.grasp_capacity; i++) {
        const scene_thread_grasp *g = &s->thread_grasps[i];
        if (scene_holds_strand(g) && g->tool == tool->number) {
            angle = vbss_max(g->angle, angle);
        }
    }
    return angle;
}

/* Removes the strands that the shears cannot cut from the query, so that they do not stop the
 * blades. */
static void exclude_uncuttable_strands(scene_object *s, scene_jaw_query *m, double next)
{
    uint32_t count = 0;
    for (uint32_t i = 0; i < m->count; i++) {
        const scene_strand_candidate *found = &m->strands[i];
        const scene_strand at = {found->thread, found->segment, found->at.fraction};
        if (found->angle < next || !vbss_scene_exclude_uncuttable(s, m->tool, &at, found->angle)) {
            m->strands[count++] = *found;
        }
    }
    m->count = count;
}

double vbss_scene_close_jaws(scene_object *s, scene_body *tool, double h)
{
    grasper_object *g = tool->rigid.grasper;
    double min_angle = held_angle(s, tool);
    double next = vbss_grasper_next_angle(g, h, min_angle);
    if (min_angle > 0.0 || next >= g->jaw_angle) {
        return next;
    }
    scene_jaw_query m;
    vbss_scene_find_strands(s, tool, &m);
    if (g->kind == VBSS_GRASPER_KIND_SHEARS) {
        exclude_uncuttable_strands(s, &m, next);
    }
    scene_needle_grasp needle;
    scene_wall_grasp wall;
    double stop_angle = vbss_scene_find_needle_in_jaws(s, tool, &needle) ? needle.angle : 0.0;
    stop_angle = vbss_scene_find_wall_in_jaws(s, tool, &wall) ? vbss_max(wall.angle, stop_angle)
                                                              : stop_angle;
    for (uint32_t i = 0; i < m.count; i++) {
        stop_angle = vbss_max(m.strands[i].angle, stop_angle);
    }
    if (stop_angle < next) {
        return next;
    }
    /* the present angle, if the jaws squeeze the object already */
    next = vbss_min(stop_angle, g->jaw_angle);
    if (needle.needle != 0 && needle.angle >= stop_angle - SCENE_JAW_COMPLIANCE_ANGLE &&
        g->kind != VBSS_GRASPER_KIND_SHEARS) {
        vbss_scene_grasp_needle(s, tool, &needle);
    }
    if (wall.drain != 0 && wall.angle >= stop_angle - SCENE_JAW_COMPLIANCE_ANGLE &&
        g->kind != VBSS_GRASPER_KIND_SHEARS) {
        vbss_scene_grasp_wall(s, tool, &wall);
    }
    for (uint32_t i = 0; i < m.count; i++) {
        if (m.strands[i].angle < stop_angle - SCENE_JAW_COMPLIANCE_ANGLE) {
            continue;
        }
        if (g->kind == VBSS_GRASPER_KIND_SHEARS) {
            const scene_strand at = {m.strands[i].thread, m.strands[i].segment,
                                     m.strands[i].at.fraction};
            vbss_scene_schedule_cut(s, &at);
        } else {
            vbss_scene_grasp_strand(s, tool, &m, &m.strands[i]);
        }
    }
    return next;
}

void vbss_scene_set_capsule_targets(scene_object *s, const scene_rigid *r, double angle)
{
    grasper_capsule capsules[GRASPER_CAPSULES];
    vbss_grasper_compute_capsules(r->grasper, angle, capsules);
    for (uint32_t i = 0; i < GRASPER_CAPSULES; i++) {
        scene_capsule *c = &s->capsules[r->first_capsule + i];
        for (int k = 0; k < 2; k++) {
            c->local_end[k] = pose_apply_inverse(r->frame, capsules[i].axis[k]);
        }
        c->radius = capsules[i].radius;
    }
}

/* ---- trial positions of capsules */

void vbss_scene_set_capsule_trials(scene_object *s, const scene_substep *substep)
{
    double fraction =
        substep->end_fraction < 1.0
            ? (substep->end_fraction - substep->start_fraction) / (1.0 - substep->start_fraction)
            : 1.0;
    for (uint32_t i = 0; i < s->capsule_count; i++) {
        scene_capsule *c = &s->capsules[i];
        for (int k = 0; k < 2; k++) {
            c->local_trial[k] =
                fraction < 1.0
                    ? vec3_add_scaled(c->local[k], fraction, vec3_sub(c->local_end[k], c->local[k]))
                    : c->local_end[k];
        }
    }
}
