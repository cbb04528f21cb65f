/* Position of the jaws, their motion with the handle, and their force. */
#include "base/elementary.h"
#include "base/pi.h"
#include "grasper/grasper.h"

/* ---- position */

const grasper_jaws *vbss_grasper_current_jaws(const grasper_object *g)
{
    return g->kind == VBSS_GRASPER_KIND_SHEARS ? &g->shears : &g->driver;
}

/* Rotated about x by the bend; its z axis points from the tip to the pivot. */
pose vbss_grasper_jaw_frame(const grasper_object *g)
{
    const grasper_jaws *j = vbss_grasper_current_jaws(g);
    double sine, cosine, half_sine, half_cosine;
    vbss_sincos(j->bend, &sine, &cosine);
    vbss_sincos(0.5 * j->bend, &half_sine, &half_cosine);
    return pose_make(vec3_make(0.0, j->length * sine, j->length * cosine),
                     quat_make(half_cosine, -half_sine, 0.0, 0.0));
}

vec3 vbss_grasper_bend_point(const grasper_object *g)
{
    vec3 back = vec3_make(0.0, 0.0, vbss_grasper_current_jaws(g)->neck);
    return pose_apply(vbss_grasper_jaw_frame(g), back);
}

static grasper_capsule jaw_at(const grasper_jaws *j, pose frame, double angle, double side)
{
    double sine, cosine;
    vbss_sincos(angle, &sine, &cosine);
    vec3 start = vec3_make(side * j->radius, 0.0, 0.0);
    vec3 end = vec3_make(side * (j->radius + j->length * sine), 0.0, -j->length * cosine);
    grasper_capsule jaw = {{pose_apply(frame, start), pose_apply(frame, end)}, j->radius};
    return jaw;
}

void vbss_grasper_compute_capsules(const grasper_object *g, double angle,
                                   grasper_capsule capsules[GRASPER_CAPSULES])
{
    const grasper_jaws *j = vbss_grasper_current_jaws(g);
    pose frame = vbss_grasper_jaw_frame(g);
    vec3 bend = vbss_grasper_bend_point(g);
    double length = g->config.shaft_length, radius = g->config.shaft_radius;
    capsules[GRASPER_SHAFT] =
        (grasper_capsule){{vec3_add(bend,
                                    /* so that its cap ends at the bend */
                                    vec3_make(0.0, 0.0, vbss_min(radius, length))),
                           vec3_add(bend, vec3_make(0.0, 0.0, length))},
                          radius};
    capsules[GRASPER_JAW] = jaw_at(j, frame, angle, 1.0);
    capsules[GRASPER_JAW + 1] = jaw_at(j, frame, angle, -1.0);
    /* The neck ends one radius before the pivot, because its cap would fill the space between the
     * jaws. */
    vec3 front = pose_apply(frame, vec3_make(0.0, 0.0, vbss_min(g->config.neck_radius, j->neck)));
    capsules[GRASPER_NECK] = (grasper_capsule){{front, bend}, g->config.neck_radius};
}

void vbss_grasper_update_view(grasper_object *g)
{
    grasper_capsule capsules[GRASPER_CAPSULES];
    vbss_grasper_compute_capsules(g, g->jaw_angle, capsules);
    for (int i = 0; i < GRASPER_CAPSULES; i++) {
        vec3_store(g->view_capsules[i], pose_apply(g->tool_pose, capsules[i].axis[0]));
        vec3_store(g->view_capsules[i] + 3, pose_apply(g->tool_pose, capsules[i].axis[1]));
        g->view_capsules[i][6] = capsules[i].radius;
    }
}

/* ---- motion with the handle */

/* Exact for a fully open or fully closed handle, so that rounding does not move open jaws at
 * rest. */
double vbss_grasper_commanded_angle(const grasper_object *g)
{
    double t = g->opening;
    return t * vbss_grasper_current_jaws(g)->opening - (1.0 - t) * g->config.closing_angle;
}

/* An object between the jaws holds them open at min_angle, whatever their speed. */
double vbss_grasper_next_angle(const grasper_object *g, double h, double min_angle)
{
    double max_change = g->config.jaw_speed * h;
    double nearer = vbss_min(g->jaw_angle + max_change, vbss_grasper_commanded_angle(g));
    nearer = vbss_max(g->jaw_angle - max_change, nearer);
    return vbss_max(nearer, vbss_max(min_angle, 0.0));
}

double vbss_grasper_jaw_force_at(const grasper_object *g, double angle)
{
    double fraction = (angle - vbss_grasper_commanded_angle(g)) / g->config.closing_angle;
    return g->config.closing_force * vbss_max(0.0, vbss_min(fraction, 1.0));
}

/* ---- objects between the jaws */

double vbss_grasper_touching_angle(double thread_diameter, double from_pivot)
{
    if (!(2.0 * from_pivot > thread_diameter)) {
        return 0.5 * VBSS_PI;
    }
    double sine = thread_diameter / (2.0 * from_pivot);
    return vbss_arc_tangent(sine, sqrt((1.0 - sine) * (1.0 + sine)));
}

double vbss_grasper_jaw_distance(double angle, double from_pivot)
{
    return 2.0 * from_pivot * vbss_sine(angle);
}

bool vbss_grasper_find_between(const grasper_object *g, vec3 start, vec3 end, double overhang,
                               grasper_jaw_point *point)
{
    const grasper_jaws *jaws = vbss_grasper_current_jaws(g);
    double across = end.y - start.y, fraction = across != 0.0 ? -start.y / across : 0.0;
    fraction = fraction < 0.0 ? 0.0 : fraction > 1.0 ? 1.0 : fraction;
    vec3 at = vec3_lerp(start, end, fraction);
    *point = (grasper_jaw_point){fraction, fabs(at.y), -at.z};
    return point->from_pivot > 0.0 && point->from_pivot <= jaws->length + overhang &&
           point->offset <= GRASPER_MAX_OFFSET_RATIO * jaws->radius &&
           fabs(at.x) <= 0.5 * vbss_grasper_jaw_distance(g->jaw_angle, point->from_pivot);
}
