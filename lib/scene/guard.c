/* The guard: whether anything would pass through anything between begin and trial state of a part.
 *
 * Axes are kept at half the distance of touching by one-sided continuous tests: a miss is a proof. Contacts
 * rest near the whole distance, so the guard sleeps unless something goes wrong. Pairs that begin nearer than
 * half must not come much nearer still, so that a bad state can be left. */
#include "scene/apart.h"
#include "scene/around_holes.h"
#include "scene/attempt.h"
#include "scene/cuts.h"
#include "scene/holes.h"
#include "scene/pins.h"
#include "scene/rows.h"
#include "scene/tools.h"

#include "collision/closest.h"

/* Share of the distance of touching; and of the distance at the begin where that is smaller. */
#define GUARDED 0.5
#define GUARDED_WHEN_NEARER 0.9
/* Share of the guarded distance below which what is cut short comes no nearer at all: pressed on and on it would
 * end so near that no test could prove that it leaves. */
#define NEAREST 0.1
/* What is at a hole is looked at as often in a part; and asked about so often at most. */
enum { LOOKS = 8, ASKED = 80 };
/* The floor: how much of its radius a node or the end of a capsule may be above it at least. */
#define GUARDED_ABOVE_FLOOR 0.5
/* Share of the margin: a half, less what rounding may do. */
#define LISTED 0.49
/* What is not deep begins no nearer than DEEP less than touching; two bodies that do not move by more than GENTLE of it
 * together stay farther apart than half: nodes that rows see smoothed, too, which may begin at 0.71 of it themselves. A
 * segment between these that is as long as the tool's radius may begin at 0.6: it stays beyond 0.4. */
#define DEEP 0.2
#define GENTLE 0.2

/* ---- where things go */

typedef struct motion {
    uint32_t count;
    const vec3 *begin, *ways, *end;
} motion;

static motion motion_of(scene_object *s, const scene_body *b)
{
    if (b->kind == BODY_THREAD) {
        const thread_object *t = b->thread.thread;
        return (motion){t->node_count, t->now.x, s->ways + b->thread.first_node, t->trial};
    }
    if (b->kind == BODY_DRAIN) {
        const drain_object *d = b->drain.drain;
        return (motion){d->mesh.node_count, d->x, b->drain.ways, d->trial};
    }
    const scene_rigid *r = &b->rigid;
    uint32_t count = 2 * r->capsule_count;
    vec3 *begin = s->vertices, *end = begin + count;
    for (uint32_t i = 0; i < count; i++) {
        begin[i] = s->capsules[r->first_capsule + i / 2].now[i % 2];
        end[i] = s->capsules[r->first_capsule + i / 2].trial[i % 2];
    }
    const vec3 *ways = s->ways + s->config.node_capacity + 2 * (size_t)r->first_capsule;
    return (motion){count, begin, ways, end};
}

/* The search for rows has listed all pairs whose boxes meet, boxes round the ways that it expected. Who leaves the
 * box by less than half of the margin with which those are made meets nobody else. */
static bool is_expected(const scene_object *s, const motion *m)
{
    const double beyond = LISTED * s->config.contact_margin;
    for (uint32_t i = 0; i < m->count; i++) {
        vec3 way = vec3_scale(m->ways[i], SCENE_AHEAD), went = vec3_sub(m->end[i], m->begin[i]);
        bool inside =
            went.x >= vbss_min(0.0, way.x) - beyond && went.x <= vbss_max(0.0, way.x) + beyond &&
            went.y >= vbss_min(0.0, way.y) - beyond && went.y <= vbss_max(0.0, way.y) + beyond &&
            went.z >= vbss_min(0.0, way.z) - beyond && went.z <= vbss_max(0.0, way.z) + beyond;
        if (!inside) { /* nor is what is not a number */
            return false;
        }
    }
    return true;
}

/* Whether all pairs begin about as far apart as they touch: rows say so of those that are near. Those of a thread and what it
 * is pinned to, or at a cut, are none of the guard's. */
