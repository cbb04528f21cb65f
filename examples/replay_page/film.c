/* Frames from what a visual shows. */
#include "replay_page/film.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "report/facts.h"

enum { JAWS = 2 }; /* value of a grasper's vertices there */

/* A row of VBSS_VISUAL_VIEW_PARTS. */
typedef struct part {
    uint32_t kind, source, body, first_vertex, vertex_count, first_triangle, triangle_count, zero;
} part;

typedef struct seen {
    const film_vertex *vertices;
    const uint32_t *triangles; /* x 3 */
    const part *parts;
    const film_decal *decals; /* with the place of the part for the body */
    uint64_t part_count, decal_count;
} seen;

static bool get_views(vbss_visual *visual, seen *s)
{
    vbss_view v[4];
    for (int i = 0; i < 4; i++) {
        if (vbss_visual_get_view(visual, i, &v[i], sizeof v[i]) != VBSS_OK) {
            return false;
        }
    }
    s->vertices = v[VBSS_VISUAL_VIEW_VERTICES].data;
    s->triangles = v[VBSS_VISUAL_VIEW_TRIANGLES].data;
    s->parts = v[VBSS_VISUAL_VIEW_PARTS].data;
    s->decals = v[VBSS_VISUAL_VIEW_SPOTS].data;
    s->part_count = v[VBSS_VISUAL_VIEW_PARTS].count;
    s->decal_count = v[VBSS_VISUAL_VIEW_SPOTS].count;
    return true;
}

/* ---- pieces of a part: a grasper has shaft, neck and two jaws, one behind the other */

typedef struct piece {
    film_form form;
    uint32_t kind, body, number;
    uint32_t first, count, first_triangle, triangle_count;
} piece;

static film_form form_of(uint32_t kind)
{
    return kind == VBSS_VISUAL_KIND_THREAD  ? FILM_TUBE
           : kind == VBSS_VISUAL_KIND_DRAIN ? FILM_SURFACE
                                            : FILM_RIGID;
}

static bool has_jaws(uint32_t kind)
{
    return kind == VBSS_VISUAL_KIND_DRIVER || kind == VBSS_VISUAL_KIND_SHEARS;
}

static bool is_jaw(const film_vertex *v)
{
    return v->value > (float)JAWS - 0.5F;
}

/* Vertices from `first` on that belong together. Of the two jaws, which are alike, each is half of what is left. */
static uint32_t count_piece(const seen *s, const part *from, uint32_t first)
{
    const uint32_t end = from->first_vertex + from->vertex_count;
    uint32_t last = first;
    if (!has_jaws(from->kind)) {
        return end - first;
    }
    if (is_jaw(&s->vertices[first])) {
        bool second = first > from->first_vertex && is_jaw(&s->vertices[first - 1]);
        return second ? end - first : (end - first) / 2;
    }
    while (last < end && fabsf(s->vertices[last].value - s->vertices[first].value) < 0.5F) {
        last++;
    }
    return last - first;
}

static piece next_piece(const seen *s, const part *from, const piece *before)
{
    piece p = {.form = form_of(from->kind), .kind = from->kind, .body = from->body};
    p.first = before != NULL ? before->first + before->count : from->first_vertex;
    p.number = before != NULL ? before->number + 1 : 0;
    p.count = count_piece(s, from, p.first);
    p.first_triangle =
        before != NULL ? before->first_triangle + before->triangle_count : from->first_triangle;
    while (p.first_triangle + p.triangle_count < from->first_triangle + from->triangle_count &&
           s->triangles[3 * (size_t)(p.first_triangle + p.triangle_count)] < p.first + p.count) {
        p.triangle_count++;
    }
    return p;
}

/* ---- models */

static void centre_model(film_model *m)
{
    for (int k = 0; k < 3; k++) {
        double low = HUGE_VAL, high = -HUGE_VAL;
        for (uint32_t i = 0; i < m->vertex_count; i++) {
            low = fmin(low, (double)m->vertices[i].position[k]);
            high = fmax(high, (double)m->vertices[i].position[k]);
        }
        m->middle[k] = 0.5 * (low + high);
        for (uint32_t i = 0; i < m->vertex_count; i++) {
            m->vertices[i].position[k] = (float)((double)m->vertices[i].position[k] - m->middle[k]);
        }
    }
}

