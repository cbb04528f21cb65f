#include "throw/trial.h"

#include <stdio.h>
#include <string.h>

#include "throw/core_speed.h"
#include "throw/mistake.h"
#include "throw/picture.h"

#define STEP 1e-3

typedef struct trial {
    const trial_options *options;
    throw_rig rig;
    hand hands[2];
    senses see;
    throw_run run;
    transfer_run pass;
    cut_run cut;
    uint64_t steps;
    int pictures;
    double next_picture;
} trial;

typedef struct knot {
    const char *name, *notation;
    int wraps, throws; /* of the first throw; all of them, the others with one wrap */
} knot;
static const knot knots[TRIAL_KINDS] = {{"single", "1", 1, 1},
                                        {"double", "2", 2, 1},
                                        {"square", "1=1", 1, 2},
                                        {"surgeons", "2=1", 2, 2},
                                        {"fls", "2=1=1", 2, 3}};

const char *trial_name(int kind)
{
    return knots[kind].name;
}

int trial_kind_of(const char *name)
{
    int kind = 0;
    while (kind < TRIAL_KINDS && strcmp(name, knots[kind].name) != 0) {
        kind++;
    }
    return kind;
}

/* ---- the beginning */

static hand_nature nature_of(uint64_t seed)
{
    uint64_t random = seed;
    hand_nature n = {.speed = 1.0, .seed = 1};
    if (seed != 0) {
        n.speed = 0.6 + 0.9 * hand_chance(&random);
        n.tremor = 1e-4 + 3e-4 * hand_chance(&random);
        n.target_at = 0.8e-3;
        n.target_end = 0.5e-3;
        n.seed = seed * 77 + 1;
    }
    return n;
}

static void plan_first(const trial_options *o, throw_plan *plan)
{
    throw_plan_usual(plan, knots[o->kind].wraps);
    if (o->mistake != THROW_NO_MISTAKE && knots[o->kind].throws == 1) {
        throw_plan_spoil(plan, o->mistake);
    }
}

vbss_result trial_set_up(const trial_options *o, throw_rig *s, hand hands[2])
{
    const vec left = v3(-0.11, -0.05, 0.08), right = v3(0.11, -0.05, 0.08);
    hand_nature nature = nature_of(o->seed);
    throw_plan plan;
    plan_first(o, &plan);
    TRY(throw_rig_create(s, 0.03, 0.117));
    TRY(hand_create(&hands[0], s, &nature, left, v3(-0.06, -0.06, 0.06), v3(-1.0, 0.1, 0.0), 0.0));
    nature.seed += 1000;
    uint32_t held = s->marks[1] + (uint32_t)(plan.hold / SEGMENT + 0.5);
    vec jaws = v3(0.5, -0.15, 0.85); /* to their handle's end */
    vec at = v_along(throw_rig_nodes(s)[held], -GRASP_BEHIND, v_unit(jaws));
    TRY(hand_create(&hands[1], s, &nature, right, at, v3(-0.25, -0.15, 0.95), 1.0));
    return throw_rig_hold_limb(s, held);
}

/* ---- a step */

static void show(trial *t, trial_event event, const char *state)
{
    if (t->options->watch != NULL) {
        trial_moment m = {event, state, &t->run, &t->see};
        t->options->watch(t->options->user, &m);
    }
}

static vbss_result step(trial *t)
{
    TRY(hand_step(&t->hands[0], STEP));
    TRY(hand_step(&t->hands[1], STEP));
    show(t, TRIAL_STEPS, "");
    TRY(throw_rig_step(&t->rig, STEP));
    show(t, TRIAL_STEPPED, "");
    TRY(hand_feel(&t->hands[0]));
    TRY(hand_feel(&t->hands[1]));
    TRY(senses_observe(&t->see));
    if (t->steps++ % 10 == 0) {
        TRY(senses_wind(&t->see));
    }
    return VBSS_OK;
}

