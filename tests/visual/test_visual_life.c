/* What a visual may be asked for and when: handles, callbacks, structs, sources that come and go, room. */
#include "fixture.h"

/* ---- handles */

/* What calls on a visual show; alive in the context under test. */
static vbss_thread *thread;
static vbss_drain *drain;
static vbss_needle *needle;
static vbss_grasper *grasper;
static vbss_scene *scene;

static void make_bodies(vbss_context *context)
{
    vbss_thread_config t;
    vbss_drain_config d;
    expect_ok(vbss_thread_config_init(&t, sizeof t));
    expect_ok(vbss_thread_create(context, &t, &thread));
    expect_ok(vbss_drain_config_init(&d, sizeof d));
    expect_ok(vbss_drain_create(context, &d, &drain));
    expect_ok(vbss_needle_create(context, NULL, &needle));
    expect_ok(vbss_grasper_create(context, NULL, &grasper));
    expect_ok(vbss_scene_create(context, NULL, &scene));
}

static vbss_result call_destroy(void *v)
{
    return v == NULL ? VBSS_ERROR_INVALID_HANDLE : vbss_visual_destroy(v);
}
static vbss_result call_add_scene(void *v)
{
    return vbss_visual_add_scene(v, scene, NULL);
}
static vbss_result call_add_thread(void *v)
{
    return vbss_visual_add_thread(v, thread, NULL);
}
static vbss_result call_add_drain(void *v)
{
    return vbss_visual_add_drain(v, drain, NULL);
}
static vbss_result call_add_needle(void *v)
{
    return vbss_visual_add_needle(v, needle, NULL);
}
static vbss_result call_add_grasper(void *v)
{
    return vbss_visual_add_grasper(v, grasper, NULL);
}
static vbss_result call_remove(void *v)
{
    return vbss_visual_remove(v, 1);
}
static vbss_result call_update(void *v)
{
    return vbss_visual_update(v);
}
static vbss_result call_view(void *v)
{
    vbss_view view;
    return vbss_visual_get_view(v, VBSS_VISUAL_VIEW_VERTICES, &view, sizeof view);
}
static vbss_result call_statistics(void *v)
{
    vbss_visual_statistics statistics;
    return vbss_visual_get_statistics(v, &statistics, sizeof statistics);
}

/* Those that change something come first. */
enum { EDITS = 8, CALLS = 10 };
static const harness_handle_call calls[CALLS] = {
    call_add_scene, call_add_thread, call_add_drain, call_add_needle, call_add_grasper,
    call_remove,    call_update,     call_destroy,   call_view,       call_statistics};

static void every_call_rejects_invalid_handles(void **state)
{
    (void)state;
    fixture f;
    begin(&f);
    make_bodies(f.context);
    make(&f);
    vbss_visual *none = f.visual;
    expect_ok(vbss_visual_destroy(f.visual));
    expect_ok(vbss_visual_destroy(NULL));
    harness_refuses_bad_handles(f.context, f.visual, calls, CALLS);
    expect_result(VBSS_ERROR_INVALID_HANDLE,
                  vbss_visual_create((vbss_context *)f.visual, NULL, &none));
    assert_null(none);
    expect_result(VBSS_ERROR_NULL_ARGUMENT, vbss_visual_create(f.context, NULL, NULL));
    end(&f);
}

static void wrong_bodies_are_rejected(void **state)
{
    (void)state;
    fixture f, other;
    begin(&f);
    begin(&other);
    make(&f);
    make_bodies(other.context); /* of another context */
    for (int i = 0; i < 5; i++) {
        expect_result(VBSS_ERROR_INVALID_HANDLE, calls[i](f.visual));
    }
    expect_result(VBSS_ERROR_INVALID_HANDLE, vbss_visual_add_thread(f.visual, NULL, NULL));
    expect_result(VBSS_ERROR_INVALID_HANDLE,
                  vbss_visual_add_drain(f.visual, (vbss_drain *)thread, NULL));
    assert_int_equal(draw(&f).part_count, 0);
    end(&other);
    end(&f);
}

typedef struct listener {
    vbss_context *context;
    vbss_visual *visual;
    vbss_result results[CALLS], created;
    int heard;
} listener;

static void listen(void *user, vbss_log_level level, const char *message)
{
    listener *l = user;
    vbss_visual *made = NULL;
    (void)level;
    (void)message;
    l->heard++;
    for (int i = 0; i < CALLS; i++) {
        l->results[i] = calls[i](l->visual);
    }
    l->created = vbss_visual_create(l->context, NULL, &made);
}

static void calls_inside_callback_are_rejected(void **state)
{
    (void)state;
    listener l = {0};
    harness_memory memory;
    vbss_context_config config = harness_watched_config(&memory);
    config.log = listen;
    config.log_user = &l;
    expect_ok(vbss_context_create(&config, &l.context));
    make_bodies(l.context);
    expect_ok(vbss_visual_create(l.context, NULL, &l.visual));
    expect_result(VBSS_ERROR_NOT_FOUND, vbss_visual_remove(l.visual, 7));
    assert_int_equal(l.heard, 1);
    for (int i = 0; i < CALLS; i++) {
        expect_result(i < EDITS ? VBSS_ERROR_BUSY : VBSS_OK, l.results[i]);
    }
    expect_result(VBSS_ERROR_BUSY, l.created);
    harness_context_end(l.context, &memory);
}

