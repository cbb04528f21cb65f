/* States and increments found together: what comes out is the law and balance, whatever went in. */
#include "base/elementary.h"
#include "few_blocks.h"

/* ---- the answer is right: every row as the law says, every block in balance */

static double largest_imbalance(const few_blocks *f, bool as_reported)
{
    double largest = 0.0;
    for (uint32_t b = 0; b < f->count; b++) {
        vec3 left = vec3_sub(f->force[b], mat3_mul_vec3(f->stiffness[b], f->system->solution[b]));
        for (uint32_t i = 0; i < f->set->count && f->roles[b] != VBSS_ROLE_PRESCRIBED; i++) {
            const contact_constraint *row = &f->set->constraints[i];
            vec3 reported = vec3_add_scaled(row->solution.tangential_force,
                                            row->solution.normal_force, row->normal);
            vec3 force = as_reported ? reported : few_law(row, few_moved(f, row));
            for (uint32_t p = 0; p < row->jacobian_block_count; p++) {
                const contact_jacobian_block *t = &row->jacobian[p];
                if (t->block == b) {
                    vec3 part = t->is_rotation ? vec3_cross(t->arm, force) : force;
                    left = vec3_add_scaled(left, t->weight, part);
                }
            }
        }
        if (f->roles[b] != VBSS_ROLE_PRESCRIBED) {
            largest = vbss_max(vec3_norm(left), largest);
        }
    }
    return largest;
}

/* What rows tell of themselves is what the law says of where they are. */
static double largest_untruth(const few_blocks *f)
{
    double largest = 0.0;
    for (uint32_t i = 0; i < f->set->count; i++) {
        const contact_constraint *row = &f->set->constraints[i];
        vec3 reported = vec3_add_scaled(row->solution.tangential_force, row->solution.normal_force,
                                        row->normal);
        largest = vbss_max(vec3_distance(reported, few_law(row, few_moved(f, row))), largest);
    }
    return largest;
}

static void expect_solved(few_blocks *f, double scale)
{
    expect_near(0.0, largest_imbalance(f, true), 1e-9 * scale);
    expect_near(0.0, largest_imbalance(f, false), 1e-6 * scale);
    expect_near(0.0, largest_untruth(f), 1e-6 * scale);
}

/* ---- several rows on one node */

static void node_rests_in_corner_of_many_planes(void **state)
{
    (void)state;
    const vec3 axes[3] = {{1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 1.0}};
    for (uint32_t copies = 1; copies <= 8; copies++) { /* the same plane again and again */
        few_blocks f;
        few_begin(&f, 1);
        f.stiffness[0] = mat3_diagonal(10.0, 10.0, 10.0);
        f.force[0] = vec3_make(-1.0, -2.0, -0.5);
        for (uint32_t i = 0; i < 3 * copies; i++) {
            contact_constraint *row = few_plane(&f, i, 0, axes[i % 3]);
            row->friction = 0.0;
        }
        assert_int_equal(few_solve(&f), CONTACT_CONVERGED);
        for (uint32_t i = 0; i < 3 * copies; i++) {
            double share = 2e5 * copies / (2e5 * copies + 10.0) / copies;
            double wanted = -vec3_dot(f.force[0], axes[i % 3]) * share;
            expect_near(wanted, f.set->constraints[i].solution.normal_force, 1e-10);
        }
        expect_solved(&f, 2.0);
        few_end(&f);
    }
}

/* Of two planes that would hold it, the one that it is pulled off lets go. */
static void pulling_constraint_opens(void **state)
{
    (void)state;
    few_blocks f;
    few_begin(&f, 1);
    f.force[0] = vec3_make(1.0, -1.0, 0.0);
    contact_constraint *wall = few_plane(&f, 0, 0, vec3_make(1.0, 0.0, 0.0));
    contact_constraint *floor = few_plane(&f, 1, 0, vec3_make(0.0, 1.0, 0.0));
    wall->solution.status = floor->solution.status = CONTACT_STICK;
    wall->friction = floor->friction = 0.2;
    assert_int_equal(few_solve(&f), CONTACT_CONVERGED);
    assert_int_equal(f.set->constraints[0].solution.status, CONTACT_OPEN);
    assert_int_equal(f.set->constraints[1].solution.status, CONTACT_SLIP);
    expect_near(0.8, f.system->solution[0].x, 1e-4);
    expect_solved(&f, 1.0);
    few_end(&f);
}

