/* The tests of what a search found. */
#include <string.h>

#include "collision/shapes_model.h"
#include "fixtures/moving_shapes.h"

typedef struct fixture {
    harness_memory memory;
    vbss_context *context;
} fixture;

/* The vertices of a candidate, as the one-question functions take them. */
static void question(const model *m, const candidate *pair, double start[12], double end[12])
{
    const model_shape *a = &m->shapes[pair->shape_a], *b = &m->shapes[pair->shape_b];
    bool edges = pair->kind == VBSS_COLLISION_PAIR_EDGE_EDGE;
    uint32_t split = edges ? 2 : 1;
    for (uint32_t k = 0; k < 4; k++) {
        const model_shape *s = k < split ? a : b;
        uint32_t node = !edges && k == 0 ? pair->a
                        : k < split      ? a->edges[pair->a][k]
                        : edges          ? b->edges[pair->b][k - split]
                                         : b->triangles[pair->b][k - split];
        vec3_store(start + 3 * (size_t)k, s->start[node]);
        vec3_store(end + 3 * (size_t)k, s->end[node]);
    }
}

static vbss_collision_impact ask(const model *m, const candidate *pair)
{
    double start[12], end[12];
    vbss_collision_impact impact;
    vbss_collision_config config = m->config;
    config.thickness =
        m->shapes[pair->shape_a].radius + m->shapes[pair->shape_b].radius + m->config.thickness;
    question(m, pair, start, end);
    expect_ok((pair->kind == VBSS_COLLISION_PAIR_EDGE_EDGE ? vbss_collision_test_edges
                                                           : vbss_collision_test_point_triangle)(
        &config, start, end, &impact, sizeof impact));
    return impact;
}

/* Number i of a view; several numbers stand side by side. */
static const double *reals(vbss_collision *collision, vbss_collision_field field, uint64_t i)
{
    vbss_view view = shapes_view(collision, field);
    assert_true(i < view.count);
    return (const double *)view.data + i * view.components;
}

static uint32_t number(vbss_collision *collision, vbss_collision_field field, uint64_t i)
{
    vbss_view view = shapes_view(collision, field);
    assert_true(i < view.count);
    return ((const uint32_t *)view.data)[i];
}

static void expect_impact(vbss_collision *collision, uint64_t i,
                          const vbss_collision_impact *wanted)
{
    expect_same_bits(wanted->time, *reals(collision, VBSS_COLLISION_VIEW_TIMES, i));
    expect_same_bits(wanted->distance, *reals(collision, VBSS_COLLISION_VIEW_DISTANCES, i));
    for (int k = 0; k < 3; k++) {
        expect_same_bits(wanted->normal[k], reals(collision, VBSS_COLLISION_VIEW_NORMALS, i)[k]);
    }
    for (int k = 0; k < 4; k++) {
        expect_same_bits(wanted->weights[k], reals(collision, VBSS_COLLISION_VIEW_WEIGHTS, i)[k]);
    }
    assert_int_equal(number(collision, VBSS_COLLISION_VIEW_DECISIONS, i), wanted->decision);
}

/* Asks about every candidate alone; returns how many hit. */
static uint32_t compare_impacts(const model *m, vbss_collision *collision)
{
    uint32_t count, hits = 0, undecided = 0;
    vbss_collision_statistics before = shapes_statistics(collision);
    const candidate *listed = shapes_find(collision, &count);
    expect_ok(vbss_collision_find_impacts(collision));
    for (uint32_t i = 0; i < count; i++) {
        vbss_collision_impact wanted = ask(m, &listed[i]);
        if (wanted.hit != 0) {
            assert_int_equal(number(collision, VBSS_COLLISION_VIEW_IMPACTS, hits), i);
            expect_impact(collision, hits, &wanted);
            undecided += wanted.decision == VBSS_COLLISION_DECISION_UNDECIDED;
            hits++;
        }
    }
    vbss_collision_statistics after = shapes_statistics(collision);
    assert_int_equal(after.impacts, hits);
    assert_int_equal(shapes_view(collision, VBSS_COLLISION_VIEW_IMPACTS).count, hits);
    assert_true(after.queries - before.queries == count);
    assert_true(after.hits - before.hits == hits);
    assert_true(after.undecided - before.undecided == undecided);
    return hits;
}

static void all_alone(harness_source *source, void *user)
{
    (void)user;
    fixture f;
    model m;
    vbss_collision *collision;
    f.context = harness_context(&f.memory);
    model_draw(&m, source);
    m.config.pair_capacity = m.config.impact_capacity = 200000;
    m.config.method = (vbss_collision_method)harness_draw_below(source, 3);
    expect_ok(vbss_collision_create(f.context, &m.config, &collision));
    model_add_to(&m, collision);
    model_draw_motion(&m, MODEL_CROWDED, source);
    model_move(&m, collision);
    compare_impacts(&m, collision);
    model_end(&m);
    harness_context_end(f.context, &f.memory);
}

