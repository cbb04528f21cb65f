/* Linear springs between separators, whose stiffness is stiffness gradient gradient^T. */
#include "base/error.h"
#include "contact/contact.h"

vbss_result vbss_contact_register_spring(const contact_spring *spring, vbss_system *system)
{
    for (uint32_t p = 0; p < spring->count; p++) {
        for (uint32_t q = p + 1; q < spring->count; q++) {
            VBSS_TRY(vbss_system_couple_separators(system, spring->blocks[p], spring->blocks[q]));
        }
    }
    return VBSS_OK;
}

void vbss_contact_find_spring_indices(contact_spring *spring, const vbss_system *system)
{
    const uint32_t n = spring->count;
    for (uint32_t p = 0; p < n; p++) {
        for (uint32_t q = p; q < n; q++) {
            vbss_system_schur_pair_indices(system, spring->blocks[p], spring->blocks[q],
                                           &spring->schur_indices[p * n + q],
                                           &spring->schur_indices[q * n + p]);
        }
    }
}

void vbss_contact_assemble_spring(const contact_spring *spring, vbss_system *system)
{
    const uint32_t n = spring->count;
    for (uint32_t p = 0; p < n; p++) {
        const lanes left = lanes_from(vec3_scale(spring->gradients[p], spring->stiffness));
        for (uint32_t q = 0; q < n; q++) {
            const uint32_t index = spring->schur_indices[p * n + q];
            const vec3 right = spring->gradients[q];
            if (index == VBSS_NO_INDEX) {
                continue; /* a prescribed node */
            }
            block *to = &system->separator_blocks[index];
            to->column[0] = lanes_add(to->column[0], lanes_scale(right.x, left));
            to->column[1] = lanes_add(to->column[1], lanes_scale(right.y, left));
            to->column[2] = lanes_add(to->column[2], lanes_scale(right.z, left));
        }
    }
}
