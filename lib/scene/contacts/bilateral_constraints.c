/* Bilateral constraints: the part that grasps and holes have in common. */
#include "scene/contacts/contacts.h"
#include "scene/world/world.h"

void vbss_scene_set_spring_geometry(const scene_object *s, contact_constraint *constraint,
                                    const scene_rigid *tool, vec3 current, vec3 target)
{
    pose jaws = vbss_scene_jaw_frame(tool, tool->trial);
    constraint->normal = quat_rotate(jaws.orientation, vec3_make(1.0, 0.0, 0.0));
    constraint->relative_displacement = vec3_sub(current, target);
    constraint->gap = vec3_dot(constraint->normal, constraint->relative_displacement);
    scene_geometry_of(s, constraint)->point = target;
    constraint->jacobian_block_count = 0;
    constraint->previous_force = constraint->solution.tangential_force = vec3_zero();
    constraint->solution.status = CONTACT_STICK;
}

contact_constraint *vbss_scene_add_bilateral_constraint(scene_object *s, const contact_key *key)
{
    contact_constraint *constraint = vbss_contact_add(s->contacts, key);
    if (constraint != NULL) {
        constraint->is_bilateral = true;
    }
    return constraint;
}
