/* Thin shell of triangles without rotational unknowns: the assumed-strain patch element EBST
 * (Flores, Onate 2005; Onate, Flores 2005), docs/explanation/drain-shell.md.
 *
 * A patch is a triangle with nodes 0 1 2, counter-clockwise from outside, and the opposite nodes 3
 * 4 5 of its neighbours across the edges opposite to nodes 0 1 2. A group has four patches side by
 * side in lanes. A shell holds constants only: all results follow from the positions that the
 * caller gives. */
#ifndef VBSS_DRAIN_SHELL_H
#define VBSS_DRAIN_SHELL_H

#include <vblast_ss/base.h>

#include "base/lanes.h"
#include "base/linear.h"
#include "base/simd_dispatch.h"
#include "solver/block.h"

enum {
    SHELL_NODES = 6,
    SHELL_PAIRS = 15, /* pairs of different nodes of a patch: 01 02 .. 05 12 .. 45 */
};

/* The node beyond a side that is free. */
#define SHELL_NONE UINT32_MAX

typedef struct vbss_shell_input {
    uint32_t node_count, triangle_count;
    const vec3 *rest;
    const uint32_t (*triangles)[3]; /* counter-clockwise from outside */
    /* Node beyond the edge opposite to corner i, or SHELL_NONE. */
    const uint32_t (*opposite_node)[3];
    /* Angle that a triangle spans about the axis of its tube, rad. It raises the bending stiffness
     * to that of an ovalling ring; 0 does not. NULL: all 0. */
    const double *angular_widths;
    double young, thickness, density; /* Pa, m, kg/m^3 */
    /* Per triangle, in place of young and thickness; NULL: these. */
    const double *triangle_young, *triangle_thickness;
    double poisson;         /* 0..0.5 */
    bool moment_free_edges; /* no bending moment across free edges; false only for comparison */
} vbss_shell_input;

/* Four patches. Lanes come first and all sizes are multiples of 32 bytes, so that both copies of
 * the hot loops see one layout. */
typedef struct vbss_shell_group {
    /* Gradients of the tangents at the middle of edge s with nodes 1, 2, 3 + s, relative to node 0.
     * They are divided by sqrt 3, so that sums over the edges are means. */
    lanes gradient[3][3][2];
    lanes metric[3]; /* at rest: 11, 22, 12 */
    lanes height[3]; /* at rest: heights of nodes 3 4 5 above the triangle's plane, m */
    /* Square roots of membrane stiffness times area, for e11 + e22, and for e11 - e22 or 2 e12. */
    lanes root_sum, root_shear;
    lanes bending_stiffness[6];    /* bending stiffness between heights: 33 44 55 34 35 45 */
    lanes transposed[SHELL_PAIRS]; /* 1: the block of the pair is added transposed */

    /* for responses only */
    /* curvature 11, 22, 2 12 for a unit height of nodes 3 4 5 */
    lanes curvature_per_height[3][3];
    lanes plate_stiffness[6]; /* moments per curvature: 11 22 33 12 13 23 */
    lanes area;               /* at rest, m^2 */
    lanes mass;               /* mass of one corner, kg */

    /* Beyond a free edge: node 0, with zero constants. */
    uint32_t node[SHELL_NODES][LANES];
    uint32_t block_index[SHELL_PAIRS][LANES]; /* block that the pair is added to */
    uint32_t free_edges[LANES];               /* bit s: edge s is free */
} vbss_shell_group;
_Static_assert(sizeof(vbss_shell_group) % sizeof(lanes) == 0 && sizeof(lanes) == 32,
               "the same layout whatever a register holds");

typedef struct vbss_shell {
    uint32_t triangle_count, group_count;
    vbss_shell_group *groups;
    bool wide; /* uses the AVX2 copy of the hot loops */
} vbss_shell;

/* ---- shell_patch.c */

/* Number of groups for this many triangles. */
uint32_t vbss_shell_group_count(uint32_t triangle_count);

