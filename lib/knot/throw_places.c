/* Places of the throws in a decomposed diagram. */
#include "knot/knot.h"

/* ---- counting throws of a kind */

uint32_t vbss_knot_count_factors(const knot_factors *f, int32_t wraps, int32_t handedness)
{
    uint32_t count = 0;
    for (uint32_t i = 0; i < f->count; i++) {
        count += f->factors[i].wraps == wraps && f->factors[i].handedness == handedness;
    }
    return count;
}

uint32_t vbss_knot_count_located(const knot_locator *l, uint32_t until, int32_t wraps,
                                 int32_t handedness)
{
    uint32_t count = 0;
    for (uint32_t i = 0; i < until; i++) {
        count += l->throws[i].wraps == wraps && l->throws[i].handedness == handedness;
    }
    return count;
}

bool vbss_knot_has_first_throws(const knot_locator *l, const knot_reading *r, uint32_t count)
{
    bool same = knot_was_read(r) && r->factors.count == count;
    for (uint32_t i = 0; i < count && same; i++) {
        const knot_located *t = &l->throws[i];
        same = vbss_knot_count_located(l, count, t->wraps, t->handedness) ==
               vbss_knot_count_factors(&r->factors, t->wraps, t->handedness);
    }
    return same;
}

/* ---- places of crossings */

static double place_of(const knot_polygon *p, double at)
{
    uint32_t i = (uint32_t)at, next = i + 1 < p->count ? i + 1 : 0;
    double a = p->place[i], b = p->place[next];
    if (a >= 0.0 && b >= 0.0) {
        return a + (at - i) * (b - a);
    }
    return vbss_max(a, b); /* beyond an end: the place of that end */
}

/* Finds the places of a throw on both limbs: the ranges of its own crossings before and after the
 * tissue. If the tissue is unknown, or the throw is in one limb alone, they are the ranges of its
 * two strands. (For a half hitch these differ.) */
static void find_throw_places(const knot_locator *l, const knot_gauss_code *code,
                              const knot_factors *f, uint32_t number, knot_located *t)
{
    const knot_factor *own = &f->factors[number];
    const double tissue = l->input->tissue_place;
    uint32_t split[2] = {own->strand_end, own->strand_begin};
    t->stray =
        l->closure->has_tissue && (place_of(&l->polygon, code->position[own->last]) < tissue ||
                                   place_of(&l->polygon, code->position[own->first]) > tissue);
    if (l->closure->has_tissue && !t->stray) {
        split[0] = own->first;
        split[1] = own->last;
        for (uint32_t e = own->first; e <= own->last; e++) {
            bool inner = false;
            for (uint32_t i = 0; i < f->count && !inner; i++) {
                const knot_factor *other = &f->factors[i];
                inner = other->first > own->first && other->last < own->last && e >= other->first &&
                        e <= other->last;
            }
            bool before = place_of(&l->polygon, code->position[e]) <= tissue;
            if (!inner && before) {
                split[0] = e;
            } else if (!inner && e < split[1]) {
                split[1] = e;
            }
        }
    }
    t->tail_places[0] = place_of(&l->polygon, code->position[own->first]);
    t->tail_places[1] = place_of(&l->polygon, code->position[split[0]]);
    t->long_places[0] = place_of(&l->polygon, code->position[split[1]]);
    t->long_places[1] = place_of(&l->polygon, code->position[own->last]);
}

bool vbss_knot_is_inside(const knot_located *a, const knot_located *b)
{
    return b->tail_places[1] <= a->tail_places[0] && a->long_places[1] <= b->long_places[0];
}

/* Sorts the throws: first those about the tissue, from the inside out, then stray ones along the
 * thread. */
static void sort_throws(knot_locator *l)
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

bool vbss_knot_locate_throws(knot_locator *l, const knot_gauss_code *code, const knot_factors *f)
{
    bool on_thread = true;
    l->count = f->count;
    for (uint32_t i = 0; i < f->count; i++) {
        knot_located *t = &l->throws[i];
        *t = (knot_located){
            .located = true, .wraps = f->factors[i].wraps, .handedness = f->factors[i].handedness};
        find_throw_places(l, code, f, i, t);
        on_thread &= vbss_min(vbss_min(t->tail_places[0], t->tail_places[1]),
                              vbss_min(t->long_places[0], t->long_places[1])) >= 0.0;
    }
    sort_throws(l);
    uint32_t about = 0;
    bool nested = true;
    for (uint32_t i = 0; i < l->count && !l->throws[i].stray; i++) {
        nested = nested && (i == 0 || vbss_knot_is_inside(&l->throws[i - 1], &l->throws[i]));
        about++;
    }
    for (uint32_t i = 0; i < about; i++) {
        l->throws[i].ordered = nested;
    }
    return on_thread;
}

/* ---- comparison with the limbs */

/* Whether the stray throws of each limb agree with the reading of that limb. Moves of a code ignore
 * the ray away from the tissue, so a diagram may show a throw beside the tissue that is about it,
 * or the reverse. */
bool vbss_knot_strays_agree(const knot_locator *l)
{
    uint32_t found[2] = {0, 0};
    bool same = true;
    for (uint32_t i = 0; i < l->count && same; i++) {
        const knot_located *t = &l->throws[i];
        uint32_t side = t->tail_places[0] > l->input->tissue_place, alike = 0;
        for (uint32_t k = 0; k < l->count && t->stray; k++) {
            const knot_located *other = &l->throws[k];
            alike += other->stray && other->wraps == t->wraps &&
                     other->handedness == t->handedness &&
                     (other->tail_places[0] > l->input->tissue_place) == (side == 1);
        }
        found[side] += t->stray;
        same = !t->stray ||
               alike == vbss_knot_count_factors(&l->limbs[side]->factors, t->wraps, t->handedness);
    }
    return same && found[0] == l->limbs[0]->factors.count && found[1] == l->limbs[1]->factors.count;
}

double vbss_knot_extent_of(const knot_located *t)
{
    return fabs(t->tail_places[1] - t->tail_places[0]) +
           fabs(t->long_places[1] - t->long_places[0]);
}
