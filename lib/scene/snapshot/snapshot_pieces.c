/* Saves and restores the pieces that were cut off threads. */
#include "base/stream.h"
#include "scene/snapshot/snapshot.h"
#include "scene/topology/topology.h"
#include "scene/world/world.h"

void vbss_scene_serialise_piece(vbss_stream *stream, scene_object *s, scene_body *b)
{
    uint8_t is_active = b->kind == SCENE_BODY_THREAD;
    vbss_stream_u8(stream, 15, &is_active, 1);
    if (is_active > 1) {
        vbss_stream_refuse(stream, VBSS_ERROR_CORRUPT, "no such flag");
    } else if (stream->mode == VBSS_STREAM_READ && is_active != (b->kind == SCENE_BODY_THREAD)) {
        if (is_active != 0) {
            vbss_scene_activate_piece(s, b);
        } else {
            vbss_scene_deactivate_piece(s, b);
        }
    }
    if (b->kind == SCENE_BODY_THREAD) {
        uint32_t words[3] = {b->number, b->thread.cut_from, b->thread.has_split_segment};
        vbss_stream_u32(stream, 16, words, 3);
        b->thread.cut_from = words[1];
        b->thread.has_split_segment = words[2] != 0;
        if (words[0] == 0 || words[0] > s->last_body_number || words[1] > s->last_body_number ||
            words[2] > 1) {
            vbss_stream_refuse(stream, VBSS_ERROR_CORRUPT, "no such piece");
        } else if (stream->mode == VBSS_STREAM_READ) {
            vbss_scene_set_body_number(s, b, words[0]);
        }
    }
}

/* Whether all numbers are unique, each thread fits into its shape, and all threads fit into the
 * scene, even after all cuts that are left. */
static bool do_pieces_fit(const scene_object *s)
{
    uint32_t nodes = 0;
    for (uint32_t i = 0; i < s->body_count; i++) {
        const scene_body *b = &s->bodies[i];
        if (b->kind == SCENE_BODY_THREAD) {
            uint32_t count = b->thread.thread->node_count;
            if (count > s->collision->shapes[b->shape]->node_capacity ||
                count > s->node_capacity - nodes) {
                return false;
            }
            nodes += count;
        }
        if (vbss_scene_is_spare_piece(b) && SCENE_NODES_PER_CUT > s->node_capacity - nodes) {
            return false;
        }
        nodes += vbss_scene_is_spare_piece(b) ? SCENE_NODES_PER_CUT : 0;
        const scene_body *before =
            b->kind == SCENE_BODY_THREAD ? vbss_scene_body(s, b->thread.cut_from) : NULL;
        if (before != NULL && before->kind != SCENE_BODY_THREAD) {
            return false;
        }
        if (b->kind != SCENE_BODY_NONE && vbss_scene_body(s, b->number) != b) {
            return false;
        }
    }
    return true;
}

void vbss_scene_restore_pieces(vbss_stream *stream, scene_object *s)
{
    if (stream->mode != VBSS_STREAM_READ || stream->result != VBSS_OK) {
        return;
    }
    if (!do_pieces_fit(s)) {
        vbss_stream_refuse(stream, VBSS_ERROR_CORRUPT, "no such pieces");
        return;
    }
    for (uint32_t i = 0; i < s->body_count; i++) {
        const scene_body *b = &s->bodies[i];
        if (b->kind == SCENE_BODY_THREAD && scene_thread_resizes(b->thread.thread)) {
            const thread_object *t = b->thread.thread;
            vbss_collision_resize_chain(s->collision, b->shape, t->node_count, t->rest);
        }
    }
    vbss_scene_number_nodes(s);
}