static bool are_apart(const scene_object *s)
{
    bool apart = !s->unlisted;
    for (uint32_t i = 0; apart && i < s->contacts->count; i++) {
        const contact_constraint *row = &s->contacts->constraints[i];
        apart = row->is_bilateral ||
                row->start_gap - row->overlap_allowance >= -DEEP * row->contact_distance;
    }
    return apart;
}

static double farthest(const motion *m)
{
    double most = 0.0;
    for (uint32_t i = 0; i < m->count; i++) {
        double way = vec3_norm_squared(vec3_sub(m->end[i], m->begin[i]));
        most = way > most ? way : most;
    }
    return sqrt(most);
}

/* All pairs that may meet on the way to the trial state are listed. */
static scene_verdict list_pairs(scene_object *s)
{
    bool expected = true;
    for (uint32_t i = 0; i < s->place_count; i++) {
        if (s->bodies[i].kind != BODY_GONE) {
            const motion m = motion_of(s, &s->bodies[i]);
            expected = expected && is_expected(s, &m);
            s->bodies[i].moved = farthest(&m); /* of all: pairs at holes ask, expected or not */
        }
    }
    s->proved = expected && are_apart(s);
    for (uint32_t i = 0; i < s->place_count; i++) {
        const scene_body *b = &s->bodies[i];
        if (b->kind == BODY_GONE) {
            continue;
        }
        const motion m = motion_of(s, b);
        if (expected) {
            vbss_collision_set_end_positions(s->collision->shapes[b->shape], m.end);
        } else if (vbss_collision_move(scene_collision(s), b->shape, &m.begin->x, &m.end->x,
                                       m.count) != VBSS_OK) {
            return VERDICT_SINGULAR; /* coordinates that are no place */
        }
        vbss_collision_update_displacements(s->collision->shapes[b->shape]);
    }
    if (!expected && vbss_scene_find_pairs(s) != VBSS_OK) {
        return VERDICT_FULL;
    }
    return VERDICT_ACCEPTED;
}

/* ---- pairs, in blocks of rows */

static void put_vertex(collision_block *rows, size_t vertex, uint32_t at, vec3 start, vec3 end)
{
    rows->start[3 * vertex][at] = start.x;
    rows->start[3 * vertex + 1][at] = start.y;
    rows->start[3 * vertex + 2][at] = start.z;
    rows->end[3 * vertex][at] = end.x;
    rows->end[3 * vertex + 1][at] = end.y;
    rows->end[3 * vertex + 2][at] = end.z;
}

/* Two vertices of either edge; a point and the corners of a triangle. */
static void vertices_of(const scene_object *s, const collision_candidate *q,
                        const collision_shape *of[4], uint32_t vertices[4])
{
    const collision_shape *a = s->collision->shapes[q->shape_a];
    const collision_shape *b = s->collision->shapes[q->shape_b];
    bool edges = q->kind == VBSS_PAIR_EDGE_EDGE;
    for (uint32_t k = 0; k < 4; k++) {
        bool is_a = k < (edges ? 2u : 1u);
        of[k] = is_a ? a : b;
        vertices[k] = !edges ? (is_a ? q->a : b->triangles[q->b][k - 1])
                             : (is_a ? a->edges[q->a][k] : b->edges[q->b][k - 2]);
    }
}

/* What reaches the free edge of a drain may come nearer to a wall than walls do. */
static bool is_flat(const scene_object *s, const collision_candidate *q, bool is_b)
{
    const collision_shape *of[4];
    uint32_t vertices[4], first = q->kind == VBSS_PAIR_EDGE_EDGE ? 2 : 1;
    const scene_body *a = &s->bodies[s->shape_places[q->shape_a]];
    const scene_body *b = &s->bodies[s->shape_places[q->shape_b]];
    if (a->kind != BODY_DRAIN || b->kind != BODY_DRAIN) {
        return false;
    }
    vertices_of(s, q, of, vertices);
    const uint32_t *lips = (is_b ? b : a)->drain.lip_of_node;
    bool flat = false;
    for (uint32_t k = is_b ? first : 0; k < (is_b ? 4 : first); k++) {
        flat = flat || lips[vertices[k]] != SCENE_NO_FACE;
    }
    return flat;
}

