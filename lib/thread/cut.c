/* Cutting a thread in two. */
#include "thread/thread.h"

#include <string.h>

/* A cut so close to a node, as a share of the segment or in m, goes through the node: slivers would
 * need tiny steps. */
#define SNAP 0.01
#define SHORTEST 1e-7

typedef struct place {
    uint32_t segment; /* that is divided, or before the node that is doubled */
    double share;     /* of the segment that stays; 1: its end node is doubled */
} place;

/* False: at an end. */
static bool find_place(const thread_object *t, double arc_length, place *p)
{
    uint32_t segments = t->node_count - 1;
    double left = arc_length;
    for (p->segment = 0; p->segment + 1 < segments && left > t->rest[p->segment]; p->segment++) {
        left -= t->rest[p->segment];
    }
    double l = t->rest[p->segment], snap = SNAP * l > SHORTEST ? SNAP : SHORTEST / l;
    p->share = left / l;
    if (p->share < snap) {
        if (p->segment == 0) {
            return false;
        }
        p->segment--;
        p->share = 1.0;
    } else if (p->share > 1.0 - snap) {
        p->share = 1.0;
    }
    return !(p->share == 1.0 && p->segment + 1 == segments);
}

/* Copies nodes from .. last of a thread to the front of its piece. */
static void copy_nodes(thread_object *piece, uint32_t to, const thread_object *t, uint32_t from)
{
    uint32_t count = t->node_count - from;
    size_t bytes = count * sizeof(vec3);
    memcpy(piece->now.x + to, t->now.x + from, bytes);
    memcpy(piece->now.v + to, t->now.v + from, bytes);
    memcpy(piece->now.a + to, t->now.a + from, bytes);
    memcpy(piece->now.q + to, t->now.q + from, bytes);
    memcpy(piece->now.tension + to, t->now.tension + from, (count - 1) * sizeof(double));
    memcpy(piece->rest + to, t->rest + from, (count - 1) * sizeof(double));
    piece->node_count = to + count;
}

static void set_node(thread_object *t, uint32_t node, vec3 x, vec3 v)
{
    t->now.x[node] = x;
    t->now.v[node] = v;
    t->now.a[node] = t->now.q[node] = vec3_zero();
}

static void divide(thread_object *t, thread_object *piece, place p)
{
    uint32_t end = p.segment + 1;
    if (p.share == 1.0) {
        copy_nodes(piece, 0, t, end);
    } else {
        vec3 x = vec3_lerp(t->now.x[p.segment], t->now.x[end], p.share);
        vec3 v = vec3_lerp(t->now.v[p.segment], t->now.v[end], p.share);
        copy_nodes(piece, 1, t, end);
        set_node(piece, 0, x, v);
        piece->rest[0] = t->rest[p.segment] * (1.0 - p.share);
        piece->now.tension[0] = t->now.tension[p.segment];
        set_node(t, end, x, v);
        t->rest[p.segment] *= p.share;
    }
    t->node_count = end + 1;
}

/* Attachments go with their nodes; old_end is the first node that went away, the new first node of
 * the piece is `shift` below its old number. */
static void divide_attachments(thread_object *t, thread_object *piece, uint32_t old_end,
                               uint32_t shift)
{
    for (uint32_t i = 0; i < t->config.attachment_capacity; i++) {
        thread_attachment *a = &t->attachments[i];
        piece->attachments[i] = (thread_attachment){0};
        if (a->id != 0 && a->node >= old_end) {
            piece->attachments[i] = *a;
            piece->attachments[i].node -= shift;
            *a = (thread_attachment){0};
        }
    }
    piece->last_id = t->last_id;
}

vbss_result vbss_thread_cut(vbss_thread *thread, double arc_length, vbss_thread **piece)
{
    thread_object *t;
    if (piece == NULL) {
        VBSS_TRY(vbss_thread_edit_alone(thread, &t));
        return vbss_check_pointer(t->context, piece, "piece");
    }
    *piece = NULL;
    VBSS_TRY(vbss_thread_edit_alone(thread, &t));
    double length = 0.0;
    for (uint32_t i = 0; i + 1 < t->node_count; i++) {
        length += t->rest[i];
    }
    VBSS_TRY(vbss_check_range(t->context, arc_length, 0.0, length, "arc_length"));
    place p;
    if (!find_place(t, arc_length, &p)) {
        return vbss_fail(t->context, VBSS_ERROR_OUT_OF_RANGE, "a cut at %g m is at an end",
                         arc_length);
    }
    thread_reserve *r = t->reserve;
    if (r->left == 0) {
        return vbss_fail(t->context, VBSS_ERROR_CAPACITY, "all %u cuts are made", r->capacity);
    }
    thread_object *new_piece = r->spares[--r->left];
    vbss_slot *slot = r->slots[r->left];
    new_piece->reserve = r;
    r->users++;
    bool doubled = p.share == 1.0;
    uint32_t end = p.segment + 1;
    divide(t, new_piece, p);
    divide_attachments(t, new_piece, doubled ? end + 1 : end, doubled ? end : end - 1);
    new_piece->statistics = (vbss_thread_statistics){0};
    new_piece->statistics.time = t->statistics.time;
    new_piece->placed = t->placed;
    new_piece->settling = t->settling;
    vbss_thread_changed(t);
    vbss_thread_changed(new_piece);
    vbss_slot_fill(slot, new_piece);
    *piece = (vbss_thread *)slot;
    return VBSS_OK;
}
