/* Forces and tangent of a shell, in groups of four patches.
 *
 * With the gradients B of the strains, the tensile part S+ of the stress, and the gradients w_i n
 * of the heights,
 *
 *   K_ij = B_i^T C B_j + sum over edges (gradient_i S+ gradient_j) I
 *          + (w_i bending_stiffness w_j) n n^T
 *
 * This is the exact second derivative without compressive stress and without the rotation of the
 * normal. Each term is positive semi-definite. */
#include "drain/shell_strain.h"

/* Tensile part of a symmetric stress 11, 22, 12, which is q I + (p - q) times a projection, with
 * principal stresses p >= q. */
static inline void keep_tensile_part(lanes stress[3])
{
    lanes zero = lanes_splat(0.0), half = lanes_splat(0.5);
    lanes mean = lanes_times(half, lanes_add(stress[0], stress[1]));
    lanes apart = lanes_times(half, lanes_sub(stress[0], stress[1]));
    lanes radius =
        lanes_sqrt(lanes_add(lanes_times(apart, apart), lanes_times(stress[2], stress[2])));
    lanes low = lanes_sub(mean, radius);
    lanes tensile_high = lanes_max(lanes_add(mean, radius), zero),
          tensile_low = lanes_max(low, zero);
    /* 1 if both principal stresses are kept */
    lanes twice = lanes_max(lanes_add(radius, radius), lanes_splat(1e-150));
    lanes fraction = lanes_div(lanes_sub(tensile_high, tensile_low), twice);
    stress[0] = lanes_add(tensile_low, lanes_times(fraction, lanes_sub(stress[0], low)));
    stress[1] = lanes_add(tensile_low, lanes_times(fraction, lanes_sub(stress[1], low)));
    stress[2] = lanes_times(fraction, stress[2]);
}

/* ---- factors of the blocks: for nodes 1 .. 5 first, then the remainder for node 0 */

typedef struct patch_factors {
    /* gradients of e11 + e22, e11 - e22, 2 e12, times the square roots */
    vlanes strain[SHELL_NODES][3];
    lanes isotropic[SHELL_NODES][SHELL_NODES]; /* coefficients of I, i <= j */
    lanes bending[SHELL_NODES][SHELL_NODES];   /* coefficients of n n^T, i <= j */
} patch_factors;

static inline void set_strain_gradients(const vbss_shell_group *g, const shell_shape *p,
                                        patch_factors *f)
{
    for (int s = 0; s < 3; s++) {
        const vlanes *t = p->tangent[s];
        for (int k = 0; k < 3; k++) {
            lanes along_1 = g->gradient[s][k][0], along_2 = g->gradient[s][k][1];
            vlanes own[3] = {v_scale(t[0], along_1), v_scale(t[1], along_2),
                             v_add_scaled(v_scale(t[1], along_1), along_2, t[0])};
            vlanes *to = f->strain[k < 2 ? 1 + k : 3 + s];
            for (int row = 0; row < 3; row++) {
                to[row] = s == 0 || k == 2 ? own[row] : v_add(to[row], own[row]);
            }
        }
    }
    for (int n = 1; n < SHELL_NODES; n++) {
        vlanes *to = f->strain[n], e11 = to[0], e22 = to[1];
        to[0] = v_scale(v_add(e11, e22), g->root_sum);
        to[1] = v_scale(v_sub(e11, e22), g->root_shear);
        to[2] = v_scale(to[2], g->root_shear);
    }
}

/* An edge couples the corners and its opposite node. Opposite nodes of different edges are
 * not coupled. */
