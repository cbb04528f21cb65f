/* Handles of threads: the kind, and the object of a handle. */
#include "base/error.h"
#include "base/stream.h"
#include "thread/thread.h"

const vbss_kind vbss_thread_kind = {"thread",         VBSS_CODE('T', 'H', 'R', 'D'), 1,
                                    vbss_thread_free, vbss_thread_serialise,         NULL};

vbss_result vbss_thread_open(const vbss_thread *handle, thread_object **thread)
{
    vbss_slot *slot;
    VBSS_TRY(vbss_slot_open(handle, &vbss_thread_kind, &slot));
    *thread = slot->object;
    return VBSS_OK;
}

vbss_result vbss_thread_edit(vbss_thread *handle, thread_object **thread)
{
    vbss_slot *slot;
    VBSS_TRY(vbss_slot_edit(handle, &vbss_thread_kind, &slot));
    *thread = slot->object;
    return VBSS_OK;
}

vbss_result vbss_thread_edit_unowned(vbss_thread *handle, thread_object **thread)
{
    vbss_slot *slot;
    VBSS_TRY(vbss_slot_edit_unowned(handle, &vbss_thread_kind, &slot));
    *thread = slot->object;
    return VBSS_OK;
}
