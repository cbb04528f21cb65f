/* Surface nets. */
#include "scene/api/surface_net.h"

#include "base/error.h"

/* Corners of a cell: bit k of the number is the offset along axis k. */
enum { CORNERS = 8 };
/* Newton iterations that move a vertex on to the surface.
 * Origin: chosen; the field is nearly linear in a cell. Test: scene.distance_field. */
enum { NEWTON_ITERATIONS = 4 };
/* Distance of a vertex from the faces of its cell, so that edges have a length.
 * Unit: cells. Origin: chosen; a vertex may be that far from the surface. Test: scene.distance_field. */
#define MARGIN 0.005

typedef struct cell {
    double values[CORNERS]; /* less the level */
    uint32_t at[3];
} cell;

static size_t sample_index(const scene_sampled_field *f, const uint32_t at[3])
{
    return at[0] + f->counts[0] * (at[1] + f->counts[1] * (size_t)at[2]);
}

static void read_cell(const scene_sampled_field *f, const uint32_t at[3], cell *c)
{
    for (uint32_t k = 0; k < CORNERS; k++) {
        const uint32_t corner[3] = {at[0] + (k & 1), at[1] + (k >> 1 & 1), at[2] + (k >> 2)};
        c->values[k] = f->values[sample_index(f, corner)] - f->level;
    }
    c->at[0] = at[0];
    c->at[1] = at[1];
    c->at[2] = at[2];
}

/* Corners with negative values, as bits. */
static uint32_t inside_of(const cell *c)
{
    uint32_t inside = 0;
    for (uint32_t k = 0; k < CORNERS; k++) {
        inside |= c->values[k] < 0.0 ? 1u << k : 0u;
    }
    return inside;
}

/* Whether edges of the cell connect all corners of a set with each other. */
static bool is_connected(uint32_t corners)
{
    uint32_t reached = corners & (~corners + 1); /* the first of them */
    for (uint32_t before = 0; before != reached;) {
        before = reached;
        for (uint32_t k = 0; k < CORNERS; k++) {
            const uint32_t beside = 1u << (k ^ 1) | 1u << (k ^ 2) | 1u << (k ^ 4);
            reached |= (reached >> k & 1u) != 0 ? beside & corners : 0u;
        }
    }
    return reached == corners;
}

/* The trilinear field at a place in a cell, 0 to 1 along each axis, and its gradient. */
static double interpolate(const cell *c, const double at[3], double gradient[3])
{
    double value = 0.0;
    gradient[0] = gradient[1] = gradient[2] = 0.0;
    for (uint32_t k = 0; k < CORNERS; k++) {
        double weights[3], signs[3];
        for (uint32_t i = 0; i < 3; i++) {
            const bool is_far = (k >> i & 1u) != 0;
            weights[i] = is_far ? at[i] : 1.0 - at[i];
            signs[i] = is_far ? 1.0 : -1.0;
        }
        value += c->values[k] * weights[0] * weights[1] * weights[2];
        gradient[0] += c->values[k] * signs[0] * weights[1] * weights[2];
        gradient[1] += c->values[k] * weights[0] * signs[1] * weights[2];
        gradient[2] += c->values[k] * weights[0] * weights[1] * signs[2];
    }
    return value;
}

/* The mean of the points at which the surface crosses edges of the cell. */
static void find_mean_crossing(const cell *c, double at[3])
{
    double sum[3] = {0.0, 0.0, 0.0}, count = 0.0;
    for (uint32_t k = 0; k < CORNERS; k++) {
        for (uint32_t axis = 0; axis < 3; axis++) {
            const uint32_t other = k | 1u << axis;
            if (other == k || (c->values[k] < 0.0) == (c->values[other] < 0.0)) {
                continue;
            }
            for (uint32_t i = 0; i < 3; i++) {
                sum[i] += i == axis ? c->values[k] / (c->values[k] - c->values[other])
                                    : (double)(k >> i & 1u);
            }
            count += 1.0;
        }
    }
    for (uint32_t i = 0; i < 3; i++) {
        at[i] = sum[i] / count;
    }
}

