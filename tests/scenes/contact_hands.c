#include "scenes/contact_hands.h"

#include "base/elementary.h"
#include "base/error.h"
#include "base/random.h"

/* Of the way to the wanted force, in a step: two hands may do it at once. */
#define EAGERNESS 0.3
/* Below this share of the wanted force it does not slow down: a knot gives way more than the thread. */
#define BARELY 0.5
/* Back, against forward: who is torn at gives way fast. */
#define GIVES_WAY 5.0
/* How far beside its home a hand goes, m; and how far back of where it was furthest. */
#define ASIDE 0.01
#define BACK 0.004
/* Largest change of force by a rigid hand in a step, N: more would be a tear, which is another test. */
#define STEP_FORCE 2.0
/* Loose ends are taken again, and whims change, after so many steps. */
enum { WHIM_STEPS = 40 };

static vec3 node_at(vbss_thread *thread, uint32_t node)
{
    vbss_view view;
    if (vbss_thread_get_view(thread, VBSS_THREAD_POSITIONS, &view, sizeof view) != VBSS_OK) {
        return vec3_zero();
    }
    return ((const vec3 *)view.data)[node];
}

bool contact_hand_scene_waits(const vbss_scene_config *scene)
{
    return scene->mode == VBSS_MODE_REAL_TIME && scene->work_limit > 0 && scene->slot_limit > 0;
}

vbss_result contact_hand_take(contact_hand *hand, vbss_thread *thread, uint32_t node, vec3 way,
                              const contact_pull *pull, double give, bool scene_waits)
{
    vbss_thread_attachment a;
    vec3 here = node_at(thread, node);
    *hand = (contact_hand){.thread = thread,
                           .node = node,
                           .way = way,
                           .at = here,
                           .home = here,
                           .pull = *pull,
                           .scene_waits = scene_waits,
                           .give = give};
    VBSS_TRY(vbss_thread_attachment_init(&a, sizeof a));
    a.kind = pull->stiffness > 0.0 ? VBSS_ATTACHMENT_SPRING : VBSS_ATTACHMENT_PIN;
    a.node = node;
    a.stiffness = pull->stiffness;
    a.damping = pull->stiffness * 1e-3; /* dies away in about a millisecond */
    vec3_store(a.position, here);
    return vbss_thread_attach(thread, &a, &hand->id);
}

vbss_result contact_hand_release(contact_hand *hand)
{
    uint32_t id = hand->id;
    hand->id = 0;
    hand->felt = 0.0;
    return id == 0 ? VBSS_OK : vbss_thread_detach(hand->thread, id);
}

static vbss_result feel(contact_hand *hand)
{
    vbss_thread_reaction r;
    VBSS_TRY(vbss_thread_get_reaction(hand->thread, hand->id, &r, sizeof r));
    hand->node = r.node; /* an adaptive mesh renumbers it */
    vec3 here = node_at(hand->thread, hand->node), force = vec3_load(r.force);
    if (hand->pull.stiffness == 0.0) { /* the guard may have held it back */
        hand->at = here;
    } else if (hand->scene_waits) {
        force = vec3_scale(vec3_sub(hand->at, here), hand->pull.stiffness);
    }
    hand->felt = vec3_dot(force, hand->way);
    return VBSS_OK;
}

static vbss_result go(contact_hand *hand, double along, vec3 aside)
{
    double target[3];
    hand->at = vec3_add(vec3_add_scaled(hand->at, along, hand->way), aside);
    hand->furthest = vbss_max(vec3_dot(vec3_sub(hand->at, hand->home), hand->way), hand->furthest);
    vec3_store(target, hand->at);
    return vbss_thread_move(hand->thread, hand->id, target, NULL);
}

static double give_of(const contact_hand *hand)
{
    double soft = hand->pull.stiffness;
    return soft > 0.0 ? soft * hand->give / (soft + hand->give) : hand->give;
}

static double along(const contact_hand *hand, double h)
{
    double most = hand->pull.speed * h;
    if (hand->felt < BARELY * hand->pull.force) {
        return most;
    }
    double wanted = EAGERNESS * (hand->pull.force - hand->felt) / give_of(hand);
    return vbss_min(vbss_max(wanted, -GIVES_WAY * most), most);
}

vbss_result contact_hand_move(contact_hand *hand, double h, vec3 aside)
{
    if (hand->id == 0) {
        return VBSS_OK;
    }
    VBSS_TRY(feel(hand));
    return go(hand, along(hand, h), aside);
}

/* ---- at random */

static double draw(vbss_random *random, double low, double high)
{
    return low + (high - low) * vbss_random_uniform(random);
}

static double draw_power_of_ten(vbss_random *random, double low, double high)
{
    return vbss_exp(2.302585092994046 * draw(random, low, high));
}

contact_whim contact_whim_of(const contact_pull *usual, uint64_t seed, uint64_t hand, uint64_t step)
{
    vbss_random random;
    vbss_random_seed(&random, 4 * seed + hand, step / WHIM_STEPS);
    uint32_t what = vbss_random_below(&random, 100);
    double force = draw_power_of_ten(&random, -2.0, 0.0);
    double speed = draw_power_of_ten(&random, -1.0, 0.5);
    vec3 way = vbss_random_direction(&random);
    contact_whim w = {.pull = *usual, .aside = vec3_scale(way, usual->speed * speed)};
    w.pull.force *= force;
    w.pull.speed *= speed;
    if (what < 40) { /* pulls, more or less */
        w.aside = vec3_zero();
    } else if (what < 55) { /* goes back */
        w.back = w.pull.speed;
        w.pull.speed = 0.0;
    } else if (what < 65) { /* jerks */
        w.pull.force = 2.0 * usual->force;
        w.pull.speed = 5.0 * usual->speed;
    } else if (what < 70) { /* rests */
        w.pull.speed = 0.0;
        w.aside = vec3_zero();
    } else if (what < 75) {
        w.letting_go = true;
    } /* else: pulls and goes aside */
    return w;
}

/* Across its way, and not too far. */
static vec3 allowed_aside(const contact_hand *hand, vec3 aside)
{
    vec3 off = vec3_sub(hand->at, hand->home);
    off = vec3_add_scaled(off, -vec3_dot(off, hand->way), hand->way);
    vec3 across = vec3_add_scaled(aside, -vec3_dot(aside, hand->way), hand->way);
    bool out = vec3_norm(off) > ASIDE && vec3_dot(off, across) > 0.0;
    return out ? vec3_neg(across) : across;
}

vbss_result contact_hand_tug(contact_hand *hand, const contact_whim *whim, double h, bool loose)
{
    if (whim->letting_go && loose) {
        return contact_hand_release(hand);
    }
    if (hand->id == 0) { /* where it is now */
        VBSS_TRY(contact_hand_take(hand, hand->thread, hand->node, hand->way, &hand->pull,
                                   hand->give, hand->scene_waits));
    }
    contact_pull usual = hand->pull;
    double most = STEP_FORCE / give_of(hand);
    VBSS_TRY(feel(hand));
    hand->pull.force = whim->pull.force;
    hand->pull.speed = vbss_min(whim->pull.speed, most / h);
    double way = along(hand, h);
    double out = vec3_dot(vec3_sub(hand->at, hand->home), hand->way);
    if (whim->back > 0.0 && out > hand->furthest - BACK) {
        way = -vbss_min(whim->back * h, most);
    }
    vec3 aside = allowed_aside(hand, vec3_scale(whim->aside, h));
    double far = vec3_norm(aside);
    aside = far > most ? vec3_scale(aside, most / far) : aside;
    hand->pull = usual;
    return go(hand, way, aside);
}
