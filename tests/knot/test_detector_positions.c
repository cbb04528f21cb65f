/* What is the same thread and the same tools to a detector, however they are shown. */
#include "knot/detector_rig.h"

static void points_may_be_strided_and_reversed(void **state)
{
    (void)state;
    detector_rig r, other;
    struct row {
        float weight;
        double x[3];
        char name[8];
    } rows[RIG_POINTS];
    detector_rig_begin(&r);
    detector_rig_begin(&other);
    detector_rig_create(&r);
    detector_rig_create(&other);
    detector_rig_tie(&r, "2=1", 160);
    detector_rig_add_tools(&r, 2);
    other.input = r.input;
    const uint32_t count = r.input.point_count;
    memset(rows, 0xff, sizeof rows);
    for (uint32_t i = 0; i < count; i++) {
        memcpy(rows[i].x, r.points[i], sizeof rows[i].x);
    }
    other.input.points = rows[0].x;
    other.input.stride_bytes = sizeof rows[0];
    detector_rig_judge(&r);
    detector_rig_judge(&other);
    detectors_are_alike(r.detector, other.detector, true);

    const double last = count - 1.0;
    for (uint32_t i = 0; i < count; i++) {
        memcpy(rows[i].x, r.points[count - 1 - i], sizeof rows[i].x);
    }
    memcpy(other.tools, r.tools, sizeof r.tools);
    other.tools[0].held_place = last - r.tools[0].held_place;
    other.input.tools = other.tools;
    other.input.reversed = 1;
    for (int i = 0; i < 2; i++) {
        other.input.hole_places[i] = last - r.input.hole_places[i];
    }
    expect_ok(vbss_knot_detector_reset(other.detector));
    detector_rig_judge(&other);
    for (uint32_t i = 0; i < 2; i++) {
        vbss_knot_throw t = detector_rig_throw(&r, i), u = detector_rig_throw(&other, i);
        assert_int_equal(t.handedness, u.handedness);
        assert_int_equal(t.flags, u.flags);
        expect_near(t.tail_length, u.tail_length, 1e-15);
        for (int k = 0; k < 2; k++) { /* ascending in the host's numbers */
            expect_near(last - t.tail_places[1 - k], u.tail_places[k], 1e-9);
            expect_near(last - t.long_places[1 - k], u.long_places[k], 1e-9);
        }
    }
    detector_rig_end(&other);
    detector_rig_end(&r);
}

/* Points given twice are points of the host's numbers nevertheless. */
static void reported_places_are_in_host_units(void **state)
{
    (void)state;
    for (uint32_t reversed = 0; reversed < 2; reversed++) {
        detector_rig r, twice;
        detector_rig_begin(&r);
        detector_rig_begin(&twice);
        detector_rig_create(&r);
        detector_rig_create(&twice);
        detector_rig_tie(&r, "1", 80);
        if (reversed) {
            thread_line_reverse(&r.line);
        }
        r.input.reversed = reversed;
        for (uint32_t i = 0; i < r.line.count; i++) {
            vec3_store(r.points[i], r.line.x[i]);
        }
        detector_rig_add_tools(&r, 1);
        r.tools[0].held_place = reversed ? r.line.count - 1.0 - 1.5 : 1.5;
        for (int i = 0; i < 2; i++) {
            r.input.hole_places[i] = r.line.hole_places[i];
        }
        twice.input = r.input;
        memcpy(twice.tools, r.tools, sizeof r.tools);
        for (uint32_t i = 0; i < r.line.count; i++) {
            for (size_t k = 2 * (size_t)i; k < 2 * (size_t)i + 2; k++) {
                memcpy(twice.points[k], r.points[i], sizeof r.points[i]);
            }
        }
        /* Segment i is now 2 i + 1, between the second of a pair and the first of the next. */
        twice.input.points = twice.points[0];
        twice.input.point_count = 2 * r.line.count;
        twice.input.tools = twice.tools;
        twice.tools[0].held_place += 1.0 + floor(r.tools[0].held_place);
        for (int i = 0; i < 2; i++) {
            twice.input.hole_places[i] += 1.0 + floor(r.input.hole_places[i]);
        }
        detector_rig_judge(&r);
        detector_rig_judge(&twice);
        vbss_knot_state p = detector_rig_state(&r), q = detector_rig_state(&twice);
        assert_memory_equal(&p, &q, sizeof p);
        vbss_knot_throw t = detector_rig_throw(&r, 0), u = detector_rig_throw(&twice, 0);
        expect_near(t.tail_length, u.tail_length, 1e-12);
        for (int k = 0; k < 2; k++) {
            expect_near(t.tail_places[k] + 1.0 + floor(t.tail_places[k]), u.tail_places[k], 1e-9);
            expect_near(t.long_places[k] + 1.0 + floor(t.long_places[k]), u.long_places[k], 1e-9);
        }
        detector_rig_end(&twice);
        detector_rig_end(&r);
    }
}

static void holes_without_arc_use_nearest_point(void **state)
{
    (void)state;
    detector_rig r, other;
    detector_rig_begin(&r);
    detector_rig_begin(&other);
    detector_rig_create(&r);
    detector_rig_create(&other);
    detector_rig_tie(&r, "2=1", 160);
    detector_rig_tie(&other, "2=1", 160);
    other.input.hole_places[0] = other.input.hole_places[1] = -1.0;
    detector_rig_judge(&r);
    detector_rig_judge(&other);
    expect_near(r.line.tissue_place, detector_rig_object(&other)->input.tissue_place, 1e-6);
    for (uint32_t i = 0; i < 2; i++) {
        vbss_knot_throw t = detector_rig_throw(&r, i), u = detector_rig_throw(&other, i);
        assert_int_equal(t.flags, u.flags);
        expect_near(t.tail_places[0], u.tail_places[0], 1e-6);
    }
    detector_rig_end(&other);
    detector_rig_end(&r);
}

static void coincident_points_are_unknot(void **state)
{
    (void)state;
    for (uint32_t reversed = 0; reversed < 2; reversed++) {
        detector_rig r;
        detector_rig_begin(&r);
        detector_rig_create(&r);
        detector_rig_add_tools(&r, 3);
        memset(r.points, 0, sizeof r.points);
        r.input.reversed = reversed;
        r.input.hole_count = 1;
        detector_rig_judge(&r);
        detector_rig_steps(&r, 50);
        vbss_knot_state s = detector_rig_state(&r);
        assert_int_equal(s.throw_count, 0);
        assert_int_equal(s.name, VBSS_KNOT_NAME_NONE);
        for (uint32_t i = 0; i < 3; i++) {
            expect_near(0.0, detector_rig_winding(&r, i).turns, 0.0);
        }
        detector_rig_end(&r);
    }
}

int test_detector_positions(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(points_may_be_strided_and_reversed),
        cmocka_unit_test(reported_places_are_in_host_units),
        cmocka_unit_test(holes_without_arc_use_nearest_point),
        cmocka_unit_test(coincident_points_are_unknot),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
