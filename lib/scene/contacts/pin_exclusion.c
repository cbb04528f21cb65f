/* Excludes contact of a thread with a body beside its pin on that body, and with the jaws that
 * grasp it. */
#include "scene/contacts/contacts.h"
#include "scene/tools/tools.h"
#include "scene/world/world.h"

bool vbss_scene_is_excluded_at_pin(const scene_object *s, const scene_body *thread,
                                   uint32_t segment, const scene_body *rigid, uint32_t capsule,
                                   double contact_distance)
{
    bool is_jaw =
        rigid->rigid.grasper != NULL && capsule != GRASPER_SHAFT && capsule != GRASPER_NECK;
    for (uint32_t i = 0; is_jaw && i < s->config.grasp_capacity; i++) {
        const scene_thread_grasp *g = &s->thread_grasps[i];
        if (g->id != 0 && g->thread == thread->number && g->tool == rigid->number &&
            vbss_scene_is_segment_in_grasp(s, g, segment, contact_distance)) {
            return true;
        }
    }
    const double *rest = thread->thread.thread->rest;
    for (uint32_t i = 0; i < s->config.pin_capacity; i++) {
        const scene_pin *p = &s->pins[i];
        if (p->thread != thread->number || p->body != rigid->number ||
            !vbss_scene_pin_holds(s, p)) {
            continue;
        }
        double arc = 0.0, max_arc = SCENE_EXCLUSION_ARC_RATIO * contact_distance;
        for (uint32_t k = p->node; k < segment && arc < max_arc; k++) {
            arc += rest[k];
        }
        for (uint32_t k = segment + 1; k < p->node && arc < max_arc; k++) {
            arc += rest[k];
        }
        if (arc < max_arc) {
            return true;
        }
    }
    return false;
}
