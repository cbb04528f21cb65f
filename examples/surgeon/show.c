#include "needle/show.h"
#include "surgeon/surgeon.h"

enum { WIDTH = 760, HEIGHT = 620 };

bool surgeon_show(const surgeon *s, const char *path, const char *text, vec middle, double width)
{
    painter *p;
    painter_camera c = {.up = {0, 0, 1}, .width = width};
    if (painter_create(WIDTH, HEIGHT, &p) != PAINTER_OK) {
        return false;
    }
    v_store(c.target, middle);
    v_store(c.eye, v_add(middle, v3(0.0, -0.24, 0.07)));
    bool good = show_add(p, &s->stitch) && painter_set_camera(p, &c) == PAINTER_OK &&
                painter_add_text(p, 10, 20, text, PAINTER_BLACK) == PAINTER_OK &&
                painter_add_scale_bar(p, width > 0.06 ? 0.01 : 5e-3,
                                      width > 0.06 ? "1 cm" : "5 mm") == PAINTER_OK &&
                painter_write_two_views(p, path) == PAINTER_OK;
    painter_destroy(p);
    return good;
}
