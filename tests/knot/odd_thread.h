/* Threads that are no threads, heard by two detectors that must say the same. */
#ifndef VBSS_TESTS_KNOT_ODD_THREAD_H
#define VBSS_TESTS_KNOT_ODD_THREAD_H

#include "harness/harness.h"
#include "knot/judge.h"

enum { ODD_MAX = 8192 };

extern vec3 odd_x[ODD_MAX];
extern judge odd_judge;
extern judge_saying odd_said;

void odd_begin(uint32_t points, uint32_t crossings);
void odd_end(void);
/* Asserts that what is said of so many points is finite, agrees with itself, and is the same twice. `tissue`: half way. */
void odd_hear(uint32_t count, bool tissue);
void odd_expect_no_knot(void);

#endif
