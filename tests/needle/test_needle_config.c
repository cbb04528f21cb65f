/* Configurations of needles: defaults, presets, and numbers that are rejected. */
#include "base/check.h"
#include "base/error.h"
#include "fixture.h"

static void null_config_is_default(void **state)
{
    (void)state;
    fixture f;
    begin(&f);
    vbss_needle *plain = NULL;
    expect_ok(vbss_needle_create(f.context, NULL, &plain));
    assert_memory_equal(&f.config, &inside(plain)->config, sizeof f.config);
    assert_true(hash_of(plain) == hash_of(make(&f)));
    assert_int_equal(f.config.method, VBSS_METHOD_IMPLICIT);
    assert_int_equal(f.config.segment_count, 8);
    assert_int_equal(f.config.reserved, 0);
    expect_same_bits(10.5e-3, f.config.radius);
    expect_same_bits(0.35e-3, f.config.wire_radius);
    expect_same_bits(PI, f.config.arc);
    expect_same_bits(7900.0, f.config.density);
    expect_same_bits(0.2, f.config.friction);
    expect_same_bits(0.0, f.config.drag);
    expect_same_bits(0.0, vbss_max_abs(f.config.gravity, 3));
    end(&f);
}

static void presets_change_shape_only(void **state)
{
    (void)state;
    vbss_needle_config c, usual;
    expect_ok(vbss_needle_config_init(&c, sizeof c));
    expect_ok(vbss_needle_config_init(&usual, sizeof usual));
    c.wire_radius = c.arc = 1.0;
    c.density = 8000.0;
    expect_ok(vbss_needle_config_preset(&c, VBSS_NEEDLE_PRESET_SH));
    expect_near(26e-3, c.radius * c.arc, 0.02e-3); /* its length */
    expect_same_bits(8.28e-3, c.radius);
    expect_same_bits(PI, c.arc);
    expect_same_bits(8000.0, c.density);
    expect_result(VBSS_ERROR_OUT_OF_RANGE, vbss_needle_config_preset(&c, 2));
    expect_result(VBSS_ERROR_OUT_OF_RANGE, vbss_needle_config_preset(&c, -1));
    expect_result(VBSS_ERROR_NULL_ARGUMENT, vbss_needle_config_preset(NULL, 0));
    expect_same_bits(8.28e-3, c.radius);
    c.density = usual.density;
    expect_ok(vbss_needle_config_preset(&c, VBSS_NEEDLE_PRESET_VBLAST));
    assert_memory_equal(&c, &usual, sizeof c);
    c.struct_size = 3;
    expect_result(VBSS_ERROR_STRUCT_SIZE, vbss_needle_config_preset(&c, VBSS_NEEDLE_PRESET_SH));
}

static void shape_of_a_catalogue_has_its_length(void **state)
{
    (void)state;
    vbss_needle_config c, usual;
    expect_ok(vbss_needle_config_init(&usual, sizeof usual));
    const double circles[] = {0.05, 0.375, 0.5, 0.625, 0.9};
    for (int k = 0; k < 5; k++) {
        c = usual;
        expect_ok(vbss_needle_config_shape(&c, circles[k], 26e-3, 0.6e-3));
        expect_near(26e-3, c.radius * c.arc, 1e-17);
        expect_near(2.0 * PI * circles[k], c.arc, 1e-15);
        expect_same_bits(0.3e-3, c.wire_radius);
        c.radius = usual.radius;
        c.arc = usual.arc;
        c.wire_radius = usual.wire_radius;
        assert_memory_equal(&c, &usual, sizeof c);
    }
    const struct {
        double circle, length, wire;
    } bad[] = {{0.049, 26e-3, 0.6e-3}, {0.91, 26e-3, 0.6e-3}, {0.5, 0.9e-3, 0.1e-3},
               {0.5, 1.1, 0.6e-3},     {0.5, 26e-3, 0.9e-5},  {0.5, 26e-3, 3.32e-3},
               {0.5, 26e-3, -1.0}};
    for (int k = 0; k < 7; k++) {
        expect_result(VBSS_ERROR_OUT_OF_RANGE,
                      vbss_needle_config_shape(&c, bad[k].circle, bad[k].length, bad[k].wire));
    }
    for (int k = 0; k < 3; k++) {
        double x = harness_bad_numbers[k];
        expect_result(VBSS_ERROR_NOT_FINITE, vbss_needle_config_shape(&c, x, 26e-3, 0.6e-3));
        expect_result(VBSS_ERROR_NOT_FINITE, vbss_needle_config_shape(&c, 0.5, x, 0.6e-3));
        expect_result(VBSS_ERROR_NOT_FINITE, vbss_needle_config_shape(&c, 0.5, 26e-3, x));
    }
    expect_result(VBSS_ERROR_NULL_ARGUMENT, vbss_needle_config_shape(NULL, 0.5, 26e-3, 0.6e-3));
    assert_memory_equal(&c, &usual, sizeof c);
}

