#include "scene/needles_rig.h"
#include "scene/world/world.h"
#include "fixtures/scene_build.h"

void needles_begin(needles_rig *r)
{
    memset(r, 0, sizeof *r);
    tools_begin(&r->tools);
    expect_ok(vbss_needle_config_init(&r->config, sizeof r->config));
}

void needles_begin_scene(needles_rig *r)
{
    needles_begin(r);
    small_create(&r->tools.s);
}

void needles_end(needles_rig *r)
{
    tools_end(&r->tools);
}

void needles_add(needles_rig *r)
{
    expect_ok(
        scene_build_needle(r->tools.s.context, r->tools.s.scene, &r->config, &r->needle, &r->body));
}

void needles_add_across(needles_rig *r, double arc, vec3 there)
{
    double angle =
        arc / r->config.radius; /* turned forward by so much, the tip points along y again */
    const double turn[4] = {cos(0.5 * angle), 0.0, 0.0, sin(0.5 * angle)};
    memcpy(r->config.orientation, turn, sizeof turn);
    vec3_store(r->config.position, vec3_sub(there, vec3_make(r->config.radius, 0.0, 0.0)));
    needles_add(r);
}

void needles_hold(needles_rig *r)
{
    double middle = 0.5 * r->config.arc * r->config.radius;
    needles_add_across(r, middle, vec3_zero());
    tools_add(&r->tools, vec3_make(0.0, 0.0, -2e-3));
    tools_close(&r->tools, 0);
}

vbss_needle_state needles_state(const needles_rig *r)
{
    vbss_needle_state state;
    expect_ok(vbss_needle_get_state(r->needle, &state, sizeof state));
    return state;
}

vbss_needle_mass needles_mass(const needles_rig *r)
{
    vbss_needle_mass mass;
    expect_ok(vbss_needle_get_mass(r->needle, &mass, sizeof mass));
    return mass;
}

vec3 needles_place(const needles_rig *r, double arc, vec3 *direction)
{
    double position[3], tangent[3];
    expect_ok(vbss_needle_get_place(r->needle, arc, position, tangent));
    if (direction != NULL) {
        *direction = vec3_load(tangent);
    }
    return vec3_load(position);
}

pose needles_pose(const needles_rig *r)
{
    vbss_needle_state s = needles_state(r);
    return pose_make(vec3_load(s.position), quat_make(s.orientation[0], s.orientation[1],
                                                      s.orientation[2], s.orientation[3]));
}

pose needles_jaws(const needles_rig *r, uint32_t tool)
{
    const scene_body *b = vbss_scene_body(small_object(&r->tools.s), r->tools.bodies[tool]);
    return vbss_scene_jaw_frame(&b->rigid, b->rigid.body.now.pose);
}

double needles_energy(const needles_rig *r)
{
    vbss_needle_energies e;
    expect_ok(vbss_needle_get_energies(r->needle, &e, sizeof e));
    return e.total;
}
