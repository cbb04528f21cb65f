/* Nodes of threads that are fixed to bodies.
 *
 * A pin on the world or on a driven body is an attachment of the thread, whose target moves with
 * the body. A pin on any other body is a weld: lib/contact eliminates the node's motion in
 * favour of the body's. */
#include "base/check.h"
#include "base/error.h"
#include "scene/world/method.h"
#include "scene/world/world.h"

static vbss_result check_node(const scene_object *s, const scene_body *thread, uint32_t node)
{
    const thread_object *t = thread->thread.thread;
    VBSS_TRY(vbss_check_range(s->context, node, 0.0, t->node_count - 1.0, "node"));
    for (uint32_t i = 0; i < t->config.attachment_capacity; i++) {
        const thread_attachment *a = &t->attachments[i];
        if (a->id != 0 && a->node == node && vbss_thread_prescribes_motion(a->kind)) {
            return vbss_fail(s->context, VBSS_ERROR_IN_USE, "node %u is held already", node);
        }
    }
    if (vbss_scene_find_weld(s, thread->number, node) != NULL) {
        return vbss_fail(s->context, VBSS_ERROR_IN_USE, "node %u is pinned already", node);
    }
    return VBSS_OK;
}

static vbss_result find_free_pin(const scene_object *s, scene_pin **pin)
{
    for (uint32_t i = 0; i < s->config.pin_capacity; i++) {
        if (s->pins[i].id == 0) {
            *pin = &s->pins[i];
            return VBSS_OK;
        }
    }
    *pin = NULL;
    (void)vbss_fail(s->context, VBSS_ERROR_CAPACITY, "more than %u pins", s->config.pin_capacity);
    return VBSS_ERROR_CAPACITY;
}

/* Returns NULL if the host has detached the attachment. */
static thread_attachment *find_attachment(const scene_body *thread, uint32_t id)
{
    thread_object *t = thread->thread.thread;
    for (uint32_t i = 0; i < t->config.attachment_capacity; i++) {
        if (t->attachments[i].id == id) {
            return &t->attachments[i];
        }
    }
    return NULL;
}

bool vbss_scene_pin_holds(const scene_object *s, const scene_pin *pin)
{
    if (pin->id == 0 || pin->attachment == 0) {
        return pin->id != 0;
    }
    const scene_body *thread = vbss_scene_body(s, pin->thread);
    return thread != NULL && find_attachment(thread, pin->attachment) != NULL;
}

/* Position of the pinned point at the end of the next step. `b` is NULL for the world. */
static vec3 pin_target(const scene_body *b, vec3 point)
{
    return b == NULL ? point : pose_apply(b->rigid.body.target_end, point);
}

static vbss_result attach(const scene_body *thread, uint32_t node, vec3 position, uint32_t *id)
{
    vbss_thread_attachment a;
    VBSS_TRY(vbss_thread_attachment_init(&a, sizeof a));
    a.kind = VBSS_THREAD_ATTACHMENT_PIN;
    a.node = node;
    vec3_store(a.position, position);
    return vbss_thread_attach((vbss_thread *)thread->thread.slot, &a, id);
}

vbss_result vbss_scene_check_pin(const scene_object *s, uint32_t thread, uint32_t node,
                                 uint32_t body, const double *point)
{
    scene_body *t, *rigid;
    VBSS_TRY(vbss_scene_require_body(s, thread, SCENE_BODY_THREAD, &t));
    if (body != 0) {
        VBSS_TRY(vbss_scene_require_body(s, body, SCENE_BODY_RIGID, &rigid));
        if (scene_is_mesh(rigid) || rigid->rigid.is_plane) {
            return vbss_fail(s->context, VBSS_ERROR_INCOMPATIBLE,
                             "body %u is a %s: pin the node to the world", body,
                             rigid->rigid.is_plane         ? "plane"
                             : rigid->rigid.is_static_mesh ? "static mesh"
                             : rigid->rigid.is_rigid_mesh  ? "rigid mesh"
                                                           : "host surface");
        }
    }
    VBSS_TRY(check_node(s, t, node));
    if (point != NULL) {
        VBSS_TRY(vbss_check_finite(s->context, point, 3, "point"));
        VBSS_TRY(vbss_check_range(s->context, vbss_max_abs(point, 3), 0.0, 1e3, "point"));
    }
    scene_pin *entry;
    return find_free_pin(s, &entry);
}

