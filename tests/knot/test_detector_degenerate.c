/* Threads that are no threads: flat, straight, in a point, touching themselves, closed, anything at all. A detector says
 * something finite, the same twice, and nothing that is not so. */
#include <math.h>
#include <string.h>

#include "base/elementary.h"
#include "knot/odd_thread.h"

/* ---- flat */

static void line_is_unknot(void **state)
{
    (void)state;
    odd_begin(ODD_MAX, 256);
    const vec3 along[] = {vec3_make(1.0, 0.0, 0.0), vec3_make(0.0, 0.0, 1.0),
                          vec3_make(0.3, -0.7, 0.2)};
    for (int k = 0; k < 3; k++) {
        for (uint32_t count = 2; count <= 300; count += count < 10 ? 1 : 29) {
            for (uint32_t i = 0; i < count; i++) {
                odd_x[i] = vec3_scale(along[k], 1e-3 * i);
            }
            for (int tissue = 0; tissue < 2; tissue++) {
                odd_hear(count, tissue == 1);
                odd_expect_no_knot();
            }
        }
    }
    odd_end();
}

/* To and fro on one line: all of it touches. */
static void folded_line_terminates(void **state)
{
    (void)state;
    odd_begin(ODD_MAX, 256);
    for (uint32_t k = 1; k < 40; k++) {
        for (uint32_t i = 0; i < 60; i++) {
            odd_x[i] = vec3_make(1e-3 * ((i * k * k) % 13), 0.0, 0.0);
        }
        odd_hear(60, k % 2 == 0);
        assert_int_equal(odd_said.state.throw_count, 0);
        assert_int_not_equal(odd_said.state.name, VBSS_KNOT_NAME_OTHER);
    }
    odd_end();
}

static void point_is_unknot(void **state)
{
    (void)state;
    odd_begin(ODD_MAX, 256);
    for (uint32_t count = 2; count < 200; count += 33) {
        for (uint32_t i = 0; i < count; i++) {
            odd_x[i] = vec3_make(0.1, -0.2, 0.3);
        }
        for (int tissue = 0; tissue < 2; tissue++) {
            odd_hear(count, tissue == 1);
            odd_expect_no_knot();
        }
    }
    odd_end();
}

/* A spiral, a zigzag and a meander in planes of all kinds: no knot, however it is turned. */
static void planar_threads_are_unknots(void **state)
{
    (void)state;
    odd_begin(ODD_MAX, 256);
    vbss_random random;
    vbss_random_seed(&random, 1, 1);
    uint32_t uncertain = 0, heard = 0;
    for (uint32_t k = 0; k < 120; k++) {
        vec3 u = vbss_random_direction(&random), v = vec3_any_normal(u);
        if (k < 30) { /* one of the planes of the axes */
            u = vec3_make(k % 3 == 0, k % 3 == 1, k % 3 == 2);
            v = vec3_make(k % 3 == 1, k % 3 == 2, k % 3 == 0);
        }
        for (uint32_t i = 0; i < 200; i++) {
            double sine, cosine, a = 1e-3 * i, b = 0.0;
            vbss_sincos(0.1 * i, &sine, &cosine);
            if (k % 3 == 0) {
                b = (i % 2 == 0 ? 5e-3 : -5e-3);
            } else if (k % 3 == 1) { /* outward: its beginning lies inside */
                a = 1e-3 * (i + 1) * cosine;
                b = 1e-3 * (i + 1) * sine;
            } else {
                b = 20e-3 * sine;
                a += 5e-3 * vbss_sin(0.2 * i);
            }
            odd_x[i] = vec3_add_scaled(vec3_scale(u, a), b, v);
        }
        odd_hear(200, false);
        heard++;
        if (judge_is_uncertain(&odd_said)) {
            uncertain++;
        } else {
            odd_expect_no_knot();
        }
    }
    print_message("%u of %u flat threads uncertain\n", uncertain, heard);
    assert_true(3 * uncertain <= heard + 6); /* the spirals: a ray in the plane meets them */
    odd_end();
}

/* ---- touching */

