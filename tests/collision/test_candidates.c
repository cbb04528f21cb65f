/* The search lists what it must, in order, whatever was searched before. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "collision/closest.h"
#include "collision/shapes.h"
#include "collision/shapes_model.h"
#include "fixtures/moving_shapes.h"

typedef struct fixture {
    harness_memory memory;
    vbss_context *context;
} fixture;

static void begin(fixture *f)
{
    f->context = harness_context(&f->memory);
}

static void end(fixture *f)
{
    harness_context_end(f->context, &f->memory);
}

static vbss_collision *make(const fixture *f, const model *m)
{
    vbss_collision *collision;
    expect_ok(vbss_collision_create(f->context, &m->config, &collision));
    model_add_to(m, collision);
    return collision;
}

static void use_wide(vbss_collision *collision, bool wide)
{
    collision_object *c;
    expect_ok(vbss_collision_open(collision, &c));
    c->wide = wide && vbss_wide_is_available();
}

/* ---- complete and exact */

static void all_pairs(harness_source *source, void *user)
{
    (void)user;
    fixture f;
    model m;
    begin(&f);
    model_draw(&m, source);
    m.config.pair_capacity = 200000;
    vbss_collision *collision = make(&f, &m);
    for (int i = 0; i < 4; i++) {
        uint32_t count, motion = harness_draw_below(source, MODEL_MOTIONS);
        model_draw_motion(&m, (model_motion)motion, source);
        model_move(&m, collision);
        use_wide(collision, i % 2 == 0);
        shapes_find(collision, &count);
        assert_int_equal(count, shapes_statistics(collision).candidates);
        model_check(&m, collision, 0);
    }
    model_end(&m);
    end(&f);
}

static void candidates_are_complete_sorted_and_exact(void **state)
{
    (void)state;
    harness_property("all pairs", 250, all_pairs, NULL);
}

/* Trees of many levels, and the one over the shapes. */
static void candidates_of_large_shapes(void **state)
{
    (void)state;
    fixture f;
    model m;
    harness_source source = {.bytes = NULL};
    vbss_random_seed(&source.random, 7, 1);
    for (int round = 0; round < 3; round++) {
        begin(&f);
        model_begin(&m);
        m.config.thickness = MODEL_UNIT;
        m.config.pair_capacity = 4000000;
        if (round == 0) {
            model_chain(&m, 4500, NULL, 0.0);
        } else if (round == 1) {
            model_capsules(&m, 700, 0.25 * MODEL_UNIT);
            model_sheet(&m, 30, 40, 0.0);
        } else {
            model_sheet(&m, 5, 180, 0.25 * MODEL_UNIT);
            model_chain(&m, 600, NULL, 0.0);
        }
        vbss_collision *collision = make(&f, &m);
        uint32_t count;
        model_draw_motion(&m, MODEL_CROWDED, &source);
        model_move(&m, collision);
        shapes_find(collision, &count);
        assert_true(count > 1000);
        model_check(&m, collision, 0);
        model_end(&m);
        end(&f);
    }
}

static void candidates_of_many_shapes(void **state)
{
    (void)state;
    enum { SHAPES = 700 };
    fixture f;
    vbss_collision_config config;
    vbss_collision *many, *one;
    uint32_t name, count;
    vec3 ends[2 * SHAPES];
    vbss_random random;
    vbss_random_seed(&random, 3, 3);
    begin(&f);
    expect_ok(vbss_collision_config_init(&config, sizeof config));
    config.shape_capacity = SHAPES;
    config.thickness = 0.05;
    expect_ok(vbss_collision_create(f.context, &config, &many));
    expect_ok(vbss_collision_create(f.context, &config, &one));
    expect_ok(vbss_collision_add_capsules(one, SHAPES, 0.0, &name));
    for (uint32_t i = 0; i < SHAPES; i++) {
        vec3 *own = ends + 2 * (size_t)i;
        for (int k = 0; k < 2; k++) {
            own[k].x = vbss_random_uniform(&random);
            own[k].y = vbss_random_uniform(&random);
            own[k].z = vbss_random_uniform(&random);
        }
        own[1] = vec3_lerp(own[0], own[1], 0.1);
        expect_ok(vbss_collision_add_capsules(many, 1, 0.0, &name));
        expect_ok(vbss_collision_set_motion(many, name, &own[0].x, &own[0].x, 2));
    }
    expect_ok(vbss_collision_set_motion(one, 0, &ends[0].x, &ends[0].x, 2 * SHAPES));
    const candidate *wanted = shapes_find(one, &count);
    assert_true(count > 1000);
    uint32_t found;
    const candidate *got = shapes_find(many, &found);
    assert_int_equal(found, count);
    for (uint32_t i = 0; i < count; i++) {
        assert_int_equal(got[i].shape_a, wanted[i].a);
        assert_int_equal(got[i].shape_b, wanted[i].b);
    }
    end(&f);
}

