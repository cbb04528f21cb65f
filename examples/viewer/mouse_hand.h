/* A hand on a desk as a device: a mouse and keys move it, and it moves a tool, by the same interface as an arm. */
#ifndef VBSS_EXAMPLES_VIEWER_MOUSE_HAND_H
#define VBSS_EXAMPLES_VIEWER_MOUSE_HAND_H

#include <stdbool.h>

#include <vblast_ss/vblast_ss.h>

#include "camera.h"

enum { MOUSE_MOTIONS = 2 }; /* it shifts; it turns */

typedef struct mouse_hand {
    vbss_mapping_config mapping;
    vbss_device_sample sample;
    double pending[MOUSE_MOTIONS][3]; /* counts to the right and up, notches away: not yet gone */
    double pull[6], grain;            /* of a gamepad's sticks, and how fine */
    bool closes;                      /* the jaws; otherwise they open */
    bool clutched;
    double time;          /* of the last sample, s */
    vbss_device *device;  /* which reads it; */
    vbss_grasper *tool;   /* which it leads */
    uint32_t body;        /* the tool's, in its scene */
    vbss_device_input in; /* as read last */
} mouse_hand;

/* It begins where its tool is, whose jaws stay as they are. Stays at its place in memory: the device knows it. */
vbss_result mouse_hand_create(mouse_hand *m, vbss_context *context, vbss_grasper *tool);
/* Movements go along the picture from now on. */
void mouse_hand_set_camera(mouse_hand *m, const camera *c);
/* Counts to the right and up, notches away from the user; the hand goes that way as a hand does, within a tenth of a second. */
void mouse_hand_move(mouse_hand *m, bool turns, double right, double up, double away);
/* A gamepad's sticks, until it is told again; a smaller grain is slower. Axes as vbss_mapping_gamepad has them, but the last
 * turns about the tool's own axis. */
void mouse_hand_pull(mouse_hand *m, const double axes[6], double grain);
/* The mouse moves freely while it is held. */
vbss_result mouse_hand_clutch(mouse_hand *m, bool held);
/* The hand goes back to the middle of its reach, where it reads as `in` has it then; its tool has to stay. */
void mouse_hand_centre(mouse_hand *m);
/* Reads the device. */
vbss_result mouse_hand_read(mouse_hand *m, double now);

#endif
