/* Indices of the constraints' blocks in the system, and assembly of their stiffness and forces. */
#include "base/error.h"
#include "contact/contact.h"

static bool is_separator(const vbss_system *system, uint32_t b)
{
    return system->roles[b] == VBSS_ROLE_SEPARATOR;
}

vbss_result vbss_contact_register(const contact_set *set, vbss_system *system)
{
    for (uint32_t i = 0; i < set->count; i++) {
        const contact_constraint *constraint = &set->constraints[i];
        for (uint32_t p = 0; p < constraint->jacobian_block_count; p++) {
            uint32_t a = constraint->jacobian[p].block;
            for (uint32_t q = p + 1;
                 is_separator(system, a) && q < constraint->jacobian_block_count; q++) {
                uint32_t b = constraint->jacobian[q].block;
                if (a != b && is_separator(system, b)) {
                    VBSS_TRY(vbss_system_couple_separators(system, a, b));
                }
            }
        }
    }
    return VBSS_OK;
}

void vbss_contact_assign_schur_offsets(contact_set *set)
{
    set->schur_index_count = 0;
    for (uint32_t i = 0; i < set->count; i++) {
        uint32_t n = set->constraints[i].jacobian_block_count;
        set->constraints[i].schur_offset = set->schur_index_count;
        set->schur_index_count += n * (n + 1);
    }
}

void vbss_contact_find_schur_indices(contact_set *set, const vbss_system *system)
{
    vbss_contact_assign_schur_offsets(set);
    for (uint32_t i = 0; i < set->count; i++) {
        const contact_constraint *constraint = &set->constraints[i];
        uint32_t n = constraint->jacobian_block_count,
                 *indices = set->schur_indices + constraint->schur_offset;
        for (uint32_t p = 0; p < n; p++) {
            for (uint32_t q = p; q < n; q++) {
                vbss_system_schur_pair_indices(system, constraint->jacobian[p].block,
                                               constraint->jacobian[q].block, &indices[p * n + q],
                                               &indices[q * n + p]);
            }
            indices[n * n + p] = vbss_system_schur_rhs_index(system, constraint->jacobian[p].block);
        }
    }
}

/* map_to_block of a rotation. */
static vec3 map_to_rotation(const contact_jacobian_block *term, vec3 direction)
{
    if (!term->is_roll) {
        return vec3_scale(vec3_cross(term->arm, direction), term->weight);
    }
    const double along = term->weight * vec3_dot(term->arm, direction);
    return vec3_make(term->component == 0 ? along : 0.0, term->component == 1 ? along : 0.0,
                     term->component == 2 ? along : 0.0);
}

/* The block's entry of the Jacobian along a direction, and transposed: the force on the block from
 * a force along it. */
static inline vec3 map_to_block(const contact_jacobian_block *term, vec3 direction)
{
    return term->is_rotation ? map_to_rotation(term, direction)
                             : vec3_scale(direction, term->weight);
}

/* Derivative of map_to_block's weights as the suture slides along the normal, per metre. */
static vec3 map_derivative_to_block(const contact_jacobian_block *term, vec3 direction)
{
    return term->is_rotation ? vec3_cross(term->weighted_arm_derivative, direction)
                             : vec3_scale(direction, term->weight_derivative);
}

static inline void add_product(block *to, vec3 left, vec3 right)
{
    lanes l = lanes_from(left);
    to->column[0] = lanes_add(to->column[0], lanes_scale(right.x, l));
    to->column[1] = lanes_add(to->column[1], lanes_scale(right.y, l));
    to->column[2] = lanes_add(to->column[2], lanes_scale(right.z, l));
}

static bool has_rotation(const contact_constraint *constraint)
{
    for (uint32_t k = 0; k < constraint->jacobian_block_count; k++) {
        if (constraint->jacobian[k].is_rotation) {
            return true;
        }
    }
    return false;
}

/* Stiffness from sliding along a curved suture.
 *
 * Sliding transfers the axial force to other nodes and rotates it. Without these terms a bend that
 * slides through the hole would look stiff, because its own tension rotates too. Where the
 * direction n of the suture changes, the transverse force f stays transverse and changes by -(f .
 * dn) n; this drives sliding as far as the hole does not stick.
 * The sum is the second derivative of the energy stiffness / 2 |point - hole|^2, minimised over all
 * points of the curve, except for terms of the relative order |point - hole| / segment length. Two
 * terms are left out because the active set converged less often with them (docs/explanation/stitch.md): the
 * rotation of friction as nodes move, and the rotation of f at a needle, since the bend at the
 * swage may be sharper than a segment. */
