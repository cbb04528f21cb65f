/* The bodies of the scene. */
#include "sewing.h"
#include "script.h"

#include <string.h>

#include "base/error.h"

/* Soft skin and a strong needle. All values are chosen: they come from no measurement. */
static const fem_config tissue = {
    {SEWING_CELLS_X, SEWING_CELLS_Y, SEWING_CELLS_Z}, 3e-3, 100e3, 0.4, 1000.0, 20.0, SEWING_STEP};
static const double thread_radius = 0.125e-3, thread_length = 110e-3;
enum { SEGMENTS = 140 };

static vbss_result add_surface(sewing *s)
{
    static double compliance[SEWING_VERTICES][9];
    const uint32_t row = SEWING_CELLS_Z + 1;
    for (uint32_t i = 0; i < SEWING_CELLS_X * SEWING_CELLS_Z; i++) {
        const uint32_t a = i / SEWING_CELLS_Z * row + i % SEWING_CELLS_Z, b = a + row;
        const uint32_t cell[2][3] = {{a, a + 1, b + 1}, {a, b + 1, b}};
        memcpy(s->triangles[2 * (size_t)i], cell, sizeof cell);
    }
    vbss_scene_surface_config config = vbss_scene_surface_config_default();
    config.vertex_count = SEWING_VERTICES;
    config.triangle_count = SEWING_TRIANGLES;
    config.vertices = s->tissue.rest[s->tissue.first_surface];
    config.triangles = s->triangles[0];
    config.compliance_size = 9;
    config.puncture_force = 0.6;
    config.hole_force = 0.15;
    VBSS_TRY(vbss_scene_add_surface(s->scene, &config, &s->surface));
    for (int i = 0; i < SEWING_VERTICES; i++) {
        fem_compliance(&s->tissue, i, 0, compliance[i]);
    }
    return vbss_scene_set_surface_compliance(s->scene, s->surface, compliance[0],
                                             9 * SEWING_VERTICES);
}

static vbss_result add_needle(sewing *s)
{
    vbss_needle_config config = vbss_needle_config_default();
    const pose at = scripted_needle(SCRIPT_CENTRE, s->turned);
    config.radius = SCRIPTED_RADIUS;
    config.wire_radius = 0.3e-3;
    config.arc = SCRIPTED_ARC;
    config.segment_count = 24;
    pose_store(at, config.position, config.orientation);
    VBSS_TRY(vbss_needle_create(s->context, &config, &s->needle));
    return vbss_scene_add_needle(s->scene, s->needle, &s->needle_body);
}

/* Straight along x from the swage. */
static vbss_result add_thread(sewing *s)
{
    vbss_needle_state needle;
    uint32_t pin;
    VBSS_TRY(vbss_needle_get_state(s->needle, &needle, sizeof needle));
    vbss_thread_config config = vbss_thread_config_default();
    config.segment_count = s->segments = SEGMENTS;
    config.length = thread_length;
    config.radius = thread_radius;
    config.damping = 10.0;
    memcpy(config.start, needle.swage, sizeof config.start);
    memset(config.gravity, 0, sizeof config.gravity);
    VBSS_TRY(vbss_thread_create(s->context, &config, &s->thread));
    VBSS_TRY(vbss_scene_add_thread(s->scene, s->thread, &s->thread_body));
    return vbss_scene_pin_thread(s->scene, s->thread_body, 0, s->needle_body, NULL, &pin);
}

vbss_result sewing_create(vbss_context *context, sewing *s)
{
    memset(s, 0, sizeof *s);
    s->context = context;
    vbss_scene_config config = vbss_scene_config_default();
    config.mode = VBSS_SCENE_MODE_OFFLINE; /* each call finishes its step, as the tissue's does */
    config.floor = 0;
    config.capsule_capacity = 64;
    config.contact_capacity = 2048;
    config.candidate_capacity = 65536;
    VBSS_TRY(vbss_scene_create(context, &config, &s->scene));
    if (!fem_create(&s->tissue, &tissue)) {
        return VBSS_ERROR_OUT_OF_MEMORY;
    }
    script_begin(s);
    VBSS_TRY(add_surface(s));
    VBSS_TRY(add_needle(s));
    VBSS_TRY(add_thread(s));
    VBSS_TRY(scripted_add_hand(context, s->scene, &s->hands[0], SCRIPT_CENTRE, 0.0));
    return scripted_add_hand(context, s->scene, &s->hands[1], SCRIPT_CENTRE, 0.0);
}

void sewing_destroy(sewing *s)
{
    fem_destroy(&s->tissue);
}
