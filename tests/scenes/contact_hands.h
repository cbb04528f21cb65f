/* Hands that hold nodes of threads: they go on until the thread pulls as they were told, and give way when
 * it pulls more. For contact_scenes.h. */
#ifndef VBSS_TESTS_SCENES_CONTACT_HANDS_H
#define VBSS_TESTS_SCENES_CONTACT_HANDS_H

#include <vblast_ss/scene.h>
#include <vblast_ss/thread.h>

#include "base/linear.h"

/* How a hand pulls. */
typedef struct contact_pull {
    double speed;     /* m/s, at most; back it may be five times as fast */
    double force;     /* N, that it goes on to */
    double stiffness; /* of the spring between hand and node, N/m; 0: the node is the hand's */
} contact_pull;

typedef struct contact_hand {
    vbss_thread *thread;
    uint32_t node, id; /* of the attachment; 0: it is let go */
    vec3 way;          /* unit, where it pulls to */
    vec3 at;           /* of a spring's end */
    vec3 home;         /* where it took the node */
    contact_pull pull;
    bool scene_waits; /* it feels what a spring pulls now, not what that did in the last step */
    double give;      /* N/m: of the thread, for a node that is the hand's */
    double furthest;  /* from home along the way, m */
    double felt;      /* N: by which the thread pulls it back along its way */
} contact_hand;

/* Whether a step may wait in such a scene. Its last step is of some calls ago then, and a hand at a spring that goes by
 * it winds the thread up. */
bool contact_hand_scene_waits(const vbss_scene_config *scene);
/* Takes a node of a thread where it is. `give`: stiffness of the thread as a whole. */
vbss_result contact_hand_take(contact_hand *hand, vbss_thread *thread, uint32_t node, vec3 way,
                              const contact_pull *pull, double give, bool scene_waits);
vbss_result contact_hand_release(contact_hand *hand);
/* Goes on for a step of h seconds, `aside` metres across. */
vbss_result contact_hand_move(contact_hand *hand, double h, vec3 aside);

/* What a hand does at random in a step: other pulls, other speeds, back, aside, nothing; now and then it
 * lets go if it may. Depends on seed and step alone. */
typedef struct contact_whim {
    contact_pull pull;
    double back; /* m/s: goes back instead */
    vec3 aside;  /* m/s */
    bool letting_go;
} contact_whim;
contact_whim contact_whim_of(const contact_pull *usual, uint64_t seed, uint64_t hand,
                             uint64_t step);
/* Does it. */
vbss_result contact_hand_tug(contact_hand *hand, const contact_whim *whim, double h, bool loose);

#endif
