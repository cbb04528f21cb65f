/* What shears close on is cut when the step is made: threads keep their nodes while it lasts. */
#include "scene/scene.h"

void vbss_scene_note_cut(scene_object *s, const scene_body *thread, uint32_t segment, double share)
{
    const thread_object *t = thread->thread.thread;
    if (s->cut_count == SCENE_CUTS) {
        return; /* what still lies between the blades is cut in the next step */
    }
    double arc = share * t->rest[segment];
    for (uint32_t i = 0; i < segment; i++) {
        arc += t->rest[i];
    }
    uint32_t to =
        s->cut_count++; /* from the end of a thread on: what is left keeps its arc lengths */
    while (to > 0 && s->cuts[to - 1].arc_length < arc) {
        s->cuts[to] = s->cuts[to - 1];
        to--;
    }
    s->cuts[to] = (scene_cut){thread->number, arc};
}

void vbss_scene_make_cuts(scene_object *s)
{
    for (uint32_t i = 0; i < s->cut_count; i++) {
        scene_body *thread = vbss_scene_body(s, s->cuts[i].thread), *piece;
        /* At an end there is nothing to cut; that no cut is left is an event. */
        (void)vbss_scene_cut_now(s, thread, s->cuts[i].arc_length, &piece);
    }
    s->cut_count = 0;
}
