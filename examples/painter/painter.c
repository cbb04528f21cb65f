/* A painter's life, its complaints, and how it looks at what it is given. */
#include "picture.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* ---- what went wrong */

const char *painter_result_string(painter_result result)
{
    switch (result) {
    case PAINTER_OK:
        return "ok";
    case PAINTER_ERROR_NULL:
        return "an argument is NULL";
    case PAINTER_ERROR_NUMBER:
        return "a number is not finite or out of range";
    case PAINTER_ERROR_MEMORY:
        return "no memory";
    case PAINTER_ERROR_FILE:
        return "the file cannot be written";
    }
    return "not a result of the painter";
}

const char *painter_error(const painter *p)
{
    return p == NULL ? "the painter is NULL" : p->error;
}

painter_result picture_fail(painter *p, painter_result result, const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(p->error, sizeof p->error, format, arguments);
    va_end(arguments);
    return result;
}

painter_result picture_need(painter *p, const void *pointer, const char *name)
{
    return pointer != NULL ? PAINTER_OK : picture_fail(p, PAINTER_ERROR_NULL, "%s is NULL", name);
}

/* ---- a painter's life */

painter_result painter_create(int width, int height, painter **out)
{
    if (out == NULL) {
        return PAINTER_ERROR_NULL;
    }
    *out = NULL;
    if (width < 1 || width > PAINTER_MAX_SIZE || height < 1 || height > PAINTER_MAX_SIZE) {
        return PAINTER_ERROR_NUMBER;
    }
    painter *p = calloc(1, sizeof *p);
    if (p == NULL) {
        return PAINTER_ERROR_MEMORY;
    }
    p->width = width;
    p->height = height;
    *out = p;
    return PAINTER_OK;
}

void painter_clear(painter *p)
{
    if (p != NULL) {
        p->shape_count = p->dot_count = p->caption_count = p->strands = 0;
        p->bar_length = 0.0;
        p->has_ramp = false;
        p->error[0] = '\0';
    }
}

void painter_destroy(painter *p)
{
    if (p != NULL) {
        free(p->shapes);
        free(p->dots);
        free(p->captions);
        free(p);
    }
}

/* ---- input is looked at before anything changes */

painter_result picture_check_point(painter *p, const double v[3], const char *name)
{
    if (v == NULL) {
        return picture_need(p, v, name);
    }
    for (int i = 0; i < 3; i++) {
        if (!(fabs(v[i]) <= PICTURE_LARGEST)) { /* a NaN is not either */
            return picture_fail(p, PAINTER_ERROR_NUMBER, "%s[%d] is not a number up to 1e6", name,
                                i);
        }
    }
    return PAINTER_OK;
}

painter_result picture_check_colour(painter *p, painter_colour colour)
{
    return colour <= 0xffffffu
               ? PAINTER_OK
               : picture_fail(p, PAINTER_ERROR_NUMBER, "the colour is above 0xffffff");
}

painter_result picture_check_range(painter *p, double value, double low, double high,
                                   const char *name)
{
    return value >= low && value <= high
               ? PAINTER_OK
               : picture_fail(p, PAINTER_ERROR_NUMBER, "%s is not in %g ... %g", name, low, high);
}

/* Points `stride` bytes apart, which need not be aligned. */
vec picture_point(const double *points, size_t stride, size_t i)
{
    double v[3];
    memcpy(v, (const char *)(const void *)points + i * stride, sizeof v);
    return vec_of(v);
}

painter_result picture_check_points(painter *p, const double *points, size_t count, size_t *stride)
{
    const size_t packed = 3 * sizeof(double);
    painter_result result = picture_need(p, points, "the array of points");
    if (result != PAINTER_OK) {
        return result;
    }
    *stride = *stride == 0 ? packed : *stride;
    if (*stride < packed || *stride > (1u << 20) || count > (1u << 26)) {
        return picture_fail(p, PAINTER_ERROR_NUMBER, "the count or stride is out of range");
    }
    for (size_t i = 0; i < count; i++) {
        vec v = picture_point(points, *stride, i);
        if (!(fabs(v.x) <= PICTURE_LARGEST && fabs(v.y) <= PICTURE_LARGEST &&
              fabs(v.z) <= PICTURE_LARGEST)) {
            return picture_fail(p, PAINTER_ERROR_NUMBER, "point %zu is not of numbers up to 1e6",
                                i);
        }
    }
    return PAINTER_OK;
}

painter_result picture_make_room(painter *p, void **array, size_t *room, size_t used, size_t more,
                                 size_t size)
{
    if (more <= *room - used) {
        return PAINTER_OK;
    }
    size_t wanted = used + more;
    wanted += wanted / 2 + 16;
    void *grown = wanted < SIZE_MAX / size ? realloc(*array, wanted * size) : NULL;
    if (grown == NULL) {
        return picture_fail(p, PAINTER_ERROR_MEMORY, "no memory for %zu items", wanted);
    }
    *array = grown;
    *room = wanted;
    return PAINTER_OK;
}
