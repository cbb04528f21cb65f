/* Moving shapes, bounding volume hierarchies over their features, and the object that searches
 * them.
 *
 * A shape has points (its nodes), edges and, if it is a mesh, triangles; each kind of feature has a
 * BVH. AABBs are swept from start to end and inflated. A search lists the pairs of features whose
 * boxes overlap, independently of the trees: docs/explanation/collision.md. */
#ifndef VBSS_COLLISION_SHAPES_H
#define VBSS_COLLISION_SHAPES_H

#include "base/memory.h"
#include "base/slot.h"
#include "base/simd_dispatch.h"
#include "collision/collision.h"

/* ---- AABBs */

/* The fourth numbers are 0: padding that lets compilers process two or four numbers at a time. */
typedef struct collision_aabb {
    double low[4], high[4];
} collision_aabb;

/* A box that overlaps nothing and that extends no other box. */
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

/* ---- BVHs (bvh.c) */

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

/* Groups of features, groups of these groups, and so on up to one group at the top. Group g is in
 * lane g % COLLISION_BVH_WIDTH of group g / COLLISION_BVH_WIDTH of the level above. */
typedef struct collision_bvh {
    uint32_t count;              /* number of features; 0 for no tree */
    uint32_t *order;             /* leaf -> feature; NULL if leaves are in the order of features */
    collision_aabb *boxes;       /* feature -> AABB */
    collision_aabb *group_boxes; /* group -> AABB around it; all levels, lowest first */
    collision_bvh_group *groups; /* group -> AABBs in it */
    uint32_t level_count;
    uint32_t level_groups[COLLISION_BVH_LEVELS]; /* level -> number of groups */
    uint32_t level_first[COLLISION_BVH_LEVELS];  /* level -> its first group */
    double built_looseness; /* looseness just after the last ordering; 0 if never ordered */
} collision_bvh;

/* Number of groups of all levels for this many features. */
size_t vbss_collision_bvh_group_count(uint32_t count);
/* Sets the levels and the natural order of features. `groups` must be large enough. */
void vbss_collision_bvh_set_count(collision_bvh *bvh, uint32_t count);
/* Updates the tree to changed boxes. Reorders the features if the groups have become loose, and
 * returns whether it did. */
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

/* Pairs that a mesh excludes because they are close along its surface (geodesic exclusion). */
typedef struct collision_exclusion {
    uint32_t words;              /* length of a row of bits; 0 if nothing is excluded */
    uint64_t *edges, *triangles; /* one row for each edge and triangle, one bit for each node */
    /* The same data for the traversal, valid for the present order of the trees: for each group of
     * tree a and each leaf of tree b, the excluded lanes. For edge pairs, and for points and
     * triangles. */
    uint8_t *edge_lanes, *point_lanes;
    /* node -> its first entry of edges_of, one extra at the end; the edges at each node */
    uint32_t *first_edge, *edges_of;
    uint32_t *leaf_of; /* scratch: feature -> leaf */
} collision_exclusion;

/* A mesh that moves as a rigid body (posed_mesh.c). Its trees are in the frame of the mesh and never
 * change. A search takes the boxes of other shapes into that frame, and sets the positions of those
 * nodes only that belong to a pair. */
typedef struct collision_posed {
    vec3 *local;     /* node positions in the frame of the mesh, m */
    pose start, end; /* of the frame in the motion */
    /* Nodes move along straight lines by this multiple of their displacements from start to end. */
    double extrapolation;
    vec3 centre, half; /* box around `local`, without inflation: its centre and half its sides, m */
    double reach; /* largest distance of a corner of it from the origin of the frame, or more, m */
    vec3 moved_low, moved_high; /* bounds of the displacements, in the frame of the start, m */
    /* Poses of the start of the last two searches: of the present one and of that before. */
    pose searched, previous;
    uint32_t search_count; /* of these poses that are set, 0 to 2 */
    /* Nodes whose positions are set for the present motion: a list, and a mark for each node. */
    uint32_t *set_nodes, *mark;
    uint32_t set_count, present_mark;
    uint32_t *found;        /* scratch: features near a box */
    bool is_near, was_near; /* another shape is near in this search, and was in the one before */
} collision_posed;

