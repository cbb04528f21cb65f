/* What one continuous question refuses: configurations, vertices, sizes, and to be asked from inside a
 * callback. */

#include "base/error.h"
#include "harness/float_modes.h"
#include "query.h"
#include "shapes_model.h"

typedef vbss_result (*test_fn)(const vbss_collision_config *config, const double start[12],
                               const double end[12], vbss_collision_impact *impact,
                               uint32_t struct_size);
static const test_fn tests_of[2] = {vbss_collision_test_edges, vbss_collision_test_point_triangle};

/* a0 a1 b0 b1; the same vertices are a point and a triangle. */
static const double start_x[12] = {-1, 0, 1, 1, 0.25, 1, 0.125, -1, 0, 0, 1, 0.125};
static const double end_x[12] = {-1, 0.125, -1, 1, 0, -0.75, 0, -1, 0, 0.25, 1, 0};

static vbss_collision_config defaults(double thickness)
{
    vbss_collision_config config;
    expect_ok(vbss_collision_config_init(&config, sizeof config));
    config.thickness = thickness;
    return config;
}

/* ---- configurations */

static vbss_result config_init(void *config, uint32_t struct_size)
{
    return vbss_collision_config_init(config, struct_size);
}

static vbss_result ask_both(vbss_context *context, const void *config)
{
    vbss_collision_impact impact;
    (void)context;
    VBSS_TRY(vbss_collision_test_edges(config, start_x, end_x, &impact, sizeof impact));
    return vbss_collision_test_point_triangle(config, start_x, end_x, &impact, sizeof impact);
}

static void config_size_protocol(void **state)
{
    (void)state;
    static const uint32_t sizes[] = {64, 0};
    const harness_config protocol = {sizes, config_init, ask_both};
    harness_config_protocol(&protocol);
    const vbss_collision_config config = defaults(0.0);
    for (int kind = 0; kind < 2; kind++) { /* none is the defaults */
        vbss_collision_impact with, without;
        expect_ok(tests_of[kind](&config, start_x, end_x, &with, sizeof with));
        expect_ok(tests_of[kind](NULL, start_x, end_x, &without, sizeof without));
        assert_memory_equal(&with, &without, sizeof with);
    }
}

/* A test of both kinds with one field of the configuration changed; on failure nothing is written. */
static vbss_result ask_with(size_t offset, const void *value, size_t size)
{
    vbss_collision_config config = defaults(0.125);
    memcpy((char *)&config + offset, value, size);
    vbss_collision_impact impact, before;
    memset(&impact, 0xa5, sizeof impact);
    before = impact;
    vbss_result result = vbss_collision_test_edges(&config, start_x, end_x, &impact, sizeof impact);
    if (result != VBSS_OK) {
        assert_memory_equal(&impact, &before, sizeof impact);
    }
    expect_result(result, vbss_collision_test_point_triangle(&config, start_x, end_x, &impact,
                                                             sizeof impact));
    return result;
}

static void bad_config_is_rejected(void **state)
{
    (void)state;
    static const struct {
        size_t offset;
        double bad[3], good[3];
    } numbers[] = {
        {offsetof(vbss_collision_config, thickness), {-1e-3, 1e-31, 1.01e30}, {0.0, 1e-30, 1e30}},
        {offsetof(vbss_collision_config, tolerance), {0.0, 9e-13, 1.01}, {1e-12, 1e-3, 1.0}},
    };
    for (size_t i = 0; i < sizeof numbers / sizeof numbers[0]; i++) {
        for (int k = 0; k < 3; k++) {
            size_t at = numbers[i].offset, size = sizeof(double);
            expect_result(VBSS_ERROR_NOT_FINITE, ask_with(at, &harness_bad_numbers[k], size));
            expect_result(VBSS_ERROR_OUT_OF_RANGE, ask_with(at, &numbers[i].bad[k], size));
            expect_ok(ask_with(at, &numbers[i].good[k], size));
        }
    }
    const int32_t methods[] = {-1, 3, INT32_MAX};
    const uint32_t limits[] = {0, 1000001, UINT32_MAX}, good[] = {1, 77, 1000000};
    for (int k = 0; k < 3; k++) {
        size_t limit = offsetof(vbss_collision_config, pass_limit);
        expect_result(VBSS_ERROR_OUT_OF_RANGE,
                      ask_with(offsetof(vbss_collision_config, method), &methods[k], 4));
        expect_result(VBSS_ERROR_OUT_OF_RANGE, ask_with(limit, &limits[k], 4));
        expect_ok(ask_with(limit, &good[k], 4));
        expect_ok(ask_with(offsetof(vbss_collision_config, method), &k, 4));
    }
    /* Capacities are not read. */
    const uint32_t large = UINT32_MAX;
    expect_ok(ask_with(offsetof(vbss_collision_config, pair_capacity), &large, 4));
}

/* ---- arguments, of the pure functions and through an object */

typedef struct asked {
    vbss_collision *object; /* NULL: the pure functions */
    const double *start, *end;
    uint32_t struct_size;
} asked;

static void expect_refused(vbss_result wanted, const asked *a)
{
    unsigned char out[512], before[512];
    memset(out, 0xa5, sizeof out);
    memcpy(before, out, sizeof out);
    vbss_collision_statistics counted = {0};
    if (a->object != NULL) {
        counted = shapes_statistics(a->object);
    }
    for (vbss_collision_pair_kind kind = 0; kind < 2; kind++) {
        vbss_collision_impact *impact = (void *)out;
        expect_result(wanted, a->object != NULL
                                  ? vbss_collision_test(a->object, kind, a->start, a->end, impact,
                                                        a->struct_size)
                                  : tests_of[kind](NULL, a->start, a->end, impact, a->struct_size));
    }
    assert_memory_equal(out, before, sizeof out);
    if (a->object != NULL) {
        vbss_collision_statistics now = shapes_statistics(a->object);
        assert_memory_equal(&now, &counted, sizeof now);
    }
}

