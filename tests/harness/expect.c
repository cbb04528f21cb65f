/* Assertions that name what they looked at. */
#include <math.h>
#include <string.h>

#include "harness/harness.h"

uint64_t harness_bits(double value)
{
    uint64_t bits;
    memcpy(&bits, &value, sizeof bits);
    return bits;
}

void harness_expect(vbss_result wanted, vbss_result got, const char *call, const char *file,
                    int line)
{
    if (wanted != got) {
        print_error("%s\n    is %s where %s is wanted\n", call, vbss_result_name(got),
                    vbss_result_name(wanted));
        _fail(file, line);
    }
}

void harness_near(double wanted, double got, double tolerance, const char *what, const char *file,
                  int line)
{
    if (!(fabs(got - wanted) <= tolerance)) {
        print_error("%s\n    is %.17g where %.17g +- %g is wanted\n", what, got, wanted, tolerance);
        _fail(file, line);
    }
}

void harness_near_vec3(vec3 wanted, vec3 got, double tolerance, const char *what, const char *file,
                       int line)
{
    if (!(vec3_distance(wanted, got) <= tolerance)) {
        print_error(
            "%s\n    is (%.17g, %.17g, %.17g) where (%.17g, %.17g, %.17g) +- %g is wanted\n", what,
            got.x, got.y, got.z, wanted.x, wanted.y, wanted.z, tolerance);
        _fail(file, line);
    }
}

void harness_known_limit(double wanted, double today, double got, const char *what,
                         const char *file, int line)
{
    if (!(got <= today)) {
        print_error("%s\n    is %g: worse than the known limit, %g\n", what, got, today);
        _fail(file, line);
    }
    if (got <= wanted) {
        print_error("%s\n    is %g: the known limit is gone, make %g the rule of this test\n", what,
                    got, wanted);
        _fail(file, line);
    }
}

void harness_same_bits(double wanted, double got, const char *what, const char *file, int line)
{
    if (harness_bits(wanted) != harness_bits(got)) {
        print_error("%s\n    is %a where %a is wanted, to the bit\n", what, got, wanted);
        _fail(file, line);
    }
}
