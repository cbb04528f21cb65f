/* What came of it: completed or not, time, score and every point that it is below 600. */
#include "knots/words.h"

#include "exercise/places.h"
#include "report/page.h"
#include "surgeon/task.h"

static const char *why_not(const facts *f)
{
    uint32_t flags = f->measured.report.flags;
    vbss_session_failure failure = f->again.session.status.failure;
    if (f->steps == 0) {
        return "the log holds no complete step";
    }
    if (f->again.session.count > 0 && failure != VBSS_SESSION_FAILURE_NONE) {
        return task_failure_name(failure);
    }
    if ((flags & VBSS_METRICS_FLAG_TIMEOUT) != 0) {
        return "the time was up";
    }
    if ((flags & VBSS_METRICS_FLAG_AVULSED) != 0) {
        return "the drain was torn off";
    }
    if ((flags & VBSS_METRICS_FLAG_BROKEN) != 0) {
        return "the thread broke";
    }
    if (f->check.result == VBSS_ERROR_TRUNCATED) {
        return "the log is cut off before both tails were cut";
    }
    if (f->check.result != VBSS_OK) {
        return "the log is damaged before both tails were cut";
    }
    return "the log ends before both tails were cut";
}

/* ---- cards */

typedef enum outcome { WHOLE, PART, NOT_DONE } outcome;

/* Both tails cut is the end of the task; what else belongs to it may be missing, or not be known. */
static outcome outcome_of(const facts *f)
{
    const vbss_metrics_report *r = &f->measured.report;
    uint32_t failed =
        VBSS_METRICS_FLAG_TIMEOUT | VBSS_METRICS_FLAG_AVULSED | VBSS_METRICS_FLAG_BROKEN;
    uint32_t holes = VBSS_METRICS_FLAG_PUNCTURE_0 | VBSS_METRICS_FLAG_PUNCTURE_1;
    if ((r->flags & VBSS_METRICS_FLAG_STOPPED) == 0 || (r->flags & failed) != 0) {
        return NOT_DONE;
    }
    return (r->flags & holes) == holes && r->throw_count >= f->measured.config.throws_wanted ? WHOLE
                                                                                             : PART;
}

static void put_task(page *p, const facts *f)
{
    static const char *const words[] = {"Completed", "In part", "Not completed"};
    static const char *const styles[] = {"good", "warn", "bad"};
    const vbss_metrics_report *r = &f->measured.report;
    outcome o = outcome_of(f);
    put(p, "<div class=\"card\"><p class=\"label\">Task</p><p class=\"big %s\">%s</p><p>",
        styles[o], words[o]);
    if (o == NOT_DONE) {
        put_text(p, why_not(f));
        if (f->again.session.count > 0) {
            put(p, "; the phase then: %s", task_phase_name(f->again.session.status.phase));
        }
    } else {
        put(p, "both tails were cut");
    }
    if (o == PART && f->again.count == 0) {
        put(p, "; whether all else was done is not known, as the log was not played back");
    } else if (o == PART) {
        put(p, "; %u of %u throws stand, %s", (unsigned)r->throw_count,
            (unsigned)f->measured.config.throws_wanted,
            f->again.puncture_count == 0 ? "no wall was pierced" : "not both marks were pierced");
    }
    put(p, "</p></div>\n");
}

static void put_knot_card(page *p, const facts *f)
{
    const again *a = &f->again;
    put(p, "<div class=\"card\"><p class=\"label\">Knot</p><p class=\"big\">");
    if (a->reading_count == 0) {
        put(p, "unknown</p><p>%s</p></div>\n",
            a->count > 0 ? "no knot is judged in this scene" : "the log was not played back");
        return;
    }
    const reading *last = &a->readings[a->reading_count - 1], *proved = facts_certified(f);
    const reading *shown = proved != NULL ? proved : last;
    put_text(p, shown->notation[0] != '\0' ? shown->notation : "none");
    put(p, "</p><p>");
    if (shown == last) {
        put(p, "at the end%s",
            proved == last                                  ? ", certified"
            : last->state.verdict != VBSS_KNOT_VERDICT_NONE ? ", not certified"
                                                            : "");
    } else {
        put(p, "certified at %.2f s; at the end ", shown->time);
        put_text(p, last->notation[0] != '\0' ? last->notation : "none");
        put(p, ", %s", words_of_result(last->state.verdict));
    }
    put(p, "</p></div>\n");
}

static void put_score_card(page *p, const facts *f)
{
    const vbss_metrics_report *r = &f->measured.report;
    put(p, "<div class=\"card\"><p class=\"label\">Score</p><p class=\"big");
    if ((r->flags & VBSS_METRICS_FLAG_ASSISTED) != 0) {
        put(p, "\">none</p><p>the trainee was assisted</p></div>\n");
    } else if (page_may_go_on(f)) {
        put(p, "\">unknown</p><p>how the trial went on is not in the log</p></div>\n");
    } else if ((r->flags & VBSS_METRICS_FLAG_FINAL) != 0) {
        put(p, "\">%.1f</p><p>of 600, in the style of MISTELS</p></div>\n", r->score);
    } else {
        put(p,
            " unsure\">%.1f</p><p>of 600, provisional: not everything that counts is "
            "known</p></div>\n",
            r->score);
    }
}

