/* Slip of a throw: whether both limbs bend alike, or one is wound around the other, straight
 * one. */
#include "base/elementary.h"
#include "knot/knot.h"

/* Total turning between two places, rad. The angle at a point is spread evenly over half a segment on
 * either side of it: counted at the point, a place that moves by a segment would change the turning of
 * a tight throw, which has only a few points, by a third of a turn. */
static double turning(const knot_input *input, const double places[2])
{
    double from = vbss_max(vbss_min(places[0], places[1]), 0.0);
    double to = vbss_min(vbss_max(places[0], places[1]), (double)(input->point_count - 1));
    double sum = 0.0;
    if (!(from < to)) {
        return 0.0;
    }
    for (uint32_t i = from < 0.5 ? 1 : (uint32_t)(from + 0.5);
         i + 1 < input->point_count && i - 0.5 < to; i++) {
        vec3 before = vec3_sub(input->points[i], input->points[i - 1]);
        vec3 after = vec3_sub(input->points[i + 1], input->points[i]);
        double share = vbss_min(to, i + 0.5) - vbss_max(from, i - 0.5);
        sum +=
            share * vbss_arc_tangent(vec3_norm(vec3_cross(before, after)), vec3_dot(before, after));
    }
    return sum;
}

double vbss_knot_slip(const knot_input *input, const double tail_places[2],
                      const double long_places[2])
{
    double tail = turning(input, tail_places), longer = turning(input, long_places);
    double both = tail + longer;
    return both > 0.0 ? (tail - longer) / both : 0.0;
}
