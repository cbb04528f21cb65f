/* Every bad number and NULL: its status, and that nothing has changed. */
#include <float.h>
#include <math.h>
#include <string.h>

#include "drain/drain_rig.h"

/* ---- configurations */

static void expect_config(drain_rig *r, vbss_result wanted)
{
    vbss_drain *drain = (vbss_drain *)r->context;
    vbss_context_statistics before, after;
    expect_ok(vbss_context_get_statistics(r->context, &before, sizeof before));
    vbss_result result = vbss_drain_create(r->context, &r->config, &drain);
    expect_result(wanted, result);
    if (result == VBSS_OK) {
        expect_ok(vbss_drain_destroy(drain));
        return;
    }
    assert_null(drain);
    expect_ok(vbss_context_get_statistics(r->context, &after, sizeof after));
    assert_int_equal(before.bytes_allocated, after.bytes_allocated);
    assert_int_equal(before.objects_created, after.objects_created);
}

static void with_number(drain_rig *r, size_t offset, double value, vbss_result wanted)
{
    vbss_drain_config kept = r->config;
    memcpy((char *)&r->config + offset, &value, sizeof value);
    expect_config(r, wanted);
    r->config = kept;
}

typedef struct number {
    size_t offset;
    double low, high;
    bool alone; /* any value in the range goes with the other defaults */
} number;

#define NUMBER(field, low, high, alone)                            \
    {                                                              \
        offsetof(vbss_drain_config, field), (low), (high), (alone) \
    }
#define DEGREE (3.14159265358979323846 / 180.0)

static const number numbers[] = {
    NUMBER(radius, 1e-4, 1.0, false),
    NUMBER(length, 2 * 6.5e-3, 7 * 6.5e-3, false),
    NUMBER(thickness, 0.01 * 6.5e-3, 0.3 * 6.5e-3, true),
    NUMBER(slit_length, 6.5e-3, 0.7 * 32e-3, false),
    NUMBER(slit_opening, 0.0, 4e-3, true),
    NUMBER(mark_arc, 20 * DEGREE * 6.5e-3, 90 * DEGREE * 6.5e-3, true),
    NUMBER(young_modulus, 1e3, 1e12, true),
    NUMBER(poisson_ratio, 0.0, 0.49, true),
    NUMBER(density, 1.0, 1e5, true),
    NUMBER(drag, 0.0, 1e6, true),
    NUMBER(gravity[0], -1e6, 1e6, true),
    NUMBER(gravity[2], -1e6, 1e6, true),
    NUMBER(position[1], -1e3, 1e3, true),
    NUMBER(tear_stress, 1.0, 1e12, true),
    NUMBER(position_tolerance, 1e-15, 1.0, true),
    NUMBER(move_limit, 1e-9, 1.0, true),
    NUMBER(friction, 0.0, 10.0, true),
    NUMBER(puncture_force, 1e-3, 1e3, true),
    NUMBER(hole_force, 1e-6, 1e3, true),
    NUMBER(hole_friction, 0.0, 10.0, true),
    NUMBER(hole_stiffness, 1.0, 1e7, true),
    NUMBER(hole_damping, 0.0, 1e3, true),
    NUMBER(tip_length, 0.0, 0.1, true),
};

