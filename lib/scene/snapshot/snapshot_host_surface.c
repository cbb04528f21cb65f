/* The state of a host surface in a snapshot: where it is, the input of the host, and the last forces. */
#include "base/check.h"
#include "base/stream.h"
#include "scene/snapshot/snapshot.h"
#include "scene/world/world.h"

/* Reading replaces an array that is not valid by the present positions. */
static void visit_positions(vbss_stream *stream, uint16_t field, scene_host_surface *h, vec3 *x)
{
    const size_t numbers = 3 * (size_t)h->vertex_count;
    vbss_stream_f64(stream, field, &x->x, numbers);
    if (stream->mode != VBSS_STREAM_READ || stream->trusted) {
        return;
    }
    bool is_valid = true;
    for (uint32_t i = 0; i < h->vertex_count; i++) {
        is_valid = is_valid && vec3_is_finite(x[i]);
    }
    if (!is_valid || !(vbss_max_abs(&x->x, numbers) <= 1e3)) {
        vbss_stream_refuse(stream, VBSS_ERROR_CORRUPT, "no such positions of a host surface");
        for (uint32_t i = 0; i < h->vertex_count; i++) {
            x[i] = vec3_zero();
        }
    }
}

static void visit_forces(vbss_stream *stream, scene_host_surface *h)
{
    vbss_stream_f64(stream, 86, &h->forces->x, 3 * (size_t)h->vertex_count);
    for (uint32_t i = 0; stream->mode == VBSS_STREAM_READ && i < h->vertex_count; i++) {
        if (!vec3_is_finite(h->forces[i])) {
            vbss_stream_refuse(stream, VBSS_ERROR_CORRUPT, "no such forces on a host surface");
            h->forces[i] = vec3_zero();
        }
    }
}

static void visit_compliance(vbss_stream *stream, scene_host_surface *h)
{
    const uint32_t count = scene_is_compliant(h) ? h->vertex_count : 0;
    for (uint32_t i = 0; i < count; i++) {
        mat3 compliance = h->compliance[i];
        vbss_stream_f64(stream, 89, compliance.m[0], 9);
        vbss_stream_f64(stream, 90, &h->deflections[i].x, 3);
        if (stream->mode != VBSS_STREAM_READ) {
            continue;
        }
        if (!stream->trusted &&
            (!vbss_scene_is_compliance(&compliance) || !(vec3_norm(h->deflections[i]) <= 1e3))) {
            vbss_stream_refuse(stream, VBSS_ERROR_CORRUPT, "no such compliance of a host surface");
            compliance = mat3_zero();
            h->deflections[i] = vec3_zero();
        }
        vbss_scene_set_vertex_compliance(h, i, &compliance);
    }
}

void vbss_scene_serialise_host_surface(vbss_stream *stream, scene_rigid *r)
{
    scene_host_surface *h = r->surface;
    uint32_t has_pending = h->has_pending;
    vbss_stream_expect(stream, 80, r->mesh.geometry_hash);
    vbss_stream_expect_f64(stream, 81, h->jump_limit);
    vbss_stream_expect(stream, 88, h->compliance_size);
    visit_positions(stream, 82, h, h->now);
    visit_positions(stream, 83, h, h->start);
    visit_positions(stream, 84, h, h->end);
    vbss_stream_u32(stream, 85, &has_pending, 1);
    if (has_pending > 1) {
        vbss_stream_refuse(stream, VBSS_ERROR_CORRUPT, "no such input of a host surface");
    }
    if (has_pending == 1) {
        visit_positions(stream, 87, h, h->pending);
    }
    visit_forces(stream, h);
    visit_compliance(stream, h);
    if (stream->mode == VBSS_STREAM_READ) {
        h->has_pending = has_pending == 1;
        vbss_scene_update_host_surface(h);
        vbss_scene_hold_host_surface(h);
    }
}
