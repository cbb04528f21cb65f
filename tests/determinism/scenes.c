#include "fixtures/baseline_of.h"
#include "determinism/scenes.h"

#include <stdlib.h>

#include <vblast_ss/needle.h>
#include <vblast_ss/visual.h>

#include "base/hash.h"
#include "base/random.h"
#include "base/rotation.h"
#include "base/snapshot.h"
#include "base/stream.h"
#include "determinism/performance.h"
#include "fixtures/collision_sets.h"
#include "fixtures/device_run.h"
#include "fixtures/drain_hands.h"
#include "fixtures/drain_scenes.h"
#include "fixtures/metrics_run.h"
#include "fixtures/moving_knot.h"
#include "fixtures/moving_shapes.h"
#include "fixtures/needle_scenes.h"
#include "fixtures/paper_needle_scenes.h"
#include "fixtures/rod.h"
#include "fixtures/rolled_scene.h"
#include "fixtures/scene_scenes.h"
#include "fixtures/session_scenes.h"
#include "fixtures/stitch_scenes.h"
#include "fixtures/thread_scenes.h"
#include "fixtures/throw_stack.h"
#include "fixtures/tool_run.h"

/* A scene that cannot run has no hash; a wrong one would only puzzle. */
static void must(vbss_result result)
{
    if (result != VBSS_OK) {
        abort();
    }
}

/* ---- base: the functions that replace libm, over their whole ranges */

static double bounded_random(vbss_random *random, double bound)
{
    return bound * (2.0 * vbss_random_uniform(random) - 1.0);
}

static void add(vbss_stream *stream, double value)
{
    vbss_stream_f64(stream, 1, &value, 1);
}

static void run_elementary(uint64_t *hashes, size_t count)
{
    vbss_random random;
    vbss_random_seed(&random, 20, 26);
    for (size_t i = 0; i < count; i++) {
        vbss_stream stream;
        vbss_stream_begin_hash(&stream);
        for (int k = 0; k < 1000; k++) {
            /* The scale walks from tiny to huge arguments over the run. */
            double scale = vbss_exp(3.5 * (double)i - 12.0);
            double x = bounded_random(&random, scale), y = bounded_random(&random, scale);
            add(&stream, vbss_sin(x));
            add(&stream, vbss_cos(x));
            add(&stream, vbss_atan2(y, x));
            add(&stream, vbss_acos(bounded_random(&random, 1.0)));
            add(&stream, vbss_exp(bounded_random(&random, 745.0)));
            add(&stream, vbss_log(x * x));
            add(&stream, vbss_random_normal(&random));
        }
        hashes[i] = vbss_hash_end(&stream.hash);
    }
}

/* ---- base: long products of rotations and matrices, where a fused operation shows at once */

static void run_rotations(uint64_t *hashes, size_t count)
{
    vbss_random random;
    vbss_random_seed(&random, 3, 3);
    pose p = pose_identity();
    mat3 m = mat3_identity();
    for (size_t i = 0; i < count; i++) {
        for (int k = 0; k < 2000; k++) {
            vec3 axis = vbss_random_direction(&random);
            vec3 turn = vec3_scale(axis, vbss_random_uniform(&random));
            quat q = vbss_quat_from_rotation_vector(turn);
            p = pose_mul(p, pose_make(vec3_scale(turn, 0.01), q));
            p.orientation = quat_unit(p.orientation);
            m = mat3_mul(m, quat_to_mat3(quat_between(vec3_make(0.0, 0.0, 1.0),
                                                      vbss_random_direction(&random))));
        }
        vbss_stream stream;
        vbss_stream_begin_hash(&stream);
        vbss_stream_f64(&stream, 1, &p.position.x, 3);
        vbss_stream_f64(&stream, 2, &p.orientation.w, 4);
        vbss_stream_f64(&stream, 3, &m.m[0][0], 9);
        hashes[i] = vbss_hash_end(&stream.hash);
    }
}

