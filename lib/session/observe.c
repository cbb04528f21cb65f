/* Fills the observation of the task from the scene after a step. */
#include "session/session.h"
#include "session/tuning.h"

/* ---- bodies */

typedef struct session_bodies {
    const vbss_scene_config *scene_config;
    uint32_t thread_number;
    scene_thread_info thread;
    scene_needle_info needle;
    scene_drain_info drain;
    vbss_drain *drain_handle;
    vbss_grasper *tools[SESSION_TOOLS]; /* NULL: the session has no such tool */
} session_bodies;

/* Finds all bodies but the thread, which may be in pieces. False: one has left the scene. */
static bool find_session_bodies(const session_object *s, session_bodies *b)
{
    const vbss_session_config *c = &s->config;
    const vbss_needle *needle = vbss_scene_inspect_body(s->scene, c->needle).needle;
    b->drain_handle = vbss_scene_inspect_body(s->scene, c->drain).drain;
    bool all_found = needle != NULL && b->drain_handle != NULL;
    for (uint32_t i = 0; i < SESSION_TOOLS; i++) {
        uint32_t number = session_tool_number(s, i);
        b->tools[i] = vbss_scene_inspect_body(s->scene, number).grasper;
        all_found = all_found && (b->tools[i] != NULL || number == 0);
    }
    if (all_found) {
        b->needle = vbss_scene_inspect_needle(needle);
        b->drain = vbss_scene_inspect_drain(b->drain_handle);
    }
    return all_found;
}

static bool find_stitched_thread(const session_object *s, uint32_t number, session_bodies *b)
{
    const vbss_thread *thread = vbss_scene_inspect_body(s->scene, number).thread;
    if (thread != NULL) {
        b->thread_number = number;
        b->thread = vbss_scene_inspect_thread(thread);
    }
    return thread != NULL;
}

/* ---- the thread */

/* The tail's limb lies beyond the arc length of the entry, the needle's before that of the exit. */
static void observe_tension(const scene_thread_info *t, const double arcs[SESSION_SIDES],
                            session_observation *observed)
{
    double arc = 0.0;
    observed->needle_pull = t->node_count > 1 ? t->tensions[0] : 0.0;
    for (uint32_t i = 0; i + 1 < t->node_count; i++) {
        double tension = t->tensions[i];
        if (arc < SESSION_PULL_SPAN) {
            observed->needle_pull = vbss_min(observed->needle_pull, tension);
        }
        observed->max_tension = vbss_max(observed->max_tension, tension);
        if (arc > arcs[SESSION_ENTRY]) {
            observed->tension[SESSION_ENTRY] = vbss_max(observed->tension[SESSION_ENTRY], tension);
        }
        arc += t->rest_lengths[i];
        if (arc < arcs[SESSION_EXIT]) {
            observed->tension[SESSION_EXIT] = vbss_max(observed->tension[SESSION_EXIT], tension);
        }
    }
}

