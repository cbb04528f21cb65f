/* Separations that a search carries to the next one, and near pairs, which save it the trees. */
#include <math.h>
#include <stdlib.h>

#include "fixtures/baseline_of.h"
#include "collision/closest.h"
#include "collision/shapes.h"
#include "collision/shapes_model.h"

enum { CASES = 60, FEW = 10, MOVES = 12, BETWEEN = 5 };

typedef struct fixture {
    harness_memory memory;
    vbss_context *context;
    collision_object *object;
    vbss_slot slot;
    model m;
} fixture;

static vbss_collision *handle(fixture *f)
{
    return (vbss_collision *)&f->slot;
}

static void begin(fixture *f)
{
    f->context = harness_context(&f->memory);
    model_begin(&f->m);
    f->m.config.pair_capacity = 100000;
    f->m.config.impact_capacity = 0;
    f->m.config.margin = 1.0;
    (void)baseline_of(&f->m.config.baseline);
}

static void make(fixture *f)
{
    expect_ok(vbss_collision_allocate(f->context, &f->m.config, f->m.config.shape_capacity, true,
                                      &f->object));
    f->slot = vbss_slot_inside(f->context, &vbss_collision_kind, f->object);
    model_add_to(&f->m, handle(f));
}

static void end(fixture *f)
{
    vbss_collision_free(f->context, f->object);
    model_end(&f->m);
    harness_context_end(f->context, &f->memory);
}

/* A chain over a sheet, and capsules. */
static void add_shapes(fixture *f)
{
    model_chain(&f->m, 12, NULL, 0.1);
    model_sheet(&f->m, 5, 4, 0.1);
    model_capsules(&f->m, 4, 0.2);
    make(f);
}

/* ---- what they do */

static void place(fixture *f, harness_source *source)
{
    for (uint32_t k = 0; k < f->m.count; k++) {
        model_shape *s = &f->m.shapes[k];
        for (uint32_t i = 0; i < s->node_count; i++) {
            s->start[i] = s->end[i] = harness_draw_vec3(source, -1.5, 1.5);
        }
    }
}

/* What was the end is the start; or not quite; a shape may stay where it is. */
static void go(fixture *f, harness_source *source)
{
    for (uint32_t k = 0; k < f->m.count; k++) {
        model_shape *s = &f->m.shapes[k];
        double largest = harness_draw_below(source, 3) * harness_draw_real(source, 0.0, 0.1);
        double off = harness_draw_below(source, 4) == 0 ? 0.05 : 0.0;
        for (uint32_t i = 0; i < s->node_count; i++) {
            s->start[i] = vec3_add(s->end[i], harness_draw_vec3(source, -off, off));
            s->end[i] = vec3_add(s->start[i], harness_draw_vec3(source, -largest, largest));
        }
    }
}

static void search(fixture *f)
{
    model_move(&f->m, handle(f));
    for (uint32_t name = 0; name < f->m.count; name++) {
        vbss_collision_update_displacements(f->object->shapes[name]);
    }
    expect_ok(vbss_collision_find_candidates(handle(f)));
}

/* Of the axes, at that share of the way. */
static double distance_of(const fixture *f, const collision_candidate *q, double time)
{
    const collision_shape *a = f->object->shapes[q->shape_a], *b = f->object->shapes[q->shape_b];
    bool edges = q->kind == VBSS_COLLISION_PAIR_EDGE_EDGE;
    vec3 x[4];
    double at[3];
    for (uint32_t k = 0; k < 4; k++) {
        bool is_a = k < (edges ? 2u : 1u);
        const collision_shape *s = is_a ? a : b;
        uint32_t node = !edges ? (is_a ? q->a : b->triangles[q->b][k - 1])
                               : (is_a ? a->edges[q->a][k] : b->edges[q->b][k - 2]);
        x[k] = vec3_lerp(s->start[node], s->end[node], time);
    }
    if (edges) {
        return vec3_norm(closest_between_edges(vec3_sub(x[1], x[0]), vec3_sub(x[3], x[2]),
                                               vec3_sub(x[2], x[0]), &at[0], &at[1]));
    }
    const vec3 corners[3] = {vec3_sub(x[1], x[0]), vec3_sub(x[2], x[0]), vec3_sub(x[3], x[0])};
    return vec3_norm(closest_on_triangle(corners, at));
}

static void note(fixture *f, const collision_candidate *q)
{
    vbss_collision_store_separation(f->object, q, distance_of(f, q, 0.0));
}

/* ---- tests */

typedef struct counts {
    uint64_t known, near, stays;
} counts;

