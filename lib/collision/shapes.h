/* Shapes that move, the trees of boxes over their features, and the object that searches them.
 *
 * A shape has points (its nodes), edges and, if it is a mesh, triangles; each kind of feature has a
 * tree. Boxes are swept over start and end and enlarged by the shape's reach; a search lists the pairs
 * of features whose boxes overlap, whatever the trees look like: docs/collision.md. */
#ifndef VBSS_COLLISION_SHAPES_H
#define VBSS_COLLISION_SHAPES_H

#include "base/memory.h"
#include "base/slot.h"
#include "base/simd_dispatch.h"
#include "collision/collision.h"

/* ---- boxes */

/* The fourth numbers are 0: padding, so that compilers take two or four numbers at a time. */
typedef struct collision_aabb {
    double low[4], high[4];
} collision_aabb;

/* Overlaps nothing, adds nothing. */
static inline collision_aabb aabb_empty(void)
{
    const double far = (double)INFINITY;
    collision_aabb none = {{far, far, far, 0.0}, {-far, -far, -far, 0.0}};
    return none;
}

static inline void aabb_extend(collision_aabb *box, const collision_aabb *other)
{
    for (int k = 0; k < 4; k++) {
        box->low[k] = vbss_min(box->low[k], other->low[k]);
        box->high[k] = vbss_max(box->high[k], other->high[k]);
    }
}

/* ---- trees (bvh.c) */

/* As many boxes side by side as are looked at together. 393216 edges of the largest mesh make groups
 * of 49152, 6144, 768, 96, 12, 2, 1: seven levels. */
enum {
    COLLISION_BVH_WIDTH_LOG2 = 3,
    COLLISION_BVH_WIDTH = 1 << COLLISION_BVH_WIDTH_LOG2,
    COLLISION_BVH_LEVELS = 7
};
typedef struct collision_bvh_group {
    double low[3][COLLISION_BVH_WIDTH], high[3][COLLISION_BVH_WIDTH];
} collision_bvh_group;

/* Groups of features, groups of these groups, and so on to one group at the top. Group g is in lane
 * g % COLLISION_BVH_WIDTH of group g / COLLISION_BVH_WIDTH of the level above. */
typedef struct collision_bvh {
    uint32_t count;              /* of features; 0: no tree */
    uint32_t *order;             /* the feature at each place; NULL: the places are the numbers */
    collision_aabb *boxes;       /* of the features, by number */
    collision_aabb *group_boxes; /* of all levels, the lowest first */
    collision_bvh_group *groups; /* what is in them */
    uint32_t level_count;
    uint32_t level_groups[COLLISION_BVH_LEVELS]; /* groups in a level */
    uint32_t level_first[COLLISION_BVH_LEVELS];  /* its first group */
    double built_looseness; /* looseness just after ordering; 0: never ordered */
} collision_bvh;

/* Groups of all levels over that many features. */
size_t vbss_collision_bvh_group_count(uint32_t count);
/* Sets the levels, and the order that features come in; `groups` must have room. */
void vbss_collision_bvh_set_count(collision_bvh *bvh, uint32_t count);
/* Takes over changed boxes; orders anew when the groups have become loose, and says so. */
bool vbss_collision_bvh_refit(collision_bvh *bvh);

static inline const collision_aabb *bvh_root(const collision_bvh *bvh)
{
    return &bvh->group_boxes[bvh->level_first[bvh->level_count - 1]];
}

/* ---- shapes (shapes.c) */

typedef struct collision_object collision_object;

typedef enum collision_shape_kind {
    COLLISION_SHAPE_CHAIN = 1,
    COLLISION_SHAPE_CAPSULES = 2,
    COLLISION_SHAPE_MESH = 3
} collision_shape_kind;

