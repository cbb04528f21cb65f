/* Cuts: divides a thread into two. */
#include "thread/bending_memory.h"
#include "thread/tuning.h"
#include "thread/twist.h"

#include <string.h>

bool vbss_thread_locate_cut(const thread_object *t, double arc_length, thread_cut *cut)
{
    uint32_t segments = t->node_count - 1, i = 0;
    double remaining = arc_length;
    for (; i + 1 < segments && remaining > t->rest[i]; i++) {
        remaining -= t->rest[i];
    }
    double l = t->rest[i], min_length = THREAD_CUT_MIN_LENGTH_RATIO * t->config.radius;
    double snap =
        THREAD_CUT_SNAP_FRACTION * l > min_length ? THREAD_CUT_SNAP_FRACTION : min_length / l;
    double fraction = remaining / l;
    if (!(fraction >= snap)) {
        if (i == 0) {
            return false;
        }
        i--;
        fraction = 1.0;
    } else if (fraction > 1.0 - snap) {
        fraction = 1.0;
    }
    bool doubled = fraction == 1.0;
    *cut = (thread_cut){i, fraction, doubled ? i + 2 : i + 1, doubled ? i + 1 : i};
    return !(doubled && i + 1 == segments);
}

/* Copies nodes from `from` on to the piece, starting at its node `to`. */
static void copy_nodes(thread_object *piece, uint32_t to, const thread_object *t, uint32_t from)
{
    uint32_t count = t->node_count - from;
    size_t bytes = count * sizeof(vec3);
    memcpy(piece->now.x + to, t->now.x + from, bytes);
    memcpy(piece->now.v + to, t->now.v + from, bytes);
    memcpy(piece->now.a + to, t->now.a + from, bytes);
    memcpy(piece->now.q + to, t->now.q + from, bytes);
    memcpy(piece->now.tension + to, t->now.tension + from, (count - 1) * sizeof(double));
    if (thread_has_memory(t)) {
        memcpy(piece->now.bend + 2 * (size_t)to, t->now.bend + 2 * (size_t)from,
               2 * (size_t)count * sizeof *t->now.bend);
    }
    if (thread_has_friction_torque(t)) {
        memcpy(piece->now.half_twists + 2 * (size_t)to, t->now.half_twists + 2 * (size_t)from,
               2 * (size_t)(count - 1) * sizeof(double));
    }
    memcpy(piece->rest + to, t->rest + from, (count - 1) * sizeof(double));
    piece->node_count = to + count;
}

static void set_node(thread_object *t, uint32_t node, vec3 x, vec3 v)
{
    t->now.x[node] = x;
    t->now.v[node] = v;
    t->now.a[node] = t->now.q[node] = vec3_zero();
    if (thread_has_memory(t)) {
        t->now.bend[2 * (size_t)node] = t->now.bend[2 * (size_t)node + 1] = (thread_bend_memory){0};
    }
}

/* Friction torque: each half of the segment keeps its twist per length. */
static void split_twist(thread_object *t, thread_object *piece, const thread_cut *cut)
{
    double *halves = t->now.half_twists + 2 * (size_t)cut->segment;
    piece->now.half_twists[0] = piece->now.half_twists[1] = halves[1] * (1.0 - cut->fraction);
    halves[0] *= cut->fraction;
    halves[1] = halves[0];
}

static void split_nodes(thread_object *t, thread_object *piece, const thread_cut *cut)
{
    uint32_t end = cut->segment + 1;
    if (cut->fraction == 1.0) {
        copy_nodes(piece, 0, t, end);
    } else {
        vec3 x = vec3_lerp(t->now.x[cut->segment], t->now.x[end], cut->fraction);
        vec3 v = vec3_lerp(t->now.v[cut->segment], t->now.v[end], cut->fraction);
        copy_nodes(piece, 1, t, end);
        set_node(piece, 0, x, v);
        piece->rest[0] = t->rest[cut->segment] * (1.0 - cut->fraction);
        piece->now.tension[0] = t->now.tension[cut->segment];
        if (thread_has_friction_torque(t)) {
            split_twist(t, piece, cut);
        }
        set_node(t, end, x, v);
        t->rest[cut->segment] *= cut->fraction;
    }
    t->node_count = end + 1;
}

/* Attachments and welds move with their nodes. */
static void split_attachments(thread_object *t, thread_object *piece, const thread_cut *cut,
                              uint32_t nodes_before)
{
    for (uint32_t i = 0; i < t->config.attachment_capacity; i++) {
        thread_attachment *a = &t->attachments[i];
        piece->attachments[i] = (thread_attachment){0};
        if (a->id != 0 && a->node >= cut->first_piece_node) {
            piece->attachments[i] = *a;
            piece->attachments[i].node -= cut->node_shift;
            if (thread_has_twist(t)) {
                piece->now.frames[i] = t->now.frames[i];
            }
            if (thread_has_friction_torque(t)) {
                piece->now.held_rolls[i] = t->now.held_rolls[i];
            }
            *a = (thread_attachment){0};
        }
    }
    piece->last_id = t->last_id;
    memset(piece->welded, 0, piece->node_count * sizeof *piece->welded);
    for (uint32_t i = cut->first_piece_node; i < nodes_before; i++) {
        piece->welded[i - cut->node_shift] = t->welded[i];
    }
    memset(t->welded + cut->first_piece_node, 0,
           (t->node_capacity - cut->first_piece_node) * sizeof *t->welded);
}

void vbss_thread_apply_cut(thread_object *t, thread_object *piece, const thread_cut *cut)
{
    uint32_t nodes_before = t->node_count;
    split_nodes(t, piece, cut);
    split_attachments(t, piece, cut, nodes_before);
    piece->statistics = (vbss_thread_statistics){0};
    piece->statistics.time = t->statistics.time;
    vbss_baseline_statistics *own = piece->method->baseline_statistics(piece);
    if (own != NULL) {
        *own = (vbss_baseline_statistics){0};
    }
    piece->is_in_setup = t->is_in_setup;
    piece->damped_steps_left = t->damped_steps_left;
    piece->previous_h = 0.0;
    piece->now.dissipated_energy = 0.0;
    piece->next_segment_to_check = 0;
    vbss_thread_invalidate(t);
    vbss_thread_invalidate(piece);
}

/* ---- piece pool */

thread_object *vbss_thread_acquire_piece(thread_object *t, vbss_slot **slot)
{
    thread_piece_pool *pool = t->piece_pool;
    if (pool->available == 0) {
        return NULL;
    }
    pool->available--;
    thread_object *piece = pool->pieces[pool->available];
    *slot = pool->slots[pool->available];
    piece->piece_pool = pool;
    pool->reference_count++;
    return piece;
}

void vbss_thread_return_piece(thread_object *piece, vbss_slot *slot)
{
    thread_piece_pool *pool = piece->piece_pool;
    piece->piece_pool = NULL;
    pool->pieces[pool->available] = piece;
    pool->slots[pool->available] = slot;
    pool->available++;
    vbss_thread_release_piece_pool(piece->context, pool);
}