/* ---- a stepped body, hashed after every 20 steps */

static void run_rod(uint64_t *hashes, size_t count)
{
    vbss_context *context;
    rod_config config;
    rod *body;
    vbss_slot *slot;
    must(vbss_context_create(NULL, &context));
    must(rod_config_init(&config, sizeof config));
    must(rod_create(context, &config, &body));
    must(vbss_slot_open(body, &rod_kind, &slot));
    for (size_t i = 0; i < count; i++) {
        for (int k = 0; k < 20; k++) {
            must(rod_step(body, 1e-3));
        }
        must(vbss_snapshot_hash(slot, &hashes[i]));
    }
    must(vbss_context_destroy(context));
}

/* ---- threads, hashed after every 5 steps */

static void run_thread(thread_scene_kind kind, vbss_method method, uint64_t *hashes, size_t count)
{
    vbss_context *context;
    vbss_thread_config config;
    thread_scene scene;
    must(vbss_context_create(NULL, &context));
    must(thread_scene_config(kind, &config));
    config.method = method;
    must(thread_scene_create(context, kind, &config, &scene));
    for (size_t i = 0; i < count; i++) {
        for (int k = 0; k < 5; k++) {
            must(thread_scene_step(&scene, 1e-3));
        }
        must(thread_scene_hash(&scene, &hashes[i]));
    }
    must(vbss_context_destroy(context));
}

static void run_thread_release(uint64_t *hashes, size_t count)
{
    run_thread(THREAD_SCENE_RELEASE, VBSS_METHOD_IMPLICIT, hashes, count);
}

static void run_thread_tugged(uint64_t *hashes, size_t count)
{
    run_thread(THREAD_SCENE_TUGGED, VBSS_METHOD_IMPLICIT, hashes, count);
}

static void run_thread_cut(uint64_t *hashes, size_t count)
{
    run_thread(THREAD_SCENE_CUT, VBSS_METHOD_IMPLICIT, hashes, count);
}

static void run_thread_paper(uint64_t *hashes, size_t count)
{
    run_thread(THREAD_SCENE_RELEASE, VBSS_METHOD_VBLAST, hashes, count);
}

/* ---- collision: degenerate questions to every method, without thickness and with it */

static void add_impact(vbss_stream *stream, vbss_collision_impact *impact)
{
    vbss_stream_i32(stream, 1, &impact->hit, 1);
    vbss_stream_i32(stream, 2, &impact->decision, 1);
    vbss_stream_u32(stream, 3, &impact->passes, 1);
    vbss_stream_f64(stream, 4, &impact->time, 1);
    vbss_stream_f64(stream, 5, &impact->distance, 1);
    vbss_stream_f64(stream, 6, impact->normal, 3);
    vbss_stream_f64(stream, 7, impact->weights, 4);
    vbss_stream_f64(stream, 8, impact->point_a, 3);
    vbss_stream_f64(stream, 9, impact->point_b, 3);
}

enum { ASKERS = 6 };

static void create_askers(vbss_context *context, vbss_collision *askers[ASKERS])
{
    for (int k = 0; k < ASKERS; k++) {
        vbss_collision_config config;
        must(vbss_collision_config_init(&config, sizeof config));
        config.method = (vbss_collision_method)(k / 2);
        config.thickness = k % 2 == 0 ? 0.0 : 0.25;
        baseline_of(&config.baseline)->collision_unit = 1.0;
        must(vbss_collision_create(context, &config, &askers[k]));
    }
}

