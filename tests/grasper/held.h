/* A held thread as three points on springs, and the jaws that hold it. */
#ifndef VBSS_TESTS_GRASPER_HELD_H
#define VBSS_TESTS_GRASPER_HELD_H

#include "fixture.h"

#define HALF_GRIP 0.5e-3
#define OLD 1.0 /* s: nothing settles any more */

typedef struct held {
    grasper_object g;
    grasper_thread_clamp grip;
    vec3 thread[GRASPER_THREAD_POINTS]; /* where its points are, jaws' frame */
    vec3 along;
    double ahead[GRASPER_THREAD_POINTS];
    double pressure, h;
} held;

/* Straight along `along` through the middle of the jaws, 8 mm from the pivot, without force. */
static inline held hold_along(vec3 along)
{
    held s = {.along = vec3_unit_or(along, vec3_zero()), .pressure = 4.0, .h = 1e-3};
    s.g.kind = VBSS_GRASPER_KIND_NEEDLE_DRIVER;
    s.g.driver = (grasper_jaws){13e-3, 0.7e-3, 0.0, 0.35, 0.0};
    s.g.config.grip_friction = 0.5;
    s.g.config.grip_length = 2.0 * HALF_GRIP;
    s.g.config.grip_stiffness = 3000.0;
    s.grip.age = OLD;
    for (int i = 0; i < GRASPER_THREAD_POINTS; i++) {
        vec3 middle = vec3_make(0.0, 0.0, -8e-3);
        s.ahead[i] = (i - 1) * HALF_GRIP;
        s.grip.anchor[i] = s.thread[i] = vec3_add_scaled(middle, (i - 1) * HALF_GRIP, s.along);
    }
    return s;
}

static inline double stiffness_of(const held *s)
{
    return s->g.config.grip_stiffness / GRASPER_THREAD_POINTS;
}

static inline vec3 force_at(const held *s, int i)
{
    vec3 force = vec3_scale(vec3_sub(s->grip.anchor[i], s->thread[i]), stiffness_of(s));
    return vec3_make(GRASPER_NORMAL_STIFFNESS_RATIO * force.x, force.y, force.z);
}

static inline vec3 force_on_thread(const held *s)
{
    return vec3_add(vec3_add(force_at(s, 0), force_at(s, 1)), force_at(s, 2));
}

static inline double torque_on_thread(const held *s)
{
    double torque = 0.0;
    for (int i = 0; i < GRASPER_THREAD_POINTS; i++) {
        torque += vec3_cross(vec3_sub(s->grip.anchor[i], s->grip.anchor[1]), force_at(s, i)).x;
    }
    return torque;
}

static inline double energy_of(const held *s)
{
    double energy = 0.0;
    for (int i = 0; i < GRASPER_THREAD_POINTS; i++) {
        energy += 0.5 * vec3_dot(force_at(s, i), vec3_sub(s->grip.anchor[i], s->thread[i]));
    }
    return energy;
}

static inline void displace_thread(held *s, vec3 by)
{
    for (int i = 0; i < GRASPER_THREAD_POINTS; i++) {
        s->thread[i] = vec3_add(s->thread[i], by);
    }
}

/* After a step; a thread that runs through has other points held, so much further on. */
static inline grasper_thread_slip yield(held *s)
{
    grasper_thread_load load = {.thread_direction = s->along, .jaw_force = s->pressure, .h = s->h};
    for (int i = 0; i < GRASPER_THREAD_POINTS; i++) {
        load.arc_offset[i] = s->ahead[i];
        load.force[i] = force_at(s, i);
    }
    grasper_thread_slip change = vbss_grasper_yield_thread(&s->g, &s->grip, &load);
    displace_thread(s, vec3_scale(s->along, change.slip));
    return change;
}

static inline double along_faces_of(vec3 a)
{
    return sqrt(a.y * a.y + a.z * a.z);
}

#endif
