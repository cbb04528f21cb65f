/* Rows that hold up to a bound: elastic below it, viscous beyond, with a memory; what a mass does that is pulled over it. */
#include "few_blocks.h"

static const double k = 2e4, beyond = 500.0, bound = 0.25;

static contact_row bounded_row(vec3 normal)
{
    contact_row row = {.normal = normal,
                       .stiffness = k,
                       .bilateral = true,
                       .bound = bound,
                       .beyond = beyond,
                       .thickness = 1.0};
    row.is.state = CONTACT_STICK;
    return row;
}

/* In closed form. */
static double law(double held, double slid)
{
    double trial = held - k * slid, most = copysign(bound, trial);
    return fabs(trial) <= bound ? trial : most - beyond * (slid - (held - most) / k);
}

static double force_at(const contact_row *row, double u, contact_found *next)
{
    (void)vbss_contact_next_state(row, vec3_scale(row->normal, u), next);
    return next->pressure;
}

/* ---- the law */

static void any_row_follows_the_law(harness_source *source, void *user)
{
    (void)user;
    contact_found next;
    contact_tangent t;
    vec3 normal = vec3_unit_or(harness_draw_vec3(source, -1.0, 1.0), vec3_make(1.0, 0.0, 0.0));
    contact_row row = bounded_row(normal);
    double held = harness_draw_real(source, -bound, bound);
    double slid = harness_draw_real(source, -1e-4, 1e-4);
    double u = harness_draw_real(source, -1e-4, 1e-4);
    vec3 side = across(harness_draw_vec3(source, -1e-3, 1e-3), normal);
    row.held = vec3_scale(normal, held);
    row.slid = vec3_add(side, vec3_scale(normal, slid)); /* what lies across is free */
    double wanted = law(held, slid + u);
    expect_near(wanted, force_at(&row, u, &next), 1e-9);
    assert_int_equal(next.state,
                     fabs(held - k * (slid + u)) <= bound ? CONTACT_STICK : CONTACT_SLIP);
    assert_true(next.share >= 0.0 && next.share <= 1.0); /* as states of rows are saved */
    expect_near(0.0, vec3_norm(next.rubbing), 0.0);
    /* There nothing is missed, and the linear law is the law. */
    row.slid = vec3_add_scaled(row.slid, u, normal);
    row.is = next;
    contact_found again;
    expect_near(0.0, vbss_contact_next_state(&row, vec3_zero(), &again), 1e-12);
    vbss_contact_linear_law(&row, &t);
    assert_int_equal(t.count, 1);
    expect_near(wanted, vec3_dot(t.force, normal), 1e-9);
    expect_near(next.state == CONTACT_SLIP ? beyond : k, t.stiffness[0], 0.0);
    expect_near(0.0, vec3_distance(t.left[0], t.right[0]), 0.0); /* symmetric */
    expect_near(wanted, vec3_dot(vbss_contact_force(&row, vec3_zero()), normal), 1e-9);
    expect_near(wanted, vec3_dot(vbss_contact_linear_force(&row, vec3_zero()), normal), 1e-9);
}

static void it_is_elastic_up_to_the_bound_and_viscous_beyond(void **state)
{
    (void)state;
    harness_property("law", 1000, any_row_follows_the_law, NULL);
}

static void both_ways_are_alike(void **state)
{
    (void)state;
    contact_found next;
    contact_row row = bounded_row(vec3_make(0.0, 0.0, 1.0));
    for (int i = 1; i <= 1000; i++) {
        double u = 1e-6 * i, there = force_at(&row, u, &next);
        expect_near(-there, force_at(&row, -u, &next), 1e-15);
    }
}

/* ---- a mass of 1 g on it, in steps */

typedef struct pulled {
    few_blocks f;
    double x, v, held, h;
} pulled;

/* Backward Euler; what is held is cut back to the bound, as a hole keeps it. Returns the row's force. */
static double pull(pulled *p, double force)
{
    const double mass = 1e-3;
    few_blocks *f = &p->f;
    vbss_contact_begin(f->set);
    contact_row *row = few_plane(f, 0, 0, vec3_make(1.0, 0.0, 0.0));
    row->bilateral = true;
    row->stiffness = k;
    row->friction = row->gap = 0.0;
    row->slid = vec3_zero();
    row->thickness = 1.0;
    row->bound = bound;
    row->beyond = 0.5 / p->h;
    row->held = vec3_make(p->held, 0.0, 0.0);
    row->is.state = CONTACT_STICK;
    f->stiffness[0] = mat3_scale(mat3_identity(), mass / (p->h * p->h));
    f->force[0] = vec3_make(force + mass * p->v / p->h, 0.0, 0.0);
    assert_int_equal(few_solve(f), CONTACT_FOUND);
    double u = f->system->solution[0].x;
    contact_found is;
    row = &f->set->rows[0];
    (void)vbss_contact_next_state(row, f->system->solution[0], &is);
    p->x += u;
    p->v = u / p->h;
    p->held = greater(-bound, lesser(is.pressure, bound));
    return is.pressure;
}

