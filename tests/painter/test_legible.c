/* Crossings, thin threads, colours and captions can be told from a picture. */
#include "harness/harness.h"

#include <math.h>
#include <string.h>

#include "canvas.h"

#define ok(call) assert_int_equal((call), PAINTER_OK)

static const double thread_radius = 0.125e-3;

/* ---- crossings */

static void strand_below_crossing_is_darkened(void **state)
{
    (void)state;
    static canvas c;
    painter *p = canvas_painter();
    const double d = 6e-3, r = 0.8e-3;
    ok(painter_add_capsule(p, (double[3]){-d, 0.0, 0.0}, (double[3]){d, 0.0, 0.0}, r,
                           PAINTER_ORANGE));
    ok(painter_add_capsule(p, (double[3]){0.0, -d, 2 * r}, (double[3]){0.0, d, 2 * r}, r,
                           PAINTER_ORANGE));
    canvas_paint(p, &c);
    int middle = CANVAS / 2, edge = canvas_column(-r);
    int far_left = canvas_brightness(&c, canvas_column(-4e-3), middle);
    int beside = canvas_brightness(&c, edge - 1, middle),
        on_top = canvas_brightness(&c, middle, middle);
    assert_true(3 * beside < 2 * far_left);
    assert_true(on_top > far_left - 60);
    /* No such line at that place of the strand on top. */
    assert_true(canvas_brightness(&c, middle, canvas_row(r) - 1) > far_left - 60);
}

static void chain_joints_are_invisible(void **state)
{
    (void)state;
    enum { COUNT = 41 };
    static canvas c;
    const double half_lengths[2] = {8e-3, 1.5e-3}, slopes[2] = {0.0, 12.0};
    const double ends[2] = {7e-3, 0.3e-3}; /* where the round end does not begin */
    for (int k = 0; k < 2; k++) {
        double points[COUNT][3];
        for (int i = 0; i < COUNT; i++) {
            points[i][0] = half_lengths[k] * (0.05 * i - 1.0);
            points[i][1] = i % 2 == 0 ? 1e-6 : -1e-6; /* nearly straight */
            points[i][2] = slopes[k] * points[i][0];
        }
        painter *p = canvas_painter();
        ok(painter_add_chain(p, &points[0][0], COUNT, 0, 1e-3, PAINTER_SKY, NULL));
        canvas_paint(p, &c);
        int first = canvas_column(-0.8 * half_lengths[k]), last = canvas_column(ends[k]);
        int wanted = canvas_brightness(&c, first, CANVAS / 2);
        assert_true(wanted > 300); /* nor is all of it an outline */
        for (int column = first; column <= last; column++) {
            assert_in_range(canvas_brightness(&c, column, CANVAS / 2), wanted - 12, wanted + 12);
        }
    }
}

static void self_crossing_is_visible(void **state)
{
    (void)state;
    enum { COUNT = 201 };
    static canvas c;
    double points[COUNT][3]; /* a figure of eight; its two parts are 1 mm apart in depth */
    for (int i = 0; i < COUNT; i++) {
        double t = 6.283185307179586 * i / (COUNT - 1) + 0.7853981633974483;
        points[i][0] = 8e-3 * cos(t);
        points[i][1] = 4e-3 * sin(2.0 * t);
        points[i][2] = 0.5e-3 * sin(t);
    }
    painter *p = canvas_painter();
    ok(painter_add_chain(p, &points[0][0], COUNT, 0, 0.4e-3, PAINTER_ORANGE, NULL));
    canvas_paint(p, &c);
    /* Along the lower strand, over the crossing in the middle: bright, dark, bright, dark, bright. */
    int changes = 0, was_dark = 0;
    for (int i = -24; i <= 24; i++) {
        int dark = canvas_brightness(&c, CANVAS / 2 + i, CANVAS / 2 + i) < 300 ? 1 : 0;
        changes += dark != was_dark ? 1 : 0;
        was_dark = dark;
    }
    int other = 0;
    was_dark = 0;
    for (int i = -24; i <= 24; i++) {
        int dark = canvas_brightness(&c, CANVAS / 2 + i, CANVAS / 2 - i) < 300 ? 1 : 0;
        other += dark != was_dark ? 1 : 0;
        was_dark = dark;
    }
    assert_true((changes == 4 && other == 0) || (changes == 0 && other == 4));
}

static void shadows_point_away_from_light(void **state)
{
    (void)state;
    static canvas c;
    const double ball[3] = {0.0, 0.0, 6e-3}, lower_right = 3.3e-3, upper_left = -3.3e-3;
    painter *p = canvas_painter();
    ok(painter_add_floor(p, (double[3]){0.0}, (double[3]){9e-3, 0.0, 0.0},
                         (double[3]){0.0, 9e-3, 0.0}, 1, PAINTER_FLOOR));
    ok(painter_add_capsule(p, ball, ball, 2e-3, PAINTER_GREEN));
    canvas_paint(p, &c);
    int shadow = canvas_brightness(&c, canvas_column(lower_right), canvas_row(-lower_right));
    int lit = canvas_brightness(&c, canvas_column(upper_left), canvas_row(-upper_left));
    assert_true(shadow < lit - 60);
    assert_true(lit > 600);
    /* A ball's own light side too. */
    assert_true(canvas_brightness(&c, canvas_column(-1e-3), canvas_row(1e-3)) >
                canvas_brightness(&c, canvas_column(1e-3), canvas_row(-1e-3)) + 30);
}

