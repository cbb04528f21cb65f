#include "scenes/moving_shapes.h"

#include "base/elementary.h"
#include "base/error.h"
#include "base/hash.h"
#include "base/linear.h"
#include "base/stream.h"

#include <stdlib.h>

#define D (2.0 * MOVING_SHAPES_RADIUS)
#define TURN 6.28318530717958648
#define COIL_RADIUS (6.4 * D)
#define PITCH (1.15 * D)
#define SPACING (2.5 * D) /* of the sheet's nodes */
enum { TURN_SEGMENTS = 32, SHEET_WIDTH = 6, SEGMENTS_A_CAPSULE = 8 };

/* ---- sizes */

static double coil_length(const moving_shapes_options *o)
{
    return PITCH * o->segment_count / TURN_SEGMENTS;
}

static uint32_t capsules(const moving_shapes_options *o)
{
    return o->segment_count / SEGMENTS_A_CAPSULE + 1;
}

static uint32_t sheet_rows(const moving_shapes_options *o)
{
    return (uint32_t)(coil_length(o) / SPACING) + 3;
}

static bool there_is(const moving_shapes_options *o, moving_shape shape)
{
    return shape == MOVING_THREAD || (shape == MOVING_CAPSULES ? o->capsules : o->sheet);
}

uint32_t moving_shapes_nodes(const moving_shapes_options *o, moving_shape shape)
{
    return shape == MOVING_THREAD     ? o->segment_count + 1
           : shape == MOVING_CAPSULES ? 2 * capsules(o)
                                      : SHEET_WIDTH * sheet_rows(o);
}

/* ---- places */

static double wave(double height, double phase)
{
    return height * vbss_sin(phase);
}

static vec3 thread_place(double i, double t)
{
    double sine, cosine;
    double radius = COIL_RADIUS + wave(0.3 * D, 0.31 * i + 0.11 * t);
    vbss_sincos(TURN / TURN_SEGMENTS * i + wave(0.3, 0.05 * i + 0.013 * t), &sine, &cosine);
    double along = PITCH / TURN_SEGMENTS * i + wave(0.2 * D, 0.7 * i - 0.09 * t);
    return vec3_make(along, radius * cosine, radius * sine);
}

static void place_capsule(const moving_shapes_options *o, uint32_t number, double t, double ends[6])
{
    double sine, cosine;
    double share = (number + 0.5) / capsules(o);
    vbss_sincos(2.4 * number + 0.02 * t, &sine, &cosine); /* the golden angle: evenly around */
    double radius = 1.2 * COIL_RADIUS + wave(0.1 * COIL_RADIUS, number + 0.05 * t);
    vec3 centre = vec3_make(share * coil_length(o), radius * cosine, radius * sine);
    vbss_sincos(0.7 * number + 0.04 * t, &sine, &cosine);
    vec3 half = vec3_scale(vec3_make(cosine, 0.6 * sine, 0.8 * sine), 1.5 * D);
    vec3_store(ends, vec3_sub(centre, half));
    vec3_store(ends + 3, vec3_add(centre, half));
}

static vec3 sheet_place(uint32_t node, double t)
{
    uint32_t along = node / SHEET_WIDTH, across = node % SHEET_WIDTH;
    double height = wave(1.5 * D, 0.9 * along + 0.07 * t) + wave(0.5 * D, 1.3 * across - 0.05 * t);
    return vec3_make((along - 1.0) * SPACING, -1.1 * COIL_RADIUS + height,
                     (across - 0.5 * (SHEET_WIDTH - 1)) * SPACING);
}

void moving_shapes_place(const moving_shapes_options *o, moving_shape shape, uint64_t step,
                         double *positions)
{
    double t = (double)step;
    uint32_t nodes = moving_shapes_nodes(o, shape);
    if (shape == MOVING_CAPSULES) {
        for (uint32_t i = 0; i < nodes / 2; i++) {
            place_capsule(o, i, t, positions + 6 * (size_t)i);
        }
        return;
    }
    for (uint32_t i = 0; i < nodes; i++) {
        vec3_store(positions + 3 * (size_t)i,
                   shape == MOVING_THREAD ? thread_place(i, t) : sheet_place(i, t));
    }
}

/* ---- shapes */

static vbss_result add_thread(moving_shapes *scene, uint32_t *shape)
{
    uint32_t n = scene->options.segment_count;
    double *rest = malloc(n * sizeof *rest);
    if (rest == NULL) {
        return VBSS_ERROR_OUT_OF_MEMORY;
    }
    for (uint32_t i = 0; i < n; i++) {
        rest[i] = TURN * COIL_RADIUS / TURN_SEGMENTS;
    }
    vbss_result result =
        vbss_collision_add_chain(scene->collision, n + 1, rest, MOVING_SHAPES_RADIUS, shape);
    free(rest);
    return result;
}