static void run_collision_questions(uint64_t *hashes, size_t count)
{
    vbss_context *context;
    vbss_collision *askers[ASKERS];
    must(vbss_context_create(NULL, &context));
    create_askers(context, askers);
    for (size_t i = 0; i < count; i++) {
        vbss_stream stream;
        collision_set set;
        vbss_collision_pair_kind kind = (vbss_collision_pair_kind)(i % 2);
        uint32_t which = (uint32_t)(i / 2) % collision_degenerate_count;
        vbss_stream_begin_hash(&stream);
        must(collision_set_degenerate(which, kind, 30, i, NULL, &set) ? VBSS_OK
                                                                      : VBSS_ERROR_OUT_OF_MEMORY);
        for (uint32_t q = 0; q < set.count; q++) {
            for (int k = 0; k < ASKERS; k++) {
                vbss_collision_impact impact;
                must(vbss_collision_test(askers[k], kind, set.queries[q].start, set.queries[q].end,
                                         &impact, sizeof impact));
                add_impact(&stream, &impact);
            }
        }
        collision_set_release(&set);
        hashes[i] = vbss_hash_end(&stream.hash);
    }
    must(vbss_context_destroy(context));
}

/* ---- collision: shapes that move, their candidates and impacts */

static void add_view(vbss_stream *stream, vbss_collision *collision, vbss_collision_field field)
{
    vbss_view view;
    must(vbss_collision_get_view(collision, field, &view, sizeof view));
    for (uint64_t i = 0; i < view.count; i++) {
        const uint8_t *item = (const uint8_t *)view.data + i * view.stride_bytes;
        for (uint32_t k = 0; k < view.components; k++) {
            if (view.type == VBSS_VIEW_TYPE_U32) {
                uint32_t value = ((const uint32_t *)(const void *)item)[k];
                vbss_stream_u32(stream, 1, &value, 1);
            } else {
                double value = ((const double *)(const void *)item)[k];
                vbss_stream_f64(stream, 2, &value, 1);
            }
        }
    }
}

static void run_collision_search(uint64_t *hashes, size_t count)
{
    vbss_context *context;
    moving_shapes_options options = {.segment_count = 120, .capsules = true, .sheet = true};
    vbss_collision_config config;
    moving_shapes scene;
    must(vbss_context_create(NULL, &context));
    must(moving_shapes_config(&options, &config));
    must(moving_shapes_create(context, &options, &config, &scene));
    for (size_t i = 0; i < count; i++) {
        vbss_stream stream;
        vbss_stream_begin_hash(&stream);
        must(moving_shapes_step(&scene));
        for (vbss_collision_field field = VBSS_COLLISION_VIEW_CANDIDATES;
             field <= VBSS_COLLISION_VIEW_DISTANCES; field++) {
            add_view(&stream, scene.collision, field);
        }
        uint64_t state;
        must(vbss_collision_get_hash(scene.collision, &state));
        vbss_stream_u64(&stream, 3, &state, 1);
        hashes[i] = vbss_hash_end(&stream.hash);
    }
    must(moving_shapes_destroy(&scene));
    must(vbss_context_destroy(context));
}

/* ---- whole scenes, hashed after every 5 steps */

static void run_scene(scene_scene_kind kind, uint64_t *hashes, size_t count)
{
    vbss_context *context;
    vbss_scene *scene;
    must(vbss_context_create(NULL, &context));
    must(scene_scene_create(context, kind, &scene));
    for (size_t i = 0; i < count; i++) {
        for (int k = 0; k < 5; k++) {
            must(scene_scene_step(scene, kind));
        }
        must(vbss_scene_get_hash(scene, &hashes[i]));
    }
    must(vbss_context_destroy(context));
}

/* Threads with twist, and with plastic and viscous bending. No other scene has such threads. */
static void run_rolled_scene(bool has_friction_torque, uint64_t *hashes, size_t count)
{
    vbss_context *context;
    rolled_scene scene;
    must(vbss_context_create(NULL, &context));
    must(rolled_scene_create(context, has_friction_torque, &scene));
    for (size_t i = 0; i < count; i++) {
        must(rolled_scene_step(&scene));
        must(vbss_scene_get_hash(scene.scene, &hashes[i]));
    }
    must(vbss_context_destroy(context));
}

static void run_scene_roll(uint64_t *hashes, size_t count)
{
    run_rolled_scene(false, hashes, count);
}

