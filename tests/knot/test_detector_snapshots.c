/* Snapshots that are none, of other detectors, and such as only the visitor can tell: all or nothing. */
#include <stdlib.h>

#include "knot/detector_rig.h"
#include "fixtures/knot_body.h"

static knot_body_options lives[] = {{VBSS_KNOT_METHOD_TOPOLOGY, 300},
                                    {VBSS_KNOT_METHOD_TOPOLOGY, 2500},
                                    {VBSS_KNOT_METHOD_PROJECTION, 15000}};

static void bad_snapshots_are_rejected(void **state)
{
    (void)state;
    const size_t moments[] = {0, 3, 44, 58, 100};
    for (int i = 0; i < 3; i++) {
        const harness_body body = knot_body(&lives[i]);
        for (int k = 0; k < 5; k++) {
            harness_refuses_bad_snapshots(&body, moments[k]);
        }
    }
}

typedef struct snapshot {
    uint8_t *bytes;
    uint64_t count;
} snapshot;

static snapshot save(const detector_rig *r)
{
    snapshot s;
    expect_result(VBSS_ERROR_CAPACITY, vbss_knot_detector_save(r->detector, NULL, 0, &s.count));
    s.bytes = malloc((size_t)s.count);
    assert_non_null(s.bytes);
    expect_ok(vbss_knot_detector_save(r->detector, s.bytes, s.count, &s.count));
    return s;
}

/* In the middle of a reading of a knot, with tools that hold, and events of the last step. */
static void begin_reading(detector_rig *r)
{
    detector_rig_begin(r);
    r->config.step_budget = 300;
    detector_rig_create(r);
    detector_rig_tie(r, "2=1", 120);
    detector_rig_add_tools(r, 2);
    detector_rig_judge(r);
    r->input.may_have_passed = 1;
    detector_rig_steps(r, 9);
    assert_true(vbss_knot_job_is_active(&detector_rig_object(r)->job));
}

/* The field of the last section, by its tag: where its numbers begin. */
static uint8_t *field(const snapshot *s, uint16_t tag, uint32_t number)
{
    enum { FRONT = 16 + 8, HEADER = 8 };
    uint64_t at = FRONT;
    while (at + HEADER <= s->count) {
        uint16_t found = (uint16_t)(s->bytes[at] | s->bytes[at + 1] << 8);
        uint32_t count = (uint32_t)s->bytes[at + 4] | (uint32_t)s->bytes[at + 5] << 8;
        uint32_t size = s->bytes[at + 2] <= 2 ? 8 : 4; /* double, uint64_t; else words */
        if (found == tag && number-- == 0) {
            return s->bytes + at + HEADER;
        }
        at += HEADER + count * size;
    }
    fail_msg("no field %u", tag);
    return NULL;
}

/* Told, and the detector is as it was in all that can be seen. */
static void refuse_changed(detector_rig *r, const snapshot *good, uint8_t *at, uint64_t bits)
{
    uint64_t kept, hash = detector_rig_hash(r);
    vbss_view events = detector_rig_view(r, VBSS_KNOT_VIEW_EVENTS);
    vbss_knot_detector_statistics figures = detector_rig_statistics(r), after;
    memcpy(&kept, at, sizeof kept);
    memcpy(at, &bits, sizeof bits); /* machines that test are little-endian */
    harness_seal_snapshot(good->bytes, (size_t)good->count);
    expect_result(VBSS_ERROR_CORRUPT,
                  vbss_knot_detector_restore(r->detector, good->bytes, good->count));
    memcpy(at, &kept, sizeof kept);
    harness_seal_snapshot(good->bytes, (size_t)good->count);
    after = detector_rig_statistics(r);
    assert_true(detector_rig_hash(r) == hash);
    assert_memory_equal(&figures, &after, sizeof figures);
    assert_int_equal(detector_rig_view(r, VBSS_KNOT_VIEW_EVENTS).count, events.count);
}

static void impossible_reading_is_rejected(void **state)
{
    (void)state;
    detector_rig r, other;
    begin_reading(&r);
    snapshot good = save(&r);
    detector_rig_begin(&other);
    other.config.step_budget = 300;
    detector_rig_create(&other);
    detector_rig_tie(&other, "1", 80);
    detector_rig_judge(&other); /* has events, too */
    uint8_t *used_work = field(&good, 92, 0);
    uint64_t right;
    memcpy(&right, used_work, sizeof right);
    assert_true(right > 0);
    const uint64_t wrong[] = {right + 1, right - 1,         1,         10000000,
                              INT64_MAX, (uint64_t)1 << 63, UINT64_MAX};
    for (int i = 0; i < 7; i++) {
        refuse_changed(&r, &good, used_work, wrong[i]);
        refuse_changed(&other, &good, used_work, wrong[i]);
    }
    expect_ok(vbss_knot_detector_restore(other.detector, good.bytes, good.count));
    assert_true(detector_rig_hash(&other) == detector_rig_hash(&r));
    free(good.bytes);
    detector_rig_end(&other);
    detector_rig_end(&r);
}

