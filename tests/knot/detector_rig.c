#include "knot/detector_rig.h"

#include "base/elementary.h"

#define TURN 6.28318530717958648

static const detector_rig *last_begun;

/* ---- life */

static void show_points(detector_rig *r, uint32_t count)
{
    r->input.points = r->points[0];
    r->input.point_count = count;
}

void detector_rig_begin(detector_rig *r)
{
    memset(r, 0, sizeof *r);
    r->context = harness_context(&r->memory);
    expect_ok(vbss_knot_detector_config_init(&r->config, sizeof r->config));
    r->config.point_capacity = RIG_POINTS;
    r->config.tool_capacity = RIG_TOOLS;
    expect_ok(vbss_knot_input_init(&r->input, sizeof r->input));
    for (uint32_t i = 0; i < 20; i++) {
        vec3_store(r->points[i], vec3_make(0.01 * i, 0.0, 0.0));
    }
    show_points(r, 20);
    last_begun = r;
}

void detector_rig_create(detector_rig *r)
{
    expect_ok(vbss_knot_detector_create(r->context, &r->config, &r->detector));
}

void detector_rig_end(detector_rig *r)
{
    harness_context_end(r->context, &r->memory);
}

/* ---- what is shown */

void detector_rig_tie(detector_rig *r, const char *notation, uint32_t segments)
{
    throw_stack stack;
    int sign = 1;
    throw_stack_init(&stack);
    stack.segments = segments;
    for (const char *c = notation; *c != '\0'; c++) {
        if (*c == '=') {
            sign = -sign;
        } else if (*c != 'x') {
            throw_stack_add(&stack, *c - '0', sign);
        }
    }
    assert_true(throw_stack_make(&stack, &r->line) && r->line.count <= RIG_POINTS);
    for (uint32_t i = 0; i < r->line.count; i++) {
        vec3_store(r->points[i], r->line.x[i]);
    }
    show_points(r, r->line.count);
    r->input.hole_count = 2;
    for (int i = 0; i < 2; i++) {
        vec3_store(r->input.holes[i], r->line.holes[i]);
        r->input.hole_places[i] = r->line.hole_places[i];
    }
    vec3_store(r->input.away, r->line.away);
}

void detector_rig_figure_eight(detector_rig *r)
{
    const uint32_t count = 160;
    for (uint32_t i = 0; i < count; i++) { /* opened where it is farthest out */
        double t = 0.02 + (TURN - 0.04) * i / (count - 1), sine, cosine;
        vbss_sincos(3.0 * t, &sine, &cosine);
        double radius = 2.0 + vbss_cos(2.0 * t);
        vec3 x = vec3_make(radius * cosine, radius * sine, vbss_sin(4.0 * t));
        x.x = i == 0 || i + 1 == count ? 9.0 : x.x; /* limbs */
        vec3_store(r->points[i], vec3_scale(x, 2e-3));
    }
    show_points(r, count);
    r->input.hole_count = 0;
}

static vbss_knot_tool *add_tool(detector_rig *r, vec3 handle, vec3 tip)
{
    assert_true(r->input.tool_count < RIG_TOOLS);
    vbss_knot_tool *tool = &r->tools[r->input.tool_count++];
    *tool = (vbss_knot_tool){.point_count = 2, .radius = {1e-3}};
    vec3_store(tool->axis[0], handle);
    vec3_store(tool->axis[1], tip);
    r->input.tools = r->tools;
    return tool;
}

void detector_rig_add_tools(detector_rig *r, uint32_t count)
{
    static const double handles[RIG_TOOLS][3] = {
        {-0.15, 0.05, 0.15}, {0.2, -0.02, 0.2}, {0.0, 0.3, 0.3}};
    assert_true(count <= RIG_TOOLS);
    for (uint32_t i = 0; i < count && i < RIG_TOOLS; i++) {
        const double place = i == 0 ? 1.5 : i == 1 ? r->input.point_count - 1.0 : 0.0;
        uint32_t first = (uint32_t)place;
        vec3 tip = vec3_load(r->points[first]);
        if (i == 0) {
            tip = vec3_lerp(tip, vec3_load(r->points[first + 1]), place - first);
        } else if (i == 2) {
            tip = vec3_make(0.0, 0.2, 0.2);
        }
        vbss_knot_tool *tool = add_tool(r, vec3_load(handles[i]), tip);
        tool->held = i == 0   ? VBSS_KNOT_HELD_THREAD
                     : i == 1 ? VBSS_KNOT_HELD_NEEDLE
                              : VBSS_KNOT_HELD_NOTHING;
        tool->held_place = place;
    }
}

