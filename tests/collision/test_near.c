/* What a mesh leaves out because it is near along the surface, against all pairs and their shortest ways. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "collision/shapes.h"
#include "collision/shapes_model.h"

typedef struct fixture {
    harness_memory memory;
    vbss_context *context;
    model m;
    vbss_collision *collision;
    collision_object *object;
} fixture;

static void begin(fixture *f)
{
    f->context = harness_context(&f->memory);
    model_begin(&f->m);
    f->m.config.pair_capacity = 200000;
}

static void make(fixture *f)
{
    expect_ok(vbss_collision_create(f->context, &f->m.config, &f->collision));
    expect_ok(vbss_collision_open(f->collision, &f->object));
    model_add_to(&f->m, f->collision);
}

static void end(fixture *f)
{
    model_end(&f->m);
    harness_context_end(f->context, &f->memory);
}

static uint64_t hash_of(const fixture *f)
{
    uint64_t hash;
    expect_ok(vbss_collision_get_hash(f->collision, &hash));
    return hash;
}

static void leave_out(const fixture *f, uint32_t name, const vec3 *at, double distance)
{
    expect_ok(vbss_collision_leave_out_near(f->object, name, at, distance));
}

/* Finds, and checks against all pairs; returns how many. */
static uint32_t find(const fixture *f)
{
    uint32_t count;
    shapes_find(f->collision, &count);
    model_check(&f->m, f->collision, 0);
    return count;
}

/* ---- against all pairs */

/* No way is as long as a distance that is drawn, give or take the rounding. */
static bool is_clear(const model_shape *s)
{
    bool clear = true;
    for (size_t i = 0; i < (size_t)s->node_count * s->node_count; i++) {
        clear = clear && !(fabs(s->arcs[i] - s->near) < 1e-12 * s->near);
    }
    return clear;
}

static void draw_distances(fixture *f, harness_source *source)
{
    for (uint32_t i = 0; i < f->m.count; i++) {
        model_shape *s = &f->m.shapes[i];
        double distance = MODEL_UNIT * harness_draw_real(source, 0.0, 20.0);
        bool last = i + 1 == f->m.count;
        if (s->kind != MODEL_MESH || (harness_draw_below(source, 4) == 0 && !last)) {
            continue;
        }
        do {
            distance *= 1.0 + 1e-6;
            model_leave_out_near(s, s->end, distance);
        } while (!is_clear(s));
        leave_out(f, i, s->end, distance);
    }
}

/* Shapes of all kinds, meshes among them, and a sheet with a slit; distances are drawn twice. */
static void all_pairs(harness_source *source, void *user)
{
    uint32_t *near = user;
    fixture f;
    begin(&f);
    model_draw(&f.m, source);
    f.m.config.pair_capacity = 200000;
    uint32_t columns = 4 + harness_draw_below(source, 5);
    uint32_t rows = 3 + harness_draw_below(source, 4);
    uint32_t slit = 1 + harness_draw_below(source, rows - 2);
    model_slit_sheet(&f.m, columns, rows, slit, MODEL_UNIT);
    make(&f);
    for (int i = 0; i < 6; i++) {
        uint32_t motion = harness_draw_below(source, MODEL_MOTIONS);
        model_draw_motion(&f.m, (model_motion)motion, source);
        model_move(&f.m, f.collision);
        f.object->wide = i % 2 == 0 && vbss_wide_is_there();
        uint32_t before = find(&f);
        if (i % 3 == 0) {
            draw_distances(&f, source);
            assert_int_equal(shapes_statistics(f.collision).candidates, 0); /* forgotten */
            *near += find(&f) < before;
        }
    }
    end(&f);
}

static void the_list_is_complete_sorted_and_exact(void **state)
{
    (void)state;
    uint32_t near = 0;
    harness_property("near pairs", 200, all_pairs, &near);
    assert_true(near > 150 || getenv("VBSS_PROPERTY_CASE") != NULL); /* enough is left out */
}

/* ---- a slit, where the arcs are known */

enum { COLUMNS = 10, ROWS = 4, SLIT = 2 };

/* A flat sheet, a unit from node to node, closed slit: nodes 21 to 28 are doubled as 40 to 47. */
static model_shape *add_slit_sheet(fixture *f)
{
    model_shape *s = model_slit_sheet(&f->m, COLUMNS, ROWS, SLIT, 0.25);
    for (uint32_t i = 0; i < s->node_count; i++) {
        uint32_t node = i < COLUMNS * ROWS ? i : i - COLUMNS * ROWS + SLIT * COLUMNS + 1;
        s->start[i] = s->end[i] = vec3_make(node % COLUMNS, node / COLUMNS, 0.0);
    }
    return s;
}

