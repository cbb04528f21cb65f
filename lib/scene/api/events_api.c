/* Takes events out of a scene's list. */
#include "base/api_call.h"
#include "base/check.h"
#include "base/error.h"
#include "scene/api/api.h"
#include "scene/world/world.h"

_Static_assert(sizeof(vbss_scene_event) == 80, "published size");

static const uint32_t event_sizes[] = {80, 0};
static const vbss_layout event_layout = {"vbss_scene_event", NULL, event_sizes};

static vbss_result take_events(scene_object *s, vbss_scene_event *events, uint32_t struct_size,
                               uint32_t capacity, uint32_t *count)
{
    unsigned char *out = (unsigned char *)events;
    vbss_scene_event event;
    /* checks the size before an event leaves the list */
    const vbss_scene_event none = {.struct_size = sizeof none};
    VBSS_TRY(vbss_struct_write(s->context, &event_layout, &none, events, struct_size));
    *count = 0;
    while (*count < capacity && vbss_scene_take_event(s, &event)) {
        VBSS_TRY(vbss_struct_write(s->context, &event_layout, &event,
                                   out + (size_t)*count * struct_size, struct_size));
        ++*count;
    }
    return VBSS_OK;
}

vbss_result vbss_scene_take_events(vbss_scene *scene, vbss_scene_event *events,
                                   uint32_t struct_size, uint32_t capacity, uint32_t *count,
                                   uint64_t *lost)
{
    VBSS_ENTER(scene);
    scene_object *s;
    VBSS_TRY(vbss_scene_open_mutable(scene, &s));
    VBSS_TRY(vbss_check_pointer(s->context, count, "count"));
    if (capacity > 0) {
        VBSS_TRY(vbss_check_pointer(s->context, events, "events"));
    }
    const bool takes = events != NULL && capacity > 0;
    if (takes) {
        VBSS_TRY(take_events(s, events, struct_size, capacity, count));
    } else {
        *count = events == NULL ? s->events.count : 0;
    }
    if (lost != NULL) {
        *lost = s->events.lost;
        s->events.lost = takes ? 0 : s->events.lost;
    }
    return VBSS_OK;
}
