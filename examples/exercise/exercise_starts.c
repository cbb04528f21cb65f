/* Makes the states at which exercises start: exercise_starts FILE */
#include <stdio.h>

#include "decimal_point.h"
#include "exercise/starts.h"

static void show(void *user, double seconds)
{
    (void)user;
    fprintf(stderr, "\r%.0f s of about 77 s", seconds);
}

int main(int count, char **words)
{
    start_states s;
    char why[300] = "the scripted surgeon has not succeeded";
    use_decimal_point();
    if (count != 2) {
        fprintf(stderr, "exercise_starts FILE\n");
        return 2;
    }
    bool good = starts_make(&s, show, NULL) && starts_write(&s, words[1], why, sizeof why);
    fprintf(stderr, "\n%s%s", good ? "" : why, good ? "" : "\n");
    starts_free(&s);
    return good ? 0 : 1;
}