static uint32_t edge_of(const model_shape *s, uint32_t p, uint32_t q)
{
    uint32_t e = 0;
    while (e < s->edge_count && (s->edges[e][0] != p || s->edges[e][1] != q)) {
        e++;
    }
    assert_true(e < s->edge_count);
    return e;
}

static bool lists(const fixture *f, candidate pair)
{
    vbss_view view = shapes_view(f->collision, VBSS_COLLISION_VIEW_CANDIDATES);
    const candidate *listed = view.data;
    for (uint64_t i = 0; i < view.count; i++) {
        if (memcmp(&listed[i], &pair, sizeof pair) == 0) {
            return true;
        }
    }
    return false;
}

/* Lips between columns k and k + 1 lie on each other, and so do the point of the upper one at column k and
 * the triangle that the lower one is a side of. The ways round the tips are the shorter ones. */
static void lips_touch_but_near_the_tips(void **state)
{
    (void)state;
    const double distances[] = {0.0, 1.0, 2.0, 2.5, 4.0, 6.0, 8.0, 8.0 * (1.0 + DBL_EPSILON), 20.0};
    fixture f;
    begin(&f);
    f.m.exact = true;
    model_shape *s = add_slit_sheet(&f);
    make(&f);
    model_move(&f.m, f.collision);
    for (size_t i = 0; i < sizeof distances / sizeof distances[0]; i++) {
        leave_out(&f, 0, s->end, distances[i]);
        model_leave_out_near(s, s->end, distances[i]);
        find(&f);
        for (uint32_t k = 1; k < 8; k++) {
            uint32_t around = k < 8 - k ? 2 * k : 16 - 2 * k, way = k < 5 ? 2 * k : 17 - 2 * k;
            const candidate edges = {VBSS_PAIR_EDGE_EDGE, 0, edge_of(s, 20 + k, 21 + k), 0,
                                     edge_of(s, 39 + k, 40 + k)};
            const candidate point = {VBSS_PAIR_POINT_TRIANGLE, 0, 39 + k, 0, 19 + 2 * k};
            assert_int_equal(lists(&f, edges), around >= distances[i]);
            assert_int_equal(lists(&f, point), way >= distances[i]);
        }
    }
    end(&f);
}

/* All nodes in one place: what is left is the rule. As much room as that, and not one pair less. */
static void what_is_left_out_needs_no_room(void **state)
{
    (void)state;
    uint32_t counts[2];
    for (int round = 0; round < 4; round++) {
        fixture f;
        begin(&f);
        vec3 at[COLUMNS * ROWS + COLUMNS - 2];
        model_shape *s = add_slit_sheet(&f);
        memcpy(at, s->end, sizeof at);
        memset(s->start, 0, sizeof at);
        memset(s->end, 0, sizeof at);
        f.m.config.pair_capacity = round == 0 ? 200000 : round == 1 ? counts[0] : counts[1];
        f.m.config.pair_capacity -= round == 3;
        make(&f);
        if (round == 0) {
            counts[0] = find(&f);
        }
        leave_out(&f, 0, at, 3.0);
        model_leave_out_near(s, at, 3.0);
        if (round == 3) {
            expect_result(VBSS_ERROR_CAPACITY, vbss_collision_find_candidates(f.collision));
            assert_int_equal(shapes_statistics(f.collision).candidates, 0);
        } else {
            counts[1] = find(&f);
            assert_in_range(counts[1], counts[0] / 4, counts[0] - counts[0] / 4);
        }
        end(&f);
    }
}

/* Two sheets in one place: pairs of both stay, and each has a rule of its own. */
static void other_shapes_are_not_asked(void **state)
{
    (void)state;
    fixture f;
    begin(&f);
    f.m.exact = true;
    for (int i = 0; i < 2; i++) {
        add_slit_sheet(&f);
    }
    make(&f);
    model_move(&f.m, f.collision);
    uint32_t before = find(&f), count = before;
    for (uint32_t i = 0; i < 2; i++) {
        model_shape *s = &f.m.shapes[1 - i];
        leave_out(&f, 1 - i, s->end, 2.5);
        model_leave_out_near(s, s->end, 2.5);
        uint32_t left = find(&f);
        assert_true(left < count);
        assert_true(i == 0 || before - left == 2 * (before - count));
        count = left;
    }
    end(&f);
}

/* ---- memory, state, refusals */

