/* Winding of the thread about a tool.
 *
 * Planes across the axis bound one cell for each capsule: normal sections at both ends, and
 * bisecting planes at joints. In a cell a point has two coordinates across the axis. A rotation
 * without twist takes those of one cell to those of the next, and both agree on the plane between.
 * A *run* of thread through cells is therefore one flat polygon, and its turns are those about the
 * origin. They are counted where it crosses the half-line y = 0, x < 0; only the ends of a run need
 * angles.
 *
 * By definition, thread through the axis itself passes it on the side x > 0. The strand in a tool's
 * own jaws does that, so it is omitted and ends a run: all thread about held_place that stays
 * within the capsules, where no other thread can be. Held thread outside the capsules has a
 * definite side, and counts.
 *
 * `sense` compares the points where a quarter and three quarters of the turns are complete, because
 * the ends of a run only lead to and from the winding. */
#include "knot/knot.h"

#include "base/compiler.h"
#include "base/elementary.h"
#include "base/lanes.h"
#include "base/pi.h"
#include "knot/tuning.h"

enum { PIECES = KNOT_AXIS_POINTS - 1 };
_Static_assert(KNOT_AXIS_POINTS == (int)LANES, "a lane for each plane");

/* Coordinates across the axis, right-handed about the direction from tip to handle. */
typedef struct chart {
    vec3 e1, e2;
    double offset1, offset2;
} chart;

typedef struct winding_tracer {
    const knot_input *input;
    vec3 tip;
    uint32_t pieces;
    lanes nx, ny, nz, offset; /* plane k is above piece k and below piece k - 1 */
    chart charts[PIECES];
    vec3 ups[PIECES]; /* unit vectors toward the handle */
    /* lengths of the pieces, and distances along the axis from the tip to each piece, m */
    double lengths[PIECES], bases[PIECES];
    knot_winding *winding;
    /* The current run, and its last point so far. */
    bool open;
    uint32_t piece, first_piece;
    int32_t crossings;
    double x, y, place, first_angle, first_place;
    /* The run with the most turns. */
    double max_run_angle;
    uint32_t max_run_pieces[2];
    /* Target of a search: the first or last point where `crossings` steps away from zero to this
     * value. 0 for no search. */
    int32_t wanted;
    bool wants_last, found, ended;
    double found_place;
    uint32_t found_piece;
} winding_tracer;

/* ---- the tool */

static void set_plane(double rows[4][LANES], uint32_t k, vec3 normal, vec3 at)
{
    rows[0][k] = normal.x;
    rows[1][k] = normal.y;
    rows[2][k] = normal.z;
    rows[3][k] = -vec3_dot(normal, at);
}

static void set_chart(chart *c, vec3 e1, vec3 up, vec3 at)
{
    c->e1 = vec3_unit_or(vec3_add_scaled(e1, -vec3_dot(e1, up), up), vec3_any_normal(up));
    c->e2 = vec3_cross(up, c->e1);
    c->offset1 = -vec3_dot(c->e1, at);
    c->offset2 = -vec3_dot(c->e2, at);
}

static void set_up(winding_tracer *w, const knot_input *input, const knot_tool *tool)
{
    double rows[4][LANES] = {{0.0}, {0.0}, {0.0}, {0.0}};
    uint32_t n = tool->point_count - 1;
    w->input = input;
    w->pieces = n;
    w->tip = tool->axis[n];
    vec3 up = vec3_make(0.0, 0.0, 1.0), e1 = vec3_any_normal(up);
    double base = 0.0;
    for (uint32_t c = n; c-- > 0;) {
        vec3 under = vec3_sub(tool->axis[c + 1], w->tip);
        vec3 piece = vec3_sub(tool->axis[c], tool->axis[c + 1]);
        vec3 below = up;
        up = vec3_unit_or(piece, below);
        w->ups[c] = up;
        w->lengths[c] = vec3_norm(piece);
        w->bases[c] = base;
        base += w->lengths[c];
        e1 = c + 1 == n ? vec3_any_normal(up) : quat_rotate(quat_between(below, up), e1);
        set_chart(&w->charts[c], e1, up, under);
        /* Heights are lengths along the axis. A folded tool has no bisecting plane. */
        double straight = 1.0 + vec3_dot(below, up);
        bool end = c + 1 == n || straight < KNOT_MIN_FOLD_COSINE;
        set_plane(rows, c + 1, end ? up : vec3_scale(vec3_add(below, up), 1.0 / straight), under);
    }
    set_plane(rows, 0, up, vec3_sub(tool->axis[0], w->tip));
    w->nx = lanes_load(rows[0]);
    w->ny = lanes_load(rows[1]);
    w->nz = lanes_load(rows[2]);
    w->offset = lanes_load(rows[3]);
}

