/* What a peer of the scene `overhand` gives the suite: a thread with a loose overhand in it, free of
 * gravity, whose ends are led apart until it is tight. */
#ifndef VBSS_BENCH_CONTACT_PEER_H
#define VBSS_BENCH_CONTACT_PEER_H

#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

/* A macro's value as text, for the version in a note. */
#define PEER_TEXT_OF(value) #value
#define PEER_TEXT(macro) PEER_TEXT_OF(macro)

/* The thread; straight when nothing bends it. */
typedef struct contact_peer_scene {
    double diameter;          /* D, m */
    double linear_density;    /* kg/m */
    double bending_stiffness; /* EI, N m^2 */
    double stretch_stiffness; /* EA, N: rigid links do without */
    double friction;          /* Coulomb's mu */
    double tension;           /* N: it is pulled to; peers choose for it how they stay stable */
} contact_peer_scene;

typedef struct contact_peer {
    const char *name;
    const char *note; /* formulation and version of the library */
    /* At rest at `positions`, x y z of each node, m; segments are unstretched there. Its own steps
     * are no longer than `step`, s. NULL: cannot. */
    void *(*create)(const contact_peer_scene *scene, size_t nodes, const double *positions,
                    double step);
    /* Over h, s, leads the first node to end_a and the last to end_b at even speed. Nonzero: the
     * state went bad. */
    int (*step)(void *peer, const double end_a[3], const double end_b[3], double h);
    /* Fills x y z of as many nodes as it was created with, and returns how many that are. The end
     * nodes may lag behind where they are led. */
    size_t (*read)(void *peer, double *positions);
    /* N: force with which the ends were led, mean of both and over the last call of step. */
    double (*tension)(void *peer);
    void (*destroy)(void *peer);
    double best_step[3]; /* s, for 61, 121, 241 nodes: the longest with which it is at its best */
} contact_peer;

/* Only those whose library was found are linked: see the definitions BENCH_HAVE_BULLET and
 * BENCH_HAVE_MUJOCO, which hold its version. */
extern const contact_peer contact_bullet_multibody;
extern const contact_peer contact_bullet_softbody;
extern const contact_peer contact_mujoco;

#ifdef __cplusplus
}
#endif

#endif
