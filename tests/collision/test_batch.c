/* Questions in rows through an object: as many single tests, none of which is told when one is refused. */
#include <stdlib.h>

#include "base/error.h"
#include "query.h"
#include "harness/float_modes.h"
#include "shapes_model.h"

enum { MAX_COUNT = 64, STRIDE = MAX_COUNT + 1, PATTERN = 0xa5 };

typedef struct outputs {
    int32_t hit[STRIDE], decision[STRIDE];
    double time[STRIDE], normal[3 * STRIDE], weights[4 * STRIDE];
} outputs;

/* Rows in blocks that end with the last question, so that a sanitizer sees what reads beyond. */
typedef struct rows {
    double *start, *end, *thickness;
} rows;

typedef struct fixture {
    harness_memory memory;
    vbss_context *context;
    vbss_collision *object;
    collision_set set;
    rows rows;
    outputs out;
    vbss_collision_batch batch;
} fixture;

static void begin(fixture *f, uint32_t which, uint32_t count, uint32_t stride)
{
    vbss_collision_config config;
    memset(f, 0, sizeof *f);
    f->context = harness_context(&f->memory);
    expect_ok(vbss_collision_config_init(&config, sizeof config));
    config.thickness = COLLISION_THICKNESS;
    expect_ok(vbss_collision_create(f->context, &config, &f->object));
    make_thick_set(which, MAX_COUNT, 51, &f->set);
    size_t cells = 11 * (size_t)stride + count;
    f->rows = (rows){malloc(cells * sizeof(double)), malloc(cells * sizeof(double)),
                     malloc((size_t)count * sizeof(double))};
    assert_true(f->rows.start != NULL && f->rows.end != NULL && f->rows.thickness != NULL);
    for (size_t i = 0; i < cells; i++) {
        size_t row = i / stride, column = i % stride;
        f->rows.start[i] = column < count ? f->set.queries[column].start[row] : (double)NAN;
        f->rows.end[i] = column < count ? f->set.queries[column].end[row] : (double)NAN;
    }
    for (uint32_t i = 0; i < count; i++) {
        f->rows.thickness[i] = i % 4 == 0 ? 0.0 : COLLISION_THICKNESS * i / 10.0;
    }
    memset(&f->out, PATTERN, sizeof f->out);
    expect_ok(vbss_collision_batch_init(&f->batch, sizeof f->batch));
    f->batch.kind = f->set.queries[0].kind;
    f->batch.count = count;
    f->batch.stride = stride;
    f->batch.start = f->rows.start;
    f->batch.end = f->rows.end;
    f->batch.hit = f->out.hit;
    f->batch.decision = f->out.decision;
    f->batch.time = f->out.time;
    f->batch.normal = f->out.normal;
    f->batch.weights = f->out.weights;
}

static void end(fixture *f)
{
    free(f->rows.start);
    free(f->rows.end);
    free(f->rows.thickness);
    collision_set_release(&f->set);
    harness_context_end(f->context, &f->memory);
}

/* ---- answers */

/* The same by single tests; an object has one thickness. */
static void ask_singly(const fixture *f, vbss_collision_method method, outputs *o,
                       vbss_collision_statistics *sum, uint64_t *sign_tests_ended)
{
    memset(o, PATTERN, sizeof *o);
    memset(sum, 0, sizeof *sum);
    *sign_tests_ended = 0;
    for (uint32_t i = 0; i < f->batch.count; i++) {
        vbss_collision_config config;
        vbss_collision *object;
        vbss_collision_impact impact;
        expect_ok(vbss_collision_config_init(&config, sizeof config));
        config.method = method;
        config.thickness = f->batch.thickness != NULL ? f->batch.thickness[i] : COLLISION_THICKNESS;
        config.pair_capacity = 16;
        expect_ok(vbss_collision_create(f->context, &config, &object));
        expect_ok(vbss_collision_test(object, f->batch.kind, f->set.queries[i].start,
                                      f->set.queries[i].end, &impact, sizeof impact));
        vbss_collision_statistics s = shapes_statistics(object);
        *sign_tests_ended += shapes_sign_tests_ended(object);
        expect_ok(vbss_collision_destroy(object));
        sum->queries += s.queries;
        sum->hits += s.hits;
        sum->undecided += s.undecided;
        sum->exact += s.exact;
        sum->passes += s.passes;
        o->hit[i] = impact.hit;
        o->decision[i] = impact.decision;
        o->time[i] = impact.time;
        for (size_t k = 0; k < 4; k++) {
            o->weights[k * f->batch.stride + i] = impact.weights[k];
            if (k < 3) {
                o->normal[k * f->batch.stride + i] = impact.normal[k];
            }
        }
    }
    sum->struct_size = sizeof *sum;
}

