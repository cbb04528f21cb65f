/* Dispatch between the plain and the wide copies of the line search. */
#include "contact/contact.h"

void vbss_contact_begin_line_search(contact_set *set, bool wide)
{
    VBSS_WIDE_CALL(wide, vbss_contact_begin_line_search, set);
}

double vbss_contact_line_search_slope(const contact_set *set, bool wide, double fraction)
{
    return VBSS_WIDE_CALL(wide, vbss_contact_line_search_slope, set, fraction);
}
