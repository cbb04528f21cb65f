/* Pictures of the pad. */
#include <stdio.h>

#include "pad.h"
#include "scripted/paint.h"

static painter_result add_bodies(painter *p, pad *s, bool with_tools)
{
    vbss_view x;
    if (vbss_drain_get_view(s->skin, VBSS_DRAIN_VIEW_POSITIONS, &x, sizeof x) != VBSS_OK) {
        return PAINTER_ERROR_NULL;
    }
    static const painter_colour colours[PAD_THREADS] = {PAINTER_GREEN, PAINTER_VIOLET};
    painter_result result = painter_add_triangles(
        p, x.data, (size_t)x.count, 0, s->sheet.triangles[0], PAD_TRIANGLES, PAINTER_TISSUE);
    for (int i = 0; i < PAD_THREADS && result == PAINTER_OK; i++) {
        const pad_suture *suture = &s->sutures[i];
        if (suture->thread != NULL) {
            result = scripted_paint_thread(p, suture->thread, PAD_THREAD_RADIUS, colours[i]);
        }
        if (suture->has_needle && result == PAINTER_OK) {
            result = scripted_paint_needle(p, suture->needle, 0.3e-3);
        }
    }
    for (int i = 0; i < 2 && with_tools && s->hands[i].tool != NULL && result == PAINTER_OK; i++) {
        result = scripted_paint_hand(p, s->scene, &s->hands[i], 60e-3);
    }
    return result;
}

bool pad_save_picture(pad *s, const char *path, const char *text, bool from_above)
{
    const painter_camera cameras[2] = {
        {{0.045, 0.075, 0.09}, {0.0, 0.016, 0.0}, {0.0, 1.0, 0.0}, 0.1, 0.0},
        {{0.0, 0.1, 0.0}, {0.0, 0.0, 0.0}, {-1.0, 0.0, 0.0}, 0.05, 0.0}};
    painter *p;
    if (painter_create(900, 640, &p) != PAINTER_OK) {
        return false;
    }
    painter_result result = add_bodies(p, s, !from_above);
    if (result == PAINTER_OK) {
        result = painter_set_camera(p, &cameras[from_above]);
    }
    if (result == PAINTER_OK) {
        result = painter_add_scale_bar(p, 5e-3, "5 mm");
    }
    if (result == PAINTER_OK) {
        result = painter_add_text(p, 16.0, 28.0, text, PAINTER_BLACK);
    }
    const bool good = result == PAINTER_OK && painter_write_png(p, path) == PAINTER_OK;
    if (!good) {
        fprintf(stderr, "%s: %s\n", path, painter_error(p));
    }
    painter_destroy(p);
    return good;
}
