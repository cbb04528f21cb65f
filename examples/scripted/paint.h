/* Pictures of threads, needles and the tools of scripted hands. */
#ifndef VBSS_EXAMPLES_SCRIPTED_PAINT_H
#define VBSS_EXAMPLES_SCRIPTED_PAINT_H

#include "painter/painter.h"
#include "scripted/hand.h"

/* Jaws and shaft of a tool, over `length` from its tip, m. */
painter_result scripted_paint_hand(painter *p, vbss_scene *scene, const scripted_hand *hand,
                                   double length);
painter_result scripted_paint_thread(painter *p, vbss_thread *thread, double radius,
                                     painter_colour colour);
painter_result scripted_paint_needle(painter *p, vbss_needle *needle, double radius);

#endif
