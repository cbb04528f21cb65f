/* Sentences over the whole width of the picture, in as many lines as they need. */
#ifndef VBSS_EXAMPLES_VIEWER_PARAGRAPHS_H
#define VBSS_EXAMPLES_VIEWER_PARAGRAPHS_H

#include "show.h"

enum { PARAGRAPHS_LINES = 6, PARAGRAPHS_LINE = 200 };

typedef struct paragraphs {
    char text[PARAGRAPHS_LINES][PARAGRAPHS_LINE];
    pen_colour colours[PARAGRAPHS_LINES];
    int count;
} paragraphs;

/* Characters for which a line has room. */
size_t paragraphs_room(const show *s);
/* Lines that do not fit are left out. */
void paragraphs_add(paragraphs *l, size_t room, pen_colour colour, const char *text);
/* So many lines of the picture stay free below. */
void paragraphs_put(show *s, const paragraphs *l, float below);

#endif
