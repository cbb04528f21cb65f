/* Traversal of two BVHs: the hot loops of a search, compiled for any processor and for AVX2.
 *
 * Comparisons of doubles are exact, so both copies find the same pairs. */
#include "base/bits.h"
#include "collision/shapes.h"

#include <string.h>

#define ALL_LANES ((1u << COLLISION_BVH_WIDTH) - 1u)

/* ---- bit mask of the boxes of a group that overlap a box; touching counts */

#if defined(__GNUC__) && defined(__SSE2__)

#if defined(__AVX__)
typedef double simd __attribute__((vector_size(32)));
typedef long long simd_mask __attribute__((vector_size(32)));
static inline unsigned simd_movemask(simd_mask bits)
{
    return (unsigned)__builtin_ia32_movmskpd256((simd)bits);
}
#else
typedef double simd __attribute__((vector_size(16)));
typedef long long simd_mask __attribute__((vector_size(16)));
static inline unsigned simd_movemask(simd_mask bits)
{
    return (unsigned)__builtin_ia32_movmskpd((simd)bits);
}
#endif
enum { SIMD_LANES = sizeof(simd) / sizeof(double) };

static inline simd simd_load(const double *values)
{
    simd p;
    memcpy(&p, values, sizeof p);
    return p;
}

static inline unsigned overlapping(const collision_bvh_group *g, const collision_aabb *box)
{
    unsigned mask = 0;
    for (unsigned i = 0; i < COLLISION_BVH_WIDTH; i += SIMD_LANES) {
        simd_mask bits = (simd_load(&g->low[0][i]) <= box->high[0]) &
                         (simd_load(&g->high[0][i]) >= box->low[0]) &
                         (simd_load(&g->low[1][i]) <= box->high[1]) &
                         (simd_load(&g->high[1][i]) >= box->low[1]) &
                         (simd_load(&g->low[2][i]) <= box->high[2]) &
                         (simd_load(&g->high[2][i]) >= box->low[2]);
        mask |= simd_movemask(bits) << i;
    }
    return mask;
}

#else

static inline unsigned overlapping(const collision_bvh_group *g, const collision_aabb *box)
{
    unsigned mask = 0;
    for (unsigned i = 0; i < COLLISION_BVH_WIDTH; i++) {
        int overlap = (g->low[0][i] <= box->high[0]) & (g->high[0][i] >= box->low[0]) &
                      (g->low[1][i] <= box->high[1]) & (g->high[1][i] >= box->low[1]) &
                      (g->low[2][i] <= box->high[2]) & (g->high[2][i] >= box->low[2]);
        mask |= (unsigned)overlap << i;
    }
    return mask;
}

#endif

/* Mask of the lanes of a group from leaf `first` on. */
static inline unsigned lanes_from(uint32_t group, uint32_t first)
{
    uint32_t leaf = group * COLLISION_BVH_WIDTH;
    return first <= leaf                        ? ALL_LANES
           : first < leaf + COLLISION_BVH_WIDTH ? ALL_LANES << (first - leaf)
                                                : 0;
}

static inline unsigned test_group(collision_search *search, const collision_bvh_group *g,
                                  const collision_aabb *box)
{
    search->boxes_tested += COLLISION_BVH_WIDTH;
    return overlapping(g, box);
}

static inline uint32_t feature_at(const collision_bvh *t, uint32_t leaf)
{
    return t->order != NULL ? t->order[leaf] : leaf;
}

/* ---- one tree */

/* Lists the groups of level 1 that overlap a box, ascending from group `first` on. Such a group has
 * up to COLLISION_BVH_WIDTH lowest groups. The top group is not tested. A tree of one level counts
 * as one group of level 1. */
