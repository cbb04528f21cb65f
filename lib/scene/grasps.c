/* What graspers hold: taken by jaws that touch it from both sides, held by rows (grasp_rows.c), let go as
 * it was. Between two steps what was pulled too hard slides. */
#include "base/error.h"
#include "scene/events.h"
#include "scene/scene.h"
#include "scene/tools.h"

#include "collision/closest.h"

/* Jaws give: a strand that they would touch within this angle of the one that stops them is held as well, rad. */
#define GIVE 0.02
/* As a share of touching: what was let go is still between the jaws. */
#define STILL_BETWEEN 0.5

/* ---- who holds what */

scene_grasp *vbss_scene_free_grasp(const scene_object *s)
{
    for (uint32_t i = 0; i < s->config.grasp_capacity; i++) {
        if (s->grasps[i].id == 0) {
            return &s->grasps[i];
        }
    }
    return NULL;
}

/* Not what it waits for, by method PAPER, while another tool leads. */
static bool holds(const scene_object *s, uint32_t tool, const scene_grasp *g)
{
    bool waits = s->config.method == VBSS_METHOD_PAPER && g->pin == 0;
    return g->id != 0 && g->tool == tool && !g->let_go && !waits;
}

uint32_t vbss_scene_count_grasps(const scene_object *s, uint32_t tool)
{
    uint32_t count = 0;
    for (uint32_t i = 0; i < s->config.grasp_capacity; i++) {
        count += holds(s, tool, &s->grasps[i]);
    }
    return count + vbss_scene_holds_needle(s, tool) + vbss_scene_pinches(s, tool);
}

void vbss_scene_forget_grasps_of(scene_object *s, uint32_t number)
{
    for (uint32_t i = 0; i < s->config.grasp_capacity; i++) {
        scene_grasp *g = &s->grasps[i];
        if (g->id != 0 && (g->thread == number || g->tool == number)) { /* pins are gone already */
            *g = (scene_grasp){0};
        }
    }
}

static double arc_of(const scene_object *s, const scene_grasp *g)
{
    const thread_object *t = vbss_scene_body(s, g->thread)->thread.thread;
    return vbss_thread_arc_length(t, g->segment) + g->into;
}

void vbss_scene_tell_grasp(scene_object *s, vbss_event_kind kind, const scene_grasp *g)
{
    double arc = 1e6 * arc_of(s, g);
    vbss_scene_add_event(s, kind, g->thread, g->tool, (uint32_t)vbss_max(arc, 0.0));
}

/* ---- taking */

/* A place of a thread between open jaws. */
typedef struct strand {
    const scene_body *thread;
    uint32_t segment;
    grasper_jaw_point at;
    double diameter;
    double angle; /* at which the jaws touch it from both sides, with what lies across from it */
} strand;

typedef struct mouth {
    const grasper_object *grasper;
    uint32_t tool;
    pose jaws;
    strand strands[SCENE_STRANDS];
    uint32_t count;
} mouth;

/* What has just been torn out is not held again because it is still there, nor is cut what was let through. */
static bool is_torn(const scene_object *s, const mouth *m, const scene_body *b, uint32_t segment)
{
    bool cuts = m->grasper->kind == VBSS_GRASPER_SHEARS; /* also further on */
    double radius = vbss_grasper_current_jaws(m->grasper)->radius;
    double reach =
        cuts ? GRASPER_MAX_OFFSET_RATIO * radius : radius + b->thread.thread->config.radius;
    for (uint32_t i = 0; i < s->config.grasp_capacity; i++) {
        const scene_grasp *g = &s->grasps[i];
        if (g->id != 0 && g->torn && g->tool == m->tool && g->thread == b->number &&
            vbss_scene_is_held_at(s, g, segment, reach)) {
            return true;
        }
    }
    return false;
}

