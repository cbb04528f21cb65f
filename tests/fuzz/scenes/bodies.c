/* Random scenes and bodies. They are small, in nodes and in capacities, so that many can be tried. */
#include "fixtures/pad.h"
#include "fixtures/solver_of.h"
#include "fuzz/scenes/fuzzed_scene.h"

#include <math.h>

/* ---- the table of bodies */

void fuzz_register(fuzz_scene *f, uint32_t number, fuzz_kind kind, void *const handles[FUZZ_SIDES])
{
    if (number >= FUZZ_MAX_BODIES) {
        return; /* the fuzzer forgets it; the scene does not */
    }
    f->bodies[number] = (fuzz_body){.kind = kind, .turn = quat_identity()};
    for (uint32_t k = 0; k < FUZZ_SIDES; k++) {
        f->sides[k].handles[number] = handles[k];
    }
    f->last_number = number > f->last_number ? number : f->last_number;
}

void fuzz_add_handle(fuzz_scene *f, fuzz_kind kind, void *const handles[FUZZ_SIDES])
{
    uint32_t number[FUZZ_SIDES] = {0, 0};
    switch (kind) {
    case FUZZ_THREAD:
        FUZZ_CALL(f, vbss_scene_add_thread(side->scene, handles[k], &number[k]));
        break;
    case FUZZ_DRAIN:
        FUZZ_CALL(f, vbss_scene_add_drain(side->scene, handles[k], &number[k]));
        break;
    case FUZZ_NEEDLE:
        FUZZ_CALL(f, vbss_scene_add_needle(side->scene, handles[k], &number[k]));
        break;
    default:
        FUZZ_CALL(f, vbss_scene_add_grasper(side->scene, handles[k], &number[k]));
        break;
    }
    if (f->results[0] == VBSS_OK) {
        fuzz_register(f, number[0], kind, handles);
    }
}

