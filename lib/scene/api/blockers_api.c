/* Describes what holds back bodies to hosts. */
#include "base/api_call.h"
#include "base/check.h"
#include "base/error.h"
#include "scene/api/api.h"

vbss_result vbss_scene_get_blocker(vbss_scene *scene, uint32_t index, vbss_scene_blocker *blocker,
                                   uint32_t struct_size)
{
    VBSS_ENTER(scene);
    static const uint32_t sizes[] = {sizeof(vbss_scene_blocker), 0};
    static const vbss_layout layout = {"vbss_scene_blocker", NULL, sizes};
    scene_object *s;
    VBSS_TRY(vbss_scene_open(scene, &s));
    if (index >= s->report.blocker_count) {
        return vbss_fail(s->context, VBSS_ERROR_NOT_FOUND, "the scene has %u blockers, not %u",
                         s->report.blocker_count, index + 1);
    }
    const scene_blocker *b = &s->report.blockers[index];
    const vbss_scene_blocker own = {.struct_size = sizeof own,
                                    .cause = b->cause,
                                    .body_a = b->bodies.body_a,
                                    .body_b = b->bodies.body_b,
                                    .since = b->since,
                                    .lost_time = b->lost_time,
                                    .depth = b->depth};
    return vbss_struct_write(s->context, &layout, &own, blocker, struct_size);
}
