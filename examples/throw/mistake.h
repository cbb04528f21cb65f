/* Mistakes in a throw that the hands make knowingly, and what must be said of them. */
#ifndef VBSS_EXAMPLES_THROW_MISTAKE_H
#define VBSS_EXAMPLES_THROW_MISTAKE_H

#include "throw/trial.h"

const char *mistake_name(throw_mistake mistake);
/* THROW_NO_MISTAKE: there is none of that name. */
throw_mistake mistake_named(const char *name);
/* What the detector shall say of it. */
const char *mistake_wanted(throw_mistake mistake);
/* Whether it does, of a knot whose last throw was spoilt, so many throws and wraps of the last one were meant. */
bool mistake_is_reported(throw_mistake mistake, const trial_outcome *out, uint32_t throws,
                         int wraps);

#endif