static void begin_pulled(pulled *p, double h)
{
    *p = (pulled){.h = h};
    few_begin(&p->f, 1);
}

static void below_the_bound_it_stays_and_comes_back(void **state)
{
    (void)state;
    pulled p;
    begin_pulled(&p, 1e-3);
    for (int i = 0; i < 2000; i++) {
        (void)pull(&p, 0.9 * bound);
    }
    expect_near(0.9 * bound / k, p.x, 1e-12);
    expect_near(-0.9 * bound, p.held, 1e-9);
    for (int i = 0; i < 2000; i++) {
        (void)pull(&p, 0.0);
    }
    expect_near(0.0, p.x, 1e-12);
    few_end(&p.f);
}

/* At (F - B) / c, whatever the step. */
static void above_the_bound_it_goes_on_at_a_speed(void **state)
{
    (void)state;
    const double steps[] = {1e-3, 0.25e-3, 4e-3};
    for (int i = 0; i < 3; i++) {
        for (int sign = -1; sign <= 1; sign += 2) {
            pulled p;
            begin_pulled(&p, steps[i]);
            for (int n = 0; n < 400; n++) {
                (void)pull(&p, sign * 2.0 * bound);
            }
            expect_near(sign * bound / 0.5, p.v, 1e-6);
            expect_near(-sign * bound, p.held, 0.0); /* what is viscous is not kept */
            /* It is let go: only what was elastic comes back. */
            double far = p.x;
            for (int n = 0; n < 4000; n++) {
                (void)pull(&p, 0.0);
            }
            assert_true(fabs(p.v) < 1e-6);
            assert_true(sign * p.x > sign * far - 1.01 * bound / k);
            few_end(&p.f);
        }
    }
}

/* Pulled over and left: what was put in is what it has rubbed, and what is still held. */
static void what_is_put_in_is_rubbed_away(void **state)
{
    (void)state;
    pulled p;
    double work = 0.0, rubbed = 0.0;
    begin_pulled(&p, 0.1e-3);
    for (int n = 0; n < 20000; n++) {
        double before = p.x, held = p.held, force = n < 10000 ? 0.4 : 0.0;
        double pushed = pull(&p, force), moved = p.x - before;
        work += force * moved;
        rubbed -= pushed * moved + 0.5 * (p.held * p.held - held * held) / k;
        assert_true(rubbed >= -1e-12);
    }
    double kept = 0.5 * p.held * p.held / k + 0.5e-3 * p.v * p.v;
    assert_true(work > 1e-2);
    assert_true(rubbed + kept <= work);
    expect_near(work, rubbed + kept, 2e-3 * work); /* backward Euler loses some */
    few_end(&p.f);
}

/* ---- rows have their places in turn */

static void a_row_in_the_place_of_a_bounded_one_has_no_bound(void **state)
{
    (void)state;
    few_blocks f;
    few_begin(&f, 1);
    contact_row *row = few_plane(&f, 0, 0, vec3_make(1.0, 0.0, 0.0));
    row->bound = bound;
    row->beyond = beyond;
    vbss_contact_begin(f.set);
    row = few_plane(&f, 1, 0, vec3_make(1.0, 0.0, 0.0));
    expect_near(0.0, row->bound, 0.0);
    expect_near(0.0, row->beyond, 0.0);
    few_end(&f);
}

int test_bounded(void)
{
    const struct CMUnitTest tests[] = {
        harness_test(it_is_elastic_up_to_the_bound_and_viscous_beyond),
        cmocka_unit_test(both_ways_are_alike),
        cmocka_unit_test(below_the_bound_it_stays_and_comes_back),
        cmocka_unit_test(above_the_bound_it_goes_on_at_a_speed),
        cmocka_unit_test(what_is_put_in_is_rubbed_away),
        cmocka_unit_test(a_row_in_the_place_of_a_bounded_one_has_no_bound),
    };
    return cmocka_run_group_tests_name("contact.bounded", tests, NULL, NULL);
}
