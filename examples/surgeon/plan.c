/* What there is before the first step; also for who plays a log back. */
#include "surgeon/surgeon.h"

enum { SEGMENTS = 300 }; /* of the thread: SEGMENT each */

void surgeon_plan(const surgeon_options *o, stitch_plan *plan)
{
    *plan = (stitch_plan){
        .site = {.segments = SEGMENTS, .work = o->work}, .free_left = true, .skill = o->skill};
}
