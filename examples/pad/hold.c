/* An assistant holds the knot until the next throw is on it: both ends where they come out of it. Without that the lips draw the thread
 * back through a throw whose ends are slack, and the hands that wind the next one pull it open. */
#include "base/error.h"
#include "pad.h"

enum { GRIP = 6 };               /* nodes from the knot to where it is held */
static const double arm = 500.0; /* N/m: gives in by 0.1 mm at the 0.05 N that keep a throw shut */
static const double tight = 0.3; /* N, of the limb: the next throw has come down */

static vbss_result hold(pad *p)
{
    const tie_thread *s = &p->tie.thread;
    VBSS_TRY(scripted_take(&p->held[0], s->thread, s->limb_root - GRIP, arm));
    return scripted_take(&p->held[1], s->thread, s->tail_root + GRIP, arm);
}

static vbss_result let_go(pad *p)
{
    VBSS_TRY(scripted_release(&p->held[0], p->tie.thread.thread));
    return scripted_release(&p->held[1], p->tie.thread.thread);
}

vbss_result pad_hold_knot(pad *p, bool has_locked)
{
    const pad_tie *t = &p->tie;
    const bool is_held = p->held[0].attachment != 0;
    if (!is_held && has_locked && t->throws < TIE_THROWS) {
        return hold(p);
    }
    return is_held && t->state == TIE_PULL && t->c.tension > tight ? let_go(p) : VBSS_OK;
}
