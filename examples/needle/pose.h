/* Where a needle or a tool is and how it is turned, for hands that steer one by looking at the other. */
#ifndef VBSS_EXAMPLES_NEEDLE_POSE_H
#define VBSS_EXAMPLES_NEEDLE_POSE_H

#include <string.h>

#include "throw/hand.h"

typedef struct pose {
    vec at;
    double q[4]; /* w, x, y, z */
} pose;

static inline pose pose_of(vec at, vec x, vec y, vec z)
{
    pose p = {.at = at};
    hand_orientation(x, y, z, p.q);
    return p;
}

static inline pose pose_load(const double at[3], const double q[4])
{
    pose p = {.at = v_load(at)};
    memcpy(p.q, q, sizeof p.q);
    return p;
}

static inline void pose_turn(const double a[4], const double b[4], double out[4])
{
    vec u = v_load(a + 1), v = v_load(b + 1);
    vec w = v_add(v_along(v_scale(a[0], v), b[0], u), v_cross(u, v));
    out[0] = a[0] * b[0] - v_dot(u, v);
    v_store(out + 1, w);
}

static inline vec pose_point(const pose *p, vec local)
{
    return v_add(p->at, hand_rotate(p->q, local));
}

static inline pose pose_after(const pose *a, const pose *b)
{
    pose p = {.at = pose_point(a, b->at)};
    pose_turn(a->q, b->q, p.q);
    return p;
}

static inline pose pose_back(const pose *a)
{
    pose p = {.q = {a->q[0], -a->q[1], -a->q[2], -a->q[3]}};
    p.at = v_scale(-1.0, hand_rotate(p.q, a->at));
    return p;
}

/* Part of the way from a to b, the shorter way round. */
static inline pose pose_mix(const pose *a, const pose *b, double share)
{
    pose p = {.at = v_mix(a->at, b->at, share)};
    double dot = 0.0, length = 0.0;
    for (int i = 0; i < 4; i++) {
        dot += a->q[i] * b->q[i];
    }
    for (int i = 0; i < 4; i++) {
        p.q[i] = (1.0 - share) * a->q[i] + share * (dot < 0.0 ? -b->q[i] : b->q[i]);
        length += p.q[i] * p.q[i];
    }
    for (int i = 0; i < 4; i++) {
        p.q[i] /= sqrt(length);
    }
    return p;
}

/* rad */
static inline double pose_angle(const pose *a, const pose *b)
{
    double dot = 0.0;
    for (int i = 0; i < 4; i++) {
        dot += a->q[i] * b->q[i];
    }
    return 2.0 * vbss_acos(smaller(fabs(dot), 1.0));
}

/* Turned about an axis of its own frame, through its origin. */
static inline pose pose_turned(const pose *p, vec axis, double angle)
{
    pose r = *p;
    double by[4] = {vbss_cos(0.5 * angle)};
    v_store(by + 1, v_scale(vbss_sin(0.5 * angle), axis));
    pose_turn(p->q, by, r.q);
    return r;
}

/* What turns all about an axis through a point of the world. */
static inline pose pose_about(vec point, vec axis, double angle)
{
    pose r = {.q = {vbss_cos(0.5 * angle)}};
    v_store(r.q + 1, v_scale(vbss_sin(0.5 * angle), axis));
    r.at = v_sub(point, hand_rotate(r.q, point));
    return r;
}

#endif
