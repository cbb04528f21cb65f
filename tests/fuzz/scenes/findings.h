/* Progress and findings of the scene fuzzer, in memory that the process which runs the scenes shares with the one
 * that watches it. So a crash or a hang is also known by its scene, call and function. */
#ifndef VBSS_TESTS_FUZZ_SCENES_FINDINGS_H
#define VBSS_TESTS_FUZZ_SCENES_FINDINGS_H

#include <stdbool.h>
#include <stdint.h>

typedef enum fuzz_check {
    FUZZ_CHECK_CRASH,      /* the process has died */
    FUZZ_CHECK_HANG,       /* a call took more than a second of CPU time */
    FUZZ_CHECK_IS_STALLED, /* a body that touches nothing has not moved */
    FUZZ_CHECK_REFUSED,    /* a refused call has changed the scene */
    FUZZ_CHECK_QUERY,      /* a query has changed the scene */
    FUZZ_CHECK_STATUS,     /* the twins returned different statuses */
    FUZZ_CHECK_TWIN,       /* the twins differ */
    FUZZ_CHECK_RESTORE,    /* the scene's own state was refused, or a damaged one was not */
    FUZZ_CHECK_NOT_FINITE, /* a position is infinite or no number */
    FUZZ_CHECK_SETUP,      /* the fuzzer itself asks for what is not possible */
    FUZZ_CHECKS
} fuzz_check;

enum { FUZZ_MAX_ROWS = 64, FUZZ_NAME_ROOM = 48 };

/* Failures of a check in a function. */
typedef struct fuzz_row {
    fuzz_check check;
    char function[FUZZ_NAME_ROOM];
    uint64_t count;
    /* The failure after the fewest calls. */
    uint64_t scene;
    uint32_t call;
} fuzz_row;

typedef struct fuzz_findings {
    uint64_t seed;
    double call_limit; /* CPU time of a call, s */
    bool is_traced;    /* each call is printed */
    /* Progress. */
    uint64_t scene;
    uint32_t call; /* from 1 on; 0: the scene is being built */
    char function[FUZZ_NAME_ROOM];
    /* Totals of this run. */
    uint64_t scenes, failures, calls, refused, suspended, grasps, cuts, holes;
    double slowest_call; /* s */
    fuzz_row rows[FUZZ_MAX_ROWS];
    uint32_t row_count;
} fuzz_findings;

/* In memory that child processes share; NULL: there is none. */
fuzz_findings *fuzz_share_findings(void);
/* Records a failure of the call in progress, and prints a line. */
void fuzz_record(fuzz_findings *findings, fuzz_check check, const char *detail);
/* One line for each check and function that failed, with the command that repeats its shortest case. */
void fuzz_print_summary(const fuzz_findings *findings);

#endif
