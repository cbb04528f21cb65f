/* BVHs: order of the features, and update of the boxes.
 *
 * The order affects only the speed of a search. It is built by splitting at medians along the axis
 * of largest spread, so that each group of a level is a compact cluster. It is rebuilt when the
 * groups of moved features are half as large again as after the last ordering. Chains need no
 * order: their edges already form clusters. */
#include "base/random.h"
#include "collision/shapes.h"

size_t vbss_collision_bvh_group_count(uint32_t count)
{
    size_t sum = 0, groups = count;
    do {
        groups = (groups + COLLISION_BVH_WIDTH - 1) / COLLISION_BVH_WIDTH;
        sum += groups;
    } while (groups > 1);
    return sum;
}

void vbss_collision_bvh_set_count(collision_bvh *t, uint32_t count)
{
    uint32_t groups = count, first = 0;
    t->count = count;
    t->level_count = 0;
    t->built_looseness = 0.0;
    do {
        groups = (groups + COLLISION_BVH_WIDTH - 1) / COLLISION_BVH_WIDTH;
        t->level_groups[t->level_count] = groups;
        t->level_first[t->level_count] = first;
        first += groups;
        t->level_count++;
    } while (groups > 1);
    for (uint32_t i = 0; t->order != NULL && i < count; i++) {
        t->order[i] = i;
    }
}

/* ---- update of the boxes */

static double extent(const collision_aabb *box)
{
    return (box->high[0] - box->low[0]) + (box->high[1] - box->low[1]) +
           (box->high[2] - box->low[2]);
}

static void set_lane(collision_bvh_group *g, uint32_t lane, const collision_aabb *box)
{
    for (int k = 0; k < 3; k++) {
        g->low[k][lane] = box->low[k];
        g->high[k][lane] = box->high[k];
    }
}

/* Fills the groups of a level with `count` boxes, in the given order if there is one. Returns the
 * sum of their extents. */
static double fill_level(collision_bvh *t, uint32_t level, const collision_aabb *boxes,
                         const uint32_t *order, uint32_t count)
{
    const collision_aabb none = aabb_empty();
    double sum = 0.0;
    uint32_t leaf = 0;
    for (uint32_t i = 0; i < t->level_groups[level]; i++) {
        collision_bvh_group *g = &t->groups[t->level_first[level] + i];
        collision_aabb all = none;
        for (uint32_t lane = 0; lane < COLLISION_BVH_WIDTH; lane++, leaf++) {
            if (leaf >= count) {
                set_lane(g, lane, &none);
                continue;
            }
            const collision_aabb *box = &boxes[order != NULL ? order[leaf] : leaf];
            set_lane(g, lane, box);
            aabb_extend(&all, box);
            sum += extent(box);
        }
        t->group_boxes[t->level_first[level] + i] = all;
    }
    return sum;
}

/* Updates all levels. Returns the looseness: the size of the lowest groups relative to their
 * features and the whole tree, so that fast or growing shapes do not count as loose. 0 if all boxes
 * are points. */
static double update_levels(collision_bvh *t)
{
    double features = fill_level(t, 0, t->boxes, t->order, t->count), groups = 0.0;
    for (uint32_t level = 1; level < t->level_count; level++) {
        const collision_aabb *below = &t->group_boxes[t->level_first[level - 1]];
        double sum = fill_level(t, level, below, NULL, t->level_groups[level - 1]);
        groups = level == 1 ? sum : groups;
    }
    double whole = features + extent(bvh_root(t));
    return whole > 0.0 ? groups / whole : 0.0;
}

/* ---- order of the features */

static double centre(const collision_bvh *t, uint32_t leaf, int axis)
{
    const collision_aabb *box = &t->boxes[t->order[leaf]];
    return box->low[axis] + box->high[axis];
}

static int widest_axis(const collision_bvh *t, uint32_t first, uint32_t end)
{
    int widest = 0;
    double width = -1.0;
    for (int axis = 0; axis < 3; axis++) {
        double low = (double)INFINITY, high = -(double)INFINITY;
        for (uint32_t leaf = first; leaf < end; leaf++) {
            double c = centre(t, leaf, axis);
            low = vbss_min(low, c);
            high = vbss_max(high, c);
        }
        if (high - low > width) {
            width = high - low;
            widest = axis;
        }
    }
    return widest;
}

static void swap(collision_bvh *t, uint32_t i, uint32_t k)
{
    uint32_t saved = t->order[i];
    t->order[i] = t->order[k];
    t->order[k] = saved;
}

/* Moves the features with lower centres along the axis to the leaves before `middle`. Random pivots
 * avoid slow arrangements of features; a range of equal keys ends the search at once. */
static void partition(collision_bvh *t, uint32_t first, uint32_t middle, uint32_t end, int axis,
                      vbss_random *random)
{
    while (first < middle && middle < end) {
        double pivot = centre(t, first + vbss_random_below(random, end - first), axis);
        uint32_t below = first, above = end;
        for (uint32_t leaf = first; leaf < above;) {
            double c = centre(t, leaf, axis);
            if (c < pivot) {
                swap(t, leaf++, below++);
            } else if (c > pivot) {
                swap(t, leaf, --above);
            } else {
                leaf++;
            }
        }
        if (middle <= below) {
            end = below;
        } else if (middle >= above) {
            first = above;
        } else {
            break;
        }
    }
}

/* Size of the first part of a split: a multiple of the largest group that is smaller than
 * `size`. */
static uint32_t split_size(uint32_t size)
{
    uint32_t unit = COLLISION_BVH_WIDTH;
    while (unit * COLLISION_BVH_WIDTH < size) {
        unit *= COLLISION_BVH_WIDTH;
    }
    return ((size + unit - 1) / unit + 1) / 2 * unit;
}

static void build_order(collision_bvh *t)
{
    /* Ranges still to be split. Three halvings separate the eight children of a group, so each
     * level leaves at most three pending ranges. */
    struct {
        uint32_t first, end;
    } pending[COLLISION_BVH_WIDTH_LOG2 * COLLISION_BVH_LEVELS];
    uint32_t first = 0, end = t->count, count = 0;
    vbss_random random;
    vbss_random_seed(&random, 1, 1);
    for (;;) {
        while (end - first > COLLISION_BVH_WIDTH) {
            uint32_t middle = first + split_size(end - first);
            partition(t, first, middle, end, widest_axis(t, first, end), &random);
            pending[count].first = middle;
            pending[count].end = end;
            count++;
            end = middle;
        }
        if (count == 0) {
            return;
        }
        count--;
        first = pending[count].first;
        end = pending[count].end;
    }
}

bool vbss_collision_bvh_refit(collision_bvh *t)
{
    double looseness = update_levels(t);
    bool is_reordered = t->order != NULL && looseness > 1.5 * t->built_looseness;
    if (is_reordered) {
        build_order(t);
        t->built_looseness = update_levels(t);
    }
    return is_reordered;
}