static void observe_thread(const session_object *s, const scene_thread_info *t,
                           session_observation *observed)
{
    double arcs[SESSION_SIDES] = {t->length, 0.0};
    observed->thread_length = arcs[SESSION_ENTRY];
    observed->thread_ends[SESSION_ENTRY] = t->positions[t->node_count - 1];
    observed->thread_ends[SESSION_EXIT] = t->positions[0];
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

static void measure_mark_offsets(const scene_drain_info *d, vec3 rest,
                                 session_hole_observation *hole)
{
    static const double axis[3] = {1.0, 0.0, 0.0}, centre[3] = {0.0, 0.0, 0.0};
    double hole_position[3], mark_position[3], distance[2];
    vec3_store(hole_position, rest);
    for (int k = 0; k < 2; k++) {
        vec3 mark_rest = d->rest_positions[d->marks[k]];
        vec3_store(mark_position, mark_rest);
        (void)vbss_metrics_get_offset(axis, centre, mark_position, hole_position, &hole->angle[k],
                                      &hole->axial[k]);
        distance[k] = vec3_distance(mark_rest, rest);
    }
    hole->mark = distance[1] < distance[0] ? 1 : 0;
}

static session_hole_observation observe_hole(const session_object *s, const scene_hole_info *h,
                                             const session_bodies *b)
{
    session_hole_observation hole = {
        .id = h->id, .thread = h->thread, .arc = h->arc_length, .position = h->position};
    double needle_length = h->thread != 0 ? b->needle.length : 0.0;
    hole.distance_from_tip = needle_length + h->arc_length;
    if (h->id > s->newest_hole) {
        measure_mark_offsets(&b->drain, h->rest_position, &hole);
    }
    return hole;
}

static void observe_holes(const session_object *s, const session_bodies *b,
                          session_observation *observed)
{
    for (uint32_t i = 0; i < b->scene_config->hole_capacity; i++) {
        const scene_hole_info h = vbss_scene_inspect_hole(s->scene, i);
        if (h.id == 0 || h.drain != s->config.drain || observed->hole_count == SESSION_MAX_HOLES) {
            continue;
        }
        uint32_t insert_at = observed->hole_count++;
        while (insert_at > 0 && observed->holes[insert_at - 1].id > h.id) {
            observed->holes[insert_at] = observed->holes[insert_at - 1];
            insert_at--;
        }
        observed->holes[insert_at] = observe_hole(s, &h, b);
    }
}

/* After a cut, the thread of the task is the piece that goes through the entry. */
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

/* Arc length of the tool's grasp nearest to the tail's end, m; negative: it has no grasp. */
static double find_held_arc(const session_object *s, uint32_t tool, const session_bodies *b)
{
    double farthest = -1.0;
    for (uint32_t i = 0; i < b->scene_config->grasp_capacity; i++) {
        const scene_grasp_info g = vbss_scene_inspect_grasp(s->scene, i);
        if (g.tool == tool && g.thread == b->thread_number) {
            farthest = vbss_max(farthest, g.arc_length);
        }
    }
    return farthest;
}

static session_tool_observation observe_tool(const session_object *s, uint32_t tool,
                                             const session_bodies *b)
{
    vbss_grasper_state state = {.needle = 0};
    (void)vbss_grasper_get_state(b->tools[tool], &state, sizeof state);
    session_tool_observation observed = {.has_needle =
                                             state.needle != 0 && state.needle == s->config.needle,
                                         .is_shears = state.kind == VBSS_GRASPER_KIND_SHEARS,
                                         .tip = vec3_load(state.position),
                                         .force = vec3_load(state.hand_force)};
    observed.held_arc = find_held_arc(s, session_tool_number(s, tool), b);
    observed.has_tail =
        observed.held_arc >= 0.0 && b->thread.length - observed.held_arc <= s->config.tail_reach;
    return observed;
}

/* ---- the drain */

static void observe_gap(const session_object *s, const scene_drain_info *d,
                        const vbss_drain_gap *gap, session_observation *observed)
{
    bool use_edges = s->config.gap_measure == VBSS_SESSION_GAP_EDGES || d->is_surface;
    observed->gap = use_edges ? gap->gap : gap->opening;
    observed->signed_gap = use_edges ? gap->signed_gap : gap->opening;
    observed->edge_gap = gap->signed_gap;
    observed->max_gap = use_edges ? gap->largest : gap->widest_opening;
    for (int k = 0; k < 2; k++) {
        observed->lips[k] = use_edges ? d->positions[d->slit_middle[k]] : vec3_load(gap->lips[k]);
    }
}

static void observe_drain(const session_object *s, const session_bodies *b,
                          session_observation *observed)
{
    const scene_drain_info *d = &b->drain;
    vbss_drain_gap gap;
    if (vbss_drain_get_gap(b->drain_handle, &gap, sizeof gap) == VBSS_OK) {
        observe_gap(s, d, &gap, observed);
    }
    observed->torn_fraction =
        d->anchor_count > 0 ? (double)d->torn_anchor_count / (double)d->anchor_count : 0.0;
    observed->anchor_load = d->anchor_load;
    observed->drain_radius = d->radius;
    observed->into_tissue =
        vec3_sub(d->centre, vec3_lerp(observed->lips[0], observed->lips[1], 0.5));
}

/* If the thread has been cut. */
static void observe_cut(const session_object *s, uint32_t entry_count,
                        session_observation *observed)
{
    const bool is_new = observed->thread != s->thread;
    if (s->phase == VBSS_SESSION_PHASE_CUT &&
        (is_new || observed->thread_length < s->thread_length)) {
        observed->free_length = vbss_session_find_free_length(
            s, entry_count, observed->thread, is_new ? SESSION_EXIT : SESSION_ENTRY);
    }
}

void vbss_session_observe(const session_object *s, session_observation *observed)
{
    scene_info scene;
    session_bodies b = {.thread_number = 0};
    *observed = (session_observation){.knot = s->knot};
    observed->has_lost_body = true;
    if (vbss_scene_inspect(s->scene, &scene) != VBSS_OK || !find_session_bodies(s, &b)) {
        return;
    }
    b.scene_config = scene.config;
    observe_holes(s, &b, observed);
    observed->thread = stitched_thread(s, observed);
    if (!find_stitched_thread(s, observed->thread, &b)) {
        return;
    }
    observed->has_lost_body = false;
    observe_thread(s, &b.thread, observed);
    for (uint32_t i = 0; i < SESSION_TOOLS; i++) {
        if (b.tools[i] != NULL) {
            observed->tools[i] = observe_tool(s, i, &b);
        }
    }
    observe_drain(s, &b, observed);
    observe_cut(s, scene.entry_count, observed);
}
