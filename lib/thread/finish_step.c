/* The end of a step, alone or in a scene. */
#include "thread/thread.h"

void vbss_thread_finish_step(thread_object *t, double h)
{
    vbss_thread_commit_attachments(t, h);
    vbss_thread_update_reactions(t);
    t->is_in_setup = false;
    t->generation++;
    t->statistics.steps++;
    t->statistics.time += h;
}
