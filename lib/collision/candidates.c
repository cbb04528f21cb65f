/* The search for candidates: which shapes to walk together, and putting the pairs in order.
 *
 * For each shape as b in turn, all shapes a that come near it are walked with it, and the pairs of a walk
 * are sorted by feature b, if they do not come so. Thus the pairs of any feature a are found sorted by
 * shape and feature b, and one counting sort by shape and feature a puts the list in order, however
 * the trees look. */
#include "base/check.h"
#include "base/error.h"
#include "collision/shapes.h"

#include <string.h>

/* ---- boxes of what has moved */

static void list_living(collision_object *c)
{
    c->living_count = 0;
    for (uint32_t name = 0; name < c->shape_count; name++) {
        if (c->shapes[name] != NULL && !c->shapes[name]->asleep) {
            c->living[c->living_count++] = name;
        }
    }
    vbss_collision_tree_set_count(&c->top, c->living_count);
    c->living_known = true;
}

static void fit_shapes(collision_object *c)
{
    if (!c->living_known) {
        list_living(c);
    }
    for (uint32_t i = 0; i < c->living_count; i++) {
        collision_shape *s = c->shapes[c->living[i]];
        vbss_collision_shape_boxes(s);
        c->top.boxes[i] = s->root;
        s->edge_rows_used = s->point_rows_used = false;
    }
    if (c->living_count > 0) {
        vbss_collision_tree_fit(&c->top);
    }
}

/* ---- walks */

static uint32_t *rows_of_edges(collision_shape *s)
{
    if (!s->edge_rows_used) {
        memset(s->edge_rows, 0, s->edge_count * sizeof *s->edge_rows);
        s->edge_rows_used = true;
    }
    return s->edge_rows;
}

static uint32_t *rows_of_points(collision_shape *s)
{
    if (!s->point_rows_used) {
        memset(s->point_rows, 0, s->node_count * sizeof *s->point_rows);
        s->point_rows_used = true;
    }
    return s->point_rows;
}

/* Turns numbers of candidates into the place of the first, each after the one before. */
static uint32_t place_rows(uint32_t *rows, uint32_t count, uint32_t place)
{
    for (uint32_t i = 0; i < count; i++) {
        uint32_t here = rows[i];
        rows[i] = place;
        place += here;
    }
    return place;
}

/* ---- pairs of a walk that came in the order of a tree */

#define FEW 24u /* pairs that are sorted faster by inserting */

static void sort_few(collision_pair *pairs, uint32_t count)
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

/* By b, of which there are `features`. The order of pairs with the same b does not matter. */
static void sort_pairs(collision_object *c, uint32_t first, uint32_t features)
{
    collision_pair *pairs = c->search.pairs + first, *spare = c->spare;
    uint32_t count = c->search.pair_count - first, *places = c->buckets;
    if (count <= FEW) {
        sort_few(pairs, count);
        return;
    }
    for (uint32_t shift = 0; shift == 0 || (features - 1) >> shift != 0; shift += SORT_DIGITS) {
        memset(places, 0, SORT_BUCKETS * sizeof *places);
        for (uint32_t i = 0; i < count; i++) {
            places[pairs[i].b >> shift & (SORT_BUCKETS - 1)]++;
        }
        place_rows(places, SORT_BUCKETS, 0);
        for (uint32_t i = 0; i < count; i++) {
            spare[places[pairs[i].b >> shift & (SORT_BUCKETS - 1)]++] = pairs[i];
        }
        memcpy(pairs, spare, count * sizeof *pairs);
    }
}

/* Notes the run, if it has any candidates. */
static bool walk(collision_object *c, const collision_walk *w, vbss_pair_kind kind, uint32_t a,
                 uint32_t b)
{
    const collision_run run = {kind, c->living[a], c->living[b], c->search.pair_count};
    c->runs[c->run_count] = run; /* there is room for one more than there can be candidates */
    if (!VBSS_WIDE_CALL(c->wide, vbss_collision_walk, &c->search, w)) {
        return false;
    }
    if (w->b->order != NULL) {
        sort_pairs(c, run.first, w->b->count);
    }
    c->run_count += c->search.pair_count > run.first;
    return true;
}

/* For the edges of one shape. */
static collision_rule rule_of_edges(const collision_shape *s)
{
    return s->kind == SHAPE_CHAIN      ? RULE_CHAIN
           : s->kind == SHAPE_CAPSULES ? RULE_CAPSULES
           : s->near.words > 0         ? RULE_FAR_EDGES
                                       : RULE_MESH_EDGES;
}

static collision_rule rule_of_points(const collision_shape *mesh)
{
    return mesh->near.words > 0 ? RULE_FAR_POINTS : RULE_MESH_POINTS;
}