static uint32_t list_parents(collision_search *search, const collision_bvh *t,
                             const collision_aabb *box, uint32_t first, uint32_t *list)
{
    if (t->level_count < 3) {
        list[0] = 0;
        return 1;
    }
    uint32_t count = 0, top = t->level_count - 3, above = top; /* levels above level 2 */
    uint32_t group[COLLISION_BVH_LEVELS];
    unsigned lanes[COLLISION_BVH_LEVELS];
    group[top] = 0;
    lanes[top] = test_group(search, &t->groups[t->level_first[top + 2]], box) &
                 lanes_from(0, first >> (COLLISION_BVH_WIDTH_LOG2 * top));
    while (above <= top) {
        if (lanes[above] == 0) {
            above++;
            continue;
        }
        uint32_t child = group[above] * COLLISION_BVH_WIDTH + lowest_bit(lanes[above]);
        lanes[above] &= lanes[above] - 1;
        if (above == 0) {
            list[count++] = child;
            continue;
        }
        above--;
        group[above] = child;
        lanes[above] = test_group(search, &t->groups[t->level_first[above + 2] + child], box) &
                       lanes_from(child, first >> (COLLISION_BVH_WIDTH_LOG2 * above));
    }
    return count;
}

/* Mask of the lowest groups in a group of level 1 that overlap a box, from group `first` on. */
static inline unsigned children(collision_search *search, const collision_bvh *t, uint32_t parent,
                                const collision_aabb *box, uint32_t first)
{
    if (t->level_count == 1) {
        return 1;
    }
    return test_group(search, &t->groups[t->level_first[1] + parent], box) &
           lanes_from(parent, first);
}

