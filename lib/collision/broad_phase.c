/* Broad phase: selects the pairs of shapes to traverse, and sorts the candidates.
 *
 * For each shape b in turn, all shapes a that overlap it are traversed with it. The pairs of a
 * traversal are sorted by feature b if they do not come in that order. The pairs of any feature a
 * are then sorted by shape and feature b, and one counting sort by shape and feature a completes
 * the order. The result does not depend on the trees. */
#include "base/api_call.h"
#include "base/check.h"
#include "base/error.h"
#include "collision/shapes.h"
#include "collision/tuning.h"

#include <string.h>

/* ---- boxes of moved shapes */

static void list_active_shapes(collision_object *c)
{
    c->active_count = 0;
    for (uint32_t id = 0; id < c->shape_count; id++) {
        if (c->shapes[id] != NULL && !c->shapes[id]->is_disabled) {
            c->active_shapes[c->active_count++] = id;
        }
    }
    vbss_collision_bvh_set_count(&c->shape_bvh, c->active_count);
    c->active_valid = true;
    c->near_valid = false;
}

static void update_shapes(collision_object *c)
{
    if (!c->active_valid) {
        list_active_shapes(c);
    }
    bool has_posed = false;
    for (uint32_t i = 0; i < c->active_count; i++) {
        collision_shape *s = c->shapes[c->active_shapes[i]];
        if (s->posed == NULL) {
            vbss_collision_shape_update_boxes(s);
        } else {
            vbss_collision_update_posed_cube(s);
            has_posed = true;
        }
    }
    if (has_posed) {
        vbss_collision_find_near_posed(c);
    }
}

static void refit_shapes(collision_object *c)
{
    for (uint32_t i = 0; i < c->active_count; i++) {
        collision_shape *s = c->shapes[c->active_shapes[i]];
        c->shape_bvh.boxes[i] = s->swept_boxes != NULL ? s->loose_root : s->root;
        s->edge_offsets_used = s->point_offsets_used = false;
    }
    if (c->active_count > 0) {
        vbss_collision_bvh_refit(&c->shape_bvh);
    }
}

/* ---- traversals */

static uint32_t *edge_offsets_of(collision_shape *s)
{
    if (!s->edge_offsets_used) {
        memset(s->edge_offsets, 0, s->edge_count * sizeof *s->edge_offsets);
        s->edge_offsets_used = true;
    }
    return s->edge_offsets;
}

static uint32_t *point_offsets_of(collision_shape *s)
{
    if (!s->point_offsets_used) {
        memset(s->point_offsets, 0, s->node_count * sizeof *s->point_offsets);
        s->point_offsets_used = true;
    }
    return s->point_offsets;
}

/* Turns counts of candidates into the index of each first one. */
static uint32_t exclusive_scan(uint32_t *offsets, uint32_t count, uint32_t offset)
{
    for (uint32_t i = 0; i < count; i++) {
        uint32_t here = offsets[i];
        offsets[i] = offset;
        offset += here;
    }
    return offset;
}

/* ---- sorting the pairs of a traversal in tree order */

static void insertion_sort(collision_pair *pairs, uint32_t count)
{
    for (uint32_t i = 1; i < count; i++) {
        collision_pair pair = pairs[i];
        uint32_t k = i;
        for (; k > 0 && pairs[k - 1].b > pair.b; k--) {
            pairs[k] = pairs[k - 1];
        }
        pairs[k] = pair;
    }
}

/* Sorts by b, which is below `features`. Pairs with equal b may come in any order. Candidates are
 * written when all pairs are sorted, so their memory serves as the second buffer. */
static void radix_sort(collision_object *c, uint32_t first, uint32_t features)
{
    collision_pair *pairs = c->search.pairs + first, *spare = (void *)c->candidates;
    uint32_t count = c->search.pair_count - first, *offsets = c->buckets;
    if (count <= COLLISION_INSERTION_SORT_LIMIT) {
        insertion_sort(pairs, count);
        return;
    }
    for (uint32_t shift = 0; shift == 0 || (features - 1) >> shift != 0;
         shift += COLLISION_SORT_DIGITS) {
        memset(offsets, 0, COLLISION_SORT_BUCKETS * sizeof *offsets);
        for (uint32_t i = 0; i < count; i++) {
            offsets[pairs[i].b >> shift & (COLLISION_SORT_BUCKETS - 1)]++;
        }
        exclusive_scan(offsets, COLLISION_SORT_BUCKETS, 0);
        for (uint32_t i = 0; i < count; i++) {
            spare[offsets[pairs[i].b >> shift & (COLLISION_SORT_BUCKETS - 1)]++] = pairs[i];
        }
        memcpy(pairs, spare, count * sizeof *pairs);
    }
}

