/* A thread pulled over a fixed cylinder, loaded at its other end: the law of the rope, T2 = T1 exp(mu angle).
 *
 * Where the thread is straight its tension is larger by EI / (2 R^2) than where the cylinder bends it, as
 * the pull and the energy of bending keep their sum along a rod that nothing rubs; the law is that of the
 * latter. For more than half a turn the thread is a helix, so that strands do not touch: it bends by
 * cos^2 / R over a length angle R / cos, so the angle counts times the cosine. */
#ifndef VBSS_TESTS_SCENE_CAPSTAN_RIG_H
#define VBSS_TESTS_SCENE_CAPSTAN_RIG_H

#include <math.h>

#include "scene/rig.h"

/* N, m: the load, and the straight part before the cylinder; radii of the cylinder and the thread. */
#define CAPSTAN_LOAD 0.1
#define CAPSTAN_LOAD_LENGTH 15e-3
#define CAPSTAN_RADIUS 2.5e-3
#define CAPSTAN_THREAD_RADIUS 0.125e-3
#define CAPSTAN_PI 0x1.921fb54442d18p1

typedef struct capstan {
    double turns, fineness; /* length of segments over the cylinder's radius */
    double friction, axial_stiffness, speed;
    vbss_thread_bending bending;
    /* what follows */
    double angle; /* that counts */
    double cosine, contact_length;
    vec3 loaded, pulled; /* where the ends are pulled to */
    double segment;
    uint32_t end, weight; /* attachments */
    vec3 at;              /* of the pulled end */
    scene_rig rig;
    /* Adds the cylinder along z, about the origin. */
    void (*add_cylinder)(struct capstan *c);
    /* Turns the cylinder, so that its surface moves that far against the pull; NULL: the end of the thread moves. */
    void (*turn_cylinder)(struct capstan *c, double distance);
} capstan;

typedef struct capstan_ratios {
    double mean, smallest, largest; /* of log(T2 / T1) */
} capstan_ratios;

/* Half a turn about a capsule. */
capstan capstan_half_turn(double friction);
/* Makes scene, cylinder and thread, and hangs the load on it. The capstan must stay where it is. */
void capstan_begin(capstan *c);
/* Pulls over so many lengths of a segment, as ripples have that period. */
capstan_ratios capstan_pull(capstan *c, double segments);
/* Segments to pull until the elastic thread slides everywhere. */
double capstan_start_segments(const capstan *c);
/* Mean of log(T2 / T1) of a whole run, made and ended. */
double capstan_pulled_over(capstan *c);

#endif
