/* Makes holes for hosts, and describes the holes of a scene to them. */
#include "base/api_call.h"
#include "base/check.h"
#include "base/error.h"
#include "base/number_text.h"
#include "scene/api/api.h"
#include "scene/tissue/tissue.h"
#include "scene/tuning.h"
#include "scene/world/method.h"
#include "scene/world/world.h"

#include <string.h>

vbss_result vbss_scene_check_weights(vbss_context *context, const double *weights)
{
    double sum = 0.0;
    VBSS_TRY(vbss_check_pointer(context, weights, "weights"));
    VBSS_TRY(vbss_check_finite(context, weights, 3, "weights"));
    for (int k = 0; k < 3; k++) {
        VBSS_TRY(vbss_check_range(context, weights[k], 0.0, 1.0, "weights"));
        sum += weights[k];
    }
    return vbss_check_range(context, sum, 1.0 - SCENE_WEIGHT_ROUNDING, 1.0 + SCENE_WEIGHT_ROUNDING,
                            "the sum of weights");
}

static vbss_result check_suture(const scene_object *s, uint32_t body, double arc_length,
                                scene_body **found)
{
    VBSS_TRY(vbss_scene_require_any_body(s, body, found));
    const scene_body *suture = *found;
    if (!vbss_scene_is_suture(suture)) {
        return vbss_fail(s->context, VBSS_ERROR_INCOMPATIBLE, "body %u is no needle or thread",
                         body);
    }
    bool thread = suture->kind == SCENE_BODY_THREAD;
    const thread_object *t = suture->thread.thread;
    if (thread && !suture_is_curve(t)) {
        return vbss_fail(s->context, VBSS_ERROR_INCOMPATIBLE, "a thread of two nodes has no curve");
    }
    double length = thread ? vbss_thread_arc_length(t, t->node_count - 1)
                           : vbss_needle_length(suture->rigid.needle);
    VBSS_TRY(vbss_check_finite(s->context, &arc_length, 1, "arc_length"));
    return vbss_check_range(s->context, arc_length, 0.0, length, "arc_length");
}

double vbss_scene_suture_radius(const scene_body *suture)
{
    return suture->kind == SCENE_BODY_THREAD ? suture->thread.thread->config.radius
                                             : suture->rigid.needle->config.wire_radius;
}

/* The suture must pass through the hole already: no farther from it than the contact distance to
 * the wall. */
static vbss_result init_hole(const scene_object *s, suture_hole *hole, const scene_body *suture)
{
    const scene_hole_context p = vbss_scene_get_hole_context(s, hole);
    const vec3 point = vbss_hole_point(hole, &p.wall, p.wall.now);
    const suture_curve_point curve_point = vbss_suture_nearest_point(&p.now, p.arc, point);
    double offset = vec3_distance(curve_point.position, point);
    double max_offset = vbss_scene_suture_radius(suture) + 0.5 * p.wall.law->thickness;
    if (!(offset <= max_offset)) {
        return vbss_fail(s->context, VBSS_ERROR_OUT_OF_RANGE,
                         "the hole is %s m from what shall be in it: at most %s",
                         VBSS_NUMBER(offset), VBSS_NUMBER(max_offset));
    }
    hole->is_outward = vbss_suture_is_outward(&p.wall, hole->triangle, curve_point.tangent);
    vbss_scene_move_hole_to(hole, &p, curve_point.arc);
    return VBSS_OK;
}

/* Refuses a hole at the place of another of the same suture: their frictions would add up. They are
 * at one place if they are less than the suture's diameter apart, in the wall and along the suture. */
static vbss_result check_place(const scene_object *s, const suture_hole *made,
                               const scene_body *suture)
{
    const scene_hole_context p = vbss_scene_get_hole_context(s, made);
    const double diameter = 2.0 * vbss_scene_suture_radius(suture);
    for (uint32_t i = 0; i < s->config.hole_capacity; i++) {
        const suture_hole *other = &s->holes[i];
        if (other->id == 0 || other->wall != made->wall) {
            continue;
        }
        const scene_hole_context q = vbss_scene_get_hole_context(s, other);
        bool is_same_suture = (p.thread != NULL && p.thread == q.thread) ||
                              (p.needle != NULL && p.needle == q.needle);
        if (is_same_suture && fabs(q.arc - p.arc) < diameter &&
            vec3_distance(vbss_hole_point(other, &p.wall, p.wall.now),
                          vbss_hole_point(made, &p.wall, p.wall.now)) < diameter) {
            return vbss_fail(s->context, VBSS_ERROR_IN_USE,
                             "hole %u of this suture is at the same place", other->id);
        }
    }
    return VBSS_OK;
}

