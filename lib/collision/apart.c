/* How far candidates are known to be apart, from one search to the next.
 *
 * Whoever has measured the axes of a candidate notes it; the next search hands it on to the same pair, less what the nodes
 * have gone since. What is known decides what need not be measured again, never what is found: it is no state, and what two
 * objects know of the same places may differ. */
#include "collision/shapes.h"

/* What is proved is so by more than rounding: share of the distance. */
#define PROVED (1.0 + 1e-9)
#define NOTED (1.0 - 1e-9)

/* ---- where nodes go */

void vbss_collision_measure_ways(collision_shape *s)
{
    for (uint32_t i = 0; i < s->node_count; i++) {
        s->goes[i] = vec3_distance(s->start[i], s->end[i]);
    }
}

/* Since the last search, of which a shape that has changed knows nothing. */
static void measure_gone(collision_shape *s)
{
    for (uint32_t i = 0; i < s->node_count; i++) {
        s->gone[i] =
            s->start_known ? vec3_distance(s->known_start[i], s->start[i]) : (double)INFINITY;
        s->known_start[i] = s->start[i];
    }
    s->start_known = true;
}

static inline double largest_of(const double *of_nodes, const uint32_t *nodes, uint32_t count)
{
    double largest = of_nodes[nodes[0]];
    for (uint32_t k = 1; k < count; k++) {
        largest = greater(of_nodes[nodes[k]], largest);
    }
    return largest;
}

/* Of the farthest corner of a candidate's feature a, and of its b. */
static double farthest_of_a(const collision_candidate *q, const collision_shape *a,
                            const double *of_nodes)
{
    return q->kind == VBSS_PAIR_EDGE_EDGE ? largest_of(of_nodes, a->edges[q->a], 2)
                                          : of_nodes[q->a];
}

static double farthest_of_b(const collision_candidate *q, const collision_shape *b,
                            const double *of_nodes)
{
    return q->kind == VBSS_PAIR_EDGE_EDGE ? largest_of(of_nodes, b->edges[q->b], 2)
                                          : largest_of(of_nodes, b->triangles[q->b], 3);
}

/* ---- what is known */

void vbss_collision_note_apart(collision_object *c, const collision_candidate *q, double distance)
{
    c->apart[q - c->candidates] = NOTED * distance;
}

bool vbss_collision_stays_apart(const collision_object *c, const collision_candidate *q,
                                double distance)
{
    const double apart = c->apart[q - c->candidates];
    if (!(apart > PROVED * distance)) {
        return false;
    }
    const collision_shape *a = c->shapes[q->shape_a], *b = c->shapes[q->shape_b];
    double go = farthest_of_a(q, a, a->goes) + farthest_of_b(q, b, b->goes);
    return apart > PROVED * (distance + go);
}

/* ---- from search to search */

void vbss_collision_begin_known(collision_object *c)
{
    collision_candidate *candidates = c->known;
    double *apart = c->known_apart;
    c->known = c->candidates;
    c->known_apart = c->apart;
    c->known_count = c->listed;
    c->candidates = candidates;
    c->apart = apart;
    c->listed = 0;
}

static bool is_before(const collision_candidate *p, const collision_candidate *q)
{
    return p->kind != q->kind         ? p->kind < q->kind
           : p->shape_a != q->shape_a ? p->shape_a < q->shape_a
           : p->a != q->a             ? p->a < q->a
           : p->shape_b != q->shape_b ? p->shape_b < q->shape_b
                                      : p->b < q->b;
}

static bool is_same(const collision_candidate *p, const collision_candidate *q)
{
    return p->b == q->b && p->a == q->a && p->shape_b == q->shape_b && p->shape_a == q->shape_a &&
           p->kind == q->kind;
}

/* Both lists ascend. */
void vbss_collision_hand_on(collision_object *c)
{
    uint32_t k = 0;
    double gone = 0.0;
    for (uint32_t i = 0; i < c->living_count; i++) {
        measure_gone(c->shapes[c->living[i]]);
    }
    for (uint32_t i = 0; i < c->candidate_count; i++) {
        const collision_candidate *q = &c->candidates[i];
        const collision_shape *a = c->shapes[q->shape_a], *b = c->shapes[q->shape_b];
        if (i == 0 || q->a != q[-1].a || q->shape_a != q[-1].shape_a || q->kind != q[-1].kind) {
            gone = farthest_of_a(q, a, a->gone);
        }
        while (k < c->known_count && is_before(&c->known[k], q)) {
            k++;
        }
        bool known = k < c->known_count && is_same(&c->known[k], q);
        c->apart[i] =
            known ? c->known_apart[k] - PROVED * (gone + farthest_of_b(q, b, b->gone)) : 0.0;
    }
    c->listed = c->candidate_count;
}