uint32_t VBSS_WIDE_NAME(vbss_collision_bvh_query)(collision_search *search, const collision_bvh *t,
                                                  const collision_aabb *box, uint32_t *features)
{
    uint32_t *list = search->parents_a, count = 0;
    uint32_t parents = list_parents(search, t, box, 0, list);
    for (uint32_t i = 0; i < parents; i++) {
        unsigned groups = children(search, t, list[i], box, 0);
        for (; groups != 0; groups &= groups - 1) {
            uint32_t group = list[i] * COLLISION_BVH_WIDTH + lowest_bit(groups);
            unsigned lanes = test_group(search, &t->groups[group], box);
            for (; lanes != 0; lanes &= lanes - 1) {
                features[count++] = feature_at(t, group * COLLISION_BVH_WIDTH + lowest_bit(lanes));
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

/* Whether a pair with overlapping boxes is a candidate, apart from the lanes already excluded. */
static inline bool allowed(const collision_shape *shape, collision_pair_rule rule, uint32_t a,
                           uint32_t b)
{
    return rule == COLLISION_RULE_MESH_EDGES    ? no_common_node(shape, a, b)
           : rule == COLLISION_RULE_MESH_POINTS ? no_corner(shape, a, b)
                                                : true;
}

static inline bool excludes_near(collision_pair_rule rule)
{
    return rule == COLLISION_RULE_FAR_EDGES || rule == COLLISION_RULE_FAR_POINTS;
}

/* A traversal of one tree with itself visits each pair of leaves once. */
static inline bool visits_pairs_once(collision_pair_rule rule)
{
    return rule == COLLISION_RULE_CAPSULES || rule == COLLISION_RULE_MESH_EDGES ||
           rule == COLLISION_RULE_FAR_EDGES;
}

/* Tests the feature at a leaf of tree b against a group of tree a. */
static inline bool collect_group_pairs(collision_search *search,
                                       const collision_traversal *traversal,
                                       collision_pair_rule rule, uint32_t group, uint32_t leaf_b)
{
    uint32_t b = feature_at(traversal->b, leaf_b), count = search->pair_count;
    unsigned lanes = test_group(search, &traversal->a->groups[group], &traversal->b->boxes[b]);
    if (rule == COLLISION_RULE_CHAIN) {
        lanes &= ~lanes_from(group, traversal->shape->far_before[b]);
    } else if (visits_pairs_once(rule)) {
        lanes &= ~lanes_from(group, leaf_b);
    }
    if (excludes_near(rule)) { /* these are most of the overlapping pairs */
        lanes &= ~(unsigned)traversal->excluded_lanes[(size_t)group * traversal->b->count + leaf_b];
    }
    for (; lanes != 0; lanes &= lanes - 1) {
        uint32_t a = feature_at(traversal->a, group * COLLISION_BVH_WIDTH + lowest_bit(lanes));
        bool is_accepted = allowed(traversal->shape, rule, a, b),
             is_swapped = visits_pairs_once(rule) && a > b;
        uint32_t lower = is_swapped ? b : a;
        search->pairs[count].a = lower;
        search->pairs[count].b = is_swapped ? a : b;
        count += is_accepted;
        traversal->offsets[lower] += is_accepted;
    }
    search->pair_count = count;
    return count <= search->pair_capacity;
}

/* First leaf of tree b that is paired with a group of tree a. */
static inline uint32_t first_leaf(const collision_traversal *traversal, collision_pair_rule rule,
                                  uint32_t group)
{
    return rule == COLLISION_RULE_CHAIN ? traversal->shape->far_after[group]
           : visits_pairs_once(rule)    ? group * COLLISION_BVH_WIDTH + 1
                                        : 0;
}

/* Pairs a group of tree a with all overlapping leaves of the listed groups of tree b. */
static inline bool traverse_group(collision_search *search, const collision_traversal *traversal,
                                  collision_pair_rule rule, uint32_t group, uint32_t parents)
{
    const collision_bvh *b = traversal->b;
    const collision_aabb *box = &traversal->a->group_boxes[group];
    uint32_t first = first_leaf(traversal, rule, group);
    for (uint32_t i = 0; i < parents; i++) {
        uint32_t parent = search->parents_b[i];
        unsigned groups = children(search, b, parent, box, first / COLLISION_BVH_WIDTH);
        for (; groups != 0; groups &= groups - 1) {
            uint32_t group_b = parent * COLLISION_BVH_WIDTH + lowest_bit(groups);
            unsigned lanes =
                test_group(search, &b->groups[group_b], box) & lanes_from(group_b, first);
            for (; lanes != 0; lanes &= lanes - 1) {
                uint32_t leaf = group_b * COLLISION_BVH_WIDTH + lowest_bit(lanes);
                if (!collect_group_pairs(search, traversal, rule, group, leaf)) {
                    return false;
                }
            }
        }
    }
    return true;
}

/* Inline, so that the compiler generates one loop for each rule. */
static inline bool traverse_by(collision_search *search, const collision_traversal *traversal,
                               collision_pair_rule rule)
{
    const collision_bvh *a = traversal->a, *b = traversal->b;
    const collision_aabb *boxes = &a->group_boxes[a->level_count > 1 ? a->level_first[1] : 0];
    uint32_t *near_a = search->parents_a, *near_b = search->parents_b;
    uint32_t count_a = list_parents(search, a, bvh_root(b), 0, near_a);
    for (uint32_t i = 0; i < count_a; i++) {
        uint32_t first =
            first_leaf(traversal, rule, near_a[i] * COLLISION_BVH_WIDTH) / COLLISION_BVH_WIDTH;
        uint32_t count_b =
            list_parents(search, b, &boxes[near_a[i]], first / COLLISION_BVH_WIDTH, near_b);
        unsigned groups = children(search, a, near_a[i], bvh_root(b), 0);
        for (; groups != 0; groups &= groups - 1) {
            uint32_t group = near_a[i] * COLLISION_BVH_WIDTH + lowest_bit(groups);
            if (!traverse_group(search, traversal, rule, group, count_b)) {
                return false;
            }
        }
    }
    return true;
}

bool VBSS_WIDE_NAME(vbss_collision_traverse)(collision_search *search,
                                             const collision_traversal *traversal)
{
    switch (traversal->rule) {
    case COLLISION_RULE_CHAIN:
        return traverse_by(search, traversal, COLLISION_RULE_CHAIN);
    case COLLISION_RULE_CAPSULES:
        return traverse_by(search, traversal, COLLISION_RULE_CAPSULES);
    case COLLISION_RULE_MESH_EDGES:
        return traverse_by(search, traversal, COLLISION_RULE_MESH_EDGES);
    case COLLISION_RULE_MESH_POINTS:
        return traverse_by(search, traversal, COLLISION_RULE_MESH_POINTS);
    case COLLISION_RULE_FAR_EDGES:
        return traverse_by(search, traversal, COLLISION_RULE_FAR_EDGES);
    case COLLISION_RULE_FAR_POINTS:
        return traverse_by(search, traversal, COLLISION_RULE_FAR_POINTS);
    default:
        return traverse_by(search, traversal, COLLISION_RULE_ALL);
    }
}
