/* Looks at a session through a laparoscope, without a window:
 *
 *     viewer --replay LOG --png FOLDER [--seed N] [--every SECONDS] [--from SECONDS] [--to SECONDS] [--size WIDTHxHEIGHT]
 *
 * LOG is what pass_needle -l has written, with that seed. The scene is made as it was then and simulated again, so the pictures
 * are of the physics, not of a film; frames are numbered from 0 on, and the first is that at --from. Exits 0 if all
 * pictures were written and the replay agreed with the log; without OpenGL 77, which is a skipped test. */
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "headless.h"
#include "needle/stitch.h"
#include "renderer.h"
#include "still.h"
#include "throw/replay.h"

enum { NO_OPENGL = 77, PATH_SIZE = 1024 };

typedef struct options {
    const char *log, *folder;
    uint64_t seed;
    double every, from, to; /* s */
    int width, height;
} options;

typedef struct show {
    options o;
    renderer renderer;
    camera camera;
    vbss_visual *visual;
    uint8_t *pixels;
    uint32_t frames;
} show;

/* ---- options */

static bool read_option(const char *name, const char *value, options *o)
{
    if (strcmp(name, "--replay") == 0) {
        o->log = value;
    } else if (strcmp(name, "--png") == 0) {
        o->folder = value;
    } else if (strcmp(name, "--seed") == 0) {
        o->seed = strtoull(value, NULL, 10);
    } else if (strcmp(name, "--every") == 0) {
        o->every = strtod(value, NULL);
    } else if (strcmp(name, "--from") == 0) {
        o->from = strtod(value, NULL);
    } else if (strcmp(name, "--to") == 0) {
        o->to = strtod(value, NULL);
    } else if (strcmp(name, "--size") == 0) {
        char *rest;
        o->width = (int)strtol(value, &rest, 10);
        o->height = *rest == 'x' ? (int)strtol(rest + 1, NULL, 10) : 0;
    } else {
        return false;
    }
    return true;
}

static bool read_options(int count, char **words, options *o)
{
    for (int i = 1; i + 1 < count; i += 2) {
        if (!read_option(words[i], words[i + 1], o)) {
            return false;
        }
    }
    return count % 2 == 1 && o->log != NULL && o->folder != NULL && o->every > 0.0 &&
           o->width >= 16 && o->width <= 4096 && o->height >= 16 && o->height <= 4096;
}

/* ---- pictures */

static bool write_picture(const show *s)
{
    char path[PATH_SIZE];
    int length = snprintf(path, sizeof path, "%s/frame-%04u.png", s->o.folder, (unsigned)s->frames);
    bool good = length > 0 && (size_t)length < sizeof path &&
                still_write(path, s->pixels, s->o.width, s->o.height);
    if (!good) {
        fprintf(stderr, "viewer: cannot write into %s\n", s->o.folder);
    }
    return good;
}

static bool take_picture(show *s)
{
    vbss_result result = vbss_visual_update(s->visual);
    if (result != VBSS_OK) {
        fprintf(stderr, "viewer: %s\n", vbss_result_string(result));
        return false;
    }
    if (!renderer_draw(&s->renderer, s->visual, &s->camera, s->pixels) || !write_picture(s)) {
        return false;
    }
    s->frames++;
    return true;
}

/* ---- the session */

static vbss_result begin_session(show *s, stitch *t, const replay_log *log, vbss_replay **replay)
{
    vbss_visual_config c;
    stitch_plan plan;
    stitch_plan_usual(&plan);
    TRY(stitch_create(t, s->o.seed, &plan));
    TRY(vbss_visual_config_init(&c, sizeof c));
    TRY(vbss_visual_create(t->site.stand.context, &c, &s->visual));
    TRY(vbss_visual_add_scene(s->visual, t->site.stand.scene, NULL));
    TRY(vbss_replay_create(t->site.stand.context, log->data, log->count, replay));
    return vbss_replay_begin(*replay, t->site.stand.scene);
}

/* False: a picture or a step failed, or the session was not as it was recorded. */
static bool play(show *s, stitch *t, vbss_replay *replay)
{
    vbss_replay_report report = {.outcome = VBSS_REPLAY_STEPPED};
    vbss_scene_statistics now;
    double next = s->o.from;
    while (report.outcome == VBSS_REPLAY_STEPPED) {
        if (vbss_scene_get_statistics(t->site.stand.scene, &now, sizeof now) != VBSS_OK) {
            return false;
        }
        if (now.time > s->o.to) {
            return true;
        }
        if (now.time >= next - 1e-9) {
            if (!take_picture(s)) {
                return false;
            }
            next += s->o.every;
        }
        if (vbss_replay_step(replay, &report, sizeof report) != VBSS_OK) {
            break;
        }
    }
    if (report.outcome != VBSS_REPLAY_ENDED) {
        fprintf(stderr, "viewer: step %llu is not as it was recorded, or the log ends there\n",
                (unsigned long long)report.step);
    }
    return report.outcome == VBSS_REPLAY_ENDED;
}

static bool run(show *s, const replay_log *log)
{
    static stitch t;
    vbss_replay *replay;
    vbss_result result = begin_session(s, &t, log, &replay);
    if (result != VBSS_OK) {
        fprintf(stderr, "viewer: the log is none of this scene: %s\n", vbss_result_string(result));
    }
    bool good = result == VBSS_OK && play(s, &t, replay);
    stand_destroy(&t.site.stand);
    return good;
}

int main(int argc, char **argv)
{
    show s = {.o = {.seed = 1, .every = 1.0, .to = 1e9, .width = 960, .height = 720}};
    headless gl;
    if (!read_options(argc, argv, &s.o)) {
        fprintf(stderr, "viewer --replay LOG --png FOLDER [--seed N] [--every SECONDS] "
                        "[--from SECONDS] [--to SECONDS] [--size WIDTHxHEIGHT]\n");
        return 2;
    }
    if (!headless_begin(&gl) || !renderer_begin(&s.renderer, s.o.width, s.o.height)) {
        return NO_OPENGL;
    }
    s.camera = camera_over((point3){0.0F, 0.0F, -2e-3F});
    s.pixels = calloc(3 * (size_t)s.o.width, (size_t)s.o.height);
    replay_log log = replay_read(s.o.log);
    if (log.count == 0) {
        fprintf(stderr, "viewer: %s cannot be read\n", s.o.log);
    }
    bool good = s.pixels != NULL && log.count > 0 && run(&s, &log);
    printf("%u pictures in %s\n", (unsigned)s.frames, s.o.folder);
    free(log.data);
    free(s.pixels);
    renderer_end(&s.renderer);
    headless_end(&gl);
    return good ? 0 : 1;
}
