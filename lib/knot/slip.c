/* Slip of a throw: whether both limbs bend alike, or one is wound around the other, straight one.
 *
 * The measure compares the mean curvatures of both limbs where they cross. Crossings are counted as
 * seen from all directions: two segments cross in a share of the directions that the Gauss integral
 * gives in closed form. Each throw has a window of either limb, whose middle is the centroid of its
 * crossings, so the measure depends on the shape alone and hardly on the segments. The places of
 * the diagram are only where the search for these middles begins. (The turning between these
 * places, an earlier measure, changed by 0.3 to 1 from one reading of a tight knot at rest to the
 * next.) */
#include "base/elementary.h"
#include "knot/knot.h"
#include "knot/tuning.h"

/* ---- pieces of a limb */

/* Angle at a point of the thread, rad. */
static double turn_at(const knot_input *input, uint32_t i)
{
    if (i == 0 || i + 1 >= input->point_count) {
        return 0.0;
    }
    vec3 before = vec3_sub(input->points[i], input->points[i - 1]);
    vec3 after = vec3_sub(input->points[i + 1], input->points[i]);
    return vbss_arc_tangent(vec3_norm(vec3_cross(before, after)), vec3_dot(before, after));
}

/* Divides the part of a limb between two places into its segments, or into as many runs of segments as
 * there is room for. The angle at a point is spread evenly over both of its segments. */
static void divide(const knot_input *input, double begin, double end, double split, knot_limb *to)
{
    to->count = 0;
    if (!(begin < end)) {
        return;
    }
    const uint32_t first = (uint32_t)begin, segments = (uint32_t)(-floor(-end)) - first;
    const uint32_t run = (segments + KNOT_LIMB_PIECES - 1) / KNOT_LIMB_PIECES;
    double arc = begin < split ? -vbss_knot_length(input, begin, split)
                               : vbss_knot_length(input, split, begin);
    for (uint32_t i = 0; i < segments; i += run) {
        double from = vbss_max(begin, (double)(first + i));
        double until = vbss_min(end, (double)(first + i + run));
        double length = 0.0, turning = 0.0;
        for (uint32_t s = first + i; s < first + i + run && s < until; s++) {
            double share = vbss_min(until, s + 1.0) - vbss_max(from, (double)s);
            length += share * vec3_distance(input->points[s], input->points[s + 1]);
            turning += share * 0.5 * (turn_at(input, s) + turn_at(input, s + 1));
        }
        if (length > 0.0) {
            to->pieces[to->count++] = (knot_limb_piece){.from = vbss_knot_point_at(input, from),
                                                        .to = vbss_knot_point_at(input, until),
                                                        .length = length,
                                                        .distance = fabs(arc + 0.5 * length),
                                                        .curvature = turning / length};
        }
        arc += length;
    }
}

/* ---- crossings */

/* Half the solid angle of the directions to three points, whose triple product has this magnitude. */
static double half_solid_angle(vec3 a, vec3 b, vec3 c, double triple)
{
    double la = vec3_norm(a), lb = vec3_norm(b), lc = vec3_norm(c);
    return vbss_arc_tangent(triple, la * lb * lc + vec3_dot(a, b) * lc + vec3_dot(b, c) * la +
                                        vec3_dot(c, a) * lb);
}

/* Half the solid angle of the directions in which one piece appears to cross another: those of the
 * differences of their points, which fill a parallelogram. */
static double count_crossings(const knot_limb_piece *p, const knot_limb_piece *q)
{
    vec3 a = vec3_sub(q->from, p->from), c = vec3_sub(q->to, p->to);
    vec3 area = vec3_cross(vec3_sub(p->to, p->from), vec3_sub(q->to, q->from));
    double triple = fabs(vec3_dot(a, area));
    if (!(triple > 0.0)) {
        return 0.0; /* in one plane */
    }
    vec3 apart = vec3_lerp(a, c, 0.5);
    double far = KNOT_SLIP_FAR_RATIO * (p->length + q->length), squared = vec3_norm_squared(apart);
    if (squared > far * far) {
        return 0.5 * triple / (squared * sqrt(squared));
    }
    vec3 b = vec3_sub(q->to, p->from), d = vec3_sub(q->from, p->to);
    return half_solid_angle(a, b, c, triple) + half_solid_angle(a, c, d, triple);
}

