/* Numbers with a decimal point in every locale. A program calls this first in `main`, and first in each thread that prints
 * numbers: a vendor's library may set the locale of the process while it is loaded, as those that use Qt do. */
#ifndef VBSS_EXAMPLES_DECIMAL_POINT_H
#define VBSS_EXAMPLES_DECIMAL_POINT_H

#include <locale.h>

static inline void use_decimal_point(void)
{
    (void)setlocale(LC_NUMERIC, "C");
#ifdef LC_NUMERIC_MASK /* POSIX: a locale of this thread, which setlocale does not change */
    locale_t c = newlocale(LC_NUMERIC_MASK, "C", (locale_t)0);
    if (c != (locale_t)0) {
        (void)uselocale(c);
    }
#endif
}

#endif
