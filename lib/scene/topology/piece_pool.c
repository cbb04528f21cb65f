/* The pool of pieces that may yet be cut from threads.
 *
 * When a thread is added, each of its possible pieces gets a body entry, a shape and a spare
 * thread, so that a cut never allocates and never fails for lack of room. An entry keeps its
 * shape and thread. A restore of a snapshot from before a cut deactivates the piece; one from
 * after it activates the piece. */
#include "base/error.h"
#include "scene/topology/topology.h"
#include "scene/world/world.h"

bool vbss_scene_is_spare_piece(const scene_body *b)
{
    return b->is_reserved && b->kind == SCENE_BODY_NONE;
}

/* ---- reserved with a thread */

vbss_result vbss_scene_check_thread_capacity(const scene_object *s, const thread_object *t)
{
    uint32_t pieces = t->piece_pool->available, spares = 0, threads = 0;
    for (uint32_t i = 0; i < s->body_count; i++) {
        spares += vbss_scene_is_spare_piece(&s->bodies[i]);
        threads += s->bodies[i].kind == SCENE_BODY_THREAD;
    }
    if (pieces > 0 && threads + spares + 1 + pieces > s->config.thread_capacity) {
        return vbss_fail(s->context, VBSS_ERROR_CAPACITY,
                         "the scene has room for %u threads, and of this one %u pieces may be cut",
                         s->config.thread_capacity, pieces);
    }
    uint32_t used = s->node_count + SCENE_NODES_PER_CUT * spares;
    uint32_t nodes = t->config.mesh == VBSS_THREAD_MESH_ADAPTIVE ? t->node_capacity : t->node_count;
    if (used > s->node_capacity || nodes + SCENE_NODES_PER_CUT * pieces > s->node_capacity - used) {
        return vbss_fail(s->context, VBSS_ERROR_CAPACITY,
                         "the scene has room for %u nodes, %u of them for each cut",
                         s->node_capacity, (uint32_t)SCENE_NODES_PER_CUT);
    }
    return VBSS_OK;
}

vbss_result vbss_scene_create_piece_shapes(scene_object *s, const thread_object *t, uint32_t shape)
{
    uint32_t last = shape;
    vbss_result result = VBSS_OK;
    for (uint32_t i = 0; result == VBSS_OK && i < t->piece_pool->available; i++) {
        /* as large as any thread of the family, because any of them may need it */
        result = vbss_collision_add_disabled_chain(s->collision, t->node_capacity, t->config.radius,
                                                   &last);
    }
    for (uint32_t id = shape; result != VBSS_OK && id <= last; id++) {
        (void)vbss_collision_remove(scene_collision(s), id);
    }
    return result;
}

static scene_body *claim_body(scene_object *s)
{
    uint32_t body_index = 0;
    while (body_index < s->body_count &&
           (s->bodies[body_index].kind != SCENE_BODY_NONE || s->bodies[body_index].is_reserved)) {
        body_index++;
    }
    s->body_count = body_index == s->body_count ? body_index + 1 : s->body_count;
    return &s->bodies[body_index];
}

void vbss_scene_add_spares(scene_object *s, thread_object *t, uint32_t first_shape)
{
    vbss_slot *slot = NULL;
    for (thread_object *spare = vbss_thread_acquire_piece(t, &slot); spare != NULL;
         spare = vbss_thread_acquire_piece(t, &slot)) {
        scene_body *b = claim_body(s);
        *b = (scene_body){.is_reserved = true, .shape = first_shape++};
        b->thread.thread = spare;
        b->thread.slot = slot;
        s->body_of_shape[b->shape] = (uint32_t)(b - s->bodies);
    }
}

void vbss_scene_return_spare(scene_body *b)
{
    vbss_thread_return_piece(b->thread.thread, b->thread.slot);
    *b = (scene_body){.kind = SCENE_BODY_NONE};
}

void vbss_scene_return_spares(scene_object *s, const thread_piece_pool *family)
{
    for (uint32_t i = 0; i < s->body_count; i++) {
        if (s->bodies[i].kind == SCENE_BODY_THREAD &&
            s->bodies[i].thread.thread->piece_pool == family) {
            return;
        }
    }
    for (uint32_t i = 0; i < s->body_count; i++) {
        scene_body *b = &s->bodies[i];
        if (vbss_scene_is_spare_piece(b) && b->thread.thread->piece_pool == family) {
            (void)vbss_collision_remove(scene_collision(s), b->shape);
            vbss_scene_return_spare(b);
        }
    }
}

/* ---- pieces become bodies and spares again */

scene_body *vbss_scene_find_spare(const scene_object *s, const scene_body *thread)
{
    for (uint32_t i = 0; i < s->body_count; i++) {
        scene_body *b = &s->bodies[i];
        if (vbss_scene_is_spare_piece(b) &&
            b->thread.thread->piece_pool == thread->thread.thread->piece_pool) {
            return b;
        }
    }
    return NULL;
}

void vbss_scene_activate_piece(scene_object *s, scene_body *piece)
{
    piece->kind = SCENE_BODY_THREAD;
    vbss_slot_fill(piece->thread.slot, piece->thread.thread);
    vbss_slot_set_owner(piece->thread.slot, s, &s->hook);
}

void vbss_scene_deactivate_piece(scene_object *s, scene_body *piece)
{
    const scene_thread pooled = {.slot = piece->thread.slot, .thread = piece->thread.thread};
    vbss_slot_empty(pooled.slot);
    vbss_collision_disable_chain(s->collision, piece->shape);
    *piece = (scene_body){.is_reserved = true, .shape = piece->shape, .thread = pooled};
}