/* ---- windows */

/* Window of a throw on one limb, in distances along the thread from the tissue: the weight is 1 in
 * the middle and falls linearly to 0 at both ends. */
typedef struct limb_window {
    double begin, middle, end;
} limb_window;

/* A throw in the search: its middles on both limbs, and the reach of its windows where it has no
 * neighbour. */
typedef struct throw_window {
    double middle[2], reach;
} throw_window;

typedef struct crossing_sums {
    double all, first[2], second[2], bent[2]; /* of distances, their squares, curvatures */
} crossing_sums;

static double weight_in(const limb_window *w, double distance)
{
    double rise = w->middle - w->begin, fall = w->end - w->middle;
    if (!(distance > w->begin && distance < w->end)) {
        return 0.0;
    }
    return distance < w->middle ? (distance - w->begin) / rise
                                : 1.0 - (distance - w->middle) / fall;
}

/* Each window reaches to the middle of the neighbouring throw, so neighbours share the arc between
 * them. */
static limb_window window_of(const throw_window *throws, uint32_t count, uint32_t i, int limb)
{
    const throw_window *own = &throws[i];
    return (limb_window){
        .begin = i > 0 ? throws[i - 1].middle[limb] : own->middle[limb] - own->reach,
        .middle = own->middle[limb],
        .end = i + 1 < count ? throws[i + 1].middle[limb] : own->middle[limb] + own->reach};
}

/* A pair of pieces is counted when a window first needs it. */
static double crossings_of(knot_slip_room *room, uint32_t i, uint32_t k)
{
    double *found = &room->crossings[i][k];
    if (*found < 0.0) {
        *found = count_crossings(&room->limbs[0].pieces[i], &room->limbs[1].pieces[k]);
    }
    return *found;
}

static crossing_sums sum_crossings(knot_slip_room *room, const limb_window windows[2])
{
    crossing_sums sums = {0};
    double weights[KNOT_LIMB_PIECES];
    uint32_t first = KNOT_LIMB_PIECES, end = 0; /* of the pieces in the window */
    for (uint32_t k = 0; k < room->limbs[1].count; k++) {
        weights[k] = weight_in(&windows[1], room->limbs[1].pieces[k].distance);
        first = weights[k] > 0.0 && first > k ? k : first;
        end = weights[k] > 0.0 ? k + 1 : end;
    }
    for (uint32_t i = 0; i < room->limbs[0].count; i++) {
        const knot_limb_piece *p = &room->limbs[0].pieces[i];
        const double share = weight_in(&windows[0], p->distance);
        double all = 0.0;
        for (uint32_t k = first; k < end && share > 0.0; k++) {
            const knot_limb_piece *q = &room->limbs[1].pieces[k];
            double w = crossings_of(room, i, k) * share * weights[k];
            all += w;
            sums.first[1] += w * q->distance;
            sums.second[1] += w * q->distance * q->distance;
            sums.bent[1] += w * q->curvature;
        }
        sums.all += all;
        sums.first[0] += all * p->distance;
        sums.second[0] += all * p->distance * p->distance;
        sums.bent[0] += all * p->curvature;
    }
    return sums;
}

/* Moves the middles of a throw to the centroid of its crossings. They stay between the neighbours'. */
static void shift_window(throw_window *own, const crossing_sums *sums)
{
    double reach = 0.0;
    for (int limb = 0; limb < 2; limb++) {
        double mean = sums->first[limb] / sums->all;
        own->middle[limb] = mean;
        reach += sqrt(vbss_max(sums->second[limb] / sums->all - mean * mean, 0.0));
    }
    own->reach = KNOT_SLIP_REACH * reach;
}

