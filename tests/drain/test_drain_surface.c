/* A drain with a surface of the host: a sheet bends as a plate does, each triangle has its stiffness, and the drain keeps a
 * copy. */
#include <math.h>
#include <string.h>

#include "drain/drain_rig.h"
#include "fixtures/pad.h"

#define LENGTH 40e-3
#define WIDTH 8e-3
#define THICKNESS 1e-3
#define YOUNG 1e6
#define LOAD 1e-5 /* N, of all nodes at the tip */
enum { COLUMNS = 40, ROWS = 8, CLAMPED = 2 };

static pad strip;

static void begin(drain_rig *r)
{
    drain_rig_begin(r);
    pad_make(&strip, COLUMNS, ROWS, LENGTH, WIDTH);
    pad_clamp_columns(&strip, CLAMPED);
    r->config.surface = &strip.surface;
    r->config.thickness = THICKNESS;
    r->config.young_modulus = YOUNG;
    r->config.poisson_ratio = 0.0;
    r->config.tear_stress = 1e9;
    r->config.attachment_capacity = ROWS + 1;
}

static uint32_t tip_node(uint32_t row)
{
    return COLUMNS * (ROWS + 1) + row;
}

/* Displacement of the tip's middle when the tip is loaded along y. */
static double deflection(drain_rig *r)
{
    drain_rig_statics(r);
    drain_rig_make(r);
    for (uint32_t row = 0; row <= ROWS; row++) {
        double share = (row == 0 || row == ROWS ? 0.5 : 1.0) / ROWS;
        drain_rig_force(r, tip_node(row), vec3_make(0.0, LOAD * share, 0.0));
    }
    drain_rig_relax(r, 1e-10, 2000);
    double y = drain_rig_position(r, tip_node(ROWS / 2)).y;
    drain_rig_end(r);
    return y;
}

/* F l^3 / (3 E I). Nodes have no rotations, so the clamp is in the middle of the cell between the two anchored columns. */
static double beam_deflection(double length, double thickness)
{
    double inertia = WIDTH * thickness * thickness * thickness / 12.0;
    return LOAD * length * length * length / (3.0 * YOUNG * inertia);
}

static void clamped_strip_bends_as_a_beam(void **state)
{
    (void)state;
    drain_rig r;
    begin(&r);
    const double cell = LENGTH / COLUMNS, y = deflection(&r);
    assert_true(y > beam_deflection(LENGTH - CLAMPED * cell, THICKNESS));
    assert_true(y < beam_deflection(LENGTH, THICKNESS));
    expect_near(1.0, y / beam_deflection(LENGTH - 0.5 * cell, THICKNESS), 0.02);
}

static double deflection_with(const double *thickness, const double *young)
{
    drain_rig r;
    begin(&r);
    strip.surface.thickness = thickness;
    strip.surface.young_modulus = young;
    return deflection(&r);
}

static void fill(double value)
{
    for (uint32_t t = 0; t < strip.surface.triangle_count; t++) {
        strip.values[t] = value;
    }
}

static void each_triangle_has_its_stiffness(void **state)
{
    (void)state;
    const double y = deflection_with(NULL, NULL);
    fill(THICKNESS);
    assert_true(deflection_with(strip.values, NULL) == y);
    fill(YOUNG);
    assert_true(deflection_with(NULL, strip.values) == y);
    fill(2.0 * YOUNG);
    expect_near(0.5, deflection_with(NULL, strip.values) / y, 1e-3);
    fill(2.0 * THICKNESS);
    expect_near(0.125, deflection_with(strip.values, NULL) / y, 1e-3);
    /* Half the length stiff: the rest from the middle on bends as a beam of half the length. */
    fill(YOUNG);
    for (uint32_t t = 0; t < strip.surface.triangle_count / 2; t++) {
        strip.values[t] = 1e4 * YOUNG;
    }
    expect_near(beam_deflection(0.5 * LENGTH, THICKNESS) / y,
                deflection_with(NULL, strip.values) / y, 0.01);
}

static void mass_is_that_of_the_triangles(void **state)
{
    (void)state;
    drain_rig r;
    begin(&r);
    fill(3.0 * THICKNESS);
    strip.surface.thickness = strip.values;
    strip.surface.anchor_count = 0;
    r.config.gravity[1] = -10.0;
    r.config.drag = 0.0;
    drain_rig_make(&r);
    drain_rig_run(&r, 1e-3, 10);
    const double speed = 10.0 * 10 * 1e-3, kinetic = drain_rig_energies(&r).kinetic;
    const double mass = r.config.density * LENGTH * WIDTH * 3.0 * THICKNESS;
    expect_near(1.0, kinetic / (0.5 * mass * speed * speed), 1e-9);
    drain_rig_end(&r);
}

