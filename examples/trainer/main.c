/* The example driver: arms, handles and solenoids on a scene at 1 kHz. `trainer` alone tells how; docs/guides/trainer.md has wiring
 * and set-up. */
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "decimal_point.h"
#include "exercise/progress.h"
#include "exercise/starts.h"
#include "trainer/coach.h"
#include "trainer/screen.h"

enum { GOOD = 0, FAULTY = 1, WRONG_WORD = 2, NOT_THERE = 3 };

#define SHOW_NS 200000000 /* 5 times a second */

static volatile sig_atomic_t interrupted;

static void interrupt(int signal_number)
{
    (void)signal_number;
    interrupted = 1;
}

static int refuse(int status, const char *what, const char *why)
{
    fprintf(stderr, "trainer: %s%s%s\n", what, what[0] != '\0' ? ": " : "", why);
    return status;
}

/* ---- a run */

/* False, told on standard error: it is not written. */
static bool note_progress(const task *t)
{
    vbss_session_exercise_state e;
    progress p;
    char why[300];
    if (t->options->progress == NULL || !stage_has_outcome(&t->stage, &e)) {
        return true;
    }
    if (!progress_note(t->options->progress, &e, &p, why, sizeof why)) {
        return refuse(FAULTY, why, "the file stays as it is") == GOOD;
    }
    const progress_row *row = &p.rows[e.exercise];
    printf("progress: %u of %u passed, %u without aids\n", row->passed, row->attempts,
           row->unaided);
    return true;
}

static int watch(task *t)
{
    pthread_t thread;
    screen s;
    char system[160];
    const struct timespec pause = {.tv_nsec = SHOW_NS};
    task_init(t);
    if (!step_clock_start(&thread, task_run, t, t->options->simulated, system, sizeof system)) {
        return refuse(NOT_THERE, "", "no thread for the task");
    }
    screen_begin(&s);
    while (!atomic_load(&t->ended)) {
        (void)nanosleep(&pause, NULL);
        if (interrupted != 0) {
            atomic_store(&t->end, true);
        }
        screen_show(&s, t, exchange_take(&t->shown), system);
    }
    (void)pthread_join(thread, NULL);
    screen_end(&s);
    hardware_close(&t->hardware);
    bool good = screen_report(t, system);
    return note_progress(t) && good ? GOOD : FAULTY;
}

/* Real hardware is not broken on purpose. */
static const char *find_missing_fault(const options *o, const rehearsal *r)
{
    for (uint32_t i = 0; i < o->fault_count; i++) {
        const fault_row *row = rehearsal_fault(o->faults[i].name);
        bool arms = r->hd != NULL && row->arm >= 0, lines = r->daq != NULL && row->lines >= 0;
        bool mock = o->arm_count < HANDS && row->mock >= 0;
        if (!arms && !lines && !mock && row->clock == 0.0) {
            return row->name;
        }
    }
    return NULL;
}

/* Fixed budgets where the option wants them, or where no clock measures. */
static const vbss_solver_options *find_budgets(const options *o, vbss_solver_options *solver,
                                               task *t)
{
    if (o->core_speed == 0.0) {
        return NULL;
    }
    *solver = vbss_solver_options_default();
    const bool good = core_speed_fit(o->core_speed, solver, t->limits) == VBSS_OK;
    printf("%s\n", t->limits);
    return good ? solver : NULL;
}

static void show_making(void *user, double seconds)
{
    (void)user;
    fprintf(stderr,
            "\rtrainer: the scripted surgeon makes the starts of exercises: %.0f s of about 77 s ",
            seconds);
}

static bool make_starts(start_states *states, const char *path)
{
    char why[300];
    starts_free(states);
    bool good = starts_make(states, NULL, show_making, NULL);
    fputc('\n', stderr);
    if (good && !starts_write(states, path, why, sizeof why)) {
        fprintf(stderr, "trainer: %s: they are made again the next time\n", why);
    }
    return good;
}

/* States that are missing, damaged or of another version of the library are made anew. */
static vbss_result create_exercise(stage *s, const options *o, const vbss_solver_options *solver)
{
    const char *path = o->starts != NULL ? o->starts : "exercise.starts";
    vbss_session_exercise exercise = practice_named(o->exercise);
    start_states states = {.memory = NULL};
    char why[300];
    if (practice_place(exercise) != START_NEW) {
        (void)starts_read(&states, path, why, sizeof why);
    }
    vbss_result result = stage_create_exercise(s, exercise, &states, solver);
    if (result != VBSS_OK && practice_place(exercise) != START_NEW && make_starts(&states, path)) {
        stage_destroy(s);
        result = stage_create_exercise(s, exercise, &states, solver);
    }
    starts_free(&states);
    return result;
}

