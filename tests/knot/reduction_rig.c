#include "knot/reduction_rig.h"

#include <string.h>

reduction_rig reduction_r;

int reduction_make_rig(void **state)
{
    (void)state;
    reduction_r = (reduction_rig){.polygon = {.x = reduction_r.x,
                                              .place = reduction_r.place,
                                              .is_fixed = reduction_r.stays,
                                              .capacity = REDUCTION_MAX}};
    expect_ok(vbss_context_create(NULL, &reduction_r.context));
    vbss_knot_reduction_arrays(&reduction_r.reduction, REDUCTION_MAX, reduction_r.arrays);
    expect_ok(vbss_allocate_arrays(reduction_r.context, reduction_r.arrays, KNOT_REDUCTION_ARRAYS,
                                   "a reduction"));
    return 0;
}

int reduction_end_rig(void **state)
{
    (void)state;
    vbss_release_arrays(reduction_r.context, reduction_r.arrays, KNOT_REDUCTION_ARRAYS);
    expect_ok(vbss_context_destroy(reduction_r.context));
    return 0;
}

void reduction_start(bool closed)
{
    reduction_r.polygon.count = 0;
    reduction_r.polygon.closed = closed;
    reduction_r.obstacle_count = 0;
}

void reduction_add(vec3 x, bool stays)
{
    uint32_t i = reduction_r.polygon.count++;
    reduction_r.x[i] = x;
    reduction_r.place[i] = i;
    reduction_r.stays[i] = stays;
}

void reduction_add_obstacle(vec3 begin, vec3 end)
{
    reduction_r.obstacles[reduction_r.obstacle_count++] = (knot_edge){begin, end};
}

/* Every slice does something. */
void reduction_reduce_in_slices(knot_ops slice)
{
    uint32_t before = reduction_r.polygon.count;
    vbss_knot_reduction_begin(&reduction_r.reduction, &reduction_r.polygon, reduction_r.obstacles,
                              reduction_r.obstacle_count);
    bool done = false;
    for (uint32_t i = 0; i < 1000000 && !done; i++) {
        knot_ops work = slice;
        done = vbss_knot_reduction_resume(&reduction_r.reduction, &work);
        assert_true(work < slice);
    }
    assert_true(done);
    assert_int_equal(before - reduction_r.polygon.count, reduction_r.reduction.removed);
}

void reduction_reduce(void)
{
    reduction_reduce_in_slices(INT64_C(1) << 40);
}

/* ---- the same without any cleverness */

static bool same(vec3 p, vec3 q)
{
    return p.x == q.x && p.y == q.y && p.z == q.z;
}

bool reduction_is_free(const reduction_plain *p, uint32_t i)
{
    uint32_t n = p->count, before = (i + n - 1) % n;
    vec3 a = p->x[before], b = p->x[i], c = p->x[(i + 1) % n];
    if (same(a, b) || same(b, c)) {
        return true;
    }
    for (uint32_t k = 0; k < n - !reduction_r.polygon.closed + reduction_r.obstacle_count; k++) {
        uint32_t o = k - (n - !reduction_r.polygon.closed);
        knot_edge e = k < n - !reduction_r.polygon.closed ? (knot_edge){p->x[k], p->x[(k + 1) % n]}
                                                          : reduction_r.obstacles[o];
        if (k != i && k != before &&
            (same(e.start, b) || same(e.end, b) ||
             !vbss_knot_segment_misses_triangle(a, b, c, e.start, e.end))) {
            return false;
        }
    }
    return true;
}

static void take_out(reduction_plain *p, uint32_t i)
{
    for (p->count--; i < p->count; i++) {
        p->x[i] = p->x[i + 1];
        p->place[i] = p->place[i + 1];
        p->stays[i] = p->stays[i + 1];
    }
}

void reduction_reduce_plainly(reduction_plain *p)
{
    for (bool again = true; again;) {
        again = false;
        for (uint32_t i = 0; i < p->count; i++) {
            bool is_end = !reduction_r.polygon.closed && (i == 0 || i + 1 == p->count);
            if (p->stays[i] == 0 && !is_end && (!reduction_r.polygon.closed || p->count > 3) &&
                reduction_is_free(p, i)) {
                take_out(p, i); /* what comes to its place is passed over */
                again = true;
            }
        }
    }
}

void reduction_take(reduction_plain *p)
{
    p->count = reduction_r.polygon.count;
    memcpy(p->x, reduction_r.x, sizeof reduction_r.x);
    memcpy(p->place, reduction_r.place, sizeof reduction_r.place);
    memcpy(p->stays, reduction_r.stays, sizeof reduction_r.stays);
}

void reduction_put(const reduction_plain *p)
{
    reduction_r.polygon.count = p->count;
    memcpy(reduction_r.x, p->x, sizeof p->x);
    memcpy(reduction_r.place, p->place, sizeof p->place);
    memcpy(reduction_r.stays, p->stays, sizeof p->stays);
}

void reduction_expect(const reduction_plain *p)
{
    assert_int_equal(p->count, reduction_r.polygon.count);
    assert_memory_equal(p->x, reduction_r.x, p->count * sizeof(vec3));
    assert_memory_equal(p->place, reduction_r.place, p->count * sizeof(double));
    assert_memory_equal(p->stays, reduction_r.stays, p->count);
}
