/* Trees of boxes: how places are ordered, how boxes are passed up.
 *
 * The order only decides how fast a search is. It is made by halving at medians, along the axis in which
 * the features are spread most, so that each group of a level is a compact cluster; and made again
 * when the groups of moved features have become half as large again as they were. Chains need none:
 * their edges are clusters as they come. */
#include "base/random.h"
#include "collision/shapes.h"

size_t vbss_collision_tree_groups(uint32_t count)
{
    size_t sum = 0, groups = count;
    do {
        groups = (groups + TREE_LANES - 1) / TREE_LANES;
        sum += groups;
    } while (groups > 1);
    return sum;
}

void vbss_collision_tree_set_count(collision_tree *t, uint32_t count)
{
    uint32_t groups = count, first = 0;
    t->count = count;
    t->level_count = 0;
    t->fresh = 0.0;
    do {
        groups = (groups + TREE_LANES - 1) / TREE_LANES;
        t->level_groups[t->level_count] = groups;
        t->level_first[t->level_count] = first;
        first += groups;
        t->level_count++;
    } while (groups > 1);
    for (uint32_t i = 0; t->order != NULL && i < count; i++) {
        t->order[i] = i;
    }
}

/* ---- passing boxes up */

static double extent(const collision_box *box)
{
    return (box->high[0] - box->low[0]) + (box->high[1] - box->low[1]) +
           (box->high[2] - box->low[2]);
}

static void set_lane(box_group *g, uint32_t lane, const collision_box *box)
{
    for (int k = 0; k < 3; k++) {
        g->low[k][lane] = box->low[k];
        g->high[k][lane] = box->high[k];
    }
}

/* Fills the groups of a level with `count` boxes, in order if there is one. Returns the sum of the
 * extents of these boxes. */
static double fill_level(collision_tree *t, uint32_t level, const collision_box *boxes,
                         const uint32_t *order, uint32_t count)
{
    const collision_box none = box_none();
    double sum = 0.0;
    uint32_t place = 0;
    for (uint32_t i = 0; i < t->level_groups[level]; i++) {
        box_group *g = &t->groups[t->level_first[level] + i];
        collision_box all = none;
        for (uint32_t lane = 0; lane < TREE_LANES; lane++, place++) {
            if (place >= count) {
                set_lane(g, lane, &none);
                continue;
            }
            const collision_box *box = &boxes[order != NULL ? order[place] : place];
            set_lane(g, lane, box);
            box_add(&all, box);
            sum += extent(box);
        }
        t->group_boxes[t->level_first[level] + i] = all;
    }
    return sum;
}

/* Returns how large the lowest groups are, against their features and the whole, so that shapes that
 * move fast or grow do not count as loose; 0 when all boxes are points. */
static double pass_up(collision_tree *t)
{
    double features = fill_level(t, 0, t->boxes, t->order, t->count), groups = 0.0;
    for (uint32_t level = 1; level < t->level_count; level++) {
        const collision_box *below = &t->group_boxes[t->level_first[level - 1]];
        double sum = fill_level(t, level, below, NULL, t->level_groups[level - 1]);
        groups = level == 1 ? sum : groups;
    }
    double whole = features + extent(tree_root(t));
    return whole > 0.0 ? groups / whole : 0.0;
}

/* ---- ordering */

static double centre(const collision_tree *t, uint32_t place, int axis)
{
    const collision_box *box = &t->boxes[t->order[place]];
    return box->low[axis] + box->high[axis];
}

static int widest_axis(const collision_tree *t, uint32_t begin, uint32_t end)
{
    int widest = 0;
    double width = -1.0;
    for (int axis = 0; axis < 3; axis++) {
        double low = (double)INFINITY, high = -(double)INFINITY;
        for (uint32_t place = begin; place < end; place++) {
            double c = centre(t, place, axis);
            low = lesser(low, c);
            high = greater(high, c);
        }
        if (high - low > width) {
            width = high - low;
            widest = axis;
        }
    }
    return widest;
}

static void swap(collision_tree *t, uint32_t i, uint32_t k)
{
    uint32_t kept = t->order[i];
    t->order[i] = t->order[k];
    t->order[k] = kept;
}

/* Moves what is lower along the axis to the places before `middle`. Pivots are drawn, so that no
 * arrangement of features is slow by its nature; places of equal keys end the search at once. */
static void divide(collision_tree *t, uint32_t begin, uint32_t middle, uint32_t end, int axis,
                   vbss_random *random)
{
    while (begin < middle && middle < end) {
        double pivot = centre(t, begin + vbss_random_below(random, end - begin), axis);
        uint32_t below = begin, above = end;
        for (uint32_t place = begin; place < above;) {
            double c = centre(t, place, axis);
            if (c < pivot) {
                swap(t, place++, below++);
            } else if (c > pivot) {
                swap(t, place, --above);
            } else {
                place++;
            }
        }
        if (middle <= below) {
            end = below;
        } else if (middle >= above) {
            begin = above;
        } else {
            break;
        }
    }
}

/* Where to divide that many places: at a multiple of the largest group of a level that is smaller. */
static uint32_t first_part(uint32_t size)
{
    uint32_t unit = TREE_LANES;
    while (unit * TREE_LANES < size) {
        unit *= TREE_LANES;
    }
    return ((size + unit - 1) / unit + 1) / 2 * unit;
}

static void order_places(collision_tree *t)
{
    /* What is still to be divided: parts after the present one. A group's eight children are parted in
     * three halvings, so a level leaves at most three waiting. */
    struct {
        uint32_t begin, end;
    } waiting[TREE_LANES_LOG * TREE_LEVELS];
    uint32_t begin = 0, end = t->count, count = 0;
    vbss_random random;
    vbss_random_seed(&random, 1, 1);
    for (;;) {
        while (end - begin > TREE_LANES) {
            uint32_t middle = begin + first_part(end - begin);
            divide(t, begin, middle, end, widest_axis(t, begin, end), &random);
            waiting[count].begin = middle;
            waiting[count].end = end;
            count++;
            end = middle;
        }
        if (count == 0) {
            return;
        }
        count--;
        begin = waiting[count].begin;
        end = waiting[count].end;
    }
}

bool vbss_collision_tree_fit(collision_tree *t)
{
    double looseness = pass_up(t);
    bool anew = t->order != NULL && looseness > 1.5 * t->fresh;
    if (anew) {
        order_places(t);
        t->fresh = pass_up(t);
    }
    return anew;
}