static vbss_result add_sheet(moving_shapes *scene, uint32_t *shape)
{
    uint32_t rows = sheet_rows(&scene->options), count = 0;
    uint32_t(*triangles)[3] = malloc((size_t)rows * SHEET_WIDTH * 2 * sizeof *triangles);
    if (triangles == NULL) {
        return VBSS_ERROR_OUT_OF_MEMORY;
    }
    for (uint32_t row = 0; row + 1 < rows; row++) {
        for (uint32_t k = 0; k + 1 < SHEET_WIDTH; k++) {
            uint32_t node = row * SHEET_WIDTH + k, above = node + SHEET_WIDTH;
            const uint32_t pair[2][3] = {{node, node + 1, above}, {node + 1, above + 1, above}};
            for (int half = 0; half < 2; half++, count++) {
                for (int corner = 0; corner < 3; corner++) {
                    triangles[count][corner] = pair[half][corner];
                }
            }
        }
    }
    vbss_result result = vbss_collision_add_mesh(scene->collision, SHEET_WIDTH * rows, triangles[0],
                                                 count, MOVING_SHAPES_RADIUS, shape);
    free(triangles);
    return result;
}

static vbss_result add_shapes(moving_shapes *scene)
{
    const moving_shapes_options *o = &scene->options;
    uint32_t shape;
    VBSS_TRY(add_thread(scene, &shape));
    if (o->capsules) {
        VBSS_TRY(vbss_collision_add_capsules(scene->collision, capsules(o), MOVING_SHAPES_RADIUS,
                                             &shape));
    }
    if (o->sheet) {
        VBSS_TRY(add_sheet(scene, &shape));
    }
    VBSS_TRY(moving_shapes_move(scene, 0)); /* from the origin */
    return moving_shapes_move(scene, 0);
}

/* ---- the scene */

vbss_result moving_shapes_config(const moving_shapes_options *options,
                                 vbss_collision_config *config)
{
    VBSS_TRY(vbss_collision_config_init(config, sizeof *config));
    config->pair_capacity = 1000 + 20 * options->segment_count;
    config->impact_capacity = config->pair_capacity;
    return VBSS_OK;
}

vbss_result moving_shapes_create(vbss_context *context, const moving_shapes_options *options,
                                 const vbss_collision_config *config, moving_shapes *scene)
{
    uint32_t most = 0;
    *scene = (moving_shapes){.options = *options};
    for (moving_shape shape = MOVING_THREAD; shape <= MOVING_SHEET; shape++) {
        uint32_t nodes = moving_shapes_nodes(options, shape);
        most = nodes > most ? nodes : most;
    }
    scene->positions = malloc(3 * (size_t)most * sizeof *scene->positions);
    vbss_result result = scene->positions == NULL ? VBSS_ERROR_OUT_OF_MEMORY : VBSS_OK;
    if (result == VBSS_OK) {
        result = vbss_collision_create(context, config, &scene->collision);
    }
    if (result == VBSS_OK) {
        result = add_shapes(scene);
    }
    if (result != VBSS_OK) {
        (void)moving_shapes_destroy(scene);
    }
    return result;
}

vbss_result moving_shapes_destroy(moving_shapes *scene)
{
    free(scene->positions);
    scene->positions = NULL;
    return vbss_collision_destroy(scene->collision);
}

vbss_result moving_shapes_move(moving_shapes *scene, uint64_t step)
{
    uint32_t name = 0;
    for (moving_shape shape = MOVING_THREAD; shape <= MOVING_SHEET; shape++) {
        if (there_is(&scene->options, shape)) {
            moving_shapes_place(&scene->options, shape, step, scene->positions);
            VBSS_TRY(vbss_collision_move(scene->collision, name++, NULL, scene->positions,
                                         moving_shapes_nodes(&scene->options, shape)));
        }
    }
    return VBSS_OK;
}

vbss_result moving_shapes_step(moving_shapes *scene)
{
    vbss_collision_statistics s;
    VBSS_TRY(vbss_collision_get_statistics(scene->collision, &s, sizeof s));
    VBSS_TRY(moving_shapes_move(scene, s.searches + 1));
    VBSS_TRY(vbss_collision_find_candidates(scene->collision));
    return vbss_collision_find_impacts(scene->collision);
}

vbss_result moving_shapes_hash(const moving_shapes *scene, uint64_t *hash)
{
    vbss_stream stream;
    uint64_t own;
    VBSS_TRY(vbss_collision_get_hash(scene->collision, &own));
    vbss_stream_begin_hash(&stream);
    vbss_stream_u64(&stream, 1, &own, 1);
    for (vbss_collision_field field = VBSS_COLLISION_VIEW_CANDIDATES;
         field <= VBSS_COLLISION_VIEW_DISTANCES; field++) {
        vbss_view view;
        VBSS_TRY(vbss_collision_get_view(scene->collision, field, &view, sizeof view));
        size_t count = (size_t)view.count * view.components; /* all of these are dense */
        if (view.type == VBSS_TYPE_F64) {
            vbss_stream_f64(&stream, 2, (double *)view.data, count); /* hashing only reads */
        } else {
            vbss_stream_u32(&stream, 3, (uint32_t *)view.data, count);
        }
    }
    *hash = vbss_hash_end(&stream.hash);
    return stream.result;
}
