/* What couples needle, thread and drain: where a tip enters a wall, and the hole that it leaves, which slides along the needle
 * and on along the thread behind it.
 *
 * A hole is a material point of the drain on the suture's middle line. Across the line it ties the two with a stiffness; along
 * it rubs (docs/puncture.md, docs/stitch.md). puncture.c says when a tip enters and where; curve.c what line that is; hole.c
 * what a hole does. Method PAPER: paper.h. */
#ifndef VBSS_SUTURE_SUTURE_H
#define VBSS_SUTURE_SUTURE_H

#include "base/linear.h"
#include "contact/contact.h"
#include "drain/drain.h"
#include "needle/needle.h"

#include "thread/thread.h"

typedef struct vbss_stream vbss_stream;

typedef struct suture_hole {
    uint32_t id;     /* 0: free */
    uint32_t needle; /* numbers in the scene: of what is in it, the other is 0 */
    uint32_t thread;
    uint32_t drain;
    uint32_t triangle;
    double barycentric[3]; /* of its corners in the hole */
    bool is_outward;       /* the needle went through from inside */
    double
        entry_arc; /* arc length of the needle that was there when it entered: below 0, before the tip */
    double arc; /* of the needle or the thread, that is there now; from the tip, from its begin */
    double
        trial_slide; /* how much of `arc` it would go on in the trial state of a part; of the guard, which finds it */
    double max_arc;        /* of the needle, that has been */
    double friction_force; /* friction on the suture, toward the tip, N */
    vec3 transverse_force; /* force on the suture across its line, N, in the world */
} suture_hole;

/* ---- curve.c */

/* A needle, a thread, or a needle with a thread swaged to its end; NULL: it has none. */
typedef struct suture_curve {
    const needle_object *needle;
    pose needle_pose; /* of the needle */
    const thread_object *thread;
    const vec3 *node_positions; /* its nodes */
    double swage_arc;           /* arc length at which the thread begins, m; 0 without a needle */
} suture_curve;

#define SUTURE_ON_NEEDLE UINT32_MAX
enum { SUTURE_SPAN_NODES = 4 };
/* A place on it: moved by the needle, by nodes of the thread, or by both. */
typedef struct suture_curve_point {
    double arc;
    vec3 position, tangent; /* tangent: unit, toward the tip */
    double needle_weight;   /* weight of the needle's point, which is in its frame: */
    vec3 needle_point;
    uint32_t span, first_node; /* of the thread: which, and the first node */
    double u;                  /* of the span, from its begin */
    double weights[SUTURE_SPAN_NODES];
    double weight_derivatives[SUTURE_SPAN_NODES]; /* of the weights along the curve as it is, 1/m */
    vec3 curvature;                               /* of the tangent the same, 1/m */
} suture_curve_point;

/* Threads of two nodes are no curve. */
static inline bool suture_is_curve(const thread_object *t)
{
    return t->node_count > 2;
}
/* The nearest place to a point downhill from an arc length; the same, among a span and those beside it. */
suture_curve_point vbss_suture_nearest_point(const suture_curve *curve, double from, vec3 to);
suture_curve_point vbss_suture_nearest_point_around_span(const suture_curve *curve,
                                                         uint32_t centre_span, double from,
                                                         vec3 to);
uint32_t vbss_suture_span_at(const suture_curve *curve, double arc);
/* Capstan: what slides along a thread in a hole bears, over what the hole bears across: against the tangent, along it. */
void vbss_suture_capstan_friction(const suture_curve *curve, const suture_curve_point *point,
                                  double friction, double capstan[2]);

/* ---- puncture.c */

typedef struct suture_tip {
    vec3 position, direction; /* direction: unit, where it points */
    vec3 force;               /* of the wall on it, N */
    vec3 normal;              /* of that force without friction: unit, away from the wall */
} suture_tip;
/* Along the wall rather than into it: cosine between the tip's way and the inner normal below which it only slides. */
#define SUTURE_MIN_ENTRY_COSINE 0.3
/* Whether it is pressed in, and not along, so that the wall gives way. */
bool vbss_suture_tip_punctures(const vbss_drain_config *config, const suture_tip *tip);
/* The hole that it makes: where its line meets the wall within `reach`; false: nowhere, or where the wall ends. */
bool vbss_suture_make_hole(const drain_object *d, const suture_tip *tip, double reach,
                           double wire_radius, suture_hole *hole);
/* Where an axis first goes through the wall: a hole's triangle and weights there, nothing else of it; at which share. */
bool vbss_suture_find_wall_crossing(const drain_object *d, const vec3 axis[2], suture_hole *hole,
                                    double *fraction);
/* Weights in a triangle, but for rounding: none below 0, all together 1. */
void vbss_suture_normalise_barycentric(double barycentric[3]);
/* Whether what goes that way through a triangle of the wall comes from inside. */
bool vbss_suture_is_outward(const drain_object *d, uint32_t triangle, vec3 direction);

/* ---- hole.c */

vec3 vbss_hole_point(const suture_hole *hole, const drain_object *d, const vec3 *x);
/* What it bears along the suture before that slides: `least`, and `grip` of what it bears across, where it was when the part
 * began. */
typedef struct hole_yield_limit {
    double force, friction[2];
} hole_yield_limit;
hole_yield_limit vbss_hole_yield_limit(const suture_hole *hole, const vbss_drain_config *config,
                                       const suture_curve *curve, const suture_curve_point *point);
/* Its row, all but the terms and what was known at the begin of the part: `now` and `drain` in the trial state; the part is h
 * long. a is the suture. */
void vbss_hole_set_constraint(const suture_hole *hole, const vbss_drain_config *config,
                              const suture_curve_point *now, vec3 drain, double h,
                              contact_constraint *constraint);
/* It has slid to that arc length of the needle. */
void vbss_hole_set_arc(suture_hole *hole, double arc);
/* What rows have found becomes its state. */
void vbss_hole_store_forces(suture_hole *hole, const contact_constraint *constraint);
void vbss_hole_serialise(vbss_stream *stream, uint16_t first_tag, suture_hole *hole);
bool vbss_hole_is_valid(const suture_hole *hole);

#endif
