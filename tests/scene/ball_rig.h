/* A triangle as a host surface, and a ball that rests on its middle: what the tests of its compliance share. */
#ifndef VBSS_TESTS_SCENE_BALL_RIG_H
#define VBSS_TESTS_SCENE_BALL_RIG_H

#include "scene/surface_rig.h"

#define BALL_STEP 1e-3 /* s */
#define BALL_RADIUS 2e-3
#define GRAVITY 9.81

/* A triangle about the origin, in the plane y = 0, and a ball at rest in contact with its middle. */
typedef struct ball_rig {
    small s;
    uint32_t surface, ball;
    double x[3][3];
} ball_rig;

static const double ball_corners[3][3] = {
    {30e-3, 0.0, 0.0}, {-15e-3, 0.0, 25e-3}, {-15e-3, 0.0, -25e-3}};

/* At a height above the contact with the triangle. */
static inline void ball_add(ball_rig *r, double above)
{
    const vec3 centre = vec3_make(0.0, BALL_RADIUS + 0.25e-3 + above, 0.0);
    r->ball = small_stick(&r->s, VBSS_SCENE_RIGID_FREE, centre, vec3_zero(), BALL_RADIUS);
}

static inline void ball_begin(ball_rig *r, uint32_t compliance_size, double ball_mass)
{
    static const uint32_t triangle[3] = {0, 1, 2};
    vbss_scene_surface_config config = vbss_scene_surface_config_default();
    small_begin(&r->s);
    r->s.config.floor = 0;
    r->s.config.mode = VBSS_SCENE_MODE_OFFLINE;
    small_create(&r->s);
    memcpy(r->x, ball_corners, sizeof r->x);
    config.vertex_count = 3;
    config.triangle_count = 1;
    config.vertices = r->x[0];
    config.triangles = triangle;
    config.compliance_size = compliance_size;
    expect_ok(vbss_scene_add_surface(r->s.scene, &config, &r->surface));
    r->s.rigid.mass = ball_mass;
    r->s.rigid.gravity[1] = -GRAVITY;
    ball_add(r, 0.0);
}

static inline void ball_set_compliance(ball_rig *r, double compliance)
{
    const double each[3] = {compliance, compliance, compliance};
    expect_ok(vbss_scene_set_surface_compliance(r->s.scene, r->surface, each, 3));
}

static inline const vec3 *ball_view(const ball_rig *r, vbss_scene_surface_field field)
{
    vbss_view view;
    expect_ok(vbss_scene_get_surface_view(r->s.scene, r->surface, field, &view, sizeof view));
    return view.data;
}

/* Height of the vertices as the scene has them, and the force on all of them. */
static inline double ball_height(const ball_rig *r)
{
    return ball_view(r, VBSS_SCENE_SURFACE_VIEW_POSITIONS)[0].y;
}

static inline double ball_force(const ball_rig *r)
{
    const vec3 *f = ball_view(r, VBSS_SCENE_SURFACE_VIEW_FORCES);
    return f[0].y + f[1].y + f[2].y;
}

/* Growth of a deviation in a step, `mass_ratio` of the ball to the surface: the larger root of (1 + s m) r^2 + 2 (1 - s) m r - (1 - s) m = 0. */
static inline double ball_closed_growth(double stated, double mass_ratio)
{
    const double b = (1.0 - stated) * mass_ratio, a = 1.0 + stated * mass_ratio;
    const double root = b * b + a * b;
    return root < 0.0 ? sqrt(fabs(b) / a) : (fabs(b) + sqrt(root)) / a;
}

#endif
