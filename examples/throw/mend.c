/* What the hands do when they are told of their mistake. */
#include "throw/states.h"

/* W's jaws open, and close again near the tail's end. */
static void take_tail_again(throw_run *t)
{
    hand *w = t->see->w;
    hand_open(w, t->plan.opening);
    catch_begin(&t->grip, t->see, w, t->plan.tail_node, t->plan.opening, 0.06);
    t->grip.behind = t->plan.behind;
    t->grip.minds = t->plan.minds;
    throw_enter(t, THROW_TAIL);
}

/* C goes back round W as it came, whatever W holds. */
static void unwind(throw_run *t, const throw_plan *plan)
{
    hand_open(t->see->w, 0.0);
    t->next = *plan;
    t->unwinds = true;
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
    if (mistake ==
        THROW_REVERSED) { /* W comes out of the turns: on its way back C would hook the limb */
        t->retries = 0;   /* what failed before was wound the other way, too */
        throw_fail(t, "wound the other way");
    } else if (mistake == THROW_COUNTER) { /* on, from the turns that are left */
        t->back = false;
        throw_enter(t, THROW_ORBIT);
    } else if (mistake == THROW_BIGHT || mistake == THROW_DROPPED) {
        take_tail_again(t);
    } else { /* both hands pull, from where they are */
        t->carrot_w = t->see->tool_w.tip;
        t->carrot_c = t->see->tool_c.tip;
        t->closed = 0.0;
    }
}
