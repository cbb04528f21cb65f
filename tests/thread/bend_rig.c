#include "thread/bend_rig.h"

#include "base/elementary.h"

vbss_thread_config bend_config(vbss_thread_bending bending)
{
    vbss_thread_config c = rig_config(BEND_LENGTH, BEND_SEGMENTS);
    c.bending = bending;
    c.bending_stiffness = BEND_STIFFNESS;
    c.gravity[1] = 0.0;
    c.linear_density = 1e-7; /* hardly any inertia: the bend follows the clamps */
    c.drag = 200.0;
    return c;
}

double bend_angle(const bend_rig *b)
{
    const double l = BEND_LENGTH / BEND_SEGMENTS;
    return b->has_arcs ? BEND_LENGTH * b->curvature
                       : 2.0 * BEND_SEGMENTS * asin(0.5 * l * b->curvature);
}

/* End of an arc or of equal chords on a circle that starts at the origin along x. */
static vec3 end_of_circle(const bend_rig *b, vec3 *direction)
{
    const double curvature = b->curvature;
    double sine, cosine;
    vbss_sincos(bend_angle(b), &sine, &cosine);
    *direction = vec3_make(cosine, sine, 0.0);
    if (fabs(curvature) < 1e-9) {
        return vec3_make(BEND_LENGTH, 0.0, 0.0);
    }
    return vec3_make(sine / curvature, (1.0 - cosine) / curvature, 0.0);
}

void bend_begin(bend_rig *b, const vbss_thread_config *config)
{
    rig_begin(&b->r, config);
    b->curvature = 0.0;
    b->has_arcs = config->bending == VBSS_THREAD_BENDING_SPLINE;
    b->clamps[0] = rig_clamp_here(&b->r, 0, vec3_make(1.0, 0.0, 0.0));
    b->clamps[1] = rig_clamp_here(&b->r, BEND_SEGMENTS, vec3_make(1.0, 0.0, 0.0));
}

void bend_end(bend_rig *b)
{
    rig_end(&b->r);
}

void bend_to(bend_rig *b, double curvature, uint32_t steps, double h)
{
    const double before = b->curvature;
    for (uint32_t k = 1; k <= steps; k++) {
        vec3 direction;
        double target[3], along[3];
        b->curvature = before + (curvature - before) * k / steps;
        vec3_store(target, end_of_circle(b, &direction));
        vec3_store(along, direction);
        expect_ok(vbss_thread_set_attachment_target(b->r.thread, b->clamps[1], target, along));
        rig_run(&b->r, h, 1);
    }
}

double bend_moment(bend_rig *b)
{
    return rig_reaction_torque(&b->r, b->clamps[1]).z;
}

void bend_release(bend_rig *b)
{
    expect_ok(vbss_thread_detach(b->r.thread, b->clamps[1]));
}

double bend_component(bend_rig *b, vbss_thread_field field, uint32_t node)
{
    vec3 v[BEND_SEGMENTS + 1];
    rig_read(&b->r, field, v);
    vec3 before = rig_position(&b->r, node - 1), after = rig_position(&b->r, node + 1);
    vec3 tangent = vec3_unit_or(vec3_sub(after, before), vec3_zero());
    return vec3_dot(v[node], vec3_make(-tangent.y, tangent.x, 0.0));
}
