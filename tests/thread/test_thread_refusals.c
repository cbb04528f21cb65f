/* Every bad number and NULL: its status, and that nothing has changed. */
#include <stdlib.h>

#include "subject.h"

/* ---- configurations */

typedef struct number {
    size_t offset;
    double low, high;
    vbss_result below, above; /* of what is just outside */
} number;

#define NUMBER(field, low, high)                                                     \
    {                                                                                \
        offsetof(vbss_thread_config, field), (low), (high), VBSS_ERROR_OUT_OF_RANGE, \
            VBSS_ERROR_OUT_OF_RANGE                                                  \
    }

static const number numbers[] = {
    NUMBER(length, 1e-6, 1e3),
    NUMBER(radius, 1e-7, 0.1),
    NUMBER(linear_density, 1e-9, 1e3),
    NUMBER(axial_stiffness, 1e-6, 1e9),
    NUMBER(bending_stiffness, 0.0, 1e3),
    NUMBER(rest_curvature, 0.0, 1e4),
    NUMBER(yield_curvature, 0.0, 1e6),
    NUMBER(yield_hardening, 0.0, 0.999),
    NUMBER(relaxation_ratio, 0.0, 1e3),
    NUMBER(relaxation_time, 1e-6, 1e9),
    NUMBER(torsional_stiffness, 0.0, 1e3),
    NUMBER(drag, 0.0, 1e6),
    NUMBER(damping, 0.0, 1e6),
    NUMBER(spectral_radius, 0.0, 1.0),
    NUMBER(stretch_tolerance, 1e-12, 1e-2),
    NUMBER(position_tolerance, 1e-12, 1.0),
    NUMBER(gravity[0], -1e6, 1e6),
    NUMBER(gravity[2], -1e6, 1e6),
    NUMBER(start[1], -1e3, 1e3),
};

static void expect_config(fixture *f, vbss_result wanted)
{
    vbss_thread *thread = (vbss_thread *)f->context;
    vbss_context_statistics before, after;
    expect_ok(vbss_context_get_statistics(f->context, &before, sizeof before));
    vbss_result result = vbss_thread_create(f->context, &f->config, &thread);
    expect_result(wanted, result);
    if (result == VBSS_OK) {
        expect_ok(vbss_thread_destroy(thread));
        return;
    }
    assert_null(thread);
    expect_ok(vbss_context_get_statistics(f->context, &after, sizeof after));
    assert_int_equal(before.bytes_allocated, after.bytes_allocated);
    assert_int_equal(before.objects_created, after.objects_created);
}

static void with_number(fixture *f, size_t offset, double value, vbss_result wanted)
{
    vbss_thread_config kept = f->config;
    memcpy((char *)&f->config + offset, &value, sizeof value);
    expect_config(f, wanted);
    f->config = kept;
}

static void bad_config_numbers_are_rejected(void **state)
{
    (void)state;
    fixture f;
    begin(&f);
    f.config.segment_count = 2;
    for (size_t i = 0; i < sizeof numbers / sizeof numbers[0]; i++) {
        const number *n = &numbers[i];
        for (int k = 0; k < 3; k++) {
            with_number(&f, n->offset, harness_bad_numbers[k], VBSS_ERROR_NOT_FINITE);
        }
        double step = 1e-6 * (fabs(n->low) > 0.0 ? fabs(n->low) : 1.0);
        with_number(&f, n->offset, n->low - step, n->below);
        with_number(&f, n->offset, n->high * (1.0 + 1e-6), n->above);
        with_number(&f, n->offset, n->low, VBSS_OK);
        with_number(&f, n->offset, n->high, VBSS_OK);
        with_number(&f, n->offset, -DBL_MAX, VBSS_ERROR_OUT_OF_RANGE);
        with_number(&f, n->offset, DBL_MAX, VBSS_ERROR_OUT_OF_RANGE);
    }
    for (int k = 0; k < 3; k++) {
        for (int c = 0; c < 3; c++) {
            size_t offset = offsetof(vbss_thread_config, direction) + (size_t)c * sizeof(double);
            with_number(&f, offset, harness_bad_numbers[k], VBSS_ERROR_NOT_FINITE);
        }
    }
    with_number(&f, offsetof(vbss_thread_config, direction), 0.0, VBSS_ERROR_OUT_OF_RANGE);
    with_number(&f, offsetof(vbss_thread_config, direction), 1e-90, VBSS_OK);
    with_number(&f, offsetof(vbss_thread_config, direction), -1e90, VBSS_OK);
    end(&f);
}

