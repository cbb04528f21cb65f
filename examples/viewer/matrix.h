/* Vectors and 4 x 4 matrices as OpenGL wants them: floats, column by column. */
#ifndef VBSS_EXAMPLES_VIEWER_MATRIX_H
#define VBSS_EXAMPLES_VIEWER_MATRIX_H

#include <math.h>

typedef struct point3 {
    float x, y, z;
} point3;

typedef struct matrix4 {
    float m[16];
} matrix4;

static inline point3 point3_add(point3 a, float s, point3 b)
{
    return (point3){a.x + s * b.x, a.y + s * b.y, a.z + s * b.z};
}

static inline float point3_dot(point3 a, point3 b)
{
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

static inline point3 point3_cross(point3 a, point3 b)
{
    return (point3){a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

static inline point3 point3_unit(point3 a)
{
    float n = sqrtf(point3_dot(a, a));
    return (point3){a.x / n, a.y / n, a.z / n};
}

/* First b, then a. */
static inline matrix4 matrix4_after(const matrix4 *a, const matrix4 *b)
{
    matrix4 r;
    for (int column = 0; column < 4; column++) {
        for (int row = 0; row < 4; row++) {
            float sum = 0.0F;
            for (int k = 0; k < 4; k++) {
                sum += a->m[4 * k + row] * b->m[4 * column + k];
            }
            r.m[4 * column + row] = sum;
        }
    }
    return r;
}

/* To the frame of an eye that looks forward; the three are unit and across each other. */
static inline matrix4 matrix4_view(point3 eye, point3 right, point3 up, point3 forward)
{
    matrix4 r = {{right.x, up.x, -forward.x, 0.0F, right.y, up.y, -forward.y, 0.0F, right.z, up.z,
                  -forward.z, 0.0F, -point3_dot(right, eye), -point3_dot(up, eye),
                  point3_dot(forward, eye), 1.0F}};
    return r;
}

/* `slope`: of half the height of the picture. */
static inline matrix4 matrix4_perspective(float slope, float aspect, float near, float far)
{
    matrix4 r = {{1.0F / (slope * aspect), 0.0F, 0.0F, 0.0F, 0.0F, 1.0F / slope, 0.0F, 0.0F, 0.0F,
                  0.0F, -(far + near) / (far - near), -1.0F, 0.0F, 0.0F,
                  -2.0F * far * near / (far - near), 0.0F}};
    return r;
}

#endif