typedef struct collision_shape {
    collision_shape_kind kind;
    uint32_t node_count, edge_count, triangle_count;
    uint32_t node_capacity; /* allocated nodes of a chain; otherwise node_count */
    double radius;
    double inflation;  /* inflation of the swept boxes on every side, m */
    vec3 *start, *end; /* node positions at start and end of the motion, m */
    uint32_t (*edges)[2];
    uint32_t (*triangles)[3];
    /* Chain: the number of first edges that are far enough along it from each edge; and the first
     * edge that is far enough from the first one of each group. */
    uint32_t *far_before, *far_after;
    collision_exclusion exclusion;
    collision_posed *posed; /* NULL unless the shape is a posed mesh */
    uint64_t topology_hash; /* hash of all data that never changes */
    uint32_t category, mask;
    bool is_rigid;          /* never forms pairs with itself */
    bool is_static;         /* never moves after its first motion: its boxes are never loose */
    bool is_search_at_rest; /* static: search_displacement is 0 for all nodes */
    bool edges_only;        /* a mesh without point-triangle pairs */
    bool is_disabled;       /* a chain that is not in use; a search ignores it */
    bool boxes_valid;       /* boxes of the points and of the shape are up to date */
    bool point_bvh_valid, edge_bvh_valid, triangle_bvh_valid; /* trees are up to date */
    /* Near pairs, otherwise NULL: the swept boxes of the points. The trees then hold loose boxes,
     * which contain them. */
    collision_aabb *swept_boxes;
    collision_aabb loose_root; /* AABB of the loose boxes of the points */
    bool is_tight;             /* loose boxes are the swept boxes */
    bool has_loose_boxes;      /* loose boxes belong to the present nodes */
    bool has_new_loose_boxes;  /* loose boxes have changed since near pairs were listed */
    /* Separation cache, otherwise NULL. For each node: displacement from start to end; displacement
     * since the last search; start position of the last search. */
    double *displacement, *search_displacement;
    double max_displacement; /* of all nodes from start to end */
    vec3 *search_start;
    bool caches_separation, has_search_start;
    collision_aabb root; /* AABB of the whole shape */
    collision_bvh point_bvh, edge_bvh, triangle_bvh;
    /* feature a -> number of its candidates, then the index of its next one */
    uint32_t *edge_offsets, *point_offsets;
    bool edge_offsets_used, point_offsets_used;
} collision_shape;

/* Adds a complete shape to the object and assigns its id. */
void vbss_collision_register_shape(collision_object *c, collision_shape *shape, uint32_t *id);

/* Checks that apply to all kinds of shapes. `id`: where the caller wants the id. */
vbss_result vbss_collision_check_new_shape(const collision_object *c, double radius,
                                           const uint32_t *id);

/* Lets the next shape have the id `next`, at most shape_capacity: those before it never exist. */
void vbss_collision_skip_shapes(collision_object *c, uint32_t next);

/* Chains with a variable number of nodes. A disabled chain only reserves memory. Resizing sets a
 * number of nodes, up to its capacity, and rest lengths; it enables the chain and does not
 * allocate. Disabling keeps the memory. */
vbss_result vbss_collision_add_disabled_chain(collision_object *c, uint32_t node_capacity,
                                              double radius, uint32_t *id);
void vbss_collision_resize_chain(collision_object *c, uint32_t id, uint32_t node_count,
                                 const double *rest_lengths);
void vbss_collision_disable_chain(collision_object *c, uint32_t id);

/* ---- meshes (meshes.c) */

/* Creates a mesh that is not part of the object yet, from numbers that have been checked. */
vbss_result vbss_collision_create_mesh(collision_object *c, uint32_t node_count,
                                       const uint32_t *triangles, uint32_t triangle_count,
                                       double radius, collision_shape **shape);
/* Puts a shape in the place of another, whose id it gets. Returns the other one, which the caller frees. */
collision_shape *vbss_collision_exchange_shape(collision_object *c, uint32_t id,
                                               collision_shape *shape);

