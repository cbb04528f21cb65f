/* Names of what is in a log, for people and tables. */
#include <stdbool.h>
#include <stddef.h>

#include "session_log/export.h"

const char *input_name(vbss_record_input_kind kind)
{
    static const char *const names[] = {
        [VBSS_RECORD_INPUT_RIGID_TARGET] = "move_rigid",
        [VBSS_RECORD_INPUT_PIN] = "pin",
        [VBSS_RECORD_INPUT_UNPIN] = "unpin",
        [VBSS_RECORD_INPUT_ATTACH] = "attach",
        [VBSS_RECORD_INPUT_ATTACHMENT_TARGET] = "move_attachment",
        [VBSS_RECORD_INPUT_DETACH] = "detach",
        [VBSS_RECORD_INPUT_CUT] = "cut",
        [VBSS_RECORD_INPUT_GRASPER_TARGET] = "move_grasper",
        [VBSS_RECORD_INPUT_SET_OPENING] = "set_opening",
        [VBSS_RECORD_INPUT_EXCHANGE] = "exchange",
        [VBSS_RECORD_INPUT_SETTING] = "setting",
        [VBSS_RECORD_INPUT_HOLE] = "make_hole",
        [VBSS_RECORD_INPUT_REMOVE] = "remove",
        [VBSS_RECORD_INPUT_DRAIN_ATTACH] = "attach_drain",
        [VBSS_RECORD_INPUT_DRAIN_TARGET] = "move_drain_attachment",
        [VBSS_RECORD_INPUT_DRAIN_DETACH] = "detach_drain",
    };
    bool known = kind > 0 && (size_t)kind < sizeof names / sizeof names[0];
    return known ? names[kind] : "unknown";
}

const char *event_name(uint32_t kind)
{
    static const char *const names[] = {
        [VBSS_SCENE_EVENT_TOUCH] = "touch",
        [VBSS_SCENE_EVENT_PART] = "part",
        [VBSS_RECORD_EVENT_TIME_LOST] = "time_lost",
        [VBSS_RECORD_EVENT_LOST] = "lost",
        [VBSS_SCENE_EVENT_GRASP] = "grasp",
        [VBSS_SCENE_EVENT_RELEASE] = "release",
        [VBSS_SCENE_EVENT_TORN] = "torn",
        [VBSS_SCENE_EVENT_SLIP] = "slip",
        [VBSS_SCENE_EVENT_GRASP_LOST] = "grasp_lost",
        [VBSS_SCENE_EVENT_CUT] = "cut",
        [VBSS_SCENE_EVENT_EXCHANGED] = "exchanged",
        [VBSS_SCENE_EVENT_NOT_EXCHANGED] = "not_exchanged",
        [VBSS_SCENE_EVENT_PUNCTURE] = "puncture",
        [VBSS_SCENE_EVENT_WITHDRAWN] = "withdrawn",
        [VBSS_SCENE_EVENT_PASSED] = "passed",
        [VBSS_SCENE_EVENT_HOLE_LOST] = "hole_lost",
    };
    bool known = kind > 0 && kind < sizeof names / sizeof names[0];
    return known ? names[kind] : "unknown";
}
