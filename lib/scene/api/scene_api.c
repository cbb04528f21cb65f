/* Steps a scene; statistics, snapshots and hash of a scene. */
#include "base/api_call.h"
#include "base/baseline_statistics.h"
#include "base/check.h"
#include "base/error.h"
#include "base/snapshot.h"
#include "scene/api/api.h"
#include "scene/step/step.h"
#include "scene/world/method.h"

static const uint32_t statistics_sizes[] = {200, 232, 248, 264, 0};
static const vbss_layout statistics_layout = {"vbss_scene_statistics", NULL, statistics_sizes};

vbss_result vbss_scene_get_statistics(vbss_scene *scene, vbss_scene_statistics *statistics,
                                      uint32_t struct_size)
{
    VBSS_ENTER(scene);
    scene_object *s;
    VBSS_TRY(vbss_scene_open(scene, &s));
    vbss_scene_statistics own = s->report.statistics;
    own.struct_size = sizeof own;
    return vbss_struct_write(s->context, &statistics_layout, &own, statistics, struct_size);
}

vbss_result vbss_scene_get_baseline_statistics(vbss_scene *scene,
                                               vbss_baseline_statistics *statistics,
                                               uint32_t struct_size)
{
    VBSS_ENTER(scene);
    scene_object *s;
    VBSS_TRY(vbss_scene_open(scene, &s));
    const vbss_baseline_statistics *counted = s->method->baseline_statistics(s);
    vbss_baseline_statistics own = counted != NULL ? *counted : (vbss_baseline_statistics){0};
    own.sign_tests_ended = s->collision->counters.sign_tests_ended;
    return vbss_baseline_write_statistics(s->context, counted != NULL ? &own : NULL, statistics,
                                          struct_size);
}

vbss_result vbss_scene_prepare(vbss_scene *scene)
{
    VBSS_ENTER(scene);
    scene_object *s;
    VBSS_TRY(vbss_scene_open_mutable(scene, &s));
    return s->config.method == VBSS_METHOD_IMPLICIT ? vbss_scene_prepare_step(s) : VBSS_OK;
}

static vbss_result step(scene_object *s, double h)
{
    const vbss_result result = s->method->step_scene(s, h);
    VBSS_TRY(result);
    s->report.generation++;
    s->report.statistics.steps++;
    s->report.statistics.time += h;
    return VBSS_OK;
}

vbss_result vbss_scene_step(vbss_scene *scene, double h)
{
    VBSS_ENTER(scene);
    scene_object *s;
    vbss_edit input = {.kind = VBSS_EDIT_STEP, .numbers = {h}};
    VBSS_TRY(vbss_scene_open_mutable(scene, &s));
    VBSS_TRY(vbss_check_range(s->context, h, 1e-7, 0.1, "h"));
    VBSS_TRY(vbss_edit_begin(scene, &input));
    return vbss_edit_end(scene, &input, step(s, h));
}

vbss_result vbss_scene_save(vbss_scene *scene, uint8_t *bytes, uint64_t capacity, uint64_t *written)
{
    VBSS_ENTER(scene);
    return vbss_object_save(scene, &vbss_scene_kind, bytes, capacity, written);
}

vbss_result vbss_scene_restore(vbss_scene *scene, const uint8_t *bytes, uint64_t count)
{
    VBSS_ENTER(scene);
    scene_object *s;
    vbss_edit input = {.kind = VBSS_EDIT_OTHER};
    VBSS_TRY(vbss_scene_open_mutable(scene, &s));
    VBSS_TRY(vbss_edit_begin(scene, &input));
    return vbss_edit_end(scene, &input, vbss_object_restore(scene, &vbss_scene_kind, bytes, count));
}

vbss_result vbss_scene_get_hash(vbss_scene *scene, uint64_t *hash)
{
    VBSS_ENTER(scene);
    return vbss_object_hash(scene, &vbss_scene_kind, hash);
}
