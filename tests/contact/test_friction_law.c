/* The law of a row: what it presses and rubs with, how that changes, and which state comes next. */
#include "base/elementary.h"
#include "few_blocks.h"

static const double k = 2e5;

static contact_constraint plain_row(vec3 normal)
{
    contact_constraint row = {.normal = normal,
                              .stiffness = k,
                              .friction = 0.3,
                              .augmentation = 3.0,
                              .thickness = 1e-3,
                              .gap = -5e-6};
    return row;
}

static vec3 draw_in_plane(harness_source *source, vec3 normal)
{
    vec3 v = across(harness_draw_vec3(source, -1.0, 1.0), normal);
    return vec3_unit_or(v, vec3_any_normal(normal));
}

/* A closed row whose elastic force is `over` times what the cone allows. */
static contact_constraint draw_closed(harness_source *source, double over)
{
    vec3 normal = vec3_unit_or(harness_draw_vec3(source, -1.0, 1.0), vec3_make(1.0, 0.0, 0.0));
    contact_constraint row = plain_row(normal);
    row.friction = harness_draw_real(source, 0.05, 1.5);
    row.augmentation = vbss_exp(harness_draw_real(source, -3.0, 12.0));
    row.gap = -harness_draw_real(source, 1e-6, 5e-5);
    double largest = -row.friction * k * row.gap;
    vec3 direction = draw_in_plane(source, normal);
    double share = harness_draw_real(source, 0.0, 1.0);
    vec3 elastic = vec3_scale(direction, over * largest);
    vec3 side = vec3_scale(draw_in_plane(source, normal), share * largest);
    row.previous_force = vec3_add(vec3_scale(elastic, 0.3), side);
    row.tangential_stiffness_ratio =
        harness_draw_below(source, 2) == 0 ? harness_draw_real(source, 0.01, 1.0) : 0.0;
    row.relative_displacement =
        vec3_scale(vec3_sub(row.previous_force, elastic), 1.0 / few_stiffness_along(&row));
    /* What lies along the normal is no slip. */
    row.relative_displacement =
        vec3_add_scaled(row.relative_displacement, harness_draw_real(source, -1e-5, 1e-5), normal);
    row.solution.status = CONTACT_STICK;
    if (over > 1.0) {
        double slip = (over - 1.0) * largest / few_stiffness_along(&row);
        row.solution.status = CONTACT_SLIP;
        row.solution.slip_direction = direction;
        row.solution.friction_ratio = largest / (largest + row.augmentation * slip);
    }
    return row;
}

static vec3 linear_force(const contact_linearisation *t, vec3 u)
{
    vec3 force = t->force;
    for (uint32_t d = 0; d < t->count; d++) {
        force = vec3_add_scaled(force, -t->stiffness[d] * vec3_dot(t->right[d], u), t->left[d]);
    }
    return force;
}

/* ---- the linear law is the law's value and its derivative */

static void check_linear_law(const contact_constraint *row)
{
    contact_linearisation t;
    vbss_contact_linearise(row, &t);
    vec3 force = few_law(row, vec3_zero());
    double scale = vec3_norm(force);
    expect_near(0.0, vec3_distance(force, t.force), 1e-11 * scale);
    const double step = 1e-10;
    for (int axis = 0; axis < 3; axis++) {
        vec3 u = vec3_make(axis == 0 ? step : 0.0, axis == 1 ? step : 0.0, axis == 2 ? step : 0.0);
        vec3 there = few_law(row, u), back = few_law(row, vec3_neg(u));
        vec3 wanted = vec3_scale(vec3_sub(there, back), 0.5 / step);
        vec3 linear = vec3_sub(linear_force(&t, u), linear_force(&t, vec3_neg(u)));
        expect_near(0.0, vec3_distance(wanted, vec3_scale(linear, 0.5 / step)), 2e-5 * k);
    }
}

static void sticking_is_linearised_exactly(harness_source *source, void *user)
{
    (void)user;
    contact_constraint row = draw_closed(source, harness_draw_real(source, 0.0, 0.99));
    check_linear_law(&row);
    row.is_bilateral = true;
    check_linear_law(&row);
}