/* Rotates all charts so that the half-line for counting turns is at this angle of the present
 * charts. */
static void spin(winding_tracer *w, double angle)
{
    double s, c;
    vbss_sincos(angle, &s, &c);
    for (uint32_t k = 0; k < w->pieces; k++) {
        chart *to = &w->charts[k], from = *to;
        to->e1 = vec3_neg(vec3_add_scaled(vec3_scale(from.e1, c), s, from.e2));
        to->e2 = vec3_add_scaled(vec3_scale(from.e1, s), -c, from.e2);
        to->offset1 = -(c * from.offset1 + s * from.offset2);
        to->offset2 = s * from.offset1 - c * from.offset2;
    }
    w->max_run_angle -= angle - 0.5 * VBSS_TWO_PI;
}

/* ---- points */

/* Heights of a point, relative to the tip, above each plane. */
VBSS_ALWAYS_INLINE lanes heights_over(const winding_tracer *w, vec3 x)
{
    lanes h = lanes_add(lanes_scale(x.x, w->nx), lanes_scale(x.y, w->ny));
    return lanes_add(lanes_add(h, lanes_scale(x.z, w->nz)), w->offset);
}

/* Bit k is set if the point is on or above plane k. */
VBSS_ALWAYS_INLINE uint32_t sides(lanes heights)
{
    return ~lanes_movemask(lanes_less(heights, lanes_splat(0.0)));
}

/* Point at a place, relative to the tip. */
static vec3 point_at(const winding_tracer *w, double place)
{
    uint32_t i = (uint32_t)place, last = w->input->point_count - 2;
    i = i < last ? i : last;
    vec3 x = vec3_lerp(w->input->points[i], w->input->points[i + 1], place - (double)i);
    return vec3_sub(x, w->tip);
}

/* Distance along the axis from the tip to a place in the cell of a piece, from its distances to
 * both planes. */
static double height_at(const winding_tracer *w, double place, uint32_t piece)
{
    lanes heights = heights_over(w, point_at(w, place));
    double over = vbss_max(lanes_at(heights, (int)piece + 1), 0.0);
    double under = vbss_max(-lanes_at(heights, (int)piece), 0.0);
    double fraction = over + under > 0.0 ? over / (over + under) : 0.0;
    return w->bases[piece] + w->lengths[piece] * fraction;
}

/* ---- runs */

static void begin_run(winding_tracer *w, uint32_t piece, vec3 x, double place)
{
    const chart *c = &w->charts[piece];
    w->open = true;
    w->piece = w->first_piece = piece;
    w->place = w->first_place = place;
    w->crossings = 0;
    w->x = vec3_dot(c->e1, x) + c->offset1;
    w->y = vec3_dot(c->e2, x) + c->offset2;
    w->first_angle = vbss_arc_tangent(w->y + 0.0, w->x + 0.0); /* 0 on the axis itself */
}

static void end_run(winding_tracer *w)
{
    if (!w->open) {
        return;
    }
    w->open = false;
    if (w->wanted != 0) {
        return;
    }
    double angle = vbss_arc_tangent(w->y + 0.0, w->x + 0.0) - w->first_angle;
    double turns = angle / VBSS_TWO_PI + (double)w->crossings;
    knot_winding *winding = w->winding;
    winding->turns += turns;
    if (winding->runs == 0 || fabs(turns) > fabs(winding->run_turns)) {
        winding->run_turns = turns;
        winding->run_places[0] = w->first_place;
        winding->run_places[1] = w->place;
        w->max_run_angle = w->first_angle;
        w->max_run_pieces[0] = w->first_piece;
        w->max_run_pieces[1] = w->piece;
    }
    winding->runs++;
}

VBSS_NEVER_INLINE void record_target_crossing(winding_tracer *w, double y, double place,
                                              int32_t step)
{
    bool outward = (w->wanted > 0) == (step > 0);
    if (outward && w->crossings == w->wanted) {
        w->found = true;
        w->ended = !w->wants_last;
        w->found_place = w->place + w->y / (w->y - y) * (place - w->place);
        w->found_piece = w->piece;
    }
}

/* Appends a point of a run, in the cell of the last point or on its border. */
VBSS_ALWAYS_INLINE void append_point(winding_tracer *w, vec3 point, double place)
{
    const chart *c = &w->charts[w->piece];
    double x = vec3_dot(c->e1, point) + c->offset1, y = vec3_dot(c->e2, point) + c->offset2;
    if ((y < 0.0) != (w->y < 0.0)) {
        double across = w->x * y - w->y * x;
        int32_t step = y < 0.0 ? across > 0.0 : -(across < 0.0);
        w->crossings += step;
        if (w->wanted != 0 && step != 0) {
            record_target_crossing(w, y, place, step);
        }
    }
    w->x = x;
    w->y = y;
    w->place = place;
}

