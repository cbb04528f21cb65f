/* What an update takes over from earlier frames: the frame is the one of a visual without any. */
#include "base/elementary.h"
#include "fixture.h"

enum { NODES = 61 };

/* A visual with a past, and its bodies in the order in which they are drawn. */
typedef struct stage {
    fixture f;
    vbss_thread *thread;
    vbss_drain *drains[2];
    vbss_grasper *grasper;
    double x[3 * NODES];
} stage;

static void add_bodies(stage *s, vbss_visual *visual, bool first_drain, bool second_drain)
{
    expect_ok(vbss_visual_add_thread(visual, s->thread, NULL));
    if (first_drain) {
        expect_ok(vbss_visual_add_drain(visual, s->drains[0], NULL));
    }
    expect_ok(vbss_visual_add_grasper(visual, s->grasper, NULL));
    if (second_drain) {
        expect_ok(vbss_visual_add_drain(visual, s->drains[1], NULL));
    }
}

/* An arc with this angle between segments, and thus with more rings the larger it is. */
static void bend(stage *s, double angle)
{
    vec3 x = vec3_zero();
    for (uint32_t i = 0; i < NODES; i++) {
        vec3_store(s->x + 3 * (size_t)i, x);
        x = vec3_add(x, vec3_scale(vec3_make(vbss_cos(angle * i), vbss_sin(angle * i), 0.0), 1e-3));
    }
    expect_ok(vbss_thread_set_state(s->thread, s->x, NULL, NODES));
}

/* Stretches a drain along its axis: the divisions stay, the vertices move. */
static void move_drain(vbss_drain *drain, double share)
{
    vbss_view view;
    double x[3 * 512];
    expect_ok(vbss_drain_get_view(drain, VBSS_DRAIN_VIEW_POSITIONS, &view, sizeof view));
    assert_in_range(view.count, 1, 512);
    memcpy(x, view.data, (size_t)view.count * 3 * sizeof *x);
    for (uint64_t i = 0; i < view.count; i++) {
        x[3 * i + 1] += share * vbss_max(x[3 * i + 1], 0.0);
    }
    expect_ok(vbss_drain_set_state(drain, x, NULL, (uint32_t)view.count));
}

static void make_stage(stage *s)
{
    vbss_thread_config c;
    vbss_drain_config drain;
    begin(&s->f);
    expect_ok(vbss_drain_config_init(&drain, sizeof drain));
    expect_ok(vbss_thread_config_init(&c, sizeof c));
    for (uint32_t i = 0; i < NODES; i++) {
        vec3_store(s->x + 3 * (size_t)i, vec3_make(1e-3 * i, 0.0, 0.0));
    }
    c.segment_count = NODES - 1;
    c.positions = s->x;
    c.radius = 4e-4;
    expect_ok(vbss_thread_create(s->f.context, &c, &s->thread));
    for (int i = 0; i < 2; i++) {
        drain.length *= 1.0 + 0.1 * i; /* like meshes, unlike attributes */
        expect_ok(vbss_drain_create(s->f.context, &drain, &s->drains[i]));
    }
    expect_ok(vbss_grasper_create(s->f.context, NULL, &s->grasper));
}

/* Frames of a thread depend on the frame before, so positions and normals of its part may not be
 * equal. */
static void expect_equal(const drawn *a, const drawn *b)
{
    assert_int_equal(a->vertex_count, b->vertex_count);
    assert_int_equal(a->triangle_count, b->triangle_count);
    assert_memory_equal(a->triangles, b->triangles, a->triangle_count * sizeof *a->triangles);
    for (uint32_t i = 0; i < a->vertex_count; i++) {
        const size_t offset = i < a->parts[0].vertex_count ? offsetof(visual_vertex, texture) : 0;
        assert_memory_equal((const uint8_t *)&a->vertices[i] + offset,
                            (const uint8_t *)&b->vertices[i] + offset,
                            sizeof a->vertices[i] - offset);
    }
}

static void expect_as_new(stage *s, bool first_drain, bool second_drain)
{
    fixture fresh = s->f;
    make(&fresh);
    add_bodies(s, fresh.visual, first_drain, second_drain);
    const drawn a = draw(&s->f), b = draw(&fresh);
    expect_equal(&a, &b);
    expect_ok(vbss_visual_destroy(fresh.visual));
}

/* While the thread is at rest all parts stay where they are in the buffers. When it bends, those
 * after it move. */
static void parts_that_move_in_buffers(void **state)
{
    (void)state;
    stage s;
    const double angles[] = {0.0, 0.0, 0.0, 0.1, 0.3, 0.3, 0.3, 0.02, 0.0, 0.3, 0.0, 0.3, 0.0};
    make_stage(&s);
    make(&s.f);
    add_bodies(&s, s.f.visual, true, true);
    for (size_t i = 0; i < sizeof angles / sizeof *angles; i++) {
        bend(&s, angles[i]);
        move_drain(s.drains[i % 2], 1e-3);
        expect_ok(vbss_grasper_set_opening(s.grasper, i % 2 == 0 ? 1.0 : 0.0));
        expect_as_new(&s, true, true);
    }
    end(&s.f);
}