static void bad_config_numbers_are_rejected(void **state)
{
    (void)state;
    drain_rig r;
    drain_rig_begin(&r);
    for (size_t i = 0; i < sizeof numbers / sizeof numbers[0]; i++) {
        const number *n = &numbers[i];
        for (int k = 0; k < 3; k++) {
            with_number(&r, n->offset, harness_bad_numbers[k], VBSS_ERROR_NOT_FINITE);
        }
        double step = 1e-6 * (fabs(n->low) > 0.0 ? fabs(n->low) : 1.0);
        with_number(&r, n->offset, n->low - step, VBSS_ERROR_OUT_OF_RANGE);
        with_number(&r, n->offset, n->high * (1.0 + 1e-6), VBSS_ERROR_OUT_OF_RANGE);
        with_number(&r, n->offset, -DBL_MAX, VBSS_ERROR_OUT_OF_RANGE);
        with_number(&r, n->offset, DBL_MAX, VBSS_ERROR_OUT_OF_RANGE);
        if (n->alone) {
            with_number(&r, n->offset, n->low + 1e-3 * step, VBSS_OK);
            with_number(&r, n->offset, n->high * (1.0 - 1e-9), VBSS_OK);
        }
    }
    size_t turn = offsetof(vbss_drain_config, orientation);
    for (int k = 0; k < 12; k++) {
        with_number(&r, turn + (size_t)(k % 4) * sizeof(double), harness_bad_numbers[k / 4],
                    VBSS_ERROR_NOT_FINITE);
    }
    with_number(&r, turn, 0.0, VBSS_ERROR_OUT_OF_RANGE);
    with_number(&r, turn, 1e101, VBSS_ERROR_OUT_OF_RANGE);
    with_number(&r, turn, 1e-90, VBSS_OK);
    with_number(&r, turn, -1e90, VBSS_OK);
    /* Ranges that hang on each other. */
    r.config.slit_opening = 5e-3;
    r.config.slit_length = 13e-3;
    expect_config(&r, VBSS_OK);
    r.config.mark_arc = 2.49e-3;
    expect_config(&r, VBSS_ERROR_OUT_OF_RANGE);
    drain_rig_end(&r);
}

/* Small and large drains, in proportion: the ends of the radius. */
static void any_drain_size_is_accepted(void **state)
{
    (void)state;
    drain_rig r;
    drain_rig_begin(&r);
    const vbss_drain_config kept = r.config;
    for (int k = 0; k < 2; k++) {
        double scale = (k == 0 ? 1e-4 : 1.0) / kept.radius;
        r.config.radius = k == 0 ? 1e-4 : 1.0;
        r.config.length = scale * kept.length;
        r.config.thickness = scale * kept.thickness;
        r.config.slit_length = scale * kept.slit_length;
        r.config.slit_opening = scale * kept.slit_opening;
        r.config.mark_arc = scale * kept.mark_arc;
        expect_config(&r, VBSS_OK);
    }
    drain_rig_end(&r);
}

static void bad_config_choices_are_rejected(void **state)
{
    (void)state;
    static const struct {
        size_t offset;
        uint32_t bad;
    } choices[] = {
        {offsetof(vbss_drain_config, method), 2},
        {offsetof(vbss_drain_config, method), UINT32_MAX},
        {offsetof(vbss_drain_config, mesh), 4},
        {offsetof(vbss_drain_config, mesh), UINT32_MAX},
        {offsetof(vbss_drain_config, mesh_divisions), 0},
        {offsetof(vbss_drain_config, mesh_divisions), 5},
        {offsetof(vbss_drain_config, mesh_divisions), UINT32_MAX},
        {offsetof(vbss_drain_config, attachment_capacity), 257},
        {offsetof(vbss_drain_config, attachment_capacity), UINT32_MAX},
        {offsetof(vbss_drain_config, iteration_limit), 0},
        {offsetof(vbss_drain_config, iteration_limit), 51},
        {offsetof(vbss_drain_config, halving_limit), 11},
        {offsetof(vbss_drain_config, halving_limit), UINT32_MAX},
        {offsetof(vbss_drain_config, reserved), 1},
    };
    drain_rig r;
    drain_rig_begin(&r);
    const vbss_drain_config kept = r.config;
    for (size_t i = 0; i < sizeof choices / sizeof choices[0]; i++) {
        memcpy((char *)&r.config + choices[i].offset, &choices[i].bad, sizeof choices[i].bad);
        expect_config(&r, VBSS_ERROR_OUT_OF_RANGE);
        r.config = kept;
    }
    drain_rig_end(&r);
}

/* ---- a drain that has lived */

static void unchanged(drain_rig *r, uint64_t hash, vbss_result wanted, vbss_result got)
{
    expect_result(wanted, got);
    assert_true(drain_rig_hash(r) == hash);
}

static void begin_subject(drain_rig *r)
{
    drain_rig_begin(r);
    drain_rig_make(r);
    drain_rig_pin(r, r->places.marks[0], vec3_make(0.0, 5e-3, -4e-3));
    drain_rig_force(r, r->places.marks[1], vec3_make(0.0, 0.01, 0.0));
    drain_rig_spring(r, r->places.gap_points[0], vec3_zero(), 2.0);
    drain_rig_run(r, 1e-3, 3);
}

