/* Queries of CCD: the motion of a pair's vertices, and batches of them. */
#include "collision/closest.h"
#include "scene/ccd/pair.h"

/* Vertices of a pair: two of each edge, or a point and the corners of a triangle. */
static void get_vertices(const scene_object *s, const collision_candidate *q,
                         const collision_shape *shapes[4], uint32_t vertices[4])
{
    const collision_shape *a = s->collision->shapes[q->shape_a];
    const collision_shape *b = s->collision->shapes[q->shape_b];
    bool edges = q->kind == VBSS_COLLISION_PAIR_EDGE_EDGE;
    for (uint32_t k = 0; k < 4; k++) {
        bool is_a = k < (edges ? 2u : 1u);
        shapes[k] = is_a ? a : b;
        vertices[k] = !edges ? (is_a ? q->a : b->triangles[q->b][k - 1])
                             : (is_a ? a->edges[q->a][k] : b->edges[q->b][k - 2]);
    }
}

bool vbss_scene_touches_lip(const scene_object *s, const collision_candidate *q, bool is_b)
{
    const collision_shape *shapes[4];
    uint32_t vertices[4], first = q->kind == VBSS_COLLISION_PAIR_EDGE_EDGE ? 2 : 1;
    const uint32_t shape = is_b ? q->shape_b : q->shape_a;
    const uint32_t *lips = s->bodies[s->body_of_shape[shape]].drain.lip_of_node;
    get_vertices(s, q, shapes, vertices);
    bool is_lip = false;
    for (uint32_t k = is_b ? first : 0; k < (is_b ? 4 : first); k++) {
        is_lip = is_lip || lips[vertices[k]] != SCENE_NO_FACE;
    }
    return is_lip;
}

typedef struct swept_vertices {
    vec3 start[4], end[4];
} swept_vertices;

static void set_batch_vertex(collision_block *batch, size_t vertex, uint32_t lane, vec3 start,
                             vec3 end)
{
    batch->start[3 * vertex][lane] = start.x;
    batch->start[3 * vertex + 1][lane] = start.y;
    batch->start[3 * vertex + 2][lane] = start.z;
    batch->end[3 * vertex][lane] = end.x;
    batch->end[3 * vertex + 1][lane] = end.y;
    batch->end[3 * vertex + 2][lane] = end.z;
}

static void set_swept_vertices(const scene_object *s, const ccd_query *query, swept_vertices *c)
{
    const collision_candidate *q = query->candidate;
    const scene_axis_interval *interval = query->interval;
    const collision_shape *shapes[4];
    uint32_t vertices[4];
    get_vertices(s, q, shapes, vertices);
    for (uint32_t k = 0; k < 4; k++) {
        vec3 start = shapes[k]->start[vertices[k]], end = shapes[k]->end[vertices[k]];
        c->start[k] =
            query->start_fraction > 0.0 ? vec3_lerp(start, end, query->start_fraction) : start;
        c->end[k] = end;
    }
    bool is_a_needle = scene_is_needle(&s->bodies[s->body_of_shape[q->shape_a]]);
    for (uint32_t k = 0; interval != NULL && k < 2; k++) {
        uint32_t first_vertex = (k == 0) == is_a_needle ? 0 : 2;
        scene_clip_axis(c->start + first_vertex, interval->bounds[k]);
        scene_clip_axis(c->end + first_vertex, interval->bounds[k]);
    }
}

void vbss_scene_set_batch_query(scene_object *s, const ccd_query *query, uint32_t lane)
{
    swept_vertices c;
    set_swept_vertices(s, query, &c);
    for (uint32_t k = 0; k < 4; k++) {
        set_batch_vertex(s->scratch.ccd_batch, k, lane, c.start[k], c.end[k]);
    }
    /* Contacts seldom let a pair come nearer. */
    s->scratch.ccd_batch->thickness[lane] = scene_ccd_min_contact_distance(s, query->candidate);
}

void vbss_scene_run_ccd_batch(scene_object *s, uint32_t kind, uint32_t count)
{
    collision_block *batch = s->scratch.ccd_batch;
    const collision_ccd_batch queries = {.kind = (vbss_collision_pair_kind)kind,
                                         .count = count,
                                         .stride = COLLISION_BLOCK_SIZE,
                                         .start = batch->start[0],
                                         .end = batch->end[0],
                                         .thickness = batch->thickness,
                                         .hit = batch->hit,
                                         .decision = batch->decision,
                                         .time = batch->time};
    vbss_collision_run_ccd_batch(&s->collision->ccd_options, s->collision->wide, &queries,
                                 &s->collision->counters);
}

double vbss_scene_distance_at_start(const scene_object *s, const ccd_query *query,
                                    double coordinates[3])
{
    swept_vertices c;
    set_swept_vertices(s, query, &c);
    const vec3 *x = c.start;
    if (query->candidate->kind == VBSS_COLLISION_PAIR_POINT_TRIANGLE) {
        const vec3 triangle[3] = {vec3_sub(x[1], x[0]), vec3_sub(x[2], x[0]), vec3_sub(x[3], x[0])};
        return vec3_norm(closest_on_triangle(triangle, coordinates));
    }
    return vec3_norm(closest_between_edges(vec3_sub(x[1], x[0]), vec3_sub(x[3], x[2]),
                                           vec3_sub(x[2], x[0]), &coordinates[0], &coordinates[1]));
}
