/* Threads in the jaws of graspers: found, grasped, released and sliding.
 *
 * Jaws grasp a strand that they touch from both sides, in the position that it has. Bilateral
 * constraints hold three of its points (contacts/grasp_constraints.c). After a step the strand
 * slides in the jaws if the load exceeds their friction limit. */
#include "collision/closest.h"
#include "scene/tools/tools.h"
#include "scene/tuning.h"
#include "scene/world/method.h"
#include "scene/world/world.h"

/* ---- the list of grasps */

void vbss_scene_remove_thread_grasps_of(scene_object *s, uint32_t number)
{
    for (uint32_t i = 0; i < s->config.grasp_capacity; i++) {
        scene_thread_grasp *g = &s->thread_grasps[i];
        /* its pins have been removed before */
        if (g->id != 0 && (g->thread == number || g->tool == number)) {
            *g = (scene_thread_grasp){0};
        }
    }
}

double vbss_scene_grasp_arc(const scene_object *s, const scene_thread_grasp *g)
{
    const thread_object *t = vbss_scene_body(s, g->thread)->thread.thread;
    return vbss_thread_arc_length(t, g->segment) + g->segment_offset;
}

void vbss_scene_describe_thread_grasp(const scene_object *s, const scene_thread_grasp *g,
                                      vbss_scene_grasp *grasp)
{
    const thread_object *t = vbss_scene_body(s, g->thread)->thread.thread;
    grasp->body = g->thread;
    grasp->arc_length = vbss_scene_grasp_arc(s, g);
    grasp->limit = g->limit;
    grasp->slid = g->slid;
    const vec3 position = s->method->grasp_position(t, g);
    vec3_store(grasp->position, position);
    vec3_store(grasp->force, g->force);
}

void vbss_scene_emit_thread_grasp_event(scene_object *s, vbss_scene_event_kind kind,
                                        const scene_thread_grasp *g)
{
    scene_grasp_event of = {.tool = g->tool};
    vbss_scene_describe_thread_grasp(s, g, &of.grasp);
    of.logged_number = (uint32_t)vbss_max(1e6 * of.grasp.arc_length, 0.0);
    vbss_scene_emit_grasp_event(s, kind, &of);
}

/* ---- grasping */

/* Whether a segment belongs to a strand that must not be grasped, because it was just torn out,
 * or cut, because the shears cannot cut it. */
static bool is_torn(const scene_object *s, const scene_jaw_query *m, const scene_body *b,
                    uint32_t segment)
{
    /* shears exclude a longer stretch of the thread */
    bool is_shears = m->grasper->kind == VBSS_GRASPER_KIND_SHEARS;
    double radius = vbss_grasper_current_jaws(m->grasper)->radius;
    double reach =
        is_shears ? GRASPER_MAX_OFFSET_RATIO * radius : radius + b->thread.thread->config.radius;
    for (uint32_t i = 0; i < s->config.grasp_capacity; i++) {
        const scene_thread_grasp *g = &s->thread_grasps[i];
        if (g->id != 0 && g->needs_reopening && g->tool == m->tool && g->thread == b->number &&
            vbss_scene_is_segment_in_grasp(s, g, segment, reach)) {
            return true;
        }
    }
    return false;
}

