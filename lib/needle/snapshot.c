/* Serialisation of a needle. */
#include "base/api_call.h"
#include "base/snapshot.h"
#include "base/stream.h"
#include "needle/needle.h"

/* The initial position is omitted, because the state contains the present one; so is the number,
 * which belongs to the scene. */
static void visit_config(vbss_stream *stream, const vbss_needle_config *c)
{
    const double numbers[] = {c->radius, c->wire_radius, c->arc,        c->density,   c->friction,
                              c->drag,   c->gravity[0],  c->gravity[1], c->gravity[2]};
    for (size_t i = 0; i < sizeof numbers / sizeof numbers[0]; i++) {
        vbss_stream_expect_f64(stream, 1, numbers[i]);
    }
    vbss_stream_expect(stream, 2, (uint64_t)c->method);
    vbss_stream_expect(stream, 2, c->segment_count);
}

void vbss_needle_serialise(vbss_stream *stream, void *object)
{
    needle_object *n = object;
    vbss_rigid_motion *now = &n->body.now;
    visit_config(stream, &n->config);
    vbss_stream_f64(stream, 10, &now->pose.position.x, 3);
    vbss_stream_f64(stream, 11, &now->pose.orientation.w, 4);
    vbss_stream_f64(stream, 12, &now->v.x, 3);
    vbss_stream_f64(stream, 13, &now->w.x, 3);
    if (stream->mode == VBSS_STREAM_READ) {
        n->body.target_start = n->body.target_end = now->pose;
        if (!stream->trusted && !vbss_rigid_is_valid(&n->body)) {
            vbss_stream_refuse(stream, VBSS_ERROR_CORRUPT, "no such needle");
        }
        n->generation++;
    }
    if (stream->trusted) { /* a way back leaves no mark */
        vbss_stream_u64(stream, 14, &n->generation, 1);
    }
}

/* ---- public functions */

vbss_result vbss_needle_save(vbss_needle *needle, uint8_t *bytes, uint64_t capacity,
                             uint64_t *written)
{
    VBSS_ENTER(needle);
    return vbss_object_save(needle, &vbss_needle_kind, bytes, capacity, written);
}

vbss_result vbss_needle_restore(vbss_needle *needle, const uint8_t *bytes, uint64_t count)
{
    VBSS_ENTER(needle);
    return vbss_object_restore(needle, &vbss_needle_kind, bytes, count);
}

vbss_result vbss_needle_get_hash(vbss_needle *needle, uint64_t *hash)
{
    VBSS_ENTER(needle);
    return vbss_object_hash(needle, &vbss_needle_kind, hash);
}
