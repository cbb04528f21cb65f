/* Shapes that move, the trees of boxes over their features, and the object that searches them.
 *
 * A shape has points (its nodes), edges and, if it is a mesh, triangles; each kind of feature has a
 * tree. Boxes are swept over start and end and enlarged by the shape's reach; a search lists the pairs
 * of features whose boxes overlap, whatever the trees look like: docs/collision.md. */
#ifndef VBSS_COLLISION_SHAPES_H
#define VBSS_COLLISION_SHAPES_H

#include "base/memory.h"
#include "base/slot.h"
#include "base/wide.h"
#include "collision/collision.h"

/* ---- boxes */

/* The fourth numbers are 0: padding, so that compilers take two or four numbers at a time. */
typedef struct collision_box {
    double low[4], high[4];
} collision_box;

/* Overlaps nothing, adds nothing. */
static inline collision_box box_none(void)
{
    const double far = (double)INFINITY;
    collision_box none = {{far, far, far, 0.0}, {-far, -far, -far, 0.0}};
    return none;
}

static inline void box_add(collision_box *box, const collision_box *other)
{
    for (int k = 0; k < 4; k++) {
        box->low[k] = lesser(box->low[k], other->low[k]);
        box->high[k] = greater(box->high[k], other->high[k]);
    }
}

/* ---- trees (tree.c) */

/* As many boxes side by side as are looked at together. 393216 edges of the largest mesh make groups
 * of 49152, 6144, 768, 96, 12, 2, 1: seven levels. */
enum { TREE_LANES_LOG = 3, TREE_LANES = 1 << TREE_LANES_LOG, TREE_LEVELS = 7 };
typedef struct box_group {
    double low[3][TREE_LANES], high[3][TREE_LANES];
} box_group;

/* Groups of features, groups of these groups, and so on to one group at the top. Group g is in lane
 * g % TREE_LANES of group g / TREE_LANES of the level above. */
typedef struct collision_tree {
    uint32_t count;             /* of features; 0: no tree */
    uint32_t *order;            /* the feature at each place; NULL: the places are the numbers */
    collision_box *boxes;       /* of the features, by number */
    collision_box *group_boxes; /* of all levels, the lowest first */
    box_group *groups;          /* what is in them */
    uint32_t level_count;
    uint32_t level_groups[TREE_LEVELS]; /* groups in a level */
    uint32_t level_first[TREE_LEVELS];  /* its first group */
    double fresh;                       /* looseness just after ordering; 0: never ordered */
} collision_tree;

/* Groups of all levels over that many features. */
size_t vbss_collision_tree_groups(uint32_t count);
/* Sets the levels, and the order that features come in; `groups` must have room. */
void vbss_collision_tree_set_count(collision_tree *tree, uint32_t count);
/* Takes over changed boxes; orders anew when the groups have become loose, and says so. */
bool vbss_collision_tree_fit(collision_tree *tree);

static inline const collision_box *tree_root(const collision_tree *tree)
{
    return &tree->group_boxes[tree->level_first[tree->level_count - 1]];
}

/* ---- shapes (shapes.c) */

typedef struct collision_object collision_object;

typedef enum collision_shape_kind {
    SHAPE_CHAIN = 1,
    SHAPE_CAPSULES = 2,
    SHAPE_MESH = 3
} collision_shape_kind;

/* What a mesh leaves out: nodes that are near its edges and triangles along the surface, their own too. */
typedef struct collision_near {
    uint32_t words;              /* in a row of bits; 0: nothing is left out */
    uint64_t *edges, *triangles; /* a row for each, of nodes */
    /* The same as a walk asks it, while trees keep their order: for each group of tree a and each place in
     * tree b, which lanes are near. Of edges and edges, of points and triangles. */
    uint8_t *edge_lanes, *point_lanes;
    uint32_t *first_edge, *edges_of; /* of each node, one more at the end; the edges it is in */
    uint32_t *places;                /* scratch: feature -> place */
} collision_near;

