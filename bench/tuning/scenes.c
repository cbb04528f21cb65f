#include "tuning/scenes.h"

#include "base/error.h"
#include "scenes/needle_scenes.h"
#include "scenes/scene_scenes.h"
#include "scenes/session_scenes.h"
#include "scenes/tool_run.h"

static vbss_result measure(vbss_scene *scene, tuning_outcome *outcome)
{
    vbss_scene_statistics s;
    VBSS_TRY(vbss_scene_get_statistics(scene, &s, sizeof s));
    outcome->attempts = (double)s.attempts / (double)outcome->steps;
    outcome->penetration = s.penetration;
    outcome->stretch = s.stretch_error;
    return VBSS_OK;
}

static vbss_result measure_scene(vbss_scene *scene, tuning_outcome *outcome)
{
    VBSS_TRY(vbss_scene_get_hash(scene, &outcome->hash));
    return measure(scene, outcome);
}

static vbss_result run_scene(vbss_context *context, scene_scene_kind kind, uint32_t steps,
                             tuning_outcome *outcome)
{
    vbss_scene *scene;
    VBSS_TRY(scene_scene_create(context, kind, &scene));
    for (uint32_t i = 0; i < steps; i++) {
        VBSS_TRY(scene_scene_step(scene, kind));
    }
    return measure_scene(scene, outcome);
}

static vbss_result run_tools(vbss_context *context, uint32_t steps, tuning_outcome *outcome)
{
    return run_scene(context, SCENE_SCENE_TOOLS, steps, outcome);
}

static vbss_result run_mesh(vbss_context *context, uint32_t steps, tuning_outcome *outcome)
{
    return run_scene(context, SCENE_SCENE_MESH, steps, outcome);
}

static vbss_result run_graspers(vbss_context *context, uint32_t steps, tuning_outcome *outcome)
{
    tool_run run;
    VBSS_TRY(tool_run_create(context, VBSS_METHOD_IMPLICIT, &run));
    for (uint32_t i = 0; i < steps; i++) {
        VBSS_TRY(tool_run_step(&run));
    }
    return measure_scene(run.scene, outcome);
}

static vbss_result run_needle(vbss_context *context, uint32_t steps, tuning_outcome *outcome)
{
    vbss_scene *scene;
    VBSS_TRY(needle_scene_create(context, &scene));
    for (uint32_t i = 0; i < steps; i++) {
        VBSS_TRY(needle_scene_step(scene));
    }
    return measure_scene(scene, outcome);
}

static vbss_result run_session(vbss_context *context, uint32_t steps, tuning_outcome *outcome)
{
    static session_scene scene;
    vbss_session *session;
    VBSS_TRY(session_scene_tying(context, 5, &scene));
    VBSS_TRY(vbss_session_create(scene.scene, &scene.config, &session));
    for (uint32_t i = 0; i < steps; i++) {
        VBSS_TRY(session_scene_tie(&scene, session, NULL));
    }
    VBSS_TRY(vbss_session_get_hash(session, &outcome->hash));
    return measure(scene.scene, outcome);
}

const tuning_scene tuning_scenes[TUNING_SCENES] = {
    {"scene-tools", 400, run_tools}, /* a thread, a needle and tools on a floor */
    {"scene-mesh", 300, run_mesh},   /* an adaptive knot that is pulled tight and cut at 220 */
    {"graspers", TOOL_RUN_STEPS, run_graspers},       /* two tools grasp, pull and cut a thread */
    {"needle-hands", NEEDLE_SCENE_STEPS, run_needle}, /* one tool hands a needle to the other */
    {"session", 640, run_session}, /* a double throw over a drain, with detector and metrics */
};
