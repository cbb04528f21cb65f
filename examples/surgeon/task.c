#include "surgeon/task.h"

#include <stdio.h>

#include "knots/words.h"

#define MILLI 1e3

vbss_result task_create(task *k, const stitch *t, vbss_record *record, vbss_replay *replay)
{
    const task_plan usual = {0};
    return task_create_as(k, t, record, replay, &usual);
}

vbss_result task_create_as(task *k, const stitch *t, vbss_record *record, vbss_replay *replay,
                           const task_plan *plan)
{
    const site *s = &t->site;
    vbss_session_config c;
    vbss_metrics_config measures;
    memset(k, 0, sizeof *k);
    TRY(vbss_metrics_config_init(&measures, sizeof measures));
    measures.drain_radius = s->tube;
    TRY(vbss_metrics_create(s->rig.context, &measures, &k->metrics));
    TRY(vbss_knot_detector_create(s->rig.context, NULL, &k->knots));
    TRY(vbss_session_config_init(&c, sizeof c));
    c.thread = s->rig.thread_body;
    c.needle = s->needle_body;
    c.drain = s->drain_body;
    c.tools[0] = stitch_hand(t, SITE_LEFT)->body;
    c.tools[1] = stitch_hand(t, SITE_RIGHT)->body;
    c.knots = k->knots;
    c.metrics = k->metrics;
    c.record = record;
    c.replay = replay;
    c.time_limit = plan->time_limit > 0.0 ? plan->time_limit : c.time_limit;
    c.coaching = plan->coaching;
    c.exercise = plan->exercise;
    return vbss_session_create(s->rig.scene, &c, &k->session);
}

vbss_result task_destroy(task *k)
{
    TRY(vbss_session_destroy(k->session));
    TRY(vbss_knot_detector_destroy(k->knots));
    TRY(vbss_metrics_destroy(k->metrics));
    memset(k, 0, sizeof *k);
    return VBSS_OK;
}

/* ---- words */

static const char *const phases[] = {
    "before the needle",
    "taking the needle",
    "to the first mark",
    "to the second mark",
    "drawing through",
    "throw 1",
    "transfer 1",
    "throw 2",
    "transfer 2",
    "throw 3",
    "cutting the tails",
    "done",
    "failed",
};
static const char *const stages[] = {"nothing of it", "wrapped", "tail grasped",
                                     "passed",        "tied",    "seated"};
static const char *const failures[] = {"no failure",
                                       "the time is up",
                                       "the drain was torn off",
                                       "cut before the third throw was seated",
                                       "cut in the knot or the tissue",
                                       "the thread broke",
                                       "something was removed"};
static const char *const tails[] = {"the short tail", "the needle's tail"};
static const char *const marks[] = {"in", "out"};

const char *task_phase_name(vbss_session_phase phase)
{
    return phase >= 0 && phase <= VBSS_SESSION_PHASE_FAILED ? phases[phase] : "?";
}

const char *task_stage_name(vbss_session_stage stage)
{
    return stage >= 0 && stage <= VBSS_SESSION_STAGE_SEATED ? stages[stage] : "?";
}

const char *task_failure_name(vbss_session_failure failure)
{
    return failure >= 0 && failure <= VBSS_SESSION_FAILURE_LOST ? failures[failure] : "?";
}

static const char *tool_of(const vbss_session_event *e)
{
    return e->tool == VBSS_METRICS_TOOL_LEFT    ? "left tool"
           : e->tool == VBSS_METRICS_TOOL_RIGHT ? "right tool"
                                                : "tool";
}

static const char *undone(const vbss_session_event *e, const char *words)
{
    return e->undone != 0 ? words : "";
}

static int throw_number(const vbss_session_event *e)
{
    return (int)e->number + 1;
}

static void words_of_tied(const vbss_session_event *e, char words[TASK_WORDS])
{
    snprintf(words, TASK_WORDS, "throw %d %s: %d wrap%s, %s-handed%s", throw_number(e),
             e->undone != 0 ? "has come undone" : "is tied", (int)e->wraps,
             e->wraps == 1 ? "" : "s", e->handedness < 0 ? "left" : "right",
             e->relation == VBSS_METRICS_RELATION_SQUARE   ? ", square"
             : e->relation == VBSS_METRICS_RELATION_GRANNY ? ", granny"
                                                           : "");
}