static void bad_numbers_in_copied_thread_are_rejected(void **state)
{
    (void)state;
    static const struct {
        uint16_t tag;
        uint32_t number; /* of the numbers of that field */
        double value;
    } wrong[] = {
        {85, 0, 1.1e3},  {85, 100, -1e300}, {85, 7, (double)NAN}, {85, 8, (double)INFINITY},
        {83, 0, 1e3},    {83, 0, -2.0},     {83, 0, 120.5},       {83, 0, -0.5},
        {84, 2, 1.1},    {84, 0, -1e300},   {86, 0, 1e308},       {86, 50, -1e308},
        {86, 120, 1e10}, {86, 3, -1.0},     {72, 0, -1.0},        {72, 0, 121.0},
        {73, 0, 1e4},    {73, 4, -1e300},   {74, 0, -1.0},        {74, 0, 2.0},
    };
    detector_rig r;
    begin_reading(&r);
    snapshot good = save(&r);
    for (size_t i = 0; i < sizeof wrong / sizeof wrong[0]; i++) {
        uint64_t bits;
        memcpy(&bits, &wrong[i].value, sizeof bits);
        refuse_changed(&r, &good, field(&good, wrong[i].tag, 0) + 8 * (size_t)wrong[i].number,
                       bits);
    }
    uint8_t *axis = field(&good, 73, 0); /* no length between two points */
    uint64_t bits, kept[3];
    memcpy(kept, axis, sizeof kept);
    memcpy(axis, axis + 24, 16);
    memcpy(&bits, axis + 40, sizeof bits);
    refuse_changed(&r, &good, axis + 16, bits);
    memcpy(axis, kept, sizeof kept);
    harness_seal_snapshot(good.bytes, (size_t)good.count);
    expect_ok(vbss_knot_detector_restore(r.detector, good.bytes, good.count));
    free(good.bytes);
    detector_rig_end(&r);
}

static void snapshot_of_other_detector_is_rejected(void **state)
{
    (void)state;
    static const size_t words[] = {offsetof(vbss_knot_detector_config, method),
                                   offsetof(vbss_knot_detector_config, point_capacity),
                                   offsetof(vbss_knot_detector_config, tool_capacity),
                                   offsetof(vbss_knot_detector_config, crossing_capacity),
                                   offsetof(vbss_knot_detector_config, direction_limit),
                                   offsetof(vbss_knot_detector_config, closure_count),
                                   offsetof(vbss_knot_detector_config, step_budget),
                                   offsetof(vbss_knot_detector_config, closure_tolerance),
                                   offsetof(vbss_knot_detector_config, interval)};
    static const size_t numbers[] = {offsetof(vbss_knot_detector_config, tail_reach),
                                     offsetof(vbss_knot_detector_config, tail_least),
                                     offsetof(vbss_knot_detector_config, wrap_turns),
                                     offsetof(vbss_knot_detector_config, slip_limit),
                                     offsetof(vbss_knot_detector_config, plane_offset)};
    enum { WORDS = sizeof words / sizeof words[0], NUMBERS = sizeof numbers / sizeof numbers[0] };
    detector_rig r;
    begin_reading(&r);
    snapshot good = save(&r);
    const uint64_t first = detector_rig_hash(&r);
    const vbss_knot_detector_config config = r.config;
    for (int k = 0; k < WORDS + NUMBERS + 1; k++) {
        r.config = config;
        if (k < WORDS) {
            *(uint32_t *)(void *)((char *)&r.config + words[k]) ^= 1u;
        } else if (k < WORDS + NUMBERS) {
            *(double *)(void *)((char *)&r.config + numbers[k - WORDS]) += 1e-3;
        } else { /* what is no part of what is known may differ */
            r.config.event_capacity = 8;
            r.config.seed = 7;
        }
        detector_rig_create(&r);
        bool alike = k == WORDS + NUMBERS;
        uint64_t hash = detector_rig_hash(&r);
        expect_result(alike ? VBSS_OK : VBSS_ERROR_CORRUPT,
                      vbss_knot_detector_restore(r.detector, good.bytes, good.count));
        assert_true(detector_rig_hash(&r) == (alike ? first : hash));
    }
    free(good.bytes);
    detector_rig_end(&r);
}

static void small_buffer_reports_required_size(void **state)
{
    (void)state;
    detector_rig r;
    uint64_t written = 0;
    begin_reading(&r);
    snapshot good = save(&r);
    uint8_t *bytes = malloc((size_t)good.count);
    assert_non_null(bytes);
    for (uint64_t capacity = 0; capacity < good.count; capacity += 1 + capacity / 8) {
        bytes[capacity] = 0x5a;
        expect_result(VBSS_ERROR_CAPACITY,
                      vbss_knot_detector_save(r.detector, bytes, capacity, &written));
        assert_int_equal(written, good.count);
        assert_int_equal(bytes[capacity], 0x5a);
    }
    expect_result(VBSS_ERROR_NULL_ARGUMENT,
                  vbss_knot_detector_save(r.detector, NULL, good.count, &written));
    expect_result(VBSS_ERROR_NULL_ARGUMENT,
                  vbss_knot_detector_save(r.detector, bytes, good.count, NULL));
    expect_result(VBSS_ERROR_NULL_ARGUMENT, vbss_knot_detector_get_hash(r.detector, NULL));
    expect_result(VBSS_ERROR_TRUNCATED,
                  vbss_knot_detector_restore(r.detector, good.bytes, good.count - 1));
    expect_result(VBSS_ERROR_TRUNCATED, vbss_knot_detector_restore(r.detector, good.bytes, 0));
    expect_result(VBSS_ERROR_NULL_ARGUMENT,
                  vbss_knot_detector_restore(r.detector, NULL, good.count));
    free(bytes);
    free(good.bytes);
    detector_rig_end(&r);
}

int test_detector_snapshots(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(bad_snapshots_are_rejected),
        cmocka_unit_test(impossible_reading_is_rejected),
        cmocka_unit_test(bad_numbers_in_copied_thread_are_rejected),
        cmocka_unit_test(snapshot_of_other_detector_is_rejected),
        cmocka_unit_test(small_buffer_reports_required_size),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