/* ---- structs that go out */

static vbss_result write_out(vbss_visual *visual, int which, void *out, uint32_t size)
{
    return which == 0 ? vbss_visual_get_statistics(visual, out, size)
                      : vbss_visual_get_view(visual, VBSS_VISUAL_VIEW_PARTS, out, size);
}

static void output_struct_size_protocol(void **state)
{
    (void)state;
    const uint32_t sizes[2] = {32, sizeof(vbss_view)};
    fixture f;
    begin(&f);
    make(&f);
    for (int which = 0; which < 2; which++) {
        unsigned char out[128];
        uint32_t filled;
        expect_result(VBSS_ERROR_NULL_ARGUMENT, write_out(f.visual, which, NULL, sizes[which]));
        for (uint32_t size = 0; size < sizes[which]; size++) {
            expect_result(VBSS_ERROR_STRUCT_SIZE, write_out(f.visual, which, out, size));
        }
        memset(out, 0xff, sizeof out);
        expect_ok(write_out(f.visual, which, out, 96));
        memcpy(&filled, out, sizeof filled);
        assert_int_equal(filled, sizes[which]);
        for (uint32_t i = sizes[which]; i < sizeof out; i++) {
            assert_true(out[i] == (i < 96 ? 0 : 0xff));
        }
    }
    end(&f);
}

static void view_dimensions_match_documentation(void **state)
{
    (void)state;
    const struct {
        vbss_view_type type;
        uint32_t components, bytes;
    } wanted[4] = {{VBSS_VIEW_TYPE_F32, 12, 48},
                   {VBSS_VIEW_TYPE_U32, 3, 12},
                   {VBSS_VIEW_TYPE_U32, 8, 32},
                   {VBSS_VIEW_TYPE_F32, 6, 24}};
    fixture f;
    vbss_view view;
    begin(&f);
    make(&f);
    for (vbss_visual_field field = 0; field < 4; field++) {
        expect_ok(vbss_visual_get_view(f.visual, field, &view, sizeof view));
        assert_int_equal(view.type, wanted[field].type);
        assert_int_equal(view.components, wanted[field].components);
        assert_int_equal(view.stride_bytes, wanted[field].bytes);
        assert_int_equal(view.count, 0);
        assert_non_null(view.data);
    }
    expect_result(VBSS_ERROR_OUT_OF_RANGE, vbss_visual_get_view(f.visual, 4, &view, sizeof view));
    expect_result(VBSS_ERROR_OUT_OF_RANGE, vbss_visual_get_view(f.visual, -1, &view, sizeof view));
    end(&f);
}

/* ---- sources */

static void sources_can_be_added_and_removed(void **state)
{
    (void)state;
    fixture f;
    uint32_t numbers[3];
    vbss_visual_statistics s;
    begin(&f);
    f.config.source_capacity = 3;
    make(&f);
    make_bodies(f.context);
    expect_ok(vbss_visual_add_thread(f.visual, thread, &numbers[0]));
    expect_ok(vbss_visual_add_needle(f.visual, needle, &numbers[1]));
    expect_ok(vbss_visual_add_drain(f.visual, drain, &numbers[2]));
    expect_result(VBSS_ERROR_CAPACITY, vbss_visual_add_grasper(f.visual, grasper, NULL));
    for (uint32_t i = 0; i < 3; i++) {
        assert_int_equal(numbers[i], i + 1);
    }
    drawn d = draw(&f);
    assert_int_equal(d.part_count, 3);
    assert_int_equal(d.parts[0].kind, VBSS_VISUAL_KIND_THREAD);
    assert_int_equal(d.parts[1].kind, VBSS_VISUAL_KIND_NEEDLE);
    assert_int_equal(d.parts[2].kind, VBSS_VISUAL_KIND_DRAIN);
    assert_int_equal(d.parts[2].source, 3);
    expect_ok(vbss_visual_remove(f.visual, 2));
    expect_result(VBSS_ERROR_NOT_FOUND, vbss_visual_remove(f.visual, 2));
    expect_result(VBSS_ERROR_NOT_FOUND, vbss_visual_remove(f.visual, 0));
    expect_ok(vbss_visual_add_grasper(f.visual, grasper, &numbers[1]));
    assert_int_equal(numbers[1], 4); /* numbers are not used again */
    expect_ok(vbss_thread_destroy(thread));
    d = draw(&f);
    assert_int_equal(d.part_count, 2); /* what is gone is not shown, and no error */
    assert_int_equal(d.parts[0].kind, VBSS_VISUAL_KIND_DRIVER);
    assert_int_equal(d.parts[1].kind, VBSS_VISUAL_KIND_DRAIN);
    expect_ok(vbss_visual_get_statistics(f.visual, &s, sizeof s));
    assert_int_equal(s.sources, 3);
    assert_int_equal(s.parts, 2);
    assert_int_equal(s.vertices, d.vertex_count);
    assert_int_equal(s.triangles, d.triangle_count);
    assert_int_equal(s.spots, 2);
    assert_int_equal(s.updates, 2);
    end(&f);
}

