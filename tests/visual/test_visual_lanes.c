/* The loops in SIMD lanes: both copies give the same bits, and a wall has those of the model that
 * computes one point at a time. */
#include "base/elementary.h"
#include "base/simd_dispatch.h"
#include "drain/drain.h"
#include "fixture.h"
#include "patch_model.h"

static visual_object *inside(vbss_visual *visual)
{
    vbss_slot *slot = NULL;
    expect_ok(vbss_slot_open(visual, &vbss_visual_kind_of_slot, &slot));
    return slot->object;
}

static drain_object *inside_drain(const vbss_drain *drain)
{
    drain_object *d = NULL;
    expect_ok(vbss_drain_open(drain, &d));
    return d;
}

/* Opens the slit and shifts each node a little, so that no two triangles are alike. */
static vbss_drain *make_drain(const fixture *f)
{
    vbss_drain_config c;
    vbss_drain *drain;
    expect_ok(vbss_drain_config_init(&c, sizeof c));
    expect_ok(vbss_drain_create(f->context, &c, &drain));
    expect_ok(vbss_visual_add_drain(f->visual, drain, NULL));
    drain_object *d = inside_drain(drain);
    for (uint32_t i = 0; i < d->mesh.node_count; i++) {
        const vec3 x = d->x[i];
        const double up = 1e-4 * vbss_sin(7.0 * i), aside = x.y > 0.0 ? 1e-3 * x.z / 5e-3 : 0.0;
        d->x[i] = vec3_add(x, vec3_make(1e-5 * vbss_cos(3.0 * i), up, aside));
    }
    return drain;
}

/* ---- both copies */

static void make_all(const fixture *f)
{
    vbss_needle *needle;
    (void)make_drain(f);
    expect_ok(vbss_visual_add_thread(f->visual, helix(f, 40, 4e-3, 2e-3, 2e-4), NULL));
    expect_ok(vbss_needle_create(f->context, NULL, &needle));
    expect_ok(vbss_visual_add_needle(f->visual, needle, NULL));
    for (int i = 0; i < 2; i++) {
        vbss_grasper_config c;
        vbss_grasper *grasper;
        expect_ok(vbss_grasper_config_init(&c, sizeof c));
        c.kind = i == 0 ? VBSS_GRASPER_KIND_NEEDLE_DRIVER : VBSS_GRASPER_KIND_SHEARS;
        expect_ok(vbss_grasper_create(f->context, &c, &grasper));
        expect_ok(vbss_visual_add_grasper(f->visual, grasper, NULL));
    }
}

static void draw_all(bool wide, double tolerance, uint32_t side_limit, fixture *f)
{
    begin(f);
    f->config.tube_tolerance *= tolerance;
    f->config.surface_tolerance *= tolerance;
    f->config.side_limit = side_limit;
    f->config.origin[0] = 0.01;
    make(f);
    make_all(f);
    inside(f->visual)->wide = wide;
    expect_ok(vbss_visual_update(f->visual));
}

static void wide_copy_gives_same_bits(void **state)
{
    (void)state;
    const double tolerances[] = {30.0, 2.0, 1.0, 0.3, 0.1};
    for (size_t i = 0; i < sizeof tolerances / sizeof *tolerances; i++) {
        fixture wide, plain;
        const uint32_t side_limit = 17 + 5 * (uint32_t)i;
        draw_all(vbss_wide_is_available(), tolerances[i], side_limit, &wide);
        draw_all(false, tolerances[i], side_limit, &plain);
        const drawn a = get_drawn(&wide), b = get_drawn(&plain);
        assert_int_equal(a.vertex_count, b.vertex_count);
        assert_int_equal(a.triangle_count, b.triangle_count);
        assert_memory_equal(a.vertices, b.vertices, a.vertex_count * sizeof *a.vertices);
        assert_memory_equal(a.triangles, b.triangles, a.triangle_count * sizeof *a.triangles);
        end(&wide);
        end(&plain);
    }
}

/* ---- the model */

typedef struct wall_view {
    const drawn *d;
    const drain_object *drain;
    const vec3 *normals; /* of nodes, in double */
    vec3 origin;
    uint32_t face_count;
} wall_view;

static void expect_vertex(const visual_vertex *v, vec3 position, vec3 normal)
{
    float wanted[6];
    visual_store(wanted, position);
    visual_store(wanted + 3, normal);
    assert_memory_equal(v->position, wanted, sizeof v->position);
    assert_memory_equal(v->normal, wanted + 3, sizeof v->normal);
}

