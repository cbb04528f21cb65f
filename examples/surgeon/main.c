/* A scripted surgeon makes a stitch, through devices alone:
 *
 *     surgeon [-s seed] [-n seeds] [-g seeds that must be good: all] [-f most N that a hand of a good one feels]
 *             [-u pass|pull|tie|over|second|back|third|cut: the last stage] [-t most seconds]
 *             [-w budget of a step in us, 0: none] [-c the same of a call] [-l log] [-p folder for pictures]
 *             [-e seconds between them] [-v] [-j file that gets a line of JSON more for each seed]
 *             [-k expert|resident|novice: whose hands] [--mend: the mistake is mended when the coach says so]
 *             [-m withdrawn|missed|torn|idle|slack|kept|granny|handle|counter|bight|dropped|one-sided: a mistake]
 *             [-a folder for pictures of the key stages] [--calibrate] [--coach: its sentences, too]
 *             [--left: left-handed, all in the mirror]
 *             [-x bending|friction|yield|hardening=number, of the thread: EI in N m^2, with itself, 1/m, fraction of EI]
 *
 * With --calibrate both budgets are those of this core, so a seed does not do the same everywhere.
 * The log is played back. Prints the result of each seed. Exits 0 if logs play back to the same, no simulation fails, and each
 * seed, or as many as -g asks for, is good: the last stage that was named is made; without one, the session calls the task done and the slit is
 * shut; with -m the session reports the mistake; with --mend it is mended as far as it can be. Else exits 1. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "decimal_point.h"
#include "surgeon/watch.h"
#include "throw/core_speed.h"

static int usage(void)
{
    fprintf(stderr, "surgeon [-s seed] [-n seeds] [-g seeds that must be good: all] "
                    "[-f most N that a hand of a good one feels] [-u "
                    "pass|pull|tie|over|second|back|third|cut] "
                    "[-t most seconds] [-w us of a step] [-c us of a call] [-l log] [-p folder for "
                    "pictures] [-e seconds between them] [-j file for lines of JSON] [-k "
                    "expert|resident|novice] [-m mistake] [--mend] "
                    "[-a folder for the "
                    "key stages] [-x bending|friction|yield|hardening=number] [--calibrate] "
                    "[--coach] [--left: left-handed] [-v]\n");
    return 2;
}

/* The one after that of this name; all of them, if there is none. */
static surgeon_stage after(const char *name)
{
    for (int i = 0; i < SURGEON_DONE; i++) {
        if (strcmp(name, surgeon_stage_name((surgeon_stage)i)) == 0) {
            return (surgeon_stage)(i + 1);
        }
    }
    return SURGEON_DONE;
}

/* False if there is no such property, or its number is not above 0. */
static bool set_material(site_material *m, const char *word)
{
    const struct {
        const char *name;
        double *value;
    } properties[] = {{"bending=", &m->bending_stiffness},
                      {"friction=", &m->friction},
                      {"yield=", &m->yield_curvature},
                      {"hardening=", &m->yield_hardening}};
    for (size_t i = 0; i < sizeof properties / sizeof properties[0]; i++) {
        const size_t length = strlen(properties[i].name);
        if (strncmp(word, properties[i].name, length) == 0) {
            *properties[i].value = strtod(word + length, NULL);
            return *properties[i].value > 0.0;
        }
    }
    return false;
}

typedef struct tally {
    int seeds, smallest; /* to be good; below 0: all */
    double max_force;    /* N, that either hand of a good one feels */
    int good, failed;    /* simulations, and logs that do not play back */
    const char *lines;   /* file for lines of JSON; may be NULL */
} tally;

static bool calibrate(vbss_solver_options *solver)
{
    char text[CORE_SPEED_WORDS] = "";
    const bool good = core_speed_fit(0.0, solver, text) == VBSS_OK;
    printf("%s\n", text);
    return good;
}

static bool read_options(int count, char **words, watch *w, tally *t, bool *whole,
                         vbss_solver_options *solver)
{
    w->options.solver = solver;
    for (int i = 1; i < count; i++) {
        const char *word = words[i];
        if (strcmp(word, "--calibrate") == 0) {
            if (!calibrate(solver)) {
                return false;
            }
            continue;
        }
        if (strcmp(word, "--coach") == 0) {
            w->options.coaching = true;
            continue;
        }
        if (strcmp(word, "--mend") == 0) {
            w->options.mends = true;
            continue;
        }
        if (strcmp(word, "--left") == 0) {
            w->options.left_handed = true;
            continue;
        }
        if (strcmp(word, "-v") == 0) {
            w->verbose = true;
            continue;
        }
        if (word[0] != '-' || strlen(word) != 2 || ++i == count) {
            return false;
        }
        switch (word[1]) {
        case 's':
            w->options.seed = strtoul(words[i], NULL, 10);
            break;
        case 'n':
            t->seeds = atoi(words[i]);
            break;
        case 'g':
            t->smallest = atoi(words[i]);
            break;
        case 'f':
            t->max_force = strtod(words[i], NULL);
            break;
        case 'u':
            w->options.until = after(words[i]);
            *whole = false;
            break;
        case 't':
            w->time_limit = strtod(words[i], NULL);
            break;
        case 'w':
            solver->step_budget_us = strtod(words[i], NULL);
            break;
        case 'c':
            solver->call_budget_us = strtod(words[i], NULL);
            break;
        case 'k':
            w->options.skill = skill_named(words[i]);
            if (w->options.skill == NULL) {
                return false;
            }
            break;
        case 'm':
            w->options.mistake = surgeon_mistake_named(words[i]);
            if (w->options.mistake == SURGEON_NO_MISTAKE) {
                return false;
            }
            break;
        case 'j':
            t->lines = words[i];
            break;
        case 'l':
            w->options.log = words[i];
            break;
        case 'p':
            w->folder = words[i];
            break;
        case 'a':
            w->album = words[i];
            break;
        case 'x':
            if (!set_material(&w->options.material, words[i])) {
                return false;
            }
            break;
        case 'e':
            w->every = strtod(words[i], NULL);
            break;
        default:
            return false;
        }
    }
    return t->seeds >= 1 && t->smallest != 0; /* atoi reads a word as 0 */
}

