/* What lies in front of the scene: dots, labels, the scale bar, the ramp. */
#include "picture.h"

static const double border = 16.0; /* pixels to the edge of the picture */

static void put_dots(const painter *p, const view *v, const sheet *to)
{
    for (size_t i = 0; i < p->dot_count; i++) {
        const dot *d = &p->dots[i];
        double x, y;
        if (view_project(v, view_place(v, d->centre), &x, &y)) {
            to->disc(to->user, x, y, d->pixels + 2.2, PICTURE_INK);
            to->disc(to->user, x, y, d->pixels + 1.4, 0xffffffu);
            to->disc(to->user, x, y, d->pixels, d->colour);
        }
    }
}

static void put_captions(const painter *p, const view *v, const sheet *to)
{
    for (size_t i = 0; i < p->caption_count; i++) {
        const caption *c = &p->captions[i];
        double x = c->point.x, y = c->point.y;
        if (!c->in_scene) {
            to->text(to->user, x, y, 0.0, c->text, c->colour);
        } else if (view_project(v, view_place(v, c->point), &x, &y)) {
            to->text(to->user, x + 7.0, y - 6.0, 0.0, c->text, c->colour);
        }
    }
}

static void put_scale_bar(const painter *p, const view *v, const sheet *to)
{
    if (!(p->bar_length > 0.0) || v->perspective) {
        return;
    }
    double x = border, y = to->height - border, end = x + p->bar_length * v->scale;
    to->line(to->user, x, y, end, y, 2.0, PICTURE_INK);
    to->line(to->user, x, y - 4.0, x, y + 4.0, 2.0, PICTURE_INK);
    to->line(to->user, end, y - 4.0, end, y + 4.0, 2.0, PICTURE_INK);
    to->text(to->user, 0.5 * (x + end), y - 8.0, 0.5, p->bar_text, PICTURE_INK);
}

static void put_ramp(const painter *p, const sheet *to)
{
    enum { STEPS = 64 };
    const double width = 128.0, height = 10.0;
    if (!p->has_ramp) {
        return;
    }
    double x = to->width - border - width, y = to->height - border - height;
    for (int i = 0; i < STEPS; i++) {
        to->fill(to->user, x + i * width / STEPS, y, width / STEPS, height,
                 painter_ramp(i, 0.0, STEPS - 1.0));
    }
    to->text(to->user, x, y - 6.0, 0.0, p->ramp_low, PICTURE_INK);
    to->text(to->user, x + width, y - 6.0, 1.0, p->ramp_high, PICTURE_INK);
}

void picture_overlay(const painter *p, const painter_camera *camera, const sheet *to)
{
    view v = view_of(camera, p->width, p->height);
    put_dots(p, &v, to);
    put_scale_bar(p, &v, to);
    put_ramp(p, to);
    put_captions(p, &v, to);
}
