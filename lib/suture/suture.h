/* Coupling of needle, thread and drain by holes. A tip makes a hole where it enters a wall. The hole then slides along the
 * needle and along the thread behind it.
 *
 * A hole is a material point of the wall on the suture's centre line. A stiffness ties both across the line, and friction acts
 * along it (docs/explanation/puncture.md, docs/explanation/stitch.md). puncture.c decides when and where a tip enters, curve.c has the line, and hole.c
 * the forces of a hole. */
#ifndef VBSS_SUTURE_SUTURE_H
#define VBSS_SUTURE_SUTURE_H

#include "base/linear.h"
#include "contact/contact.h"
#include "drain/drain.h"
#include "needle/needle.h"

#include "suture/tuning.h"
#include "thread/thread.h"

typedef struct vbss_stream vbss_stream;

/* The wall of a hole: a drain, or a surface that the host moves. */
typedef struct suture_wall {
    const vbss_drain_config *law; /* thickness, and the laws of punctures and holes */
    uint32_t (*triangles)[3];
    uint32_t triangle_count;
    /* Nodes of each edge, and the triangles beside it; DRAIN_NONE: it has fewer. From one edge to the next
     * are edge_stride numbers. */
    const uint32_t *edges, *beside_edges;
    uint32_t edge_count, edge_stride;
    const double *triangle_thickness; /* per triangle, m; NULL: that of the law */
    const uint8_t *anchored;          /* per node; NULL: none is */
    const vec3 *now, *trial, *rest;   /* positions of the nodes, m */
} suture_wall;

static inline suture_wall suture_wall_of_drain(const drain_object *d)
{
    const drain_mesh *mesh = &d->mesh;
    return (suture_wall){.law = &d->config,
                         .triangles = mesh->triangles,
                         .triangle_count = mesh->triangle_count,
                         .edges = mesh->edges[0].nodes,
                         .beside_edges = mesh->edges[0].triangles,
                         .edge_count = mesh->edge_count,
                         .edge_stride = sizeof(drain_edge) / sizeof(uint32_t),
                         .triangle_thickness = d->triangle_thickness,
                         .anchored = d->anchored,
                         .now = d->x,
                         .trial = d->trial,
                         .rest = mesh->rest};
}

typedef enum suture_tear {
    SUTURE_HOLDS,
    SUTURE_BEGINS_TO_TEAR, /* the event is due */
    SUTURE_TEARS
} suture_tear;

typedef struct suture_hole {
    uint32_t id; /* 0 for a free entry */
    /* numbers in the scene; the hole is on a needle or a thread, and the other is 0 */
    uint32_t needle;
    uint32_t thread;
    uint32_t wall; /* a drain or host surface */
    uint32_t triangle;
    bool is_outward;       /* the needle passed through from the inside of the wall */
    double barycentric[3]; /* weights of the triangle's corners */
    /* arc length of the needle at the hole when it entered, m; below 0 means ahead of the tip */
    double entry_arc;
    /* present arc length at the hole, m; measured from the needle's tip, or the thread's
     * start */
    double arc;
    /* change of `arc` in the trial state of a substep, m; the CCD guard computes it */
    double trial_slide;
    double max_arc;        /* largest arc length of the needle so far, m */
    double friction_force; /* friction on the suture, positive toward the tip, N */
    vec3 transverse_force; /* force on the suture across its line, N, in the world frame */
    suture_tear tear;
    /* the hole has torn up to a free edge: the side opposite to corner free_side - 1; 0: it has not */
    uint32_t free_side;
    double torn_length; /* how far it has torn, m */
    double tear_work;   /* dissipated by that, J */
} suture_hole;

/* ---- the suture curve (curve.c) */

/* A needle, a thread, or a needle with a thread swaged to its end; NULL for the missing one. */
typedef struct suture_curve {
    const needle_object *needle;
    pose needle_pose; /* pose of the needle */
    const thread_object *thread;
    const vec3 *node_positions; /* positions of the thread's nodes */
    /* arc length of the swage, where the thread starts, m; 0 without a needle */
    double swage_arc;
} suture_curve;

/* Value of suture_curve_point.span for a point of the needle. */
#define SUTURE_ON_NEEDLE UINT32_MAX
enum { SUTURE_SPAN_NODES = 4 };
/* A point of the curve. It moves with the needle, with nodes of the thread, or with both. */
typedef struct suture_curve_point {
    double arc;
    vec3 position, tangent; /* unit tangent toward the tip */
    double needle_weight;   /* weight of needle_point, which is in the needle's frame */
    vec3 needle_point;
    uint32_t span, first_node; /* span of the thread, and its first node */
    double u;                  /* parameter in the span, 0 to 1 from its start */
    double weights[SUTURE_SPAN_NODES];
    /* derivatives of weights by arc length along the present curve, 1/m */
    double weight_derivatives[SUTURE_SPAN_NODES];
    vec3 curvature; /* derivative of the tangent by arc length, 1/m */
} suture_curve_point;

/* A thread of two nodes has no spline. */
static inline bool suture_is_curve(const thread_object *t)
{
    return t->node_count > 2;
}
/* The nearest point to a given point, found by descent from the arc length `from`. The second
 * function searches only centre_span and its two neighbours. */
