/* Threads with an adaptive mesh: bad configurations, states, cuts, memory. */
#include <stdlib.h>

#include "base/error.h"
#include "fixture.h"
#include "thread/remesh.h"

/* ---- configurations */

typedef struct number {
    size_t offset;
    double low, high;
} number;

#define NUMBER(field, low, high)                           \
    {                                                      \
        offsetof(vbss_thread_config, field), (low), (high) \
    }

static void expect_config(fixture *f, vbss_result wanted)
{
    vbss_thread *thread = NULL;
    vbss_result result = vbss_thread_create(f->context, &f->config, &thread);
    expect_result(wanted, result);
    if (result == VBSS_OK) {
        expect_ok(vbss_thread_destroy(thread));
    }
}

static void with_number(fixture *f, size_t offset, double value, vbss_result wanted)
{
    vbss_thread_config kept = f->config;
    memcpy((char *)&f->config + offset, &value, sizeof value);
    expect_config(f, wanted);
    f->config = kept;
}

static void with_word(fixture *f, size_t offset, uint32_t value, vbss_result wanted)
{
    vbss_thread_config kept = f->config;
    memcpy((char *)&f->config + offset, &value, sizeof value);
    expect_config(f, wanted);
    f->config = kept;
}

/* Of a fixed mesh too: a host that mistypes one is told before it needs it. */
static void bad_mesh_numbers_are_rejected(void **state)
{
    (void)state;
    static const number numbers[] = {
        NUMBER(finest_length, 1e-7, 2e-3), NUMBER(coarsest_length, 3e-4, 1e2),
        NUMBER(refine_angle, 0.1, 1.0),    NUMBER(coarsen_angle, 0.0, 0.125),
        NUMBER(near_distance, 0.0, 3e-3),  NUMBER(clear_distance, 1e-3, 0.1),
    };
    fixture f;
    begin(&f);
    for (int mesh = 0; mesh < 2; mesh++) {
        f.config.mesh = mesh;
        for (size_t i = 0; i < sizeof numbers / sizeof numbers[0]; i++) {
            const number *n = &numbers[i];
            for (int k = 0; k < 3; k++) {
                with_number(&f, n->offset, harness_bad_numbers[k], VBSS_ERROR_NOT_FINITE);
            }
            with_number(&f, n->offset, n->low, VBSS_OK);
            with_number(&f, n->offset, n->high, VBSS_OK);
            with_number(&f, n->offset, n->low - 1e-9, VBSS_ERROR_OUT_OF_RANGE);
            with_number(&f, n->offset, n->high * (1.0 + 1e-9), VBSS_ERROR_OUT_OF_RANGE);
        }
    }
    end(&f);
}

static void bad_mesh_choices_are_rejected(void **state)
{
    (void)state;
    fixture f;
    begin(&f);
    const size_t mesh = offsetof(vbss_thread_config, mesh);
    const size_t capacity = offsetof(vbss_thread_config, node_capacity);
    const size_t operations = offsetof(vbss_thread_config, mesh_operations);
    with_word(&f, mesh, 2, VBSS_ERROR_OUT_OF_RANGE);
    with_word(&f, mesh, UINT32_MAX, VBSS_ERROR_OUT_OF_RANGE);
    f.config.mesh = VBSS_THREAD_MESH_ADAPTIVE;
    with_word(&f, capacity, 12, VBSS_ERROR_OUT_OF_RANGE);
    with_word(&f, capacity, 13, VBSS_OK);
    with_word(&f, capacity, 65538, VBSS_ERROR_OUT_OF_RANGE);
    with_word(&f, operations, 65, VBSS_ERROR_OUT_OF_RANGE);
    with_word(&f, operations, 64, VBSS_OK);
    f.config.method = VBSS_METHOD_VBLAST;
    expect_config(&f, VBSS_ERROR_INCOMPATIBLE);
    f.config.mesh = VBSS_THREAD_MESH_FIXED;
    expect_config(&f, VBSS_OK);
    end(&f);
}

static void zero_capacity_is_four_times_segments(void **state)
{
    (void)state;
    static const uint32_t segments[] = {1, 12, 16383, 16385};
    static const uint32_t nodes[] = {5, 49, 65533, 65537};
    fixture f;
    begin(&f);
    f.config.mesh = VBSS_THREAD_MESH_ADAPTIVE;
    f.config.length = 10.0;
    for (int k = 0; k < 4; k++) {
        thread_object *t;
        f.config.segment_count = segments[k];
        vbss_thread *thread = make(&f);
        expect_ok(vbss_thread_open(thread, &t));
        assert_int_equal(t->node_capacity, nodes[k]);
        expect_ok(vbss_thread_destroy(thread));
    }
    end(&f);
}

/* States of one kind of mesh are none of the other. */
static void snapshot_of_other_mesh_is_rejected(void **state)
{
    (void)state;
    static uint8_t bytes[2][16384];
    uint64_t sizes[2];
    fixture f;
    vbss_thread *threads[2];
    begin(&f);
    for (int mesh = 0; mesh < 2; mesh++) {
        f.config.mesh = mesh;
        threads[mesh] = make(&f);
        expect_ok(vbss_thread_save(threads[mesh], bytes[mesh], sizeof bytes[mesh], &sizes[mesh]));
    }
    for (int mesh = 0; mesh < 2; mesh++) {
        uint64_t before = hash_of(threads[mesh]);
        expect_result(VBSS_ERROR_CORRUPT,
                      vbss_thread_restore(threads[mesh], bytes[1 - mesh], sizes[1 - mesh]));
        assert_true(hash_of(threads[mesh]) == before);
    }
    end(&f);
}

/* ---- cuts */

static void each_part_of_cut_thread_adapts(void **state)
{
    (void)state;
    fixture f;
    begin(&f);
    f.config.mesh = VBSS_THREAD_MESH_ADAPTIVE;
    f.config.segment_count = 200;
    f.config.cut_capacity = 2;
    f.config.node_capacity = 201;
    vbss_thread *thread = make(&f), *piece;
    hold(thread, VBSS_THREAD_ATTACHMENT_PIN, 0, vec3_zero());
    steps(thread, 5, 1e-3);
    expect_ok(vbss_thread_cut(thread, 0.08, &piece));
    double length = 0.0;
    for (int k = 0; k < 100; k++) {
        steps(thread, 1, 1e-3);
        steps(piece, 1, 1e-3);
    }
    vbss_thread *const parts[2] = {thread, piece};
    for (int p = 0; p < 2; p++) {
        thread_object *t;
        expect_ok(vbss_thread_open(parts[p], &t));
        assert_true(t->statistics.coarsened > 0);
        assert_int_equal(view_of(parts[p], VBSS_THREAD_VIEW_REST_LENGTHS).count, t->node_count - 1);
        length += vbss_thread_arc_length(t, t->node_count - 1);
    }
    expect_near(0.15, length, 1e-15);
    end(&f);
}

int test_adaptive_config(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(bad_mesh_numbers_are_rejected),
        cmocka_unit_test(bad_mesh_choices_are_rejected),
        cmocka_unit_test(zero_capacity_is_four_times_segments),
        cmocka_unit_test(snapshot_of_other_mesh_is_rejected),
        cmocka_unit_test(each_part_of_cut_thread_adapts),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
