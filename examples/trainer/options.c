#include "trainer/options.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define LONGEST 1e6 /* s */

void options_help(void)
{
    fputs(
        "trainer [devices] [what to do]\n"
        "devices, which combine freely; hands without an arm follow the log, or the mock:\n"
        "  --mock                       scripted hands without hardware\n"
        "  --replay LOG                 hands that do what a session's log says; stand-ins', too\n"
        "  --openhaptics [LEFT[,RIGHT]] haptic arms by their names; without names: two\n"
        "  --nidaq [INPUT:LINE[,...]]   handles: analog input and solenoid line of the left, the "
        "right\n"
        "  --openhaptics-library PATH, --nidaq-library PATH\n"
        "what to do:\n"
        "  --list                       tells what there is: arms, lines, scenes\n"
        "  --calibrate                  guides through it and writes the calibration\n"
        "  --calibration FILE           where that is\n"
        "  --scene NAME                 default: stitch\n"
        "  --exercise NAME              one skill of the task, in place of a scene: take_needle, "
        "pass_mark,\n"
        "                               single_throw, double_throw, square_throw, cut\n"
        "  --starts FILE                where exercises start; made when it is not there (1 to 3 "
        "minutes);\n"
        "                               default: exercise.starts\n"
        "  --progress FILE              a line for each exercise: attempts, passed, unaided, best "
        "time\n"
        "  --seconds N                  default: until Ctrl-C or the end of the log\n"
        "  --simulated                  the clock of stand-ins, mock and log, as fast as it goes\n"
        "  --core-speed measure|off|N   budgets of work: of the core with its measured speed "
        "(default, but\n"
        "                               off with --simulated), fixed, or for N operations per us\n"
        "  --fault NAME@FROM[+TIME]     a fault of stand-ins or mock\n"
        "ends with 0: as it shall be, 1: something failed and is told, 2: a wrong word here,\n"
        "3: hardware, library or file is not there\n",
        stdout);
}

/* ---- words */

static bool refuse(char *why, size_t bytes, const char *word, const char *what)
{
    snprintf(why, bytes, "%s: %s", word, what);
    return false;
}

static bool read_seconds(const char *text, char **end, double *value)
{
    *value = strtod(text, end);
    return *end != text && isfinite(*value) && *value >= 0.0 && *value <= LONGEST;
}

/* The piece of a text up to a separator; where it ends. */
static const char *read_piece(const char *text, char separator, char *piece)
{
    size_t length = 0;
    while (text[length] != '\0' && text[length] != separator) {
        length++;
    }
    if (length == 0 || length >= NAME_BYTES) {
        return NULL;
    }
    memcpy(piece, text, length);
    piece[length] = '\0';
    return text + length;
}

static bool read_arms(const char *names, options *o)
{
    o->arm_count = 0;
    for (;;) {
        names = o->arm_count < HANDS ? read_piece(names, ',', o->arms[o->arm_count]) : NULL;
        if (names == NULL) {
            return false;
        }
        o->arm_count++;
        if (*names == '\0') {
            return true;
        }
        names++;
    }
}

static bool read_handles(const char *names, options *o)
{
    char piece[2 * NAME_BYTES];
    o->handle_count = 0;
    for (;;) {
        size_t length = strcspn(names, ",");
        if (o->handle_count == HANDS || length >= sizeof piece) {
            return false;
        }
        memcpy(piece, names, length);
        piece[length] = '\0';
        const char *line = read_piece(piece, ':', o->inputs[o->handle_count]);
        if (line == NULL || *line != ':' ||
            read_piece(line + 1, '\0', o->lines[o->handle_count]) == NULL) {
            return false;
        }
        o->handle_count++;
        if (names[length] == '\0') {
            return true;
        }
        names += length + 1;
    }
}

static bool read_core_speed(const char *text, options *o)
{
    char *end;
    if (strcmp(text, "measure") == 0 || strcmp(text, "off") == 0) {
        o->core_speed = text[0] == 'm' ? -1.0 : 0.0;
        return true;
    }
    o->core_speed = strtod(text, &end);
    return end != text && *end == '\0' && o->core_speed >= 1e-3 && o->core_speed <= 1e6;
}

