/* A scene in parts small enough to be sorted by depth. */
#include "pieces.h"

#include <stdlib.h>

enum { MAX_PARTS = 96, MAX_JOINED = 16 };

static bool is_round(const shape *s)
{
    return s->kind == SHAPE_CAPSULE || s->kind == SHAPE_LINE;
}

static double length_of(const shape *s)
{
    return vec_length(vec_sub(s->b, s->a));
}

/* ---- along a strand */

/* What it goes on with before the beginning of one of its shapes (step -1) or behind its end (1); a
 * ring goes on with its other end. NULL where it ends. */
static const shape *neighbour_of(const drawing *d, const shape *s, int step)
{
    const shape *first = d->placed, *last = d->placed + d->count - 1, *other = s;
    if (s != (step < 0 ? first : last) && s[step].strand == s->strand) {
        return s + step;
    }
    while (other != (step < 0 ? last : first) && other[-step].strand == s->strand) {
        other -= step;
    }
    vec gap = step < 0 ? vec_sub(other->b, s->a) : vec_sub(other->a, s->b);
    return other != s && vec_length(gap) < 1e-3 * s->radius ? other : NULL;
}

int pieces_walk(const drawing *d, const shape *s, double t, int step, double length, vec *points,
                int room, bool *ended)
{
    int count = 0;
    vec at = vec_lerp(s->a, s->b, t);
    if (step < 0 ? t <= 0.0 : t >= 1.0) {
        s = neighbour_of(d, s, step);
    }
    if (ended != NULL) {
        *ended = s == NULL;
    }
    double left = length, skipped = 0.0; /* points that crowd are left out */
    while (s != NULL && count < room) {
        vec end = step < 0 ? s->a : s->b;
        double distance = vec_length(vec_sub(end, at));
        if (distance >= left) {
            points[count++] = distance > 0.0 ? vec_lerp(at, end, left / distance) : end;
            return count;
        }
        at = end;
        left -= distance;
        skipped += distance;
        if (skipped >= 0.125 * length) {
            points[count++] = at;
            skipped = 0.0;
        }
        s = neighbour_of(d, s, step);
    }
    if (skipped > 0.0 && count < room) {
        points[count++] = at;
    }
    return count;
}

/* ---- pieces: long shapes are cut, short ones of one colour joined */

static double wanted_length(const drawing *d, const shape *s)
{
    double three_pixels = 3.0 / view_scale_at(&d->v, 0.5 * (s->a.z + s->b.z));
    return fmax(2.0 * s->radius, three_pixels);
}

static bool is_joined(const drawing *d, const piece *part, double length, double wanted)
{
    size_t next = part->last + 1;
    if (next >= d->count || part->last - part->first >= MAX_JOINED) {
        return false;
    }
    const shape *s = &d->placed[part->first], *other = &d->placed[next];
    return is_round(s) && other->strand == s->strand && other->colour == s->colour &&
           length + length_of(other) <= wanted;
}

/* The pieces that begin with a shape, put into `to` unless it is NULL; *next: the first shape that
 * is not in them. */
static size_t pieces_from(const drawing *d, size_t first, piece *to, size_t *next)
{
    const shape *s = &d->placed[first];
    double wanted = wanted_length(d, s), length = is_round(s) ? length_of(s) : 0.0;
    piece all = {.first = first, .last = first, .t0 = 0.0, .t1 = 1.0};
    size_t parts = (size_t)clamp(ceil(length / wanted), 1.0, MAX_PARTS);
    while (parts == 1 && is_joined(d, &all, length, wanted)) {
        all.last++;
        length += length_of(&d->placed[all.last]);
    }
    *next = all.last + 1;
    for (size_t k = 0; to != NULL && k < parts; k++) {
        to[k] = all;
        if (parts > 1) {
            to[k].t0 = (double)k / (double)parts;
            to[k].t1 = (double)(k + 1) / (double)parts;
        }
    }
    return parts;
}

/* ---- their order */

static vec middle_of(const drawing *d, const piece *part)
{
    const shape *s = &d->placed[part->first], *last = &d->placed[part->last];
    if (is_round(s)) {
        vec begin = vec_lerp(s->a, s->b, part->t0), end = vec_lerp(last->a, last->b, part->t1);
        return vec_lerp(begin, end, 0.5);
    }
    double share = s->kind == SHAPE_FLOOR ? 0.5 : 1.0 / 3.0;
    return vec_add(s->a, vec_scale(vec_add(s->b, s->c), share));
}

static void find_depth(const drawing *d, piece *part, size_t order)
{
    vec middle = middle_of(d, part);
    part->order = order;
    part->depth = d->v.perspective ? vec_length(middle) : middle.z;
    part->layer = d->placed[part->first].kind == SHAPE_FLOOR ? 1 : 2;
}

/* What is on the other side of a floor than the eye is. */
static void find_beyond(const drawing *d, const shape *s, piece *pieces, size_t count)
{
    vec normal = vec_cross(s->b, s->c);
    double eye = d->v.perspective ? -vec_dot(normal, s->a) : -normal.z;
    for (size_t i = 0; i < count; i++) {
        double side = vec_dot(normal, vec_sub(middle_of(d, &pieces[i]), s->a));
        if (pieces[i].layer == 2 && side * eye < 0.0) {
            pieces[i].layer = 0;
        }
    }
}

static int far_first(const void *one, const void *other)
{
    const piece *a = one, *b = other;
    if (a->layer != b->layer) {
        return a->layer < b->layer ? -1 : 1;
    }
    if (a->depth < b->depth || a->depth > b->depth) {
        return a->depth > b->depth ? -1 : 1;
    }
    return a->order < b->order ? -1 : a->order > b->order ? 1 : 0;
}

piece *pieces_sorted(const drawing *d, size_t *count)
{
    size_t total = 0, at = 0;
    for (size_t i = 0; i < d->count;) {
        total += pieces_from(d, i, NULL, &i);
    }
    *count = total;
    piece *pieces = calloc(total + 1, sizeof *pieces);
    if (pieces == NULL) {
        return NULL;
    }
    for (size_t i = 0; i < d->count;) {
        at += pieces_from(d, i, pieces + at, &i);
    }
    for (size_t i = 0; i < total; i++) {
        find_depth(d, &pieces[i], i);
    }
    for (size_t i = 0; i < d->count; i++) {
        if (d->placed[i].kind == SHAPE_FLOOR) {
            find_beyond(d, &d->placed[i], pieces, total);
        }
    }
    qsort(pieces, total, sizeof *pieces, far_first);
    return pieces;
}
