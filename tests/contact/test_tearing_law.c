/* A sleeve whose wall can tear: its transverse spring yields at the force that tears, with a damper in series, and by no more than
 * its largest slip. */
#include "base/elementary.h"
#include "few_blocks.h"

static const double k = FEW_SLEEVE_STIFFNESS;

/* The wall is across the suture, or askew. */
static contact_constraint any_row(harness_source *source, bool is_askew)
{
    vec3 normal = vec3_unit_or(harness_draw_vec3(source, -1.0, 1.0), vec3_make(1.0, 0.0, 0.0));
    contact_constraint row = few_sleeve(normal);
    row.viscous_stiffness = harness_draw_real(source, 10.0, 2e3);
    row.relative_displacement = harness_draw_vec3(source, -1e-4, 1e-4);
    row.previous_force = vec3_scale(normal, harness_draw_real(source, -1.0, 1.0));
    row.tear_force = harness_draw_real(source, 0.2, 1.0);
    row.max_tear_slip = harness_draw_real(source, 1e-5, 1e-4);
    row.wall_normal = normal;
    if (is_askew) {
        row.wall_normal =
            vec3_unit_or(vec3_add(normal, harness_draw_vec3(source, -0.5, 0.5)), normal);
    }
    return row;
}

static double in_plane(const contact_constraint *row, vec3 v)
{
    return vec3_norm(across(v, row->wall_normal));
}

/* In closed form, by the slip y of the spring: k (stretch - y) = limit + viscous y, up to the largest slip. */
static void any_sleeve_yields_at_its_limit(harness_source *source, void *user)
{
    int *seen = user;
    contact_solution next;
    const contact_constraint row = any_row(source, true);
    const vec3 stretch = across(row.relative_displacement, row.normal);
    const double size = vec3_norm(stretch);
    const vec3 back = vec3_scale(stretch, -1.0 / size);
    const double limit = row.tear_force / in_plane(&row, back);
    double slip = fmax(k * size - limit, 0.0) / (k + row.viscous_stiffness);
    const int state = slip == 0.0 ? 0 : slip < row.max_tear_slip ? 1 : 2;
    slip = fmin(slip, row.max_tear_slip);
    (void)vbss_contact_update_solution(&row, vec3_zero(), &next);
    const vec3 wanted = vec3_scale(back, k * (size - slip));
    expect_near(0.0, vec3_distance(wanted, next.tangential_force), 1e-9);
    expect_near(0.0, vec3_distance(vec3_scale(back, -slip), vbss_contact_tear_slip(&row)), 1e-13);
    assert_int_equal(state > 0, next.tear_limit > 0.0);
    assert_int_equal(state == 2, next.is_tear_capped);
    /* It gives the cut at least its energy: force in the plane times the path in the plane. */
    const double work = vec3_norm(next.tangential_force) * slip, path = slip / in_plane(&row, back);
    assert_true(work >= row.tear_force * path * (1.0 - 1e-12));
    seen[state]++;
}

static void yields_at_its_limit(void **state)
{
    (void)state;
    int seen[3] = {0};
    harness_property("tearing law", 1000, any_sleeve_yields_at_its_limit, seen);
    for (int i = 0; i < 3; i++) {
        assert_true(seen[i] > 50);
    }
}

/* Where the wall is across the suture; askew, the limit turns with the direction, which the tangent leaves out. */
static void any_tangent_is_the_slope(harness_source *source, void *user)
{
    int *seen = user;
    contact_constraint row = any_row(source, false);
    contact_linearisation t;
    (void)vbss_contact_update_solution(&row, vec3_zero(), &row.solution);
    contact_solution there;
    expect_near(0.0, vbss_contact_update_solution(&row, vec3_zero(), &there), 0.0);
    const double elastic = k * vec3_norm(across(row.relative_displacement, row.normal)),
                 slip = (elastic - row.tear_force) / (k + row.viscous_stiffness);
    if (fabs(elastic - row.tear_force) < 0.01 || fabs(slip - row.max_tear_slip) < 1e-7) {
        return; /* the slope has a step there */
    }
    vbss_contact_linearise(&row, &t);
    expect_near(0.0, vec3_distance(t.force, vbss_contact_force(&row, vec3_zero())), 1e-12);
    const bool is_at_friction =
        fabs(fabs(row.solution.normal_force) - row.yield_force[row.solution.is_forward]) < 0.02;
    assert_true(is_at_friction || few_slope_error(&row, &t, 1e-10) < 1e-3 * k);
    vec3 u = harness_draw_vec3(source, -4e-5, 4e-5);
    expect_near(0.0,
                vec3_distance(few_force_by_tangent(&t, u), vbss_contact_linearised_force(&row, u)),
                1e-12);
    seen[(row.solution.tear_limit > 0.0) + row.solution.is_tear_capped]++;
}

static void tangent_is_the_slope_of_the_force(void **state)
{
    (void)state;
    int seen[3] = {0};
    harness_property("tearing slope", 1000, any_tangent_is_the_slope, seen);
    for (int i = 0; i < 3; i++) {
        assert_true(seen[i] > 50);
    }
}

/* A force that is nearly normal to the wall would move the hole far for a small yield. */
static void force_off_the_wall_does_not_tear(void **state)
{
    (void)state;
    contact_solution next;
    contact_constraint row = few_sleeve(vec3_make(1.0, 0.0, 0.0));
    row.tear_force = 0.1;
    row.max_tear_slip = 1e-4;
    row.wall_normal = vec3_make(0.0, 1.0, 0.0);
    row.relative_displacement = vec3_make(0.0, 2e-4, 2e-5);
    (void)vbss_contact_update_solution(&row, vec3_zero(), &next);
    assert_true(next.tear_limit == 0.0);
    expect_near(0.0, vec3_norm(vbss_contact_tear_slip(&row)), 0.0);
}

int test_tearing_law(void)
{
    const struct CMUnitTest tests[] = {
        harness_test(yields_at_its_limit),
        harness_test(tangent_is_the_slope_of_the_force),
        cmocka_unit_test(force_off_the_wall_does_not_tear),
    };
    return cmocka_run_group_tests_name("contact.tearing_law", tests, NULL, NULL);
}
