/* Handles of detectors: the kind, and the object of a handle. */
#include "base/error.h"
#include "base/stream.h"
#include "knot/knot.h"

const vbss_kind vbss_knot_kind = {"knot detector", VBSS_CODE('K', 'N', 'O', 'T'), 1,
                                  vbss_knot_free,  vbss_knot_serialise,           NULL};

vbss_result vbss_knot_open(const vbss_knot_detector *handle, knot_detector **detector)
{
    vbss_slot *slot;
    VBSS_TRY(vbss_slot_open(handle, &vbss_knot_kind, &slot));
    *detector = slot->object;
    return VBSS_OK;
}

vbss_result vbss_knot_edit(vbss_knot_detector *handle, knot_detector **detector)
{
    vbss_slot *slot;
    VBSS_TRY(vbss_slot_edit(handle, &vbss_knot_kind, &slot));
    *detector = slot->object;
    return VBSS_OK;
}
