#include "scenes/isotopy.h"

#include <stdlib.h>

#include "base/elementary.h"
#include "base/random.h"
#include "scenes/swept.h"

enum { MOST_FLOWS = 48, MOST_PIECES = 128, DRAWS = 8 };

#define PI 3.141592653589793
#define TOLERANCE 8e-6 /* m: of an edge from the image of what it stands for */
#define MARGIN 4e-6    /* m */
#define LARGEST 25e-3  /* m: radius of a ball in which something moves */
#define SMALLEST 2e-3

void isotopy_init(isotopy *way, uint64_t seed)
{
    *way =
        (isotopy){.seed = seed, .strength = 0.3, .segments = 240, .jump = 0.5e-3, .turned = true};
}

/* ---- diffeomorphisms of space that are the identity outside a ball */

typedef struct flow {
    vec3 centre;
    double radius;
    vec3 axis;    /* of a swirl, unit */
    double angle; /* rad; 0: a push */
    vec3 push;    /* shorter than 0.4 radii: the decay's slope is at most 1.72 / radius */
} flow;

static quat turn_about(vec3 axis, double angle)
{
    double sine, cosine;
    vbss_sincos(0.5 * angle, &sine, &cosine);
    return (quat){cosine, sine * axis.x, sine * axis.y, sine * axis.z};
}

static vec3 move(const flow *f, vec3 p)
{
    vec3 from = vec3_sub(p, f->centre);
    double rest = 1.0 - vec3_norm_squared(from) / (f->radius * f->radius);
    if (!(rest > 0.0)) {
        return p;
    }
    double share = rest * rest * rest;
    if (f->angle == 0.0) {
        return vec3_add_scaled(p, share, f->push);
    }
    quat turn = turn_about(f->axis, share * f->angle);
    return vec3_add(f->centre, quat_rotate(turn, from));
}

typedef struct flows {
    uint32_t count;
    flow all[MOST_FLOWS];
} flows;

static vec3 carry(const flows *f, vec3 p)
{
    for (uint32_t i = 0; i < f->count; i++) {
        p = move(&f->all[i], p);
    }
    return p;
}

/* ---- the holes and the place between them, in their order */

typedef struct marks {
    uint32_t count, vertex[3];
    double place[3];
} marks;

/* Near a vertex they are moved there: edges must be long against margins. */
static marks marks_of(const thread_line *line)
{
    double place[3] = {line->hole_places[0], line->tissue_place, line->hole_places[1]};
    marks m = {.count = line->tissue_place >= 0.0 ? 3 : 0};
    for (int k = 0; k < 3; k++) {
        double vertex = floor(place[k] + 0.5);
        m.place[k] = fabs(place[k] - vertex) < 0.2 ? vertex : place[k];
    }
    for (int k = 0; k < 3 && !(m.place[0] < m.place[1] && m.place[1] < m.place[2]); k++) {
        m.place[k] = place[k];
    }
    return m;
}

/* ---- what diffeomorphisms may not move */

typedef struct rays {
    uint32_t count; /* tail's end, long limb's end, tissue */
    vec3 from[3], along[3];
} rays;

static rays rays_of(const thread_line *line, const marks *m)
{
    uint32_t last = line->count - 1;
    rays r = {.count = 2};
    r.from[0] = line->x[0];
    r.along[0] = vec3_unit_or(vec3_sub(line->x[0], line->x[1]), vec3_zero());
    r.from[1] = line->x[last];
    r.along[1] = vec3_unit_or(vec3_sub(line->x[last], line->x[last - 1]), vec3_zero());
    if (m->count > 0) {
        r.from[2] = thread_line_at(line, m->place[1]);
        r.along[2] = line->away;
        r.count = 3;
    }
    return r;
}

static double distance_to_ray(vec3 p, vec3 from, vec3 along)
{
    double t = vbss_max(vec3_dot(vec3_sub(p, from), along), 0.0);
    return vec3_distance(p, vec3_add_scaled(from, t, along));
}

static double room(const rays *r, uint32_t count, vec3 p)
{
    double least = LARGEST;
    for (uint32_t i = 0; i < count; i++) {
        least = vbss_min(least, 0.98 * distance_to_ray(p, r->from[i], r->along[i]));
    }
    return least;
}

/* ---- drawing them */

