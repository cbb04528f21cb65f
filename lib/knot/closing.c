/* How the ends of a thread are continued to infinity: straight outward, in other directions to compare with,
 * and through the tools that hold them. */
#include "knot/knot.h"

/* ---- the frame: where far is, and what is outward */

static vec3 middle_of(const knot_scene *scene)
{
    vec3 sum = vec3_zero();
    double length = 0.0;
    for (uint32_t i = 0; i + 1 < scene->point_count; i++) {
        double l = vec3_distance(scene->points[i], scene->points[i + 1]);
        sum = vec3_add_scaled(sum, l, vec3_lerp(scene->points[i], scene->points[i + 1], 0.5));
        length += l;
    }
    return length > 0.0 ? vec3_scale(sum, 1.0 / length) : scene->points[0];
}

static double reach_from(const knot_scene *scene, vec3 centre)
{
    double reach = 0.0;
    for (uint32_t i = 0; i < scene->point_count; i++) {
        reach = greater(reach, vec3_distance(scene->points[i], centre));
    }
    for (uint32_t t = 0; t < scene->tool_count; t++) {
        for (uint32_t i = 0; i < scene->tools[t].point_count; i++) {
            reach = greater(reach, vec3_distance(scene->tools[t].axis[i], centre));
        }
    }
    return reach;
}

/* Whether all the rest of the thread lies behind the plane through an end across a direction: then going on in that
 * direction meets nothing, whatever the rest does. */
static bool is_outermost(const knot_scene *scene, uint32_t end, vec3 out, double scale)
{
    double most = vec3_dot(scene->points[end], out) - 1e-12 * scale;
    for (uint32_t i = 0; i < scene->point_count; i++) {
        if (i != end && vec3_dot(scene->points[i], out) >= most) {
            return false;
        }
    }
    return true;
}

/* Other directions lie about the outward one, within some 60 degrees. */
static void set_directions(vec3 out[1 + KNOT_CLOSURES], vec3 first, uint32_t others, uint32_t from)
{
    out[0] = first;
    for (uint32_t i = 0; i < others; i++) {
        vec3 aside = vbss_knot_direction(from + 2 * i);
        out[1 + i] = vec3_unit_or(vec3_add_scaled(first, 0.87, aside), first);
    }
}

/* Puts an outermost direction first, if there is one. */
static bool find_outermost(const knot_scene *scene, uint32_t end, vec3 out[1 + KNOT_CLOSURES],
                           uint32_t others, double scale)
{
    for (uint32_t i = 0; i <= others; i++) {
        if (is_outermost(scene, end, out[i], scale)) {
            out[0] = out[i];
            return true;
        }
    }
    return false;
}

/* ---- through the tools */

static vec3 nearest_on(vec3 a, vec3 b, vec3 x)
{
    vec3 along = vec3_sub(b, a);
    double t = vec3_dot(vec3_sub(x, a), along) / vec3_norm_squared(along);
    return vec3_add_scaled(a, greater(0.0, lesser(1.0, t)), along);
}

/* From the thread to the jaws' axis, along it to the handle and beyond. */
static knot_way way_through(const knot_scene *scene, const knot_tool *tool)
{
    vec3 from = vbss_knot_point_at(scene, tool->held_place);
    uint32_t last = tool->point_count - 1;
    knot_way way = {.count = 1, .points = {from}};
    vec3 jaws = nearest_on(tool->axis[last - 1], tool->axis[last], from);
    if (vec3_distance(jaws, from) > 0.0) {
        way.points[way.count++] = jaws;
    }
    for (uint32_t i = last; i-- > 0;) {
        if (vec3_distance(way.points[way.count - 1], tool->axis[i]) > 0.0) {
            way.points[way.count++] = tool->axis[i];
        }
    }
    way.out = vec3_unit_or(vec3_sub(tool->axis[0], tool->axis[1]), vec3_make(1.0, 0.0, 0.0));
    return way;
}

/* The tool that holds nearest to an end, if not too far from it. */
static void find_ways(knot_closing *c, const vbss_knot_config *config, const knot_scene *scene)
{
    double last = scene->point_count - 1.0;
    double tissue = scene->has_holes ? scene->tissue_place : 0.5 * last;
    c->tail_hold = c->long_hold = -1.0;
    for (uint32_t t = 0; t < scene->tool_count; t++) {
        const knot_tool *tool = &scene->tools[t];
        double place = tool->held_place;
        if (tool->held == VBSS_KNOT_HELD_NOTHING) {
            continue;
        }
        if (place < tissue && vbss_knot_length(scene, 0.0, place) <= config->tail_reach &&
            (c->tail_hold < 0.0 || place < c->tail_hold)) {
            c->tail_hold = place;
            c->tail_way = way_through(scene, tool);
        } else if (place > tissue && vbss_knot_length(scene, place, last) <= config->tail_reach &&
                   place > c->long_hold) {
            c->long_hold = place;
            c->long_way = way_through(scene, tool);
        }
    }
}

