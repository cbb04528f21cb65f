/* Formats numbers independently of the locale. A host or a library that it loads may set a locale
 * with a decimal comma at any time, and the C library then prints and reads commas. */
#include <stdbool.h>
#include <stdio.h>
#include <string.h>

#include "base/number_text.h"

/* Whether a number has this character in the C locale. All others are the separator. */
static bool is_usual(char c)
{
    static const char usual[] = "0123456789+-.eEinfaINFA";
    for (size_t i = 0; i + 1 < sizeof usual; i++) {
        if (c == usual[i]) {
            return true;
        }
    }
    return false;
}

vbss_number_text vbss_format_number(double value, int digits)
{
    vbss_number_text number;
    snprintf(number.text, sizeof number.text, "%.*g", digits, value);
    char *separator = number.text;
    while (is_usual(*separator)) {
        separator++;
    }
    if (*separator != '\0') { /* it may have several bytes */
        char *rest = separator;
        while (*rest != '\0' && !is_usual(*rest)) {
            rest++;
        }
        *separator = '.';
        memmove(separator + 1, rest, strlen(rest) + 1);
    }
    return number;
}
