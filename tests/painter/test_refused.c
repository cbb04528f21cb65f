/* Bad input is told and changes nothing; no memory and no file are told too. */
#include "harness/harness.h"

#include <stdlib.h>
#include <string.h>

#include "canvas.h"

#define refused(p, wanted, call)                                  \
    do {                                                          \
        assert_int_equal((call), (wanted));                       \
        assert_true((p) == NULL || strlen(painter_error(p)) > 5); \
    } while (0)

static const double a[3] = {0.0, 0.0, 0.0}, b[3] = {1e-3, 0.0, 0.0}, c[3] = {0.0, 1e-3, 0.0};
static const uint32_t indices[3] = {0, 1, 2};
static const double points[9] = {0.0, 0.0, 0.0, 1e-3, 0.0, 0.0, 0.0, 1e-3, 0.0};

/* ---- memory that fails when told to: the linker sends the painter's calls here */

void *__real_malloc(size_t size);
void *__real_calloc(size_t count, size_t size);
void *__real_realloc(void *block, size_t size);
void *__wrap_malloc(size_t size);
void *__wrap_calloc(size_t count, size_t size);
void *__wrap_realloc(void *block, size_t size);

static long calls_left = -1; /* until one fails; below 0: none does */

static bool fails_now(void)
{
    return calls_left >= 0 && calls_left-- == 0;
}

void *__wrap_malloc(size_t size)
{
    return fails_now() ? NULL : __real_malloc(size);
}

void *__wrap_calloc(size_t count, size_t size)
{
    return fails_now() ? NULL : __real_calloc(count, size);
}

void *__wrap_realloc(void *block, size_t size)
{
    return fails_now() ? NULL : __real_realloc(block, size);
}

static painter_result paint_everything(painter **p, const char *path)
{
    painter_result result = painter_create(CANVAS, CANVAS, p);
    const painter_result results[] = {
        result != PAINTER_OK ? result : painter_add_chain(*p, points, 3, 0, 1e-4, 0, NULL),
        result != PAINTER_OK ? result : painter_add_dots(*p, a, 1, 0, 2.0, 0),
        result != PAINTER_OK ? result : painter_add_label(*p, a, "a", 0),
        result != PAINTER_OK ? result : painter_write_png(*p, path),
        result != PAINTER_OK ? result : painter_write_svg(*p, path),
        result != PAINTER_OK ? result : painter_write_two_views(*p, path)};
    for (size_t i = 0; result == PAINTER_OK && i < sizeof results / sizeof results[0]; i++) {
        result = results[i];
    }
    return result;
}

static void each_failed_allocation_is_reported(void **state)
{
    (void)state;
    long count = 0;
    painter_result result = PAINTER_ERROR_MEMORY;
    while (result != PAINTER_OK) {
        painter *p = NULL;
        calls_left = count++;
        result = paint_everything(&p, "refused.out");
        bool failed = calls_left < 0;
        calls_left = -1;
        assert_int_equal(result, failed ? PAINTER_ERROR_MEMORY : PAINTER_OK);
        assert_true(p == NULL || !failed || strstr(painter_error(p), "memory") != NULL);
        painter_destroy(p);
    }
    assert_true(count > 20);
    remove("refused.out");
}

/* ---- arguments */

static void painter_needs_a_size(void **state)
{
    (void)state;
    painter *p;
    const int sizes[6][2] = {{0, 10}, {10, 0}, {-1, 10}, {8193, 10}, {10, 8193}, {10, -2147483647}};
    assert_int_equal(painter_create(10, 10, NULL), PAINTER_ERROR_NULL);
    for (int i = 0; i < 6; i++) {
        p = (painter *)(void *)&p;
        assert_int_equal(painter_create(sizes[i][0], sizes[i][1], &p), PAINTER_ERROR_NUMBER);
        assert_null(p);
    }
    painter_destroy(NULL);
    painter_clear(NULL);
    assert_true(strlen(painter_error(NULL)) > 5);
    for (int result = 1; result >= -5; result--) {
        assert_true(strlen(painter_result_string((painter_result)result)) > 1);
    }
}