/* ---- bad numbers */

static void expect_config(const fixture *f, vbss_result wanted)
{
    vbss_needle *needle = (vbss_needle *)f->context;
    vbss_context_statistics before, after;
    expect_ok(vbss_context_get_statistics(f->context, &before, sizeof before));
    vbss_result result = vbss_needle_create(f->context, &f->config, &needle);
    expect_result(wanted, result);
    if (result == VBSS_OK) {
        assert_true(vbss_rigid_is_valid(&inside(needle)->body));
        expect_ok(vbss_needle_step(needle, 1e-3));
        expect_ok(vbss_needle_destroy(needle));
        return;
    }
    assert_null(needle);
    expect_ok(vbss_context_get_statistics(f->context, &after, sizeof after));
    assert_true(before.bytes_allocated == after.bytes_allocated);
    assert_true(before.objects_created == after.objects_created);
}

typedef struct number {
    size_t offset;
    double low, high;
} number;

#define NUMBER(field, low, high)                           \
    {                                                      \
        offsetof(vbss_needle_config, field), (low), (high) \
    }

static const number numbers[] = {
    NUMBER(radius, 1e-4, 1.0),
    NUMBER(wire_radius, 1e-6, 0.2),
    NUMBER(arc, 0.1, 6.0),
    NUMBER(density, 1.0, 1e5),
    NUMBER(friction, 0.0, 10.0),
    NUMBER(drag, 0.0, 1e6),
    NUMBER(gravity[0], -1e6, 1e6),
    NUMBER(gravity[1], -1e6, 1e6),
    NUMBER(gravity[2], -1e6, 1e6),
    NUMBER(position[0], -1e3, 1e3),
    NUMBER(position[1], -1e3, 1e3),
    NUMBER(position[2], -1e3, 1e3),
    NUMBER(velocity[0], -1e5, 1e5),
    NUMBER(velocity[1], -1e5, 1e5),
    NUMBER(velocity[2], -1e5, 1e5),
    NUMBER(angular_velocity[0], -1e6, 1e6),
    NUMBER(angular_velocity[1], -1e6, 1e6),
    NUMBER(angular_velocity[2], -1e6, 1e6),
};

static void with_number(fixture *f, const number *n, double value, vbss_result wanted)
{
    const vbss_needle_config kept = f->config;
    /* a wire is thin, whichever of both is tried */
    f->config.wire_radius = 1e-6;
    f->config.radius = n->offset == offsetof(vbss_needle_config, wire_radius) ? 1.0 : kept.radius;
    memcpy((char *)&f->config + n->offset, &value, sizeof value);
    expect_config(f, wanted);
    f->config = kept;
}

