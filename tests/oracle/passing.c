#include "oracle/passing.h"

#include <stdlib.h>

#include "oracle/oracle.h"

/* Time is halved this often before exact arithmetic is asked. */
enum { HALVINGS = 6 };

/* What a moving segment may touch: a segment at any time lies among its four ends, of both states, and so
 * in their box, which is exact. */
typedef struct sweep {
    const vec3 *start, *end; /* two nodes each */
    vec3 low, high;
    size_t chain, segment;
    bool tool;
} sweep;

/* ---- boxes */

static vec3 lesser_of(vec3 a, vec3 b)
{
    return vec3_make(lesser(a.x, b.x), lesser(a.y, b.y), lesser(a.z, b.z));
}

static vec3 greater_of(vec3 a, vec3 b)
{
    return vec3_make(greater(a.x, b.x), greater(a.y, b.y), greater(a.z, b.z));
}

static bool is_finite(const sweep *s)
{
    return vec3_is_finite(s->start[0]) && vec3_is_finite(s->start[1]) &&
           vec3_is_finite(s->end[0]) && vec3_is_finite(s->end[1]);
}

static sweep make_sweep(const passing_chain *chain, size_t number, size_t segment)
{
    sweep s = {.start = chain->start + segment,
               .end = chain->end + segment,
               .chain = number,
               .segment = segment,
               .tool = chain->tool};
    s.low = lesser_of(lesser_of(s.start[0], s.start[1]), lesser_of(s.end[0], s.end[1]));
    s.high = greater_of(greater_of(s.start[0], s.start[1]), greater_of(s.end[0], s.end[1]));
    if (!is_finite(&s)) { /* in everybody's way */
        s.low = vec3_make(-HUGE_VAL, -HUGE_VAL, -HUGE_VAL);
        s.high = vec3_make(HUGE_VAL, HUGE_VAL, HUGE_VAL);
    }
    return s;
}

static bool boxes_apart(const sweep *a, const sweep *b)
{
    return a->high.x < b->low.x || b->high.x < a->low.x || a->high.y < b->low.y ||
           b->high.y < a->low.y || a->high.z < b->low.z || b->high.z < a->low.z;
}

/* ---- a plane between two sweeps, or between parts of them in time
 *
 * Any direction n may be tried: if all ends of a are further along n than all ends of b, at both times,
 * nothing meets between these times. In floating point, u = 2^-53, M the largest coordinate: an end at time t
 * is known to 2.1 u M a coordinate, its place along n to 5.5 u M |n|_1 with the rounding of products and
 * sums; so 16 u M |n|_1 is more than twice that, and TINY more than any underflow. */

#define ROUNDING (16.0 * 0x1p-53)
#define TINY 1e-290

static double reach(const sweep *s)
{
    vec3 a = greater_of(s->high, vec3_neg(s->low));
    return greater(a.x, greater(a.y, a.z));
}

static double clamp(double x)
{
    return x < 0.0 ? 0.0 : x > 1.0 ? 1.0 : x;
}

/* From a point of b to one of a: nearly the closest ones. A choice, which need not be right. */
static vec3 between(const vec3 a[2], const vec3 b[2])
{
    vec3 along_a = vec3_sub(a[1], a[0]), along_b = vec3_sub(b[1], b[0]),
         from_b = vec3_sub(a[0], b[0]);
    double aa = vec3_dot(along_a, along_a), bb = vec3_dot(along_b, along_b);
    double ab = vec3_dot(along_a, along_b), ar = vec3_dot(along_a, from_b);
    double br = vec3_dot(along_b, from_b), d = aa * bb - ab * ab;
    double s = d > 0.0 ? clamp((ab * br - bb * ar) / d) : 0.5;
    double t = bb > 0.0 ? clamp((ab * s + br) / bb) : 0.0;
    s = aa > 0.0 ? clamp((ab * t - ar) / aa) : 0.0;
    return vec3_add_scaled(vec3_add_scaled(from_b, s, along_a), -t, along_b);
}