static void calls_without_painter(void)
{
    const painter_camera camera = {{0.0, 0.0, 1.0}, {0.0}, {0.0, 1.0, 0.0}, 1.0, 0.0};
    painter_camera got;
    uint8_t pixel[3];
    painter *p = NULL;
    const painter_result wanted = PAINTER_ERROR_NULL;
    refused(p, wanted, painter_set_camera(p, &camera));
    refused(p, wanted, painter_get_camera(p, &got));
    refused(p, wanted, painter_fit_camera(p, b, c));
    refused(p, wanted, painter_add_capsule(p, a, b, 1e-3, 0));
    refused(p, wanted, painter_add_chain(p, points, 3, 0, 1e-3, 0, NULL));
    refused(p, wanted, painter_add_lines(p, points, 3, 0, 0));
    refused(p, wanted, painter_add_triangles(p, points, 3, 0, indices, 1, 0));
    refused(p, wanted, painter_add_floor(p, a, b, c, 1, 0));
    refused(p, wanted, painter_add_dots(p, points, 3, 0, 1.0, 0));
    refused(p, wanted, painter_add_text(p, 0.0, 0.0, "", 0));
    refused(p, wanted, painter_add_label(p, a, "", 0));
    refused(p, wanted, painter_add_scale_bar(p, 1.0, ""));
    refused(p, wanted, painter_add_ramp(p, "", ""));
    refused(p, wanted, painter_paint(p, pixel, 3));
    refused(p, wanted, painter_write_png(p, "x"));
    refused(p, wanted, painter_write_svg(p, "x"));
    refused(p, wanted, painter_write_two_views(p, "x"));
    refused(p, wanted, painter_save_png(NULL, pixel, 1, 1));
    refused(p, wanted, painter_save_png("x", NULL, 1, 1));
}

static void null_is_rejected(void **state)
{
    (void)state;
    painter *p = canvas_painter();
    const painter_result wanted = PAINTER_ERROR_NULL;
    calls_without_painter();
    assert_string_equal(painter_error(p), "");
    refused(p, wanted, painter_set_camera(p, NULL));
    refused(p, wanted, painter_get_camera(p, NULL));
    refused(p, wanted, painter_fit_camera(p, NULL, c));
    refused(p, wanted, painter_fit_camera(p, b, NULL));
    refused(p, wanted, painter_add_capsule(p, NULL, b, 1e-3, 0));
    refused(p, wanted, painter_add_capsule(p, a, NULL, 1e-3, 0));
    refused(p, wanted, painter_add_chain(p, NULL, 3, 0, 1e-3, 0, NULL));
    refused(p, wanted, painter_add_lines(p, NULL, 3, 0, 0));
    refused(p, wanted, painter_add_triangles(p, NULL, 3, 0, indices, 1, 0));
    refused(p, wanted, painter_add_triangles(p, points, 3, 0, NULL, 1, 0));
    refused(p, wanted, painter_add_floor(p, NULL, b, c, 1, 0));
    refused(p, wanted, painter_add_floor(p, a, NULL, c, 1, 0));
    refused(p, wanted, painter_add_floor(p, a, b, NULL, 1, 0));
    refused(p, wanted, painter_add_dots(p, NULL, 3, 0, 1.0, 0));
    refused(p, wanted, painter_add_text(p, 0.0, 0.0, NULL, 0));
    refused(p, wanted, painter_add_label(p, NULL, "", 0));
    refused(p, wanted, painter_add_label(p, a, NULL, 0));
    refused(p, wanted, painter_add_scale_bar(p, 1.0, NULL));
    refused(p, wanted, painter_add_ramp(p, NULL, ""));
    refused(p, wanted, painter_add_ramp(p, "", NULL));
    refused(p, wanted, painter_paint(p, NULL, 3));
    refused(p, wanted, painter_write_png(p, NULL));
    refused(p, wanted, painter_write_svg(p, NULL));
    refused(p, wanted, painter_write_two_views(p, NULL));
    painter_clear(p);
    assert_string_equal(painter_error(p), "");
    painter_destroy(p);
}

