/* Writes what a session log says as one page that needs nothing else:
 *
 *     vbss-report LOG [-o FILE.html] [--pictures FOLDER] [--replay-page ADDRESS] [--log-only]
 *
 * Without -o the page is written beside the log. The log is played back for what it does not hold, if its note says which
 * scene it is of; --log-only does without. The debrief links to moments of the replay page at ADDRESS, such as
 * replay.html beside the report. Exits 0 for a log that is whole, 1 for one that is cut off or damaged (the page
 * is of its good part) or plays back to other bits, 2 where there is no page. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "decimal_point.h"
#include "report/page.h"

enum { MAX_PATH = 1024 };

typedef struct options {
    const char *log, *to, *pictures, *replay_page;
    bool log_only;
} options;

static bool read_options(int count, char **words, options *o)
{
    for (int i = 1; i < count; i++) {
        if (strcmp(words[i], "-o") == 0 && i + 1 < count) {
            o->to = words[++i];
        } else if (strcmp(words[i], "--pictures") == 0 && i + 1 < count) {
            o->pictures = words[++i];
        } else if (strcmp(words[i], "--replay-page") == 0 && i + 1 < count) {
            o->replay_page = words[++i];
        } else if (strcmp(words[i], "--log-only") == 0) {
            o->log_only = true;
        } else if (words[i][0] != '-' && o->log == NULL) {
            o->log = words[i];
        } else {
            return false;
        }
    }
    return o->log != NULL;
}

static bool read_whole(const char *path, facts *f)
{
    FILE *file = fopen(path, "rb");
    if (file == NULL) {
        return false;
    }
    long size = fseek(file, 0, SEEK_END) == 0 ? ftell(file) : -1;
    f->bytes = size >= 0 && fseek(file, 0, SEEK_SET) == 0 ? malloc((size_t)size + 1) : NULL;
    f->count = f->bytes != NULL ? fread(f->bytes, 1, (size_t)size, file) : 0;
    return fclose(file) == 0 && f->bytes != NULL && f->count == (size_t)size;
}

static vbss_result find_out(facts *f)
{
    TRY(facts_read(f));
    TRY(facts_again(f));
    TRY(facts_phases(f));
    return facts_measure(f);
}

/* 0, 1, 2 as above; says why. */
static int report(facts *f, const pictures *shown, const char *to)
{
    vbss_result result = find_out(f);
    if (result != VBSS_OK) {
        const char *text = "";
        if (f->context != NULL) {
            (void)vbss_context_get_last_error(f->context, NULL, &text);
        }
        fprintf(stderr, "%s: %s%s%s\n", f->path, vbss_result_name(result),
                text[0] != '\0' ? ": " : "", text);
        return 2;
    }
    if (!page_report(f, shown, to)) {
        fprintf(stderr, "%s cannot be written\n", to);
        return 2;
    }
    bool differs = f->again.report.outcome == VBSS_REPLAY_OUTCOME_DIFFERS;
    if (f->check.result != VBSS_OK || differs) {
        fprintf(stderr, "%s: %s\n", f->path,
                differs ? "plays back to other bits" : vbss_result_name(f->check.result));
    }
    printf("%s\n", to);
    return f->check.result == VBSS_OK && !differs ? 0 : 1;
}

static int run(const options *o)
{
    static facts f;
    static pictures shown;
    char beside[MAX_PATH];
    int length = snprintf(beside, sizeof beside, "%s.html", o->log);
    f.path = o->log;
    f.again.asked = !o->log_only;
    f.replay_page = o->replay_page;
    if (length < 0 || length >= MAX_PATH || !read_whole(o->log, &f)) {
        fprintf(stderr, "%s cannot be read\n", o->log);
        free(f.bytes);
        return 2;
    }
    if (o->pictures != NULL && !pictures_read(&shown, o->pictures)) {
        fprintf(stderr, "%s cannot be read\n", o->pictures);
        free(f.bytes);
        return 2;
    }
    int code = report(&f, &shown, o->to != NULL ? o->to : beside);
    pictures_free(&shown);
    facts_destroy(&f);
    return code;
}

int main(int count, char **words)
{
    use_decimal_point();
    options o = {.log = NULL};
    if (!read_options(count, words, &o)) {
        fprintf(stderr,
                "vbss-report LOG [-o FILE.html] [--pictures FOLDER] [--replay-page ADDRESS] "
                "[--log-only: not played back]\n");
        return 2;
    }
    return run(&o);
}