/* Checks the arguments of vbss_scene_make_hole and initialises the hole with them. */
static vbss_result prepare_hole(scene_object *s, suture_hole *made, double arc_length,
                                uint32_t body, const double *weights)
{
    scene_body *suture, *b;
    if (!s->method->accepts_holes) {
        return vbss_fail(s->context, VBSS_ERROR_INCOMPATIBLE,
                         "holes are made by hosts in scenes of method IMPLICIT");
    }
    VBSS_TRY(check_suture(s, body, arc_length, &suture));
    VBSS_TRY(vbss_scene_require_any_body(s, made->wall, &b));
    if (!scene_is_wall(b)) {
        return vbss_fail(s->context, VBSS_ERROR_INCOMPATIBLE, "body %u is no drain or host surface",
                         made->wall);
    }
    const suture_wall wall = vbss_scene_wall_of(b);
    VBSS_TRY(
        vbss_check_range(s->context, made->triangle, 0.0, wall.triangle_count - 1.0, "triangle"));
    VBSS_TRY(vbss_scene_check_weights(s->context, weights));
    if (vbss_scene_find_free_hole(s) == NULL) {
        return vbss_fail(s->context, VBSS_ERROR_CAPACITY, "more than %u holes",
                         s->config.hole_capacity);
    }
    made->id = s->last_hole_id + 1;
    made->arc = arc_length;
    made->needle = suture->kind == SCENE_BODY_RIGID ? body : 0;
    made->thread = suture->kind == SCENE_BODY_THREAD ? body : 0;
    memcpy(made->barycentric, weights, sizeof made->barycentric);
    VBSS_TRY(init_hole(s, made, suture));
    VBSS_TRY(check_place(s, made, suture));
    made->max_arc = vbss_max(made->max_arc, wall.law->tip_length); /* it is open */
    return VBSS_OK;
}

static vbss_result add_hole(scene_object *s, suture_hole *made, double arc_length, uint32_t body,
                            const double *weights)
{
    VBSS_TRY(prepare_hole(s, made, arc_length, body, weights));
    *vbss_scene_find_free_hole(s) = *made;
    s->last_hole_id = made->id;
    s->report.generation++;
    return VBSS_OK;
}

vbss_result vbss_scene_make_hole(vbss_scene *scene, uint32_t body, double arc_length,
                                 uint32_t drain, uint32_t triangle, const double *weights,
                                 uint32_t *id)
{
    VBSS_ENTER(scene);
    scene_object *s;
    scene_edit edit;
    const suture_hole place = {.wall = drain, .triangle = triangle};
    suture_hole made = place;
    VBSS_TRY(vbss_scene_open_mutable(scene, &s));
    VBSS_TRY(prepare_hole(s, &made, arc_length, body, weights));
    vbss_edit input = {
        .kind = VBSS_EDIT_HOLE, .words = {body, drain, triangle}, .numbers = {arc_length}};
    vbss_edit_set_numbers(&input, 1, weights, 3);
    VBSS_TRY(vbss_scene_begin_edit(scene, &input, &edit));
    made = place;
    VBSS_TRY(vbss_scene_end_edit(&edit, add_hole(s, &made, arc_length, body, weights)));
    if (id != NULL) {
        *id = made.id;
    }
    return VBSS_OK;
}

vbss_result vbss_scene_get_hole(vbss_scene *scene, uint32_t index, vbss_scene_hole *hole,
                                uint32_t struct_size)
{
    VBSS_ENTER(scene);
    static const uint32_t sizes[] = {168, sizeof(vbss_scene_hole), 0};
    static const vbss_layout layout = {"vbss_scene_hole", NULL, sizes};
    scene_object *s;
    VBSS_TRY(vbss_scene_open(scene, &s));
    uint32_t left = index;
    for (uint32_t i = 0; i < s->config.hole_capacity; i++) {
        const suture_hole *h = &s->holes[i];
        if (h->id == 0 || left-- > 0) {
            continue;
        }
        const scene_hole_context p = vbss_scene_get_hole_context(s, h);
        const suture_curve_point curve_point = vbss_scene_hole_curve_point(&p, h);
        vbss_scene_hole own = {.struct_size = sizeof own,
                               .id = h->id,
                               .needle = h->needle,
                               .drain = h->wall,
                               .triangle = h->triangle,
                               .outward = h->is_outward,
                               .arc_length = h->arc,
                               .friction = h->friction_force,
                               .thread = h->thread,
                               .torn_length = h->torn_length,
                               .tear_work = h->tear_work};
        for (int k = 0; k < 3; k++) {
            own.weights[k] = h->barycentric[k];
        }
        vec3_store(own.position, vbss_hole_point(h, &p.wall, p.wall.now));
        vec3_store(own.rest_position, vbss_hole_point(h, &p.wall, p.wall.rest));
        vec3_store(own.direction, curve_point.tangent);
        vec3_store(own.force,
                   vec3_add_scaled(h->transverse_force, h->friction_force, curve_point.tangent));
        return vbss_struct_write(s->context, &layout, &own, hole, struct_size);
    }
    return vbss_fail(s->context, VBSS_ERROR_NOT_FOUND, "the scene has no %u holes", index + 1);
}