static void report(trial *t, const char *state, bool changed)
{
    const senses *s = &t->see;
    const trial_options *o = t->options;
    if (changed) {
        show(t, TRIAL_ENTERED, state);
    }
    if (o->verbose && (changed || t->steps % 200 == 0)) {
        vbss_scene_statistics c;
        (void)vbss_scene_get_statistics(t->rig.scene, &c, sizeof c);
        printf("%6.3f %-7s phi %6.1f rho %4.1f Tc %6.3f Tw %6.3f turns %5.2f first %3u %4.1f last "
               "%3u %4.1f"
               " W %5.1f %5.1f %5.1f C %5.1f %5.1f %5.1f rejected %lu clamped %lu\n",
               t->rig.time, state, t->run.phi * 57.2958, t->run.rho * 1e3, s->tension_c,
               s->tension_w, s->turns, s->first, s->first_s * 1e3, s->last, s->last_s * 1e3,
               s->tool_w.tip.x * 1e3, s->tool_w.tip.y * 1e3, s->tool_w.tip.z * 1e3,
               s->tool_c.tip.x * 1e3, s->tool_c.tip.y * 1e3, s->tool_c.tip.z * 1e3,
               (unsigned long)(c.rejected_states + c.rejected_stretch + c.rejected_depth +
                               c.rejected_guard),
               (unsigned long)c.clamped);
        fflush(stdout);
    }
    if (o->folder != NULL && (changed || t->rig.time >= t->next_picture)) {
        char path[512], text[96];
        snprintf(path, sizeof path, "%s/%03d.png", o->folder, t->pictures++);
        snprintf(text, sizeof text, "%.2f s %s turns %.2f", t->rig.time, state, s->turns);
        (void)picture_write(s, path, text, o->near);
        t->next_picture = t->rig.time + o->every;
    }
}

/* ---- the parts of a knot */

static vbss_result tie(trial *t, const throw_plan *plan, bool *good)
{
    double begin = t->rig.time;
    throw_state before = THROW_STATES;
    throw_run *r = &t->run;
    throw_begin(r, &t->see, plan);
    while (r->state != THROW_DONE && r->state != THROW_FAILED &&
           t->rig.time - begin < t->options->time_limit) {
        report(t, throw_state_name(r->state), r->state != before);
        before = r->state;
        TRY(throw_step(r, STEP));
        TRY(step(t));
    }
    report(t, throw_state_name(r->state), true);
    *good = r->state == THROW_DONE;
    return VBSS_OK;
}

static vbss_result change_hands(trial *t, bool *good)
{
    transfer_state before = TRANSFER_DONE;
    double begin = t->rig.time;
    TRY(senses_find_roots(&t->see));
    transfer_begin(&t->pass, &t->see);
    while (t->pass.state != TRANSFER_DONE && t->pass.state != TRANSFER_FAILED &&
           t->rig.time - begin < t->options->time_limit) {
        report(t, transfer_state_name(t->pass.state), t->pass.state != before);
        before = t->pass.state;
        TRY(transfer_step(&t->pass, STEP));
        TRY(step(t));
    }
    *good = t->pass.state == TRANSFER_DONE;
    if (!*good) {
        t->run.why = "limb not handed over";
    }
    return VBSS_OK;
}

static bool is_same_type(const vbss_knot_state *a, const vbss_knot_state *b)
{
    return a->certified == 1 && b->certified == 1 && a->throw_count == b->throw_count &&
           a->determinant == b->determinant && a->signature == b->signature &&
           a->signature_tristram == b->signature_tristram && a->v2 == b->v2 && a->v3 == b->v3;
}

/* In a tight knot the detector may prove the type without finding each throw's place. */
static bool is_tight(const vbss_knot_state *k, const vbss_knot_state *formed)
{
    return k->verdict == VBSS_KNOT_VERDICT_FORMED && is_same_type(k, formed);
}

static vbss_result cut_ends(trial *t, trial_outcome *out)
{
    cut_state before = CUT_DONE;
    cut_run *r = &t->cut;
    double begin = t->rig.time;
    TRY(cut_begin(r, &t->see));
    while (r->state != CUT_DONE && r->state != CUT_FAILED &&
           t->rig.time - begin < t->options->time_limit) {
        report(t, cut_state_name(r->state), r->state != before);
        before = r->state;
        TRY(cut_step(r, STEP));
        TRY(step(t));
    }
    report(t, cut_state_name(r->state), true);
    out->cuts = r->ends;
    senses_knot k;
    TRY(senses_judge(&t->see, false, &k));
    out->kept = k.state.verdict == VBSS_KNOT_VERDICT_CERTIFIED
                    ? strcmp(k.notation, out->notation) == 0
                    : is_tight(&k.state, &t->run.formed.state);
    out->left[0] = r->left_tail;
    out->left[1] = r->left_limb;
    return VBSS_OK;
}