static void put_cards(page *p, const facts *f)
{
    const measured *m = &f->measured;
    bool done = outcome_of(f) != NOT_DONE;
    put(p, "<div class=\"cards\">\n");
    if (!facts_are_of_exercise(f)) {
        put_task(p, f);
    }
    put(p,
        "<div class=\"card\"><p class=\"label\">Time</p><p class=\"big\">%.2f "
        "<small>s</small></p><p>on the session clock, %.2f s of it simulated; %s</p></div>\n",
        m->report.time, m->report.time_simulated,
        done ? "from the begin of the log to the second cut"
             : "recorded, from the begin of the log");
    if (!facts_are_of_exercise(f)) {
        put_score_card(p, f);
    }
    put_knot_card(p, f);
    put(p, "</div>\n");
}

/* ---- an exercise, which has an outcome in place of a score */

static const char *words_of_outcome(vbss_session_outcome found)
{
    return found == VBSS_SESSION_OUTCOME_PASSED   ? "Passed"
           : found == VBSS_SESSION_OUTCOME_FAILED ? "Not passed"
                                                  : "Not ended";
}

static void put_exercise(page *p, const followed *t)
{
    const vbss_session_exercise_state *e = &t->exercise;
    char words[PRACTICE_LINE];
    put(p, "<div class=\"cards\"><div class=\"card\"><p class=\"label\">Exercise ");
    put_text(p, e->name);
    put(p, "</p><p class=\"big %s\">%s</p><p>",
        e->outcome == VBSS_SESSION_OUTCOME_PASSED ? "good" : "bad", words_of_outcome(e->outcome));
    put_text(p, e->sentence);
    put(p, " %.1f s%s. An exercise has no score.</p></div></div>\n<ul>\n", e->time,
        e->aids_used != 0 ? ", with aids" : "");
    for (uint32_t i = 0; i < t->measure_count; i++) {
        practice_words(&t->measures[i], words);
        put(p, "<li class=\"%s\">", t->measures[i].is_met != 0 ? "good" : "bad");
        put_text(p, words);
        put(p, "%s</li>\n", t->measures[i].is_met != 0 ? "" : " (missed)");
    }
    put(p, "</ul>\n");
}

/* ---- every point */

static void put_where(page *p, const vbss_metrics_penalty *e)
{
    bool known = e->step > 0 || e->time > 0.0;
    if (known) {
        put(p, "<td class=\"n\">%.3f</td><td class=\"n\">%llu</td>", e->time,
            (unsigned long long)e->step);
    } else {
        put(p, "<td class=\"n\">&#8211;</td><td class=\"n\">&#8211;</td>");
    }
    put(p, "<td>%s</td>",
        e->tool == VBSS_METRICS_TOOL_LEFT    ? "left"
        : e->tool == VBSS_METRICS_TOOL_RIGHT ? "right"
                                             : "&#8211;");
}

static void put_score(page *p, const measured *m)
{
    put(p,
        "<table><caption>From %.0f points to the score</caption><thead><tr><th "
        "scope=\"col\">Reason</th><th scope=\"col\" class=\"n\">Measure</th><th scope=\"col\" "
        "class=\"n\">at s</th><th scope=\"col\" class=\"n\">step</th><th scope=\"col\">tool</th>"
        "<th scope=\"col\" class=\"n\">Points</th></tr></thead>\n<tbody>\n",
        m->config.max_time);
    put(p,
        "<tr><th scope=\"row\">most there is</th><td></td><td></td><td></td><td></td><td "
        "class=\"n\">%.1f</td></tr>\n",
        m->config.max_time);
    put(p,
        "<tr><th scope=\"row\">time on the session clock, a point a second</th><td "
        "class=\"n\">%.2f "
        "s</td><td></td><td></td><td></td><td class=\"n\">&#8722;%.1f</td></tr>\n",
        m->report.time, m->report.time);
    for (uint32_t i = 0; i < m->report.penalty_count; i++) {
        const vbss_metrics_penalty *e = &m->penalties[i];
        put(p, "<tr><th scope=\"row\">");
        put_text(p, e->text);
        put(p, "</th><td class=\"n\">%.2f</td>", e->measure);
        put_where(p, e);
        put(p, "<td class=\"n\">%s%.1f</td></tr>\n", e->amount > 0.0 ? "&#8722;" : "", e->amount);
    }
    put(p,
        "</tbody><tfoot><tr><th scope=\"row\" colspan=\"5\">score</th><td "
        "class=\"n\">%.1f</td></tr></tfoot></table>\n",
        m->report.score);
}

static void put_score_note(page *p, const facts *f)
{
    const measured *m = &f->measured;
    put(p,
        "<p class=\"note\">600 &#8722; time &#8722; penalties, as Korndorffer et al. published the "
        "form in 2005; the weights are common ones and not those of FLS, which are not published. "
        "This is not an FLS score and says nothing of certification. The session clock adds up the "
        "lengths of the steps. It runs with the hands and includes simulated time that was lost: "
        "%.2f s.",
        m->report.time_lost);
    if ((m->report.flags & VBSS_METRICS_FLAG_FINAL) == 0) {
        put(p, " What is not known costs nothing here, so a whole trial with the same faults "
               "could have less.");
    }
    if (page_may_go_on(f)) {
        put(p,
            " Here the end of the log is taken for the end of the trial, which may have gone on.");
    }
    put(p, "</p>");
}

void page_summary(page *p, const facts *f)
{
    put(p, "<section aria-labelledby=\"summary\"><h2 id=\"summary\">Summary</h2>\n");
    if (facts_are_of_exercise(f)) {
        put_exercise(p, &f->again.session);
    }
    put_cards(p, f);
    if (!facts_are_of_exercise(f)) {
        put_score(p, &f->measured);
        put_score_note(p, f);
    }
    put(p, "</section>\n");
}
