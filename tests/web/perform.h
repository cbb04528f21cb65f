/* The scripted surgeon before the page: it sees the scene, and tells where its hands want their tools; controllers lead them. A
 * module for tests, which has these calls beside those of page.h. */
#ifndef VBSS_TESTS_WEB_PERFORM_H
#define VBSS_TESTS_WEB_PERFORM_H

#include "web/page.h"

/* The whole stitch, as page_begin begins it; the surgeon acts in each page_step. */
PAGE_CALL(int32_t, page_perform)(uint32_t seed);
/* Of a hand: place of the tool's tip, m; quaternion w, x, y, z; opening; 1 if it wants shears; 1 when the surgeon has ended. */
PAGE_CALL(const double *, page_wanted)(int32_t side);
/* What the surgeon does, or why it failed. */
PAGE_CALL(const char *, page_doing)(void);

#endif