static void run_friction_torque(uint64_t *hashes, size_t count)
{
    run_rolled_scene(true, hashes, count);
}

static void run_scene_knot(uint64_t *hashes, size_t count)
{
    run_scene(SCENE_SCENE_KNOT, hashes, count);
}

static void run_scene_tools(uint64_t *hashes, size_t count)
{
    run_scene(SCENE_SCENE_TOOLS, hashes, count);
}

static void run_scene_mesh(uint64_t *hashes, size_t count)
{
    run_scene(SCENE_SCENE_MESH, hashes, count);
}

/* ---- graspers with all that they do, hashed after every 5 steps */

static void run_graspers_by(vbss_method method, uint64_t *hashes, size_t count)
{
    vbss_context *context;
    tool_run run;
    must(vbss_context_create(NULL, &context));
    must(tool_run_create(context, method, &run));
    for (size_t i = 0; i < count; i++) {
        for (int k = 0; k < 5; k++) {
            must(tool_run_step(&run));
        }
        must(vbss_scene_get_hash(run.scene, &hashes[i]));
    }
    must(vbss_context_destroy(context));
}

static void run_graspers(uint64_t *hashes, size_t count)
{
    run_graspers_by(VBSS_METHOD_IMPLICIT, hashes, count);
}

static void run_graspers_paper(uint64_t *hashes, size_t count)
{
    run_graspers_by(VBSS_METHOD_VBLAST, hashes, count);
}

/* ---- knots: one that is tied and comes undone, seen by both methods; and stacks of throws that are judged */

enum { WATCHERS = 2, JUDGE = 2, KNOT_DETECTORS };

static void create_knot_detectors(vbss_context *context, vbss_knot_detector *d[KNOT_DETECTORS])
{
    for (int k = 0; k < KNOT_DETECTORS; k++) {
        vbss_knot_detector_config config;
        must(moving_knot_config(&config));
        config.method = k == 1 ? VBSS_KNOT_METHOD_PROJECTION : VBSS_KNOT_METHOD_TOPOLOGY;
        config.step_budget = 2500; /* readings last over some steps */
        if (k == JUDGE) {
            config.point_capacity = 400;
            config.crossing_capacity = 256;
        }
        must(vbss_knot_detector_create(context, &config, &d[k]));
    }
}

static void judge_stack(vbss_knot_detector *judge, size_t number)
{
    throw_stack stack;
    thread_line line;
    vbss_knot_input input;
    vbss_random random;
    vbss_random_seed(&random, 6, number);
    throw_stack_init(&stack);
    stack.segments = 160 + 40 * (uint32_t)(number % 4);
    stack.unevenness = 0.1 * (double)(number % 3);
    stack.seed = number;
    for (size_t k = 0; k <= number % 4; k++) {
        int wraps = 1 + (int)vbss_random_below(&random, 2);
        throw_stack_add(&stack, wraps, vbss_random_below(&random, 2) == 0 ? -1 : 1);
    }
    must(throw_stack_make(&stack, &line) ? VBSS_OK : VBSS_ERROR_OUT_OF_RANGE);
    must(vbss_knot_input_init(&input, sizeof input));
    input.points = &line.x[0].x;
    input.point_count = line.count;
    input.hole_count = 2;
    for (int i = 0; i < 2; i++) {
        input.hole_places[i] = line.hole_places[i];
    }
    vec3_store(input.away, line.away);
    must(vbss_knot_detector_judge(judge, &input));
}