/* Creates a body on both sides with the function of its kind, and adds it. */
#define CREATE_AND_ADD(f, kind, type, config)                                                 \
    do {                                                                                      \
        vbss_##type *made_[FUZZ_SIDES] = {NULL, NULL};                                        \
        for (uint32_t k_ = 0; k_ < FUZZ_SIDES; k_++) {                                        \
            vbss_result made_well_ =                                                          \
                vbss_##type##_create((f)->sides[k_].context, (config), &made_[k_]);           \
            if (made_well_ != VBSS_OK) {                                                      \
                fuzz_fail((f), FUZZ_CHECK_SETUP, #type ": %s", vbss_result_name(made_well_)); \
                return RETURNED;                                                              \
            }                                                                                 \
        }                                                                                     \
        fuzz_add_handle((f), (kind), (void *[FUZZ_SIDES]){made_[0], made_[1]});               \
    } while (0)

static void store_turn(double out[4], quat q)
{
    double origin[3];
    pose_store(pose_make(vec3_zero(), q), origin, out);
}

/* ---- threads */

static void make_adaptive(fuzz_scene *f, vbss_thread_config *config)
{
    config->mesh = VBSS_THREAD_MESH_ADAPTIVE;
    config->node_capacity = 2 * (config->segment_count + 1);
    config->finest_length = 0.5 * config->length / config->segment_count;
    config->coarsest_length = fuzz_real(f, 2.0, 6.0) * config->finest_length;
    config->mesh_operations = fuzz_below(f, 5);
}

/* The thread's middle is in the middle of a random triangle of the drain. Returns the triangle's index. */
static uint32_t lead_through_drain(fuzz_scene *f, uint32_t drain, vbss_thread_config *config)
{
    vbss_view x, triangles;
    (void)vbss_drain_get_view(f->sides[0].handles[drain], VBSS_DRAIN_VIEW_POSITIONS, &x, sizeof x);
    (void)vbss_drain_get_view(f->sides[0].handles[drain], VBSS_DRAIN_VIEW_TRIANGLES, &triangles,
                              sizeof triangles);
    const uint32_t triangle = fuzz_below(f, (uint32_t)triangles.count);
    const uint32_t *corner = (const uint32_t *)triangles.data + 3 * (size_t)triangle;
    const double *nodes = x.data;
    vec3 middle = vec3_zero();
    for (int i = 0; i < 3; i++) {
        middle = vec3_add_scaled(middle, 1.0 / 3.0, vec3_load(nodes + 3 * (size_t)corner[i]));
    }
    vec3 direction = fuzz_direction(f);
    vec3_store(config->direction, direction);
    vec3_store(config->start, vec3_add_scaled(middle, -0.5 * config->length, direction));
    return triangle;
}

/* The first node at a needle's swage. Its number; 0: none. */
static uint32_t lead_to_needle(fuzz_scene *f, vbss_thread_config *config)
{
    const uint32_t needle = fuzz_choose(f, FUZZ_NEEDLE);
    vbss_needle_state at;
    if (needle == 0 || !fuzz_chance(f, 0.6) ||
        vbss_needle_get_state(f->sides[0].handles[needle], &at, sizeof at) != VBSS_OK) {
        return 0;
    }
    for (int c = 0; c < 3; c++) {
        config->start[c] = at.swage[c];
        config->direction[c] = at.swage_direction[c];
    }
    return needle;
}

static void choose_thread(fuzz_scene *f, vbss_thread_config *config)
{
    vbss_thread_config_init(config, sizeof *config);
    config->method = f->config.method;
    if (fuzz_chance(f, 0.5)) {
        (void)vbss_thread_config_preset(config, VBSS_THREAD_PRESET_SILK_2_0);
    }
    config->segment_count = 1 + fuzz_below(f, 12);
    config->length = fuzz_real(f, 1e-3, 3e-3) * config->segment_count;
    config->bending = (vbss_thread_bending)fuzz_below(f, 2);
    config->attachment_capacity = fuzz_below(f, 5);
    config->cut_capacity = fuzz_chance(f, 0.5) ? fuzz_below(f, 4) : 0;
    config->damping = fuzz_chance(f, 0.5) ? 20.0 : 0.0;
    config->rest_curvature = fuzz_chance(f, 0.2) ? 100.0 : 0.0;
    config->gravity[1] = fuzz_chance(f, 0.7) ? -9.81 : 0.0;
    vec3_store(config->start, fuzz_point(f));
    vec3_store(config->direction, fuzz_direction(f));
    if (f->config.method == VBSS_METHOD_IMPLICIT && fuzz_chance(f, 0.15)) {
        make_adaptive(f, config);
    }
}

#define RETURNED
void fuzz_add_thread(fuzz_scene *f)
{
    vbss_thread_config config;
    choose_thread(f, &config);
    const uint32_t drain = fuzz_choose(f, FUZZ_DRAIN);
    if (drain != 0 && fuzz_chance(f, 0.4)) {
        (void)lead_through_drain(f, drain, &config);
    }
    const uint32_t needle = lead_to_needle(f, &config), last = f->last_number;
    CREATE_AND_ADD(f, FUZZ_THREAD, thread, &config);
    if (needle != 0 && f->last_number > last) {
        uint32_t pin;
        FUZZ_CALL(f, vbss_scene_pin_thread(side->scene, f->last_number, 0, needle, NULL, &pin));
    }
}

/* A thread in a hole of the drain's wall. */
static void add_stitch(fuzz_scene *f, uint32_t drain)
{
    const double third = 1.0 / 3.0, weights[3] = {third, third, 1.0 - 2.0 * third};
    const uint32_t last = f->last_number;
    vbss_thread_config config;
    choose_thread(f, &config);
    const uint32_t triangle = lead_through_drain(f, drain, &config);
    CREATE_AND_ADD(f, FUZZ_THREAD, thread, &config);
    if (f->last_number > last) {
        FUZZ_CALL(f, vbss_scene_make_hole(side->scene, f->last_number, 0.5 * config.length, drain,
                                          triangle, weights, NULL));
    }
}

/* ---- drains and rigid bodies */

/* A flat sheet in place of the tube, clamped at one side or nowhere. */
static void choose_sheet(fuzz_scene *f, vbss_drain_config *config)
{
    static pad sheet;
    const uint32_t columns = 2 + fuzz_below(f, 9), rows = 2 + fuzz_below(f, 9);
    pad_make(&sheet, columns, rows, fuzz_real(f, 2e-3, 4e-3) * columns,
             fuzz_real(f, 2e-3, 4e-3) * rows);
    if (fuzz_chance(f, 0.7)) {
        pad_clamp_columns(&sheet, 2);
    }
    for (uint32_t t = 0; t < sheet.surface.triangle_count; t++) {
        sheet.values[t] = fuzz_real(f, 0.5e-3, 2e-3);
    }
    sheet.surface.thickness = fuzz_chance(f, 0.3) ? sheet.values : NULL;
    config->surface = &sheet.surface;
}

void fuzz_add_drain(fuzz_scene *f)
{
    vbss_drain_config config;
    vbss_drain_config_init(&config, sizeof config);
    config.method = f->config.method;
    config.position[1] = fuzz_real(f, -8e-3, 8e-3);
    config.puncture_force = fuzz_chance(f, 0.5) ? 1.0 : 0.01;
    config.tear_stress = fuzz_chance(f, 0.5) ? 5e4 : 1e3;
    if (fuzz_chance(f, 0.3)) {
        store_turn(config.orientation, fuzz_turn(f));
    }
    if (config.method == VBSS_METHOD_IMPLICIT && fuzz_chance(f, 0.3)) {
        choose_sheet(f, &config);
    }
    CREATE_AND_ADD(f, FUZZ_DRAIN, drain, &config);
}

void fuzz_add_rigid(fuzz_scene *f)
{
    vbss_scene_rigid_config config;
    vbss_scene_capsule capsules[3];
    uint32_t number = 0;
    vbss_scene_rigid_config_init(&config, sizeof config);
    config.kind = (vbss_scene_rigid_kind)fuzz_below(f, 3);
    config.capsules = capsules;
    config.capsule_count = 1 + fuzz_below(f, 3);
    for (uint32_t i = 0; i < 3; i++) {
        const vec3 begin = harness_draw_vec3(&f->source, -3e-3, 3e-3);
        const vec3 other = harness_draw_vec3(&f->source, -8e-3, 8e-3);
        vec3_store(capsules[i].begin, begin);
        vec3_store(capsules[i].end, fuzz_chance(f, 0.3) ? begin : other);
        capsules[i].radius = fuzz_small(f, 1e-4, 4e-3);
    }
    const vec3 at = fuzz_point(f);
    vec3_store(config.position, at);
    if (config.kind != VBSS_SCENE_RIGID_DRIVEN) {
        vec3_store(config.velocity, fuzz_vector(f, 2.0));
        vec3_store(config.angular_velocity, fuzz_vector(f, 200.0));
    }
    config.gravity[1] = config.kind == VBSS_SCENE_RIGID_FREE ? -9.81 : 0.0;
    config.mass = fuzz_small(f, 1e-3, 0.1);
    config.friction = fuzz_real(f, 0.0, 0.6);
    FUZZ_CALL(f, vbss_scene_add_rigid(side->scene, &config, &number));
    if (f->results[0] == VBSS_OK && number < FUZZ_MAX_BODIES) {
        fuzz_register(f, number, FUZZ_RIGID, (void *[FUZZ_SIDES]){NULL, NULL});
        f->bodies[number].has_target = config.kind != VBSS_SCENE_RIGID_FREE;
        f->bodies[number].tip = at;
    }
}
#undef RETURNED

#define RETURNED 0
uint32_t fuzz_add_needle(fuzz_scene *f)
{
    vbss_needle_config config;
    const uint32_t last = f->last_number;
    vbss_needle_config_init(&config, sizeof config);
    config.method = f->config.method;
    config.segment_count = 2 + fuzz_below(f, 5);
    config.radius = fuzz_real(f, 4e-3, 10.5e-3);
    config.arc = fuzz_real(f, 1.0, 4.0);
    config.gravity[1] = fuzz_chance(f, 0.7) ? -9.81 : 0.0;
    vec3_store(config.position, fuzz_point(f));
    store_turn(config.orientation, fuzz_turn(f));
    vec3_store(config.velocity, fuzz_vector(f, 2.0));
    vec3_store(config.angular_velocity, fuzz_vector(f, 200.0));
    CREATE_AND_ADD(f, FUZZ_NEEDLE, needle, &config);
    return f->last_number > last ? f->last_number : 0;
}

static void choose_grasper(fuzz_scene *f, vbss_grasper_config *config)
{
    vbss_grasper_config_init(config, sizeof *config);
    if (fuzz_chance(f, 0.3)) {
        (void)vbss_grasper_config_preset(config, VBSS_GRASPER_PRESET_ANGLED);
    }
    config->method = f->config.method;
    config->kind = fuzz_chance(f, 0.3) ? VBSS_GRASPER_KIND_SHEARS : VBSS_GRASPER_KIND_NEEDLE_DRIVER;
    config->jaw_speed = fuzz_small(f, 8.0, 100.0);
    config->closing_force = fuzz_real(f, 0.1, 12.0);
    config->stiffness = fuzz_chance(f, 0.5) ? 400.0 : 2000.0;
    config->damping = fuzz_chance(f, 0.5) ? 5.0 : 10.0;
    config->has_trocar = fuzz_chance(f, 0.1);
    config->trocar[1] = 0.12;
    config->exchange_distance = fuzz_chance(f, 0.1) ? 0.01 : 0.0;
}

uint32_t fuzz_add_grasper(fuzz_scene *f, uint32_t body)
{
    vbss_grasper_config config;
    pose at = fuzz_pose(f);
    const uint32_t last = f->last_number;
    choose_grasper(f, &config);
    if (body == 0) {
        body = fuzz_choose(f, fuzz_chance(f, 0.5) ? FUZZ_NEEDLE : FUZZ_THREAD);
    } else {
        config.kind = VBSS_GRASPER_KIND_NEEDLE_DRIVER;
    }
    (void)fuzz_set_target(f, body, &at);
    double tip[3], turn[4];
    const double opening = fuzz_real(f, 0.2, 1.0);
    vbss_grasper *graspers[FUZZ_SIDES] = {NULL, NULL};
    pose_store(at, tip, turn);
    for (uint32_t k = 0; k < FUZZ_SIDES; k++) {
        vbss_result made = vbss_grasper_create(f->sides[k].context, &config, &graspers[k]);
        if (made != VBSS_OK) {
            fuzz_fail(f, FUZZ_CHECK_SETUP, "grasper: %s", vbss_result_name(made));
            return 0;
        }
        (void)vbss_grasper_set_target(graspers[k], tip, turn);
        (void)vbss_grasper_set_opening(graspers[k], opening);
    }
    fuzz_add_handle(f, FUZZ_GRASPER, (void *[FUZZ_SIDES]){graspers[0], graspers[1]});
    if (f->last_number == last) {
        return 0;
    }
    fuzz_body *own = &f->bodies[f->last_number];
    own->has_target = true;
    own->tip = at.position;
    own->turn = at.orientation;
    return f->last_number;
}

void fuzz_add_random_body(fuzz_scene *f)
{
    switch (FUZZ_PICK(f, 0, 0, 0, 1, 1, 2, 2, 2, 3, 3)) {
    case 0:
        fuzz_add_thread(f);
        break;
    case 1:
        (void)fuzz_add_needle(f);
        break;
    case 2:
        (void)fuzz_add_grasper(f, 0);
        break;
    default:
        fuzz_add_rigid(f);
        break;
    }
}

/* ---- scenes */

static void append_to_script(fuzz_scene *f, fuzz_action action, uint32_t tool, uint32_t times)
{
    for (uint32_t i = 0; i < times && f->script_length < FUZZ_SCRIPT_LENGTH; i++) {
        f->script[f->script_length++] = (fuzz_scripted_call){action, tool};
    }
}

void fuzz_add_exchange(fuzz_scene *f)
{
    const uint32_t needle = fuzz_add_needle(f);
    const uint32_t giver = needle != 0 ? fuzz_add_grasper(f, needle) : 0;
    const uint32_t taker = giver != 0 ? fuzz_add_grasper(f, needle) : 0;
    if (taker == 0) {
        return;
    }
    append_to_script(f, FUZZ_CLOSE, giver, 1);
    append_to_script(f, FUZZ_STEP, 0, 10);
    append_to_script(f, FUZZ_CLOSE, taker, 1);
    append_to_script(f, FUZZ_STEP, 0, 10);
    append_to_script(f, FUZZ_OPEN, giver, 1);
    append_to_script(f, FUZZ_STEP, 0, 5);
}

static void choose_limits(fuzz_scene *f, vbss_scene_config *config)
{
    config->mode = fuzz_chance(f, 0.6) ? VBSS_SCENE_MODE_REAL_TIME : VBSS_SCENE_MODE_OFFLINE;
    config->method = fuzz_chance(f, 0.1) ? VBSS_METHOD_VBLAST : VBSS_METHOD_IMPLICIT;
    set_step_operations(config, FUZZ_PICK(f, 250000, 250000, 250000, 50000, 10000, 2000, 0));
    set_call_operations(config, FUZZ_PICK(f, 210000, 210000, 50000, 20000, 5000, 1000, 0));
    vbss_solver_options *solver = solver_of(config);
    solver->attempt_limit = 1 + fuzz_below(f, 5);
    solver->halving_limit = fuzz_below(f, 6);
    solver->contact_margin = FUZZ_PICK(f, 0, 1, 1, 1, 10) * 3e-5;
    solver->penetration_tolerance = fuzz_chance(f, 0.1) ? 1e-3 : 0.1;
}

static void choose_capacities(fuzz_scene *f, vbss_scene_config *config, bool has_drain)
{
    config->thread_capacity = 1 + fuzz_below(f, 6);
    config->node_capacity = FUZZ_PICK(f, 24, 48, 96);
    config->rigid_capacity = 1 + fuzz_below(f, 10);
    config->capsule_capacity = FUZZ_PICK(f, 8, 16, 32, 64);
    config->pin_capacity = fuzz_below(f, 6);
    config->grasp_capacity = fuzz_below(f, 7);
    config->hole_capacity = fuzz_below(f, 5);
    config->drain_capacity = has_drain;
    config->event_capacity = FUZZ_PICK(f, 0, 2, 32);
    config->contact_capacity = has_drain ? 256 : FUZZ_PICK(f, 4, 16, 64, 128);
    config->candidate_capacity = has_drain ? 4096 : FUZZ_PICK(f, 16, 64, 256, 1024);
    config->floor = fuzz_chance(f, 0.5);
    config->floor_height = fuzz_real(f, -0.02, 0.0);
    config->floor_normal[0] = fuzz_real(f, -0.2, 0.2);
}

static bool create_scenes(fuzz_scene *f)
{
    vbss_scene_config_init(&f->config, sizeof f->config);
    const bool has_drain = fuzz_chance(f, 0.05);
    choose_limits(f, &f->config);
    choose_capacities(f, &f->config, has_drain);
    for (uint32_t k = 0; k < FUZZ_SIDES; k++) {
        if (vbss_context_create(NULL, &f->sides[k].context) != VBSS_OK ||
            vbss_scene_create(f->sides[k].context, &f->config, &f->sides[k].scene) != VBSS_OK) {
            fuzz_fail(f, FUZZ_CHECK_SETUP, "no scene");
            return false;
        }
    }
    return true;
}

bool fuzz_build_scene(fuzz_scene *f)
{
    if (!create_scenes(f)) {
        return false;
    }
    const uint32_t interval = FUZZ_PICK(f, 1, 1, 1, 7);
    f->comparison_interval = f->findings->is_traced ? 1 : interval;
    f->h = 1e-4 * FUZZ_PICK(f, 10, 10, 10, 10, 1, 5, 20, 160);
    fuzz_begin_checks(f);
    if (fuzz_chance(f, 0.8)) {
        fuzz_add_witness(f);
    }
    if (f->config.drain_capacity > 0) {
        fuzz_add_drain(f);
        const uint32_t drain = fuzz_choose(f, FUZZ_DRAIN);
        for (uint32_t i = drain != 0 ? fuzz_below(f, 3) : 0; i > 0; i--) {
            add_stitch(f, drain);
        }
    }
    if (fuzz_chance(f, 0.25)) {
        fuzz_add_exchange(f);
    }
    for (uint32_t i = fuzz_below(f, 5); i > 0; i--) {
        fuzz_add_random_body(f);
    }
    return true;
}
