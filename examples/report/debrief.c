/* The three things that would raise the score most: penalties, time that mistakes took, and phases that took long. An exercise has
 * no score: there the measures that were missed, and the mistakes. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "exercise/places.h"
#include "report/page.h"
#include "surgeon/task.h"

enum { MAX_ADVICE = 96, SHOWN = 3, WORDS = 400 };
#define SHOWN_FROM 0.5 /* points: less is rounded to none */

typedef struct advice {
    double points, time; /* that it costs; when it began, s */
    char words[WORDS];
} advice;

typedef struct advice_list {
    advice all[MAX_ADVICE];
    int count;
} advice_list;

static void add(advice_list *l, double points, double time, const char *words)
{
    if (points >= SHOWN_FROM && l->count < MAX_ADVICE) {
        advice *a = &l->all[l->count++];
        a->points = points;
        a->time = time;
        (void)snprintf(a->words, sizeof a->words, "%s", words);
    }
}

/* ---- penalties: those of a kind together */

static const char *const remedies[] = {
    [VBSS_METRICS_PENALTY_DEVIATION] =
        "Bring the tip onto the mark and square to the wall before you push",
    [VBSS_METRICS_PENALTY_GAP] = "Pull both ends low and equally hard until the slit is closed",
    [VBSS_METRICS_PENALTY_TIGHTNESS] = "Seat each throw before the next one",
    [VBSS_METRICS_PENALTY_THROWS] = "Tie a double throw and two single ones",
    [VBSS_METRICS_PENALTY_GRANNY] = "Change the sense of winding from throw to throw",
    [VBSS_METRICS_PENALTY_ATTEMPT] = "Aim before you push, and do not draw the needle back",
    [VBSS_METRICS_PENALTY_DROP] = "Keep the jaws closed on the needle until the other tool has it",
    [VBSS_METRICS_PENALTY_TRANSFER] = "Hand the needle over after each throw",
    [VBSS_METRICS_PENALTY_HOST] = "Avoid what the host marks down",
    [VBSS_METRICS_PENALTY_TIMEOUT] = "Finish within the time limit",
    [VBSS_METRICS_PENALTY_AVULSED] = "Pull along the drain's top rather than up",
    [VBSS_METRICS_PENALTY_BROKEN] = "Cut only after the third throw, and pull less hard",
    [VBSS_METRICS_PENALTY_INCOMPLETE] = "Go on until both tails are cut",
    [VBSS_METRICS_PENALTY_TIME_LOST] = "Use limits of work that fit the machine",
    [VBSS_METRICS_PENALTY_ASSISTED] = "Go without the aids",
};
enum { KINDS = sizeof remedies / sizeof remedies[0] };

static void add_penalties(advice_list *l, const measured *m)
{
    for (int32_t kind = 1; kind < KINDS; kind++) {
        const vbss_metrics_penalty *largest = NULL;
        double points = 0.0;
        char words[WORDS];
        for (uint32_t i = 0; i < m->report.penalty_count; i++) {
            const vbss_metrics_penalty *e = &m->penalties[i];
            if (e->kind == kind) {
                points += e->amount;
                largest = largest == NULL || e->amount > largest->amount ? e : largest;
            }
        }
        if (largest != NULL) {
            (void)snprintf(words, sizeof words, "%s (%s).", remedies[kind], largest->text);
            add(l, points, largest->time, words);
        }
    }
}

/* ---- time that mistakes took until they were mended */

/* s. A hole beside its mark can be mended until the first throw begins. */
static double last_chance(const followed *t, uint32_t mistake)
{
    bool is_hole =
        mistake == VBSS_SESSION_MISTAKE_ENTRY_MISSED || mistake == VBSS_SESSION_MISTAKE_EXIT_MISSED;
    for (size_t i = 0; i < t->count && is_hole; i++) {
        const vbss_session_event *e = &t->events[i];
        if (e->kind == VBSS_SESSION_EVENT_PHASE && e->number == VBSS_SESSION_PHASE_THROW_1) {
            return e->time;
        }
    }
    return t->status.time;
}

static void add_mistake(advice_list *l, const followed *t, uint32_t mistake)
{
    const double end = last_chance(t, mistake);
    const vbss_session_event *first = NULL, *open = NULL;
    double seconds = 0.0;
    int times = 0;
    char words[WORDS];
    for (size_t i = 0; i < t->count; i++) {
        const vbss_session_event *e = &t->events[i];
        if (e->kind != VBSS_SESSION_EVENT_MISTAKE || e->number != mistake) {
            continue;
        }
        if (e->undone == 0) {
            first = first == NULL ? e : first;
            open = e;
        } else if (open != NULL) {
            seconds += fmax(fmin(e->time, end) - open->time, 0.0);
            times++;
            open = NULL;
        }
    }
    if (open != NULL) {
        seconds += fmax(end - open->time, 0.0);
        times++;
    }
    if (times > 0) {
        (void)snprintf(words, sizeof words, "%s That took %.1f s%s. %s",
                       vbss_session_mistake_string((vbss_session_mistake)mistake), seconds,
                       times > 1 ? " in all" : "",
                       vbss_session_remedy_string((vbss_session_mistake)mistake));
        add(l, seconds, first->time, words);
    }
}

/* ---- phases against those of the scripted surgeon */