/* ---- posed meshes (add_posed_mesh.c, posed_mesh.c), for objects created with caches_separation */

/* Makes a new mesh a posed one, at a pose. `positions`: three finite numbers for each of its nodes, in the
 * frame in which the frame of the mesh has the pose `frame`; NULL: in the frame of the mesh.
 * VBSS_ERROR_OUT_OF_MEMORY; then nothing has changed. */
vbss_result vbss_collision_make_posed(collision_object *c, uint32_t id, const double *positions,
                                      const pose *frame, pose at);
enum { COLLISION_POSED_ARRAYS = 4 };
void vbss_collision_list_posed_arrays(const collision_shape *shape, collision_posed *posed,
                                      vbss_array arrays[COLLISION_POSED_ARRAYS]);
void vbss_collision_free_posed(vbss_context *context, collision_shape *shape);

/* Sets the motion of a posed mesh, as vbss_collision_set_motion that of another shape: its nodes move
 * by `extrapolation` times their displacements from start to end. */
vbss_result vbss_collision_set_pose_motion(collision_object *c, uint32_t id, pose start, pose end,
                                           double extrapolation);
/* Changes the end pose, as vbss_collision_set_end_positions; updates the displacements as well. */
void vbss_collision_set_end_pose(collision_shape *shape, pose end);
/* Bound of the distance of any node of a posed mesh between two poses, m: the largest component, and the
 * norm. 0 for equal poses. */
double vbss_collision_largest_offset(const collision_shape *shape, pose from, pose to);
double vbss_collision_largest_distance(const collision_shape *shape, pose from, pose to);
/* Whether a motion begins at a pose, to the bit. */
bool vbss_collision_begins_at(const collision_shape *shape, const pose *at);

/* Begins a set of nodes, of which none has positions yet. */
void vbss_collision_begin_posed_set(collision_shape *shape);
/* Steps of a search: updates a cube around the whole mesh, or its box; begins the set of its nodes; finds out whether other
 * shapes are near. */
void vbss_collision_update_posed_cube(collision_shape *shape);
void vbss_collision_update_posed_box(collision_shape *shape);
void vbss_collision_begin_posed_search(collision_shape *shape);
void vbss_collision_find_near_posed(collision_object *c);
/* Sets the positions, swept boxes and displacements of nodes for the present motion. */
void vbss_collision_set_posed_nodes(collision_shape *shape, const uint32_t *nodes, uint32_t count);
/* A feature of another shape: its nodes. */
typedef struct collision_feature_nodes {
    const uint32_t *nodes;
    uint32_t count;
} collision_feature_nodes;
/* Lists the features in a tree of a posed mesh that a feature of another shape may come near, in
 * `posed->found`. Returns their number. */
uint32_t vbss_collision_query_posed(collision_object *c, const collision_shape *mesh,
                                    const collision_bvh *tree, const collision_shape *other,
                                    collision_feature_nodes feature);
/* Box in the frame of a pose around a box in the world. */
collision_aabb vbss_collision_box_in_frame(const collision_aabb *box, pose at);

/* ---- memory of shapes (shape_memory.c) */

/* Creates a shape without topology. `counts` gives its nodes, edges and triangles, which must be in
 * range; `radius` is in m. */
vbss_result vbss_collision_create_shape(collision_object *c, collision_shape_kind kind,
                                        const uint32_t counts[3], double radius,
                                        collision_shape **shape);
void vbss_collision_shape_free(vbss_context *context, collision_shape *shape);

/* Arrays of a mesh's exclusion. */
enum { COLLISION_EXCLUSION_ARRAYS = 7 };
void vbss_collision_exclusion_arrays(const collision_shape *shape, collision_exclusion *exclusion,
                                     vbss_array arrays[COLLISION_EXCLUSION_ARRAYS]);

/* ---- topology of shapes (topology.c) */

/* Hash of all data of a shape that never changes. */
uint64_t vbss_collision_hash_topology(collision_shape *shape);
/* Invalidates all results after a change of the pairs that a shape excludes. */
void vbss_collision_update_pair_rules(collision_object *c, collision_shape *shape);

