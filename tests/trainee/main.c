/* A scripted trainee does exercises with a mouse: trainee EXERCISE STARTS [SEEDS [FIRST [LOG]]] [-v], or the whole task:
 * trainee whole_task [SEEDS [FIRST [LOG]]] [-v] [-s FOLDER] [-r STATE] [-u PHASE]. With -s it saves its state in the folder whenever the coach's goal
 * changes, and with -r it continues from such a state; with -u it ends at that phase (a number of the session). Prints the outcome of each try, and ends with 0 if all were passed. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "decimal_point.h"
#include "exercise/practice.h"
#include "exercise/starts.h"
#include "trainee/trainee.h"

typedef struct options {
    unsigned long seeds, first;
    const char *log, *folder, *state; /* each may be NULL */
    int until;                        /* a VBSS_SESSION_PHASE_ constant: passed if it is reached */
    bool verbose;
} options;

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

/* The whole task. `state`, which may be NULL: continued from there. `folder`, which may be NULL: states are saved there. */
static bool attempt_task(trainee *t, uint64_t seed, const options *o)
{
    vbss_result result =
        o->state != NULL ? trainee_resume(t, seed, o->state) : trainee_begin_task(t, seed, o->log);
    if (result != VBSS_OK) {
        fprintf(stderr, "trainee: the task cannot begin\n");
        return false;
    }
    t->verbose = o->verbose;
    t->folder = o->folder;
    t->until = o->until;
    lesson_whole_task(t);
    bool is_passed = trainee_report_task(t, seed);
    trainee_end(t);
    return is_passed;
}

static int attempt_all(const char *name, const options *o, vbss_session_exercise exercise,
                       const start_states *states)
{
    static trainee t;
    unsigned long passed = 0;
    for (unsigned long i = 0; i < o->seeds; i++) {
        uint64_t seed = o->first + i;
        passed += exercise == VBSS_SESSION_EXERCISE_NONE
                      ? attempt_task(&t, seed, o)
                      : attempt(&t, exercise, states, seed, o->log, o->verbose);
    }
    printf("%s: %lu of %lu passed\n", name, passed, o->seeds);
    return passed == o->seeds ? 0 : 1;
}

/* The words without those of options. */
static int read_options(int count, char **words, options *o)
{
    int left = 0;
    for (int i = 0; i < count; i++) {
        if (strcmp(words[i], "-v") == 0) {
            o->verbose = true;
        } else if (strcmp(words[i], "-s") == 0 && i + 1 < count) {
            o->folder = words[++i];
        } else if (strcmp(words[i], "-u") == 0 && i + 1 < count) {
            o->until = (int)strtol(words[++i], NULL, 10);
        } else if (strcmp(words[i], "-r") == 0 && i + 1 < count) {
            o->state = words[++i];
        } else {
            words[left++] = words[i];
        }
    }
    return left;
}

int main(int count, char **words)
{
    start_states states = {0};
    options o = {.seeds = 1, .until = VBSS_SESSION_PHASE_DONE};
    char why[300];
    use_decimal_point();
    count = read_options(count, words, &o);
    bool is_task = count > 1 && strcmp(words[1], "whole_task") == 0;
    vbss_session_exercise exercise =
        count > 2 && !is_task ? practice_named(words[1]) : VBSS_SESSION_EXERCISE_NONE;
    int from = is_task ? 2 : 3; /* the whole task needs no states */
    if (!is_task && (exercise == VBSS_SESSION_EXERCISE_NONE ||
                     !starts_read(&states, words[2], why, sizeof why))) {
        fprintf(
            stderr,
            "trainee EXERCISE STARTS [SEEDS [FIRST [LOG]]] [-v]\n"
            "trainee whole_task [SEEDS [FIRST [LOG]]] [-v] [-s FOLDER] [-r STATE] [-u PHASE]\n");
        return 2;
    }
    o.seeds = count > from ? strtoul(words[from], NULL, 10) : 1;
    o.first = count > from + 1 ? strtoul(words[from + 1], NULL, 10) : 0;
    o.log = count > from + 2 ? words[from + 2] : NULL;
    int result = attempt_all(words[1], &o, exercise, &states);
    starts_free(&states);
    return result;
}
