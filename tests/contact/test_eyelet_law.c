/* Rows of what slides in a sleeve: elastic across, and along up to what friction bears; beyond that a damper in series. */
#include "base/elementary.h"
#include "few_blocks.h"

static const double k = FEW_SLEEVE_STIFFNESS, smallest = FEW_SLEEVE_MIN;

/* ---- the law */

/* In closed form, by what the damper has yielded: f = trial - k y = most + beyond y. */
static vec3 law(const contact_constraint *row, vec3 u, contact_status *state)
{
    vec3 slid = vec3_add(row->relative_displacement, u), aside = across(slid, row->normal);
    double trial = vec3_dot(row->previous_force, row->normal) - k * vec3_dot(slid, row->normal);
    double largest =
        row->yield_force[trial > 0.0] + row->yield_friction[trial > 0.0] * k * vec3_norm(aside);
    double yielded = fmax(fabs(trial) - largest, 0.0) / (k + row->viscous_stiffness);
    *state = yielded > 0.0 ? CONTACT_SLIP : CONTACT_STICK;
    return vec3_add_scaled(vec3_scale(aside, -k), trial - copysign(k * yielded, trial),
                           row->normal);
}

/* Along of either sign, stuck or beyond. */
static contact_constraint any_row(harness_source *source)
{
    vec3 direction = harness_draw_vec3(source, -1.0, 1.0);
    contact_constraint row = few_sleeve(vec3_unit_or(direction, vec3_make(1.0, 0.0, 0.0)));
    double held = harness_draw_real(source, -1.0, 1.0);
    row.yield_force[0] = harness_draw_real(source, 0.0, 0.1);
    row.yield_force[1] = harness_draw_real(source, 0.0, 0.1);
    row.yield_friction[0] = harness_draw_real(source, 0.0, 1.5);
    row.yield_friction[1] = harness_draw_real(source, 0.0, 1.5);
    row.viscous_stiffness = harness_draw_real(source, 0.0, 2e3);
    row.relative_displacement = harness_draw_vec3(source, -4e-5, 4e-5);
    row.previous_force = vec3_scale(row.normal, held);
    return row;
}

static void any_row_follows_the_law(harness_source *source, void *user)
{
    int *seen = user;
    contact_status wanted;
    contact_solution next;
    contact_constraint row = any_row(source);
    const vec3 n = row.normal, u = harness_draw_vec3(source, -4e-5, 4e-5);
    const vec3 force = law(&row, u, &wanted);
    (void)vbss_contact_update_solution(&row, u, &next);
    assert_int_equal(next.status, wanted);
    expect_near(vec3_dot(force, n), next.normal_force, 1e-12);
    expect_near(0.0, vec3_distance(across(force, n), next.tangential_force), 1e-12);
    expect_near(1.0, vec3_norm(next.slip_direction), 1e-12);
    expect_near(0.0, vec3_dot(next.slip_direction, n), 1e-9);
    if (wanted == CONTACT_SLIP) {
        assert_int_equal(next.normal_force > 0.0, next.is_forward);
    }
    expect_near(0.0, vec3_distance(force, vbss_contact_force(&row, u)), 1e-12);
    seen[2 * (wanted == CONTACT_SLIP) + (next.normal_force > 0.0)]++;
    /* Where the search stands says the same, whatever force it balances with. */
    contact_solution there;
    const contact_iterate iterate = {u, vec3_make(3.0, -2.0, 1.0)};
    vbss_contact_solution_at(&row, &iterate, &there);
    assert_int_equal(there.status, next.status);
    expect_near(next.normal_force, there.normal_force, 0.0);
    assert_int_equal(next.is_forward, there.is_forward);
    /* In that state nothing is missed, and the linear law is the law there. */
    row.solution = next;
    expect_near(0.0, vbss_contact_update_solution(&row, u, &there), 0.0);
    expect_near(0.0, vec3_distance(force, vbss_contact_linearised_force(&row, u)), 1e-12);
}

