/* Dispatch: selects the copy of the shell's hot loops. */
#include "drain/shell.h"

void vbss_shell_add_forces(const vbss_shell *shell, const vec3 *x, vec3 *forces)
{
    VBSS_WIDE_CALL(shell->wide, vbss_shell_add_forces, shell, x, forces);
}

void vbss_shell_assemble(const vbss_shell *shell, const vec3 *x, vec3 *forces, block *diagonal,
                         block *blocks)
{
    VBSS_WIDE_CALL(shell->wide, vbss_shell_assemble, shell, x, forces, diagonal, blocks);
}
