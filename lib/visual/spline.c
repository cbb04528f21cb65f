/* The line of a thread: the natural cubic spline through its nodes (de Boor, A Practical Guide to
 * Splines, chapter IV). Its parameter is the rest length. A short segment between long ones thus
 * gets a short interval of the parameter, and the spline moves smoothly with the nodes. */
#include "visual/visual.h"

void vbss_visual_solve_spline(const vec3 *x, const double *lengths, uint32_t node_count,
                              vec3 *second_derivatives, double *ratios)
{
    const uint32_t last = node_count - 1;
    second_derivatives[0] = second_derivatives[last] = vec3_zero();
    ratios[0] = 0.0;
    if (last < 2) {
        return;
    }
    vec3 chord = vec3_scale(vec3_sub(x[1], x[0]), 1.0 / lengths[0]);
    for (uint32_t i = 1; i < last; i++) {
        vec3 next = vec3_scale(vec3_sub(x[i + 1], x[i]), 1.0 / lengths[i]);
        vec3 right = vec3_scale(vec3_sub(next, chord), 6.0);
        double pivot = 2.0 * (lengths[i - 1] + lengths[i]) - lengths[i - 1] * ratios[i - 1];
        ratios[i] = lengths[i] / pivot;
        right = vec3_add_scaled(right, -lengths[i - 1], second_derivatives[i - 1]);
        second_derivatives[i] = vec3_scale(right, 1.0 / pivot);
        chord = next;
    }
    for (uint32_t i = last - 1; i > 0; i--) {
        second_derivatives[i] =
            vec3_add_scaled(second_derivatives[i], -ratios[i], second_derivatives[i + 1]);
    }
}
