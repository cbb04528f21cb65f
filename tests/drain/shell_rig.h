/* Small structured shells and their equilibrium, for tests: dense to the skyline, minimising energy. */
#ifndef VBSS_TESTS_SHELL_RIG_H
#define VBSS_TESTS_SHELL_RIG_H

#include "drain/shell.h"

typedef struct shell_rig {
    uint32_t node_count, own_count, triangle_count; /* own: without images */
    vec3 *rest, *x, *load;
    uint32_t (*triangles)[3], (*opposite)[3];
    double *widths;
    /* A node beyond a plane of symmetry moves as its master does, mirrored; others are their own. */
    uint32_t *master;
    vec3 *sign;
    bool (*held)[3];
    vbss_shell shell;
    vbss_shell_group *groups;
    vbss_shell_response *states;
    vec3 *forces;
    uint32_t pair_count;
    uint32_t (*pairs)[2]; /* nodes, the lower one first: rows */
    block *diagonal, *blocks;
} shell_rig;

/* ---- meshes (shell_mesh.c) */
typedef vec3 (*shell_rig_shape)(double u, double v, const void *user);
/* A grid of cells, each of two triangles; node `column (rows + 1) + row` is shape(column / columns,
 * row / rows), or column 0 again for the last one if it wraps. Outside is du x dv. `flipped`: the other
 * diagonal. */
void shell_rig_mesh(shell_rig *r, uint32_t columns, uint32_t rows, bool wraps, bool flipped,
                    shell_rig_shape shape, const void *user);
/* Continues the shell as its mirror image beyond the plane where a coordinate has that value; nodes
 * there stay there. */
void shell_rig_mirror(shell_rig *r, int axis, double value);
/* The input of the mesh with E = 1, nu = 0, t = 0.1, density 1, with the rule of free edges. */
vbss_shell_input shell_rig_input(const shell_rig *r);
void shell_rig_start(shell_rig *r, const vbss_shell_input *input);
void shell_rig_end(shell_rig *r);

/* ---- states (shell_solve.c) */
double shell_rig_energy(shell_rig *r); /* and states, forces */
void shell_rig_tangent(shell_rig *r);  /* diagonal, blocks, and forces */
/* The largest number of the tangent's diagonal; and the force that it makes of what rounding leaves of positions: what no
 * force can be told from zero by. Thin triangles are stiff. */
double shell_rig_stiffest(shell_rig *r);
double shell_rig_rounding(shell_rig *r);
/* Moves to equilibrium under the loads; returns the steps it took, at most `most`. One step is the linear
 * answer if it starts at rest. */
int shell_rig_solve(shell_rig *r, int limit);

#endif