/* ---- anything */

static vec3 draw_unit(harness_source *source)
{
    return vec3_unit_or(harness_draw_vec3(source, -1.0, 1.0), vec3_make(0.0, 1.0, 0.0));
}

static void draw_few(few_blocks *f, harness_source *source, double max_friction)
{
    few_begin(f, 1 + harness_draw_below(source, 4));
    for (uint32_t b = 0; b < f->count; b++) {
        double inertia = vbss_exp(harness_draw_real(source, 2.0, 9.0));
        f->stiffness[b] = mat3_diagonal(inertia, inertia, inertia);
        f->force[b] = harness_draw_vec3(source, -1.0, 1.0);
        f->roles[b] = b > 0 && harness_draw_below(source, 5) == 0 ? VBSS_ROLE_PRESCRIBED
                                                                  : VBSS_ROLE_SEPARATOR;
    }
    uint32_t rows = 1 + harness_draw_below(source, 6);
    for (uint32_t i = 0; i < rows; i++) {
        vec3 normal = draw_unit(source);
        contact_constraint *row = few_plane(f, i, harness_draw_below(source, f->count), normal);
        row->friction = harness_draw_real(source, 0.0, max_friction);
        row->gap = harness_draw_real(source, -1e-5, 1e-5);
        row->augmentation = vbss_exp(harness_draw_real(source, 8.0, 12.0));
        row->is_bilateral = harness_draw_below(source, 8) == 0;
        row->solution.status = row->is_bilateral ? CONTACT_STICK : CONTACT_OPEN;
        if (harness_draw_below(source, 2) == 0) { /* against another, with a lever */
            row->jacobian[1] =
                (contact_jacobian_block){.block = harness_draw_below(source, f->count),
                                         .weight = harness_draw_real(source, -1.0, -0.1)};
            row->jacobian_block_count = 2;
        }
        if (!row->is_bilateral && harness_draw_below(source, 3) == 0) { /* it was closed before */
            double limit = row->friction * vbss_max(0.0, -2e5 * row->gap);
            row->solution.status = CONTACT_STICK;
            row->previous_force = vec3_scale(across(draw_unit(source), normal), limit);
        }
    }
}

typedef struct tally {
    uint32_t found, lost;
} tally;

static void whatever_is_found_is_right(harness_source *source, void *user)
{
    tally *t = user;
    few_blocks f;
    draw_few(&f, source, 0.4);
    contact_outcome outcome = few_solve(&f);
    assert_true(outcome == CONTACT_CONVERGED || outcome == CONTACT_NOT_CONVERGED);
    assert_true(f.set->counters.solves <= f.search.max_solves);
    for (uint32_t i = 0; i < f.set->count; i++) {
        expect_same_bits(2e5, f.set->constraints[i].stiffness);
    }
    if (outcome == CONTACT_CONVERGED) {
        expect_solved(&f, 3.0);
    }
    t->found += outcome == CONTACT_CONVERGED;
    t->lost += outcome == CONTACT_NOT_CONVERGED;
    few_end(&f);
}

static void solution_satisfies_law_and_balance(void **state)
{
    (void)state;
    tally t = {0};
    harness_property("any", 1000, whatever_is_found_is_right, &t);
    assert_true(t.found > 900 || t.found + t.lost == 1);
}

