/* A scripted trainee does exercises with a mouse: trainee EXERCISE STARTS [SEEDS [FIRST [LOG]]] [-v]. Prints the
 * outcome of each try, and ends with 0 if all were passed. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "decimal_point.h"
#include "exercise/practice.h"
#include "exercise/starts.h"
#include "trainee/trainee.h"

static bool attempt(trainee *t, vbss_session_exercise exercise, const start_states *states,
                    uint64_t seed, const char *log, bool verbose)
{
    vbss_session_exercise_state e;
    vbss_session_measure m;
    char words[PRACTICE_LINE];
    if (trainee_begin(t, exercise, states, seed, log) != VBSS_OK) {
        fprintf(stderr, "trainee: the exercise cannot begin\n");
        return false;
    }
    t->verbose = verbose;
    switch (exercise) {
    case VBSS_SESSION_EXERCISE_TAKE_NEEDLE:
        lesson_take_needle(t);
        break;
    case VBSS_SESSION_EXERCISE_PASS_MARK:
        lesson_pass_mark(t);
        break;
    case VBSS_SESSION_EXERCISE_SINGLE_THROW:
    case VBSS_SESSION_EXERCISE_DOUBLE_THROW:
    case VBSS_SESSION_EXERCISE_SQUARE_THROW:
        lesson_throw(t);
        break;
    default:
        lesson_cut(t);
        break;
    }
    bool ended = trainee_has_ended(t, &e),
         passed = ended && e.outcome == VBSS_SESSION_OUTCOME_PASSED;
    printf("%s seed %lu: %s after %.1f s, aids %u:", e.name, (unsigned long)seed,
           passed  ? "passed"
           : ended ? "NOT PASSED"
                   : "NOT ENDED",
           e.time, (unsigned)e.aids_used);
    for (uint32_t i = 0; i < e.measure_count; i++) {
        if (vbss_session_get_measure(t->live.stage.task.session, i, &m, sizeof m) == VBSS_OK) {
            practice_words(&m, words);
            printf("%s %s%s", i > 0 ? ";" : "", words, m.is_met != 0 ? "" : " MISSED");
        }
    }
    if (!passed && t->live.stage.task.session != NULL) {
        vbss_session_coaching c;
        (void)vbss_session_get_coaching(t->live.stage.task.session, &c, sizeof c);
        printf(" \"%s\" \"%s\"", c.sentence, c.mistake_sentence);
    }
    printf("\n");
    fflush(stdout);
    trainee_end(t);
    return passed;
}

int main(int count, char **words)
{
    static trainee t;
    start_states states;
    char why[300];
    use_decimal_point();
    bool verbose = count > 1 && strcmp(words[count - 1], "-v") == 0;
    count -= verbose;
    vbss_session_exercise exercise =
        count > 2 ? practice_named(words[1]) : VBSS_SESSION_EXERCISE_NONE;
    if (exercise == VBSS_SESSION_EXERCISE_NONE ||
        !starts_read(&states, words[2], why, sizeof why)) {
        fprintf(stderr, "trainee EXERCISE STARTS [SEEDS [FIRST [LOG]]] [-v]\n");
        return 2;
    }
    unsigned long seeds = count > 3 ? strtoul(words[3], NULL, 10) : 1,
                  first = count > 4 ? strtoul(words[4], NULL, 10) : 0;
    unsigned long passed = 0;
    for (unsigned long i = 0; i < seeds; i++) {
        passed += attempt(&t, exercise, &states, first + i, count > 5 ? words[5] : NULL, verbose);
    }
    printf("%s: %lu of %lu passed\n", words[1], passed, seeds);
    starts_free(&states);
    return passed == seeds ? 0 : 1;
}
