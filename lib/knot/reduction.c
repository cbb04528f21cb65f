/* Removal of polygon vertices whose triangle is hit by nothing.
 *
 * Vertices are tested in turn, sweep after sweep. A sweep removes vertices from a linked ring; the
 * arrays are compacted after it. Most edges are far from most triangles, so eight boxes of edges
 * are tested at once, and before them eight boxes of such groups. A blocked vertex is not tested
 * again while its blocker and both its edges are unchanged. */
#include "knot/boxes.h"
#include "knot/knot.h"
#include "knot/triangle.h"
#include "knot/tuning.h"

#define NONE UINT32_MAX

/* ---- entries: one for each obstacle, then one for each vertex and the edge after it */

static uint32_t groups_of(uint32_t entries)
{
    return (entries + KNOT_BOX_LANES - 1) / KNOT_BOX_LANES;
}

void vbss_knot_reduction_arrays(knot_reduction *r, uint32_t capacity,
                                vbss_array arrays[KNOT_REDUCTION_ARRAYS])
{
    uint32_t groups = groups_of(capacity), entries = groups * KNOT_BOX_LANES;
    vbss_array wanted[KNOT_REDUCTION_ARRAYS] = {
        {&r->boxes, ((size_t)groups + groups_of(groups)) * KNOT_BOX_GROUP + 4 * (size_t)entries,
         sizeof(int16_t)},
        {&r->blockers, 2 * (size_t)entries, sizeof(uint32_t)},
        {&r->links, 3 * (size_t)entries, sizeof(uint32_t)}};
    r->capacity = capacity;
    for (int i = 0; i < KNOT_REDUCTION_ARRAYS; i++) {
        arrays[i] = wanted[i];
    }
}

/* The arrays by name. */
typedef struct parts {
    uint32_t first, end; /* entries of vertices */
    uint32_t groups, supers;
    int16_t *edges, *hulls;        /* boxes of edges, and of groups of eight */
    int16_t *corners;              /* vertices on the grid */
    uint32_t *blocker, *tested_at; /* the edge that blocks a vertex, and when it was found */
    uint32_t *next, *before;       /* `next` of a removed vertex is the vertex itself */
    uint32_t *changed_at;          /* when an edge last changed */
} parts;

static parts parts_of(const knot_reduction *r)
{
    uint32_t groups = groups_of(r->capacity), all = groups * KNOT_BOX_LANES;
    parts p;
    p.first = r->first_edge;
    p.end = p.first + r->polygon->count;
    p.groups = groups_of(p.end);
    p.supers = groups_of(p.groups);
    p.edges = r->boxes;
    p.hulls = p.edges + (size_t)groups * KNOT_BOX_GROUP;
    p.corners = p.hulls + (size_t)groups_of(groups) * KNOT_BOX_GROUP;
    p.blocker = r->blockers;
    p.tested_at = p.blocker + all;
    p.next = r->links;
    p.before = p.next + all;
    p.changed_at = p.before + all;
    return p;
}

static vec3 vertex(const knot_reduction *r, uint32_t entry)
{
    return r->polygon->x[entry - r->first_edge];
}

static knot_edge edge_of(const knot_reduction *r, const parts *p, uint32_t entry)
{
    if (entry < p->first) {
        return r->obstacles[entry];
    }
    knot_edge e = {vertex(r, entry), vertex(r, p->next[entry])};
    return e;
}

/* ---- boxes */

static box box_of(const parts *p, uint32_t start, uint32_t end)
{
    return box_of_corners(p->corners + 4 * (size_t)start, p->corners + 4 * (size_t)end);
}

/* Sets links and boxes of all edges; the vertices must be compact. */
static void link_all(knot_reduction *r)
{
    parts p = parts_of(r);
    bool closed = r->polygon->closed;
    for (uint32_t s = p.first; s < p.end; s++) {
        p.next[s] = s + 1 < p.end ? s + 1 : closed ? p.first : NONE;
        p.before[s] = s > p.first ? s - 1 : closed ? p.end - 1 : NONE;
        boxes_set(p.edges, s, p.next[s] == NONE ? box_empty() : box_of(&p, s, p.next[s]));
    }
    for (uint32_t s = p.end; s < p.groups * KNOT_BOX_LANES; s++) {
        boxes_set(p.edges, s, box_empty());
    }
    for (uint32_t g = 0; g < p.supers * KNOT_BOX_LANES; g++) {
        boxes_set(p.hulls, g,
                  g < p.groups ? boxes_hull(p.edges + (size_t)g * KNOT_BOX_GROUP) : box_empty());
    }
    r->cursor = p.first;
    r->removed_in_sweep = 0;
}

