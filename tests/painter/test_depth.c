/* What is nearer hides what is farther, at the place and in the size that it has. */
#include "harness/harness.h"

#include <string.h>

#include "canvas.h"

static const double near_z = 4e-3;

#define ok(call) assert_int_equal((call), PAINTER_OK)

static void add_bar_along_x(painter *p, double z, painter_colour colour)
{
    ok(painter_add_capsule(p, (double[3]){-8e-3, 0.0, z}, (double[3]){8e-3, 0.0, z}, 1e-3, colour));
}

static void add_bar_along_y(painter *p, double z, painter_colour colour)
{
    ok(painter_add_capsule(p, (double[3]){0.0, -8e-3, z}, (double[3]){0.0, 8e-3, z}, 1e-3, colour));
}

static void add_ball(painter *p, double x, double y, double z, double radius, painter_colour colour)
{
    const double centre[3] = {x, y, z};
    ok(painter_add_capsule(p, centre, centre, radius, colour));
}

/* ---- */

static void nearer_capsule_occludes(void **state)
{
    (void)state;
    for (int upright_in_front = 0; upright_in_front < 2; upright_in_front++) {
        for (int upright_first = 0; upright_first < 2; upright_first++) {
            static canvas c;
            painter *p = canvas_painter();
            double z = upright_in_front == 1 ? near_z : -near_z;
            if (upright_first == 1) {
                add_bar_along_y(p, z, PAINTER_VERMILION);
            }
            add_bar_along_x(p, 0.0, PAINTER_BLUE);
            if (upright_first == 0) {
                add_bar_along_y(p, z, PAINTER_VERMILION);
            }
            canvas_paint(p, &c);
            uint32_t crossing = canvas_pixel(&c, canvas_column(0.0), canvas_row(0.0));
            painter_colour front = upright_in_front == 1 ? PAINTER_VERMILION : PAINTER_BLUE;
            assert_true(canvas_matches(crossing, front));
            uint32_t left = canvas_pixel(&c, canvas_column(-5e-3), canvas_row(0.0));
            assert_true(canvas_matches(left, PAINTER_BLUE));
            uint32_t above = canvas_pixel(&c, canvas_column(0.0), canvas_row(5e-3));
            assert_true(canvas_matches(above, PAINTER_VERMILION));
            assert_true(canvas_is_background(&c, canvas_column(5e-3), canvas_row(5e-3)));
        }
    }
}

static void depth_is_of_surface(void **state)
{
    (void)state;
    static canvas c;
    painter *p = canvas_painter();
    /* Equal balls side by side cut each other in the plane between them. */
    add_ball(p, -2e-3, 0.0, 0.0, 4e-3, PAINTER_BLUE);
    add_ball(p, 2e-3, 0.0, 0.0, 4e-3, PAINTER_VERMILION);
    canvas_paint(p, &c);
    for (int row = canvas_row(2.5e-3); row <= canvas_row(-2.5e-3); row++) {
        assert_true(canvas_matches(canvas_pixel(&c, canvas_column(-0.5e-3), row), PAINTER_BLUE));
        assert_true(
            canvas_matches(canvas_pixel(&c, canvas_column(0.5e-3), row), PAINTER_VERMILION));
    }
}

static void intersecting_balls_show_nearer_surface(void **state)
{
    (void)state;
    static canvas c;
    painter *p = canvas_painter();
    add_ball(p, 0.0, 0.0, 0.0, 6e-3, PAINTER_BLUE);
    add_ball(p, 0.0, 0.0, 5.5e-3, 1e-3, PAINTER_VERMILION);    /* 0.5 mm stick out */
    add_ball(p, 3e-3, 3e-3, 0.0, 1e-3, PAINTER_VERMILION);     /* inside */
    add_ball(p, -3e-3, -3e-3, -9e-3, 1e-3, PAINTER_VERMILION); /* behind */
    canvas_paint(p, &c);
    assert_true(
        canvas_matches(canvas_pixel(&c, canvas_column(0.0), canvas_row(0.0)), PAINTER_VERMILION));
    assert_true(
        canvas_matches(canvas_pixel(&c, canvas_column(3e-3), canvas_row(3e-3)), PAINTER_BLUE));
    assert_true(
        canvas_matches(canvas_pixel(&c, canvas_column(-3e-3), canvas_row(-3e-3)), PAINTER_BLUE));
}

static void sizes_and_positions_are_to_scale(void **state)
{
    (void)state;
    static canvas c;
    painter *p = canvas_painter();
    add_ball(p, 3e-3, -2e-3, 0.0, 5e-3, PAINTER_GREEN);
    canvas_paint(p, &c);
    int row = canvas_row(-2e-3), first = 0, last = CANVAS - 1;
    while (canvas_is_background(&c, first, row)) {
        first++;
    }
    while (canvas_is_background(&c, last, row)) {
        last--;
    }
    /* An outline of at most 2 pixels lies round it. */
    assert_in_range(first, canvas_column(-2e-3) - 2, canvas_column(-2e-3));
    assert_in_range(last, canvas_column(8e-3) - 1, canvas_column(8e-3) + 2);
    assert_int_equal(canvas_covered(&c, canvas_row(3.5e-3)), 0);
    assert_int_equal(canvas_covered(&c, canvas_row(-7.5e-3)), 0);
    assert_true(canvas_covered(&c, canvas_row(2.8e-3)) > 0);
    assert_true(canvas_covered(&c, canvas_row(-6.8e-3)) > 0);
}

