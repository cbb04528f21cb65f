/* What the task can see of the scene after a step. */
#include "session/session.h"

/* ---- bodies */

typedef struct session_bodies {
    const scene_body *thread, *needle, *drain, *tools[SESSION_TOOLS];
} session_bodies;

static const scene_body *find_body(const scene_object *scene, uint32_t number, scene_body_kind kind)
{
    const scene_body *b = number > 0 ? vbss_scene_body(scene, number) : NULL;
    return b != NULL && b->kind == kind ? b : NULL;
}

/* All but the thread, of which there may be pieces. */
static bool find_session_bodies(const session_object *s, const scene_object *scene,
                                session_bodies *b)
{
    const vbss_session_config *c = &s->config;
    const uint32_t numbers[SESSION_TOOLS] = {c->tools[0], c->tools[1], c->shears};
    b->needle = find_body(scene, c->needle, SCENE_BODY_RIGID);
    b->drain = find_body(scene, c->drain, SCENE_BODY_DRAIN);
    bool all_found = b->needle != NULL && b->drain != NULL;
    for (int i = 0; i < SESSION_TOOLS; i++) {
        b->tools[i] = find_body(scene, numbers[i], SCENE_BODY_RIGID);
        all_found = all_found && (b->tools[i] != NULL || numbers[i] == 0);
    }
    return all_found;
}

/* ---- the thread */

static double thread_length(const thread_object *t)
{
    return vbss_thread_arc_length(t, t->node_count - 1);
}

/* Largest tension before the hole out, and beyond the hole in; without holes, of all. */
static void observe_tension(const thread_object *t, const double arcs[SESSION_SIDES],
                            session_observation *observed)
{
    double arc = 0.0;
    for (uint32_t i = 0; i + 1 < t->node_count; i++) {
        double tension = t->now.tension[i];
        observed->max_tension = vbss_max(observed->max_tension, tension);
        if (arc > arcs[SESSION_ENTRY]) {
            observed->tension[SESSION_ENTRY] = vbss_max(observed->tension[SESSION_ENTRY], tension);
        }
        arc += t->rest[i];
        if (arc < arcs[SESSION_EXIT]) {
            observed->tension[SESSION_EXIT] = vbss_max(observed->tension[SESSION_EXIT], tension);
        }
    }
}

static void observe_thread(const session_object *s, const thread_object *t,
                           session_observation *observed)
{
    double arcs[SESSION_SIDES] = {thread_length(t), 0.0};
    observed->thread_length = arcs[SESSION_ENTRY];
    observed->thread_ends[SESSION_ENTRY] = t->now.x[t->node_count - 1];
    observed->thread_ends[SESSION_EXIT] = t->now.x[0];
    for (uint32_t i = 0; i < observed->hole_count; i++) {
        const session_hole_observation *hole = &observed->holes[i];
        for (int k = 0; k < SESSION_SIDES; k++) {
            if (hole->id == s->holes[k].id && hole->thread == observed->thread) {
                arcs[k] = hole->arc;
            }
        }
    }
    observe_tension(t, arcs, observed);
}

/* ---- holes */

static void measure_mark_offsets(const drain_object *d, vec3 rest, session_hole_observation *hole)
{
    static const double axis[3] = {1.0, 0.0, 0.0}, centre[3] = {0.0, 0.0, 0.0};
    double hole_position[3], mark_position[3], distance[2];
    vec3_store(hole_position, rest);
    for (int k = 0; k < 2; k++) {
        vec3 mark_rest = d->mesh.rest[d->mesh.marks[k]];
        vec3_store(mark_position, mark_rest);
        (void)vbss_metrics_offset(axis, centre, mark_position, hole_position, &hole->angle[k],
                                  &hole->axial[k]);
        distance[k] = vec3_distance(mark_rest, rest);
    }
    hole->mark = distance[1] < distance[0] ? 1 : 0;
}

static session_hole_observation observe_hole(const session_object *s, const suture_hole *h,
                                             const session_bodies *b)
{
    const drain_object *d = b->drain->drain.drain;
    session_hole_observation hole = {.id = h->id, .thread = h->thread, .arc = h->arc};
    double needle_length = h->thread != 0 ? vbss_needle_length(b->needle->rigid.needle) : 0.0;
    hole.distance_from_tip = needle_length + h->arc;
    hole.position = vbss_hole_point(h, d, d->x);
    if (h->id > s->newest_hole) {
        measure_mark_offsets(d, vbss_hole_point(h, d, d->mesh.rest), &hole);
    }
    return hole;
}

