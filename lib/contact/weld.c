/* Elimination of a node that is a point of a rigid body.
 *
 * u = dx + dtheta x arm, so the node's rows and columns are added to those of the body. If P maps
 * the remaining increments to all increments, the joined system is P^T S P. There is no penalty, so
 * the ratio of masses does not matter. */
#include "base/error.h"
#include "contact/contact.h"

/* ---- access to blocks as matrices: welds are few */

static mat3 read_block(const vbss_system *system, uint32_t row, uint32_t column)
{
    uint32_t schur_index = vbss_system_schur_index(system, row, column);
    return schur_index == VBSS_NO_INDEX ? mat3_zero()
                                        : block_mat3(&system->separator_blocks[schur_index]);
}

static void write_block(vbss_system *system, uint32_t row, uint32_t column, mat3 m)
{
    uint32_t schur_index = vbss_system_schur_index(system, row, column);
    if (schur_index != VBSS_NO_INDEX) {
        block_set(&system->separator_blocks[schur_index], m);
    }
}

static void add_block(vbss_system *system, uint32_t row, uint32_t column, mat3 m)
{
    write_block(system, row, column, mat3_add(read_block(system, row, column), m));
}

vbss_result vbss_contact_register_weld(const contact_weld *weld, vbss_system *system)
{
    for (uint32_t i = 0; i < weld->neighbour_count; i++) {
        uint32_t neighbour = weld->neighbours[i];
        if (neighbour == weld->translation || neighbour == weld->rotation) {
            continue; /* the body couples its own blocks */
        }
        VBSS_TRY(vbss_system_couple_separators(system, weld->translation, neighbour));
        VBSS_TRY(vbss_system_couple_separators(system, weld->rotation, neighbour));
    }
    return VBSS_OK;
}

void vbss_contact_eliminate_weld(const contact_weld *weld, vbss_system *system)
{
    const uint32_t s = weld->node, t = weld->translation, r = weld->rotation;
    const mat3 map = mat3_scale(mat3_cross(weld->arm), -1.0), map_transposed = mat3_transpose(map);
    for (uint32_t i = 0; i < weld->neighbour_count; i++) {
        uint32_t j = weld->neighbours[i];
        mat3 row = read_block(system, s, j), column = read_block(system, j, s);
        add_block(system, t, j, row);
        add_block(system, r, j, mat3_mul(map_transposed, row));
        add_block(system, j, t, column);
        add_block(system, j, r, mat3_mul(column, map));
        write_block(system, s, j, mat3_zero());
        write_block(system, j, s, mat3_zero());
    }
    mat3 diagonal = read_block(system, s, s);
    add_block(system, t, t, diagonal);
    add_block(system, t, r, mat3_mul(diagonal, map));
    add_block(system, r, t, mat3_mul(map_transposed, diagonal));
    add_block(system, r, r, mat3_mul(map_transposed, mat3_mul(diagonal, map)));
    write_block(system, s, s, mat3_identity());

    vec3 *node_rhs = &system->separator_rhs[vbss_system_schur_rhs_index(system, s)];
    vec3 *force = &system->separator_rhs[vbss_system_schur_rhs_index(system, t)];
    vec3 *torque = &system->separator_rhs[vbss_system_schur_rhs_index(system, r)];
    *force = vec3_add(*force, *node_rhs);
    *torque = vec3_add(*torque, mat3_mul_vec3(map_transposed, *node_rhs));
    *node_rhs = vec3_zero();
}

vec3 vbss_contact_weld_increment(const contact_weld *weld, const vbss_system *system)
{
    return vec3_add(system->solution[weld->translation],
                    vec3_cross(system->solution[weld->rotation], weld->arm));
}
