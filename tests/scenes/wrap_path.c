#include "scenes/wrap_path.h"

#include <stdlib.h>

#include "base/elementary.h"
#include "scenes/swept.h"

#define PI 3.141592653589793
#define SPACING 0.4e-3 /* of control points, m */
#define FINE 0.25e-3   /* of the line that the segments are proved with */
#define NEARLY 0.045   /* of its length: so far an edge of it may stray from the curve */
#define SIZE 1e-3      /* of the throws below */
#define DEPTH 4e-3
#define DRAIN 3e-3
#define ORBIT 6e-3    /* of N about the axis */
#define SHORT 0.04    /* turns by which whole turns stay short of the tail */
#define WHOLE 2.2e-3  /* from the axis: so far strands are shifted wholly */
#define FADED 6.2e-3  /* and from here on not at all */
#define BESIDE 0.8e-3 /* of what hangs from the jaws, beside the tail */

/* ---- frame: where the limbs leave the knot below */

static double half_width(const wrap_state *state)
{
    uint32_t n = state->below.throws;
    return n > 0 ? (0.75 * (2 * state->below.wraps[n - 1] + 2) + 0.6) * SIZE : 0.5 * DRAIN;
}

static double top(const wrap_state *state)
{
    uint32_t n = state->below.throws;
    return n > 0 ? ((n - 1) * 2.9 + 0.25) * SIZE : 0.0;
}

double wrap_axis_height(const wrap_state *state)
{
    return top(state) + WRAP_ABOVE;
}

/* ---- the helix: how far it has turned at a share of the way, rad; its direction from the axis */

static double turned(const wrap_state *state, double share)
{
    double turns = state->turns - (state->turns > 0.0 ? SHORT : -SHORT);
    return 2.0 * PI * (share * turns + state->there_and_back * vbss_sin(PI * share));
}

static vec3 aside(double angle)
{
    double sine, cosine;
    vbss_sincos(angle, &sine, &cosine);
    return vec3_make(0.0, sine, -cosine);
}

static double helix_x(const wrap_state *state, double share)
{
    return (state->to_handle ? -1.0 : 1.0) * WRAP_LOOPS * (1.0 - 2.0 * share);
}

static double smooth(double t)
{
    double s = vbss_min(vbss_max(t, 0.0), 1.0);
    return s * s * (3.0 - 2.0 * s);
}

/* Near the axis everything is shifted square to it, at each place along it by one vector, which decays so
 * slowly outward that planes stay planes and nothing passes. */
static vec3 flattened(const wrap_state *state, vec3 p)
{
    double x = p.x / WRAP_LOOPS, z = p.z - wrap_axis_height(state);
    double out = sqrt(p.y * p.y + z * z);
    if (state->flat == 0.0 || fabs(x) > 1.3 || out > FADED) {
        return p;
    }
    double share = 0.5 * (1.0 - (state->to_handle ? -x : x));
    double by = smooth((1.3 - fabs(x)) / 0.3) * smooth((FADED - out) / (FADED - WHOLE));
    return vec3_add_scaled(p, -by * state->flat * state->radius, aside(turned(state, share)));
}

static vec3 on_helix(double t, const void *user)
{
    const wrap_state *state = user;
    vec3 centre = vec3_make(helix_x(state, t), 0.0, wrap_axis_height(state));
    return vec3_add_scaled(centre, state->radius, aside(turned(state, t)));
}

/* ---- the pieces, from the tail's end on */

typedef struct pen {
    knot_curve *curve;
    vec3 at;
} pen;

static void go(pen *p, vec3 to)
{
    knot_curve_straight(p->curve, p->at, to);
    p->at = to;
}

static void put_tail(const wrap_state *state, pen *p)
{
    double z = wrap_axis_height(state), low = top(state), up = state->lift;
    vec3 rise = vec3_make(WRAP_RISE, 0.0, low + up * (z - low));
    vec3 jaws = vec3_make(state->lift < 1.0 ? WRAP_RISE - 1e-3 : state->jaws, 0.0, rise.z);
    double back = vbss_min(state->hanging, vbss_max(jaws.x - (WRAP_RISE - 6e-3), 0.0));
    double sine, cosine, rest = state->hanging - back;
    vbss_sincos(PI * state->swing, &sine, &cosine);
    if (rest > 1e-9) { /* what hangs reaches back out of the loops: then to the side */
        p->at = vec3_make(jaws.x - back, BESIDE + rest, rise.z);
        go(p, vec3_make(jaws.x - back, BESIDE, rise.z));
    } else {
        p->at = vec3_add(jaws, vec3_make(-cosine * back, BESIDE + sine * back, 0.0));
    }
    go(p, vec3_add(jaws, vec3_make(0.0, BESIDE, 0.0)));
    go(p, vec3_add(jaws, vec3_make(jaws.x > WRAP_RISE ? 0.35e-3 * vbss_max(cosine, 0.0) : 0.0,
                                   0.5 * BESIDE, 0.0)));
    go(p, jaws);
    if (jaws.x > WRAP_RISE) {
        go(p, rise);
        go(p, vec3_make(WRAP_RISE - 1e-3, 0.0, rise.z - 1e-3));
        go(p, vec3_make(WRAP_RISE - 0.7e-3, 0.0, rise.z - 2.5e-3));
    }
    go(p, vec3_make(-half_width(state) - 1.5e-3, 0.0, low));
}

