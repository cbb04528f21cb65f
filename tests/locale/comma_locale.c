/* Sets a locale with a decimal comma before `main`, as a vendor's library may. Preloaded by check_locale.py. */
#include <locale.h>

__attribute__((constructor)) static void set_comma(void)
{
    (void)setlocale(LC_ALL, "comma");
}