/* Calls with one number, the others good. */
static painter_result call_with(painter *p, int which, double number)
{
    const double bad[3] = {0.0, number, 0.0};
    const double row[9] = {0.0, 0.0, 0.0, 1e-3, 0.0, 0.0, 0.0, 1e-3, number};
    painter_camera camera = {{0.0, 0.0, 1.0}, {0.0}, {0.0, 1.0, 0.0}, 1.0, 0.5};
    switch (which) {
    case 0:
        return painter_add_capsule(p, bad, b, 1e-3, 0);
    case 1:
        return painter_add_capsule(p, a, bad, 1e-3, 0);
    case 2:
        return painter_add_capsule(p, a, b, number, 0);
    case 3:
        return painter_add_chain(p, row, 3, 0, 1e-3, 0, NULL);
    case 4:
        return painter_add_chain(p, points, 3, 0, number, 0, NULL);
    case 5:
        return painter_add_lines(p, row, 3, 0, 0);
    case 6:
        return painter_add_triangles(p, row, 3, 0, indices, 1, 0);
    case 7:
        return painter_add_floor(p, bad, b, c, 1, 0);
    case 8:
        return painter_add_dots(p, row, 3, 0, 1.0, 0);
    case 9:
        return painter_add_dots(p, points, 3, 0, number, 0);
    case 10:
        return painter_add_text(p, number, 0.0, "", 0);
    case 11:
        return painter_add_label(p, bad, "", 0);
    case 12:
        return painter_add_scale_bar(p, number, "");
    case 13:
        camera.width = number;
        return painter_set_camera(p, &camera);
    case 14:
        camera.up[0] = number;
        return painter_set_camera(p, &camera);
    case 15:
        camera.width = 0.0;
        camera.angle = number;
        return painter_set_camera(p, &camera);
    case 16:
        return painter_fit_camera(p, bad, b);
    case 17:
        return painter_add_floor(p, a, bad, b, 1, 0);
    default:
        return PAINTER_OK;
    }
}

static void bad_numbers_are_rejected_and_change_nothing(void **state)
{
    (void)state;
    static canvas before, after;
    const double bad[6] = {
        harness_bad_numbers[0], harness_bad_numbers[1], harness_bad_numbers[2], 1e7, -1e7, 1e300};
    const painter_colour colours[2] = {0, 0x1000000u};
    for (int round = 0; round < 2; round++) {
        painter *p = canvas_painter();
        assert_int_equal(painter_add_capsule(p, a, b, 2e-3, PAINTER_GREEN), PAINTER_OK);
        for (int i = 0; round == 1 && i < 18 * 6; i++) {
            refused(p, PAINTER_ERROR_NUMBER, call_with(p, i / 6, bad[i % 6]));
        }
        if (round == 1) {
            const painter_result wanted = PAINTER_ERROR_NUMBER;
            const painter_camera at_target = {{0.0}, {0.0}, {0.0, 1.0, 0.0}, 1.0, 0.0};
            const painter_camera along_up = {{0.0, 1.0, 0.0}, {0.0}, {0.0, 1.0, 0.0}, 1.0, 0.0};
            const uint32_t beyond[3] = {0, 1, 3};
            uint8_t pixel[3];
            refused(p, wanted, painter_set_camera(p, &at_target));
            refused(p, wanted, painter_set_camera(p, &along_up));
            refused(p, wanted, painter_fit_camera(p, b, b));
            refused(p, wanted, painter_add_capsule(p, a, b, 0.0, 0));
            refused(p, wanted, painter_add_capsule(p, a, b, -1e-3, 0));
            refused(p, wanted, painter_add_capsule(p, a, b, 1e-3, 0x1000000u));
            refused(p, wanted, painter_add_chain(p, points, 3, 0, 1e-3, 0, colours));
            refused(p, wanted, painter_add_chain(p, points, 3, 23, 1e-3, 0, NULL));
            refused(p, wanted, painter_add_chain(p, points, SIZE_MAX, 0, 1e-3, 0, NULL));
            refused(p, wanted, painter_add_triangles(p, points, 3, 0, beyond, 1, 0));
            refused(p, wanted, painter_add_triangles(p, points, 3, 0, indices, SIZE_MAX / 2, 0));
            refused(p, wanted, painter_add_floor(p, a, b, b, 1, 0));
            refused(p, wanted, painter_add_floor(p, a, b, c, 0, 0));
            refused(p, wanted, painter_add_floor(p, a, b, c, 1001, 0));
            refused(p, wanted, painter_paint(p, pixel, sizeof pixel));
            refused(NULL, wanted, painter_save_png("refused.out", pixel, 0, 1));
            refused(NULL, wanted, painter_save_png("refused.out", pixel, 1, -1));
        }
        canvas_paint(p, round == 0 ? &before : &after);
    }
    assert_memory_equal(before.pixels, after.pixels, sizeof before.pixels);
}

