/* The wall of a drain: closed, smooth, as thick as it is, with marks where they are. */
#include "base/elementary.h"
#include "drain/drain.h"
#include "fixture.h"
#include "patch_model.h"

static drain_object *inside(const vbss_drain *drain)
{
    drain_object *d = NULL;
    expect_ok(vbss_drain_open(drain, &d));
    return d;
}

static vbss_drain *make_drain(const fixture *f)
{
    vbss_drain_config c;
    vbss_drain *drain;
    expect_ok(vbss_drain_config_init(&c, sizeof c));
    expect_ok(vbss_drain_create(f->context, &c, &drain));
    expect_ok(vbss_visual_add_drain(f->visual, drain, NULL));
    return drain;
}

/* From the axis. */
static double from_axis(vec3 p)
{
    return sqrt(p.y * p.y + p.z * p.z);
}

static double value_of(const drawn *d, uint32_t vertex)
{
    return (double)d->vertices[vertex].value;
}

static void wall_mesh_is_closed_at_any_subdivision(void **state)
{
    (void)state;
    for (uint32_t limit = 1; limit <= 12; limit++) {
        fixture f;
        begin(&f);
        f.config.surface_tolerance = 1e-6;
        f.config.division_limit = limit;
        f.config.vertex_capacity = 200000;
        f.config.triangle_capacity = 200000;
        make(&f);
        const drain_mesh *m = &inside(make_drain(&f))->mesh;
        const drawn d = draw(&f);
        expect_sound(&d, &d.parts[0]);
        assert_int_equal(d.part_count, 1);
        assert_int_equal(d.parts[0].kind, VBSS_VISUAL_KIND_DRAIN);
        uint32_t rims = 0;
        for (uint32_t i = 0; i < m->edge_count; i++) {
            rims += m->edges[i].triangles[1] == DRAIN_NONE;
        }
        assert_int_equal(d.triangle_count,
                         2 * m->triangle_count * limit * limit + 2 * rims * limit);
        end(&f);
    }
}

/* Of a tube that is a cylinder at rest: both faces are half a wall from the middle, and normals are radii. */
static void faces_are_half_wall_thickness_from_cylinder(void **state)
{
    (void)state;
    fixture f;
    begin(&f);
    make(&f);
    const drain_object *drain = inside(make_drain(&f));
    const drain_mesh *m = &drain->mesh;
    const double radius = drain->config.radius, half = 0.5 * drain->config.thickness;
    const drawn d = draw(&f);
    double worst = 0.0, leaning = 0.0;
    for (uint32_t i = 0; i < d.vertex_count; i++) {
        vec3 p = position_of(&d, i), n = normal_of(&d, i);
        double side = value_of(&d, i);
        if (side == 0.0) {
            continue;
        }
        worst = vbss_max(worst, fabs(from_axis(p) - radius - side * half));
        vec3 out = vec3_scale(vec3_make(0.0, p.y, p.z), side / from_axis(p));
        leaning = vbss_max(leaning, vec3_distance(n, out));
    }
    /* Nodes at ends and lips see triangles on one side only, which lean by half of what a cell turns. */
    assert_true(worst < 1.5e-4);
    assert_true(leaning < 0.35);
    for (uint32_t i = 0; i < m->node_count; i++) { /* the middle goes through the nodes */
        vec3 p = position_of(&d, i), n = normal_of(&d, i);
        assert_true(vec3_distance(vec3_add_scaled(p, -half, n), drain->x[i]) < 2e-9);
    }
    end(&f);
}

/* Into how many parts each way triangles were divided. */
static uint32_t divisions_of(const drawn *d, const drain_mesh *m)
{
    uint32_t n = 1, rims = 0;
    for (uint32_t i = 0; i < m->edge_count; i++) {
        rims += m->edges[i].triangles[1] == DRAIN_NONE;
    }
    while (2 * m->triangle_count * n * n + 2 * rims * n < d->triangle_count) {
        n++;
    }
    return n;
}

/* Of the curved sides of patches from the chords that are drawn. */
static double deviation(const drawn *d, const drain_object *drain)
{
    const drain_mesh *m = &drain->mesh;
    const uint32_t n = divisions_of(d, m);
    double worst = 0.0;
    for (uint32_t i = 0; i < m->edge_count; i++) {
        const uint32_t *node = m->edges[i].nodes;
        const vec3 x[2] = {drain->x[node[0]], drain->x[node[1]]};
        const vec3 normals[2] = {normal_of(d, node[0]), normal_of(d, node[1])};
        const model_edge side = model_make_edge(x, normals);
        for (uint32_t k = 0; k < 20 * n; k++) {
            vec3 normal;
            const uint32_t part = k / 20;
            double share = (double)k / (20.0 * n), step = 1.0 / n, from = step * part;
            vec3 a = model_edge_point(&side, from, &normal);
            vec3 b = model_edge_point(&side, from + step, &normal);
            vec3 chord = vec3_lerp(a, b, (share - from) / step);
            vec3 curve = model_edge_point(&side, share, &normal);
            worst = vbss_max(worst, vec3_distance(chord, curve));
        }
    }
    return worst;
}

