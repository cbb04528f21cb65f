/* Which copy of the hot loops is run. */
#include "solver/solver.h"

bool vbss_system_condense(vbss_system *system)
{
    if (!VBSS_WIDE_CALL(system->wide, vbss_system_condense, system)) {
        return false;
    }
    vbss_system_keep_separators(system);
    return true;
}

void vbss_system_condense_rhs(vbss_system *system)
{
    VBSS_WIDE_CALL(system->wide, vbss_system_condense_rhs, system);
    vbss_system_keep_separator_rhs(system);
}

void vbss_system_return_to_runs(vbss_system *system)
{
    VBSS_WIDE_CALL(system->wide, vbss_system_return_to_runs, system);
}

bool vbss_system_solve_separators(vbss_system *system)
{
    return VBSS_WIDE_CALL(system->wide, vbss_system_solve_separators, system);
}

vbss_result vbss_system_order_separators(vbss_system *system)
{
    return VBSS_WIDE_CALL(system->wide, vbss_system_order_separators, system);
}