static void bad_config_choices_are_rejected(void **state)
{
    (void)state;
    static const struct {
        size_t offset;
        uint32_t bad;
    } choices[] = {
        {offsetof(vbss_thread_config, method), 2},
        {offsetof(vbss_thread_config, method), UINT32_MAX},
        {offsetof(vbss_thread_config, bending), 2},
        {offsetof(vbss_thread_config, bending), UINT32_MAX},
        {offsetof(vbss_thread_config, segment_count), 0},
        {offsetof(vbss_thread_config, segment_count), 65537},
        {offsetof(vbss_thread_config, segment_count), UINT32_MAX},
        {offsetof(vbss_thread_config, attachment_capacity), 257},
        {offsetof(vbss_thread_config, attachment_capacity), UINT32_MAX},
        {offsetof(vbss_thread_config, cut_capacity), 65},
        {offsetof(vbss_thread_config, cut_capacity), UINT32_MAX},
        {offsetof(vbss_thread_config, iteration_limit), 0},
        {offsetof(vbss_thread_config, iteration_limit), 101},
        {offsetof(vbss_thread_config, halving_limit), 11},
    };
    fixture f;
    begin(&f);
    vbss_thread_config good = f.config;
    for (size_t i = 0; i < sizeof choices / sizeof choices[0]; i++) {
        memcpy((char *)&f.config + choices[i].offset, &choices[i].bad, sizeof choices[i].bad);
        expect_config(&f, VBSS_ERROR_OUT_OF_RANGE);
        f.config = good;
    }
    f.config.length = 1e-6; /* segments shorter than any may be */
    expect_config(&f, VBSS_ERROR_OUT_OF_RANGE);
    vbss_thread *thread;
    expect_ok(vbss_thread_create(f.context, NULL, &thread)); /* the defaults */
    expect_ok(vbss_thread_destroy(thread));
    expect_result(VBSS_ERROR_NULL_ARGUMENT, vbss_thread_create(f.context, &good, NULL));
    expect_result(VBSS_ERROR_OUT_OF_RANGE, vbss_thread_config_preset(&good, 2));
    expect_result(VBSS_ERROR_OUT_OF_RANGE, vbss_thread_config_preset(&good, -1));
    expect_result(VBSS_ERROR_NULL_ARGUMENT, vbss_thread_config_preset(NULL, 0));
    good.struct_size = 3;
    expect_result(VBSS_ERROR_STRUCT_SIZE, vbss_thread_config_preset(&good, 0));
    end(&f);
}

static void bad_array_entries_are_rejected(void **state)
{
    (void)state;
    fixture f;
    double rest[12], positions[39];
    begin(&f);
    for (int i = 0; i < 39; i++) {
        positions[i] = 0.01 * i;
        rest[i % 12] = 0.01;
    }
    f.config.rest_lengths = rest;
    f.config.positions = positions;
    expect_config(&f, VBSS_OK);
    for (int i = 0; i < 12; i++) {
        for (int k = 0; k < 5; k++) {
            rest[i] = k < 3 ? harness_bad_numbers[k] : k == 3 ? 0.0 : 101.0;
            expect_config(&f, k < 3 ? VBSS_ERROR_NOT_FINITE : VBSS_ERROR_OUT_OF_RANGE);
        }
        rest[i] = 0.01;
    }
    for (int i = 0; i < 39; i++) {
        for (int k = 0; k < 4; k++) {
            positions[i] = k < 3 ? harness_bad_numbers[k] : 1001.0;
            expect_config(&f, k < 3 ? VBSS_ERROR_NOT_FINITE : VBSS_ERROR_OUT_OF_RANGE);
        }
        positions[i] = 0.0;
    }
    /* What the arrays replace is ignored, whatever it is. */
    f.config.length = (double)NAN;
    f.config.start[0] = (double)NAN;
    expect_config(&f, VBSS_OK);
    end(&f);
}

/* ---- attaching, moving, stepping: the thread stays as it was to the bit */

static vbss_result attach_with(subject *s, size_t offset, double value)
{
    uint32_t id = 77;
    vbss_thread_attachment a = plain(VBSS_THREAD_ATTACHMENT_SPRING, 7);
    memcpy((char *)&a + offset, &value, sizeof value);
    vbss_result result = vbss_thread_attach(s->thread, &a, &id);
    assert_true(result == VBSS_OK || id == 77);
    return result;
}

