/* Edits of hosts, told to whoever records them.
 *
 * An owner of objects has one hook, which its slot and the slots of its objects point to. A public
 * function that edits tells the hook before it changes anything, and again when it is done. Edits
 * inside another edit are part of that, and are not told. */
#ifndef VBSS_BASE_EDIT_HOOK_H
#define VBSS_BASE_EDIT_HOOK_H

#include <stdint.h>

#include <vblast_ss/base.h>

/* What a host does. Logs have the numbers below VBSS_EDIT_STEP; record.h lists words and numbers. */
enum {
    VBSS_EDIT_RIGID_TARGET = 1,
    VBSS_EDIT_PIN = 2,
    VBSS_EDIT_UNPIN = 3,
    VBSS_EDIT_ATTACH = 4,
    VBSS_EDIT_ATTACHMENT_TARGET = 5,
    VBSS_EDIT_DETACH = 6,
    VBSS_EDIT_CUT = 7,
    VBSS_EDIT_GRASPER_TARGET = 8,
    VBSS_EDIT_OPENING = 9,
    VBSS_EDIT_EXCHANGE = 10,
    VBSS_EDIT_SETTING = 11,
    VBSS_EDIT_HOLE = 12,
    VBSS_EDIT_REMOVE = 13,
    VBSS_EDIT_DRAIN_ATTACH = 14,
    VBSS_EDIT_DRAIN_TARGET = 15,
    VBSS_EDIT_DRAIN_DETACH = 16,
    VBSS_EDIT_ROLL = 17,
    VBSS_EDIT_STEP = 100,
    VBSS_EDIT_OTHER = 101 /* one without an input of its own: logs have the state after it */
};

/* The second kind of VBSS_EDIT_SETTING: its words[0]. words[1] is the body. */
enum {
    VBSS_EDIT_SETTING_GRAVITY = 1,
    VBSS_EDIT_SETTING_FRICTION = 2,
    VBSS_EDIT_SETTING_THREAD_FRICTION = 3,
    VBSS_EDIT_SETTING_COUPLING = 4,
    VBSS_EDIT_SETTING_SPEED_LIMIT = 5,
    VBSS_EDIT_SETTING_FILTER = 6,
    VBSS_EDIT_SETTING_FORCE = 7,
    VBSS_EDIT_SETTING_VELOCITY = 8,
    VBSS_EDIT_SETTING_POSE = 9,
    VBSS_EDIT_SETTING_BUDGETS = 10
};

typedef struct vbss_edit {
    uint32_t kind;      /* VBSS_EDIT_ */
    uint32_t words[4];  /* words[0] of an edit of an object that a scene owns: left to the hook */
    double numbers[12]; /* of a step: its length, s */
    const void *edited; /* slot of the edited object */
} vbss_edit;

typedef struct vbss_edit_hook {
    void *data; /* of the recorder; NULL: there is none */
    /* May refuse the edit, with an error text. */
    vbss_result (*begin_edit)(void *data, const vbss_edit *edit);
    /* Returns the result of the edit, or the failure to record it. */
    vbss_result (*end_edit)(void *data, const vbss_edit *edit, vbss_result result);
    uint32_t depth; /* edits under way, one inside the other */
} vbss_edit_hook;

/* Copies an array of the host into the numbers of an edit; NULL leaves them 0. */
void vbss_edit_set_numbers(vbss_edit *edit, uint32_t first, const double *numbers, uint32_t count);

/* Tells the hook of a slot; NULL, and a slot without hook, have none. The call must be followed by
 * vbss_edit_end unless it fails. The edit stays valid and unchanged until then. */
vbss_result vbss_edit_begin(void *handle, vbss_edit *edit);
/* Returns `result`, or the failure to record an edit that has succeeded. */
vbss_result vbss_edit_end(void *handle, const vbss_edit *edit, vbss_result result);

#endif