/* ---- thin threads */

static int widest_column_run(const canvas *c, int column)
{
    int run = 0;
    for (int row = 0; row < CANVAS; row++) {
        run += canvas_is_background(c, column, row) ? 0 : 1;
    }
    return run;
}

static void thin_thread_is_visible(void **state)
{
    (void)state;
    static canvas c;
    const double widths[3] = {5e-3, 20e-3, 1.0};
    const int smallest[3] = {10, 2, 2}, largest[3] = {14, 5, 4};
    for (int i = 0; i < 3; i++) {
        painter *p = canvas_painter();
        const painter_camera camera = {{0.0, 0.0, 1.0}, {0.0}, {0.0, 1.0, 0.0}, widths[i], 0.0};
        ok(painter_set_camera(p, &camera));
        double d = 0.3 * widths[i];
        ok(painter_add_capsule(p, (double[3]){-d, 0.0, 0.0}, (double[3]){d, 0.0, 0.0},
                               thread_radius, PAINTER_VIOLET));
        canvas_paint(p, &c);
        int run = widest_column_run(&c, CANVAS / 2);
        assert_in_range(run, smallest[i], largest[i]);
        assert_true(canvas_brightness(&c, CANVAS / 2, CANVAS / 2) < 550);
    }
}

/* ---- colours */

static void segment_colours_and_stride(void **state)
{
    (void)state;
    static canvas packed, apart;
    const double points[3][3] = {{-8e-3, 0.0, 0.0}, {0.0, 0.0, 0.0}, {8e-3, 0.0, 0.0}};
    double spread[3][5] = {{0.0}};
    const painter_colour colours[2] = {PAINTER_BLUE, PAINTER_VERMILION};
    for (int i = 0; i < 3; i++) {
        memcpy(spread[i], points[i], sizeof points[i]);
        spread[i][3] = harness_bad_numbers[0]; /* must not be looked at */
    }
    painter *p = canvas_painter();
    ok(painter_add_chain(p, &points[0][0], 3, 0, 1e-3, PAINTER_GREEN, colours));
    canvas_paint(p, &packed);
    p = canvas_painter();
    ok(painter_add_chain(p, &spread[0][0], 3, sizeof spread[0], 1e-3, PAINTER_GREEN, colours));
    canvas_paint(p, &apart);
    assert_memory_equal(packed.pixels, apart.pixels, sizeof packed.pixels);
    assert_true(canvas_matches(canvas_pixel(&packed, canvas_column(-4e-3), 100), PAINTER_BLUE));
    assert_true(canvas_matches(canvas_pixel(&packed, canvas_column(4e-3), 100), PAINTER_VERMILION));
}

static int luma(painter_colour colour)
{
    return (int)(3 * (colour >> 16) + 6 * (colour >> 8 & 255) + (colour & 255));
}

static void colour_ramp_is_monotonic(void **state)
{
    (void)state;
    int last = luma(painter_ramp(-1.0, 0.0, 2.0));
    assert_int_equal(last, luma(painter_ramp(0.0, 0.0, 2.0)));
    for (int i = 1; i <= 50; i++) {
        int next = luma(painter_ramp(0.04 * i, 0.0, 2.0));
        assert_true(next > last && next - last < 90);
        last = next;
    }
    assert_int_equal(last, luma(painter_ramp(3.0, 0.0, 2.0)));
    assert_int_equal(painter_ramp(0.5, 2.0, 0.0), painter_ramp(1.5, 0.0, 2.0)); /* reversed */
    for (int i = 0; i < 3; i++) {
        double bad = harness_bad_numbers[i];
        assert_int_equal(painter_ramp(bad, 0.0, 1.0), painter_ramp(0.0, 1.0, 1.0));
        assert_int_equal(painter_ramp(0.0, bad, 1.0), painter_ramp(0.0, 1.0, 1.0));
    }
}

/* ---- what lies in front */

static int changed_pixels(const canvas *a, const canvas *b, int left, int right, int top,
                          int bottom)
{
    int count = 0;
    for (int row = top; row < bottom; row++) {
        for (int column = left; column < right; column++) {
            count += canvas_pixel(a, column, row) != canvas_pixel(b, column, row) ? 1 : 0;
        }
    }
    return count;
}

