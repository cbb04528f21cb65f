#include "trainer/calibration.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

enum { MAX_NUMBERS = 6, LINE_BYTES = 256, PATH_BYTES = 4096 };

static const char *const hand_names[HANDS] = {"left", "right"};
static const char *const first_line = "# vblast_ss trainer calibration 1\n";

/* The facts, in the order of the file. */
typedef struct fact {
    const char *name;
    int count;
} fact;
enum { AXES, SCALE, OFFSET, MOUNT, LOW, HIGH, JAW, FACTS };
static const fact facts[FACTS] = {
    {"axes", 3},          {"scale", 1},          {"offset", 3},         {"mount", 4},
    {"workspace_low", 3}, {"workspace_high", 3}, {"jaw_closed_open", 2}};

vbss_result calibration_init(calibration *c)
{
    vbss_result result = VBSS_OK;
    memset(c, 0, sizeof *c);
    for (int i = 0; i < HANDS && result == VBSS_OK; i++) {
        vbss_device_calibration *hand = &c->hands[i];
        result = vbss_device_calibration_init(hand, sizeof *hand);
        /* x right, y up, z toward the user become x right, y away, z up */
        hand->axes[1] = -3;
        hand->axes[2] = 2;
    }
    return result;
}

/* ---- numbers to and from */

static void get(const vbss_device_calibration *c, int which, double *x)
{
    switch (which) {
    case AXES:
        for (int i = 0; i < 3; i++) {
            x[i] = c->axes[i];
        }
        break;
    case SCALE:
        x[0] = c->scale;
        break;
    case OFFSET:
        memcpy(x, c->offset, sizeof c->offset);
        break;
    case MOUNT:
        memcpy(x, c->mount, sizeof c->mount);
        break;
    case LOW:
        memcpy(x, c->workspace_low, sizeof c->workspace_low);
        break;
    case HIGH:
        memcpy(x, c->workspace_high, sizeof c->workspace_high);
        break;
    default:
        x[0] = c->jaw_closed;
        x[1] = c->jaw_open;
        break;
    }
}

static bool set_axes(vbss_device_calibration *c, const double *x)
{
    int seen = 0;
    for (int i = 0; i < 3; i++) {
        double size = fabs(x[i]);
        if (size != 1.0 && size != 2.0 && size != 3.0) {
            return false;
        }
        c->axes[i] = (int32_t)x[i];
        seen |= 1 << (int)size;
    }
    return seen == 14; /* each once */
}

static bool set(vbss_device_calibration *c, int which, const double *x)
{
    switch (which) {
    case AXES:
        return set_axes(c, x);
    case SCALE:
        c->scale = x[0];
        return x[0] > 0.0;
    case OFFSET:
        memcpy(c->offset, x, sizeof c->offset);
        return true;
    case MOUNT:
        memcpy(c->mount, x, sizeof c->mount);
        return true;
    case LOW:
        memcpy(c->workspace_low, x, sizeof c->workspace_low);
        return true;
    case HIGH:
        memcpy(c->workspace_high, x, sizeof c->workspace_high);
        return true;
    default:
        c->jaw_closed = x[0];
        c->jaw_open = x[1];
        return x[0] != x[1];
    }
}

/* ---- written */

static void write_hand(FILE *file, const char *name, const vbss_device_calibration *c)
{
    for (int which = 0; which < FACTS; which++) {
        double x[MAX_NUMBERS] = {0.0};
        get(c, which, x);
        fprintf(file, "%s.%s", name, facts[which].name);
        for (int i = 0; i < facts[which].count; i++) {
            fprintf(file, " %.17g", x[i]); /* so that it is read as it was */
        }
        fputc('\n', file);
    }
}

static bool write_file(const calibration *c, const char *path)
{
    FILE *file = fopen(path, "w");
    if (file == NULL) {
        return false;
    }
    fputs(first_line, file);
    for (int i = 0; i < HANDS; i++) {
        if (c->known[i]) {
            write_hand(file, hand_names[i], &c->hands[i]);
        }
    }
    bool good = fflush(file) == 0 && ferror(file) == 0 && fsync(fileno(file)) == 0;
    return fclose(file) == 0 && good;
}

/* A new file takes the place of the old one when it is complete. So the old calibration stays if the program is killed or
 * the disk is full. */
bool calibration_write(const calibration *c, const char *path)
{
    char other[PATH_BYTES];
    int length = snprintf(other, sizeof other, "%s.new", path);
    if (length < 0 || (size_t)length >= sizeof other) {
        return false;
    }
    bool good = write_file(c, other) && rename(other, path) == 0;
    if (!good) {
        (void)remove(other);
    }
    return good;
}

/* ---- read */

static bool read_numbers(const char *text, int count, double *x)
{
    char *end;
    for (int i = 0; i < count; i++) {
        x[i] = strtod(text, &end);
        if (end == text || !isfinite(x[i]) || fabs(x[i]) > 1e3) {
            return false;
        }
        text = end;
    }
    return strcmp(text, "\n") == 0;
}

/* The bit of what the line said, 0: it is wrong. */
static unsigned read_line(const char *line, calibration *c)
{
    for (int i = 0; i < HANDS; i++) {
        size_t length = strlen(hand_names[i]);
        if (strncmp(line, hand_names[i], length) != 0 || line[length] != '.') {
            continue;
        }
        for (int which = 0; which < FACTS; which++) {
            const char *fact_text = line + length + 1;
            size_t word = strlen(facts[which].name);
            double x[MAX_NUMBERS] = {0.0};
            if (strncmp(fact_text, facts[which].name, word) == 0 && fact_text[word] == ' ' &&
                read_numbers(fact_text + word, facts[which].count, x) &&
                set(&c->hands[i], which, x)) {
                return 1u << (i * FACTS + which);
            }
        }
    }
    return 0;
}

static bool read_all(FILE *file, calibration *c, char *why, size_t bytes)
{
    char line[LINE_BYTES];
    unsigned seen = 0;
    for (int number = 1; fgets(line, sizeof line, file) != NULL; number++) {
        if (number == 1 && strcmp(line, first_line) != 0) {
            snprintf(why, bytes, "line 1: not a calibration of the trainer");
            return false;
        }
        if (line[0] == '#' || line[0] == '\n') {
            continue;
        }
        unsigned bit = read_line(line, c);
        if (bit == 0 || (seen & bit) != 0) {
            snprintf(why, bytes, "line %d: %s", number, bit == 0 ? "not understood" : "again");
            return false;
        }
        seen |= bit;
    }
    for (int i = 0; i < HANDS; i++) {
        unsigned all = (1u << FACTS) - 1, of_hand = (seen >> (i * FACTS)) & all;
        if (of_hand != 0 && of_hand != all) {
            snprintf(why, bytes, "facts of the %s hand are missing", hand_names[i]);
            return false;
        }
        c->known[i] = of_hand == all;
    }
    if (seen == 0) {
        snprintf(why, bytes, "it is of no hand");
    }
    return seen != 0;
}

bool calibration_read(calibration *c, const char *path, char *why, size_t bytes)
{
    calibration found = *c;
    FILE *file = fopen(path, "r");
    if (file == NULL) {
        snprintf(why, bytes, "cannot be opened");
        return false;
    }
    bool good = read_all(file, &found, why, bytes);
    (void)fclose(file);
    if (good) {
        *c = found;
    }
    return good;
}
