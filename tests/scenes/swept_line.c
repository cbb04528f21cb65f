/* What is done with swept lines as a whole. */
#include "scenes/swept.h"

/* ---- thinning */

/* How much is lost when a vertex goes: its distance from the new edge, and a share of the edge's length. */
static double loss(const swept_line *line, uint32_t v)
{
    vec3 a = line->x[line->previous[v]], b = line->x[line->next[v]], x = line->x[v];
    vec3 along = vec3_sub(b, a);
    double length = vec3_norm(along);
    double height =
        length > 0.0 ? vec3_norm(vec3_cross(along, vec3_sub(x, a))) / length : vec3_distance(x, a);
    return height + 0.02 * length;
}

/* Along the line once, never two neighbours. */
static bool thin_once(swept_line *line, uint32_t points, double most)
{
    bool any = false;
    for (uint32_t v = line->next[0]; v != line->last && line->count > points; v = line->next[v]) {
        if (!line->stays[v] && loss(line, v) < most && swept_remove(line, v)) {
            any = true;
            v = line->next[v];
            if (v == line->last) {
                break;
            }
        }
    }
    return any;
}

static bool split_longest(swept_line *line)
{
    uint32_t longest = 0;
    double most = 0.0;
    for (uint32_t v = 0; v != line->last; v = line->next[v]) {
        double length = vec3_distance(line->x[v], line->x[line->next[v]]);
        longest = length > most ? v : longest;
        most = vbss_max(most, length);
    }
    return swept_split(line, longest);
}

bool swept_thin(swept_line *line, uint32_t segments)
{
    double most = 1e-6;
    while (line->count > segments + 1 && most < 1.0) {
        most *= thin_once(line, segments + 1, most) ? 1.0 : 1.5;
    }
    while (line->count < segments + 1) {
        if (!split_longest(line)) {
            return false;
        }
    }
    return line->count == segments + 1;
}

bool swept_thin_all(swept_line *line)
{
    uint32_t left = 0;
    bool again = true;
    while (again) {
        again = false;
        left = 0;
        for (uint32_t v = line->next[0]; v != line->last; v = line->next[v]) {
            bool gone = swept_remove(line, v);
            again = again || gone;
            left += gone || line->stays[v] ? 0 : 1;
        }
    }
    return left == 0;
}
