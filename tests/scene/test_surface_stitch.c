/* A pad of the host's triangles in a scene: a tool presses it, a thread is stitched through it, a saved scene holds it. */
#include <stdlib.h>

#include "fixtures/pad.h"
#include "scene/small.h"

#define SIDE 30e-3
#define FRICTION 0.02 /* N, of a slack thread in a hole */
enum { CELLS = 12, SEGMENTS = 40 };

static pad skin;

typedef struct stitched {
    small s;
    vbss_drain *drain;
    vbss_thread *thread;
    uint32_t pad, suture;
    vec3 hole;
} stitched;

static vec3 middle_of(const pad *p, uint32_t triangle)
{
    vec3 sum = vec3_zero();
    for (int k = 0; k < 3; k++) {
        sum = vec3_add(sum, vec3_load(p->positions[p->triangles[triangle][k]]));
    }
    return vec3_scale(sum, 1.0 / 3.0);
}

static void begin(stitched *c)
{
    small_begin(&c->s);
    pad_make(&skin, CELLS, CELLS, SIDE, SIDE);
    pad_clamp_frame(&skin);
    c->s.drain.surface = &skin.surface;
    c->s.drain.tear_stress = 1e9;
    c->s.drain.thread_force = FRICTION;
    c->s.config.mode = VBSS_SCENE_MODE_OFFLINE;
    small_create(&c->s);
    c->pad = small_drain(&c->s, &c->drain);
}

/* A thread that goes straight through the middle of a triangle, in a hole. */
static void add_stitch(stitched *c)
{
    const double third = 1.0 / 3.0, weights[3] = {third, third, 1.0 - 2.0 * third};
    const uint32_t triangle = CELLS * CELLS;
    c->hole = middle_of(&skin, triangle);
    c->suture = small_thread(&c->s, vec3_add(c->hole, vec3_make(0.0, 10e-3, 0.0)),
                             vec3_sub(c->hole, vec3_make(0.0, 10e-3, 0.0)), SEGMENTS, &c->thread);
    expect_ok(vbss_scene_make_hole(c->s.scene, c->suture, 10e-3, c->pad, triangle, weights, NULL));
}

static double arc_at_hole(const stitched *c)
{
    vbss_scene_hole hole;
    expect_ok(vbss_scene_get_hole(c->s.scene, 0, &hole, sizeof hole));
    return hole.arc_length;
}

/* How far the thread slides through its hole in 50 ms when its upper end is drawn. */
static double slide_under(double force)
{
    stitched c;
    begin(&c);
    add_stitch(&c);
    small_draw(c.thread, 0, vec3_make(0.0, force, 0.0));
    small_steps(&c.s, 50, 1e-3);
    const double slid = arc_at_hole(&c) - 10e-3;
    small_end(&c.s);
    return slid;
}

static void thread_slides_through_a_pad_above_its_friction(void **state)
{
    (void)state;
    assert_true(fabs(slide_under(0.8 * FRICTION)) < 0.1e-3);
    assert_true(slide_under(1.2 * FRICTION) > 1e-3);
}

/* A stick that comes down on the pad pushes it down, is pushed back as much, and goes through nowhere. */
static void pad_bears_a_stick(void **state)
{
    (void)state;
    stitched c;
    begin(&c);
    const double radius = 2e-3, gap = radius + 0.5 * c.s.drain.thickness;
    uint32_t stick = small_stick(&c.s, VBSS_SCENE_RIGID_DRIVEN, vec3_make(0.0, gap + 0.1e-3, 0.0),
                                 vec3_make(5e-3, 0.0, 0.0), radius);
    double force = 0.0;
    for (int i = 1; i <= 300; i++) {
        double depth = 3e-3 * vbss_min(1.0, i / 200.0);
        small_move(&c.s, stick, vec3_make(0.0, gap + 0.1e-3 - depth, 0.0));
        small_steps(&c.s, 1, 1e-3);
    }
    vbss_view x, forces;
    expect_ok(vbss_drain_get_view(c.drain, VBSS_DRAIN_VIEW_POSITIONS, &x, sizeof x));
    expect_ok(vbss_drain_get_view(c.drain, VBSS_DRAIN_VIEW_ANCHOR_FORCES, &forces, sizeof forces));
    const vec3 *nodes = x.data, *anchors = forces.data;
    const uint32_t centre = CELLS / 2 * (CELLS + 1) + CELLS / 2;
    expect_near(-2.9e-3, nodes[centre].y, 0.15e-3);
    for (uint64_t i = 0; i < forces.count; i++) {
        force += anchors[i].y;
    }
    vbss_scene_rigid_state body = small_rigid(&c.s, stick);
    assert_true(force > 0.1);
    expect_near(force, body.contact_force[1], 0.02 * force);
    small_end(&c.s);
}