static double radius_of(const scene_object *s, const collision_candidate *q, bool is_b)
{
    return scene_radius_of(s, q, is_b) * (is_flat(s, q, is_b) ? 2.0 * SCENE_LIP : 1.0);
}

static double touching_of(const scene_object *s, const collision_candidate *q)
{
    return radius_of(s, q, false) + radius_of(s, q, true);
}

/* Of the thinner one. */
static double thickness_of(const scene_object *s, const collision_candidate *q)
{
    return 2.0 * vbss_min(radius_of(s, q, false), radius_of(s, q, true));
}

/* As near as contact may let them come. */
static double allowed_by_contact(const scene_object *s, const collision_candidate *q)
{
    return touching_of(s, q) - s->config.penetration_tolerance * thickness_of(s, q);
}

/* A pair of features, of which pieces of both (NULL: of all of it), from which share of the part on. */
typedef struct asked_pair {
    const collision_candidate *q;
    const scene_piece *piece;
    double from;
} asked_pair;

typedef struct corners {
    vec3 start[4], end[4];
} corners;

static void corners_of(const scene_object *s, const asked_pair *pair, corners *c)
{
    const collision_candidate *q = pair->q;
    const scene_piece *piece = pair->piece;
    const collision_shape *of[4];
    uint32_t vertices[4];
    vertices_of(s, q, of, vertices);
    for (uint32_t k = 0; k < 4; k++) {
        vec3 start = of[k]->start[vertices[k]], end = of[k]->end[vertices[k]];
        c->start[k] = pair->from > 0.0 ? vec3_lerp(start, end, pair->from) : start;
        c->end[k] = end;
    }
    bool first = s->bodies[s->shape_places[q->shape_a]].kind == BODY_RIGID;
    for (uint32_t k = 0; piece != NULL && k < 2; k++) {
        uint32_t at = (k == 0) == first ? 0 : 2;
        scene_cut_axis(c->start + at, piece->at[k]);
        scene_cut_axis(c->end + at, piece->at[k]);
    }
}

static void put_pair(scene_object *s, const asked_pair *pair, uint32_t at)
{
    corners c;
    corners_of(s, pair, &c);
    for (uint32_t k = 0; k < 4; k++) {
        put_vertex(s->block, k, at, c.start[k], c.end[k]);
    }
    /* What contact has looked at is seldom nearer. */
    s->block->thickness[at] = allowed_by_contact(s, pair->q);
}

/* How far apart they begin, and where: shares of two edges; weights of a triangle's corners. */
static double distance_at_begin(const scene_object *s, const asked_pair *pair, double at[3])
{
    corners c;
    corners_of(s, pair, &c);
    const vec3 *x = c.start;
    if (pair->q->kind == VBSS_PAIR_POINT_TRIANGLE) {
        const vec3 triangle[3] = {vec3_sub(x[1], x[0]), vec3_sub(x[2], x[0]), vec3_sub(x[3], x[0])};
        return vec3_norm(closest_on_triangle(triangle, at));
    }
    return vec3_norm(closest_between_edges(vec3_sub(x[1], x[0]), vec3_sub(x[3], x[2]),
                                           vec3_sub(x[2], x[0]), &at[0], &at[1]));
}

/* Where the wall is nearest then, and where on the other one that is: a share of its edge. */
static scene_spot nearest_spot(const scene_object *s, const asked_pair *pair, bool first,
                               const scene_body *drain, double *share)
{
    const collision_candidate *q = pair->q;
    const uint32_t feature = first ? q->b : q->a;
    double at[3];
    scene_spot spot;
    (void)distance_at_begin(s, pair, at);
    if (q->kind == VBSS_PAIR_POINT_TRIANGLE) {
        *share = 0.0;
        spot = vbss_scene_spot_then(drain, feature, at, pair->from);
    } else {
        double on_other = at[first ? 0 : 1], on_side = at[first ? 1 : 0];
        if (pair->piece != NULL) {
            const double(*cut)[2] = pair->piece->at;
            on_other = cut[0][0] + on_other * (cut[0][1] - cut[0][0]);
            on_side = cut[1][0] + on_side * (cut[1][1] - cut[1][0]);
        }
        *share = on_other;
        const uint32_t *side = s->collision->shapes[drain->shape]->edges[feature];
        spot = vbss_scene_spot_on_side_then(drain, side, on_side, pair->from);
    }
    return spot;
}

