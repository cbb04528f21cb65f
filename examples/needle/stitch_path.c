/* The path on which the needle is led through both walls. */
#include "needle/stitch_parts.h"

#define LEAD \
    0.35e-3 /* toward the slit, as the tip slides away from it on the wall before it enters */
#define TO_HOLES 0.3 /* s, in which the circle moves from the marks to the holes */

vec stitch_targeted(const stitch *t, int side)
{
    return v_add(v_add(t->marks[side], t->errors[side]), t->beside);
}

/* The needle with its tip at a point, straight through the wall there. */
static pose at_entry(const stitch *t)
{
    vec z = v3(0.0, 1.0, 0.0);
    vec y = v_scale(-1.0, site_normal_at_rest(&t->site, SITE_RIGHT));
    vec x = v_cross(y, z);
    return pose_of(v_along(t->entry, -t->site.radius, x), x, y, z);
}

pose stitch_entering(const stitch *t)
{
    pose p = at_entry(t);
    return pose_turned(&p, v3(0.0, 0.0, 1.0), t->gone / t->site.radius);
}

/* The left mark as it is seen; where the needle pushes it out, it is not followed. */
static vec exit_target(const stitch *t)
{
    vec rest = site_mark_at_rest(&t->site, SITE_LEFT), n = site_normal_at_rest(&t->site, SITE_LEFT);
    vec moved = v_sub(t->marks[SITE_LEFT], rest);
    moved = v_along(moved, -larger(v_dot(moved, n), 0.0), n);
    vec up = v_cross(v3(0.0, 1.0, 0.0), n);
    vec target_at = v_along(v_add(v_add(rest, t->errors[SITE_LEFT]), t->beside), LEAD, up);
    return v_add(v_add(target_at, t->trim), v_limit(moved, STITCH_FOLLOW));
}

/* From the circle on which the needle really lies to the left mark. */
vec stitch_miss(const stitch *t)
{
    pose needle = site_needle(&t->site);
    vec to = v_sub(stitch_targeted(t, SITE_LEFT), needle.at);
    vec z = hand_rotate(needle.q, v3(0.0, 0.0, 1.0)), flat = v_across(to, z);
    vec out = v_scale(v_length(flat) - t->site.radius, v_unit(flat));
    return v_along(out, v_dot(to, z), z);
}

/* By STITCH_FOLLOW at most: a needle that follows its holes without limit tears the drain off. */
static vec toward_hole(vec at_rest, vec hole, double share)
{
    return v_along(at_rest, share, v_limit(v_sub(hole, at_rest), STITCH_FOLLOW));
}

/* On the circle through the first hole and the left mark, above which its centre lies, so far beyond the hole. Once the needle is in both walls, the
 * circle goes through both holes: one through the marks at rest presses on the holes, and friction drags the drain along. */
pose stitch_crossing(const stitch *t)
{
    vec from = t->entry, to = exit_target(t);
    if (t->state == STITCH_DRAW) {
        const double share = smaller(1.0, t->since / TO_HOLES);
        from = toward_hole(from, t->hole[SITE_RIGHT], share);
        to = toward_hole(to, t->hole[SITE_LEFT], share);
    }
    vec e1 = v_unit(v_sub(from, to)), e3 = v_unit(v_across(v3(0.0, 0.0, 1.0), e1));
    double half = 0.5 * v_distance(from, to), r = t->site.radius;
    vec centre = v_along(v_mix(from, to, 0.5), sqrt(r * r - half * half), e3);
    vec x = v_unit(v_sub(from, centre)), z = v_cross(e3, e1);
    pose p = pose_of(centre, x, v_cross(z, x), z);
    return pose_turned(&p, v3(0.0, 0.0, 1.0), t->gone / r);
}
