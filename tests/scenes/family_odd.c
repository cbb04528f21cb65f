/* Families of threads that are no plain stacks of throws. */
#include "scenes/family_odd.h"

#include <string.h>

#include "base/elementary.h"
#include "base/random.h"
#include "scenes/clutter.h"
#include "scenes/isotopy.h"
#include "scenes/wrap_scripts.h"

#define PI 3.141592653589793
#define SIZE 1e-3 /* m: of the stacks */

static double draw(vbss_random *random, double low, double high)
{
    return low + (high - low) * vbss_random_uniform(random);
}

static bool put(thread_line *line, vec3 x)
{
    if (line->count == STACK_POINTS) {
        return false;
    }
    line->x[line->count++] = x;
    return true;
}

/* Straight on from the long limb's end. */
static bool put_straight(thread_line *line, vec3 to, double step)
{
    vec3 from = line->x[line->count - 1];
    uint32_t pieces = (uint32_t)(vec3_distance(from, to) / step) + 1;
    for (uint32_t i = 1; i <= pieces; i++) {
        if (!put(line, vec3_lerp(from, to, (double)i / pieces))) {
            return false;
        }
    }
    return true;
}

/* ---- no knot */

bool family_crossed_ends(uint64_t seed, uint32_t segments, family_case *made)
{
    return family_stack(0, 0, 60e-3, made) &&
           family_carry(seed, segments, 0.2 + 0.25 * (double)(seed % 4), 0.0, made);
}

/* Both limbs lie in heaps. */
bool family_tangle(uint64_t seed, uint32_t segments, family_case *made)
{
    clutter over = {.tail = false,
                    .up = {0.0, 0.0, 1.0},
                    .reach = 7e-3,
                    .slope = 0.06,
                    .passes = 6 + (uint32_t)(seed % 5)};
    clutter aside = {
        .tail = true, .up = {-1.0, 0.0, 0.0}, .reach = 5e-3, .slope = 0.1, .passes = 4};
    return family_stack(0, 0, 3e-3, made) && clutter_limb(&made->line, &over, seed) &&
           clutter_limb(&made->line, &aside, seed + 1) &&
           family_carry(seed, segments, 0.2 + 0.25 * (double)(seed % 4), 0.0, made);
}

/* ---- the tail comes back out of its last throw as a bight */

#define BESIDE (0.12 * SIZE) /* of the strand that comes back */
#define STOREY (2.9 * SIZE)  /* from throw to throw */

/* The last point before the last throw, walking from the tissue to the tail's end. */
static uint32_t before_last_throw(const family_case *made)
{
    double z = made->throws == 1 ? -0.25 * SIZE - 2e-3 : (made->throws - 1.5) * STOREY;
    uint32_t i = (uint32_t)made->line.tissue_place;
    while (i > 0 && made->line.x[i].z < z) {
        i--;
    }
    return i;
}

bool family_bight(uint64_t seed, uint32_t segments, family_case *made)
{
    static const uint32_t of[3] = {1, 2, 3};
    uint32_t throws = of[seed % 3];
    if (!family_stack(throws, (seed / 3) * 41 % 216, 60e-3, made)) {
        return false;
    }
    thread_line *line = &made->line;
    uint32_t from = before_last_throw(made), to = 0;
    double fold = 8e-3; /* of thread that is a bight beyond the throw */
    while (to + 1 < from && vec3_distance(line->x[to], line->x[0]) < 15e-3 - fold) {
        to++;
    }
    static vec3 back[STACK_POINTS];
    uint32_t count = 0;
    vec3 n = vec3_make(0.0, 1.0, 0.0);
    for (uint32_t i = from + 1; i-- > to;) { /* a normal that turns as little as it can */
        vec3 along = vec3_unit_or(vec3_sub(line->x[i], line->x[i + 1]), vec3_zero());
        n = vec3_unit_or(vec3_add_scaled(n, -vec3_dot(n, along), along), n);
        back[count++] = vec3_add_scaled(line->x[i], BESIDE, n);
    }
    vec3 end = vec3_add_scaled(back[0], 15e-3, vec3_make(0.0, 1.0, 0.0));
    thread_line_reverse(line);
    line->count -= to;
    while (count > 0) {
        if (!put(line, back[--count])) {
            return false;
        }
    }
    bool done = put_straight(line, end, 1e-3);
    thread_line_reverse(line);
    made->throws--;
    return done && family_carry(seed, segments, 0.1 + 0.2 * (double)(seed % 3), 0.0, made);
}

