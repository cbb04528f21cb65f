/* What a host shows: checked as a whole, then copied in the order from the tail's end on. */
#include "base/check.h"
#include "base/error.h"
#include "knot/knot.h"

#include <string.h>

static const uint32_t input_sizes[] = {136, 0};
_Static_assert(sizeof(vbss_knot_input) == 136, "published size");
_Static_assert(sizeof(vbss_knot_tool) == 136, "no padding, part of the interface");
static const vbss_knot_input input_defaults = {
    .struct_size = sizeof(vbss_knot_input), .stride_bytes = 24, .hole_places = {-1.0, -1.0}};
static const vbss_layout input_layout = {"vbss_knot_input", &input_defaults, input_sizes};

vbss_result vbss_knot_input_init(vbss_knot_input *input, uint32_t struct_size)
{
    return vbss_config_init(&input_layout, input, struct_size);
}

/* ---- checks */

static vec3 shown_point(const vbss_knot_input *in, uint32_t i)
{
    double x[3];
    memcpy(x, (const unsigned char *)in->points + (size_t)i * in->stride_bytes, sizeof x);
    return vec3_load(x);
}

/* Whether they are all numbers in range, asked at once; which one is not is asked afterwards. */
static bool are_points_sound(const vbss_knot_input *in)
{
    bool sound = true;
    for (uint32_t i = 0; i < in->point_count; i++) {
        vec3 x = shown_point(in, i);
        sound &= fabs(x.x) <= 1e3 && fabs(x.y) <= 1e3 && fabs(x.z) <= 1e3;
    }
    return sound;
}

static vbss_result check_points(vbss_context *context, const vbss_knot_input *in)
{
    VBSS_TRY(vbss_check_pointer(context, in->points, "points"));
    VBSS_TRY(vbss_check_range(context, in->stride_bytes, 24.0, 1e9, "stride_bytes"));
    const bool sound = are_points_sound(in);
    for (uint32_t i = 0; i < in->point_count && !sound; i++) {
        double x[3];
        vec3_store(x, shown_point(in, i));
        VBSS_TRY(vbss_check_finite(context, x, 3, "points"));
        VBSS_TRY(vbss_check_range(context, vbss_largest(x, 3), 0.0, 1e3, "|points|"));
    }
    return VBSS_OK;
}

static vbss_result check_tool(vbss_context *context, const vbss_knot_input *in,
                              const vbss_knot_tool *tool)
{
    VBSS_TRY(
        vbss_check_range(context, tool->point_count, 2.0, KNOT_AXIS_POINTS, "tools[].point_count"));
    VBSS_TRY(vbss_check_range(context, tool->held, VBSS_KNOT_HELD_NOTHING, VBSS_KNOT_HELD_NEEDLE,
                              "tools[].held"));
    for (uint32_t i = 0; i < tool->point_count; i++) {
        VBSS_TRY(vbss_check_finite(context, tool->axis[i], 3, "tools[].axis"));
        VBSS_TRY(
            vbss_check_range(context, vbss_largest(tool->axis[i], 3), 0.0, 1e3, "|tools[].axis|"));
        if (i == 0) {
            continue;
        }
        VBSS_TRY(vbss_check_range(context, tool->radius[i - 1], 0.0, 1.0, "tools[].radius"));
        double length = vec3_distance(vec3_load(tool->axis[i]), vec3_load(tool->axis[i - 1]));
        VBSS_TRY(vbss_check_range(context, length, 1e-9, 1e4, "length of tools[].axis"));
    }
    if (tool->held == VBSS_KNOT_HELD_THREAD) {
        VBSS_TRY(vbss_check_range(context, tool->held_place, 0.0, in->point_count - 1.0,
                                  "tools[].held_place"));
    }
    return VBSS_OK;
}

static vbss_result check_holes(vbss_context *context, const vbss_knot_input *in)
{
    VBSS_TRY(vbss_check_range(context, in->hole_count, 0.0, 2.0, "hole_count"));
    for (uint32_t i = 0; i < in->hole_count; i++) {
        VBSS_TRY(vbss_check_finite(context, &in->hole_places[i], 1, "hole_places"));
        VBSS_TRY(vbss_check_range(context, in->hole_places[i], -1e300, in->point_count - 1.0,
                                  "hole_places"));
        VBSS_TRY(vbss_check_finite(context, in->holes[i], 3, "holes"));
        VBSS_TRY(vbss_check_range(context, vbss_largest(in->holes[i], 3), 0.0, 1e3, "|holes|"));
    }
    return vbss_check_finite(context, in->away, 3, "away");
}