static void captions_bars_and_dots_are_placed(void **state)
{
    (void)state;
    static canvas plain, text, label, bar, ramp, dots;
    canvas *pictures[6] = {&plain, &text, &label, &bar, &ramp, &dots};
    const int regions[6][4] = {{0, 0, 0, 0},       {8, 70, 10, 40},     {150, 200, 30, 55},
                               {10, 80, 160, 195}, {50, 190, 150, 190}, {94, 106, 94, 106}};
    const double place[3] = {5e-3, 5e-3, 0.0}, origin[3] = {0.0};
    for (int i = 0; i < 6; i++) {
        painter *p = canvas_painter();
        ok(painter_add_capsule(p, origin, origin, 4e-3, PAINTER_SKY));
        ok(i == 1 ? painter_add_text(p, 10.0, 30.0, "Knot 1", PAINTER_BLACK) : PAINTER_OK);
        ok(i == 2 ? painter_add_label(p, place, "tip", PAINTER_BLACK) : PAINTER_OK);
        ok(i == 3 ? painter_add_scale_bar(p, 5e-3, "5 mm") : PAINTER_OK);
        ok(i == 4 ? painter_add_ramp(p, "0 N", "2 N") : PAINTER_OK);
        /* Inside of the ball, and seen. */
        ok(i == 5 ? painter_add_dots(p, origin, 1, 0, 3.0, PAINTER_VERMILION) : PAINTER_OK);
        canvas_paint(p, pictures[i]);
        const int *r = regions[i];
        int all = changed_pixels(&plain, pictures[i], 0, CANVAS, 0, CANVAS);
        assert_int_equal(changed_pixels(&plain, pictures[i], r[0], r[1], r[2], r[3]), all);
        assert_true(i == 0 || all > 20);
    }
    assert_int_equal(canvas_pixel(&dots, 100, 100), PAINTER_VERMILION);
    assert_int_equal(canvas_pixel(&bar, 16 + 25, 184), 0x1c2127u);
    assert_true(canvas_is_background(&bar, 16 + 55, 184)); /* 50 pixels long */
}

/* ---- cameras that find the scene, and pictures that repeat */

static void default_camera_frames_all(void **state)
{
    (void)state;
    static canvas c;
    const double directions[3][3] = {{0.0, 0.0, -1.0}, {-1.0, -2.0, -3.0}, {0.0, 5.0, 1.0}};
    for (int i = 0; i < 4; i++) {
        painter *p;
        ok(painter_create(CANVAS, CANVAS, &p));
        ok(painter_add_capsule(p, (double[3]){0.3, 0.1, 0.0}, (double[3]){0.5, 0.2, 0.1}, 0.02,
                               PAINTER_BLUE));
        ok(painter_add_capsule(p, (double[3]){0.45, 0.1, 0.3}, (double[3]){0.4, 0.2, 0.1}, 0.01,
                               PAINTER_GREEN));
        ok(i < 3 ? painter_fit_camera(p, directions[i], (double[3]){0.0, 2.0, 0.0}) : PAINTER_OK);
        canvas_paint(p, &c);
        int covered = 0;
        for (int k = 0; k < CANVAS; k++) {
            covered += canvas_covered(&c, k);
            assert_true(canvas_is_background(&c, k, 0) && canvas_is_background(&c, 0, k));
            assert_true(canvas_is_background(&c, k, CANVAS - 1) &&
                        canvas_is_background(&c, CANVAS - 1, k));
        }
        assert_true(covered > CANVAS * CANVAS / 50);
    }
}

static void pixels_are_deterministic(void **state)
{
    (void)state;
    static canvas pictures[2];
    for (int i = 0; i < 2; i++) {
        painter *p = canvas_painter();
        for (int k = 0; k < 20 * (2 - i); k++) { /* the first one had another scene before */
            painter_clear(k == 20 ? p : NULL);
            double a = 0.4e-3 * (k % 20);
            ok(painter_add_capsule(p, (double[3]){a - 5e-3, -5e-3, a}, (double[3]){5e-3, a, -a},
                                   0.5e-3, painter_ramp(a, 0.0, 8e-3)));
        }
        ok(painter_add_scale_bar(p, 1e-3, "1 mm"));
        canvas_paint(p, &pictures[i]);
    }
    assert_memory_equal(&pictures[0], &pictures[1], sizeof pictures[0]);
}

int test_legible(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(strand_below_crossing_is_darkened),
        cmocka_unit_test(chain_joints_are_invisible),
        cmocka_unit_test(self_crossing_is_visible),
        cmocka_unit_test(shadows_point_away_from_light),
        cmocka_unit_test(thin_thread_is_visible),
        cmocka_unit_test(segment_colours_and_stride),
        cmocka_unit_test(colour_ramp_is_monotonic),
        cmocka_unit_test(captions_bars_and_dots_are_placed),
        cmocka_unit_test(default_camera_frames_all),
        cmocka_unit_test(pixels_are_deterministic),
    };
    return cmocka_run_group_tests_name("painter.legible", tests, NULL, NULL);
}
