/* The surgeon hears of a mistake from the coach, and mends it. */
#include "surgeon/surgeon.h"

/* Nodes from the tail's end: 11 mm, of the 15 to 20 that there are. */
enum { TAIL_MIDDLE = 22 };

/* The throw that is to be spoilt: a granny needs one below it. */
static bool is_spoilt_stage(const surgeon *s)
{
    return s->stage == (s->mistake == SURGEON_GRANNY ? SURGEON_SECOND : SURGEON_TIE);
}

void surgeon_spoil(const surgeon *s, throw_plan *plan)
{
    const throw_mistake mistake = surgeon_mistake_in_throw(s->mistake);
    if (mistake != THROW_NO_MISTAKE && is_spoilt_stage(s)) {
        if (s->stage != SURGEON_TIE) {
            throw_plan_back(plan);
        }
        throw_plan_spoil(plan, mistake);
        plan->tail_node = mistake == THROW_BIGHT ? TAIL_MIDDLE : plan->tail_node;
        plan->waits = s->mends;
    }
}

/* The plan of the present throw without its mistake. The limb has not become longer. */
static void find_plan(const surgeon *s, throw_plan *plan)
{
    if (s->stage == SURGEON_TIE) {
        surgeon_plan_tie(plan);
    } else {
        surgeon_plan_later(s, senses_length(&s->see, s->tie.limb_root, s->see.c->node), plan);
    }
}

void surgeon_mend(surgeon *s, vbss_session_mistake coached)
{
    throw_plan plan;
    if (s->stage == SURGEON_PASS && (coached == VBSS_SESSION_MISTAKE_ENTRY_MISSED ||
                                     coached == VBSS_SESSION_MISTAKE_NEEDLE_WITHDRAWN)) {
        stitch_mend(&s->stitch);
        return;
    }
    s->tie.plan.other_end = s->stage == SURGEON_TIE && coached == VBSS_SESSION_MISTAKE_CAPSIZED;
    if (coached != surgeon_mistake_coached(s->mistake)) {
        return;
    }
    if (surgeon_mistake_in_throw(s->mistake) != THROW_NO_MISTAKE && is_spoilt_stage(s)) {
        s->mistake = SURGEON_NO_MISTAKE;
        find_plan(s, &plan);
        throw_mend(&s->tie, &plan);
    } else if (s->mistake == SURGEON_TORN) {
        s->mistake = SURGEON_NO_MISTAKE;
        s->lowers = true;
    }
}