static bool judge_mistake(const watch *w)
{
    surgeon_mistake mistake = w->options.mistake;
    bool reported = surgeon_mistake_is_reported(mistake, w->task.session, w->task.metrics);
    printf("  %s: wanted: %s: %s\n", surgeon_mistake_name(mistake), surgeon_mistake_wanted(mistake),
           reported ? "so it is told" : "NOT TOLD");
    return reported;
}

/* All stages that were asked for were gone through and, if that is the whole task, the session calls it done. */
static bool is_made(const watch *w, const surgeon *s, bool whole)
{
    return s->stage >= w->options.until && s->stage != SURGEON_FAILED && !w->unpainted &&
           (!whole || (watch_complete(w) && surgeon_slit_is_shut(s)));
}

/* Mended, and the last stage made, if that can be. */
static bool judge_remedy(const watch *w, const surgeon *s)
{
    const surgeon_mistake mistake = w->options.mistake;
    const bool made = s->stage >= w->options.until && s->stage != SURGEON_FAILED;
    const surgeon_remedy remedy = surgeon_mistake_remedy(mistake);
    const bool good =
        surgeon_mistake_is_mended(mistake, w->task.session) && (made || remedy != REMEDY_WORKS);
    printf("  %s: %s: %s\n", surgeon_mistake_name(mistake),
           remedy == REMEDY_WORKS  ? "the coach takes it back"
           : remedy == REMEDY_NONE ? "it is named, and stays"
                                   : "the task has failed",
           good ? "so it is" : "NO");
    return good;
}

typedef struct listener {
    vbss_session_coaching before;
    bool prints;
} listener;

/* What the coach says when that changes, and every second; the hands follow it. */
static vbss_result hear_coach(void *user, const watch *w, surgeon *s)
{
    listener *l = user;
    vbss_session_coaching now;
    TRY(vbss_session_get_coaching(w->task.session, &now, sizeof now));
    const bool is_new = now.mistake != l->before.mistake;
    if (l->prints && (now.goal != l->before.goal || now.tool != l->before.tool || is_new ||
                      s->steps % 1000 == 0)) {
        task_print_coaching(s->stitch.site.rig.time, &now);
    }
    if (w->options.mends && is_new) {
        const bool ends = now.mistake == VBSS_SESSION_MISTAKE_NONE;
        printf("  %.3f s  coach: %s %s%s\n", s->stitch.site.rig.time,
               ends ? now.sentence : now.mistake_sentence, now.remedy,
               ends || now.is_mendable != 0 ? "" : " (cannot be mended)");
        surgeon_mend(s, now.mistake);
    }
    l->before = now;
    return VBSS_OK;
}

/* Adds a line to the file, if one was asked for. */
static bool write_line(const tally *t, const watch *w, const surgeon *s, vbss_result result,
                       bool is_good)
{
    if (t->lines == NULL) {
        return true;
    }
    FILE *out = fopen(t->lines, "a");
    if (out == NULL) {
        fprintf(stderr, "surgeon: cannot open %s\n", t->lines);
        return false;
    }
    const bool written = watch_write_outcome(out, w, s, result, is_good);
    return fclose(out) == 0 && written;
}

static void run(watch w, bool whole, tally *t)
{
    static surgeon s;
    static watch_step steps[WATCH_STEPS];
    listener hears = {.before = {.goal = -1}, .prints = w.options.coaching};
    if (w.options.coaching || w.options.mends) {
        w.guest = hear_coach;
        w.user = &hears;
    }
    vbss_result result = watch_run(&w, &s, steps);
    watch_report(&w, &s, result);
    watch_report_events(&w);
    bool good =
        result == VBSS_OK && (w.options.mistake == SURGEON_NO_MISTAKE ? is_made(&w, &s, whole)
                              : w.options.mends                       ? judge_remedy(&w, &s)
                                                                      : judge_mistake(&w));
    good = good && watch_largest_force(&w) <= t->max_force;
    t->failed += !write_line(t, &w, &s, result, good);
    throw_rig_destroy(&s.stitch.site.rig);
    if (w.options.log != NULL) {
        bool same = watch_replay(&w);
        printf("  %s, played back: %s\n", w.options.log, same ? "the same hashes" : "NOT THE SAME");
        t->failed += !same;
    }
    t->good += good;
    t->failed += result != VBSS_OK;
}

int main(int count, char **words)
{
    use_decimal_point();
    watch w = {.options = {.until = SURGEON_DONE}, .time_limit = 600.0, .every = 1e9};
    vbss_solver_options solver = vbss_solver_options_default();
    tally t = {.seeds = 1, .smallest = -1, .max_force = (double)INFINITY};
    bool whole = true; /* until a last stage is named */
    if (!read_options(count, words, &w, &t, &whole, &solver)) {
        return usage();
    }
    for (int i = 0; i < t.seeds; i++, w.options.seed++) {
        run(w, whole, &t);
    }
    printf("%d of %d\n", t.good, t.seeds);
    return t.good >= (t.smallest < 0 ? t.seeds : t.smallest) && t.failed == 0 ? 0 : 1;
}
