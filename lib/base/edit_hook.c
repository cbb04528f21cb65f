/* Tells edits to a hook, but not those inside another edit. */
#include "base/edit_hook.h"
#include "base/error.h"
#include "base/slot.h"

#include <string.h>

void vbss_edit_set_numbers(vbss_edit *edit, uint32_t first, const double *numbers, uint32_t count)
{
    if (numbers != NULL) {
        memcpy(&edit->numbers[first], numbers, count * sizeof *numbers);
    }
}

vbss_result vbss_edit_begin(void *handle, vbss_edit *edit)
{
    vbss_edit_hook *hook = ((vbss_slot *)handle)->hook;
    if (hook == NULL) {
        return VBSS_OK;
    }
    edit->edited = handle;
    if (hook->depth == 0 && hook->data != NULL) {
        VBSS_TRY(hook->begin_edit(hook->data, edit));
    }
    hook->depth++;
    return VBSS_OK;
}

vbss_result vbss_edit_end(void *handle, const vbss_edit *edit, vbss_result result)
{
    vbss_edit_hook *hook = ((vbss_slot *)handle)->hook;
    if (hook == NULL) {
        return result;
    }
    hook->depth--;
    return hook->depth == 0 && hook->data != NULL ? hook->end_edit(hook->data, edit, result)
                                                  : result;
}
