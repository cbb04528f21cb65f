#include "scenes/held_look.h"

#include "base/error.h"

#include <stdlib.h>

/* A tail that touches something further out than this from where it left the knot lies beside it, m. */
#define BESIDE 1e-3
/* The loop's tension is that of so much of it on either side of the knot, m. */
#define NEXT_TO_KNOT 1.5e-3
/* Of the tails, what a surgeon leaves, m. */
#define TAIL 8e-3

static vbss_result view_of(const tied_knot *knot, vbss_thread_field field, vbss_view *view)
{
    return vbss_thread_get_view(knot->thread, field, view, sizeof *view);
}

vbss_result held_look_line(const tied_knot *knot, held_line *line)
{
    vbss_view positions, rest;
    VBSS_TRY(view_of(knot, VBSS_THREAD_POSITIONS, &positions));
    VBSS_TRY(view_of(knot, VBSS_THREAD_REST_LENGTHS, &rest));
    line->nodes = knot->node_count;
    line->x = positions.data;
    line->arc[0] = 0.0;
    for (uint32_t i = 0; i + 1 < line->nodes; i++) {
        line->arc[i + 1] = line->arc[i] + ((const double *)rest.data)[i];
    }
    return VBSS_OK;
}

/* ---- where strands touch each other */

enum { MOST_PLACES = 4096 };

typedef struct places {
    uint32_t count;
    double at[MOST_PLACES]; /* arc lengths, m */
} places;

static int by_size(const void *a, const void *b)
{
    double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

static double place_on(const held_line *line, uint32_t segment, vec3 point)
{
    vec3 along = vec3_sub(line->x[segment + 1], line->x[segment]);
    vec3 from = vec3_sub(point, line->x[segment]);
    double share = vec3_dot(from, along) / vec3_dot(along, along);
    double length = line->arc[segment + 1] - line->arc[segment];
    return line->arc[segment] + length * vbss_min(vbss_max(share, 0.0), 1.0);
}

static vbss_result find_places(const tied_knot *knot, places *p)
{
    held_line line;
    vbss_view features, points;
    vbss_scene *scene = knot->scene;
    VBSS_TRY(held_look_line(knot, &line));
    VBSS_TRY(vbss_scene_get_view(scene, VBSS_SCENE_VIEW_CONTACTS, &features, sizeof features));
    VBSS_TRY(vbss_scene_get_view(scene, VBSS_SCENE_VIEW_CONTACT_POINTS, &points, sizeof points));
    p->count = 0;
    for (uint64_t i = 0; i < features.count && p->count + 2 <= MOST_PLACES; i++) {
        const uint32_t *f = (const uint32_t *)features.data + 5 * i;
        vec3 at = ((const vec3 *)points.data)[i];
        if (f[0] == VBSS_CONTACT_SEGMENTS) {
            p->at[p->count++] = place_on(&line, f[2], at);
            p->at[p->count++] = place_on(&line, f[4], at);
        }
    }
    qsort(p->at, p->count, sizeof p->at[0], by_size);
    return VBSS_OK;
}

/* The loop is the longest part between the tails that touches no strand. */
vbss_result held_look(const tied_knot *knot, bool known, held_knot_edges *edges, bool *touches)
{
    places p;
    VBSS_TRY(find_places(knot, &p));
    uint32_t first = 0, last = p.count > 0 ? p.count - 1 : 0;
    while (known && first < last && p.at[first] < edges->tails[0] - BESIDE) {
        first++;
    }
    while (known && last > first && p.at[last] > edges->tails[1] + BESIDE) {
        last--;
    }
    *touches = last > first;
    if (*touches) {
        uint32_t loop = first;
        for (uint32_t i = first; i < last; i++) {
            loop = p.at[i + 1] - p.at[i] > p.at[loop + 1] - p.at[loop] ? i : loop;
        }
        *edges = (held_knot_edges){{p.at[first], p.at[last]}, {p.at[loop], p.at[loop + 1]}};
    }
    return VBSS_OK;
}

/* ---- what lies between them */

vbss_result held_look_tension(const tied_knot *knot, const held_knot_edges *edges, double *tension)
{
    held_line line;
    vbss_view tensions;
    double sum = 0.0, length = 0.0, from = edges->loop[0], to = edges->loop[1];
    VBSS_TRY(held_look_line(knot, &line));
    VBSS_TRY(view_of(knot, VBSS_THREAD_TENSIONS, &tensions));
    for (uint32_t i = 0; i + 1 < line.nodes; i++) {
        double l = line.arc[i + 1] - line.arc[i], middle = 0.5 * (line.arc[i] + line.arc[i + 1]);
        bool next = (middle > from && middle < from + NEXT_TO_KNOT) ||
                    (middle < to && middle > to - NEXT_TO_KNOT);
        sum += next ? l * ((const double *)tensions.data)[i] : 0.0;
        length += next ? l : 0.0;
    }
    *tension = length > 0.0 ? sum / length : 0.0;
    return VBSS_OK;
}

vbss_result held_look_middle(const tied_knot *knot, const held_knot_edges *edges, vec3 *middle)
{
    held_line line;
    double count = 0.0;
    VBSS_TRY(held_look_line(knot, &line));
    *middle = vec3_zero();
    for (uint32_t i = 0; i < line.nodes; i++) {
        double s = line.arc[i];
        bool inside = (s > edges->tails[0] && s < edges->loop[0]) ||
                      (s > edges->loop[1] && s < edges->tails[1]);
        *middle = inside ? vec3_add(*middle, line.x[i]) : *middle;
        count += inside;
    }
    *middle = vec3_scale(*middle, 1.0 / vbss_max(count, 1.0));
    return VBSS_OK;
}

vbss_result held_knot_strand(const held_knot *knot, const vec3 **x, uint32_t *count)
{
    held_line line = {0};
    VBSS_TRY(held_look_line(&knot->tied, &line));
    uint32_t first = 0, last = line.nodes - 1;
    while (first < last && line.arc[first + 1] < knot->edges.tails[0] - TAIL) {
        first++;
    }
    while (last > first && line.arc[last - 1] > knot->edges.tails[1] + TAIL) {
        last--;
    }
    *x = line.x + first;
    *count = last - first + 1;
    return VBSS_OK;
}