static vbss_result check_counts(const knot_detector *d, const vbss_knot_input *in)
{
    vbss_context *context = d->context;
    if (in->point_count > d->config.point_capacity) {
        return vbss_fail(context, VBSS_ERROR_CAPACITY, "%u points, and room for %u",
                         in->point_count, d->config.point_capacity);
    }
    if (in->tool_count > d->config.tool_capacity) {
        return vbss_fail(context, VBSS_ERROR_CAPACITY, "%u tools, and room for %u", in->tool_count,
                         d->config.tool_capacity);
    }
    VBSS_TRY(vbss_check_range(context, in->point_count, 2.0, 1e9, "point_count"));
    VBSS_TRY(vbss_check_range(context, in->reversed, 0.0, 1.0, "reversed"));
    VBSS_TRY(vbss_check_range(context, in->may_have_passed, 0.0, 1.0, "may_have_passed"));
    VBSS_TRY(vbss_check_range(context, in->reserved, 0.0, 0.0, "reserved"));
    return in->tool_count > 0 ? vbss_check_pointer(context, in->tools, "tools") : VBSS_OK;
}

/* ---- places */

vec3 vbss_knot_point_at(const knot_scene *scene, double place)
{
    double last = scene->point_count - 1.0;
    place = greater(0.0, lesser(place, last));
    uint32_t i = (uint32_t)place;
    if (i + 1 >= scene->point_count) {
        return scene->points[scene->point_count - 1];
    }
    return vec3_lerp(scene->points[i], scene->points[i + 1], place - i);
}

double vbss_knot_length(const knot_scene *scene, double from, double to)
{
    double length = 0.0;
    vec3 last = vbss_knot_point_at(scene, from);
    for (uint32_t i = (uint32_t)greater(0.0, from) + 1; i < scene->point_count && i < to; i++) {
        length += vec3_distance(last, scene->points[i]);
        last = scene->points[i];
    }
    return from < to ? length + vec3_distance(last, vbss_knot_point_at(scene, to)) : 0.0;
}

/* Where a segment of the scene begins in the host's numbers: points that were left out stand before its own, and only
 * the last step to its end has any length. */
static double segment_begin(const knot_scene *scene, uint32_t i)
{
    double end = scene->places[i + 1];
    return end > scene->places[i] ? end - 1.0 : end + 1.0;
}

static double shown_place(const knot_scene *scene, double place)
{
    uint32_t i = (uint32_t)place;
    if (i + 1 >= scene->point_count || place <= i) {
        return scene->places[i + 1 >= scene->point_count ? scene->point_count - 1 : i];
    }
    double begin = segment_begin(scene, i);
    return begin + (place - i) * (scene->places[i + 1] - begin);
}

void vbss_knot_show_places(const knot_scene *scene, const double own[2], double shown[2])
{
    double a = shown_place(scene, own[0]), b = shown_place(scene, own[1]);
    shown[0] = lesser(a, b);
    shown[1] = greater(a, b);
}

/* From the host's numbers, which run the same way after `reversed`, to the scene's own. */
static double own_place(const knot_scene *scene, bool reversed, uint32_t shown, double place)
{
    double wanted = reversed ? shown - 1.0 - place : place;
    uint32_t low = 0, high = scene->point_count - 1;
    while (low + 1 < high) { /* places ascend from the tail's end, counted from there */
        uint32_t middle = (low + high) / 2;
        double at = reversed ? shown - 1.0 - scene->places[middle] : scene->places[middle];
        if (at <= wanted) {
            low = middle;
        } else {
            high = middle;
        }
    }
    if (low == high) {
        return low;
    }
    double part = fabs(place - segment_begin(scene, low));
    bool within = reversed ? place < segment_begin(scene, low) : place > segment_begin(scene, low);
    return within ? low + lesser(part, 1.0) : low;
}