/* A suture and the wall round a hole that it is in; jaws and the wall that they hold. `more`: as if the hole were so much
 * larger. */
static double share_at_wall(const scene_object *s, const asked_pair *pair, double touching,
                            double more)
{
    const collision_candidate *q = pair->q;
    const scene_body *a = &s->bodies[s->shape_places[q->shape_a]];
    const scene_body *b = &s->bodies[s->shape_places[q->shape_b]];
    bool first = a->kind != BODY_DRAIN, point = q->kind == VBSS_PAIR_POINT_TRIANGLE;
    const scene_body *other = first ? a : b, *drain = first ? b : a;
    bool holds = other->kind == BODY_RIGID && other->rigid.pinch.drain == drain->number;
    if (other->kind == BODY_DRAIN || drain->kind != BODY_DRAIN ||
        !(holds || vbss_scene_is_suture(other))) {
        return 1.0;
    }
    double share;
    const scene_spot spot = nearest_spot(s, pair, first, drain, &share);
    return vbss_scene_share_touching(s, other, point, first ? q->a : q->b, share, drain, &spot,
                                     SCENE_PIN_ARC * touching + more);
}

/* The thread and the body that it is pinned to; the two ends at a cut; a needle and the jaws that hold it: none. */
static double share_touching(const scene_object *s, const collision_candidate *q, double touching)
{
    const scene_body *a = &s->bodies[s->shape_places[q->shape_a]];
    const scene_body *b = &s->bodies[s->shape_places[q->shape_b]];
    if (a->kind == BODY_DRAIN || b->kind == BODY_DRAIN) {
        const asked_pair pair = {q, NULL, 0.0};
        return share_at_wall(s, &pair, touching, a->moved + b->moved);
    }
    if (a->kind == BODY_THREAD && b->kind == BODY_THREAD) {
        return vbss_scene_adjoins(s, a, q->a, b, q->b) ? 0.0 : 1.0;
    }
    if (a->kind == b->kind) {
        bool held = vbss_scene_is_in_jaws(s, a, q->a, b, q->b) ||
                    vbss_scene_is_in_jaws(s, b, q->b, a, q->a);
        return held ? 0.0 : 1.0;
    }
    bool comes = a->kind == BODY_THREAD ? vbss_scene_comes_from(s, a, q->a, b, q->b, touching)
                                        : vbss_scene_comes_from(s, b, q->b, a, q->a, touching);
    return comes ? 0.0 : 1.0;
}

static double least_radius(const scene_object *s, const scene_body *b, uint32_t shape)
{
    double least = s->collision->shapes[shape]->radius; /* of rigid bodies the largest */
    if (b->kind == BODY_DRAIN) {
        return 2.0 * SCENE_LIP * least;
    }
    for (uint32_t i = 0; b->kind == BODY_RIGID && i < b->rigid.capsule_count; i++) {
        least = vbss_min(s->capsules[b->rigid.first_capsule + i].radius, least);
    }
    return least;
}

/* Who moves that little meets nobody who was not near. */
static bool is_proved(const scene_object *s, const collision_candidate *q)
{
    const scene_body *a = &s->bodies[s->shape_places[q->shape_a]];
    const scene_body *b = &s->bodies[s->shape_places[q->shape_b]];
    return s->proved && a->moved + b->moved <= GENTLE * touching_of(s, q);
}

