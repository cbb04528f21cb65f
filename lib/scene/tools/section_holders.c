/* Rigid bodies and jaws that hold the section of a thread with twist.
 *
 * A pin on a rigid body and a grasp own a ROLL attachment of the thread. At the start of each step its target
 * is the spin of its body about the thread, extrapolated to the end of the step, and the torque there loads
 * the body. A torque from the start of the step would gain energy; this one loses some. */
#include "base/rotation.h"
#include "scene/tools/tools.h"
#include "scene/world/world.h"
#include "thread/twist.h"

/* A place where a body holds the section of a thread. */
typedef struct section_hold {
    uint32_t thread, node, body, owner; /* owner: thread_attachment::owner */
} section_hold;

static uint32_t grasped_node(const scene_object *s, const scene_thread_grasp *g)
{
    const thread_object *t = vbss_scene_body(s, g->thread)->thread.thread;
    return g->segment + (g->segment_offset > 0.5 * t->rest[g->segment] ? 1 : 0);
}

/* The hold of a pin or, beyond the pins, of a grasp. False: it holds no section. */
static bool find_hold(const scene_object *s, uint32_t index, section_hold *hold)
{
    if (index < s->config.pin_capacity) {
        const scene_pin *p = &s->pins[index];
        *hold = (section_hold){p->thread, p->node, p->body, 2 * p->id};
        return p->id != 0 && p->body != 0 && vbss_scene_pin_holds(s, p);
    }
    const scene_thread_grasp *g = &s->thread_grasps[index - s->config.pin_capacity];
    if (!scene_holds_strand(g)) {
        return false;
    }
    *hold = (section_hold){g->thread, grasped_node(s, g), g->tool, 2 * g->id + 1};
    return true;
}

static uint32_t hold_count(const scene_object *s)
{
    return s->config.pin_capacity + s->config.grasp_capacity;
}

/* Whether some pin or grasp on the thread is the owner. */
static bool is_owner(const scene_object *s, uint32_t thread, uint32_t owner)
{
    section_hold hold;
    for (uint32_t i = 0; i < hold_count(s); i++) {
        if (find_hold(s, i, &hold) && hold.thread == thread && hold.owner == owner) {
            return true;
        }
    }
    return false;
}

static void release_sections(const scene_object *s, const scene_body *b)
{
    thread_object *t = b->thread.thread;
    for (uint32_t i = 0; i < t->config.attachment_capacity; i++) {
        const thread_attachment *a = &t->attachments[i];
        if (a->id != 0 && a->owner != 0 && !is_owner(s, b->number, a->owner)) {
            vbss_thread_release_section(t, i);
        }
    }
}

static vec3 tangent_at(const thread_object *t, uint32_t node)
{
    const uint32_t low = node > 0 ? node - 1 : node,
                   high = node + 1 < t->node_count ? node + 1 : node;
    return vec3_unit_or(vec3_sub(t->now.x[high], t->now.x[low]), vec3_zero());
}

/* Orientation of a body at the end of a step of `h` seconds, foreseen. */
static quat foresee_orientation(const scene_rigid *r, double h)
{
    return r->kind == VBSS_SCENE_RIGID_DRIVEN
               ? r->body.target_end.orientation
               : vbss_quat_integrate(r->body.now.pose.orientation, r->body.now.w, h);
}

static void hold_section(scene_object *s, const section_hold *hold, double h)
{
    thread_object *t = vbss_scene_body(s, hold->thread)->thread.thread;
    scene_rigid *r = &vbss_scene_body(s, hold->body)->rigid;
    bool is_new;
    thread_attachment *a =
        thread_has_twist(t) ? vbss_thread_hold_section(t, hold->owner, hold->node, &is_new) : NULL;
    if (a == NULL) {
        return;
    }
    if (is_new) {
        a->owner_orientation = r->body.now.pose.orientation;
    }
    const quat orientation = foresee_orientation(r, h);
    const quat turned = quat_mul(orientation, quat_conjugate(a->owner_orientation));
    const vec3 tangent = tangent_at(t, hold->node);
    const double spin = vec3_dot(vbss_quat_to_rotation_vector(turned), tangent);
    const double stiffness = vbss_thread_section_stiffness(t, a);
    const vec3 torque = vec3_add_scaled(a->reaction_torque, stiffness * spin, tangent);
    r->body.load.torque = vec3_sub(r->body.load.torque, torque);
    a->target_roll += spin;
    a->owner_orientation = orientation;
}

void vbss_scene_hold_sections(scene_object *s, double h)
{
    for (uint32_t i = 0; i < s->body_count; i++) {
        const scene_body *b = &s->bodies[i];
        if (b->kind == SCENE_BODY_THREAD && thread_has_twist(b->thread.thread)) {
            release_sections(s, b);
        }
    }
    section_hold hold;
    for (uint32_t i = 0; i < hold_count(s); i++) {
        if (find_hold(s, i, &hold)) {
            hold_section(s, &hold, h);
        }
    }
}

void vbss_scene_add_section_torques(scene_object *s)
{
    section_hold hold;
    for (uint32_t i = 0; i < hold_count(s); i++) {
        if (!find_hold(s, i, &hold)) {
            continue;
        }
        const scene_body *b = vbss_scene_body(s, hold.thread);
        const thread_attachment *a =
            thread_has_twist(b->thread.thread) && scene_is_active(b)
                ? vbss_thread_find_section_owner(b->thread.thread, hold.owner)
                : NULL;
        if (a != NULL) {
            scene_rigid *r = &vbss_scene_body(s, hold.body)->rigid;
            r->torque = vec3_sub(r->torque, a->reaction_torque);
        }
    }
}
