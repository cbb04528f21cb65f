#include "collision/shapes_model.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* ---- shapes */

void model_begin(model *m)
{
    memset(m, 0, sizeof *m);
    expect_ok(vbss_collision_config_init(&m->config, sizeof m->config));
}

void model_end(model *m)
{
    for (uint32_t i = 0; i < m->count; i++) {
        free(m->shapes[i].edges);
        free(m->shapes[i].triangles);
        free(m->shapes[i].rest);
        free(m->shapes[i].arcs);
        free(m->shapes[i].start);
        free(m->shapes[i].end);
    }
    m->count = 0;
}

static void *zeros(size_t count, size_t size)
{
    void *block = calloc(count + 1, size);
    assert_non_null(block);
    return block;
}

static model_shape *add(model *m, model_kind kind, uint32_t nodes, uint32_t edges,
                        uint32_t triangles, double radius)
{
    assert_true(m->count < MODEL_SHAPES);
    model_shape *s = &m->shapes[m->count++];
    *s = (model_shape){.kind = kind,
                       .node_count = nodes,
                       .edge_count = edges,
                       .triangle_count = triangles,
                       .radius = radius};
    s->edges = zeros(edges, sizeof *s->edges);
    s->triangles = zeros(triangles, sizeof *s->triangles);
    s->start = zeros(nodes, sizeof *s->start);
    s->end = zeros(nodes, sizeof *s->end);
    return s;
}

model_shape *model_chain(model *m, uint32_t node_count, const double *rest, double radius)
{
    model_shape *s = add(m, MODEL_CHAIN, node_count, node_count - 1, 0, radius);
    for (uint32_t i = 0; i < s->edge_count; i++) {
        s->edges[i][0] = i;
        s->edges[i][1] = i + 1;
    }
    if (rest != NULL) {
        s->rest = zeros(s->edge_count, sizeof *s->rest);
        memcpy(s->rest, rest, s->edge_count * sizeof *rest);
    }
    return s;
}

model_shape *model_capsules(model *m, uint32_t capsule_count, double radius)
{
    model_shape *s = add(m, MODEL_CAPSULES, 2 * capsule_count, capsule_count, 0, radius);
    for (uint32_t i = 0; i < capsule_count; i++) {
        s->edges[i][0] = 2 * i;
        s->edges[i][1] = 2 * i + 1;
    }
    return s;
}

static int compare_edges(const void *one, const void *other)
{
    const uint32_t *a = one, *b = other;
    int k = a[0] == b[0];
    return a[k] < b[k] ? -1 : a[k] > b[k];
}

model_shape *model_mesh(model *m, uint32_t node_count, const uint32_t (*triangles)[3],
                        uint32_t triangle_count, double radius)
{
    model_shape *s = add(m, MODEL_MESH, node_count, 3 * triangle_count, triangle_count, radius);
    uint32_t count = 0;
    memcpy(s->triangles, triangles, triangle_count * sizeof *triangles);
    for (uint32_t i = 0; i < 3 * triangle_count; i++) {
        uint32_t p = triangles[i / 3][i % 3], q = triangles[i / 3][(i + 1) % 3];
        s->edges[i][0] = p < q ? p : q;
        s->edges[i][1] = p < q ? q : p;
    }
    qsort(s->edges, 3 * (size_t)triangle_count, sizeof *s->edges, compare_edges);
    for (uint32_t i = 0; i < 3 * triangle_count; i++) {
        if (i == 0 || compare_edges(s->edges[i], s->edges[i - 1]) != 0) {
            memmove(s->edges[count++], s->edges[i], sizeof *s->edges);
        }
    }
    s->edge_count = count;
    return s;
}

model_shape *model_sheet(model *m, uint32_t columns, uint32_t rows, double radius)
{
    uint32_t(*triangles)[3] = zeros(2 * (size_t)columns * rows, sizeof *triangles), count = 0;
    for (uint32_t row = 0; row + 1 < rows; row++) {
        for (uint32_t k = 0; k + 1 < columns; k++, count += 2) {
            uint32_t node = row * columns + k, above = node + columns;
            const uint32_t pair[2][3] = {{node, node + 1, above}, {above + 1, above, node + 1}};
            memcpy(triangles[count], pair, sizeof pair);
        }
    }
    model_shape *s = model_mesh(m, columns * rows, (const uint32_t(*)[3])triangles, count, radius);
    free(triangles);
    return s;
}

