/* How a film is written. A frame is the number of its layout, then of all numbers the differences to those of the frame before,
 * or, if that had another layout, to those of the place before. Differences are 0, 2, 4 ... for 0, 1, 2 ... and 1, 3 ... for
 * -1, -2 ..., seven bits a byte, the low ones first, the highest bit says that more follow; behind a 0 stands how many
 * further ones follow. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "replay_page/film.h"
#include "report/facts.h"

static bool put_whole_number(film *f, uint32_t number)
{
    for (;;) {
        if (!facts_room((void **)&f->bytes, &f->byte_room, f->byte_count, 1)) {
            return false;
        }
        f->bytes[f->byte_count++] = (uint8_t)(number < 128 ? number : (number & 127) | 128);
        if (number < 128) {
            return true;
        }
        number >>= 7;
    }
}

static uint32_t folded(int32_t difference)
{
    return difference < 0 ? 2 * (uint32_t) - (difference + 1) + 1 : 2 * (uint32_t)difference;
}

/* What a number is compared with; `row` is how many make a place. */
static int32_t guess(const film *f, size_t i, size_t begin, size_t row)
{
    if (f->frames > 0 && f->layout == f->layout_before) {
        return f->before[i];
    }
    return i >= begin + row ? f->now[i - row] : 0;
}

static bool put_numbers(film *f)
{
    const film_layout *l = &f->layouts[f->layout];
    uint32_t zeros = 0;
    size_t at = 0;
    for (uint32_t k = 0; k < l->count; k++) {
        const bool rigid = f->models[l->items[k].model].form == FILM_RIGID;
        const size_t begin = at, row = rigid ? 7 : 3;
        for (const size_t end = at + row * (rigid ? 1 : l->items[k].count); at < end; at++) {
            uint32_t number = folded(f->now[at] - guess(f, at, begin, row));
            if (number == 0) {
                zeros++;
                continue;
            }
            if (zeros > 0 && !(put_whole_number(f, 0) && put_whole_number(f, zeros - 1))) {
                return false;
            }
            zeros = 0;
            if (!put_whole_number(f, number)) {
                return false;
            }
        }
    }
    return zeros == 0 || (put_whole_number(f, 0) && put_whole_number(f, zeros - 1));
}

bool film_code(film *f)
{
    if (!put_whole_number(f, f->layout) || !put_numbers(f)) {
        return false;
    }
    int32_t *numbers = f->now;
    size_t room = f->now_room;
    f->now = f->before;
    f->now_room = f->before_room;
    f->before = numbers;
    f->before_room = room;
    f->before_count = f->now_count;
    f->layout_before = f->layout;
    return true;
}

/* ---- as text */

static void store16(uint8_t *to, double value)
{
    int32_t number = (int32_t)floor(value + 0.5);
    to[0] = (uint8_t)((uint32_t)number & 255);
    to[1] = (uint8_t)((uint32_t)number >> 8 & 255);
}

typedef enum film_column { POSITIONS, NORMALS, MATERIAL, FACE } film_column;

static double number_of(const film_vertex *v, film_column column, int k)
{
    const float *numbers = column == POSITIONS  ? v->position
                           : column == NORMALS  ? v->normal
                           : column == MATERIAL ? v->material
                                                : &v->value;
    return (double)numbers[k];
}

/* Some of the numbers of each vertex, in 16 bits, and how much one of these is. */
static void put_columns(page *p, const film_model *m, film_column column)
{
    static const char *const names[] = {"positions", "normals", "material", "face"};
    const int count = column == FACE ? 1 : 3;
    double largest = 1e-30;
    uint8_t *bytes = malloc(2 * (size_t)count * m->vertex_count + 1);
    for (uint32_t i = 0; i < m->vertex_count; i++) {
        for (int k = 0; k < count; k++) {
            largest = fmax(largest, fabs(number_of(&m->vertices[i], column, k)));
        }
    }
    put(p, ",\"%s\":\"", names[column]);
    for (uint32_t i = 0; bytes != NULL && i < m->vertex_count; i++) {
        for (int k = 0; k < count; k++) {
            store16(bytes + 2 * ((size_t)count * i + (size_t)k),
                    32767.0 * number_of(&m->vertices[i], column, k) / largest);
        }
    }
    if (bytes != NULL) {
        put_base64(p, bytes, 2 * (size_t)count * m->vertex_count);
    }
    put(p, "\",\"%sUnit\":%.9g", names[column], largest / 32767.0);
    free(bytes);
}

static void put_triangles(page *p, const film_model *m)
{
    uint8_t *bytes = malloc(6 * (size_t)m->triangle_count + 1);
    for (uint32_t i = 0; bytes != NULL && i < m->triangle_count; i++) {
        for (size_t k = 0; k < 3; k++) {
            store16(bytes + 6 * (size_t)i + 2 * k, (double)m->triangles[i][k]);
        }
    }
    put(p, ",\"triangles\":\"");
    if (bytes != NULL) {
        put_base64(p, bytes, 6 * (size_t)m->triangle_count);
    }
    put(p, "\"");
    free(bytes);
}

static void put_model(page *p, const film_model *m)
{
    static const char *const forms[] = {"rigid", "tube", "surface"};
    put(p, "{\"form\":\"%s\",\"kind\":%u,\"body\":%u,\"piece\":%u", forms[m->form],
        (unsigned)m->kind, (unsigned)m->body, (unsigned)m->piece);
    if (m->form == FILM_TUBE) {
        put(p, ",\"radius\":%.9g}", m->radius);
        return;
    }
    put_triangles(p, m);
    if (m->form == FILM_RIGID) {
        put_columns(p, m, POSITIONS);
        put_columns(p, m, NORMALS);
    } else {
        put_columns(p, m, MATERIAL);
        put_columns(p, m, FACE);
    }
    put(p, "}");
}

static void put_layout(page *p, const film_layout *l)
{
    put(p, "[");
    for (uint32_t i = 0; i < l->count; i++) {
        put(p, "%s[%u,%u]", i > 0 ? "," : "", (unsigned)l->items[i].model,
            (unsigned)l->items[i].count);
    }
    put(p, "]");
}

static void put_decals(page *p, const film_decals *s)
{
    put(p, "{\"frame\":%u,\"rows\":[", (unsigned)s->frame);
    for (uint32_t i = 0; i < s->count; i++) {
        const film_decal *r = &s->rows[i];
        put(p, "%s[%g,%g,%.7g,%.7g,%.7g,%.4g]", i > 0 ? "," : "", (double)r->body, (double)r->kind,
            (double)r->material[0], (double)r->material[1], (double)r->material[2],
            (double)r->radius);
    }
    put(p, "]}");
}

void film_put(page *p, const film *f)
{
    put(p, "{\"frames\":%u,\"place\":%g,\"turn\":%.17g,\"models\":[", (unsigned)f->frames,
        FILM_PLACE, FILM_TURN);
    for (uint32_t i = 0; i < f->model_count; i++) {
        put(p, "%s", i > 0 ? ",\n" : "");
        put_model(p, &f->models[i]);
    }
    put(p, "],\n\"layouts\":[");
    for (size_t i = 0; i < f->layout_count; i++) {
        put(p, "%s", i > 0 ? "," : "");
        put_layout(p, &f->layouts[i]);
    }
    put(p, "],\n\"spots\":[");
    for (size_t i = 0; i < f->decal_count; i++) {
        put(p, "%s", i > 0 ? "," : "");
        put_decals(p, &f->decals[i]);
    }
    put(p, "],\n\"numbers\":\"");
    put_base64(p, f->bytes, f->byte_count);
    put(p, "\"}");
}
