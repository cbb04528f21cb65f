/* The table of bodies: look-up by number, free entries, and node numbers over all threads. */
#include "base/error.h"
#include "scene/world/method.h"
#include "scene/world/world.h"

scene_body *vbss_scene_body(const scene_object *s, uint32_t number)
{
    if (number == 0 || number > SCENE_MAX_SHAPES) {
        return NULL;
    }
    /* A number whose body is gone keeps its entry, which then points to another body or to none. */
    scene_body *b = &s->bodies[s->body_of_number[number - 1]];
    return b->kind != SCENE_BODY_NONE && b->number == number ? b : NULL;
}

void vbss_scene_set_body_number(scene_object *s, scene_body *b, uint32_t number)
{
    b->number = number;
    s->body_of_number[number - 1] = (uint32_t)(b - s->bodies);
}

vbss_slot *vbss_scene_slot_of_body(const scene_body *b)
{
    switch (b->kind) {
    case SCENE_BODY_THREAD:
        return b->thread.slot;
    case SCENE_BODY_DRAIN:
        return b->drain.slot;
    case SCENE_BODY_RIGID:
        return b->rigid.slot;
    default:
        return NULL;
    }
}

bool vbss_scene_has_body_kind(const scene_object *s, scene_body_kind kind)
{
    bool any = false;
    for (uint32_t i = 0; i < s->body_count; i++) {
        any = any || s->bodies[i].kind == kind;
    }
    return any;
}

vbss_result vbss_scene_require_any_body(const scene_object *s, uint32_t number, scene_body **body)
{
    *body = vbss_scene_body(s, number);
    return *body != NULL
               ? VBSS_OK
               : vbss_fail(s->context, VBSS_ERROR_NOT_FOUND, "the scene has no body %u", number);
}

vbss_result vbss_scene_require_body(const scene_object *s, uint32_t number, scene_body_kind kind,
                                    scene_body **body)
{
    static const char *const names[] = {[SCENE_BODY_THREAD] = "thread",
                                        [SCENE_BODY_RIGID] = "rigid body",
                                        [SCENE_BODY_DRAIN] = "drain"};
    VBSS_TRY(vbss_scene_require_any_body(s, number, body));
    return (*body)->kind == kind ? VBSS_OK
                                 : vbss_fail(s->context, VBSS_ERROR_INCOMPATIBLE,
                                             "body %u is no %s", number, names[kind]);
}

vbss_result vbss_scene_find_free_body(scene_object *s, scene_body_kind kind, scene_body **body)
{
    const uint32_t capacities[] = {[SCENE_BODY_THREAD] = s->config.thread_capacity,
                                   [SCENE_BODY_RIGID] = s->config.rigid_capacity,
                                   [SCENE_BODY_DRAIN] = s->config.drain_capacity};
    const uint32_t capacity = capacities[kind];
    uint32_t alive = 0, body_index = s->body_count;
    for (uint32_t i = s->body_count; i > 0; i--) {
        const scene_body *b = &s->bodies[i - 1];
        alive += b->kind == kind ||
                 (b->is_reserved && b->kind == SCENE_BODY_NONE && kind == SCENE_BODY_THREAD);
        body_index = b->kind == SCENE_BODY_NONE && !b->is_reserved ? i - 1 : body_index;
    }
    if (alive == capacity || s->last_body_number == SCENE_MAX_SHAPES) {
        *body = NULL;
        return vbss_fail(s->context, VBSS_ERROR_CAPACITY, "the scene has room for %u such bodies",
                         capacity);
    }
    *body = &s->bodies[body_index];
    return VBSS_OK;
}

void vbss_scene_register_body(scene_object *s, scene_body *b, scene_body_kind kind, uint32_t shape,
                              uint32_t *number)
{
    uint32_t body_index = (uint32_t)(b - s->bodies);
    b->kind = kind;
    b->shape = shape;
    b->filter = vbss_scene_default_filter();
    b->user_data = NULL;
    b->next_halvings = b->group = 0;
    b->is_frozen = false;
    *number = ++s->last_body_number;
    vbss_scene_set_body_number(s, b, *number);
    s->body_of_shape[shape] = body_index;
    s->body_count = body_index == s->body_count ? body_index + 1 : s->body_count;
    s->method->add_body(s, b);
    s->step.pattern_hash = 0;
    s->report.generation++;
}

void vbss_scene_number_nodes(scene_object *s)
{
    s->node_count = 0;
    for (uint32_t i = 0; i < s->body_count; i++) {
        if (s->bodies[i].kind == SCENE_BODY_THREAD) {
            s->bodies[i].thread.first_node = s->node_count;
            s->node_count += s->bodies[i].thread.thread->node_count;
        }
    }
}
