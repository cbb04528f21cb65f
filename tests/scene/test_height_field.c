/* Height fields: the bits of a static mesh with the same triangles, place and orientation, sides, refused input. */
#include "scene/small.h"

enum { COLUMNS = 14, ROWS = 11, HEIGHTS = COLUMNS * ROWS };

static double heights[HEIGHTS];

/* Hills of 2 mm, about the origin. */
static vbss_scene_height_field_config hills(void)
{
    vbss_scene_height_field_config c = vbss_scene_height_field_config_default();
    for (uint32_t i = 0; i < HEIGHTS; i++) {
        const uint32_t row = i / COLUMNS, column = i % COLUMNS;
        heights[i] = 1e-3 * sin(0.9 * column) * cos(1.1 * row);
    }
    c.column_count = COLUMNS;
    c.row_count = ROWS;
    c.height_count = HEIGHTS;
    c.heights = heights;
    c.spacing[0] = 3e-3;
    c.spacing[1] = 4e-3;
    vec3_store(c.position, vec3_make(-19e-3, 0.0, -20e-3));
    c.friction = 0.2;
    return c;
}

static void begin(small *s)
{
    small_begin(s);
    s->config.floor = 0;
    s->config.contact_capacity = 4096;
    s->thread.gravity[1] = -9.81;
    small_create(s);
}

static void add_field(small *s, const vbss_scene_height_field_config *c)
{
    uint32_t body;
    expect_ok(vbss_scene_add_height_field(s->scene, c, &body));
}

static void add_triangles(small *s, const vbss_scene_height_field_config *c)
{
    double vertices[HEIGHTS][3];
    uint32_t triangles[2 * (COLUMNS - 1) * (ROWS - 1)][3], count = 0, body;
    for (uint32_t i = 0; i < HEIGHTS; i++) {
        const uint32_t row = i / COLUMNS, column = i % COLUMNS;
        const vec3 local = vec3_make(column * c->spacing[0], heights[i], row * c->spacing[1]);
        vec3_store(vertices[i], vec3_add(vec3_load(c->position), local));
    }
    for (uint32_t i = 0; i < HEIGHTS - COLUMNS; i++) {
        if (i % COLUMNS + 1 < COLUMNS) {
            const uint32_t cell[2][3] = {{i, i + COLUMNS, i + COLUMNS + 1},
                                         {i, i + COLUMNS + 1, i + 1}};
            memcpy(triangles[count], cell, sizeof cell);
            count += 2;
        }
    }
    vbss_scene_static_mesh_config mesh = vbss_scene_static_mesh_config_default();
    mesh.vertex_count = HEIGHTS;
    mesh.triangle_count = count;
    mesh.vertices = vertices[0];
    mesh.triangles = triangles[0];
    mesh.friction = c->friction;
    mesh.one_sided = c->one_sided;
    expect_ok(vbss_scene_add_static_mesh(s->scene, &mesh, &body));
}

static uint64_t hash_of_fall(void (*add)(small *s, const vbss_scene_height_field_config *c),
                             uint32_t one_sided)
{
    small s;
    vbss_scene_height_field_config c = hills();
    c.one_sided = one_sided;
    begin(&s);
    add(&s, &c);
    small_thread(&s, vec3_make(-5e-3, 5e-3, -10e-3), vec3_make(3e-3, 4e-3, 10e-3), 20, NULL);
    small_steps(&s, 80, 1e-3);
    assert_true(small_statistics(&s).contacts > 0);
    const uint64_t hash = small_hash(&s);
    small_end(&s);
    return hash;
}

static void height_field_gives_the_bits_of_its_triangles(void **state)
{
    (void)state;
    for (uint32_t one_sided = 0; one_sided < 2; one_sided++) {
        assert_true(hash_of_fall(add_field, one_sided) == hash_of_fall(add_triangles, one_sided));
    }
}

/* ---- place and sides */

