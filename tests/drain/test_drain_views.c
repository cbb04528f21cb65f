/* What a drain shows: arrays, places, the gap, strains, triangles that are turned over. */
#include <math.h>
#include <string.h>

#include "drain/drain_rig.h"

static vbss_view view_of(drain_rig *r, vbss_drain_field field)
{
    vbss_view view;
    expect_ok(vbss_drain_get_view(r->drain, field, &view, sizeof view));
    return view;
}

/* ---- arrays */

static void view_dimensions(void **state)
{
    (void)state;
    const struct {
        uint32_t nodes, triangles;
    } wanted[] = {{137, 240}, {159, 280}, {181, 320}, {225, 400}};
    for (int mesh = 0; mesh < 4; mesh++) {
        uint32_t n = wanted[mesh].nodes, m = wanted[mesh].triangles;
        const struct {
            vbss_view_type type;
            uint32_t components;
            uint64_t count;
        } fields[] = {{VBSS_VIEW_TYPE_F64, 3, n},  {VBSS_VIEW_TYPE_F64, 3, n},
                      {VBSS_VIEW_TYPE_F64, 3, n},  {VBSS_VIEW_TYPE_U32, 3, m},
                      {VBSS_VIEW_TYPE_U32, 1, 7},  {VBSS_VIEW_TYPE_U32, 1, 7},
                      {VBSS_VIEW_TYPE_U32, 1, 33}, {VBSS_VIEW_TYPE_F64, 3, 33},
                      {VBSS_VIEW_TYPE_F64, 3, m},  {VBSS_VIEW_TYPE_F64, 3, m}};
        drain_rig r;
        drain_rig_begin(&r);
        r.config.mesh = mesh;
        drain_rig_make(&r);
        assert_int_equal(r.places.node_count, n);
        assert_int_equal(r.places.triangle_count, m);
        for (vbss_drain_field f = VBSS_DRAIN_VIEW_POSITIONS; f <= VBSS_DRAIN_VIEW_CURVATURES; f++) {
            vbss_view view = view_of(&r, f);
            assert_int_equal(view.type, fields[f].type);
            assert_int_equal(view.components, fields[f].components);
            assert_int_equal(view.count, fields[f].count);
            uint32_t item = view.type == VBSS_VIEW_TYPE_F64 ? sizeof(double) : sizeof(uint32_t);
            assert_int_equal(view.stride_bytes, view.components * item);
            assert_non_null(view.data);
        }
        drain_rig_end(&r);
    }
}

static void generation_changes_with_every_step_and_edit(void **state)
{
    (void)state;
    drain_rig r;
    uint8_t bytes[32768];
    uint64_t seen[9], written;
    drain_rig_begin(&r);
    drain_rig_make(&r);
    expect_ok(vbss_drain_save(r.drain, bytes, sizeof bytes, &written));
    for (int k = 0; k < 9; k++) {
        uint32_t mark = r.places.marks[0];
        switch (k) {
        case 1:
            drain_rig_run(&r, 1e-3, 1);
            break;
        case 2:
            drain_rig_pin_here(&r, mark);
            break;
        case 3:
            drain_rig_move(&r, 1, drain_rig_position(&r, mark));
            break;
        case 4:
            drain_rig_detach(&r, 1);
            break;
        case 5:
            expect_ok(vbss_drain_set_state(r.drain, NULL, NULL, r.places.node_count));
            break;
        case 6:
            expect_ok(vbss_drain_restore(r.drain, bytes, written));
            break;
        default:
            break;
        }
        seen[k] = view_of(&r, k % 2 == 0 ? VBSS_DRAIN_VIEW_POSITIONS : VBSS_DRAIN_VIEW_STRAINS)
                      .generation;
        assert_true(k == 0 || (seen[k] != seen[k - 1]) == (k <= 6));
    }
    expect_result(VBSS_ERROR_OUT_OF_RANGE, vbss_drain_step(r.drain, 0.0));
    assert_true(view_of(&r, VBSS_DRAIN_VIEW_POSITIONS).generation == seen[8]);
    drain_rig_end(&r);
}

/* ---- places */