static void put_below(const wrap_state *state, pen *p)
{
    double half = half_width(state), low = top(state);
    vec3 begin = vec3_make(-half, 0.0, low), end = vec3_make(half, 0.0, low);
    if (state->below.throws > 0) {
        knot_pile pile = state->below;
        go(p, begin);
        p->at = knot_path_put_pile(&pile, SIZE, 0.5 * DEPTH, p->curve);
    } else {
        go(p, begin);
        knot_curve_arc(p->curve, vec3_zero(), 0.5 * DRAIN, PI, 2.0 * PI);
        p->at = end;
    }
}

static void put_limb(const wrap_state *state, pen *p)
{
    double half = half_width(state), low = top(state);
    bool bare = state->below.throws == 0;
    if (!bare) {
        go(p, vec3_make(half + 0.8e-3, 0.0, low));
    }
    go(p, vec3_make(half + (bare ? 0.2e-3 : 1.5e-3), 0.0, low + 0.8e-3));
    go(p, vec3_make(half + (bare ? 0.2e-3 : 1.2e-3), 0.0, low + 2.2e-3));
    vec3 start = on_helix(0.0, state);
    double ahead = state->to_handle ? -1.0 : 1.0; /* it comes in along the axis */
    go(p, vec3_add(start, vec3_make(ahead * 1.5e-3, 0.0, -1.3e-3)));
    go(p, vec3_add(start, vec3_make(ahead * 0.8e-3, 0.0, -0.2e-3)));
    go(p, start);
    double length = 2.0 * WRAP_LOOPS + 2.0 * PI * state->radius *
                                           (fabs(state->turns) + 2.0 * fabs(state->there_and_back));
    knot_curve_piece(p->curve, length, on_helix, state);
    p->at = on_helix(1.0, state);
    double z = wrap_axis_height(state), sense = state->to_handle ? -1.0 : 1.0;
    double out = state->pulled * 25e-3;
    vec3 side = aside(turned(state, 1.0));
    vec3 needle = vec3_add_scaled(vec3_make(sense * WRAP_FRONT, 0.0, z), ORBIT, side);
    go(p, needle);
    go(p, vec3_add_scaled(needle, -sense * 4e-3, vec3_make(1.0, 0.0, 0.0)));
    if (state->to_handle) { /* the tail's end comes to this side too */
        go(p, vec3_add_scaled(p->at, out + 4e-3, side));
    } else {
        go(p, vec3_add_scaled(p->at, -out - 4e-3, vec3_make(1.0, 0.0, 0.0)));
    }
}

/* ---- the polyline */

static double mix(double a, double b, double share)
{
    return a + share * (b - a);
}

static uint32_t nearest(const swept_line *fine, uint32_t from, uint32_t to, vec3 x)
{
    uint32_t best = from;
    for (uint32_t i = from; i <= to; i++) {
        best = vec3_distance(fine->x[i], x) < vec3_distance(fine->x[best], x) ? i : best;
    }
    return best;
}

/* A share of the curve in equal pieces that are nearly straight. */
static bool put_share(const wrap_state *state, const knot_curve *curve, double from, double to,
                      swept_line *fine)
{
    uint32_t first = fine->slots, pieces = 1;
    double worst = 1.0;
    while (worst > NEARLY && pieces <= 64) {
        vec3 a = flattened(state, knot_curve_at(curve, from));
        worst = 0.0;
        fine->slots = first;
        for (uint32_t i = 0; i < pieces; i++) {
            double s = mix(from, to, (i + 0.5) / pieces), t = mix(from, to, (i + 1.0) / pieces);
            vec3 middle = flattened(state, knot_curve_at(curve, s));
            vec3 b = flattened(state, knot_curve_at(curve, t));
            double strays = vec3_distance(middle, vec3_lerp(a, b, 0.5));
            worst = vbss_max(worst, strays / vec3_distance(a, b));
            if (!swept_put(fine, a, strays, false)) {
                return false;
            }
            a = b;
        }
        pieces *= 2;
    }
    return worst <= NEARLY;
}