/* A thread that goes through a point of its own a second time, where nothing can part it. */
static void self_touching_thread_is_uncertain(void **state)
{
    (void)state;
    static thread_line line;
    throw_stack stack;
    odd_begin(ODD_MAX, 256);
    throw_stack_init(&stack);
    throw_stack_add(&stack, 1, 1);
    throw_stack_add(&stack, 1, -1);
    uint32_t doubted = 0, heard = 0;
    for (uint32_t n = 0; n < 40; n++) {
        assert_true(throw_stack_make(&stack, &line));
        uint32_t a = (uint32_t)line.tissue_place - 20 - n, b = (uint32_t)line.tissue_place + 20 + n;
        vec3 between = vec3_lerp(line.x[a], line.x[b], 0.5);
        line.x[a] = line.x[b] = between; /* both strands bend to the same point */
        memcpy(odd_x, line.x, line.count * sizeof *odd_x);
        odd_hear(line.count, false);
        heard++;
        doubted += judge_is_uncertain(&odd_said);
    }
    print_message("%u of %u uncertain\n", doubted, heard);
    /* What moves take away with the point in it was never part of a knot: both ways past it are the same. */
    assert_int_equal(doubted, heard);
    odd_end();
}

static void closed_threads_terminate(void **state)
{
    (void)state;
    odd_begin(ODD_MAX, 256);
    for (uint32_t k = 0; k < 20; k++) {
        uint32_t count = 40 + k;
        for (uint32_t i = 0; i < count; i++) {
            double sine, cosine,
                turn = 6.28318530717958648 * (i + 1 == count ? 0 : i) / (count - 1.0);
            vbss_sincos((k % 2 == 0 ? 1 : 2) * turn, &sine, &cosine);
            double r = 0.02 + 0.01 * (k % 2) * vbss_cos(3.0 * turn);
            odd_x[i] = vec3_make(r * cosine, r * sine, -0.01 * (k % 2) * vbss_sin(3.0 * turn));
        }
        assert_true(vec3_distance(odd_x[0], odd_x[count - 1]) == 0.0);
        odd_hear(count, k % 4 < 2);
        assert_true(judge_is_uncertain(&odd_said) || odd_said.state.throw_count <= 1);
    }
    odd_end();
}

/* ---- anything at all */

static void expect_sense(harness_source *source, void *user)
{
    uint32_t *uncertain = user, count = 2 + harness_draw_below(source, 30);
    uint32_t kind = harness_draw_below(source, 6);
    for (uint32_t i = 0; i < count; i++) {
        odd_x[i] = harness_draw_vec3(source, -0.05, 0.05);
        if (kind == 1) { /* a coarse grid: touches, doubles, overlaps */
            odd_x[i] = vec3_make(floor(60.0 * odd_x[i].x), floor(60.0 * odd_x[i].y),
                                 floor(60.0 * odd_x[i].z));
        } else if (kind == 2) {
            odd_x[i].z = 0.0;
        } else if (kind == 3) {
            odd_x[i] = vec3_scale(odd_x[i], harness_draw_below(source, 3) == 0 ? 2e4 : 1e-12);
        } else if (kind == 4 && i > 1) {
            odd_x[i] = harness_draw_below(source, 3) == 0 ? odd_x[harness_draw_below(source, i)]
                                                          : odd_x[i];
        }
    }
    odd_hear(count, harness_draw_below(source, 2) == 1);
    *uncertain += judge_is_uncertain(&odd_said);
    if (!judge_is_uncertain(&odd_said)) {
        assert_true(odd_said.state.determinant % 2 == 1 && odd_said.state.determinant > 0);
        assert_true(odd_said.state.signature % 2 == 0 &&
                    odd_said.state.signature_tristram % 2 == 0);
        /* Levine: sigma is 0 modulo 4 just when det is 1 modulo 4. */
        assert_int_equal(odd_said.state.signature % 4 == 0, odd_said.state.determinant % 4 == 1);
        /* Arf: v2 is even just when det is 1 or 7 modulo 8. */
        assert_int_equal(odd_said.state.v2 % 2 == 0, odd_said.state.determinant % 8 == 1 ||
                                                         odd_said.state.determinant % 8 == 7);
    }
}

static void any_input_gives_valid_result(void **state)
{
    (void)state;
    uint32_t uncertain = 0;
    odd_begin(ODD_MAX, 256);
    harness_property("any points", 1000, expect_sense, &uncertain);
    print_message("%u of 1000 uncertain\n", uncertain);
    odd_end();
}

int test_detector_degenerate(void)
{
    const struct CMUnitTest tests[] = {
        harness_test(line_is_unknot),
        harness_test(folded_line_terminates),
        harness_test(point_is_unknot),
        harness_test(planar_threads_are_unknots),
        harness_test(self_touching_thread_is_uncertain),
        harness_test(closed_threads_terminate),
        harness_test(any_input_gives_valid_result),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
