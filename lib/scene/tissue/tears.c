/* Tears: threads that cut through the wall at their holes, until they leave it at a free edge. */
#include "scene/tissue/tissue.h"
#include "scene/world/world.h"

static double contact_distance(const scene_hole_context *p)
{
    return p->now.thread->config.radius + 0.5 * p->wall.law->thickness;
}

/* Distance along the thread within which its contact with the wall beside a hole is not complete, m. */
static double zone_of(const scene_hole_context *p)
{
    return (1.0 + SCENE_EXIT_RAMP_RATIO) * SCENE_THREAD_EXCLUSION_ARC * contact_distance(p);
}

bool vbss_scene_can_tear(const scene_hole_context *p, const suture_hole *hole)
{
    return hole->thread != 0 && p->wall.law->tear_energy > 0.0;
}

bool vbss_scene_is_hole_torn_open(const scene_object *s, const suture_hole *hole)
{
    if (hole->free_side == 0) {
        return false;
    }
    const scene_hole_context p = vbss_scene_get_hole_context(s, hole);
    return vbss_suture_is_outside(&p.wall, hole, vbss_scene_hole_curve_point(&p, hole).position);
}

bool vbss_scene_tears_too_far(const scene_object *s)
{
    for (uint32_t i = 0; i < s->contacts->count; i++) {
        const contact_constraint *constraint = &s->contacts->constraints[i];
        if (constraint->key.kind == VBSS_SCENE_CONTACT_HOLE && constraint->tear_force > 0.0 &&
            vec3_norm(vbss_contact_tear_slip(constraint)) >= 0.999 * constraint->max_tear_slip) {
            return true;
        }
    }
    return false;
}

/* Part of a vector in the plane of the triangle in which the hole is. */
static vec3 in_plane(const suture_wall *wall, const suture_hole *hole, vec3 v)
{
    const vec3 normal = vbss_suture_wall_normal(wall, wall->now, hole->triangle);
    return vec3_add_scaled(v, -vec3_dot(v, normal), normal);
}

/* The yield of the constraint moves the hole so far through the wall that it takes this yield out of the
 * distance between hole and thread. */
void vbss_scene_tear_hole(scene_object *s, suture_hole *hole, const contact_constraint *constraint)
{
    const vec3 slip = vbss_contact_tear_slip(constraint);
    const double slipped = vec3_norm(slip);
    if (!(slipped > 0.0)) {
        return;
    }
    const scene_hole_context p = vbss_scene_get_hole_context(s, hole);
    const vec3 direction = in_plane(&p.wall, hole, slip);
    const double share = vec3_norm(direction) / slipped;
    if (!(share > 0.0)) {
        return;
    }
    const double distance = slipped / share;
    const double moved = vbss_suture_move_hole(&p.wall, hole, direction, distance);
    const double work = vec3_norm(hole->transverse_force) * slipped * (moved / distance);
    hole->torn_length += moved;
    hole->tear_work += work;
    hole->tear = hole->tear == SUTURE_HOLDS ? SUTURE_BEGINS_TO_TEAR : hole->tear;
    s->report.statistics.torn_length += moved;
    s->report.statistics.tear_work += work;
}

static void report_tear(scene_object *s, suture_hole *hole, const scene_hole_context *p)
{
    const double force = vec3_norm(in_plane(&p->wall, hole, hole->transverse_force));
    if (hole->tear == SUTURE_BEGINS_TO_TEAR) {
        hole->tear = SUTURE_TEARS;
        vbss_scene_emit_hole_event(s, VBSS_SCENE_EVENT_TEARING, hole, force);
    } else if (hole->tear == SUTURE_TEARS &&
               force < SUTURE_TEAR_END_RATIO * vbss_suture_tear_force(&p->wall, hole->triangle)) {
        hole->tear = SUTURE_HOLDS;
    }
}

/* Whether another hole of this wall is nearer to a place of the thread. */
static bool is_of_other_hole(const scene_object *s, const suture_hole *hole, double arc)
{
    for (uint32_t i = 0; i < s->config.hole_capacity; i++) {
        const suture_hole *other = &s->holes[i];
        if (other != hole && other->id != 0 && other->wall == hole->wall &&
            other->thread == hole->thread && fabs(other->arc - arc) < fabs(hole->arc - arc)) {
            return true;
        }
    }
    return false;
}

static bool needle_crosses_wall(const scene_hole_context *p)
{
    suture_hole at;
    double fraction;
    for (uint32_t i = 0; i < p->now.needle->config.segment_count; i++) {
        const double start = vbss_needle_vertex_arc(p->now.needle, i),
                     end = vbss_needle_vertex_arc(p->now.needle, i + 1);
        const vec3 axis[2] = {
            pose_apply(p->now.needle_pose, vbss_needle_point(p->now.needle, start)),
            pose_apply(p->now.needle_pose, vbss_needle_point(p->now.needle, end))};
        if (vbss_suture_find_wall_crossing(&p->wall, axis, &at, &fraction)) {
            return true;
        }
    }
    return false;
}

/* Whether the suture goes through the wall beside the hole. */
static bool crosses_wall(const scene_object *s, const suture_hole *hole,
                         const scene_hole_context *p)
{
    const thread_object *t = p->now.thread;
    const double zone = zone_of(p);
    suture_hole at;
    double fraction;
    for (uint32_t i = 0; i + 1 < t->node_count; i++) {
        const double start = vbss_thread_arc_length(t, i), end = vbss_thread_arc_length(t, i + 1);
        const vec3 axis[2] = {t->now.x[i], t->now.x[i + 1]};
        if (end > hole->arc - zone && start < hole->arc + zone &&
            vbss_suture_find_wall_crossing(&p->wall, axis, &at, &fraction) &&
            !is_of_other_hole(s, hole, start + fraction * (end - start))) {
            return true;
        }
    }
    return p->needle != NULL && hole->arc < zone && needle_crosses_wall(p);
}

/* Whether the thread has left the wall at a free edge, so far that their contact has no overlap. */
static bool is_out(const scene_object *s, const suture_hole *hole, const scene_hole_context *p)
{
    return vec3_distance(vbss_scene_hole_curve_point(p, hole).position,
                         vbss_hole_point(hole, &p->wall, p->wall.now)) >= contact_distance(p) &&
           !crosses_wall(s, hole, p);
}

void vbss_scene_update_tears(scene_object *s)
{
    for (uint32_t i = 0; i < s->config.hole_capacity; i++) {
        suture_hole *hole = &s->holes[i];
        if (!vbss_scene_is_hole_active(s, hole) || !(hole->torn_length > 0.0)) {
            continue;
        }
        const scene_hole_context p = vbss_scene_get_hole_context(s, hole);
        report_tear(s, hole, &p);
        if (hole->thread == 0 || !vbss_scene_is_hole_torn_open(s, hole)) {
            continue;
        }
        hole->friction_force = 0.0;
        hole->transverse_force = vec3_zero();
        if (is_out(s, hole, &p)) {
            vbss_scene_emit_hole_event(s, VBSS_SCENE_EVENT_TORN_OUT, hole, hole->torn_length);
            *hole = (suture_hole){0};
        }
    }
}
