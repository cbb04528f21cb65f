/* A vessel in a pelvis, and a thread that is tied round it: the scene. */
#ifndef VBSS_EXAMPLES_VESSEL_H
#define VBSS_EXAMPLES_VESSEL_H

#include <vblast_ss/vblast_ss.h>

#define VESSEL_STEP 1e-3              /* s */
#define VESSEL_THREAD_RADIUS 0.125e-3 /* m */
enum {
    VESSEL_AROUND = 20, /* nodes of a ring */
    VESSEL_CELLS = 30,  /* between the rings */
    VESSEL_NODES = VESSEL_AROUND * (VESSEL_CELLS + 1),
    VESSEL_TRIANGLES = 2 * VESSEL_AROUND * VESSEL_CELLS,
    PELVIS_CELLS = 48, /* of the surface, each way */
    PELVIS_VERTICES = (PELVIS_CELLS + 1) * (PELVIS_CELLS + 1),
    PELVIS_TRIANGLES = 2 * PELVIS_CELLS * PELVIS_CELLS
};

/* The vessel lies along y, z points up. */
typedef struct vessel_scene {
    vbss_context *context;
    vbss_scene *scene;
    vbss_drain *vessel;
    vbss_thread *thread;
    uint32_t vessel_body, thread_body, pelvis_body;
    uint32_t node_count; /* of the thread */
    uint32_t hands[2];   /* attachments at the ends of the thread */
    double at[2][3];     /* where the hands are, m */
    double force[2];     /* with which they pull, N */
    double axis;         /* of the vessel: its height, m */
    double initial_area; /* of the narrowest ring, m^2 */
    double vertices[PELVIS_VERTICES][3];
    uint32_t triangles[PELVIS_TRIANGLES][3];
} vessel_scene;

/* Builds the scene: the loop of a double throw round the vessel, still loose. */
vbss_result vessel_create(vbss_context *context, vessel_scene *s);

/* One step. Both hands go apart until each pulls with the force, N, and then keep it. */
vbss_result vessel_pull(vessel_scene *s, double force);

/* Area of the narrowest ring of the vessel's middle surface, m^2. A ring is the polygon of its nodes, seen along y. */
double vessel_narrowest(const vessel_scene *s);

/* How far the lowest node of the thread is above where it touches the surface below it, m; negative: in it, or behind it. */
double vessel_clearance(const vessel_scene *s);

#endif