static double draw(vbss_random *random, double low, double high)
{
    return low + (high - low) * vbss_random_uniform(random);
}

/* About a place near the line, as it is by then. */
static bool draw_flow(vbss_random *random, const thread_line *line, const rays *r, double strength,
                      flows *f)
{
    flow *added = &f->all[f->count];
    uint32_t at = vbss_random_below(random, line->count);
    vec3 aside = vbss_random_direction(random);
    double by = draw(random, 0.0, 5e-3), size = vbss_random_uniform(random);
    uint32_t kind = vbss_random_below(random, 6);
    bool twist = r->count == 3 && kind == 0;
    vec3 centre = vec3_add_scaled(carry(f, line->x[at]), by, aside);
    if (twist) {
        double t = vec3_dot(vec3_sub(centre, r->from[2]), r->along[2]);
        centre = vec3_add_scaled(r->from[2], t, r->along[2]);
    }
    double most = room(r, twist ? 2 : r->count, centre);
    if (most < SMALLEST) {
        return false;
    }
    double radius = SMALLEST + (most - SMALLEST) * size;
    vec3 direction = vbss_random_direction(random);
    double amount = strength * vbss_random_normal(random);
    *added = (flow){.centre = centre, .radius = radius, .axis = twist ? r->along[2] : direction};
    if (kind < 4) {
        added->angle = 1.5 * PI * amount;
    } else {
        added->push = vec3_scale(direction, 0.4 * radius * vbss_min(fabs(amount) * 1.5, 1.0));
    }
    f->count++;
    return true;
}

static void draw_flows(vbss_random *random, const thread_line *line, const rays *r, double strength,
                       flows *f)
{
    uint32_t wanted = (uint32_t)(4.0 + 12.0 * strength);
    f->count = 0;
    for (uint32_t i = 0; i < 4 * wanted && f->count < wanted && strength > 0.0; i++) {
        draw_flow(random, line, r, strength, f);
    }
}

/* ---- the fine image of the line */

/* Of the share [t, u] of an edge, from its chord. */
static double deviation(const flows *f, vec3 a, vec3 b, double t, double u, vec3 from, vec3 to)
{
    double most = 0.0;
    for (int k = 1; k < 4; k++) {
        vec3 there = carry(f, vec3_lerp(a, b, t + 0.25 * k * (u - t)));
        most = vbss_max(most, vec3_distance(there, vec3_lerp(from, to, 0.25 * k)));
    }
    return most;
}

/* In so many equal pieces; false when one strays too far. Counts on an empty line `to` NULL. */
static bool put_pieces(const flows *f, vec3 a, vec3 b, uint32_t pieces, swept_line *to)
{
    vec3 from = carry(f, a);
    for (uint32_t k = 0; k < pieces; k++) {
        double t = (double)k / pieces, u = (k + 1.0) / pieces;
        vec3 end = carry(f, vec3_lerp(a, b, u));
        double strays = deviation(f, a, b, t, u, from, end);
        if (to == NULL && strays > vbss_min(TOLERANCE, 0.04 * vec3_distance(from, end))) {
            return false;
        }
        if (to != NULL && !swept_put(to, from, strays, false)) {
            return false;
        }
        from = end;
    }
    return true;
}

static bool put_edge(const flows *f, vec3 a, vec3 b, swept_line *to)
{
    uint32_t pieces = 1;
    while (!put_pieces(f, a, b, pieces, NULL)) {
        pieces *= 2;
        if (pieces > MOST_PIECES) {
            return false;
        }
    }
    return put_pieces(f, a, b, pieces, to);
}

/* Marks get vertices of their own. */
static bool put_image(const flows *f, const thread_line *line, marks *m, swept_line *fine)
{
    uint32_t next = 0;
    for (uint32_t i = 0; i + 1 < line->count; i++) {
        vec3 a = line->x[i], b = line->x[i + 1];
        while (next < m->count && m->place[next] < i + 1.0) {
            vec3 there = thread_line_at(line, m->place[next]);
            if (m->place[next] > i && !put_edge(f, a, there, fine)) {
                return false;
            }
            m->vertex[next++] = fine->slots;
            a = there;
        }
        if (!put_edge(f, a, b, fine)) {
            return false;
        }
    }
    if (!swept_put(fine, carry(f, line->x[line->count - 1]), 0.0, true)) {
        return false;
    }
    for (uint32_t k = 0; k < m->count; k++) {
        fine->stays[m->vertex[k]] = true;
    }
    return true;
}