static bool walk_edges(collision_object *c, uint32_t a, uint32_t b)
{
    collision_shape *s = c->shapes[c->living[a]], *other = c->shapes[c->living[b]];
    if (s == other && s->edge_count < 2) {
        return true;
    }
    vbss_collision_shape_fit_edges(s);
    vbss_collision_shape_fit_edges(other);
    const collision_walk w = {.a = &s->edge_tree,
                              .b = &other->edge_tree,
                              .rule = s == other ? rule_of_edges(s) : RULE_ALL,
                              .shape = s,
                              .near_lanes = s->near.edge_lanes,
                              .rows = rows_of_edges(s)};
    return walk(c, &w, VBSS_PAIR_EDGE_EDGE, a, b);
}

static bool walk_points(collision_object *c, uint32_t a, uint32_t b)
{
    collision_shape *s = c->shapes[c->living[a]], *mesh = c->shapes[c->living[b]];
    vbss_collision_shape_fit_points(s);
    vbss_collision_shape_fit_triangles(mesh);
    const collision_walk w = {.a = &s->point_tree,
                              .b = &mesh->triangle_tree,
                              .rule = s == mesh ? rule_of_points(s) : RULE_ALL,
                              .shape = mesh,
                              .near_lanes = mesh->near.point_lanes,
                              .rows = rows_of_points(s)};
    return walk(c, &w, VBSS_PAIR_POINT_TRIANGLE, a, b);
}

static bool filtered_out(const collision_object *c, uint32_t a, uint32_t b)
{
    const collision_shape *s = c->shapes[c->living[a]], *other = c->shapes[c->living[b]];
    return (a == b && s->rigid) || (s->category & other->mask) == 0 ||
           (other->category & s->mask) == 0;
}

static bool find_pairs(collision_object *c)
{
    c->run_count = c->search.pair_count = 0;
    for (uint32_t b = 0; b < c->living_count; b++) {
        const collision_shape *s = c->shapes[c->living[b]];
        bool mesh = s->kind == SHAPE_MESH && !s->edges_only;
        uint32_t count = VBSS_WIDE_CALL(c->wide, vbss_collision_meet, &c->search, &c->top,
                                        &c->top.boxes[b], c->partners);
        for (uint32_t i = 0; i < count; i++) {
            uint32_t a = c->partners[i];
            if (filtered_out(c, a, b)) {
                continue;
            }
            if (a <= b && !walk_edges(c, a, b)) {
                return false;
            }
            if (mesh && !walk_points(c, a, b)) {
                return false;
            }
        }
    }
    return true;
}

/* ---- order */

static void place_all_rows(collision_object *c)
{
    uint32_t place = 0;
    for (uint32_t i = 0; i < c->living_count; i++) {
        collision_shape *s = c->shapes[c->living[i]];
        place = s->edge_rows_used ? place_rows(s->edge_rows, s->edge_count, place) : place;
    }
    for (uint32_t i = 0; i < c->living_count; i++) {
        collision_shape *s = c->shapes[c->living[i]];
        place = s->point_rows_used ? place_rows(s->point_rows, s->node_count, place) : place;
    }
}

static void write_candidates(collision_object *c)
{
    uint32_t i = 0;
    place_all_rows(c);
    for (uint32_t r = 0; r < c->run_count; r++) {
        const collision_run *run = &c->runs[r];
        const collision_shape *s = c->shapes[run->shape_a];
        bool edges = run->kind == VBSS_PAIR_EDGE_EDGE;
        uint32_t *rows = edges ? s->edge_rows : s->point_rows;
        uint32_t end = r + 1 < c->run_count ? c->runs[r + 1].first : c->search.pair_count;
        collision_candidate candidate = {
            .kind = (uint32_t)run->kind, .shape_a = run->shape_a, .shape_b = run->shape_b};
        for (; i < end; i++) {
            candidate.a = c->search.pairs[i].a;
            candidate.b = c->search.pairs[i].b;
            c->candidates[rows[candidate.a]++] = candidate;
        }
    }
    c->candidate_count = c->search.pair_count;
}

vbss_result vbss_collision_find_candidates(vbss_collision *collision)
{
    collision_object *c;
    VBSS_TRY(vbss_collision_edit(collision, &c));
    VBSS_TRY(vbss_check_arithmetic(c->context));
    vbss_collision_forget(c);
    c->generation++;
    if (c->keeps_apart) {
        vbss_collision_begin_known(c);
    }
    c->search.boxes_tested = 0;
    fit_shapes(c);
    if (!find_pairs(c)) {
        return vbss_fail(c->context, VBSS_ERROR_CAPACITY,
                         "there are more candidates than pair_capacity, %u",
                         c->config.pair_capacity);
    }
    write_candidates(c);
    if (c->keeps_apart) {
        vbss_collision_hand_on(c);
    }
    c->boxes_tested += c->search.boxes_tested;
    c->searches++;
    return VBSS_OK;
}
