/* Thin shells of triangles without rotational unknowns: the assumed-strain patch triangle EBST (Flores,
 * Onate 2005; Onate, Flores 2005), docs/drain-shell.md.
 *
 * A patch is a triangle, nodes 0 1 2 counter-clockwise from outside, and its neighbours' far nodes 3 4 5
 * across the sides opposite nodes 0 1 2. Four patches make a group, side by side in lanes. A shell holds
 * constants only: what it computes follows from the positions that are given. */
#ifndef VBSS_DRAIN_SHELL_H
#define VBSS_DRAIN_SHELL_H

#include <vblast_ss/base.h>

#include "base/lanes.h"
#include "base/linear.h"
#include "base/simd_dispatch.h"
#include "solver/block.h"

enum {
    SHELL_NODES = 6,
    SHELL_PAIRS = 15, /* of different nodes of a patch: 01 02 .. 05 12 .. 45 */
};
/* The node beyond a side that is free. */
#define SHELL_NONE UINT32_MAX

typedef struct vbss_shell_input {
    uint32_t node_count, triangle_count;
    const vec3 *rest;
    const uint32_t (*triangles)[3];     /* counter-clockwise from outside */
    const uint32_t (*opposite_node)[3]; /* node beyond the side opposite corner i, or SHELL_NONE */
    /* The angle (rad) a triangle spans around its tube: its bending stiffness is raised to what an
     * ovalling ring has; 0 leaves it. NULL: all 0. */
    const double *angular_widths;
    double young, thickness, density; /* Pa, m, kg/m^3 */
    double poisson;                   /* 0 .. 0.5 */
    bool moment_free_edges; /* no bending moment across free sides: off for comparison only */
} vbss_shell_input;

/* Four patches. Lanes come first and all sizes are multiples of 32 bytes: both copies of the hot loops
 * see the same layout. */
typedef struct vbss_shell_group {
    /* The tangents at the middle of side s are those of node 1, 2, 3 + s, from node 0: gradients over
     * sqrt 3, so that sums over the sides are means. */
    lanes gradient[3][3][2];
    lanes metric[3]; /* at rest: 11, 22, 12 */
    lanes height[3]; /* at rest: of nodes 3 4 5 over the triangle's plane */
    /* Roots of membrane stiffness times area, against e11 + e22 and against e11 - e22 or 2 e12. */
    lanes root_sum, root_shear;
    lanes bending_stiffness[6];    /* bending stiffness between heights: 33 44 55 34 35 45 */
    lanes transposed[SHELL_PAIRS]; /* 1: the pair's block goes there transposed */

    /* for measuring only */
    lanes curvature_per_height[3][3]; /* curvature 11, 22, 2 12 of a unit height of nodes 3 4 5 */
    lanes plate_stiffness[6];         /* moments of curvatures: 11 22 33 12 13 23 */
    lanes area;                       /* at rest */
    lanes mass;                       /* of a corner */

    uint32_t node[SHELL_NODES][LANES];        /* beyond a free side: node 0, with zero constants */
    uint32_t block_index[SHELL_PAIRS][LANES]; /* of a pair's block */
    uint32_t free_edges[LANES];               /* bit s: nothing beyond side s */
} vbss_shell_group;
_Static_assert(sizeof(vbss_shell_group) % sizeof(lanes) == 0 && sizeof(lanes) == 32,
               "the same layout whatever a register holds");

typedef struct vbss_shell {
    uint32_t triangle_count, group_count;
    vbss_shell_group *groups;
    bool wide; /* hot loops with AVX2 */
} vbss_shell;

/* ---- making one (shell_patch.c)
 *
 * The caller brings room for the groups, aligned as the context's memory is, and keeps it. A triangle
 * without area or turned over against a neighbour at rest, a patch that has a node twice (inside the shell
 * more than three triangles meet at each node) and widths beyond 1.6 are VBSS_ERROR_OUT_OF_RANGE. */
uint32_t vbss_shell_group_count(uint32_t triangle_count);
vbss_result vbss_shell_init(vbss_context *context, const vbss_shell_input *input,
                            vbss_shell_group *groups, vbss_shell *shell);
/* A third of each triangle's mass to each of its corners. */
void vbss_shell_add_masses(const vbss_shell *shell, double *masses);

/* The nodes of a pair of a patch. Its block has the rows of the pair's first node. False:
 * the pair's second node lies beyond a free side, the block is zero, and its place has to be 0. */
bool vbss_shell_pair_nodes(const vbss_shell *shell, uint32_t triangle, uint32_t pair, uint32_t *row,
                           uint32_t *column);
/* A pair's block goes to blocks[place], as it is or transposed. Targets are twice a place, and 1 more for transposed;
 * numbers[triangle][pair] is twice the number of a target, and 1 more if the block is to go there the other way round.
 * Place 0 takes what was never aimed, and zeros: it must be there, and hold nothing else. */
void vbss_shell_set_assembly_map(vbss_shell *shell, const uint32_t (*pair_codes)[SHELL_PAIRS],
                                 const uint32_t *block_codes);

/* ---- the hot loops (shell_force.c, shell_tangent.c), forces, diagonal and x by node */

/* Adds the forces: minus the exact slope of the energy. */
void vbss_shell_add_forces(const vbss_shell *shell, const vec3 *x, vec3 *forces);
/* Adds the forces, to the same bits, and the tangent: symmetric, positive semi-definite; exact where no
 * stress is compressive and curvatures are those of rest. */
void vbss_shell_assemble(const vbss_shell *shell, const vec3 *x, vec3 *forces, block *diagonal,
                         block *blocks);

/* ---- measuring (shell_response.c). Components 11, 22, 12 in a frame that is carried along: axis 1 ran
 * from corner 0 to corner 1 at rest, axis 2 to the left of it in the triangle's plane. */
typedef struct vbss_shell_response {
    double strain[3], curvature[3]; /* mid-surface, with 2 e12; 1/m against rest, with 2 k12 */
    double membrane_force[3], bending_moment[3]; /* N/m; N */
    double membrane_energy, bending_energy;
    bool is_inverted;
} vbss_shell_response;
/* Turned over: the tangents at the middle of a side span an area that points against the triangle; or
 * collapsed: its area is a hundredth of what it was at rest or less. */
bool vbss_shell_is_inverted(const vbss_shell *shell, uint32_t triangle, const vec3 *x);
void vbss_shell_compute_responses(const vbss_shell *shell, const vec3 *x,
                                  vbss_shell_response *responses);
/* Of all triangles, J. */
double vbss_shell_energy(const vbss_shell *shell, const vec3 *x);

/* Both copies of the hot loops. */
void vbss_shell_add_forces_plain(const vbss_shell *shell, const vec3 *x, vec3 *forces);
void vbss_shell_add_forces_wide(const vbss_shell *shell, const vec3 *x, vec3 *forces);
void vbss_shell_assemble_plain(const vbss_shell *shell, const vec3 *x, vec3 *forces,
                               block *diagonal, block *blocks);
void vbss_shell_assemble_wide(const vbss_shell *shell, const vec3 *x, vec3 *forces, block *diagonal,
                              block *blocks);

#endif
