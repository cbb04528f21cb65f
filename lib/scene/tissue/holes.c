/* The list of holes: adding, closing, and moving them to a piece that was cut off. */
#include "scene/tissue/tissue.h"
#include "scene/world/world.h"

static void emit_event_of_body(scene_object *s, vbss_scene_event_kind kind, uint32_t body,
                               const suture_hole *hole, double force)
{
    const suture_wall wall = vbss_scene_wall_of(vbss_scene_body(s, hole->wall));
    vbss_scene_event event = {.kind = kind,
                              .body_a = body,
                              .body_b = hole->wall,
                              .id = hole->id,
                              .value = force,
                              .arc_length = hole->arc};
    vbss_scene_add_event_at(s, &event, vbss_hole_point(hole, &wall, wall.now), hole->id);
}

void vbss_scene_emit_hole_event(scene_object *s, vbss_scene_event_kind kind,
                                const suture_hole *hole, double value)
{
    emit_event_of_body(s, kind, hole->needle != 0 ? hole->needle : hole->thread, hole, value);
}

void vbss_scene_record_holes_before_step(scene_object *s)
{
    for (uint32_t i = 0; i < s->config.hole_capacity; i++) {
        s->step.previous_holes[i] = (scene_previous_hole){s->holes[i].id, s->holes[i].needle};
    }
}

static void emit_swage_event(scene_object *s, const scene_previous_hole *before,
                             const suture_hole *hole)
{
    if (before->id == hole->id && (before->needle == 0) != (hole->needle == 0)) {
        vbss_scene_event_kind kind =
            hole->needle == 0 ? VBSS_SCENE_EVENT_PASSED : VBSS_SCENE_EVENT_RETURNED;
        uint32_t needle = hole->needle == 0 ? before->needle : hole->needle;
        emit_event_of_body(s, kind, needle, hole, 0.0);
    }
}

/* Returns the event with which the suture has left the hole, or 0 if it is still in it. */
static vbss_scene_event_kind exit_event(const scene_hole_context *p, const suture_hole *hole)
{
    const thread_object *t = p->now.thread;
    if (hole->needle == 0 && t != NULL) {
        double end = vbss_thread_arc_length(t, t->node_count - 1);
        bool out = hole->arc > end + SCENE_HOLE_EXIT_DISTANCE ||
                   (p->needle == NULL && hole->arc < -SCENE_HOLE_EXIT_DISTANCE);
        return out ? VBSS_SCENE_EVENT_UNTHREADED : 0;
    }
    double end = vbss_needle_length(p->now.needle) - hole->entry_arc + SCENE_HOLE_EXIT_DISTANCE;
    return hole->arc < hole->entry_arc - SCENE_HOLE_EXIT_DISTANCE ? VBSS_SCENE_EVENT_WITHDRAWN
           : t == NULL && hole->arc > end                         ? VBSS_SCENE_EVENT_PASSED
                                                                  : 0;
}

bool vbss_scene_is_in_other_hole(const scene_object *s, const suture_hole *hole, double arc)
{
    const needle_object *n = vbss_scene_body(s, hole->needle)->rigid.needle;
    const suture_wall wall = vbss_scene_wall_of(vbss_scene_body(s, hole->wall));
    const double contact_distance = n->config.wire_radius + 0.5 * wall.law->thickness;
    for (uint32_t i = 0; i < s->config.hole_capacity; i++) {
        const suture_hole *other = &s->holes[i];
        if (other != hole && other->id != 0 && other->needle == hole->needle &&
            other->wall == hole->wall &&
            fabs(other->arc - arc) < SCENE_EXCLUSION_ARC_RATIO * contact_distance) {
            return true;
        }
    }
    return false;
}

/* Moves a hole that the needle has left to where the needle passes through the wall now. A tip
 * that enters at an oblique angle may pass through beside its hole and be withdrawn from the
 * hole only. */
static bool relocate_hole(const scene_object *s, const scene_hole_context *p, suture_hole *hole)
{
    if (hole->needle == 0) {
        return false;
    }
    const needle_object *n = p->needle->rigid.needle;
    for (uint32_t i = 0; i < n->config.segment_count; i++) {
        const double start = vbss_needle_vertex_arc(n, i), end = vbss_needle_vertex_arc(n, i + 1);
        const vec3 axis[2] = {pose_apply(p->now.needle_pose, vbss_needle_point(n, start)),
                              pose_apply(p->now.needle_pose, vbss_needle_point(n, end))};
        suture_hole relocated = *hole;
        double fraction;
        if (vbss_suture_find_wall_crossing(&p->wall, axis, &relocated, &fraction) &&
            !vbss_scene_is_in_other_hole(s, hole, start + fraction * (end - start))) {
            *hole = relocated;
            hole->friction_force = 0.0;
            hole->transverse_force = vec3_zero();
            vbss_hole_set_arc(hole, start + fraction * (end - start));
            return true;
        }
    }
    return false;
}