/* The finest grid for the vertices that can be removed. */
static box_grid grid_of(const knot_polygon *polygon)
{
    vec3 low = vec3_make(DBL_MAX, DBL_MAX, DBL_MAX), high = vec3_scale(low, -1.0);
    for (uint32_t i = 0; i < polygon->count; i++) {
        vec3 x = polygon->x[i];
        if (polygon->is_fixed[i] == 0) {
            low = vec3_make(x.x < low.x ? x.x : low.x, x.y < low.y ? x.y : low.y,
                            x.z < low.z ? x.z : low.z);
            high = vec3_make(x.x > high.x ? x.x : high.x, x.y > high.y ? x.y : high.y,
                             x.z > high.z ? x.z : high.z);
        }
    }
    box_grid grid;
    box_grid_axis(&grid, 0, low.x, high.x);
    box_grid_axis(&grid, 1, low.y, high.y);
    box_grid_axis(&grid, 2, low.z, high.z);
    return grid;
}

void vbss_knot_reduction_begin(knot_reduction *r, knot_polygon *polygon, const knot_edge *obstacles,
                               uint32_t obstacle_count)
{
    r->polygon = polygon;
    r->obstacles = obstacles;
    r->obstacle_count = obstacle_count;
    r->first_edge = obstacle_count;
    r->remaining = polygon->count;
    r->removed = 0;
    r->timestamp = 1;
    r->deferred_ops = (knot_ops)KNOT_COMPACT_OPS * ((knot_ops)polygon->count + obstacle_count);

    parts p = parts_of(r);
    box_grid grid = grid_of(polygon);
    for (uint32_t s = p.first; s < p.end; s++) {
        box_round(&grid, vertex(r, s), p.corners + 4 * (size_t)s);
        p.blocker[s] = NONE;
        p.tested_at[s] = 0;
        p.changed_at[s] = 1;
    }
    for (uint32_t s = 0; s < p.first; s++) {
        int16_t start[4], end[4];
        box_round(&grid, obstacles[s].start, start);
        box_round(&grid, obstacles[s].end, end);
        boxes_set(p.edges, s, box_of_corners(start, end));
        p.changed_at[s] = 1;
    }
    link_all(r);
}

/* ---- one vertex */

static bool same(vec3 p, vec3 q)
{
    return p.x == q.x && p.y == q.y && p.z == q.z;
}

/* An edge that ends at b always blocks, because the polygon moves away from b. */
static bool blocks(const knot_triangle *t, knot_edge e)
{
    return same(e.start, t->b) || same(e.end, t->b) ||
           !vbss_knot_triangle_misses(t, e.start, e.end);
}

/* Tests the edges next to the two that would go; `next` may be NONE. Nearly all of them leave the
 * plane of the triangle. */
static bool neighbours_clear(const knot_reduction *r, const parts *p, const knot_triangle *t,
                             uint32_t v, uint32_t *blocker)
{
    uint32_t a = p->before[v], c = p->next[v], before = p->before[a], next = p->next[c];
    if (before != NONE && knot_triangle_side(t, vertex(r, before)) == 0 &&
        blocks(t, edge_of(r, p, before))) {
        *blocker = before;
        return false;
    }
    if (next != NONE && knot_triangle_side(t, vertex(r, next)) == 0 &&
        blocks(t, edge_of(r, p, c))) {
        *blocker = c;
        return false;
    }
    return true;
}

/* Bit mask of the 64 edges of a group of groups whose boxes overlap a box. */
static uint64_t edges_overlapping(const parts *p, uint32_t super, const box_query *query)
{
    uint64_t groups = boxes_overlapping(p->hulls + (size_t)super * KNOT_BOX_GROUP, query),
             edges = 0;
    while (groups != 0) {
        uint32_t g = box_pop_bit(&groups);
        uint64_t meeting = boxes_overlapping(
            p->edges + ((size_t)super * KNOT_BOX_LANES + g) * KNOT_BOX_GROUP, query);
        edges |= meeting << g * KNOT_BOX_LANES;
    }
    return edges;
}

static uint64_t bit_of(uint32_t super, uint32_t s)
{
    return (uint64_t)(s / 64 == super) << s % 64;
}

/* An edge that blocks v, whose triangle is t; NONE if there is none. */
static uint32_t find_blocker(const knot_reduction *r, const parts *p, uint32_t v,
                             const knot_triangle *t, knot_ops *budget)
{
    uint32_t a = p->before[v], c = p->next[v], before = p->before[a];
    box_query query = box_ask(box_hull(box_of(p, a, v), box_of(p, v, c)));
    for (uint32_t super = 0; super < p->supers; super++) {
        uint64_t edges =
            edges_overlapping(p, super, &query) &
            ~(bit_of(super, v) | bit_of(super, a) | bit_of(super, c) | bit_of(super, before));
        while (edges != 0) {
            uint32_t s = super * 64 + box_pop_bit(&edges);
            knot_edge e = edge_of(r, p, s);
            *budget -= KNOT_EDGE_OPS;
            if (knot_triangle_side(t, e.start) * knot_triangle_side(t, e.end) <= 0 &&
                blocks(t, e)) {
                return s;
            }
        }
    }
    return NONE;
}