/* ---- room */

/* What does not fit is told, and what was shown stays. */
static void expect_full(fixture *f)
{
    vbss_view before, after;
    make(f);
    make_bodies(f->context);
    expect_ok(vbss_visual_add_needle(f->visual, needle, NULL));
    const drawn shown = draw(f);
    expect_ok(vbss_visual_get_view(f->visual, 0, &before, sizeof before));
    expect_ok(vbss_visual_add_drain(f->visual, drain, NULL));
    for (int i = 0; i < 3; i++) {
        expect_result(VBSS_ERROR_CAPACITY, vbss_visual_update(f->visual));
    }
    expect_ok(vbss_visual_get_view(f->visual, 0, &after, sizeof after));
    assert_memory_equal(&before, &after, sizeof before);
    assert_int_equal(get_drawn(f).part_count, 1);
    expect_sound(&shown, &shown.parts[0]);
    end(f);
}

static void overflow_is_reported(void **state)
{
    (void)state;
    fixture f;
    begin(&f);
    f.config.vertex_capacity = 2000;
    expect_full(&f);
    begin(&f);
    f.config.triangle_capacity = 3000;
    expect_full(&f);
    begin(&f);
    f.config.part_capacity = 1;
    expect_full(&f);
    begin(&f);
    f.config.spot_capacity = 1;
    expect_full(&f);
    begin(&f);
    f.config.node_capacity = 100;
    expect_full(&f);
}

static void exact_capacity_fits(void **state)
{
    (void)state;
    fixture f;
    begin(&f);
    make(&f);
    make_bodies(f.context);
    expect_ok(vbss_visual_add_drain(f.visual, drain, NULL));
    const drawn d = draw(&f);
    f.config.vertex_capacity = d.vertex_count;
    f.config.triangle_capacity = d.triangle_count;
    f.config.spot_capacity = 2;
    f.config.part_capacity = 1;
    f.config.node_capacity = 137;
    make(&f);
    expect_ok(vbss_visual_add_drain(f.visual, drain, NULL));
    assert_int_equal(draw(&f).triangle_count, d.triangle_count);
    end(&f);
}

/* The arrays of one frame stay while the next is written beside them. */
static void views_live_until_second_update(void **state)
{
    (void)state;
    fixture f;
    begin(&f);
    make(&f);
    make_bodies(f.context);
    expect_ok(vbss_visual_add_needle(f.visual, needle, NULL));
    const drawn before = draw(&f);
    const vec3 first = position_of(&before, 0);
    const double elsewhere[3] = {0.3, 0.2, 0.1};
    expect_ok(vbss_needle_set_state(needle, elsewhere, NULL, NULL, NULL));
    const drawn after = draw(&f);
    expect_same_bits(first.x, position_of(&before, 0).x);
    expect_near(first.x + 0.3, position_of(&after, 0).x, 1e-7);
    end(&f);
}

/* Far away, where floats are coarse, the origin helps. */
static void vertices_are_relative_to_origin(void **state)
{
    (void)state;
    fixture f;
    const double far[3] = {900.0, -800.0, 700.0};
    begin(&f);
    make(&f);
    make_bodies(f.context);
    expect_ok(vbss_visual_add_needle(f.visual, needle, NULL));
    const drawn near = draw(&f);
    const uint32_t count = near.vertex_count;
    const vec3 middle = position_of(&near, count / 2);
    expect_ok(vbss_needle_set_state(needle, far, NULL, NULL, NULL));
    memcpy(f.config.origin, far, sizeof far);
    make(&f);
    expect_ok(vbss_visual_add_needle(f.visual, needle, NULL));
    const drawn d = draw(&f);
    assert_int_equal(d.vertex_count, count);
    assert_true(vec3_distance(position_of(&d, count / 2), middle) < 1e-9);
    end(&f);
}

int test_visual_life(void)
{
    const struct CMUnitTest tests[] = {
        harness_test(every_call_rejects_invalid_handles),
        harness_test(wrong_bodies_are_rejected),
        harness_test(calls_inside_callback_are_rejected),
        harness_test(output_struct_size_protocol),
        harness_test(view_dimensions_match_documentation),
        harness_test(sources_can_be_added_and_removed),
        harness_test(overflow_is_reported),
        harness_test(exact_capacity_fits),
        harness_test(views_live_until_second_update),
        harness_test(vertices_are_relative_to_origin),
    };
    return cmocka_run_group_tests_name("visual.visual_life", tests, NULL, NULL);
}