static inline void set_isotropic(const vbss_shell_group *g, const lanes stress[3], patch_factors *f)
{
    for (int s = 0; s < 3; s++) {
        const int node[3] = {1, 2, 3 + s};
        for (int l = 0; l < 3; l++) {
            const lanes *gradient = g->gradient[s][l];
            lanes traction_1 =
                lanes_add(lanes_times(stress[0], gradient[0]), lanes_times(stress[2], gradient[1]));
            lanes traction_2 =
                lanes_add(lanes_times(stress[2], gradient[0]), lanes_times(stress[1], gradient[1]));
            for (int k = 0; k <= l; k++) {
                lanes own = lanes_add(lanes_times(g->gradient[s][k][0], traction_1),
                                      lanes_times(g->gradient[s][k][1], traction_2));
                lanes *to = &f->isotropic[node[k]][node[l]];
                *to = s == 0 || l == 2 ? own : lanes_add(*to, own);
            }
        }
    }
    f->isotropic[3][4] = f->isotropic[3][5] = f->isotropic[4][5] = lanes_splat(0.0);
}

/* A height grows by 1 with its own node and by -foot with a corner. */
static inline void set_bending(const vbss_shell_group *g, lanes foot[3][3], patch_factors *f)
{
    static const int symmetric_index[3][3] = {{0, 3, 4}, {3, 1, 5}, {4, 5, 2}};
    lanes stiffness_foot[3][3];
    for (int m = 0; m < 3; m++) {
        const lanes bend[3] = {g->bending_stiffness[symmetric_index[m][0]],
                               g->bending_stiffness[symmetric_index[m][1]],
                               g->bending_stiffness[symmetric_index[m][2]]};
        for (int i = 1; i < 3; i++) {
            stiffness_foot[m][i] = lanes_add(
                lanes_add(lanes_times(bend[0], foot[0][i]), lanes_times(bend[1], foot[1][i])),
                lanes_times(bend[2], foot[2][i]));
            f->bending[i][3 + m] = lanes_sub(lanes_splat(0.0), stiffness_foot[m][i]);
        }
        for (int k = m; k < 3; k++) {
            f->bending[3 + m][3 + k] = g->bending_stiffness[symmetric_index[m][k]];
        }
    }
    for (int i = 1; i < 3; i++) {
        for (int j = i; j < 3; j++) {
            f->bending[i][j] = lanes_add(lanes_add(lanes_times(foot[0][i], stiffness_foot[0][j]),
                                                   lanes_times(foot[1][i], stiffness_foot[1][j])),
                                         lanes_times(foot[2][i], stiffness_foot[2][j]));
        }
    }
}

/* Sets row 0 so that a common translation of all six nodes has no effect. */
static inline void complete_row_sums(lanes of[SHELL_NODES][SHELL_NODES])
{
    lanes own = lanes_splat(0.0);
    for (int j = 1; j < SHELL_NODES; j++) {
        lanes sum = lanes_splat(0.0);
        for (int i = 1; i < SHELL_NODES; i++) {
            sum = lanes_sub(sum, i <= j ? of[i][j] : of[j][i]);
        }
        of[0][j] = sum;
        own = lanes_sub(own, sum);
    }
    of[0][0] = own;
}

static inline void complete_factors(patch_factors *f)
{
    for (int row = 0; row < 3; row++) {
        vlanes sum = f->strain[1][row];
        for (int n = 2; n < SHELL_NODES; n++) {
            sum = v_add(sum, f->strain[n][row]);
        }
        f->strain[0][row] = v_scale(sum, lanes_splat(-1.0));
    }
    complete_row_sums(f->isotropic);
    complete_row_sums(f->bending);
}

/* ---- blocks */

/* Four blocks, by rows. */
typedef struct patch_block {
    lanes at[9];
} patch_block;

static inline vlanes block_row(lanes u0, lanes u1, lanes u2, lanes along, const vlanes v[3],
                               const vlanes *normal)
{
    vlanes row = v_add_scaled(v_scale(v[0], u0), u1, v[1]);
    return v_add_scaled(v_add_scaled(row, u2, v[2]), along, *normal);
}

