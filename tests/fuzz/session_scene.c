/* All that a session wants, far apart: nothing touches anything. */
#include <vblast_ss/vblast_ss.h>

#include "fuzz/fuzz.h"

#define ASIDE 0.08

#define TRY(call)                     \
    do {                              \
        vbss_result result_ = (call); \
        if (result_ != VBSS_OK) {     \
            return result_;           \
        }                             \
    } while (0)

static vbss_result add_drain(vbss_context *context, vbss_scene *scene, uint32_t *body)
{
    vbss_drain_config c;
    vbss_drain *drain;
    TRY(vbss_drain_config_init(&c, sizeof c));
    TRY(vbss_drain_create(context, &c, &drain));
    return vbss_scene_add_drain(scene, drain, body);
}

static vbss_result add_thread(vbss_context *context, vbss_scene *scene, uint32_t *body)
{
    vbss_thread_config c;
    vbss_thread *thread;
    TRY(vbss_thread_config_init(&c, sizeof c));
    c.segment_count = 8;
    c.gravity[1] = 0.0;
    c.start[1] = ASIDE;
    TRY(vbss_thread_create(context, &c, &thread));
    return vbss_scene_add_thread(scene, thread, body);
}

static vbss_result add_needle(vbss_context *context, vbss_scene *scene, uint32_t *body)
{
    vbss_needle_config c;
    vbss_needle *needle;
    TRY(vbss_needle_config_init(&c, sizeof c));
    c.position[0] = c.position[1] = ASIDE;
    TRY(vbss_needle_create(context, &c, &needle));
    return vbss_scene_add_needle(scene, needle, body);
}

static vbss_result add_tool(vbss_context *context, vbss_scene *scene, double z, uint32_t *body)
{
    vbss_grasper_config c;
    vbss_grasper *grasper;
    const double tip[3] = {-ASIDE, ASIDE, z};
    TRY(vbss_grasper_config_init(&c, sizeof c));
    TRY(vbss_grasper_create(context, &c, &grasper));
    TRY(vbss_grasper_set_target(grasper, tip, NULL));
    return vbss_scene_add_grasper(scene, grasper, body);
}

vbss_result session_scene_create(vbss_context *context, vbss_scene **scene,
                                 vbss_session_config *session)
{
    vbss_scene_config config;
    TRY(vbss_scene_config_init(&config, sizeof config));
    config.contact_capacity = 256;
    config.candidate_capacity = 4096;
    config.hole_capacity = 2;
    TRY(vbss_scene_create(context, &config, scene));
    TRY(vbss_session_config_init(session, sizeof *session));
    session->event_capacity = 8;
    session->hash_interval = 2;
    TRY(add_drain(context, *scene, &session->drain));
    TRY(add_thread(context, *scene, &session->thread));
    TRY(add_needle(context, *scene, &session->needle));
    TRY(add_tool(context, *scene, -ASIDE, &session->tools[0]));
    TRY(add_tool(context, *scene, ASIDE, &session->tools[1]));
    TRY(vbss_knot_detector_create(context, NULL, &session->knots));
    return VBSS_OK;
}