/* ---- what matters: nothing that comes near is missing */

static vec3 vertex(const model_shape *s, uint32_t node, double time)
{
    return vec3_lerp(s->start[node], s->end[node], time);
}

static double distance_at(const model *m, const candidate *pair, double time)
{
    const model_shape *a = &m->shapes[pair->shape_a], *b = &m->shapes[pair->shape_b];
    if (pair->kind == VBSS_COLLISION_PAIR_POINT_TRIANGLE) {
        vec3 corners[3], point = vertex(a, pair->a, time);
        double weights[3];
        for (int k = 0; k < 3; k++) {
            corners[k] = vec3_sub(vertex(b, b->triangles[pair->b][k], time), point);
        }
        return vec3_norm(closest_on_triangle(corners, weights));
    }
    vec3 p = vertex(a, a->edges[pair->a][0], time), q = vertex(b, b->edges[pair->b][0], time);
    vec3 along_a = vec3_sub(vertex(a, a->edges[pair->a][1], time), p);
    vec3 along_b = vec3_sub(vertex(b, b->edges[pair->b][1], time), q);
    double s, u;
    return vec3_norm(closest_between_edges(along_a, along_b, vec3_sub(q, p), &s, &u));
}

/* Features of two shapes, so that no rule is in the way. */
static void what_comes_near(harness_source *source, void *user)
{
    uint32_t count, *near = user;
    fixture f;
    model m;
    begin(&f);
    model_begin(&m);
    m.config.thickness = MODEL_UNIT;
    m.config.margin = 0.5 * MODEL_UNIT;
    model_chain(&m, 20, NULL, 0.5 * MODEL_UNIT);
    model_sheet(&m, 4, 4, 0.25 * MODEL_UNIT);
    vbss_collision *collision = make(&f, &m);
    model_draw_motion(&m, MODEL_CROWDED, source);
    model_move(&m, collision);
    const candidate *listed = shapes_find(collision, &count), *last = listed + count;
    double reach = 1.75 * MODEL_UNIT * (1.0 + m.config.tolerance) + m.config.margin;
    candidate pair = {.kind = VBSS_COLLISION_PAIR_EDGE_EDGE, .shape_b = 1};
    for (; pair.kind <= VBSS_COLLISION_PAIR_POINT_TRIANGLE; pair.kind++) {
        bool edges = pair.kind == VBSS_COLLISION_PAIR_EDGE_EDGE;
        for (pair.a = 0; pair.a < (edges ? 19u : 20u); pair.a++) {
            for (pair.b = 0; pair.b < (edges ? 33u : 18u); pair.b++) {
                double smallest = (double)INFINITY;
                for (int i = 0; i <= 16; i++) {
                    double distance = distance_at(&m, &pair, i / 16.0);
                    smallest = distance < smallest ? distance : smallest;
                }
                while (listed < last && memcmp(listed, &pair, sizeof pair) != 0 &&
                       smallest <= reach) {
                    listed++; /* a pair that comes near no sample, or of one shape */
                }
                assert_true(smallest > reach || listed < last);
                *near += smallest <= reach;
            }
        }
    }
    model_end(&m);
    end(&f);
}

static void approaching_features_are_candidates(void **state)
{
    (void)state;
    uint32_t near = 0;
    harness_property("what comes near", 60, what_comes_near, &near);
    assert_true(near > 500 || getenv("VBSS_PROPERTY_CASE") != NULL); /* enough is tried */
}

int test_candidates(void)
{
    const struct CMUnitTest tests[] = {
        harness_test(candidates_are_complete_sorted_and_exact),
        cmocka_unit_test(candidates_of_large_shapes),
        cmocka_unit_test(candidates_of_many_shapes),
        harness_test(approaching_features_are_candidates),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