static void run_knots(uint64_t *hashes, size_t count)
{
    vbss_context *context;
    vbss_knot_detector *detectors[KNOT_DETECTORS];
    must(vbss_context_create(NULL, &context));
    create_knot_detectors(context, detectors);
    for (size_t i = 0; i < count; i++) {
        vbss_stream stream;
        vbss_stream_begin_hash(&stream);
        for (int k = 0; k < 10 * WATCHERS; k++) {
            must(moving_knot_step(detectors[k % WATCHERS]));
        }
        if (i % 4 == 0) { /* to make one takes long */
            judge_stack(detectors[JUDGE], i / 4);
        }
        for (int k = 0; k < KNOT_DETECTORS; k++) {
            uint64_t own;
            must(moving_knot_hash(detectors[k], &own));
            vbss_stream_u64(&stream, 1, &own, 1);
        }
        hashes[i] = vbss_hash_end(&stream.hash);
    }
    must(vbss_context_destroy(context));
}

/* ---- the device layer with everything that can go wrong, hashed after every 5 steps with what went in and out */

static void add_device_step(vbss_stream *stream, vbss_device_input *input,
                            vbss_output_result *result)
{
    vbss_stream_u32(stream, 1, &input->events, 1);
    vbss_stream_f64(stream, 2, input->position, 3);
    vbss_stream_f64(stream, 3, input->orientation, 4);
    vbss_stream_f64(stream, 4, input->velocity, 3);
    vbss_stream_f64(stream, 5, input->angular_velocity, 3);
    vbss_stream_f64(stream, 6, &input->jaw, 1);
    vbss_stream_u32(stream, 7, &result->flags, 1);
    vbss_stream_f64(stream, 8, result->force, 3);
    vbss_stream_f64(stream, 9, result->torque, 3);
}

static void run_device(uint64_t *hashes, size_t count)
{
    vbss_context *context;
    device_run run;
    must(vbss_context_create(NULL, &context));
    must(device_run_create(context, &run));
    for (size_t i = 0; i < count; i++) {
        vbss_stream stream;
        vbss_stream_begin_hash(&stream);
        for (int k = 0; k < 5; k++) {
            vbss_device_input input;
            vbss_output_result result;
            must(device_run_step(run.device, &input, &result));
            add_device_step(&stream, &input, &result);
        }
        uint64_t state;
        must(vbss_device_get_hash(run.device, &state));
        vbss_stream_u64(&stream, 10, &state, 1);
        hashes[i] = vbss_hash_end(&stream.hash);
    }
    must(vbss_context_destroy(context));
}

/* ---- a trial that is measured, hashed after every 10 steps with what it comes to */

static void add_motion(vbss_stream *stream, vbss_metrics *metrics)
{
    vbss_metrics_bimanual b;
    must(vbss_metrics_get_bimanual(metrics, VBSS_METRICS_PHASE_ALL, &b, sizeof b));
    vbss_stream_f64(stream, 1, &b.correlation, 1);
    vbss_stream_f64(stream, 2, &b.both_moving_share, 1);
    for (int tool = VBSS_METRICS_TOOL_LEFT; tool <= VBSS_METRICS_TOOL_RIGHT; tool++) {
        vbss_metrics_motion o;
        must(vbss_metrics_get_motion(metrics, tool, VBSS_METRICS_PHASE_ALL, &o, sizeof o));
        vbss_stream_f64(stream, 3, &o.path_length, 1);
        vbss_stream_f64(stream, 4, &o.ldj_length, 1);
        vbss_stream_f64(stream, 5, &o.ldj_speed, 1);
        vbss_stream_f64(stream, 6, &o.sparc, 1);
        vbss_stream_f64(stream, 7, &o.movement_sparc, 1);
        vbss_stream_f64(stream, 8, &o.force_integral, 1);
    }
}

static void run_metrics(uint64_t *hashes, size_t count)
{
    vbss_context *context;
    vbss_metrics *metrics;
    must(vbss_context_create(NULL, &context));
    must(metrics_run_create(context, &metrics));
    for (size_t i = 0; i < count; i++) {
        vbss_stream stream;
        vbss_metrics_report r;
        uint64_t state;
        for (int k = 0; k < 10; k++) {
            must(metrics_run_step(metrics));
        }
        vbss_stream_begin_hash(&stream);
        add_motion(&stream, metrics);
        must(vbss_metrics_get_report(metrics, &r, sizeof r));
        vbss_stream_f64(&stream, 9, &r.score, 1);
        vbss_stream_f64(&stream, 10, &r.penalties, 1);
        must(vbss_metrics_get_hash(metrics, &state));
        vbss_stream_u64(&stream, 11, &state, 1);
        hashes[i] = vbss_hash_end(&stream.hash);
    }
    must(vbss_context_destroy(context));
}

