/* The scripted surgeon performs the task once, and everything is made of that performance:
 *
 *     demo FOLDER [-s seed] [-u pass|pull|tie|over|second|back|third|cut: the last stage]
 *
 * Into the folder, which must have a folder "stages", go the log (task.vbss), a film (task.mp4), stills (frame-*.png), a report
 * (report.html), a page that plays the session (replay.html), pictures of the key stages (stages) and details (details.txt).
 * Without OpenGL, ffmpeg, or esbuild and three.js it says what is missing and makes the rest. Exits 0 if the task was
 * completed, or the last stage that was named is done, and nothing else failed; 1 otherwise; 2 if it was called wrongly. */
#include <stdlib.h>
#include <unistd.h>

#include "decimal_point.h"
#include "demo/performance.h"

static surgeon_stage stage_after(const char *name)
{
    for (int i = 0; i < SURGEON_DONE; i++) {
        if (strcmp(name, surgeon_stage_name((surgeon_stage)i)) == 0) {
            return (surgeon_stage)(i + 1);
        }
    }
    return SURGEON_FAILED;
}

static bool place(char *into, const char *folder, const char *name)
{
    const int length = snprintf(into, PATH_SIZE, "%s/%s", folder, name);
    return length > 0 && length < PATH_SIZE;
}

static bool find_places(places *at)
{
    return place(at->log, at->folder, "task.vbss") && place(at->film, at->folder, "task.mp4") &&
           place(at->stages, at->folder, "stages") && place(at->page, at->folder, "replay.html") &&
           place(at->report, at->folder, "report.html") &&
           place(at->details, at->folder, "details.txt");
}

static bool read_options(int count, char **words, performance *p)
{
    surgeon_options *o = &p->watch.options;
    o->until = SURGEON_DONE;
    for (int i = 1; i < count; i++) {
        if (strcmp(words[i], "-s") == 0 && i + 1 < count) {
            o->seed = strtoul(words[++i], NULL, 10);
        } else if (strcmp(words[i], "-u") == 0 && i + 1 < count) {
            o->until = stage_after(words[++i]);
        } else if (words[i][0] != '-' && p->at.folder == NULL) {
            p->at.folder = words[i];
        } else {
            return false;
        }
    }
    return p->at.folder != NULL && o->until != SURGEON_FAILED && find_places(&p->at);
}

/* Standard output goes to the details; the bar and the summary go where it went. NULL: that cannot be. */
static FILE *divert(const char *details)
{
    const int screen = dup(STDOUT_FILENO);
    FILE *to = screen >= 0 ? fdopen(screen, "w") : NULL;
    if (to == NULL || freopen(details, "w", stdout) == NULL) {
        fprintf(stderr, "%s cannot be written\n", details);
        return NULL;
    }
    return to;
}

static bool completed(const performance *p)
{
    const surgeon *s = &p->surgeon;
    const bool made =
        p->result == VBSS_OK && s->stage >= p->watch.options.until && s->stage != SURGEON_FAILED;
    return made && (p->watch.options.until < SURGEON_DONE ||
                    (watch_complete(&p->watch) && surgeon_slit_is_shut(s)));
}

int main(int count, char **words)
{
    use_decimal_point();
    static performance p = {.watch = {.time_limit = 250.0, .every = 1e9}};
    if (!read_options(count, words, &p)) {
        fprintf(stderr, "demo FOLDER [-s seed] [-u pass|pull|tie|over|second|back|third|cut]\n");
        return 2;
    }
    FILE *screen = divert(p.at.details);
    if (screen == NULL) {
        return 2;
    }
    p.count = observe_pictures(p.observers, MAX_OBSERVERS, p.at.film, p.at.folder);
    const size_t pages = observe_page(p.observers + p.count, MAX_OBSERVERS - p.count, p.at.page);
    p.count += pages;
    p.facts.replay_page = pages > 0 ? "replay.html" : NULL; /* beside the report */
    bar_begin(&p.bar, screen);
    const bool whole = perform(&p);
    const bool done = completed(&p);
    bar_end(&p.bar);
    summary_put(screen, &p, whole, done);
    (void)fclose(screen);
    observe_pictures_end();
    observe_page_end();
    facts_destroy(&p.facts);
    throw_rig_destroy(&p.surgeon.stitch.site.rig);
    return done && whole ? 0 : 1;
}