static void check_candidate(fixture *f, const collision_candidate *q, counts *c)
{
    double apart = collision_separation(f->object, q), smallest = (double)INFINITY;
    assert_true(apart <= distance_of(f, q, 0.0));
    c->known += apart > 0.0;
    for (int k = 0; k <= BETWEEN; k++) {
        smallest = vbss_min(smallest, distance_of(f, q, (double)k / BETWEEN));
    }
    assert_false(vbss_collision_stays_separated(f->object, q, smallest));
    for (int k = 0; k < 10; k++) {
        double distance = 0.1 * k;
        bool stays = vbss_collision_stays_separated(f->object, q, distance);
        assert_true(!stays || distance < smallest);
        c->stays += stays;
        c->near += !stays;
    }
}

/* The answer with an empty cache. */
static bool is_separated_by_measurement(const fixture *f, const collision_candidate *q,
                                        double distance)
{
    double *cached = &f->object->separations[f->object->near_index[q - f->object->candidates]];
    const double kept = *cached;
    *cached = 0.0;
    bool is_separated = vbss_collision_is_separated(f->object, q, distance);
    *cached = kept;
    return is_separated;
}

static void check_independence_of_cache(const fixture *f, const collision_candidate *q, counts *c)
{
    for (int k = 0; k < 10; k++) {
        double distance = 0.1 * k;
        bool is_cached = vbss_collision_stays_separated(f->object, q, distance);
        bool is_separated = vbss_collision_is_separated(f->object, q, distance);
        assert_true(is_separated == is_separated_by_measurement(f, q, distance));
        assert_true(is_separated || !is_cached);
        c->known += is_cached;
        c->stays += is_separated && !is_cached;
        c->near += !is_separated;
    }
}

static void search_and_compare(harness_source *source, void *user)
{
    fixture f;
    begin(&f);
    add_shapes(&f);
    place(&f, source);
    for (int move = 0; move < MOVES; move++) {
        go(&f, source);
        search(&f);
        for (uint32_t i = 0; i < f.object->candidate_count; i++) {
            const collision_candidate *q = &f.object->candidates[i];
            check_independence_of_cache(&f, q, user);
            if (harness_draw_below(source, 3) == 0) {
                note(&f, q);
            }
        }
    }
    end(&f);
}

/* The islands of a scene depend on it, and a restored scene has an empty cache. */
static void measured_separation_does_not_depend_on_the_cache(void **state)
{
    (void)state;
    counts c = {0};
    harness_property("separation with a cache and without", CASES, search_and_compare, &c);
    assert_true(getenv("VBSS_PROPERTY_CASE") != NULL ||
                (c.known > 10000 && c.stays > 10000 && c.near > 10000));
}

static void wander(harness_source *source, void *user)
{
    counts *c = user;
    fixture f;
    begin(&f);
    add_shapes(&f);
    place(&f, source);
    for (int move = 0; move < MOVES; move++) {
        go(&f, source);
        search(&f);
        for (uint32_t i = 0; i < f.object->candidate_count; i++) {
            const collision_candidate *q = &f.object->candidates[i];
            check_candidate(&f, q, c);
            if (harness_draw_below(source, 3) == 0) {
                note(&f, q);
                check_candidate(&f, q, c);
            }
        }
    }
    end(&f);
}

static void known_separation_is_a_lower_bound(void **state)
{
    (void)state;
    counts c = {0};
    harness_property("what is apart", CASES, wander, &c);
    assert_true(getenv("VBSS_PROPERTY_CASE") != NULL ||
                (c.known > 10000 && c.stays > 10000 && c.near > 10000));
}

static uint32_t count_known(const fixture *f)
{
    uint32_t count = 0;
    for (uint32_t i = 0; i < f->object->candidate_count; i++) {
        count += collision_separation(f->object, &f->object->candidates[i]) > 0.0;
    }
    return count;
}

static void measure_all(fixture *f)
{
    for (uint32_t i = 0; i < f->object->candidate_count; i++) {
        note(f, &f->object->candidates[i]);
    }
}

/* Somewhere, with everything known that there is to know. */
static void begin_measured(fixture *f, harness_source *source)
{
    begin(f);
    add_shapes(f);
    place(f, source);
    search(f);
    assert_int_equal(0, count_known(f));
    measure_all(f);
}

static void rest(harness_source *source, void *user)
{
    (void)user;
    fixture f;
    begin_measured(&f, source);
    uint32_t known = count_known(&f);
    assert_true(known > 100);
    search(&f);
    search(&f);
    assert_int_equal(known, count_known(&f));
    end(&f);
}

static void separation_of_resting_pairs_persists(void **state)
{
    (void)state;
    harness_property("what rests", FEW, rest, NULL);
}

