/* Input of the host: checked completely, then copied in order from the tail's end. */
#include "base/check.h"
#include "base/error.h"
#include "knot/knot.h"

#include <string.h>

static const uint32_t input_sizes[] = {VBSS_SIZE_WITH_POINTERS(vbss_knot_input, 120u, 2u), 0};
_Static_assert(sizeof(vbss_knot_input) == VBSS_SIZE_WITH_POINTERS(vbss_knot_input, 120u, 2u),
               "published size");
_Static_assert(sizeof(vbss_knot_tool) == 136, "no padding, part of the interface");
static const vbss_knot_input input_defaults = {
    .struct_size = sizeof(vbss_knot_input), .stride_bytes = 24, .hole_places = {-1.0, -1.0}};
static const vbss_layout input_layout = {"vbss_knot_input", &input_defaults, input_sizes};

vbss_result vbss_knot_input_init(vbss_knot_input *input, uint32_t struct_size)
{
    return vbss_config_init(&input_layout, input, struct_size);
}

/* ---- checks */

static vec3 host_point(const vbss_knot_input *in, uint32_t i)
{
    double x[3];
    memcpy(x, (const unsigned char *)in->points + (size_t)i * in->stride_bytes, sizeof x);
    return vec3_load(x);
}

/* Whether all coordinates are in range. A failed check is repeated point by point for the error
 * text. */
