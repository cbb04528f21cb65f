#include "scenes/session_scenes.h"

#include <string.h>

#include "base/error.h"
#include "scene/api/api.h"
#include "scene/world/world.h"
#include "scenes/needle_scenes.h"
#include "scenes/puncture_scenes.h"

enum { SEGMENTS = 60 };
/* Where needle and tools stand: beside the drain, and out of each other's way, m. */
#define ASIDE 0.08

/* ---- what is in it */

static vbss_result add_needle(vbss_context *context, session_scene *m)
{
    vbss_needle_config c;
    VBSS_TRY(vbss_needle_config_init(&c, sizeof c));
    c.position[0] = ASIDE;
    c.position[1] = ASIDE;
    VBSS_TRY(vbss_needle_create(context, &c, &m->needle));
    return vbss_scene_add_needle(m->scene, m->needle, &m->config.needle);
}

/* From above, their handles up. */
static vbss_result add_tool(vbss_context *context, session_scene *m, int which)
{
    vbss_grasper_config c;
    const double tip[3] = {-ASIDE, ASIDE, which == 0 ? -ASIDE : ASIDE};
    const double up[4] = {0.70710678118654752, -0.70710678118654752, 0.0, 0.0}; /* z to y */
    VBSS_TRY(vbss_grasper_config_init(&c, sizeof c));
    VBSS_TRY(vbss_grasper_create(context, &c, &m->tools[which]));
    VBSS_TRY(vbss_grasper_move(m->tools[which], tip, up));
    return vbss_scene_add_grasper(m->scene, m->tools[which], &m->config.tools[which]);
}

static vbss_result add_rest(vbss_context *context, session_scene *m)
{
    VBSS_TRY(add_needle(context, m));
    VBSS_TRY(add_tool(context, m, 0));
    return add_tool(context, m, 1);
}

static vbss_result add_thread(vbss_context *context, session_scene *m)
{
    vbss_thread_config c;
    VBSS_TRY(vbss_thread_config_init(&c, sizeof c));
    c.segment_count = SEGMENTS;
    c.cut_capacity = 3;
    memset(c.gravity, 0, sizeof c.gravity);
    c.start[1] = ASIDE;
    c.start[2] = ASIDE / 2.0;
    VBSS_TRY(vbss_thread_create(context, &c, &m->thread));
    return vbss_scene_add_thread(m->scene, m->thread, &m->config.thread);
}

vbss_result session_scene_still(vbss_context *context, session_scene *made)
{
    vbss_scene_config scene;
    vbss_drain_config drain;
    memset(made, 0, sizeof *made);
    /* Little touches: room for that, as some make thousands of these. */
    VBSS_TRY(vbss_scene_config_init(&scene, sizeof scene));
    scene.node_capacity = 128;
    scene.contact_capacity = 64;
    scene.candidate_capacity = 4096;
    VBSS_TRY(vbss_session_config_init(&made->config, sizeof made->config));
    VBSS_TRY(vbss_drain_config_init(&drain, sizeof drain));
    VBSS_TRY(vbss_scene_create(context, &scene, &made->scene));
    VBSS_TRY(vbss_drain_create(context, &drain, &made->drain));
    VBSS_TRY(vbss_scene_add_drain(made->scene, made->drain, &made->config.drain));
    VBSS_TRY(add_thread(context, made));
    return add_rest(context, made);
}

vbss_result session_scene_end(session_scene *s)
{
    VBSS_TRY(vbss_scene_destroy(s->scene));
    VBSS_TRY(vbss_thread_destroy(s->thread));
    VBSS_TRY(vbss_drain_destroy(s->drain));
    VBSS_TRY(vbss_needle_destroy(s->needle));
    VBSS_TRY(vbss_grasper_destroy(s->tools[0]));
    return vbss_grasper_destroy(s->tools[1]);
}

/* ---- a needle that goes in and out, or from hand to hand */

