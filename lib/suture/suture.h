/* What couples needle and drain: where a tip enters a wall, and the hole that it leaves, which slides along the needle.
 *
 * A hole is a material point of the drain on a needle's middle line. Across the line it ties the two with a stiffness; along
 * it rubs, up to a bound (docs/puncture.md). puncture.c says when a tip enters and where; hole.c what a hole does. Method PAPER: paper.h. */
#ifndef VBSS_SUTURE_SUTURE_H
#define VBSS_SUTURE_SUTURE_H

#include "base/base.h"
#include "contact/contact.h"
#include "drain/drain.h"
#include "needle/needle.h"

/* Rows of a hole: two across, one along. */
enum { HOLE_ROWS = 3, HOLE_ALONG = 2 };

typedef struct suture_hole {
    uint32_t id;            /* 0: free */
    uint32_t needle, drain; /* numbers in the scene */
    uint32_t triangle;
    double weights[3]; /* of its corners in the hole */
    bool outward;      /* the needle went through from inside */
    double
        entry; /* arc length of the needle that was there when it entered: below 0, before the tip */
    double arc;     /* that is there now */
    double deepest; /* that has been */
    double held;    /* friction on the needle, toward its tip, N */
    vec3 across;    /* force on the needle across its line, N, in the world */
} suture_hole;

/* ---- puncture.c */

typedef struct suture_tip {
    vec3 position, direction; /* direction: unit, where it points */
    vec3 force;               /* of the wall on it, N */
    vec3 normal;              /* of that force without friction: unit, away from the wall */
} suture_tip;
/* Whether it is pressed in, and not along, so that the wall gives way. */
bool vbss_suture_enters(const vbss_drain_config *config, const suture_tip *tip);
/* The hole that it makes: where its line meets the wall within `reach`; false: nowhere, or where the wall ends. */
bool vbss_suture_make_hole(const drain_object *d, const suture_tip *tip, double reach,
                           double wire_radius, suture_hole *hole);
/* Weights in a triangle, but for rounding: none below 0, all together 1. */
void vbss_suture_round_off(double weights[3]);

/* ---- hole.c */

vec3 vbss_hole_point(const suture_hole *hole, const drain_object *d, const vec3 *x);
/* What it bears along the needle before that slides. */
double vbss_hole_bound(const suture_hole *hole, const vbss_drain_config *config);
/* How needle and drain lie there. */
typedef struct hole_lie {
    vec3 needle, drain; /* points that shall be the same */
    vec3 tangent;       /* unit, toward the tip */
    double arc;
} hole_lie;
hole_lie vbss_hole_look(const suture_hole *hole, const drain_object *d, const vec3 *x,
                        const needle_object *n, pose needle);
/* How a row of it lies: `now` in the trial state, `before` at the begin of the part, which is h long. */
void vbss_hole_lay_row(const suture_hole *hole, const vbss_drain_config *config,
                       const hole_lie *now, const hole_lie *before, double h, contact_row *row);
/* What rows have found becomes its state; it has slid to that arc length. */
void vbss_hole_keep(suture_hole *hole, const vbss_drain_config *config, const contact_row *row);
void vbss_hole_move(suture_hole *hole, double arc);
/* Whether nothing of the needle is in it: the tip is back out, or the end has passed. */
bool vbss_hole_is_left(const suture_hole *hole, const needle_object *n);
void vbss_hole_serialise(vbss_stream *stream, uint16_t first_tag, suture_hole *hole);
bool vbss_hole_is_sound(const suture_hole *hole);

#endif
