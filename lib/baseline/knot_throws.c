/* Method PROJECTION, criterion 2: a segment that crosses the plane P inside loops that close around
 * a tool (Qi et al. 2017, section 5). docs/explanation/paper-knots.md lists the points that the paper leaves
 * open, and the reasons for the choices here. */
#include "baseline/knots.h"

/* Crossing of a segment and the plane P. */
typedef struct crossing {
    uint32_t segment;
    vec3 at;
    plane_point flat;
    bool rising; /* whether the thread crosses toward the handle */
} crossing;

/* Returns the strand of the loop's pair that the crossing belongs to: 0 before the loop, on the
 * side of the first segment; 1 after the loop; -1 within it. */
static int strand_of(const baseline_loop *loop, const knot_input *scene, const crossing *c)
{
    if (c->segment < loop->first || c->segment > loop->last) {
        return c->segment < loop->first ? 0 : 1;
    }
    if (c->segment != loop->first && c->segment != loop->last) {
        return -1;
    }
    int end = c->segment == loop->first ? 0 : 1;
    vec3 begin = scene->points[c->segment];
    bool before = vec3_norm_squared(vec3_sub(c->at, begin)) <
                  vec3_norm_squared(vec3_sub(loop->meeting[end], begin));
    return before == (end == 0) ? end : -1;
}

typedef struct crossing_result {
    bool inside, ties, inside_out;
} crossing_result;

static crossing_result judge(baseline_loops *p, const projection_plane *plane,
                             const knot_input *scene, const baseline_loop *loop, const crossing *c)
{
    crossing_result v = {false, false, false};
    int strand = strand_of(loop, scene, c);
    if (strand < 0) {
        return v;
    }
    plane_point meeting = vbss_baseline_project_point(plane, loop->meeting[0]);
    v.inside = vbss_baseline_is_inside_loop(p, meeting, loop->first, loop->last, c->flat);
    /* Each strand is followed away from the loop, toward its own end. */
    v.inside_out = strand == 0 ? !c->rising : c->rising;
    bool above = loop->first_is_above == (strand == 0);
    v.ties = v.inside && above == v.inside_out;
    return v;
}

/* Counts the loops of a tool that a crossing ties. */
static void count(baseline_loops *p, const projection_plane *plane, const knot_input *scene,
                  uint32_t tool, const crossing *c, baseline_throw *found)
{
    baseline_throw here = {.segment = c->segment};
    for (uint32_t k = 0; k < p->loop_count; k++) {
        const baseline_loop *loop = &p->loops[k];
        if (loop->tool != tool || loop->inside == 0) {
            continue;
        }
        crossing_result v = judge(p, plane, scene, loop, c);
        if (v.ties && here.loops == 0) {
            here.first_is_above = loop->first_is_above;
            here.inside_out = v.inside_out;
        }
        here.loops += v.ties ? 1 : 0;
        found->undone += v.inside && !v.ties ? 1 : 0;
    }
    if (here.loops > found->loops) {
        here.undone = found->undone;
        *found = here;
    }
}

baseline_throw vbss_baseline_find_throws(baseline_loops *p, const vbss_knot_detector_config *config,
                                         const knot_input *scene, uint32_t tool)
{
    baseline_throw found = {0};
    projection_plane plane = vbss_baseline_projection_plane(config, &scene->tools[tool]);
    vbss_baseline_project_thread(p, &plane, scene);
    const double *heights = projected_heights(p);
    for (uint32_t k = 0; k + 1 < scene->point_count; k++) {
        double a = heights[k], b = heights[k + 1];
        if ((a < 0.0) == (b < 0.0)) {
            continue;
        }
        crossing c = {.segment = k, .rising = a < 0.0};
        c.at = vec3_lerp(scene->points[k], scene->points[k + 1], a / (a - b));
        c.flat = vbss_baseline_project_point(&plane, c.at);
        count(p, &plane, scene, tool, &c, &found);
    }
    return found;
}
