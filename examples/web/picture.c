/* What the page draws: meshes, where they are seen from, and the programs that draw them. */
#include <string.h>

#include "page.h"
#include "session.h"
#include "viewer/barrel.h"
#include "viewer/materials.h"
#include "viewer/programs.h"

enum { FIELDS = 4, MATRIX = 16, REST = 14, PROGRAM_BYTES = 16384 };

void page_set_camera(double aside, double down, double away, double aspect)
{
    page_session *p = page_get();
    if (!p->there) {
        return;
    }
    p->aspect = (float)aspect;
    p->camera = camera_from(p->live.view.target, (float)aside, (float)down, (float)away);
    for (int side = 0; side < SIDES && !p->plays; side++) {
        mouse_hand_set_camera(&p->live.hands[side], &p->camera);
    }
}

const double *page_first_camera(void)
{
    static double place[3];
    const live *l = &page_get()->live;
    place[0] = l->scene != NULL ? (double)l->view.aside : 0.0;
    place[1] = (double)CAMERA_DOWN;
    place[2] = l->scene != NULL ? (double)l->view.away : (double)CAMERA_AWAY;
    return place;
}

const float *page_view(void)
{
    static float numbers[2 * MATRIX + REST];
    const page_session *p = page_get();
    const camera_view v = camera_get_view(&p->camera, p->aspect);
    const point3 target = p->there ? p->live.view.target : (point3){0.0F, 0.0F, 0.0F};
    const float rest[REST] = {v.eye.x,
                              v.eye.y,
                              v.eye.z,
                              v.lamp.x,
                              v.lamp.y,
                              v.lamp.z,
                              target.x,
                              target.y,
                              target.z,
                              p->camera.clear,
                              MATERIAL_BRIGHTNESS * p->camera.gain,
                              CAMERA_GONE,
                              BARREL,
                              BARREL_SPREAD};
    memcpy(numbers, v.seen.m, sizeof v.seen.m);
    memcpy(numbers + MATRIX, v.light.m, sizeof v.light.m);
    memcpy(numbers + 2 * (size_t)MATRIX, rest, sizeof rest);
    return numbers;
}

const uint32_t *page_draw(void)
{
    static uint32_t arrays[2 * FIELDS];
    page_session *p = page_get();
    const double since = p->live.time - p->ghost_time;
    p->ghost_time = p->live.time;
    if (!p->there || page_step_ghost(p, since) != VBSS_OK ||
        vbss_visual_update(p->visual) != VBSS_OK) {
        return NULL;
    }
    for (vbss_visual_field field = 0; field < FIELDS; field++) {
        vbss_view view;
        if (vbss_visual_get_view(p->visual, field, &view, sizeof view) != VBSS_OK) {
            return NULL;
        }
        arrays[2 * (size_t)field] = (uint32_t)(uintptr_t)view.data; /* of 32 bits in the module */
        arrays[2 * field + 1] = (uint32_t)view.count;
    }
    return arrays;
}

const char *page_program(int32_t number)
{
    static char text[PROGRAM_BYTES];
    const char *const pieces[][MATERIAL_PIECES] = {
        {material_vertex}, {material_fragment[0], material_fragment[1], material_fragment[2]},
        {lens_vertex},     {lens_fragment},
        {shadow_vertex},   {shadow_fragment},
    };
    size_t at = 0;
    text[0] = '\0';
    for (int i = 0; number >= 0 && number < 6 && i < MATERIAL_PIECES; i++) {
        const size_t size = pieces[number][i] != NULL ? strlen(pieces[number][i]) : 0;
        if (size > 0 && at + size < sizeof text) {
            memcpy(text + at, pieces[number][i], size + 1);
            at += size;
        }
    }
    return text;
}