/* Traverses two trees and stores the run if it has candidates. */
static bool collect_pairs(collision_object *c, const collision_traversal *w,
                          vbss_collision_pair_kind kind, uint32_t a, uint32_t b)
{
    const collision_run run = {kind, c->active_shapes[a], c->active_shapes[b],
                               c->search.pair_count};
    c->runs[c->run_count] = run; /* there is room for one run more than there can be candidates */
    if (!VBSS_WIDE_CALL(c->wide, vbss_collision_traverse, &c->search, w)) {
        return false;
    }
    if (w->b->order != NULL) {
        radix_sort(c, run.first, w->b->count);
    }
    c->run_count += c->search.pair_count > run.first;
    return true;
}

/* ---- pairs with a posed mesh */

/* A kind of features of a shape, one of them a posed mesh: its tree there, and where their nodes are. */
typedef struct posed_side {
    collision_shape *shape;
    const collision_bvh *tree;
    const uint32_t *nodes; /* NULL: a feature is a node */
    uint32_t count, nodes_each;
} posed_side;

static posed_side points_of(collision_shape *s)
{
    return (posed_side){s, &s->point_bvh, NULL, s->node_count, 1};
}

static posed_side edges_of(collision_shape *s)
{
    return (posed_side){s, &s->edge_bvh, s->edges[0], s->edge_count, 2};
}

static posed_side triangles_of(collision_shape *s)
{
    return (posed_side){s, &s->triangle_bvh, s->triangles[0], s->triangle_count, 3};
}

static bool push_pair(collision_search *search, uint32_t *offsets, uint32_t a, uint32_t b)
{
    if (search->pair_count == search->pair_capacity) {
        return false;
    }
    search->pairs[search->pair_count++] = (collision_pair){a, b};
    offsets[a]++;
    return true;
}

/* Pairs every feature of the other shape with those of the posed mesh that it may come near. */
static bool collect_posed_pairs(collision_object *c, const posed_side *a, const posed_side *b,
                                uint32_t *offsets)
{
    const bool is_a_posed = a->shape->posed != NULL;
    const posed_side *mesh = is_a_posed ? a : b, *other = is_a_posed ? b : a;
    const uint32_t *found = mesh->shape->posed->found;
    for (uint32_t i = 0; i < other->count; i++) {
        const collision_feature_nodes feature = {
            other->nodes != NULL ? other->nodes + (size_t)other->nodes_each * i : &i,
            other->nodes_each};
        const uint32_t count =
            vbss_collision_query_posed(c, mesh->shape, mesh->tree, other->shape, feature);
        for (uint32_t k = 0; k < count; k++) {
            if (!push_pair(&c->search, offsets, is_a_posed ? found[k] : i,
                           is_a_posed ? i : found[k])) {
                return false;
            }
        }
    }
    return true;
}

/* Stores the run of two shapes, one of them a posed mesh. Two posed meshes have no pairs. */
static bool collect_posed_run(collision_object *c, vbss_collision_pair_kind kind, uint32_t a,
                              uint32_t b)
{
    collision_shape *s = c->shapes[c->active_shapes[a]], *other = c->shapes[c->active_shapes[b]];
    const bool edges = kind == VBSS_COLLISION_PAIR_EDGE_EDGE;
    const posed_side first = edges ? edges_of(s) : points_of(s);
    const posed_side second = edges ? edges_of(other) : triangles_of(other);
    const collision_run run = {kind, c->active_shapes[a], c->active_shapes[b],
                               c->search.pair_count};
    if (s->posed != NULL && other->posed != NULL) {
        return true;
    }
    c->runs[c->run_count] = run;
    if (!collect_posed_pairs(c, &first, &second,
                             edges ? edge_offsets_of(s) : point_offsets_of(s))) {
        return false;
    }
    if (other->posed != NULL) {
        radix_sort(c, run.first, second.count);
    }
    c->run_count += c->search.pair_count > run.first;
    return true;
}

static bool has_posed(const collision_object *c, uint32_t a, uint32_t b)
{
    return c->shapes[c->active_shapes[a]]->posed != NULL ||
           c->shapes[c->active_shapes[b]]->posed != NULL;
}

/* ---- pairs of features */

