/* Directional conservative advancement: a continuous test whose misses are proofs.
 *
 * Between two times a fixed direction n separates the features by at least g if it does so at both,
 * because n times the vector between two vertices is linear in time. So: take n along the shortest
 * vector, go on to where n stops separating by more than D, take a new n there. Covered until 1: a
 * miss. Near enough: a hit. docs/collision.md has the proof, rounding included, and the numbers. */
#include "collision/collision.h"

#include "collision/closest.h"
#include "collision/conservative.h"
#include "collision/crossing.h"
#include "collision/exact.h"

/* Component by component, in magnitude. */
static inline vec3 larger_magnitudes(vec3 a, vec3 b)
{
    return vec3_make(greater(fabs(a.x), fabs(b.x)), greater(fabs(a.y), fabs(b.y)),
                     greater(fabs(a.z), fabs(b.z)));
}

static inline double largest_of(vec3 magnitudes)
{
    return greater(greater(magnitudes.x, magnitudes.y), magnitudes.z);
}

static inline void start_relative(const collision_question *q, collision_relative *m)
{
    m->start[0] = vec3_sub(q->start[1], q->start[0]);
    m->start[1] = vec3_sub(q->start[2], q->start[0]);
    m->start[2] = vec3_sub(q->start[3], q->start[0]);
}

/* The rest, after the start. */
static inline void end_relative(const collision_question *q, collision_relative *m)
{
    vec3 largest[3];
    for (int k = 0; k < 3; k++) {
        m->end[k] = vec3_sub(q->end[k + 1], q->end[0]);
        largest[k] = larger_magnitudes(m->start[k], m->end[k]);
    }
    m->size = largest_of(larger_magnitudes(larger_magnitudes(largest[0], largest[1]), largest[2]));
}

/* The closest points at one time. */
typedef struct moment {
    vec3 apart; /* from a to b */
    double square;
    double weights[4];
} moment;

/* Vertices 1, 2, 3 stand at p, q, r. */
VBSS_ALWAYS_INLINE void look_at(bool edges, vec3 p, vec3 q, vec3 r, moment *now)
{
    double *w = now->weights;
    if (edges) {
        now->apart = closest_edges(p, vec3_sub(r, q), q, &w[1], &w[3]);
        w[0] = 1.0 - w[1];
        w[2] = 1.0 - w[3];
    } else {
        const vec3 corners[3] = {p, q, r};
        w[0] = 1.0;
        now->apart = closest_corners(corners, &w[1]);
    }
    now->square = vec3_norm_squared(now->apart);
}

VBSS_ALWAYS_INLINE void look(const collision_relative *m, bool edges, double t, moment *now)
{
    look_at(edges, relative_at(m, 0, t), relative_at(m, 1, t), relative_at(m, 2, t), now);
}

/* ---- certificates: a direction n times the vectors of the vertices, at the start (0) and the end (1) */

typedef struct projection {
    double p0, p1, q0, q1, r0, r1;
} projection;

static inline projection project(const collision_relative *m, vec3 n)
{
    projection g = {vec3_dot(n, m->start[0]), vec3_dot(n, m->end[0]),   vec3_dot(n, m->start[1]),
                    vec3_dot(n, m->end[1]),   vec3_dot(n, m->start[2]), vec3_dot(n, m->end[2])};
    return g;
}

/* The least of the pairs: b's vertices q and r less a's, 0 and p; or the corners p, q, r less the point. */
VBSS_ALWAYS_INLINE double least_pair(bool edges, double p, double q, double r)
{
    double least = lesser(q, r);
    return edges ? least - greater(p, 0.0) : lesser(least, p);
}

/* Whether n, of which |n|^2 is `square`, separates by `clear` from start to end: what most misses are.
 * Needs no root. */
