#include "ghost/track.h"

#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const char title[] = "vblast_ss ghost 1\n";
#define TITLE (sizeof title - 1)
#define METRES 1e-5        /* a step of a position */
#define TURNS 32767.0      /* steps of a part of a quaternion */
#define OPENINGS 255.0     /* steps of an opening */
#define MAX_METRES 0.32767 /* from the origin */

enum { NUMBERS = 13, PHASE_BYTES = 8 + 8 * NUMBERS, TOOL_BYTES = 16, ROW_BYTES = 2 * TOOL_BYTES };
enum { MAX_ROWS = 1 << 16, MAX_BYTES = 1 << 22 };

ghost_pose *ghost_track_add(ghost_track *t)
{
    if ((t->count & (t->count - 1)) == 0) { /* full: 0, 1, 2, 4, ... rows */
        const size_t room = t->count > 0 ? 2 * (size_t)t->count : 1;
        ghost_pose(*more)[GHOST_SIDES] =
            t->count < MAX_ROWS ? realloc(t->rows, room * sizeof *t->rows) : NULL;
        if (more == NULL) {
            return NULL;
        }
        t->rows = more;
    }
    memset(t->rows[t->count], 0, sizeof *t->rows);
    return t->rows[t->count++];
}

void ghost_track_free(ghost_track *t)
{
    free(t->rows);
    memset(t, 0, sizeof *t);
}

/* ---- bytes */

static void put(uint8_t **to, uint64_t value, int bytes)
{
    for (int i = 0; i < bytes; i++) {
        *(*to)++ = (uint8_t)(value >> 8 * i);
    }
}

static uint64_t get(const uint8_t **from, int bytes)
{
    uint64_t value = 0;
    for (int i = 0; i < bytes; i++) {
        value |= (uint64_t) * (*from)++ << 8 * i;
    }
    return value;
}

static void put_step(uint8_t **to, double steps)
{
    put(to, (uint16_t)(int16_t)floor(steps + 0.5), 2);
}

static double get_step(const uint8_t **from)
{
    return (int16_t)(uint16_t)get(from, 2);
}

static void put_number(uint8_t **to, double number)
{
    uint64_t bits;
    memcpy(&bits, &number, sizeof bits);
    put(to, bits, 8);
}

static double get_number(const uint8_t **from)
{
    const uint64_t bits = get(from, 8);
    double number;
    memcpy(&number, &bits, sizeof number);
    return number;
}

static void put_tool(uint8_t **to, const ghost_pose *p)
{
    for (int i = 0; i < 3; i++) {
        put_step(to, fmin(fmax(p->position[i], -MAX_METRES), MAX_METRES) / METRES);
    }
    for (int i = 0; i < 4; i++) {
        put_step(to, TURNS * p->orientation[i]);
    }
    put(to, (uint64_t)floor(OPENINGS * p->opening + 0.5), 1);
    put(to, (uint64_t)p->kind, 1);
}

/* False: no tool is like this. */
static bool get_tool(const uint8_t **from, ghost_pose *p)
{
    double square = 0.0;
    for (int i = 0; i < 3; i++) {
        p->position[i] = METRES * get_step(from);
    }
    for (int i = 0; i < 4; i++) {
        p->orientation[i] = get_step(from) / TURNS;
        square += p->orientation[i] * p->orientation[i];
    }
    for (int i = 0; i < 4; i++) {
        p->orientation[i] /= sqrt(fmax(square, 0.5));
    }
    p->opening = (double)get(from, 1) / OPENINGS;
    p->kind = (int32_t)get(from, 1);
    return fabs(square - 1.0) < 0.01 &&
           (p->kind == VBSS_GRASPER_KIND_NEEDLE_DRIVER || p->kind == VBSS_GRASPER_KIND_SHEARS);
}

