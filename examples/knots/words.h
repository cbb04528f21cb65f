/* What a detector's answers are called, in ASCII. */
#ifndef VBSS_EXAMPLES_WORDS_H
#define VBSS_EXAMPLES_WORDS_H

#include <stddef.h>

#include <vblast_ss/knot.h>

enum { WORD_TAGS = 192 }; /* bytes, enough for all of them */

const char *words_of_name(vbss_knot_name name);
const char *words_of_result(vbss_knot_verdict result);
/* "2 wraps, right-handed, certified" and what its flags say. */
void words_of_throw(const vbss_knot_throw *t, char text[WORD_TAGS]);
/* "no faults", or what keeps it from being 2=1=1. */
void words_of_faults(uint32_t faults, char text[WORD_TAGS]);

#endif