/* s, of seed 0. 0: no such phase, or it goes on in the next one. */
static const double expert[VBSS_SESSION_PHASE_DONE] = {
    [VBSS_SESSION_PHASE_LOADING] = 1.4,     [VBSS_SESSION_PHASE_APPROACH] = 2.5,
    [VBSS_SESSION_PHASE_IN_DRAIN] = 1.9,    [VBSS_SESSION_PHASE_PULL_THROUGH] = 9.6,
    [VBSS_SESSION_PHASE_THROW_1] = 12.1,    [VBSS_SESSION_PHASE_THROW_2] = 24.4,
    [VBSS_SESSION_PHASE_TRANSFER_2] = 11.9, [VBSS_SESSION_PHASE_THROW_3] = 13.0,
    [VBSS_SESSION_PHASE_CUT] = 9.9,
};

static void add_phase_time(advice_list *l, const facts *f, vbss_session_phase number)
{
    const char *name = task_phase_name(number);
    const phase *first = NULL;
    double seconds = 0.0;
    char words[WORDS];
    for (size_t i = 0; i < f->phase_count; i++) {
        if (strcmp(f->phases[i].name, name) == 0) {
            first = first == NULL ? &f->phases[i] : first;
            seconds += f->phases[i].to - f->phases[i].from;
        }
    }
    if (first != NULL && expert[number] > 0.0) {
        (void)snprintf(words, sizeof words,
                       "The phase \"%s\" took %.0f s; the scripted surgeon needs about %.0f s.",
                       name, seconds, expert[number]);
        add(l, seconds - expert[number], first->from, words);
    }
}

/* ---- the three largest */

static void take_largest(advice_list *l, int place)
{
    int largest = place;
    for (int i = place + 1; i < l->count; i++) {
        largest = l->all[i].points > l->all[largest].points ? i : largest;
    }
    const advice a = l->all[largest];
    l->all[largest] = l->all[place];
    l->all[place] = a;
}

static void put_moment(page *p, const facts *f, double time)
{
    if (f->replay_page != NULL) {
        put(p, "<a href=\"");
        put_text(p, f->replay_page);
        put(p, "#t=%.2f\">from %.1f s on</a>", time, time);
    } else {
        put(p, "from %.1f s on", time);
    }
}

static void put_largest(page *p, const facts *f, advice_list *l, bool points)
{
    for (int i = 0; i < SHOWN && i < l->count; i++) {
        take_largest(l, i);
        put(p, "<li>");
        put_text(p, l->all[i].words);
        if (points) {
            put(p, " <strong>%.0f points</strong>, ", l->all[i].points);
        } else {
            put(p, " It was seen ");
        }
        put_moment(p, f, l->all[i].time);
        put(p, ".</li>\n");
    }
}

static void add_mistakes(advice_list *l, const followed *t)
{
    for (uint32_t m = 1; m < VBSS_SESSION_MISTAKE_COUNT; m++) {
        add_mistake(l, t, m);
    }
}

static void debrief_exercise(page *p, const facts *f, advice_list *l)
{
    const followed *t = &f->again.session;
    char words[PRACTICE_LINE];
    uint32_t missed = 0;
    put(p,
        "<section aria-labelledby=\"debrief\"><h2 id=\"debrief\">What to do better</h2>\n<ul>\n");
    for (uint32_t i = 0; i < t->measure_count; i++) {
        if (t->measures[i].is_met == 0) {
            practice_words(&t->measures[i], words);
            put(p, "<li>");
            put_text(p, words);
            put(p, ".</li>\n");
            missed++;
        }
    }
    add_mistakes(l, t);
    put_largest(p, f, l, false);
    put(p, "</ul>\n");
    if (missed == 0 && l->count == 0) {
        put(p, "<p>Nothing: every measure is met, and no mistake took time.</p>\n");
    }
    put(p, "<p class=\"note\">Measures that were missed, and the three mistakes that took most "
           "time until "
           "they were mended.</p></section>\n");
}

static void debrief_task(page *p, const facts *f, advice_list *l)
{
    add_penalties(l, &f->measured);
    add_mistakes(l, &f->again.session);
    for (vbss_session_phase i = VBSS_SESSION_PHASE_LOADING; i < VBSS_SESSION_PHASE_DONE; i++) {
        add_phase_time(l, f, i);
    }
    put(p, "<section aria-labelledby=\"debrief\"><h2 id=\"debrief\">What would raise the score "
           "most</h2>\n<ol>\n");
    put_largest(p, f, l, true);
    put(p, "</ol>\n");
    if (l->count == 0) {
        put(p,
            "<p>Nothing: no penalty, no mistake that took time, no phase slower than the scripted "
            "surgeon's.</p>\n");
    }
    put(p, "<p class=\"note\">Points of penalties, and a point for each second that a "
           "mistake took until it was mended, or that a phase took longer than the scripted "
           "surgeon's. The viewer shows a moment with <code>--replay LOG --from "
           "SECONDS</code>.</p></section>\n");
}

void page_debrief(page *p, const facts *f)
{
    static advice_list l;
    const followed *t = &f->again.session;
    if (t->count == 0 || !t->measured) {
        return; /* without a session there is nothing to improve */
    }
    l.count = 0;
    if (facts_are_of_exercise(f)) {
        debrief_exercise(p, f, &l);
    } else {
        debrief_task(p, f, &l);
    }
}
