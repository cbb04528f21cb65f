/* The two copies of the hot loops give the same bits; with and without tangent the forces are the same. */
#include <string.h>

#include "drain/shell_sheet.h"

static void expect_same(const void *a, const void *b, size_t size)
{
    assert_memory_equal(a, b, size);
}

typedef struct answer {
    vec3 forces[20];
    block diagonal[20], blocks[SHELL_PAIRS * 24 + 1];
} answer;

static void take_answer(const shell_rig *r, answer *a)
{
    assert_true(r->node_count <= 20 && r->triangle_count <= 24);
    memset(a, 0, sizeof *a);
    memcpy(a->forces, r->forces, r->node_count * sizeof *r->forces);
    memcpy(a->diagonal, r->diagonal, r->node_count * sizeof *r->diagonal);
    memcpy(a->blocks, r->blocks, (r->pair_count + 1) * sizeof *r->blocks);
}

static void copies_agree(harness_source *source, void *user)
{
    (void)user;
    shell_rig r;
    answer answers[2];
    shell_sheet_start(source, &r);
    shell_sheet_deform(source, &r, harness_draw_below(source, 2) == 0 ? 0.4 : 0.0);
    for (int wide = 0; wide < 2; wide++) {
        /* where there is no wide copy, the plain one goes twice */
        r.shell.wide = wide != 0 && vbss_wide_is_available();
        shell_rig_tangent(&r);
        take_answer(&r, &answers[wide]);
        shell_rig_energy(&r);
        expect_same(answers[wide].forces, r.forces, r.node_count * sizeof *r.forces);
    }
    expect_same(&answers[0], &answers[1], sizeof answers[0]);
    shell_rig_end(&r);
}

static void scalar_and_simd_bits_are_equal(void **state)
{
    (void)state;
    harness_property("shells in both copies", 100, copies_agree, NULL);
}

static void dispatch_follows_cpu_features(void **state)
{
    (void)state;
    harness_source source = {0};
    shell_rig r;
    shell_sheet_start(&source, &r);
    assert_int_equal(vbss_wide_is_available(), r.shell.wide);
    shell_rig_end(&r);
}

int test_shell_simd(void)
{
    const struct CMUnitTest tests[] = {
        harness_test(scalar_and_simd_bits_are_equal),
        cmocka_unit_test(dispatch_follows_cpu_features),
    };
    return cmocka_run_group_tests_name("drain.shell_simd", tests, NULL, NULL);
}
