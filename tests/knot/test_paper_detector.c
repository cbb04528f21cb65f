/* Method PROJECTION as hosts see it. What it finds and what it misses: test_paper_cases.c,
 * test_paper_tying.c. */
#include <string.h>

#include "harness/harness.h"
#include "fixtures/paper_knot_cases.h"
#include "fixtures/paper_tying.h"

typedef struct host {
    harness_memory memory;
    vbss_context *context;
    vbss_knot_detector *detector;
    vec3 points[PAPER_TYING_POINTS];
    vbss_knot_tool tool;
    vbss_knot_input input;
} host;

static void host_begin(host *h)
{
    memset(h, 0, sizeof *h);
    h->context = harness_context(&h->memory);
    vbss_knot_detector_config config;
    expect_ok(vbss_knot_detector_config_init(&config, sizeof config));
    assert_true(config.plane_offset == -2e-3); /* as the sweep has it */
    config.method = VBSS_KNOT_METHOD_PROJECTION;
    expect_ok(vbss_knot_detector_create(h->context, &config, &h->detector));
    expect_ok(vbss_knot_input_init(&h->input, sizeof h->input));
    h->tool = paper_knot_tool();
    h->input.points = &h->points[0].x;
    h->input.tools = &h->tool;
    h->input.tool_count = 1;
}

static void host_end(host *h)
{
    expect_ok(vbss_knot_detector_destroy(h->detector));
    harness_context_end(h->context, &h->memory);
}

static vbss_knot_state host_step(host *h)
{
    vbss_knot_state state;
    expect_ok(vbss_knot_detector_step(h->detector, &h->input));
    expect_ok(vbss_knot_detector_get_state(h->detector, &state, sizeof state));
    return state;
}

static vbss_view host_loops(host *h)
{
    vbss_view view;
    expect_ok(vbss_knot_detector_get_view(h->detector, VBSS_KNOT_VIEW_LOOPS, &view, sizeof view));
    return view;
}

static const uint32_t *row(const vbss_view *view, uint64_t number)
{
    return (const uint32_t *)(const void *)((const char *)view->data + number * view->stride_bytes);
}

static void view_shows_all_loops(void **state)
{
    (void)state;
    host h;
    host_begin(&h);
    for (paper_knot_kind kind = 0; kind < PAPER_KNOT_KINDS; kind++) {
        const paper_knot_case *c = &paper_knot_cases[kind];
        h.input.point_count = paper_knot_make(kind, h.points);
        host_step(&h);
        vbss_view view = host_loops(&h);
        assert_int_equal(c->loops + c->rejected, view.count);
        uint32_t inside = 0;
        for (uint64_t k = 0; k < view.count; k++) {
            assert_int_equal(0, row(&view, k)[0]);
            assert_true(row(&view, k)[1] + 2 <= row(&view, k)[2]);
            assert_true(row(&view, k)[2] + 1 < h.input.point_count);
            inside += row(&view, k)[3];
        }
        assert_int_equal(c->loops, inside);
    }
    host_end(&h);
}

static void segments_use_host_numbers(void **state)
{
    (void)state;
    host h;
    host_begin(&h);
    uint32_t n = h.input.point_count = paper_knot_make(PAPER_KNOT_E, h.points);
    host_step(&h);
    vbss_view view = host_loops(&h);
    assert_int_equal(1, view.count);
    uint32_t first = row(&view, 0)[1], last = row(&view, 0)[2];
    for (uint32_t k = 0; k < n / 2; k++) {
        vec3 swapped = h.points[k];
        h.points[k] = h.points[n - 1 - k];
        h.points[n - 1 - k] = swapped;
    }
    h.input.reversed = 1;
    host_step(&h);
    view = host_loops(&h);
    assert_int_equal(1, view.count);
    uint32_t a = row(&view, 0)[1], b = row(&view, 0)[2];
    assert_int_equal(n - 2 - last, a < b ? a : b);
    assert_int_equal(n - 2 - first, a < b ? b : a);

    /* A point given twice is one point, but counts. */
    h.input.reversed = 0;
    n = paper_knot_make(PAPER_KNOT_E, h.points);
    memmove(h.points + 1, h.points, n * sizeof *h.points);
    h.input.point_count = n + 1;
    host_step(&h);
    view = host_loops(&h);
    assert_int_equal(1, view.count);
    assert_int_equal(first + 1, row(&view, 0)[1]);
    assert_int_equal(last + 1, row(&view, 0)[2]);
    host_end(&h);
}

static void throw_appears_and_disappears(void **state)
{
    (void)state;
    host h;
    host_begin(&h);
    paper_tying t = {PAPER_TYING_WRAPPED, 1, false, 0.0, 1e-3};
    h.input.point_count = paper_tying_make(&t, 1, h.points);
    vbss_knot_state s = host_step(&h);
    assert_int_equal(0, s.loops + s.undone);
    assert_true(host_loops(&h).count > 0);
    t.stage = PAPER_TYING_DRAWN;
    h.input.point_count = paper_tying_make(&t, 1, h.points);
    s = host_step(&h);
    assert_int_equal(1, s.loops);
    assert_int_equal(0, s.undone);
    assert_int_equal(1, s.next_wraps);
    assert_int_equal(0, s.next_handedness); /* it has none */
    t.towards_handle = true;
    h.input.point_count = paper_tying_make(&t, 1, h.points);
    s = host_step(&h);
    assert_int_equal(0, s.loops);
    assert_int_equal(1, s.undone);
    h.input.tool_count = 0;
    h.input.point_count = paper_tying_make(&t, 1, h.points);
    s = host_step(&h);
    assert_int_equal(0, s.loops + s.undone);
    assert_int_equal(0, host_loops(&h).count);
    host_end(&h);
}

int test_paper_detector(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(view_shows_all_loops),
        cmocka_unit_test(segments_use_host_numbers),
        cmocka_unit_test(throw_appears_and_disappears),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