static void put_phase(uint8_t **to, const ghost_phase *p)
{
    put(to, p->first, 4);
    put(to, p->count, 4);
    for (int i = 0; i < 6; i++) {
        put_number(to, p->scene.marks[i / 3][i % 3]);
    }
    for (int i = 0; i < 7; i++) {
        put_number(to, p->scene.needle[i]);
    }
}

static bool get_phase(const uint8_t **from, ghost_phase *p, uint32_t rows)
{
    bool good = true;
    p->first = (uint32_t)get(from, 4);
    p->count = (uint32_t)get(from, 4);
    for (int i = 0; i < 6; i++) {
        p->scene.marks[i / 3][i % 3] = get_number(from);
        good = good && isfinite(p->scene.marks[i / 3][i % 3]);
    }
    for (int i = 0; i < 7; i++) {
        p->scene.needle[i] = get_number(from);
        good = good && isfinite(p->scene.needle[i]);
    }
    return good && p->first <= rows && p->count <= rows - p->first;
}

static bool parse(ghost_track *t, const uint8_t *bytes, size_t count)
{
    const size_t before = TITLE + (size_t)GHOST_PHASES * PHASE_BYTES;
    if (count < before || memcmp(bytes, title, TITLE) != 0 || (count - before) % ROW_BYTES != 0) {
        return false;
    }
    const uint8_t *at = bytes + TITLE;
    const size_t rows = (count - before) / ROW_BYTES;
    bool good = rows <= MAX_ROWS;
    for (int i = 0; i < GHOST_PHASES; i++) {
        good = get_phase(&at, &t->phases[i], (uint32_t)rows) && good;
    }
    for (size_t i = 0; i < rows && good; i++) {
        ghost_pose *row = ghost_track_add(t);
        good = row != NULL && get_tool(&at, &row[0]) && get_tool(&at, &row[1]);
    }
    return good;
}

bool ghost_track_parse(ghost_track *t, const uint8_t *bytes, size_t count)
{
    memset(t, 0, sizeof *t);
    const bool good = bytes != NULL && parse(t, bytes, count);
    if (!good) {
        ghost_track_free(t);
    }
    return good;
}

/* ---- files */

bool ghost_track_read(ghost_track *t, const char *path, char *why, size_t why_bytes)
{
    FILE *file = fopen(path, "rb");
    memset(t, 0, sizeof *t);
    if (file == NULL) {
        snprintf(why, why_bytes, "%s: %s", path, strerror(errno));
        return false;
    }
    uint8_t *bytes = malloc(MAX_BYTES);
    const size_t count = bytes != NULL ? fread(bytes, 1, MAX_BYTES, file) : 0;
    (void)fclose(file);
    const bool good = ghost_track_parse(t, bytes, count);
    snprintf(why, why_bytes, "%s: it is damaged, or no file of ghost hands", path);
    free(bytes);
    return good;
}

bool ghost_track_write(const ghost_track *t, const char *path, char *why, size_t why_bytes)
{
    const size_t size = TITLE + (size_t)GHOST_PHASES * PHASE_BYTES + (size_t)t->count * ROW_BYTES;
    uint8_t *bytes = malloc(size), *at = bytes;
    FILE *file = bytes != NULL ? fopen(path, "wb") : NULL;
    if (file == NULL) {
        snprintf(why, why_bytes, "%s: %s", path, strerror(errno));
        free(bytes);
        return false;
    }
    memcpy(at, title, TITLE);
    at += TITLE;
    for (int i = 0; i < GHOST_PHASES; i++) {
        put_phase(&at, &t->phases[i]);
    }
    for (uint32_t i = 0; i < t->count; i++) {
        put_tool(&at, &t->rows[i][0]);
        put_tool(&at, &t->rows[i][1]);
    }
    bool good = fwrite(bytes, 1, size, file) == size;
    good = fclose(file) == 0 && good;
    snprintf(why, why_bytes, "%s: %s", path, strerror(errno));
    free(bytes);
    return good;
}