/* ---- geodesic exclusion (geodesic_exclusion.c) */

/* Memory for the exclusion bits while they are computed: a row for each node, edge and triangle. It is enough
 * for a surface of 4700 nodes. Lanes take twice as much in addition. */
#define COLLISION_EXCLUSION_BYTES (16u << 20)
/* Excludes pairs of features of a mesh that are close along its surface: edge pairs, and points
 * with triangles. A pair is excluded if the shortest path along edges between a node of one and a
 * node of the other is below `distance`, m, for the node positions `at`. Pairs with a common node
 * are always excluded. VBSS_ERROR_CAPACITY if COLLISION_EXCLUSION_BYTES are not enough. A failure
 * changes nothing. */
vbss_result vbss_collision_exclude_near(collision_object *c, uint32_t id, const vec3 *at,
                                        double distance);

/* The larger of the numbers of edges and triangles: enough entries for a list of near features. */
static inline uint32_t collision_max_features(const collision_shape *shape)
{
    return shape->edge_count > shape->triangle_count ? shape->edge_count : shape->triangle_count;
}

/* Updates the excluded lanes after a tree has been reordered. */
void vbss_collision_update_excluded_edges(collision_shape *shape);
void vbss_collision_update_excluded_points(collision_shape *shape);

static inline uint64_t near_bit(const uint64_t *row, uint32_t node)
{
    return row[node / 64] >> node % 64 & 1u;
}

/* ---- AABBs of shapes (aabb.c) */

/* Marks all boxes, and trees of swept boxes, as out of date. */
void vbss_collision_shape_invalidate(collision_shape *shape);
/* Marks all trees as out of date. */
void vbss_collision_shape_invalidate_trees(collision_shape *shape);
/* Changes the end positions without invalidating the candidates. The caller must know that none is
 * missing. */
void vbss_collision_set_end_positions(collision_shape *shape, const vec3 *end);
/* Updates the boxes of the points and of the whole shape. */
void vbss_collision_shape_update_boxes(collision_shape *shape);
/* Update one tree when its features are needed; the boxes of the points must be up to date. */
void vbss_collision_shape_refit_points(collision_shape *shape);
void vbss_collision_shape_refit_edges(collision_shape *shape);
void vbss_collision_shape_refit_triangles(collision_shape *shape);

/* ---- broad phase (bvh_traversal.c, broad_phase.c) */

enum { COLLISION_SORT_DIGITS = 11, COLLISION_SORT_BUCKETS = 1 << COLLISION_SORT_DIGITS };

/* Rule that decides which pairs with overlapping boxes are candidates. */
typedef enum collision_pair_rule {
    COLLISION_RULE_ALL,        /* two different shapes */
    COLLISION_RULE_CHAIN,      /* edges of one chain: those far enough along it */
    COLLISION_RULE_CAPSULES,   /* edges of one shape: each pair once */
    COLLISION_RULE_MESH_EDGES, /* edges of one mesh: each pair once, without a common node */
    /* a mesh with itself: a point, and triangles without it as a corner */
    COLLISION_RULE_MESH_POINTS,
    /* edges of a mesh with geodesic exclusion: each pair once, no close nodes */
    COLLISION_RULE_FAR_EDGES,
    /* a mesh with geodesic exclusion: a point, and triangles without a close corner */
    COLLISION_RULE_FAR_POINTS
} collision_pair_rule;

typedef struct collision_pair {
    uint32_t a, b;
} collision_pair;

/* Pairs of two shapes: from `first` to the `first` of the next run. */
typedef struct collision_run {
    vbss_collision_pair_kind kind;
    uint32_t shape_a, shape_b, first;
} collision_run;

typedef struct collision_candidate {
    uint32_t kind, shape_a, a, shape_b, b;
} collision_candidate;

