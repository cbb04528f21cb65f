/* What shears close on is cut when the step is made: threads keep their nodes while it lasts. */
#include "scene/scene.h"

void vbss_scene_note_cut(scene_object *s, const scene_body *tool, const scene_body *thread,
                         uint32_t segment, double share)
{
    if (s->cut_count < SCENE_CUTS) {
        s->cuts[s->cut_count++] = (scene_cut){thread->number, tool->number, segment, share};
    }
}

void vbss_scene_make_cuts(scene_object *s)
{
    s->cut_count = 0;
}
