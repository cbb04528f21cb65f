/* Pictures of a needle on its way through a drain. */
#include "needle/pass.h"
#include "needle/show.h"

enum { WIDTH = 760, HEIGHT = 620 };
#define WIDE 0.1
#define CLOSE 0.045

bool show_picture(const stitch *t, const char *path, const char *text)
{
    painter *p;
    bool wide = t->state < STITCH_TARGET;
    painter_camera c = {
        .eye = {0.0, -0.24, 0.07}, .target = {0.0, 0.0, -2e-3}, .up = {0, 0, 1}, .width = CLOSE};
    if (wide) {
        c.eye[0] = c.target[0] = 0.015;
        c.width = WIDE;
    }
    if (painter_create(WIDTH, HEIGHT, &p) != PAINTER_OK) {
        return false;
    }
    bool good =
        show_add(p, t) && painter_set_camera(p, &c) == PAINTER_OK &&
        painter_add_text(p, 10, 20, text, PAINTER_BLACK) == PAINTER_OK &&
        painter_add_scale_bar(p, wide ? 0.01 : 5e-3, wide ? "1 cm" : "5 mm") == PAINTER_OK &&
        painter_write_two_views(p, path) == PAINTER_OK;
    painter_destroy(p);
    return good;
}