static void slipping_is_linearised_exactly(harness_source *source, void *user)
{
    (void)user;
    /* Not nearer to sticking than the largest share that is used. */
    double over = harness_draw_real(source, 1.02, 6.0);
    contact_constraint row = draw_closed(source, over);
    double largest = -row.friction * k * row.gap;
    row.augmentation = vbss_max(row.augmentation, 0.002 * k / (over - 1.0));
    double slip = (over - 1.0) * largest / few_stiffness_along(&row);
    row.solution.friction_ratio = largest / (largest + row.augmentation * slip);
    check_linear_law(&row);
}

static void rows_without_friction_are_linearised_exactly(harness_source *source, void *user)
{
    (void)user;
    contact_constraint row = draw_closed(source, 0.5);
    row.friction = 0.0;
    row.previous_force = vec3_zero();
    check_linear_law(&row);
    contact_linearisation t;
    row.gap = harness_draw_real(source, 0.0, 1.0); /* bilateral, it pulls */
    row.is_bilateral = true;
    vbss_contact_linearise(&row, &t);
    expect_near(-k * row.gap, vec3_dot(t.force, row.normal), 1e-9);
}

static void linearisation_is_derivative_of_law(void **state)
{
    (void)state;
    harness_property("stick", 300, sticking_is_linearised_exactly, NULL);
    harness_property("slip", 300, slipping_is_linearised_exactly, NULL);
    harness_property("no friction", 300, rows_without_friction_are_linearised_exactly, NULL);
}

static void open_constraint_adds_nothing(void **state)
{
    (void)state;
    contact_constraint row = plain_row(vec3_make(0.0, 1.0, 0.0));
    contact_linearisation t;
    row.gap = -1e-3; /* even where it overlaps: its state says so */
    vbss_contact_linearise(&row, &t);
    assert_int_equal(t.count, 0);
    expect_near(0.0, vec3_norm(t.force), 0.0);
}

/* ---- the next state */

/* Where the law holds, nothing is missed, and the state stays. */
static void a_state_that_holds_stays(harness_source *source, void *user)
{
    (void)user;
    bool slips = harness_draw_below(source, 2) == 1;
    contact_constraint row = draw_closed(source, slips ? harness_draw_real(source, 1.1, 6.0)
                                                       : harness_draw_real(source, 0.0, 0.99));
    contact_solution next;
    double scale = -k * row.gap;
    row.augmentation = slips ? vbss_max(row.augmentation, 0.02 * k) : row.augmentation;
    if (slips) {
        const double along = few_stiffness_along(&row);
        vec3 elastic = vec3_add_scaled(row.previous_force, -along,
                                       across(row.relative_displacement, row.normal));
        double largest = row.friction * scale;
        row.solution.friction_ratio =
            largest / (largest + row.augmentation * (vec3_norm(elastic) - largest) / along);
    }
    expect_near(0.0, vbss_contact_update_solution(&row, vec3_zero(), &next), 1e-10 * scale);
    assert_int_equal(next.status, slips ? CONTACT_SLIP : CONTACT_STICK);
    expect_near(scale, next.normal_force, 1e-12 * scale);
    vec3 wanted = vec3_add_scaled(few_law(&row, vec3_zero()), -next.normal_force, row.normal);
    expect_near(0.0, vec3_distance(wanted, next.tangential_force), 1e-10 * scale);
    if (slips) {
        expect_near(0.0, vec3_distance(row.solution.slip_direction, next.slip_direction), 1e-9);
        expect_near(row.solution.friction_ratio, next.friction_ratio, 1e-9);
    }
}

/* From any state, for a motion that is given, what is missed comes out as nothing in the end. */
static void states_come_to_the_law(harness_source *source, void *user)
{
    (void)user;
    bool slips = harness_draw_below(source, 2) == 1;
    contact_constraint row = draw_closed(source, slips ? harness_draw_real(source, 1.1, 6.0)
                                                       : harness_draw_real(source, 0.0, 0.95));
    /* A stiffer one overshoots, again and again. */
    row.augmentation =
        vbss_min(vbss_exp(harness_draw_real(source, 7.0, 12.0)), few_stiffness_along(&row));
    double missed = 1.0, scale = -k * row.gap;
    row.solution = (contact_solution){.status = (contact_status)harness_draw_below(source, 3),
                                      .slip_direction = draw_in_plane(source, row.normal),
                                      .friction_ratio = harness_draw_real(source, 0.1, 0.99)};
    /* Farther than is asked of what is missed: the force is off by up to the ratio of the stiffness along to r more. */
    for (int i = 0; i < 200 && missed > 1e-11 * scale; i++) {
        contact_solution next;
        missed = vbss_contact_update_solution(&row, vec3_zero(), &next);
        row.solution = next;
    }
    expect_near(0.0, missed, 1e-9 * scale);
    vec3 force =
        vec3_add_scaled(row.solution.tangential_force, row.solution.normal_force, row.normal);
    expect_near(0.0, vec3_distance(few_law(&row, vec3_zero()), force), 2e-8 * scale);
}

