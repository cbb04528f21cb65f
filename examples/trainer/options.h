/* What the trainer is told on its command line. Words that it does not know, or numbers that are none, are refused. */
#ifndef VBSS_EXAMPLES_TRAINER_OPTIONS_H
#define VBSS_EXAMPLES_TRAINER_OPTIONS_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

enum { LEFT = 0, RIGHT = 1, HANDS = 2 };
enum { NAME_BYTES = 128, MAX_FAULTS = 8 };

/* A fault of the stand-ins or of a mock, to see what comes of it. */
typedef struct fault_plan {
    char name[24];
    double from, until; /* s */
} fault_plan;

typedef struct options {
    bool list, calibrate, simulated, mock;
    const char *scene;
    /* Of the core, operations per us; 0: the budgets of work are fixed; below 0: measured at the start. */
    double core_speed;
    double seconds; /* at most; below 0: until Ctrl-C, or the log's end */
    const char *calibration;
    const char *replay;
    const char *exercise, *starts, *progress; /* NULL: none */
    uint32_t arm_count;                       /* 0: none */
    char arms[HANDS][NAME_BYTES];             /* empty: the library's default */
    const char *openhaptics_library;
    uint32_t handle_count;
    char inputs[HANDS][NAME_BYTES], lines[HANDS][NAME_BYTES];
    const char *nidaq_library;
    fault_plan faults[MAX_FAULTS];
    uint32_t fault_count;
} options;

/* False: `why` says what is wrong. */
bool options_read(int count, char **words, options *o, char *why, size_t bytes);
void options_help(void);

#endif
