/* Poses and capsules of rigid bodies: frames of needles and jaws, and axes of capsules now and
 * in the trial state. */
#include "scene/world/world.h"

void vbss_scene_transform_capsule(const scene_capsule *capsule, pose at, vec3 axis[2])
{
    axis[0] = pose_apply(at, capsule->local[0]);
    axis[1] = pose_apply(at, capsule->local[1]);
}

void vbss_scene_transform_trial_capsule(scene_capsule *capsule, pose at)
{
    capsule->trial[0] = pose_apply(at, capsule->local_trial[0]);
    capsule->trial[1] = pose_apply(at, capsule->local_trial[1]);
}

void vbss_scene_snap_capsule_to_target(scene_capsule *capsule)
{
    for (int k = 0; k < 2; k++) {
        capsule->local[k] = capsule->local_trial[k] = capsule->local_end[k];
    }
}

pose vbss_scene_needle_frame(const scene_rigid *r, pose principal)
{
    return pose_mul(principal, pose_inverse(r->frame));
}

pose vbss_scene_jaw_frame(const scene_rigid *r, pose principal)
{
    pose tool = pose_mul(principal, pose_inverse(r->frame));
    return pose_mul(tool, vbss_grasper_jaw_frame(r->grasper));
}