/* Marks and the middles of the edges face each other across the slit; a mark's arc is 4.5 mm before the opening. */
static void reference_points_are_placed_correctly(void **state)
{
    (void)state;
    drain_rig r;
    drain_rig_begin(&r);
    drain_rig_make(&r);
    const uint32_t *left = drain_rig_numbers(&r, VBSS_DRAIN_VIEW_SLIT_LEFT);
    const uint32_t *right = drain_rig_numbers(&r, VBSS_DRAIN_VIEW_SLIT_RIGHT);
    const vec3 *x = drain_rig_vectors(&r, VBSS_DRAIN_VIEW_POSITIONS);
    assert_int_equal(r.places.gap_points[0], left[3]);
    assert_int_equal(r.places.gap_points[1], right[3]);
    for (int k = 0; k < 7; k++) {
        bool tip = k == 0 || k == 6;
        assert_true((left[k] == right[k]) == tip);
        assert_true(k == 0 || x[left[k]].x > x[left[k - 1]].x);
        assert_true(tip ? x[left[k]].z == 0.0 : x[left[k]].z < 0.0);
        expect_near_vec3(vec3_make(x[left[k]].x, x[left[k]].y, -x[left[k]].z), x[right[k]], 0.0);
    }
    expect_near(-5e-3, x[left[0]].x, 1e-15);
    vec3 mark = x[r.places.marks[1]];
    expect_near(0.0, mark.x, 1e-15);
    assert_true(mark.z > 4.5e-3 && mark.z < 4.7e-3 && mark.y > 0.0);
    expect_near_vec3(vec3_make(mark.x, mark.y, -mark.z), x[r.places.marks[0]], 0.0);
    /* The strip: 25 degrees to either side of the bottom. */
    double edge = 6.5e-3 * sin(25.0 / 180.0 * 3.14159265358979323846);
    const uint32_t *anchors = drain_rig_numbers(&r, VBSS_DRAIN_VIEW_ANCHORS);
    for (int k = 0; k < 33; k++) {
        assert_true(x[anchors[k]].y < -5.8e-3 && fabs(x[anchors[k]].z) < edge + 1e-12);
    }
    drain_rig_end(&r);
}

/* ---- the gap */

static void gap_at_rest_is_chord_of_opening(void **state)
{
    (void)state;
    drain_rig r;
    drain_rig_begin(&r);
    drain_rig_make(&r);
    vbss_drain_gap gap = drain_rig_gap(&r);
    double chord = 2.0 * 6.5e-3 * sin(1.5 / 6.5);
    expect_near(2.973e-3, chord, 1e-6);
    expect_near(chord, gap.gap, 1e-12);
    expect_near(chord, gap.signed_gap, 1e-12);
    expect_near(chord, gap.largest, 1e-12);
    assert_int_equal(gap.largest_pair, 3); /* the middle one of seven */
    drain_rig_end(&r);
}

/* Wherever the drain stands: its own frame says which side is which. */
static void crossed_edges_have_negative_gap(void **state)
{
    (void)state;
    drain_rig r;
    uint32_t ids[2];
    vec3 from[2];
    drain_rig_begin(&r);
    r.config.orientation[2] = 5.0; /* nearly turned round */
    r.config.position[0] = 0.1;
    drain_rig_make(&r);
    for (int side = 0; side < 2; side++) {
        from[side] = drain_rig_position(&r, r.places.gap_points[side]);
        ids[side] = drain_rig_pin_here(&r, r.places.gap_points[side]);
    }
    double apart = vec3_distance(from[0], from[1]);
    for (int step = 1; step <= 60; step++) { /* each goes 2/3 of the way: they pass in the middle */
        double share = step / 90.0;
        for (int side = 0; side < 2; side++) {
            drain_rig_move(&r, ids[side], vec3_lerp(from[side], from[1 - side], share));
        }
        drain_rig_run(&r, 1e-3, 1);
        vbss_drain_gap gap = drain_rig_gap(&r);
        expect_near(apart * (1.0 - 2.0 * share), gap.signed_gap, 1e-12);
        expect_near(fabs(gap.signed_gap), gap.gap, 1e-12);
        assert_true(gap.largest >= gap.gap);
        assert_true(step != 45 || (gap.largest_pair != 3 && gap.largest > 1e-4));
    }
    drain_rig_end(&r);
}

/* ---- the lips */

/* Their inner ends. A facet beside the edge leans as the tube does in its middle, not at the edge. */
static void lip_gap_at_rest_is_between_inner_ends(void **state)
{
    (void)state;
    drain_rig r;
    drain_rig_begin(&r);
    drain_rig_make(&r);
    vbss_drain_gap gap = drain_rig_gap(&r);
    vec3 left = vec3_load(gap.lips[0]), right = vec3_load(gap.lips[1]);
    expect_near(2.0 * 6.0e-3 * sin(1.5 / 6.5), gap.opening, 0.15e-3);
    expect_near(gap.opening, vec3_distance(left, right), 1e-15);
    assert_true(gap.widest_opening >= gap.opening);
    expect_near_vec3(vec3_make(left.x, left.y, -left.z), right, 1e-12);
    assert_true(left.z < 0.0 && left.y < drain_rig_position(&r, r.places.gap_points[0]).y);
    drain_rig_end(&r);
}