static void divisions_that_change(void **state)
{
    (void)state;
    stage s;
    make_stage(&s);
    make(&s.f);
    add_bodies(&s, s.f.visual, true, true);
    uint32_t counts[2] = {0, 0};
    for (int i = 0; i < 6; i++) {
        move_drain(s.drains[0], i % 2 == 0 ? 1.0 : -0.5); /* to twice its height, and back */
        expect_as_new(&s, true, true);
        counts[i % 2] = get_drawn(&s.f).triangle_count;
    }
    assert_true(counts[0] != counts[1]);
    end(&s.f);
}

/* Shows a source of a kind, as a new visual does. The source is removed afterwards. */
static void expect_alone(stage *s, vbss_drain *drain, vbss_needle *needle)
{
    fixture fresh = s->f;
    fixture *both[2] = {&s->f, &fresh};
    uint32_t source[2];
    make(&fresh);
    for (int i = 0; i < 2; i++) {
        expect_ok(drain != NULL ? vbss_visual_add_drain(both[i]->visual, drain, &source[i])
                                : vbss_visual_add_needle(both[i]->visual, needle, &source[i]));
    }
    const drawn a = draw(&s->f), b = draw(&fresh);
    assert_int_equal(a.vertex_count, b.vertex_count);
    assert_int_equal(a.triangle_count, b.triangle_count);
    assert_memory_equal(a.vertices, b.vertices, a.vertex_count * sizeof *a.vertices);
    assert_memory_equal(a.triangles, b.triangles, a.triangle_count * sizeof *a.triangles);
    expect_ok(vbss_visual_destroy(fresh.visual));
    expect_ok(vbss_visual_remove(s->f.visual, source[0]));
}

static void body_that_takes_place_of_another(void **state)
{
    (void)state;
    stage s;
    vbss_needle_config c;
    vbss_needle *needles[2];
    make_stage(&s);
    make(&s.f);
    expect_ok(vbss_needle_config_init(&c, sizeof c));
    for (int i = 0; i < 2; i++) { /* with unlike sections */
        c.wire_radius *= 1.0 + 0.4 * i;
        expect_ok(vbss_needle_create(s.f.context, &c, &needles[i]));
    }
    for (uint32_t i = 0; i < 4; i++) {
        expect_alone(&s, s.drains[i / 2], NULL);
    }
    for (uint32_t i = 0; i < 4; i++) {
        expect_alone(&s, NULL, needles[i / 2]);
    }
    end(&s.f);
}

/* Between its removal and its return, other parts have overwritten a wall. */
static void walls_that_go_and_come(void **state)
{
    (void)state;
    stage s;
    uint32_t sources[2];
    make_stage(&s);
    make(&s.f);
    add_bodies(&s, s.f.visual, false, false);
    for (int i = 0; i < 3; i++) {
        for (int k = 0; k < 2; k++) {
            expect_ok(vbss_visual_add_drain(s.f.visual, s.drains[k], &sources[k]));
            expect_ok(vbss_visual_update(s.f.visual));
            expect_ok(vbss_visual_update(s.f.visual));
        }
        expect_ok(vbss_visual_remove(s.f.visual, sources[0]));
        expect_ok(vbss_visual_remove(s.f.visual, sources[1]));
        for (int k = 0; k <= i; k++) {
            expect_as_new(&s, false, false);
        }
        expect_ok(vbss_visual_add_drain(s.f.visual, s.drains[i % 2], &sources[0]));
        expect_ok(vbss_visual_update(s.f.visual));
        fixture fresh = s.f;
        make(&fresh);
        add_bodies(&s, fresh.visual, false, false);
        expect_ok(vbss_visual_add_drain(fresh.visual, s.drains[i % 2], NULL));
        const drawn a = get_drawn(&s.f), b = draw(&fresh);
        expect_equal(&a, &b);
        expect_ok(vbss_visual_destroy(fresh.visual));
        expect_ok(vbss_visual_remove(s.f.visual, sources[0]));
    }
    end(&s.f);
}

/* An update that fails has overwritten part of a frame. */
static void update_that_failed(void **state)
{
    (void)state;
    stage s;
    make_stage(&s);
    fixture probe = s.f;
    make(&probe);
    add_bodies(&s, probe.visual, true, true);
    bend(&s, 0.0);
    const drawn all = draw(&probe);
    s.f.config.vertex_capacity = all.vertex_count;
    s.f.config.triangle_capacity = all.triangle_count;
    expect_ok(vbss_visual_destroy(probe.visual));
    make(&s.f);
    add_bodies(&s, s.f.visual, true, true);
    for (int i = 0; i < 4; i++) {
        bend(&s, 0.0);
        expect_as_new(&s, true, true);
        bend(&s, 0.05 * (1 + i));
        for (int k = 0; k <= i; k++) {
            expect_result(VBSS_ERROR_CAPACITY, vbss_visual_update(s.f.visual));
        }
    }
    bend(&s, 0.0);
    expect_as_new(&s, true, true);
    expect_as_new(&s, true, true);
    end(&s.f);
}

int test_visual_reuse(void)
{
    const struct CMUnitTest tests[] = {
        harness_test(parts_that_move_in_buffers),
        harness_test(divisions_that_change),
        harness_test(body_that_takes_place_of_another),
        harness_test(walls_that_go_and_come),
        harness_test(update_that_failed),
    };
    return cmocka_run_group_tests_name("visual.visual_reuse", tests, NULL, NULL);
}