/* ---- knots in one limb */

static bool stray(uint64_t seed, uint32_t segments, uint32_t throws, double gap, family_case *made)
{
    vbss_random random;
    vbss_random_seed(&random, seed, 21);
    uint64_t n = vbss_random_u64(&random);
    if (!family_stack(throws, n % 216, gap, made)) {
        return false;
    }
    made->stray_in_tail = seed % 2 == 1;
    made->stray_wraps = (int)(seed / 4 % 3) + 1;
    made->stray_sign = seed % 4 < 2 ? 1 : -1;
    if (made->stray_in_tail) { /* from a shorter tail on */
        clutter_cut(&made->line, true, 0.0);
    }
    double size = draw(&random, 0.7e-3, 1.2e-3);
    return clutter_throw(&made->line, made->stray_in_tail, made->stray_wraps, made->stray_sign,
                         size, 25e-3) &&
           family_carry(seed, segments, 0.1 + 0.2 * (double)(seed % 4), 0.0, made);
}

/* Far from the throws. */
bool family_stray(uint64_t seed, uint32_t segments, family_case *made)
{
    return stray(seed, segments, (uint32_t)(seed / 12 % 4), 15e-3, made);
}

/* Next to one throw: what should have been the second one. */
bool family_own_limb(uint64_t seed, uint32_t segments, family_case *made)
{
    return stray(2 * seed, segments, 1, 1e-3, made);
}

/* ---- the long limb goes back */

/* Round the knot and past the drain, beside the thread that is in it: that ties and unties nothing. */
bool family_beside_drain(uint64_t seed, uint32_t segments, family_case *made)
{
    if (!family_stack(1 + (uint32_t)(seed % 2), seed * 7 % 36, 3e-3, made)) {
        return false;
    }
    thread_line *line = &made->line;
    vec3 end = line->x[line->count - 1];
    vec3 middle = thread_line_at(line, line->tissue_place);
    double y = 0.6e-3, far = end.x + 2e-3;
    return put_straight(line, vec3_make(far, 0.2e-3, end.z), 0.5e-3) &&
           put_straight(line, vec3_make(far + 1e-3, y, 0.5 * end.z + 0.5 * middle.z), 0.5e-3) &&
           put_straight(line, vec3_make(far, y, middle.z), 0.5e-3) &&
           put_straight(line, vec3_make(-far, y, middle.z), 0.5e-3) &&
           put_straight(line, vec3_make(-far, 20e-3, middle.z), 1e-3) &&
           family_carry(seed, segments, 0.1 + 0.2 * (double)(seed % 4), 0.0, made);
}

/* It was drawn back through the throw and the drain: nothing goes through tissue any more. */
bool family_withdrawn(uint64_t seed, uint32_t segments, family_case *made)
{
    if (!family_stack(1, seed % 6, 60e-3, made)) {
        return false;
    }
    thread_line *line = &made->line;
    line->count = (uint32_t)line->hole_places[0] + 1;
    vec3 end = line->x[line->count - 1];
    thread_line_leave_tissue(line);
    made->throws = 0;
    return put_straight(line, vec3_add(end, vec3_make(1e-3, -20e-3, -4e-3)), 1e-3) &&
           family_carry(seed, segments, 0.2 + 0.2 * (double)(seed % 4), 0.0, made);
}

/* ---- what so many turns about a tool have tied, on the right side and on the wrong one */

bool family_wraps(uint64_t seed, uint32_t segments, family_case *made)
{
    script_frame frame;
    if (!wrap_script_frame(0, (uint32_t)(seed % 26), 1.0, 400, &frame)) {
        return false;
    }
    *made = (family_case){.truth = FAMILY_THROWS, .throws = frame.throws, .line = frame.line};
    memcpy(made->wraps, frame.throw_wraps, sizeof made->wraps);
    memcpy(made->signs, frame.throw_signs, sizeof made->signs);
    return family_carry(seed, segments, 0.1 + 0.2 * (double)(seed % 4), 0.0, made);
}

/* ---- closed curves, opened where they are furthest out */

typedef struct closed_curve {
    int p, q; /* torus: p times round the axis, q times round the ring */
    int64_t determinant, v2, v3;
} closed_curve;

static vec3 torus_point(double t, const closed_curve *c)
{
    double r = 2.0 + vbss_cos(c->q * t);
    return vec3_make(r * vbss_cos(c->p * t), r * vbss_sin(c->p * t), -vbss_sin(c->q * t));
}

