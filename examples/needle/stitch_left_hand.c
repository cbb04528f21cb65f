/* The left hand, whose jaws are a fork that bears a wall against the needle. */
#include "needle/stitch_parts.h"

#define DRAWN_BACK 2e-3    /* of it drawn back from a left wall, before the fork leaves that */
#define HELPED 2e-3        /* of it while the left hand still bears the wall */
#define HELPED_LONGER 3e-3 /* of it, each time that the needle was locked */
#define FORK_BEYOND 1.8e-3 /* of the fork's tips past the mark */
#define PUSH 4e-3          /* of the wall against the needle */

enum { DISTANCES = 5 }; /* from which it is set */
enum { FORKED = 10 };   /* settings of the fork under that */

/* The fork's tips have come in by the slit, and do not lie on the right wall from outside. */
bool stitch_is_under_wall(const stitch *t)
{
    vec from = v_sub(t->left.at, t->marks[SITE_RIGHT]);
    return v_dot(from, site_normal(&t->site, SITE_RIGHT)) < 0.0;
}

void stitch_enter_support(stitch *t, stitch_support support)
{
    t->support = support;
    t->support_since = 0.0;
}

/* The fork goes over the slit and in again, from farther on the near side, where its shaft is not in the needle's way; not always as far,
 * since from very far its jaws go over the slit's edge. */
void stitch_set_fork_again(stitch *t)
{
    /* m, spread up to 0.05, where the shaft is clear of the needle; one seed showed that this may be too far */
    static const double nearer[DISTANCES] = {0.025, 0.05, 0.0125, 0.0375, 0.0};
    hand_target(&t->left, t->left.nature.target_end);
    if (t->left_is_free) {
        hand_through(&t->left, v_along(STITCH_LEFT_TROCAR, -nearer[t->forked % DISTANCES],
                                       v3(0.0, 1.0, 0.0)));
    }
    stitch_enter_support(t, SUPPORT_OVER);
    if (++t->forked == FORKED) {
        stitch_fail(t, "the right wall is not supported");
    }
}

/* A wall that has tipped over the fork springs back as that leaves: not onto the tip, which would catch it aslant. */
static bool is_drawn_back(const stitch *t)
{
    return t->since * STITCH_DRIVE * t->right.nature.speed > DRAWN_BACK;
}

void stitch_lead_left(stitch *t)
{
    hand *h = &t->left;
    vec right = v_add(site_mark_at_rest(&t->site, SITE_RIGHT), t->beside),
        left = v_add(site_mark_at_rest(&t->site, SITE_LEFT), t->beside);
    double off = 0.5 * t->site.wall + h->shape.driver_radius;
    vec in = v_along(right, -off + 0.2e-3, site_normal_at_rest(&t->site, SITE_RIGHT));
    vec outer = site_normal_at_rest(&t->site, SITE_LEFT);
    vec on =
        v_along(v_along(left, off, outer), -STITCH_FORK_LOWER, v_cross(v3(0.0, 1.0, 0.0), outer));
    on = v_add(on, t->fork);
    vec direction = v_unit(v_sub(h->trocar, in)), tip = v_along(in, -FORK_BEYOND, direction);
    switch (t->support) {
    case SUPPORT_AWAY:
        if (t->since > 0.1 && t->state > STITCH_LIE) {
            hand_target(h, h->nature.target_end);
            stitch_enter_support(t, SUPPORT_OVER);
        }
        break;
    case SUPPORT_OVER:
        hand_go(h, v_along(tip, 0.02, direction), STITCH_CARRY);
        if (v_distance(h->at, v_add(v_along(tip, 0.02, direction), h->target_at)) < 0.5e-3) {
            stitch_enter_support(t, SUPPORT_UNDER);
        }
        break;
    case SUPPORT_UNDER:
        hand_go(h, tip, STITCH_CAREFUL);
        if (t->state <= STITCH_TARGET && t->support_since > STITCH_BORNE && stitch_is_there(h) &&
            !stitch_is_under_wall(t)) {
            stitch_set_fork_again(t);
            break;
        }
        if (t->state == STITCH_CROSS && t->gone >= STITCH_IN_LUMEN) {
            stitch_enter_support(t, SUPPORT_OUT);
        }
        break;
    case SUPPORT_OUT:
        hand_go(h, v_along(tip, 0.025, direction), STITCH_CARRY);
        if (v_distance(h->at, v_add(v_along(tip, 0.025, direction), h->target_at)) < 1e-3) {
            hand_through(h, STITCH_LEFT_TROCAR);
            stitch_enter_support(t, SUPPORT_BESIDE);
        }
        break;
    case SUPPORT_BESIDE:
        direction = v_unit(v_sub(h->trocar, on));
        hand_go(h, v_along(on, 4e-3, direction), STITCH_CARRY);
        if (t->state != STITCH_EASE &&
            v_distance(h->at, v_add(v_along(on, 4e-3, direction), h->target_at)) < 0.5e-3) {
            stitch_enter_support(t, SUPPORT_ON);
        }
        break;
    case SUPPORT_ON:
        direction = v_unit(v_sub(h->trocar, on));
        hand_go(h, v_along(on, -PUSH, direction), STITCH_CAREFUL);
        if (t->state == STITCH_EASE && is_drawn_back(t)) {
            stitch_enter_support(t, SUPPORT_BESIDE);
        } else if (t->out > HELPED + HELPED_LONGER * t->fork_returns) {
            stitch_enter_support(t, SUPPORT_BACK);
        }
        break;
    case SUPPORT_BACK:
        if (t->state == STITCH_EASE) {
            stitch_enter_support(t, SUPPORT_BESIDE);
            break;
        }
        direction = v_unit(v_sub(h->trocar, on));
        hand_go(h, v_along(on, 0.03, direction), STITCH_CARRY);
        break;
    }
}