static bool put_finely(const wrap_state *state, const knot_curve *curve, double length,
                       swept_line *fine)
{
    uint32_t shares = (uint32_t)(length / FINE) + 1;
    for (uint32_t i = 0; i < shares; i++) {
        if (!put_share(state, curve, length * i / shares, length * (i + 1.0) / shares, fine)) {
            return false;
        }
    }
    return swept_put(fine, flattened(state, knot_curve_at(curve, length)), 0.0, false);
}

/* Even segments, or where these do not do others. */
static bool choose(swept_line *fine, uint32_t segments)
{
    double length = 0.0, reached = 0.0;
    for (uint32_t v = 0; v < fine->last; v++) {
        length += vec3_distance(fine->x[v], fine->x[v + 1]);
    }
    uint32_t number = 1;
    for (uint32_t v = 1; v < fine->last; v++) {
        reached += vec3_distance(fine->x[v - 1], fine->x[v]);
        if (reached >= length * number / segments && number < segments) {
            fine->stays[v] = true;
            number++;
        }
    }
    if (number == segments && swept_thin_all(fine)) {
        return true;
    }
    for (uint32_t v = fine->next[0]; v != fine->last; v = fine->next[v]) {
        fine->stays[v] = false;
    }
    return swept_thin(fine, segments);
}

/* The place on what is left of a point that was a vertex. */
static double place_of(const swept_line *fine, uint32_t vertex)
{
    uint32_t number = 0, v = 0;
    while (fine->next[v] <= vertex && fine->next[v] != fine->last) {
        v = fine->next[v];
        number++;
    }
    vec3 a = fine->x[v], b = fine->x[fine->next[v]], along = vec3_sub(b, a);
    double t = vec3_dot(vec3_sub(fine->x[vertex], a), along) / vec3_norm_squared(along);
    return number + vbss_min(vbss_max(t, 0.0), 1.0);
}

static bool read_off(swept_line *fine, const wrap_state *state, uint32_t segments,
                     thread_line *line, double *jaws)
{
    bool bare = state->below.throws == 0;
    double low = bare ? 0.0 : -0.25 * SIZE - DEPTH, x = 0.5 * DRAIN;
    uint32_t last = fine->last;
    uint32_t middle = nearest(fine, 0, last, vec3_make(0.0, 0.0, bare ? -x : low));
    uint32_t holes[2] = {nearest(fine, 0, middle, vec3_make(-x, 0.0, low)),
                         nearest(fine, middle, last, vec3_make(x, 0.0, low))};
    double z = wrap_axis_height(state);
    uint32_t held = nearest(fine, 0, holes[0], vec3_make(state->jaws, 0.0, z));
    swept_finish(fine);
    if (!swept_is_true(fine) || !choose(fine, segments)) {
        return false;
    }
    line->count = 0;
    for (uint32_t v = 0;; v = fine->next[v]) {
        line->x[line->count++] = fine->x[v];
        if (v == fine->last) {
            break;
        }
    }
    *jaws = place_of(fine, held);
    line->tissue_place = place_of(fine, middle);
    for (int i = 0; i < 2; i++) {
        line->hole_places[i] = place_of(fine, holes[i]);
        line->holes[i] = thread_line_at(line, line->hole_places[i]);
    }
    line->away = vec3_make(0.0, 0.0, -1.0);
    return true;
}

bool wrap_path(const wrap_state *state, uint32_t segments, thread_line *line, double *jaws)
{
    knot_curve curve;
    pen p = {.curve = &curve};
    knot_curve_begin(&curve, SPACING);
    put_tail(state, &p);
    uint32_t before_drain = curve.count;
    put_below(state, &p);
    put_limb(state, &p);
    knot_curve_finish(&curve, p.at);
    swept_line *fine = malloc(sizeof *fine);
    if (curve.full || fine == NULL || segments < 3 || segments >= STACK_POINTS) {
        free(fine);
        return false;
    }
    swept_begin(fine, 2e-6);
    double tail = curve.arcs[before_drain - 1] + 1.4e-3;
    double length = tail + state->limb_left * (knot_curve_length(&curve) - tail);
    bool done =
        put_finely(state, &curve, length, fine) && read_off(fine, state, segments, line, jaws);
    free(fine);
    return done;
}
