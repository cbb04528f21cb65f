#include "surgeon/hand_over.h"

#include "surgeon/handing.h"

/* Of the needle's length from its tip: where it is taken. Always nearer to the tip: by the jaws that have it lies thread, which may have
 * come round them as they went round W. */
#define LEFT_HOLD 0.4
#define RIGHT_HOLD 0.18
#define UP \
    0.62 /* share of the free limb, by which the swage is held up from the knot: that it comes off those jaws */
#define STRAIGHT 0.93 /* share of the tail, that W is from where it comes out as it lets it go */
#define STRAIGHTENING 0.02 /* m/s */
#define AHEAD 0.5e-3       /* m, of W's target before its tip: it stops so soon */
#define NEARLY 1e-3        /* m */
#define TAUT 0.04          /* N: a bent tail draws by half of it */
/* N, whichever way: the tail is caught on something, and draws at more than its end. */
#define HELD_BACK 0.1
#define OPEN 0.4e-3                 /* m: a slit that is wider is open */
#define OPENED 0.1e-3               /* m, that it has become wider */
#define LOOSENED 1.2e-3             /* m, that a throw gapes more: it has sprung open */
#define A_SECOND 1.0                /* s */
#define UPWARD v3(0.6, -0.35, 1.0)  /* on the bearer's side, where the limb is all the time */
#define LIFTING 0.06                /* m/s */
#define AWAY v3(0.06, -0.06, 0.05)  /* of who lets go, from the needle's side */
#define ASIDE v3(0.05, -0.06, 0.06) /* of who lets the tail go */
#define PATIENCE 6.0                /* s, of every state */

enum {
    LOOP = 7,    /* nodes of either end inside the knot */
    TAKEN_UP = 8 /* of the tail, that the knot has drawn in: it is loose */
};

const char *hand_over_name(hand_over_state state)
{
    static const char *const names[] = {"ease",   "straighten", "release", "sprung", "offer", "ask",
                                        "accept", "take over",  "give",    "given",  "failed"};
    return names[state];
}

vbss_result hand_over_begin(hand_over *o, stitch *t, senses *see)
{
    memset(o, 0, sizeof *o);
    o->stitch = t;
    o->see = see;
    ease_begin(&o->easing, see);
    TRY(senses_find_roots(see));
    o->tail_root = see->tail_root;
    o->limb_root = see->limb_root;
    return VBSS_OK;
}

static void enter(hand_over *o, hand_over_state state)
{
    o->state = state;
    o->since = 0.0;
}

/* ---- the knot is let alone */

/* How far either end stands off from the middle of the stitch, where it goes into the knot. */
static double gape(const hand_over *o)
{
    const senses *s = o->see;
    const uint32_t *marks = s->rig->marks;
    const vec knot = v_scale(0.5, v_add(s->x[marks[0]], s->x[marks[1]]));
    double farthest = 0.0;
    for (uint32_t i = 0; i < LOOP; i++) {
        farthest = larger(farthest, v_distance(s->x[o->tail_root + i], knot));
        farthest = larger(farthest, v_distance(s->x[o->limb_root - i], knot));
    }
    return farthest;
}

static void ease(hand_over *o, double dt)
{
    if (ease_step(&o->easing, o->see, dt)) {
        enter(o, HAND_OVER_STRAIGHTEN);
    }
}

/* A bent tail springs out as it is released, and opens the throw. */
static void straighten(hand_over *o)
{
    senses *s = o->see;
    const hand_pose *w = &s->tool_w;
    vec root = s->x[s->tail_root], jaws = v_along(w->tip, GRASP_BEHIND, w->handle);
    double length = STRAIGHT * senses_length(s, s->w->node, s->tail_root);
    double missing = length - v_distance(jaws, root);
    vec out = v_unit(v_sub(jaws, root));
    bool done =
        missing < NEARLY || s->draws_w > TAUT || s->tension_w > HELD_BACK || o->since > A_SECOND;
    hand_go(s->w, v_along(w->tip, done ? 0.0 : AHEAD, out), STRAIGHTENING);
    if (done) {
        o->from = w->tip;
        o->from_handle = w->handle;
        o->slit_held = o->slit;
        o->gape_held = gape(o);
        enter(o, HAND_OVER_RELEASE);
    }
}

/* Held up on the bearer's side; the swage toward the knot. */
static void choose_offered(hand_over *o)
{
    const senses *s = o->see;
    vec root = s->x[s->limb_root], direction = v_unit(UPWARD), z = v3(0.0, 1.0, 0.0);
    double free = senses_length(s, s->limb_root, s->nodes - 1);
    root.x *= s->w->side;
    direction.x *= s->c == &o->stitch->right ? 1.0 : -1.0;
    vec swage = v_along(root, UP * free, direction), x = v_unit(v_across(direction, z));
    o->offered = pose_of(v_along(swage, o->stitch->site.radius, x), x, v_cross(z, x), z);
}

