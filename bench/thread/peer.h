/* What every method of the cantilever scene gives the suite, ours and the peers' alike: a thread of
 * length L, clamped horizontally at the origin along +x, at rest, falling under gravity along -y.
 *
 * Clamp: the N segments have the length l = L / (N - 1/2), and the first is held with its middle at
 * the origin, so that nodes 0 and 1 stand at -l/2 and +l/2. That is of second order in l, and has a
 * smaller error than a first joint of twice the stiffness at the origin. Each moving node carries
 * linear_density * l, the last one half of it. */
#ifndef VBSS_BENCH_THREAD_PEER_H
#define VBSS_BENCH_THREAD_PEER_H

#include <stdbool.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

#define CANTILEVER_LENGTH 0.15             /* m */
#define CANTILEVER_LINEAR_DENSITY 6.4e-5   /* kg/m */
#define CANTILEVER_BENDING_STIFFNESS 1e-8  /* EI, N m^2 */
#define CANTILEVER_STRETCH_STIFFNESS 427.0 /* EA, N */
#define CANTILEVER_RADIUS 0.125e-3         /* m */
#define CANTILEVER_GRAVITY 9.81            /* m/s^2 */

/* A macro's value as text, for the version in a note. */
#define PEER_TEXT_OF(value) #value
#define PEER_TEXT(macro) PEER_TEXT_OF(macro)

typedef struct cantilever_setup {
    uint32_t segments; /* N >= 3 */
    double dt;         /* s */
    double drag;       /* 1/s: each mass m feels the force -drag * m * velocity */
} cantilever_setup;

typedef struct cantilever_method {
    const char *name;
    const char *note;                               /* formulation and version of the library */
    void *(*create)(const cantilever_setup *setup); /* straight and at rest; NULL: cannot */
    int (*step)(void *thread);                      /* one dt; nonzero: failed */
    void (*tip)(void *thread, double tip[3]);       /* free end, m */
    /* Largest error of length over the segments: ||e|/l - 1 - T/EA|, or ||e|/l - 1| where the
     * method has no tension T; 0 where rigid links leave no room for one. */
    double (*stretch)(void *thread);
    void (*destroy)(void *thread);
    /* s, for N = 30, 60, 120, 240: the largest step found by trial that is stable through the fall
     * and ends within 1 mm of the static tip, if there is one; 0: not supported. */
    double largest_dt[4];
    /* s: of the timed scene; 0, which a peer leaves here: largest_dt, where it is cheapest. */
    double dt[4];
    bool divides; /* longer steps than largest_dt too: it divides them by itself */
} cantilever_method;

/* Ours: ours.c. */
extern const cantilever_method cantilever_ours, cantilever_ours_local, cantilever_paper;

/* Only those whose library was found are linked: see the definitions BENCH_HAVE_BULLET and
 * BENCH_HAVE_MUJOCO, which hold its version. */
extern const cantilever_method cantilever_bullet_multibody;
extern const cantilever_method cantilever_bullet_softbody;
extern const cantilever_method cantilever_mujoco;        /* springs explicit in time */
extern const cantilever_method cantilever_mujoco_damped; /* springs made implicit by damping */

#ifdef __cplusplus
}
#endif

#endif
