/* What the task can see of the scene after a step. */
#include "session/session.h"

/* ---- bodies */

typedef struct bodies {
    const scene_body *thread, *needle, *drain, *tools[SESSION_TOOLS];
} bodies;

static const scene_body *body_of(const scene_object *scene, uint32_t number, scene_body_kind kind)
{
    const scene_body *b = number > 0 ? vbss_scene_body(scene, number) : NULL;
    return b != NULL && b->kind == kind ? b : NULL;
}

/* All but the thread, of which there may be pieces. */
static bool find_bodies(const session_object *s, const scene_object *scene, bodies *b)
{
    const vbss_session_config *c = &s->config;
    const uint32_t numbers[SESSION_TOOLS] = {c->tools[0], c->tools[1], c->shears};
    b->needle = body_of(scene, c->needle, SCENE_BODY_RIGID);
    b->drain = body_of(scene, c->drain, SCENE_BODY_DRAIN);
    bool all = b->needle != NULL && b->drain != NULL;
    for (int i = 0; i < SESSION_TOOLS; i++) {
        b->tools[i] = body_of(scene, numbers[i], SCENE_BODY_RIGID);
        all = all && (b->tools[i] != NULL || numbers[i] == 0);
    }
    return all;
}

/* ---- the thread */

static double length_of(const thread_object *t)
{
    return vbss_thread_arc_length(t, t->node_count - 1);
}

/* Largest tension before the hole out, and beyond the hole in; without holes, of all. */
static void look_at_tension(const thread_object *t, const double arcs[SESSION_MARKS],
                            session_look *look)
{
    double arc = 0.0;
    for (uint32_t i = 0; i + 1 < t->node_count; i++) {
        double tension = t->now.tension[i];
        look->most_tension = vbss_max(look->most_tension, tension);
        if (arc > arcs[SESSION_IN]) {
            look->tension[SESSION_IN] = vbss_max(look->tension[SESSION_IN], tension);
        }
        arc += t->rest[i];
        if (arc < arcs[SESSION_OUT]) {
            look->tension[SESSION_OUT] = vbss_max(look->tension[SESSION_OUT], tension);
        }
    }
}

static void look_at_thread(const session_object *s, const thread_object *t, session_look *look)
{
    double arcs[SESSION_MARKS] = {length_of(t), 0.0};
    look->length = arcs[SESSION_IN];
    look->thread_ends[SESSION_IN] = t->now.x[t->node_count - 1];
    look->thread_ends[SESSION_OUT] = t->now.x[0];
    for (uint32_t i = 0; i < look->hole_count; i++) {
        const session_hole_look *hole = &look->holes[i];
        for (int k = 0; k < SESSION_MARKS; k++) {
            if (hole->id == s->holes[k].id && hole->thread == look->thread) {
                arcs[k] = hole->arc;
            }
        }
    }
    look_at_tension(t, arcs, look);
}

/* ---- holes */

static void measure_marks(const drain_object *d, vec3 rest, session_hole_look *hole)
{
    static const double axis[3] = {1.0, 0.0, 0.0}, centre[3] = {0.0, 0.0, 0.0};
    double place[3], mark[3], farness[2];
    vec3_store(place, rest);
    for (int k = 0; k < 2; k++) {
        vec3 at = d->mesh.rest[d->mesh.marks[k]];
        vec3_store(mark, at);
        (void)vbss_metrics_offset(axis, centre, mark, place, &hole->angle[k], &hole->axial[k]);
        farness[k] = vec3_distance(at, rest);
    }
    hole->mark = farness[1] < farness[0] ? 1 : 0;
}

static session_hole_look look_at_hole(const session_object *s, const suture_hole *h,
                                      const bodies *b)
{
    const drain_object *d = b->drain->drain.drain;
    session_hole_look hole = {.id = h->id, .thread = h->thread, .arc = h->arc};
    double before = h->thread != 0 ? vbss_needle_length(b->needle->rigid.needle) : 0.0;
    hole.way = before + h->arc;
    hole.at = vbss_hole_point(h, d, d->x);
    if (h->id > s->newest_hole) {
        measure_marks(d, vbss_hole_point(h, d, d->mesh.rest), &hole);
    }
    return hole;
}

