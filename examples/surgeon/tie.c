#include "surgeon/surgeon.h"

/* Where the thread goes through the drain, as places along it from the tail's end. */
static void find_marks(surgeon *s)
{
    stand *st = &s->stitch.site.stand;
    for (int side = 0; side < 2; side++) {
        vbss_hole hole;
        if (site_find_hole(&s->stitch.site, s->stitch.holes[side], &hole) && hole.thread != 0) {
            st->marks[side == SITE_RIGHT ? 0 : 1] =
                (uint32_t)(stand_place(st, hole.arc_length) + 0.5);
        }
    }
}

vbss_result surgeon_begin_tie(surgeon *s)
{
    stitch *t = &s->stitch;
    throw_plan plan;
    find_marks(s);
    TRY(senses_create(&s->see, &t->site.stand, &t->left, &t->right));
    TRY(senses_look(&s->see));
    throw_plan_usual(&plan, 2);
    plan.wrap_tip = v3(0.014, 0.0, 0.07);
    plan.tension = 0.03;
    hand_through(&t->left, v3(-0.3, 0.03, 0.07));
    hand_through(&t->right, v3(0.3, -0.05, 0.1));
    throw_begin(&s->tie, &s->see, &plan);
    return VBSS_OK;
}

vbss_result surgeon_tie(surgeon *s, double dt)
{
    find_marks(s);
    s->tie.tail_root = s->see.tail_root = s->stitch.site.stand.marks[0];
    s->tie.limb_root = s->see.limb_root = s->stitch.site.stand.marks[1];
    TRY(senses_look(&s->see));
    if (s->steps % 10 == 0) {
        TRY(senses_wind(&s->see));
    }
    return throw_step(&s->tie, dt);
}
