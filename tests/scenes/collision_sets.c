#include "scenes/collision_build.h"

#include <stdio.h>
#include <stdlib.h>

bool collision_set_begin(collision_set *set, const char *name, uint32_t capacity)
{
    *set = (collision_set){.queries = calloc(capacity > 0 ? capacity : 1, sizeof *set->queries)};
    snprintf(set->name, sizeof set->name, "%s", name);
    return set->queries != NULL;
}

void collision_set_release(collision_set *set)
{
    free(set->queries);
    *set = (collision_set){.queries = NULL};
}

void collision_query_fill(collision_query *query, vbss_pair_kind kind, double thickness,
                          const collision_motion *motion)
{
    *query = (collision_query){.kind = kind, .thickness = thickness, .clearance = (double)NAN};
    for (size_t i = 0; i < 4; i++) {
        vec3_store(&query->start[3 * i], motion->start[i]);
        vec3_store(&query->end[3 * i], motion->end[i]);
    }
}

void collision_set_fill(collision_set *set, uint32_t capacity, vbss_pair_kind kind,
                        collision_draw draw, vbss_random *random)
{
    while (set->count < capacity) {
        collision_motion motion;
        draw(random, &motion);
        collision_query *query = &set->queries[set->count];
        collision_query_fill(query, kind, COLLISION_THICKNESS, &motion);
        set->count += collision_truth(query) ? 1 : 0;
    }
}

bool collision_set_make(collision_set *set, const char *name, uint32_t count, vbss_pair_kind kind,
                        collision_draw draw, uint64_t seed, uint64_t sequence)
{
    if (!collision_set_begin(set, name, count)) {
        return false;
    }
    vbss_random random;
    vbss_random_seed(&random, seed, sequence);
    collision_set_fill(set, count, kind, draw, &random);
    return true;
}

uint64_t collision_set_hash(const collision_set *set)
{
    vbss_stream stream;
    vbss_stream_begin_hash(&stream);
    for (uint32_t i = 0; i < set->count; i++) {
        collision_query query = set->queries[i];
        uint8_t hit = query.hit;
        vbss_stream_f64(&stream, 1, query.start, 12);
        vbss_stream_f64(&stream, 2, query.end, 12);
        vbss_stream_f64(&stream, 3, &query.thickness, 1);
        vbss_stream_i32(&stream, 4, &query.kind, 1);
        vbss_stream_u8(&stream, 5, &hit, 1);
    }
    return vbss_hash_end(&stream.hash);
}