/* What a mesh leaves out: nodes that are near its edges and triangles along the surface, their own too. */
typedef struct collision_exclusion {
    uint32_t words;              /* in a row of bits; 0: nothing is left out */
    uint64_t *edges, *triangles; /* a row for each, of nodes */
    /* The same as a walk asks it, while trees keep their order: for each group of tree a and each place in
     * tree b, which lanes are near. Of edges and edges, of points and triangles. */
    uint8_t *edge_lanes, *point_lanes;
    uint32_t *first_edge, *edges_of; /* of each node, one more at the end; the edges it is in */
    uint32_t *leaf_of;               /* scratch: feature -> place */
} collision_exclusion;

typedef struct collision_shape {
    collision_shape_kind kind;
    uint32_t node_count, edge_count, triangle_count;
    uint32_t node_capacity; /* of a chain: there is memory for so many; else node_count */
    double radius;
    double inflation;  /* by which boxes are larger than the swept vertices, on every side */
    vec3 *start, *end; /* of the nodes */
    uint32_t (*edges)[2];
    uint32_t (*triangles)[3];
    /* Of a chain: how many edges, from the first on, are far enough along it from each; and the first
     * edge far enough from the first of each group. */
    uint32_t *far_before, *far_after;
    collision_exclusion exclusion;
    uint64_t topology_hash; /* hash of all that never changes */
    uint32_t category, mask;
    bool is_rigid;    /* never a pair with itself */
    bool edges_only;  /* a mesh whose triangles nobody asks for: no pairs of them */
    bool is_disabled; /* a chain that is nowhere yet: never found */
    bool boxes_valid; /* of the points, and around all, since the last move */
    bool point_bvh_valid, edge_bvh_valid, triangle_bvh_valid; /* trees know the last move */
    /* Of an object that keeps what is apart; else NULL. Of each node: how far it goes from start to end; where it started in
     * the last search, and how far from there it is. */
    double *displacement, *search_displacement;
    vec3 *search_start;
    bool caches_separation, has_search_start;
    collision_aabb root; /* around all */
    collision_bvh point_bvh, edge_bvh, triangle_bvh;
    uint32_t *edge_offsets,
        *point_offsets; /* candidates of each as a; then where its next one goes */
    bool edge_offsets_used, point_offsets_used;
} collision_shape;

void vbss_collision_shape_free(vbss_context *context, collision_shape *shape);

/* Chains that change, for who has them inside: one that is nowhere yet; another number of nodes, up to its
 * capacity, with other rest lengths, which wakes it and allocates nothing; and nowhere again. */
vbss_result vbss_collision_add_disabled_chain(collision_object *c, uint32_t node_capacity,
                                              double radius, uint32_t *id);
void vbss_collision_resize_chain(collision_object *c, uint32_t id, uint32_t node_count,
                                 const double *rest_lengths);
void vbss_collision_disable_chain(collision_object *c, uint32_t id);

/* Another rule of which of its own pairs are candidates: what was found is no longer true. */
void vbss_collision_update_pair_rules(collision_object *c, collision_shape *shape);

/* ---- what is near along a surface (geodesic_exclusion.c) */

/* Of all bits, while they are worked out: a row for each node, edge and triangle. Enough for a surface of 4700
 * nodes; lanes take twice as much again. */
#define COLLISION_EXCLUSION_BYTES (16u << 20)
/* Of a mesh, from now on: edges, and points and triangles, are no candidates if the shortest way over edges
 * between a node of the one and a node of the other is below `distance` when the nodes are `at`; those
 * with a common node never are. VBSS_ERROR_CAPACITY if COLLISION_EXCLUSION_BYTES are not enough. A failure changes
 * nothing. */
vbss_result vbss_collision_exclude_near(collision_object *c, uint32_t id, const vec3 *at,
                                        double distance);

/* What there is of it, of a mesh that leaves something out. */
enum { COLLISION_EXCLUSION_ARRAYS = 7 };
void vbss_collision_exclusion_arrays(const collision_shape *shape, collision_exclusion *exclusion,
                                     vbss_array arrays[COLLISION_EXCLUSION_ARRAYS]);
