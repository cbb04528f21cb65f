#include "show.h"

#include <stdio.h>
#include <string.h>
#include <time.h>

#include "barrel.h"

#define USUAL_HEIGHT 720.0F /* pixels, with a point each */
#define SMALLEST 0.5F
#define LARGEST 3.0F
#define MAX_TENSION 1.0F /* N, of the last colour */

static bool is_ok(vbss_result result)
{
    if (result != VBSS_OK) {
        fprintf(stderr, "viewer: %s\n", vbss_result_string(result));
    }
    return result == VBSS_OK;
}

bool show_begin(show *s, int width, int height)
{
    memset(s, 0, sizeof *s);
    s->camera = camera_over((point3){0.0F, 0.0F, -2e-3F});
    return show_renew(s, width, height);
}

bool show_renew(show *s, int width, int height)
{
    return renderer_begin(&s->renderer, width, height) && pen_begin(&s->pen);
}

void show_end(show *s)
{
    pen_end(&s->pen);
    renderer_end(&s->renderer);
}

static vbss_result see(show *s, stage *st)
{
    vbss_visual_config c;
    TRY(vbss_visual_config_init(&c, sizeof c));
    TRY(vbss_visual_create(st->context, &c, &s->visual));
    return vbss_visual_add_scene(s->visual, st->scene, NULL);
}

bool show_stage(show *s, stage *st)
{
    s->stage = st;
    s->judged = false;
    s->scored = false;
    return is_ok(see(s, st));
}

double show_clock(void)
{
    struct timespec t;
    (void)clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

void show_time(show *s, float microseconds)
{
    s->times[s->times_next] = microseconds;
    s->times_next = (s->times_next + 1) % SHOW_TIMES_KEPT;
}

bool show_place(const show *s, const double at[3], float place[2])
{
    const lens *l = &s->renderer.lens;
    const float aspect = (float)l->width / (float)l->height;
    const camera_view view = camera_get_view(&s->camera, aspect);
    if (!barrel_place(&view.seen, aspect, at, place)) {
        return false;
    }
    place[0] = 0.5F * (1.0F + place[0]) * s->wide;
    place[1] = 0.5F * (1.0F - place[1]) * s->tall;
    return true;
}

/* Words are as large a part of a small picture, as long as they can be read. */
static void measure(show *s)
{
    const lens *l = &s->renderer.lens;
    s->pen.scale = fminf(fmaxf((float)l->height / USUAL_HEIGHT, SMALLEST), LARGEST);
    s->wide = (float)l->width / s->pen.scale;
    s->tall = (float)l->height / s->pen.scale;
}

bool show_draw(show *s, double time)
{
    measure(s);
    s->renderer.max_tension = (s->overlays & SHOW_TENSION) != 0 ? MAX_TENSION : 0.0F;
    if (!is_ok(vbss_visual_update(s->visual)) ||
        !renderer_draw(&s->renderer, s->visual, &s->camera)) {
        return false;
    }
    overlay_draw(s, time);
    return true;
}

bool show_finish(show *s)
{
    pen_draw(&s->pen, s->renderer.lens.width, s->renderer.lens.height);
    return renderer_good();
}
