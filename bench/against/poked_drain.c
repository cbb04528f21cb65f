/* drain/poked: a tool pokes a drain at four places, stirs there and draws back. */
#include "base/error.h"
#include "fixtures/tissue_scenes.h"
#include "against/subject.h"

static struct {
    vbss_context *context;
    tissue_scene scene;
    uint32_t steps;
} own;

static vbss_result begin(uint64_t seed)
{
    vbss_scene_config scene;
    vbss_drain_config drain;
    (void)seed;
    VBSS_TRY(vbss_context_create(NULL, &own.context));
    VBSS_TRY(tissue_scene_configs(TISSUE_SCENE_POKED, VBSS_METHOD_IMPLICIT, &scene, &drain));
    return tissue_scene_create(own.context, TISSUE_SCENE_POKED, &scene, &drain, &own.scene);
}

static bool goes_on(void)
{
    return own.steps < tissue_scene_steps[TISSUE_SCENE_POKED];
}

static vbss_result step(void)
{
    own.steps++;
    return tissue_scene_step(&own.scene, SUBJECT_STEP);
}

static vbss_result hash(uint64_t *value)
{
    return vbss_scene_get_hash(own.scene.scene, value);
}

static vbss_scene *scene(void)
{
    return own.scene.scene;
}

static void end(void)
{
    (void)vbss_context_destroy(own.context);
}

const subject poked_drain = {.name = "drain/poked",
                             .begin = begin,
                             .goes_on = goes_on,
                             .step = step,
                             .hash = hash,
                             .scene = scene,
                             .end = end};
