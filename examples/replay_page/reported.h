/* What a session says beside its film: events, phases, the knot, forces. */
#ifndef VBSS_EXAMPLES_REPLAY_PAGE_REPORTED_H
#define VBSS_EXAMPLES_REPLAY_PAGE_REPORTED_H

#include "replay_page/film.h"
#include "report/facts.h"

/* As JSON; `steps` are those of the film's frames, which has so many. */
void reported_put(page *p, const facts *f, const film *shown, const uint64_t *steps);

#endif