vbss_result vbss_scene_pin_node(scene_object *s, uint32_t thread, uint32_t node, uint32_t body,
                                const double *point, uint32_t *pin)
{
    VBSS_TRY(vbss_scene_check_pin(s, thread, node, body, point));
    scene_body *t = vbss_scene_body(s, thread);
    scene_body *b = vbss_scene_body(s, body);
    scene_pin *p;
    VBSS_TRY(find_free_pin(s, &p));
    vec3 current = t->thread.thread->now.x[node];
    vec3 at = point != NULL ? vec3_load(point) : current;
    if (b != NULL) {
        at = point != NULL ? pose_apply_inverse(b->rigid.frame, at)
                           : pose_apply_inverse(b->rigid.body.now.pose, current);
    }
    uint32_t attachment = 0;
    if (b == NULL || b->rigid.kind == VBSS_SCENE_RIGID_DRIVEN || !s->method->welds_pins) {
        VBSS_TRY(attach(t, node, pin_target(b, at), &attachment));
    }
    t->thread.thread->welded[node] = attachment == 0;
    const scene_pin own = {.id = ++s->last_pin_id,
                           .thread = thread,
                           .node = node,
                           .body = body,
                           .attachment = attachment,
                           .point = at};
    *p = own;
    *pin = own.id;
    s->report.generation++;
    return VBSS_OK;
}

static void remove_pin(scene_object *s, scene_pin *p)
{
    scene_body *t = vbss_scene_body(s, p->thread);
    if (p->attachment == 0 && t != NULL) {
        t->thread.thread->welded[p->node] = 0;
    }
    if (p->attachment != 0 && t != NULL && find_attachment(t, p->attachment) != NULL) {
        (void)vbss_thread_detach((vbss_thread *)t->thread.slot, p->attachment);
    }
    *p = (scene_pin){0};
}

bool vbss_scene_has_pin(const scene_object *s, uint32_t pin)
{
    for (uint32_t i = 0; pin != 0 && i < s->config.pin_capacity; i++) {
        if (s->pins[i].id == pin) {
            return true;
        }
    }
    return false;
}

bool vbss_scene_unpin_node(scene_object *s, uint32_t pin)
{
    for (uint32_t i = 0; pin != 0 && i < s->config.pin_capacity; i++) {
        if (s->pins[i].id == pin) {
            remove_pin(s, &s->pins[i]);
            s->report.generation++;
            return true;
        }
    }
    return false;
}

void vbss_scene_remove_pins_of(scene_object *s, uint32_t number)
{
    for (uint32_t i = 0; i < s->config.pin_capacity; i++) {
        scene_pin *p = &s->pins[i];
        if (p->id != 0 && (p->thread == number || p->body == number)) {
            remove_pin(s, p);
        }
    }
}

const scene_pin *vbss_scene_find_weld(const scene_object *s, uint32_t thread, uint32_t node)
{
    for (uint32_t i = 0; i < s->config.pin_capacity; i++) {
        const scene_pin *p = &s->pins[i];
        if (p->id != 0 && p->attachment == 0 && p->thread == thread && p->node == node) {
            return p;
        }
    }
    return NULL;
}

/* The attachment of the thread that a pin moves, or NULL. */
static thread_attachment *attachment_of(const scene_object *s, const scene_pin *p)
{
    return p->id != 0 && p->attachment != 0
               ? find_attachment(vbss_scene_body(s, p->thread), p->attachment)
               : NULL;
}

void vbss_scene_set_pin_targets(scene_object *s)
{
    for (uint32_t i = 0; i < s->config.pin_capacity; i++) {
        thread_attachment *a = attachment_of(s, &s->pins[i]);
        if (a != NULL) {
            a->target = pin_target(vbss_scene_body(s, s->pins[i].body), s->pins[i].point);
        }
    }
}

void vbss_scene_checkpoint_pin_targets(scene_object *s)
{
    for (uint32_t i = 0; i < s->config.pin_capacity; i++) {
        const thread_attachment *a = attachment_of(s, &s->pins[i]);
        if (a != NULL) {
            s->pins[i].checkpoint_target = a->target;
        }
    }
}

void vbss_scene_rollback_pin_targets(scene_object *s)
{
    for (uint32_t i = 0; i < s->config.pin_capacity; i++) {
        thread_attachment *a = attachment_of(s, &s->pins[i]);
        if (a != NULL) {
            a->target = s->pins[i].checkpoint_target;
        }
    }
}
