/* What is pulled through a sleeve: a mass, in steps; what the row remembers from part to part. */
#include "few_blocks.h"

static const double k = FEW_SLEEVE_STIFFNESS, smallest = FEW_SLEEVE_MIN, damping = 0.5;
static const double grip[2] = FEW_SLEEVE_GRIP;

/* ---- a mass of 1 g on it, in steps */

typedef struct pulled {
    few_blocks f;
    double held, h;
    vec3 x, v;
} pulled;

/* Backward Euler; along x, pressed across by 0.5 N. What is held is all that was found. Returns the row's force along. */
static double pull(pulled *p, double force)
{
    const double mass = 1e-3;
    few_blocks *f = &p->f;
    vbss_contact_clear(f->set);
    contact_constraint *row = few_plane(f, 0, 0, vec3_make(1.0, 0.0, 0.0));
    const contact_key key = row->key;
    *row = few_sleeve(row->normal);
    row->key = key;
    row->jacobian_block_count = 1;
    row->jacobian[0] = (contact_jacobian_block){.block = 0, .weight = 1.0};
    row->relative_displacement = across(p->x, row->normal);
    row->viscous_stiffness = damping / p->h;
    row->previous_force = vec3_make(p->held, 0.0, 0.0);
    vbss_contact_warm_start(f->set);
    f->stiffness[0] = mat3_scale(mat3_identity(), mass / (p->h * p->h));
    f->force[0] = vec3_add_scaled(vec3_make(force, 0.3, -0.4), mass / p->h, p->v);
    assert_int_equal(few_solve(f), CONTACT_CONVERGED);
    const vec3 u = f->system->solution[0];
    contact_solution is;
    (void)vbss_contact_update_solution(&f->set->constraints[0], u, &is);
    vbss_contact_store_warm_start(f->set);
    p->x = vec3_add(p->x, u);
    p->v = vec3_scale(u, 1.0 / p->h);
    p->held = is.normal_force;
    return is.normal_force;
}

static void begin_pulled(pulled *p, double h)
{
    *p = (pulled){.h = h};
    few_begin(&p->f, 1);
}

static void below_yield_is_reversible(void **state)
{
    (void)state;
    pulled p;
    begin_pulled(&p, 1e-3);
    for (int sign = -1; sign <= 1; sign += 2) {
        double force = sign * 0.95 * (smallest + 0.5 * grip[sign < 0]);
        for (int i = 0; i < 1000; i++) {
            (void)pull(&p, i < 500 ? 0.0 : force);
        }
        expect_near(force / k, p.x.x, 1e-10);
        expect_near(-force, p.held, 1e-6);
    }
    for (int i = 0; i < 1000; i++) {
        (void)pull(&p, 0.0);
    }
    expect_near(0.0, p.x.x, 1e-10);
    few_end(&p.f);
}

/* At (F - most) / c, each way with its own grip, to rounding whatever the step; and all that is held comes back. */
static void above_yield_speed_is_step_independent(void **state)
{
    (void)state;
    const double steps[] = {1e-3, 0.25e-3, 4e-3};
    for (int i = 0; i < 3; i++) {
        for (int sign = -1; sign <= 1; sign += 2) {
            pulled p;
            begin_pulled(&p, steps[i]);
            for (int n = 0; n < 400; n++) {
                (void)pull(&p, n < 100 ? 0.0 : 0.6 * sign);
            }
            double largest = smallest + 0.5 * grip[sign < 0];
            expect_near(sign * (0.6 - largest) / damping, p.v.x, 1e-9);
            expect_near(-sign * (largest + damping * fabs(p.v.x)), p.held, 1e-9);
            double far = p.x.x;
            for (int n = 0; n < 4000; n++) {
                (void)pull(&p, 0.0);
            }
            assert_true(fabs(p.v.x) < 1e-9);
            assert_true(sign * p.x.x > sign * far - 1.01 * 0.6 / k);
            few_end(&p.f);
        }
    }
}