static void look_along(const scene_object *s, const scene_body *b, mouth *m)
{
    const thread_object *t = b->thread.thread;
    const double length = vbss_grasper_current_jaws(m->grasper)->length;
    strand *last =
        NULL; /* of a run of segments that all lie between: the one nearest to the middle */
    bool is_torn_run = false;
    for (uint32_t i = 0; i + 1 < t->node_count; i++) {
        vec3 off = vec3_sub(t->now.x[i], m->jaws.position);
        double reach = 1.1 * length + t->rest[i];
        strand found = {.thread = b, .segment = i, .diameter = 2.0 * t->config.radius};
        bool between =
            vec3_norm_squared(off) < reach * reach &&
            vbss_grasper_find_between(m->grasper, pose_apply_inverse(m->jaws, t->now.x[i]),
                                      pose_apply_inverse(m->jaws, t->now.x[i + 1]), &found.at);
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
        } else if (m->count < SCENE_STRANDS) {
            last = &m->strands[m->count++];
            *last = found;
        }
    }
}

/* Strands side by side between the same places of the jaws are pressed on one another. */
static void stack(mouth *m)
{
    for (uint32_t i = 0; i < m->count; i++) {
        strand *a = &m->strands[i];
        double width = a->diameter;
        for (uint32_t k = 0; k < m->count; k++) {
            const strand *b = &m->strands[k];
            double apart = fabs(a->at.from_pivot - b->at.from_pivot);
            width += k != i && apart < 0.5 * (a->diameter + b->diameter) ? b->diameter : 0.0;
        }
        a->angle = vbss_grasper_touching_angle(width, a->at.from_pivot);
    }
}

static void look_between(const scene_object *s, const scene_body *tool, mouth *m)
{
    const scene_rigid *r = &tool->rigid;
    m->tool = tool->number;
    m->grasper = r->grasper;
    m->jaws = vbss_scene_jaws_of(r, r->body.now.pose);
    m->count = 0;
    for (uint32_t i = 0; i < s->place_count; i++) {
        if (s->bodies[i].kind == BODY_THREAD) {
            look_along(s, &s->bodies[i], m);
        }
    }
    stack(m);
}

static void take(scene_object *s, const scene_body *tool, const mouth *m, const strand *found)
{
    const thread_object *t = found->thread->thread.thread;
    for (uint32_t i = 0; i < s->config.grasp_capacity; i++) { /* held again before it had left */
        scene_grasp *old = &s->grasps[i];
        if (old->let_go && old->thread == found->thread->number && old->tool == tool->number) {
            *old = (scene_grasp){0};
        }
    }
    scene_grasp *g = vbss_scene_free_grasp(s);
    if (g == NULL) {
        vbss_scene_add_event(s, VBSS_EVENT_GRASP_LOST, found->thread->number, tool->number, 0);
        return;
    }
    *g = (scene_grasp){.id = ++s->last_grasp,
                       .thread = found->thread->number,
                       .tool = tool->number,
                       .segment = found->segment,
                       .into = found->at.fraction * t->rest[found->segment],
                       .angle = found->angle,
                       .spacing = m->grasper->config.grip_length / (GRASPER_THREAD_POINTS - 1)};
    for (uint32_t k = 0; k < GRASPER_THREAD_POINTS; k++) {
        g->grip.anchor[k] = pose_apply_inverse(m->jaws, vbss_scene_held_point(g, t, t->now.x, k));
    }
    vbss_scene_tell_grasp(s, VBSS_EVENT_GRASP, g);
}

/* The angle below which the jaws cannot close, for what is held. */
static double held_angle(const scene_object *s, const scene_body *tool)
{
    const scene_hold *hold = &tool->rigid.hold;
    const scene_pinch *pinch = &tool->rigid.pinch;
    double angle = vbss_scene_holds_needle(s, tool->number) ? hold->angle : 0.0;
    angle = vbss_scene_pinches(s, tool->number) ? vbss_max(pinch->angle, angle) : angle;
    for (uint32_t i = 0; i < s->config.grasp_capacity; i++) {
        const scene_grasp *g = &s->grasps[i];
        if (g->id != 0 && g->tool == tool->number && !g->let_go) {
            angle = vbss_max(g->angle, angle);
        }
    }
    return angle;
}