static void look_at_holes(const session_object *s, const scene_object *scene, const bodies *b,
                          session_look *look)
{
    for (uint32_t i = 0; i < scene->config.hole_capacity; i++) {
        const suture_hole *h = &scene->holes[i];
        if (h->id == 0 || h->drain != s->config.drain || look->hole_count == SESSION_HOLES) {
            continue;
        }
        uint32_t at = look->hole_count++;
        while (at > 0 && look->holes[at - 1].id > h->id) {
            look->holes[at] = look->holes[at - 1];
            at--;
        }
        look->holes[at] = look_at_hole(s, h, b);
    }
}

/* After a cut the piece that goes through the hole in is the thread. */
static uint32_t thread_of(const session_object *s, const session_look *look)
{
    uint32_t thread = s->thread;
    for (uint32_t i = 0; i < look->hole_count; i++) {
        const session_hole_look *hole = &look->holes[i];
        if (hole->id == s->holes[SESSION_IN].id && hole->thread != 0) {
            thread = hole->thread;
        }
    }
    return thread;
}

/* ---- tools */

/* Where a tool holds the thread nearest to the end of its tail, m; below 0: it does not. */
static double held_arc(const scene_object *scene, uint32_t tool, const scene_body *thread)
{
    const thread_object *t = thread->thread.thread;
    double farthest = -1.0;
    for (uint32_t i = 0; i < scene->config.grasp_capacity; i++) {
        const scene_thread_grasp *g = &scene->thread_grasps[i];
        if (g->id != 0 && !g->is_released && g->tool == tool && g->thread == thread->number) {
            double into = g->pin != 0 ? 0.0 : g->segment_offset;
            farthest = vbss_max(farthest, vbss_thread_arc_length(t, g->segment) + into);
        }
    }
    return farthest;
}

static session_tool_look look_at_tool(const session_object *s, const scene_object *scene,
                                      const scene_body *tool, const bodies *b, double length)
{
    const grasper_object *g = tool->rigid.grasper;
    session_tool_look look = {.has_needle = g->needle != 0 && g->needle == s->config.needle,
                              .cuts = g->kind == VBSS_GRASPER_SHEARS,
                              .tip = g->tool_pose.position,
                              .force = g->hand_force};
    look.held_arc = held_arc(scene, tool->number, b->thread);
    look.has_tail = look.held_arc >= 0.0 && length - look.held_arc <= s->config.tail_reach;
    return look;
}

/* ---- the drain */

/* Walls of method PAPER are surfaces: they have no height. */
static void look_at_gap(const session_object *s, const drain_object *d, const vbss_drain_gap *gap,
                        session_look *look)
{
    bool edges =
        s->config.gap_measure == VBSS_SESSION_GAP_EDGES || d->config.method == VBSS_METHOD_PAPER;
    look->gap = edges ? gap->gap : gap->opening;
    look->open = edges ? gap->signed_gap : gap->opening;
    look->gap_most = edges ? gap->largest : gap->widest_opening;
    for (int k = 0; k < 2; k++) {
        look->lips[k] = edges ? d->x[d->mesh.slit_middle[k]] : vec3_load(gap->lips[k]);
    }
}

static void look_at_drain(const session_object *s, const drain_object *d, vbss_drain *handle,
                          vec3 middle_of_tube, session_look *look)
{
    vbss_drain_gap gap;
    if (vbss_drain_get_gap(handle, &gap, sizeof gap) == VBSS_OK) {
        look_at_gap(s, d, &gap, look);
    }
    look->torn =
        d->mesh.anchor_count > 0 ? (double)d->statistics.torn / (double)d->mesh.anchor_count : 0.0;
    look->radius = d->config.radius;
    look->away = vec3_sub(middle_of_tube, vec3_lerp(look->lips[0], look->lips[1], 0.5));
}

void vbss_session_look(const session_object *s, session_look *look)
{
    const scene_object *scene = ((const vbss_slot *)s->scene)->object;
    bodies b;
    *look = (session_look){.knot = s->knot};
    look->lost = true;
    if (!find_bodies(s, scene, &b)) {
        return;
    }
    const drain_object *d = b.drain->drain.drain;
    look_at_holes(s, scene, &b, look);
    look->thread = thread_of(s, look);
    b.thread = body_of(scene, look->thread, SCENE_BODY_THREAD);
    if (b.thread == NULL) {
        return;
    }
    look->lost = false;
    look_at_thread(s, b.thread->thread.thread, look);
    for (int i = 0; i < SESSION_TOOLS; i++) {
        if (b.tools[i] != NULL) {
            look->tools[i] = look_at_tool(s, scene, b.tools[i], &b, look->length);
        }
    }
    look_at_drain(s, d, (vbss_drain *)b.drain->drain.slot, d->frame.position, look);
}
