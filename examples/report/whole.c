/* The page, from its head to its foot. */
#include "report/page.h"

bool page_report(const facts *f, const pictures *shown, const char *to)
{
    page *p = page_create();
    if (p == NULL) {
        return false;
    }
    page_head(p, f);
    page_summary(p, f);
    page_debrief(p, f);
    page_timeline(p, f);
    page_bands(p, f);
    page_motion(p, f);
    page_accuracy(p, f);
    page_knot(p, f);
    page_simulation(p, f);
    page_pictures(p, shown);
    page_foot(p, f, shown);
    bool written = page_write(p, to);
    page_destroy(p);
    return written;
}
