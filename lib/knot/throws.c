/* Where on the thread the throws lie, and which comes after which.
 *
 * The thread is reduced again, but only between vertices that stay, so that the crossings of its diagrams have
 * places: if one comes apart, the throws' strands can be read off, nested about the tissue. Sub-chains cut between the
 * throws must then have just the throws inside. If no diagram comes apart, or they have not, sub-chains are shrunk until
 * they lose a throw. */
#include "knot/knot.h"

#include <string.h>

enum { HALVINGS = 7, TRIES = 8, ROUNDS = 3, DIRECTIONS = 6 };

/* Segments between vertices that stay, a round; none stay in the last. */
static const uint32_t spacings[ROUNDS] = {6, 16, 0};

/* ---- sub-chains */

static void begin_part(const knot_locating *l, knot_curve *curve, double from, double until)
{
    const knot_scene *scene = l->scene;
    vec3 first = vbss_knot_point_at(scene, from), last = vbss_knot_point_at(scene, until);
    vec3 centre = l->closing->has_tissue ? vbss_knot_point_at(scene, scene->tissue_place)
                                         : vbss_knot_point_at(scene, 0.5 * (from + until));
    const vec3 outward = vec3_sub(first, centre), onward = vec3_sub(last, centre);
    knot_way tail = vbss_knot_way_out(first, vec3_unit_or(outward, l->closing->tail_out[0]));
    knot_way end = vbss_knot_way_out(last, vec3_unit_or(onward, l->closing->long_out[0]));
    vbss_knot_close_begin(l->closing, &curve->polygon, &tail);
    vbss_knot_polygon_add_thread(&curve->polygon, scene, from, until);
    vbss_knot_close_end(l->closing, &curve->polygon, &tail, &end);
    vbss_knot_curve_begin(curve, false);
}

static bool was_read(const knot_reading *r)
{
    return r->reason == VBSS_KNOT_REASON_NONE && r->throws;
}

/* Throws of a kind among factors, and among those found. */
static uint32_t count_factors(const knot_factors *f, int32_t wraps, int32_t handedness)
{
    uint32_t count = 0;
    for (uint32_t i = 0; i < f->count; i++) {
        count += f->factors[i].wraps == wraps && f->factors[i].handedness == handedness;
    }
    return count;
}

static uint32_t count_found(const knot_locating *l, uint32_t until, int32_t wraps,
                            int32_t handedness)
{
    uint32_t count = 0;
    for (uint32_t i = 0; i < until; i++) {
        count += l->throws[i].wraps == wraps && l->throws[i].handedness == handedness;
    }
    return count;
}

static bool has_first_throws(const knot_locating *l, const knot_reading *r, uint32_t count)
{
    bool same = r->reason == VBSS_KNOT_REASON_NONE && r->throws && r->factors.count == count;
    for (uint32_t i = 0; i < count && same; i++) {
        const knot_located *t = &l->throws[i];
        same = count_found(l, count, t->wraps, t->handedness) ==
               count_factors(&r->factors, t->wraps, t->handedness);
    }
    return same;
}

/* ---- read off the whole thread */

static double place_of(const knot_polygon *p, double at)
{
    uint32_t i = (uint32_t)at, next = i + 1 < p->count ? i + 1 : 0;
    double a = p->place[i], b = p->place[next];
    if (a >= 0.0 && b >= 0.0) {
        return a + (at - i) * (b - a);
    }
    return greater(a, b); /* beyond an end: that end */
}

/* Where a throw lies on both limbs: the ranges of its own crossings before and after the tissue, or of its two
 * strands when nobody knows where that is or the throw is in one limb alone. False when the ranges are not its
 * strands: a diagram of a half hitch, or one in which the throw looks like one. */
