/* The implicit method of threads: its memory and its function table. */
#include "base/error.h"
#include "base/memory.h"
#include "thread/bending_memory.h"
#include "thread/twist.h"

#include <string.h>

enum { ARRAY_COUNT = 29 };

static void list_arrays(thread_object *t, vbss_array arrays[ARRAY_COUNT])
{
    size_t n = t->node_capacity, bends = thread_has_memory(t) ? n : 0;
    const size_t twists = thread_has_twist(t) ? n : 0,
                 holders = thread_has_twist(t) ? t->config.attachment_capacity : 0,
                 slots = thread_has_friction_torque(t) ? 3 : 2,
                 rolls = thread_has_friction_torque(t) ? n : 0,
                 held = thread_has_friction_torque(t) ? holders : 0;
    const vbss_array all[] = {
        {&t->bending_matrix, n, sizeof *t->bending_matrix},
        {&t->rest_curvature_forces, n, sizeof(vec3)},
        {&t->axial_forces, n, sizeof *t->axial_forces},
        {&t->spline_moments, n, sizeof *t->spline_moments},
        {&t->arcs, n, sizeof *t->arcs},
        {&t->couplings, n, sizeof *t->couplings},
        {&t->now.bend, 2 * bends, sizeof *t->now.bend},
        {&t->saved.bend, 2 * bends, sizeof *t->saved.bend},
        {&t->bend_responses, 2 * bends, sizeof *t->bend_responses},
        {&t->memory_curvatures[0], bends, sizeof(vec3)},
        {&t->memory_curvatures[1], bends, sizeof(vec3)},
        {&t->now.frames, holders, sizeof *t->now.frames},
        {&t->saved.frames, holders, sizeof *t->saved.frames},
        {&t->holders, holders, sizeof *t->holders},
        {&t->twist_spans, holders + rolls, sizeof *t->twist_spans},
        {&t->twist_stiffness, 2 * twists, sizeof *t->twist_stiffness},
        {&t->twist_forces, twists, sizeof(vec3)},
        {&t->twist_couplings, slots * twists, sizeof(vec3)},
        {&t->twist_scratch, twists, sizeof(vec3)},
        {&t->twists, twists, sizeof *t->twists},
        {&t->material_directors, twists, sizeof(vec3)},
        {&t->now.half_twists, 2 * rolls, sizeof(double)},
        {&t->saved.half_twists, 2 * rolls, sizeof(double)},
        {&t->now.held_rolls, held, sizeof(double)},
        {&t->saved.held_rolls, held, sizeof(double)},
        {&t->has_roll, rolls, sizeof *t->has_roll},
        {&t->roll_angles, rolls, sizeof *t->roll_angles},
        {&t->is_span_exact, held + rolls, sizeof *t->is_span_exact},
        {&t->span_gradients, held + rolls, sizeof *t->span_gradients},
    };
    _Static_assert(sizeof all == ARRAY_COUNT * sizeof(vbss_array), "the table has its length");
    memcpy(arrays, all, sizeof all);
}

static vbss_result create_thread(thread_object *t)
{
    vbss_array arrays[ARRAY_COUNT];
    list_arrays(t, arrays);
    VBSS_TRY(vbss_allocate_arrays(t->context, arrays, ARRAY_COUNT, "thread"));
    t->coupling_slots = thread_has_friction_torque(t) ? 3 : 2;
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