static void bad_attachments_are_rejected(void **state)
{
    (void)state;
    drain_rig r;
    begin_subject(&r);
    uint64_t hash = drain_rig_hash(&r);
    vbss_drain_attachment a, good;
    uint32_t id = 77;
    expect_ok(vbss_drain_attachment_init(&good, sizeof good));
    good.node = r.places.gap_points[1];
    for (int k = 0; k < 3; k++) {
        for (int c = 0; c < 7; c++) {
            a = good;
            *(c < 3   ? &a.position[c]
              : c < 6 ? &a.force[c - 3]
                      : &a.stiffness) = harness_bad_numbers[k];
            unchanged(&r, hash, VBSS_ERROR_NOT_FINITE, vbss_drain_attach(r.drain, &a, &id));
        }
    }
    for (int c = 0; c < 14; c++) {
        double sign = c < 7 ? 1.0 : -1.0;
        int at = c % 7;
        a = good;
        *(at < 3   ? &a.position[at]
          : at < 6 ? &a.force[at - 3]
                   : &a.stiffness) = sign * (at < 3   ? 1001.0
                                             : at < 6 ? 1.001e6
                                                      : 1.001e9);
        unchanged(&r, hash, VBSS_ERROR_OUT_OF_RANGE, vbss_drain_attach(r.drain, &a, &id));
    }
    const uint32_t nodes[] = {r.places.node_count, UINT32_MAX,
                              drain_rig_numbers(&r, VBSS_DRAIN_VIEW_ANCHORS)[0], r.places.marks[0]};
    for (int k = 0; k < 4; k++) {
        a = good;
        a.node = nodes[k];
        unchanged(&r, hash, k < 2 ? VBSS_ERROR_OUT_OF_RANGE : VBSS_ERROR_IN_USE,
                  vbss_drain_attach(r.drain, &a, &id));
    }
    const int32_t kinds[] = {-1, 3, INT32_MIN, INT32_MAX};
    for (int k = 0; k < 4; k++) {
        a = good;
        a.kind = kinds[k];
        unchanged(&r, hash, VBSS_ERROR_OUT_OF_RANGE, vbss_drain_attach(r.drain, &a, &id));
    }
    a = good;
    a.reserved = 1;
    unchanged(&r, hash, VBSS_ERROR_OUT_OF_RANGE, vbss_drain_attach(r.drain, &a, &id));
    unchanged(&r, hash, VBSS_ERROR_NULL_ARGUMENT, vbss_drain_attach(r.drain, NULL, &id));
    unchanged(&r, hash, VBSS_ERROR_NULL_ARGUMENT, vbss_drain_attach(r.drain, &good, NULL));
    assert_int_equal(id, 77);
    drain_rig_end(&r);
}

static void bad_moves_are_rejected(void **state)
{
    (void)state;
    drain_rig r;
    begin_subject(&r);
    uint64_t hash = drain_rig_hash(&r);
    double zero[3] = {0.0, 0.0, 0.0}, force[3];
    for (uint32_t id = 1; id <= 3; id++) {
        unchanged(&r, hash, VBSS_ERROR_NULL_ARGUMENT,
                  vbss_drain_set_attachment_target(r.drain, id, NULL));
        for (int c = 0; c < 3; c++) {
            double target[3] = {0.0, 0.0, 0.0};
            for (int k = 0; k < 3; k++) {
                target[c] = harness_bad_numbers[k];
                unchanged(&r, hash, VBSS_ERROR_NOT_FINITE,
                          vbss_drain_set_attachment_target(r.drain, id, target));
            }
            target[c] = id == 2 ? -1.001e6 : 1001.0;
            unchanged(&r, hash, VBSS_ERROR_OUT_OF_RANGE,
                      vbss_drain_set_attachment_target(r.drain, id, target));
        }
    }
    const uint32_t none[] = {0, 4, UINT32_MAX};
    for (int k = 0; k < 3; k++) {
        unchanged(&r, hash, VBSS_ERROR_NOT_FOUND,
                  vbss_drain_set_attachment_target(r.drain, none[k], zero));
        unchanged(&r, hash, VBSS_ERROR_NOT_FOUND, vbss_drain_detach(r.drain, none[k]));
        unchanged(&r, hash, VBSS_ERROR_NOT_FOUND, vbss_drain_get_reaction(r.drain, none[k], force));
    }
    unchanged(&r, hash, VBSS_ERROR_NULL_ARGUMENT, vbss_drain_get_reaction(r.drain, 1, NULL));
    drain_rig_end(&r);
}