/* Lanes, when a tree has another order. */
void vbss_collision_update_excluded_edges(collision_shape *shape);
void vbss_collision_update_excluded_points(collision_shape *shape);

static inline uint64_t near_bit(const uint64_t *row, uint32_t node)
{
    return row[node / 64] >> node % 64 & 1u;
}

/* ---- their boxes (aabb.c) */

/* Forgets what is known of them. */
void vbss_collision_shape_invalidate(collision_shape *shape);
/* Vertices end elsewhere, and candidates stay: for whoever knows that none is missing. */
void vbss_collision_set_end_positions(collision_shape *shape, const vec3 *end);
/* Those of the points, and the one around all. */
void vbss_collision_shape_update_boxes(collision_shape *shape);
/* The trees, once their features are asked for; the points' boxes are known. */
void vbss_collision_shape_refit_points(collision_shape *shape);
void vbss_collision_shape_refit_edges(collision_shape *shape);
void vbss_collision_shape_refit_triangles(collision_shape *shape);

/* ---- the search (bvh_traversal.c, broad_phase.c) */

enum { COLLISION_SORT_DIGITS = 11, COLLISION_SORT_BUCKETS = 1 << COLLISION_SORT_DIGITS };

/* Which pairs with overlapping boxes are candidates. */
typedef enum collision_pair_rule {
    COLLISION_RULE_ALL,         /* of two shapes */
    COLLISION_RULE_CHAIN,       /* edges of one chain: far enough along it */
    COLLISION_RULE_CAPSULES,    /* edges of one shape: each pair once */
    COLLISION_RULE_MESH_EDGES,  /* the same, without a common node */
    COLLISION_RULE_MESH_POINTS, /* a point, and triangles of which it is no corner */
    COLLISION_RULE_FAR_EDGES, /* of a mesh that leaves out what is near: each pair once, no nodes near */
    COLLISION_RULE_FAR_POINTS /* of the same: a point, and triangles of which no corner is near it */
} collision_pair_rule;

typedef struct collision_pair {
    uint32_t a, b;
} collision_pair;

/* Pairs from first to the next run's first are of these shapes. */
typedef struct collision_run {
    vbss_pair_kind kind;
    uint32_t shape_a, shape_b, first;
} collision_run;

typedef struct collision_candidate {
    uint32_t kind, shape_a, a, shape_b, b;
} collision_candidate;

typedef struct collision_traversal {
    const collision_bvh *a, *b; /* of features a and b of the pairs */
    collision_pair_rule rule;
    const collision_shape *shape;  /* the rule is about it */
    const uint8_t *excluded_lanes; /* of a rule about what is near */
    uint32_t *offsets;             /* of features a */
} collision_traversal;

/* Groups of level 1 in the largest tree there is, and one more. */
enum { COLLISION_SEARCH_PARENTS = 393216 / (COLLISION_BVH_WIDTH * COLLISION_BVH_WIDTH) + 1 };
typedef struct collision_search {
    uint32_t *parents_a, *parents_b; /* lists of such groups */
    collision_pair *pairs;           /* COLLISION_BVH_WIDTH more than the capacity */
    uint32_t pair_count, pair_capacity;
    uint64_t boxes_tested;
} collision_search;

/* Adds the candidates of two trees; where tree b has no order, those of one feature a come in the order
 * of b. False when there are more than the capacity. */
bool vbss_collision_traverse_plain(collision_search *search, const collision_traversal *traversal);
bool vbss_collision_traverse_wide(collision_search *search, const collision_traversal *traversal);
/* Features of a tree that meet a box, in no order; returns how many. */
uint32_t vbss_collision_bvh_query_plain(collision_search *search, const collision_bvh *bvh,
                                        const collision_aabb *box, uint32_t *features);
uint32_t vbss_collision_bvh_query_wide(collision_search *search, const collision_bvh *bvh,
                                       const collision_aabb *box, uint32_t *features);

/* ---- what is known to be apart (separation_cache.c), of an object that keeps it */