static vbss_result tie_all(trial *t, trial_outcome *out)
{
    throw_plan plan;
    bool good;
    char note[64];
    snprintf(note, sizeof note, "vbss throw %s seed %lu", trial_name((int)t->options->kind),
             (unsigned long)t->options->seed);
    plan_first(t->options, &plan);
    plan.wrong = plan.wrong || t->options->wrong;
    plan.unchecked = plan.unchecked || t->options->unchecked;
    TRY(trial_set_up(t->options, &t->rig, t->hands));
    TRY(throw_rig_begin(&t->rig, t->options->log, note));
    TRY(senses_create(&t->see, &t->rig, &t->hands[0], &t->hands[1]));
    TRY(senses_observe(&t->see));
    const int throws = knots[t->options->kind].throws;
    TRY(tie(t, &plan, &good));
    out->retries = t->run.retries;
    out->refused = t->run.refused;
    for (int i = 1; i < throws && good; i++) {
        throw_plan_on_top(&plan);
        if (t->options->mistake != THROW_NO_MISTAKE && i + 1 == throws) {
            throw_plan_spoil(&plan, t->options->mistake);
        }
        TRY(change_hands(t, &good));
        if (good) {
            TRY(tie(t, &plan, &good));
            out->retries += t->run.retries;
            out->refused += t->run.refused;
        }
    }
    out->good = good;
    return VBSS_OK;
}

/* ---- how it went */

/* Is it proved, at least its type? */
static bool note(trial *t, const senses_knot *k, trial_outcome *out)
{
    const senses_knot *formed = &t->run.formed;
    out->tight = is_tight(&k->state, &formed->state);
    out->handedness = out->tight ? formed->handedness : k->handedness;
    memcpy(out->notation, out->tight ? formed->notation : k->notation, sizeof out->notation);
    return out->tight || k->state.verdict == VBSS_KNOT_VERDICT_CERTIFIED;
}

static vbss_result read_outcome(trial *t, trial_outcome *out)
{
    const knot *tied = &knots[t->options->kind];
    senses_knot k;
    vbss_scene_statistics c;
    TRY(senses_find_knot(&t->see));
    TRY(senses_judge(&t->see, false, &k));
    TRY(vbss_scene_get_statistics(t->rig.scene, &c, sizeof c));
    bool proved = note(t, &k, out);
    out->knot = k;
    out->predicted = t->run.predicted;
    out->height = t->see.knot_height;
    out->lowest = t->see.knot_lowest;
    out->highest = t->see.knot_highest;
    out->time = t->rig.time;
    out->clamped = c.clamped;
    out->state = throw_state_name(t->run.state);
    out->why = t->run.why != NULL ? t->run.why : "";
    if (t->options->mistake != THROW_NO_MISTAKE) {
        out->good =
            out->good && mistake_is_reported(t->options->mistake, out, (uint32_t)tied->throws,
                                             tied->throws > 1 ? 1 : tied->wraps);
        return VBSS_OK;
    }
    out->good = out->good && proved && out->handedness == throw_handedness(&t->run) &&
                strcmp(out->notation, tied->notation) == 0 && out->height < 2e-3;
    return VBSS_OK;
}

vbss_result trial_run(const trial_options *o, trial_outcome *out)
{
    static trial t;
    const double start = cpu_clock(NULL);
    memset(&t, 0, sizeof t);
    memset(out, 0, sizeof *out);
    t.options = o;
    vbss_result result = tie_all(&t, out);
    if (result == VBSS_OK) {
        result = read_outcome(&t, out);
    }
    if (result == VBSS_OK && out->good && o->cut) {
        result = cut_ends(&t, out);
        out->time = t.rig.time;
    }
    if (result == VBSS_OK) {
        result = throw_rig_end(&t.rig);
    }
    if (result == VBSS_OK) {
        show(&t, TRIAL_ENDED, throw_state_name(t.run.state));
    }
    out->cpu = cpu_clock(NULL) - start;
    throw_rig_destroy(&t.rig);
    return result;
}
