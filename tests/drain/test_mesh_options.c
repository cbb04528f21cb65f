/* Options: what is refused, with which text; and that the same ones give the same mesh. */
#include "drain/mesh_rig.h"

#include <string.h>

/* ---- refusals */

static drain_mesh_options good(void)
{
    return mesh_rig_options(DRAIN_MESH_N);
}

static void refused(vbss_context *context, drain_mesh_options o, vbss_result wanted,
                    const char *name)
{
    drain_mesh m;
    vbss_result result;
    const char *text;
    expect_result(wanted, vbss_drain_mesh_plan(context, &o, &m));
    expect_ok(vbss_context_get_last_error(context, &result, &text));
    assert_int_equal(wanted, result);
    assert_non_null(strstr(text, name));
    assert_null(m.rest);
    assert_int_equal(0, m.node_count);
}

static void bad_numbers_are_rejected_by_name(void **state)
{
    (void)state;
    harness_memory memory;
    vbss_context *context = harness_context(&memory);
    static const char *const names[] = {"radius", "length", "slit_length", "opening", "mark_arc"};
    for (int field = 0; field < 5; field++) {
        for (int bad = 0; bad < 5; bad++) {
            drain_mesh_options o = good();
            double *fields[] = {&o.radius, &o.length, &o.slit_length, &o.opening, &o.mark_arc};
            *fields[field] = bad < 3 ? harness_bad_numbers[bad] : bad == 3 ? -1e-3 : 1.001;
            refused(context, o, bad < 3 ? VBSS_ERROR_NOT_FINITE : VBSS_ERROR_OUT_OF_RANGE,
                    names[field]);
        }
    }
    harness_context_end(context, &memory);
}

static void impossible_geometry_is_rejected(void **state)
{
    (void)state;
    harness_memory memory;
    vbss_context *context = harness_context(&memory);
    const vbss_result range = VBSS_ERROR_OUT_OF_RANGE;
    drain_mesh_options o = good();
    o.slit_length = 33e-3; /* longer than the tube */
    refused(context, o, range, "slit_length");
    o.slit_length = 0.0; /* only equal cells can be without */
    refused(context, o, range, "slit_length");
    o = good();
    o.opening = 4.1e-3; /* nearly as wide as long */
    refused(context, o, range, "opening");
    o = good();
    o.radius = 2.9e-3;
    o.length = 20e-3;
    o.mark_arc = 2e-3;
    refused(context, o, range, "opening"); /* over a third of the tube's circumference */
    o = good();
    o.slit_length = 20e-3;
    o.opening = 6.4e-3;
    o.mark_arc = 3.1e-3; /* inside the opening */
    refused(context, o, range, "mark_arc");
    o.mark_arc = 18e-3; /* on the fixed strip */
    refused(context, o, range, "mark_arc");
    o = good();
    o.length = 1.9 * o.radius;
    o.slit_length = o.radius;
    refused(context, o, range, "length");
    o = good();
    o.divisions = 0;
    refused(context, o, range, "divisions");
    o.divisions = 5;
    refused(context, o, range, "divisions");
    o = good();
    o.kind = DRAIN_MESH_KINDS;
    refused(context, o, range, "kind");
    harness_context_end(context, &memory);
}

static void nonfitting_equal_cells_are_rejected(void **state)
{
    (void)state;
    harness_memory memory;
    vbss_context *context = harness_context(&memory);
    const vbss_result range = VBSS_ERROR_OUT_OF_RANGE;
    refused(context, mesh_rig_tube(0, 12), range, "axial_cells");
    refused(context, mesh_rig_tube(513, 12), range, "axial_cells");
    refused(context, mesh_rig_tube(5, 4), range, "round_cells");
    refused(context, mesh_rig_tube(5, 1026), range, "round_cells");
    refused(context, mesh_rig_tube(5, 13), range, "odd");
    refused(context, mesh_rig_tube(512, 512), range, "number of nodes");
    refused(context, mesh_rig_tube(1, 200), range, "length of a cell");
    drain_mesh_options o = mesh_rig_tube(32, 36);
    drain_mesh m;
    o.slit_length = 10e-3;
    o.mark_arc = 40.0 * RIG_DEGREE * o.radius;
    expect_ok(vbss_drain_mesh_plan(context, &o, &m));
    o.mark_arc *= 1.001;
    refused(context, o, range, "mark_arc");
    o.mark_arc /= 1.001;
    o.slit_length *= 1.001;
    refused(context, o, range, "slit_length");
    o.slit_length = 10e-3;
    o.axial_cells = 33;
    refused(context, o, range, "mid-length");
    o.axial_cells = 2;
    refused(context, o, range, "mid-length");
    harness_context_end(context, &memory);
}

