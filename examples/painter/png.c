/* Pictures as PNG files, and the calls that paint pixels. */
#include "picture.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* ---- the encoder */

static uint32_t crc32(const uint8_t *data, size_t count)
{
    uint32_t crc = 0xffffffffu;
    for (size_t i = 0; i < count; i++) {
        crc ^= data[i];
        for (int bit = 0; bit < 8; bit++) {
            crc = crc >> 1 ^ ((crc & 1) != 0 ? 0xedb88320u : 0);
        }
    }
    return ~crc;
}

static void add_number(bytes *to, uint32_t n)
{
    const uint8_t high_first[4] = {(uint8_t)(n >> 24), (uint8_t)(n >> 16 & 255),
                                   (uint8_t)(n >> 8 & 255), (uint8_t)(n & 255)};
    bytes_add(to, high_first, sizeof high_first);
}

/* The length in front is known only once the data stands there. */
static size_t begin_chunk(bytes *to, const char *type)
{
    add_number(to, 0);
    bytes_add(to, type, 4);
    return to->count;
}

static void end_chunk(bytes *to, size_t data)
{
    if (!to->failed) {
        size_t length = to->count - data;
        for (int i = 0; i < 4; i++) {
            to->data[data - 8 + (size_t)i] = (uint8_t)(length >> (24 - 8 * i) & 255);
        }
        add_number(to, crc32(to->data + data - 4, length + 4));
    }
}

static uint8_t paeth(int left, int up, int corner)
{
    int guess = left + up - corner;
    int to_left = abs(guess - left), to_up = abs(guess - up), to_corner = abs(guess - corner);
    return (uint8_t)(to_left <= to_up && to_left <= to_corner ? left
                     : to_up <= to_corner                     ? up
                                                              : corner);
}

/* Row `filter` of the five filters; returns how rough the filtered row is. */
static uint64_t filter_row(int filter, const uint8_t *row, const uint8_t *above, size_t count,
                           uint8_t *out)
{
    uint64_t rough = 0;
    for (size_t i = 0; i < count; i++) {
        int left = i >= 3 ? row[i - 3] : 0, up = above != NULL ? above[i] : 0;
        int corner = i >= 3 && above != NULL ? above[i - 3] : 0;
        const int guesses[5] = {0, left, up, (left + up) / 2, 0};
        int guess = filter == 4 ? paeth(left, up, corner) : guesses[filter];
        out[i] = (uint8_t)((row[i] - guess) & 255);
        rough += out[i] < 128 ? out[i] : 256u - out[i];
    }
    return rough;
}

/* Each row by the filter that leaves the least. */
static void filter_rows(const uint8_t *pixels, size_t row_size, int height, uint8_t *trial,
                        uint8_t *out)
{
    for (int y = 0; y < height; y++) {
        const uint8_t *row = pixels + (size_t)y * row_size;
        const uint8_t *above = y > 0 ? row - row_size : NULL;
        uint8_t *best = out + (size_t)y * (row_size + 1);
        uint64_t smallest = UINT64_MAX;
        for (int filter = 0; filter < 5; filter++) {
            uint64_t rough = filter_row(filter, row, above, row_size, trial);
            if (rough < smallest) {
                smallest = rough;
                best[0] = (uint8_t)filter;
                memcpy(best + 1, trial, row_size);
            }
        }
    }
}

void png_encode(bytes *to, const uint8_t *pixels, int width, int height)
{
    size_t row_size = 3 * (size_t)width, size = (row_size + 1) * (size_t)height;
    uint8_t *filtered = malloc(size), *trial = malloc(row_size);
    if (filtered == NULL || trial == NULL) {
        to->failed = true;
    } else {
        filter_rows(pixels, row_size, height, trial, filtered);
        bytes_add(to, "\x89PNG\r\n\x1a\n", 8);
        size_t chunk = begin_chunk(to, "IHDR");
        add_number(to, (uint32_t)width);
        add_number(to, (uint32_t)height);
        bytes_add(to, (const uint8_t[5]){8, 2, 0, 0, 0}, 5); /* bits; red, green and blue */
        end_chunk(to, chunk);
        chunk = begin_chunk(to, "IDAT");
        bytes_add_zlib(to, filtered, size);
        end_chunk(to, chunk);
        end_chunk(to, begin_chunk(to, "IEND"));
    }
    free(trial);
    free(filtered);
}