static bool take_places(const knot_locating *l, const knot_code *code, const knot_factors *f,
                        uint32_t number, knot_located *t)
{
    const knot_factor *own = &f->factors[number];
    const double tissue = l->scene->tissue_place;
    uint32_t split[2] = {own->strand_end, own->strand_begin};
    t->stray = l->closing->has_tissue && (place_of(&l->polygon, code->at[own->last]) < tissue ||
                                          place_of(&l->polygon, code->at[own->first]) > tissue);
    if (l->closing->has_tissue && !t->stray) {
        split[0] = own->first;
        split[1] = own->last;
        for (uint32_t e = own->first; e <= own->last; e++) {
            bool inner = false;
            for (uint32_t i = 0; i < f->count && !inner; i++) {
                const knot_factor *other = &f->factors[i];
                inner = other->first > own->first && other->last < own->last && e >= other->first &&
                        e <= other->last;
            }
            bool before = place_of(&l->polygon, code->at[e]) <= tissue;
            if (!inner && before) {
                split[0] = e;
            } else if (!inner && e < split[1]) {
                split[1] = e;
            }
        }
    }
    t->tail_places[0] = place_of(&l->polygon, code->at[own->first]);
    t->tail_places[1] = place_of(&l->polygon, code->at[split[0]]);
    t->long_places[0] = place_of(&l->polygon, code->at[split[1]]);
    t->long_places[1] = place_of(&l->polygon, code->at[own->last]);
    return split[0] == own->strand_end && split[1] == own->strand_begin;
}

static bool is_inside(const knot_located *a, const knot_located *b)
{
    return b->tail_places[1] <= a->tail_places[0] && a->long_places[1] <= b->long_places[0];
}

/* About the tissue first, from the inside out; then stray ones, along the thread. */
static void sort_throws(knot_locating *l)
{
    for (uint32_t i = 1; i < l->count; i++) {
        knot_located moving = l->throws[i];
        uint32_t at = i;
        while (at > 0) {
            const knot_located *other = &l->throws[at - 1];
            bool before = moving.stray != other->stray ? other->stray
                          : moving.stray ? moving.tail_places[0] < other->tail_places[0]
                                         : moving.tail_places[0] > other->tail_places[0];
            if (!before) {
                break;
            }
            l->throws[at] = *other;
            at--;
        }
        l->throws[at] = moving;
    }
}

/* How well a diagram shows where the throws lie: by strands, or as half hitches, which another direction may show by
 * strands; not at all when something crosses beyond the ends. */
enum { SHOWS_NOTHING = 0, SHOWS_PLACES = 1, SHOWS_STRANDS = 2 };

static uint32_t take_off(knot_locating *l, const knot_code *code, const knot_factors *f)
{
    bool strands = true, on_thread = true;
    l->count = f->count;
    for (uint32_t i = 0; i < f->count; i++) {
        knot_located *t = &l->throws[i];
        *t = (knot_located){
            .located = true, .wraps = f->factors[i].wraps, .handedness = f->factors[i].handedness};
        strands &= take_places(l, code, f, i, t);
        on_thread &= lesser(lesser(t->tail_places[0], t->tail_places[1]),
                            lesser(t->long_places[0], t->long_places[1])) >= 0.0;
    }
    sort_throws(l);
    uint32_t about = 0;
    bool nested = true;
    for (uint32_t i = 0; i < l->count && !l->throws[i].stray; i++) {
        nested = nested && (i == 0 || is_inside(&l->throws[i - 1], &l->throws[i]));
        about++;
    }
    for (uint32_t i = 0; i < about; i++) {
        l->throws[i].ordered = nested;
    }
    return !on_thread ? SHOWS_NOTHING : strands ? SHOWS_STRANDS : SHOWS_PLACES;
}

static void begin_check(knot_locating *l)
{
    l->certified = true;
    l->level = 0;
    l->reading = false;
    l->stage = KNOT_LOCATE_CHECK;
}