VBSS_ALWAYS_INLINE bool clear_throughout(const projection *g, bool edges, double clear,
                                         double square)
{
    double least =
        lesser(least_pair(edges, g->p0, g->q0, g->r0), least_pair(edges, g->p1, g->q1, g->r1));
    return least > 0.0 && least * least >= clear * clear * square;
}

static inline double projected(double g0, double g1, double t)
{
    return g0 + t * (g1 - g0);
}

/* How steeply a pair falls below `clear`: what it lacks at the end over what it has to spare now. The
 * steepest pair is the first. */
static inline double steeper(double steepest, double now, double end, double clear)
{
    double lack = clear - end, spare = now - clear;
    if (spare == 0.0) { /* as a division would have it */
        return lack > 0.0 ? (double)INFINITY : steepest;
    }
    return greater(lack / spare, steepest);
}

/* The time until which all pairs are separated by `clear`, from t on: above 1 if to the end; -1 if they are
 * not at t. With `clear` |n| times a distance, n separates by that. */
VBSS_ALWAYS_INLINE double clear_until(const projection *g, bool edges, double t, double clear)
{
    double p = projected(g->p0, g->p1, t), q = projected(g->q0, g->q1, t);
    double r = projected(g->r0, g->r1, t);
    if (!(least_pair(edges, p, q, r) >= clear)) {
        return -1.0;
    }
    double steepest = steeper(steeper(0.0, q, g->q1, clear), r, g->r1, clear);
    if (edges) {
        double others = steeper(0.0, q - p, g->q1 - g->p1, clear);
        steepest = greater(steepest, steeper(others, r - p, g->r1 - g->p1, clear));
    } else {
        steepest = steeper(steepest, p, g->p1, clear);
    }
    return steepest > 0.0 ? t + (1.0 - t) / (1.0 + steepest) : 2.0;
}

/* Other directions, for when the one along the shortest vector was too inexact: the common normal, and
 * of edges the vector made normal to the longer one. */
VBSS_NEVER_INLINE double clear_otherwise(const collision_relative *m, bool edges, const moment *now,
                                         double t, double clear, vec3 *direction)
{
    vec3 a = relative_at(m, 0, t), q = relative_at(m, 1, t), b = vec3_sub(relative_at(m, 2, t), q);
    vec3 others[2];
    others[0] = vec3_cross(edges ? a : vec3_sub(q, a), b);
    int count = 1;
    if (edges) {
        vec3 longer = vec3_norm_squared(a) > vec3_norm_squared(b) ? a : b;
        double square = vec3_norm_squared(longer);
        if (square > 0.0) {
            double along = vec3_dot(now->apart, longer) / square;
            others[count++] = vec3_add_scaled(now->apart, -along, longer);
        }
    }
    for (int k = 0; k < count; k++) {
        double length = vec3_norm(others[k]);
        if (!(length > 1e-140)) { /* no unit vector comes of squares that underflow */
            continue;
        }
        double way = vec3_dot(others[k], now->apart) < 0.0 ? -1.0 : 1.0;
        vec3 n = vec3_scale(others[k], way);
        projection g = project(m, n);
        double until = clear_until(&g, edges, t, clear * length);
        if (until > t) {
            *direction = n;
            return until;
        }
    }
    return -1.0;
}

static inline void tell_hit(collision_answer *answer, vbss_decision decision, double t,
                            const moment *now, double distance, vec3 normal)
{
    answer->hit = 1;
    answer->decision = decision;
    answer->time = t;
    answer->distance = distance;
    answer->normal = normal;
    for (int k = 0; k < 4; k++) {
        answer->weights[k] = now->weights[k];
    }
}

/* The normal of a hit: along the shortest vector, unless that is all rounding; then along the last
 * direction that was certified, if there was one. */
static inline vec3 normal_of(const moment *now, double distance, double rounding_square, vec3 last)
{
    if (now->square < rounding_square || distance <= 1e-150) {
        vec3 before = vec3_unit_or(last, vec3_zero());
        return vec3_norm_squared(before) > 0.0 ? before : vec3_unit_or(now->apart, before);
    }
    return vec3_scale(now->apart, 1.0 / distance);
}

