/* The baseline method of threads: its memory, and its function table. */
#include "base/memory.h"
#include "baseline/thread.h"

static vbss_result create_thread(thread_object *t)
{
    t->baseline = vbss_allocate(t->context, 1, sizeof *t->baseline, "thread");
    if (t->baseline == NULL) {
        return VBSS_ERROR_OUT_OF_MEMORY;
    }
    baseline_thread *own = t->baseline;
    own->rows = vbss_allocate(t->context, t->node_capacity, sizeof *own->rows, "thread");
    return own->rows != NULL ? VBSS_OK : VBSS_ERROR_OUT_OF_MEMORY;
}

static void destroy_thread(vbss_context *context, thread_object *t)
{
    if (t->baseline != NULL) {
        vbss_release(context, t->baseline->rows, t->node_capacity, sizeof *t->baseline->rows);
        vbss_release(context, t->baseline, 1, sizeof *t->baseline);
    }
}

static const double *axial_forces(thread_object *t)
{
    return t->now.tension;
}

static vbss_baseline_statistics *baseline_statistics(const thread_object *t)
{
    return &t->baseline->statistics;
}

const thread_method vbss_baseline_thread = {
    .create_thread = create_thread,
    .destroy_thread = destroy_thread,
    .step_thread = vbss_baseline_thread_step,
    .bending_energy = vbss_baseline_bending_energy,
    .constraint_force = vbss_baseline_constraint_force,
    .axial_forces = axial_forces,
    .reaction_force = vbss_baseline_constraint_force, /* without forces and springs at the node */
    .reaction_torque = vbss_baseline_reaction_torque,
    .baseline_statistics = baseline_statistics,
    .corrects_masses = false,
    .is_guarded = false,
};