static void add_sliding_stiffness(const contact_constraint *constraint,
                                  const contact_linearisation *t, const uint32_t *schur_indices,
                                  vbss_system *system)
{
    const uint32_t n = constraint->jacobian_block_count;
    const double along = vec3_dot(t->force, constraint->normal);
    const vec3 across = vec3_add_scaled(t->force, -along, constraint->normal);
    const vec3 turned = vec3_scale(constraint->curvature, -along);
    const double slide_fraction =
        has_rotation(constraint) ? 0.0 : 1.0 - t->stiffness[0] / constraint->stiffness;
    const double curvature_force = slide_fraction * vec3_dot(across, constraint->curvature);
    for (uint32_t p = 0; p < n; p++) {
        const contact_jacobian_block *row_block = &constraint->jacobian[p];
        const vec3 row_direction = map_to_block(row_block, constraint->normal);
        const vec3 left =
            vec3_sub(map_to_block(row_block, turned), map_derivative_to_block(row_block, t->force));
        for (uint32_t q = 0; q < n; q++) {
            uint32_t schur_index = schur_indices[p * n + q];
            if (schur_index == VBSS_NO_INDEX) {
                continue;
            }
            block *to = &system->separator_blocks[schur_index];
            const contact_jacobian_block *column_block = &constraint->jacobian[q];
            const vec3 column_direction = map_to_block(column_block, constraint->normal);
            add_product(to, left, column_direction);
            add_product(to, row_direction,
                        vec3_add_scaled(vec3_scale(column_direction, curvature_force),
                                        -slide_fraction,
                                        map_derivative_to_block(column_block, across)));
        }
    }
}

/* Two threads that slide over each other: the contact force moves along both threads, to other nodes. With the force of
 * each solve the active set would converge less often; that of the last linearisation differs by second order. */
static void add_point_motion(const contact_constraint *constraint, const uint32_t *schur_indices,
                             vbss_system *system)
{
    const uint32_t n = constraint->jacobian_block_count;
    for (uint32_t p = 0; p < n; p++) {
        const contact_jacobian_block *row_block = &constraint->jacobian[p];
        const vec3 left = vec3_scale(constraint->sliding_force, -row_block->weight_derivative),
                   gradient = constraint->slide_gradients[row_block->is_on_side_b];
        const uint32_t rhs = schur_indices[n * n + p];
        if (row_block->weight_derivative == 0.0) {
            continue;
        }
        for (uint32_t q = 0; q < n; q++) {
            uint32_t schur_index = schur_indices[p * n + q];
            /* The threads do not cross elsewhere because they roll. */
            if (schur_index != VBSS_NO_INDEX && !constraint->jacobian[q].is_roll) {
                add_product(&system->separator_blocks[schur_index], left,
                            map_to_block(&constraint->jacobian[q], gradient));
            }
        }
        if (rhs != VBSS_NO_INDEX) {
            vec3 *f = &system->separator_rhs[rhs];
            *f = vec3_add_scaled(*f, constraint->slide_leads[row_block->is_on_side_b], left);
        }
    }
}

static void add_constraint(const contact_set *set, const contact_constraint *constraint,
                           vbss_system *system)
{
    contact_linearisation t;
    uint32_t n = constraint->jacobian_block_count;
    const uint32_t *schur_indices = set->schur_indices + constraint->schur_offset;
    vec3 left[3][CONTACT_MAX_JACOBIAN_BLOCKS], right[3][CONTACT_MAX_JACOBIAN_BLOCKS];
    vbss_contact_linearise(constraint, &t);
    if (t.count == 0) {
        return;
    }
    for (uint32_t p = 0; p < n; p++) {
        uint32_t rhs = schur_indices[n * n + p];
        for (uint32_t d = 0; d < t.count; d++) {
            left[d][p] =
                vec3_scale(map_to_block(&constraint->jacobian[p], t.left[d]), t.stiffness[d]);
            right[d][p] = map_to_block(&constraint->jacobian[p], t.right[d]);
        }
        if (rhs != VBSS_NO_INDEX) {
            vec3 *f = &system->separator_rhs[rhs];
            *f = vec3_add(*f, map_to_block(&constraint->jacobian[p], t.force));
        }
    }
    for (uint32_t p = 0; p < n; p++) {
        for (uint32_t q = 0; q < n; q++) {
            uint32_t schur_index = schur_indices[p * n + q];
            for (uint32_t d = 0; schur_index != VBSS_NO_INDEX && d < t.count; d++) {
                add_product(&system->separator_blocks[schur_index], left[d][p], right[d][q]);
            }
        }
    }
    if (constraint->is_sliding) {
        add_point_motion(constraint, schur_indices, system);
    }
    if (constraint->is_sleeve) {
        add_sliding_stiffness(constraint, &t, schur_indices, system);
    }
}

void vbss_contact_assemble(const contact_set *set, vbss_system *system)
{
    for (uint32_t i = 0; i < set->count; i++) {
        add_constraint(set, &set->constraints[i], system);
    }
}
