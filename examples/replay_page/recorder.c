#include "replay_page/recorder.h"

#include <stdlib.h>
#include <string.h>

#include "replay_page/assets.h"
#include "replay_page/reported.h"

/* ---- frames */

/* Segments and sides undivided, as the player rounds them itself; what is rigid is written once, and may be fine. */
static vbss_result set_up(recorder *c, const stage *s)
{
    vbss_visual_config config;
    TRY(vbss_visual_config_init(&config, sizeof config));
    config.division_limit = 1;
    TRY(vbss_visual_create(s->context, &config, &c->visual));
    return vbss_visual_add_scene(c->visual, s->scene, NULL);
}

static vbss_result take_frame(recorder *c, uint64_t step)
{
    if (!facts_room((void **)&c->steps, &c->room, c->film.frames, sizeof *c->steps)) {
        return VBSS_ERROR_OUT_OF_MEMORY;
    }
    TRY(vbss_visual_update(c->visual));
    c->steps[c->film.frames] = step;
    return film_add(&c->film, c->visual) ? VBSS_OK : VBSS_ERROR_CAPACITY;
}

vbss_result recorder_watch(void *user, struct stage *s, uint64_t step, double time)
{
    recorder *c = user;
    const double next = (double)c->film.frames / c->rate;
    if (step == 0) {
        TRY(set_up(c, s));
    }
    return time < next - 1e-9 && step != c->last ? VBSS_OK : take_frame(c, step);
}

vbss_result recorder_end(recorder *c, uint64_t step)
{
    const bool there = c->film.frames > 0 && c->steps[c->film.frames - 1] == step;
    return there ? VBSS_OK : take_frame(c, step);
}

void recorder_free(recorder *c)
{
    film_free(&c->film);
    free(c->steps);
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

bool recorder_write(const recorder *c, const facts *f, const char *to)
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
            reported_put(p, f, &c->film, c->steps);
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

size_t recorder_player_size(void)
{
    return asset_player_size;
}
