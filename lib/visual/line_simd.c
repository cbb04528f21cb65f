/* Points of the spline of a thread and the tangents there, four at a time. */
#include "base/simd_dispatch.h"
#include "visual/vertex_lanes.h"

/* One segment a lane. */
typedef struct segments {
    vlanes start, end, start_second_derivative, end_second_derivative; /* m; 1/m */
    lanes length;                                                      /* at rest, m */
} segments;

static void set_segments(segments *s, const visual_line *line, const uint32_t start[LANES])
{
    const uint32_t end[LANES] = {start[0] + 1, start[1] + 1, start[2] + 1, start[3] + 1};
    const double *l = line->lengths;
    const double length[LANES] = {l[start[0]], l[start[1]], l[start[2]], l[start[3]]};
    s->start = v_gather(line->nodes, start);
    s->end = v_gather(line->nodes, end);
    s->start_second_derivative = v_gather(line->second_derivatives, start);
    s->end_second_derivative = v_gather(line->second_derivatives, end);
    s->length = lanes_load(length);
}

/* At the fractions 0 and 1 this is the node, to the bit. `a` is 1 - b. */
static vlanes spline_point(const segments *s, lanes a, lanes b)
{
    const lanes sixth = lanes_div(lanes_times(s->length, s->length), lanes_splat(6.0));
    const lanes start_share = lanes_sub(lanes_times(lanes_times(a, a), a), a);
    const lanes end_share = lanes_sub(lanes_times(lanes_times(b, b), b), b);
    vlanes x = v_add(v_scale(s->start, a), v_scale(s->end, b));
    x = v_add_scaled(x, lanes_times(start_share, sixth), s->start_second_derivative);
    return v_add_scaled(x, lanes_times(end_share, sixth), s->end_second_derivative);
}

/* Derivative with respect to the rest length. */
static vlanes spline_slope(const segments *s, lanes a, lanes b)
{
    const lanes one = lanes_splat(1.0), sixth = lanes_div(s->length, lanes_splat(6.0));
    const lanes start_share = lanes_sub(one, lanes_times(lanes_scale(3.0, a), a));
    const lanes end_share = lanes_sub(lanes_times(lanes_scale(3.0, b), b), one);
    vlanes slope = v_scale(v_sub(s->end, s->start), lanes_div(one, s->length));
    slope = v_add_scaled(slope, lanes_times(start_share, sixth), s->start_second_derivative);
    return v_add_scaled(slope, lanes_times(end_share, sixth), s->end_second_derivative);
}

void VBSS_WIDE_NAME(vbss_visual_find_line_points)(const visual_line *line, visual_line_points *p)
{
    for (uint32_t i = 0; i < p->count; i += LANES) {
        uint32_t index[LANES], start[LANES];
        double fraction[LANES];
        segments s;
        clamp_indices(i, p->count - 1, index);
        for (int l = 0; l < LANES; l++) {
            start[l] = p->segment[index[l]];
            fraction[l] = p->fraction[index[l]];
        }
        set_segments(&s, line, start);
        const lanes b = lanes_load(fraction), a = lanes_sub(lanes_splat(1.0), b);
        v_scatter(p->centre, index, spline_point(&s, a, b));
        v_scatter(p->tangent, index, v_unit_or(spline_slope(&s, a, b), v_splat(vec3_zero())));
    }
}
