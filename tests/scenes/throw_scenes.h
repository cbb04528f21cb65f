/* A throw tied round a tool, as far as it is hard for contact: a thread that comes out of a drain is wound
 * round a tool (W) by another (C); W takes the tail and is drawn out of the loops, which slide down shaft and
 * jaws and off the tip while C gives way. Hands tremble, follow with a lag and feel the thread's tension. What
 * they do follows from the scene and the struct: a restored scene goes on as the saved one when the struct is
 * put back with it. Nothing is said of the knot: a script that ties the right one takes more care. */
#ifndef VBSS_TESTS_SCENES_THROW_SCENES_H
#define VBSS_TESTS_SCENES_THROW_SCENES_H

#include <vblast_ss/scene.h>

#include "base/linear.h"

typedef enum throw_phase {
    THROW_NEAR,   /* C brings the limb to W's near side */
    THROW_ORBIT,  /* and round W, on a radius that follows the thread's tension */
    THROW_TRAVEL, /* W goes to the tail, C with it */
    THROW_DRAW,   /* W takes the tail and goes over to the other side on its leash; C gives way */
    THROW_REST,   /* all stand still */
    THROW_DONE
} throw_phase;

typedef struct throw_scene_options {
    vbss_scene_config scene;
    vbss_thread_config thread; /* material; its shape is set by create */
    double segment;            /* m */
    double turns;              /* of the limb about W, a bit less when it is caught */
    vec3 tip;                  /* of W while it is wound round, m */
    double held_at;            /* where C holds the limb: m from the drain along the thread */
    double first, advance;     /* m: from W's tip where C begins; nearer to the tip each turn */
    double speed;              /* of C, m/s */
    double pull;               /* N: what C winds with; it goes on no more at three times that */
    double tremor;             /* of hands, m */
} throw_scene_options;

typedef struct throw_tool {
    uint32_t body;
    vec3 at; /* where its hand has told it to be: of its grasp */
} throw_tool;

typedef struct throw_scene {
    throw_scene_options options;
    vbss_scene *scene;
    vbss_thread *thread;
    uint32_t thread_body, nodes;
    uint32_t tail_node, right_mark, left_mark, held_node;
    double arcs[4]; /* of these along the thread, m: a mesh that adapts renumbers them */
    throw_tool w, c;
    double phi;           /* rad: where C is on its orbit */
    double radius, share; /* of the orbit, m; of the free length that it shall be */
    double over;          /* rad: where W is on its leash */
    double leash;         /* m */
    vec3 mark;            /* where the leash is tied, m */
    throw_phase phase;
    uint32_t since, steps; /* of the phase, of all; steps */
} throw_scene;

/* A single throw, or a double. */
vbss_result throw_scene_init(throw_scene_options *options, bool twice);
vbss_result throw_scene_create(vbss_context *context, const throw_scene_options *options,
                               throw_scene *scene);
/* Hands first, then all by a millisecond; until scene->phase is THROW_DONE. */
vbss_result throw_scene_step(throw_scene *scene);
#define THROW_SCENE_STEP 1e-3     /* s */
enum { THROW_SCENE_NODES = 298 }; /* with the default segment */
/* N: of the thread where C holds it, and where W does (0 before it has taken the tail). */
double throw_scene_pull_at_c(const throw_scene *scene);
double throw_scene_pull_at_w(const throw_scene *scene);

#endif
