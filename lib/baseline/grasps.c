/* Grasps of the baseline. Jaws that have just closed near a thread carry its nearest node
 * exactly. The first tool that grasps a node leads it, and a second tool waits until the first
 * releases it. The hand feels the springs of the two sections beside the node:
 * docs/explanation/paper-scene.md. */
#include "baseline/scene.h"
#include "scene/tools/tools.h"

static uint32_t *pin_of(const scene_object *s, const scene_thread_grasp *g)
{
    return &s->baseline->grasp_pins[g - s->thread_grasps];
}

/* Returns the grasp that leads a node, or NULL if there is none. */
static const scene_thread_grasp *leader_of(const scene_object *s, uint32_t thread, uint32_t node)
{
    for (uint32_t i = 0; i < s->config.grasp_capacity; i++) {
        const scene_thread_grasp *g = &s->thread_grasps[i];
        if (g->id != 0 && g->thread == thread && g->segment == node && *pin_of(s, g) != 0) {
            return g;
        }
    }
    return NULL;
}

/* Takes the lead of a node that no tool leads. The grasp keeps waiting if the host has pinned
 * the node or no pin is free. */
static void lead(scene_object *s, scene_thread_grasp *g)
{
    if (leader_of(s, g->thread, g->segment) == NULL &&
        vbss_scene_pin_node(s, g->thread, g->segment, g->tool, NULL, pin_of(s, g)) == VBSS_OK) {
        vbss_scene_emit_thread_grasp_event(s, VBSS_SCENE_EVENT_GRASP, g);
    }
}

/* Finds the node nearest to the point between the tips of the jaws, within grasper_distance.
 * Returns false if there is none. */
static bool nearest_node(const scene_object *s, const scene_body *tool, scene_thread_grasp *found)
{
    const grasper_object *g = tool->rigid.grasper;
    pose at = pose_mul(tool->rigid.body.now.pose, pose_inverse(tool->rigid.frame));
    double nearest = g->config.baseline->grasper_distance;
    found->thread = 0;
    for (uint32_t i = 0; i < s->body_count; i++) {
        const scene_body *b = &s->bodies[i];
        const thread_object *t = b->thread.thread;
        for (uint32_t k = 0; b->kind == SCENE_BODY_THREAD && k < t->node_count; k++) {
            double distance = vec3_distance(t->now.x[k], at.position);
            if (distance <= nearest) {
                nearest = distance;
                found->thread = b->number;
                found->segment = k;
            }
        }
    }
    return found->thread != 0;
}

static void take(scene_object *s, const scene_body *tool)
{
    scene_thread_grasp found = {.tool = tool->number};
    if (!nearest_node(s, tool, &found)) {
        return;
    }
    for (uint32_t i = 0; i < s->config.grasp_capacity; i++) {
        if (s->thread_grasps[i].id == 0) {
            found.id = ++s->last_grasp_id;
            s->thread_grasps[i] = found;
            s->baseline->grasp_pins[i] = 0;
            lead(s, &s->thread_grasps[i]);
            return;
        }
    }
    const thread_object *t = vbss_scene_body(s, found.thread)->thread.thread;
    vbss_scene_event event = {.kind = VBSS_SCENE_EVENT_GRASP_LOST,
                              .body_a = found.thread,
                              .body_b = tool->number,
                              .arc_length = vbss_thread_arc_length(t, found.segment)};
    vbss_scene_add_event_at(s, &event, t->now.x[found.segment], 0);
}

static void let_go(scene_object *s, scene_thread_grasp *g)
{
    uint32_t *pin = pin_of(s, g);
    if (*pin != 0) {
        vbss_scene_emit_thread_grasp_event(s, VBSS_SCENE_EVENT_RELEASE, g);
        (void)vbss_scene_unpin_node(s, *pin); /* the host may have removed the pin */
        *pin = 0;
    }
    *g = (scene_thread_grasp){0};
}

void vbss_baseline_set_carried_targets(scene_object *s)
{
    for (uint32_t i = 0; i < s->config.grasp_capacity; i++) {
        if (s->thread_grasps[i].id != 0 && s->baseline->grasp_pins[i] != 0) {
            vbss_scene_set_pin_targets(s);
            return;
        }
    }
}

