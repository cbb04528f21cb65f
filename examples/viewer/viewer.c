/* Looks at a session through a laparoscope, or plays one:
 *
 *     viewer --live throw|needle|stitch [--log FILE]      in a window, with a mouse and keys; F1 tells which; a gamepad too
 *     viewer --live ... --openhaptics [...] --nidaq [...] with arms and handles, as examples/trainer has them
 *     viewer --live ... --hands LOG [--fault NAME@FROM]   with the hands of a log, as mock devices
 *     viewer --exercise NAME [--starts FILE] [--progress FILE]   one skill: docs/guides/exercises.md; exercise_starts FILE
 *                                                         makes the first file
 *     viewer --live stitch|--exercise NAME --ghost FILE   with an expert's tools beside one's own; ghost_track LOG FILE makes it
 *     viewer --replay LOG                                 in a window, with a time line
 *     viewer --replay LOG --png FOLDER [--every SECONDS]  stills, without a window
 *     viewer --replay LOG --mp4 FILE                      a film, by ffmpeg, without a window
 *
 * further [--from SECONDS] [--to SECONDS] [--size WIDTHxHEIGHT] [--show contacts,forces,tension,knot,task,times,help,coach,all]
 * [--frame-steps N: of each frame, however long they take] [--tell: a line a frame]. LOG is what examples/throw, needle, surgeon or --live have written: its note says which scene it
 * is of. That is made as it was then and simulated again, so the pictures are of the physics; those of stills are numbered from 0
 * on, and the first is that at --from. Exits 0 if all was as it shall be and a replay agreed with its log; without OpenGL or a
 * screen 77, which is a skipped test. */
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "decimal_point.h"
#include "modes.h"
#include "show.h"

/* ---- options */

static bool read_overlays(const char *words, uint32_t *overlays)
{
    static const struct {
        const char *name;
        uint32_t bit;
    } names[] = {{"contacts", SHOW_CONTACTS}, {"forces", SHOW_FORCES}, {"tension", SHOW_TENSION},
                 {"knot", SHOW_KNOT},         {"task", SHOW_TASK},     {"times", SHOW_TIMES},
                 {"help", SHOW_HELP},         {"coach", SHOW_COACH},   {"all", SHOW_ALL}};
    *overlays = 0;
    while (*words != '\0') {
        const size_t length = strcspn(words, ",");
        size_t i = 0, count = sizeof names / sizeof *names;
        while (i < count &&
               (strncmp(words, names[i].name, length) != 0 || names[i].name[length] != '\0')) {
            i++;
        }
        if (i == count) {
            return false;
        }
        *overlays |= names[i].bit;
        words += length + (words[length] == ',' ? 1 : 0);
    }
    return true;
}

static bool read_size(const char *value, options *o)
{
    char *rest;
    o->width = (int)strtol(value, &rest, 10);
    o->height = *rest == 'x' ? (int)strtol(rest + 1, NULL, 10) : 0;
    return o->width >= 16 && o->width <= 4096 && o->height >= 16 && o->height <= 4096;
}

