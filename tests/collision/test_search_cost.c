/* How many boxes a search looks at: counted, not timed. */
#include <stdlib.h>
#include <string.h>

#include "collision/shapes_model.h"
#include "fixtures/moving_shapes.h"

/* Boxes looked at in the third step, when trees have their order. */
static double boxes_of_coil(uint32_t segments, bool capsules, bool sheet)
{
    const moving_shapes_options options = {segments, capsules, sheet};
    harness_memory memory;
    vbss_context *context = harness_context(&memory);
    vbss_collision_config config;
    moving_shapes scene;
    uint64_t before = 0, after = 0;
    expect_ok(moving_shapes_config(&options, &config));
    expect_ok(moving_shapes_create(context, &options, &config, &scene));
    for (uint64_t step = 1; step <= 3; step++) {
        before = after;
        expect_ok(moving_shapes_move(&scene, step));
        expect_ok(vbss_collision_find_candidates(scene.collision));
        after = shapes_statistics(scene.collision).boxes_tested;
    }
    expect_ok(moving_shapes_destroy(&scene));
    harness_context_end(context, &memory);
    return (double)(after - before);
}

/* Ten times as many features with as many neighbours each: about ten times the work. */
static void search_cost_is_linear_in_features(void **state)
{
    (void)state;
    for (int variant = 0; variant < 4; variant++) {
        double few = boxes_of_coil(1000, variant % 2 != 0, variant / 2 != 0);
        double many = boxes_of_coil(10000, variant % 2 != 0, variant / 2 != 0);
        assert_true(many > 9.0 * few && many < 11.5 * few);
    }
}

/* A sheet of which nodes have names in any order, at rest. */
static vbss_collision *make_sheet(model *m, vbss_context *context, bool shuffled)
{
    enum { COLUMNS = 30, ROWS = 40, NODES = COLUMNS * ROWS };
    uint32_t name[NODES] = {0};
    vbss_random random;
    vbss_collision *collision;
    model_begin(m);
    m->config.pair_capacity = 1000000;
    m->config.thickness = 0.1;
    model_shape *s = model_sheet(m, COLUMNS, ROWS, 0.0);
    vbss_random_seed(&random, 5, 5);
    for (uint32_t i = 0; i < NODES; i++) {
        uint32_t k = shuffled ? vbss_random_below(&random, i + 1) : i;
        name[i] = name[k];
        name[k] = i;
    }
    for (uint32_t i = 0; i < 3 * s->triangle_count; i++) {
        s->triangles[i / 3][i % 3] = name[s->triangles[i / 3][i % 3]];
    }
    for (uint32_t i = 0; i < NODES; i++) {
        uint32_t row = i / COLUMNS;
        s->start[name[i]] = s->end[name[i]] = vec3_make(i % COLUMNS, row, 0.0);
    }
    expect_ok(vbss_collision_create(context, &m->config, &collision));
    model_add_to(m, collision);
    return collision;
}

static double boxes_of_search(vbss_collision *collision)
{
    uint32_t count;
    uint64_t before = shapes_statistics(collision).boxes_tested;
    shapes_find(collision, &count);
    assert_true(count > 1000);
    return (double)(shapes_statistics(collision).boxes_tested - before);
}

static void node_names_do_not_matter(void **state)
{
    (void)state;
    harness_memory memory;
    vbss_context *context = harness_context(&memory);
    double boxes[2];
    for (int variant = 0; variant < 2; variant++) {
        model m;
        vbss_collision *collision = make_sheet(&m, context, variant != 0);
        model_move(&m, collision);
        boxes[variant] = boxes_of_search(collision);
        model_end(&m);
    }
    expect_near(boxes[0], boxes[1], 0.1 * boxes[0]);
    harness_context_end(context, &memory);
}

/* Capsules change places with each other, so that what was near is far: the next search finds it out. */
static void trees_follow_motion(void **state)
{
    (void)state;
    enum { CAPSULES = 3000 };
    harness_memory memory;
    vbss_context *context = harness_context(&memory);
    model m;
    vbss_collision *lived, *fresh;
    harness_source source = {.bytes = NULL};
    vbss_random_seed(&source.random, 9, 9);
    model_begin(&m);
    m.config.pair_capacity = 1000000;
    model_shape *s = model_capsules(&m, CAPSULES, 0.2);
    expect_ok(vbss_collision_create(context, &m.config, &lived));
    model_add_to(&m, lived);
    for (uint32_t life = 0; life < 4; life++) {
        for (size_t i = 0; i < CAPSULES; i++) {
            vec3 at = harness_draw_vec3(&source, 0.0, 10.0);
            vec3 displacement = harness_draw_vec3(&source, -0.3, 0.3);
            s->start[2 * i] = s->end[2 * i] = at;
            s->start[2 * i + 1] = s->end[2 * i + 1] = vec3_add(at, displacement);
        }
        expect_ok(vbss_collision_create(context, &m.config, &fresh));
        model_add_to(&m, fresh);
        model_move(&m, lived);
        model_move(&m, fresh);
        expect_near(boxes_of_search(fresh), boxes_of_search(lived), 0.02 * boxes_of_search(fresh));
        shapes_expect_same_list(lived, fresh);
        expect_ok(vbss_collision_destroy(fresh));
    }
    model_end(&m);
    harness_context_end(context, &memory);
}

int test_search_cost(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(search_cost_is_linear_in_features),
        cmocka_unit_test(node_names_do_not_matter),
        cmocka_unit_test(trees_follow_motion),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