static void surface_tolerance_holds(void **state)
{
    (void)state;
    const double tolerances[4] = {4e-4, 1e-4, 2.5e-5, 6e-6};
    for (int i = 0; i < 4; i++) {
        fixture f;
        begin(&f);
        f.config.surface_tolerance = tolerances[i];
        make(&f);
        const drain_object *drain = inside(make_drain(&f));
        const drawn d = draw(&f);
        double worst = deviation(&d, drain);
        assert_true(worst < tolerances[i]);
        if (divisions_of(&d, &drain->mesh) > 2) {
            assert_true(worst > 0.2 * tolerances[i]); /* and no finer than they need to be */
        }
        end(&f);
    }
}

static void rims_have_wall_width_and_face_outward(void **state)
{
    (void)state;
    fixture f;
    begin(&f);
    make(&f);
    const drain_object *drain = inside(make_drain(&f));
    const drawn d = draw(&f);
    uint32_t rims = 0, lips = 0, ends = 0;
    for (uint32_t i = 0; i + 1 < d.vertex_count; i++) {
        if (value_of(&d, i) != 0.0 || value_of(&d, i + 1) != 0.0 || (rims++ & 1) != 0) {
            continue;
        }
        vec3 across = vec3_sub(position_of(&d, i), position_of(&d, i + 1));
        vec3 n = normal_of(&d, i);
        expect_near(drain->config.thickness, vec3_norm(across), 1e-8);
        assert_true(fabs(vec3_dot(across, n)) < 0.05 * drain->config.thickness);
        vec3 p = position_of(&d, i);
        if (fabs(fabs(material_of(&d, i).x) - 0.5 * drain->config.length) < 1e-6) {
            ends++;
            assert_true(n.x * p.x > 0.99 * fabs(p.x));
        } else { /* of a lip: toward the other one */
            lips++;
            assert_true(n.z * p.z <= 1e-12);
        }
    }
    assert_true(ends > 40);
    assert_true(lips > 40);
    end(&f);
}

/* Vertices know where they were; linear between those of a triangle, as places of holes are. */
static void material_coordinates_are_of_rest_nodes(void **state)
{
    (void)state;
    fixture f;
    begin(&f);
    make(&f);
    vbss_drain *handle = make_drain(&f);
    const drain_object *drain = inside(handle);
    const drain_mesh *m = &drain->mesh;
    double x[3 * 256];
    assert_in_range(m->node_count, 100, 256);
    for (uint32_t i = 0; i < m->node_count; i++) { /* moved as a whole where it is not held */
        vec3_store(
            x + 3 * (size_t)i,
            vec3_add(drain->x[i], drain->anchored[i] ? vec3_zero() : vec3_make(0.0, 1e-4, 0.0)));
    }
    expect_ok(vbss_drain_set_state(handle, x, NULL, m->node_count));
    const drawn d = draw(&f);
    for (uint32_t i = 0; i < m->node_count; i++) {
        assert_true(vec3_distance(material_of(&d, i), m->rest[i]) < 1e-9);
        expect_near(m->rest[i].x, (double)d.vertices[i].texture[0], 1e-9);
        expect_near(fabs(m->material_coordinates[i][0]), (double)d.vertices[i].texture[1], 1e-9);
    }
    assert_int_equal(d.decal_count, 2);
    for (int side = 0; side < 2; side++) {
        const visual_decal *s = &d.decals[side];
        vec3 at = vec3_make((double)s->material[0], (double)s->material[1], (double)s->material[2]);
        assert_true((double)s->kind == VBSS_VISUAL_SPOT_MARK && (double)s->part == 0.0);
        assert_true(vec3_distance(at, m->rest[m->marks[side]]) < 1e-9);
        expect_near(f.config.mark_radius, (double)s->radius, 1e-9);
    }
    end(&f);
}

/* Pushed out of shape it stays closed; deep dents are not turned over. */
static void dented_wall_is_valid(void **state)
{
    (void)state;
    fixture f;
    begin(&f);
    make(&f);
    vbss_drain *handle = make_drain(&f);
    const drain_object *drain = inside(handle);
    const drain_mesh *m = &drain->mesh;
    double x[3 * 256];
    for (int deep = 1; deep <= 4; deep++) {
        for (uint32_t i = 0; i < m->node_count; i++) {
            vec3 p = m->rest[i];
            double near = vbss_exp(-(p.x * p.x + (p.z - 5e-3) * (p.z - 5e-3)) / 16e-6);
            double down = drain->anchored[i] || p.y < 0.0 ? 0.0 : 5e-4 * deep * near;
            vec3_store(x + 3 * (size_t)i, vec3_make(p.x, p.y - down, p.z));
        }
        expect_ok(vbss_drain_set_state(handle, x, NULL, m->node_count));
        const drawn d = draw(&f);
        expect_sound(&d, &d.parts[0]);
    }
    end(&f);
}

int test_visual_drain(void)
{
    const struct CMUnitTest tests[] = {
        harness_test(wall_mesh_is_closed_at_any_subdivision),
        harness_test(faces_are_half_wall_thickness_from_cylinder),
        harness_test(surface_tolerance_holds),
        harness_test(rims_have_wall_width_and_face_outward),
        harness_test(material_coordinates_are_of_rest_nodes),
        harness_test(dented_wall_is_valid),
    };
    return cmocka_run_group_tests_name("visual.visual_drain", tests, NULL, NULL);
}