/* ---- a stack of throws */

/* Arc length of a throw's places on both limbs. */
static double length_of(const knot_input *input, const knot_located *t)
{
    return vbss_knot_length(input, t->tail_places[0], t->tail_places[1]) +
           vbss_knot_length(input, t->long_places[0], t->long_places[1]);
}

/* Place at an arc length before (negative) or behind a place, within the thread. */
static double shift_place(const knot_input *input, double place, double distance)
{
    const double last = input->point_count - 1.0;
    double left = fabs(distance);
    while (left > 0.0 && (distance < 0.0 ? place > 0.0 : place < last)) {
        double next = distance < 0.0 ? -floor(-place) - 1.0 : floor(place) + 1.0;
        double step =
            vec3_distance(vbss_knot_point_at(input, place), vbss_knot_point_at(input, next));
        if (step >= left) {
            return place + (next - place) * (left / step);
        }
        left -= step;
        place = next;
    }
    return place;
}

static void measure_stack(const knot_input *input, const knot_located *throws, uint32_t count,
                          knot_slip_room *room, double *slips)
{
    const knot_located *inner = &throws[0], *outer = &throws[count - 1];
    throw_window windows[KNOT_THROWS];
    double split = input->has_holes && !inner->stray
                       ? input->tissue_place
                       : 0.5 * (inner->tail_places[1] + inner->long_places[0]);
    for (uint32_t i = 0; i < count; i++) {
        double tail = 0.5 * (throws[i].tail_places[0] + throws[i].tail_places[1]);
        double longer = 0.5 * (throws[i].long_places[0] + throws[i].long_places[1]);
        windows[i] = (throw_window){.middle = {vbss_knot_length(input, tail, split),
                                               vbss_knot_length(input, split, longer)},
                                    .reach = length_of(input, &throws[i])};
    }
    double in = length_of(input, inner), out = length_of(input, outer);
    divide(input, shift_place(input, outer->tail_places[0], -out),
           vbss_min(shift_place(input, inner->tail_places[1], in), split), split, &room->limbs[0]);
    divide(input, vbss_max(shift_place(input, inner->long_places[0], -in), split),
           shift_place(input, outer->long_places[1], out), split, &room->limbs[1]);
    for (uint32_t i = 0; i < room->limbs[0].count; i++) {
        for (uint32_t k = 0; k < room->limbs[1].count; k++) {
            room->crossings[i][k] = -1.0;
        }
    }
    for (uint32_t round = 0; round < KNOT_SLIP_ROUNDS; round++) {
        for (uint32_t i = 0; i < count; i++) {
            const limb_window own[2] = {window_of(windows, count, i, 0),
                                        window_of(windows, count, i, 1)};
            crossing_sums sums = sum_crossings(room, own);
            double both = sums.bent[0] + sums.bent[1];
            slips[i] = both > 0.0 ? (sums.bent[0] - sums.bent[1]) / both : 0.0;
            if (sums.all > 0.0) {
                shift_window(&windows[i], &sums);
            }
        }
    }
}

void vbss_knot_measure_slips(const knot_input *input, const knot_located *throws, uint32_t count,
                             knot_slip_room *room, double slips[KNOT_THROWS])
{
    uint32_t i = 0;
    while (i < count) {
        uint32_t end = i + 1;
        bool stacked = throws[i].ordered && throws[i].located && !throws[i].stray;
        while (stacked && end < count && throws[end].ordered && throws[end].located &&
               !throws[end].stray) {
            end++;
        }
        slips[i] = 0.0;
        if (throws[i].located) {
            measure_stack(input, &throws[i], end - i, room, &slips[i]);
        }
        i = end;
    }
}