/* From the first look on, which has not hit. */
VBSS_ALWAYS_INLINE void advance(const collision_relative *m, const collision_rules *rules,
                                bool edges, uint32_t limit, double thickness, moment *now,
                                collision_answer *answer)
{
    conservative_bounds bounds = conservative_bounds_of(rules->tolerance, thickness, m->size);
    double t = 0.0;
    vec3 last = vec3_zero();
    for (;; answer->passes++) {
        if (now->square <= bounds.near_square) {
            double distance = sqrt(now->square);
            vec3 normal = normal_of(now, distance, bounds.rounding_square, last);
            tell_hit(answer, VBSS_DECISION_PROVED, t, now, distance, normal);
            return;
        }
        vec3 n = now->apart; /* not of unit length: that would cost more than the rest */
        projection g = project(m, n);
        if (clear_throughout(&g, edges, bounds.clear, now->square)) {
            return;
        }
        double distance = sqrt(now->square);
        double until = clear_until(&g, edges, t, bounds.clear * distance);
        if (!(until > t)) {
            until = clear_otherwise(m, edges, now, t, bounds.clear, &n);
        }
        if (until > 1.0) {
            return;
        }
        last = n;
        if (!(until > t) || answer->passes >= limit) {
            vec3 normal = vec3_unit_or(n, vec3_zero());
            tell_hit(answer, VBSS_DECISION_UNDECIDED, t, now, distance, normal);
            return;
        }
        t = until;
        look(m, edges, t, now);
    }
}

/* Features that are within D and its tolerance at the start have hit, whatever comes. */
VBSS_ALWAYS_INLINE bool hits_at_start(const collision_relative *m, const collision_rules *rules,
                                      bool edges, double thickness, moment *now,
                                      collision_answer *answer)
{
    look_at(edges, m->start[0], m->start[1], m->start[2], now);
    answer->passes = 1;
    double near = thickness + NEAR_SHARE * (rules->tolerance * thickness);
    if (!(now->square <= near * near)) {
        return false;
    }
    double distance = sqrt(now->square);
    vec3 normal = normal_of(now, distance, 0.0, vec3_zero());
    tell_hit(answer, VBSS_DECISION_PROVED, 0.0, now, distance, normal);
    return true;
}

/* What is not decided at the start: out of the way of what is. */
VBSS_NEVER_INLINE void advance_edges(const collision_relative *m, const collision_rules *rules,
                                     uint32_t limit, double thickness, moment *now,
                                     collision_answer *answer)
{
    advance(m, rules, true, limit, thickness, now, answer);
}

VBSS_NEVER_INLINE void advance_triangle(const collision_relative *m, const collision_rules *rules,
                                        uint32_t limit, double thickness, moment *now,
                                        collision_answer *answer)
{
    advance(m, rules, false, limit, thickness, now, answer);
}

VBSS_ALWAYS_INLINE void ask(const collision_rules *rules, uint32_t limit,
                            const collision_question *question, bool edges,
                            collision_answer *answer)
{
    collision_relative m;
    moment now;
    start_relative(question, &m);
    if (hits_at_start(&m, rules, edges, question->thickness, &now, answer)) {
        return;
    }
    end_relative(question, &m);
    if (edges) {
        advance_edges(&m, rules, limit, question->thickness, &now, answer);
    } else {
        advance_triangle(&m, rules, limit, question->thickness, &now, answer);
    }
}

/* In at most `limit` passes. */
static void ask_either(const collision_rules *rules, uint32_t limit,
                       const collision_question *question, collision_answer *answer)
{
    if (question->kind == VBSS_PAIR_EDGE_EDGE) {
        ask(rules, limit, question, true, answer);
    } else {
        ask(rules, limit, question, false, answer);
    }
}

/* ---- zero thickness */

