/* Makes the states at which exercises start, and the ghost hands of who made them: exercise_starts FILE [GHOST] */
#include <stdio.h>

#include "decimal_point.h"
#include "exercise/starts.h"

static void show(void *user, double seconds)
{
    (void)user;
    fprintf(stderr, "\r%.0f s of about 90 s", seconds);
}

int main(int count, char **words)
{
    start_states s;
    ghost_track hands = {.count = 0};
    char why[300] = "the scripted surgeon has not succeeded";
    use_decimal_point();
    if (count != 2 && count != 3) {
        fprintf(stderr, "exercise_starts FILE [GHOST]\n");
        return 2;
    }
    bool good = starts_make(&s, count == 3 ? &hands : NULL, show, NULL) &&
                starts_write(&s, words[1], why, sizeof why) &&
                (count == 2 || ghost_track_write(&hands, words[2], why, sizeof why));
    fprintf(stderr, "\n%s%s", good ? "" : why, good ? "" : "\n");
    starts_free(&s);
    ghost_track_free(&hands);
    return good ? 0 : 1;
}
