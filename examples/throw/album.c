/* Pictures of the key stages: each from the front and from above, and all of them on one sheet. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "knots/words.h"
#include "throw/scenery.h"

enum {
    WIDTH = 640, /* of a view, pixels */
    HEIGHT = 520,
    VIEWS = 2,
    ROWS = 4, /* throws that are painted */
    SEAM = 4,
    LEFT = 14,
    TOP = 24,
    LINE = 20,
    HEADS = 2 /* lines of text above a stage */
};
#define SWATCH 4.5
#define STAGE_WIDTH 0.03 /* least, of what is seen, m */
#define NEAR_WIDTH 8e-3
#define NEAR_BORDER 0.8e-3
#define NEAR_REACH 12e-3 /* how far from the knot the thread is painted */

/* In the order of the columns. */
typedef enum stage { TAKEN, WRAPPED, CAUGHT, DRAWN, SEATED, NEAR, CUT, STAGES } stage;
static const char *const files[STAGES] = {"1-taken",  "2-wrapped", "3-caught", "4-drawn",
                                          "5-seated", "6-near",    "7-cut"};
enum {
    PAIR_WIDTH = VIEWS * WIDTH,
    COLUMNS = CUT, /* what is cut begins a row */
    SHEET_WIDTH = COLUMNS * (WIDTH + SEAM),
    ROW_HEIGHT = VIEWS * (HEIGHT + SEAM)
};

struct album {
    painter *painter;
    const char *folder, *name;
    uint8_t *sheet;
    uint32_t rows;
    bool good;
};

album *album_create(const char *folder, const char *name)
{
    album *a = calloc(1, sizeof *a);
    size_t size = (size_t)3 * SHEET_WIDTH * ROW_HEIGHT * ROWS;
    if (a == NULL) {
        return NULL;
    }
    a->folder = folder;
    a->name = name;
    a->sheet = malloc(size);
    a->good = a->sheet != NULL && painter_create(WIDTH, HEIGHT, &a->painter) == PAINTER_OK;
    if (a->sheet != NULL) {
        memset(a->sheet, 0xff, size);
    }
    return a;
}

/* ---- a picture of two views */

static bool put_text(painter *p, int line, int left, const char *text)
{
    return painter_add_text(p, left, TOP + LINE * line, text, PAINTER_BLACK) == PAINTER_OK;
}

/* Copies a view's pixels to a place of a larger picture. */
static void put(const uint8_t *view, uint8_t *picture, size_t width, size_t x, size_t y)
{
    for (size_t row = 0; row < HEIGHT; row++) {
        memcpy(picture + 3 * ((y + row) * width + x), view + 3 * row * WIDTH, 3 * (size_t)WIDTH);
    }
}

/* Paints what was added, as it is seen now. */
static bool take(album *a, uint8_t *pair, uint32_t row, stage at, int view)
{
    static uint8_t pixels[3 * WIDTH * HEIGHT];
    if (painter_paint(a->painter, pixels, sizeof pixels) != PAINTER_OK) {
        return false;
    }
    a->rows = row + 1 > a->rows ? row + 1 : a->rows;
    put(pixels, pair, PAIR_WIDTH, (size_t)view * WIDTH, 0);
    put(pixels, a->sheet, SHEET_WIDTH, (size_t)(at % COLUMNS) * (WIDTH + SEAM),
        (size_t)row * ROW_HEIGHT + (size_t)view * (HEIGHT + SEAM));
    return true;
}

static bool save(const album *a, const uint8_t *pair, uint32_t row, stage at)
{
    char path[DEMO_PATH];
    snprintf(path, sizeof path, "%s/%s-%u-%s.png", a->folder, a->name, (unsigned)row + 1,
             files[at]);
    return painter_save_png(path, pair, PAIR_WIDTH, HEIGHT) == PAINTER_OK;
}

/* ---- a stage */

static void include_tool(scenery_box *b, const hand *h, const hand_pose *p)
{
    double mirror = h->side;
    scenery_include(b, v3(mirror * p->tip.x, p->tip.y, p->tip.z), 1e-3);
    scenery_include(b, v3(mirror * p->bend.x, p->bend.y, p->bend.z), 3e-3);
}

