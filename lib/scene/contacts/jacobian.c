/* Jacobian blocks of a constraint for nodes, welded nodes and points of rigid bodies. */
#include "scene/contacts/contacts.h"
#include "scene/world/world.h"

void vbss_scene_add_jacobian_block(contact_constraint *constraint, uint32_t b, double weight)
{
    contact_jacobian_block *term = &constraint->jacobian[constraint->jacobian_block_count++];
    *term = (contact_jacobian_block){.block = b, .weight = weight};
}

void vbss_scene_add_rigid_jacobian(contact_constraint *constraint, const scene_rigid *r, vec3 point,
                                   double weight)
{
    contact_jacobian_block *term = &constraint->jacobian[constraint->jacobian_block_count + 1];
    vbss_scene_add_jacobian_block(constraint, r->blocks.first, weight);
    *term = (contact_jacobian_block){.block = r->blocks.first + 1,
                                     .is_rotation = true,
                                     .weight = weight,
                                     .arm = vec3_sub(point, r->trial.position)};
    constraint->jacobian_block_count++;
}

void vbss_scene_add_node_jacobian(const scene_object *s, contact_constraint *constraint,
                                  const scene_body *b, uint32_t node, double weight)
{
    const scene_pin *weld =
        b->thread.thread->welded[node] != 0 ? vbss_scene_find_weld(s, b->number, node) : NULL;
    if (weld == NULL) {
        vbss_scene_add_jacobian_block(constraint, b->thread.first_block + node, weight);
        return;
    }
    const scene_rigid *r = &vbss_scene_body(s, weld->body)->rigid;
    vbss_scene_add_rigid_jacobian(constraint, r, pose_apply(r->trial, weld->point), weight);
}
