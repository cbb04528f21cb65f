#include "ghost/gather.h"

#include <stdlib.h>
#include <string.h>

vbss_result ghost_gather(ghost_rows *g, const stitch *t, vbss_session *session)
{
    ghost_pose *row = ghost_track_add(&g->all);
    ghost_seen *more = row != NULL ? realloc(g->seen, g->all.count * sizeof *more) : NULL;
    if (more == NULL) {
        return VBSS_ERROR_OUT_OF_MEMORY;
    }
    g->seen = more;
    return ghost_observe(t, session, &more[g->all.count - 1], row);
}

static ghost_phase longest_part(const ghost_rows *g, int32_t wanted)
{
    ghost_phase longest = {.count = 0};
    for (uint32_t first = 0, end; first < g->all.count; first = end) {
        for (end = first + 1; end < g->all.count && g->seen[end].phase == g->seen[first].phase;) {
            end++;
        }
        if (g->seen[first].phase == wanted && end - first > longest.count) {
            longest = (ghost_phase){first, end - first, g->seen[first].scene};
        }
    }
    return longest;
}

static bool copy_parts(const ghost_rows *g, ghost_track *t)
{
    for (int32_t i = VBSS_SESSION_PHASE_LOADING; i < GHOST_PHASES; i++) {
        const ghost_phase part = longest_part(g, i);
        t->phases[i] = part;
        t->phases[i].first = t->count;
        for (uint32_t k = 0; k < part.count; k++) {
            ghost_pose *row = ghost_track_add(t);
            if (row == NULL) {
                return false;
            }
            memcpy(row, g->all.rows[part.first + k], sizeof *g->all.rows);
        }
    }
    return t->count > 0;
}

bool ghost_finish(ghost_rows *g, ghost_track *t)
{
    memset(t, 0, sizeof *t);
    const bool good = copy_parts(g, t);
    if (!good) {
        ghost_track_free(t);
    }
    ghost_rows_free(g);
    return good;
}

void ghost_rows_free(ghost_rows *g)
{
    ghost_track_free(&g->all);
    free(g->seen);
    g->seen = NULL;
}