static void unwritable_file_is_reported(void **state)
{
    (void)state;
    /* A folder that is not there, a folder, and on some machines a disk that is full. */
    const char *paths[4] = {"no-such-folder/refused.out", ".", "", "/dev/full"};
    FILE *full = fopen(paths[3], "r");
    int count = full != NULL ? 4 : 3;
    if (full != NULL) {
        fclose(full);
    }
    painter *p = canvas_painter();
    for (int i = 0; i < count; i++) {
        refused(p, PAINTER_ERROR_FILE, painter_write_png(p, paths[i]));
        refused(p, PAINTER_ERROR_FILE, painter_write_svg(p, paths[i]));
        refused(p, PAINTER_ERROR_FILE, painter_write_two_views(p, paths[i]));
        refused(NULL, PAINTER_ERROR_FILE, painter_save_png(paths[i], (const uint8_t[3]){0}, 1, 1));
    }
    assert_non_null(strstr(painter_error(p), paths[count - 1]));
    painter_destroy(p);
}

static void odd_valid_input_is_painted(void **state)
{
    (void)state;
    static canvas picture;
    painter *p = canvas_painter();
    char long_text[2000];
    memset(long_text, '\xc3', sizeof long_text);
    long_text[sizeof long_text - 1] = '\0';
    const double far_away[3] = {1e6, -1e6, 1e6}, back[3] = {-1e6, 1e6, -1e6};
    assert_int_equal(painter_add_capsule(p, far_away, back, 1e6, 0), PAINTER_OK);
    assert_int_equal(painter_add_capsule(p, far_away, back, 1e-9, 0), PAINTER_OK);
    assert_int_equal(painter_add_chain(p, points, 0, 0, 1e-3, 0, NULL), PAINTER_OK);
    assert_int_equal(painter_add_chain(p, points, 1, 0, 1e-3, 0, NULL), PAINTER_OK);
    assert_int_equal(painter_add_floor(p, far_away, back, c, 1000, 0), PAINTER_OK);
    const uint32_t flat[3] = {1, 1, 1};
    assert_int_equal(painter_add_triangles(p, points, 3, 0, flat, 1, 0), PAINTER_OK);
    assert_int_equal(painter_add_label(p, far_away, long_text, 0), PAINTER_OK);
    assert_int_equal(painter_add_text(p, -1e5, 1e5, "\x01\x7f\xff", 0), PAINTER_OK);
    assert_int_equal(painter_add_scale_bar(p, 1e6, ""), PAINTER_OK);
    assert_int_equal(painter_write_svg(p, "refused.out"), PAINTER_OK);
    const double down[3] = {1e-5, -1.0, 1e-6};
    assert_int_equal(painter_fit_camera(p, down, b), PAINTER_OK);
    assert_int_equal(painter_write_svg(p, "refused.out"), PAINTER_OK);
    canvas_paint(p, &picture);
    assert_int_equal(painter_create(1, 1, &p), PAINTER_OK); /* nothing at all, on a pixel */
    assert_int_equal(painter_write_two_views(p, "refused.out"), PAINTER_OK);
    assert_int_equal(painter_write_svg(p, "refused.out"), PAINTER_OK);
    painter_destroy(p);
    remove("refused.out");
}

int test_refused(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(each_failed_allocation_is_reported),
        cmocka_unit_test(painter_needs_a_size),
        cmocka_unit_test(null_is_rejected),
        cmocka_unit_test(bad_numbers_are_rejected_and_change_nothing),
        cmocka_unit_test(unwritable_file_is_reported),
        cmocka_unit_test(odd_valid_input_is_painted),
    };
    return cmocka_run_group_tests_name("painter.refused", tests, NULL, NULL);
}
