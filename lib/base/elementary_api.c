/* The public elementary functions: those of base/elementary.h in the library's floating-point mode.
 *
 * The computation is in another file, so no compiler can move it across the change of mode. */
#include <vblast_ss/elementary.h>

#include "base/api_call.h"
#include "base/elementary.h"

double vbss_sin(double angle)
{
    vbss_call call;
    vbss_call_enter(&call, NULL);
    const double sine = vbss_sine(angle);
    vbss_call_leave(&call);
    return sine;
}

double vbss_cos(double angle)
{
    vbss_call call;
    vbss_call_enter(&call, NULL);
    const double cosine = vbss_cosine(angle);
    vbss_call_leave(&call);
    return cosine;
}

double vbss_atan2(double y, double x)
{
    vbss_call call;
    vbss_call_enter(&call, NULL);
    const double angle = vbss_arc_tangent(y, x);
    vbss_call_leave(&call);
    return angle;
}

double vbss_acos(double cosine)
{
    vbss_call call;
    vbss_call_enter(&call, NULL);
    const double angle = vbss_arc_cosine(cosine);
    vbss_call_leave(&call);
    return angle;
}
