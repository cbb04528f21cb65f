/* What stands in the pictures of the gallery; every function says whether all of it could be added. */
#ifndef VBSS_EXAMPLES_DRAW_H
#define VBSS_EXAMPLES_DRAW_H

#include "knots/gallery.h"
#include "painter/painter.h"

/* Of a segment at a fraction of it. */
typedef painter_colour draw_colour(const void *user, uint32_t segment, double t);
/* By tension; each limb in its own. */
typedef struct draw_tensions {
    const double *tensions;
    uint32_t node_count;
} draw_tensions;
painter_colour draw_by_tension(const void *tensions, uint32_t segment, double t);
painter_colour draw_by_limb(const void *gallery_knot, uint32_t segment, double t);

/* The curve through the nodes from first to last, whose bending the library knows. */
bool draw_thread(painter *p, const gallery_knot *g, const vec3 *x, uint32_t first, uint32_t last,
                 draw_colour *colour, const void *user);
/* The cylinder as a tube, cut off in front of y; or only where it is cut. */
bool draw_cylinder(painter *p, const gallery_knot *g, double y, bool whole);
bool draw_pegs(painter *p, const gallery_knot *g, const gallery_frame *f);
/* From `elevation` (rad) above the front: 0 is along y, pi / 2 from above. */
bool draw_seen_from(painter *p, vec3 target, double azimuth, double elevation, double width);

#endif