/* Of what the blades reach, what they cannot cut does not stop them. */
static void let_through(scene_object *s, mouth *m, double next)
{
    uint32_t kept = 0;
    for (uint32_t i = 0; i < m->count; i++) {
        const strand *found = &m->strands[i];
        const scene_strand at = {found->thread, found->segment, found->at.fraction};
        if (found->angle < next || !vbss_scene_let_through(s, m->tool, &at, found->angle)) {
            m->strands[kept++] = *found;
        }
    }
    m->count = kept;
}

double vbss_scene_close_jaws(scene_object *s, scene_body *tool, double h)
{
    grasper_object *g = tool->rigid.grasper;
    double least = held_angle(s, tool);
    double next = vbss_grasper_next_angle(g, h, least);
    if (least > 0.0 || next >= g->jaw_angle) {
        return next;
    }
    mouth m;
    look_between(s, tool, &m);
    if (g->kind == VBSS_GRASPER_SHEARS) {
        let_through(s, &m, next);
    }
    scene_hold needle;
    scene_pinch wall;
    double stop = vbss_scene_find_needle(s, tool, &needle) ? needle.angle : 0.0;
    stop = vbss_scene_find_wall(s, tool, &wall) ? vbss_max(wall.angle, stop) : stop;
    for (uint32_t i = 0; i < m.count; i++) {
        stop = vbss_max(m.strands[i].angle, stop);
    }
    if (stop < next) {
        return next;
    }
    next = vbss_min(stop, g->jaw_angle); /* as it is, if it is squeezed a little already */
    if (needle.needle != 0 && needle.angle >= stop - GIVE && g->kind != VBSS_GRASPER_SHEARS) {
        vbss_scene_take_needle(s, tool, &needle);
    }
    if (wall.drain != 0 && wall.angle >= stop - GIVE && g->kind != VBSS_GRASPER_SHEARS) {
        vbss_scene_take_wall(s, tool, &wall);
    }
    for (uint32_t i = 0; i < m.count; i++) {
        if (m.strands[i].angle < stop - GIVE) {
            continue;
        }
        if (g->kind == VBSS_GRASPER_SHEARS) {
            const scene_strand at = {m.strands[i].thread, m.strands[i].segment,
                                     m.strands[i].at.fraction};
            vbss_scene_note_cut(s, &at);
        } else {
            take(s, tool, &m, &m.strands[i]);
        }
    }
    return next;
}

/* ---- letting go */

/* Whether the axes of both jaws are that share of touching away from what was let go. */
static bool is_clear(const scene_object *s, const scene_grasp *g, double share)
{
    const thread_object *t = vbss_scene_body(s, g->thread)->thread.thread;
    const scene_rigid *r = &vbss_scene_body(s, g->tool)->rigid;
    for (uint32_t k = GRASPER_JAW; k < GRASPER_NECK; k++) {
        const scene_capsule *c = &s->capsules[r->first_capsule + k];
        vec3 axis[2];
        double touching = c->radius + t->config.radius;
        vbss_scene_place_capsule(c, r->body.now.pose, axis);
        for (uint32_t i = 0; i + 1 < t->node_count; i++) {
            if (vbss_scene_is_held_at(s, g, i, touching)) {
                double at[2];
                vec3 apart = closest_between_edges(vec3_sub(t->now.x[i + 1], t->now.x[i]),
                                                   vec3_sub(axis[1], axis[0]),
                                                   vec3_sub(axis[0], t->now.x[i]), &at[0], &at[1]);
                if (vec3_norm(apart) < share * touching) {
                    return false;
                }
            }
        }
    }
    return true;
}

