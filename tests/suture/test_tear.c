/* How a hole moves through a wall when it tears: straight on over the sides of triangles, up to an edge. */
#include "base/stream.h"
#include "fixture.h"
#include "fixtures/pad.h"

#define LENGTH 20e-3
#define WIDTH 10e-3
enum { COLUMNS = 8, ROWS = 4 };

static pad sheet;

typedef struct torn {
    harness_memory memory;
    vbss_context *context;
    drain_object *d;
    suture_wall wall;
    suture_hole hole;
} torn;

/* A sheet that is folded along the line x = 0 by an angle. */
static void begin_sheet(torn *t, double cosine, uint32_t anchored_columns)
{
    vbss_drain_config config;
    vbss_drain *drain;
    memset(t, 0, sizeof *t);
    t->context = harness_context(&t->memory);
    pad_make(&sheet, COLUMNS, ROWS, LENGTH, WIDTH);
    pad_clamp_columns(&sheet, anchored_columns);
    for (uint32_t i = 0; i < sheet.surface.node_count; i++) {
        double *x = sheet.positions[i];
        if (x[0] > 0.0) {
            x[1] = x[0] * sqrt(1.0 - cosine * cosine);
            x[0] *= cosine;
        }
    }
    expect_ok(vbss_drain_config_init(&config, sizeof config));
    config.surface = &sheet.surface;
    config.thickness = 0.5e-3;
    expect_ok(vbss_drain_create(t->context, &config, &drain));
    expect_ok(vbss_drain_open(drain, &t->d));
    t->wall = suture_wall_of_drain(t->d);
}

static void end_sheet(torn *t)
{
    harness_context_end(t->context, &t->memory);
}

static vec3 point_of(const torn *t)
{
    return vbss_hole_point(&t->hole, &t->wall, t->wall.now);
}

/* Where the hole is on the flat sheet from which the folded one was made. */
static vec3 flat_of(const torn *t, double cosine)
{
    vec3 x = point_of(t);
    if (x.y > 0.0) {
        x.x /= cosine;
        x.y = 0.0;
    }
    return x;
}

static void put_hole(torn *t, harness_source *source)
{
    double sum = 0.0;
    t->hole = (suture_hole){.id = 1, .thread = 1};
    t->hole.triangle = (uint32_t)harness_draw_real(source, 0.0, t->wall.triangle_count - 0.01);
    for (int k = 0; k < 3; k++) {
        t->hole.barycentric[k] = harness_draw_real(source, 0.05, 1.0);
        sum += t->hole.barycentric[k];
    }
    for (int k = 0; k < 3; k++) {
        t->hole.barycentric[k] /= sum;
    }
}

/* Distance along a direction to the border of the flat sheet. */
static double distance_to_border(vec3 from, vec3 direction)
{
    const double x = direction.x > 0.0 ? 0.5 * LENGTH - from.x : 0.5 * LENGTH + from.x;
    const double z = direction.z > 0.0 ? 0.5 * WIDTH - from.z : 0.5 * WIDTH + from.z;
    return fmin(x / fabs(direction.x), z / fabs(direction.z));
}

typedef struct walk {
    double cosine;
    int out, in;
} walk;

static void any_hole_goes_straight_on(harness_source *source, void *user)
{
    walk *w = user;
    torn t;
    begin_sheet(&t, w->cosine, 0);
    put_hole(&t, source);
    const vec3 from = flat_of(&t, w->cosine);
    const double angle = harness_draw_real(source, 0.0, 6.28);
    const vec3 flat = vec3_make(cos(angle), 0.0, sin(angle));
    vec3 direction = flat;
    if (point_of(&t).y > 0.0) {
        direction.x *= w->cosine;
        direction.y = flat.x * sqrt(1.0 - w->cosine * w->cosine);
    }
    /* A part across the triangle is left out. */
    const vec3 normal = vbss_suture_wall_normal(&t.wall, t.wall.now, t.hole.triangle);
    direction = vec3_add_scaled(direction, harness_draw_real(source, -1.0, 1.0), normal);
    const double distance = harness_draw_real(source, 0.0, 12e-3),
                 border = distance_to_border(from, flat);
    const double moved = vbss_suture_move_hole(&t.wall, &t.hole, direction, distance);
    expect_near(fmin(distance, border), moved, 1e-12);
    assert_int_equal(distance > border, t.hole.free_side != 0);
    const vec3 to = flat_of(&t, w->cosine);
    expect_near(0.0, vec3_distance(to, vec3_add_scaled(from, moved, flat)), 1e-12);
    for (int k = 0; k < 3; k++) {
        assert_true(t.hole.barycentric[k] >= 0.0);
    }
    if (t.hole.free_side != 0) {
        const vec3 normal_there = vbss_suture_wall_normal(&t.wall, t.wall.now, t.hole.triangle);
        assert_true(t.hole.barycentric[t.hole.free_side - 1] == 0.0);
        assert_true(!vbss_suture_is_outside(&t.wall, &t.hole, vec3_scale(point_of(&t), 0.9)));
        assert_true(vbss_suture_is_outside(&t.wall, &t.hole,
                                           vec3_add(vec3_scale(point_of(&t), 1.1), normal_there)));
        w->out++;
    } else {
        w->in++;
    }
    end_sheet(&t);
}