static void begin_offer(hand_over *o)
{
    senses *s = o->see;
    choose_offered(o);
    s->w->side = s->c->side = 1.0; /* needle and world are not seen in a mirror */
    o->held = handing_held(&o->stitch->site, s->c);
    enter(o, o->kept ? HAND_OVER_DONE : HAND_OVER_OFFER);
}

vbss_result hand_over_begin_at_needle(hand_over *o, stitch *t, senses *see)
{
    TRY(hand_over_begin(o, t, see));
    begin_offer(o);
    return VBSS_OK;
}

/* The knot has taken up that much of the tail. */
static vbss_result find_taken_up(const hand_over *o, uint32_t *nodes)
{
    senses *s = o->see;
    const uint32_t tail = s->tail_root, limb = s->limb_root;
    TRY(senses_find_roots(s));
    *nodes = o->tail_root > s->tail_root ? o->tail_root - s->tail_root : 0;
    s->tail_root = tail;
    s->limb_root = limb;
    return VBSS_OK;
}

/* A slit that was as open before does not count. */
static vbss_result has_sprung(const hand_over *o, bool *sprung)
{
    const bool opened = o->slit > OPEN && o->slit > o->slit_held + OPENED;
    uint32_t taken_up = 0;
    TRY(find_taken_up(o, &taken_up));
    *sprung = opened || gape(o) > o->gape_held + LOOSENED || taken_up > TAKEN_UP;
    return VBSS_OK;
}

/* W's jaws open and are drawn back along themselves. */
static vbss_result release(hand_over *o)
{
    senses *s = o->see;
    bool sprung = false;
    hand_open(s->w, 0.4);
    if (o->since > 0.2) {
        hand_go(s->w, v_along(o->from, 20e-3, o->from_handle), 0.04);
    }
    if (o->since > 0.9 && o->again) {
        TRY(has_sprung(o, &sprung));
    }
    if (sprung) {
        enter(o, HAND_OVER_SPRUNG);
    } else if (o->since > 0.9) {
        hand_open(s->w, 0.0);
        begin_offer(o);
    }
    return VBSS_OK;
}

/* ---- the needle */

static void offer(hand_over *o)
{
    senses *s = o->see;
    vec aside = ASIDE;
    aside.x *= s->w == &o->stitch->left ? -1.0 : 1.0;
    hold_steer(s->c, &o->held, &o->offered, LIFTING);
    hand_go(s->w, aside, LIFTING);
    if (hold_off(&o->stitch->site, &o->offered) < 2e-3) {
        enter(o, HAND_OVER_ASK);
    }
}

static void take(hand_over *o)
{
    senses *s = o->see;
    const site *at = &o->stitch->site;
    double share = s->w == &o->stitch->left ? LEFT_HOLD : RIGHT_HOLD;
    handing_part part = (handing_part)(o->state - HAND_OVER_ASK);
    handing_result handed = handing_take(at, s->w, share * at->arc * at->radius, part, o->since);
    if (handed != HANDING_GOES_ON) {
        enter(o, (hand_over_state)(o->state + 1));
    }
}

/* Who holds the limb now is C, and pulls it to where C's mirror image would. */
static vbss_result exchange(senses *s, bool right_is_w)
{
    hand *w = s->w;
    s->w = s->c;
    s->c = w;
    s->w->side = s->c->side = right_is_w ? -1.0 : 1.0;
    return vbss_knot_detector_reset(s->detector);
}

static vbss_result give(hand_over *o)
{
    senses *s = o->see;
    bool is_right = s->c == &o->stitch->right;
    vec away = AWAY;
    away.x *= is_right ? 1.0 : -1.0;
    if (!handing_leave(s->c, o->since, &o->back, away) || o->since < 2.0) {
        return VBSS_OK;
    }
    enter(o, HAND_OVER_DONE);
    return exchange(s, is_right);
}

vbss_result hand_over_step(hand_over *o, double dt)
{
    const senses *s = o->see;
    o->since += dt;
    if (o->state > HAND_OVER_RELEASE && o->state < HAND_OVER_GIVE) {
        hold_see(&o->held, s->c, &o->stitch->site, dt);
        if (!s->c->holds) {
            o->why = "the needle is lost";
            enter(o, HAND_OVER_FAILED);
        }
    }
    switch (o->state) {
    case HAND_OVER_EASE:
        ease(o, dt);
        break;
    case HAND_OVER_STRAIGHTEN:
        straighten(o);
        break;
    case HAND_OVER_RELEASE:
        TRY(release(o));
        break;
    case HAND_OVER_OFFER:
        offer(o);
        break;
    case HAND_OVER_ASK:
    case HAND_OVER_ACCEPT:
    case HAND_OVER_TAKE:
        take(o);
        break;
    case HAND_OVER_GIVE:
        return give(o);
    default:
        return VBSS_OK;
    }
    if (o->since > PATIENCE) {
        o->why = hand_over_name(o->state);
        enter(o, HAND_OVER_FAILED);
    }
    return VBSS_OK;
}