static bool keep_mesh(film_model *m, const seen *s, const piece *p)
{
    m->vertices = calloc((size_t)p->count + 1, sizeof *m->vertices);
    m->triangles = calloc((size_t)p->triangle_count + 1, sizeof *m->triangles);
    if (p->count > UINT16_MAX || m->vertices == NULL || m->triangles == NULL) {
        return false;
    }
    m->vertex_count = p->count;
    m->triangle_count = p->triangle_count;
    memcpy(m->vertices, s->vertices + p->first, p->count * sizeof *m->vertices);
    for (uint32_t i = 0; i < p->triangle_count; i++) {
        for (int k = 0; k < 3; k++) {
            m->triangles[i][k] =
                s->triangles[3 * (size_t)(p->first_triangle + i) + (size_t)k] - p->first;
        }
    }
    centre_model(m);
    film_find_corners(m);
    return true;
}

/* Away from the middle line, in a section. */
static double section_radius(const film_vertex *v)
{
    return hypot((double)v->material[1], (double)v->material[2]);
}

static film_model *model_of(film *f, const seen *s, const piece *p)
{
    for (uint32_t i = 0; i < f->model_count; i++) {
        film_model *m = &f->models[i];
        if (m->kind == p->kind && m->body == p->body && m->piece == p->number &&
            (m->form == FILM_TUBE || m->vertex_count == p->count)) {
            return m;
        }
    }
    if (f->model_count == FILM_MODELS) {
        return NULL;
    }
    film_model *m = &f->models[f->model_count++];
    *m = (film_model){.form = p->form, .kind = p->kind, .body = p->body, .piece = p->number};
    for (uint32_t i = 0; p->form == FILM_TUBE && i < p->count; i++) {
        m->radius = fmax(m->radius, section_radius(&s->vertices[p->first + i]));
    }
    return p->form == FILM_TUBE || keep_mesh(m, s, p) ? m : NULL;
}

/* ---- numbers */

static bool keep_number(film *f, double value, double unit)
{
    if (!facts_room((void **)&f->now, &f->now_room, f->now_count, sizeof *f->now)) {
        return false;
    }
    double number = floor(value / unit + 0.5);
    f->beyond = f->beyond || fabs(number) > 32767.0;
    f->now[f->now_count++] = (int32_t)fmin(fmax(number, -32767.0), 32767.0);
    return true;
}

static bool keep_place(film *f, const double place[3])
{
    return keep_number(f, place[0], FILM_PLACE) && keep_number(f, place[1], FILM_PLACE) &&
           keep_number(f, place[2], FILM_PLACE);
}

static bool keep_pose(film *f, const film_model *m, const film_vertex *vertices)
{
    double place[3], turn[4], cosine = 0.0;
    film_pose(m, vertices, place, turn);
    if (!keep_place(f, place)) {
        return false;
    }
    /* The sign of the frame before, if that has the same number here, so that differences are small. */
    for (size_t i = 0; i < 4 && f->now_count + i < f->before_count; i++) {
        cosine += turn[i] * (double)f->before[f->now_count + i];
    }
    for (int i = 0; i < 4; i++) {
        if (!keep_number(f, cosine < 0.0 ? -turn[i] : turn[i], FILM_TURN)) {
            return false;
        }
    }
    return true;
}

/* A normal of a tube points away from its line. Domes are none of it: their rings are smaller. */
static bool keep_line(film *f, const film_model *m, const film_vertex *vertices, const piece *p,
                      uint32_t *count)
{
    float along = HUGE_VALF;
    for (uint32_t i = 0; i < p->count; i++) {
        const film_vertex *v = &vertices[i];
        if (section_radius(v) < 0.999 * m->radius ||
            !(v->material[0] < along || v->material[0] > along)) {
            continue;
        }
        along = v->material[0];
        double place[3];
        for (int k = 0; k < 3; k++) {
            place[k] = (double)v->position[k] - m->radius * (double)v->normal[k];
        }
        ++*count;
        if (!keep_place(f, place)) {
            return false;
        }
    }
    return true;
}