static void observe_holes(const session_object *s, const scene_object *scene,
                          const session_bodies *b, session_observation *observed)
{
    for (uint32_t i = 0; i < scene->config.hole_capacity; i++) {
        const suture_hole *h = &scene->holes[i];
        if (h->id == 0 || h->drain != s->config.drain ||
            observed->hole_count == SESSION_MAX_HOLES) {
            continue;
        }
        uint32_t insert_at = observed->hole_count++;
        while (insert_at > 0 && observed->holes[insert_at - 1].id > h->id) {
            observed->holes[insert_at] = observed->holes[insert_at - 1];
            insert_at--;
        }
        observed->holes[insert_at] = observe_hole(s, h, b);
    }
}

/* After a cut the piece that goes through the hole in is the thread. */
static uint32_t stitched_thread(const session_object *s, const session_observation *observed)
{
    uint32_t thread = s->thread;
    for (uint32_t i = 0; i < observed->hole_count; i++) {
        const session_hole_observation *hole = &observed->holes[i];
        if (hole->id == s->holes[SESSION_ENTRY].id && hole->thread != 0) {
            thread = hole->thread;
        }
    }
    return thread;
}

/* ---- tools */

/* Where a tool holds the thread nearest to the end of its tail, m; below 0: it does not. */
static double find_held_arc(const scene_object *scene, uint32_t tool, const scene_body *thread)
{
    const thread_object *t = thread->thread.thread;
    double farthest = -1.0;
    for (uint32_t i = 0; i < scene->config.grasp_capacity; i++) {
        const scene_thread_grasp *g = &scene->thread_grasps[i];
        if (g->id != 0 && !g->is_released && g->tool == tool && g->thread == thread->number) {
            double offset = g->pin != 0 ? 0.0 : g->segment_offset;
            farthest = vbss_max(farthest, vbss_thread_arc_length(t, g->segment) + offset);
        }
    }
    return farthest;
}

static session_tool_observation observe_tool(const session_object *s, const scene_object *scene,
                                             const scene_body *tool, const session_bodies *b,
                                             double length)
{
    const grasper_object *g = tool->rigid.grasper;
    session_tool_observation observed = {.has_needle =
                                             g->needle != 0 && g->needle == s->config.needle,
                                         .is_shears = g->kind == VBSS_GRASPER_SHEARS,
                                         .tip = g->tool_pose.position,
                                         .force = g->hand_force};
    observed.held_arc = find_held_arc(scene, tool->number, b->thread);
    observed.has_tail =
        observed.held_arc >= 0.0 && length - observed.held_arc <= s->config.tail_reach;
    return observed;
}

/* ---- the drain */

/* Walls of method PAPER are surfaces: they have no height. */
static void observe_gap(const session_object *s, const drain_object *d, const vbss_drain_gap *gap,
                        session_observation *observed)
{
    bool use_edges =
        s->config.gap_measure == VBSS_SESSION_GAP_EDGES || d->config.method == VBSS_METHOD_PAPER;
    observed->gap = use_edges ? gap->gap : gap->opening;
    observed->signed_gap = use_edges ? gap->signed_gap : gap->opening;
    observed->max_gap = use_edges ? gap->largest : gap->widest_opening;
    for (int k = 0; k < 2; k++) {
        observed->lips[k] = use_edges ? d->x[d->mesh.slit_middle[k]] : vec3_load(gap->lips[k]);
    }
}

static void observe_drain(const session_object *s, const drain_object *d, vbss_drain *handle,
                          vec3 tube_centre, session_observation *observed)
{
    vbss_drain_gap gap;
    if (vbss_drain_get_gap(handle, &gap, sizeof gap) == VBSS_OK) {
        observe_gap(s, d, &gap, observed);
    }
    observed->torn_fraction =
        d->mesh.anchor_count > 0 ? (double)d->statistics.torn / (double)d->mesh.anchor_count : 0.0;
    observed->drain_radius = d->config.radius;
    observed->into_tissue =
        vec3_sub(tube_centre, vec3_lerp(observed->lips[0], observed->lips[1], 0.5));
}

void vbss_session_observe(const session_object *s, session_observation *observed)
{
    const scene_object *scene = ((const vbss_slot *)s->scene)->object;
    session_bodies b;
    *observed = (session_observation){.knot = s->knot};
    observed->has_lost_body = true;
    if (!find_session_bodies(s, scene, &b)) {
        return;
    }
    const drain_object *d = b.drain->drain.drain;
    observe_holes(s, scene, &b, observed);
    observed->thread = stitched_thread(s, observed);
    b.thread = find_body(scene, observed->thread, SCENE_BODY_THREAD);
    if (b.thread == NULL) {
        return;
    }
    observed->has_lost_body = false;
    observe_thread(s, b.thread->thread.thread, observed);
    for (int i = 0; i < SESSION_TOOLS; i++) {
        if (b.tools[i] != NULL) {
            observed->tools[i] = observe_tool(s, scene, b.tools[i], &b, observed->thread_length);
        }
    }
    observe_drain(s, d, (vbss_drain *)b.drain->drain.slot, d->frame.position, observed);
}
