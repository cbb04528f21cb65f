/* Handles of collision objects: the kind, and the object of a handle. */
#include "base/error.h"
#include "base/stream.h"
#include "collision/shapes.h"

const vbss_kind vbss_collision_kind = {"collision object",  VBSS_CODE('C', 'O', 'L', 'L'), 1,
                                       vbss_collision_free, vbss_collision_serialise,      NULL};

vbss_result vbss_collision_open(const vbss_collision *handle, collision_object **collision)
{
    vbss_slot *slot;
    VBSS_TRY(vbss_slot_open(handle, &vbss_collision_kind, &slot));
    *collision = slot->object;
    return VBSS_OK;
}

vbss_result vbss_collision_edit(vbss_collision *handle, collision_object **collision)
{
    vbss_slot *slot;
    VBSS_TRY(vbss_slot_edit(handle, &vbss_collision_kind, &slot));
    *collision = slot->object;
    return VBSS_OK;
}