static bool keep_surface(film *f, const film_vertex *vertices, uint32_t count)
{
    for (uint32_t i = 0; i < count; i++) {
        const float *p = vertices[i].position;
        const double place[3] = {(double)p[0], (double)p[1], (double)p[2]};
        if (!keep_place(f, place)) {
            return false;
        }
    }
    return true;
}

static bool keep_piece(film *f, const seen *s, const piece *p, film_layout *layout)
{
    const film_model *m = model_of(f, s, p);
    const film_vertex *vertices = s->vertices + p->first;
    if (m == NULL || layout->count == FILM_ITEMS) {
        return false;
    }
    film_item *item = &layout->items[layout->count++];
    *item = (film_item){(uint32_t)(m - f->models), p->form == FILM_SURFACE ? p->count : 0};
    switch (p->form) {
    case FILM_RIGID:
        return keep_pose(f, m, vertices);
    case FILM_TUBE:
        return keep_line(f, m, vertices, p, &item->count);
    default:
        return keep_surface(f, vertices, p->count);
    }
}

static bool keep_layout(film *f, const film_layout *layout)
{
    for (size_t i = f->layout_count; i-- > 0;) {
        const film_layout *l = &f->layouts[i];
        if (l->count == layout->count &&
            memcmp(l->items, layout->items, l->count * sizeof *l->items) == 0) {
            f->layout = (uint32_t)i;
            return true;
        }
    }
    if (!facts_room((void **)&f->layouts, &f->layout_room, f->layout_count, sizeof *f->layouts)) {
        return false;
    }
    f->layout = (uint32_t)f->layout_count;
    f->layouts[f->layout_count++] = *layout;
    return true;
}

/* ---- spots */

static bool keep_decals(film *f, const seen *s)
{
    const film_decals *last = f->decal_count > 0 ? &f->decals[f->decal_count - 1] : NULL;
    const size_t bytes = (size_t)s->decal_count * sizeof *s->decals;
    film_decal *rows = malloc(bytes + 1);
    if (rows == NULL) {
        return false;
    }
    for (uint64_t i = 0; i < s->decal_count; i++) {
        rows[i] = s->decals[i];
        rows[i].body = (float)s->parts[(size_t)s->decals[i].body].body;
    }
    if (last != NULL && last->count == s->decal_count && memcmp(last->rows, rows, bytes) == 0) {
        free(rows);
        return true;
    }
    if (!facts_room((void **)&f->decals, &f->decal_room, f->decal_count, sizeof *f->decals)) {
        free(rows);
        return false;
    }
    f->decals[f->decal_count++] = (film_decals){f->frames, (uint32_t)s->decal_count, rows};
    return true;
}

/* ---- a frame */

bool film_add(film *f, vbss_visual *visual)
{
    film_layout layout = {.count = 0};
    seen s;
    f->now_count = 0;
    if (!get_views(visual, &s)) {
        return false;
    }
    for (uint64_t i = 0; i < s.part_count; i++) {
        const part *from = &s.parts[i];
        piece p = next_piece(&s, from, NULL);
        for (; p.count > 0; p = next_piece(&s, from, &p)) {
            if (!keep_piece(f, &s, &p, &layout)) {
                return false;
            }
            if (p.first + p.count == from->first_vertex + from->vertex_count) {
                break;
            }
        }
    }
    if (!keep_layout(f, &layout) || !keep_decals(f, &s) || !film_code(f)) {
        return false;
    }
    f->frames++;
    return true;
}

void film_free(film *f)
{
    for (uint32_t i = 0; i < f->model_count; i++) {
        free(f->models[i].vertices);
        free(f->models[i].triangles);
    }
    for (size_t i = 0; i < f->decal_count; i++) {
        free(f->decals[i].rows);
    }
    free(f->decals);
    free(f->layouts);
    free(f->bytes);
    free(f->now);
    free(f->before);
}
