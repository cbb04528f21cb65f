/* The implicit method of drains: its memory and its function table. */
#include "base/error.h"
#include "base/memory.h"
#include "drain/drain.h"

static drain_mesh_kind mesh_kind(const vbss_drain_config *config)
{
    static const drain_mesh_kind kinds[] = {DRAIN_MESH_N, DRAIN_MESH_D, DRAIN_MESH_S, DRAIN_MESH_R};
    return config->surface != NULL ? DRAIN_MESH_SURFACE : kinds[config->mesh];
}

static vbss_result create_drain(drain_object *d)
{
    d->diagonal = vbss_allocate(d->context, d->mesh.node_count, sizeof *d->diagonal, "drain");
    if (d->diagonal == NULL) {
        return VBSS_ERROR_OUT_OF_MEMORY;
    }
    VBSS_TRY(vbss_drain_create_elimination_order(d->context, &d->mesh, &d->shell, &d->order));
    const vbss_system_capacity capacity = {.blocks = d->mesh.node_count,
                                           .couplings = d->order.pair_count,
                                           .entries = d->order.factor_entries,
                                           .products = d->order.factor_products,
                                           .arena = 1 + 2 * d->order.factor_entries};
    return vbss_system_create_with_capacity(d->context, &capacity, &d->system);
}

static void destroy_drain(vbss_context *context, drain_object *d)
{
    vbss_system_destroy(context, d->system);
    vbss_drain_destroy_elimination_order(context, &d->mesh, &d->order);
    vbss_release(context, d->diagonal, d->mesh.node_count, sizeof *d->diagonal);
}

static void add_shell_energies(drain_object *d, vbss_drain_energies *energies)
{
    vbss_shell_compute_responses(&d->shell, d->x, d->shell_responses);
    for (uint32_t t = 0; t < d->mesh.triangle_count; t++) {
        energies->membrane += d->shell_responses[t].membrane_energy;
        energies->bending += d->shell_responses[t].bending_energy;
    }
}

const drain_method vbss_drain_implicit = {
    .mesh_kind = mesh_kind,
    .create_drain = create_drain,
    .destroy_drain = destroy_drain,
    .step_drain = vbss_drain_implicit_step,
    .add_energies = add_shell_energies,
    .is_surface = false,
};
