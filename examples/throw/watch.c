/* Watches a trial: times its steps, prints what the hands do and what it comes to. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "knots/words.h"
#include "throw/demo.h"

/* ---- time */

static double now(clockid_t clock)
{
    struct timespec t;
    (void)clock_gettime(clock, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

static void keep_time(demo_times *t, double seconds)
{
    if (t->count == t->room) {
        size_t room = t->room > 0 ? 2 * t->room : 16384;
        double *more = realloc(t->steps, room * sizeof *more);
        if (more == NULL) {
            return; /* the rest is not measured, and the count says so */
        }
        t->steps = more;
        t->room = room;
    }
    t->steps[t->count++] = 1e6 * seconds;
}

/* ---- which knot it is */

/* With a detector of its own, since a look must change nothing. */
vbss_result demo_judge(demo *d, const senses *s, demo_knot *k)
{
    vbss_knot_input in;
    const vec *x = throw_rig_nodes(s->rig);
    if (d->detector == NULL) {
        TRY(vbss_knot_detector_create(s->rig->context, NULL, &d->detector));
    }
    memset(k, 0, sizeof *k);
    TRY(vbss_knot_input_init(&in, sizeof in));
    in.points = &x[0].x;
    in.point_count = s->nodes;
    in.hole_count = 2;
    for (int i = 0; i < 2; i++) {
        v_store(in.holes[i], x[s->rig->marks[i]]);
        in.hole_places[i] = s->rig->marks[i];
    }
    in.away[2] = -1.0;
    TRY(vbss_knot_detector_judge(d->detector, &in));
    TRY(vbss_knot_detector_get_state(d->detector, &k->state, sizeof k->state));
    for (uint32_t i = 0; i < k->state.throw_count && i < DEMO_THROWS; i++) {
        TRY(vbss_knot_detector_get_throw(d->detector, i, &k->throws[i], sizeof k->throws[i]));
    }
    return vbss_knot_detector_get_notation(d->detector, k->notation, sizeof k->notation);
}

/* ---- what the hands do */

/* Words for the states of the hands; a state without any is told by its name. */
static const char *words_of_stage(const char *name)
{
    static const char *const words[][2] = {
        {"pick", "C takes the limb"},           {"near", "C brings the limb near"},
        {"place", "W comes to be wound about"}, {"orbit", "C winds the limb round W's jaws"},
        {"check", "are the turns right?"},      {"unwind", "no: back"},
        {"tail", "W reaches for the tail"},     {"close", "W has it: would it tie?"},
        {"draw", "W draws the tail through"},   {"lower", "both hands go low"},
        {"seat", "both pull, to 2 N"},          {"ease", "nothing is taut any longer"},
        {"release", "W lets the tail go"},      {"offer", "C holds the limb up"},
        {"take", "W takes the limb"},           {"give", "C lets it go"},
        {"leave", "W leaves for shears"},       {"exchange", "W is given shears"},
        {"cut limb", "W cuts the limb"},        {"away", "C takes the piece away"},
        {"cut tail", "W cuts the tail"},        {"back", "W withdraws"},
    };
    for (size_t i = 0; i < sizeof words / sizeof words[0]; i++) {
        if (strcmp(words[i][0], name) == 0) {
            return words[i][1];
        }
    }
    return name;
}

static void report_stage(demo *d, const trial_moment *m, const demo_knot *k)
{
    const senses_knot *next = &m->run->predicted;
    char knot[96] = "-";
    if (k->state.throw_count > 0) {
        snprintf(knot, sizeof knot, "%s, %s", k->notation, words_of_result(k->state.verdict));
    }
    if (strcmp(d->stage.name, "close") == 0 &&
        next->state.next_verdict == VBSS_KNOT_VERDICT_PASSED) {
        size_t used = strlen(knot);
        snprintf(knot + used, sizeof knot - used, "; to come: %d wrap%s, %s-handed",
                 (int)next->state.next_wraps, next->state.next_wraps == 1 ? "" : "s",
                 next->state.next_handedness > 0 ? "right" : "left");
    }
    printf("%7.2f%7.2f  %-32s%6.2f%6.2f%7.2f  %s\n", m->see->rig->time, d->wall,
           words_of_stage(d->stage.name), d->stage.force[0], d->stage.force[1], m->see->turns,
           knot);
    fflush(stdout);
}

static void begin_stage(demo *d, const trial_moment *m)
{
    if (d->stage.name == NULL) {
        printf("%7s%7s  %-32s%6s%6s%7s  %s\n", "s", "real s", "what the hands do", "W, N", "C, N",
               "turns", "knot");
    }
    if (strcmp(m->state, "orbit") == 0 && m->see->throws < DEMO_THROWS) {
        d->tries[m->see->throws]++;
    }
    d->stage = (demo_stage){.name = m->state};
}

static void entered(demo *d, const trial_moment *m)
{
    demo_knot k = {.notation = ""};
    if (demo_judge(d, m->see, &k) != VBSS_OK) {
        snprintf(k.notation, sizeof k.notation, "?");
    }
    if (d->stage.name != NULL) {
        report_stage(d, m, &k);
    }
    album_show(d->album, m, &k);
    begin_stage(d, m);
}

/* ---- every step */

static void feel(demo *d, const trial_moment *m)
{
    const hand *hands[2] = {m->see->w, m->see->c};
    for (int i = 0; i < 2; i++) {
        vbss_grasper_state s;
        if (vbss_grasper_get_state(hands[i]->grasper, &s, sizeof s) == VBSS_OK) {
            double force = v_length(v_load(s.hand_force));
            d->stage.force[i] = larger(d->stage.force[i], force);
            uint32_t side = demo_side(hands[i]);
            d->largest[side] = larger(d->largest[side], force);
        }
    }
}

static void ended(demo *d, const trial_moment *m)
{
    const hand *hands[2] = {m->see->w, m->see->c};
    vbss_result r = demo_judge(d, m->see, &d->knot);
    r = r ? r : vbss_scene_get_statistics(m->see->rig->scene, &d->scene, sizeof d->scene);
    for (int i = 0; i < 2; i++) {
        vbss_device *device = hands[i]->device;
        vbss_device_statistics *in = &d->device[demo_side(hands[i])];
        vbss_output_statistics *out = &d->output[demo_side(hands[i])];
        r = r ? r : vbss_device_get_statistics(device, in, sizeof *in);
        r = r ? r : vbss_device_get_output_statistics(device, out, sizeof *out);
    }
    d->ended = r == VBSS_OK;
}

void demo_watch(void *user, const trial_moment *m)
{
    demo *d = user;
    double cpu = now(CLOCK_THREAD_CPUTIME_ID) - d->left_cpu;
    if (d->watched) {
        d->cpu += cpu;
        d->wall += now(CLOCK_MONOTONIC) - d->left_wall;
    }
    d->watched = true;
    switch (m->event) {
    case TRIAL_ENTERED:
        entered(d, m);
        break;
    case TRIAL_STEPS:
        break;
    case TRIAL_STEPPED:
        keep_time(&d->times, cpu);
        feel(d, m);
        break;
    case TRIAL_ENDED:
        ended(d, m);
        break;
    }
    d->left_cpu = now(CLOCK_THREAD_CPUTIME_ID);
    d->left_wall = now(CLOCK_MONOTONIC);
}