static void status_iteration_is_consistent_with_law(void **state)
{
    (void)state;
    harness_property("stays", 300, a_state_that_holds_stays, NULL);
    harness_property("comes", 300, states_come_to_the_law, NULL);
}

static contact_status next_of(contact_constraint *row, vec3 u, contact_solution *next)
{
    (void)vbss_contact_update_solution(row, u, next);
    return next->status;
}

static void constraint_opens_and_closes(void **state)
{
    (void)state;
    contact_constraint row = plain_row(vec3_make(0.0, 1.0, 0.0));
    contact_solution next;
    row.gap = 1e-5;
    assert_int_equal(next_of(&row, vec3_zero(), &next), CONTACT_OPEN);
    assert_int_equal(next_of(&row, vec3_make(1.0, -0.999e-5, 1.0), &next), CONTACT_OPEN);
    expect_near(0.0, vbss_contact_update_solution(&row, vec3_make(0.0, -1e-5, 0.0), &next), 0.0);
    assert_int_equal(next.status, CONTACT_OPEN); /* touching is not pressing */
    /* It closes: what is missed is the force that an open row does not have. */
    expect_near(0.2, vbss_contact_update_solution(&row, vec3_make(0.0, -1.1e-5, 0.0), &next),
                1e-12);
    assert_int_equal(next.status, CONTACT_STICK);
    expect_near(0.2, next.normal_force, 1e-12);
    assert_int_equal(next_of(&row, vec3_make(0.9e-7, -1.1e-5, 0.0), &next), CONTACT_STICK);
    assert_int_equal(next_of(&row, vec3_make(1e-6, -1.1e-5, 0.0), &next), CONTACT_SLIP);
    expect_near(-1.0, next.slip_direction.x, 1e-15);
    expect_near(-0.3 * 0.2, next.tangential_force.x, 1e-12);
    row.friction = 0.0;
    assert_int_equal(next_of(&row, vec3_make(1e-6, -1.1e-5, 0.0), &next), CONTACT_STICK);
    expect_near(0.0, vec3_norm(next.tangential_force), 0.0);
    /* It opens, from either closed state: what is missed is the pull, and what it would be rubbed with. */
    row.friction = 0.3;
    for (int s = CONTACT_STICK; s <= CONTACT_SLIP; s++) {
        row.solution = (contact_solution){
            .status = (contact_status)s, .slip_direction = {1.0, 0.0, 0.0}, .friction_ratio = 0.5};
        double missed = vbss_contact_update_solution(&row, vec3_zero(), &next);
        expect_near(vec3_norm(vbss_contact_linearised_force(&row, vec3_zero())), missed, 1e-12);
        assert_true(missed > 2.0 - 1e-12);
        assert_int_equal(next.status, CONTACT_OPEN);
        expect_near(0.0, next.normal_force, 0.0);
    }
}

