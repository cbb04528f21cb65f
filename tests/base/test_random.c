#include <math.h>

#include "harness/harness.h"

/* Seed 42, sequence 54: the sequence printed by the generator's published demonstration. */
static void sequence_matches_published_generator(void **state)
{
    (void)state;
    const uint32_t published[] = {0xa15c02b7u, 0x7b47f409u, 0xba1d3330u,
                                  0x83d2f293u, 0xbfa4784bu, 0xcbed606eu};
    vbss_random random;
    vbss_random_seed(&random, 42, 54);
    for (int i = 0; i < 6; i++) {
        assert_int_equal(vbss_random_u32(&random), published[i]);
    }
}

static void streams_of_one_seed_differ(void **state)
{
    (void)state;
    vbss_random a, b;
    int same = 0;
    vbss_random_seed(&a, 1, 0);
    vbss_random_seed(&b, 1, 1);
    for (int i = 0; i < 1000; i++) {
        same += vbss_random_u32(&a) == vbss_random_u32(&b);
    }
    assert_true(same < 3);
    /* Sequences that differ in a high bit only. */
    vbss_random_seed(&a, 1, 1);
    vbss_random_seed(&b, 1, 1 + (UINT64_C(1) << 40));
    assert_true(vbss_random_u64(&a) != vbss_random_u64(&b) ||
                vbss_random_u64(&a) != vbss_random_u64(&b));
}

static void bounded_integers_are_uniform(void **state)
{
    (void)state;
    enum { BOUND = 12, DRAWS = 120000 };
    int counts[BOUND] = {0};
    vbss_random random;
    vbss_random_seed(&random, 7, 0);
    for (int i = 0; i < DRAWS; i++) {
        uint32_t drawn = vbss_random_below(&random, BOUND);
        assert_true(drawn < BOUND);
        counts[drawn]++;
    }
    double chi2 = 0.0, mean = (double)DRAWS / BOUND;
    for (int i = 0; i < BOUND; i++) {
        chi2 += (counts[i] - mean) * (counts[i] - mean) / mean;
    }
    assert_true(chi2 < 31.3); /* 0.1 % of fair generators with 11 degrees of freedom exceed it */
    assert_int_equal(vbss_random_below(&random, 1), 0);
    assert_true(vbss_random_below(&random, 0x80000001u) < 0x80000001u);
}

/* A bound of three quarters of the range: without rejection the lowest third would come twice as
 * often as the others. */
static void large_bounds_are_uniform(void **state)
{
    (void)state;
    enum { DRAWS = 60000 };
    vbss_random random;
    vbss_random_seed(&random, 8, 0);
    int low = 0;
    for (int i = 0; i < DRAWS; i++) {
        low += vbss_random_below(&random, 3u << 30) < 1u << 30;
    }
    expect_near(1.0 / 3.0, (double)low / DRAWS, 5 * 0.4714 / sqrt((double)DRAWS));
}

static void uniform_and_normal_moments(void **state)
{
    (void)state;
    enum { DRAWS = 200000 };
    double u1 = 0.0, u2 = 0.0, n1 = 0.0, n2 = 0.0, n4 = 0.0;
    vec3 d1 = vec3_zero();
    double dzz = 0.0, dzzzz = 0.0;
    vbss_random random;
    vbss_random_seed(&random, 11, 0);
    for (int i = 0; i < DRAWS; i++) {
        double u = vbss_random_uniform(&random);
        assert_true(u >= 0.0 && u < 1.0);
        u1 += u;
        u2 += u * u;
        double n = vbss_random_normal(&random);
        n1 += n;
        n2 += n * n;
        n4 += n * n * n * n;
        vec3 d = vbss_random_direction(&random);
        expect_near(1.0, vec3_norm(d), 4e-16);
        d1 = vec3_add(d1, d);
        dzz += d.z * d.z;
        dzzzz += d.z * d.z * d.z * d.z;
    }
    /* Bounds of five standard deviations of the mean. */
    double root = sqrt((double)DRAWS);
    expect_near(0.5, u1 / DRAWS, 5 * 0.2887 / root);
    expect_near(1.0 / 3.0, u2 / DRAWS, 5 * 0.2981 / root);
    expect_near(0.0, n1 / DRAWS, 5 / root);
    expect_near(1.0, n2 / DRAWS, 5 * 1.4142 / root);
    expect_near(3.0, n4 / DRAWS, 5 * 9.798 / root);
    expect_near(0.0, vec3_norm(d1) / DRAWS, 5 * 1.0 / root);
    expect_near(1.0 / 3.0, dzz / DRAWS, 5 * 0.2981 / root);
    expect_near(1.0 / 5.0, dzzzz / DRAWS, 5 * 0.2667 / root); /* the cube's would be 0.185 */
}

static void restored_generator_continues(void **state)
{
    (void)state;
    uint8_t bytes[256];
    vbss_random random, again;
    vbss_random_seed(&random, 5, 6);
    vbss_random_u32(&random);
    vbss_stream stream;
    vbss_stream_begin_write(&stream, bytes, sizeof bytes);
    vbss_random_serialise(&stream, 1, &random);
    expect_ok(stream.result);
    size_t count = stream.position;
    vbss_random_seed(&again, 0, 0);
    vbss_stream_begin_read(&stream, bytes, count);
    vbss_random_serialise(&stream, 1, &again);
    expect_ok(stream.result);
    for (int i = 0; i < 10; i++) {
        assert_int_equal(vbss_random_u32(&again), vbss_random_u32(&random));
    }
    /* An even increment is no generator. */
    bytes[16] &= 0xfe;
    vbss_random before = again;
    vbss_stream_begin_read(&stream, bytes, count);
    vbss_random_serialise(&stream, 1, &again);
    expect_result(VBSS_ERROR_CORRUPT, stream.result);
    assert_memory_equal(&before, &again, sizeof again);
}

int test_random(void)
{
    const struct CMUnitTest tests[] = {
        harness_test(sequence_matches_published_generator),
        harness_test(streams_of_one_seed_differ),
        harness_test(bounded_integers_are_uniform),
        harness_test(large_bounds_are_uniform),
        harness_test(uniform_and_normal_moments),
        harness_test(restored_generator_continues),
    };
    return cmocka_run_group_tests_name("base.random", tests, NULL, NULL);
}