static void find_strands_of_thread(const scene_object *s, const scene_body *b, scene_jaw_query *m)
{
    const thread_object *t = b->thread.thread;
    const double length = vbss_grasper_current_jaws(m->grasper)->length;
    /* in a run of segments between the jaws: the one nearest to their middle */
    scene_strand_candidate *last = NULL;
    bool is_torn_run = false;
    for (uint32_t i = 0; i + 1 < t->node_count; i++) {
        vec3 off = vec3_sub(t->now.x[i], m->jaws.position);
        double reach = SCENE_STRAND_SEARCH_RATIO * length + t->rest[i];
        scene_strand_candidate found = {
            .thread = b, .segment = i, .diameter = 2.0 * t->config.radius};
        bool between =
            vec3_norm_squared(off) < reach * reach &&
            vbss_grasper_find_between(m->grasper, pose_apply_inverse(m->jaws, t->now.x[i]),
                                      pose_apply_inverse(m->jaws, t->now.x[i + 1]), 0.0, &found.at);
        if (!between) {
            last = NULL;
            is_torn_run = false;
        } else if (is_torn_run || is_torn(s, m, b, i)) {
            m->count -= last != NULL;
            last = NULL;
            is_torn_run = true;
        } else if (last != NULL) {
            if (found.at.offset < last->at.offset) {
                *last = found;
            }
        } else if (m->count < SCENE_MAX_STRANDS) {
            last = &m->strands[m->count++];
            *last = found;
        }
    }
}

/* Strands that lie side by side at the same distance from the pivot are pressed together, so the
 * jaws touch the whole stack. */
static void stack_strands(scene_jaw_query *m)
{
    for (uint32_t i = 0; i < m->count; i++) {
        scene_strand_candidate *a = &m->strands[i];
        double width = a->diameter;
        for (uint32_t k = 0; k < m->count; k++) {
            const scene_strand_candidate *b = &m->strands[k];
            double spacing = fabs(a->at.from_pivot - b->at.from_pivot);
            width += k != i && spacing < 0.5 * (a->diameter + b->diameter) ? b->diameter : 0.0;
        }
        a->angle = vbss_grasper_touching_angle(width, a->at.from_pivot);
    }
}

void vbss_scene_find_strands(const scene_object *s, const scene_body *tool, scene_jaw_query *m)
{
    const scene_rigid *r = &tool->rigid;
    m->tool = tool->number;
    m->grasper = r->grasper;
    m->jaws = vbss_scene_jaw_frame(r, r->body.now.pose);
    m->count = 0;
    for (uint32_t i = 0; i < s->body_count; i++) {
        if (s->bodies[i].kind == SCENE_BODY_THREAD &&
            vbss_scene_do_collide(s, tool, &s->bodies[i])) {
            find_strands_of_thread(s, &s->bodies[i], m);
        }
    }
    stack_strands(m);
}

void vbss_scene_grasp_strand(scene_object *s, const scene_body *tool, const scene_jaw_query *m,
                             const scene_strand_candidate *found)
{
    const thread_object *t = found->thread->thread.thread;
    /* grasped again before the jaws were clear */
    for (uint32_t i = 0; i < s->config.grasp_capacity; i++) {
        scene_thread_grasp *old = &s->thread_grasps[i];
        if (!scene_holds_strand(old) && old->thread == found->thread->number &&
            old->tool == tool->number) {
            *old = (scene_thread_grasp){0};
        }
    }
    scene_thread_grasp *g = vbss_scene_find_free_grasp(s);
    if (g == NULL) {
        const vec3 *x = &t->now.x[found->segment];
        vbss_scene_event event = {.kind = VBSS_SCENE_EVENT_GRASP_LOST,
                                  .body_a = found->thread->number,
                                  .body_b = tool->number,
                                  .arc_length = vbss_thread_arc_length(t, found->segment) +
                                                found->at.fraction * t->rest[found->segment]};
        vbss_scene_add_event_at(s, &event, vec3_lerp(x[0], x[1], found->at.fraction), 0);
        return;
    }
    *g = (scene_thread_grasp){.id = ++s->last_grasp_id,
                              .thread = found->thread->number,
                              .tool = tool->number,
                              .segment = found->segment,
                              .segment_offset = found->at.fraction * t->rest[found->segment],
                              .angle = found->angle,
                              .point_spacing =
                                  m->grasper->config.grip_length / (GRASPER_THREAD_POINTS - 1)};
    for (uint32_t k = 0; k < GRASPER_THREAD_POINTS; k++) {
        g->grip.anchor[k] = pose_apply_inverse(m->jaws, vbss_scene_grip_point(g, t, t->now.x, k));
    }
    vbss_scene_emit_thread_grasp_event(s, VBSS_SCENE_EVENT_GRASP, g);
}

