/* The bodies of the scene. All values are chosen: they come from no measurement. */
#include <string.h>

#include "base/error.h"
#include "pad.h"

static const double thickness = 2e-3 /* m */, young = 0.1e6 /* Pa */, poisson = 0.45;
/* Of the tissue below the skin, as springs to where it is at rest: a layer of 10 mm with a modulus of 20 kPa. */
static const double foundation = 2e6 /* N/m^3 */;
static const double segments[PAD_THREADS] = {0.5e-3, 0.9e-3}; /* m: a knot needs shorter ones */
static const double shaft = 1.5e-3 /* m, of a tool */;
static const double lengths[PAD_THREADS] = {158e-3, 183e-3};

/* ---- skin */

/* A third of the area of each triangle of a node. */
static void find_areas(const pad_sheet *s, double areas[PAD_NODES])
{
    memset(areas, 0, PAD_NODES * sizeof *areas);
    for (uint32_t i = 0; i < PAD_TRIANGLES; i++) {
        const uint32_t *n = s->triangles[i];
        const vec3 a = vec3_load(s->x[n[0]]), b = vec3_load(s->x[n[1]]), c = vec3_load(s->x[n[2]]);
        const double area = 0.5 * vec3_norm(vec3_cross(vec3_sub(b, a), vec3_sub(c, a)));
        for (int k = 0; k < 3; k++) {
            areas[n[k]] += area / 3.0;
        }
    }
}

static bool is_anchor(const pad_sheet *s, uint32_t node)
{
    for (uint32_t i = 0; i < PAD_ANCHORS; i++) {
        if (s->anchors[i] == node) {
            return true;
        }
    }
    return false;
}

static vbss_result support_skin(pad *p)
{
    double areas[PAD_NODES];
    find_areas(&p->sheet, areas);
    for (uint32_t i = 0; i < PAD_NODES; i++) {
        if (!is_anchor(&p->sheet, i)) {
            vbss_drain_attachment spring = vbss_drain_attachment_default();
            uint32_t id;
            spring.kind = VBSS_DRAIN_ATTACHMENT_SPRING;
            spring.node = i;
            spring.stiffness = foundation * areas[i];
            memcpy(spring.position, p->sheet.x[i], sizeof spring.position);
            VBSS_TRY(vbss_drain_attach(p->skin, &spring, &id));
        }
    }
    return VBSS_OK;
}

static vbss_result add_skin(pad *p)
{
    pad_make_sheet(&p->sheet);
    vbss_drain_surface surface = vbss_drain_surface_default();
    surface.node_count = PAD_NODES;
    surface.triangle_count = PAD_TRIANGLES;
    surface.anchor_count = PAD_ANCHORS;
    surface.positions = p->sheet.x[0];
    surface.triangles = p->sheet.triangles[0];
    surface.anchors = p->sheet.anchors;
    vbss_drain_config config = vbss_drain_config_default();
    config.surface = &surface;
    config.thickness = thickness;
    config.young_modulus = young;
    config.poisson_ratio = poisson;
    config.density = 1050.0;
    config.tear_stress = 1e9; /* the clamps hold */
    config.attachment_capacity = PAD_NODES;
    config.puncture_force = 0.2;
    config.hole_force = 0.06;
    config.hole_friction = PAD_FRICTION;
    config.friction = PAD_SKIN_FRICTION;
    VBSS_TRY(vbss_drain_create(p->context, &config, &p->skin));
    VBSS_TRY(support_skin(p));
    return vbss_scene_add_drain(p->scene, p->skin, &p->skin_body);
}

/* ---- sutures */

static vbss_result add_needle(pad *p, pad_suture *s, pose at)
{
    vbss_needle_config config = vbss_needle_config_default();
    config.radius = SCRIPTED_RADIUS;
    config.wire_radius = 0.3e-3;
    config.arc = SCRIPTED_ARC;
    config.segment_count = 24;
    pose_store(at, config.position, config.orientation);
    VBSS_TRY(vbss_needle_create(p->context, &config, &s->needle));
    return vbss_scene_add_needle(p->scene, s->needle, &s->needle_body);
}

/* Straight from the swage, to the right. */
static vbss_result add_thread(pad *p, pad_suture *s)
{
    vbss_needle_state needle;
    uint32_t pin;
    VBSS_TRY(vbss_needle_get_state(s->needle, &needle, sizeof needle));
    vbss_thread_config config = vbss_thread_config_default();
    config.segment_count = s->segments;
    config.length = s->length;
    config.radius = PAD_THREAD_RADIUS;
    config.damping = 10.0;
    config.drag = 10.0; /* in air it would be less; loops come to rest sooner */
    config.cut_capacity = 3;
    memcpy(config.start, needle.swage, sizeof config.start);
    memset(config.gravity, 0, sizeof config.gravity);
    VBSS_TRY(vbss_thread_create(p->context, &config, &s->thread));
    VBSS_TRY(vbss_scene_add_thread(p->scene, s->thread, &s->thread_body));
    return vbss_scene_pin_thread(p->scene, s->thread_body, 0, s->needle_body, NULL, &pin);
}

vbss_result pad_add_suture(pad *p, uint32_t which, pose needle)
{
    pad_suture *s = &p->sutures[which];
    s->length = lengths[which];
    s->segments = (uint32_t)(s->length / segments[which] + 0.5);
    s->has_needle = true;
    VBSS_TRY(add_needle(p, s, needle));
    return add_thread(p, s);
}

/* ---- all */

static vbss_result create_scene(pad *p)
{
    vbss_scene_config config = vbss_scene_config_default();
    config.mode = VBSS_SCENE_MODE_OFFLINE; /* each call finishes its step */
    config.node_capacity = 1024;
    config.thread_capacity = 6;
    config.rigid_capacity = 8;
    config.capsule_capacity = 128;
    config.contact_capacity = 4096;
    config.candidate_capacity = 65536;
    config.hole_capacity = 32;
    return vbss_scene_create(p->context, &config, &p->scene);
}

vbss_result pad_create(vbss_context *context, pad *p)
{
    FILE *log = p->log;
    const uint64_t seed = p->seed;
    memset(p, 0, sizeof *p);
    p->log = log;
    p->seed = seed;
    p->context = context;
    VBSS_TRY(create_scene(p));
    VBSS_TRY(add_skin(p));
    VBSS_TRY(pad_add_suture(p, 0, scripted_needle(pad_needle_centre(p), pad_needle_turned(p))));
    for (int i = 0; i < 2; i++) {
        const vec3 centre = pad_direct_hand(p, i, &p->hands[i]);
        VBSS_TRY(scripted_add_hand(context, p->scene, &p->hands[i], centre, shaft));
    }
    return pad_begin_log(p);
}