static void bad_steps_states_and_fields_are_rejected(void **state)
{
    (void)state;
    drain_rig r;
    begin_subject(&r);
    uint64_t hash = drain_rig_hash(&r);
    uint32_t nodes = r.places.node_count,
             anchor = drain_rig_numbers(&r, VBSS_DRAIN_VIEW_ANCHORS)[7];
    static vec3 x[DRAIN_RIG_NODES], kept[DRAIN_RIG_NODES], v[DRAIN_RIG_NODES];
    vbss_view view;
    drain_rig_copy(&r, kept);
    const double wrong_steps[] = {0.0, -1e-3, 0.99e-7, 0.1001, DBL_MAX, -DBL_MAX, 5e-324};
    for (int i = 0; i < 7; i++) {
        unchanged(&r, hash, VBSS_ERROR_OUT_OF_RANGE, vbss_drain_step(r.drain, wrong_steps[i]));
    }
    for (int k = 0; k < 3; k++) {
        unchanged(&r, hash, VBSS_ERROR_NOT_FINITE,
                  vbss_drain_step(r.drain, harness_bad_numbers[k]));
        for (uint32_t i = 0; i < nodes; i += 17) {
            memcpy(x, kept, sizeof x);
            memset(v, 0, sizeof v);
            x[i].z = harness_bad_numbers[k];
            unchanged(&r, hash, VBSS_ERROR_NOT_FINITE,
                      vbss_drain_set_state(r.drain, &x[0].x, NULL, nodes));
            v[i].x = harness_bad_numbers[k];
            unchanged(&r, hash, VBSS_ERROR_NOT_FINITE,
                      vbss_drain_set_state(r.drain, NULL, &v[0].x, nodes));
            x[i].z = -1001.0;
            unchanged(&r, hash, VBSS_ERROR_OUT_OF_RANGE,
                      vbss_drain_set_state(r.drain, &x[0].x, NULL, nodes));
            v[i].x = 1.1e5;
            unchanged(&r, hash, VBSS_ERROR_OUT_OF_RANGE,
                      vbss_drain_set_state(r.drain, NULL, &v[0].x, nodes));
        }
    }
    /* An anchored node stays where it is. */
    memcpy(x, kept, sizeof x);
    memset(v, 0, sizeof v);
    x[anchor].y += 1e-9;
    unchanged(&r, hash, VBSS_ERROR_IN_USE, vbss_drain_set_state(r.drain, &x[0].x, NULL, nodes));
    v[anchor].z = 1e-9;
    unchanged(&r, hash, VBSS_ERROR_IN_USE, vbss_drain_set_state(r.drain, NULL, &v[0].x, nodes));
    const uint32_t wrong_counts[] = {0, nodes - 1, nodes + 1, UINT32_MAX};
    for (int i = 0; i < 4; i++) {
        unchanged(&r, hash, VBSS_ERROR_OUT_OF_RANGE,
                  vbss_drain_set_state(r.drain, &kept[0].x, NULL, wrong_counts[i]));
    }
    const vbss_drain_field fields[] = {-1, 10, INT32_MAX, INT32_MIN};
    for (int i = 0; i < 4; i++) {
        unchanged(&r, hash, VBSS_ERROR_OUT_OF_RANGE,
                  vbss_drain_get_view(r.drain, fields[i], &view, sizeof view));
    }
    unchanged(&r, hash, VBSS_ERROR_NULL_ARGUMENT, vbss_drain_get_hash(r.drain, NULL));
    expect_ok(vbss_drain_set_state(r.drain, &kept[0].x, NULL, nodes));
    drain_rig_end(&r);
}

int test_drain_refusals(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(bad_config_numbers_are_rejected),
        cmocka_unit_test(any_drain_size_is_accepted),
        cmocka_unit_test(bad_config_choices_are_rejected),
        cmocka_unit_test(bad_attachments_are_rejected),
        cmocka_unit_test(bad_moves_are_rejected),
        cmocka_unit_test(bad_steps_states_and_fields_are_rejected),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
