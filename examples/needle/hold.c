#include "needle/hold.h"

#define SEEING 0.1 /* s: what is seen is told so late */

pose hold_reported(const hand *h)
{
    pose p = {.at = h->at};
    memcpy(p.q, h->face, sizeof p.q);
    return p;
}

void hold_go(hand *h, const pose *p, double speed)
{
    hand_go(h, p->at, speed);
    hand_face(h, p->q);
}

pose hold_grip(const site *s, double arc_length, double behind, double lean, double up)
{
    vec out = site_outward(s, arc_length);
    vec z = v3(vbss_sin(lean) * vbss_cos(up), vbss_sin(lean) * vbss_sin(up), -vbss_cos(lean));
    vec x = v_unit(v_across(out, z));
    return pose_of(v_along(v_scale(s->radius, out), -behind, z), x, v_cross(z, x), z);
}

void hold_see(pose *held, const hand *h, const site *s, double dt)
{
    pose tool = hold_reported(h), back = pose_back(&tool), needle = site_needle(s);
    pose now = pose_after(&back, &needle);
    *held = pose_mix(held, &now, dt / SEEING);
}

void hold_steer(hand *h, const pose *held, const pose *needle, double speed)
{
    pose back = pose_back(held), tool = pose_after(needle, &back);
    hold_go(h, &tool, speed);
}

double hold_off(const site *s, const pose *needle)
{
    pose now = site_needle(s);
    return v_distance(now.at, needle->at) + s->radius * pose_angle(&now, needle);
}