static bool read_fault(const char *text, options *o)
{
    char *end;
    const char *at = strchr(text, '@');
    if (o->fault_count == MAX_FAULTS || at == NULL || at == text) {
        return false;
    }
    fault_plan *f = &o->faults[o->fault_count];
    size_t length = (size_t)(at - text);
    if (length >= sizeof f->name || !read_seconds(at + 1, &end, &f->from)) {
        return false;
    }
    memcpy(f->name, text, length);
    f->name[length] = '\0';
    f->until = LONGEST;
    if (*end == '+') {
        if (!read_seconds(end + 1, &end, &f->until)) {
            return false;
        }
        f->until += f->from;
    }
    o->fault_count++;
    return *end == '\0';
}

/* ---- options */

static bool read_flag(const char *word, options *o)
{
    const struct {
        const char *word;
        bool *flag;
    } flags[] = {{"--mock", &o->mock},
                 {"--list", &o->list},
                 {"--calibrate", &o->calibrate},
                 {"--simulated", &o->simulated}};
    for (size_t i = 0; i < sizeof flags / sizeof *flags; i++) {
        if (strcmp(word, flags[i].word) == 0) {
            *flags[i].flag = true;
            return true;
        }
    }
    return false;
}

static bool read_text(const char *word, const char *value, options *o)
{
    const struct {
        const char *word;
        const char **text;
    } texts[] = {{"--scene", &o->scene},
                 {"--calibration", &o->calibration},
                 {"--replay", &o->replay},
                 {"--exercise", &o->exercise},
                 {"--starts", &o->starts},
                 {"--progress", &o->progress},
                 {"--openhaptics-library", &o->openhaptics_library},
                 {"--nidaq-library", &o->nidaq_library}};
    for (size_t i = 0; i < sizeof texts / sizeof *texts; i++) {
        if (strcmp(word, texts[i].word) == 0) {
            *texts[i].text = value;
            return true;
        }
    }
    return false;
}

static bool all_fits(const options *o, char *why, size_t bytes)
{
    if (o->calibrate && o->calibration == NULL) {
        return refuse(why, bytes, "--calibrate", "also wants --calibration FILE to write to");
    }
    if (o->calibrate && o->arm_count == 0 && o->handle_count == 0) {
        return refuse(why, bytes, "--calibrate", "neither --openhaptics nor --nidaq is given");
    }
    if (o->exercise == NULL && (o->starts != NULL || o->progress != NULL)) {
        return refuse(why, bytes, o->starts != NULL ? "--starts" : "--progress",
                      "wants --exercise NAME");
    }
    bool others = o->mock || o->replay != NULL || o->calibrate || o->list;
    if (o->arm_count < HANDS && !others) {
        return refuse(why, bytes, o->arm_count == 0 ? "both hands" : "the right hand",
                      "no device: add --mock or --replay LOG, or name an arm");
    }
    return true;
}

static bool has_word(int count, char **words, const char *word)
{
    for (int i = 1; i < count; i++) {
        if (strcmp(words[i], word) == 0) {
            return true;
        }
    }
    return false;
}

bool options_read(int count, char **words, options *o, char *why, size_t bytes)
{
    memset(o, 0, sizeof *o);
    o->scene = "stitch";
    o->seconds = -1.0;
    o->core_speed = has_word(count, words, "--simulated") ? 0.0 : -1.0;
    for (int i = 1; i < count; i++) {
        const char *word = words[i];
        const char *value =
            i + 1 < count && strncmp(words[i + 1], "--", 2) != 0 ? words[i + 1] : NULL;
        char *end;
        bool good = true;
        if (read_flag(word, o)) {
            continue;
        }
        i += value != NULL;
        if (strcmp(word, "--openhaptics") == 0) {
            o->arm_count = HANDS;
            good = value == NULL || read_arms(value, o);
        } else if (strcmp(word, "--nidaq") == 0) {
            good = read_handles(
                value != NULL ? value : "Dev1/ai0:Dev1/port0/line0,Dev1/ai1:Dev1/port0/line1", o);
        } else if (value == NULL) {
            return refuse(why, bytes, word, "no such option, or it wants a value");
        } else if (strcmp(word, "--seconds") == 0) {
            good = read_seconds(value, &end, &o->seconds) && *end == '\0';
        } else if (strcmp(word, "--core-speed") == 0) {
            good = read_core_speed(value, o);
        } else if (strcmp(word, "--fault") == 0) {
            good = read_fault(value, o);
        } else if (!read_text(word, value, o)) {
            return refuse(why, bytes, word, "no such option");
        }
        if (!good) {
            snprintf(why, bytes, "%s: not %s", word, value);
            return false;
        }
    }
    return all_fits(o, why, bytes);
}
