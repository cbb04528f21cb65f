/* Where needle and hands are, by the clock. The needle goes round a circle across the incision: in at the left, out at the right. Both
 * tools come from +z, and the suture goes on in that direction, away from its finished part. */
#include "pad.h"

#include "base/error.h"

static const double places[PAD_BITES] = {-7e-3, -1e-3, 4.5e-3, 10e-3};
static const double height = 4e-3, above = 32e-3; /* m, of the centre over the skin */
static const double begin = 200.0 * SCRIPTED_DEGREE, driven = 366.0 * SCRIPTED_DEGREE,
                    out = 545.0 * SCRIPTED_DEGREE, over = 560.0 * SCRIPTED_DEGREE; /* of the tip */
static const double behind[2] = {175.0 * SCRIPTED_DEGREE,
                                 12.0 * SCRIPTED_DEGREE}; /* the tip: the jaws */
static const double lean = 20.0 * SCRIPTED_DEGREE /* of the shafts */, retreat = 30e-3 /* m */;
/* To where the needle is drawn from the circle, m; its direction. */
static const double draw[PAD_BITES] = {80e-3, 112e-3, 76e-3, 42e-3};
/* The stitch away from where the suture begins. */
static const double draw_directions[2][3] = {{-0.2, 0.85, -0.49}, {-0.25, 0.93, 0.27}},
                    tighten_direction[3] = {-0.85, 0.1, 0.3}; /* then across the incision */
/* To pull tight the needle comes down across the incision: pulled up, the lip of the last hole would rise over the other one. */
static const double low_direction[3] = {-0.9, 0.25, 0.36}, lowering = 0.8 /* s */;

static const double before_tying = 0.3; /* s: the knot pulls the stitch tight */

enum {
    FIRST_OFFERED = 2 /* bite whose needle comes from the one before; others have a fresh one */
};

static const struct {
    const char *name;
    double seconds;
} phases[PAD_PHASES] = {{"bring the needle over the next bite", 0.8},
                        {"come beside the needle", 0.4},
                        {"take the needle", 0.2},
                        {"give it", 0.15},
                        {"go aside", 0.4},
                        {"lower the needle", 0.5},
                        {"drive it through both lips", 1.3},
                        {"come round", 0.4},
                        {"reach for the tip", 0.3},
                        {"take the tip", 0.2},
                        {"let go", 0.15},
                        {"leave", 0.4},
                        {"turn the needle out", 1.3},
                        {"draw the thread", 1.3},
                        {"pull it tight", 1.5}};

const char *pad_phase_name(pad_phase phase)
{
    return phases[phase].name;
}

/* The first hand already waits beside a fresh needle. */
double pad_phase_time(uint32_t bite, pad_phase phase)
{
    const bool is_fresh = bite < FIRST_OFFERED;
    const bool is_left_out =
        is_fresh && (phase == PAD_OFFER || phase == PAD_GIVE || phase == PAD_WITHDRAW);
    return is_left_out                         ? 0.0
           : bite == 0 && phase == PAD_TIGHTEN ? before_tying
                                               : phases[phase].seconds;
}

double pad_place(uint32_t bite)
{
    return places[bite < PAD_BITES ? bite : PAD_BITES - 1];
}

/* ---- needle */

static double between(double from, double to, double part)
{
    return from + (to - from) * part;
}

/* From 0 to 1 without jerks at its ends. */
static double smooth(double part)
{
    const double share = part < 1.0 ? part : 1.0;
    return share * share * (3.0 - 2.0 * share);
}

/* Share of the phase that is over. */
static double part_of(const pad *p)
{
    const double seconds = pad_phase_time(p->bite, p->phase);
    return smooth(seconds > 0.0 ? p->since / seconds : 1.0);
}

static vec3 site(const pad *p, uint32_t bite)
{
    return vec3_add(vec3_make(0.0, height, pad_place(bite)), pad_vary(p->seed, bite));
}

static vec3 over_site(const pad *p, uint32_t bite)
{
    return vec3_add(vec3_make(0.0, above, pad_place(bite)), pad_vary(p->seed, bite));
}

/* `lowered`: share of the path from above the stitch to beside it. */
static vec3 drawn(const pad *p, uint32_t bite, double part, double lowered)
{
    const vec3 up = vec3_load(draw_directions[bite > 0]), low = vec3_load(low_direction);
    const vec3 direction = bite > 0 ? vec3_unit_or(vec3_lerp(up, low, lowered), up) : up;
    const vec3 at = vec3_add_scaled(site(p, bite), part * draw[bite], direction);
    return vec3_add_scaled(at, p->pulled, vec3_load(tighten_direction));
}

vec3 pad_needle_centre(const pad *p)
{
    if (p->phase == PAD_OFFER && p->bite >= FIRST_OFFERED) {
        return vec3_lerp(drawn(p, p->bite - 1, p->drawn, 1.0), over_site(p, p->bite), part_of(p));
    }
    if (p->phase < PAD_LOWER) {
        return over_site(p, p->bite);
    }
    if (p->phase == PAD_LOWER) {
        return vec3_lerp(over_site(p, p->bite), site(p, p->bite), part_of(p));
    }
    if (p->phase < PAD_DRAW) {
        return site(p, p->bite);
    }
    const double lowered = p->phase == PAD_TIGHTEN ? smooth(p->since / lowering) : 0.0;
    return drawn(p, p->bite, p->drawn, lowered);
}