/* Opened jaws release their nodes first, so that a waiting tool can take the lead in the same
 * step. */
void vbss_baseline_update_grasps(scene_object *s)
{
    vbss_scene_remove_clear_thread_grasps(s); /* strands that blades have left uncut */
    for (uint32_t i = 0; i < s->config.grasp_capacity; i++) {
        scene_thread_grasp *g = &s->thread_grasps[i];
        if (scene_holds_strand(g) && vbss_scene_body(s, g->tool)->rigid.grasper->jaw_angle > 0.0) {
            let_go(s, g);
        }
    }
    for (uint32_t i = 0; i < s->config.grasp_capacity; i++) {
        scene_thread_grasp *g = &s->thread_grasps[i];
        if (scene_holds_strand(g) && *pin_of(s, g) == 0) {
            lead(s, g);
        }
    }
    for (uint32_t i = 0; i < s->body_count; i++) {
        scene_body *b = &s->bodies[i];
        if (b->kind == SCENE_BODY_RIGID && b->rigid.grasper != NULL &&
            b->rigid.grasper->kind == VBSS_GRASPER_KIND_NEEDLE_DRIVER &&
            baseline_body_of(s, b)->has_closed_jaws) {
            baseline_body_of(s, b)->has_closed_jaws = false;
            take(s, b);
        }
    }
}

/* Returns the force k_s (length - rest length) toward the other end of a section, or zero if the
 * section is slack. */
static vec3 pull_of_section(const thread_object *t, uint32_t from, uint32_t to, double stiffness)
{
    uint32_t low = from < to ? from : to, high = from < to ? to : from;
    double length = 0.0, rest = 0.0;
    for (uint32_t i = low; i < high; i++) {
        length += vec3_distance(t->now.x[i], t->now.x[i + 1]);
        rest += t->rest[i];
    }
    double size = stiffness * vbss_max(length - rest, 0.0);
    vec3 direction = vec3_unit_or(vec3_sub(t->now.x[to], t->now.x[from]), vec3_zero());
    return vec3_scale(direction, size);
}

/* Returns the force of both sections that end at a node. */
static vec3 pull_of_node(const thread_object *t, uint32_t node, double stiffness)
{
    uint32_t before = 0, after = t->node_count - 1;
    for (uint32_t k = 0; k < t->node_count; k++) {
        before = t->prescribed_by[k] != 0 && k < node ? k : before;
        after = t->prescribed_by[t->node_count - 1 - k] != 0 && t->node_count - 1 - k > node
                    ? t->node_count - 1 - k
                    : after;
    }
    return vec3_add(pull_of_section(t, node, before, stiffness),
                    pull_of_section(t, node, after, stiffness));
}

/* Sums the forces of nodes that the tool carries, and of nodes pinned to its needle. */
vec3 vbss_baseline_hand_force(const scene_object *s, const scene_body *tool)
{
    double stiffness = tool->rigid.grasper->config.baseline->grasper_stiffness;
    uint32_t needle =
        vbss_scene_has_needle_grasp(s, tool->number) ? tool->rigid.needle_grasp.needle : 0;
    vec3 force = vec3_zero();
    for (uint32_t i = 0; i < s->config.grasp_capacity; i++) {
        const scene_thread_grasp *g = &s->thread_grasps[i];
        if (g->id != 0 && g->tool == tool->number && *pin_of(s, g) != 0) {
            const thread_object *t = vbss_scene_body(s, g->thread)->thread.thread;
            force = vec3_add(force, pull_of_node(t, g->segment, stiffness));
        }
    }
    for (uint32_t i = 0; needle != 0 && i < s->config.pin_capacity; i++) {
        const scene_pin *p = &s->pins[i];
        if (p->body == needle && vbss_scene_pin_holds(s, p)) {
            const thread_object *t = vbss_scene_body(s, p->thread)->thread.thread;
            force = vec3_add(force, pull_of_node(t, p->node, stiffness));
        }
    }
    return force;
}
