/* Moves a host surface, and describes its arrays. */
#include "base/api_call.h"
#include "base/check.h"
#include "base/error.h"
#include "scene/api/api.h"
#include "scene/world/world.h"

#include <vblast_ss/scene_surface.h>

#include <string.h>

vbss_result vbss_scene_require_surface(const scene_object *s, uint32_t number, scene_body **b)
{
    VBSS_TRY(vbss_scene_require_any_body(s, number, b));
    return scene_host_surface_of(*b) != NULL ? VBSS_OK
                                             : vbss_fail(s->context, VBSS_ERROR_INCOMPATIBLE,
                                                         "body %u is no host surface", number);
}

static vbss_result check_jumps(const scene_object *s, const scene_host_surface *h, const vec3 *x)
{
    const vec3 *last = vbss_scene_host_surface_targets(h);
    for (uint32_t i = 0; i < h->vertex_count; i++) {
        const double jump = vec3_distance(x[i], last[i]);
        if (!(jump <= h->jump_limit)) {
            return vbss_fail(s->context, VBSS_ERROR_OUT_OF_RANGE,
                             "vertex %u jumps by %g m, jump_limit is %g m", i, jump, h->jump_limit);
        }
    }
    return VBSS_OK;
}

static vbss_result check_move(const scene_object *s, const scene_body *b, const double *vertices,
                              uint32_t count)
{
    const scene_host_surface *h = b->rigid.surface;
    const size_t numbers = 3 * (size_t)count;
    uint32_t triangle = 0;
    if (count != h->vertex_count) {
        return vbss_fail(s->context, VBSS_ERROR_OUT_OF_RANGE,
                         "vertex_count is %u, the host surface has %u vertices", count,
                         h->vertex_count);
    }
    VBSS_TRY(vbss_check_finite(s->context, vertices, numbers, "vertices"));
    VBSS_TRY(vbss_check_range(s->context, vbss_max_abs(vertices, numbers), 0.0, 1e3,
                              "largest coordinate of vertices"));
    const vec3 *x = (const vec3 *)(const void *)vertices;
    VBSS_TRY(check_jumps(s, h, x));
    const collision_shape *shape = s->collision->shapes[b->shape];
    return vbss_scene_keeps_triangles((const uint32_t(*)[3])shape->triangles, shape->triangle_count,
                                      vbss_scene_host_surface_targets(h), x, &triangle)
               ? VBSS_OK
               : vbss_fail(s->context, VBSS_ERROR_OUT_OF_RANGE,
                           "triangle %u loses its area, or turns by 90 degrees or more", triangle);
}

vbss_result vbss_scene_move_surface(vbss_scene *scene, uint32_t body, const double *vertices,
                                    uint32_t vertex_count)
{
    VBSS_ENTER(scene);
    scene_object *s;
    scene_body *b;
    vbss_edit input = {.kind = VBSS_EDIT_OTHER};
    VBSS_TRY(vbss_scene_open_mutable(scene, &s));
    VBSS_TRY(vbss_check_pointer(s->context, vertices, "vertices"));
    VBSS_TRY(vbss_scene_require_surface(s, body, &b));
    VBSS_TRY(check_move(s, b, vertices, vertex_count));
    VBSS_TRY(vbss_edit_begin(scene, &input));
    scene_host_surface *h = b->rigid.surface;
    memcpy(h->pending, vertices, vertex_count * sizeof *h->pending);
    h->has_pending = true;
    s->report.generation++;
    return vbss_edit_end(scene, &input, VBSS_OK);
}

/* ---- compliance */

static mat3 compliance_of(const scene_host_surface *h, const double *compliance, uint32_t vertex)
{
    const double *c = compliance + (size_t)vertex * h->compliance_size;
    return h->compliance_size == 1 ? mat3_diagonal(c[0], c[0], c[0])
                                   : mat3_rows(vec3_load(c), vec3_load(c + 3), vec3_load(c + 6));
}

static vbss_result check_compliance(const scene_object *s, const scene_host_surface *h,
                                    const double *compliance, uint32_t count)
{
    const uint64_t expected = (uint64_t)h->vertex_count * h->compliance_size;
    if (!scene_is_compliant(h)) {
        return vbss_fail(s->context, VBSS_ERROR_INCOMPATIBLE,
                         "the host surface was added with compliance_size 0");
    }
    if (count != expected) {
        return vbss_fail(s->context, VBSS_ERROR_OUT_OF_RANGE,
                         "count is %u, the host surface has %llu numbers of compliance", count,
                         (unsigned long long)expected);
    }
    VBSS_TRY(vbss_check_finite(s->context, compliance, count, "compliance"));
    for (uint32_t i = 0; i < h->vertex_count; i++) {
        const mat3 own = compliance_of(h, compliance, i);
        if (!vbss_scene_is_compliance(&own)) {
            return vbss_fail(s->context, VBSS_ERROR_OUT_OF_RANGE,
                             "the compliance of vertex %u is neither zero nor positive definite "
                             "within its limits",
                             i);
        }
    }
    return VBSS_OK;
}

static vbss_result set_compliance(scene_object *s, scene_host_surface *h, const double *compliance)
{
    for (uint32_t i = 0; i < h->vertex_count; i++) {
        const mat3 own = compliance_of(h, compliance, i);
        vbss_scene_set_vertex_compliance(h, i, &own);
        if (!scene_has_compliance(h, i)) {
            h->deflections[i] = vec3_zero();
        }
    }
    s->report.generation++;
    return VBSS_OK;
}

vbss_result vbss_scene_set_surface_compliance(vbss_scene *scene, uint32_t body,
                                              const double *compliance, uint32_t count)
{
    VBSS_ENTER(scene);
    scene_object *s;
    scene_body *b;
    scene_edit edit;
    vbss_edit input = {.kind = VBSS_EDIT_OTHER};
    VBSS_TRY(vbss_scene_open_mutable(scene, &s));
    VBSS_TRY(vbss_check_pointer(s->context, compliance, "compliance"));
    VBSS_TRY(vbss_scene_require_surface(s, body, &b));
    VBSS_TRY(check_compliance(s, b->rigid.surface, compliance, count));
    VBSS_TRY(vbss_scene_begin_edit(scene, &input, &edit));
    return vbss_scene_end_edit(&edit, set_compliance(s, b->rigid.surface, compliance));
}

/* ---- views */

vbss_result vbss_scene_get_surface_view(vbss_scene *scene, uint32_t body,
                                        vbss_scene_surface_field field, vbss_view *view,
                                        uint32_t struct_size)
{
    VBSS_ENTER(scene);
    scene_object *s;
    scene_body *b;
    VBSS_TRY(vbss_scene_open(scene, &s));
    VBSS_TRY(vbss_scene_require_surface(s, body, &b));
    const scene_host_surface *h = b->rigid.surface;
    vbss_view own = {0,    VBSS_VIEW_TYPE_F64,  3, sizeof(vec3), h->vertex_count,
                     NULL, s->report.generation};
    switch (field) {
    case VBSS_SCENE_SURFACE_VIEW_POSITIONS:
        own.data = h->now;
        break;
    case VBSS_SCENE_SURFACE_VIEW_TARGETS:
        own.data = vbss_scene_host_surface_targets(h);
        break;
    case VBSS_SCENE_SURFACE_VIEW_FORCES:
        own.data = h->forces;
        break;
    default:
        return vbss_fail(s->context, VBSS_ERROR_OUT_OF_RANGE, "a host surface has no array %d",
                         field);
    }
    return vbss_struct_write(s->context, &vbss_view_layout, &own, view, struct_size);
}
