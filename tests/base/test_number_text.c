/* Numbers in texts: as the C locale has them. tests/locale checks them in a locale with a decimal comma. */
#include <math.h>

#include "base/number_text.h"
#include "harness/harness.h"

static void numbers_are_written_as_in_c(void **state)
{
    (void)state;
    assert_string_equal(vbss_format_number(0.5, 6).text, "0.5");
    assert_string_equal(vbss_format_number(-1.25e-7, 6).text, "-1.25e-07");
    assert_string_equal(vbss_format_number(1234567.0, 3).text, "1.23e+06");
    assert_string_equal(vbss_format_number(-0.1234567890123456789e-300, 17).text,
                        "-1.2345678901234567e-301");
    assert_string_equal(VBSS_NUMBER(3.0), "3");
    assert_string_equal(VBSS_NUMBER(HUGE_VAL), "inf");
}

int test_number_text(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(numbers_are_written_as_in_c)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