/* Its segments are others, under the same numbers. */
static void change(harness_source *source, void *user)
{
    (void)user;
    fixture f;
    begin_measured(&f, source);
    vbss_collision_resize_chain(f.object, 0, 12, NULL);
    search(&f);
    uint32_t others = 0;
    for (uint32_t i = 0; i < f.object->candidate_count; i++) {
        const collision_candidate *q = &f.object->candidates[i];
        bool of_chain = q->shape_a == 0 || q->shape_b == 0,
             known = collision_separation(f.object, q) > 0.0;
        assert_true(!(of_chain && known));
        others += known;
    }
    assert_true(others > 20);
    end(&f);
}

static void changed_chain_drops_known_separation(void **state)
{
    (void)state;
    harness_property("a chain that changes", FEW, change, NULL);
}

/* Neither by a search that failed nor by the next one. */
static void leave(harness_source *source, void *user)
{
    (void)user;
    fixture f;
    begin_measured(&f, source);
    search(&f);
    uint32_t count = f.object->candidate_count;
    f.object->search.pair_capacity = count - 1;
    expect_result(VBSS_ERROR_CAPACITY, vbss_collision_find_candidates(handle(&f)));
    f.object->search.pair_capacity = f.m.config.pair_capacity;
    search(&f);
    assert_int_equal(count, f.object->candidate_count);
    assert_int_equal(0, count_known(&f));

    measure_all(&f);
    expect_ok(vbss_collision_set_filter(handle(&f), 1, 0, 0));
    search(&f);
    expect_ok(vbss_collision_set_filter(handle(&f), 1, 1, UINT32_MAX));
    search(&f);
    for (uint32_t i = 0; i < f.object->candidate_count; i++) {
        const collision_candidate *q = &f.object->candidates[i];
        bool was_out = q->shape_a == 1 || q->shape_b == 1;
        assert_true((collision_separation(f.object, q) > 0.0) == !was_out);
    }
    end(&f);
}

static void non_candidates_have_no_known_separation(void **state)
{
    (void)state;
    harness_property("what was no candidate", FEW, leave, NULL);
}

/* ---- near pairs */

typedef struct reuse {
    uint64_t searches, without_trees, tight;
} reuse;

static void search_and_check(fixture *f, reuse *r)
{
    search(f);
    model_check(&f->m, handle(f), 0);
    r->searches++;
    r->without_trees += f->object->search.boxes_tested == 0;
}

static void wander_and_edit(harness_source *source, void *user)
{
    fixture f;
    begin(&f);
    add_shapes(&f);
    place(&f, source);
    for (int move = 0; move < 4 * MOVES; move++) {
        go(&f, source);
        search_and_check(&f, user);
        if (harness_draw_below(source, 8) == 0) {
            vbss_collision_resize_chain(f.object, 0, 12, NULL);
        }
    }
    end(&f);
}

static void near_pairs_give_the_candidates_of_all_pairs(void **state)
{
    (void)state;
    reuse r = {0};
    harness_property("near pairs", CASES, wander_and_edit, &r);
    assert_true(getenv("VBSS_PROPERTY_CASE") != NULL ||
                (4 * r.without_trees > r.searches && 4 * r.without_trees < 3 * r.searches));
}

/* The capacity is the number of candidates: near pairs do not fit. */
static void fill(harness_source *source, void *user)
{
    reuse *r = user;
    fixture f;
    begin_measured(&f, source);
    f.object->search.pair_capacity = f.object->candidate_count;
    f.object->near_valid = false;
    search_and_check(&f, r);
    r->tight += f.object->tight_searches > 0;
    f.object->search.pair_capacity = f.m.config.pair_capacity;
    for (int move = 0; move < 2 * MOVES; move++) {
        go(&f, source);
        search_and_check(&f, r);
    }
    end(&f);
}

static void candidates_fit_where_near_pairs_do_not(void **state)
{
    (void)state;
    reuse r = {0};
    harness_property("near pairs that do not fit", FEW, fill, &r);
    assert_true(getenv("VBSS_PROPERTY_CASE") != NULL || r.tight > FEW / 2);
}

int test_separation_bounds(void)
{
    const struct CMUnitTest tests[] = {
        harness_test(known_separation_is_a_lower_bound),
        harness_test(measured_separation_does_not_depend_on_the_cache),
        harness_test(separation_of_resting_pairs_persists),
        harness_test(changed_chain_drops_known_separation),
        harness_test(non_candidates_have_no_known_separation),
        harness_test(near_pairs_give_the_candidates_of_all_pairs),
        harness_test(candidates_fit_where_near_pairs_do_not),
    };
    return cmocka_run_group_tests_name("collision.separation_bounds", tests, NULL, NULL);
}
