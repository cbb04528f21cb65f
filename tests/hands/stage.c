#include "hands/stage.h"

#include <string.h>

#include "needle/stitch.h"
#include "throw/replay.h"

static stitch stage;

vbss_result stage_create(vbss_context **context, vbss_scene **scene)
{
    stitch_plan plan;
    stitch_plan_usual(&plan);
    memset(&stage, 0, sizeof stage);
    TRY(stitch_create(&stage, 1, &plan));
    *context = stage.site.rig.context;
    *scene = stage.site.rig.scene;
    return VBSS_OK;
}

void stage_destroy(void)
{
    throw_rig_destroy(&stage.site.rig);
}

uint8_t *stage_read_log(const char *path, uint64_t *count)
{
    replay_log log = replay_read(path);
    *count = log.count;
    return log.data;
}