void detector_rig_wind(detector_rig *r, double turns)
{
    const uint32_t count = 100;
    for (uint32_t i = 0; i < count; i++) {
        double share = (double)i / (count - 1), sine, cosine;
        vbss_sincos(TURN * turns * share, &sine, &cosine);
        vec3_store(r->points[i], vec3_make(3e-3 * cosine, 3e-3 * sine, 0.03 - 0.02 * share));
    }
    show_points(r, count);
    add_tool(r, vec3_make(0.0, 0.0, 0.1), vec3_zero()); /* from tip to handle: z */
}

/* ---- steps */

void detector_rig_steps(detector_rig *r, uint32_t count)
{
    for (uint32_t i = 0; i < count; i++) {
        expect_ok(vbss_knot_detector_step(r->detector, &r->input));
    }
}

void detector_rig_judge(detector_rig *r)
{
    expect_ok(vbss_knot_detector_judge(r->detector, &r->input));
}

uint32_t detector_rig_read(detector_rig *r)
{
    uint64_t before = detector_rig_statistics(r).readings;
    uint32_t steps = 0;
    while (detector_rig_statistics(r).readings == before) {
        detector_rig_steps(r, 1);
        assert_true(++steps < 100000);
    }
    return steps;
}

/* ---- looking */

vbss_knot_state detector_rig_state(const detector_rig *r)
{
    vbss_knot_state s;
    expect_ok(vbss_knot_detector_get_state(r->detector, &s, sizeof s));
    return s;
}

vbss_knot_throw detector_rig_throw(const detector_rig *r, uint32_t number)
{
    vbss_knot_throw t;
    expect_ok(vbss_knot_detector_get_throw(r->detector, number, &t, sizeof t));
    return t;
}

vbss_knot_winding detector_rig_winding(const detector_rig *r, uint32_t tool)
{
    vbss_knot_winding w;
    expect_ok(vbss_knot_detector_get_winding(r->detector, tool, &w, sizeof w));
    return w;
}

vbss_knot_detector_statistics detector_rig_statistics(const detector_rig *r)
{
    vbss_knot_detector_statistics s;
    expect_ok(vbss_knot_detector_get_statistics(r->detector, &s, sizeof s));
    return s;
}

vbss_view detector_rig_view(const detector_rig *r, vbss_knot_field field)
{
    vbss_view v;
    expect_ok(vbss_knot_detector_get_view(r->detector, field, &v, sizeof v));
    return v;
}

uint64_t detector_rig_hash(const detector_rig *r)
{
    uint64_t hash;
    expect_ok(vbss_knot_detector_get_hash(r->detector, &hash));
    return hash;
}

uint32_t detector_rig_events(const detector_rig *r, vbss_knot_event kind, uint32_t event[4])
{
    vbss_view v = detector_rig_view(r, VBSS_KNOT_VIEW_EVENTS);
    uint32_t count = 0;
    for (uint64_t i = 0; i < v.count; i++) {
        uint32_t row[4];
        memcpy(row, (const uint8_t *)v.data + i * v.stride_bytes, sizeof row);
        if (row[0] == (uint32_t)kind) {
            count++;
            if (event != NULL) {
                memcpy(event, row, sizeof row);
            }
        }
    }
    return count;
}

void detector_rig_expect_notation(const detector_rig *r, const char *wanted)
{
    char text[32];
    expect_ok(vbss_knot_detector_get_notation(r->detector, text, sizeof text));
    assert_string_equal(text, wanted);
}

static void views_are_alike(vbss_knot_detector *a, vbss_knot_detector *b, vbss_knot_field field)
{
    vbss_view p, q;
    expect_ok(vbss_knot_detector_get_view(a, field, &p, sizeof p));
    expect_ok(vbss_knot_detector_get_view(b, field, &q, sizeof q));
    assert_int_equal(p.count, q.count);
    for (uint64_t i = 0; i < p.count; i++) {
        assert_memory_equal((const uint8_t *)p.data + i * p.stride_bytes,
                            (const uint8_t *)q.data + i * q.stride_bytes, 16);
    }
}

/* Structs of a kind that are numbered, until there are no more. */
static void parts_are_alike(vbss_knot_detector *a, vbss_knot_detector *b, bool throws)
{
    vbss_result results[2] = {VBSS_OK, VBSS_OK};
    for (uint32_t i = 0; results[0] == VBSS_OK; i++) {
        vbss_knot_throw t[2];
        vbss_knot_winding w[2];
        memset(t, 0, sizeof t);
        memset(w, 0, sizeof w);
        for (int k = 0; k < 2; k++) {
            vbss_knot_detector *d = k == 0 ? a : b;
            results[k] = throws ? vbss_knot_detector_get_throw(d, i, &t[k], sizeof t[k])
                                : vbss_knot_detector_get_winding(d, i, &w[k], sizeof w[k]);
        }
        assert_int_equal(results[0], results[1]);
        assert_memory_equal(&t[0], &t[1], sizeof t[0]);
        assert_memory_equal(&w[0], &w[1], sizeof w[0]);
    }
}