bool vbss_scene_is_held_at(const scene_object *s, const scene_grasp *g, uint32_t segment,
                           double touching)
{
    const double *rest = vbss_scene_body(s, g->thread)->thread.thread->rest;
    double most = SCENE_PIN_ARC * touching + g->spacing;
    double arc = segment > g->segment   ? rest[g->segment] - g->into
                 : segment < g->segment ? g->into
                                        : 0.0;
    for (uint32_t k = g->segment + 1; k < segment && arc < most; k++) {
        arc += rest[k];
    }
    for (uint32_t k = segment + 1; k < g->segment && arc < most; k++) {
        arc += rest[k];
    }
    return arc < most;
}

/* What is let go lies between the jaws, which touch it from now on. What was pulled into one of them, as the
 * clamp gives way, is not touched before it has been clear of both: it might come out on the wrong side. */
void vbss_scene_let_go(scene_object *s, const scene_body *tool)
{
    double told = vbss_grasper_commanded_angle(tool->rigid.grasper);
    for (uint32_t i = 0; i < s->config.grasp_capacity; i++) {
        scene_grasp *g = &s->grasps[i];
        if (g->id == 0 || g->tool != tool->number || !(told > g->angle)) {
            continue;
        }
        g->torn = false;
        if (!g->let_go) {
            vbss_scene_tell_grasp(s, VBSS_EVENT_RELEASE, g);
            g->let_go = true;
            g->force = vec3_zero();
            if (is_clear(s, g, STILL_BETWEEN)) {
                *g = (scene_grasp){0};
            }
        }
    }
}

/* ---- after a step */

static void slide(scene_object *s, scene_grasp *g, double way)
{
    const thread_object *t = vbss_scene_body(s, g->thread)->thread.thread;
    g->into += way;
    g->slid += fabs(way);
    while (g->into < 0.0 && g->segment > 0) {
        g->into += t->rest[--g->segment];
    }
    while (g->into > t->rest[g->segment] && g->segment + 2 < t->node_count) {
        g->into -= t->rest[g->segment++];
    }
    bool sliding = way != 0.0;
    if (sliding && !g->sliding) {
        vbss_scene_tell_grasp(s, VBSS_EVENT_SLIP, g);
    }
    g->sliding = sliding;
}

/* Over the end of the thread. */
static bool is_over(const scene_object *s, const scene_grasp *g)
{
    const thread_object *t = vbss_scene_body(s, g->thread)->thread.thread;
    return g->into < 0.0 || g->into > t->rest[g->segment];
}

/* Arc length that is held on one side of the middle: to the thread's end at most. */
static double held_ahead(const thread_object *t, const scene_grasp *g, bool on)
{
    uint32_t i = g->segment;
    double arc = on ? t->rest[i] - g->into : g->into;
    while (arc < g->spacing && (on ? i + 2 < t->node_count : i > 0)) {
        i = on ? i + 1 : i - 1;
        arc += t->rest[i];
    }
    return vbss_max(vbss_min(arc, g->spacing), 0.0);
}

