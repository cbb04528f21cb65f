/* A stitch as it begins: the site, and both hands with their tools. */
#include "needle/stitch.h"

#define JAW_RADIUS 0.25e-3 /* fine enough to take a needle that lies flat on the floor */
#define LEFT_POINT v3(0.56, 0.0, 0.83) /* so that it opens along the drain */
#define NECK 5e-3 /* of the left tool, if it has no trocar and shall be wound about */
#define FORK 0.56 /* of the left handle: a needle goes between its jaws */

static double between(uint64_t *random, double low, double high)
{
    return low + (high - low) * hand_chance(random);
}

static vbss_result make_hands(stitch *t, const hand_nature *nature, bool free_left)
{
    vbss_grasper_config c;
    hand_nature left = *nature;
    left.seed += 1000;
    TRY(vbss_grasper_config_init(&c, sizeof c));
    hand_stiffen(&c);
    c.driver_radius = JAW_RADIUS;
    if (free_left) { /* this one is wound about as well */
        c.driver_neck = NECK;
    }
    TRY(hand_create_with(&t->right, &t->site.rig, nature, &c, v3(0.05, -0.05, 0.03),
                         v3(0.0, 0.0, 1.0), STITCH_JAW_WIDE));
    TRY(vbss_grasper_config_init(&c, sizeof c));
    hand_stiffen(&c);
    if (free_left) {
        c.driver_neck = NECK;
    } else {
        c.has_trocar = 1;
        v_store(c.trocar, STITCH_LEFT_TROCAR);
    }
    TRY(hand_create_with(&t->left, &t->site.rig, &left, &c, v3(-0.04, -0.01, 0.03), LEFT_POINT,
                         FORK));
    hand_through(&t->left, STITCH_LEFT_TROCAR);
    t->left_is_free = free_left;
    hand_turn(&t->left, LEFT_POINT);
    return VBSS_OK;
}

/* The error lies in the plane of the wall. */
void stitch_set_error(stitch *t, int side)
{
    double angle = between(&t->random, 0.0, 6.283185307179586);
    vec along = v3(0.0, 1.0, 0.0), up = v_cross(site_normal_at_rest(&t->site, side), along);
    t->errors[side] = v_add(v_scale(t->target_at * vbss_cos(angle), along),
                            v_scale(t->target_at * vbss_sin(angle), up));
}

void stitch_plan_usual(stitch_plan *plan)
{
    *plan = (stitch_plan){.site = {.segments = 60}};
}

vbss_result stitch_create(stitch *t, uint64_t seed, const stitch_plan *plan)
{
    uint64_t random = seed * 7919 + 17;
    hand_nature nature = {.speed = 1.0, .seed = seed};
    const hand_skill *skill = skill_or_expert(plan->skill);
    vec place = v3(0.035, -0.005, 0.0);
    double turn = 3.141592653589793, target_at = 0.0;
    memset(t, 0, sizeof *t);
    if (seed > 0) { /* 0: steady hands, everything where it belongs */
        nature.speed = between(&random, 0.6, 1.5);
        nature.tremor = between(&random, 0.1e-3, 0.4e-3);
        target_at = 0.5e-3;
        place.x += between(&random, -8e-3, 8e-3);
        place.y += between(&random, -8e-3, 8e-3);
        turn += between(&random, -0.8, 0.8);
    }
    nature.speed *= skill->speed;
    nature.tremor *= skill->tremor;
    nature.target_at = nature.target_end = target_at *= skill->target_at;
    TRY(site_create(&t->site, place, turn, &plan->site));
    t->target_at = target_at;
    t->random = random;
    for (int side = 0; side < 2; side++) {
        stitch_set_error(t, side);
        t->marks[side] = site_mark(&t->site, side);
    }
    t->held.q[0] = 1.0;
    return make_hands(t, &nature, plan->free_left);
}
