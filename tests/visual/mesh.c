/* Looking at meshes, and judging them. */
#include <stdlib.h>

#include "base/elementary.h"
#include "fixture.h"

static vbss_view view_of(const fixture *f, vbss_visual_field field)
{
    vbss_view view;
    expect_ok(vbss_visual_get_view(f->visual, field, &view, sizeof view));
    return view;
}

drawn get_drawn(const fixture *f)
{
    const vbss_view v = view_of(f, VBSS_VISUAL_VIEW_VERTICES),
                    t = view_of(f, VBSS_VISUAL_VIEW_TRIANGLES),
                    p = view_of(f, VBSS_VISUAL_VIEW_PARTS), s = view_of(f, VBSS_VISUAL_VIEW_SPOTS);
    return (drawn){v.data,
                   t.data,
                   p.data,
                   s.data,
                   (uint32_t)v.count,
                   (uint32_t)t.count,
                   (uint32_t)p.count,
                   (uint32_t)s.count};
}

drawn draw(const fixture *f)
{
    expect_ok(vbss_visual_update(f->visual));
    return get_drawn(f);
}

/* ---- closed surfaces */

typedef struct location {
    float x[3];
    uint32_t vertex;
} place;

static int compare_places(const void *a, const void *b)
{
    const place *p = a, *q = b;
    for (int k = 0; k < 3; k++) {
        if (p->x[k] < q->x[k] || p->x[k] > q->x[k]) {
            return p->x[k] < q->x[k] ? -1 : 1;
        }
    }
    return p->vertex < q->vertex ? -1 : 1;
}

static bool is_same_place(const place *a, const place *b)
{
    return !(a->x[0] < b->x[0] || a->x[0] > b->x[0] || a->x[1] < b->x[1] || a->x[1] > b->x[1] ||
             a->x[2] < b->x[2] || a->x[2] > b->x[2]);
}

static int compare_sides(const void *a, const void *b)
{
    const uint64_t p = *(const uint64_t *)a, q = *(const uint64_t *)b;
    return p < q ? -1 : p > q;
}

/* The least vertex at the same place, for each vertex of a part. */
static uint32_t *weld(const drawn *d, const visual_part *part)
{
    place *places = calloc(part->vertex_count + 1, sizeof *places);
    uint32_t *same = calloc(part->vertex_count + 1, sizeof *same);
    assert_non_null(places);
    assert_non_null(same);
    for (uint32_t i = 0; i < part->vertex_count; i++) {
        memcpy(places[i].x, d->vertices[part->first_vertex + i].position, sizeof places[i].x);
        places[i].vertex = i;
    }
    qsort(places, part->vertex_count, sizeof *places, compare_places);
    for (uint32_t i = 0, first = 0; i < part->vertex_count; i++) {
        first = is_same_place(&places[i], &places[first]) ? first : i;
        same[places[i].vertex] = places[first].vertex;
    }
    free(places);
    return same;
}

/* Sides there and back, each as the vertices it runs between, in ascending order. */
static uint64_t *list_sides(const drawn *d, const visual_part *part)
{
    const size_t count = 3 * (size_t)part->triangle_count;
    uint32_t *same = weld(d, part);
    uint64_t *sides = calloc(2 * count + 1, sizeof *sides), *back = sides + count;
    assert_non_null(sides);
    for (uint32_t t = 0, n = 0; t < part->triangle_count; t++) {
        const uint32_t *corner = d->triangles[part->first_triangle + t].corner;
        for (int k = 0; k < 3; k++, n++) {
            uint64_t a = same[corner[k] - part->first_vertex];
            uint64_t b = same[corner[(k + 1) % 3] - part->first_vertex];
            sides[n] = a << 32 | b;
            back[n] = b << 32 | a;
        }
    }
    qsort(sides, count, sizeof *sides, compare_sides);
    qsort(back, count, sizeof *back, compare_sides);
    free(same);
    return sides;
}

