/* Cutting a thread in two. */
#include "base/check.h"
#include "base/error.h"
#include "thread/thread.h"

#include <string.h>

/* A cut so close to a node, as a share of the segment or in m, goes through the node: slivers would
 * need tiny steps. */
#define SNAP 0.01
#define SHORTEST 1e-7

bool vbss_thread_find_cut(const thread_object *t, double arc_length, thread_cut *cut)
{
    uint32_t segments = t->node_count - 1, i = 0;
    double left = arc_length;
    for (; i + 1 < segments && left > t->rest[i]; i++) {
        left -= t->rest[i];
    }
    double l = t->rest[i], snap = SNAP * l > SHORTEST ? SNAP : SHORTEST / l;
    double share = left / l;
    if (!(share >= snap)) {
        if (i == 0) {
            return false;
        }
        i--;
        share = 1.0;
    } else if (share > 1.0 - snap) {
        share = 1.0;
    }
    bool doubled = share == 1.0;
    *cut = (thread_cut){i, share, doubled ? i + 2 : i + 1, doubled ? i + 1 : i};
    return !(doubled && i + 1 == segments);
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

static void divide_nodes(thread_object *t, thread_object *piece, const thread_cut *cut)
{
    uint32_t end = cut->segment + 1;
    if (cut->share == 1.0) {
        copy_nodes(piece, 0, t, end);
    } else {
        vec3 x = vec3_lerp(t->now.x[cut->segment], t->now.x[end], cut->share);
        vec3 v = vec3_lerp(t->now.v[cut->segment], t->now.v[end], cut->share);
        copy_nodes(piece, 1, t, end);
        set_node(piece, 0, x, v);
        piece->rest[0] = t->rest[cut->segment] * (1.0 - cut->share);
        piece->now.tension[0] = t->now.tension[cut->segment];
        set_node(t, end, x, v);
        t->rest[cut->segment] *= cut->share;
    }
    t->node_count = end + 1;
}

/* What holds a node goes with it. */
static void divide_holders(thread_object *t, thread_object *piece, const thread_cut *cut,
                           uint32_t nodes_before)
{
    for (uint32_t i = 0; i < t->config.attachment_capacity; i++) {
        thread_attachment *a = &t->attachments[i];
        piece->attachments[i] = (thread_attachment){0};
        if (a->id != 0 && a->node >= cut->first_node) {
            piece->attachments[i] = *a;
            piece->attachments[i].node -= cut->shift;
            *a = (thread_attachment){0};
        }
    }
    piece->last_id = t->last_id;
    memset(piece->welded, 0, piece->node_count * sizeof *piece->welded);
    for (uint32_t i = cut->first_node; i < nodes_before; i++) {
        piece->welded[i - cut->shift] = t->welded[i];
    }
    memset(t->welded + cut->first_node, 0,
           (t->node_capacity - cut->first_node) * sizeof *t->welded);
}

void vbss_thread_divide(thread_object *t, thread_object *piece, const thread_cut *cut)
{
    uint32_t nodes_before = t->node_count;
    divide_nodes(t, piece, cut);
    divide_holders(t, piece, cut, nodes_before);
    piece->statistics = (vbss_thread_statistics){0};
    piece->statistics.time = t->statistics.time;
    piece->placed = t->placed;
    piece->settling = t->settling;
    piece->last_part = 0.0;
    piece->next_look = 0;
    vbss_thread_changed(t);
    vbss_thread_changed(piece);
}

/* ---- spares */

thread_object *vbss_thread_take_spare(thread_object *t, vbss_slot **slot)
{
    thread_reserve *r = t->reserve;
    if (r->left == 0) {
        return NULL;
    }
    r->left--;
    thread_object *spare = r->spares[r->left];
    *slot = r->slots[r->left];
    spare->reserve = r;
    r->users++;
    return spare;
}

void vbss_thread_give_spare_back(thread_object *spare, vbss_slot *slot)
{
    thread_reserve *r = spare->reserve;
    spare->reserve = NULL;
    r->spares[r->left] = spare;
    r->slots[r->left] = slot;
    r->left++;
    vbss_thread_leave_reserve(spare->context, r);
}

/* ---- a thread alone */

vbss_result vbss_thread_cut(vbss_thread *thread, double arc_length, vbss_thread **piece)
{
    thread_object *t;
    if (piece == NULL) {
        VBSS_TRY(vbss_thread_edit_alone(thread, &t));
        return vbss_check_pointer(t->context, piece, "piece");
    }
    *piece = NULL;
    VBSS_TRY(vbss_thread_edit_alone(thread, &t));
    double length = vbss_thread_arc_length(t, t->node_count - 1);
    VBSS_TRY(vbss_check_range(t->context, arc_length, 0.0, length, "arc_length"));
    thread_cut cut;
    if (!vbss_thread_find_cut(t, arc_length, &cut)) {
        return vbss_fail(t->context, VBSS_ERROR_OUT_OF_RANGE, "a cut at %g m is at an end",
                         arc_length);
    }
    vbss_slot *slot;
    thread_object *new_piece = vbss_thread_take_spare(t, &slot);
    if (new_piece == NULL) {
        return vbss_fail(t->context, VBSS_ERROR_CAPACITY, "all %u cuts are made",
                         t->reserve->capacity);
    }
    vbss_thread_divide(t, new_piece, &cut);
    vbss_slot_fill(slot, new_piece);
    *piece = (vbss_thread *)slot;
    return VBSS_OK;
}
