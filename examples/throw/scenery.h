/* What stands in the pictures of the demonstration, and from where it is seen. Every function says whether all of it
 * could be done. */
#ifndef VBSS_EXAMPLES_THROW_SCENERY_H
#define VBSS_EXAMPLES_THROW_SCENERY_H

#include "painter/painter.h"
#include "throw/demo.h"

#define SCENERY_TAIL PAINTER_BLUE
#define SCENERY_LIMB PAINTER_VERMILION

/* A box round what must be seen. */
typedef struct scenery_box {
    vec low, high;
} scenery_box;

scenery_box scenery_nothing(void);
void scenery_include(scenery_box *b, vec x, double radius);

bool scenery_add_ground(painter *p);
/* The drain's half behind y, so that what sinks into it is seen. */
bool scenery_add_half_drain(painter *p, double y);
bool scenery_add_tools(painter *p, const senses *s);
/* By limb: the tail's, what is in the drain, the long one. */
bool scenery_add_thread(painter *p, const senses *s);
/* Smooth, which counts from near: what is in the box, by throw. */
bool scenery_add_knot(painter *p, const senses *s, const demo_knot *k, const scenery_box *b);
painter_colour scenery_throw_colour(uint32_t number, bool tail);

/* An orthographic camera a little above the front, or above; `top` pixels are left free for text. */
bool scenery_set_view(painter *p, const scenery_box *b, bool above, int width, int height, int top,
                      double min_width);

#endif