/* The triangles beside the middles of the edges, their nodes pinned where the walls stand upright, so far from the plane between
 * them: what is apart there is twice that less a wall, whatever the middles say. */
static void set_upright(drain_rig *r, double from_plane)
{
    const uint32_t(*triangles)[3] =
        (const uint32_t(*)[3])drain_rig_numbers(r, VBSS_DRAIN_VIEW_TRIANGLES);
    for (uint32_t n = 0; n < r->places.node_count; n++) {
        bool beside[2] = {false, false};
        for (uint32_t t = 0; t < r->places.triangle_count; t++) {
            for (int side = 0; side < 2; side++) {
                uint32_t middle = r->places.gap_points[side];
                bool has_middle = false, has = false;
                for (int k = 0; k < 3; k++) {
                    has_middle = has_middle || triangles[t][k] == middle;
                    has = has || triangles[t][k] == n;
                }
                beside[side] = beside[side] || (has_middle && has);
            }
        }
        if (beside[0] || beside[1]) {
            vec3 at = drain_rig_position(r, n);
            drain_rig_pin(r, n, vec3_make(at.x, at.y, beside[0] ? -from_plane : from_plane));
        }
    }
    drain_rig_run(r, 1e-3, 1);
}

static void facing_lip_gap_is_wall_free_distance(void **state)
{
    (void)state;
    const double walls = 1e-3, apart[] = {0.2e-3, 1e-3};
    for (int i = 0; i < 2; i++) {
        drain_rig r;
        drain_rig_begin(&r);
        r.config.attachment_capacity = 32;
        drain_rig_make(&r);
        set_upright(&r, 0.5 * (walls + apart[i]));
        vbss_drain_gap gap = drain_rig_gap(&r);
        expect_near(walls + apart[i], gap.gap, 1e-12);
        expect_near(apart[i], gap.opening, 1e-12);
        assert_true(gap.widest_opening >= gap.opening);
        drain_rig_end(&r);
    }
}

/* ---- strains */

static void strain_at_rest_is_zero(void **state)
{
    (void)state;
    drain_rig r;
    drain_rig_begin(&r);
    r.config.orientation[3] = 0.4;
    drain_rig_make(&r);
    const vec3 *strains = drain_rig_vectors(&r, VBSS_DRAIN_VIEW_STRAINS);
    const vec3 *curvatures = drain_rig_vectors(&r, VBSS_DRAIN_VIEW_CURVATURES);
    for (uint32_t t = 0; t < r.places.triangle_count; t++) {
        expect_near_vec3(vec3_zero(), strains[t], 1e-14);
        expect_near_vec3(vec3_zero(), curvatures[t], 1e-9);
    }
    expect_near(0.0, drain_rig_energies(&r).total, 1e-28);
    drain_rig_end(&r);
}

/* Relative errors of strains, and of the membrane's energy, of a drain that has grown by a factor and been turned. */
typedef struct grown {
    double along, shear, energy;
} grown;

static grown grow(vbss_drain_mesh mesh, uint32_t divisions, double factor)
{
    static vec3 x[DRAIN_RIG_NODES];
    static double areas[DRAIN_RIG_NODES];
    drain_rig r;
    double area = 0.0, strain = 0.5 * (factor * factor - 1.0);
    grown worst = {0.0, 0.0, 0.0};
    drain_rig_begin(&r);
    r.config.tear_stress = 1.0;
    r.config.mesh = mesh;
    r.config.mesh_divisions = divisions;
    drain_rig_make(&r);
    drain_rig_tear_off(&r);
    drain_rig_areas(&r, areas);
    quat turned = quat_unit(quat_make(0.3, -0.5, 0.7, 0.2));
    const vec3 *rest = drain_rig_vectors(&r, VBSS_DRAIN_VIEW_REST_POSITIONS);
    for (uint32_t i = 0; i < r.places.node_count; i++) {
        x[i] = quat_rotate(turned, vec3_scale(rest[i], factor));
        area += areas[i];
    }
    expect_ok(vbss_drain_set_state(r.drain, &x[0].x, NULL, r.places.node_count));
    const vec3 *strains = drain_rig_vectors(&r, VBSS_DRAIN_VIEW_STRAINS);
    for (uint32_t t = 0; t < r.places.triangle_count; t++) {
        worst.along = fmax(worst.along, fabs(strains[t].x / strain - 1.0));
        worst.along = fmax(worst.along, fabs(strains[t].y / strain - 1.0));
        worst.shear = fmax(worst.shear, fabs(strains[t].z / strain));
    }
    /* Plane stress: E t / (1 - nu) of the energy of both strains. */
    double energy = r.config.young_modulus * r.config.thickness / (1.0 - r.config.poisson_ratio) *
                    strain * strain * area;
    worst.energy = fabs(drain_rig_energies(&r).membrane / energy - 1.0);
    assert_int_equal(drain_rig_statistics(&r).inverted, 0);
    drain_rig_end(&r);
    return worst;
}

