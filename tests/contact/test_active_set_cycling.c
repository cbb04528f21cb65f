/* The search for states where solves lead too far: what cycled without end is found, and is the law. */
#include "base/elementary.h"
#include "few_blocks.h"

/* A node of a fine thread: mass / h^2 is a hundredth of the r of the law. */
#define LIGHT 0.03
#define FRICTION 0.3

static void begin_light(few_blocks *f, uint32_t count, double inertia)
{
    few_begin(f, count);
    f->search.max_solves = 36; /* as a scene asks */
    f->search.relative_force_tolerance = 1e-3;
    f->search.absolute_force_tolerance = 1e-7;
    f->search.overlap_tolerance = 1e-4;
    for (uint32_t b = 0; b < count; b++) {
        f->stiffness[b] = mat3_diagonal(inertia, inertia, inertia);
    }
}

/* N: by how much any block is out of balance with the forces that its rows tell of. */
static double largest_imbalance(const few_blocks *f)
{
    double largest = 0.0;
    for (uint32_t b = 0; b < f->count; b++) {
        vec3 left = vec3_sub(f->force[b], mat3_mul_vec3(f->stiffness[b], f->system->solution[b]));
        for (uint32_t i = 0; i < f->set->count; i++) {
            const contact_constraint *row = &f->set->constraints[i];
            vec3 force = vec3_add_scaled(row->solution.tangential_force, row->solution.normal_force,
                                         row->normal);
            for (uint32_t p = 0; p < row->jacobian_block_count; p++) {
                double weight = row->jacobian[p].block == b ? row->jacobian[p].weight : 0.0;
                left = vec3_add_scaled(left, weight, force);
            }
        }
        largest = vbss_max(vec3_norm(left), largest);
    }
    return largest;
}

static double largest_pressure(const few_blocks *f)
{
    double largest = 0.0;
    for (uint32_t i = 0; i < f->set->count; i++) {
        largest = vbss_max(f->set->constraints[i].solution.normal_force, largest);
    }
    return largest;
}

/* In newtons: what sticks does not move, what slides is rubbed with all that the pressure allows and, where it
 * slides by more than nothing, against its way; what is open does not overlap. */
static void expect_law(const few_blocks *f)
{
    const double none = 1e-3 * largest_pressure(f) + 1e-7;
    expect_near(0.0, largest_imbalance(f), 4.0 * none); /* a row that lets go has told of it */
    for (uint32_t i = 0; i < f->set->count; i++) {
        const contact_constraint *row = &f->set->constraints[i];
        vec3 u = few_moved(f, row), rubbing = row->solution.tangential_force;
        double gap = row->gap + vec3_dot(row->normal, u),
               friction_limit = FRICTION * row->solution.normal_force;
        vec3 slip = vec3_add_scaled(across(vec3_add(row->relative_displacement, u), row->normal),
                                    1.0 / row->stiffness, vec3_sub(rubbing, row->previous_force));
        if (row->solution.status == CONTACT_OPEN) {
            assert_true(-gap <= f->search.overlap_tolerance * row->thickness * (1.0 + 1e-9));
            continue;
        }
        expect_near(-row->stiffness * gap, row->solution.normal_force, 1e-9);
        assert_true(row->solution.normal_force >= 0.0 &&
                    vec3_norm(rubbing) <= friction_limit + none);
        if (row->solution.status == CONTACT_STICK) {
            expect_near(0.0, row->augmentation * vec3_norm(slip), none);
        } else {
            expect_near(friction_limit, vec3_norm(rubbing), none);
            double far = row->augmentation * vec3_norm(slip);
            assert_true(vec3_dot(rubbing, slip) <= 0.0 || far <= 2.0 * none);
        }
    }
}

/* ---- the smallest system that cycled: its solves led to one side and to the other for ever */

static void light_node_on_plane_sticks_or_slides(void **state)
{
    (void)state;
    const double pressed = 0.03, friction_limit = FRICTION * pressed;
    for (int k = 1; k <= 20; k++) {
        double inertia = LIGHT, pulled = 0.1 * k * friction_limit;
        for (int doubled = 0; doubled < 8; doubled++) {
            few_blocks f;
            begin_light(&f, 1, inertia);
            f.force[0] = vec3_make(pulled, -pressed, 0.0);
            contact_constraint *row = few_plane(&f, 0, 0, vec3_make(0.0, 1.0, 0.0));
            row->friction = FRICTION;
            row->gap = 1e-6;
            assert_int_equal(few_solve(&f), CONTACT_CONVERGED);
            assert_true(f.set->counters.solves <= 16);
            expect_law(&f);
            if (k < 10) {
                assert_int_equal(f.set->constraints[0].solution.status, CONTACT_STICK);
                expect_near(0.0, f.system->solution[0].x, 1e-7);
            } else if (k > 10) {
                assert_int_equal(f.set->constraints[0].solution.status, CONTACT_SLIP);
                expect_near((pulled - friction_limit) / inertia, f.system->solution[0].x,
                            2e-3 * friction_limit / inertia);
            }
            few_end(&f);
            inertia *= 2.0;
        }
    }
}

/* ---- nodes on a round tool, each held by a few planes and touching the next */

