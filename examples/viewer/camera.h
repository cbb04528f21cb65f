/* A laparoscope: a straight tube through a port in the wall of the body, whose optics look aside of its axis, with a light
 * beside them at the tip. */
#ifndef VBSS_EXAMPLES_VIEWER_CAMERA_H
#define VBSS_EXAMPLES_VIEWER_CAMERA_H

#include "matrix.h"

/* The usual place: the view is 50 degrees down; from the right, where tools do not hide what they do. */
#define CAMERA_ASIDE 0.41887902F /* rad */
#define CAMERA_DOWN 0.87266463F  /* rad */
#define CAMERA_AWAY 0.07F        /* m */

/* Of what is between lens and target; a shaft of 5 mm covers a tenth of the picture's height at the most of it. */
#define CAMERA_CLEAR 0.6F
#define CAMERA_MAX_CLEAR 0.045F /* m */
#define CAMERA_GONE 0.7F        /* of the two */

typedef struct camera {
    point3 port, tip; /* m: the tube goes from one to the other */
    point3 up;        /* in the picture, about */
    float optics;     /* rad: of the view, downward from the tube's axis; 30 degrees are usual */
    float field;      /* rad: from the upper to the lower edge of the picture */
    float gain;       /* of the light: as much more as it is farther than usual */
    float
        clear; /* m: tools that come nearer to the lens are seen through, and not at all at CAMERA_GONE of it */
} camera;

typedef struct camera_view {
    matrix4 seen;  /* from the world to clip space */
    matrix4 light; /* the same of the light, for its shadows */
    point3 eye, lamp;
    point3 right, up; /* in the picture, unit */
} camera_view;

/* The usual place: behind, right of and above what is sutured at that place, looking along +y and down. */
camera camera_over(point3 target);
/* Another: turned to the right about the vertical, looking down by so much, that far away. */
camera camera_from(point3 target, float aside, float down, float away);
camera_view camera_get_view(const camera *c, float aspect);

#endif
