/* Which copy of the elimination is run. */
#include "solver/solver.h"

bool vbss_system_condense(vbss_system *system)
{
    return VBSS_WIDE_CALL(system->wide, vbss_system_condense, system);
}

void vbss_system_return_to_runs(vbss_system *system)
{
    VBSS_WIDE_CALL(system->wide, vbss_system_return_to_runs, system);
}
