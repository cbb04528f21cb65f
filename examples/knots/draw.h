/* What stands in the pictures of the gallery; every function says whether all of it could be added. */
#ifndef VBSS_EXAMPLES_DRAW_H
#define VBSS_EXAMPLES_DRAW_H

#include "knots/gallery.h"
#include "painter/painter.h"

/* The curve through the nodes from first to last, whose bending the library knows. Coloured by tension, or,
 * without tensions, each limb in its own colour. */
bool draw_thread(painter *p, const gallery_knot *g, const vec3 *x, uint32_t first, uint32_t last,
                 const double *tensions);
/* The cylinder as a tube, cut off in front of y; or only where it is cut. */
bool draw_cylinder(painter *p, const gallery_knot *g, double y, bool whole);
bool draw_pegs(painter *p, const gallery_knot *g, const gallery_frame *f);
/* From `elevation` (rad) above the front: 0 is along y, pi / 2 from above. */
bool draw_seen_from(painter *p, vec3 target, double azimuth, double elevation, double width);

#endif