typedef struct collision_shape {
    collision_shape_kind kind;
    uint32_t node_count, edge_count, triangle_count;
    uint32_t node_capacity; /* of a chain: there is memory for so many; else node_count */
    double radius;
    double reach;      /* by which boxes are larger than the swept vertices, on every side */
    vec3 *start, *end; /* of the nodes */
    uint32_t (*edges)[2];
    uint32_t (*triangles)[3];
    /* Of a chain: how many edges, from the first on, are far enough along it from each; and the first
     * edge far enough from the first of each group. */
    uint32_t *far_before, *far_after;
    collision_near near;
    uint64_t topology; /* hash of all that never changes */
    uint32_t category, mask;
    bool rigid;       /* never a pair with itself */
    bool edges_only;  /* a mesh whose triangles nobody asks for: no pairs of them */
    bool asleep;      /* a chain that is nowhere yet: never found */
    bool boxes_known; /* of the points, and around all, since the last move */
    bool points_fit, edges_fit, triangles_fit; /* trees know the last move */
    /* Of an object that keeps what is apart; else NULL. Of each node: how far it goes from start to end; where it started in
     * the last search, and how far from there it is. */
    double *goes, *gone;
    vec3 *known_start;
    bool keeps_apart, start_known;
    collision_box root; /* around all */
    collision_tree point_tree, edge_tree, triangle_tree;
    uint32_t *edge_rows, *point_rows; /* candidates of each as a; then where its next one goes */
    bool edge_rows_used, point_rows_used;
} collision_shape;

void vbss_collision_shape_free(vbss_context *context, collision_shape *shape);

/* Chains that change, for who has them inside: one that is nowhere yet; another number of nodes, up to its
 * capacity, with other rest lengths, which wakes it and allocates nothing; and nowhere again. */
vbss_result vbss_collision_add_sleeping_chain(collision_object *c, uint32_t node_capacity,
                                              double radius, uint32_t *name);
void vbss_collision_change_chain(collision_object *c, uint32_t name, uint32_t node_count,
                                 const double *rest_lengths);
void vbss_collision_send_to_sleep(collision_object *c, uint32_t name);

/* Another rule of which of its own pairs are candidates: what was found is no longer true. */
void vbss_collision_rules_changed(collision_object *c, collision_shape *shape);

/* ---- what is near along a surface (near.c) */

/* Of all bits, while they are worked out: a row for each node, edge and triangle. Enough for a surface of 4700
 * nodes; lanes take twice as much again. */
#define NEAR_BYTES (16u << 20)
/* Of a mesh, from now on: edges, and points and triangles, are no candidates if the shortest way over edges
 * between a node of the one and a node of the other is below `distance` when the nodes are `at`; those
 * with a common node never are. VBSS_ERROR_CAPACITY if NEAR_BYTES are not enough. A failure changes
 * nothing. */
vbss_result vbss_collision_leave_out_near(collision_object *c, uint32_t name, const vec3 *at,
                                          double distance);

/* What there is of it, of a mesh that leaves something out. */
enum { NEAR_PARTS = 7 };
void vbss_collision_near_parts(const collision_shape *shape, collision_near *near,
                               vbss_array parts[NEAR_PARTS]);
/* Lanes, when a tree has another order. */
void vbss_collision_near_edge_lanes(collision_shape *shape);
void vbss_collision_near_point_lanes(collision_shape *shape);

static inline uint64_t near_bit(const uint64_t *row, uint32_t node)
{
    return row[node / 64] >> node % 64 & 1u;
}

/* ---- their boxes (boxes.c) */

/* Forgets what is known of them. */
void vbss_collision_shape_moved(collision_shape *shape);
/* Vertices end elsewhere, and candidates stay: for whoever knows that none is missing. */
void vbss_collision_end_elsewhere(collision_shape *shape, const vec3 *end);
/* Those of the points, and the one around all. */
void vbss_collision_shape_boxes(collision_shape *shape);
/* The trees, once their features are asked for; the points' boxes are known. */
void vbss_collision_shape_fit_points(collision_shape *shape);
void vbss_collision_shape_fit_edges(collision_shape *shape);
void vbss_collision_shape_fit_triangles(collision_shape *shape);

/* ---- the search (walk.c, candidates.c) */

enum { SORT_DIGITS = 11, SORT_BUCKETS = 1 << SORT_DIGITS };

/* Which pairs with overlapping boxes are candidates. */
typedef enum collision_rule {
    RULE_ALL,         /* of two shapes */
    RULE_CHAIN,       /* edges of one chain: far enough along it */
    RULE_CAPSULES,    /* edges of one shape: each pair once */
    RULE_MESH_EDGES,  /* the same, without a common node */
    RULE_MESH_POINTS, /* a point, and triangles of which it is no corner */
    RULE_FAR_EDGES,   /* of a mesh that leaves out what is near: each pair once, no nodes near */
    RULE_FAR_POINTS   /* of the same: a point, and triangles of which no corner is near it */
} collision_rule;

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

