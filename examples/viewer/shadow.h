/* What the lamp does not reach: depths as it sees them. */
#ifndef VBSS_EXAMPLES_VIEWER_SHADOW_H
#define VBSS_EXAMPLES_VIEWER_SHADOW_H

#include <stdbool.h>

#include <epoxy/gl.h>

#include "matrix.h"

enum { SHADOW_SIZE = 1536 };

typedef struct shadow {
    GLuint program, frame, depth;
} shadow;

bool shadow_begin(shadow *s);
void shadow_end(shadow *s);
/* What is drawn from here on casts shadows; the vertex array that is bound has positions first. */
void shadow_cast(const shadow *s, const matrix4 *light);
/* Of parts from now on: what is nearer to the lamp casts none, as it is not seen. */
void shadow_clear(const shadow *s, point3 lamp, float clear);

#endif