/* ---- releasing */

/* Whether the axes of both jaws are at least this fraction of the contact distance away from the
 * part of the thread that is excluded from contact. */
static bool is_strand_clear(const scene_object *s, const scene_thread_grasp *g, double fraction)
{
    const thread_object *t = vbss_scene_body(s, g->thread)->thread.thread;
    const scene_rigid *r = &vbss_scene_body(s, g->tool)->rigid;
    for (uint32_t k = GRASPER_JAW; k < GRASPER_NECK; k++) {
        const scene_capsule *c = &s->capsules[r->first_capsule + k];
        vec3 axis[2];
        double contact_distance = c->radius + t->config.radius;
        vbss_scene_transform_capsule(c, r->body.now.pose, axis);
        for (uint32_t i = 0; i + 1 < t->node_count; i++) {
            if (vbss_scene_is_segment_in_grasp(s, g, i, contact_distance)) {
                double at[2];
                vec3 separation_vector = closest_between_edges(
                    vec3_sub(t->now.x[i + 1], t->now.x[i]), vec3_sub(axis[1], axis[0]),
                    vec3_sub(axis[0], t->now.x[i]), &at[0], &at[1]);
                if (vec3_norm(separation_vector) < fraction * contact_distance) {
                    return false;
                }
            }
        }
    }
    return true;
}

bool vbss_scene_is_segment_in_grasp(const scene_object *s, const scene_thread_grasp *g,
                                    uint32_t segment, double contact_distance)
{
    const double *rest = vbss_scene_body(s, g->thread)->thread.thread->rest;
    double max_arc = SCENE_EXCLUSION_ARC_RATIO * contact_distance + g->point_spacing;
    double arc = segment > g->segment   ? rest[g->segment] - g->segment_offset
                 : segment < g->segment ? g->segment_offset
                                        : 0.0;
    for (uint32_t k = g->segment + 1; k < segment && arc < max_arc; k++) {
        arc += rest[k];
    }
    for (uint32_t k = segment + 1; k < g->segment && arc < max_arc; k++) {
        arc += rest[k];
    }
    return arc < max_arc;
}

/* A released strand lies between the jaws and touches them from now on. If the clamp has pulled
 * it into a jaw, it stays excluded from contact until it is clear of both: contact could push it
 * out on the wrong side. */
void vbss_scene_release_thread_grasps(scene_object *s, const scene_body *tool)
{
    double target_angle = vbss_grasper_commanded_angle(tool->rigid.grasper);
    for (uint32_t i = 0; i < s->config.grasp_capacity; i++) {
        scene_thread_grasp *g = &s->thread_grasps[i];
        if (g->id == 0 || g->tool != tool->number || !(target_angle > g->angle)) {
            continue;
        }
        g->needs_reopening = false;
        if (scene_holds_strand(g)) {
            vbss_scene_emit_thread_grasp_event(s, VBSS_SCENE_EVENT_RELEASE, g);
            g->is_released = true;
            g->force = vec3_zero();
            if (is_strand_clear(s, g, SCENE_RELEASE_CLEARANCE_RATIO)) {
                *g = (scene_thread_grasp){0};
            }
        }
    }
}

/* ---- after a step */

static void slide_grasp(scene_object *s, scene_thread_grasp *g, double slip)
{
    const thread_object *t = vbss_scene_body(s, g->thread)->thread.thread;
    g->segment_offset += slip;
    g->slid += fabs(slip);
    while (g->segment_offset < 0.0 && g->segment > 0) {
        g->segment_offset += t->rest[--g->segment];
    }
    while (g->segment_offset > t->rest[g->segment] && g->segment + 2 < t->node_count) {
        g->segment_offset -= t->rest[g->segment++];
    }
    bool sliding = slip != 0.0;
    if (sliding && !g->is_sliding) {
        vbss_scene_emit_thread_grasp_event(s, VBSS_SCENE_EVENT_SLIP, g);
    }
    g->is_sliding = sliding;
}

