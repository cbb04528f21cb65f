#include "knot/diagram.h"

#include "base/elementary.h"

#include <stdlib.h>
#include <string.h>

static const double pi = 0x1.921fb54442d18p1;

/* ---- memory */

void diagram_begin(diagram *d, uint32_t crossings)
{
    memset(d, 0, sizeof *d);
    d->context = harness_context(&d->memory);
    d->polygon.x = d->x;
    d->polygon.capacity = DIAGRAM_VERTICES;
    d->polygon.closed = true;
    vbss_knot_projector_arrays(&d->projector, DIAGRAM_VERTICES, d->arrays);
    vbss_knot_gauss_code_arrays(&d->code, crossings, d->arrays + KNOT_PROJECTOR_ARRAYS);
    vbss_knot_gauss_code_arrays(&d->spare, crossings,
                                d->arrays + KNOT_PROJECTOR_ARRAYS + KNOT_GAUSS_CODE_ARRAYS);
    expect_ok(vbss_allocate_arrays(d->context, d->arrays, sizeof d->arrays / sizeof d->arrays[0],
                                   "diagram"));
}

void diagram_end(diagram *d)
{
    vbss_release_arrays(d->context, d->arrays, sizeof d->arrays / sizeof d->arrays[0]);
    harness_context_end(d->context, &d->memory);
}

knot_diagram_status diagram_project(diagram *d, vec3 direction)
{
    knot_ops work = 0;
    knot_diagram_status result =
        vbss_knot_project(&d->projector, &d->polygon, direction, &d->code, &work);
    assert_true(work < 0);
    assert_true(result == KNOT_DIAGRAM_REGULAR || d->code.n == 0);
    return result;
}

uint32_t diagram_project_plain(diagram *d, uint32_t k)
{
    while (diagram_project(d, vbss_knot_direction(k)) != KNOT_DIAGRAM_REGULAR) {
        assert_true(++k < 64);
    }
    return k;
}

/* ---- polygons */

void diagram_torus(diagram *d, int p, int q, uint32_t count)
{
    d->polygon.count = count;
    for (uint32_t i = 0; i < count; i++) {
        double t = 2.0 * pi * (i + 0.137) / count, r = 2.0 + vbss_cos(q * t);
        d->x[i] = vec3_make(r * vbss_cos(p * t), r * vbss_sin(p * t), -vbss_sin(q * t));
    }
}

void diagram_figure_eight(diagram *d, uint32_t count)
{
    d->polygon.count = count;
    for (uint32_t i = 0; i < count; i++) {
        double t = 2.0 * pi * (i + 0.137) / count, r = 2.0 + vbss_cos(2.0 * t);
        d->x[i] = vec3_make(r * vbss_cos(3.0 * t), r * vbss_sin(3.0 * t), vbss_sin(4.0 * t));
    }
}

void diagram_random(diagram *d, harness_source *source, uint32_t count)
{
    d->polygon.count = count;
    for (uint32_t i = 0; i < count; i++) {
        d->x[i] = harness_draw_vec3(source, -1.0, 1.0);
    }
}

void diagram_knot(diagram *d, knot_kind kind, bool mirrored, double finest, double far)
{
    static double rest_lengths[DIAGRAM_VERTICES];
    knot_shape shape;
    knot_line line;
    knot_shape_init(&shape, kind);
    shape.mirrored = mirrored;
    shape.finest = finest;
    shape.coarsest = vbss_max(finest, shape.coarsest);
    expect_ok(knot_make(&shape, DIAGRAM_VERTICES - 3, d->x + 1, rest_lengths, &line));
    uint32_t last = line.node_count;
    vec3 middle = vec3_lerp(d->x[1], d->x[last], 0.5);
    double reach = far * vec3_distance(d->x[1], d->x[last]);
    vec3 out = vec3_unit_or(vec3_sub(d->x[last], middle), vec3_make(1.0, 0.0, 0.0));
    d->x[last + 1] = vec3_add_scaled(middle, reach, out);
    d->x[last + 2] = vec3_add_scaled(middle, reach, vec3_make(0.1, 0.2, 0.97));
    d->x[0] = vec3_add_scaled(middle, -reach, out);
    d->polygon.count = last + 3;
}

void diagram_mirror(diagram *d)
{
    for (uint32_t i = 0; i < d->polygon.count; i++) {
        d->x[i].z = -d->x[i].z;
    }
}

/* ---- codes */