uint32_t open_sides(const drawn *d, const visual_part *part)
{
    const size_t count = 3 * (size_t)part->triangle_count;
    /* Both jaws of a grasper may touch. */
    const bool once =
        part->kind != VBSS_VISUAL_KIND_DRIVER && part->kind != VBSS_VISUAL_KIND_SHEARS;
    uint64_t *sides = list_sides(d, part), *back = sides + count;
    uint32_t open = 0;
    for (size_t i = 0; i < count; i++) {
        open += sides[i] != back[i] || (once && i > 0 && sides[i] == sides[i - 1]);
    }
    free(sides);
    return open;
}

static vec3 face_of(const drawn *d, const uint32_t *corner)
{
    vec3 a = position_of(d, corner[0]);
    return vec3_cross(vec3_sub(position_of(d, corner[1]), a),
                      vec3_sub(position_of(d, corner[2]), a));
}

uint32_t inverted_triangles(const drawn *d, const visual_part *part)
{
    uint32_t inverted = 0;
    for (uint32_t t = 0; t < part->triangle_count; t++) {
        const uint32_t *corner = d->triangles[part->first_triangle + t].corner;
        vec3 face = face_of(d, corner);
        bool wrong = false;
        for (int k = 0; k < 3; k++) {
            wrong |= !(vec3_dot(face, normal_of(d, corner[k])) > 0.0);
        }
        inverted += wrong;
    }
    return inverted;
}

double normal_error(const drawn *d, const visual_part *part)
{
    double error = 0.0;
    for (uint32_t i = 0; i < part->vertex_count; i++) {
        error = vbss_max_or_nan(error, fabs(vec3_norm(normal_of(d, part->first_vertex + i)) - 1.0));
    }
    return error;
}

double volume_of(const drawn *d, const visual_part *part)
{
    double volume = 0.0;
    for (uint32_t t = 0; t < part->triangle_count; t++) {
        const uint32_t *corner = d->triangles[part->first_triangle + t].corner;
        volume += vec3_dot(position_of(d, corner[0]), face_of(d, corner)) / 6.0;
    }
    return volume;
}

void expect_sound(const drawn *d, const visual_part *part)
{
    assert_true(part->triangle_count > 0);
    for (uint32_t t = 0; t < part->triangle_count; t++) {
        for (int k = 0; k < 3; k++) {
            uint32_t corner = d->triangles[part->first_triangle + t].corner[k];
            assert_in_range(corner, part->first_vertex,
                            part->first_vertex + part->vertex_count - 1);
        }
    }
    assert_int_equal(open_sides(d, part), 0);
    assert_int_equal(inverted_triangles(d, part), 0);
    assert_true(normal_error(d, part) < 2e-7);
    assert_true(volume_of(d, part) > 0.0);
}

/* ---- bodies */

vbss_thread *helix(const fixture *f, uint32_t nodes, double radius, double rise,
                   double thread_radius)
{
    vbss_thread_config c;
    vbss_thread *thread;
    double x[3 * 512], rest[512];
    assert_in_range(nodes, 2, 512);
    for (uint32_t i = 0; i < nodes; i++) {
        double angle = (double)i * VBSS_PI / 6.0;
        vec3_store(x + 3 * (size_t)i, vec3_make(radius * vbss_cos(angle), rise * (double)i / 12.0,
                                                radius * vbss_sin(angle)));
    }
    for (uint32_t i = 0; i + 1 < nodes; i++) { /* the length of the arc */
        double turn = radius * VBSS_PI / 6.0, up = rise / 12.0;
        rest[i] = sqrt(turn * turn + up * up);
    }
    expect_ok(vbss_thread_config_init(&c, sizeof c));
    c.segment_count = nodes - 1;
    c.radius = thread_radius;
    c.positions = x;
    c.rest_lengths = rest;
    expect_ok(vbss_thread_create(f->context, &c, &thread));
    return thread;
}
