/* Writes a session log as one page that plays it in any browser, and needs nothing else:
 *
 *     vbss-replay-page LOG [-o FILE.html] [--rate FRAMES_A_SECOND]
 *
 * Without -o the page is written beside the log. The scene is made as it was and simulated again; the page gets 30 frames
 * of a simulated second, or as many as are asked for. Exits 0 for a log that is whole and plays back to the same bits, 1 for
 * another one (the page is of its good part), 2 where there is no page. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "decimal_point.h"
#include "replay_page/recorder.h"
#include "throw/replay.h"

enum { MAX_PATH = 1024 };

typedef struct options {
    const char *log, *to;
    double rate;
} options;

static bool read_options(int count, char **words, options *o)
{
    for (int i = 1; i < count; i++) {
        if (strcmp(words[i], "-o") == 0 && i + 1 < count) {
            o->to = words[++i];
        } else if (strcmp(words[i], "--rate") == 0 && i + 1 < count) {
            o->rate = strtod(words[++i], NULL);
        } else if (words[i][0] != '-' && o->log == NULL) {
            o->log = words[i];
        } else {
            return false;
        }
    }
    return o->log != NULL && o->rate >= 0.1 && o->rate <= 1000.0;
}

/* ---- one log */

static bool read_log(const char *path, facts *f)
{
    replay_log log = replay_read(path);
    f->bytes = log.data;
    f->count = log.count;
    return log.data != NULL;
}

/* What keeps it from a page; NULL: nothing. */
static const char *play(facts *f, recorder *c)
{
    vbss_result result = facts_read(f);
    c->last = f->steps;
    result = result == VBSS_OK ? facts_again(f) : result;
    result = result == VBSS_OK ? facts_phases(f) : result;
    return result != VBSS_OK       ? vbss_result_string(result)
           : f->again.name == NULL ? "its note names no scene that can be made here"
           : c->film.frames == 0   ? "its scene is not as it was"
                                   : NULL;
}

static int run(const options *o)
{
    static facts f;
    static recorder c;
    char beside[MAX_PATH];
    int length = snprintf(beside, sizeof beside, "%s.html", o->log);
    const char *to = o->to != NULL ? o->to : beside;
    f.path = o->log;
    f.again.asked = true;
    f.again.watch = recorder_watch;
    f.again.user = &c;
    c.rate = o->rate;
    bool read = length > 0 && length < MAX_PATH && read_log(o->log, &f);
    const char *problem = read ? play(&f, &c) : "cannot be read";
    int code = 2;
    if (problem != NULL) {
        fprintf(stderr, "%s: %s\n", o->log, problem);
    } else if (!recorder_write(&c, &f, to)) {
        fprintf(stderr, "%s cannot be written\n", to);
    } else {
        bool same = f.check.result == VBSS_OK && f.again.result == VBSS_OK &&
                    f.again.report.outcome == VBSS_REPLAY_OUTCOME_ENDED;
        printf("%s: %u frames of %.2f s, %zu bytes of places, %zu of the player%s%s\n", to,
               (unsigned)c.film.frames, facts_end(&f), c.film.byte_count, recorder_player_size(),
               c.film.beyond ? ", some beyond its range" : "", same ? "" : "; not whole");
        code = same ? 0 : 1;
    }
    recorder_free(&c);
    facts_destroy(&f);
    return code;
}

int main(int count, char **words)
{
    use_decimal_point();
    options o = {NULL, NULL, 30.0};
    if (!read_options(count, words, &o)) {
        fprintf(stderr, "vbss-replay-page LOG [-o FILE.html] [--rate FRAMES_A_SECOND]\n");
        return 2;
    }
    return run(&o);
}
