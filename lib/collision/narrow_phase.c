/* Narrow phase: tests the candidates in batches. */
#include "base/api_call.h"
#include "base/check.h"
#include "base/error.h"
#include "collision/shapes.h"

#include <string.h>

static void load_vertex(collision_block *block, size_t vertex, uint32_t at,
                        const collision_shape *s, uint32_t node)
{
    double(*start)[COLLISION_BLOCK_SIZE] = &block->start[3 * vertex];
    double(*end)[COLLISION_BLOCK_SIZE] = &block->end[3 * vertex];
    start[0][at] = s->start[node].x;
    start[1][at] = s->start[node].y;
    start[2][at] = s->start[node].z;
    end[0][at] = s->end[node].x;
    end[1][at] = s->end[node].y;
    end[2][at] = s->end[node].z;
}

static void load_query(const collision_object *c, uint32_t at, const collision_candidate *q)
{
    const collision_shape *a = c->shapes[q->shape_a], *b = c->shapes[q->shape_b];
    collision_block *block = c->block;
    block->thickness[at] = vbss_collision_contact_distance(c, a, b);
    if (q->kind == VBSS_COLLISION_PAIR_EDGE_EDGE) {
        load_vertex(block, 0, at, a, a->edges[q->a][0]);
        load_vertex(block, 1, at, a, a->edges[q->a][1]);
        load_vertex(block, 2, at, b, b->edges[q->b][0]);
        load_vertex(block, 3, at, b, b->edges[q->b][1]);
    } else {
        load_vertex(block, 0, at, a, q->a);
        load_vertex(block, 1, at, b, b->triangles[q->b][0]);
        load_vertex(block, 2, at, b, b->triangles[q->b][1]);
        load_vertex(block, 3, at, b, b->triangles[q->b][2]);
    }
}

/* Tests candidates from `first` on, as many as have one kind and fit in a block. Returns their
 * number. */
static uint32_t test_block(const collision_object *c, uint32_t first, collision_counters *counters)
{
    collision_block *block = c->block;
    const collision_candidate *q = c->candidates + first;
    uint32_t count = 0, left = c->candidate_count - first;
    while (count < COLLISION_BLOCK_SIZE && count < left && q[count].kind == q[0].kind) {
        load_query(c, count, &q[count]);
        count++;
    }
    const collision_ccd_batch batch = {.kind = (vbss_collision_pair_kind)q[0].kind,
                                       .count = count,
                                       .stride = COLLISION_BLOCK_SIZE,
                                       .start = block->start[0],
                                       .end = block->end[0],
                                       .thickness = block->thickness,
                                       .hit = block->hit,
                                       .decision = block->decision,
                                       .time = block->time,
                                       .distance = block->distance,
                                       .normal = block->normal[0],
                                       .weights = block->weights[0]};
    vbss_collision_run_ccd_batch(&c->ccd_options, c->wide, &batch, counters);
    return count;
}

static void store_impact(collision_object *c, uint32_t candidate, uint32_t at)
{
    const collision_block *block = c->block;
    uint32_t i = c->impact_count++;
    c->impacts[i] = candidate;
    c->times[i] = block->time[at];
    c->distances[i] = block->distance[at];
    c->normals[i] = vec3_make(block->normal[0][at], block->normal[1][at], block->normal[2][at]);
    for (int k = 0; k < 4; k++) {
        c->weights[i][k] = block->weights[k][at];
    }
    c->decisions[i] = (uint32_t)block->decision[at];
}

vbss_result vbss_collision_find_impacts(vbss_collision *collision)
{
    VBSS_ENTER(collision);
    collision_object *c;
    VBSS_TRY(vbss_collision_edit(collision, &c));
    collision_counters counters = c->counters;
    c->impact_count = 0;
    c->generation++;
    uint32_t tested;
    for (uint32_t first = 0; first < c->candidate_count; first += tested) {
        tested = test_block(c, first, &counters);
        for (uint32_t at = 0; at < tested; at++) {
            if (c->block->hit[at] == 0) {
                continue;
            }
            if (c->impact_count == c->config.impact_capacity) {
                c->impact_count = 0;
                return vbss_fail(c->context, VBSS_ERROR_CAPACITY,
                                 "there are more impacts than impact_capacity, %u",
                                 c->config.impact_capacity);
            }
            store_impact(c, first + at, at);
        }
    }
    c->counters = counters;
    return VBSS_OK;
}