/* Strict to the last digit some draws cycle; a scene takes what is nearly right, and tells. */
static void what_cycles_ends(harness_source *source, void *user)
{
    tally *t = user;
    few_blocks f;
    draw_few(&f, source, 3.0);
    f.search.max_solves = 8 + harness_draw_below(source, 16);
    f.search.max_stalled_solves = 6;
    f.search.loose_force_tolerance = 0.05;
    f.search.loose_overlap_tolerance = 0.02;
    contact_outcome outcome = few_solve(&f);
    uint64_t solves = f.set->counters.solves;
    assert_true(solves <= f.search.max_solves);
    assert_int_equal(f.set->counters.inexact, outcome == CONTACT_INEXACT);
    if (outcome == CONTACT_INEXACT) {
        assert_true(solves >= 4);
        double pressure = 0.0;
        for (uint32_t i = 0; i < f.set->count; i++) {
            pressure = vbss_max(f.set->constraints[i].solution.normal_force, pressure);
        }
        assert_true(f.set->residual <= 0.05 * pressure + 1e-12);
    }
    t->found += outcome == CONTACT_INEXACT;
    t->lost += outcome == CONTACT_NOT_CONVERGED;
    assert_true(outcome != CONTACT_NOT_CONVERGED || solves == f.search.max_solves);
    few_end(&f);
}

static void cycling_ends_loose_or_lost_within_limit(void **state)
{
    (void)state;
    tally t = {0};
    harness_property("cycles", 1000, what_cycles_ends, &t);
    assert_true((t.found > 10 && t.lost > 10) || t.found + t.lost <= 1);
}

/* ---- with limited work */

/* With the forces of where the search stopped. */
static double imbalance_of_iterate(const few_blocks *f)
{
    double largest = 0.0;
    for (uint32_t b = 0; b < f->count; b++) {
        vec3 left = vec3_sub(f->force[b], mat3_mul_vec3(f->stiffness[b], f->system->solution[b]));
        for (uint32_t i = 0; i < f->set->count; i++) {
            const contact_constraint *row = &f->set->constraints[i];
            for (uint32_t p = 0; p < row->jacobian_block_count; p++) {
                bool here = row->jacobian[p].block == b;
                double weight = here ? row->jacobian[p].weight : 0.0;
                left = vec3_add_scaled(left, weight, f->set->current[i].force);
            }
        }
        largest =
            f->roles[b] != VBSS_ROLE_PRESCRIBED ? vbss_max(vec3_norm(left), largest) : largest;
    }
    return largest;
}

/* Where it stops all balances, and sides have come as far as it says. */
static void what_stops_in_time_balances(harness_source *source, void *user)
{
    tally *t = user;
    few_blocks f;
    draw_few(&f, source, 3.0);
    f.search.operation_limit = 1 + harness_draw_below(source, 2000);
    contact_outcome outcome = few_solve(&f);
    const uint64_t work = f.set->counters.operations, solves = f.set->counters.solves;
    assert_true(solves == 1 || work <= f.search.operation_limit);
    if (outcome == CONTACT_NOT_CONVERGED) { /* it may go on for as long as ever */
        assert_int_equal(solves, f.search.max_solves);
        few_end(&f);
        return;
    }
    expect_near(0.0, imbalance_of_iterate(&f), 1e-8);
    for (uint32_t i = 0; i < f.set->count; i++) {
        const contact_constraint *row = &f.set->constraints[i];
        expect_near(0.0, vec3_distance(few_moved(&f, row), f.set->current[i].u), 1e-12);
        expect_same_bits(2e5, row->stiffness);
    }
    t->found += outcome == CONTACT_INEXACT;
    t->lost += outcome == CONTACT_CONVERGED;
    few_end(&f);
}

static void interrupted_search_leaves_balance(void **state)
{
    (void)state;
    tally t = {0};
    harness_property("stopped", 1000, what_stops_in_time_balances, &t);
    assert_true((t.found > 100 && t.lost > 100) || t.found + t.lost <= 1);
}