static bool are_points_sound(const vbss_knot_input *in)
{
    bool sound = true;
    for (uint32_t i = 0; i < in->point_count; i++) {
        vec3 x = host_point(in, i);
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
        vec3_store(x, host_point(in, i));
        VBSS_TRY(vbss_check_finite(context, x, 3, "points"));
        VBSS_TRY(vbss_check_range(context, vbss_max_abs(x, 3), 0.0, 1e3, "|points|"));
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
            vbss_check_range(context, vbss_max_abs(tool->axis[i], 3), 0.0, 1e3, "|tools[].axis|"));
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
        VBSS_TRY(vbss_check_range(context, vbss_max_abs(in->holes[i], 3), 0.0, 1e3, "|holes|"));
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

vec3 vbss_knot_point_at(const knot_input *input, double place)
{
    double last = input->point_count - 1.0;
    place = vbss_max(0.0, vbss_min(place, last));
    uint32_t i = (uint32_t)place;
    if (i + 1 >= input->point_count) {
        return input->points[input->point_count - 1];
    }
    return vec3_lerp(input->points[i], input->points[i + 1], place - i);
}

double vbss_knot_length(const knot_input *input, double from, double to)
{
    double length = 0.0;
    vec3 last = vbss_knot_point_at(input, from);
    for (uint32_t i = (uint32_t)vbss_max(0.0, from) + 1; i < input->point_count && i < to; i++) {
        length += vec3_distance(last, input->points[i]);
        last = input->points[i];
    }
    return from < to ? length + vec3_distance(last, vbss_knot_point_at(input, to)) : 0.0;
}

/* Start of a segment in the host's numbering. Omitted equal points precede its own start, and only
 * the last step to its end has any length. */
static double segment_start(const knot_input *input, uint32_t i)
{
    double end = input->places[i + 1];
    return end > input->places[i] ? end - 1.0 : end + 1.0;
}

static double host_place(const knot_input *input, double place)
{
    uint32_t i = (uint32_t)place;
    if (i + 1 >= input->point_count || place <= i) {
        return input->places[i + 1 >= input->point_count ? input->point_count - 1 : i];
    }
    double start = segment_start(input, i);
    return start + (place - i) * (input->places[i + 1] - start);
}

void vbss_knot_places_to_host(const knot_input *input, const double own[2], double host[2])
{
    double a = host_place(input, own[0]), b = host_place(input, own[1]);
    host[0] = vbss_min(a, b);
    host[1] = vbss_max(a, b);
}

/* Converts a place from the host's numbering to that of the copy. */
static double local_place(const knot_input *input, bool reversed, uint32_t host_count, double place)
{
    double wanted = reversed ? host_count - 1.0 - place : place;
    uint32_t low = 0, high = input->point_count - 1;
    while (low + 1 < high) { /* places ascend when counted from the tail's end */
        uint32_t middle = (low + high) / 2;
        double at = reversed ? host_count - 1.0 - input->places[middle] : input->places[middle];
        if (at <= wanted) {
            low = middle;
        } else {
            high = middle;
        }
    }
    if (low == high) {
        return low;
    }
    double fraction = fabs(place - segment_start(input, low));
    bool within = reversed ? place < segment_start(input, low) : place > segment_start(input, low);
    return within ? low + vbss_min(fraction, 1.0) : low;
}

static double nearest_place(const knot_input *input, vec3 x)
{
    double best = 0.0, min_squared = vec3_norm_squared(vec3_sub(input->points[0], x));
    for (uint32_t i = 0; i + 1 < input->point_count; i++) {
        vec3 along = vec3_sub(input->points[i + 1], input->points[i]);
        double squared = vec3_norm_squared(along);
        double t = vec3_dot(vec3_sub(x, input->points[i]), along);
        t = squared > 0.0 ? vbss_max(0.0, vbss_min(1.0, t / squared)) : 0.0;
        vec3 at = vec3_add_scaled(input->points[i], t, along);
        double distance = vec3_norm_squared(vec3_sub(at, x));
        if (distance < min_squared) {
            min_squared = distance;
            best = i + t;
        }
    }
    return best;
}

/* ---- the copy */

static void copy_points(knot_input *copy, const vbss_knot_input *in)
{
    copy->point_count = 0;
    for (uint32_t i = 0; i < in->point_count; i++) {
        uint32_t from = in->reversed ? in->point_count - 1 - i : i;
        vec3 x = host_point(in, from);
        const vec3 *last = &copy->points[copy->point_count - (copy->point_count > 0)];
        if (copy->point_count > 0 && x.x == last->x && x.y == last->y && x.z == last->z) {
            continue;
        }
        copy->points[copy->point_count] = x;
        copy->places[copy->point_count] = from;
        copy->point_count++;
    }
}

static void copy_tool(knot_input *copy, const vbss_knot_input *in, uint32_t number)
{
    const vbss_knot_tool *from = &in->tools[number];
    knot_tool *to = &copy->tools[number];
    *to = (knot_tool){.point_count = from->point_count, .held = from->held};
    for (uint32_t i = 0; i < from->point_count; i++) {
        to->axis[i] = vec3_load(from->axis[i]);
        if (i > 0) {
            to->radius[i - 1] = from->radius[i - 1];
        }
    }
    if (from->held == VBSS_KNOT_HELD_THREAD) {
        to->held_place = local_place(copy, in->reversed, in->point_count, from->held_place);
    } else if (from->held == VBSS_KNOT_HELD_NEEDLE) {
        to->held_place = copy->point_count - 1.0;
    }
}

static void copy_tissue(knot_input *copy, const vbss_knot_input *in)
{
    copy->has_holes = in->hole_count > 0;
    copy->tissue_place = -1.0;
    copy->away = vec3_zero();
    double sum = 0.0;
    for (uint32_t i = 0; i < in->hole_count; i++) {
        sum += in->hole_places[i] >= 0.0
                   ? local_place(copy, in->reversed, in->point_count, in->hole_places[i])
                   : nearest_place(copy, vec3_load(in->holes[i]));
    }
    if (copy->has_holes) {
        copy->tissue_place = sum / in->hole_count;
        double largest = vbss_max_abs(in->away, 3);
        if (largest > 0.0) { /* scaled first, because its square may overflow or underflow */
            vec3 scaled =
                vec3_make(in->away[0] / largest, in->away[1] / largest, in->away[2] / largest);
            copy->away = vec3_unit_or(scaled, vec3_zero());
        }
    }
}

vbss_result vbss_knot_read_input(const knot_detector *d, const vbss_knot_input *input,
                                 knot_input *copy)
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

    copy_points(copy, &in);
    copy->tool_count = in.tool_count;
    copy->may_have_passed = in.may_have_passed != 0;
    for (uint32_t i = 0; i < in.tool_count; i++) {
        copy_tool(copy, &in, i);
    }
    copy_tissue(copy, &in);
    return VBSS_OK;
}

void vbss_knot_input_copy(knot_input *to, const knot_input *from)
{
    knot_input own = *from;
    own.points = to->points;
    own.places = to->places;
    own.tools = to->tools;
    *to = own;
    memcpy(to->points, from->points, from->point_count * sizeof *to->points);
    memcpy(to->places, from->places, from->point_count * sizeof *to->places);
    memcpy(to->tools, from->tools, from->tool_count * sizeof *to->tools);
}