/* The order of candidates: negative, 0 or positive if p is before, equal to or after q. */
static inline int vbss_collision_compare_candidates(const collision_candidate *p,
                                                    const collision_candidate *q)
{
    const uint32_t x[5] = {p->kind, p->shape_a, p->a, p->shape_b, p->b};
    const uint32_t y[5] = {q->kind, q->shape_a, q->a, q->shape_b, q->b};
    for (int i = 0; i < 5; i++) {
        if (x[i] != y[i]) {
            return x[i] < y[i] ? -1 : 1;
        }
    }
    return 0;
}

typedef struct collision_traversal {
    const collision_bvh *a, *b; /* trees of the features a and b of the pairs */
    collision_pair_rule rule;
    const collision_shape *shape;  /* subject of the rule */
    const uint8_t *excluded_lanes; /* used by rules with geodesic exclusion */
    uint32_t *offsets;             /* per feature a */
} collision_traversal;

/* Groups of level 1 in the largest tree there is, and one more. */
enum { COLLISION_SEARCH_PARENTS = 393216 / (COLLISION_BVH_WIDTH * COLLISION_BVH_WIDTH) + 1 };
typedef struct collision_search {
    uint32_t *parents_a, *parents_b; /* lists of such groups */
    collision_pair *pairs;           /* capacity plus COLLISION_BVH_WIDTH */
    uint32_t pair_count, pair_capacity;
    uint64_t boxes_tested;
} collision_search;

/* Adds the candidates of two trees. If tree b has its natural order, the candidates of each feature
 * a come in the order of b. Returns false if there are more than the capacity. */
bool vbss_collision_traverse_plain(collision_search *search, const collision_traversal *traversal);
bool vbss_collision_traverse_wide(collision_search *search, const collision_traversal *traversal);
/* Lists the features whose boxes overlap a box, in any order. Returns their number. */
uint32_t vbss_collision_bvh_query_plain(collision_search *search, const collision_bvh *bvh,
                                        const collision_aabb *box, uint32_t *features);
uint32_t vbss_collision_bvh_query_wide(collision_search *search, const collision_bvh *bvh,
                                       const collision_aabb *box, uint32_t *features);

/* ---- near pairs (near_pairs.c), for objects created with caches_separation */

/* Lets the loose boxes contain the swept boxes. They stay as they are if they do already. */
void vbss_collision_fit_loose_boxes(collision_shape *shape);
/* Makes the loose boxes of all active shapes equal to the swept boxes, or lets them be looser again
 * once they are next set. */
void vbss_collision_tighten_boxes(collision_object *c);
void vbss_collision_allow_loose_boxes(collision_object *c);
/* Whether near pairs have to be listed again for some shapes: those with new loose boxes, or all if
 * the list is not valid. */
bool vbss_collision_have_boxes_changed(collision_object *c);
/* Replaces the near pairs of shapes with new loose boxes by the first `count` candidates. Separations
 * stay with their pairs. Returns false, and changes nothing, if the list does not fit. */
bool vbss_collision_merge_near_pairs(collision_object *c, uint32_t count);
/* Lists the near pairs whose swept boxes overlap as candidates, and reduces the separations of all
 * near pairs by the motion since the last search. Returns false if there are more candidates than
 * the capacity. */
bool vbss_collision_filter_near_pairs(collision_object *c);

/* ---- separation cache (separation_cache.c), for objects created with caches_separation */

/* Stores the measured distance of a candidate's axes at the start. */
void vbss_collision_store_separation(collision_object *c, const collision_candidate *candidate,
                                     double distance);
/* Computes the displacements of a shape's nodes from start to end. Call it after every move, before
 * vbss_collision_stays_separated. */
void vbss_collision_update_displacements(collision_shape *shape);
/* Whether the cache proves that the axes stay farther apart than `distance`, m, for all positions
 * of their nodes between start and end. */
bool vbss_collision_stays_separated(const collision_object *c, const collision_candidate *candidate,
                                    double distance);
/* The same for the distance at the start, which is measured if the cache does not suffice. The answer
 * does not depend on the cache, so the state of a caller may depend on it. */
bool vbss_collision_is_separated(const collision_object *c, const collision_candidate *candidate,
                                 double distance);
