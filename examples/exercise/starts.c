/* The file: a line of text, then for each place the sizes of two states, 8 bytes each, the lower byte first, and the states. */
#include "exercise/starts.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const char title[] = "vblast_ss exercise starts 1\n";
#define TITLE (sizeof title - 1)
#define LARGEST ((size_t)1 << 28) /* bytes of a file */

static uint64_t get_size(const uint8_t *bytes)
{
    uint64_t size = 0;
    for (int i = 0; i < 8; i++) {
        size |= (uint64_t)bytes[i] << 8 * i;
    }
    return size;
}

static bool take(uint8_t *bytes, size_t count, size_t *at, uint64_t size, uint8_t **state)
{
    if (size > count - *at) {
        return false;
    }
    *state = size > 0 ? bytes + *at : NULL;
    *at += (size_t)size;
    return true;
}

static bool parse(start_states *s, uint8_t *bytes, size_t count)
{
    size_t at = TITLE;
    if (count < TITLE || memcmp(bytes, title, TITLE) != 0) {
        return false;
    }
    for (int i = START_NEW + 1; i < START_PLACES; i++) {
        start_state *state = &s->at[i];
        if (count - at < 16) {
            return false;
        }
        state->scene_bytes = get_size(bytes + at);
        state->session_bytes = get_size(bytes + at + 8);
        at += 16;
        if (!take(bytes, count, &at, state->scene_bytes, &state->scene) ||
            !take(bytes, count, &at, state->session_bytes, &state->session)) {
            return false;
        }
    }
    return at == count;
}

bool starts_parse(start_states *s, uint8_t *bytes, size_t count)
{
    memset(s, 0, sizeof *s);
    if (bytes == NULL || !parse(s, bytes, count)) {
        free(bytes);
        memset(s, 0, sizeof *s);
        return false;
    }
    s->memory = bytes;
    return true;
}

bool starts_read(start_states *s, const char *path, char *why, size_t why_bytes)
{
    FILE *file = fopen(path, "rb");
    uint8_t *bytes = NULL;
    size_t count = 0, room = 0, got = 1;
    memset(s, 0, sizeof *s);
    if (file == NULL) {
        snprintf(why, why_bytes, "%s: %s", path, strerror(errno));
        return false;
    }
    while (got > 0 && count < LARGEST) {
        if (count == room) {
            room = room > 0 ? 2 * room : 1 << 16;
            uint8_t *more = realloc(bytes, room);
            if (more == NULL) {
                break;
            }
            bytes = more;
        }
        got = fread(bytes + count, 1, room - count, file);
        count += got;
    }
    (void)fclose(file);
    snprintf(why, why_bytes, "%s: it is damaged, or no file of exercises", path);
    return starts_parse(s, bytes, count);
}

static bool write_state(FILE *file, const start_state *state)
{
    uint8_t sizes[16];
    for (int i = 0; i < 8; i++) {
        sizes[i] = (uint8_t)(state->scene_bytes >> 8 * i);
        sizes[8 + i] = (uint8_t)(state->session_bytes >> 8 * i);
    }
    return fwrite(sizes, 1, sizeof sizes, file) == sizeof sizes &&
           fwrite(state->scene, 1, (size_t)state->scene_bytes, file) == state->scene_bytes &&
           fwrite(state->session, 1, (size_t)state->session_bytes, file) == state->session_bytes;
}

bool starts_write(const start_states *s, const char *path, char *why, size_t why_bytes)
{
    char beside[1024];
    if ((size_t)snprintf(beside, sizeof beside, "%s.new", path) >= sizeof beside) {
        snprintf(why, why_bytes, "%s: the name is too long", path);
        return false;
    }
    FILE *file = fopen(beside, "wb");
    bool good = file != NULL && fwrite(title, 1, TITLE, file) == TITLE;
    for (int i = START_NEW + 1; i < START_PLACES && good; i++) {
        good = write_state(file, &s->at[i]);
    }
    good = (file == NULL || fclose(file) == 0) && good;
    good = good && rename(beside, path) == 0;
    if (!good) {
        snprintf(why, why_bytes, "%s: %s", path, strerror(errno));
        (void)remove(beside);
    }
    return good;
}

/* States that were read are in one piece of memory, states that were made in one each. */
void starts_free(start_states *s)
{
    for (int i = 0; i < START_PLACES && s->memory == NULL; i++) {
        free(s->at[i].scene);
        free(s->at[i].session);
    }
    free(s->memory);
    memset(s, 0, sizeof *s);
}