static double nearest_place(const knot_scene *scene, vec3 x)
{
    double best = 0.0, least = vec3_norm_squared(vec3_sub(scene->points[0], x));
    for (uint32_t i = 0; i + 1 < scene->point_count; i++) {
        vec3 along = vec3_sub(scene->points[i + 1], scene->points[i]);
        double squared = vec3_norm_squared(along);
        double t = vec3_dot(vec3_sub(x, scene->points[i]), along);
        t = squared > 0.0 ? greater(0.0, lesser(1.0, t / squared)) : 0.0;
        vec3 at = vec3_add_scaled(scene->points[i], t, along);
        double distance = vec3_norm_squared(vec3_sub(at, x));
        if (distance < least) {
            least = distance;
            best = i + t;
        }
    }
    return best;
}

/* ---- the copy */

static void copy_points(knot_scene *scene, const vbss_knot_input *in)
{
    scene->point_count = 0;
    for (uint32_t i = 0; i < in->point_count; i++) {
        uint32_t from = in->reversed ? in->point_count - 1 - i : i;
        vec3 x = shown_point(in, from);
        const vec3 *last = &scene->points[scene->point_count - (scene->point_count > 0)];
        if (scene->point_count > 0 && x.x == last->x && x.y == last->y && x.z == last->z) {
            continue;
        }
        scene->points[scene->point_count] = x;
        scene->places[scene->point_count] = from;
        scene->point_count++;
    }
}

static void copy_tool(knot_scene *scene, const vbss_knot_input *in, uint32_t number)
{
    const vbss_knot_tool *from = &in->tools[number];
    knot_tool *to = &scene->tools[number];
    *to = (knot_tool){.point_count = from->point_count, .held = from->held};
    for (uint32_t i = 0; i < from->point_count; i++) {
        to->axis[i] = vec3_load(from->axis[i]);
        if (i > 0) {
            to->radius[i - 1] = from->radius[i - 1];
        }
    }
    if (from->held == VBSS_KNOT_HELD_THREAD) {
        to->held_place = own_place(scene, in->reversed, in->point_count, from->held_place);
    } else if (from->held == VBSS_KNOT_HELD_NEEDLE) {
        to->held_place = scene->point_count - 1.0;
    }
}

static void copy_tissue(knot_scene *scene, const vbss_knot_input *in)
{
    scene->has_holes = in->hole_count > 0;
    scene->tissue_place = -1.0;
    scene->away = vec3_zero();
    double sum = 0.0;
    for (uint32_t i = 0; i < in->hole_count; i++) {
        sum += in->hole_places[i] >= 0.0
                   ? own_place(scene, in->reversed, in->point_count, in->hole_places[i])
                   : nearest_place(scene, vec3_load(in->holes[i]));
    }
    if (scene->has_holes) {
        scene->tissue_place = sum / in->hole_count;
        double largest = vbss_largest(in->away, 3);
        if (largest > 0.0) { /* scaled first: its square may be no number */
            vec3 scaled =
                vec3_make(in->away[0] / largest, in->away[1] / largest, in->away[2] / largest);
            scene->away = vec3_unit_or(scaled, vec3_zero());
        }
    }
}

vbss_result vbss_knot_show(const knot_detector *d, const vbss_knot_input *input, knot_scene *scene)
{
    vbss_knot_input in;
    VBSS_TRY(vbss_check_pointer(d->context, input, "input"));
    VBSS_TRY(vbss_config_read(d->context, &input_layout, input, &in));
    VBSS_TRY(check_counts(d, &in));
    VBSS_TRY(check_points(d->context, &in));
    for (uint32_t i = 0; i < in.tool_count; i++) {
        VBSS_TRY(check_tool(d->context, &in, &in.tools[i]));
    }
    VBSS_TRY(check_holes(d->context, &in));

    copy_points(scene, &in);
    scene->tool_count = in.tool_count;
    scene->may_have_passed = in.may_have_passed != 0;
    for (uint32_t i = 0; i < in.tool_count; i++) {
        copy_tool(scene, &in, i);
    }
    copy_tissue(scene, &in);
    return VBSS_OK;
}

void vbss_knot_scene_copy(knot_scene *to, const knot_scene *from)
{
    knot_scene own = *from;
    own.points = to->points;
    own.places = to->places;
    own.tools = to->tools;
    *to = own;
    memcpy(to->points, from->points, from->point_count * sizeof *to->points);
    memcpy(to->places, from->places, from->point_count * sizeof *to->places);
    memcpy(to->tools, from->tools, from->tool_count * sizeof *to->tools);
}