/* Whether the grasp has slid over an end of the thread. */
static bool is_past_end(const scene_object *s, const scene_thread_grasp *g)
{
    const thread_object *t = vbss_scene_body(s, g->thread)->thread.thread;
    return g->segment_offset < 0.0 || g->segment_offset > t->rest[g->segment];
}

/* Arc length between the middle of the grasp and its last point on one side, or the end of the
 * thread. */
static double held_arc(const thread_object *t, const scene_thread_grasp *g, bool forward)
{
    uint32_t i = g->segment;
    double arc = forward ? t->rest[i] - g->segment_offset : g->segment_offset;
    while (arc < g->point_spacing && (forward ? i + 2 < t->node_count : i > 0)) {
        i = forward ? i + 1 : i - 1;
        arc += t->rest[i];
    }
    return vbss_max(vbss_min(arc, g->point_spacing), 0.0);
}

static void update_thread_grasp(scene_object *s, scene_thread_grasp *g, double h)
{
    const scene_rigid *r = &vbss_scene_body(s, g->tool)->rigid;
    const thread_object *t = vbss_scene_body(s, g->thread)->thread.thread;
    pose jaws = vbss_scene_jaw_frame(r, r->body.now.pose);
    double stiffness = r->grasper->config.grip_stiffness / GRASPER_THREAD_POINTS;
    vec3 tangent = vec3_sub(t->now.x[g->segment + 1], t->now.x[g->segment]);
    uint32_t strands = vbss_scene_count_grasps(s, g->tool);
    grasper_thread_load load = {
        .jaw_force = r->grasper->jaw_force / strands,
        .thread_direction =
            vec3_unit_or(quat_rotate_back(jaws.orientation, tangent), vec3_make(0.0, 1.0, 0.0)),
        .arc_offset = {-held_arc(t, g, false), 0.0, held_arc(t, g, true)},
        .h = h,
        .is_stacked = strands > 1};
    g->force = vec3_zero();
    for (uint32_t k = 0; k < GRASPER_THREAD_POINTS; k++) {
        vec3 current = pose_apply_inverse(jaws, vbss_scene_grip_point(g, t, t->now.x, k));
        load.force[k] = vec3_scale(vec3_sub(g->grip.anchor[k], current), stiffness);
        load.force[k].x *= GRASPER_NORMAL_STIFFNESS_RATIO;
        g->force = vec3_add(g->force, quat_rotate(jaws.orientation, load.force[k]));
    }
    g->limit = vbss_grasper_friction_limit(r->grasper, load.jaw_force);
    grasper_thread_slip change = vbss_grasper_yield_thread(r->grasper, &g->grip, &load);
    slide_grasp(s, g, change.slip);
    if (change.has_escaped || is_past_end(s, g)) {
        vbss_scene_emit_thread_grasp_event(s, VBSS_SCENE_EVENT_TORN, g);
        g->is_released = g->needs_reopening = true;
        g->force = vec3_zero();
    }
}

void vbss_scene_remove_clear_thread_grasps(scene_object *s)
{
    for (uint32_t i = 0; i < s->config.grasp_capacity; i++) {
        scene_thread_grasp *g = &s->thread_grasps[i];
        if (g->id != 0 && !scene_holds_strand(g) && is_strand_clear(s, g, 1.0)) {
            *g = (scene_thread_grasp){0};
        }
    }
}

void vbss_scene_update_thread_grasps(scene_object *s, double h)
{
    vbss_scene_remove_clear_thread_grasps(s);
    for (uint32_t i = 0; i < s->config.grasp_capacity; i++) {
        scene_thread_grasp *g = &s->thread_grasps[i];
        if (scene_holds_strand(g)) {
            update_thread_grasp(s, g, h);
        }
    }
}