double pad_draw_step(const pad *p)
{
    const double seconds = pad_phase_time(p->bite, PAD_DRAW);
    return smooth((p->since + PAD_STEP) / seconds) - smooth(p->since / seconds);
}

double pad_needle_turned(const pad *p)
{
    switch (p->phase) {
    case PAD_OFFER:
        return p->bite < FIRST_OFFERED ? begin : between(out, over, part_of(p)) - (over - begin);
    case PAD_DRIVE:
        return between(begin, driven, part_of(p));
    case PAD_TURN:
        return between(driven, out, part_of(p));
    default:
        return p->phase < PAD_DRIVE ? begin : p->phase < PAD_TURN ? driven : out;
    }
}

/* ---- hands */

/* A place of a hand: the circle's centre, the needle's angle there, and how far the jaws are from it. */
typedef struct station {
    vec3 centre;
    double turned;
    vec3 tip;
    double back; /* along the shaft, m */
} station;

static station at_needle(const pad *p, int which)
{
    station s = {pad_needle_centre(p), pad_needle_turned(p), vec3_zero(), 0.0};
    if (which == 1 && p->phase < PAD_DRIVE) { /* as it has turned the needle out */
        s.turned += over - begin;
    }
    return s;
}

static station wait_over(const pad *p, uint32_t bite, int which)
{
    if (which == 0) {
        return (station){over_site(p, bite), begin, vec3_zero(), retreat};
    }
    return (station){over_site(p, bite), over, vec3_make(-6e-3, 24e-3, 0.0), retreat};
}

static station wait_beside(const pad *p, uint32_t bite, int which)
{
    const vec3 tip = which == 0 ? vec3_make(-10e-3, 8e-3, 0.0) : vec3_zero();
    return (station){site(p, bite), driven, tip, retreat};
}

/* Jaws come and go along their shaft; other motions are before and after that. */
static station mix(station a, station b, double part)
{
    const double first = vbss_min(1.0, 2.0 * part), second = vbss_max(0.0, 2.0 * part - 1.0);
    const double moved = a.back == b.back ? part : a.back > b.back ? first : second;
    const double slid = a.back > b.back ? second : first;
    return (station){vec3_lerp(a.centre, b.centre, moved), between(a.turned, b.turned, moved),
                     vec3_lerp(a.tip, b.tip, moved), between(a.back, b.back, slid)};
}

static station first_hand(const pad *p)
{
    const uint32_t next = p->bite + 1 < PAD_BITES ? p->bite + 1 : p->bite;
    switch (p->phase) {
    case PAD_OFFER:
        return wait_over(p, p->bite, 0);
    case PAD_APPROACH:
        return mix(wait_over(p, p->bite, 0), at_needle(p, 0), part_of(p));
    case PAD_LEAVE:
        return mix(at_needle(p, 0), wait_beside(p, p->bite, 0), part_of(p));
    case PAD_TIGHTEN:
        return mix(wait_beside(p, p->bite, 0), wait_over(p, next, 0), part_of(p));
    default:
        return p->phase < PAD_LEAVE ? at_needle(p, 0) : wait_beside(p, p->bite, 0);
    }
}

static station second_hand(const pad *p)
{
    const bool is_fresh = p->bite < FIRST_OFFERED;
    switch (p->phase) {
    case PAD_WITHDRAW:
        return is_fresh ? wait_over(p, p->bite, 1)
                        : mix(at_needle(p, 1), wait_over(p, p->bite, 1), part_of(p));
    case PAD_LOWER:
    case PAD_DRIVE:
        return wait_over(p, p->bite, 1);
    case PAD_COME:
        return mix(wait_over(p, p->bite, 1), wait_beside(p, p->bite, 1), part_of(p));
    case PAD_REACH:
        return mix(wait_beside(p, p->bite, 1), at_needle(p, 1), part_of(p));
    default:
        return p->phase < PAD_WITHDRAW && is_fresh ? wait_over(p, p->bite, 1) : at_needle(p, 1);
    }
}

vec3 pad_direct_hand(const pad *p, int which, scripted_hand *hand)
{
    const station s = which == 0 ? first_hand(p) : second_hand(p);
    hand->side = 1.0;
    hand->lean = lean;
    hand->angle = s.turned - behind[which];
    hand->tip = s.tip;
    hand->back = s.back;
    return s.centre;
}

bool pad_hand_is_open(const pad *p, int which)
{
    if (which == 0) {
        return p->phase < PAD_CLOSE || p->phase >= PAD_LET_GO;
    }
    return p->bite < FIRST_OFFERED ? p->phase < PAD_TAKE
                                   : p->phase >= PAD_GIVE && p->phase < PAD_TAKE;
}
