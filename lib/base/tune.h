/* Definition of a tuned number: the number itself, or a variable in a library built with VBSS_TUNING.
 *
 * Each folder of lib/ lists its tuned numbers in its tuning.h. A build with VBSS_TUNING is for the bench `tuning` only: it
 * includes tuning_variables.h first, in which bench/tuning/variables.py declares a variable vbss_tuned_NAME for each. */
#ifndef VBSS_BASE_TUNE_H
#define VBSS_BASE_TUNE_H

#ifdef VBSS_TUNING
#define VBSS_TUNE(name, value) vbss_tuned_##name
#else
#define VBSS_TUNE(name, value) (value)
#endif

#endif