static vec3 figure_eight(double t)
{
    double r = 2.0 + vbss_cos(2.0 * t);
    return vec3_make(r * vbss_cos(3.0 * t), r * vbss_sin(3.0 * t), vbss_sin(4.0 * t));
}

/* Lissajous: 5_2 */
static vec3 three_twists(double t)
{
    return vec3_make(vbss_cos(3.0 * t + 0.7), vbss_cos(2.0 * t + 0.2), vbss_cos(7.0 * t));
}

static vec3 on_closed(double t, const closed_curve *c)
{
    return c->p > 0 ? torus_point(t, c) : c->determinant == 5 ? figure_eight(t) : three_twists(t);
}

/* Its ends go straight out, a little away from each other. */
static bool open_curve(const closed_curve *c, thread_line *line)
{
    enum { PIECES = 400 };
    double furthest = 0.0, begin = 0.0;
    for (int i = 0; i < PIECES; i++) {
        double t = 2.0 * PI * i / PIECES, distance = vec3_norm(on_closed(t, c));
        begin = distance > furthest ? t : begin;
        furthest = vbss_max(furthest, distance);
    }
    vec3 first = on_closed(begin + PI / PIECES, c), last = on_closed(begin - PI / PIECES, c);
    vec3 out = vec3_unit_or(on_closed(begin, c), vec3_zero());
    vec3 ahead = vec3_unit_or(vec3_sub(first, last), vec3_zero());
    line->count = 0;
    thread_line_leave_tissue(line);
    for (int i = 6; i > 0; i--) {
        vec3 x = vec3_add_scaled(first, 0.25 * i, vec3_add_scaled(out, 0.4, ahead));
        put(line, vec3_scale(x, 4.0 * SIZE));
    }
    for (int i = 0; i < PIECES; i++) {
        put(line, vec3_scale(on_closed(begin + 2.0 * PI * (i + 0.5) / PIECES, c), 4.0 * SIZE));
    }
    for (int i = 1; i <= 6; i++) {
        vec3 x = vec3_add_scaled(last, 0.25 * i, vec3_add_scaled(out, -0.4, ahead));
        put(line, vec3_scale(x, 4.0 * SIZE));
    }
    return true;
}

/* T(2, q): one throw, without tissue. */
bool family_torus(uint64_t seed, uint32_t segments, family_case *made)
{
    int k = (int)(seed / 2 % 5), sign = seed % 2 == 0 ? 1 : -1;
    int wraps = k < 3 ? k + 1 : k - 2; /* and twice along, once around */
    closed_curve c = {.p = k < 3 ? 2 : 2 * wraps + 1, .q = sign * (k < 3 ? 2 * wraps + 1 : 2)};
    *made = (family_case){.truth = FAMILY_THROWS, .throws = 1, .wraps = {wraps}, .signs = {sign}};
    return open_curve(&c, &made->line) &&
           family_carry(seed, segments, 0.1 + 0.2 * (double)(seed % 4), 0.0, made);
}

bool family_other(uint64_t seed, uint32_t segments, family_case *made)
{
    static const closed_curve curves[4] = {
        {0, 0, 5, -1, 0}, {0, 0, 7, 2, 3}, {3, 4, 3, 5, 10}, {3, 5, 1, 8, 20}};
    const closed_curve *c = &curves[seed % 4];
    *made = (family_case){
        .truth = FAMILY_OTHER, .determinant = c->determinant, .v2 = c->v2, .v3 = c->v3};
    if (!open_curve(c, &made->line) ||
        !family_carry(seed, segments, 0.1 + 0.2 * (double)(seed % 4), 0.0, made)) {
        return false;
    }
    if (seed / 4 % 2 == 1) {
        thread_line_mirror(&made->line);
        made->v3 = -made->v3;
    }
    return true;
}

/* ---- no truth */

bool family_ends_inside(uint64_t seed, uint32_t segments, family_case *made)
{
    vbss_random random;
    vbss_random_seed(&random, seed, 22);
    double share = draw(&random, 0.3, 0.9);
    if (!family_stack(3, seed % 216, 20e-3, made)) {
        return false;
    }
    uint32_t more = (uint32_t)(segments / (1.0 - 0.4 * share));
    if (more >= STACK_POINTS || !family_carry(seed, more, 0.5, 0.0, made)) {
        return false;
    }
    clutter_cut(&made->line, seed % 3 == 0, share);
    made->truth = FAMILY_OPEN;
    return true;
}
