/* A scene under two hands, of one mouse or of devices: what a person does, made into steps of a millisecond. */
#ifndef VBSS_EXAMPLES_VIEWER_LIVE_H
#define VBSS_EXAMPLES_VIEWER_LIVE_H

#include "arms.h"
#include "exercise/places.h"
#include "mouse_hand.h"
#include "report/stage.h"
#include "trainer/grip.h"

/* Where a camera looks from, as camera_from() has it: target, rad, m. */
typedef struct live_view {
    point3 target;
    float aside, away;
} live_view;

typedef struct live_scene {
    const char *name, *what;
    const char
        *note; /* of its log, before the seed: which scene it is, for whoever plays it back */
    live_view view;
} live_scene;

typedef struct live {
    const live_scene *scene;
    live_view view; /* at first: the scene's, or with a session one that shows both tools */
    stage stage;
    mouse_hand hands[SIDES];
    arms *arms;        /* NULL: both hands are the mouse's */
    grip grips[SIDES]; /* of those that are not */
    int active;
    uint32_t aids; /* VBSS_SESSION_AID_ bits that are on */
    bool aided;    /* one has been on: hands go through the session */
    uint64_t steps;
    double time; /* s */
} live;

/* NULL: there is none of that name, or number. */
const live_scene *live_find(const char *name);
const live_scene *live_at(size_t number);
/* Arms, which are open, and log may be NULL. */
vbss_result live_create(live *l, const live_scene *scene, unsigned long seed, arms *a,
                        const char *log);
/* An exercise in the scene "stitch". Where it starts is in the states. */
vbss_result live_create_exercise(live *l, vbss_session_exercise exercise,
                                 const start_states *states, arms *a, const char *log);
/* Makes the view one of slit and both tools. (live_view.c) */
vbss_result live_show_tools(live *l);
/* With a stitch that is there already, its log begun. */
vbss_result live_take_over(live *l, const live_scene *scene, arms *a, stitch *t, const task *k);
/* A device leads that hand. */
bool live_by_device(const live *l, int side);
/* Switches an aid of the session on, or off; nothing in a scene without one. */
vbss_result live_toggle_aid(live *l, uint32_t aid);
/* The other kind of tool for that hand: needle driver or shears. Its jaws have to be empty. */
vbss_result live_exchange(live *l, int side);
/* Hands, scene, knots of the session; a limb that stood by itself is let go when a hand has it. */
vbss_result live_step(live *l);
/* Ends the log. */
vbss_result live_end(live *l);
void live_destroy(live *l);

#endif
