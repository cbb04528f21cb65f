/* Serialisation of a collision object.
 *
 * Trees are omitted: they affect the speed of a search, not its result. So is the count of tested
 * boxes, which depends on them. */
#include "base/check.h"
#include "base/stream.h"
#include "collision/shapes.h"

/* The configuration must equal the saved one, except for capacities. */
static void visit_config(vbss_stream *stream, const collision_object *c)
{
    const double numbers[] = {c->thickness,
                              c->ccd_options.tolerance,
                              c->config.exclusion,
                              c->config.margin,
                              c->config.baseline->collision_parallel,
                              c->config.baseline->collision_unit};
    for (size_t i = 0; i < sizeof numbers / sizeof numbers[0]; i++) {
        vbss_stream_expect_f64(stream, 1, numbers[i]);
    }
    vbss_stream_expect(stream, 2, (uint64_t)c->config.method);
    vbss_stream_expect(stream, 3, c->ccd_options.pass_limit);
}

static void visit_shape(vbss_stream *stream, collision_shape *s)
{
    size_t numbers = 3u * (size_t)s->node_count;
    vbss_stream_expect(stream, 11, s->topology_hash);
    vbss_stream_f64(stream, 12, &s->start[0].x, numbers);
    vbss_stream_f64(stream, 13, &s->end[0].x, numbers);
    vbss_stream_u32(stream, 14, &s->category, 1);
    vbss_stream_u32(stream, 15, &s->mask, 1);
    if (stream->mode != VBSS_STREAM_READ) {
        return;
    }
    vbss_collision_shape_invalidate(s);
    if (vbss_max_abs(&s->start[0].x, numbers) > COLLISION_MAX_COORDINATE ||
        vbss_max_abs(&s->end[0].x, numbers) > COLLISION_MAX_COORDINATE) {
        vbss_stream_refuse(stream, VBSS_ERROR_CORRUPT, "a coordinate is too large");
    }
}

static void visit_counters(vbss_stream *stream, collision_object *c)
{
    vbss_stream_u64(stream, 20, &c->counters.queries, 1);
    vbss_stream_u64(stream, 21, &c->counters.hits, 1);
    vbss_stream_u64(stream, 22, &c->counters.undecided, 1);
    vbss_stream_u64(stream, 23, &c->counters.exact, 1);
    vbss_stream_u64(stream, 24, &c->counters.passes, 1);
    vbss_stream_u64(stream, 25, &c->counters.sign_tests_ended, 1);
    vbss_stream_u64(stream, 26, &c->searches, 1);
}

void vbss_collision_serialise(vbss_stream *stream, void *object)
{
    collision_object *c = object;
    visit_config(stream, c);
    vbss_stream_expect(stream, 4, c->shape_count);
    for (uint32_t id = 0; id < c->shape_count; id++) {
        vbss_stream_expect(stream, 10, c->shapes[id] != NULL);
        if (c->shapes[id] != NULL) {
            visit_shape(stream, c->shapes[id]);
        }
    }
    visit_counters(stream, c);
}