void vbss_scene_close_exited_holes(scene_object *s, bool relocates)
{
    for (uint32_t i = 0; i < s->config.hole_capacity; i++) {
        suture_hole *hole = &s->holes[i];
        if (!vbss_scene_is_hole_active(s, hole)) {
            continue;
        }
        const scene_hole_context p = vbss_scene_get_hole_context(s, hole);
        vbss_scene_event_kind out = exit_event(&p, hole);
        emit_swage_event(s, &s->step.previous_holes[i], hole);
        bool stays = relocates && out == VBSS_SCENE_EVENT_WITHDRAWN && relocate_hole(s, &p, hole);
        if (out != 0 && !stays) {
            vbss_scene_emit_hole_event(s, out, hole, 0.0);
            *hole = (suture_hole){0};
        }
    }
}

/* Moves a cut beside a hole, beyond the distance at which an end counts as out of it. Returns
 * true if the cut was in the hole. */
static bool move_cut_out_of_hole(const suture_hole *hole, double *arc_length)
{
    double beyond = *arc_length - hole->arc;
    bool is_inside = fabs(beyond) < SCENE_HOLE_EXIT_DISTANCE;
    *arc_length = is_inside ? hole->arc + (beyond < 0.0 ? -SCENE_HOLE_EXIT_DISTANCE
                                                        : SCENE_HOLE_EXIT_DISTANCE)
                            : *arc_length;
    return is_inside;
}

double vbss_scene_move_cut_out_of_holes(const scene_object *s, uint32_t thread, double arc_length)
{
    bool moved = true;
    for (uint32_t times = 0; moved && times < s->config.hole_capacity; times++) {
        moved = false; /* it may now be in a hole that was tested before */
        for (uint32_t i = 0; i < s->config.hole_capacity; i++) {
            const suture_hole *hole = &s->holes[i];
            bool own = hole->id != 0 && hole->thread == thread;
            moved = (own && move_cut_out_of_hole(hole, &arc_length)) || moved;
        }
    }
    return arc_length;
}

suture_hole *vbss_scene_find_free_hole(scene_object *s)
{
    for (uint32_t i = 0; i < s->config.hole_capacity; i++) {
        if (s->holes[i].id == 0) {
            return &s->holes[i];
        }
    }
    return NULL;
}

void vbss_scene_add_hole(scene_object *s, suture_hole *made, double force)
{
    suture_hole *hole = vbss_scene_find_free_hole(s);
    if (hole == NULL) {
        vbss_scene_emit_hole_event(s, VBSS_SCENE_EVENT_HOLE_LOST, made, 0.0);
        return;
    }
    made->id = ++s->last_hole_id;
    *hole = *made;
    vbss_scene_emit_hole_event(s, VBSS_SCENE_EVENT_PUNCTURE, hole, force);
}

void vbss_scene_remove_holes_of(scene_object *s, uint32_t number)
{
    for (uint32_t i = 0; i < s->config.hole_capacity; i++) {
        const suture_hole *hole = &s->holes[i];
        if (hole->needle == number || hole->thread == number || hole->wall == number) {
            s->holes[i] = (suture_hole){0};
        }
    }
}

void vbss_scene_divide_holes(scene_object *s, uint32_t thread, uint32_t piece, double arc_length)
{
    for (uint32_t i = 0; i < s->config.hole_capacity; i++) {
        suture_hole *hole = &s->holes[i];
        if (hole->id != 0 && hole->thread == thread && hole->arc > arc_length) {
            hole->thread = piece;
            hole->arc -= arc_length;
        }
    }
}

void vbss_scene_close_holes_of_short_threads(scene_object *s)
{
    for (uint32_t i = 0; i < s->config.hole_capacity; i++) {
        suture_hole *hole = &s->holes[i];
        if (hole->id != 0 && hole->thread != 0 &&
            !suture_is_curve(vbss_scene_body(s, hole->thread)->thread.thread)) {
            vbss_scene_emit_hole_event(s, VBSS_SCENE_EVENT_UNTHREADED, hole, 0.0);
            *hole = (suture_hole){0};
        }
    }
}