/* ---- drains: one that is torn off its block, one that is poked, the paper's, hashed together after every 5 steps */

enum { DRAINS = 3 };

static void run_drain(uint64_t *hashes, size_t count)
{
    static const drain_scene_kind kinds[DRAINS] = {DRAIN_SCENE_TUGGED, DRAIN_SCENE_POKED,
                                                   DRAIN_SCENE_TUGGED};
    vbss_context *context;
    drain_scene scenes[DRAINS];
    must(vbss_context_create(NULL, &context));
    for (int k = 0; k < DRAINS; k++) {
        vbss_drain_config config;
        must(drain_scene_config(kinds[k], &config));
        config.method = k == 2 ? VBSS_METHOD_VBLAST : VBSS_METHOD_IMPLICIT;
        must(drain_scene_create(context, kinds[k], &config, &scenes[k]));
    }
    for (size_t i = 0; i < count; i++) {
        vbss_stream stream;
        vbss_stream_begin_hash(&stream);
        for (int k = 0; k < 5; k++) {
            for (int d = 0; d < DRAINS; d++) {
                must(drain_scene_step(&scenes[d], 1e-3));
            }
        }
        for (int k = 0; k < DRAINS; k++) {
            uint64_t own;
            must(vbss_drain_get_hash(scenes[k].drain, &own));
            vbss_stream_u64(&stream, 1, &own, 1);
        }
        hashes[i] = vbss_hash_end(&stream.hash);
    }
    must(vbss_context_destroy(context));
}

/* ---- a drain in a scene, poked and laden, hashed after every 5 steps */

static void run_drain_hands(uint64_t *hashes, size_t count)
{
    vbss_context *context;
    drain_hands hands;
    must(vbss_context_create(NULL, &context));
    must(drain_hands_init(&hands));
    must(drain_hands_create(context, &hands));
    for (size_t i = 0; i < count; i++) {
        for (int k = 0; k < 5; k++) {
            must(drain_hands_step(hands.scene));
        }
        must(vbss_scene_get_hash(hands.scene, &hashes[i]));
    }
    must(vbss_context_destroy(context));
}

/* ---- needles: a thin and a stout one, thrown and slowed down, hashed together after every 20 steps */

enum { NEEDLES = 2 };

static void run_needle(uint64_t *hashes, size_t count)
{
    static const double arcs[NEEDLES] = {3.14159265358979323846, 0.7};
    vbss_context *context;
    vbss_needle *needles[NEEDLES];
    must(vbss_context_create(NULL, &context));
    for (int k = 0; k < NEEDLES; k++) {
        vbss_needle_config config;
        must(vbss_needle_config_init(&config, sizeof config));
        config.arc = arcs[k];
        config.wire_radius *= 1.0 + 3.0 * k;
        config.drag = 0.3;
        config.gravity[2] = -9.81;
        vec3_store(config.velocity, vec3_make(0.4, -0.3, 5.0));
        vec3_store(config.angular_velocity, vec3_make(0.03, -60.0, 0.02)); /* the middle axis */
        must(vbss_needle_create(context, &config, &needles[k]));
    }
    for (size_t i = 0; i < count; i++) {
        vbss_stream stream;
        vbss_stream_begin_hash(&stream);
        for (int n = 0; n < NEEDLES; n++) {
            vbss_needle_state seen;
            uint64_t own;
            for (int k = 0; k < 20; k++) {
                must(vbss_needle_step(needles[n], 1e-3));
            }
            must(vbss_needle_get_hash(needles[n], &own));
            must(vbss_needle_get_state(needles[n], &seen, sizeof seen));
            vbss_stream_u64(&stream, 1, &own, 1);
            vbss_stream_f64(&stream, 2, seen.swage, 3);
        }
        hashes[i] = vbss_hash_end(&stream.hash);
    }
    must(vbss_context_destroy(context));
}