/* Clips a segment to the cell of a piece; it must not be completely beyond one plane. The range is
 * empty if its end is before its start. Adjacent cells share the same fraction to the bit. */
static void clip(lanes a, lanes b, uint32_t piece, double range[2])
{
    range[0] = 0.0;
    range[1] = 1.0;
    for (uint32_t k = piece; k <= piece + 1; k++) {
        double ha = lanes_at(a, (int)k), hb = lanes_at(b, (int)k);
        if ((ha < 0.0) != (hb < 0.0)) {
            double t = ha / (ha - hb);
            bool enters = (hb < 0.0) == (k == piece);
            range[0] = enters ? vbss_max(range[0], t) : range[0];
            range[1] = enters ? range[1] : vbss_min(range[1], t);
        }
    }
}

/* Handles a segment between two places that may touch the cells in the mask `touched`. */
VBSS_NEVER_INLINE void cross_planes(winding_tracer *w, vec3 a, vec3 b, double from, double to,
                                    uint32_t touched)
{
    lanes heights_a = heights_over(w, a), heights_b = heights_over(w, b);
    double reached = 0.0;
    while (touched != 0) {
        double range[2] = {2.0, 2.0}, other[2];
        uint32_t piece = 0;
        for (uint32_t c = 0; c < w->pieces; c++) {
            clip(heights_a, heights_b, c, other);
            if ((touched >> c & 1u) != 0 && other[0] < range[0]) {
                range[0] = other[0];
                range[1] = other[1];
                piece = c;
            }
        }
        touched &= ~(1u << piece);
        /* Where cells overlap, far from a bent tool, the one entered first counts. */
        double start = vbss_max(range[0], reached), end = range[1];
        if (start >= end) {
            continue;
        }
        double start_place = from + start * (to - from);
        bool next = piece == w->piece || piece + 1 == w->piece || piece == w->piece + 1;
        if (w->open && w->place == start_place && next) {
            w->piece = piece;
        } else {
            end_run(w);
            begin_run(w, piece, vec3_lerp(a, b, start), start_place);
        }
        append_point(w, vec3_lerp(a, b, end), end < 1.0 ? from + end * (to - from) : to);
        reached = end;
    }
}

/* Traces all runs between two places. */
static void trace(winding_tracer *w, double from, double to)
{
    uint32_t pieces = (1u << w->pieces) - 1u, i = (uint32_t)from;
    vec3 a = point_at(w, from);
    uint32_t over_a = sides(heights_over(w, a));
    while (from < to && !w->ended) {
        i++;
        double next = vbss_min((double)i, to);
        vec3 b = (double)i <= to ? vec3_sub(w->input->points[i], w->tip) : point_at(w, to);
        uint32_t over_b = sides(heights_over(w, b)), both = over_a & over_b, any = over_a | over_b;
        uint32_t inside = ~any & both >> 1 & pieces, touched = ~both & any >> 1 & pieces;
        if (w->open && w->place == from && (inside >> w->piece & 1u) != 0) {
            append_point(w, b, next);
        } else if (touched != 0) {
            cross_planes(w, a, b, from, next, touched);
        }
        a = b;
        over_a = over_b;
        from = next;
    }
    end_run(w);
}

/* ---- the strand in the jaws */

/* Range where a t^2 + 2 b t + c <= 0, if there is one; [0, 1] if it holds everywhere. */
static bool solve_quadratic(double a, double b, double c, double range[2])
{
    bool moves = a > 1e-100;
    double d = b * b - a * c, root = sqrt(vbss_max(d, 0.0));
    range[0] = moves ? (-b - root) / a : 0.0;
    range[1] = moves ? (-b + root) / a : 1.0;
    return moves ? d >= 0.0 : c <= 0.0;
}

static bool intersect_sphere(vec3 centre, double radius, vec3 x, vec3 direction, double range[2])
{
    vec3 m = vec3_sub(x, centre);
    return solve_quadratic(vec3_dot(direction, direction), vec3_dot(m, direction),
                           vec3_dot(m, m) - radius * radius, range);
}

static bool intersect_cylinder(const winding_tracer *w, uint32_t c, vec3 lower, double radius,
                               vec3 x, vec3 direction, double range[2])
{
    vec3 m = vec3_sub(x, lower), up = w->ups[c];
    double height = vec3_dot(m, up), rise = vec3_dot(direction, up), slab[2];
    double half = 0.5 * w->lengths[c], off = height - half;
    bool beside = solve_quadratic(rise * rise, rise * off, off * off - half * half, slab);
    vec3 flat_m = vec3_add_scaled(m, -height, up),
         flat_direction = vec3_add_scaled(direction, -rise, up);
    bool near =
        solve_quadratic(vec3_dot(flat_direction, flat_direction), vec3_dot(flat_m, flat_direction),
                        vec3_dot(flat_m, flat_m) - radius * radius, range);
    range[0] = vbss_max(range[0], slab[0]);
    range[1] = vbss_min(range[1], slab[1]);
    return beside && near;
}