vbss_result session_scene_piercing(vbss_context *context, session_scene *made)
{
    vbss_scene_config scene;
    vbss_drain_config drain;
    puncture_scene p;
    memset(made, 0, sizeof *made);
    VBSS_TRY(vbss_session_config_init(&made->config, sizeof made->config));
    VBSS_TRY(puncture_scene_configs(&scene, &drain));
    scene.node_capacity = 256;
    VBSS_TRY(puncture_scene_create(context, &scene, &drain, &p));
    made->scene = p.scene;
    made->drain = p.drain;
    made->needle = p.needle;
    made->config.drain = p.drain_body;
    made->config.needle = p.needle_body;
    VBSS_TRY(add_thread(context, made));
    VBSS_TRY(add_tool(context, made, 0));
    return add_tool(context, made, 1);
}

vbss_result session_scene_floor(vbss_context *context, session_scene *made)
{
    vbss_drain_config drain;
    memset(made, 0, sizeof *made);
    VBSS_TRY(vbss_session_config_init(&made->config, sizeof made->config));
    VBSS_TRY(needle_scene_create(context, &made->scene));
    VBSS_TRY(vbss_drain_config_init(&drain, sizeof drain));
    drain.position[0] = 0.2;
    drain.position[2] = 0.05;
    VBSS_TRY(vbss_drain_create(context, &drain, &made->drain));
    VBSS_TRY(vbss_scene_add_drain(made->scene, made->drain, &made->config.drain));
    made->config.needle = NEEDLE_SCENE_NEEDLE;
    made->config.thread = NEEDLE_SCENE_THREAD;
    made->config.tools[0] = NEEDLE_SCENE_FIRST;
    made->config.tools[1] = NEEDLE_SCENE_SECOND;
    return VBSS_OK;
}

/* ---- a throw that is tied */

static vbss_result add_parts(vbss_context *context, session_scene *m)
{
    vbss_metrics_config c;
    VBSS_TRY(vbss_metrics_config_init(&c, sizeof c));
    c.duration = 10.0;
    VBSS_TRY(vbss_metrics_create(context, &c, &m->config.metrics));
    return vbss_knot_detector_create(context, NULL, &m->config.knots);
}

vbss_result session_scene_tying(vbss_context *context, uint32_t crossings, session_scene *made)
{
    stitch_scene_options options;
    memset(made, 0, sizeof *made);
    VBSS_TRY(vbss_session_config_init(&made->config, sizeof made->config));
    VBSS_TRY(stitch_scene_init(&options));
    options.crossings = crossings;
    VBSS_TRY(stitch_scene_create(context, &options, &made->stitch));
    made->scene = made->stitch.scene;
    made->drain = made->stitch.drain;
    made->thread = made->stitch.thread;
    made->config.drain = made->stitch.drain_body;
    made->config.thread = made->stitch.thread_body;
    VBSS_TRY(add_rest(context, made));
    return add_parts(context, made);
}

static vbss_result draw(session_scene *s, int hand, vec3 to, vbss_record *record)
{
    double target[3];
    if (record == NULL) {
        return stitch_scene_move(&s->stitch, hand, to);
    }
    vec3_store(target, to);
    return vbss_record_move_attachment(record, s->stitch.thread_body, s->stitch.hands[hand], target,
                                       NULL);
}

vbss_result session_scene_tie(session_scene *s, vbss_session *session, vbss_record *record)
{
    scene_object *scene;
    VBSS_TRY(vbss_scene_open(s->scene, &scene));
    const thread_object *t = vbss_scene_body(scene, s->stitch.thread_body)->thread.thread;
    for (int k = 0; k < 2; k++) {
        vec3 to;
        s->stitch.at[k] = t->now.x[s->stitch.ends[k]];
        if (stitch_scene_draws(&s->stitch, k, (uint32_t)scene->statistics.steps, SESSION_SCENE_STEP,
                               &to)) {
            VBSS_TRY(draw(s, k, to, record));
        }
    }
    return vbss_session_step(session, 0.0, SESSION_SCENE_STEP);
}