static void stick_slip_transition_at_cone(void **state)
{
    (void)state;
    contact_constraint row = plain_row(vec3_make(0.0, 1.0, 0.0));
    contact_solution next;
    row.solution.status = CONTACT_STICK; /* 1 N of pressure: 0.3 N at most, which is 1.5 um */
    assert_int_equal(next_of(&row, vec3_make(1.4999e-6, 0.0, 0.0), &next), CONTACT_STICK);
    expect_near(-0.29998, next.tangential_force.x, 1e-12);
    assert_int_equal(next_of(&row, vec3_make(1.5001e-6, 0.0, 0.0), &next), CONTACT_SLIP);
    expect_near(-1.0, next.slip_direction.x, 1e-15);
    assert_true(next.friction_ratio < 1.0);
    /* More pressure holds it. */
    assert_int_equal(next_of(&row, vec3_make(1.5001e-6, -1e-8, 0.0), &next), CONTACT_STICK);
    /* A force that is held counts. */
    row.previous_force = vec3_make(-0.2, 0.0, 0.0);
    assert_int_equal(next_of(&row, vec3_make(0.49e-6, 0.0, 0.0), &next), CONTACT_STICK);
    assert_int_equal(next_of(&row, vec3_make(0.51e-6, 0.0, 0.0), &next), CONTACT_SLIP);
    /* It slips, and is moved back by more than was elastic. */
    row.previous_force = vec3_zero();
    row.solution = (contact_solution){
        .status = CONTACT_SLIP, .slip_direction = {-1.0, 0.0, 0.0}, .friction_ratio = 0.9};
    row.augmentation = k;
    assert_int_equal(next_of(&row, vec3_make(2e-6, 0.0, 0.0), &next), CONTACT_SLIP);
    assert_int_equal(next_of(&row, vec3_make(1e-6, 0.0, 0.0), &next), CONTACT_STICK);
}

static void bilateral_constraint_pulls_and_never_slips(void **state)
{
    (void)state;
    contact_constraint row = plain_row(vec3_make(0.0, 1.0, 0.0));
    contact_solution next;
    row.is_bilateral = true;
    row.solution.status = CONTACT_STICK;
    const vec3 displacements[] = {
        {0.0, 0.0, 0.0}, {1e-3, 1e-3, 0.0}, {-1.0, 1.0, 1.0}, {0.0, -1.0, 0.0}};
    for (int i = 0; i < 4; i++) {
        expect_near(0.0, vbss_contact_update_solution(&row, displacements[i], &next), 0.0);
        assert_int_equal(next.status, CONTACT_STICK);
        expect_near(-k * (row.gap + displacements[i].y), next.normal_force, 1e-9);
        expect_near(-k * displacements[i].x, next.tangential_force.x, 1e-9);
        expect_near(-k * displacements[i].z, next.tangential_force.z, 1e-9);
    }
    row.friction = 0.0; /* the coefficient is for contacts only */
    expect_near(0.0, vbss_contact_update_solution(&row, displacements[1], &next), 0.0);
    expect_near(-k * displacements[1].x, next.tangential_force.x, 1e-9);
    expect_near(
        0.0,
        vec3_distance(few_law(&row, displacements[2]), vbss_contact_force(&row, displacements[2])),
        1e-9);
}

/* ---- the force that is held */

static void a_turned_force_keeps_its_length(harness_source *source, void *user)
{
    (void)user;
    vec3 normal = vec3_unit_or(harness_draw_vec3(source, -1.0, 1.0), vec3_make(0.0, 0.0, 1.0));
    vec3 force = harness_draw_vec3(source, -1.0, 1.0);
    vec3 turned = vbss_contact_rotate_to_tangent_plane(force, normal);
    vec3 in_plane = across(force, normal);
    expect_near(0.0, vec3_dot(turned, normal), 1e-12 * vec3_norm(force));
    expect_near(vec3_norm(force), vec3_norm(turned), 1e-13);
    expect_near(vec3_norm(in_plane) * vec3_norm(turned), vec3_dot(in_plane, turned), 1e-13);
}

static void prescribed_force_turns_with_normal(void **state)
{
    (void)state;
    harness_property("turned", 300, a_turned_force_keeps_its_length, NULL);
    vec3 n = vec3_make(0.6, 0.0, 0.8);
    expect_near(0.0, vec3_norm(vbss_contact_rotate_to_tangent_plane(n, n)), 0.0);
    expect_near(0.0, vec3_norm(vbss_contact_rotate_to_tangent_plane(vec3_zero(), n)), 0.0);
}

int test_friction_law(void)
{
    const struct CMUnitTest tests[] = {
        harness_test(linearisation_is_derivative_of_law),
        cmocka_unit_test(open_constraint_adds_nothing),
        harness_test(status_iteration_is_consistent_with_law),
        cmocka_unit_test(constraint_opens_and_closes),
        cmocka_unit_test(stick_slip_transition_at_cone),
        cmocka_unit_test(bilateral_constraint_pulls_and_never_slips),
        harness_test(prescribed_force_turns_with_normal),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
