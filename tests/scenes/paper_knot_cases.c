#include "scenes/paper_knot_cases.h"

#include "base/elementary.h"

const paper_knot_case paper_knot_cases[PAPER_KNOT_KINDS] = {
    {"A: one turn", 1, 0, 1.07, true},           {"B: two turns outward", 1, 0, 1.94, true},
    {"C: helix, 32 segments", 1, 1, 1.59, true}, {"C: helix, 31 segments", 1, 1, 1.59, true},
    {"D: one turn and back", 2, 0, -0.02, true}, {"E: curled standing part", 1, 0, -1.36, true},
    {"F: beyond the tip", 1, 0, 1.07, false},    {"G: two turns, in and out", 0, 1, 2.03, true},
    {"H: on the floor", 1, 0, 1.07, false},
};

#define TWO_PI 6.283185307179586

/* ---- the thread from where the search begins: the long limb's end */

/* In turns, walking towards there, mm, mm. */
typedef struct corner {
    double turns, radius, height;
} corner;

static vec3 place(corner c)
{
    double sine, cosine;
    vbss_sincos(-TWO_PI * c.turns, &sine, &cosine);
    return vec3_make(1e-3 * c.radius * cosine, 1e-3 * c.radius * sine, 1e-3 * c.height);
}

static corner between(corner a, corner b, double s)
{
    corner c = {a.turns + s * (b.turns - a.turns), a.radius + s * (b.radius - a.radius),
                a.height + s * (b.height - a.height)};
    return c;
}

/* Inward to 3 mm and out again, evenly about the axis, sinking by 4 mm. */
static uint32_t in_and_out(double turns, double height, uint32_t segments, vec3 *points)
{
    for (uint32_t k = 0; k <= segments; k++) {
        double s = (double)k / segments, q = 2.0 * s - 1.0;
        corner c = {turns * s, 3.0 + 27.0 * (q * q * q) * (q * q * q), height - 2.0 * q};
        points[k] = place(c);
    }
    return segments + 1;
}

/* Through corners, straight in cylinder coordinates, as many segments between each two. */
static uint32_t along(const corner *corners, uint32_t count, uint32_t segments, vec3 *points)
{
    uint32_t n = 0;
    for (uint32_t k = 0; k + 1 < count; k++) {
        for (uint32_t m = 0; m < segments; m++) {
            points[n++] = place(between(corners[k], corners[k + 1], (double)m / segments));
        }
    }
    points[n++] = place(corners[count - 1]);
    return n;
}

/* Comes in radially; the end turns back by 0.41, straight through the turns. */
static uint32_t helix(uint32_t segments, vec3 *points)
{
    corner begin = {0.0, 30.0, 14.0}, end = {2.0 - 0.41, 30.0, 6.0};
    uint32_t n = 0;
    points[n++] = place(begin);
    for (uint32_t k = 0; k <= segments; k++) {
        corner c = {2.0 * k / segments, 2.5, 14.0 - 8.0 * k / segments};
        points[n++] = place(c);
    }
    points[n++] = place(end);
    return n;
}

#define ALONG(...)                                                                               \
    along((const corner[]){__VA_ARGS__}, sizeof((const corner[]){__VA_ARGS__}) / sizeof(corner), \
          12, points)

static uint32_t from_long_limb(paper_knot_kind kind, vec3 *points)
{
    switch (kind) {
    case PAPER_KNOT_B:
        return ALONG({0, 30, 12}, {0, 2.5, 12}, {0.5, 4, 11}, {1, 5.5, 10}, {1.5, 7, 9},
                     {1.94, 8.5, 8}, {1.94, 30, 6});
    case PAPER_KNOT_C:
        return helix(32, points);
    case PAPER_KNOT_C2:
        return helix(31, points);
    case PAPER_KNOT_D:
        return ALONG({0, 30, 14}, {0.05, 3, 13}, {0.55, 3, 12}, {1.02, 3, 11}, {1.07, 12, 10},
                     {0.77, 12, 9}, {0.72, 3, 8}, {0.2, 3, 7}, {-0.25, 3, 6}, {-0.30, 20, 5},
                     {-0.02, 30, 5});
    case PAPER_KNOT_E:
        return ALONG({0, 30, 12}, {-0.45, 20, 12}, {-0.25, 12, 4}, {-0.5, 3, 6}, {-0.95, 3, 8},
                     {-1.36, 3, 10}, {-1.36, 30, 10});
    case PAPER_KNOT_F:
        return in_and_out(1.07, -20.0, 48, points);
    case PAPER_KNOT_G:
        return in_and_out(2.03, 10.0, 96, points);
    case PAPER_KNOT_H:
        return in_and_out(1.07, -45.0, 48, points);
    default:
        return in_and_out(1.07, 10.0, 48, points);
    }
}

uint32_t paper_knot_make(paper_knot_kind kind, vec3 points[PAPER_KNOT_POINTS])
{
    uint32_t n = from_long_limb(kind, points);
    for (uint32_t k = 0; k < n / 2; k++) {
        vec3 swapped = points[k];
        points[k] = points[n - 1 - k];
        points[n - 1 - k] = swapped;
    }
    return n;
}

vbss_knot_tool paper_knot_tool(void)
{
    vbss_knot_tool tool = {
        .point_count = 2, .axis = {{0.0, 0.0, 0.15}, {0.0, 0.0, 0.0}}, .radius = {2.5e-3}};
    return tool;
}