model_shape *model_slit_sheet(model *m, uint32_t columns, uint32_t rows, uint32_t slit_row,
                              double radius)
{
    model whole;
    model_begin(&whole);
    const model_shape *s = model_sheet(&whole, columns, rows, radius);
    uint32_t first = slit_row * columns, last = first + columns - 1,
             doubled = s->node_count - first;
    for (uint32_t i = 0; i < 3 * s->triangle_count; i++) {
        bool above = i / 6 >= slit_row * (columns - 1);
        uint32_t *node = &s->triangles[i / 3][i % 3];
        *node += above && *node > first && *node < last ? doubled - 1 : 0;
    }
    model_shape *slit = model_mesh(m, s->node_count + columns - 2,
                                   (const uint32_t(*)[3])s->triangles, s->triangle_count, radius);
    model_end(&whole);
    return slit;
}

/* All paths over one more node, then over another, and so on. */
void model_leave_out_near(model_shape *s, const vec3 *at, double distance)
{
    size_t n = s->node_count;
    free(s->arcs);
    s->arcs = zeros(n * n, sizeof *s->arcs);
    s->near = distance;
    for (size_t i = 0; i < n * n; i++) {
        s->arcs[i] = i / n == i % n ? 0.0 : (double)INFINITY;
    }
    for (uint32_t e = 0; e < s->edge_count; e++) {
        uint32_t p = s->edges[e][0], q = s->edges[e][1];
        s->arcs[p * n + q] = s->arcs[q * n + p] = vec3_norm(vec3_sub(at[q], at[p]));
    }
    for (size_t over = 0; over < n; over++) {
        for (size_t i = 0; i < n * n; i++) {
            double path = s->arcs[i / n * n + over] + s->arcs[over * n + i % n];
            s->arcs[i] = path < s->arcs[i] ? path : s->arcs[i];
        }
    }
}

/* ---- random shapes */

static double units(harness_source *source, uint32_t bound)
{
    return MODEL_UNIT * harness_draw_below(source, bound);
}

static void draw_chain(model *m, harness_source *source)
{
    double rest[64];
    uint32_t nodes = 2 + harness_draw_below(source, 60);
    for (uint32_t i = 0; i + 1 < nodes; i++) {
        rest[i] = units(source, 4);
    }
    bool with_rest = harness_draw_below(source, 4) != 0;
    double radius = units(source, 3);
    model_chain(m, nodes, with_rest ? rest : NULL, radius);
}

/* Any triangles: some nodes are of none, some edges of many, some triangles come twice. */
static void draw_mesh(model *m, harness_source *source)
{
    uint32_t triangles[40][3], nodes = 3 + harness_draw_below(source, 30);
    uint32_t count = 1 + harness_draw_below(source, 40);
    for (uint32_t i = 0; i < count; i++) {
        uint32_t first = harness_draw_below(source, nodes);
        uint32_t step = 1 + harness_draw_below(source, nodes - 2);
        uint32_t other = 1 + harness_draw_below(source, nodes - 1 - step);
        triangles[i][0] = first;
        triangles[i][1] = (first + step) % nodes;
        triangles[i][2] = (first + step + other) % nodes;
    }
    double radius = units(source, 3);
    model_mesh(m, nodes, (const uint32_t(*)[3])triangles, count, radius);
}

void model_draw(model *m, harness_source *source)
{
    model_begin(m);
    m->config.thickness = units(source, 3);
    m->config.exclusion = 0.5 * harness_draw_below(source, 8);
    m->config.margin = units(source, 2);
    m->config.tolerance = harness_draw_below(source, 2) == 0 ? 1e-12 : 0.25;
    uint32_t count = 1 + harness_draw_below(source, 4);
    for (uint32_t i = 0; i < count; i++) {
        uint32_t kind = harness_draw_below(source, 4);
        if (kind == 0) {
            draw_chain(m, source);
        } else if (kind == 1) {
            uint32_t capsules = 1 + harness_draw_below(source, 40);
            double radius = units(source, 3);
            model_capsules(m, capsules, radius);
        } else if (kind == 2) {
            draw_mesh(m, source);
        } else {
            uint32_t columns = 2 + harness_draw_below(source, 5);
            uint32_t rows = 2 + harness_draw_below(source, 5);
            double radius = units(source, 3);
            model_sheet(m, columns, rows, radius);
        }
    }
}

