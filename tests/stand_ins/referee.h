/* Counting illegal calls: the first is kept in words. */
#ifndef VBSS_TESTS_STAND_INS_REFEREE_H
#define VBSS_TESTS_STAND_INS_REFEREE_H

#include <stdio.h>

typedef struct referee {
    int count;
    char first[160];
} referee;

static inline void referee_refuse(referee *r, const char *call, const char *why)
{
    if (r->count++ == 0) {
        snprintf(r->first, sizeof r->first, "%s: %s", call, why);
    }
}

#endif
