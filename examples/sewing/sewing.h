/* A stitch in the tissue of a host: finite elements of the host's own, a needle with its thread, and two scripted hands. */
#ifndef VBSS_EXAMPLES_SEWING_H
#define VBSS_EXAMPLES_SEWING_H

#include <stdbool.h>

#include <vblast_ss/vblast_ss.h>

#include "base/linear.h"
#include "host_tissue/fem.h"
#include "scripted/hand.h"
#include "scripted/pull.h"

#define SEWING_STEP 1e-3 /* s */
enum {
    SEWING_CELLS_X = 10,
    SEWING_CELLS_Y = 2,
    SEWING_CELLS_Z = 6,
    SEWING_VERTICES = (SEWING_CELLS_X + 1) * (SEWING_CELLS_Z + 1), /* of the surface */
    SEWING_TRIANGLES = 2 * SEWING_CELLS_X * SEWING_CELLS_Z
};

/* y points up. The surface is at y = 0; the needle goes round a circle in the plane z = 0. */
typedef struct sewing {
    vbss_context *context;
    vbss_scene *scene;
    fem tissue;
    vbss_needle *needle;
    vbss_thread *thread;
    uint32_t surface, needle_body, thread_body, segments;
    uint32_t triangles[SEWING_TRIANGLES][3];
    scripted_hand hands[2];     /* drives the needle; takes it over */
    double turned;              /* angle of the needle's tip on the circle, rad */
    scripted_pull tail;         /* of the thread */
    double time;                /* s */
    uint32_t punctures, passed; /* events so far */
} sewing;

/* Measures of the stitch. */
typedef struct sewing_report {
    uint32_t holes;
    double hole_forces[2];   /* N */
    vec3 force, reaction;    /* of the scene on the tissue; of the tissue on its support, N */
    double largest_residual; /* of a surface vertex: force of the scene and elastic force, N */
    double largest_force;    /* on a vertex, N */
    double tail_force;       /* N */
    double deepest, highest; /* displacement of the surface, m */
    double apart;            /* largest distance between a vertex of the host and of the scene, m */
    uint32_t crossings;      /* of thread or needle with the surface, away from the holes */
} sewing_report;

vbss_result sewing_create(vbss_context *context, sewing *s);
void sewing_destroy(sewing *s);

/* hands.c. One step of the script, the scene and the tissue. Sets *is_done at the end of the script. */
vbss_result sewing_step(sewing *s, bool *is_done);
/* Name of the present phase of the script. */
const char *sewing_phase(const sewing *s);

/* measure.c */
vbss_result sewing_measure(const sewing *s, sewing_report *report);

#endif