void vbss_knot_closing_of(knot_closing *c, const vbss_knot_config *config, const knot_scene *scene)
{
    const uint32_t last = scene->point_count - 1;
    vec3 middle = middle_of(scene);
    vec3 knot = scene->has_holes ? vbss_knot_point_at(scene, scene->tissue_place) : middle;
    double reach = greater(reach_from(scene, middle), 1e-300);
    *c = (knot_closing){.centre = middle,
                        .far = 8.0 * reach,
                        .others = config->closure_count,
                        .has_tissue = scene->has_holes};
    vec3 tail = vec3_unit_or(vec3_sub(scene->points[0], knot), vec3_make(-1.0, 0.0, 0.0));
    vec3 end = vec3_unit_or(vec3_sub(scene->points[last], knot), vec3_make(1.0, 0.0, 0.0));
    set_directions(c->tail_out, tail, c->others, 0);
    set_directions(c->long_out, end, c->others, 1);
    bool tail_free = find_outermost(scene, 0, c->tail_out, c->others, reach);
    bool end_free = find_outermost(scene, last, c->long_out, c->others, reach);
    c->ends_free = tail_free && end_free;
    if (c->ends_free) {
        c->others = 0;
    }
    if (vec3_norm_squared(scene->away) > 0.0) {
        c->away = scene->away;
    } else if (scene->has_holes) {
        c->away = vec3_unit_or(vec3_sub(knot, middle), vec3_make(0.0, -1.0, 0.0));
    }
    find_ways(c, config, scene);
}

knot_way vbss_knot_way_out(vec3 from, vec3 out)
{
    return (knot_way){.count = 1, .points = {from}, .out = out};
}

/* ---- polygons */

void vbss_knot_polygon_add(knot_polygon *polygon, vec3 x, double place, bool stays)
{
    if (polygon->count > 0) {
        vec3 last = polygon->x[polygon->count - 1];
        if (last.x == x.x && last.y == x.y && last.z == x.z) {
            polygon->stays[polygon->count - 1] |= stays;
            return;
        }
    }
    polygon->x[polygon->count] = x;
    polygon->place[polygon->count] = place;
    polygon->stays[polygon->count] = stays;
    polygon->count++;
}

void vbss_knot_polygon_add_thread(knot_polygon *polygon, const knot_scene *scene, double from,
                                  double to)
{
    vbss_knot_polygon_add(polygon, vbss_knot_point_at(scene, from), from, false);
    for (uint32_t i = (uint32_t)from + 1; i < scene->point_count && i < to; i++) {
        vbss_knot_polygon_add(polygon, scene->points[i], i, false);
    }
    vbss_knot_polygon_add(polygon, vbss_knot_point_at(scene, to), to, false);
}

static vec3 far_point(const knot_closing *c, const knot_way *way)
{
    return vec3_add_scaled(way->points[way->count - 1], c->far, way->out);
}

void vbss_knot_close_begin(const knot_closing *c, knot_polygon *polygon, const knot_way *tail)
{
    polygon->count = 0;
    polygon->closed = true;
    vbss_knot_polygon_add(polygon, far_point(c, tail), -1.0, false);
    for (uint32_t i = tail->count; i-- > 1;) {
        vbss_knot_polygon_add(polygon, tail->points[i], -1.0, false);
    }
}

/* Between two far points the way leads round: at most a quarter turn between one and the next, so that it stays far
 * from the thread. */
void vbss_knot_close_end(const knot_closing *c, knot_polygon *polygon, const knot_way *tail,
                         const knot_way *end)
{
    for (uint32_t i = 1; i < end->count; i++) {
        vbss_knot_polygon_add(polygon, end->points[i], -1.0, false);
    }
    vbss_knot_polygon_add(polygon, far_point(c, end), -1.0, false);
    vec3 between = vec3_add(tail->out, end->out);
    if (vec3_dot(tail->out, end->out) < 0.0) {
        if (vec3_norm_squared(between) < 1e-6) {
            between = vec3_any_normal(tail->out);
        }
        between = vec3_unit_or(between, vec3_any_normal(tail->out));
        vbss_knot_polygon_add(polygon, vec3_add_scaled(c->centre, 1.5 * c->far, between), -1.0,
                              false);
    }
}