/* ---- random moves of vertices */

static bool below_ends(const rays *r, vec3 p)
{
    return vec3_dot(vec3_sub(p, r->from[0]), r->along[0]) < -1e-4 &&
           vec3_dot(vec3_sub(p, r->from[1]), r->along[1]) < -1e-4;
}

static void jump(vbss_random *random, const isotopy *way, const rays *r, swept_line *line)
{
    uint32_t tries = (uint32_t)(way->jumps * line->count), v = 0;
    for (uint32_t i = 0; i < tries; i++) {
        for (uint32_t k = vbss_random_below(random, 50) + 1; k > 0; k--) {
            v = v == line->last ? 0 : line->next[v];
        }
        vec3 direction = vbss_random_direction(random);
        double rare = 0.002 + vbss_random_uniform(random);
        vec3 to = vec3_add_scaled(line->x[v], way->jump / sqrt(rare), direction);
        if (!line->stays[v] && below_ends(r, to)) {
            swept_move(line, v, to);
        }
    }
}

/* ---- the whole */

static void take(const swept_line *fine, const marks *m, thread_line *to)
{
    double places[3] = {-1.0, -1.0, -1.0};
    uint32_t n = 0;
    for (uint32_t v = 0;; v = fine->next[v]) {
        for (uint32_t k = 0; k < m->count; k++) {
            places[k] = v == m->vertex[k] ? n : places[k];
        }
        to->x[n++] = fine->x[v];
        if (v == fine->last) {
            break;
        }
    }
    to->count = n;
    to->hole_places[0] = places[0];
    to->tissue_place = places[1];
    to->hole_places[1] = places[2];
}

static void turn_all(vbss_random *random, thread_line *line)
{
    vec3 axis = vbss_random_direction(random);
    quat turn = turn_about(axis, draw(random, 0.0, 2.0 * PI));
    vec3 shift = vbss_random_direction(random);
    for (uint32_t i = 0; i < line->count; i++) {
        line->x[i] = vec3_add_scaled(quat_rotate(turn, line->x[i]), 0.1, shift);
    }
    line->away = quat_rotate(turn, line->away);
}

static bool attempt(const isotopy *way, uint64_t draw_number, const thread_line *from,
                    swept_line *fine, thread_line *to)
{
    vbss_random random;
    vbss_random_seed(&random, way->seed, 64 + draw_number);
    marks m = marks_of(from);
    rays r = rays_of(from, &m);
    flows f;
    draw_flows(&random, from, &r, way->strength, &f);
    swept_begin(fine, MARGIN);
    if (!put_image(&f, from, &m, fine)) {
        return false;
    }
    swept_finish(fine);
    swept_put_ray(fine, 0, r.along[0]);
    swept_put_ray(fine, fine->last, r.along[1]);
    if (r.count == 3) {
        swept_put_ray(fine, m.vertex[1], r.along[2]);
    }
    if (!swept_is_true(fine) || !swept_end_is_outermost(fine, 0, r.along[0]) ||
        !swept_end_is_outermost(fine, fine->last, r.along[1]) || !swept_thin(fine, way->segments)) {
        return false;
    }
    jump(&random, way, &r, fine);
    take(fine, &m, to);
    to->away = from->away;
    if (way->turned) {
        turn_all(&random, to);
    }
    if (m.count > 0) {
        to->holes[0] = thread_line_at(to, to->hole_places[0]);
        to->holes[1] = thread_line_at(to, to->hole_places[1]);
    }
    return true;
}

bool isotopy_apply(const isotopy *way, const thread_line *from, thread_line *to)
{
    swept_line *fine = malloc(sizeof *fine);
    thread_line *made = malloc(sizeof *made);
    bool done = false;
    if (way->segments < 3 || way->segments >= STACK_POINTS) {
        goto end;
    }
    for (uint64_t k = 0; k < DRAWS && !done && fine != NULL && made != NULL; k++) {
        done = attempt(way, k, from, fine, made);
    }
    if (done) {
        *to = *made;
    }
end:
    free(made);
    free(fine);
    return done;
}