static void drain_keeps_a_copy_of_its_surface(void **state)
{
    (void)state;
    drain_rig r;
    begin(&r);
    fill(YOUNG);
    strip.surface.young_modulus = strip.values;
    drain_rig_make(&r);
    const uint32_t nodes = strip.surface.node_count, triangles = strip.surface.triangle_count;
    assert_int_equal(nodes, r.places.node_count);
    assert_int_equal(triangles, r.places.triangle_count);
    assert_int_equal(UINT32_MAX, r.places.marks[0]);
    assert_int_equal(UINT32_MAX, r.places.gap_points[1]);
    memset(strip.positions, 0, sizeof strip.positions);
    memset(strip.triangles, 0, sizeof strip.triangles);
    memset(strip.anchors, 0, sizeof strip.anchors);
    memset(strip.values, 0, sizeof strip.values);
    const vec3 *rest = drain_rig_vectors(&r, VBSS_DRAIN_VIEW_REST_POSITIONS);
    expect_near_vec3(vec3_make(0.5 * LENGTH, 0.0, 0.5 * WIDTH), rest[nodes - 1], 1e-17);
    assert_int_equal(CLAMPED * (ROWS + 1), drain_rig_count(&r, VBSS_DRAIN_VIEW_ANCHORS));
    assert_int_equal(CLAMPED * (ROWS + 1) - 1,
                     drain_rig_numbers(&r, VBSS_DRAIN_VIEW_ANCHORS)[CLAMPED * (ROWS + 1) - 1]);
    vbss_drain_gap gap;
    expect_result(VBSS_ERROR_INCOMPATIBLE, vbss_drain_get_gap(r.drain, &gap, sizeof gap));
    drain_rig_end(&r);
}

/* ---- states */

static void state_goes_back_to_an_equal_surface_only(void **state)
{
    (void)state;
    static uint8_t bytes[200000];
    uint64_t count = 0;
    drain_rig r;
    begin(&r);
    drain_rig_make(&r);
    drain_rig_force(&r, tip_node(3), vec3_make(0.0, 0.01, 0.0));
    drain_rig_run(&r, 1e-3, 5);
    expect_ok(vbss_drain_save(r.drain, bytes, sizeof bytes, &count));
    vbss_drain *first = r.drain;
    drain_rig_make(&r);
    expect_ok(vbss_drain_restore(r.drain, bytes, count));
    drain_rig_run(&r, 1e-3, 5);
    uint64_t hash = drain_rig_hash(&r);
    expect_ok(vbss_drain_destroy(r.drain));
    r.drain = first;
    drain_rig_run(&r, 1e-3, 5);
    assert_int_equal(hash, drain_rig_hash(&r));
    expect_ok(vbss_drain_destroy(r.drain));
    strip.positions[100][1] += 1e-9;
    drain_rig_make(&r);
    expect_result(VBSS_ERROR_CORRUPT, vbss_drain_restore(r.drain, bytes, count));
    drain_rig_end(&r);
}

/* ---- refusals */

static void expect_refused(drain_rig *r, vbss_result wanted, const char *text)
{
    vbss_drain *drain = NULL;
    vbss_context_statistics before, after;
    const char *message = "";
    expect_ok(vbss_context_get_statistics(r->context, &before, sizeof before));
    expect_result(wanted, vbss_drain_create(r->context, &r->config, &drain));
    assert_null(drain);
    expect_ok(vbss_context_get_statistics(r->context, &after, sizeof after));
    assert_int_equal(before.bytes_allocated, after.bytes_allocated);
    expect_ok(vbss_context_get_last_error(r->context, NULL, &message));
    assert_non_null(strstr(message, text));
}

static void refuse_node(uint32_t triangle, uint32_t corner, uint32_t node, const char *text)
{
    drain_rig r;
    begin(&r);
    strip.triangles[triangle][corner] = node;
    expect_refused(&r, VBSS_ERROR_OUT_OF_RANGE, text);
    harness_context_end(r.context, &r.memory);
}

static void refuse_field(size_t offset, uint32_t value, vbss_result wanted, const char *text)
{
    drain_rig r;
    begin(&r);
    memcpy((char *)&strip.surface + offset, &value, sizeof value);
    expect_refused(&r, wanted, text);
    harness_context_end(r.context, &r.memory);
}

static void refuse_without(size_t offset, const char *text)
{
    drain_rig r;
    const double *none = NULL;
    begin(&r);
    memcpy((char *)&strip.surface + offset, &none, sizeof none);
    expect_refused(&r, VBSS_ERROR_NULL_ARGUMENT, text);
    harness_context_end(r.context, &r.memory);
}