/* The same of all that follow of the same two shapes; returns the first of others. */
static uint32_t skip_proved(const scene_object *s, uint32_t first)
{
    const collision_object *c = s->collision;
    const collision_candidate *q = &c->candidates[first];
    const scene_body *a = &s->bodies[s->shape_places[q->shape_a]];
    const scene_body *b = &s->bodies[s->shape_places[q->shape_b]];
    double touching = least_radius(s, a, q->shape_a) + least_radius(s, b, q->shape_b);
    uint32_t next = first;
    if (s->proved && a->moved + b->moved <= GENTLE * touching) {
        while (next < c->candidate_count && c->candidates[next].shape_a == q->shape_a &&
               c->candidates[next].shape_b == q->shape_b) {
            next++;
        }
    }
    return next;
}

static void ask(scene_object *s, uint32_t kind, uint32_t count)
{
    collision_block *b = s->block;
    const collision_ccd_batch rows = {.kind = (vbss_pair_kind)kind,
                                      .count = count,
                                      .stride = COLLISION_BLOCK_SIZE,
                                      .start = b->start[0],
                                      .end = b->end[0],
                                      .thickness = b->thickness,
                                      .hit = b->hit,
                                      .decision = b->decision,
                                      .time = b->time};
    vbss_collision_run_ccd_batch(&s->collision->ccd_options, s->collision->wide, &rows,
                                 &s->collision->counters);
}

/* When they come so near, as a share of the part; 1: they do not. */
static double time_at(scene_object *s, const asked_pair *pair, double thickness)
{
    put_pair(s, pair, 0);
    s->block->thickness[0] = thickness;
    ask(s, pair->q->kind, 1);
    return s->block->hit[0] != 0 ? pair->from + (1.0 - pair->from) * s->block->time[0] : 1.0;
}

/* Shares of the distance of touching: at which features touch when the part begins; and anywhere on their way, if they may come
 * into a hole on it. `leaves`: they begin in one, where they may be as near as they like. */
typedef struct shares {
    double now, coming;
    bool leaves;
} shares;

/* Share of the part after which a pair that hit comes too near; 1: it does not. What begins near is a row, and
 * contact has seen to it; what comes from further away may be none. */
static double time_of_hit(scene_object *s, const asked_pair *pair, shares share)
{
    double at[3], touching = touching_of(s, pair->q), distance = distance_at_begin(s, pair, at);
    double guarded = GUARDED * share.now * touching;
    if (distance >= touching + s->config.contact_margin) {
        double nearer = (1.0 - share.coming) * touching;
        return time_at(s, pair, vbss_max(allowed_by_contact(s, pair->q) - nearer, guarded));
    }
    bool near = distance <= guarded * (1.0 + 2.0 * s->collision->ccd_options.tolerance);
    double hit = time_at(s, pair, near ? GUARDED_WHEN_NEARER * distance : guarded);
    return hit < 1.0 && distance < NEAREST * guarded && !share.leaves ? pair->from : hit;
}

/* The same of a suture and a wall, of which what is at a hole touches less or nothing: where they hit they are looked at again,
 * and what leaves the hole is asked about from when it was last seen in it. */
static double time_of_hit_at_holes(scene_object *s, const collision_candidate *q,
                                   const scene_piece *piece)
{
    const double touching = touching_of(s, q);
    const double moved =
        s->bodies[s->shape_places[q->shape_a]].moved + s->bodies[s->shape_places[q->shape_b]].moved;
    const double look = vbss_max(1.0 / LOOKS, GENTLE * touching / moved);
    asked_pair pair = {q, piece, 0.0};
    const double coming = share_at_wall(s, &pair, touching, moved);
    for (uint32_t i = 0; i < ASKED && pair.from < 1.0; i++) {
        shares share = {share_at_wall(s, &pair, touching, 0.0), coming, false};
        if (share.now <= 0.0) {
            const asked_pair next = {q, piece, vbss_min(pair.from + look, 1.0)};
            share.now = share_at_wall(s, &next, touching, 0.0);
            share.leaves = true;
            if (share.now <= 0.0) {
                pair.from = next.from;
                continue;
            }
        }
        const asked_pair hit = {q, piece, time_of_hit(s, &pair, share)};
        if (hit.from >= 1.0) {
            return 1.0;
        }
        const double there = share_at_wall(s, &hit, touching, 0.0);
        if (there >= share.now) {
            return hit.from;
        }
        double least = there > 0.0 ? 0.0 : pair.from + look / LOOKS;
        pair.from = vbss_min(vbss_max(hit.from, least), 1.0);
    }
    return pair.from;
}

