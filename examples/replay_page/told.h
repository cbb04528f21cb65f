/* What a session says beside its film: events, phases, the knot, forces. */
#ifndef VBSS_EXAMPLES_REPLAY_PAGE_TOLD_H
#define VBSS_EXAMPLES_REPLAY_PAGE_TOLD_H

#include "replay_page/film.h"
#include "report/facts.h"

/* As JSON; `steps` are those of the film's frames, which has so many. */
void told_put(page *p, const facts *f, const film *shown, const uint64_t *steps);

#endif