static void elastic_up_to_yield_force(void **state)
{
    (void)state;
    int seen[4] = {0};
    harness_property("law", 1000, any_row_follows_the_law, seen);
    for (int i = 0; i < 4; i++) {
        assert_true(seen[i] > 50);
    }
}

/* Of the force itself, which knows nothing of the row's direction. */
static void any_tangent_is_the_slope_of_the_force(harness_source *source, void *user)
{
    int *seen = user;
    contact_constraint row = any_row(source);
    contact_linearisation t;
    (void)vbss_contact_update_solution(&row, vec3_zero(), &row.solution);
    double aside = k * vec3_norm(across(row.relative_displacement, row.normal));
    double elastic = vec3_dot(row.previous_force, row.normal) -
                     k * vec3_dot(row.relative_displacement, row.normal);
    double largest = row.yield_force[elastic > 0.0] + row.yield_friction[elastic > 0.0] * aside;
    if (aside < 0.05 || fabs(fabs(elastic) - largest) < 1e-3) {
        return; /* nothing across has a direction; the slope has a step where it begins to yield */
    }
    vbss_contact_linearise(&row, &t);
    assert_int_equal(t.count, 3);
    expect_near(0.0, vec3_distance(t.force, vbss_contact_force(&row, vec3_zero())), 1e-12);
    expect_near(0.0, few_slope_error(&row, &t, 1e-9), 1e-4 * k);
    vec3 u = harness_draw_vec3(source, -4e-5, 4e-5);
    expect_near(0.0,
                vec3_distance(few_force_by_tangent(&t, u), vbss_contact_linearised_force(&row, u)),
                1e-12);
    seen[2 * (row.solution.status == CONTACT_SLIP) + (elastic > 0.0)]++;
}

static void tangent_is_derivative_of_force(void **state)
{
    (void)state;
    int seen[4] = {0};
    harness_property("slope", 1000, any_tangent_is_the_slope_of_the_force, seen);
    for (int i = 0; i < 4; i++) {
        assert_true(seen[i] > 50);
    }
}

/* A direction across that is off by 1e-5 is good enough; by 0.1, or another state, is told. */
static void residual_of_wrong_state_is_reported(void **state)
{
    (void)state;
    contact_solution next;
    contact_constraint row = few_sleeve(vec3_make(1.0, 0.0, 0.0));
    row.relative_displacement = vec3_make(-1e-4, -5e-5, 0.0); /* trial 2 N, 1 N across */
    row.solution.status = CONTACT_STICK;
    const double force = (row.viscous_stiffness * 2.0 + k * (smallest + row.yield_friction[1])) /
                         (row.viscous_stiffness + k);
    expect_near(2.0 - force, vbss_contact_update_solution(&row, vec3_zero(), &next), 1e-12);
    row.solution = next;
    for (int i = 0; i < 2; i++) {
        double off = i == 0 ? 1e-5 : 0.1, sine, cosine;
        vbss_sincos(off, &sine, &cosine);
        row.solution.slip_direction = vec3_make(0.0, cosine, sine);
        double missed = row.yield_friction[1] * (1.0 - cosine) * k / (row.viscous_stiffness + k);
        expect_near(i == 0 ? 0.0 : missed, vbss_contact_update_solution(&row, vec3_zero(), &next),
                    1e-12);
    }
    row.solution.slip_direction = next.slip_direction;
    row.solution.is_forward = false; /* the other way */
    assert_true(vbss_contact_update_solution(&row, vec3_zero(), &next) >
                2.0 * (smallest + row.yield_friction[0]) - 0.3);
}

int test_eyelet_law(void)
{
    const struct CMUnitTest tests[] = {
        harness_test(elastic_up_to_yield_force),
        harness_test(tangent_is_derivative_of_force),
        cmocka_unit_test(residual_of_wrong_state_is_reported),
    };
    return cmocka_run_group_tests_name("contact.eyelet_law", tests, NULL, NULL);
}
