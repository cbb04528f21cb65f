/* Views of a scene's contacts. */
#include "base/api_call.h"
#include "base/error.h"
#include "scene/api/api.h"

vbss_result vbss_scene_get_view(vbss_scene *scene, vbss_scene_field field, vbss_view *view,
                                uint32_t struct_size)
{
    VBSS_ENTER(scene);
    scene_object *s;
    VBSS_TRY(vbss_scene_open(scene, &s));
    const uint32_t f64 = (uint32_t)sizeof(double), u32 = (uint32_t)sizeof(uint32_t);
    vbss_view own = {.struct_size = sizeof own, .type = VBSS_VIEW_TYPE_F64, .components = 3};
    own.count = s->report.contact_count;
    own.generation = s->report.generation;
    switch (field) {
    case VBSS_SCENE_VIEW_CONTACTS:
        own.type = VBSS_VIEW_TYPE_U32;
        own.components = 5;
        own.data = s->report.contact_features;
        break;
    case VBSS_SCENE_VIEW_CONTACT_POINTS:
        own.data = s->report.contact_points;
        break;
    case VBSS_SCENE_VIEW_CONTACT_NORMALS:
        own.data = s->report.contact_normals;
        break;
    case VBSS_SCENE_VIEW_CONTACT_FORCES:
        own.data = s->report.contact_forces;
        break;
    case VBSS_SCENE_VIEW_CONTACT_GAPS:
        own.components = 1;
        own.data = s->report.contact_gaps;
        break;
    default:
        return vbss_fail(s->context, VBSS_ERROR_OUT_OF_RANGE, "a scene has no array %d", field);
    }
    own.stride_bytes = own.components * (own.type == VBSS_VIEW_TYPE_F64 ? f64 : u32);
    if (own.data == s->report.contact_points || own.data == s->report.contact_normals ||
        own.data == s->report.contact_forces) {
        own.stride_bytes = (uint32_t)sizeof(vec3);
    }
    return vbss_struct_write(s->context, &vbss_view_layout, &own, view, struct_size);
}
