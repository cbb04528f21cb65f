#include "knot/derive.h"

#include "base/elementary.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#define MARGIN 4e-6 /* m */
#define CLEAR 1e-4  /* m: vertices stay so far below the plane of an end */
#define TURN 6.28318530717958648

static double draw(vbss_random *random, double low, double high)
{
    return low + (high - low) * vbss_random_uniform(random);
}

/* ---- the line, laid anew without the vertices that are gone */

static void copy_to(const family_case *from, const double places[3], uint32_t count, derivation *d)
{
    const thread_line *line = &from->line;
    uint32_t next = 0;
    swept_begin(&d->line, MARGIN);
    for (uint32_t i = 0; i < line->count; i++) {
        if (next < count && places[next] == i) {
            d->marks[next++] = d->line.slots;
        }
        (void)swept_put(&d->line, line->x[i], 0.0, false);
        for (; next < count && places[next] > i && places[next] < i + 1.0; next++) {
            d->marks[next] = d->line.slots;
            (void)swept_put(&d->line, thread_line_at(line, places[next]), 0.0, false);
        }
    }
}

static void finish(derivation *d)
{
    for (uint32_t k = 0; k < 3 && d->has_marks; k++) {
        d->line.stays[d->marks[k]] = true;
    }
    swept_finish(&d->line);
    swept_put_ray(&d->line, 0, d->out[0]);
    swept_put_ray(&d->line, d->line.last, d->out[1]);
    if (d->has_marks) {
        swept_put_ray(&d->line, d->marks[1], d->from.line.away);
    }
}

static void pack(derivation *d)
{
    uint32_t marks[3] = {0, 0, 0};
    swept_line *old = &d->line, *fresh = &d->spare;
    swept_begin(fresh, MARGIN);
    for (uint32_t v = 0;; v = old->next[v]) {
        for (uint32_t k = 0; k < 3 && d->has_marks; k++) {
            marks[k] = v == d->marks[k] ? fresh->slots : marks[k];
        }
        (void)swept_put(fresh, old->x[v], 0.0, false);
        if (v == old->last) {
            break;
        }
    }
    memcpy(d->marks, marks, sizeof marks);
    /* Only what is there: the arrays are long. */
    swept_begin(old, MARGIN);
    for (uint32_t v = 0; v < fresh->slots; v++) {
        (void)swept_put(old, fresh->x[v], 0.0, false);
    }
    finish(d);
}

/* ---- how ends go on */

static bool find_out(derivation *d, uint32_t end, const thread_line *line, vec3 *out)
{
    vec3 x = d->line.x[end];
    for (uint32_t k = 1; k < line->count; k++) {
        uint32_t other = end == 0 ? k : line->count - 1 - k;
        *out = vec3_unit_or(vec3_sub(x, line->x[other]), vec3_make(1.0, 0.0, 0.0));
        if (swept_end_is_outermost(&d->line, end, *out)) {
            return true;
        }
    }
    return false;
}

bool derive_begin(derivation *d, const family_case *from)
{
    const thread_line *line = &from->line;
    const double places[3] = {line->hole_places[0], line->tissue_place, line->hole_places[1]};
    d->from = *from;
    d->moved = d->removed = d->split = 0;
    d->has_marks = line->tissue_place >= 0.0;
    copy_to(from, places, d->has_marks ? 3 : 0, d);
    swept_finish(&d->line);
    if (!find_out(d, 0, line, &d->out[0]) || !find_out(d, d->line.last, line, &d->out[1])) {
        return false;
    }
    finish(d);
    return true;
}

/* ---- moves */

static bool below_ends(const derivation *d, vec3 p)
{
    const swept_line *line = &d->line;
    return vec3_dot(vec3_sub(p, line->x[0]), d->out[0]) < -CLEAR &&
           vec3_dot(vec3_sub(p, line->x[line->last]), d->out[1]) < -CLEAR;
}