/* Rule for the edges of one shape. */
static collision_pair_rule rule_of_edges(const collision_shape *s)
{
    return s->kind == COLLISION_SHAPE_CHAIN      ? COLLISION_RULE_CHAIN
           : s->kind == COLLISION_SHAPE_CAPSULES ? COLLISION_RULE_CAPSULES
           : s->exclusion.words > 0              ? COLLISION_RULE_FAR_EDGES
                                                 : COLLISION_RULE_MESH_EDGES;
}

static collision_pair_rule rule_of_points(const collision_shape *mesh)
{
    return mesh->exclusion.words > 0 ? COLLISION_RULE_FAR_POINTS : COLLISION_RULE_MESH_POINTS;
}

static bool collect_edge_pairs(collision_object *c, uint32_t a, uint32_t b)
{
    collision_shape *s = c->shapes[c->active_shapes[a]], *other = c->shapes[c->active_shapes[b]];
    if (s == other && s->edge_count < 2) {
        return true;
    }
    if (has_posed(c, a, b)) {
        return collect_posed_run(c, VBSS_COLLISION_PAIR_EDGE_EDGE, a, b);
    }
    vbss_collision_shape_refit_edges(s);
    vbss_collision_shape_refit_edges(other);
    const collision_traversal w = {.a = &s->edge_bvh,
                                   .b = &other->edge_bvh,
                                   .rule = s == other ? rule_of_edges(s) : COLLISION_RULE_ALL,
                                   .shape = s,
                                   .excluded_lanes = s->exclusion.edge_lanes,
                                   .offsets = edge_offsets_of(s)};
    return collect_pairs(c, &w, VBSS_COLLISION_PAIR_EDGE_EDGE, a, b);
}

static bool collect_point_pairs(collision_object *c, uint32_t a, uint32_t b)
{
    collision_shape *s = c->shapes[c->active_shapes[a]], *mesh = c->shapes[c->active_shapes[b]];
    if (has_posed(c, a, b)) {
        return collect_posed_run(c, VBSS_COLLISION_PAIR_POINT_TRIANGLE, a, b);
    }
    vbss_collision_shape_refit_points(s);
    vbss_collision_shape_refit_triangles(mesh);
    const collision_traversal w = {.a = &s->point_bvh,
                                   .b = &mesh->triangle_bvh,
                                   .rule = s == mesh ? rule_of_points(s) : COLLISION_RULE_ALL,
                                   .shape = mesh,
                                   .excluded_lanes = mesh->exclusion.point_lanes,
                                   .offsets = point_offsets_of(s)};
    return collect_pairs(c, &w, VBSS_COLLISION_PAIR_POINT_TRIANGLE, a, b);
}

static bool filtered_out(const collision_object *c, uint32_t a, uint32_t b)
{
    const collision_shape *s = c->shapes[c->active_shapes[a]],
                          *other = c->shapes[c->active_shapes[b]];
    bool is_listed = c->caches_separation && !s->has_new_loose_boxes && !other->has_new_loose_boxes;
    return is_listed || (a == b && s->is_rigid) || (s->category & other->mask) == 0 ||
           (other->category & s->mask) == 0;
}

static bool do_shapes_overlap(const collision_object *c, uint32_t a, uint32_t b)
{
    const collision_aabb *p = &c->shape_bvh.boxes[a], *q = &c->shape_bvh.boxes[b];
    bool overlap = true;
    for (int k = 0; k < 3; k++) {
        overlap = overlap && p->low[k] <= q->high[k] && q->low[k] <= p->high[k];
    }
    return overlap;
}

/* Pairs of edges of posed meshes with those of shapes behind them in the table. Shape a is the other one, whatever the
 * ids: the counting sort then has no entries for the edges of the mesh, which may be many. These runs come first, in the
 * order of the meshes, so that all pairs of an edge a come in the order of shapes b. */
static bool find_posed_edge_pairs(collision_object *c)
{
    for (uint32_t m = 0; m < c->active_count; m++) {
        const collision_shape *mesh = c->shapes[c->active_shapes[m]];
        const bool is_near = mesh->posed != NULL && mesh->posed->is_near;
        for (uint32_t i = is_near ? m + 1 : c->active_count; i < c->active_count; i++) {
            if (do_shapes_overlap(c, i, m) && !filtered_out(c, i, m) &&
                !collect_edge_pairs(c, i, m)) {
                return false;
            }
        }
    }
    return true;
}

