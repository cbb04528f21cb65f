/* How far a long piece of work is: its stage, a percentage, the time that is left. */
#ifndef VBSS_EXAMPLES_DEMO_BAR_H
#define VBSS_EXAMPLES_DEMO_BAR_H

#include <stdbool.h>
#include <stdio.h>

typedef struct bar {
    FILE *to;
    bool terminal;       /* one line is drawn again and again; else a line now and then */
    double began, shown; /* s, by a clock that goes on */
    int percent;         /* that was shown last */
    const char *stage;   /* likewise */
} bar;

void bar_begin(bar *b, FILE *to);
/* `part` of all the work is done, 0 to 1. `stage` must outlive the bar. */
void bar_show(bar *b, const char *stage, double part);
/* Nothing of it stays on a terminal. */
void bar_end(bar *b);

#endif