/* ---- a needle with its thread in two pairs of hands, hashed after every 10 steps */

static void run_needle_hands(uint64_t *hashes, size_t count)
{
    vbss_context *context;
    vbss_scene *scene;
    must(vbss_context_create(NULL, &context));
    must(needle_scene_create(context, &scene));
    for (size_t i = 0; i < count; i++) {
        for (int k = 0; k < 10; k++) {
            must(needle_scene_step(scene));
        }
        must(vbss_scene_get_hash(scene, &hashes[i]));
    }
    must(vbss_context_destroy(context));
}

/* ---- the paper's needle, that two tools pass through a drain, hashed after every 10 steps */

static void run_paper_needle(uint64_t *hashes, size_t count)
{
    vbss_context *context;
    vbss_scene *scene;
    must(vbss_context_create(NULL, &context));
    must(paper_needle_scene_create(context, &scene));
    for (size_t i = 0; i < count; i++) {
        for (int k = 0; k < 10; k++) {
            must(paper_needle_scene_step(scene));
        }
        must(vbss_scene_get_hash(scene, &hashes[i]));
    }
    must(vbss_context_destroy(context));
}

/* ---- a double throw that shuts a slit, hashed after every 10 steps */

static void run_stitch(uint64_t *hashes, size_t count)
{
    static stitch_scene_options options;
    static stitch_scene stitch;
    vbss_context *context;
    uint32_t step = 0;
    must(vbss_context_create(NULL, &context));
    must(stitch_scene_init(&options));
    options.crossings = 5;
    must(stitch_scene_create(context, &options, &stitch));
    for (size_t i = 0; i < count; i++) {
        for (int k = 0; k < 10; k++) {
            must(stitch_scene_tie(&stitch, step++, 1e-3));
        }
        must(vbss_scene_get_hash(stitch.scene, &hashes[i]));
    }
    must(vbss_context_destroy(context));
}

/* ---- the task while that throw is tied, with detector and metrics, hashed after every 10 steps */

static void run_session(uint64_t *hashes, size_t count)
{
    static session_scene scene;
    vbss_session *session;
    vbss_context *context;
    must(vbss_context_create(NULL, &context));
    must(session_scene_tying(context, 5, &scene));
    must(vbss_session_create(scene.scene, &scene.config, &session));
    for (size_t i = 0; i < count; i++) {
        for (int k = 0; k < 10; k++) {
            must(session_scene_tie(&scene, session, NULL));
        }
        must(vbss_session_get_hash(session, &hashes[i]));
    }
    must(vbss_context_destroy(context));
}

/* ---- what is drawn of tools, a thread that they cut, a drain and a needle, hashed after every 5 steps */

static uint64_t hash_of_picture(vbss_visual *visual)
{
    vbss_view vertices, triangles;
    vbss_stream stream;
    must(vbss_visual_update(visual));
    must(vbss_visual_get_view(visual, VBSS_VISUAL_VIEW_VERTICES, &vertices, sizeof vertices));
    must(vbss_visual_get_view(visual, VBSS_VISUAL_VIEW_TRIANGLES, &triangles, sizeof triangles));
    vbss_stream_begin_hash(&stream);
    const float *numbers = vertices.data;
    for (uint64_t i = 0; i < 12 * vertices.count; i++) {
        add(&stream, (double)numbers[i]);
    }
    const uint32_t *corners = triangles.data;
    for (uint64_t i = 0; i < 3 * triangles.count; i++) {
        uint32_t corner = corners[i];
        vbss_stream_u32(&stream, 2, &corner, 1);
    }
    return vbss_hash_end(&stream.hash);
}