static uint32_t walk(const derivation *d, vbss_random *random, uint32_t v)
{
    for (uint32_t k = vbss_random_below(random, 20) + 1; k > 0; k--) {
        v = v == d->line.last ? 0 : d->line.next[v];
    }
    return v;
}

static void jump(derivation *d, vbss_random *random, uint32_t v, double size)
{
    swept_line *line = &d->line;
    vec3 direction = vbss_random_direction(random);
    double rare = 0.002 + vbss_random_uniform(random);
    vec3 to = vec3_add_scaled(line->x[v], size / sqrt(rare), direction);
    if (!line->stays[v] && below_ends(d, to)) {
        d->moved += swept_move(line, v, to);
    }
}

static void take(derivation *d)
{
    thread_line *to = &d->from.line;
    double places[3] = {-1.0, -1.0, -1.0};
    uint32_t n = 0;
    for (uint32_t v = 0;; v = d->line.next[v]) {
        for (uint32_t k = 0; k < 3 && d->has_marks; k++) {
            places[k] = v == d->marks[k] ? n : places[k];
        }
        to->x[n++] = d->line.x[v];
        if (v == d->line.last) {
            break;
        }
    }
    to->count = n;
    to->hole_places[0] = places[0];
    to->tissue_place = places[1];
    to->hole_places[1] = places[2];
    for (int i = 0; i < 2 && d->has_marks; i++) {
        to->holes[i] = thread_line_at(to, to->hole_places[i]);
    }
}

void derive_move(derivation *d, vbss_random *random)
{
    enum { MAX_COUNT = 1000 }; /* vertices */
    swept_line *line = &d->line;
    double size = 0.02e-3 * vbss_exp(4.0 * vbss_random_uniform(random));
    uint32_t tries = 10 + vbss_random_below(random, 90), kind = vbss_random_below(random, 8);
    pack(d);
    for (uint32_t i = 0, v = 0; i < tries; i++) {
        v = walk(d, random, v);
        if (kind == 0 && !line->stays[v]) {
            uint32_t before = line->previous[v];
            if (swept_remove(line, v)) {
                d->removed++;
                v = before;
            }
        } else if (kind == 1 && v != line->last && line->count < MAX_COUNT) {
            d->split += swept_split(line, v);
        } else {
            jump(d, random, v, size);
        }
    }
    take(d);
}

/* ---- the whole */

derive_whole derive_plain(void)
{
    return (derive_whole){.turn = {1.0, 0.0, 0.0, 0.0}, .scale = 1.0};
}

derive_whole derive_draw(vbss_random *random)
{
    derive_whole how = derive_plain();
    uint32_t kind = vbss_random_below(random, 8);
    vec3 axis = vbss_random_direction(random), shift = vbss_random_direction(random);
    double sine, cosine;
    vbss_sincos(0.5 * TURN * vbss_random_uniform(random), &sine, &cosine);
    how.turn = (quat){cosine, sine * axis.x, sine * axis.y, sine * axis.z};
    how.mirrored = vbss_random_below(random, 2) == 1;
    how.reversed = vbss_random_below(random, 2) == 1;
    double size = draw(random, -6.9, 6.9), far = draw(random, -9.0, 4.6);
    how.scale = kind == 1 ? vbss_exp(size) : 1.0;
    how.shift = kind == 2 ? vec3_scale(shift, vbss_exp(far)) : vec3_zero();
    how.doubled = kind == 3 ? vbss_random_uniform(random) : 0.0;
    how.inserted = kind == 4 ? vbss_random_below(random, 200) : 0;
    how.no_tissue = kind == 5;
    how.seed = vbss_random_u64(random);
    return how;
}

/* A point more after point i; places after it move on. */
static void insert(thread_line *line, uint32_t i, double share)
{
    vec3 x = share > 0.0 ? vec3_lerp(line->x[i], line->x[i + 1], share) : line->x[i];
    memmove(line->x + i + 2, line->x + i + 1, (line->count - i - 1) * sizeof *line->x);
    line->x[i + 1] = x;
    line->count++;
    double *places[3] = {&line->hole_places[0], &line->tissue_place, &line->hole_places[1]};
    for (int k = 0; k < 3; k++) {
        double at = *places[k] - i;
        if (at >= 1.0 || (at > 0.0 && share <= 0.0)) { /* 0: all the length lies after the second */
            *places[k] += 1.0;
        } else if (at > 0.0) {
            *places[k] = at < share ? i + at / share : i + 1.0 + (at - share) / (1.0 - share);
        }
    }
}

