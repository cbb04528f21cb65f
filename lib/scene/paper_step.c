#include "scene/scene.h"
vbss_result vbss_scene_paper_step(scene_object *s, double h)
{
    (void)h;
    return vbss_fail(s->context, VBSS_ERROR_OUT_OF_RANGE, "not yet");
}