typedef struct collision_walk {
    const collision_tree *a, *b; /* of features a and b of the pairs */
    collision_rule rule;
    const collision_shape *shape; /* the rule is about it */
    const uint8_t *near_lanes;    /* of a rule about what is near */
    uint32_t *rows;               /* of features a */
} collision_walk;

/* Groups of level 1 in the largest tree there is, and one more. */
enum { SEARCH_PARENTS = 393216 / (TREE_LANES * TREE_LANES) + 1 };
typedef struct collision_search {
    uint32_t *parents_a, *parents_b; /* lists of such groups */
    collision_pair *pairs;           /* TREE_LANES more than the capacity */
    uint32_t pair_count, pair_capacity;
    uint64_t boxes_tested;
} collision_search;

/* Adds the candidates of two trees; where tree b has no order, those of one feature a come in the order
 * of b. False when there are more than the capacity. */
bool vbss_collision_walk_plain(collision_search *search, const collision_walk *walk);
bool vbss_collision_walk_wide(collision_search *search, const collision_walk *walk);
/* Features of a tree that meet a box, in no order; returns how many. */
uint32_t vbss_collision_meet_plain(collision_search *search, const collision_tree *tree,
                                   const collision_box *box, uint32_t *features);
uint32_t vbss_collision_meet_wide(collision_search *search, const collision_tree *tree,
                                  const collision_box *box, uint32_t *features);

/* ---- what is known to be apart (apart.c), of an object that keeps it */

/* The axes of a candidate were measured: they are so far apart at the start. */
void vbss_collision_note_apart(collision_object *c, const collision_candidate *candidate,
                               double distance);
/* How far the nodes of a shape go from start to end: after every move that is asked about. */
void vbss_collision_measure_ways(collision_shape *shape);
/* Whether the axes are known to stay farther apart than that, wherever their nodes are between start and end. */
bool vbss_collision_stays_apart(const collision_object *c, const collision_candidate *candidate,
                                double distance);
/* A search begins, with what the last one found; it has its candidates. */
void vbss_collision_begin_known(collision_object *c);
void vbss_collision_hand_on(collision_object *c);

/* ---- the object (object.c) */

/* Candidates tested together. */
enum { IMPACT_BLOCK = 64 };
typedef struct collision_block {
    double start[12][IMPACT_BLOCK], end[12][IMPACT_BLOCK], thickness[IMPACT_BLOCK];
    double time[IMPACT_BLOCK], distance[IMPACT_BLOCK];
    double normal[3][IMPACT_BLOCK], weights[4][IMPACT_BLOCK];
    int32_t hit[IMPACT_BLOCK], decision[IMPACT_BLOCK];
} collision_block;

struct collision_object {
    vbss_context *context;
    vbss_collision_config config;
    collision_rules rules;
    bool wide;        /* which copy of the hot loops */
    double thickness; /* of the configuration */
    collision_counters counters;
    uint64_t searches, boxes_tested, generation;
    collision_shape **shapes; /* by name; NULL once removed */
    uint32_t shape_count;     /* ever added */
    uint32_t *living;         /* names, ascending */
    uint32_t living_count;
    bool living_known;  /* since the last one was added or removed */
    collision_tree top; /* over the roots of the living */
    uint32_t *partners; /* of one shape, places in `living` */
    collision_search search;
    collision_pair *spare; /* both for sorting pairs */
    uint32_t *buckets;
    collision_run *runs;
    uint32_t run_count, run_capacity;
    collision_candidate *candidates;
    uint32_t candidate_count;
    /* Of an object that keeps it: how far the axes of each candidate are apart at the start, at least; both lists of the last
     * search; how many that one found, and how many this one has. */
    bool keeps_apart;
    double *apart, *known_apart;
    collision_candidate *known;
    uint32_t known_count, listed;
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
                                    bool keeps_apart, collision_object **collision);
void vbss_collision_free(vbss_context *context, void *object);
vbss_result vbss_collision_open(const vbss_collision *handle, collision_object **collision);
vbss_result vbss_collision_edit(vbss_collision *handle, collision_object **collision);
/* The living shape of that name, or VBSS_ERROR_OUT_OF_RANGE. */
vbss_result vbss_collision_find_shape(const collision_object *c, uint32_t name,
                                      collision_shape **shape);
/* D of a pair of features of these shapes. */
static inline double vbss_collision_distance(const collision_object *c, const collision_shape *a,
                                             const collision_shape *b)
{
    return (a->radius + b->radius) + c->thickness;
}
void vbss_collision_forget(collision_object *c); /* candidates and impacts */
void vbss_collision_serialise(vbss_stream *stream, void *object);

#endif
