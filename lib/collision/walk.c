/* Two trees walked together: the hot loops of a search, compiled twice.
 *
 * Comparisons of doubles are exact, so both copies find the same pairs. */
#include "base/bits.h"
#include "collision/shapes.h"

#include <string.h>

#define ALL_LANES ((1u << TREE_LANES) - 1u)

/* ---- which boxes of a group overlap a box, a bit each; touching counts */

#if defined(__GNUC__) && defined(__SSE2__)

#if defined(__AVX__)
typedef double part __attribute__((vector_size(32)));
typedef long long part_bits __attribute__((vector_size(32)));
static inline unsigned bits_of_part(part_bits bits)
{
    return (unsigned)__builtin_ia32_movmskpd256((part)bits);
}
#else
typedef double part __attribute__((vector_size(16)));
typedef long long part_bits __attribute__((vector_size(16)));
static inline unsigned bits_of_part(part_bits bits)
{
    return (unsigned)__builtin_ia32_movmskpd((part)bits);
}
#endif
enum { PART_LANES = sizeof(part) / sizeof(double) };

static inline part part_at(const double *values)
{
    part p;
    memcpy(&p, values, sizeof p);
    return p;
}

static inline unsigned overlapping(const box_group *g, const collision_box *box)
{
    unsigned mask = 0;
    for (unsigned i = 0; i < TREE_LANES; i += PART_LANES) {
        part_bits bits =
            (part_at(&g->low[0][i]) <= box->high[0]) & (part_at(&g->high[0][i]) >= box->low[0]) &
            (part_at(&g->low[1][i]) <= box->high[1]) & (part_at(&g->high[1][i]) >= box->low[1]) &
            (part_at(&g->low[2][i]) <= box->high[2]) & (part_at(&g->high[2][i]) >= box->low[2]);
        mask |= bits_of_part(bits) << i;
    }
    return mask;
}

#else

static inline unsigned overlapping(const box_group *g, const collision_box *box)
{
    unsigned mask = 0;
    for (unsigned i = 0; i < TREE_LANES; i++) {
        int overlap = (g->low[0][i] <= box->high[0]) & (g->high[0][i] >= box->low[0]) &
                      (g->low[1][i] <= box->high[1]) & (g->high[1][i] >= box->low[1]) &
                      (g->low[2][i] <= box->high[2]) & (g->high[2][i] >= box->low[2]);
        mask |= (unsigned)overlap << i;
    }
    return mask;
}

#endif

/* The lanes of a group from place `first` on. */
static inline unsigned lanes_from(uint32_t group, uint32_t first)
{
    uint32_t place = group * TREE_LANES;
    return first <= place               ? ALL_LANES
           : first < place + TREE_LANES ? ALL_LANES << (first - place)
                                        : 0;
}

static inline unsigned look(collision_search *search, const box_group *g, const collision_box *box)
{
    search->boxes_tested += TREE_LANES;
    return overlapping(g, box);
}

static inline uint32_t feature_at(const collision_tree *t, uint32_t place)
{
    return t->order != NULL ? t->order[place] : place;
}

/* ---- one tree */

/* Groups of level 1, which have up to TREE_LANES lowest groups each, that overlap a box: ascending, from
 * group `first` on. The top group is not asked. A tree of one level counts as one group of level 1. */
static uint32_t list_parents(collision_search *search, const collision_tree *t,
                             const collision_box *box, uint32_t first, uint32_t *list)
{
    if (t->level_count < 3) {
        list[0] = 0;
        return 1;
    }
    uint32_t count = 0, top = t->level_count - 3, above = top; /* levels above level 2 */
    uint32_t group[TREE_LEVELS];
    unsigned lanes[TREE_LEVELS];
    group[top] = 0;
    lanes[top] = look(search, &t->groups[t->level_first[top + 2]], box) &
                 lanes_from(0, first >> (TREE_LANES_LOG * top));
    while (above <= top) {
        if (lanes[above] == 0) {
            above++;
            continue;
        }
        uint32_t child = group[above] * TREE_LANES + lowest_bit(lanes[above]);
        lanes[above] &= lanes[above] - 1;
        if (above == 0) {
            list[count++] = child;
            continue;
        }
        above--;
        group[above] = child;
        lanes[above] = look(search, &t->groups[t->level_first[above + 2] + child], box) &
                       lanes_from(child, first >> (TREE_LANES_LOG * above));
    }
    return count;
}

/* The lowest groups under one of level 1 that overlap a box, from group `first` on, a bit each. */
static inline unsigned children(collision_search *search, const collision_tree *t, uint32_t parent,
                                const collision_box *box, uint32_t first)
{
    if (t->level_count == 1) {
        return 1;
    }
    return look(search, &t->groups[t->level_first[1] + parent], box) & lanes_from(parent, first);
}

uint32_t VBSS_WIDE_NAME(vbss_collision_meet)(collision_search *search, const collision_tree *t,
                                             const collision_box *box, uint32_t *features)
{
    uint32_t *list = search->parents_a, count = 0;
    uint32_t parents = list_parents(search, t, box, 0, list);
    for (uint32_t i = 0; i < parents; i++) {
        unsigned groups = children(search, t, list[i], box, 0);
        for (; groups != 0; groups &= groups - 1) {
            uint32_t group = list[i] * TREE_LANES + lowest_bit(groups);
            unsigned lanes = look(search, &t->groups[group], box);
            for (; lanes != 0; lanes &= lanes - 1) {
                features[count++] = feature_at(t, group * TREE_LANES + lowest_bit(lanes));
            }
        }
    }
    return count;
}

/* ---- two trees */