static void run_visual(uint64_t *hashes, size_t count)
{
    vbss_context *context;
    vbss_drain_config drain_config;
    vbss_drain *drain;
    vbss_needle *needle;
    vbss_visual *visual;
    tool_run run;
    must(vbss_context_create(NULL, &context));
    must(tool_run_create(context, VBSS_METHOD_IMPLICIT, &run));
    must(vbss_drain_config_init(&drain_config, sizeof drain_config));
    must(vbss_drain_create(context, &drain_config, &drain));
    must(vbss_needle_create(context, NULL, &needle));
    must(vbss_visual_create(context, NULL, &visual));
    must(vbss_visual_add_scene(visual, run.scene, NULL));
    must(vbss_visual_add_drain(visual, drain, NULL));
    must(vbss_visual_add_needle(visual, needle, NULL));
    for (size_t i = 0; i < count; i++) {
        for (int k = 0; k < 5; k++) {
            must(tool_run_step(&run));
        }
        hashes[i] = hash_of_picture(visual);
    }
    must(vbss_context_destroy(context));
}

/* ---- the scripted surgeon, whose hands compute beside the library, hashed after every 100 steps */

static void run_surgeon(uint64_t *hashes, size_t count)
{
    size_t made;
    must(performance_run(0, 100, hashes, count, &made));
    must(made == count ? VBSS_OK : VBSS_ERROR_TRUNCATED);
}

const golden_scene golden_scenes[] = {
    {"base-elementary", 100, 4, run_elementary},
    {"base-rotations", 50, 2, run_rotations},
    {"harness-rod", 200, 10, run_rod},
    {"device-run", DEVICE_RUN_STEPS / 5, 20, run_device},
    {"metrics-run", METRICS_RUN_STEPS / 10, 6, run_metrics}, /* the first puncture at 2 */
    {"collision-questions", 120, 4, run_collision_questions},
    {"collision-search", 40, 2, run_collision_search},
    {"thread-release", 200, 10, run_thread_release},
    {"thread-tugged", 200, 8, run_thread_tugged},
    {"thread-cut", 100, 10, run_thread_cut}, /* the cut is at step 40, inside the short form */
    {"thread-paper", 20, 2, run_thread_paper},
    {"scene-knot", 64, 2, run_scene_knot}, /* tight at 58 */
    {"scene-tools", 80, 6, run_scene_tools},
    {"scene-roll", 60, 18, run_scene_roll},             /* the section is held from 16 to 45 */
    {"friction-torque", 60, 18, run_friction_torque},   /* two threads touch; cut at 50 */
    {"scene-mesh", 60, 2, run_scene_mesh},              /* cut at 44 */
    {"graspers", TOOL_RUN_STEPS / 5, 12, run_graspers}, /* both hold at 11 */
    {"graspers-paper", 30, 12, run_graspers_paper},     /* then it loses the thread */
    {"knots", 72, 4, run_knots}, /* two rounds of all that the moving knot does */
    {"needle", 200, 20, run_needle},
    {"drain", 160, 2, run_drain},
    {"drain-hands", 64, 3, run_drain_hands}, /* the thread is there at once, the tool at 2 */
    {"needle-hands", NEEDLE_SCENE_STEPS / 10, 32, run_needle_hands}, /* held on the floor at 31 */
    {"paper-needle", PAPER_NEEDLE_SCENE_STEPS / 10, 20,
     run_paper_needle}, /* through a wall at 17 */
    {"visual", TOOL_RUN_STEPS / 5, 4, run_visual},
    {"stitch", STITCH_TIE_STEPS / 10, 12, run_stitch}, /* shut at 60; hands draw from 10 on */
    {"session", 64, 2, run_session},                   /* tied at 14, seated at 56 */
    {"surgeon", 40, 14, run_surgeon}, /* the needle is taken at 13, in the first wall at 38 */
};
const size_t golden_scene_count = sizeof golden_scenes / sizeof golden_scenes[0];
