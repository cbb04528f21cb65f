/* Sparsity: the drain in a system, as a chain of nodes in the order of elimination. */
#include "base/error.h"
#include "drain/drain.h"

vbss_result vbss_drain_add_to_system(drain_object *d, vbss_system *s, const uint8_t *separators,
                                     uint32_t *first)
{
    drain_elimination_order *order = &d->order;
    VBSS_TRY(vbss_system_add_chain(s, d->mesh.node_count, first));
    vbss_system_use_natural_order(s);
    for (uint32_t i = 0; i < d->mesh.node_count; i++) {
        bool separator = separators != NULL && separators[i] != 0;
        vbss_system_set_role(s, *first + order->block_index[i],
                             d->anchored[i] ? VBSS_ROLE_PRESCRIBED
                             : separator    ? VBSS_ROLE_SEPARATOR
                                            : VBSS_ROLE_INTERIOR);
    }
    order->first_coupling = s->coupling_count + 1;
    for (uint32_t p = 0; p < order->pair_count; p++) {
        drain_pair *pair = &order->pairs[p];
        VBSS_TRY(vbss_system_couple(s, *first + pair->high, *first + pair->low, &pair->coupling));
    }
    order->coupling_count = s->coupling_count + 1 - order->first_coupling;
    return VBSS_OK;
}

/* Only the analysis of the system decides which block of a pair is eliminated later. */
void vbss_drain_set_assembly_map(drain_object *d, const vbss_system *s)
{
    drain_elimination_order *order = &d->order;
    for (uint32_t p = 0; p < order->pair_count; p++) {
        uint32_t coupling = order->pairs[p].coupling;
        order->block_codes[p] = 2 * coupling + (s->couplings[coupling].is_transposed != 0);
    }
    order->block_codes[order->pair_count] = 2 * VBSS_NO_COUPLING;
    vbss_shell_set_assembly_map(&d->shell, (const uint32_t(*)[SHELL_PAIRS])order->pair_codes,
                                order->block_codes);
}