/* Of a needle and a side that touch nowhere where they are nearest, at a hole: what is left of the needle beside its holes. */
static double time_beside_holes(scene_object *s, const collision_candidate *q)
{
    const scene_body *a = &s->bodies[s->shape_places[q->shape_a]];
    const scene_body *b = &s->bodies[s->shape_places[q->shape_b]];
    bool first = a->kind == BODY_RIGID;
    const scene_body *needle = first ? a : b, *drain = first ? b : a;
    if (q->kind != VBSS_PAIR_EDGE_EDGE || drain->kind != BODY_DRAIN || needle->kind != BODY_RIGID ||
        needle->rigid.needle == NULL) {
        return 1.0;
    }
    const double reach = SCENE_PIN_ARC * touching_of(s, q);
    scene_piece piece = {.begun = false};
    double earliest = 1.0;
    while (vbss_scene_next_piece(s, needle, first ? q->a : q->b, drain, first ? q->b : q->a, reach,
                                 &piece)) {
        const asked_pair pair = {q, &piece, 0.0};
        if (time_at(s, &pair, allowed_by_contact(s, q)) < 1.0) {
            earliest = vbss_min(time_of_hit_at_holes(s, q, &piece), earliest);
        }
    }
    return earliest;
}

static bool is_of_suture_and_wall(const scene_object *s, const collision_candidate *q)
{
    const scene_body *a = &s->bodies[s->shape_places[q->shape_a]];
    const scene_body *b = &s->bodies[s->shape_places[q->shape_b]];
    return (a->kind == BODY_DRAIN && vbss_scene_is_suture(b)) ||
           (b->kind == BODY_DRAIN && vbss_scene_is_suture(a));
}

static bool is_of_needle_and_wall(const scene_object *s, const collision_candidate *q)
{
    const scene_body *a = &s->bodies[s->shape_places[q->shape_a]];
    const scene_body *b = &s->bodies[s->shape_places[q->shape_b]];
    return (a->kind == BODY_DRAIN && b->kind == BODY_RIGID && b->rigid.needle != NULL) ||
           (b->kind == BODY_DRAIN && a->kind == BODY_RIGID && a->rigid.needle != NULL);
}

/* Whether a pair that began near stays beyond the guarded share of the whole distance of touching, and so of any less: most that
 * hit do. A needle at a wall is looked at in pieces, which may begin farther away. */
static bool is_clear(scene_object *s, const asked_pair *pair)
{
    double at[3], distance = distance_at_begin(s, pair, at), touching = touching_of(s, pair->q);
    const double guarded = GUARDED * touching * (1.0 + 2.0 * s->collision->ccd_options.tolerance);
    vbss_collision_store_separation(s->collision, pair->q, distance);
    return distance < touching + s->config.contact_margin &&
           vbss_collision_stays_separated(s->collision, pair->q, guarded) &&
           !is_of_needle_and_wall(s, pair->q);
}

/* Of a pair that comes nearer than contact lets it. */
static double look_again(scene_object *s, const collision_candidate *q, double time)
{
    const asked_pair pair = {q, NULL, 0.0};
    if (is_clear(s, &pair)) {
        return 1.0;
    }
    const double share = share_touching(s, q, touching_of(s, q));
    double at[3];
    if (share < 1.0 && is_of_suture_and_wall(s, q)) {
        return vbss_min(time_of_hit_at_holes(s, q, NULL), time_beside_holes(s, q));
    }
    if (share <= 0.0) {
        return 1.0;
    }
    double far = touching_of(s, q) + s->config.contact_margin;
    return share >= 1.0 && distance_at_begin(s, &pair, at) >= far
               ? time
               : time_of_hit(s, &pair, (shares){share, share, false});
}

