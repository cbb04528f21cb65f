/* Faces of a diagram, traced side by side. Side 2 i is the left of arc i, which leads from entry i
 * to the next, traversed forward; side 2 i + 1 is its right, traversed backward. */
#include "knot/faces.h"

#include <string.h>

typedef struct sides {
    const knot_gauss_code *code;
    uint32_t entries;
    uint32_t *face; /* side -> face */
    uint32_t *mate; /* entry -> the other entry of its crossing */
} sides;

#define NO_FACE UINT32_MAX

static void find_mates(sides *s, uint32_t *first)
{
    const knot_gauss_code *code = s->code;
    memset(first, 0xff, code->n * sizeof *first);
    for (uint32_t e = 0; e < s->entries; e++) {
        uint32_t c = code->crossing[e];
        if (first[c] == UINT32_MAX) {
            first[c] = e;
        } else {
            s->mate[e] = first[c];
            s->mate[first[c]] = e;
        }
    }
}

/* Whether the other strand crosses from right to left. */
static bool crossed_leftward(const sides *s, uint32_t entry)
{
    return (s->code->over[entry] != 0) == (s->code->sign[s->code->crossing[entry]] > 0);
}

static uint32_t before(const sides *s, uint32_t entry)
{
    return (entry == 0 ? s->entries : entry) - 1;
}

static uint32_t after(const sides *s, uint32_t entry)
{
    return entry + 1 == s->entries ? 0 : entry + 1;
}

/* Next side of a face that is kept on the left. */
static uint32_t next_side(const sides *s, uint32_t side)
{
    bool along = side % 2 == 0;
    uint32_t here = along ? after(s, side / 2) : side / 2, mate = s->mate[here];
    return crossed_leftward(s, here) == along ? 2 * mate : 2 * before(s, mate) + 1;
}

/* Traces all faces of a colour: left of every other arc, right of the arcs between. */
static uint32_t trace_faces(sides *s, uint32_t colour, uint32_t count)
{
    for (uint32_t arc = 0; arc < s->entries; arc++) {
        uint32_t first_side = 2 * arc + (arc + colour) % 2;
        count += s->face[first_side] == NO_FACE ? 1 : 0;
        for (uint32_t side = first_side; s->face[side] == NO_FACE; side = next_side(s, side)) {
            s->face[side] = count - 1;
        }
    }
    return count;
}

bool vbss_knot_find_faces(const knot_algebra *algebra, const knot_gauss_code *code,
                          knot_faces *faces)
{
    uint32_t n = code->n, *corners = algebra->index;
    sides s = {code, 2 * n, corners + (size_t)KNOT_CORNERS * n,
               corners + 2 * (size_t)KNOT_CORNERS * n};
    memset(s.face, 0xff, 4 * (size_t)n * sizeof *s.face);
    find_mates(&s, corners);
    faces->even = trace_faces(&s, 0, 0);
    faces->count = trace_faces(&s, 1, faces->even);
    for (uint32_t e = 0; e < s.entries; e++) {
        if (crossed_leftward(&s, e)) { /* only from one of the two strands */
            uint32_t *corner = corners + (size_t)KNOT_CORNERS * code->crossing[e],
                     incoming = before(&s, e);
            corner[KNOT_FRONT] = s.face[2 * (size_t)e];
            corner[KNOT_LEFT] = s.face[2 * (size_t)incoming];
            corner[KNOT_BACK] = s.face[2 * (size_t)incoming + 1];
            corner[KNOT_RIGHT] = s.face[2 * (size_t)e + 1];
        }
    }
    return n > 0 && faces->count == n + 2;
}
