/* Threads, tools and a floor that touch, in motion: the same for tests, bench, determinism and soak. What
 * hands and tools do follows from the options, the number of the step and what the hands feel. */
#ifndef VBSS_TESTS_SCENES_CONTACT_SCENES_H
#define VBSS_TESTS_SCENES_CONTACT_SCENES_H

#include <vblast_ss/scene.h>

#include "base/linear.h"
#include "scenes/contact_hands.h"
#include "scenes/knots.h"

typedef enum contact_scene_kind {
    CONTACT_SCENE_PULLED, /* a knot whose ends are taken apart, then held */
    CONTACT_SCENE_TUGGED, /* the same; afterwards hands do anything */
    CONTACT_SCENE_STRUCK, /* the same; afterwards a rod goes through where the knot is, and back */
    CONTACT_SCENE_PULLED_OPEN, /* a knot round two rods that go apart; its ends are free */
    CONTACT_SCENE_MANY_KNOTS,  /* knots one after the other on one thread, pulled */
    CONTACT_SCENE_INTERLOCKED, /* two threads, a bight of each through that of the other, pulled */
    CONTACT_SCENE_SLIDING_OFF, /* turns round a tool that is drawn out of them */
    CONTACT_SCENE_DROPPED,     /* a thread on two tools that cross above a floor */
    CONTACT_SCENE_BESIDE,      /* a straight thread that is held, and one beside it that falls */
    CONTACT_SCENE_TOOLS,       /* tools of all kinds on each other and a floor, without thread */
    CONTACT_SCENE_KINDS
} contact_scene_kind;
extern const char *const contact_scene_names[CONTACT_SCENE_KINDS];

enum { CONTACT_SCENE_THREADS = 2, CONTACT_SCENE_TOOLS_MOST = 8 };

typedef struct contact_scene_options {
    contact_scene_kind kind;
    vbss_scene_config scene;   /* capacities are set by create, and the floor where there is one */
    vbss_thread_config thread; /* material; its shape is set by create */
    knot_shape knot;           /* the mesh of threads without knot too */
    uint32_t knots;            /* MANY_KNOTS: how many, 1 to 10 */
    contact_pull pull;         /* of the hands */
    uint64_t seed;             /* TUGGED */
    bool loose;                /* TUGGED: ends are let go and taken again */
    uint32_t begin; /* TUGGED, STRUCK, SLIDING_OFF: step in which what comes afterwards begins */
    vbss_rigid_kind tool; /* STRUCK */
    double tool_speed;    /* STRUCK, PULLED_OPEN, SLIDING_OFF: m/s */
    double tool_radius;   /* STRUCK, PULLED_OPEN, SLIDING_OFF, DROPPED: m */
    double tool_friction;
    double turns; /* SLIDING_OFF: about the tool, a half more or less for the ends' sides */
    /* m: of the thread beside its usual place (DROPPED), of the second beside the first (BESIDE) */
    vec3 aside;
    double wave; /* DROPPED: amplitude, m */
} contact_scene_options;

typedef struct contact_scene {
    contact_scene_options options;
    vbss_scene *scene;
    vbss_thread *threads[CONTACT_SCENE_THREADS];
    uint32_t thread_count, nodes[CONTACT_SCENE_THREADS], thread_bodies[CONTACT_SCENE_THREADS];
    contact_hand hands[2 * CONTACT_SCENE_THREADS];
    uint32_t hand_count;
    uint32_t tools[CONTACT_SCENE_TOOLS_MOST], tool_count; /* numbers of bodies */
    vec3 tool_homes[CONTACT_SCENE_TOOLS_MOST];
    knot_line line; /* of the thread with a knot */
    uint64_t steps;
} contact_scene;

/* The defaults of a kind; change what you need. */
vbss_result contact_scene_init(contact_scene_options *options, contact_scene_kind kind);
/* On failure what was made so far goes with the context. */
vbss_result contact_scene_create(vbss_context *context, const contact_scene_options *options,
                                 contact_scene *scene);
vbss_result contact_scene_destroy(contact_scene *scene);

/* Hands and tools are moved, then all of it by h seconds. */
vbss_result contact_scene_step(contact_scene *scene, double h);
vbss_result contact_scene_hash(const contact_scene *scene, uint64_t *hash);

/* The hands' smallest pull, N: what a thread is held by. */
double contact_scene_pull_felt(const contact_scene *scene);

#endif
