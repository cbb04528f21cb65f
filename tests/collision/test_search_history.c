/* The list is a function of positions and configuration: nothing else that an object went through
 * shows in it. */
#include <string.h>

#include "collision/shapes.h"
#include "collision/shapes_model.h"

typedef struct fixture {
    harness_memory memory;
    vbss_context *context;
    model m;
} fixture;

static void begin(fixture *f, harness_source *source)
{
    f->context = harness_context(&f->memory);
    model_draw(&f->m, source);
    f->m.config.pair_capacity = 200000;
}

static void end(fixture *f)
{
    model_end(&f->m);
    harness_context_end(f->context, &f->memory);
}

static vbss_collision *make(const fixture *f)
{
    vbss_collision *collision;
    expect_ok(vbss_collision_create(f->context, &f->m.config, &collision));
    model_add_to(&f->m, collision);
    return collision;
}

static void wander(fixture *f, vbss_collision *collision, harness_source *source)
{
    uint32_t count, moves = 1 + harness_draw_below(source, 4);
    for (uint32_t i = 0; i < moves; i++) {
        uint32_t motion = harness_draw_below(source, MODEL_MOTIONS);
        model_draw_motion(&f->m, (model_motion)motion, source);
        model_move(&f->m, collision);
        shapes_find(collision, &count);
    }
}

/* ---- other lives */

static void another_life(harness_source *source, void *user)
{
    (void)user;
    fixture f;
    uint32_t count;
    uint8_t bytes[65536];
    uint64_t written;
    begin(&f, source);
    vbss_collision *lived = make(&f), *fresh = make(&f), *restored = make(&f);
    wander(&f, lived, source);
    wander(&f, restored, source);
    model_draw_motion(&f.m, MODEL_CROWDED, source);
    model_move(&f.m, lived);
    model_move(&f.m, fresh);
    expect_ok(vbss_collision_save(lived, bytes, sizeof bytes, &written));
    expect_ok(vbss_collision_restore(restored, bytes, written));
    shapes_find(lived, &count);
    shapes_find(fresh, &count);
    shapes_find(restored, &count);
    shapes_expect_same_list(lived, fresh);
    shapes_expect_same_list(lived, restored);
    shapes_find(lived, &count); /* and again, without a move */
    shapes_expect_same_list(lived, fresh);
    end(&f);
}

static void candidates_do_not_depend_on_history(void **state)
{
    (void)state;
    harness_property("another life", 150, another_life, NULL);
}

/* ---- trees that look otherwise */

static void scramble(collision_bvh *tree, harness_source *source)
{
    for (uint32_t i = 1; tree->order != NULL && i < tree->count; i++) {
        uint32_t k = harness_draw_below(source, i + 1), kept = tree->order[i];
        tree->order[i] = tree->order[k];
        tree->order[k] = kept;
    }
    tree->built_looseness = 1e300; /* never loose enough to be put in order */
}

static void another_tree(harness_source *source, void *user)
{
    (void)user;
    fixture f;
    uint32_t count;
    begin(&f, source);
    vbss_collision *tidy = make(&f), *scrambled = make(&f);
    collision_object *c;
    expect_ok(vbss_collision_edit(scrambled, &c));
    shapes_find(scrambled, &count); /* now it knows its shapes */
    for (uint32_t i = 0; i < c->shape_count; i++) {
        scramble(&c->shapes[i]->point_bvh, source);
        scramble(&c->shapes[i]->edge_bvh, source);
        scramble(&c->shapes[i]->triangle_bvh, source);
    }
    scramble(&c->shape_bvh, source);
    for (int motion = 0; motion < MODEL_MOTIONS; motion++) {
        model_draw_motion(&f.m, (model_motion)motion, source);
        model_move(&f.m, tidy);
        model_move(&f.m, scrambled);
        shapes_find(tidy, &count);
        shapes_find(scrambled, &count);
        shapes_expect_same_list(tidy, scrambled);
    }
    end(&f);
}

static void candidates_do_not_depend_on_tree(void **state)
{
    (void)state;
    harness_property("another tree", 60, another_tree, NULL);
}

/* ---- either copy of the hot loops */

