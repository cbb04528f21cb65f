/* Damping of motion relative to the rigid motion of each section. */
#include "thread/thread.h"

void vbss_thread_damp_sections(thread_object *t, double fraction)
{
    for (uint32_t s = 0; s < t->section_count; s++) {
        uint32_t first = t->sections[s];
        uint32_t last = s + 1 < t->section_count ? t->sections[s + 1] : t->node_count - 1;
        first += t->prescribed_by[first] != 0;
        /* A section has at least two nodes, so this does not underflow. */
        last -= t->prescribed_by[last] != 0;
        if (first < last) {
            vbss_damp_relative_motion(t->mass, t->now.x, t->now.v, first, last, fraction);
        }
    }
}
