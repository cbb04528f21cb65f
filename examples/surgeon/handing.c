#include "surgeon/handing.h"

#define BEHIND 1.5e-3 /* the tool's tip */
#define LEAN 0.3      /* of a tool from the needle's axis, rad */
#define BEFORE 0.02   /* of jaws, along themselves, before they come */
#define WIDE 0.7      /* of the handle */
#define CARRY 0.08    /* m/s */
#define CAREFUL 0.03

/* Jaws across the needle there, so far before it. */
static pose before(const site *s, double arc_length, double distance)
{
    pose needle = site_needle(s);
    vec out = site_outward(s, arc_length);
    pose local = hold_grip(s, arc_length, BEHIND, LEAN, vbss_atan2(out.y, out.x));
    pose tool = pose_after(&needle, &local);
    tool.at = v_along(tool.at, distance, hand_rotate(tool.q, v3(0.0, 0.0, 1.0)));
    return tool;
}

static bool is_there(const hand *h, const pose *p, double within)
{
    pose now = hold_reported(h);
    return v_distance(h->at, v_add(p->at, h->target_at)) < within && pose_angle(&now, p) < 0.1;
}

handing_result handing_take(const site *s, hand *h, double arc_length, handing_part part,
                            double since)
{
    pose tool = before(s, arc_length, part == HANDING_BEFORE ? BEFORE : 0.0);
    hold_go(h, &tool, part == HANDING_BEFORE ? CARRY : CAREFUL);
    hand_open(h, part == HANDING_CLOSE ? 0.0 : WIDE);
    if (part == HANDING_CLOSE) {
        return h->holds && since >= 0.3 ? HANDING_HELD : HANDING_GOES_ON;
    }
    return is_there(h, &tool, part == HANDING_BEFORE ? 1e-3 : 0.3e-3) ? HANDING_NEXT
                                                                      : HANDING_GOES_ON;
}

pose handing_held(const site *s, const hand *h)
{
    pose now = hold_reported(h), back = pose_back(&now), needle = site_needle(s);
    return pose_after(&back, &needle);
}

bool handing_leave(hand *h, double since, pose *back, vec park)
{
    hand_open(h, since > 1.0 ? 0.0 : WIDE);
    if (since < 0.15) {
        *back = hold_reported(h);
        return false;
    }
    pose away = *back;
    away.at = v_along(away.at, 0.04, hand_rotate(away.q, v3(0.0, 0.0, 1.0)));
    hold_go(h, &away, CARRY);
    if (since > 1.0) {
        hand_go(h, park, CARRY);
    }
    return since > 0.8;
}