static void expect_all_refused(vbss_collision *object)
{
    double x[12];
    const asked bad_start = {object, x, end_x, sizeof(vbss_collision_impact)};
    const asked bad_end = {object, start_x, x, sizeof(vbss_collision_impact)};
    for (int i = 0; i < 60; i++) {
        double large = i % 2 == 0 ? 1.01e30 : -DBL_MAX;
        memcpy(x, start_x, sizeof x);
        x[i / 5] = i % 5 < 3 ? harness_bad_numbers[i % 5] : large;
        vbss_result wanted = i % 5 < 3 ? VBSS_ERROR_NOT_FINITE : VBSS_ERROR_OUT_OF_RANGE;
        expect_refused(wanted, &bad_start);
        expect_refused(wanted, &bad_end);
    }
    expect_refused(VBSS_ERROR_NULL_ARGUMENT,
                   &(asked){object, NULL, end_x, sizeof(vbss_collision_impact)});
    expect_refused(VBSS_ERROR_NULL_ARGUMENT,
                   &(asked){object, start_x, NULL, sizeof(vbss_collision_impact)});
    for (uint32_t size = 0; size < sizeof(vbss_collision_impact); size++) {
        expect_refused(VBSS_ERROR_STRUCT_SIZE, &(asked){object, start_x, end_x, size});
    }
    expect_refused(VBSS_ERROR_STRUCT_SIZE, &(asked){object, start_x, end_x, UINT32_MAX});
}

static void host_mode_does_not_change_impacts(void **state)
{
    (void)state;
    for (int kind = 0; kind < 2; kind++) {
        vbss_collision_impact wanted, found;
        expect_ok(tests_of[kind](NULL, start_x, end_x, &wanted, sizeof wanted));
        for (size_t k = 0; k < harness_mode_count; k++) {
            harness_mode_set(k);
            vbss_result result = tests_of[kind](NULL, start_x, end_x, &found, sizeof found);
            harness_mode_end(k);
            expect_ok(result);
            assert_memory_equal(&wanted, &found, sizeof wanted);
        }
    }
}

static void bad_query_is_rejected_without_output_or_count(void **state)
{
    (void)state;
    harness_memory memory;
    vbss_context *context = harness_context(&memory);
    vbss_collision *object;
    vbss_collision_impact impact;
    expect_ok(vbss_collision_create(context, NULL, &object));
    expect_all_refused(NULL);
    expect_all_refused(object);
    const uint32_t size = sizeof impact;
    expect_result(VBSS_ERROR_NULL_ARGUMENT,
                  vbss_collision_test_edges(NULL, start_x, end_x, NULL, size));
    expect_result(VBSS_ERROR_NULL_ARGUMENT,
                  vbss_collision_test(object, 0, start_x, end_x, NULL, size));
    for (vbss_collision_pair_kind kind = -1; kind < 4; kind += 3) {
        expect_result(VBSS_ERROR_OUT_OF_RANGE,
                      vbss_collision_test(object, kind, start_x, end_x, &impact, size));
    }
    unsigned char out[512];
    memset(out, 0xff, sizeof out); /* a newer header: zeros beyond what is known */
    expect_ok(vbss_collision_test_edges(NULL, start_x, end_x, (void *)out, 300));
    expect_ok(vbss_collision_test_edges(NULL, start_x, end_x, &impact, size));
    assert_memory_equal(out, &impact, size);
    for (uint32_t i = size; i < sizeof out; i++) {
        assert_int_equal(out[i], i < 300 ? 0 : 0xff);
    }
    harness_context_end(context, &memory);
}

typedef struct listener {
    vbss_collision *object;
    vbss_result counted, pure;
    int heard;
} listener;

static void listen(void *user, vbss_log_level level, const char *message)
{
    listener *l = user;
    vbss_collision_impact impact;
    (void)level;
    (void)message;
    if (l->heard++ == 0) { /* what it is refused is logged, too */
        l->counted = vbss_collision_test(l->object, 0, start_x, end_x, &impact, sizeof impact);
        l->pure = vbss_collision_test_edges(NULL, start_x, end_x, &impact, sizeof impact);
    }
}

static void counting_test_inside_callback_is_rejected(void **state)
{
    (void)state;
    listener l = {0};
    harness_memory memory;
    vbss_context_config config = harness_watched_config(&memory);
    config.log = listen;
    config.log_user = &l;
    vbss_context *context;
    vbss_collision_impact impact;
    expect_ok(vbss_context_create(&config, &context));
    expect_ok(vbss_collision_create(context, NULL, &l.object));
    expect_result(VBSS_ERROR_OUT_OF_RANGE,
                  vbss_collision_test(l.object, 9, start_x, end_x, &impact, sizeof impact));
    assert_true(l.heard > 0);
    expect_result(VBSS_ERROR_BUSY, l.counted);
    expect_ok(l.pure);
    assert_int_equal(shapes_statistics(l.object).queries, 0);
    harness_context_end(context, &memory);
}

int test_continuous_refusals(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(config_size_protocol),
        cmocka_unit_test(bad_config_is_rejected),
        cmocka_unit_test(bad_query_is_rejected_without_output_or_count),
        cmocka_unit_test(host_mode_does_not_change_impacts),
        cmocka_unit_test(counting_test_inside_callback_is_rejected),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
