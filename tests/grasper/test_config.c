/* Configurations of graspers: defaults, presets, and numbers that are rejected. */
#include "fixture.h"

static void null_config_is_default(void **state)
{
    (void)state;
    fixture f;
    begin(&f);
    vbss_grasper *plain = NULL;
    expect_ok(vbss_grasper_create(f.context, NULL, &plain));
    vbss_grasper_config own = inside(plain)->config;
    own.baseline = NULL; /* points into the grasper */
    assert_memory_equal(&f.config, &own, sizeof f.config);
    assert_int_equal(hash_of(plain) == hash_of(make(&f)), 1);
    vbss_grasper_state s = get_state(plain);
    assert_int_equal(s.kind, VBSS_GRASPER_KIND_NEEDLE_DRIVER);
    assert_int_equal(s.body, 0);
    assert_int_equal(s.grasp_count, 0);
    expect_same_bits(1.0, s.opening);
    expect_same_bits(f.config.driver_opening, s.jaw_angle);
    expect_same_bits(0.0, s.pressure);
    expect_same_bits(0.0, vec3_norm(vec3_load(s.position)));
    expect_same_bits(1.0, s.orientation[0]);
    f.config.kind = VBSS_GRASPER_KIND_SHEARS;
    f.config.shears_opening = 0.5;
    s = get_state(make(&f));
    assert_int_equal(s.kind, VBSS_GRASPER_KIND_SHEARS);
    expect_same_bits(0.5, s.jaw_angle);
    end(&f);
}

/* ---- bad numbers */

static void expect_config(fixture *f, vbss_result wanted)
{
    vbss_grasper *grasper = (vbss_grasper *)f->context;
    vbss_context_statistics before, after;
    expect_ok(vbss_context_get_statistics(f->context, &before, sizeof before));
    vbss_result result = vbss_grasper_create(f->context, &f->config, &grasper);
    expect_result(wanted, result);
    if (result == VBSS_OK) {
        expect_ok(vbss_grasper_destroy(grasper));
        return;
    }
    assert_null(grasper);
    expect_ok(vbss_context_get_statistics(f->context, &after, sizeof after));
    assert_int_equal(before.bytes_allocated, after.bytes_allocated);
    assert_int_equal(before.objects_created, after.objects_created);
}

typedef struct number {
    size_t offset;
    double low, high;
} number;

#define NUMBER(field, low, high)                            \
    {                                                       \
        offsetof(vbss_grasper_config, field), (low), (high) \
    }

static const number numbers[] = {
    NUMBER(trocar[0], -1e3, 1e3),          NUMBER(trocar[1], -1e3, 1e3),
    NUMBER(trocar[2], -1e3, 1e3),          NUMBER(driver_length, 1e-4, 1.0),
    NUMBER(driver_radius, 1e-6, 0.1),      NUMBER(driver_bend, -1.5, 1.5),
    NUMBER(driver_opening, 1e-3, 1.2),     NUMBER(shears_length, 1e-4, 1.0),
    NUMBER(shears_radius, 1e-6, 0.1),      NUMBER(shears_bend, -1.5, 1.5),
    NUMBER(shears_opening, 1e-3, 1.2),     NUMBER(driver_neck, 0.0, 1.0),
    NUMBER(shears_neck, 0.0, 1.0),         NUMBER(neck_radius, 1e-6, 0.1),
    NUMBER(shaft_length, 1e-3, 10.0),      NUMBER(shaft_radius, 1e-6, 0.1),
    NUMBER(friction, 0.0, 10.0),           NUMBER(closing_force, 0.0, 1e4),
    NUMBER(closing_angle, 1e-3, 1.0),      NUMBER(jaw_speed, 1e-2, 1e3),
    NUMBER(grip_friction, 0.0, 10.0),      NUMBER(grip_length, 1e-5, 1e-1),
    NUMBER(grip_stiffness, 1.0, 1e6),      NUMBER(mass, 1e-4, 1e2),
    NUMBER(stiffness, 0.0, 1e9),           NUMBER(damping, 0.0, 1e6),
    NUMBER(turning_stiffness, 0.0, 1e9),   NUMBER(turning_damping, 0.0, 1e6),
    NUMBER(exchange_centre[0], -1e3, 1e3), NUMBER(exchange_centre[1], -1e3, 1e3),
    NUMBER(exchange_centre[2], -1e3, 1e3), NUMBER(exchange_distance, 0.0, 1e3),
    NUMBER(needle_stiffness, 1.0, 1e7),    NUMBER(needle_turning_stiffness, 1e-6, 1e4),
    NUMBER(needle_torque, 0.0, 1e2),       NUMBER(solenoid_opening, 0.0, 1.0),
};