/* The heights point along -x: a turn by a quarter about z. */
static void height_field_is_where_its_frame_says(void **state)
{
    (void)state;
    small s;
    vbss_scene_nearest found;
    vbss_scene_height_field_config c = hills();
    for (uint32_t i = 0; i < HEIGHTS; i++) {
        heights[i] = 2e-3;
    }
    const double turn[4] = {1.0, 0.0, 0.0, 1.0}, near[3] = {-10e-3, 1e-3, 0.0};
    memcpy(c.orientation, turn, sizeof turn);
    vec3_store(c.position, vec3_make(-4e-3, -19e-3, -20e-3));
    begin(&s);
    add_field(&s, &c);
    expect_ok(vbss_scene_find_nearest(s.scene, near, 1.0, UINT32_MAX, &found, sizeof found));
    expect_near(10e-3 - 6e-3 - 0.5 * c.thickness, found.distance, 1e-15);
    expect_near(-1.0, found.normal[0], 1e-12);
    small_end(&s);
}

/* Height of the middle of a thread 20 ms after it flew at 2 m/s across a level field that has one side. */
static double height_after_flight(double y, double speed)
{
    small s;
    vbss_thread *thread;
    vbss_scene_height_field_config c = hills();
    memset(heights, 0, sizeof heights);
    c.one_sided = 1;
    begin(&s);
    add_field(&s, &c);
    small_thread(&s, vec3_make(-8e-3, y, 1e-3), vec3_make(9e-3, y, -2e-3), 20, &thread);
    double velocities[21][3];
    for (int i = 0; i < 21; i++) {
        vec3_store(velocities[i], vec3_make(0.0, speed, 0.0));
    }
    expect_ok(vbss_thread_set_state(thread, NULL, velocities[0], 21));
    small_steps(&s, 20, 1e-3);
    const double end = small_node(thread, 10).y;
    small_end(&s);
    return end;
}

static void one_sided_field_stops_only_what_comes_from_above(void **state)
{
    (void)state;
    assert_true(height_after_flight(11e-3, -2.0) > 0.0);
    assert_true(height_after_flight(-11e-3, 2.0) > 20e-3);
}

/* ---- refused input */

static void expect_refusal(small *s, vbss_result expected, const vbss_scene_height_field_config *c)
{
    uint32_t body = 77;
    assert_int_equal(vbss_scene_add_height_field(s->scene, c, &body), expected);
    assert_int_equal(body, 77);
}

static void refused_height_fields_change_nothing(void **state)
{
    (void)state;
    small s;
    begin(&s);
    const uint64_t hash = small_hash(&s);
    const vbss_scene_height_field_config good = hills();
    vbss_scene_height_field_config bad = good;
    bad.height_count = HEIGHTS - 1;
    expect_refusal(&s, VBSS_ERROR_OUT_OF_RANGE, &bad);
    bad = good;
    bad.row_count = 1;
    bad.height_count = COLUMNS;
    expect_refusal(&s, VBSS_ERROR_OUT_OF_RANGE, &bad);
    bad = good;
    bad.column_count = 1;
    bad.height_count = ROWS;
    expect_refusal(&s, VBSS_ERROR_OUT_OF_RANGE, &bad);
    bad = good;
    bad.heights = NULL;
    expect_refusal(&s, VBSS_ERROR_NULL_ARGUMENT, &bad);
    for (int k = 0; k < 2; k++) {
        bad = good;
        bad.spacing[k] = 0.0;
        expect_refusal(&s, VBSS_ERROR_OUT_OF_RANGE, &bad);
    }
    bad = good;
    bad.reserved = 1;
    expect_refusal(&s, VBSS_ERROR_OUT_OF_RANGE, &bad);
    bad = good;
    bad.position[2] = (double)NAN;
    expect_refusal(&s, VBSS_ERROR_NOT_FINITE, &bad);
    bad = good;
    memset(bad.orientation, 0, sizeof bad.orientation);
    expect_refusal(&s, VBSS_ERROR_OUT_OF_RANGE, &bad);
    bad = good;
    bad.thickness = 0.0;
    expect_refusal(&s, VBSS_ERROR_OUT_OF_RANGE, &bad);
    heights[7] = (double)INFINITY;
    expect_refusal(&s, VBSS_ERROR_NOT_FINITE, &good);
    assert_true(small_hash(&s) == hash);
    small_end(&s);
}

int test_height_field(void)
{
    const struct CMUnitTest tests[] = {
        harness_test(height_field_gives_the_bits_of_its_triangles),
        harness_test(height_field_is_where_its_frame_says),
        harness_test(one_sided_field_stops_only_what_comes_from_above),
        harness_test(refused_height_fields_change_nothing),
    };
    return cmocka_run_group_tests_name("scene.height_field", tests, NULL, NULL);
}
