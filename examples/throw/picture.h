/* Looks at a throw: two views, from the front and from above. */
#ifndef VBSS_EXAMPLES_THROW_PICTURE_H
#define VBSS_EXAMPLES_THROW_PICTURE_H

#include "throw/senses.h"

bool picture_write(const senses *s, const char *path, const char *text, bool near);

#endif