/* The thread closed; the tissue's place stays, and its ray is in the way of moves. */
static void begin_round(knot_locating *l, knot_curve *curve)
{
    const knot_scene *scene = l->scene;
    const double last = scene->point_count - 1.0, tissue = scene->tissue_place;
    knot_polygon *p = &l->polygon;
    knot_way tail = vbss_knot_way_out(scene->points[0], l->closing->tail_out[0]);
    knot_way end =
        vbss_knot_way_out(scene->points[scene->point_count - 1], l->closing->long_out[0]);
    vbss_knot_close_begin(l->closing, p, &tail);
    if (l->closing->has_tissue) {
        vbss_knot_polygon_add_thread(p, scene, 0.0, tissue);
        vec3 in = p->x[p->count - 1];
        p->stays[p->count - 1] = true;
        l->ray = (knot_edge){in, vec3_add_scaled(in, l->closing->far, l->closing->away)};
        vbss_knot_polygon_add_thread(p, scene, tissue, last);
    } else {
        vbss_knot_polygon_add_thread(p, scene, 0.0, last);
    }
    vbss_knot_close_end(l->closing, p, &tail, &end);
    p->stays[0] = p->stays[p->count - 1] = true; /* far away: between them there is no thread */
    uint32_t spacing = spacings[l->round++];
    for (uint32_t i = 1; i < p->count && spacing > 0; i += spacing) {
        p->stays[i] = true;
    }
    vbss_knot_reduction_begin(&curve->reduction, p, &l->ray, l->closing->has_tissue ? 1 : 0);
    l->direction = 0;
    l->stage = KNOT_LOCATE_REDUCE;
}

static void reduce(knot_locating *l, knot_curve *curve, knot_work *work)
{
    if (vbss_knot_reduction_go_on(&curve->reduction, work)) {
        curve->counts.removed += curve->reduction.removed;
        l->stage = KNOT_LOCATE_PROJECT;
    }
}

static void end_round(knot_locating *l, knot_curve *curve)
{
    if (l->quality > 0) {
        memcpy(l->throws, l->spare, sizeof l->throws);
        l->quality = 0;
        begin_check(l);
    } else if (l->round < ROUNDS) {
        begin_round(l, curve);
    } else {
        l->stage = KNOT_LOCATE_SHRINK;
    }
}

/* Whether what lies in one limb alone is what the limb has. Moves of a code know nothing of the tissue's ray: a
 * diagram may show a throw beside the tissue that is about it, or the reverse. */
static bool has_strays(const knot_locating *l)
{
    uint32_t found[2] = {0, 0};
    bool same = true;
    for (uint32_t i = 0; i < l->count && same; i++) {
        const knot_located *t = &l->throws[i];
        uint32_t side = t->tail_places[0] > l->scene->tissue_place, alike = 0;
        for (uint32_t k = 0; k < l->count && t->stray; k++) {
            const knot_located *other = &l->throws[k];
            alike += other->stray && other->wraps == t->wraps &&
                     other->handedness == t->handedness &&
                     (other->tail_places[0] > l->scene->tissue_place) == (side == 1);
        }
        found[side] += t->stray;
        same =
            !t->stray || alike == count_factors(&l->limbs[side]->factors, t->wraps, t->handedness);
    }
    return same && found[0] == l->limbs[0]->factors.count && found[1] == l->limbs[1]->factors.count;
}

/* Strands that were laid anew have no places of their own. */
static uint32_t take_apart(knot_locating *l, knot_curve *curve, knot_code *code, knot_work *work)
{
    knot_factors factors;
    bool anew = false;
    if (!vbss_knot_twists(code, &factors)) {
        anew = vbss_knot_code_untangle(code, &curve->codes[1], KNOT_TRIES, work);
        if (!anew || !vbss_knot_twists(code, &factors)) {
            return 0;
        }
    }
    uint32_t shows = take_off(l, code, &factors);
    if (shows == SHOWS_NOTHING || !has_first_throws(l, l->whole, l->count) ||
        (l->closing->has_tissue && !has_strays(l))) {
        return 0;
    }
    return 2 * shows - anew;
}

/* How much of the thread is said to be in throws: a crossing of a throw may be seen far from the others. */
static double extent_of(const knot_locating *l)
{
    double sum = 0.0;
    for (uint32_t i = 0; i < l->count; i++) {
        const knot_located *t = &l->throws[i];
        sum += fabs(t->tail_places[1] - t->tail_places[0]) +
               fabs(t->long_places[1] - t->long_places[0]);
    }
    return sum;
}

