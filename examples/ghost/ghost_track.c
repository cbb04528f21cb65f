/* Makes ghost hands from a recorded log of the whole task: ghost_track LOG FILE
 *
 * The log is replayed, which takes about as long as the task did. */
#include <stdio.h>

#include "decimal_point.h"
#include "ghost/gather.h"
#include "viewer/player.h"

enum { STEPS = 40, SHOWN = 1000 }; /* from row to row; from one printed time to the next */

static bool gather(ghost_rows *g, player *p)
{
    while (player_step(p)) {
        if (p->step % SHOWN == 0) {
            fprintf(stderr, "\r%.0f s", p->time);
        }
        if (p->step % STEPS == 0 &&
            ghost_gather(g, p->stage.tasked, p->stage.task.session) != VBSS_OK) {
            return false;
        }
    }
    fprintf(stderr, "\n");
    return !p->differs;
}

static bool make(player *p, const char *to, char *why, size_t why_bytes)
{
    ghost_rows rows = {.seen = NULL};
    ghost_track t;
    if (p->stage.tasked == NULL || p->stage.task.session == NULL) {
        snprintf(why, why_bytes, "the log is not of the whole task");
        return false;
    }
    if (!gather(&rows, p) || !ghost_finish(&rows, &t)) {
        snprintf(why, why_bytes, "the log cannot be replayed");
        ghost_rows_free(&rows);
        return false;
    }
    for (int i = 0; i < GHOST_PHASES; i++) {
        printf("phase %d: %.1f s\n", i, GHOST_INTERVAL * t.phases[i].count);
    }
    const bool good = ghost_track_write(&t, to, why, why_bytes);
    ghost_track_free(&t);
    return good;
}

int main(int count, char **words)
{
    static player p;
    char why[300];
    use_decimal_point();
    if (count != 3) {
        fprintf(stderr, "ghost_track LOG FILE\n");
        return 2;
    }
    if (!player_open(&p, words[1])) {
        return 1;
    }
    const bool good = make(&p, words[2], why, sizeof why);
    if (!good) {
        fprintf(stderr, "ghost_track: %s\n", why);
    }
    player_close(&p);
    return good ? 0 : 1;
}