suture_curve_point vbss_suture_nearest_point(const suture_curve *curve, double from, vec3 to);
suture_curve_point vbss_suture_nearest_point_around_span(const suture_curve *curve,
                                                         uint32_t centre_span, double from,
                                                         vec3 to);
/* Span of the thread at this arc length. */
uint32_t vbss_suture_span_at(const suture_curve *curve, double arc);
/* Capstan friction of a thread that slides through a hole: axial friction / transverse force.
 * capstan[0] is for friction against the tangent, capstan[1] along it. */
void vbss_suture_capstan_friction(const suture_curve *curve, const suture_curve_point *point,
                                  double friction, double capstan[2]);

/* ---- puncture (puncture.c) */

typedef struct suture_tip {
    vec3 position, direction; /* unit direction in which the tip points */
    vec3 force;               /* force of the wall on the tip, N */
    /* unit direction of that force without friction, away from the wall */
    vec3 normal;
} suture_tip;
/* Whether it is pressed in, and not along, so that the wall gives way. */
bool vbss_suture_tip_punctures(const vbss_drain_config *config, const suture_tip *tip);
/* Makes the hole where the line of the tip meets the wall within `reach`, m. Returns false if it
 * misses, or meets the wall too near a free edge or where it is fixed. */
bool vbss_suture_make_hole(const suture_wall *wall, const suture_tip *tip, double reach,
                           double wire_radius, suture_hole *hole);
/* First point where an axis crosses the wall. Sets only triangle and barycentric coordinates of the
 * hole; *fraction is the position along the axis, 0 to 1. Returns false if there is none. */
bool vbss_suture_find_wall_crossing(const suture_wall *wall, const vec3 axis[2], suture_hole *hole,
                                    double *fraction);
/* Removes rounding errors from barycentric coordinates: none is negative, and their sum is 1. */
void vbss_suture_normalise_barycentric(double barycentric[3]);
/* Whether a motion in this direction passes through the triangle from the inside of the wall. */
bool vbss_suture_is_outward(const suture_wall *wall, uint32_t triangle, vec3 direction);

/* ---- holes (hole.c) */

/* Point of a triangle of a wall with given barycentric coordinates, with the nodes at `x`. */
vec3 vbss_wall_point(const suture_wall *wall, const vec3 *x, uint32_t triangle,
                     const double barycentric[3]);
/* Position of the hole for node positions x of its wall. */
vec3 vbss_hole_point(const suture_hole *hole, const suture_wall *wall, const vec3 *x);
/* Axial force that a hole bears before the suture slides: force[], N, plus friction[] times the
 * transverse force. Index 0 is against the tangent, as it advances; 1 is along it. It is evaluated at the start of the
 * substep. */
typedef struct hole_yield_limit {
    double force[2], friction[2];
} hole_yield_limit;
hole_yield_limit vbss_hole_yield_limit(const suture_hole *hole, const vbss_drain_config *config,
                                       const suture_curve *curve, const suture_curve_point *point);
/* Sets the constraint of a hole, except its Jacobian and the fields known at the start of the
 * substep. The hole began the substep at `start_arc`, m. The point `now` of the suture and the
 * hole's position `drain` are in the trial state; the substep lasts h seconds. Side a is the
 * suture. */
void vbss_hole_set_constraint(const suture_hole *hole, const vbss_drain_config *config,
                              double start_arc, const suture_curve_point *now, vec3 drain, double h,
                              contact_constraint *constraint);
/* Moves the hole to this arc length and updates max_arc. */
void vbss_hole_set_arc(suture_hole *hole, double arc);
/* Stores the forces of the solved constraint in the hole. */
void vbss_hole_store_forces(suture_hole *hole, const contact_constraint *constraint);
/* Visits the hole, but not its tear, with four tags from first_tag on. */
void vbss_hole_serialise(vbss_stream *stream, uint16_t first_tag, suture_hole *hole);
/* Whether a hole that was read can exist. */
bool vbss_hole_is_valid(const suture_hole *hole);

/* ---- tears (tear.c) */

/* Force in the plane of a triangle at which a hole in it tears, N; 0: it never does. */
double vbss_suture_tear_force(const suture_wall *wall, uint32_t triangle);
/* Unit normal of a triangle, with the nodes at `x`. */
vec3 vbss_suture_wall_normal(const suture_wall *wall, const vec3 *x, uint32_t triangle);
/* Moves a hole through the wall as it is now, along the part of the direction in its plane. Stops at a free
 * edge, which becomes free_side, and before a triangle with three anchored nodes. Returns the length of the
 * path, at most `distance`, m. */
double vbss_suture_move_hole(const suture_wall *wall, suture_hole *hole, vec3 direction,
                             double distance);
/* Whether a point is beyond the free edge at which the hole is. False if the hole is at none. */
bool vbss_suture_is_outside(const suture_wall *wall, const suture_hole *hole, vec3 point);
/* Visits the tear of a hole with three tags from first_tag on. */
void vbss_suture_serialise_tear(vbss_stream *stream, uint16_t first_tag, suture_hole *hole);

#endif