static inline bool no_common_node(const collision_shape *shape, uint32_t a, uint32_t b)
{
    const uint32_t *m = shape->edges[a], *n = shape->edges[b];
    return (m[0] != n[0]) & (m[0] != n[1]) & (m[1] != n[0]) & (m[1] != n[1]);
}

static inline bool no_corner(const collision_shape *shape, uint32_t point, uint32_t triangle)
{
    const uint32_t *n = shape->triangles[triangle];
    return (point != n[0]) & (point != n[1]) & (point != n[2]);
}

/* Whether a pair whose boxes overlap is a candidate, after what the lanes leave out. */
static inline bool allowed(const collision_shape *shape, collision_rule rule, uint32_t a,
                           uint32_t b)
{
    return rule == RULE_MESH_EDGES    ? no_common_node(shape, a, b)
           : rule == RULE_MESH_POINTS ? no_corner(shape, a, b)
                                      : true;
}

static inline bool leaves_out_near(collision_rule rule)
{
    return rule == RULE_FAR_EDGES || rule == RULE_FAR_POINTS;
}

/* In a walk over one tree, each pair of places is met once. */
static inline bool meets_once(collision_rule rule)
{
    return rule == RULE_CAPSULES || rule == RULE_MESH_EDGES || rule == RULE_FAR_EDGES;
}

/* The feature at a place of tree b against a group of tree a. */
static inline bool meet_group(collision_search *search, const collision_walk *walk,
                              collision_rule rule, uint32_t group, uint32_t place_b)
{
    uint32_t b = feature_at(walk->b, place_b), count = search->pair_count;
    unsigned lanes = look(search, &walk->a->groups[group], &walk->b->boxes[b]);
    if (rule == RULE_CHAIN) {
        lanes &= ~lanes_from(group, walk->shape->far_before[b]);
    } else if (meets_once(rule)) {
        lanes &= ~lanes_from(group, place_b);
    }
    if (leaves_out_near(rule)) { /* most of what overlaps */
        lanes &= ~(unsigned)walk->near_lanes[(size_t)group * walk->b->count + place_b];
    }
    for (; lanes != 0; lanes &= lanes - 1) {
        uint32_t a = feature_at(walk->a, group * TREE_LANES + lowest_bit(lanes));
        bool take = allowed(walk->shape, rule, a, b), turn = meets_once(rule) && a > b;
        uint32_t lower = turn ? b : a;
        search->pairs[count].a = lower;
        search->pairs[count].b = turn ? a : b;
        count += take;
        walk->rows[lower] += take;
    }
    search->pair_count = count;
    return count <= search->pair_capacity;
}

/* The first place in tree b that is met with a group of tree a. */
static inline uint32_t first_place(const collision_walk *walk, collision_rule rule, uint32_t group)
{
    return rule == RULE_CHAIN ? walk->shape->far_after[group]
           : meets_once(rule) ? group * TREE_LANES + 1
                              : 0;
}

/* A group of tree a with all that is near it under the listed groups of tree b. */
static inline bool walk_group(collision_search *search, const collision_walk *walk,
                              collision_rule rule, uint32_t group, uint32_t parents)
{
    const collision_tree *b = walk->b;
    const collision_box *box = &walk->a->group_boxes[group];
    uint32_t first = first_place(walk, rule, group);
    for (uint32_t i = 0; i < parents; i++) {
        uint32_t parent = search->parents_b[i];
        unsigned groups = children(search, b, parent, box, first / TREE_LANES);
        for (; groups != 0; groups &= groups - 1) {
            uint32_t group_b = parent * TREE_LANES + lowest_bit(groups);
            unsigned lanes = look(search, &b->groups[group_b], box) & lanes_from(group_b, first);
            for (; lanes != 0; lanes &= lanes - 1) {
                uint32_t place = group_b * TREE_LANES + lowest_bit(lanes);
                if (!meet_group(search, walk, rule, group, place)) {
                    return false;
                }
            }
        }
    }
    return true;
}

/* Inline, so that there is a loop for each rule. */
static inline bool walk_by(collision_search *search, const collision_walk *walk,
                           collision_rule rule)
{
    const collision_tree *a = walk->a, *b = walk->b;
    const collision_box *boxes = &a->group_boxes[a->level_count > 1 ? a->level_first[1] : 0];
    uint32_t *near_a = search->parents_a, *near_b = search->parents_b;
    uint32_t count_a = list_parents(search, a, tree_root(b), 0, near_a);
    for (uint32_t i = 0; i < count_a; i++) {
        uint32_t first = first_place(walk, rule, near_a[i] * TREE_LANES) / TREE_LANES;
        uint32_t count_b = list_parents(search, b, &boxes[near_a[i]], first / TREE_LANES, near_b);
        unsigned groups = children(search, a, near_a[i], tree_root(b), 0);
        for (; groups != 0; groups &= groups - 1) {
            uint32_t group = near_a[i] * TREE_LANES + lowest_bit(groups);
            if (!walk_group(search, walk, rule, group, count_b)) {
                return false;
            }
        }
    }
    return true;
}

bool VBSS_WIDE_NAME(vbss_collision_walk)(collision_search *search, const collision_walk *walk)
{
    switch (walk->rule) {
    case RULE_CHAIN:
        return walk_by(search, walk, RULE_CHAIN);
    case RULE_CAPSULES:
        return walk_by(search, walk, RULE_CAPSULES);
    case RULE_MESH_EDGES:
        return walk_by(search, walk, RULE_MESH_EDGES);
    case RULE_MESH_POINTS:
        return walk_by(search, walk, RULE_MESH_POINTS);
    case RULE_FAR_EDGES:
        return walk_by(search, walk, RULE_FAR_EDGES);
    case RULE_FAR_POINTS:
        return walk_by(search, walk, RULE_FAR_POINTS);
    default:
        return walk_by(search, walk, RULE_ALL);
    }
}
