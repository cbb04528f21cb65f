/* Dispatch between the plain and the wide copies of the hot loops. */
#include "solver/solver.h"

bool vbss_system_condense(vbss_system *system)
{
    if (!VBSS_WIDE_CALL(system->wide, vbss_system_condense, system)) {
        return false;
    }
    vbss_system_store_schur_complement(system);
    return true;
}

void vbss_system_condense_rhs(vbss_system *system)
{
    VBSS_WIDE_CALL(system->wide, vbss_system_condense_rhs, system);
    vbss_system_store_schur_rhs(system);
}

void vbss_system_back_substitute_interior(vbss_system *system)
{
    VBSS_WIDE_CALL(system->wide, vbss_system_back_substitute_interior, system);
}

bool vbss_system_solve_separators(vbss_system *system)
{
    return VBSS_WIDE_CALL(system->wide, vbss_system_solve_separators, system);
}

vbss_result vbss_system_order_separators(vbss_system *system)
{
    return VBSS_WIDE_CALL(system->wide, vbss_system_order_separators, system);
}
