/* Makes a mesh a posed one, and sets its motion. */
#include "base/error.h"
#include "collision/shapes.h"
#include "collision/tuning.h"

static void set_local_boxes(collision_shape *s, collision_posed *p)
{
    vec3 low = p->local[0], high = low;
    for (uint32_t i = 0; i < s->node_count; i++) {
        const vec3 x = p->local[i];
        low = vec3_make(vbss_min(low.x, x.x), vbss_min(low.y, x.y), vbss_min(low.z, x.z));
        high = vec3_make(vbss_max(high.x, x.x), vbss_max(high.y, x.y), vbss_max(high.z, x.z));
        s->point_bvh.boxes[i] =
            (collision_aabb){{x.x - s->inflation, x.y - s->inflation, x.z - s->inflation, 0.0},
                             {x.x + s->inflation, x.y + s->inflation, x.z + s->inflation, 0.0}};
    }
    p->centre = vec3_scale(vec3_add(low, high), 0.5);
    p->half = vec3_scale(vec3_sub(high, low), 0.5);
    p->reach = (1.0 + COLLISION_CUBE_PADDING) * (vec3_norm(p->centre) + vec3_norm(p->half));
    vbss_collision_shape_invalidate_trees(s);
    vbss_collision_shape_refit_points(s);
    vbss_collision_shape_refit_edges(s);
    vbss_collision_shape_refit_triangles(s);
    s->boxes_valid = true;
}

vbss_result vbss_collision_make_posed(collision_object *c, uint32_t id, const double *positions,
                                      const pose *frame, pose at)
{
    collision_shape *s = c->shapes[id];
    vbss_array arrays[COLLISION_POSED_ARRAYS];
    collision_posed *p = vbss_allocate(c->context, 1, sizeof *p, "posed mesh");
    if (p == NULL) {
        return VBSS_ERROR_OUT_OF_MEMORY;
    }
    vbss_collision_list_posed_arrays(s, p, arrays);
    const vbss_result result =
        vbss_allocate_arrays(c->context, arrays, COLLISION_POSED_ARRAYS, "posed mesh");
    if (result != VBSS_OK) {
        vbss_release_arrays(c->context, arrays, COLLISION_POSED_ARRAYS);
        vbss_release(c->context, p, 1, sizeof *p);
        return result;
    }
    for (uint32_t i = 0; i < s->node_count; i++) {
        const vec3 x = vec3_load(positions + 3 * (size_t)i);
        p->local[i] = frame != NULL ? pose_apply_inverse(*frame, x) : x;
    }
    p->start = p->end = at;
    p->extrapolation = 1.0;
    p->present_mark = 1;
    s->posed = p;
    s->is_rigid = true;
    set_local_boxes(s, p);
    vbss_collision_update_posed_box(s);
    return VBSS_OK;
}

static bool is_pose_finite(pose at)
{
    return vec3_is_finite(at.position) && quat_is_finite(at.orientation);
}

vbss_result vbss_collision_set_pose_motion(collision_object *c, uint32_t id, pose start, pose end,
                                           double extrapolation)
{
    collision_shape *s = c->shapes[id];
    if (!is_pose_finite(start) || !is_pose_finite(end)) {
        return vbss_fail(c->context, VBSS_ERROR_NOT_FINITE, "a pose of a mesh is not finite");
    }
    s->posed->start = start;
    s->posed->end = end;
    s->posed->extrapolation = extrapolation;
    vbss_collision_begin_posed_set(s);
    vbss_collision_clear_results(c); /* candidates of other positions would be incomplete */
    c->generation++;
    return VBSS_OK;
}