/* ---- files */

int bytes_write(const bytes *b, const char *path)
{
    errno = 0;
    FILE *file = fopen(path, "wb");
    if (file == NULL) {
        return errno != 0 ? errno : EIO;
    }
    size_t written = fwrite(b->data, 1, b->count, file);
    int reason = written == b->count ? 0 : errno != 0 ? errno : EIO;
    if (fclose(file) != 0 && reason == 0) {
        reason = errno != 0 ? errno : EIO;
    }
    return reason;
}

painter_result picture_save(painter *p, const bytes *file, const char *path)
{
    if (file->failed) {
        return picture_fail(p, PAINTER_ERROR_MEMORY, "no memory for the file");
    }
    int reason = bytes_write(file, path);
    return reason == 0 ? PAINTER_OK
                       : picture_fail(p, PAINTER_ERROR_FILE, "%.200s: %s", path, strerror(reason));
}

painter_result painter_save_png(const char *path, const uint8_t *pixels, int width, int height)
{
    if (path == NULL || pixels == NULL) {
        return PAINTER_ERROR_NULL;
    }
    if (width < 1 || width > 2 * PAINTER_MAX_SIZE || height < 1 || height > PAINTER_MAX_SIZE) {
        return PAINTER_ERROR_NUMBER;
    }
    bytes file = {.data = NULL};
    png_encode(&file, pixels, width, height);
    painter_result result = file.failed                     ? PAINTER_ERROR_MEMORY
                            : bytes_write(&file, path) == 0 ? PAINTER_OK
                                                            : PAINTER_ERROR_FILE;
    bytes_free(&file);
    return result;
}

/* ---- pictures */

static painter_result paint_view(painter *p, const painter_camera *camera, uint8_t *first,
                                 size_t stride)
{
    pixel_area area = {first, stride, p->width, p->height};
    sheet front = sheet_on_pixels(&area);
    if (!picture_render(p, camera, first, stride)) {
        return picture_fail(p, PAINTER_ERROR_MEMORY, "no memory to paint the picture");
    }
    picture_overlay(p, camera, &front);
    return PAINTER_OK;
}

painter_result painter_paint(painter *p, uint8_t *pixels, size_t size)
{
    if (p == NULL) {
        return PAINTER_ERROR_NULL;
    }
    if (pixels == NULL) {
        return picture_need(p, pixels, "the array of pixels");
    }
    size_t stride = 3 * (size_t)p->width;
    if (size < stride * (size_t)p->height) {
        return picture_fail(p, PAINTER_ERROR_NUMBER, "the array of pixels is too small");
    }
    painter_camera camera = camera_in_use(p);
    return paint_view(p, &camera, pixels, stride);
}

static painter_result write_views(painter *p, const char *path, int views)
{
    if (p == NULL) {
        return PAINTER_ERROR_NULL;
    }
    if (path == NULL) {
        return picture_need(p, path, "the path");
    }
    size_t stride = 3 * (size_t)p->width * (size_t)views;
    uint8_t *pixels = malloc(stride * (size_t)p->height);
    if (pixels == NULL) {
        return picture_fail(p, PAINTER_ERROR_MEMORY, "no memory for the pixels");
    }
    painter_camera camera = camera_in_use(p);
    painter_result result = paint_view(p, &camera, pixels, stride);
    if (views == 2 && result == PAINTER_OK) {
        painter_camera above = camera_from_above(&camera);
        result = paint_view(p, &above, pixels + 3 * (size_t)p->width, stride);
        pixel_area both = {pixels, stride, 2 * p->width, p->height};
        sheet front = sheet_on_pixels(&both);
        front.line(front.user, p->width, 0.0, p->width, p->height, 1.0, 0xc4c8ccu);
        front.text(front.user, 2.0 * p->width - 16.0, 26.0, 1.0, "from above", PICTURE_INK);
    }
    bytes file = {.data = NULL};
    if (result == PAINTER_OK) {
        png_encode(&file, pixels, views * p->width, p->height);
        result = picture_save(p, &file, path);
    }
    bytes_free(&file);
    free(pixels);
    return result;
}

painter_result painter_write_png(painter *p, const char *path)
{
    return write_views(p, path, 1);
}

painter_result painter_write_two_views(painter *p, const char *path)
{
    return write_views(p, path, 2);
}