/* Another search from there is left: rows are as found before it, and what was stopped is so still. */
static void what_is_left_again_is_as_it_was_found(harness_source *source, void *user)
{
    tally *t = user;
    few_blocks f;
    contact_solution found[16] = {0};
    draw_few(&f, source, 3.0);
    f.search.operation_limit = 1;
    (void)few_solve(&f);
    const bool stopped = f.set->is_stopped_early;
    assert_true(f.set->count <= 16);
    vbss_contact_save_solution(f.set);
    for (uint32_t i = 0; i < f.set->count; i++) {
        found[i] = f.set->constraints[i].solution;
    }
    f.search.operation_limit = 0;
    (void)few_solve(&f);
    assert_false(f.set->is_stopped_early);
    vbss_contact_restore_solution(f.set);
    assert_int_equal(stopped, f.set->is_stopped_early);
    for (uint32_t i = 0; i < f.set->count; i++) {
        assert_int_equal(found[i].status, f.set->constraints[i].solution.status);
        expect_same_bits(found[i].normal_force, f.set->constraints[i].solution.normal_force);
    }
    t->found += stopped;
    t->lost += !stopped;
    few_end(&f);
}

static void abandoned_search_keeps_last_solution(void **state)
{
    (void)state;
    tally t = {0};
    harness_property("left", 1000, what_is_left_again_is_as_it_was_found, &t);
    assert_true((t.found > 100 && t.lost > 100) || t.found + t.lost <= 1);
}

static void missing_support_is_reported(void **state)
{
    (void)state;
    few_blocks f;
    few_begin(&f, 1);
    f.stiffness[0] = mat3_zero();
    f.force[0] = vec3_make(0.0, -1.0, 0.0);
    assert_int_equal(few_solve(&f), CONTACT_SINGULAR);
    contact_constraint *row = few_plane(&f, 0, 0, vec3_make(0.0, 1.0, 0.0));
    row->solution.status = CONTACT_STICK; /* smooth: it slides away */
    assert_int_equal(few_solve(&f), CONTACT_SINGULAR);
    f.set->constraints[0].friction = 0.5; /* and rough it rests */
    f.set->constraints[0].solution.status = CONTACT_STICK;
    f.set->constraints[0].gap = -5e-6;
    assert_int_equal(few_solve(&f), CONTACT_CONVERGED);
    expect_near(1.0, f.set->constraints[0].solution.normal_force, 1e-9);
    few_end(&f);
}

/* ---- solves that lead too far, and searches that take long */

/* What lets go flies against a stiff row that it reaches early on the way: there the search goes on, not before, where all is
 * as it was. */
static void early_closing_constraint_is_found_on_line_search(void **state)
{
    (void)state;
    for (int k = 1; k <= 12; k++) {
        few_blocks f;
        few_begin(&f, 1);
        f.stiffness[0] = mat3_diagonal(10.0, 10.0, 10.0);
        f.force[0] = vec3_make(0.0, 1e-5, 0.0); /* 1 um, if nothing were there */
        contact_constraint *left = few_plane(&f, 0, 0, vec3_make(0.0, 1.0, 0.0));
        left->solution.status = CONTACT_STICK;
        contact_constraint *met = few_plane(&f, 1, 0, vec3_make(0.0, -1.0, 0.0));
        met->gap = 7e-9 * k;
        assert_int_equal(few_solve(&f), CONTACT_CONVERGED);
        assert_int_equal(f.set->constraints[0].solution.status, CONTACT_OPEN);
        assert_int_not_equal(f.set->constraints[1].solution.status, CONTACT_OPEN);
        assert_true(f.set->counters.solves <= 4);
        expect_solved(&f, 1e-5);
        few_end(&f);
    }
}

