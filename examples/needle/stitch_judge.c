/* What came of a stitch. */
#include "needle/stitch.h"

#define MAX_OFF 2e-3 /* of a hole from its mark */

bool stitch_is_through(const stitch *t, double off[2])
{
    bool near = true;
    for (int side = 0; side < 2; side++) {
        off[side] = t->holes[side] != 0 ? site_deviation(&t->site, &t->made[side], side) : -1.0;
        near = near && off[side] >= 0.0 && off[side] < MAX_OFF;
    }
    return t->state == STITCH_DONE && near && t->punctures == 2 && t->others == 0;
}