static void change_points(thread_line *line, const derive_whole *how)
{
    vbss_random random;
    vbss_random_seed(&random, how->seed, 3);
    for (uint32_t i = 0; i < line->count && line->count < STACK_POINTS; i++) {
        if (vbss_random_uniform(&random) < how->doubled) {
            insert(line, i++, 0.0);
        }
    }
    for (uint32_t k = 0; k < how->inserted && line->count < STACK_POINTS; k++) {
        uint32_t at = vbss_random_below(&random, line->count - 1);
        insert(line, at, draw(&random, 0.05, 0.95));
    }
}

static vec3 placed(const derive_whole *how, vec3 x)
{
    return vec3_add_scaled(how->shift, how->scale, quat_rotate(how->turn, x));
}

void derive_whole_of(const family_case *from, const derive_whole *how, family_case *to)
{
    *to = *from;
    thread_line *line = &to->line;
    if (how->mirrored) {
        thread_line_mirror(line);
        for (uint32_t i = 0; i < to->throws; i++) {
            to->signs[i] = -to->signs[i];
        }
        to->stray_sign = -to->stray_sign;
        to->v3 = -to->v3;
    }
    if (how->reversed) {
        thread_line_reverse(line);
        to->stray_in_tail = !to->stray_in_tail;
    }
    for (uint32_t i = 0; i < line->count; i++) {
        line->x[i] = placed(how, line->x[i]);
    }
    change_points(line, how);
    if (how->no_tissue && to->stray_wraps == 0) {
        thread_line_leave_tissue(line);
    }
    if (line->tissue_place >= 0.0) {
        line->away = quat_rotate(how->turn, line->away);
        for (int i = 0; i < 2; i++) {
            line->holes[i] = thread_line_at(line, line->hole_places[i]);
        }
    }
}

/* ---- judged */

static void count_fault(judge_counts *counts, const char *what)
{
    judge_counts one = {.heard = 1, .wrong = 1};
    snprintf(one.first, sizeof one.first, "%s: it is refused", what);
    judge_add_up(counts, &one);
}

static void hear(judge *j, family_case *c, bool tail_last, const char *what, judge_counts *counts)
{
    judge_saying saying;
    if (tail_last) {
        thread_line_reverse(&c->line);
    }
    vbss_knot_input in = judge_input_of(&c->line);
    in.reversed = tail_last ? 1 : 0;
    if (judge_hear(j, &in, &saying) != VBSS_OK) {
        count_fault(counts, what);
        return;
    }
    judge_count(counts, &saying, c, tail_last, what);
}

bool derive_and_judge(judge *j, const family *f, uint64_t seed, uint32_t segments,
                      uint32_t configurations, judge_counts *counts)
{
    static family_case made, shown;
    static derivation d;
    char what[120];
    if (!f->make(seed, segments, &made)) {
        return false;
    }
    snprintf(what, sizeof what, "%s, seed %llu, %u segments", f->name, (unsigned long long)seed,
             segments);
    hear(j, &made, false, what, counts);
    if (made.truth == FAMILY_OPEN || !derive_begin(&d, &made)) {
        return true;
    }
    vbss_random random;
    vbss_random_seed(&random, seed, segments);
    for (uint32_t k = 0; k < configurations; k++) {
        derive_move(&d, &random);
        derive_whole how = derive_draw(&random);
        derive_whole_of(&d.from, &how, &shown);
        snprintf(what, sizeof what, "%s, seed %llu, %u segments, configuration %u", f->name,
                 (unsigned long long)seed, segments, k);
        hear(j, &shown, k % 4 == 3, what, counts);
    }
    return true;
}