void detectors_are_alike(vbss_knot_detector *a, vbss_knot_detector *b, bool events)
{
    uint64_t hashes[2];
    vbss_knot_state states[2];
    vbss_knot_detector_statistics figures[2];
    char texts[2][32];
    for (int k = 0; k < 2; k++) {
        vbss_knot_detector *d = k == 0 ? a : b;
        expect_ok(vbss_knot_detector_get_hash(d, &hashes[k]));
        expect_ok(vbss_knot_detector_get_state(d, &states[k], sizeof states[k]));
        expect_ok(vbss_knot_detector_get_statistics(d, &figures[k], sizeof figures[k]));
        expect_ok(vbss_knot_detector_get_notation(d, texts[k], sizeof texts[k]));
    }
    assert_true(hashes[0] == hashes[1]);
    assert_memory_equal(&states[0], &states[1], sizeof states[0]);
    assert_memory_equal(&figures[0], &figures[1], sizeof figures[0]);
    assert_string_equal(texts[0], texts[1]);
    parts_are_alike(a, b, true);
    parts_are_alike(a, b, false);
    if (events) {
        views_are_alike(a, b, VBSS_KNOT_VIEW_EVENTS);
        views_are_alike(a, b, VBSS_KNOT_VIEW_LOOPS);
    }
}

knot_detector *detector_rig_object(const detector_rig *r)
{
    knot_detector *object;
    expect_ok(vbss_knot_open(r->detector, &object));
    return object;
}

/* ---- every call */

static vbss_result call_step(void *detector)
{
    return vbss_knot_detector_step(detector, &last_begun->input);
}
static vbss_result call_judge(void *detector)
{
    return vbss_knot_detector_judge(detector, &last_begun->input);
}
static vbss_result call_reset(void *detector)
{
    return vbss_knot_detector_reset(detector);
}
vbss_result detector_call_restore(void *detector)
{
    uint8_t bytes[64] = {0};
    return vbss_knot_detector_restore(detector, bytes, sizeof bytes);
}
static vbss_result call_save(void *detector)
{
    uint64_t written;
    vbss_result result = vbss_knot_detector_save(detector, NULL, 0, &written);
    return result == VBSS_ERROR_CAPACITY ? VBSS_OK : result;
}
static vbss_result call_hash(void *detector)
{
    uint64_t hash;
    return vbss_knot_detector_get_hash(detector, &hash);
}
static vbss_result call_notation(void *detector)
{
    char text[32];
    return vbss_knot_detector_get_notation(detector, text, sizeof text);
}
static vbss_result call_state(void *detector)
{
    vbss_knot_state state;
    return vbss_knot_detector_get_state(detector, &state, sizeof state);
}
static vbss_result call_view(void *detector)
{
    vbss_view view;
    return vbss_knot_detector_get_view(detector, VBSS_KNOT_VIEW_EVENTS, &view, sizeof view);
}
static vbss_result call_statistics(void *detector)
{
    vbss_knot_detector_statistics statistics;
    return vbss_knot_detector_get_statistics(detector, &statistics, sizeof statistics);
}
/* There is none of these. */
static vbss_result call_throw(void *detector)
{
    vbss_knot_throw t;
    vbss_result result = vbss_knot_detector_get_throw(detector, 99, &t, sizeof t);
    return result == VBSS_ERROR_NOT_FOUND ? VBSS_OK : result;
}
static vbss_result call_winding(void *detector)
{
    vbss_knot_winding winding;
    vbss_result result = vbss_knot_detector_get_winding(detector, 99, &winding, sizeof winding);
    return result == VBSS_ERROR_NOT_FOUND ? VBSS_OK : result;
}

const harness_handle_call detector_calls[DETECTOR_CALLS] = {
    call_step,     call_judge, call_reset, detector_call_restore, call_save,  call_hash,
    call_notation, call_state, call_view,  call_statistics,       call_throw, call_winding};

/* ---- structs that go out */

const uint32_t detector_struct_sizes[DETECTOR_STRUCTS] = {120, 88, 64, 104, sizeof(vbss_view)};

vbss_result detector_write_out(vbss_knot_detector *detector, int which, void *out, uint32_t size)
{
    switch (which) {
    case 0:
        return vbss_knot_detector_get_state(detector, out, size);
    case 1:
        return vbss_knot_detector_get_throw(detector, 0, out, size);
    case 2:
        return vbss_knot_detector_get_winding(detector, 0, out, size);
    case 3:
        return vbss_knot_detector_get_statistics(detector, out, size);
    default:
        return vbss_knot_detector_get_view(detector, VBSS_KNOT_VIEW_EVENTS, out, size);
    }
}
