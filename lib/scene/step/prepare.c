/* Work of the next step that depends on the bodies alone. */
#include "base/error.h"
#include "scene/contacts/contacts.h"
#include "scene/solve/solve.h"
#include "scene/step/step.h"

vbss_result vbss_scene_prepare_step(scene_object *s)
{
    if (s->cursor.is_attempt_suspended || s->step.pattern_hash != 0) {
        return VBSS_OK;
    }
    vbss_scene_set_bounds_at_rest(s);
    VBSS_TRY(vbss_scene_find_candidates(s));
    return vbss_scene_prepare_pattern(s);
}