/* The drain's top, the tail, the limb up to C, and the tools that have to do with them. */
static scenery_box what_counts(const senses *s)
{
    scenery_box b = scenery_nothing();
    const vec *x = throw_rig_nodes(s->rig);
    bool held = senses_holds(s, s->c);
    uint32_t last = held ? s->c->node : s->rig->marks[1];
    scenery_include(&b, v3(0.0, 0.0, -DRAIN_RADIUS), DRAIN_RADIUS);
    for (uint32_t i = 0; i <= last; i++) {
        scenery_include(&b, x[i], 1e-3);
    }
    if (held) {
        include_tool(&b, s->c, &s->tool_c);
    }
    if (s->w->holds || s->last > 0) {
        include_tool(&b, s->w, &s->tool_w);
    }
    return b;
}

static bool paint_stage(album *a, const trial_moment *m, stage at, const char *text)
{
    static uint8_t pair[VIEWS * 3 * WIDTH * HEIGHT];
    const senses *s = m->see;
    painter *p = a->painter;
    scenery_box b = what_counts(s);
    char time[64];
    bool good = true;
    int number = at == CUT ? (int)s->throws : (int)s->throws + 1; /* of the throw that is tied */
    snprintf(time, sizeof time, "%s, throw %d, at %.2f s", a->name, number, s->rig->time);
    for (int view = 0; view < VIEWS && good; view++) {
        painter_clear(p);
        good = scenery_add_ground(p) && scenery_add_tools(p, s) && scenery_add_thread(p, s) &&
               scenery_set_view(p, &b, view == 1, WIDTH, HEIGHT, TOP + LINE * HEADS, STAGE_WIDTH) &&
               put_text(p, 0, LEFT, text) &&
               put_text(p, 1, LEFT, view == 1 ? "from above" : time) &&
               painter_add_scale_bar(p, 0.01, "1 cm") == PAINTER_OK &&
               take(a, pair, s->throws, at, view);
    }
    return good && save(a, pair, s->throws, at);
}

/* ---- from near */

static scenery_box round_the_knot(const senses *s, const demo_knot *k)
{
    const vec *x = throw_rig_nodes(s->rig);
    scenery_box b = scenery_nothing();
    for (uint32_t i = 0; i < s->nodes; i++) {
        for (uint32_t j = 0; j < k->state.throw_count && j < DEMO_THROWS; j++) {
            const vbss_knot_throw *t = &k->throws[j];
            bool part = (i >= t->tail_places[0] && i <= t->tail_places[1]) ||
                        (i >= t->long_places[0] && i <= t->long_places[1]);
            if (part && (t->flags & VBSS_KNOT_THROW_LOCATED) != 0) {
                scenery_include(&b, x[i], NEAR_BORDER);
            }
        }
    }
    if (b.low.x > b.high.x) { /* nobody knows where it is */
        scenery_include(&b, v3(0.0, 0.0, 0.0), 0.5 * NEAR_WIDTH);
    }
    return b;
}

/* Two dots in the scene that come to lie beside a line of text. */
static bool add_swatches(painter *p, int line, uint32_t number)
{
    painter_camera c;
    bool good = painter_get_camera(p, &c) == PAINTER_OK;
    vec eye = v_load(c.eye), target = v_load(c.target), up = v_load(c.up);
    vec right = v_unit(v_cross(v_sub(target, eye), up));
    double metres = c.width / WIDTH, y = TOP + LINE * line - SWATCH;
    for (int tail = 0; tail < 2 && good; tail++) {
        vec at = v_along(target, metres * (LEFT + 6 + 16 * tail - 0.5 * WIDTH), right);
        at = v_along(at, metres * (0.5 * HEIGHT - y), v_unit(up));
        good = painter_add_dots(p, &at.x, 1, 0, SWATCH, scenery_throw_colour(number, tail == 1)) ==
               PAINTER_OK;
    }
    return good;
}