/* Updates the motion of all nodes since the last search. */
void vbss_collision_update_search_displacements(collision_object *c);
/* Exchanges the near pairs and their separations with the list before. */
void vbss_collision_swap_separation_cache(collision_object *c);
/* The largest of these values over two or three nodes. */
static inline double max_over_nodes(const double *of_nodes, const uint32_t *nodes, uint32_t count)
{
    double largest = of_nodes[nodes[0]];
    for (uint32_t k = 1; k < count; k++) {
        largest = vbss_max(of_nodes[nodes[k]], largest);
    }
    return largest;
}

/* ---- the object */

/* Number of candidates tested together. */
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
    vbss_baseline_config baseline_config; /* what config.baseline points to */
    collision_ccd_options ccd_options;
    bool wide;        /* use the AVX2 copies of the hot loops */
    double thickness; /* thickness of the configuration, m */
    collision_counters counters;
    uint64_t searches, boxes_tested, generation;
    collision_shape **shapes; /* indexed by id; NULL once removed */
    uint32_t shape_count;     /* number of shapes ever added */
    uint32_t *active_shapes;  /* ids of the shapes in use, ascending */
    uint32_t active_count, active_capacity;
    bool active_valid;       /* active_shapes is up to date */
    collision_bvh shape_bvh; /* BVH over the root boxes of the active shapes */
    uint32_t *overlapping;   /* shapes that overlap one shape, as indices of active_shapes */
    collision_search search;
    uint32_t *buckets; /* scratch of the sort of pairs, with the memory of candidates */
    collision_run *runs;
    uint32_t run_count, run_capacity;
    collision_candidate *candidates;
    uint32_t candidate_count;
    /* Near pairs: all pairs whose loose boxes overlap, in the order of candidates. Candidates are
     * some of them; near_index is the index of each among the near pairs. The list stays valid
     * until a swept box leaves its loose box. */
    bool caches_separation;
    collision_candidate *near_pairs, *previous_pairs;
    uint32_t near_count, previous_count;
    bool near_valid;         /* false: all near pairs have to be listed again */
    uint32_t tight_searches; /* searches left without loose boxes, as near pairs did not fit */
    uint32_t *near_index;
    /* Separation cache: lower bounds of the distances of the near pairs' axes at the start, m; and
     * those of the list before. */
    double *separations, *previous_separations;
    collision_block *block;
    uint32_t *impacts; /* indices of the candidates that hit */
    double *times, *distances;
    vec3 *normals;
    double (*weights)[4];
    uint32_t *decisions;
    uint32_t impact_count;
};

/* Lower bound of the distance of a candidate's axes at the start, m; 0 or less if none is known. */
static inline double collision_separation(const collision_object *c, const collision_candidate *q)
{
    return c->separations[c->near_index[q - c->candidates]];
}

/* ---- handles (handle.c) */

/* The kind of all handles of collision objects. */
extern const vbss_kind vbss_collision_kind;
/* The object behind a handle, for a query or for a change. */
vbss_result vbss_collision_open(const vbss_collision *handle, collision_object **collision);
vbss_result vbss_collision_edit(vbss_collision *handle, collision_object **collision);

/* ---- memory and results of objects (object.c), snapshots (snapshot.c) */

/* Creates and destroys an object without a handle, from a checked configuration. A search may find at
 * most active_capacity shapes in use, of all that were ever added. */
vbss_result vbss_collision_allocate(vbss_context *context, const vbss_collision_config *config,
                                    uint32_t active_capacity, bool caches_separation,
                                    collision_object **collision);
void vbss_collision_free(vbss_context *context, void *object);
/* The shape with this id, or VBSS_ERROR_NOT_FOUND. */
vbss_result vbss_collision_find_shape(const collision_object *c, uint32_t id,
                                      collision_shape **shape);
/* Contact distance D of two shapes, m. */
static inline double vbss_collision_contact_distance(const collision_object *c,
                                                     const collision_shape *a,
                                                     const collision_shape *b)
{
    return (a->radius + b->radius) + c->thickness;
}
void vbss_collision_clear_results(collision_object *c); /* Removes candidates and impacts. */
void vbss_collision_serialise(vbss_stream *stream, void *object);

#endif
