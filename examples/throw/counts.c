#include "throw/counts.h"

#include <stdio.h>

#include "throw/rig.h"

#define PERCENT 100.0

static unsigned long long u(uint64_t count)
{
    return count;
}

void counts_report_scene(const vbss_scene_statistics *s)
{
    printf("  contacts at the end %u; parts of steps %llu of %llu attempts; rejected: states %llu, "
           "stretch %llu,"
           " depth %llu, guard %llu, singular %llu, full %llu\n",
           (unsigned)s->contacts, u(s->parts), u(s->attempts), u(s->rejected_states),
           u(s->rejected_stretch), u(s->rejected_depth), u(s->rejected_guard),
           u(s->rejected_singular), u(s->rejected_full));
    printf("  loose states %llu, loose stretch %llu, clamped by the guard %llu, recovering %llu; "
           "pairs the guard"
           " looked at %llu\n",
           u(s->loose_states), u(s->loose_stretch), u(s->clamped), u(s->recovering),
           u(s->guard_pairs));
    printf("  deepest penetration %.1f %% of the thread's diameter; largest stretch error %.1e\n",
           PERCENT * s->penetration / (2.0 * THREAD_RADIUS), s->stretch_error);
}

void counts_report_device(const char *name, const vbss_device_statistics *in,
                          const vbss_output_statistics *out, double largest_force)
{
    printf("  %s: %llu samples read, %llu refused; %llu forces written, largest %.2f N (the "
           "tool's: %.2f N);"
           " limited %llu, slewed %llu, over the continuous load %llu, stale %llu, watchdog %llu; "
           "held at the workspace %llu\n",
           name, u(in->accepted[0]),
           u(in->out_of_order[0] + in->not_finite[0] + in->out_of_range[0] + in->not_unit[0] +
             in->failed_reads[0]),
           u(out->steps), out->largest_force, largest_force, u(out->clamped), u(out->slewed),
           u(out->continuous), u(out->input_stale + out->command_stale), u(out->watchdogs),
           u(in->clamped_reads));
}
