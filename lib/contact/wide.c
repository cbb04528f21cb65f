/* Which copy of the hot loops is run. */
#include "contact/contact.h"

void vbss_contact_begin_work(contact_set *set, bool wide)
{
    VBSS_WIDE_CALL(wide, vbss_contact_begin_work, set);
}

double vbss_contact_work(const contact_set *set, bool wide, double share)
{
    return VBSS_WIDE_CALL(wide, vbss_contact_work, set, share);
}