static vec3 draw_step(model_motion motion, harness_source *source)
{
    if (motion == MODEL_LATTICE) {
        vec3 step;
        step.x = units(source, 3);
        step.y = units(source, 3);
        step.z = units(source, 3);
        return vec3_sub(step, vec3_make(MODEL_UNIT, MODEL_UNIT, MODEL_UNIT));
    }
    vec3 step = harness_draw_vec3(source, -3.0 * MODEL_UNIT, 3.0 * MODEL_UNIT);
    step.z = motion == MODEL_FLAT ? 0.0 : step.z;
    return motion == MODEL_ONE_POINT ? vec3_zero() : step;
}

void model_draw_motion(model *m, model_motion motion, harness_source *source)
{
    m->exact = motion == MODEL_LATTICE;
    vec3 origin = motion == MODEL_FAR ? vec3_make(1e4, -1e4, 7e3) : vec3_zero();
    for (uint32_t i = 0; i < m->count; i++) {
        model_shape *s = &m->shapes[i];
        vec3 at = origin;
        for (uint32_t node = 0; node < s->node_count; node++) {
            at = vec3_add(at, draw_step(motion, source));
            vec3 displacement = draw_step(motion, source);
            if (motion == MODEL_HUGE) {
                displacement = harness_draw_vec3(source, -100.0, 100.0);
            } else if (motion == MODEL_RESTING) {
                displacement = vec3_zero();
            }
            s->start[node] = at;
            s->end[node] = vec3_add(at, displacement);
        }
    }
}

/* ---- in an object */

void model_add_to(const model *m, vbss_collision *collision)
{
    for (uint32_t i = 0; i < m->count; i++) {
        const model_shape *s = &m->shapes[i];
        uint32_t name = UINT32_MAX;
        if (s->kind == MODEL_CHAIN) {
            expect_ok(
                vbss_collision_add_chain(collision, s->node_count, s->rest, s->radius, &name));
        } else if (s->kind == MODEL_CAPSULES) {
            expect_ok(vbss_collision_add_capsules(collision, s->edge_count, s->radius, &name));
        } else {
            expect_ok(vbss_collision_add_mesh(collision, s->node_count, s->triangles[0],
                                              s->triangle_count, s->radius, &name));
        }
        assert_int_not_equal(name, UINT32_MAX);
    }
}

void model_move(const model *m, vbss_collision *collision)
{
    for (uint32_t i = 0; i < m->count; i++) {
        const model_shape *s = &m->shapes[i];
        if (!s->removed) {
            expect_ok(vbss_collision_set_motion(collision, i, &s->start[0].x, &s->end[0].x,
                                                s->node_count));
        }
    }
}

vbss_view shapes_view(vbss_collision *collision, vbss_collision_field field)
{
    vbss_view view;
    expect_ok(vbss_collision_get_view(collision, field, &view, sizeof view));
    return view;
}

uint64_t shapes_sign_tests_ended(vbss_collision *collision)
{
    vbss_baseline_statistics statistics = {0};
    vbss_result result =
        vbss_collision_get_baseline_statistics(collision, &statistics, sizeof statistics);
    assert_true(result == VBSS_OK || result == VBSS_ERROR_INCOMPATIBLE);
    return statistics.sign_tests_ended;
}

vbss_collision_statistics shapes_statistics(vbss_collision *collision)
{
    vbss_collision_statistics statistics;
    expect_ok(vbss_collision_get_statistics(collision, &statistics, sizeof statistics));
    return statistics;
}

const candidate *shapes_find(vbss_collision *collision, uint32_t *count)
{
    expect_ok(vbss_collision_find_candidates(collision));
    vbss_view view = shapes_view(collision, VBSS_COLLISION_VIEW_CANDIDATES);
    assert_int_equal(view.stride_bytes, sizeof(candidate));
    *count = (uint32_t)view.count;
    return view.data;
}

void shapes_expect_same_list(vbss_collision *one, vbss_collision *other)
{
    vbss_view a = shapes_view(one, VBSS_COLLISION_VIEW_CANDIDATES);
    vbss_view b = shapes_view(other, VBSS_COLLISION_VIEW_CANDIDATES);
    assert_int_equal(a.count, b.count);
    assert_memory_equal(a.data, b.data, a.count * sizeof(candidate));
}
