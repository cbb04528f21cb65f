/* What there is before the first step; also for who plays a log back. */
#include "surgeon/surgeon.h"

#define IDLE_TIME 5.0 /* s: who is idle need not be watched for 600 */

enum { SEGMENTS = 300 }; /* of the thread: SEGMENT each */

void surgeon_plan(const surgeon_options *o, stitch_plan *plan)
{
    *plan = (stitch_plan){.site = {.segments = o->segments > 0 ? o->segments : SEGMENTS,
                                   .solver = o->solver,
                                   .mirrored = o->left_handed,
                                   .material = o->material},
                          .free_left = true,
                          .skill = o->skill};
}

task_plan surgeon_task_plan(const surgeon_options *o)
{
    return (task_plan){.time_limit = o->mistake == SURGEON_IDLE ? IDLE_TIME : 0.0,
                       .coaching = o->coaching || o->mistake != SURGEON_NO_MISTAKE};
}
