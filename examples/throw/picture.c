#include "throw/picture.h"

#include "painter/painter.h"

enum { WIDTH = 760, HEIGHT = 620 };

static void add_tool(painter *p, const hand *h, painter_colour colour)
{
    vbss_view view;
    if (vbss_grasper_get_view(h->grasper, VBSS_GRASPER_VIEW_CAPSULES, &view, sizeof view) !=
        VBSS_OK) {
        return;
    }
    for (int i = 0; i < 4; i++) {
        const double *part = (const double *)view.data + (size_t)7 * (size_t)i;
        double begin[3], end[3];
        v_store(begin, seen(h, v_load(part)));
        v_store(end, seen(h, v_load(part + 3)));
        painter_add_capsule(p, begin, end, part[6], i == 0 || i == 3 ? colour : PAINTER_STEEL);
    }
}

bool picture_write(const senses *s, const char *path, const char *text, bool near)
{
    painter *p;
    if (painter_create(WIDTH, HEIGHT, &p) != PAINTER_OK) {
        return false;
    }
    const double a[3] = {0.0, -0.016, -DRAIN_RADIUS}, b[3] = {0.0, 0.016, -DRAIN_RADIUS};
    const uint32_t right = s->rig->marks[0], left = s->rig->marks[1];
    const double radius = near ? THREAD_RADIUS : 3.0 * THREAD_RADIUS; /* so that it is seen */
    painter_add_capsule(p, a, b, DRAIN_RADIUS, PAINTER_TISSUE);
    painter_add_chain(p, &s->x[0].x, right + 1, 0, radius, PAINTER_BLUE, NULL);
    painter_add_chain(p, &s->x[left].x, s->nodes - left, 0, radius, PAINTER_VERMILION, NULL);
    add_tool(p, s->w, PAINTER_GREEN);
    add_tool(p, s->c, PAINTER_YELLOW);
    painter_camera c = {
        .eye = {0.005, -0.25, 0.06}, .target = {0.005, 0.0, 0.02}, .up = {0, 0, 1}, .width = 0.11};
    if (near) {
        c = (painter_camera){.eye = {0.0, -0.25, 0.03}, .up = {0, 0, 1}, .width = 0.03};
    }
    painter_set_camera(p, &c);
    painter_add_text(p, 10, 20, text, PAINTER_BLACK);
    painter_add_scale_bar(p, 0.01, "1 cm");
    bool good = painter_write_two_views(p, path) == PAINTER_OK;
    painter_destroy(p);
    return good;
}
