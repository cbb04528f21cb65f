/* What the session told while it was followed. */
#include "report/page.h"
#include "surgeon/task.h"

static const char *words_of_tool(vbss_metrics_tool tool)
{
    return tool == VBSS_METRICS_TOOL_LEFT    ? "left"
           : tool == VBSS_METRICS_TOOL_RIGHT ? "right"
                                             : "&#8211;";
}

static void put_row(page *p, const vbss_session_event *e)
{
    char words[TASK_WORDS];
    task_words(e, words);
    put(p, "<tr><td class=\"n\">%.3f</td><td class=\"n\">%llu</td><td>%s</td><td>%s</td><td%s>",
        e->time, (unsigned long long)e->step, words_of_tool(e->tool), task_phase_name(e->phase),
        e->undone != 0 ? " class=\"back\"" : "");
    put_text(p, words);
    put(p, "</td></tr>\n");
}

void page_session(page *p, const facts *f)
{
    const followed *t = &f->again.session;
    if (t->there && !t->agrees) {
        put(p,
            "<p class=\"bad\">The session, as it is made here, is not the one that was recorded: "
            "it is left out.</p>\n");
    }
    if (t->count == 0) {
        return;
    }
    put(p,
        "<details><summary>All that the session told (%llu)</summary><table><caption>Events of the "
        "session, since the needle appeared%s</caption><thead><tr><th scope=\"col\" "
        "class=\"n\">at s</th><th scope=\"col\" class=\"n\">step</th><th "
        "scope=\"col\">tool</th><th "
        "scope=\"col\">phase after it</th><th scope=\"col\">what</th></tr></thead><tbody>\n",
        (unsigned long long)t->count, t->status.first_event > 0 ? "; the oldest are not kept" : "");
    for (size_t i = 0; i < t->count; i++) {
        put_row(p, &t->events[i]);
    }
    put(p, "</tbody></table></details>\n");
}
