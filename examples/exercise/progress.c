#include "exercise/progress.h"

#include <errno.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

#define LONGEST 1e6 /* s */

static const char title[] = "vblast_ss progress 1";

enum { LINE = 200 };

static bool refuse(char *why, size_t bytes, const char *path, unsigned line, const char *what)
{
    snprintf(why, bytes, "%s, line %u: %s", path, line, what);
    return false;
}

/* ---- read */

static vbss_session_exercise find(const char *name)
{
    vbss_session_exercise e = VBSS_SESSION_EXERCISE_COUNT - 1;
    while (e > 0 && strcmp(name, vbss_session_exercise_name(e)) != 0) {
        e--;
    }
    return e;
}

/* NULL: the line is good; else the fault. */
static const char *read_line(progress *p, const char *text)
{
    char name[32];
    progress_row row;
    int end = 0;
    if (sscanf(text, "%31s %9u %9u %9u %lf %n", name, &row.attempts, &row.passed, &row.unaided,
               &row.best, &end) != 5 ||
        text[end] != '\0') {
        return "not a name with three counts and a time";
    }
    vbss_session_exercise e = find(name);
    if (e == VBSS_SESSION_EXERCISE_NONE) {
        return "no such exercise";
    }
    if (p->rows[e].attempts > 0) {
        return "the exercise occurs twice";
    }
    if (row.attempts == 0 || row.passed > row.attempts || row.unaided > row.passed ||
        !(row.best >= 0.0 && row.best <= LONGEST)) {
        return "no such counts";
    }
    p->rows[e] = row;
    return NULL;
}

bool progress_read(progress *p, const char *path, char *why, size_t why_bytes)
{
    char text[LINE];
    const char *wrong = NULL;
    unsigned line = 0;
    memset(p, 0, sizeof *p);
    FILE *file = fopen(path, "r");
    if (file == NULL) {
        snprintf(why, why_bytes, "%s: %s", path, strerror(errno));
        return errno == ENOENT;
    }
    while (wrong == NULL && fgets(text, sizeof text, file) != NULL) {
        line++;
        text[strcspn(text, "\r\n")] = '\0';
        if (line == 1) {
            wrong = strcmp(text, title) == 0 ? NULL : "this is no file of progress";
        } else if (text[0] != '\0' && text[0] != '#') {
            wrong = read_line(p, text);
        }
    }
    bool failed = ferror(file) != 0;
    (void)fclose(file);
    wrong = wrong == NULL && (failed || line == 0) ? "it cannot be read, or is empty" : wrong;
    return wrong == NULL || refuse(why, why_bytes, path, line, wrong);
}

/* ---- written */

static bool print(FILE *file, const progress *p)
{
    bool good = fprintf(file, "%s\n# exercise attempts passed unaided best\n", title) > 0;
    for (vbss_session_exercise e = 1; e < VBSS_SESSION_EXERCISE_COUNT; e++) {
        const progress_row *r = &p->rows[e];
        if (r->attempts > 0) {
            good = fprintf(file, "%s %u %u %u %.3f\n", vbss_session_exercise_name(e), r->attempts,
                           r->passed, r->unaided, r->best) > 0 &&
                   good;
        }
    }
    return good;
}

bool progress_write(const progress *p, const char *path, char *why, size_t why_bytes)
{
    char beside[1024];
    if ((size_t)snprintf(beside, sizeof beside, "%s.new", path) >= sizeof beside) {
        snprintf(why, why_bytes, "%s: the name is too long", path);
        return false;
    }
    FILE *file = fopen(beside, "w");
    bool good = file != NULL && print(file, p) && fflush(file) == 0 && fsync(fileno(file)) == 0;
    good = (file == NULL || fclose(file) == 0) && good;
    good = good && rename(beside, path) == 0;
    if (!good) {
        snprintf(why, why_bytes, "%s: %s", path, strerror(errno));
        (void)remove(beside);
    }
    return good;
}

void progress_add(progress *p, const vbss_session_exercise_state *state)
{
    progress_row *r = &p->rows[state->exercise];
    bool is_passed = state->outcome == VBSS_SESSION_OUTCOME_PASSED;
    r->attempts++;
    r->passed += is_passed;
    if (is_passed && state->aids_used == 0) {
        r->best = r->unaided == 0 || state->time < r->best ? state->time : r->best;
        r->unaided++;
    }
}

bool progress_note(const char *path, const vbss_session_exercise_state *state, progress *p,
                   char *why, size_t why_bytes)
{
    if (!progress_read(p, path, why, why_bytes)) {
        return false;
    }
    progress_add(p, state);
    return progress_write(p, path, why, why_bytes);
}