static void settle(scene_object *s, scene_grasp *g, double h)
{
    const scene_rigid *r = &vbss_scene_body(s, g->tool)->rigid;
    const thread_object *t = vbss_scene_body(s, g->thread)->thread.thread;
    pose jaws = vbss_scene_jaws_of(r, r->body.now.pose);
    double stiffness = r->grasper->config.grip_stiffness / GRASPER_THREAD_POINTS;
    vec3 way = vec3_sub(t->now.x[g->segment + 1], t->now.x[g->segment]);
    uint32_t strands = vbss_scene_count_grasps(s, g->tool);
    grasper_thread_load load = {
        .jaw_force = r->grasper->jaw_force / strands,
        .thread_direction =
            vec3_unit_or(quat_rotate_back(jaws.orientation, way), vec3_make(0.0, 1.0, 0.0)),
        .arc_offset = {-held_ahead(t, g, false), 0.0, held_ahead(t, g, true)},
        .h = h,
        .is_stacked = strands > 1};
    g->force = vec3_zero();
    for (uint32_t k = 0; k < GRASPER_THREAD_POINTS; k++) {
        vec3 here = pose_apply_inverse(jaws, vbss_scene_held_point(g, t, t->now.x, k));
        load.force[k] = vec3_scale(vec3_sub(g->grip.anchor[k], here), stiffness);
        load.force[k].x *= GRASPER_NORMAL_STIFFNESS_RATIO;
        g->force = vec3_add(g->force, quat_rotate(jaws.orientation, load.force[k]));
    }
    g->limit = vbss_grasper_friction_limit(r->grasper, load.jaw_force);
    grasper_thread_slip change = vbss_grasper_yield_thread(r->grasper, &g->grip, &load);
    slide(s, g, change.slip);
    if (change.has_escaped || is_over(s, g)) {
        vbss_scene_tell_grasp(s, VBSS_EVENT_TORN, g);
        g->let_go = g->torn = true;
        g->force = vec3_zero();
    }
}

void vbss_scene_forget_clear_grasps(scene_object *s)
{
    for (uint32_t i = 0; i < s->config.grasp_capacity; i++) {
        scene_grasp *g = &s->grasps[i];
        if (g->id != 0 && g->let_go && is_clear(s, g, 1.0)) {
            *g = (scene_grasp){0};
        }
    }
}

void vbss_scene_settle_grasps(scene_object *s, double h)
{
    vbss_scene_forget_clear_grasps(s);
    for (uint32_t i = 0; i < s->config.grasp_capacity; i++) {
        scene_grasp *g = &s->grasps[i];
        if (g->id != 0 && !g->let_go) {
            settle(s, g, h);
        }
    }
}

vbss_result vbss_scene_get_grasp(vbss_scene *scene, uint32_t tool, uint32_t index,
                                 vbss_grasp *grasp, uint32_t struct_size)
{
    static const uint32_t sizes[] = {sizeof(vbss_grasp), 0};
    static const vbss_layout layout = {"vbss_grasp", NULL, sizes};
    scene_object *s;
    VBSS_TRY(vbss_scene_open(scene, &s));
    uint32_t left = index;
    for (uint32_t i = 0; i < s->config.grasp_capacity; i++) {
        const scene_grasp *g = &s->grasps[i];
        bool other = !holds(s, tool, g);
        if (other || left > 0) {
            left -= !other;
            continue;
        }
        const thread_object *t = vbss_scene_body(s, g->thread)->thread.thread;
        vbss_grasp own = {.struct_size = sizeof own,
                          .thread = g->thread,
                          .arc_length = arc_of(s, g),
                          .limit = g->limit,
                          .slid = g->slid};
        vec3_store(own.position,
                   s->config.method == VBSS_METHOD_PAPER
                       ? t->now.x[g->segment]
                       : vbss_scene_held_point(g, t, t->now.x, GRASPER_THREAD_POINTS / 2));
        vec3_store(own.force, g->force);
        return vbss_struct_write(s->context, &layout, &own, grasp, struct_size);
    }
    if (left == 0 && vbss_scene_holds_needle(s, tool)) {
        vbss_grasp own = {.struct_size = sizeof own};
        vbss_scene_show_hold(s, vbss_scene_body(s, tool), &own);
        return vbss_struct_write(s->context, &layout, &own, grasp, struct_size);
    }
    left -= vbss_scene_holds_needle(s, tool) ? 1 : 0;
    if (left == 0 && vbss_scene_pinches(s, tool)) {
        vbss_grasp own = {.struct_size = sizeof own};
        vbss_scene_show_pinch(s, vbss_scene_body(s, tool), &own);
        return vbss_struct_write(s->context, &layout, &own, grasp, struct_size);
    }
    return vbss_fail(s->context, VBSS_ERROR_OUT_OF_RANGE, "body %u does not hold %u places", tool,
                     index + 1);
}
