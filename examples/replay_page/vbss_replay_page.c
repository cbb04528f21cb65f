/* Writes a session log as one page that plays it in any browser, and needs nothing else:
 *
 *     vbss-replay-page LOG [-o FILE.html] [--rate FRAMES_A_SECOND]
 *
 * Without -o the page is written beside the log. The scene is made as it was and simulated again; the page gets 30 frames
 * of a simulated second, or as many as are asked for. Exits 0 for a log that is whole and plays back to the same bits, 1 for
 * another one (the page is of its good part), 2 where there is no page. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "replay_page/assets.h"
#include "replay_page/told.h"
#include "report/stage.h"
#include "throw/replay.h"

enum { MOST_PATH = 1024 };

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

/* ---- frames, while it is played back */

typedef struct camera {
    const facts *facts;
    vbss_visual *visual;
    film film;
    uint64_t *steps; /* of the frames */
    size_t room;
    double rate;
} camera;

/* Segments and sides undivided, as the player rounds them itself; what is rigid is written once, and may be fine. */
static vbss_result set_up(camera *c, const stage *s)
{
    vbss_visual_config config;
    TRY(vbss_visual_config_init(&config, sizeof config));
    config.division_limit = 1;
    TRY(vbss_visual_create(s->context, &config, &c->visual));
    return vbss_visual_add_scene(c->visual, s->scene, NULL);
}

/* Frame n is of the first step at or after n / rate, and the last one of the end. */
static vbss_result watch(void *user, struct stage *s, uint64_t step)
{
    camera *c = user;
    const double time = step > 0 ? c->facts->moments[step - 1].time : 0.0;
    const double next = (double)c->film.frames / c->rate;
    if (step == 0) {
        TRY(set_up(c, s));
    }
    if (time < next - 1e-9 && step != c->facts->steps) {
        return VBSS_OK;
    }
    if (!facts_room((void **)&c->steps, &c->room, c->film.frames, sizeof *c->steps)) {
        return VBSS_ERROR_OUT_OF_MEMORY;
    }
    TRY(vbss_visual_update(c->visual));
    c->steps[c->film.frames] = step;
    return film_add(&c->film, c->visual) ? VBSS_OK : VBSS_ERROR_CAPACITY;
}

/* ---- the page */

static void put_asset(page *p, const unsigned char *asset, size_t size)
{
    put_markup(p, (const char *)asset, size);
}

/* The begin of what stands between "<!--" and "-->" of that name; NULL: there is none. */
static const char *find_place(const char *text, size_t size, const char *name)
{
    const size_t length = strlen(name);
    for (size_t i = 0; i + length <= size; i++) {
        if (memcmp(text + i, name, length) == 0) {
            return text + i;
        }
    }
    return NULL;
}

static bool write_page(const camera *c, const char *to)
{
    static const char *const places[] = {"<!--style-->", "<!--session-->", "<!--player-->"};
    const char *text = (const char *)asset_page;
    size_t left = asset_page_size;
    page *p = page_create();
    for (int i = 0; p != NULL && i < 3; i++) {
        const char *place = find_place(text, left, places[i]);
        if (place == NULL) {
            page_destroy(p);
            return false;
        }
        put_markup(p, text, (size_t)(place - text));
        left -= (size_t)(place - text) + strlen(places[i]);
        text = place + strlen(places[i]);
        if (i == 0) {
            put_asset(p, asset_style, asset_style_size);
        } else if (i == 1) {
            told_put(p, c->facts, &c->film, c->steps);
        } else {
            put_asset(p, asset_player, asset_player_size);
        }
    }
    if (p == NULL) {
        return false;
    }
    put_markup(p, text, left);
    bool written = page_write(p, to);
    page_destroy(p);
    return written;
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
static const char *play(facts *f, camera *c)
{
    vbss_result result = facts_read(f);
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
    static camera c;
    char beside[MOST_PATH];
    int length = snprintf(beside, sizeof beside, "%s.html", o->log);
    const char *to = o->to != NULL ? o->to : beside;
    f.path = o->log;
    f.again.asked = true;
    f.again.watch = watch;
    f.again.user = &c;
    c.facts = &f;
    c.rate = o->rate;
    bool read = length > 0 && length < MOST_PATH && read_log(o->log, &f);
    const char *problem = read ? play(&f, &c) : "cannot be read";
    int code = 2;
    if (problem != NULL) {
        fprintf(stderr, "%s: %s\n", o->log, problem);
    } else if (!write_page(&c, to)) {
        fprintf(stderr, "%s cannot be written\n", to);
    } else {
        bool same = f.check.result == VBSS_OK && f.again.result == VBSS_OK &&
                    f.again.report.outcome == VBSS_REPLAY_ENDED;
        printf("%s: %u frames of %.2f s, %zu bytes of places, %zu of the player%s%s\n", to,
               (unsigned)c.film.frames, facts_end(&f), c.film.byte_count, asset_player_size,
               c.film.beyond ? ", some beyond its range" : "", same ? "" : "; not whole");
        code = same ? 0 : 1;
    }
    film_free(&c.film);
    free(c.steps);
    facts_destroy(&f);
    return code;
}

int main(int count, char **words)
{
    options o = {NULL, NULL, 30.0};
    if (!read_options(count, words, &o)) {
        fprintf(stderr, "vbss-replay-page LOG [-o FILE.html] [--rate FRAMES_A_SECOND]\n");
        return 2;
    }
    return run(&o);
}