/* Fraction of the segment from x on that stays within the capsules; 0 if x is outside all of
 * them. */
static double stays_within(const winding_tracer *w, const knot_tool *tool, vec3 x, vec3 direction)
{
    double reached = 0.0, before, range[2];
    do { /* continue from the capsule that ends to one entered before */
        before = reached;
        for (uint32_t c = 0; c < w->pieces; c++) {
            vec3 upper = vec3_sub(tool->axis[c], w->tip),
                 lower = vec3_sub(tool->axis[c + 1], w->tip);
            for (int k = 0; k < 3; k++) {
                double r = tool->radius[c];
                bool hit = k == 2
                               ? intersect_cylinder(w, c, lower, r, x, direction, range)
                               : intersect_sphere(k == 0 ? upper : lower, r, x, direction, range);
                if (hit && range[0] <= reached && range[1] > reached) {
                    reached = range[1];
                }
            }
        }
    } while (reached > before && reached < 1.0);
    return reached;
}

/* Place where the thread about a held place leaves the capsules, in one direction. */
static double leave_jaws(const winding_tracer *w, const knot_tool *tool, double place, bool forward)
{
    double last = (double)(w->input->point_count - 1), end = forward ? last : 0.0;
    while (place != end) {
        double next = forward ? floor(place) + 1.0 : -floor(-place) - 1.0;
        vec3 x = point_at(w, place);
        double fraction = stays_within(w, tool, x, vec3_sub(point_at(w, next), x));
        if (fraction < 1.0) {
            return place + fraction * (next - place);
        }
        place = next;
    }
    return end;
}

/* ---- sense of the winding */

/* Finds the point of the run where this fraction of its turns is complete, for the first or the
 * last time. */
static bool find_turn_fraction(winding_tracer *w, double fraction, bool last)
{
    const knot_winding *winding = w->winding;
    double turns = fraction * fabs(winding->run_turns),
           sign = winding->run_turns < 0.0 ? -1.0 : 1.0;
    if (fabs(turns - floor(turns + 0.5)) < KNOT_TURN_ROUNDING) {
        turns -= 2.0 * KNOT_TURN_ROUNDING; /* so that the run does not start on the half-line */
    }
    spin(w, w->max_run_angle + sign * turns * VBSS_TWO_PI);
    w->wanted = (int32_t)sign * (1 + (int32_t)floor(turns));
    w->wants_last = last;
    w->found = false;
    trace(w, winding->run_places[0], winding->run_places[1]);
    w->ended = false;
    return w->found;
}

/* Usually the long limb winds: the tissue is before the run unless it is known to be after it. */
static int32_t find_sense(winding_tracer *w, const knot_tool *tool)
{
    if (!(fabs(w->winding->run_turns) >= KNOT_SENSE_MIN_TURNS) ||
        !find_turn_fraction(w, KNOT_SENSE_QUARTILE, false)) {
        return 0;
    }
    double place = w->found_place, width = KNOT_SENSE_WIDTH_RATIO * tool->radius[w->found_piece];
    double down = height_at(w, place, w->found_piece);
    if (!find_turn_fraction(w, 1.0 - KNOT_SENSE_QUARTILE, true)) {
        return 0;
    }
    down -= height_at(w, w->found_place, w->found_piece);
    if (w->input->tissue_place > 0.5 * (place + w->found_place)) {
        down = -down;
    }
    return down > width ? 1 : down < -width ? -1 : 0;
}

void vbss_knot_measure_winding(const knot_input *input, uint32_t tool_index, knot_winding *winding)
{
    const knot_tool *tool = &input->tools[tool_index];
    winding_tracer w = {0};
    knot_winding none = {0};
    *winding = none;
    w.winding = winding;
    set_up(&w, input, tool);
    double last = (double)(input->point_count - 1), leaves = last, returns = last;
    if (tool->held != VBSS_KNOT_HELD_NOTHING) {
        double place = vbss_max(0.0, vbss_min(tool->held_place, last));
        leaves = leave_jaws(&w, tool, place, false);
        returns = leave_jaws(&w, tool, place, true);
    }
    bool held = leaves < returns;
    trace(&w, 0.0, held ? leaves : last);
    if (held) {
        trace(&w, returns, last);
    }
    if (winding->runs > 0) {
        for (int k = 0; k < 2; k++) {
            winding->run_heights[k] = height_at(&w, winding->run_places[k], w.max_run_pieces[k]);
        }
        winding->sense = find_sense(&w, tool);
    }
}