/* Patience is with what does not come nearer: a slip that turns into its way does, a little with each solve. */
static void slowly_converging_slip_is_not_stalled(void **state)
{
    (void)state;
    uint64_t max_solves = 0;
    for (int stiffer = 2; stiffer <= 64; stiffer *= 2) {
        few_blocks f;
        few_begin(&f, 1);
        f.search.max_stalled_solves = 3;
        f.search.loose_force_tolerance = f.search.loose_overlap_tolerance =
            1.0; /* anything would do */
        f.stiffness[0] = mat3_diagonal(10.0, 10.0, 10.0 * stiffer);
        f.force[0] = vec3_make(1.0, -1.0, 1.0);
        contact_constraint *row = few_plane(&f, 0, 0, vec3_make(0.0, 1.0, 0.0));
        row->friction = 0.3;
        row->gap = -5e-6;
        row->solution = (contact_solution){.status = CONTACT_SLIP,
                                           .normal_force = 1.0,
                                           .tangential_force = vec3_make(-0.3, 0.0, 0.0),
                                           .slip_direction = vec3_make(-1.0, 0.0, 0.0),
                                           .friction_ratio = 0.5};
        assert_int_equal(few_solve(&f), CONTACT_CONVERGED);
        max_solves = f.set->counters.solves > max_solves ? f.set->counters.solves : max_solves;
        few_end(&f);
    }
    assert_true(max_solves > 3);
}

/* ---- rows that close deep, all at once */

static void deep_closure_is_softened_and_converges(void **state)
{
    (void)state;
    double share = 0.05;                             /* of the distance of touching */
    for (int doubled = 0; doubled < 12; doubled++) { /* to 200 */
        share *= 2.0;
        few_blocks f;
        few_begin(&f, 3);
        f.search.relative_force_tolerance = 1e-3; /* as a scene asks */
        f.search.absolute_force_tolerance = 1e-7;
        f.search.overlap_tolerance = 1e-4;
        for (uint32_t b = 0; b < 3; b++) {
            f.stiffness[b] = mat3_diagonal(100.0, 100.0, 100.0);
            f.force[b] = vec3_make(0.02, -0.1 * share, 0.01 * b);
            for (uint32_t k = 0; k < 3; k++) {
                double turn = 0.5 * k - 0.5;
                vec3 normal = vec3_make(vbss_sin(turn), vbss_cos(turn), 0.0);
                contact_constraint *row = few_plane(&f, 3 * b + k, b, normal);
                row->friction = 0.3;
                row->gap = 1e-6 * k;
            }
        }
        assert_int_equal(few_solve(&f), CONTACT_CONVERGED);
        double little = 3e-3 * 0.1 * share;
        expect_near(0.0, largest_imbalance(&f, true), little);
        for (uint32_t i = 0; i < f.set->count; i++) {
            contact_constraint *row = &f.set->constraints[i];
            double limit = row->friction * row->solution.normal_force;
            expect_same_bits(2e5, row->stiffness);
            assert_true(row->solution.normal_force >= 0.0);
            assert_true(vec3_norm(row->solution.tangential_force) <= limit + little);
        }
        few_end(&f);
    }
}

/* Also when it ends in the middle. */
static void stiffness_is_restored(void **state)
{
    (void)state;
    for (uint32_t limit = 1; limit <= 8; limit++) {
        few_blocks f;
        few_begin(&f, 1);
        f.search.max_solves = limit;
        f.stiffness[0] = mat3_diagonal(100.0, 100.0, 100.0);
        f.force[0] = vec3_make(3.0, -4.0, 0.0);
        contact_constraint *row = few_plane(&f, 0, 0, vec3_make(0.0, 1.0, 0.0));
        row->friction = 0.3;
        row->stiffness = 123456.789;
        contact_outcome found = few_solve(&f);
        assert_true(found == CONTACT_CONVERGED || f.set->counters.solves == limit);
        expect_same_bits(123456.789, f.set->constraints[0].stiffness);
        few_end(&f);
    }
}

int test_active_set(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(node_rests_in_corner_of_many_planes),
        cmocka_unit_test(pulling_constraint_opens),
        harness_test(solution_satisfies_law_and_balance),
        harness_test(cycling_ends_loose_or_lost_within_limit),
        cmocka_unit_test(interrupted_search_leaves_balance),
        cmocka_unit_test(abandoned_search_keeps_last_solution),
        cmocka_unit_test(missing_support_is_reported),
        cmocka_unit_test(early_closing_constraint_is_found_on_line_search),
        cmocka_unit_test(slowly_converging_slip_is_not_stalled),
        cmocka_unit_test(deep_closure_is_softened_and_converges),
        cmocka_unit_test(stiffness_is_restored),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
