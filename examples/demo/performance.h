/* One performance of the scripted surgeon, and all that is made of it while it goes on. */
#ifndef VBSS_EXAMPLES_DEMO_PERFORMANCE_H
#define VBSS_EXAMPLES_DEMO_PERFORMANCE_H

#include "demo/bar.h"
#include "demo/observer.h"
#include "surgeon/watch.h"

enum { MAX_OBSERVERS = 4, PATH_SIZE = 1024 };

typedef struct places {
    char log[PATH_SIZE], film[PATH_SIZE], stages[PATH_SIZE], page[PATH_SIZE], report[PATH_SIZE];
    char details[PATH_SIZE];
    const char *folder; /* of them and of the stills */
} places;

typedef struct performance {
    places at;
    watch watch;
    surgeon surgeon;
    facts facts;
    stage stage;
    observer observers[MAX_OBSERVERS];
    size_t count;
    bar bar;
    uint64_t steps;
    bool reported; /* the report page is written */
    vbss_result result;
} performance;

/* perform.c: makes it, and all files. False: something that can be had here is missing. */
bool perform(performance *p);
/* summary.c: what came of it, in plain words. */
void summary_put(FILE *to, const performance *p, bool whole, bool completed);

#endif