static void batch_equals_single_tests(void **state)
{
    (void)state;
    const uint32_t counts[] = {1, 4, 7, MAX_COUNT};
    for (uint32_t i = 0; i < 3 * (thick_set_count() - 1); i++) {
        fixture f;
        outputs wanted;
        vbss_collision_statistics sum;
        uint64_t sign_tests_ended;
        vbss_collision_config config;
        begin(&f, i / 3, counts[i % 4], counts[i % 4] + i % 2);
        f.batch.thickness = i % 5 < 3 ? f.rows.thickness : NULL;
        expect_ok(vbss_collision_config_init(&config, sizeof config));
        config.method = (vbss_collision_method)(i % 3);
        config.thickness = COLLISION_THICKNESS;
        vbss_collision *object;
        expect_ok(vbss_collision_create(f.context, &config, &object));
        ask_singly(&f, config.method, &wanted, &sum, &sign_tests_ended);
        uint64_t calls = f.memory.calls;
        expect_ok(vbss_collision_test_batch(object, &f.batch));
        assert_true(f.memory.calls == calls);
        assert_memory_equal(&f.out, &wanted, sizeof wanted);
        vbss_collision_statistics counted = shapes_statistics(object);
        assert_memory_equal(&counted, &sum, sizeof sum);
        assert_int_equal(sign_tests_ended, shapes_sign_tests_ended(object));
        end(&f);
    }
}

static void unrequested_answers_are_not_written(void **state)
{
    (void)state;
    fixture f;
    begin(&f, 0, 20, 20);
    expect_ok(vbss_collision_test_batch(f.object, &f.batch));
    outputs all = f.out;
    memset(&f.out, PATTERN, sizeof f.out);
    f.batch.decision = NULL;
    f.batch.time = f.batch.normal = f.batch.weights = NULL;
    expect_ok(vbss_collision_test_batch(f.object, &f.batch));
    assert_memory_equal(f.out.hit, all.hit, sizeof all.hit);
    const unsigned char *bytes = (const unsigned char *)&f.out;
    for (size_t i = sizeof f.out.hit; i < sizeof f.out; i++) {
        assert_int_equal(bytes[i], PATTERN);
    }
    f.batch.hit = NULL; /* of no questions nothing is needed */
    f.batch.start = f.batch.end = NULL;
    f.batch.count = 0;
    expect_ok(vbss_collision_test_batch(f.object, &f.batch));
    f.batch.stride = 0;
    expect_ok(vbss_collision_test_batch(f.object, &f.batch));
    assert_int_equal(shapes_statistics(f.object).queries, 40);
    end(&f);
}

/* ---- refusals */

static void expect_refused(fixture *f, vbss_result wanted)
{
    vbss_collision_statistics before = shapes_statistics(f->object);
    expect_result(wanted, vbss_collision_test_batch(f->object, &f->batch));
    vbss_collision_statistics after = shapes_statistics(f->object);
    assert_memory_equal(&after, &before, sizeof after);
    const unsigned char *bytes = (const unsigned char *)&f->out;
    for (size_t i = 0; i < sizeof f->out; i++) {
        assert_int_equal(bytes[i], PATTERN);
    }
}