/* The next pairs of one kind that have to be asked about, from *next on; returns how many, and which. */
static uint32_t gather(scene_object *s, uint32_t *next, uint32_t which[COLLISION_BLOCK_SIZE])
{
    const collision_object *c = s->collision;
    uint32_t count = 0;
    for (; *next < c->candidate_count && count < COLLISION_BLOCK_SIZE; ++*next) {
        const collision_candidate *q = &c->candidates[*next];
        bool others = *next == 0 || q->shape_a != q[-1].shape_a || q->shape_b != q[-1].shape_b;
        uint32_t beyond = others ? skip_proved(s, *next) : *next;
        if (beyond > *next || is_proved(s, q)) {
            *next = beyond > *next ? beyond - 1 : *next;
            continue;
        }
        if (count > 0 && q->kind != c->candidates[which[0]].kind) {
            break;
        }
        s->statistics.guard_pairs++;
        if (scene_stay_apart(s, q, 0.0)) {
            continue;
        }
        put_pair(s, &(asked_pair){q, NULL, 0.0}, count);
        which[count++] = *next;
    }
    return count;
}

static double earliest_hit(scene_object *s)
{
    const collision_object *c = s->collision;
    double earliest = 1.0;
    uint32_t which[COLLISION_BLOCK_SIZE], count, next = 0;
    while ((count = gather(s, &next, which)) > 0) {
        double time[COLLISION_BLOCK_SIZE];
        bool hit[COLLISION_BLOCK_SIZE];
        ask(s, c->candidates[which[0]].kind, count);
        for (uint32_t i = 0; i < count; i++) { /* asking again overwrites the block */
            hit[i] = s->block->hit[i] != 0;
            time[i] = s->block->time[i];
        }
        for (uint32_t i = 0; i < count; i++) {
            const collision_candidate *q = &c->candidates[which[i]];
            if (hit[i]) {
                earliest = vbss_min(look_again(s, q, time[i]), earliest);
            }
        }
    }
    return earliest;
}

/* ---- the floor */

static double earliest_below_floor(const scene_object *s, vec3 begin, vec3 end, double radius)
{
    double above = vec3_dot(begin, s->floor_normal) - s->config.floor_height;
    double then = vec3_dot(end, s->floor_normal) - s->config.floor_height;
    double least = GUARDED_ABOVE_FLOOR * radius;
    if (above < least) { /* it began there */
        least = above - (1.0 - GUARDED_WHEN_NEARER) * fabs(above);
    }
    return then >= least ? 1.0 : (above - least) / (above - then);
}

static double earliest_through_floor(const scene_object *s)
{
    double earliest = 1.0;
    for (uint32_t i = 0; s->config.floor != 0 && i < s->place_count; i++) {
        const scene_body *b = &s->bodies[i];
        const thread_object *t = b->thread.thread;
        const scene_rigid *r = &b->rigid;
        for (uint32_t k = 0; b->kind == BODY_THREAD && k < t->node_count; k++) {
            double at = earliest_below_floor(s, t->now.x[k], t->trial[k], t->config.radius);
            earliest = vbss_min(at, earliest);
        }
        for (uint32_t k = 0; b->kind == BODY_RIGID && k < 2 * r->capsule_count; k++) {
            const scene_capsule *c = &s->capsules[r->first_capsule + k / 2];
            double at = earliest_below_floor(s, c->now[k % 2], c->trial[k % 2], c->radius);
            earliest = vbss_min(at, earliest);
        }
        const drain_object *d = b->drain.drain;
        for (uint32_t k = 0; b->kind == BODY_DRAIN && k < d->mesh.node_count; k++) {
            double at = earliest_below_floor(s, d->x[k], d->trial[k], 0.5 * d->config.thickness);
            earliest = vbss_min(at, earliest);
        }
    }
    return earliest;
}

scene_verdict vbss_scene_guard(scene_object *s)
{
    scene_verdict verdict = list_pairs(s);
    if (verdict != VERDICT_ACCEPTED) {
        return verdict;
    }
    vbss_scene_find_slides(s);
    s->earliest = vbss_min(earliest_hit(s), earliest_through_floor(s));
    return s->earliest < 1.0 ? VERDICT_GUARD : VERDICT_ACCEPTED;
}