void diagram_set_code(knot_gauss_code *code, const char *entries, const char *signs)
{
    code->n = (uint32_t)strlen(signs);
    assert_true(code->n <= code->capacity && strlen(entries) == 2 * (size_t)code->n);
    char seen[64];
    uint32_t count = 0;
    for (uint32_t e = 0; e < 2 * code->n; e++) {
        code->over[e] = entries[e] >= 'A' && entries[e] <= 'Z';
        char letter = (char)(code->over[e] != 0 ? entries[e] - 'A' + 'a' : entries[e]);
        uint32_t c = 0;
        while (c < count && seen[c] != letter) {
            c++;
        }
        seen[c] = letter;
        count += c == count ? 1 : 0;
        code->crossing[e] = (uint16_t)c;
        code->position[e] = e + 0.5;
    }
    for (uint32_t c = 0; c < code->n; c++) {
        code->sign[c] = signs[c] == '+' ? 1 : -1;
    }
}

void diagram_expect_code(const char *entries, const char *signs, const knot_gauss_code *code)
{
    char text[64], sign_text[32];
    assert_true(code->n < sizeof sign_text);
    for (uint32_t e = 0; e < 2 * code->n; e++) {
        text[e] = (char)((code->over[e] != 0 ? 'A' : 'a') + code->crossing[e]);
    }
    for (uint32_t c = 0; c < code->n; c++) {
        sign_text[c] = code->sign[c] > 0 ? '+' : '-';
    }
    text[2 * (size_t)code->n] = sign_text[code->n] = '\0';
    assert_string_equal(entries, text);
    assert_string_equal(signs, sign_text);
}

static const uint64_t prime = 2147483647u;

static uint64_t power(uint64_t a, uint64_t n)
{
    uint64_t result = 1;
    for (; n > 0; n >>= 1) {
        result = (n & 1) != 0 ? result * a % prime : result;
        a = a * a % prime;
    }
    return result;
}

/* Of the first `size` rows and columns of a matrix with n columns. */
static uint64_t eliminate(uint64_t *a, uint32_t n, uint32_t size)
{
    uint64_t product = 1;
    for (uint32_t k = 0; k < size; k++) {
        uint32_t pivot = k;
        while (pivot < size && a[pivot * n + k] == 0) {
            pivot++;
        }
        if (pivot == size) {
            return 0;
        }
        for (uint32_t j = 0; j < size; j++) {
            uint64_t value = a[k * n + j];
            a[k * n + j] = a[pivot * n + j];
            a[pivot * n + j] = value;
        }
        uint64_t by_pivot = power(a[k * n + k], prime - 2);
        product = product * a[k * n + k] % prime;
        for (uint32_t i = k + 1; i < size; i++) {
            uint64_t factor = (prime - a[i * n + k]) % prime * by_pivot % prime;
            for (uint32_t j = k; j < size && factor != 0; j++) {
                a[i * n + j] = (a[i * n + j] + factor * a[k * n + j]) % prime;
            }
        }
    }
    return product;
}

/* A row a crossing: the arc over it twice, less both that end there. */
int64_t diagram_determinant(const knot_gauss_code *code)
{
    uint32_t n = code->n, arc = 0;
    if (n < 2) {
        return 1;
    }
    uint64_t *a = calloc((size_t)n * n, sizeof *a);
    assert_non_null(a);
    for (uint32_t e = 0; e < 2 * n; e++) {
        uint64_t *row = a + (size_t)code->crossing[e] * n;
        if (code->over[e] != 0) {
            row[arc] = (row[arc] + 2) % prime;
        } else {
            row[arc] = (row[arc] + prime - 1) % prime;
            arc = (arc + 1) % n;
            row[arc] = (row[arc] + prime - 1) % prime;
        }
    }
    uint64_t value = eliminate(a, n, n - 1);
    free(a);
    return (int64_t)(value < prime / 2 ? value : prime - value);
}

/* Polyak and Viro: pairs of crossings met under a, over b, over a, under b. */
int64_t diagram_v2(const knot_gauss_code *code)
{
    uint32_t n = code->n, *over = calloc(2 * (size_t)n + 1, sizeof *over), *under = over + n;
    assert_non_null(over);
    for (uint32_t e = 0; e < 2 * n; e++) {
        (code->over[e] != 0 ? over : under)[code->crossing[e]] = e;
    }
    int64_t sum = 0;
    for (uint32_t a = 0; a < n; a++) {
        for (uint32_t b = 0; b < n; b++) {
            if (under[a] < over[b] && over[b] < over[a] && over[a] < under[b]) {
                sum += code->sign[a] == code->sign[b] ? 1 : -1;
            }
        }
    }
    free(over);
    return sum;
}