static void bad_numbers_are_rejected(void **state)
{
    (void)state;
    fixture f;
    begin(&f);
    for (size_t i = 0; i < sizeof numbers / sizeof numbers[0]; i++) {
        const number *n = &numbers[i];
        for (int k = 0; k < 3; k++) {
            with_number(&f, n, harness_bad_numbers[k], VBSS_ERROR_NOT_FINITE);
        }
        double step = 1e-6 * (fabs(n->low) > 0.0 ? fabs(n->low) : 1.0);
        with_number(&f, n, n->low - step, VBSS_ERROR_OUT_OF_RANGE);
        with_number(&f, n, n->high * (1.0 + 1e-6), VBSS_ERROR_OUT_OF_RANGE);
        with_number(&f, n, -DBL_MAX, VBSS_ERROR_OUT_OF_RANGE);
        with_number(&f, n, DBL_MAX, VBSS_ERROR_OUT_OF_RANGE);
        with_number(&f, n, n->low, VBSS_OK);
        with_number(&f, n, n->high, VBSS_OK);
    }
    f.config.wire_radius = 0.2001 * f.config.radius;
    expect_config(&f, VBSS_ERROR_OUT_OF_RANGE);
    end(&f);
}

static void with_orientation(const fixture *f, const double q[4], vbss_result wanted)
{
    fixture other = *f;
    memcpy(other.config.orientation, q, sizeof other.config.orientation);
    expect_config(&other, wanted);
}

static void bad_orientations_are_rejected(void **state)
{
    (void)state;
    fixture f;
    begin(&f);
    for (int i = 0; i < 4; i++) {
        double q[4] = {0.5, 0.5, 0.5, 0.5};
        for (int k = 0; k < 3; k++) {
            q[i] = harness_bad_numbers[k];
            with_orientation(&f, q, VBSS_ERROR_NOT_FINITE);
        }
        double only[4] = {0.0, 0.0, 0.0, 0.0};
        with_orientation(&f, only, VBSS_ERROR_OUT_OF_RANGE);
        only[i] = 0.9e-100;
        with_orientation(&f, only, VBSS_ERROR_OUT_OF_RANGE);
        only[i] = -1.1e100;
        with_orientation(&f, only, VBSS_ERROR_OUT_OF_RANGE);
        only[i] = -1e100;
        with_orientation(&f, only, VBSS_OK);
        only[i] = 1e-100;
        with_orientation(&f, only, VBSS_OK);
    }
    end(&f);
}

static void bad_choices_are_rejected(void **state)
{
    (void)state;
    static const struct {
        size_t offset;
        uint32_t good[2], bad[3];
    } choices[] = {
        {offsetof(vbss_needle_config, method), {0, 1}, {2, UINT32_MAX, INT32_MAX}},
        {offsetof(vbss_needle_config, segment_count), {2, 64}, {1, 65, UINT32_MAX}},
        {offsetof(vbss_needle_config, reserved), {0, 0}, {1, 2, UINT32_MAX}},
    };
    fixture f;
    begin(&f);
    const vbss_needle_config good = f.config;
    for (size_t i = 0; i < sizeof choices / sizeof choices[0]; i++) {
        char *choice = (char *)&f.config + choices[i].offset;
        for (int k = 0; k < 3; k++) {
            memcpy(choice, &choices[i].bad[k], sizeof choices[i].bad[k]);
            expect_config(&f, VBSS_ERROR_OUT_OF_RANGE);
        }
        for (int k = 0; k < 2; k++) {
            memcpy(choice, &choices[i].good[k], sizeof choices[i].good[k]);
            expect_config(&f, VBSS_OK);
        }
        f.config = good;
    }
    expect_result(VBSS_ERROR_NULL_ARGUMENT, vbss_needle_create(f.context, &good, NULL));
    vbss_needle *none = (vbss_needle *)f.context;
    expect_result(VBSS_ERROR_INVALID_HANDLE, vbss_needle_create(NULL, &good, &none));
    assert_null(none);
    end(&f);
}

int test_needle_config(void)
{
    const struct CMUnitTest tests[] = {
        harness_test(null_config_is_default),
        harness_test(presets_change_shape_only),
        harness_test(shape_of_a_catalogue_has_its_length),
        harness_test(bad_numbers_are_rejected),
        harness_test(bad_orientations_are_rejected),
        harness_test(bad_choices_are_rejected),
    };
    return cmocka_run_group_tests_name("needle.needle_config", tests, NULL, NULL);
}