/* The diagram that shows the strands of all throws as they lie, in the least of the thread; else the best. */
static void project(knot_locating *l, knot_curve *curve, knot_work *work)
{
    knot_code *code = &curve->codes[0];
    if (l->direction >= l->direction_limit) {
        end_round(l, curve);
        return;
    }
    vec3 direction = vbss_knot_direction(l->direction++);
    curve->counts.projections++;
    if (vbss_knot_project(&curve->projector, &l->polygon, direction, code, work) !=
        KNOT_DIAGRAM_PLAIN) {
        return;
    }
    vbss_knot_code_simplify(code, work);
    uint32_t quality = take_apart(l, curve, code, work);
    if (quality == 0) {
        return;
    }
    double extent = extent_of(l);
    if (quality > l->quality || (quality == l->quality && extent < l->extent)) {
        memcpy(l->spare, l->throws, sizeof l->throws);
        l->quality = quality;
        l->extent = extent;
    }
}

/* ---- the order, confirmed */

static void check(knot_locating *l, knot_curve *curve, knot_work *work)
{
    if (l->reading) {
        if (vbss_knot_curve_go_on(curve, work)) {
            l->reading = false;
            if (!has_first_throws(l, &curve->reading, l->level)) {
                l->direction = l->direction_limit; /* another round may place them better */
                l->stage = KNOT_LOCATE_PROJECT;
            }
        }
        return;
    }
    l->level++;
    if (l->level >= l->count || !l->throws[l->level].ordered || l->throws[l->level].stray) {
        l->stage = KNOT_LOCATE_DONE;
        return;
    }
    const knot_located *inner = &l->throws[l->level - 1], *outer = &l->throws[l->level];
    double from = 0.5 * (inner->tail_places[0] + outer->tail_places[1]);
    double until = 0.5 * (inner->long_places[1] + outer->long_places[0]);
    begin_part(l, curve, from, until);
    l->reading = true;
}

/* ---- shrinking */

static uint32_t throws_in(const knot_reading *r)
{
    return r->reason == VBSS_KNOT_REASON_NONE && r->throws ? r->factors.count : KNOT_THROWS + 1;
}

static void begin_level(knot_locating *l, uint32_t level)
{
    l->level = level;
    l->side = 0;
    l->halvings = l->tries = 0;
    l->low = l->cuts[0];
    l->high = l->scene->tissue_place;
    l->reading = false;
}

static void begin_shrinking(knot_locating *l)
{
    l->count = l->whole->factors.count;
    memset(l->throws, 0, sizeof l->throws);
    for (uint32_t i = 0; i < l->count; i++) {
        l->throws[i].wraps = l->whole->factors.factors[i].wraps;
        l->throws[i].handedness = l->whole->factors.factors[i].handedness;
        l->throws[i].ordered = l->count == 1;
    }
    l->cuts[0] = 0.0;
    l->cuts[1] = l->scene->point_count - 1.0;
    begin_level(l, l->count);
}

/* How far inside the limits of this level the next sub-chain is cut. */
static double inner_cut(const knot_locating *l, uint32_t side)
{
    return l->found[side] + 0.03 * l->tries * (l->scene->tissue_place - l->found[side]);
}

/* What the sub-chain had that `inside` has not is the throw of this level. */
static bool take_throw(knot_locating *l, const knot_reading *inside)
{
    knot_located *t = &l->throws[l->level - 1];
    for (uint32_t i = 0; i < l->level; i++) {
        const knot_located had = l->throws[i];
        uint32_t now =
            inside == NULL ? 0 : count_factors(&inside->factors, had.wraps, had.handedness);
        if (count_found(l, l->level, had.wraps, had.handedness) != now + 1) {
            continue;
        }
        l->throws[i] = *t;
        *t = had;
        t->located = t->ordered = true;
        t->tail_places[0] = l->found[0];
        t->long_places[1] = l->found[1];
        t->tail_places[1] = inside == NULL ? l->scene->tissue_place : inner_cut(l, 0);
        t->long_places[0] = inside == NULL ? l->scene->tissue_place : inner_cut(l, 1);
        return inside == NULL || has_first_throws(l, inside, l->level - 1);
    }
    return false;
}