static bool plane_between(vec3 n, const vec3 a[4], const vec3 b[4], double most)
{
    double nearest = HUGE_VAL, furthest = -HUGE_VAL;
    for (int i = 0; i < 4; i++) {
        nearest = lesser(nearest, vec3_dot(n, a[i]));
        furthest = greater(furthest, vec3_dot(n, b[i]));
    }
    return nearest - furthest > ROUNDING * most * (fabs(n.x) + fabs(n.y) + fabs(n.z)) + TINY;
}

static void at_time(const sweep *s, double t, vec3 ends[2])
{
    ends[0] = vec3_lerp(s->start[0], s->end[0], t);
    ends[1] = vec3_lerp(s->start[1], s->end[1], t);
}

static bool apart_from_to(const sweep *a, const sweep *b, double from, double to, double most)
{
    vec3 ends_a[4], ends_b[4], middle_a[2], middle_b[2];
    at_time(a, from, ends_a);
    at_time(a, to, ends_a + 2);
    at_time(b, from, ends_b);
    at_time(b, to, ends_b + 2);
    at_time(a, 0.5 * (from + to), middle_a);
    at_time(b, 0.5 * (from + to), middle_b);
    return plane_between(between(middle_a, middle_b), ends_a, ends_b, most);
}

/* Step by step through time: as long as can be proven, halving what cannot. */
static bool proven_apart(const sweep *a, const sweep *b)
{
    double most = greater(reach(a), reach(b)), time = 0.0, step = 1.0;
    while (time < 1.0) {
        if (apart_from_to(a, b, time, time + step, most)) {
            time += step;
            step = lesser(2.0 * step, 1.0 - time);
        } else if (step > 1.0 / (1 << HALVINGS)) {
            step *= 0.5;
        } else {
            return false;
        }
    }
    return true;
}

/* ---- the exact answer */

static bool meets(const sweep *a, const sweep *b)
{
    if (!is_finite(a) || !is_finite(b)) {
        return true;
    }
    collision_query query = {.kind = VBSS_PAIR_EDGE_EDGE};
    for (size_t i = 0; i < 2; i++) {
        vec3_store(query.start + 3 * i, a->start[i]);
        vec3_store(query.start + 6 + 3 * i, b->start[i]);
        vec3_store(query.end + 3 * i, a->end[i]);
        vec3_store(query.end + 6 + 3 * i, b->end[i]);
    }
    return oracle_meets(&query);
}

/* ---- all pairs */

static void ask(const sweep *a, const sweep *b, passing_report *report)
{
    if (proven_apart(a, b)) {
        return;
    }
    report->asked++;
    if (!meets(a, b)) {
        return;
    }
    if (report->passed++ == 0) {
        report->chains[0] = a->chain;
        report->chains[1] = b->chain;
        report->segments[0] = a->segment;
        report->segments[1] = b->segment;
    }
}

static void ask_all(const sweep *sweeps, size_t count, passing_report *report)
{
    for (size_t i = 0; i < count; i++) {
        const sweep *a = &sweeps[i];
        for (size_t j = i + 1; j < count; j++) {
            const sweep *b = &sweeps[j];
            if ((a->tool && b->tool) || (a->chain == b->chain && j == i + 1)) {
                continue;
            }
            report->pairs++;
            if (!boxes_apart(a, b)) {
                ask(a, b, report);
            }
        }
    }
}

uint64_t passing_count(const passing_chain *chains, size_t count, passing_report *report)
{
    passing_report own = {0};
    size_t segments = 0;
    for (size_t c = 0; c < count; c++) {
        segments += chains[c].nodes > 1 ? chains[c].nodes - 1 : 0;
    }
    sweep *sweeps = segments > 0 ? malloc(segments * sizeof *sweeps) : NULL;
    if (sweeps != NULL) {
        size_t made = 0;
        for (size_t c = 0; c < count; c++) {
            for (size_t i = 0; i + 1 < chains[c].nodes; i++) {
                sweeps[made++] = make_sweep(&chains[c], c, i);
            }
        }
        ask_all(sweeps, made, &own);
        free(sweeps);
    } else if (segments > 0) {
        own.passed = UINT64_MAX; /* no memory: nothing is proven */
    }
    if (report != NULL) {
        *report = own;
    }
    return own.passed;
}
