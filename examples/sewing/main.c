/* A stitch in the tissue of a host.
 *
 *     sewing [folder for pictures [s between frames of a film]]
 *
 * The tissue is the host's own: 720 linear tetrahedra in implicit steps (host_tissue/fem.c). Its surface is a host surface of the scene.
 * Two scripted hands drive a needle through it, in and out, draw the thread after it, and pull at both of its ends. Prints what
 * happens; exits 0 if the stitch holds, the tissue bears exactly the forces that the scene returned, and nothing passed
 * through the surface but by the two holes. */
#include <inttypes.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "decimal_point.h"
#include "scripted/paint.h"
#include "sewing.h"

enum { EVERY = 250 /* steps from line to line of the log */ };
static const double balance = 0.01 /* of the force */, min_pull = 0.25 /* N */;

/* ---- pictures */

static painter_result paint(painter *p, const sewing *s, const char *text)
{
    vbss_view surface;
    if (vbss_scene_get_surface_view(s->scene, s->surface, VBSS_SCENE_SURFACE_VIEW_POSITIONS,
                                    &surface, sizeof surface) != VBSS_OK) {
        return PAINTER_ERROR_NULL;
    }
    const painter_camera camera = {
        {0.012, 0.028, 0.06}, {0.0, 0.004, 0.0}, {0.0, 1.0, 0.0}, 0.036, 0.0};
    painter_result result =
        painter_add_triangles(p, surface.data, (size_t)surface.count, 0, s->triangles[0],
                              SEWING_TRIANGLES, PAINTER_TISSUE);
    if (result == PAINTER_OK) {
        result = scripted_paint_thread(p, s->thread, 0.125e-3, PAINTER_VIOLET);
    }
    if (result == PAINTER_OK) {
        result = scripted_paint_needle(p, s->needle, 0.3e-3);
    }
    for (int i = 0; i < 2 && result == PAINTER_OK; i++) {
        result = scripted_paint_hand(p, s->scene, &s->hands[i], 13e-3);
    }
    if (result == PAINTER_OK) {
        result = painter_set_camera(p, &camera);
    }
    if (result == PAINTER_OK) {
        result = painter_add_scale_bar(p, 5e-3, "5 mm");
    }
    return result != PAINTER_OK ? result : painter_add_text(p, 16.0, 28.0, text, PAINTER_BLACK);
}

static bool save(const char *folder, const char *format, int number, const sewing *s)
{
    char name[32], path[512], text[96];
    painter *p;
    if (painter_create(900, 640, &p) != PAINTER_OK) {
        return false;
    }
    snprintf(name, sizeof name, format, number);
    snprintf(path, sizeof path, "%s/%s", folder, name);
    snprintf(text, sizeof text, "%.2f s: %s", s->time, sewing_phase(s));
    const bool good = paint(p, s, text) == PAINTER_OK && painter_write_png(p, path) == PAINTER_OK;
    if (!good) {
        fprintf(stderr, "%s: %s\n", path, painter_error(p));
    }
    painter_destroy(p);
    return good;
}

/* ---- run */

static void report(const sewing *s, const sewing_report *r)
{
    printf("%5.2f s  %-17s  %u holes  tissue bears %.3f N  surface %+.2f to %+.2f mm  "
           "apart %.3f mm  crossings %u\n",
           s->time, sewing_phase(s), r->holes, vec3_norm(r->force), 1e3 * r->deepest,
           1e3 * r->highest, 1e3 * r->apart, r->crossings);
}

static vbss_result run(sewing *s, const char *folder, double interval, sewing_report *last,
                       uint32_t *crossings, bool *painted)
{
    bool is_done = false;
    vbss_result result = VBSS_OK;
    int pictures = 0, frames = 0;
    *crossings = 0;
    *painted = true;
    for (int step = 1; result == VBSS_OK && !is_done; step++) {
        result = sewing_step(s, &is_done);
        if (result == VBSS_OK && (step % EVERY == 0 || is_done)) {
            result = sewing_measure(s, last);
            *crossings += last->crossings;
            report(s, last);
            *painted = *painted && (folder == NULL || save(folder, "%02d.png", ++pictures, s));
        }
        if (result == VBSS_OK && interval > 0.0 && s->time >= frames * interval) {
            *painted = *painted && save(folder, "frame-%04d.png", frames++, s);
        }
    }
    return result;
}

int main(int count, char **words)
{
    use_decimal_point();
    static sewing s;
    vbss_context *context;
    sewing_report r;
    uint32_t crossings = 0;
    uint64_t hash = 0;
    bool painted = false;
    const double interval = count > 2 ? strtod(words[2], NULL) : 0.0;
    if (count > 3 || vbss_context_create(NULL, &context) != VBSS_OK) {
        fprintf(stderr, "usage: sewing [folder for pictures [s between frames of a film]]\n");
        return 2;
    }
    vbss_result result = sewing_create(context, &s);
    if (result == VBSS_OK) {
        const char *folder = count > 1 ? words[1] : NULL;
        result = run(&s, folder, interval, &r, &crossings, &painted);
    }
    result = result == VBSS_OK ? vbss_scene_get_hash(s.scene, &hash) : result;
    if (result != VBSS_OK) {
        const char *text = "";
        (void)vbss_context_get_last_error(context, NULL, &text);
        fprintf(stderr, "%s: %s\n", vbss_result_name(result), text);
        sewing_destroy(&s);
        (void)vbss_context_destroy(context);
        return 1;
    }
    const double force = vec3_norm(r.force), off = vec3_distance(r.force, r.reaction);
    printf("%u punctures; %u holes with %.3f and %.3f N; tail %.3f N\n", s.punctures, r.holes,
           r.hole_forces[0], r.hole_forces[1], r.tail_force);
    printf("forces of the scene %.4f N, reaction of the tissue %.4f N, %.2f %% apart; a vertex "
           "bears %.4f N and "
           "lacks %.2g N\n",
           force, vec3_norm(r.reaction), 100.0 * off / force, r.largest_force, r.largest_residual);
    printf("crossings beside the holes: %u; hash %016" PRIx64 "\n", crossings, hash);
    const bool good = s.punctures == 2 && r.holes == 2 && r.tail_force > min_pull &&
                      off < balance * force && r.largest_residual < balance * r.largest_force &&
                      crossings == 0 && painted;
    sewing_destroy(&s);
    (void)vbss_context_destroy(context);
    return good ? 0 : 1;
}
