/* Configuration of sessions: defaults and range checks. */
#include "base/check.h"
#include "base/config.h"
#include "base/error.h"
#include "device/device.h"
#include "knot/knot.h"
#include "metrics/metrics.h"
#include "session/session.h"

#define SIZE_BEFORE_GAP_MEASURE offsetof(vbss_session_config, gap_measure)
#define SIZE_BEFORE_LOST_SHARE offsetof(vbss_session_config, lost_share)
#define SIZE_BEFORE_EXERCISE offsetof(vbss_session_config, exercise)

_Static_assert(sizeof(vbss_session_config) == 160 + 8 * sizeof(void *), "published size");
_Static_assert(SIZE_BEFORE_EXERCISE == 152 + 8 * sizeof(void *), "published size");
_Static_assert(SIZE_BEFORE_LOST_SHARE == 144 + 8 * sizeof(void *), "published size");
_Static_assert(SIZE_BEFORE_GAP_MEASURE == 136 + 8 * sizeof(void *), "published size");

static const vbss_session_config defaults = {
    .struct_size = sizeof(vbss_session_config),
    .event_capacity = 1024,
    .knot_interval = 4,
    .hash_interval = 100,
    .time_limit = 600.0,
    .dwell = 0.05,
    .throw_dwell = 0.1,
    .tail_low = 15e-3,
    .tail_high = 20e-3,
    .tail_margin = 1e-3,
    .tail_reach = 0.01,
    .seat_gap = 0.5e-3,
    .seat_release = 1e-3,
    .seat_force = 0.5,
    .avulsed_share = 0.5,
    .lost_share = 0.02,
};
static const uint32_t sizes[] = {SIZE_BEFORE_GAP_MEASURE, SIZE_BEFORE_LOST_SHARE,
                                 SIZE_BEFORE_EXERCISE, sizeof(vbss_session_config), 0};
static const vbss_layout layout = {"vbss_session_config", &defaults, sizes};

vbss_result vbss_session_config_init(vbss_session_config *config, uint32_t struct_size)
{
    return vbss_config_init(&layout, config, struct_size);
}

vbss_result vbss_session_read_config(vbss_context *context, const vbss_session_config *config,
                                     vbss_session_config *own)
{
    VBSS_TRY(vbss_check_pointer(context, config, "config"));
    VBSS_TRY(vbss_config_read(context, &layout, config, own));
    const struct {
        const char *name;
        double value, low, high;
    } ranges[] = {
        {"event_capacity", own->event_capacity, 8.0, 65536.0},
        {"knot_interval", own->knot_interval, 1.0, 1000.0},
        {"hash_interval", own->hash_interval, 1.0, 1e9},
        {"time_limit", own->time_limit, 1e-3, 1e6},
        {"dwell", own->dwell, 0.0, 10.0},
        {"throw_dwell", own->throw_dwell, 0.0, 10.0},
        {"tail_low", own->tail_low, 0.0, 1.0},
        {"tail_high", own->tail_high, own->tail_low, 1.0},
        {"tail_margin", own->tail_margin, 0.0, 1.0},
        {"tail_reach", own->tail_reach, 0.0, 1.0},
        {"seat_gap", own->seat_gap, 0.0, 1.0},
        {"seat_release", own->seat_release, own->seat_gap, 1.0},
        {"seat_force", own->seat_force, 0.0, 1e3},
        {"avulsed_share", own->avulsed_share, 0.0, 1.0},
        {"break_force", own->break_force, 0.0, 1e6},
        {"coaching", own->coaching, 0.0, 1.0},
        {"gap_measure", own->gap_measure, VBSS_SESSION_GAP_LIPS, VBSS_SESSION_GAP_EDGES},
        {"lost_share", own->lost_share, 0.0, 1.0},
        {"exercise", own->exercise, VBSS_SESSION_EXERCISE_NONE, VBSS_SESSION_EXERCISE_COUNT - 1},
        {"reserved", own->reserved, 0.0, 0.0},
    };
    for (size_t i = 0; i < sizeof ranges / sizeof ranges[0]; i++) {
        VBSS_TRY(vbss_check_range(context, ranges[i].value, ranges[i].low, ranges[i].high,
                                  ranges[i].name));
    }
    return VBSS_OK;
}