static bool add_legend(album *a, const senses *s, const demo_knot *k)
{
    char text[2 * WORD_TAGS], words[WORD_TAGS];
    painter *p = a->painter;
    snprintf(text, sizeof text, "%s: %s, %s, at 2 N, %.2f s", a->name, k->notation,
             words_of_result(k->state.verdict), s->rig->time);
    bool good = put_text(p, 0, LEFT, text);
    for (uint32_t i = 0; i < k->state.throw_count && i < DEMO_THROWS && good; i++) {
        words_of_throw(&k->throws[i], words);
        snprintf(text, sizeof text, "throw %u: %s", (unsigned)i + 1, words);
        good = add_swatches(p, (int)i + 1, i) && put_text(p, (int)i + 1, LEFT + 32, text);
    }
    return good;
}

static bool paint_near(album *a, const trial_moment *m, const demo_knot *k)
{
    static uint8_t pair[VIEWS * 3 * WIDTH * HEIGHT];
    const senses *s = m->see;
    painter *p = a->painter;
    scenery_box b = round_the_knot(s, k), wide = b;
    int top = TOP + LINE * (1 + (int)k->state.throw_count);
    scenery_include(&wide, v_mix(b.low, b.high, 0.5), NEAR_REACH);
    bool good = true;
    for (int view = 0; view < VIEWS && good; view++) {
        painter_clear(p);
        good = scenery_add_half_drain(p, b.high.y) && scenery_add_tools(p, s) &&
               scenery_add_knot(p, s, k, &wide) &&
               scenery_set_view(p, &b, view == 1, WIDTH, HEIGHT, top, NEAR_WIDTH) &&
               (view == 1 ? put_text(p, 0, LEFT, "from above; the drain's near half is cut away")
                          : add_legend(a, s, k)) &&
               painter_add_scale_bar(p, 1e-3, "1 mm") == PAINTER_OK &&
               take(a, pair, s->throws, NEAR, view);
    }
    return good && save(a, pair, s->throws, NEAR);
}

/* ---- when */

static bool paint(album *a, const trial_moment *m, const demo_knot *k)
{
    const vbss_knot_state *next = &m->run->predicted.state;
    char text[96];
    if (strcmp(m->state, "near") == 0) {
        return paint_stage(a, m, TAKEN, "C has the limb");
    }
    if (strcmp(m->state, "tail") == 0) {
        snprintf(text, sizeof text, "wrapped round W's jaws: %.2f turns", m->see->turns);
        return paint_stage(a, m, WRAPPED, text);
    }
    if (strcmp(m->state, "draw") == 0) {
        snprintf(text, sizeof text, "W has the tail; drawn through it ties: %d wrap%s, %s-handed",
                 (int)next->next_wraps, next->next_wraps == 1 ? "" : "s",
                 next->next_handedness > 0 ? "right" : "left");
        return paint_stage(a, m, CAUGHT, text);
    }
    if (strcmp(m->state, "lower") == 0) {
        snprintf(text, sizeof text, "drawn through: %s, %s", k->notation,
                 words_of_result(k->state.verdict));
        return paint_stage(a, m, DRAWN, text);
    }
    if (strcmp(m->state, "done") == 0) {
        snprintf(text, sizeof text, "pulled to 2 N: %s, %s", k->notation,
                 words_of_result(k->state.verdict));
        return paint_stage(a, m, SEATED, text) && paint_near(a, m, k);
    }
    if (strcmp(m->state, "cut both") == 0) {
        snprintf(text, sizeof text, "both ends cut: %s, %s", k->notation,
                 words_of_result(k->state.verdict));
        return paint_stage(a, m, CUT, text);
    }
    return true;
}

void album_show(album *a, const trial_moment *m, const demo_knot *k)
{
    if (a != NULL && a->good && m->see->throws < ROWS) {
        a->good = paint(a, m, k);
    }
}

/* ---- the sheet */

bool album_close(album *a)
{
    char path[DEMO_PATH];
    if (a == NULL) {
        return false;
    }
    if (a->good && a->rows > 0) {
        snprintf(path, sizeof path, "%s/%s.png", a->folder, a->name);
        a->good =
            painter_save_png(path, a->sheet, SHEET_WIDTH, (int)a->rows * ROW_HEIGHT) == PAINTER_OK;
    }
    bool good = a->good;
    if (!good) {
        printf("  a picture could not be made: %s\n",
               a->painter != NULL ? painter_error(a->painter) : "no memory");
    }
    painter_destroy(a->painter);
    free(a->sheet);
    free(a);
    return good;
}
