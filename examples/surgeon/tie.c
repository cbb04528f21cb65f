#include "surgeon/surgeon.h"

/* Where a line through the left tool's shaft goes: level while it is wound about and draws, steep when it takes the tail,
 * which lies on the drain and beyond. */
#define LEVEL v3(-0.3, 0.03, 0.07)
#define STEEP v3(-0.15, -0.02, 0.2)
#define SWAY 0.2 /* m/s, from one to the other */
#define RIGHT_LINE v3(0.3, -0.05, 0.1)
#define WRAP_TIP v3(0.014, 0.0, 0.07)
#define WINDING \
    0.03           /* N, that the right hand gives way to while it winds: more draws the tail in */
#define LOW 0.02   /* m below the drain's top, to where both hands pull */
#define ENOUGH 1.0 /* N, of both hands, if the slit is shut */
#define SHUT 0.45e-3 /* m */
#define A_MOMENT 0.3 /* s */

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
    plan.wrap_tip = WRAP_TIP;
    plan.tension = WINDING;
    plan.alike = true; /* the drain gives way to what is pulled unlike */
    plan.low = LOW;
    hand_through(&t->left, LEVEL);
    hand_through(&t->right, RIGHT_LINE);
    throw_begin(&s->tie, &s->see, &plan);
    return VBSS_OK;
}

static void sway(surgeon *s, double dt)
{
    hand *h = &s->stitch.left;
    bool steep = s->tie.state == THROW_TAIL || s->tie.state == THROW_CLOSE;
    vec way = v_sub(steep ? STEEP : LEVEL, h->trocar);
    hand_through(h, v_add(h->trocar, v_limit(way, SWAY * h->nature.speed * dt)));
}

vbss_result surgeon_tie(surgeon *s, double dt)
{
    find_marks(s);
    sway(s, dt);
    s->tie.tail_root = s->see.tail_root = s->stitch.site.stand.marks[0];
    s->tie.limb_root = s->see.limb_root = s->stitch.site.stand.marks[1];
    TRY(senses_look(&s->see));
    if (s->steps % 10 == 0) {
        TRY(senses_wind(&s->see));
    }
    TRY(throw_step(&s->tie, dt));
    bool shut = s->tie.state == THROW_SEAT && s->gap < SHUT && s->see.tension_w > ENOUGH &&
                s->see.tension_c > ENOUGH;
    s->shut = shut ? s->shut + dt : 0.0;
    if (s->shut > A_MOMENT) { /* more might shift its lips past each other */
        s->tie.state = THROW_DONE;
    }
    return VBSS_OK;
}