static void place_loop(few_blocks *f, harness_source *source)
{
    begin_light(f, 6, harness_draw_real(source, LIGHT, 1.0));
    for (uint32_t b = 0; b < f->count; b++) {
        vec3 push = harness_draw_vec3(source, -0.03, 0.03);
        f->force[b] = vec3_add(push, vec3_make(0.0, -0.03, 0.0));
        for (uint32_t k = 0; k < 3; k++) {
            double angle = harness_draw_real(source, -1.0, 1.0);
            double aslant = harness_draw_real(source, -0.3, 0.3);
            vec3 normal = vec3_make(vbss_sin(angle), vbss_cos(angle), aslant);
            contact_constraint *row = few_plane(f, 4 * b + k, b, vec3_unit_or(normal, vec3_zero()));
            row->friction = FRICTION;
            row->gap = harness_draw_real(source, -1e-6, 2e-6);
        }
        if (b > 0 && harness_draw_below(source, 2) == 0) {
            vec3 normal = harness_draw_vec3(source, -1.0, 1.0);
            contact_constraint *row =
                few_plane(f, 4 * b + 3, b, vec3_unit_or(normal, vec3_make(0.0, 0.0, 1.0)));
            row->friction = FRICTION;
            row->gap = harness_draw_real(source, 0.0, 1e-5);
            row->jacobian[1] = (contact_jacobian_block){.block = b - 1, .weight = -1.0};
            row->jacobian_block_count = 2;
        }
    }
}

typedef struct tally {
    uint32_t found, lost;
} tally;

static void what_is_found_of_a_loop_is_right(harness_source *source, void *user)
{
    tally *t = user;
    few_blocks f;
    place_loop(&f, source);
    contact_outcome outcome = few_solve(&f);
    assert_true(outcome == CONTACT_CONVERGED || outcome == CONTACT_NOT_CONVERGED);
    if (outcome == CONTACT_CONVERGED) {
        expect_law(&f);
    }
    t->found += outcome == CONTACT_CONVERGED;
    t->lost += outcome == CONTACT_NOT_CONVERGED;
    few_end(&f);
}

/* More than half of them are lost if solves are followed all the way. */
static void cyclic_cases_converge(void **state)
{
    (void)state;
    tally t = {0};
    harness_property("loops", 500, what_is_found_of_a_loop_is_right, &t);
    assert_true(t.found > 4 * t.lost || t.found + t.lost == 1);
}

/* ---- the forces that tell how far to follow */

static void forces_are_those_of_the_law(harness_source *source, void *user)
{
    (void)user;
    vec3 normal = vec3_unit_or(harness_draw_vec3(source, -1.0, 1.0), vec3_make(1.0, 0.0, 0.0));
    contact_constraint row = {.normal = normal, .stiffness = 2e5, .friction = FRICTION};
    row.gap = harness_draw_real(source, -1e-5, 1e-5);
    row.relative_displacement = harness_draw_vec3(source, -1e-6, 1e-6);
    row.previous_force = across(harness_draw_vec3(source, -0.1, 0.1), normal);
    row.augmentation = 3.0;
    row.is_bilateral = harness_draw_below(source, 8) == 0;
    vec3 u = harness_draw_vec3(source, -1e-5, 1e-5), force = vbss_contact_force(&row, u);
    expect_near(0.0, vec3_distance(few_law(&row, u), force), 1e-12);
    /* Where the law is satisfied its state goes on to say the same. */
    const contact_iterate iterate = {u, force};
    contact_solution next;
    vbss_contact_solution_at(&row, &iterate, &next);
    row.solution = next;
    double smallest = row.is_bilateral ? -1.0 : 0.0, pressed = vec3_dot(force, normal);
    assert_true((next.status == CONTACT_OPEN) == !(pressed > smallest) || row.is_bilateral);
    if (next.status == CONTACT_STICK) {
        expect_near(0.0, vec3_distance(force, vbss_contact_linearised_force(&row, u)), 1e-9);
    } else if (next.status == CONTACT_SLIP) { /* but for the share, which has a largest value */
        vec3 linear = vbss_contact_linearised_force(&row, u);
        double stiff = 1e-3 * FRICTION * pressed + 1e-9;
        expect_near(0.0, vec3_dot(vec3_sub(force, linear), normal), 1e-9);
        expect_near(0.0, vec3_dot(vec3_sub(force, linear), next.slip_direction), stiff);
    }
}

static void law_and_linear_force_agree(void **state)
{
    (void)state;
    harness_property("forces", 2000, forces_are_those_of_the_law, NULL);
}

/* ---- what needs no help gets none */

static void plain_contacts_need_minimum_solves(void **state)
{
    (void)state;
    few_blocks f;
    begin_light(&f, 3, 100.0);
    for (uint32_t b = 0; b < 3; b++) {
        f.force[b] = vec3_make(1e-3, -1e-3, 0.0);
        contact_constraint *row = few_plane(&f, b, b, vec3_make(0.0, 1.0, 0.0));
        row->friction = FRICTION;
        row->solution.status = CONTACT_STICK;
        row->gap = -5e-9;
    }
    assert_int_equal(few_solve(&f), CONTACT_CONVERGED);
    assert_true(f.set->counters.solves <= 3); /* sticking, slipping, and where to */
    expect_law(&f);
    few_end(&f);
}

int test_active_set_cycling(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(light_node_on_plane_sticks_or_slides),
        harness_test(cyclic_cases_converge),
        harness_test(law_and_linear_force_agree),
        cmocka_unit_test(plain_contacts_need_minimum_solves),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
