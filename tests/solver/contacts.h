/* Contacts: couplings of separators far apart, and what is added to the separators unsymmetrically, both
 * into the library's system and into the plain one. */
#ifndef VBSS_TESTS_CONTACTS_H
#define VBSS_TESTS_CONTACTS_H

#include "solver/twin.h"

/* Couples so many pairs of separators, of any chains; fewer where there are not so many. */
void contacts_draw(twin *t, harness_source *source, uint32_t count);
/* Arcs of separators with runs between, in one chain or in one each, and contacts of two neighbours in one
 * arc with two neighbours in another: with numbers, ready to be registered. */
void contacts_draw_knot(twin *t, harness_source *source, uint32_t max_separators);
/* Between take and solve. */
void contacts_add(twin *t, harness_source *source);

#endif