static bool read_option(const char *name, const char *value, options *o)
{
    const struct {
        const char *name;
        const char **to;
    } texts[] = {{"--replay", &o->log},        {"--live", &o->live},
                 {"--log", &o->keep},          {"--hands", &o->hands},
                 {"--png", &o->folder},        {"--mp4", &o->film},
                 {"--exercise", &o->exercise}, {"--starts", &o->starts},
                 {"--progress", &o->progress}, {"--ghost", &o->ghost}};
    const struct {
        const char *name;
        double *to;
    } numbers[] = {{"--every", &o->every}, {"--from", &o->from}, {"--to", &o->to}};
    for (size_t i = 0; i < sizeof texts / sizeof *texts; i++) {
        if (strcmp(name, texts[i].name) == 0) {
            *texts[i].to = value;
            return true;
        }
    }
    for (size_t i = 0; i < sizeof numbers / sizeof *numbers; i++) {
        if (strcmp(name, numbers[i].name) == 0) {
            *numbers[i].to = strtod(value, NULL);
            return *numbers[i].to >= 0.0;
        }
    }
    if (strcmp(name, "--frame-steps") == 0) {
        o->frame_steps = (int)strtol(value, NULL, 10);
        return o->frame_steps > 0 && o->frame_steps <= 1000;
    }
    if (strcmp(name, "--seed") == 0) {
        char *rest;
        o->seed = strtoul(value, &rest, 10);
        return *rest == '\0' && rest != value;
    }
    if (strcmp(name, "--renew") == 0) {
        o->renew = (int)strtol(value, NULL, 10);
        return o->renew > 0;
    }
    return strcmp(name, "--size") == 0
               ? read_size(value, o)
               : strcmp(name, "--show") == 0 && read_overlays(value, &o->overlays);
}

/* Words of the trainer, with what follows them. */
static int take_device_words(int count, char **words, options *o)
{
    static const char *const names[] = {"--openhaptics",   "--nidaq",       "--openhaptics-library",
                                        "--nidaq-library", "--calibration", "--fault"};
    int taken = 0;
    for (size_t i = 0; i < sizeof names / sizeof *names && taken == 0; i++) {
        taken = strcmp(words[0], names[i]) == 0;
    }
    if (taken > 0 && count > 1 && strncmp(words[1], "--", 2) != 0) {
        taken++;
    }
    for (int i = 0; i < taken && o->device_words < MAX_DEVICE_WORDS; i++) {
        o->devices[o->device_words++] = words[i];
    }
    return taken;
}

static bool read_options(int count, char **words, options *o)
{
    for (int i = 1; i < count; i++) {
        const int taken = take_device_words(count - i, words + i, o);
        if (taken > 0) {
            i += taken - 1;
        } else if (strcmp(words[i], "--tell") == 0) {
            o->report = 1;
        } else if (strcmp(words[i], "--lockstep") == 0) {
            o->lockstep = 1;
        } else if (i + 1 == count || !read_option(words[i], words[i + 1], o)) {
            return false;
        } else {
            i++;
        }
    }
    if (o->exercise != NULL && o->live == NULL) {
        o->live = "stitch";
    }
    const bool taken = o->folder != NULL || o->film != NULL;
    const bool played = o->hands != NULL || o->device_words > 0 || o->keep != NULL || o->seed > 0;
    return (o->log != NULL) != (o->live != NULL) && !(played && o->live == NULL) &&
           !(taken && o->log == NULL) && !(o->folder != NULL && o->film != NULL);
}

int main(int argc, char **argv)
{
    use_decimal_point();
    options o = {.to = 1e9, .width = 960, .height = 720};
    if (!read_options(argc, argv, &o)) {
        fprintf(stderr, "viewer --live throw|needle|stitch [--log FILE] [--seed N]\n"
                        "    [--hands LOG] [--openhaptics [LEFT[,RIGHT]]] [--nidaq [...]] "
                        "[--calibration FILE] and more, as the trainer has them\n"
                        "viewer --exercise NAME [--starts FILE] [--progress FILE]\n"
                        "    [--ghost FILE]\n"
                        "viewer --replay LOG [--png FOLDER [--every SECONDS]] [--mp4 FILE]\n"
                        "    [--from SECONDS] [--to SECONDS] [--size WIDTHxHEIGHT] [--show "
                        "contacts,forces,tension,knot,task,times,help,coach,all]\n"
                        "    [--frame-steps N] [--tell]\n");
        return 2;
    }
    if (o.folder != NULL || o.film != NULL) {
        return mode_take(&o);
    }
#ifdef VIEWER_WINDOW
    return o.live != NULL ? mode_live(&o) : mode_replay(&o);
#else
    fprintf(stderr, "viewer: built without GLFW, and so without a window\n");
    return MODE_NO_OPENGL;
#endif
}
