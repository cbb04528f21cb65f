/* A laparoscope: a straight tube through a port in the wall of the body, whose optics look aside of its axis, with a light
 * beside them at the tip. */
#ifndef VBSS_EXAMPLES_VIEWER_CAMERA_H
#define VBSS_EXAMPLES_VIEWER_CAMERA_H

#include "matrix.h"

typedef struct camera {
    point3 port, tip; /* m: the tube goes from one to the other */
    point3 up;        /* in the picture, about */
    float optics;     /* rad: of the view, downward from the tube's axis; 30 degrees are usual */
    float field;      /* rad: from the upper to the lower edge of the picture */
} camera;

typedef struct camera_view {
    matrix4 seen;  /* from the world to clip space */
    matrix4 light; /* the same of the light, for its shadows */
    point3 eye, lamp;
} camera_view;

/* The usual place: behind, right of and above what is sutured at that place, looking along +y and down. */
camera camera_over(point3 target);
camera_view camera_look(const camera *c, float aspect);

#endif