static double largest(vec3 a, vec3 b)
{
    return largest_of(larger_magnitudes(a, b));
}

/* The volume of the four vertices is a cubic in time; if all its Bernstein coefficients are on one side of
 * zero by more than their rounding, the vertices never lie in one plane. */
static bool never_flat(const collision_relative *m)
{
    vec3 yz0 = vec3_cross(m->start[1], m->start[2]), yz1 = vec3_cross(m->end[1], m->end[2]);
    vec3 mixed = vec3_add(vec3_cross(m->start[1], m->end[2]), vec3_cross(m->end[1], m->start[2]));
    double first = vec3_dot(m->start[0], yz0), last = vec3_dot(m->end[0], yz1);
    double second = vec3_dot(m->end[0], yz0) + vec3_dot(m->start[0], mixed); /* three times */
    double third = vec3_dot(m->start[0], yz1) + vec3_dot(m->end[0], mixed);
    double bound = largest(m->start[0], m->end[0]) * largest(m->start[1], m->end[1]) *
                   largest(m->start[2], m->end[2]) * VOLUME_ROUNDING;
    if (!(bound > VOLUME_UNDERFLOW)) {
        return false;
    }
    return (first > bound && last > bound && second > 3.0 * bound && third > 3.0 * bound) ||
           (first < -bound && last < -bound && second < -3.0 * bound && third < -3.0 * bound);
}

bool vbss_collision_apart(const collision_question *question)
{
    static const collision_rules rules = {.tolerance = 0.0};
    collision_answer answer = vbss_collision_miss(VBSS_DECISION_PROVED);
    ask_either(&rules, ZERO_PASS_LIMIT, question, &answer);
    return answer.hit == 0;
}

/* Features that were not proved apart: whether they meet. */
static exact_truth decide(const collision_rules *rules, const collision_question *question,
                          const collision_relative *m, double t, collision_counters *counters)
{
    if (vbss_collision_crosses(m, question->kind == VBSS_PAIR_EDGE_EDGE, t)) {
        return EXACT_HIT;
    }
    workspace w = {.limbs = rules->limbs, .capacity = rules->limb_count};
    counters->exact++;
    return vbss_collision_exact(question, &w);
}

static void without_thickness(const collision_rules *rules, const collision_question *question,
                              collision_answer *answer, collision_counters *counters)
{
    collision_relative m;
    start_relative(question, &m);
    end_relative(question, &m);
    if (never_flat(&m)) {
        return;
    }
    uint32_t limit = conservative_pass_limit(rules->pass_limit, 0.0);
    ask_either(rules, limit, question, answer);
    if (answer->hit == 0) {
        return;
    }
    exact_truth truth = decide(rules, question, &m, answer->time, counters);
    if (truth == EXACT_MISS) {
        uint32_t passes = answer->passes;
        *answer = vbss_collision_miss(VBSS_DECISION_EXACT);
        answer->passes = passes;
        return;
    }
    if (answer->decision == VBSS_DECISION_UNDECIDED && rules->pass_limit > limit) {
        /* It ended on the way: on to the place of contact, if that is not too far. */
        limit = rules->pass_limit < ZERO_HIT_PASS_LIMIT ? rules->pass_limit : ZERO_HIT_PASS_LIMIT;
        *answer = vbss_collision_miss(VBSS_DECISION_PROVED);
        ask_either(rules, limit, question, answer);
    }
    if (answer->hit != 0) { /* else more passes have proved a miss of what was unknown */
        answer->decision = truth == EXACT_HIT ? VBSS_DECISION_EXACT : VBSS_DECISION_UNDECIDED;
    }
}

void vbss_collision_conservative(const collision_rules *rules, const collision_question *question,
                                 collision_answer *answer, collision_counters *counters)
{
    if (question->thickness == 0.0) {
        without_thickness(rules, question, answer, counters);
    } else {
        ask_either(rules, rules->pass_limit, question, answer);
    }
    counters->passes += answer->passes;
}