static void with_number(fixture *f, const number *n, double value, vbss_result wanted)
{
    const vbss_grasper_config kept = f->config;
    memcpy((char *)&f->config + n->offset, &value, sizeof value);
    /* jaws are longer than they are thick, whichever of both is tried */
    if (n->offset == offsetof(vbss_grasper_config, driver_length)) {
        f->config.driver_radius = 1e-6;
    } else if (n->offset == offsetof(vbss_grasper_config, driver_radius)) {
        f->config.driver_length = 1.0;
    } else if (n->offset == offsetof(vbss_grasper_config, shears_length)) {
        f->config.shears_radius = 1e-6;
    } else if (n->offset == offsetof(vbss_grasper_config, shears_radius)) {
        f->config.shears_length = 1.0;
    }
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
    end(&f);
}

static void bad_choices_are_rejected(void **state)
{
    (void)state;
    static const struct {
        size_t offset;
        int32_t good, bad[3];
    } choices[] = {
        {offsetof(vbss_grasper_config, method), VBSS_METHOD_VBLAST, {2, -1, INT32_MAX}},
        {offsetof(vbss_grasper_config, kind), VBSS_GRASPER_KIND_SHEARS, {0, 3, INT32_MIN}},
        {offsetof(vbss_grasper_config, has_trocar), 1, {2, -1, INT32_MAX}},
    };
    fixture f;
    begin(&f);
    const vbss_grasper_config good = f.config;
    for (size_t i = 0; i < sizeof choices / sizeof choices[0]; i++) {
        char *choice = (char *)&f.config + choices[i].offset;
        for (int k = 0; k < 3; k++) {
            memcpy(choice, &choices[i].bad[k], sizeof(int32_t));
            expect_config(&f, VBSS_ERROR_OUT_OF_RANGE);
        }
        memcpy(choice, &choices[i].good, sizeof(int32_t));
        expect_config(&f, VBSS_OK);
        f.config = good;
    }
    f.config.driver_radius = f.config.driver_length;
    expect_config(&f, VBSS_ERROR_OUT_OF_RANGE);
    f.config = good;
    f.config.shears_radius = f.config.shears_length;
    expect_config(&f, VBSS_ERROR_OUT_OF_RANGE);
    expect_result(VBSS_ERROR_NULL_ARGUMENT, vbss_grasper_create(f.context, &good, NULL));
    vbss_grasper *none = (vbss_grasper *)f.context;
    expect_result(VBSS_ERROR_INVALID_HANDLE, vbss_grasper_create(NULL, &good, &none));
    assert_null(none);
    end(&f);
}

static void presets_change_jaws_only(void **state)
{
    (void)state;
    vbss_grasper_config c, usual;
    expect_ok(vbss_grasper_config_init(&c, sizeof c));
    expect_ok(vbss_grasper_config_init(&usual, sizeof usual));
    c.stiffness = 400.0;
    c.shears_bend = 0.3;
    expect_ok(vbss_grasper_config_preset(&c, VBSS_GRASPER_PRESET_ANGLED));
    expect_same_bits(0.8, c.driver_bend);
    expect_same_bits(5e-3, c.driver_neck);
    expect_same_bits(400.0, c.stiffness);
    expect_same_bits(0.3, c.shears_bend);
    expect_result(VBSS_ERROR_OUT_OF_RANGE, vbss_grasper_config_preset(&c, 2));
    expect_result(VBSS_ERROR_OUT_OF_RANGE, vbss_grasper_config_preset(&c, -1));
    expect_result(VBSS_ERROR_NULL_ARGUMENT, vbss_grasper_config_preset(NULL, 0));
    expect_same_bits(0.8, c.driver_bend);
    c.stiffness = usual.stiffness;
    c.shears_bend = usual.shears_bend;
    expect_ok(vbss_grasper_config_preset(&c, VBSS_GRASPER_PRESET_STRAIGHT));
    assert_memory_equal(&c, &usual, sizeof c);
}

int test_config(void)
{
    const struct CMUnitTest tests[] = {
        harness_test(null_config_is_default),
        harness_test(bad_numbers_are_rejected),
        harness_test(bad_choices_are_rejected),
        harness_test(presets_change_jaws_only),
    };
    return cmocka_run_group_tests_name("grasper.config", tests, NULL, NULL);
}
