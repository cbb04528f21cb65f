/* Handles of drains: the kind, and the object of a handle. */
#include "base/error.h"
#include "base/stream.h"
#include "drain/drain.h"

const vbss_kind vbss_drain_kind = {"drain",         VBSS_CODE('D', 'R', 'A', 'N'), 2,
                                   vbss_drain_free, vbss_drain_serialise,          NULL};

vbss_result vbss_drain_open(const vbss_drain *handle, drain_object **drain)
{
    vbss_slot *slot;
    VBSS_TRY(vbss_slot_open(handle, &vbss_drain_kind, &slot));
    *drain = slot->object;
    return VBSS_OK;
}

vbss_result vbss_drain_edit(vbss_drain *handle, drain_object **drain)
{
    vbss_slot *slot;
    VBSS_TRY(vbss_slot_edit(handle, &vbss_drain_kind, &slot));
    *drain = slot->object;
    return VBSS_OK;
}

vbss_result vbss_drain_edit_unowned(vbss_drain *handle, drain_object **drain)
{
    vbss_slot *slot;
    VBSS_TRY(vbss_slot_edit_unowned(handle, &vbss_drain_kind, &slot));
    *drain = slot->object;
    return VBSS_OK;
}
