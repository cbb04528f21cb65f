/* Which segments of one chain are no candidates: all nodes lie in one point, so that every pair of boxes
 * overlaps and the list is what the rule leaves. */
#include <math.h>
#include <stdlib.h>

#include "collision/shapes_model.h"

typedef struct fixture {
    harness_memory memory;
    vbss_context *context;
    vbss_collision_config config;
} fixture;

static void begin(fixture *f)
{
    f->context = harness_context(&f->memory);
    expect_ok(vbss_collision_config_init(&f->config, sizeof f->config));
    f->config.pair_capacity = 100000;
}

static void end(fixture *f)
{
    harness_context_end(f->context, &f->memory);
}

static const candidate *find(const fixture *f, uint32_t edges, const double *rest, double radius,
                             uint32_t *count)
{
    vbss_collision *collision;
    uint32_t name;
    expect_ok(vbss_collision_create(f->context, &f->config, &collision));
    expect_ok(vbss_collision_add_chain(collision, edges + 1, rest, radius, &name));
    return shapes_find(collision, count);
}

/* Asserts that exactly the pairs at least `least` edges apart are listed. */
static void expect_apart(const fixture *f, uint32_t edges, const double *rest, double radius,
                         uint32_t smallest)
{
    uint32_t count, next = 0;
    const candidate *listed = find(f, edges, rest, radius, &count);
    for (uint32_t a = 0; a < edges; a++) {
        for (uint32_t b = a + smallest; b < edges; b++) {
            assert_true(next < count);
            assert_int_equal(listed[next].a, a);
            assert_int_equal(listed[next++].b, b);
        }
    }
    assert_int_equal(next, count);
}

static uint32_t two_or_more(uint32_t edges)
{
    return edges < 2 ? 2 : edges;
}

/* Edges b - a = k + 1 have k between them: an arc of k lengths. */
static void exclusion_boundary_is_exact(void **state)
{
    (void)state;
    enum { EDGES = 40 };
    const double lengths[] = {0.125, 0.1, 0.3, 1.0 / 3.0, 1e-3, 7e-5};
    for (size_t i = 0; i < sizeof lengths / sizeof lengths[0]; i++) {
        fixture f;
        double rest[EDGES];
        begin(&f);
        for (int k = 0; k < EDGES; k++) {
            rest[k] = lengths[i];
        }
        for (uint32_t k = 0; k < 20; k++) {
            /* As long as k edges: not shorter, so they are listed; D is thickness and both radii. */
            f.config.exclusion = k;
            f.config.thickness = lengths[i];
            expect_apart(&f, EDGES, rest, 0.0, two_or_more(k + 1));
            f.config.thickness = 0.0;
            expect_apart(&f, EDGES, rest, 0.5 * lengths[i], two_or_more(k + 1));
            f.config.thickness = 0.5 * lengths[i];
            expect_apart(&f, EDGES, rest, 0.25 * lengths[i], two_or_more(k + 1));
            f.config.exclusion = k * (1.0 + DBL_EPSILON);
            expect_apart(&f, EDGES, rest, 0.25 * lengths[i], two_or_more(k > 0 ? k + 2 : 1));
        }
        end(&f);
    }
}

static void neighbours_only_without_rest_lengths(void **state)
{
    (void)state;
    fixture f;
    begin(&f);
    f.config.thickness = 1.0;
    f.config.exclusion = 1e3;
    for (uint32_t edges = 1; edges < 30; edges++) {
        expect_apart(&f, edges, NULL, 0.0, 2);
    }
    double rest[30] = {0.0};
    f.config.exclusion = 0.0;
    for (uint32_t edges = 1; edges < 30; edges++) {
        expect_apart(&f, edges, rest, 0.0, 2);
    }
    end(&f);
}

/* Multiples of 2^-30, whose sums are exact. */
static void uneven(harness_source *source, void *user)
{
    (void)user;
    fixture f;
    double rest[100];
    uint32_t edges = 1 + harness_draw_below(source, 100), count, next = 0;
    begin(&f);
    for (uint32_t i = 0; i < edges; i++) {
        uint32_t bits = 1 + harness_draw_below(source, 30);
        rest[i] = 0x1p-30 * harness_draw_below(source, UINT32_C(1) << bits);
    }
    f.config.thickness = 0x1p-10 * (1 + harness_draw_below(source, 1000));
    f.config.exclusion = 0.25 * harness_draw_below(source, 20);
    const candidate *listed = find(&f, edges, rest, 0.0, &count);
    for (uint32_t a = 0; a < edges; a++) {
        double arc = 0.0;
        for (uint32_t b = a + 2; b < edges; b++) {
            arc += rest[b - 1];
            if (arc >= f.config.exclusion * f.config.thickness) {
                assert_true(next < count);
                assert_int_equal(listed[next].a, a);
                assert_int_equal(listed[next++].b, b);
            }
        }
    }
    assert_int_equal(next, count);
    end(&f);
}

static void uneven_rest_lengths(void **state)
{
    (void)state;
    harness_property("uneven", 300, uneven, NULL);
}

/* Were each pair looked at, this would take hours. */
static void longest_chain_is_added_at_once(void **state)
{
    (void)state;
    enum { EDGES = 65536 };
    fixture f;
    uint32_t count;
    begin(&f);
    double *rest = calloc(EDGES, sizeof *rest);
    assert_non_null(rest);
    f.config.thickness = 1.0;
    (void)find(&f, EDGES, rest, 0.0, &count);
    assert_int_equal(count, 0);
    /* One edge long enough parts the rest into two ends: of 3 and 65532 edges. */
    rest[3] = 2.0;
    f.config.pair_capacity = 200000;
    (void)find(&f, EDGES, rest, 0.0, &count);
    assert_int_equal(count, 3 * 65532);
    free(rest);
    end(&f);
}

int test_exclusion(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(exclusion_boundary_is_exact),
        cmocka_unit_test(neighbours_only_without_rest_lengths),
        harness_test(uneven_rest_lengths),
        cmocka_unit_test(longest_chain_is_added_at_once),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