static void perspective_shrinks_with_distance(void **state)
{
    (void)state;
    static canvas at_one, at_two;
    canvas *pictures[2] = {&at_one, &at_two};
    const painter_camera camera = {{0.0, 0.0, 0.1}, {0.0}, {0.0, 1.0, 0.0}, 0.0, 0.4};
    for (int i = 0; i < 2; i++) {
        painter *p = canvas_painter();
        ok(painter_set_camera(p, &camera));
        add_ball(p, 0.0, 0.0, 0.1 - 0.06 * (i + 1), 4e-3, PAINTER_GREEN);
        add_ball(p, 0.0, 0.0, 0.12, 4e-3, PAINTER_BLUE); /* behind the eye */
        canvas_paint(p, pictures[i]);
    }
    int wide = canvas_covered(&at_one, CANVAS / 2), narrow = canvas_covered(&at_two, CANVAS / 2);
    /* 2 * 100 / tan(0.2) * 4 / 60 pixels, and the outlines */
    assert_in_range(wide, 66, 72);
    assert_in_range(narrow, 33, 38);
    assert_true(canvas_matches(canvas_pixel(&at_one, CANVAS / 2, CANVAS / 2), PAINTER_GREEN));
}

static void capsule_behind_eye_is_clipped(void **state)
{
    (void)state;
    static canvas c;
    painter *p = canvas_painter();
    const painter_camera camera = {{0.0, 0.0, 0.1}, {0.0}, {0.0, 1.0, 0.0}, 0.0, 0.8};
    ok(painter_set_camera(p, &camera));
    ok(painter_add_capsule(p, (double[3]){0.0, -4e-3, -0.5}, (double[3]){0.0, -4e-3, 0.5}, 1e-3,
                           PAINTER_STEEL));
    canvas_paint(p, &c);
    assert_false(canvas_is_background(&c, CANVAS / 2, CANVAS - 1));
    assert_true(canvas_is_background(&c, CANVAS / 2, CANVAS / 4));
}

static void view_along_capsule_axis(void **state)
{
    (void)state;
    static canvas c;
    for (int away = 0; away < 2; away++) {
        painter *p = canvas_painter();
        double begin = away == 1 ? 5e-3 : -5e-3;
        ok(painter_add_capsule(p, (double[3]){0.0, 0.0, begin}, (double[3]){0.0, 0.0, -begin}, 2e-3,
                               PAINTER_GREEN));
        add_ball(p, 0.0, 0.0, 0.0, 3e-3, PAINTER_BLUE); /* round its middle */
        canvas_paint(p, &c);
        for (int dx = -25; dx <= 25; dx++) {
            uint32_t pixel = canvas_pixel(&c, canvas_column(0.0) + dx, CANVAS / 2);
            assert_true(canvas_matches(pixel, dx < -17 || dx > 17 ? PAINTER_BLUE : PAINTER_GREEN) ||
                        (dx * dx > 17 * 17 && dx * dx < 25 * 25)); /* near the edge: either */
        }
    }
}

static void triangles_and_floor_are_depth_tested(void **state)
{
    (void)state;
    static canvas c;
    painter *p = canvas_painter();
    const double corners[4][3] = {
        {-9e-3, -9e-3, 0.0}, {0.0, -9e-3, 0.0}, {0.0, 9e-3, 0.0}, {-9e-3, 9e-3, 0.0}};
    const uint32_t indices[6] = {0, 1, 2, 0, 2, 3};
    ok(painter_add_triangles(p, &corners[0][0], 4, 0, indices, 2, PAINTER_TISSUE));
    ok(painter_add_floor(p, (double[3]){5e-3, 0.0, 0.0}, (double[3]){4e-3, 0.0, 0.0},
                         (double[3]){0.0, 9e-3, 0.0}, 4, 0x80c080u));
    add_bar_along_x(p, near_z, PAINTER_BLUE);
    ok(painter_add_capsule(p, (double[3]){-8e-3, 5e-3, -near_z}, (double[3]){8e-3, 5e-3, -near_z},
                           1e-3, PAINTER_VERMILION));
    canvas_paint(p, &c);
    const double xs[2] = {-5.5e-3, 5.5e-3};
    const painter_colour grounds[2] = {PAINTER_TISSUE, 0x80c080u};
    for (int i = 0; i < 2; i++) {
        int column = canvas_column(xs[i]);
        assert_true(canvas_matches(canvas_pixel(&c, column, canvas_row(0.0)), PAINTER_BLUE));
        assert_true(canvas_matches(canvas_pixel(&c, column, canvas_row(5e-3)), grounds[i]));
        assert_true(canvas_matches(canvas_pixel(&c, column, canvas_row(-7e-3)), grounds[i]));
    }
    assert_true(canvas_is_background(&c, canvas_column(9.6e-3), canvas_row(-8e-3)));
}

int test_depth(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(nearer_capsule_occludes),
        cmocka_unit_test(depth_is_of_surface),
        cmocka_unit_test(intersecting_balls_show_nearer_surface),
        cmocka_unit_test(sizes_and_positions_are_to_scale),
        cmocka_unit_test(perspective_shrinks_with_distance),
        cmocka_unit_test(capsule_behind_eye_is_clipped),
        cmocka_unit_test(view_along_capsule_axis),
        cmocka_unit_test(triangles_and_floor_are_depth_tested),
    };
    return cmocka_run_group_tests_name("painter.depth", tests, NULL, NULL);
}