/* The axes of a candidate were measured: they are so far apart at the start. */
void vbss_collision_store_separation(collision_object *c, const collision_candidate *candidate,
                                     double distance);
/* How far the nodes of a shape go from start to end: after every move that is asked about. */
void vbss_collision_update_displacements(collision_shape *shape);
/* Whether the axes are known to stay farther apart than that, wherever their nodes are between start and end. */
bool vbss_collision_stays_separated(const collision_object *c, const collision_candidate *candidate,
                                    double distance);
/* A search begins, with what the last one found; it has its candidates. */
void vbss_collision_swap_separation_cache(collision_object *c);
void vbss_collision_carry_separations(collision_object *c);

/* ---- the object (object.c) */

/* Candidates tested together. */
enum { COLLISION_BLOCK_SIZE = 64 };
typedef struct collision_block {
    double start[12][COLLISION_BLOCK_SIZE], end[12][COLLISION_BLOCK_SIZE],
        thickness[COLLISION_BLOCK_SIZE];
    double time[COLLISION_BLOCK_SIZE], distance[COLLISION_BLOCK_SIZE];
    double normal[3][COLLISION_BLOCK_SIZE], weights[4][COLLISION_BLOCK_SIZE];
    int32_t hit[COLLISION_BLOCK_SIZE], decision[COLLISION_BLOCK_SIZE];
} collision_block;

struct collision_object {
    vbss_context *context;
    vbss_collision_config config;
    collision_ccd_options ccd_options;
    bool wide;        /* which copy of the hot loops */
    double thickness; /* of the configuration */
    collision_counters counters;
    uint64_t searches, boxes_tested, generation;
    collision_shape **shapes; /* by name; NULL once removed */
    uint32_t shape_count;     /* ever added */
    uint32_t *active_shapes;  /* names, ascending */
    uint32_t active_count;
    bool active_valid;       /* since the last one was added or removed */
    collision_bvh shape_bvh; /* over the roots of the living */
    uint32_t *overlapping;   /* of one shape, places in `living` */
    collision_search search;
    collision_pair *sort_buffer; /* both for sorting pairs */
    uint32_t *buckets;
    collision_run *runs;
    uint32_t run_count, run_capacity;
    collision_candidate *candidates;
    uint32_t candidate_count;
    /* Of an object that keeps it: how far the axes of each candidate are apart at the start, at least; both lists of the last
     * search; how many that one found, and how many this one has. */
    bool caches_separation;
    double *separations, *previous_separations;
    collision_candidate *previous_candidates;
    uint32_t previous_count, separation_count;
    collision_block *block;
    uint32_t *impacts; /* candidates that hit */
    double *times, *distances;
    vec3 *normals;
    double (*weights)[4];
    uint32_t *decisions;
    uint32_t impact_count;
};

extern const vbss_kind vbss_collision_kind;
/* An object of a checked configuration, without a handle, which keeps what is known to be apart, or not; and its end. */
vbss_result vbss_collision_allocate(vbss_context *context, const vbss_collision_config *config,
                                    bool caches_separation, collision_object **collision);
void vbss_collision_free(vbss_context *context, void *object);
vbss_result vbss_collision_open(const vbss_collision *handle, collision_object **collision);
vbss_result vbss_collision_edit(vbss_collision *handle, collision_object **collision);
/* The living shape of that name, or VBSS_ERROR_OUT_OF_RANGE. */
vbss_result vbss_collision_find_shape(const collision_object *c, uint32_t id,
                                      collision_shape **shape);
/* D of a pair of features of these shapes. */
static inline double vbss_collision_contact_distance(const collision_object *c,
                                                     const collision_shape *a,
                                                     const collision_shape *b)
{
    return (a->radius + b->radius) + c->thickness;
}
void vbss_collision_clear_results(collision_object *c); /* candidates and impacts */
void vbss_collision_serialise(vbss_stream *stream, void *object);

#endif