static void surface_that_is_no_sheet_is_refused(void **state)
{
    (void)state;
    drain_rig r;
    refuse_node(7, 1, 5000, "triangle 7 has node 5000");
    refuse_node(7, 1, strip.triangles[7][0], "triangle 7 has a node twice");
    refuse_node(0, 2, strip.triangles[1][2], "two triangles list the edge");
    begin(&r);
    const uint32_t kept = strip.triangles[5][1];
    strip.triangles[5][1] = strip.triangles[5][2];
    strip.triangles[5][2] = kept;
    expect_refused(&r, VBSS_ERROR_OUT_OF_RANGE, "two triangles list the edge");
    harness_context_end(r.context, &r.memory);
    begin(&r);
    strip.surface.triangle_count -= 2;
    expect_refused(&r, VBSS_ERROR_OUT_OF_RANGE, "is in no triangle");
    harness_context_end(r.context, &r.memory);
    begin(&r);
    memcpy(strip.positions[20], strip.positions[19], sizeof strip.positions[19]);
    expect_refused(&r, VBSS_ERROR_OUT_OF_RANGE, "");
    harness_context_end(r.context, &r.memory);
}

static void surface_with_values_out_of_range_is_refused(void **state)
{
    (void)state;
    drain_rig r;
    refuse_field(offsetof(vbss_drain_surface, node_count), 2, VBSS_ERROR_OUT_OF_RANGE,
                 "node_count");
    refuse_field(offsetof(vbss_drain_surface, node_count), 2049, VBSS_ERROR_OUT_OF_RANGE,
                 "node_count");
    refuse_field(offsetof(vbss_drain_surface, triangle_count), 0, VBSS_ERROR_OUT_OF_RANGE,
                 "triangle_count");
    refuse_field(offsetof(vbss_drain_surface, triangle_count), 4097, VBSS_ERROR_OUT_OF_RANGE,
                 "triangle_count");
    refuse_field(offsetof(vbss_drain_surface, anchor_count), 100000, VBSS_ERROR_OUT_OF_RANGE,
                 "anchor_count");
    refuse_field(offsetof(vbss_drain_surface, struct_size), 3, VBSS_ERROR_STRUCT_SIZE, "");
    refuse_without(offsetof(vbss_drain_surface, positions), "positions");
    refuse_without(offsetof(vbss_drain_surface, triangles), "triangles");
    refuse_without(offsetof(vbss_drain_surface, anchors), "anchors");
    begin(&r);
    strip.anchors[3] = strip.anchors[2];
    expect_refused(&r, VBSS_ERROR_OUT_OF_RANGE, "which is an anchor already");
    strip.anchors[3] = strip.surface.node_count;
    expect_refused(&r, VBSS_ERROR_OUT_OF_RANGE, "which does not exist");
    strip.anchors[3] = 3;
    strip.positions[9][2] = (double)NAN;
    expect_refused(&r, VBSS_ERROR_NOT_FINITE, "positions");
    strip.positions[9][2] = 1.5;
    expect_refused(&r, VBSS_ERROR_OUT_OF_RANGE, "positions");
    harness_context_end(r.context, &r.memory);
    begin(&r);
    fill(THICKNESS);
    strip.values[11] = 0.2;
    strip.surface.thickness = strip.values;
    expect_refused(&r, VBSS_ERROR_OUT_OF_RANGE, "thickness");
    strip.surface.thickness = NULL;
    fill(YOUNG);
    strip.values[11] = 10.0;
    strip.surface.young_modulus = strip.values;
    expect_refused(&r, VBSS_ERROR_OUT_OF_RANGE, "young_modulus");
    strip.surface.young_modulus = NULL;
    r.config.method = VBSS_METHOD_VBLAST;
    expect_refused(&r, VBSS_ERROR_INCOMPATIBLE, "VBLAST");
    harness_context_end(r.context, &r.memory);
}

int test_drain_surface(void)
{
    const struct CMUnitTest tests[] = {
        harness_test(clamped_strip_bends_as_a_beam),
        harness_test(each_triangle_has_its_stiffness),
        harness_test(mass_is_that_of_the_triangles),
        harness_test(drain_keeps_a_copy_of_its_surface),
        harness_test(state_goes_back_to_an_equal_surface_only),
        harness_test(surface_that_is_no_sheet_is_refused),
        harness_test(surface_with_values_out_of_range_is_refused),
    };
    return cmocka_run_group_tests_name("drain.drain_surface", tests, NULL, NULL);
}