static void expect_on_faces(const wall_view *w, uint32_t vertex, vec3 middle, vec3 normal)
{
    const double half = 0.5 * w->drain->config.thickness;
    const visual_vertex *outer = &w->d->vertices[vertex], *inner = outer + w->face_count;
    expect_vertex(outer, vec3_sub(vec3_add_scaled(middle, half, normal), w->origin), normal);
    expect_vertex(inner, vec3_sub(vec3_add_scaled(middle, -half, normal), w->origin),
                  vec3_neg(normal));
}

static model_edge edge_of(const wall_view *w, uint32_t a, uint32_t b)
{
    const vec3 x[2] = {w->drain->x[a], w->drain->x[b]}, normals[2] = {w->normals[a], w->normals[b]};
    return model_make_edge(x, normals);
}

static void expect_edges(const wall_view *w, uint32_t n)
{
    const drain_mesh *m = &w->drain->mesh;
    uint32_t vertex = m->node_count;
    const visual_vertex *rim = &w->d->vertices[2 * (size_t)w->face_count];
    const double half = 0.5 * w->drain->config.thickness;
    for (uint32_t i = 0; i < m->edge_count; i++) {
        const model_edge edge = edge_of(w, m->edges[i].nodes[0], m->edges[i].nodes[1]);
        const bool is_free = m->edges[i].triangles[1] == DRAIN_NONE;
        for (uint32_t k = 0; k <= n; k++) {
            vec3 normal, x = model_edge_point(&edge, (double)k / (double)n, &normal);
            if (k > 0 && k < n) {
                expect_on_faces(w, vertex++, x, normal);
            }
            if (is_free) {
                const vec3 chord = vec3_sub(edge.corner[1], edge.corner[0]);
                const vec3 out = vec3_unit_or(vec3_cross(chord, normal), normal);
                expect_vertex(rim++, vec3_sub(vec3_add_scaled(x, half, normal), w->origin), out);
                expect_vertex(rim++, vec3_sub(vec3_add_scaled(x, -half, normal), w->origin), out);
            }
        }
    }
}

static void expect_interior(const wall_view *w, uint32_t n)
{
    const drain_mesh *m = &w->drain->mesh;
    uint32_t vertex = m->node_count + m->edge_count * (n - 1);
    for (uint32_t t = 0; t < m->triangle_count; t++) {
        const uint32_t *node = m->triangles[t];
        const model_edge edges[3] = {edge_of(w, node[0], node[1]), edge_of(w, node[1], node[2]),
                                     edge_of(w, node[2], node[0])};
        const model_patch patch = model_make_patch(edges);
        for (uint32_t i = 1; i + 1 < n; i++) {
            for (uint32_t k = 1; i + k < n; k++) {
                const double weights[3] = {(double)(n - i - k) / (double)n, (double)i / (double)n,
                                           (double)k / (double)n};
                vec3 normal, x = model_patch_point(&patch, weights, &normal);
                expect_on_faces(w, vertex++, x, normal);
            }
        }
    }
}

static void walls_are_those_of_model(void **state)
{
    (void)state;
    const double tolerances[] = {4e-4, 1e-4, 2e-5, 6e-6};
    for (size_t i = 0; i < sizeof tolerances / sizeof *tolerances; i++) {
        fixture f;
        begin(&f);
        f.config.surface_tolerance = tolerances[i];
        f.config.origin[1] = -0.02;
        make(&f);
        const vbss_drain *drain = make_drain(&f);
        const drawn d = draw(&f);
        const visual_object *v = inside(f.visual);
        const drain_mesh *m = &inside_drain(drain)->mesh;
        const uint32_t n = v->frames[v->front].walls[0].divisions;
        const wall_view w = {&d, inside_drain(drain), v->node_vectors, v->origin,
                             m->node_count + m->edge_count * (n - 1) +
                                 m->triangle_count * visual_interior_vertices(n)};
        for (uint32_t k = 0; k < m->node_count; k++) {
            expect_on_faces(&w, k, w.drain->x[k], w.normals[k]);
        }
        expect_edges(&w, n);
        expect_interior(&w, n);
        end(&f);
    }
}

int test_visual_lanes(void)
{
    const struct CMUnitTest tests[] = {
        harness_test(wide_copy_gives_same_bits),
        harness_test(walls_are_those_of_model),
    };
    return cmocka_run_group_tests_name("visual.visual_lanes", tests, NULL, NULL);
}
