/* Names of what is in a log, for people and tables. */
#include <stdbool.h>
#include <stddef.h>

#include "session_log/export.h"

const char *input_name(vbss_input_kind kind)
{
    static const char *const names[] = {
        [VBSS_INPUT_MOVE_RIGID] = "move_rigid",
        [VBSS_INPUT_PIN] = "pin",
        [VBSS_INPUT_UNPIN] = "unpin",
        [VBSS_INPUT_ATTACH] = "attach",
        [VBSS_INPUT_MOVE] = "move_attachment",
        [VBSS_INPUT_DETACH] = "detach",
        [VBSS_INPUT_CUT] = "cut",
        [VBSS_INPUT_MOVE_GRASPER] = "move_grasper",
        [VBSS_INPUT_SET_OPENING] = "set_opening",
        [VBSS_INPUT_EXCHANGE] = "exchange",
        [VBSS_INPUT_SETTING] = "setting",
    };
    bool known = kind > 0 && (size_t)kind < sizeof names / sizeof names[0];
    return known ? names[kind] : "unknown";
}

const char *event_name(uint32_t kind)
{
    static const char *const names[] = {
        [VBSS_EVENT_TOUCH] = "touch",
        [VBSS_EVENT_PART] = "part",
        [VBSS_EVENT_CLAMPED] = "clamped",
        [VBSS_EVENT_LOST] = "lost",
        [VBSS_EVENT_GRASP] = "grasp",
        [VBSS_EVENT_RELEASE] = "release",
        [VBSS_EVENT_TORN] = "torn",
        [VBSS_EVENT_SLIP] = "slip",
        [VBSS_EVENT_GRASP_LOST] = "grasp_lost",
        [VBSS_EVENT_CUT] = "cut",
        [VBSS_EVENT_EXCHANGED] = "exchanged",
        [VBSS_EVENT_NOT_EXCHANGED] = "not_exchanged",
        [VBSS_EVENT_PUNCTURE] = "puncture",
        [VBSS_EVENT_WITHDRAWN] = "withdrawn",
        [VBSS_EVENT_PASSED] = "passed",
        [VBSS_EVENT_HOLE_LOST] = "hole_lost",
    };
    bool known = kind > 0 && kind < sizeof names / sizeof names[0];
    return known ? names[kind] : "unknown";
}