static vbss_result create_stage(stage *s, const options *o, const stage_row *row,
                                unsigned long seed, const vbss_solver_options *solver)
{
    return o->exercise != NULL ? create_exercise(s, o, solver) : stage_create(s, row, seed, solver);
}

static int run(const options *o, const calibration *c, const score *log, const stage_row *row)
{
    static task t;
    const char *missing;
    char why[512];
    vbss_solver_options solver;
    t.options = o;
    t.calibration = c;
    t.duration = o->seconds < 0.0 && log != NULL ? log->duration : o->seconds;
    if (create_stage(&t.stage, o, row, log != NULL ? log->seed : 0, find_budgets(o, &solver, &t)) !=
        VBSS_OK) {
        stage_destroy(&t.stage);
        return refuse(NOT_THERE, row->name, "the scene cannot be made");
    }
    rehearsal_find(&t.rehearsal, o);
    rehearsal_begin(&t.rehearsal, o->simulated);
    int status = NOT_THERE;
    if (o->simulated && ((o->arm_count > 0 && t.rehearsal.hd == NULL) ||
                         (o->handle_count > 0 && t.rehearsal.daq == NULL))) {
        (void)refuse(status, "--simulated", "the hardware has a clock of its own");
    } else if ((missing = find_missing_fault(o, &t.rehearsal)) != NULL) {
        (void)refuse(status, missing, "no stand-in or mock that is in use has this fault");
    } else if (o->calibrate) {
        calibration found = *c;
        status = coach_run(o, &found, &t.rehearsal, &t.stage);
    } else if (hardware_open(&t.hardware, o, c, &t.stage, log, why, sizeof why)) {
        status = watch(&t);
    } else {
        (void)refuse(status, "", why);
    }
    stage_destroy(&t.stage);
    rehearsal_end(&t.rehearsal);
    return status;
}

/* ---- what it is told */

static bool knows_faults(const options *o)
{
    for (uint32_t i = 0; i < o->fault_count; i++) {
        if (rehearsal_fault(o->faults[i].name) == NULL) {
            return false;
        }
    }
    return true;
}

static int run_with_files(const options *o, const stage_row *row)
{
    calibration c;
    score log = {.count = 0};
    char why[256];
    if (calibration_init(&c) != VBSS_OK) {
        return NOT_THERE;
    }
    if (o->calibration != NULL && !o->calibrate &&
        !calibration_read(&c, o->calibration, why, sizeof why)) {
        return refuse(NOT_THERE, o->calibration, why);
    }
    if (o->replay != NULL && !score_read(&log, o->replay, why, sizeof why)) {
        return refuse(NOT_THERE, o->replay, why);
    }
    for (int side = 0; side < HANDS && !o->calibrate; side++) {
        if (!c.known[side] && ((uint32_t)side < o->arm_count || (uint32_t)side < o->handle_count)) {
            fprintf(stderr, "trainer: the %s hand is not calibrated: see --calibrate\n",
                    side == LEFT ? "left" : "right");
        }
    }
    int status = run(o, &c, o->replay != NULL ? &log : NULL, row);
    score_free(&log);
    return status;
}

int main(int count, char **words)
{
    use_decimal_point();
    options o;
    char why[256];
    if (count == 1 || strcmp(words[1], "--help") == 0) {
        options_help();
        return count == 1 ? WRONG_WORD : GOOD;
    }
    if (!options_read(count, words, &o, why, sizeof why)) {
        return refuse(WRONG_WORD, "", why);
    }
    const stage_row *row = stage_find(o.scene);
    if (row == NULL) {
        return refuse(WRONG_WORD, o.scene, "no such scene");
    }
    if (o.exercise != NULL && practice_named(o.exercise) == VBSS_SESSION_EXERCISE_NONE) {
        return refuse(WRONG_WORD, o.exercise, "no such exercise");
    }
    if (!knows_faults(&o)) {
        return refuse(WRONG_WORD, "--fault", "no such fault");
    }
    if (o.list) {
        for (size_t i = 0; stage_at(i) != NULL; i++) {
            printf("scene %s: %s\n", stage_at(i)->name, stage_at(i)->what);
        }
        return hardware_list(&o) ? GOOD : NOT_THERE;
    }
    const struct sigaction on_interrupt = {.sa_handler = interrupt};
    (void)sigaction(SIGINT, &on_interrupt, NULL);
    (void)sigaction(SIGTERM, &on_interrupt, NULL);
    return run_with_files(&o, row);
}
