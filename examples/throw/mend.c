/* The hands mend a mistake that somebody has named. */
#include "throw/states.h"

/* C goes back round W as it came, whatever W holds. */
static void unwind(throw_run *t, const throw_plan *plan)
{
    hand_open(t->see->w, 0.0);
    t->next = *plan;
    t->unwinds = true;
    t->retries++;
    t->plan.mistake = THROW_NO_MISTAKE;
    throw_enter(t, THROW_ORBIT);
}

void throw_mend(throw_run *t, const throw_plan *plan)
{
    const throw_mistake mistake = t->plan.mistake;
    t->clear = 0.0;
    if (mistake == THROW_TO_HANDLE) {
        unwind(t, plan);
        return;
    }
    t->plan = *plan;
    if (mistake == THROW_REVERSED) {
        /* W comes out of the turns, since C would hook the limb on its way back. Tries that failed were wound the other
         * way, too, and do not count. */
        t->retries = 0;
        throw_fail(t, "wound the other way");
    } else if (mistake == THROW_COUNTER) { /* on, from the turns that are left */
        t->back = false;
        throw_enter(t, THROW_ORBIT);
    } else if (mistake == THROW_BIGHT || mistake == THROW_DROPPED) {
        throw_take_tail(t, t->plan.tail_node);
    } else { /* both hands pull, from where they are */
        t->carrot_w = t->see->tool_w.tip;
        t->carrot_c = t->see->tool_c.tip;
        t->closed = 0.0;
    }
}
