/* What is shown while the task runs, and told at its end. */
#ifndef VBSS_EXAMPLES_TRAINER_SCREEN_H
#define VBSS_EXAMPLES_TRAINER_SCREEN_H

#include "trainer/task.h"

typedef struct screen {
    bool terminal; /* one screen, drawn again and again; else lines */
    double before; /* wall, at the figures shown last, s */
    uint64_t slots;
    double rate; /* Hz */
} screen;

void screen_begin(screen *s);
void screen_show(screen *s, const task *t, const figures *f, const char *system);
void screen_end(const screen *s);
/* The report. False: something failed. */
bool screen_report(const task *t, const char *system);

#endif
