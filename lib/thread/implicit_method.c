/* The implicit method of threads: its memory and its function table. */
#include "base/error.h"
#include "base/memory.h"
#include "thread/thread.h"

#include <string.h>

enum { ARRAY_COUNT = 6 };

static void list_arrays(thread_object *t, vbss_array arrays[ARRAY_COUNT])
{
    size_t n = t->node_capacity;
    const vbss_array all[] = {
        {&t->bending_matrix, n, sizeof *t->bending_matrix},
        {&t->rest_curvature_forces, n, sizeof(vec3)},
        {&t->axial_forces, n, sizeof *t->axial_forces},
        {&t->spline_moments, n, sizeof *t->spline_moments},
        {&t->arcs, n, sizeof *t->arcs},
        {&t->couplings, n, sizeof *t->couplings},
    };
    _Static_assert(sizeof all == ARRAY_COUNT * sizeof(vbss_array), "the table has its length");
    memcpy(arrays, all, sizeof all);
}

static vbss_result create_thread(thread_object *t)
{
    vbss_array arrays[ARRAY_COUNT];
    list_arrays(t, arrays);
    VBSS_TRY(vbss_allocate_arrays(t->context, arrays, ARRAY_COUNT, "thread"));
    /* A spring makes a group of separators, which is coupled with the next on either side. */
    uint32_t separators = THREAD_BANDWIDTH * t->config.attachment_capacity;
    return vbss_system_create(t->context, t->node_capacity, THREAD_BANDWIDTH, separators,
                              3 * THREAD_BANDWIDTH * separators, &t->system);
}

static void destroy_thread(vbss_context *context, thread_object *t)
{
    vbss_array arrays[ARRAY_COUNT];
    list_arrays(t, arrays);
    vbss_release_arrays(context, arrays, ARRAY_COUNT);
    vbss_system_destroy(context, t->system);
}

static vbss_baseline_statistics *baseline_statistics(const thread_object *t)
{
    (void)t;
    return NULL;
}

const thread_method vbss_thread_implicit = {
    .create_thread = create_thread,
    .destroy_thread = destroy_thread,
    .step_thread = vbss_thread_implicit_step,
    .bending_energy = vbss_thread_bending_energy,
    .constraint_force = vbss_thread_implicit_constraint_force,
    .axial_forces = vbss_thread_implicit_axial_forces,
    .reaction_force = vbss_thread_implicit_reaction_force,
    .reaction_torque = vbss_thread_implicit_reaction_torque,
    .baseline_statistics = baseline_statistics,
    .corrects_masses = true,
    .is_guarded = true,
};