/* (factor^2 - 1) / 2 of Green's strain everywhere, no shear; but for what the fold between two triangles takes from the
 * tangents at the middle of their side, which falls with the square of the cells. */
static void uniform_growth_has_uniform_strain(void **state)
{
    (void)state;
    const double factors[] = {1.1, 0.9};
    for (int k = 0; k < 2; k++) {
        grown coarse = grow(VBSS_DRAIN_MESH_137, 1, factors[k]);
        grown fine = grow(VBSS_DRAIN_MESH_137, 2, factors[k]);
        assert_true(coarse.along < 0.05 && coarse.shear < 0.05 && coarse.energy < 0.03);
        assert_true(fine.along < 0.35 * coarse.along);
        assert_true(fine.shear < 0.35 * coarse.shear);
        assert_true(fine.energy < 0.35 * coarse.energy);
    }
}

/* A pulse of speed on one node, weighed: kinetic energy of lumped masses; and height under gravity. */
static void kinetic_energy_is_of_lumped_masses(void **state)
{
    (void)state;
    static vec3 v[DRAIN_RIG_NODES];
    double masses[DRAIN_RIG_NODES], potential = 0.0;
    drain_rig r;
    drain_rig_begin(&r);
    r.config.gravity[1] = -9.81;
    r.config.position[1] = 0.5;
    drain_rig_make(&r);
    drain_rig_masses(&r, masses);
    v[r.places.marks[0]] = vec3_make(0.3, 0.4, 0.0);
    expect_ok(vbss_drain_set_state(r.drain, NULL, &v[0].x, r.places.node_count));
    const vec3 *x = drain_rig_vectors(&r, VBSS_DRAIN_VIEW_POSITIONS);
    for (uint32_t i = 0; i < r.places.node_count; i++) {
        potential += 9.81 * masses[i] * x[i].y;
    }
    vbss_drain_energies e = drain_rig_energies(&r);
    expect_near(0.125 * masses[r.places.marks[0]], e.kinetic, 1e-12 * e.kinetic);
    expect_near(potential, e.gravity, 1e-12 * potential);
    expect_near(e.kinetic + e.membrane + e.bending + e.springs + e.gravity, e.total, 1e-18);
    drain_rig_end(&r);
}

/* ---- turned over */

static void inverted_triangles_are_counted(void **state)
{
    (void)state;
    static vec3 x[DRAIN_RIG_NODES];
    drain_rig r;
    drain_rig_begin(&r);
    drain_rig_make(&r);
    drain_rig_copy(&r, x);
    assert_int_equal(drain_rig_statistics(&r).inverted, 0);
    uint32_t mark = r.places.marks[0], nodes = r.places.node_count;
    vec3 place = x[mark];
    /* Pushed in, a wall dents; it is still the same way round. */
    x[mark] = vec3_scale(place, 0.8);
    expect_ok(vbss_drain_set_state(r.drain, &x[0].x, NULL, nodes));
    assert_int_equal(drain_rig_statistics(&r).inverted, 0);
    /* Across the slit and beyond the other edge: triangles fold over. */
    x[mark] = vec3_make(place.x, place.y, -place.z);
    expect_ok(vbss_drain_set_state(r.drain, &x[0].x, NULL, nodes));
    assert_in_range(drain_rig_statistics(&r).inverted, 2, 20);
    /* On a neighbour: a triangle without area. */
    x[mark] = x[r.places.gap_points[0]];
    expect_ok(vbss_drain_set_state(r.drain, &x[0].x, NULL, nodes));
    assert_in_range(drain_rig_statistics(&r).inverted, 1, 20);
    x[mark] = place;
    expect_ok(vbss_drain_set_state(r.drain, &x[0].x, NULL, nodes));
    assert_int_equal(drain_rig_statistics(&r).inverted, 0);
    drain_rig_end(&r);
}

int test_drain_views(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(view_dimensions),
        cmocka_unit_test(generation_changes_with_every_step_and_edit),
        cmocka_unit_test(reference_points_are_placed_correctly),
        cmocka_unit_test(gap_at_rest_is_chord_of_opening),
        cmocka_unit_test(crossed_edges_have_negative_gap),
        cmocka_unit_test(lip_gap_at_rest_is_between_inner_ends),
        cmocka_unit_test(facing_lip_gap_is_wall_free_distance),
        cmocka_unit_test(strain_at_rest_is_zero),
        cmocka_unit_test(uniform_growth_has_uniform_strain),
        cmocka_unit_test(kinetic_energy_is_of_lumped_masses),
        cmocka_unit_test(inverted_triangles_are_counted),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
