/* The work along the way of a solve: four rows at a time, with the bits of one row after another. */
#include "base/simd_dispatch.h"
#include "few_blocks.h"

static vec3 draw(harness_source *source, double size)
{
    return harness_draw_vec3(source, -size, size);
}

static void draw_sleeve(harness_source *source, contact_constraint *row)
{
    row->is_bilateral = row->is_sleeve = true;
    row->yield_force[0] = harness_draw_real(source, 0.0, 0.5);
    row->yield_force[1] = harness_draw_real(source, 0.0, 0.5);
    row->yield_friction[0] = -harness_draw_real(source, 0.0, 0.3);
    row->yield_friction[1] = harness_draw_real(source, 0.0, 0.3);
    row->viscous_stiffness = harness_draw_real(source, 1.0, 1e3);
}

/* Open, pressed, beyond the cone and within, with friction and without, soft in the plane, tied, or a sleeve. */
static void draw_row(harness_source *source, few_blocks *f, uint32_t feature)
{
    vec3 normal = vec3_unit_or(draw(source, 1.0), vec3_make(1.0, 0.0, 0.0));
    contact_constraint *row = few_plane(f, feature, feature % FEW_BLOCKS, normal);
    row->gap = harness_draw_real(source, -2e-5, 1e-5);
    row->relative_displacement = draw(source, 1e-5);
    row->previous_force = across(draw(source, 2.0), normal);
    row->friction = harness_draw_below(source, 4) == 0 ? 0.0 : harness_draw_real(source, 0.1, 1.0);
    row->tangential_stiffness_ratio =
        harness_draw_below(source, 3) == 0 ? harness_draw_real(source, 0.01, 1.0) : 0.0;
    row->is_bilateral = harness_draw_below(source, 5) == 0;
    if (harness_draw_below(source, 6) == 0) {
        draw_sleeve(source, row);
    }
}

static double work_of_rows(const contact_set *set, double share)
{
    double sum = 0.0;
    for (uint32_t i = 0; i < set->count; i++) {
        const contact_iterate at =
            contact_iterate_lerp(&set->current[i], &set->candidate[i], share);
        vec3 missed = vec3_sub(at.force, vbss_contact_force(&set->constraints[i], at.u));
        sum += vec3_dot(missed, vec3_sub(set->candidate[i].u, set->current[i].u));
    }
    return sum;
}

static void expect_same_work(const few_blocks *f, double share)
{
    const double one_by_one = work_of_rows(f->set, share);
    for (int wide = 0; wide < 2; wide++) {
        bool is_wide = wide != 0 && vbss_wide_is_available();
        vbss_contact_begin_line_search(f->set, is_wide);
        const double by_fours = vbss_contact_line_search_slope(f->set, is_wide, share);
        assert_memory_equal(&by_fours, &one_by_one, sizeof one_by_one);
    }
}

static void work_by_fours_has_the_bits_of_row_after_row(harness_source *source, void *user)
{
    few_blocks f;
    uint32_t rows = harness_draw_below(source, FEW_ROWS + 1);
    (void)user;
    few_begin(&f, FEW_BLOCKS);
    vbss_contact_clear(f.set);
    for (uint32_t i = 0; i < rows; i++) {
        draw_row(source, &f, i);
        f.set->current[i] = (contact_iterate){draw(source, 2e-5), draw(source, 3.0)};
        f.set->candidate[i] = (contact_iterate){draw(source, 2e-5), draw(source, 3.0)};
    }
    const double shares[] = {0.0, 0.005, harness_draw_real(source, 0.0, 1.0), 1.0};
    for (int i = 0; i < 4; i++) {
        expect_same_work(&f, shares[i]);
    }
    few_end(&f);
}

static void simd_slope_equals_scalar_slope(void **state)
{
    (void)state;
    harness_property("same bits", 300, work_by_fours_has_the_bits_of_row_after_row, NULL);
}

int test_slope_simd(void)
{
    const struct CMUnitTest tests[] = {
        harness_test(simd_slope_equals_scalar_slope),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
