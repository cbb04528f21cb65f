/* Some cases of every family that has a truth, made once, and a detector that hears them. */
#ifndef VBSS_TESTS_KNOT_CASES_H
#define VBSS_TESTS_KNOT_CASES_H

#include "harness/harness.h"
#include "knot/judge.h"

extern judge cases_judge;

/* Of a group of tests. */
int begin_cases(void **state);
int end_cases(void **state);

typedef void (*cases_check)(const family_case *c);
void on_all_cases(cases_check holds);
void cases_hear(const family_case *c, judge_saying *saying);

#endif