static bool find_pairs(collision_object *c)
{
    c->run_count = c->search.pair_count = 0;
    if (!find_posed_edge_pairs(c)) {
        return false;
    }
    for (uint32_t b = 0; b < c->active_count; b++) {
        const collision_shape *s = c->shapes[c->active_shapes[b]];
        bool mesh = s->kind == COLLISION_SHAPE_MESH && !s->edges_only;
        uint32_t count = VBSS_WIDE_CALL(c->wide, vbss_collision_bvh_query, &c->search,
                                        &c->shape_bvh, &c->shape_bvh.boxes[b], c->overlapping);
        for (uint32_t i = 0; i < count; i++) {
            uint32_t a = c->overlapping[i];
            if (filtered_out(c, a, b)) {
                continue;
            }
            const bool is_behind_posed = a < b && c->shapes[c->active_shapes[a]]->posed != NULL;
            if (a <= b && !is_behind_posed && !collect_edge_pairs(c, a, b)) {
                return false;
            }
            if (mesh && !collect_point_pairs(c, a, b)) {
                return false;
            }
        }
    }
    return true;
}

/* ---- order of the candidates */

static void compute_offsets(collision_object *c)
{
    uint32_t offset = 0;
    for (uint32_t i = 0; i < c->active_count; i++) {
        collision_shape *s = c->shapes[c->active_shapes[i]];
        offset =
            s->edge_offsets_used ? exclusive_scan(s->edge_offsets, s->edge_count, offset) : offset;
    }
    for (uint32_t i = 0; i < c->active_count; i++) {
        collision_shape *s = c->shapes[c->active_shapes[i]];
        offset = s->point_offsets_used ? exclusive_scan(s->point_offsets, s->node_count, offset)
                                       : offset;
    }
}

static void write_pairs(collision_object *c, collision_candidate *list)
{
    uint32_t i = 0;
    compute_offsets(c);
    for (uint32_t r = 0; r < c->run_count; r++) {
        const collision_run *run = &c->runs[r];
        const collision_shape *s = c->shapes[run->shape_a];
        bool edges = run->kind == VBSS_COLLISION_PAIR_EDGE_EDGE;
        uint32_t *offsets = edges ? s->edge_offsets : s->point_offsets;
        uint32_t end = r + 1 < c->run_count ? c->runs[r + 1].first : c->search.pair_count;
        collision_candidate candidate = {
            .kind = (uint32_t)run->kind, .shape_a = run->shape_a, .shape_b = run->shape_b};
        for (; i < end; i++) {
            candidate.a = c->search.pairs[i].a;
            candidate.b = c->search.pairs[i].b;
            list[offsets[candidate.a]++] = candidate;
        }
    }
}

/* Lists all pairs whose boxes in the trees overlap. Returns false if they do not fit. */
static bool list_pairs(collision_object *c, collision_candidate *list, uint32_t *count)
{
    refit_shapes(c);
    if (!find_pairs(c)) {
        return false;
    }
    write_pairs(c, list);
    *count = c->search.pair_count;
    return true;
}

/* ---- candidates by way of near pairs */

/* Lists the near pairs of shapes with new loose boxes, and adds those of all others. */
static bool list_near_pairs(collision_object *c)
{
    uint32_t count;
    return list_pairs(c, c->candidates, &count) && vbss_collision_merge_near_pairs(c, count);
}

/* If the near pairs do not fit, the candidates may still do. */
static bool update_near_pairs(collision_object *c)
{
    if (!vbss_collision_have_boxes_changed(c) || list_near_pairs(c)) {
        return true;
    }
    vbss_collision_tighten_boxes(c);
    c->tight_searches = COLLISION_TIGHT_SEARCHES;
    return list_near_pairs(c);
}

static bool find_candidates_from_near_pairs(collision_object *c)
{
    if (c->tight_searches > 0 && --c->tight_searches == 0) {
        vbss_collision_allow_loose_boxes(c);
    }
    vbss_collision_update_search_displacements(c);
    c->near_valid = update_near_pairs(c) && vbss_collision_filter_near_pairs(c);
    c->near_count = c->near_valid ? c->near_count : 0;
    return c->near_valid;
}

vbss_result vbss_collision_find_candidates(vbss_collision *collision)
{
    VBSS_ENTER(collision);
    collision_object *c;
    VBSS_TRY(vbss_collision_edit(collision, &c));
    vbss_collision_clear_results(c);
    c->generation++;
    c->search.boxes_tested = 0;
    update_shapes(c);
    if (!(c->caches_separation ? find_candidates_from_near_pairs(c)
                               : list_pairs(c, c->candidates, &c->candidate_count))) {
        return vbss_fail(c->context, VBSS_ERROR_CAPACITY,
                         "there are more candidates than pair_capacity, %u",
                         c->config.pair_capacity);
    }
    c->boxes_tested += c->search.boxes_tested;
    c->searches++;
    return VBSS_OK;
}