/* Initialises a shell. The caller provides memory for the groups, aligned as the context's memory
 * is, and keeps it. VBSS_ERROR_OUT_OF_RANGE: a triangle without area, or folded over against a
 * neighbour at rest; a patch that contains a node twice (inside the shell more than three triangles
 * must meet at each node); or an angular width above 1.6. */
vbss_result vbss_shell_init(vbss_context *context, const vbss_shell_input *input,
                            vbss_shell_group *groups, vbss_shell *shell);

/* Adds a third of each triangle's mass to each of its corners, kg. */
void vbss_shell_add_masses(const vbss_shell *shell, double *masses);

/* The two nodes of a pair of a patch. Its block has the rows of the first node. False: the second
 * node is beyond a free edge and the block is zero; its block index has to be 0. */
bool vbss_shell_pair_nodes(const vbss_shell *shell, uint32_t triangle, uint32_t pair, uint32_t *row,
                           uint32_t *column);

/* Sets the block that each pair is added to. pair_codes[triangle][pair] is twice an index into
 * block_codes, plus 1 if the block is to be transposed once more. block_codes holds twice an index
 * into the blocks of vbss_shell_assemble, plus 1 if transposed. Block 0 takes zeros and pairs
 * without a map; it must exist and serve nothing else. */
void vbss_shell_set_assembly_map(vbss_shell *shell, const uint32_t (*pair_codes)[SHELL_PAIRS],
                                 const uint32_t *block_codes);

/* ---- hot loops (shell_force.c, shell_tangent.c): x, forces and diagonal are indexed by node */

/* Adds the forces, N: minus the exact gradient of the energy. */
void vbss_shell_add_forces(const vbss_shell *shell, const vec3 *x, vec3 *forces);

/* Adds the same forces, bit for bit, and the tangent. It is symmetric and positive semi-definite,
 * and exact if no stress is compressive and curvatures are those at rest. */
void vbss_shell_assemble(const vbss_shell *shell, const vec3 *x, vec3 *forces, block *diagonal,
                         block *blocks);

/* ---- responses (shell_response.c) */

/* Response of a triangle. Components 11, 22, 12 refer to a frame that is carried along: at rest
 * axis 1 points from corner 0 to corner 1, and axis 2 to the left of it in the triangle's plane. */
typedef struct vbss_shell_response {
    /* strain of the middle surface, with 2 e12; curvature relative to rest, with 2 k12, 1/m */
    double strain[3], curvature[3];
    double membrane_force[3], bending_moment[3]; /* N/m; N */
    double membrane_energy, bending_energy;      /* J */
    bool is_inverted;
} vbss_shell_response;

/* Whether a triangle is inverted or collapsed. Inverted: the tangents at the middle of an edge
 * span an area that points against the triangle. Collapsed: its area is at most a hundredth of
 * that at rest. */
bool vbss_shell_is_inverted(const vbss_shell *shell, uint32_t triangle, const vec3 *x);

/* Computes the responses of all triangles with the nodes at `x`. */
void vbss_shell_compute_responses(const vbss_shell *shell, const vec3 *x,
                                  vbss_shell_response *responses);

/* Elastic energy of all triangles with the nodes at `x`, J. */
double vbss_shell_energy(const vbss_shell *shell, const vec3 *x);

/* ---- both copies of the hot loops */
void vbss_shell_add_forces_plain(const vbss_shell *shell, const vec3 *x, vec3 *forces);
void vbss_shell_add_forces_wide(const vbss_shell *shell, const vec3 *x, vec3 *forces);
void vbss_shell_assemble_plain(const vbss_shell *shell, const vec3 *x, vec3 *forces,
                               block *diagonal, block *blocks);
void vbss_shell_assemble_wide(const vbss_shell *shell, const vec3 *x, vec3 *forces, block *diagonal,
                              block *blocks);

#endif
