/* Programs for the graphics processor. */
#ifndef VBSS_EXAMPLES_VIEWER_SHADER_H
#define VBSS_EXAMPLES_VIEWER_SHADER_H

#include <epoxy/gl.h>

/* The second is in so many pieces. 0, told on standard error, when it does not compile or link. */
GLuint shader_program(const char *name, const char *vertex, const char *const *fragment,
                      int pieces);

#endif