/* Of the stitch. */
static void words_of_stitch(const vbss_session_event *e, char words[TASK_WORDS])
{
    double mm = MILLI * e->amount;
    switch (e->kind) {
    case VBSS_SESSION_EVENT_TAKEN:
        snprintf(words, TASK_WORDS, "%s %s the needle", tool_of(e),
                 e->undone != 0 ? "lets go of" : "holds");
        return;
    case VBSS_SESSION_EVENT_PUNCTURE:
        snprintf(words, TASK_WORDS, "hole %s%s, %.2f mm off its mark", marks[e->number % 2],
                 undone(e, " left"), e->amount);
        return;
    case VBSS_SESSION_EVENT_STRAY:
        snprintf(words, TASK_WORDS, "a hole beside the marks%s", undone(e, ", left"));
        return;
    case VBSS_SESSION_EVENT_THREADED:
        snprintf(words, TASK_WORDS, "the thread is %s hole %s",
                 e->undone != 0 ? "back out of" : "in", marks[e->number % 2]);
        return;
    case VBSS_SESSION_EVENT_TAIL:
        snprintf(words, TASK_WORDS, "the tail %s %.1f mm",
                 e->undone != 0 ? "is not as it should any more:" : "is set:", mm);
        return;
    default:
        snprintf(words, TASK_WORDS, "the needle is dropped");
        return;
    }
}

/* Of the knot, and of the end. */
static void words_of_knot(const vbss_session_event *e, char words[TASK_WORDS])
{
    double mm = MILLI * e->amount;
    char faults[WORD_TAGS];
    switch (e->kind) {
    case VBSS_SESSION_EVENT_STAGE:
        snprintf(words, TASK_WORDS, "throw %d: %s", throw_number(e), task_stage_name(e->stage));
        return;
    case VBSS_SESSION_EVENT_THROW:
        words_of_tied(e, words);
        return;
    case VBSS_SESSION_EVENT_SEATED:
        snprintf(words, TASK_WORDS, "throw %d is %sseated, the slit gapes %.2f mm", throw_number(e),
                 undone(e, "no longer "), mm);
        return;
    case VBSS_SESSION_EVENT_TRANSFER:
        snprintf(words, TASK_WORDS, "%s takes the needle over after throw %d", tool_of(e),
                 throw_number(e));
        return;
    case VBSS_SESSION_EVENT_TRANSFER_MISSED:
        snprintf(words, TASK_WORDS, "throw %d without the needle having changed hands%s",
                 throw_number(e), undone(e, ": undone"));
        return;
    case VBSS_SESSION_EVENT_FAULT:
        words_of_faults(e->number, faults);
        snprintf(words, TASK_WORDS, "the knot%s: %s", undone(e, " is no longer"), faults);
        return;
    case VBSS_SESSION_EVENT_CUT:
        snprintf(words, TASK_WORDS, "%s is cut, %.1f mm are left", tails[e->number % 2], mm);
        return;
    default:
        snprintf(words, TASK_WORDS, "failed: %s",
                 task_failure_name((vbss_session_failure)e->number));
        return;
    }
}

static const char *name_of_aid(uint32_t aid)
{
    static const char *const names[] = {"the needle stays on its arc",
                                        "the limb is wound at one radius",
                                        "the roll snaps",
                                        "slow motion",
                                        "hands do not sink",
                                        "an idle tool stays"};
    for (size_t i = 0; i < sizeof names / sizeof names[0]; i++) {
        if (aid == 1U << i) {
            return names[i];
        }
    }
    return "unknown";
}

void task_words(const vbss_session_event *e, char words[TASK_WORDS])
{
    switch (e->kind) {
    case VBSS_SESSION_EVENT_APPEARED:
        snprintf(words, TASK_WORDS, "the needle has appeared");
        return;
    case VBSS_SESSION_EVENT_PHASE:
        snprintf(words, TASK_WORDS, "%s: %s", e->undone != 0 ? "back to" : "phase",
                 task_phase_name((vbss_session_phase)e->number));
        return;
    case VBSS_SESSION_EVENT_DONE:
        snprintf(words, TASK_WORDS, "the task is complete");
        return;
    case VBSS_SESSION_EVENT_GOAL:
    case VBSS_SESSION_EVENT_MISTAKE:
        task_words_of_coach(e, words);
        return;
    case VBSS_SESSION_EVENT_AID:
        snprintf(words, TASK_WORDS, "aid %s: %s", e->undone != 0 ? "off" : "on, no score",
                 name_of_aid(e->number));
        return;
    case VBSS_SESSION_EVENT_EXERCISE:
        snprintf(words, TASK_WORDS, "the exercise is %s",
                 e->amount > 0.0 ? "passed" : "not passed");
        return;
    case VBSS_SESSION_EVENT_TIME_LOST:
        snprintf(words, TASK_WORDS, "%s simulated time is lost: %.3f s",
                 e->undone != 0 ? "little" : "much", e->amount);
        return;
    default:
        break;
    }
    if (e->kind <= VBSS_SESSION_EVENT_TAIL) {
        words_of_stitch(e, words);
    } else {
        words_of_knot(e, words);
    }
}