static void bad_batch_is_rejected_without_output(void **state)
{
    (void)state;
    fixture f;
    begin(&f, 0, 20, 21);
    const vbss_collision_batch good = f.batch;
    expect_result(VBSS_ERROR_NULL_ARGUMENT, vbss_collision_test_batch(f.object, NULL));
    for (int kind = -1; kind < 3; kind += 3) {
        f.batch.kind = kind;
        expect_refused(&f, VBSS_ERROR_OUT_OF_RANGE);
    }
    f.batch = good;
    f.batch.stride = 19;
    expect_refused(&f, VBSS_ERROR_OUT_OF_RANGE);
    f.batch.count = 100000001;
    f.batch.stride = UINT32_MAX;
    expect_refused(&f, VBSS_ERROR_OUT_OF_RANGE);
    f.batch = good;
    f.batch.hit = NULL;
    expect_refused(&f, VBSS_ERROR_NULL_ARGUMENT);
    f.batch = good;
    f.batch.start = NULL;
    expect_refused(&f, VBSS_ERROR_NULL_ARGUMENT);
    f.batch = good;
    f.batch.end = NULL;
    expect_refused(&f, VBSS_ERROR_NULL_ARGUMENT);
    f.batch = good;
    f.batch.struct_size = 0; /* and that nothing was written then, too */
    expect_refused(&f, VBSS_ERROR_STRUCT_SIZE);
    end(&f);
}

static void host_mode_does_not_change_answers(void **state)
{
    (void)state;
    fixture f;
    begin(&f, 0, 20, 21);
    expect_ok(vbss_collision_test_batch(f.object, &f.batch));
    const outputs wanted = f.out;
    for (size_t k = 0; k < harness_mode_count; k++) {
        memset(&f.out, PATTERN, sizeof f.out);
        harness_mode_set(k);
        vbss_result result = vbss_collision_test_batch(f.object, &f.batch);
        harness_mode_end(k);
        expect_ok(result);
        assert_memory_equal(&f.out, &wanted, sizeof wanted);
    }
    end(&f);
}

static void bad_number_is_found_at_any_index(void **state)
{
    (void)state;
    fixture f;
    begin(&f, 0, 20, 21);
    f.batch.thickness = f.rows.thickness;
    for (size_t row = 0; row < 26; row++) {
        for (size_t k = 0; k < 5; k++) {
            double *numbers = row < 12   ? f.rows.start + 21 * row
                              : row < 24 ? f.rows.end + 21 * (row - 12)
                                         : f.rows.thickness;
            double *bad = &numbers[(7 * row + 5 * k) % 20], kept = *bad;
            *bad = k < 3 ? harness_bad_numbers[k] : k == 3 ? 1.01e30 : row < 24 ? -DBL_MAX : 1e-31;
            expect_refused(&f, k < 3 ? VBSS_ERROR_NOT_FINITE : VBSS_ERROR_OUT_OF_RANGE);
            *bad = kept;
        }
    }
    f.rows.thickness[19] = -0.25;
    expect_refused(&f, VBSS_ERROR_OUT_OF_RANGE);
    f.rows.thickness[19] = 0.25;
    expect_ok(vbss_collision_test_batch(f.object, &f.batch));
    end(&f);
}

static vbss_result batch_init(void *batch, uint32_t struct_size)
{
    return vbss_collision_batch_init(batch, struct_size);
}

static vbss_result ask_nothing(vbss_context *context, const void *batch)
{
    vbss_collision *object;
    VBSS_TRY(vbss_collision_create(context, NULL, &object));
    vbss_result result = vbss_collision_test_batch(object, batch);
    VBSS_TRY(vbss_collision_destroy(object));
    return result;
}

static void batch_size_protocol(void **state)
{
    (void)state;
    static const uint32_t sizes[] = {80, 0};
    const harness_config protocol = {sizes, batch_init, ask_nothing};
    harness_config_protocol(&protocol);
}

int test_batch(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(batch_equals_single_tests),
        cmocka_unit_test(unrequested_answers_are_not_written),
        cmocka_unit_test(bad_batch_is_rejected_without_output),
        cmocka_unit_test(host_mode_does_not_change_answers),
        cmocka_unit_test(bad_number_is_found_at_any_index),
        cmocka_unit_test(batch_size_protocol),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