static void either_copy(harness_source *source, void *user)
{
    (void)user;
    fixture f;
    uint32_t count;
    begin(&f, source);
    vbss_collision *plain = make(&f), *wide = make(&f);
    collision_object *c;
    expect_ok(vbss_collision_edit(wide, &c));
    assert_int_equal(c->wide, vbss_wide_is_available());
    expect_ok(vbss_collision_edit(plain, &c));
    c->wide = false;
    for (int motion = 0; motion < MODEL_MOTIONS; motion++) {
        model_draw_motion(&f.m, (model_motion)motion, source);
        model_move(&f.m, plain);
        model_move(&f.m, wide);
        shapes_find(plain, &count);
        shapes_find(wide, &count);
        shapes_expect_same_list(plain, wide);
        assert_true(shapes_statistics(plain).boxes_tested == shapes_statistics(wide).boxes_tested);
    }
    end(&f);
}

static void scalar_and_simd_candidates_are_equal(void **state)
{
    (void)state;
    harness_property("either copy", 60, either_copy, NULL);
}

/* ---- shapes that come and go */

static void removed_and_added_again(harness_source *source, void *user)
{
    (void)user;
    fixture f;
    uint32_t count;
    begin(&f, source);
    vbss_collision *collision = make(&f);
    uint32_t shapes = f.m.count;
    wander(&f, collision, source);
    model_draw_motion(&f.m, MODEL_CROWDED, source);
    model_move(&f.m, collision);
    uint32_t gone = harness_draw_below(source, shapes);
    expect_ok(vbss_collision_remove(collision, gone));
    f.m.shapes[gone].removed = true;
    assert_int_equal(shapes_view(collision, VBSS_COLLISION_VIEW_CANDIDATES).count, 0);
    shapes_find(collision, &count);
    model_check(&f.m, collision, 0);

    for (uint32_t i = 0; i < shapes; i++) {
        vbss_result wanted = i == gone ? VBSS_ERROR_NOT_FOUND : VBSS_OK;
        expect_result(wanted, vbss_collision_remove(collision, i));
        f.m.shapes[i].removed = false;
    }
    shapes_find(collision, &count);
    assert_int_equal(count, 0);
    model_add_to(&f.m, collision); /* with names from `shapes` on */
    for (uint32_t i = 0; i < shapes; i++) {
        const model_shape *s = &f.m.shapes[i];
        expect_result(VBSS_ERROR_NOT_FOUND,
                      vbss_collision_set_motion(collision, i, NULL, &s->end[0].x, s->node_count));
        expect_ok(vbss_collision_set_motion(collision, shapes + i, &s->start[0].x, &s->end[0].x,
                                            s->node_count));
    }
    shapes_find(collision, &count);
    model_check(&f.m, collision, shapes);
    end(&f);
}

static void shapes_can_be_added_and_removed(void **state)
{
    (void)state;
    harness_property("removed and added again", 100, removed_and_added_again, NULL);
}

/* ---- moving on from the last end is moving from there */

static void moves_go_on_where_they_ended(harness_source *source, void *user)
{
    (void)user;
    fixture f;
    uint32_t count;
    begin(&f, source);
    vbss_collision *on = make(&f), *reported = make(&f);
    for (int i = 0; i < 3; i++) {
        for (uint32_t k = 0; k < f.m.count; k++) { /* at the origin before the first move */
            memcpy(f.m.shapes[k].start, f.m.shapes[k].end, f.m.shapes[k].node_count * sizeof(vec3));
            for (uint32_t node = 0; node < f.m.shapes[k].node_count; node++) {
                vec3 displacement = harness_draw_vec3(source, -4.0 * MODEL_UNIT, 4.0 * MODEL_UNIT);
                f.m.shapes[k].end[node] = vec3_add(f.m.shapes[k].end[node], displacement);
            }
            expect_ok(vbss_collision_set_motion(on, k, NULL, &f.m.shapes[k].end[0].x,
                                                f.m.shapes[k].node_count));
        }
        model_move(&f.m, reported);
        shapes_find(on, &count);
        shapes_find(reported, &count);
        shapes_expect_same_list(on, reported);
        model_check(&f.m, on, 0);
    }
    end(&f);
}

static void move_without_start_continues(void **state)
{
    (void)state;
    harness_property("moves go on", 40, moves_go_on_where_they_ended, NULL);
}

int test_search_history(void)
{
    const struct CMUnitTest tests[] = {
        harness_test(candidates_do_not_depend_on_history),
        harness_test(candidates_do_not_depend_on_tree),
        harness_test(scalar_and_simd_candidates_are_equal),
        harness_test(shapes_can_be_added_and_removed),
        harness_test(move_without_start_continues),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
