/* Public views of candidates and impacts. */
#include "base/api_call.h"
#include "base/error.h"
#include "collision/shapes.h"

_Static_assert(sizeof(collision_candidate) == 20, "five numbers side by side");

static vbss_view make_view(vbss_view_type type, uint32_t components, size_t stride, uint32_t count,
                           const void *data)
{
    vbss_view view = {0, type, components, (uint32_t)stride, count, data, 0};
    return view;
}

static vbss_result get_field(const collision_object *c, vbss_collision_field field, vbss_view *view)
{
    uint32_t n = c->impact_count;
    switch (field) {
    case VBSS_COLLISION_VIEW_CANDIDATES:
        *view = make_view(VBSS_VIEW_TYPE_U32, 5, sizeof *c->candidates, c->candidate_count,
                          c->candidates);
        return VBSS_OK;
    case VBSS_COLLISION_VIEW_IMPACTS:
        *view = make_view(VBSS_VIEW_TYPE_U32, 1, sizeof *c->impacts, n, c->impacts);
        return VBSS_OK;
    case VBSS_COLLISION_VIEW_TIMES:
        *view = make_view(VBSS_VIEW_TYPE_F64, 1, sizeof *c->times, n, c->times);
        return VBSS_OK;
    case VBSS_COLLISION_VIEW_NORMALS:
        *view = make_view(VBSS_VIEW_TYPE_F64, 3, sizeof *c->normals, n, c->normals);
        return VBSS_OK;
    case VBSS_COLLISION_VIEW_WEIGHTS:
        *view = make_view(VBSS_VIEW_TYPE_F64, 4, sizeof *c->weights, n, c->weights);
        return VBSS_OK;
    case VBSS_COLLISION_VIEW_DECISIONS:
        *view = make_view(VBSS_VIEW_TYPE_U32, 1, sizeof *c->decisions, n, c->decisions);
        return VBSS_OK;
    case VBSS_COLLISION_VIEW_DISTANCES:
        *view = make_view(VBSS_VIEW_TYPE_F64, 1, sizeof *c->distances, n, c->distances);
        return VBSS_OK;
    default:
        return vbss_fail(c->context, VBSS_ERROR_OUT_OF_RANGE, "a collision object has no field %d",
                         field);
    }
}

vbss_result vbss_collision_get_view(vbss_collision *collision, vbss_collision_field field,
                                    vbss_view *view, uint32_t struct_size)
{
    VBSS_ENTER(collision);
    collision_object *c;
    vbss_view own;
    VBSS_TRY(vbss_collision_open(collision, &c));
    VBSS_TRY(get_field(c, field, &own));
    own.generation = c->generation;
    return vbss_struct_write(c->context, &vbss_view_layout, &own, view, struct_size);
}
