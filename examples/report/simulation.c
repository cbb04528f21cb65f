/* How the simulation fared: hashes, guard, contacts, what a step takes. */
#include <stdlib.h>

#include "report/page.h"

static int compare(const void *a, const void *b)
{
    const double *x = a, *y = b;
    return (*x > *y) - (*x < *y);
}

static void put_times(page *p, const again *a)
{
    double *cpu_time = calloc((size_t)a->count + 1, sizeof *cpu_time);
    uint64_t late = 0;
    if (cpu_time == NULL) {
        return;
    }
    for (uint64_t i = 0; i < a->count; i++) {
        cpu_time[i] = 1e6 * a->steps[i].cpu_time;
        late += cpu_time[i] > 1e3;
    }
    qsort(cpu_time, (size_t)a->count, sizeof *cpu_time, compare);
    put(p,
        "<table><caption>Time of a step, &#181;s of this thread's CPU</caption><thead><tr><th "
        "scope=\"col\" class=\"n\">median</th><th scope=\"col\" class=\"n\">p99</th><th "
        "scope=\"col\" class=\"n\">p99.9</th><th scope=\"col\" class=\"n\">most</th><th "
        "scope=\"col\" class=\"n\">above 1 ms</th></tr></thead><tbody><tr><td "
        "class=\"n\">%.0f</td><td class=\"n\">%.0f</td><td class=\"n\">%.0f</td><td "
        "class=\"n\">%.0f</td><td class=\"n\">%.2f %%</td></tr></tbody></table>\n"
        "<p class=\"note\">Logs hold no times of steps: these are of %s, once, on a machine that "
        "may do other things.</p>\n",
        cpu_time[a->count / 2], cpu_time[(size_t)(0.99 * (double)a->count)],
        cpu_time[(size_t)(0.999 * (double)a->count)], cpu_time[a->count - 1],
        100.0 * (double)late / (double)a->count,
        a->performed ? "making it here, devices, session and log included"
                     : "playing it back here");
    free(cpu_time);
}

static void put_count(page *p, const char *name, uint64_t count, const char *words)
{
    put(p, "<tr><th scope=\"row\">%s</th><td class=\"n\">%llu</td><td>%s</td></tr>\n", name,
        (unsigned long long)count, words);
}

static void put_events(page *p, const facts *f)
{
    put(p,
        "<table><caption>Counted in the log</caption><thead><tr><th scope=\"col\">What</th><th "
        "scope=\"col\" class=\"n\">times</th><th scope=\"col\">meaning</th></tr></thead><tbody>\n");
    put_count(p, "contacts begun", f->counts[VBSS_SCENE_EVENT_TOUCH],
              "two bodies touched that did not");
    put_count(p, "contacts ended", f->counts[VBSS_SCENE_EVENT_PART],
              "two that touched do no longer");
    put_count(p, "steps cut short or paused", f->counts[VBSS_RECORD_EVENT_TIME_LOST],
              "by the guard or the limit of work");
    put_count(p, "slips in jaws", f->counts[VBSS_SCENE_EVENT_SLIP], "what is held begins to slide");
    put_count(p, "torn out", f->counts[VBSS_SCENE_EVENT_TORN], "pulled out of the jaws");
    put_count(p, "grasps without room", f->counts[VBSS_SCENE_EVENT_GRASP_LOST],
              "not held for that");
    put_count(p, "steps with lost events", f->counts[VBSS_RECORD_EVENT_LOST],
              "more happened than was kept");
    put(p, "</tbody></table>\n<p>Simulated time lost in steps cut short or paused: %.2f ms.</p>\n",
        1e3 * f->check.time_lost);
}

static void put_scene(page *p, const again *a)
{
    const vbss_scene_statistics *s = &a->scene;
    uint32_t largest = 0;
    for (uint64_t i = 0; i < a->count; i++) {
        largest = a->steps[i].contacts > largest ? a->steps[i].contacts : largest;
    }
    put(p, "<table><caption>Guard and contacts, from playing it back</caption><thead><tr><th "
           "scope=\"col\">What</th><th scope=\"col\" class=\"n\">count</th><th "
           "scope=\"col\">meaning</th></tr></thead><tbody>\n");
    put_count(p, "most contacts at a time", largest, "that carry a force");
    put_count(p, "parts of steps", s->parts, "steps are divided where they are hard");
    put_count(p, "attempts", s->attempts, "rejected ones included");
    put_count(p, "rejected by the guard", s->rejected_guard, "something would have passed");
    put_count(p, "rejected, depth", s->rejected_depth, "too much penetration");
    put_count(p, "rejected, stretch", s->rejected_stretch, "lengths or shape not found");
    put_count(p, "clamped", s->clamped, "parts cut short by the guard");
    put_count(p, "paused", s->paused, "steps of which a part was left out");
    put_count(p, "pairs looked at", s->guard_pairs, "by the guard");
    put(p,
        "</tbody></table>\n<p>Deepest penetration %.1f &#181;m; largest stretch error "
        "%.3f %%.</p>\n",
        1e6 * s->penetration, 100.0 * s->stretch_error);
}

static void put_replay(page *p, const facts *f)
{
    const again *a = &f->again;
    if (a->performed) {
        put(p,
            "<p>Watched while the hands made it, session and all: its log was not played back for "
            "this page.</p>\n");
        return;
    }
    if (a->name == NULL) {
        put(p, "<p class=\"absent\">Not played back: %s.</p>\n",
            !a->asked ? "it was asked not to"
            : f->info.note_bytes > 0
                ? "the note of the log names no scene that this program can make"
                : "the log has no note of which scene it is");
        return;
    }
    put(p, "<p><strong class=\"%s\">",
        a->report.outcome == VBSS_REPLAY_OUTCOME_DIFFERS ? "bad" : "good");
    if (a->report.outcome == VBSS_REPLAY_OUTCOME_DIFFERS) {
        put(p, "Played back to other bits: the first hash that differs is after step %llu.",
            (unsigned long long)a->report.step);
    } else {
        put(p, "Played back to the same bits");
    }
    put(p, "</strong> ");
    if (a->report.outcome != VBSS_REPLAY_OUTCOME_DIFFERS) {
        put(p, "through step %llu, all recorded hashes agree up to step %llu%s; ",
            (unsigned long long)a->count, (unsigned long long)a->report.agreed_step,
            a->result == VBSS_OK ? "" : ", where the log ends");
    }
    put(p, "the scene: %s%s.</p>\n", a->name,
        a->session.there && a->session.agrees ? "; its session was followed, and came to the same"
                                              : "");
    if (a->result != VBSS_OK) {
        put(p, "<p class=\"bad\">It ended with %s. ", vbss_result_name(a->result));
        put_text(p, a->problem);
        put(p, "</p>\n");
    }
}

void page_simulation(page *p, const facts *f)
{
    put(p, "<section aria-labelledby=\"simulation\"><h2 id=\"simulation\">Simulation</h2>\n");
    put_replay(p, f);
    put(p, "<div class=\"pair\"><div>\n");
    put_events(p, f);
    put(p, "</div><div>\n");
    if (f->again.count > 0) {
        put_scene(p, &f->again);
    }
    put(p, "</div></div>\n");
    if (f->again.count > 0) {
        put_times(p, &f->again);
    } else {
        put(p, "<p class=\"absent\">Times of steps: not known, as logs hold none.</p>\n");
    }
    put(p, "</section>\n");
}
