/* Slip of a throw: whether both limbs bend alike, or one is wound around the other, straight
 * one. */
#include "base/elementary.h"
#include "knot/knot.h"

/* Sum of the angles between successive segments whose common point is between two places, rad. */
static double turning(const knot_input *input, const double places[2])
{
    double from = vbss_max(vbss_min(places[0], places[1]), 0.0);
    double to = vbss_min(vbss_max(places[0], places[1]), (double)(input->point_count - 1));
    double sum = 0.0;
    if (!(from < to)) {
        return 0.0;
    }
    for (uint32_t i = (uint32_t)from + 1; i < to; i++) {
        vec3 before = vec3_sub(input->points[i], input->points[i - 1]);
        vec3 after = vec3_sub(input->points[i + 1], input->points[i]);
        sum += vbss_arc_tangent(vec3_norm(vec3_cross(before, after)), vec3_dot(before, after));
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