static void impacts_match_single_pair_tests(void **state)
{
    (void)state;
    harness_property("all alone", 60, all_alone, NULL);
}

/* Capsules that cross a resting one half way, from `gap` beyond D: one impact each, in a block of any
 * length. */
static void blocks_of_any_length_are_tested(void **state)
{
    (void)state;
    const double radius = 0.25, gap = 0.5;
    const uint32_t counts[] = {1, 2, 3, 4, 5, 63, 64, 65, 127, 128, 129, 200};
    for (size_t i = 0; i < sizeof counts / sizeof counts[0]; i++) {
        fixture f;
        model m;
        vbss_collision *collision;
        f.context = harness_context(&f.memory);
        model_begin(&m);
        model_shape *many = model_capsules(&m, counts[i], radius);
        model_shape *one = model_capsules(&m, 1, radius);
        one->start[0] = one->end[0] = vec3_make(-1.0, 0.0, 0.0);
        one->start[1] = one->end[1] = vec3_make(1000.0, 0.0, 0.0);
        for (uint32_t k = 0; k < counts[i]; k++) {
            for (uint32_t end = 0; end < 2; end++) {
                vec3 at = vec3_make(3.0 * k, end == 0 ? -1.0 : 1.0, 2.0 * radius + gap);
                many->start[2 * k + end] = at;
                at.z -= 2.0 * gap;
                many->end[2 * k + end] = at;
            }
        }
        expect_ok(vbss_collision_create(f.context, &m.config, &collision));
        model_add_to(&m, collision);
        model_move(&m, collision);
        assert_int_equal(compare_impacts(&m, collision), counts[i]);
        for (uint32_t k = 0; k < counts[i]; k++) {
            expect_near(0.5, *reals(collision, VBSS_COLLISION_VIEW_TIMES, k), 1e-3);
            expect_near(2.0 * radius, *reals(collision, VBSS_COLLISION_VIEW_DISTANCES, k), 1e-3);
        }
        model_end(&m);
        harness_context_end(f.context, &f.memory);
    }
}

static void scene_with_both_feature_kinds_is_tested(void **state)
{
    (void)state;
    const moving_shapes_options options = {120, true, true};
    harness_memory memory;
    vbss_context *context = harness_context(&memory);
    vbss_collision_config config;
    moving_shapes scene;
    uint64_t hits = 0;
    expect_ok(moving_shapes_config(&options, &config));
    expect_ok(moving_shapes_create(context, &options, &config, &scene));
    for (int i = 0; i < 20; i++) {
        expect_ok(moving_shapes_step(&scene));
        vbss_collision_statistics s = shapes_statistics(scene.collision);
        const candidate *listed = shapes_view(scene.collision, VBSS_COLLISION_VIEW_CANDIDATES).data;
        assert_true(s.impacts > 0 && s.candidates > 100);
        assert_int_equal(listed[0].kind, VBSS_COLLISION_PAIR_EDGE_EDGE);
        assert_int_equal(listed[s.candidates - 1].kind, VBSS_COLLISION_PAIR_POINT_TRIANGLE);
        hits += s.impacts;
        assert_true(s.hits == hits);
    }
    expect_ok(moving_shapes_destroy(&scene));
    harness_context_end(context, &memory);
}

static void impacts_above_capacity_are_counted(void **state)
{
    (void)state;
    const moving_shapes_options options = {120, true, true};
    harness_memory memory;
    vbss_context *context = harness_context(&memory);
    vbss_collision_config config;
    moving_shapes scene;
    uint32_t largest = 0;
    expect_ok(moving_shapes_config(&options, &config));
    for (int variant = 0; variant < 3; variant++) { /* enough, just enough, one too few */
        config.impact_capacity =
            variant == 0 ? config.impact_capacity : largest + 1 - (uint32_t)variant;
        expect_ok(moving_shapes_create(context, &options, &config, &scene));
        expect_ok(moving_shapes_move(&scene, 1));
        expect_ok(vbss_collision_find_candidates(scene.collision));
        vbss_collision_statistics before = shapes_statistics(scene.collision);
        expect_result(variant == 2 ? VBSS_ERROR_CAPACITY : VBSS_OK,
                      vbss_collision_find_impacts(scene.collision));
        vbss_collision_statistics after = shapes_statistics(scene.collision);
        largest = variant == 0 ? after.impacts : largest;
        assert_true(largest > 1);
        assert_int_equal(after.impacts, variant == 2 ? 0 : largest);
        assert_int_equal(after.candidates, before.candidates);
        assert_true(after.queries == (variant == 2 ? 0 : after.candidates));
        expect_ok(moving_shapes_destroy(&scene));
    }
    harness_context_end(context, &memory);
}

int test_impacts(void)
{
    const struct CMUnitTest tests[] = {
        harness_test(impacts_match_single_pair_tests),
        cmocka_unit_test(blocks_of_any_length_are_tested),
        cmocka_unit_test(scene_with_both_feature_kinds_is_tested),
        cmocka_unit_test(impacts_above_capacity_are_counted),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
