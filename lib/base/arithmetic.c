/* The floating-point mode that results depend on: round to nearest, with subnormals. */
#include <stdbool.h>

#include <vblast_ss/base.h>

vbss_result vbss_arithmetic_check(void)
{
    /* volatile forces the computation now, in the present mode. Rounding towards zero or down keeps
     * 1 in the first sum; rounding up does not keep 1 in the second; only round to nearest passes
     * both. */
    volatile double one = 1.0, three_quarter_ulp = 0x1.8p-53, quarter_ulp = 0x1p-54;
    volatile double smallest_normal = 0x1p-1022, half = 0.5;
    volatile double up = one + three_quarter_ulp, stay = one + quarter_ulp;
    volatile double negative_up = -one - three_quarter_ulp, subnormal = smallest_normal * half;
    /* The second product reads a subnormal, which the DAZ mode would replace by zero. */
    volatile double normal_again = subnormal * 2.0;
    bool nearest = up == 0x1.0000000000001p0 && stay == 1.0 && negative_up == -0x1.0000000000001p0;
    bool gradual = subnormal != 0.0 && normal_again == smallest_normal;
    return nearest && gradual ? VBSS_OK : VBSS_ERROR_ARITHMETIC_MODE;
}