/* The edge that replaces a removed one: that of the last remaining vertex before it. */
static uint32_t current_edge(const parts *p, uint32_t s)
{
    while (s >= p->first && p->next[s] == s) {
        s = (s > p->first ? s : p->end) - 1;
    }
    return s;
}

static bool is_free(const knot_reduction *r, const parts *p, uint32_t v, knot_ops *budget)
{
    uint32_t before = p->before[v];
    vec3 a = vertex(r, before), b = vertex(r, v), c = vertex(r, p->next[v]);
    if (same(a, b) || same(b, c)) {
        return true;
    }
    knot_triangle t = knot_triangle_make(a, b, c);
    uint32_t blocker = p->blocker[v];
    if (blocker != NONE) {
        blocker = current_edge(p, blocker);
    }
    if (blocker == NONE || blocker == v || blocker == before ||
        !blocks(&t, edge_of(r, p, blocker))) {
        if (neighbours_clear(r, p, &t, v, &blocker)) {
            blocker = find_blocker(r, p, v, &t, budget);
        }
    }
    p->blocker[v] = blocker;
    return blocker == NONE;
}

static void remove_vertex(knot_reduction *r, const parts *p, uint32_t v)
{
    uint32_t before = p->before[v], next = p->next[v], group = before / KNOT_BOX_LANES;
    box b = box_of(p, before, next);
    boxes_set(p->edges, before, b);
    boxes_set(p->hulls, group, box_hull(boxes_get(p->hulls, group), b));
    boxes_set(p->edges, v, box_empty());
    p->next[before] = next;
    p->before[next] = before;
    p->next[v] = v;
    p->changed_at[before] = p->changed_at[v] = r->timestamp;
    r->remaining--;
    r->removed_in_sweep++;
    r->removed++;
}

/* Removes v if possible. Returns whether it did. */
static bool try_remove(knot_reduction *r, const parts *p, uint32_t v, knot_ops *budget)
{
    uint32_t before = p->before[v], next = p->next[v], blocker = p->blocker[v];
    *budget -= KNOT_SKIP_OPS;
    if (r->polygon->is_fixed[v - p->first] != 0 || before == NONE || next == NONE ||
        (r->polygon->closed && r->remaining <= 3)) {
        return false;
    }
    uint32_t tested_at = p->tested_at[v];
    if (blocker != NONE && p->changed_at[blocker] < tested_at &&
        p->changed_at[before] < tested_at && p->changed_at[v] < tested_at) {
        return false;
    }
    *budget -= KNOT_VISIT_OPS;
    p->tested_at[v] = ++r->timestamp;
    if (!is_free(r, p, v, budget)) {
        return false;
    }
    *budget -= KNOT_REMOVE_OPS;
    r->timestamp++;
    remove_vertex(r, p, v);
    return true;
}

/* ---- sweeps */

static void compact(knot_reduction *r)
{
    parts p = parts_of(r);
    knot_polygon *polygon = r->polygon;
    /* an edge before the first vertex continues at the last one */
    uint32_t to = p.first + r->remaining;
    for (uint32_t s = p.first, remaining = 0; s < p.end; s++) {
        remaining += p.next[s] != s;
        p.before[s] = remaining > 0 ? p.first + remaining - 1 : to - 1;
    }
    for (uint32_t s = p.first; s < p.end; s++) {
        if (p.next[s] == s) {
            continue;
        }
        uint32_t d = p.before[s], i = s - p.first, j = d - p.first, blocker = p.blocker[s];
        polygon->x[j] = polygon->x[i];
        polygon->place[j] = polygon->place[i];
        polygon->is_fixed[j] = polygon->is_fixed[i];
        for (size_t k = 0; k < 4; k++) {
            p.corners[4 * (size_t)d + k] = p.corners[4 * (size_t)s + k];
        }
        p.blocker[d] = blocker != NONE && blocker >= p.first ? p.before[blocker] : blocker;
        p.tested_at[d] = p.tested_at[s];
        p.changed_at[d] = p.changed_at[s];
    }
    polygon->count = r->remaining;
    link_all(r);
}

bool vbss_knot_reduction_resume(knot_reduction *r, knot_ops *budget)
{
    parts p = parts_of(r);
    *budget -= r->deferred_ops;
    r->deferred_ops = 0;
    while (*budget > 0) {
        if (r->cursor >= p.end) {
            if (r->removed_in_sweep == 0) {
                *budget -= 1;
                return true;
            }
            *budget -= (knot_ops)KNOT_COMPACT_OPS * r->polygon->count + 1;
            compact(r);
            p = parts_of(r);
        } else {
            /* Skip the next vertex until the next sweep: triangles stay small and hit little. */
            r->cursor += try_remove(r, &p, r->cursor, budget) ? 2 : 1;
        }
    }
    return false;
}