static void a_failing_allocation_changes_nothing(void **state)
{
    (void)state;
    fixture f;
    begin(&f);
    const model_shape *s = add_slit_sheet(&f);
    make(&f);
    model_move(&f.m, f.collision);
    uint64_t before = f.memory.blocks;
    for (int round = 0; round < 3; round++) {
        uint64_t calls = 1;
        for (;; calls++) {
            uint32_t count, kept;
            shapes_find(f.collision, &count);
            uint64_t hash = hash_of(&f), blocks = f.memory.blocks;
            f.memory.fail_call = f.memory.calls + calls;
            vbss_result result = vbss_collision_leave_out_near(f.object, 0, s->end, 2.5 + round);
            f.memory.fail_call = 0;
            if (result == VBSS_OK) {
                assert_true(hash_of(&f) != hash);
                break;
            }
            expect_result(VBSS_ERROR_OUT_OF_MEMORY, result);
            assert_int_equal(f.memory.blocks, blocks);
            assert_int_equal(shapes_statistics(f.collision).candidates, count); /* not forgotten */
            shapes_find(f.collision, &kept);
            assert_int_equal(kept, count);
        }
        assert_int_equal(calls, 10); /* of each of nine */
        assert_int_equal(f.memory.blocks, before + 2);
    }
    expect_ok(vbss_collision_remove(f.collision, 0));
    assert_true(f.memory.blocks < before);
    end(&f);
}

/* A snapshot fits what leaves out the same, and the list does not depend on what was before. */
static void rules_are_part_of_what_a_snapshot_fits(void **state)
{
    (void)state;
    fixture saved, other;
    uint8_t bytes[8192];
    uint64_t written;
    begin(&saved);
    begin(&other);
    const model_shape *s = add_slit_sheet(&saved);
    make(&saved);
    model_move(&saved.m, saved.collision);
    add_slit_sheet(&other);
    make(&other);
    leave_out(&saved, 0, s->end, 2.5);
    expect_ok(vbss_collision_save(saved.collision, bytes, sizeof bytes, &written));
    expect_result(VBSS_ERROR_CORRUPT, vbss_collision_restore(other.collision, bytes, written));
    leave_out(&other, 0, s->end, 4.5);
    expect_result(VBSS_ERROR_CORRUPT, vbss_collision_restore(other.collision, bytes, written));
    leave_out(&other, 0, s->end, 2.5);
    expect_ok(vbss_collision_restore(other.collision, bytes, written));
    assert_true(hash_of(&saved) == hash_of(&other));
    expect_ok(vbss_collision_find_candidates(saved.collision));
    expect_ok(vbss_collision_find_candidates(other.collision));
    shapes_expect_same_list(saved.collision, other.collision);
    end(&saved);
    end(&other);
}

static void what_cannot_be_is_refused(void **state)
{
    (void)state;
    enum { MOST = 65536 };
    fixture f;
    const uint32_t triangle[3] = {0, 1, 2};
    uint32_t name;
    begin(&f);
    model_shape *s = add_slit_sheet(&f);
    model_chain(&f.m, 5, NULL, 0.1);
    make(&f);
    model_move(&f.m, f.collision);
    expect_ok(vbss_collision_add_mesh(f.collision, MOST, triangle, 1, 0.1, &name));
    uint64_t hash = hash_of(&f);
    vec3 *at = calloc(MOST, sizeof *at);
    assert_non_null(at);
    collision_object *c = f.object;
    expect_result(VBSS_ERROR_OUT_OF_RANGE, vbss_collision_leave_out_near(c, 3, at, 1.0));
    expect_result(VBSS_ERROR_OUT_OF_RANGE, vbss_collision_leave_out_near(c, 1, at, 1.0));
    expect_result(VBSS_ERROR_OUT_OF_RANGE, vbss_collision_leave_out_near(c, 0, at, -1.0));
    expect_result(VBSS_ERROR_NOT_FINITE, vbss_collision_leave_out_near(c, 0, at, (double)NAN));
    expect_result(VBSS_ERROR_CAPACITY, vbss_collision_leave_out_near(c, name, at, 1.0));
    s->start[47].z = (double)INFINITY;
    expect_result(VBSS_ERROR_NOT_FINITE, vbss_collision_leave_out_near(c, 0, s->start, 1.0));
    assert_true(hash_of(&f) == hash);
    free(at);
    end(&f);
}

int test_near(void)
{
    const struct CMUnitTest tests[] = {
        harness_test(the_list_is_complete_sorted_and_exact),
        cmocka_unit_test(lips_touch_but_near_the_tips),
        cmocka_unit_test(what_is_left_out_needs_no_room),
        cmocka_unit_test(other_shapes_are_not_asked),
        cmocka_unit_test(a_failing_allocation_changes_nothing),
        cmocka_unit_test(rules_are_part_of_what_a_snapshot_fits),
        cmocka_unit_test(what_cannot_be_is_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
