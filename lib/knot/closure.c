/* Extensions of a thread's ends to infinity: straight outward, in other directions for comparison,
 * and through the tools that hold them. */
#include "knot/knot.h"
#include "knot/tuning.h"

/* ---- the frame: far distance and outward directions */

static vec3 centroid_of(const knot_input *input)
{
    vec3 sum = vec3_zero();
    double length = 0.0;
    for (uint32_t i = 0; i + 1 < input->point_count; i++) {
        double l = vec3_distance(input->points[i], input->points[i + 1]);
        sum = vec3_add_scaled(sum, l, vec3_lerp(input->points[i], input->points[i + 1], 0.5));
        length += l;
    }
    return length > 0.0 ? vec3_scale(sum, 1.0 / length) : input->points[0];
}

static double bounding_radius(const knot_input *input, vec3 centre)
{
    double reach = 0.0;
    for (uint32_t i = 0; i < input->point_count; i++) {
        reach = vbss_max(reach, vec3_distance(input->points[i], centre));
    }
    for (uint32_t t = 0; t < input->tool_count; t++) {
        for (uint32_t i = 0; i < input->tools[t].point_count; i++) {
            reach = vbss_max(reach, vec3_distance(input->tools[t].axis[i], centre));
        }
    }
    return reach;
}

/* Whether the rest of the thread is behind the plane through an end, normal to a direction. An
 * extension in that direction then hits nothing. */
static bool is_outermost(const knot_input *input, uint32_t end, vec3 out, double scale)
{
    double limit = vec3_dot(input->points[end], out) - 1e-12 * scale;
    for (uint32_t i = 0; i < input->point_count; i++) {
        if (i != end && vec3_dot(input->points[i], out) >= limit) {
            return false;
        }
    }
    return true;
}

/* Sets the other directions, within about 60 degrees of the first one. */
static void set_directions(vec3 out[1 + KNOT_CLOSURES], vec3 first, uint32_t alternative_count,
                           uint32_t from)
{
    out[0] = first;
    for (uint32_t i = 0; i < alternative_count; i++) {
        vec3 aside = vbss_knot_direction(from + 2 * i);
        out[1 + i] = vec3_unit_or(vec3_add_scaled(first, KNOT_DIRECTION_SPREAD, aside), first);
    }
}

/* Moves an outermost direction to the front, if there is one. */
static bool find_outermost(const knot_input *input, uint32_t end, vec3 out[1 + KNOT_CLOSURES],
                           uint32_t alternative_count, double scale)
{
    for (uint32_t i = 0; i <= alternative_count; i++) {
        if (is_outermost(input, end, out[i], scale)) {
            out[0] = out[i];
            return true;
        }
    }
    return false;
}

/* ---- extensions through the tools */

static vec3 nearest_on(vec3 a, vec3 b, vec3 x)
{
    vec3 along = vec3_sub(b, a);
    double t = vec3_dot(vec3_sub(x, a), along) / vec3_norm_squared(along);
    return vec3_add_scaled(a, vbss_max(0.0, vbss_min(1.0, t)), along);
}

/* From the thread to the axis of the jaws, then along it to the handle and beyond. */
static knot_extension extension_through(const knot_input *input, const knot_tool *tool)
{
    vec3 from = vbss_knot_point_at(input, tool->held_place);
    uint32_t last = tool->point_count - 1;
    knot_extension extension = {.count = 1, .points = {from}};
    vec3 jaws = nearest_on(tool->axis[last - 1], tool->axis[last], from);
    if (vec3_distance(jaws, from) > 0.0) {
        extension.points[extension.count++] = jaws;
    }
    for (uint32_t i = last; i-- > 0;) {
        if (vec3_distance(extension.points[extension.count - 1], tool->axis[i]) > 0.0) {
            extension.points[extension.count++] = tool->axis[i];
        }
    }
    extension.direction =
        vec3_unit_or(vec3_sub(tool->axis[0], tool->axis[1]), vec3_make(1.0, 0.0, 0.0));
    return extension;
}

/* Selects the tool that holds each limb closest to its end, within tail_reach. */
static void find_tool_extensions(knot_closure *c, const vbss_knot_detector_config *config,
                                 const knot_input *input)
{
    double last = input->point_count - 1.0;
    double tissue = input->has_holes ? input->tissue_place : 0.5 * last;
    c->tail_hold = c->long_hold = -1.0;
    for (uint32_t t = 0; t < input->tool_count; t++) {
        const knot_tool *tool = &input->tools[t];
        double place = tool->held_place;
        if (tool->held == VBSS_KNOT_HELD_NOTHING) {
            continue;
        }
        if (place < tissue && vbss_knot_length(input, 0.0, place) <= config->tail_reach &&
            (c->tail_hold < 0.0 || place < c->tail_hold)) {
            c->tail_hold = place;
            c->tail_extension = extension_through(input, tool);
        } else if (place > tissue && vbss_knot_length(input, place, last) <= config->tail_reach &&
                   place > c->long_hold) {
            c->long_hold = place;
            c->long_extension = extension_through(input, tool);
        }
    }
}

