/* Exercises and aids in the page. */
#include <stdlib.h>

#include "exercise/starts.h"
#include "page.h"
#include "session.h"

int32_t page_exercise(int32_t exercise)
{
    page_session *p = page_get();
    start_states states;
    const replay_log given = page_take_room();
    if (exercise <= VBSS_SESSION_EXERCISE_NONE || exercise >= VBSS_SESSION_EXERCISE_COUNT) {
        free(given.data);
        return VBSS_ERROR_OUT_OF_RANGE;
    }
    (void)starts_parse(&states, given.data,
                       given.count); /* without states some exercises cannot begin */
    page_clear(p);
    const vbss_result made =
        live_create_exercise(&p->live, exercise, &states, tracked_arms(), PAGE_LOG);
    starts_free(&states);
    return page_complete(p, made);
}

int32_t page_set_aids(uint32_t aids)
{
    page_session *p = page_get();
    if (!p->there || p->plays) {
        return VBSS_ERROR_WRONG_STATE;
    }
    for (uint32_t aid = 1; aid <= (uint32_t)VBSS_SESSION_AID_ALL; aid <<= 1) {
        if (((p->live.aids ^ aids) & aid) != 0) {
            TRY(live_toggle_aid(&p->live, aid));
        }
    }
    return VBSS_OK;
}