/* ---- its copy in a saved scene */

static vbss_scene *load(stitched *c, vbss_context *context)
{
    vbss_scene *loaded = NULL;
    const small_state saved = small_save(&c->s);
    vbss_result result = vbss_scene_load(context, saved.bytes, saved.count, &loaded);
    if (result != VBSS_OK) {
        const char *text;
        expect_ok(vbss_context_get_last_error(context, NULL, &text));
        fail_msg("%s", text);
    }
    free(saved.bytes);
    return loaded;
}

static void loaded_scene_has_the_pad(void **state)
{
    (void)state;
    stitched c;
    harness_memory memory;
    vbss_context *context = harness_context(&memory);
    begin(&c);
    add_stitch(&c);
    small_draw(c.thread, 0, vec3_make(0.0, 2.0 * FRICTION, 0.0));
    small_steps(&c.s, 20, 1e-3);
    vbss_scene *loaded = load(&c, context);
    for (int i = 0; i < 20; i++) {
        uint64_t hash = 0;
        expect_ok(vbss_scene_get_hash(loaded, &hash));
        assert_int_equal(small_hash(&c.s), hash);
        expect_ok(vbss_scene_step(loaded, 1e-3));
        small_steps(&c.s, 1, 1e-3);
    }
    expect_ok(vbss_scene_destroy(loaded));
    harness_context_end(context, &memory);
    small_end(&c.s);
}

/* Also one whose triangles have thickness and stiffness of their own, and no anchors. */
static void loaded_pad_has_its_own_stiffness(void **state)
{
    (void)state;
    stitched c;
    harness_memory memory;
    vbss_context *context = harness_context(&memory);
    small_begin(&c.s);
    pad_make(&skin, CELLS, CELLS, SIDE, SIDE);
    for (uint32_t t = 0; t < skin.surface.triangle_count; t++) {
        skin.values[t] = 0.5e-3 + 1e-6 * t;
    }
    skin.surface.thickness = skin.values;
    c.s.drain.surface = &skin.surface;
    c.s.drain.gravity[1] = -9.81;
    small_create(&c.s);
    c.pad = small_drain(&c.s, &c.drain);
    (void)small_stick(&c.s, VBSS_SCENE_RIGID_DRIVEN, vec3_make(0.0, -3e-3, 0.0),
                      vec3_make(5e-3, 0.0, 5e-3), 2e-3);
    small_steps(&c.s, 30, 1e-3);
    vbss_scene *loaded = load(&c, context);
    for (int i = 0; i < 10; i++) {
        expect_ok(vbss_scene_step(loaded, 1e-3));
        small_steps(&c.s, 1, 1e-3);
    }
    uint64_t hash = 0;
    expect_ok(vbss_scene_get_hash(loaded, &hash));
    assert_int_equal(small_hash(&c.s), hash);
    expect_ok(vbss_scene_destroy(loaded));
    harness_context_end(context, &memory);
    small_end(&c.s);
}

int test_surface_stitch(void)
{
    const struct CMUnitTest tests[] = {
        harness_test(thread_slides_through_a_pad_above_its_friction),
        harness_test(pad_bears_a_stick),
        harness_test(loaded_scene_has_the_pad),
        harness_test(loaded_pad_has_its_own_stiffness),
    };
    return cmocka_run_group_tests_name("scene.surface_stitch", tests, NULL, NULL);
}