static void bad_attachments_are_rejected(void **state)
{
    (void)state;
    static const struct {
        size_t offset;
        double low, high;
    } fields[] = {
        {offsetof(vbss_thread_attachment, position[0]), -1e3, 1e3},
        {offsetof(vbss_thread_attachment, position[1]), -1e3, 1e3},
        {offsetof(vbss_thread_attachment, position[2]), -1e3, 1e3},
        {offsetof(vbss_thread_attachment, direction[0]), -1e101, 1e101},
        {offsetof(vbss_thread_attachment, force[0]), -1e6, 1e6},
        {offsetof(vbss_thread_attachment, force[2]), -1e6, 1e6},
        {offsetof(vbss_thread_attachment, stiffness), 0.0, 1e9},
        {offsetof(vbss_thread_attachment, damping), 0.0, 1e6},
        {offsetof(vbss_thread_attachment, mass), 0.0, 1e3},
    };
    subject s;
    begin_subject(&s);
    for (size_t i = 0; i < sizeof fields / sizeof fields[0]; i++) {
        for (int k = 0; k < 3; k++) {
            unchanged(&s, VBSS_ERROR_NOT_FINITE,
                      attach_with(&s, fields[i].offset, harness_bad_numbers[k]));
        }
        double below = fields[i].low - 1e-3 * fabs(fields[i].low) - 1e-12;
        unchanged(&s, VBSS_ERROR_OUT_OF_RANGE, attach_with(&s, fields[i].offset, below));
        unchanged(&s, VBSS_ERROR_OUT_OF_RANGE,
                  attach_with(&s, fields[i].offset, 1.001 * fields[i].high));
    }
    unchanged(&s, VBSS_ERROR_OUT_OF_RANGE,
              attach_with(&s, offsetof(vbss_thread_attachment, direction), 0.0));
    uint32_t id;
    vbss_thread_attachment a = plain(VBSS_THREAD_ATTACHMENT_PIN, 13);
    unchanged(&s, VBSS_ERROR_OUT_OF_RANGE, vbss_thread_attach(s.thread, &a, &id));
    a.node = UINT32_MAX;
    unchanged(&s, VBSS_ERROR_OUT_OF_RANGE, vbss_thread_attach(s.thread, &a, &id));
    a = plain(6, 1);
    unchanged(&s, VBSS_ERROR_OUT_OF_RANGE, vbss_thread_attach(s.thread, &a, &id));
    a = plain(-1, 1);
    unchanged(&s, VBSS_ERROR_OUT_OF_RANGE, vbss_thread_attach(s.thread, &a, &id));
    a = plain(VBSS_THREAD_ATTACHMENT_PIN, 1);
    a.reserved = 1;
    unchanged(&s, VBSS_ERROR_OUT_OF_RANGE, vbss_thread_attach(s.thread, &a, &id));
    a.reserved = 0;
    unchanged(&s, VBSS_ERROR_NULL_ARGUMENT, vbss_thread_attach(s.thread, &a, NULL));
    unchanged(&s, VBSS_ERROR_NULL_ARGUMENT, vbss_thread_attach(s.thread, NULL, &id));
    end_subject(&s);
}

static void presets_match_documentation(void **state)
{
    (void)state;
    const struct {
        vbss_thread_preset preset;
        double radius, linear_density, axial_stiffness, bending_stiffness;
    } wanted[] = {
        {VBSS_THREAD_PRESET_SILK_2_0, 0.16e-3, 1.05e-4, 700.0, 2.7e-8},
        {VBSS_THREAD_PRESET_VBLAST, 0.125e-3, 6.4e-5, 427.0, 1e-8},
    };
    vbss_thread_config config, kept;
    expect_ok(vbss_thread_config_init(&config, sizeof config));
    kept = config;
    for (int k = 0; k < 2; k++) {
        expect_ok(vbss_thread_config_preset(&config, wanted[k].preset));
        expect_same_bits(wanted[k].radius, config.radius);
        expect_same_bits(wanted[k].linear_density, config.linear_density);
        expect_same_bits(wanted[k].axial_stiffness, config.axial_stiffness);
        expect_same_bits(wanted[k].bending_stiffness, config.bending_stiffness);
    }
    /* The last of them is the default, and nothing else was touched. */
    assert_memory_equal(&config, &kept, sizeof config);
    const vbss_thread_preset none[] = {-1, 2, INT32_MAX, INT32_MIN};
    for (int k = 0; k < 4; k++) {
        expect_result(VBSS_ERROR_OUT_OF_RANGE, vbss_thread_config_preset(&config, none[k]));
        assert_memory_equal(&config, &kept, sizeof config);
    }
    expect_result(VBSS_ERROR_NULL_ARGUMENT,
                  vbss_thread_config_preset(NULL, VBSS_THREAD_PRESET_SILK_2_0));
}

int test_thread_refusals(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(bad_config_numbers_are_rejected),
        cmocka_unit_test(bad_config_choices_are_rejected),
        cmocka_unit_test(bad_array_entries_are_rejected),
        cmocka_unit_test(bad_attachments_are_rejected),
        cmocka_unit_test(presets_match_documentation),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