/* The vertex stays in its cell, so that triangles do not overlap. */
static void find_vertex(const scene_sampled_field *f, const cell *c, double *vertex)
{
    const double spacing[3] = {f->spacing.x, f->spacing.y, f->spacing.z};
    double at[3], gradient[3];
    find_mean_crossing(c, at);
    for (uint32_t n = 0; n < NEWTON_ITERATIONS; n++) {
        const double value = interpolate(c, at, gradient);
        double squared = 0.0;
        for (uint32_t i = 0; i < 3; i++) {
            gradient[i] /= spacing[i];
            squared += gradient[i] * gradient[i];
        }
        for (uint32_t i = 0; i < 3 && squared > 0.0; i++) {
            const double moved = at[i] - value * gradient[i] / squared / spacing[i];
            at[i] = vbss_min(vbss_max(moved, MARGIN), 1.0 - MARGIN);
        }
    }
    for (uint32_t i = 0; i < 3; i++) {
        vertex[i] = spacing[i] * (c->at[i] + at[i]);
    }
}

static void add_triangle(scene_surface_net *net, uint32_t a, uint32_t b, uint32_t c)
{
    if (net->triangles != NULL) {
        uint32_t *n = net->triangles + 3 * (size_t)net->triangle_count;
        n[0] = a;
        n[1] = b;
        n[2] = c;
    }
    net->triangle_count++;
}

/* Vertices of the cells of two layers: those of the present z, and those of the one before. */
typedef struct layer_pair {
    const scene_sampled_field *field;
    uint32_t *now, *before;
} layer_pair;

static uint32_t vertex_at(const layer_pair *l, bool is_before, uint32_t x, uint32_t y)
{
    return (is_before ? l->before : l->now)[x + (size_t)l->field->counts[0] * y];
}

/* Triangles around the edges of the grid that start at the first corner of a cell. */
static void add_triangles(const layer_pair *l, const cell *c, scene_surface_net *net)
{
    for (uint32_t axis = 0; axis < 3; axis++) {
        const uint32_t u = (axis + 1) % 3, v = (axis + 2) % 3;
        const bool is_inside = c->values[0] < 0.0;
        if (is_inside == (c->values[1u << axis] < 0.0) || c->at[u] == 0 || c->at[v] == 0) {
            continue;
        }
        uint32_t around[4]; /* in the order of the turn from u to v */
        for (uint32_t k = 0; k < 4; k++) {
            uint32_t back[3] = {0, 0, 0};
            back[u] = k == 0 || k == 3 ? 1 : 0;
            back[v] = k < 2 ? 1 : 0;
            around[k] = vertex_at(l, back[2] != 0, c->at[0] - back[0], c->at[1] - back[1]);
        }
        const uint32_t second = is_inside ? around[1] : around[3];
        const uint32_t fourth = is_inside ? around[3] : around[1];
        add_triangle(net, around[0], second, around[2]);
        add_triangle(net, around[0], around[2], fourth);
    }
}

static vbss_result visit_cell(vbss_context *context, const layer_pair *l, const uint32_t at[3],
                              scene_surface_net *net)
{
    cell c;
    read_cell(l->field, at, &c);
    const uint32_t inside = inside_of(&c), all = (1u << CORNERS) - 1;
    if (inside == 0 || inside == all) {
        return VBSS_OK;
    }
    if (!is_connected(inside) || !is_connected(all & ~inside)) {
        return vbss_fail(context, VBSS_ERROR_OUT_OF_RANGE,
                         "the surface passes the cell %u, %u, %u of the grid twice", at[0], at[1],
                         at[2]);
    }
    l->now[at[0] + (size_t)l->field->counts[0] * at[1]] = net->vertex_count;
    if (net->vertices != NULL) {
        find_vertex(l->field, &c, net->vertices + 3 * (size_t)net->vertex_count);
    }
    net->vertex_count++;
    add_triangles(l, &c, net);
    return VBSS_OK;
}

vbss_result vbss_scene_find_surface_net(vbss_context *context, const scene_sampled_field *field,
                                        uint32_t *layers, scene_surface_net *net)
{
    const size_t layer_size = (size_t)field->counts[0] * field->counts[1];
    net->vertex_count = net->triangle_count = 0;
    for (uint32_t z = 0; z + 1 < field->counts[2]; z++) {
        uint32_t *const even = layers, *const odd = even + layer_size;
        const layer_pair l = {field, z % 2 == 0 ? even : odd, z % 2 == 0 ? odd : even};
        for (uint32_t y = 0; y + 1 < field->counts[1]; y++) {
            for (uint32_t x = 0; x + 1 < field->counts[0]; x++) {
                const uint32_t at[3] = {x, y, z};
                VBSS_TRY(visit_cell(context, &l, at, net));
            }
        }
    }
    return VBSS_OK;
}