/* Pulled through and left: what was put in is what it has rubbed, and what is still held. */
static void input_work_equals_dissipation_plus_stored_energy(void **state)
{
    (void)state;
    pulled p;
    double work = 0.0, rubbed = 0.0;
    begin_pulled(&p, 0.1e-3);
    for (int n = 0; n < 12000; n++) {
        const vec3 before = p.x;
        double held = p.held, force = n < 6000 ? 0.6 : 0.0;
        double pushed = pull(&p, force), moved = p.x.x - before.x;
        work += vec3_dot(vec3_make(force, 0.3, -0.4), vec3_sub(p.x, before));
        double rubs = -pushed * moved - 0.5 * (p.held * p.held - held * held) / k;
        assert_true(rubs >= -1e-15);
        rubbed += rubs;
    }
    double kept = 0.5 * k * (p.x.y * p.x.y + p.x.z * p.x.z) + 0.5 * p.held * p.held / k;
    kept += 0.5e-3 * vec3_norm_squared(p.v);
    assert_true(work > 1e-2);
    assert_true(rubbed + kept <= work);
    expect_near(work, rubbed + kept, 2e-3 * work); /* backward Euler loses some */
    few_end(&p.f);
}

/* ---- from part to part */

static void sleeve_keeps_its_initial_offset(void **state)
{
    (void)state;
    const vec3 held = vec3_make(0.3, 0.0, 0.0);
    few_blocks f;
    few_begin(&f, 1);
    for (int i = 0; i < 4; i++) { /* is it remembered, is it a sleeve */
        f.set->warm_start_count = 0;
        if (i % 2 == 1) {
            f.set->warm_start[f.set->warm_start_count++] =
                (contact_warm_start_entry){.key = {3, 1, 0, 0, 0},
                                           .status = CONTACT_SLIP,
                                           .is_forward = true,
                                           .normal_force = -0.7,
                                           .tangential_force = {0.0, 0.3, -0.4}};
        }
        vbss_contact_clear(f.set);
        contact_constraint *row = few_plane(&f, 0, 0, vec3_make(1.0, 0.0, 0.0));
        row->is_bilateral = true;
        row->is_sleeve = i >= 2;
        row->previous_force = held;
        vbss_contact_warm_start(f.set);
        vec3 other = i % 2 == 1 ? vec3_make(0.0, 0.3, -0.4) : vec3_zero();
        expect_near(0.0, vec3_distance(row->previous_force, row->is_sleeve ? held : other), 1e-15);
        expect_near(0.0, vec3_distance(row->solution.tangential_force, other), 1e-15);
        assert_int_equal(row->solution.status, i % 2 == 1 ? CONTACT_SLIP : CONTACT_STICK);
        if (i == 3) {
            expect_near(-0.7, row->solution.normal_force, 0.0);
            assert_true(row->solution.is_forward);
            expect_near(0.0, vec3_distance(row->solution.slip_direction, vec3_make(0.0, 0.6, -0.8)),
                        1e-15);
        }
    }
    few_end(&f);
}

static void reused_slot_is_no_sleeve(void **state)
{
    (void)state;
    few_blocks f;
    contact_linearisation t;
    few_begin(&f, 1);
    contact_constraint *row = few_plane(&f, 0, 0, vec3_make(1.0, 0.0, 0.0));
    row->is_bilateral = row->is_sleeve = true;
    row->previous_force = vec3_make(0.3, 0.0, 0.0);
    vbss_contact_clear(f.set);
    row = few_plane(&f, 1, 0, vec3_make(1.0, 0.0, 0.0));
    row->gap = 1e-3;
    assert_false(row->is_sleeve);
    vbss_contact_linearise(row, &t);
    assert_int_equal(t.count, 0);
    few_end(&f);
}

int test_eyelet_pulled(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(below_yield_is_reversible),
        cmocka_unit_test(above_yield_speed_is_step_independent),
        cmocka_unit_test(input_work_equals_dissipation_plus_stored_energy),
        cmocka_unit_test(sleeve_keeps_its_initial_offset),
        cmocka_unit_test(reused_slot_is_no_sleeve),
    };
    return cmocka_run_group_tests_name("contact.eyelet_pulled", tests, NULL, NULL);
}