static void hole_goes_straight_on_to_the_border(void **state)
{
    (void)state;
    static const double cosines[] = {1.0, 0.6, -0.4};
    for (int i = 0; i < 3; i++) {
        walk w = {.cosine = cosines[i]};
        harness_property("walk", 200, any_hole_goes_straight_on, &w);
        assert_true(w.out > 20 && w.in > 20);
    }
}

static void hole_stops_before_anchored_triangles(void **state)
{
    (void)state;
    torn t;
    begin_sheet(&t, 1.0, 3); /* up to x = -5 mm */
    t.hole = (suture_hole){
        .id = 1, .thread = 1, .triangle = 4 * 2 * ROWS, .barycentric = {0.2, 0.5, 0.3}};
    const double x = point_of(&t).x;
    const double moved = vbss_suture_move_hole(&t.wall, &t.hole, vec3_make(-1.0, 0.0, 0.0), 20e-3);
    expect_near(x + 5e-3, moved, 1e-12);
    assert_int_equal(0, t.hole.free_side);
    end_sheet(&t);
}

static void tear_is_saved(void **state)
{
    (void)state;
    uint8_t bytes[256];
    vbss_stream stream;
    suture_hole saved = {
        .tear = SUTURE_TEARS, .free_side = 2, .torn_length = 1e-3, .tear_work = 2e-3};
    suture_hole read = {.tear = SUTURE_HOLDS};
    vbss_stream_begin_write(&stream, bytes, sizeof bytes);
    vbss_suture_serialise_tear(&stream, 1, &saved);
    const size_t count = stream.position;
    vbss_stream_begin_read(&stream, bytes, count);
    vbss_suture_serialise_tear(&stream, 1, &read);
    expect_ok(stream.result);
    assert_true(read.tear == SUTURE_TEARS && read.free_side == 2);
    assert_true(read.torn_length == 1e-3 && read.tear_work == 2e-3);
}

static void tear_that_cannot_be_is_refused(void **state)
{
    (void)state;
    const suture_hole wrong[] = {
        {.tear = (suture_tear)3}, {.free_side = 4}, {.torn_length = -1e-9}, {.tear_work = -1e-9}};
    for (int i = 0; i < 4; i++) {
        uint8_t bytes[256];
        vbss_stream stream;
        suture_hole hole = wrong[i], read = {.id = 0};
        /* As bytes: what writes refuses it, too. */
        uint32_t words[] = {(uint32_t)hole.tear, hole.free_side};
        vbss_stream_begin_write(&stream, bytes, sizeof bytes);
        vbss_stream_u32(&stream, 1, words, 2);
        vbss_stream_f64(&stream, 2, &hole.torn_length, 1);
        vbss_stream_f64(&stream, 3, &hole.tear_work, 1);
        const size_t count = stream.position;
        vbss_stream_begin_read(&stream, bytes, count);
        vbss_suture_serialise_tear(&stream, 1, &read);
        assert_int_equal(VBSS_ERROR_CORRUPT, stream.result);
    }
}

int test_tear(void)
{
    const struct CMUnitTest tests[] = {
        harness_test(hole_goes_straight_on_to_the_border),
        harness_test(hole_stops_before_anchored_triangles),
        cmocka_unit_test(tear_is_saved),
        cmocka_unit_test(tear_that_cannot_be_is_refused),
    };
    return cmocka_run_group_tests_name("suture.tear", tests, NULL, NULL);
}
