/* Topology of shapes: the hash of all data that never changes, and changes of pair rules. */
#include "base/hash.h"
#include "base/stream.h"
#include "collision/shapes.h"

uint64_t vbss_collision_hash_topology(collision_shape *s)
{
    vbss_stream stream;
    uint32_t counts[4] = {(uint32_t)s->kind, s->node_count, s->edge_count, s->triangle_count};
    vbss_stream_begin_hash(&stream);
    vbss_stream_u32(&stream, 1, counts, 4);
    vbss_stream_f64(&stream, 2, &s->radius, 1);
    if (s->kind == COLLISION_SHAPE_CHAIN) {
        vbss_stream_u32(&stream, 3, s->far_before, s->edge_count);
    }
    if (s->kind == COLLISION_SHAPE_MESH) {
        vbss_stream_u32(&stream, 4, s->triangles[0], 3u * (size_t)s->triangle_count);
    }
    if (s->exclusion.words > 0) { /* the edges determine the rows of the triangles */
        vbss_stream_u64(&stream, 5, s->exclusion.edges, (size_t)s->edge_count * s->exclusion.words);
    }
    return vbss_hash_end(&stream.hash);
}

void vbss_collision_update_pair_rules(collision_object *c, collision_shape *s)
{
    s->topology_hash = vbss_collision_hash_topology(s);
    c->near_valid = false;
    vbss_collision_clear_results(c);
    c->generation++;
}
