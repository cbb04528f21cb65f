/* Ghost hands: an expert's tools in the scene of a trainee, for the phase in which the task is. They go ahead of the trainee's
 * tools and wait for them. They touch nothing. */
#ifndef VBSS_EXAMPLES_GHOST_GHOST_H
#define VBSS_EXAMPLES_GHOST_GHOST_H

#include <vblast_ss/grasper.h>
#include <vblast_ss/visual.h>

#include "ghost/track.h"

/* What the trainee's scene is like now. */
typedef struct ghost_seen {
    int32_t phase; /* of the session */
    ghost_scene scene;
    double tips[GHOST_SIDES][3]; /* of the tools, m */
} ghost_seen;

typedef struct ghost {
    const ghost_track *track;
    vbss_scene *scene; /* of their own, in which tools are exactly where they shall be */
    vbss_visual *visual;
    vbss_grasper *graspers[GHOST_SIDES];
    uint32_t source;               /* in the visual; 0: they are hidden */
    ghost_pose poses[GHOST_SIDES]; /* in the trainee's scene */
    int32_t phase;
    double time, waited;                 /* in the phase; for the trainee, s */
    double cosine, sine, from[3], to[3]; /* of the track's scene onto the trainee's */
} ghost;

/* Tools of the shapes that the trainee's have. They are hidden before ghost_step. The track must outlive the ghost; the context
 * frees the rest. */
vbss_result ghost_create(ghost *g, const ghost_track *track, vbss_context *context,
                         const vbss_grasper_config shapes[GHOST_SIDES], vbss_visual *visual);
/* The time since the last call, s. */
vbss_result ghost_step(ghost *g, const ghost_seen *seen, double seconds);
/* From the beginning of the phase. */
void ghost_again(ghost *g);
vbss_result ghost_hide(ghost *g);

#endif