void vbss_knot_closure_init(knot_closure *c, const vbss_knot_detector_config *config,
                            const knot_input *input)
{
    const uint32_t last = input->point_count - 1;
    vec3 middle = centroid_of(input);
    vec3 knot = input->has_holes ? vbss_knot_point_at(input, input->tissue_place) : middle;
    double reach = vbss_max(bounding_radius(input, middle), 1e-300);
    *c = (knot_closure){.centre = middle,
                        .far_distance = 8.0 * reach,
                        .alternative_count = config->closure_count,
                        .has_tissue = input->has_holes};
    vec3 tail = vec3_unit_or(vec3_sub(input->points[0], knot), vec3_make(-1.0, 0.0, 0.0));
    vec3 end = vec3_unit_or(vec3_sub(input->points[last], knot), vec3_make(1.0, 0.0, 0.0));
    set_directions(c->tail_directions, tail, c->alternative_count, 0);
    set_directions(c->long_directions, end, c->alternative_count, 1);
    bool tail_free = find_outermost(input, 0, c->tail_directions, c->alternative_count, reach);
    bool end_free = find_outermost(input, last, c->long_directions, c->alternative_count, reach);
    c->ends_free = tail_free && end_free;
    if (c->ends_free) {
        c->alternative_count = 0;
    }
    if (vec3_norm_squared(input->away) > 0.0) {
        c->away = input->away;
    } else if (input->has_holes) {
        c->away = vec3_unit_or(vec3_sub(knot, middle), vec3_make(0.0, -1.0, 0.0));
    }
    find_tool_extensions(c, config, input);
}

knot_extension vbss_knot_straight_extension(vec3 from, vec3 out)
{
    return (knot_extension){.count = 1, .points = {from}, .direction = out};
}

/* ---- polygons */

void vbss_knot_polygon_add(knot_polygon *polygon, vec3 x, double place, bool is_fixed)
{
    if (polygon->count > 0) {
        vec3 last = polygon->x[polygon->count - 1];
        if (last.x == x.x && last.y == x.y && last.z == x.z) {
            polygon->is_fixed[polygon->count - 1] |= is_fixed;
            return;
        }
    }
    polygon->x[polygon->count] = x;
    polygon->place[polygon->count] = place;
    polygon->is_fixed[polygon->count] = is_fixed;
    polygon->count++;
}

void vbss_knot_polygon_add_thread(knot_polygon *polygon, const knot_input *input, double from,
                                  double to)
{
    vbss_knot_polygon_add(polygon, vbss_knot_point_at(input, from), from, false);
    for (uint32_t i = (uint32_t)from + 1; i < input->point_count && i < to; i++) {
        vbss_knot_polygon_add(polygon, input->points[i], i, false);
    }
    vbss_knot_polygon_add(polygon, vbss_knot_point_at(input, to), to, false);
}

static vec3 far_point(const knot_closure *c, const knot_extension *extension)
{
    return vec3_add_scaled(extension->points[extension->count - 1], c->far_distance,
                           extension->direction);
}

void vbss_knot_close_begin(const knot_closure *c, knot_polygon *polygon, const knot_extension *tail)
{
    polygon->count = 0;
    polygon->closed = true;
    vbss_knot_polygon_add(polygon, far_point(c, tail), -1.0, false);
    for (uint32_t i = tail->count; i-- > 1;) {
        vbss_knot_polygon_add(polygon, tail->points[i], -1.0, false);
    }
}

/* Connects two far points with at most a quarter turn between successive points, so that the path
 * stays far from the thread. */
void vbss_knot_close_end(const knot_closure *c, knot_polygon *polygon, const knot_extension *tail,
                         const knot_extension *end)
{
    for (uint32_t i = 1; i < end->count; i++) {
        vbss_knot_polygon_add(polygon, end->points[i], -1.0, false);
    }
    vbss_knot_polygon_add(polygon, far_point(c, end), -1.0, false);
    vec3 between = vec3_add(tail->direction, end->direction);
    if (vec3_dot(tail->direction, end->direction) < 0.0) {
        if (vec3_norm_squared(between) < KNOT_OPPOSITE_SQUARED) {
            between = vec3_any_normal(tail->direction);
        }
        between = vec3_unit_or(between, vec3_any_normal(tail->direction));
        vbss_knot_polygon_add(
            polygon, vec3_add_scaled(c->centre, KNOT_FAR_DETOUR_RATIO * c->far_distance, between),
            -1.0, false);
    }
}
