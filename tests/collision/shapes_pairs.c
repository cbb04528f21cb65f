/* What a search must list, by trying all pairs. */
#include <math.h>
#include <string.h>

#include "base/check.h"
#include "collision/shapes_model.h"

/* ---- swept boxes, not enlarged */

typedef struct swept {
    double low[3], high[3];
} swept;

static void sweep(swept *box, const model_shape *s, uint32_t node)
{
    const vec3 ends[2] = {s->start[node], s->end[node]};
    for (int i = 0; i < 2; i++) {
        const double x[3] = {ends[i].x, ends[i].y, ends[i].z};
        for (int k = 0; k < 3; k++) {
            box->low[k] = x[k] < box->low[k] ? x[k] : box->low[k];
            box->high[k] = x[k] > box->high[k] ? x[k] : box->high[k];
        }
    }
}

static swept sweep_nodes(const model_shape *s, const uint32_t *nodes, int count)
{
    const double far = (double)INFINITY;
    swept box = {{far, far, far}, {-far, -far, -far}};
    for (int i = 0; i < count; i++) {
        sweep(&box, s, nodes[i]);
    }
    return box;
}

static swept sweep_feature(const model_shape *s, int corners, uint32_t feature)
{
    return corners == 1   ? sweep_nodes(s, &feature, 1)
           : corners == 2 ? sweep_nodes(s, s->edges[feature], 2)
                          : sweep_nodes(s, s->triangles[feature], 3);
}

/* ---- which pairs are meant */

static bool touches(const uint32_t *nodes, int count, uint32_t node)
{
    bool found = false;
    for (int i = 0; i < count; i++) {
        found = found || nodes[i] == node;
    }
    return found;
}

static bool far_along(const model *m, const model_shape *s, uint32_t a, uint32_t b)
{
    double arc = 0.0; /* exact: see MODEL_UNIT */
    for (uint32_t i = a + 1; s->rest != NULL && i < b; i++) {
        arc += s->rest[i];
    }
    double distance = 2.0 * s->radius + m->config.thickness;
    return b > a + 1 && (s->rest == NULL || arc >= m->config.exclusion * distance);
}

static bool no_common_node(const model_shape *s, uint32_t a, uint32_t b)
{
    return !touches(s->edges[b], 2, s->edges[a][0]) && !touches(s->edges[b], 2, s->edges[a][1]);
}

/* Along the surface, between the nearest of their nodes. */
static bool far_apart(const model_shape *s, const uint32_t *a, int count_a, const uint32_t *b,
                      int count_b)
{
    double arc = (double)INFINITY;
    for (int i = 0; s->arcs != NULL && i < count_a * count_b; i++) {
        double path = s->arcs[(size_t)a[i / count_b] * s->node_count + b[i % count_b]];
        arc = path < arc ? path : arc;
    }
    return s->arcs == NULL || arc >= s->near;
}

static bool meant(const model *m, const candidate *pair)
{
    const model_shape *a = &m->shapes[pair->shape_a], *b = &m->shapes[pair->shape_b];
    if (a->removed || b->removed) {
        return false;
    }
    if (pair->kind == VBSS_COLLISION_PAIR_POINT_TRIANGLE) {
        const uint32_t *corners = b->triangles[pair->b];
        return a != b || (!touches(corners, 3, pair->a) && far_apart(b, &pair->a, 1, corners, 3));
    }
    if (a != b || pair->a >= pair->b) {
        return pair->shape_a < pair->shape_b;
    }
    return a->kind == MODEL_CHAIN  ? far_along(m, a, pair->a, pair->b)
           : a->kind == MODEL_MESH ? no_common_node(a, pair->a, pair->b) &&
                                         far_apart(a, a->edges[pair->a], 2, a->edges[pair->b], 2)
                                   : true;
}

/* ---- which of them overlap */

/* The largest gap between the boxes along any axis. */
static double gap(const swept *a, const swept *b)
{
    double largest = -(double)INFINITY;
    for (int k = 0; k < 3; k++) {
        largest = vbss_max_or_nan(vbss_max_or_nan(a->low[k] - b->high[k], b->low[k] - a->high[k]),
                                  largest);
    }
    return largest;
}

static double size(const swept *box)
{
    return vbss_max_or_nan(vbss_max_abs(box->low, 3), vbss_max_abs(box->high, 3));
}

/* One listed pair after another, as all pairs go by in order. */
typedef struct check {
    const model *m;
    uint32_t first_name;
    const candidate *listed;
    uint64_t left;
} check;

static void check_pair(check *c, const candidate *pair)
{
    bool edges = pair->kind == VBSS_COLLISION_PAIR_EDGE_EDGE;
    const model_shape *a = &c->m->shapes[pair->shape_a], *b = &c->m->shapes[pair->shape_b];
    candidate named = *pair;
    named.shape_a += c->first_name;
    named.shape_b += c->first_name;
    bool listed = c->left > 0 && memcmp(c->listed, &named, sizeof named) == 0;
    if (listed) {
        c->listed++;
        c->left--;
    }
    if (!meant(c->m, pair)) {
        assert_false(listed);
        return;
    }
    swept box_a = sweep_feature(a, edges ? 2 : 1, pair->a);
    swept box_b = sweep_feature(b, edges ? 2 : 3, pair->b);
    double distance = a->radius + b->radius + c->m->config.thickness;
    double reach = distance * (1.0 + c->m->config.tolerance) + c->m->config.margin;
    double apart = gap(&box_a, &box_b);
    /* Rounding here: what is that near to the border may be listed or not. */
    double doubt = c->m->exact ? 0.0 : 4.0 * DBL_EPSILON * (size(&box_a) + size(&box_b) + reach);
    if (apart <= reach - doubt) {
        assert_true(listed);
    }
    if (apart > reach + doubt) {
        assert_false(listed);
    }
}

static void check_shapes(check *c, candidate pair)
{
    const model *m = c->m;
    bool edges = pair.kind == VBSS_COLLISION_PAIR_EDGE_EDGE;
    const model_shape *a = &m->shapes[pair.shape_a];
    for (pair.a = 0; pair.a < (edges ? a->edge_count : a->node_count); pair.a++) {
        for (pair.shape_b = 0; pair.shape_b < m->count; pair.shape_b++) {
            const model_shape *b = &m->shapes[pair.shape_b];
            for (pair.b = 0; pair.b < (edges ? b->edge_count : b->triangle_count); pair.b++) {
                check_pair(c, &pair);
            }
        }
    }
}

void model_check(const model *m, vbss_collision *collision, uint32_t first_name)
{
    vbss_view view = shapes_view(collision, VBSS_COLLISION_VIEW_CANDIDATES);
    check c = {m, first_name, view.data, view.count};
    candidate pair = {.kind = VBSS_COLLISION_PAIR_EDGE_EDGE};
    for (; pair.kind <= VBSS_COLLISION_PAIR_POINT_TRIANGLE; pair.kind++) {
        for (pair.shape_a = 0; pair.shape_a < m->count; pair.shape_a++) {
            check_shapes(&c, pair);
        }
    }
    assert_int_equal(c.left, 0); /* else there is one out of order, twice, or of nothing */
}
