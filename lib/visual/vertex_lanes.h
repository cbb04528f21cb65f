/* Four vertices in SIMD lanes: unit vectors, and the conversion to the floats of a renderer. */
#ifndef VBSS_VISUAL_VERTEX_LANES_H
#define VBSS_VISUAL_VERTEX_LANES_H

#include <string.h>

#include "base/vlanes.h"
#include "visual/visual.h"

/* ---- four floats */

#if defined(__GNUC__)
typedef float lanes_floats __attribute__((vector_size(16)));
#define FLOAT_OF(v, i) ((v)[i])
#else
typedef struct lanes_floats {
    float at[LANES];
} lanes_floats;
#define FLOAT_OF(v, i) ((v).at[i])
#endif

static inline lanes_floats lanes_floats_make(float a, float b, float c, float d)
{
#if defined(__GNUC__)
    lanes_floats v = {a, b, c, d};
#else
    lanes_floats v = {{a, b, c, d}};
#endif
    return v;
}

/* visual_to_float for each lane */
static inline lanes_floats lanes_to_floats(lanes v)
{
    v = lanes_min(lanes_max(v, lanes_splat(-VISUAL_LARGEST)), lanes_splat(VISUAL_LARGEST));
#if defined(__GNUC__) && defined(__AVX__)
    return __builtin_ia32_cvtpd2ps256(v);
#elif defined(LANES_SHUFFLE) && defined(__SSE2__)
    return LANES_SHUFFLE(__builtin_ia32_cvtpd2ps(v.low), __builtin_ia32_cvtpd2ps(v.high), 0, 1, 4,
                         5);
#else
    return lanes_floats_make((float)lanes_at(v, 0), (float)lanes_at(v, 1), (float)lanes_at(v, 2),
                             (float)lanes_at(v, 3));
#endif
}

/* Transposes four rows in place. */
static inline void lanes_floats_transpose(lanes_floats r[LANES])
{
    const lanes_floats a = r[0], b = r[1], c = r[2], d = r[3];
#if defined(LANES_SHUFFLE)
    const lanes_floats ab_low = LANES_SHUFFLE(a, b, 0, 4, 1, 5);
    const lanes_floats ab_high = LANES_SHUFFLE(a, b, 2, 6, 3, 7);
    const lanes_floats cd_low = LANES_SHUFFLE(c, d, 0, 4, 1, 5);
    const lanes_floats cd_high = LANES_SHUFFLE(c, d, 2, 6, 3, 7);
    r[0] = LANES_SHUFFLE(ab_low, cd_low, 0, 1, 4, 5);
    r[1] = LANES_SHUFFLE(ab_low, cd_low, 2, 3, 6, 7);
    r[2] = LANES_SHUFFLE(ab_high, cd_high, 0, 1, 4, 5);
    r[3] = LANES_SHUFFLE(ab_high, cd_high, 2, 3, 6, 7);
#else
    for (int i = 0; i < LANES; i++) {
        r[i] = lanes_floats_make(FLOAT_OF(a, i), FLOAT_OF(b, i), FLOAT_OF(c, i), FLOAT_OF(d, i));
    }
#endif
}

/* Stores the pairs (a_i, b_i), `stride` bytes apart. */
static inline void lanes_floats_store_pairs(uint8_t *out, size_t stride, lanes_floats a,
                                            lanes_floats b)
{
#if defined(LANES_SHUFFLE)
    typedef double pair_of_pairs __attribute__((vector_size(16)));
    const pair_of_pairs low = (pair_of_pairs)LANES_SHUFFLE(a, b, 0, 4, 1, 5);
    const pair_of_pairs high = (pair_of_pairs)LANES_SHUFFLE(a, b, 2, 6, 3, 7);
    const double pairs[LANES] = {low[0], low[1], high[0], high[1]};
#else
    float pairs[LANES][2];
    for (int i = 0; i < LANES; i++) {
        pairs[i][0] = FLOAT_OF(a, i);
        pairs[i][1] = FLOAT_OF(b, i);
    }
#endif
    for (size_t i = 0; i < LANES; i++) {
        memcpy(out + i * stride, &pairs[i], sizeof pairs[i]);
    }
}

/* ---- four vertices */

/* First of the next four of `count` items, of which those before `index` are done. The last four
 * overlap those before them. */
static inline uint32_t next_four(uint32_t index, uint32_t count)
{
    return index + LANES <= count ? index : count - LANES;
}

/* Stores positions, which are relative to the origin of the vertices, and normals. The vertices are
 * `step` apart. */
static inline void visual_store_points(visual_vertex *first, uint32_t step, vlanes position,
                                       vlanes normal)
{
    uint8_t *out = (uint8_t *)first;
    const size_t stride = step * sizeof *first;
    lanes_floats rows[LANES] = {lanes_to_floats(position.x), lanes_to_floats(position.y),
                                lanes_to_floats(position.z), lanes_to_floats(normal.x)};
    lanes_floats_transpose(rows);
    for (size_t l = 0; l < LANES; l++) {
        memcpy(out + l * stride, &rows[l], sizeof rows[l]);
    }
    lanes_floats_store_pairs(out + sizeof rows[0], stride, lanes_to_floats(normal.y),
                             lanes_to_floats(normal.z));
}

static inline vlanes v_splat(vec3 a)
{
    vlanes r = {lanes_splat(a.x), lanes_splat(a.y), lanes_splat(a.z)};
    return r;
}

/* Four indices from `first` on. Those beyond `last` are replaced by it. */
static inline void clamp_indices(uint32_t first, uint32_t last, uint32_t index[LANES])
{
    for (uint32_t l = 0; l < LANES; l++) {
        index[l] = first + l < last ? first + l : last;
    }
}

/* The vectors of four indices. */
static inline vlanes v_gather(const vec3 *from, const uint32_t index[LANES])
{
    const vec3 a = from[index[0]], b = from[index[1]], c = from[index[2]], d = from[index[3]];
    const double x[LANES] = {a.x, b.x, c.x, d.x}, y[LANES] = {a.y, b.y, c.y, d.y},
                 z[LANES] = {a.z, b.z, c.z, d.z};
    vlanes r = {lanes_load(x), lanes_load(y), lanes_load(z)};
    return r;
}

/* vec3_unit_or for each lane */
static inline vlanes v_unit_or(vlanes a, vlanes fallback)
{
    const lanes n = lanes_sqrt(v_dot(a, a));
    const lanes_mask is_infinite = lanes_less(lanes_splat(DBL_MAX), n);
    const lanes_mask is_short = lanes_less(n, lanes_splat(1e-150));
    const lanes inverse = lanes_div(lanes_splat(1.0), n);
    return v_select(is_short, fallback,
                    v_scale(a, lanes_select(is_infinite, lanes_sub(n, n), inverse)));
}

/* Stores four vectors at their indices. */
static inline void v_scatter(vec3 *out, const uint32_t index[LANES], vlanes v)
{
    double x[LANES], y[LANES], z[LANES];
    lanes_store(x, v.x);
    lanes_store(y, v.y);
    lanes_store(z, v.z);
    for (int l = 0; l < LANES; l++) {
        out[index[l]] = vec3_make(x[l], y[l], z[l]);
    }
}

#endif