static inline void set_block(const patch_factors *f, const vlanes *normal, int i, int j,
                             patch_block *b)
{
    const vlanes *u = f->strain[i], *v = f->strain[j];
    vlanes along = v_scale(*normal, f->bending[i][j]);
    vlanes x = block_row(u[0].x, u[1].x, u[2].x, along.x, v, normal);
    vlanes y = block_row(u[0].y, u[1].y, u[2].y, along.y, v, normal);
    vlanes z = block_row(u[0].z, u[1].z, u[2].z, along.z, v, normal);
    b->at[0] = lanes_add(x.x, f->isotropic[i][j]);
    b->at[1] = x.y;
    b->at[2] = x.z;
    b->at[3] = y.x;
    b->at[4] = lanes_add(y.y, f->isotropic[i][j]);
    b->at[5] = y.z;
    b->at[6] = z.x;
    b->at[7] = z.y;
    b->at[8] = lanes_add(z.z, f->isotropic[i][j]);
}

/* A diagonal block is symmetric to the bit. */
static inline void symmetrise_block(patch_block *b)
{
    b->at[3] = b->at[1];
    b->at[6] = b->at[2];
    b->at[7] = b->at[5];
}

/* Adds four blocks, one for each lane. */
static inline void add_blocks(const patch_block *four, block *const to[LANES])
{
    for (int c = 0; c < 3; c++) {
        lanes own[LANES];
        lanes_transpose(four->at[c], four->at[3 + c], four->at[6 + c], own);
        for (int lane = 0; lane < LANES; lane++) {
            to[lane]->column[c] = lanes_add(to[lane]->column[c], own[lane]);
        }
    }
}

static inline void transpose_lanes(patch_block *four, lanes_mask transposed)
{
    static const int entry[3][2] = {{1, 3}, {2, 6}, {5, 7}};
    for (int k = 0; k < 3; k++) {
        lanes upper = four->at[entry[k][0]], lower = four->at[entry[k][1]];
        four->at[entry[k][0]] = lanes_select(transposed, lower, upper);
        four->at[entry[k][1]] = lanes_select(transposed, upper, lower);
    }
}

static void add_tangent(const vbss_shell_group *g, const patch_factors *f, const vlanes *normal,
                        block *diagonal, block *blocks)
{
    patch_block four;
    block *to[LANES];
    int pair = 0;
    for (int i = 0; i < SHELL_NODES; i++) {
        for (int lane = 0; lane < LANES; lane++) {
            to[lane] = &diagonal[g->node[i][lane]];
        }
        set_block(f, normal, i, i, &four);
        symmetrise_block(&four);
        add_blocks(&four, to);
        for (int j = i + 1; j < SHELL_NODES; j++, pair++) {
            for (int lane = 0; lane < LANES; lane++) {
                to[lane] = &blocks[g->block_index[pair][lane]];
            }
            set_block(f, normal, i, j, &four);
            transpose_lanes(&four, lanes_less(lanes_splat(0.5), g->transposed[pair]));
            add_blocks(&four, to);
        }
    }
}

void VBSS_WIDE_NAME(vbss_shell_assemble)(const vbss_shell *shell, const vec3 *x, vec3 *forces,
                                         block *diagonal, block *blocks)
{
    for (uint32_t k = 0; k < shell->group_count; k++) {
        const vbss_shell_group *g = &shell->groups[k];
        int used = shell_lanes_used(shell, k);
        shell_shape shape;
        lanes stress[3], bending_gradient[3], foot[3][3];
        vlanes force[SHELL_NODES];
        patch_factors factors;
        shell_set_shape(g, x, &shape);
        shell_set_stress(g, &shape, stress);
        shell_set_bending_gradient(g, &shape, bending_gradient);
        shell_set_feet(&shape, foot);
        shell_set_forces(g, &shape, stress, bending_gradient, foot, force);
        shell_scatter_forces(g, used, force, forces);

        keep_tensile_part(stress);
        set_strain_gradients(g, &shape, &factors);
        set_isotropic(g, stress, &factors);
        set_bending(g, foot, &factors);
        complete_factors(&factors);
        add_tangent(g, &factors, &shape.normal, diagonal, blocks);
    }
}
