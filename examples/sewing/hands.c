/* The hands, by the clock: one drives the needle along its arc through the tissue, the other draws it out and the thread after it;
 * then both ends of the thread are drawn. */
#include "script.h"

#include "base/error.h"

static const double begin = 200.0 * SCRIPTED_DEGREE, driven = 372.0 * SCRIPTED_DEGREE,
                    out = 545.0 * SCRIPTED_DEGREE; /* of the tip */
static const double behind[2] = {175.0 * SCRIPTED_DEGREE,
                                 14.0 * SCRIPTED_DEGREE}; /* the tip: the jaws */
static const double retreat = 25e-3 /* m */, draw[3] = {12e-3, 45e-3, 0.0} /* m */,
                    pull = 0.3 /* N */, tail_speed = 30e-3 /* m/s */,
                    tail_stiffness = 50.0 /* N/m */;

/* ---- phases */

typedef enum phase {
    CLOSE,  /* the first hand takes the needle */
    DRIVE,  /* through the tissue, until the tip stands out */
    REACH,  /* the second hand comes beside the tip */
    TAKE,   /* and closes */
    LET_GO, /* the first hand opens, and goes away */
    LEAVE,
    TURN, /* the second turns the needle out */
    DRAW, /* and draws the thread through */
    PULL, /* at the tail too */
    REST, /* both hold */
    DONE
} phase;

static const struct {
    const char *name;
    double seconds;
} phases[DONE] = {{"take the needle", 0.3},
                  {"drive it", 2.2},
                  {"reach for the tip", 0.5},
                  {"take the tip", 0.3},
                  {"let go", 0.3},
                  {"leave", 0.4},
                  {"turn it out", 2.2},
                  {"draw the thread", 1.2},
                  {"pull the tail", 0.9},
                  {"rest", 0.5}};

/* The phase at a time, and which part of it is over, 0 to 1. */
static phase phase_at(double time, double *part)
{
    uint32_t i = 0;
    while (i < DONE && time >= phases[i].seconds) {
        time -= phases[i++].seconds;
    }
    *part = i < DONE ? time / phases[i].seconds : 1.0;
    return (phase)i;
}

const char *sewing_phase(const sewing *s)
{
    double part;
    const phase now = phase_at(s->time, &part);
    return now == DONE ? "done" : phases[now].name;
}

void script_begin(sewing *s)
{
    s->turned = begin;
    s->hands[0] = (scripted_hand){.side = 1.0, .angle = begin - behind[0]};
    s->hands[1] = (scripted_hand){.side = -1.0, .angle = driven - behind[1]};
    s->hands[1].tip = vec3_make(0.0, 0.0, -retreat);
}

/* ---- a step */

static double between(double from, double to, double part)
{
    return from + (to - from) * part;
}

/* The tail is drawn to the left and up, until it bears the pull. */
static vbss_result pull_tail(sewing *s)
{
    if (s->tail.attachment == 0) {
        VBSS_TRY(scripted_take(&s->tail, s->thread, s->segments, tail_stiffness));
    }
    return scripted_pull_toward(&s->tail, s->thread, vec3_make(-90e-3, 70e-3, 0.0), pull,
                                tail_speed * SEWING_STEP);
}

static vbss_result move_hands(sewing *s)
{
    double part;
    const phase now = phase_at(s->time, &part);
    scripted_hand *first = &s->hands[0], *second = &s->hands[1];
    if (now == DRIVE) {
        s->turned = between(begin, driven, part);
    } else if (now == TURN) {
        s->turned = between(driven, out, part);
    }
    if (now <= LEAVE) {
        first->angle = (now < LEAVE ? s->turned : driven) - behind[0];
        first->tip = vec3_make(0.0, 0.0, now == LEAVE ? retreat * part : 0.0);
    }
    second->angle = (now >= TURN ? s->turned : driven) - behind[1];
    second->tip = vec3_zero();
    if (now <= REACH) {
        second->tip = vec3_make(0.0, 0.0, -retreat * (now == REACH ? 1.0 - part : 1.0));
    } else if (now >= DRAW) {
        second->tip = vec3_scale(vec3_load(draw), now == DRAW ? part : 1.0);
    }
    VBSS_TRY(scripted_place_hand(first, SCRIPT_CENTRE, now < LET_GO ? 0.0 : SCRIPTED_OPENING));
    VBSS_TRY(scripted_place_hand(second, SCRIPT_CENTRE, now >= TAKE ? 0.0 : SCRIPTED_OPENING));
    return now >= PULL ? pull_tail(s) : VBSS_OK;
}

static vbss_result count_events(sewing *s)
{
    vbss_scene_event events[64];
    uint32_t count = 64;
    while (count == 64) {
        VBSS_TRY(vbss_scene_take_events(s->scene, events, sizeof events[0], 64, &count, NULL));
        for (uint32_t i = 0; i < count; i++) {
            s->punctures += events[i].kind == VBSS_SCENE_EVENT_PUNCTURE;
            s->passed += events[i].kind == VBSS_SCENE_EVENT_PASSED;
        }
    }
    return VBSS_OK;
}

/* The tissue goes where it goes without the stitch, the scene adds the forces, and the tissue bears them in the same step. */
vbss_result sewing_step(sewing *s, bool *is_done)
{
    static double vertices[SEWING_VERTICES][3];
    vbss_view forces;
    double part;
    VBSS_TRY(move_hands(s));
    fem_predict(&s->tissue, vertices);
    VBSS_TRY(vbss_scene_move_surface(s->scene, s->surface, vertices[0], SEWING_VERTICES));
    VBSS_TRY(vbss_scene_step(s->scene, SEWING_STEP));
    VBSS_TRY(vbss_scene_get_surface_view(s->scene, s->surface, VBSS_SCENE_SURFACE_VIEW_FORCES,
                                         &forces, sizeof forces));
    fem_apply(&s->tissue, (const double(*)[3])forces.data);
    s->time += SEWING_STEP;
    *is_done = phase_at(s->time, &part) == DONE;
    return count_events(s);
}