/* Gives up what is further inside. */
static void leave_unordered(knot_locating *l)
{
    for (uint32_t i = 0; i < l->level; i++) {
        l->throws[i].located = l->throws[i].ordered = false;
    }
    l->stage = KNOT_LOCATE_DONE;
}

static void take_part(knot_locating *l, const knot_reading *r)
{
    uint32_t inside = throws_in(r);
    if (l->side < 2) {
        double middle = 0.5 * (l->low + l->high);
        *(inside == l->level ? &l->low : &l->high) = middle;
        if (++l->halvings == HALVINGS) {
            l->found[l->side++] = l->low;
            l->halvings = 0;
            l->low = l->cuts[1];
            l->high = l->scene->tissue_place;
        }
        return;
    }
    if (inside == l->level - 1) {
        if (!take_throw(l, r)) {
            leave_unordered(l);
            return;
        }
        l->cuts[0] = inner_cut(l, 0);
        l->cuts[1] = inner_cut(l, 1);
        begin_level(l, l->level - 1);
    } else if (++l->tries == TRIES) {
        leave_unordered(l);
    }
}

static void shrink(knot_locating *l, knot_curve *curve, knot_work *work)
{
    if (!l->shrinking) {
        l->shrinking = true;
        begin_shrinking(l);
        if (!l->closing->has_tissue || l->limbs[0]->factors.count > 0 ||
            l->limbs[1]->factors.count > 0) {
            leave_unordered(l);
        }
        return;
    }
    if (l->reading) {
        if (vbss_knot_curve_go_on(curve, work)) {
            l->reading = false;
            take_part(l, &curve->reading);
        }
        return;
    }
    if (l->side == 2 && l->level == 1) {
        take_throw(l, NULL);
        l->stage = KNOT_LOCATE_DONE;
        return;
    }
    double middle = 0.5 * (l->low + l->high);
    double from = l->side == 0 ? middle : l->side == 1 ? l->cuts[0] : inner_cut(l, 0);
    double until = l->side == 1 ? middle : l->side == 0 ? l->cuts[1] : inner_cut(l, 1);
    begin_part(l, curve, from, until);
    l->reading = true;
}

/* ---- the whole */

void vbss_knot_locating_begin(knot_locating *l, knot_curve *curve, const knot_scene *scene,
                              const knot_closing *closing, const knot_reading *whole,
                              const knot_reading *tail, const knot_reading *long_limb,
                              uint32_t direction_limit)
{
    l->scene = scene;
    l->closing = closing;
    l->whole = whole;
    l->limbs[0] = tail;
    l->limbs[1] = long_limb;
    l->count = 0;
    l->certified = l->shrinking = false;
    l->quality = 0;
    l->direction_limit = direction_limit < DIRECTIONS ? direction_limit : DIRECTIONS;
    curve->direction_limit = l->direction_limit; /* sub-chains are many */
    l->round = 0;
    l->stage = KNOT_LOCATE_DONE;
    if (!whole->throws || whole->factors.count == 0) {
        return;
    }
    begin_round(l, curve);
    if (closing->has_tissue && !(was_read(tail) && was_read(long_limb))) {
        begin_shrinking(l);
        leave_unordered(l);
    }
}

bool vbss_knot_locating_go_on(knot_locating *l, knot_curve *curve, knot_work *work)
{
    while (*work > 0 && l->stage != KNOT_LOCATE_DONE) {
        switch (l->stage) {
        case KNOT_LOCATE_REDUCE:
            reduce(l, curve, work);
            break;
        case KNOT_LOCATE_PROJECT:
            project(l, curve, work);
            break;
        case KNOT_LOCATE_CHECK:
            check(l, curve, work);
            break;
        case KNOT_LOCATE_SHRINK:
            shrink(l, curve, work);
            break;
        case KNOT_LOCATE_DONE:
            break;
        }
    }
    return l->stage == KNOT_LOCATE_DONE;
}
