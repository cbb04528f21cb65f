/* Formats numbers independently of the locale. A host or a library that it loads may set a locale
 * with a decimal comma at any time, and the C library then prints and reads commas. */
#include <stdio.h>
#include <string.h>

#include "base/number_text.h"

vbss_number_text vbss_format_number(double value, int digits)
{
    /* all characters that a number has in the C locale; any others are the separator */
    static const char usual[] = "0123456789+-.eEinfaINFA";
    vbss_number_text number;
    snprintf(number.text, sizeof number.text, "%.*g", digits, value);
    char *separator = number.text + strspn(number.text, usual);
    if (*separator != '\0') { /* it may have several bytes */
        char *rest = separator + strcspn(separator, usual);
        *separator = '.';
        memmove(separator + 1, rest, strlen(rest) + 1);
    }
    return number;
}