/* ---- any options */

/* Nothing that comes in makes what is no mesh: refused, or sound. */
static void any_numbers_are_refused_or_sound(harness_source *source, void *user)
{
    uint32_t *planned = user;
    drain_mesh m;
    drain_mesh_options o = mesh_rig_draw(source, true);
    double *fields[] = {&o.radius, &o.length, &o.slit_length, &o.opening, &o.mark_arc};
    double *one = fields[harness_draw_below(source, 5)];
    double factor = harness_draw_real(source, 0.0, 3.0), any = harness_draw_any_double(source);
    *one = harness_draw_below(source, 2) == 0 ? *one * factor : any;
    if (vbss_drain_mesh_plan(NULL, &o, &m) == VBSS_OK) {
        mesh_rig rig;
        mesh_rig_begin(&rig, &o);
        assert_true(mesh_rig_min_angle(&rig.mesh) > 1.5);
        assert_int_equal(m.edge_count, rig.mesh.edge_count);
        mesh_rig_end(&rig);
        ++*planned;
    }
}

static void bad_options_make_no_mesh(void **state)
{
    (void)state;
    uint32_t planned = 0;
    harness_property("any numbers", 3000, any_numbers_are_refused_or_sound, &planned);
    assert_true(planned > 200 && planned < 2800);
}

static void expect_same_parts(drain_mesh *a, drain_mesh *b)
{
    vbss_array of_a[DRAIN_MESH_ARRAYS], of_b[DRAIN_MESH_ARRAYS];
    vbss_drain_mesh_arrays(a, of_a);
    vbss_drain_mesh_arrays(b, of_b);
    for (int k = 0; k < DRAIN_MESH_ARRAYS; k++) {
        void *p, *q;
        memcpy(&p, of_a[k].pointer, sizeof p);
        memcpy(&q, of_b[k].pointer, sizeof q);
        assert_int_equal(of_a[k].count, of_b[k].count);
        assert_memory_equal(p, q, of_a[k].count * of_a[k].size);
    }
}

/* Also when the memory was used before. */
static void mesh_is_deterministic(void **state)
{
    (void)state;
    for (int kind = 0; kind < DRAIN_MESH_KINDS; kind++) {
        mesh_rig first, second;
        vbss_array parts[DRAIN_MESH_ARRAYS];
        drain_mesh_options o = kind == DRAIN_MESH_UNIFORM ? mesh_rig_tube(9, 20)
                                                          : mesh_rig_options((drain_mesh_kind)kind);
        mesh_rig_begin(&first, &o);
        mesh_rig_begin(&second, &o);
        vbss_drain_mesh_arrays(&second.mesh, parts);
        for (int k = 0; k < DRAIN_MESH_ARRAYS; k++) {
            void *block;
            memcpy(&block, parts[k].pointer, sizeof block);
            memset(block, 0x5a, parts[k].count * parts[k].size);
        }
        vbss_drain_mesh_fill(&second.mesh);
        expect_same_parts(&first.mesh, &second.mesh);
        mesh_rig_end(&first);
        mesh_rig_end(&second);
    }
}

int test_mesh_options(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(bad_numbers_are_rejected_by_name),
        cmocka_unit_test(impossible_geometry_is_rejected),
        cmocka_unit_test(nonfitting_equal_cells_are_rejected),
        harness_test(bad_options_make_no_mesh),
        cmocka_unit_test(mesh_is_deterministic),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
