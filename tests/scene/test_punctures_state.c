/* Scenes with a needle in a drain: saved, restored and gone on with; damaged; without memory; without room for holes. */
#include "scene/needle_case.h"

#define STEP_S 1e-3
#define SPEED 0.1

/* ---- a needle that turns into both walls, as a body that is stepped */

typedef struct pricked {
    uint32_t hole_capacity;
} pricked;

/* Square to the wall over the right mark, 1 mm before it. */
static pose first_pose(const vbss_drain_places *places, const vec3 *x, double radius)
{
    vec3 mark = x[places->marks[DRAIN_RIGHT]];
    vec3 out = vec3_unit_or(vec3_make(0.0, mark.y, mark.z), vec3_zero());
    vec3 aside = vec3_make(0.0, -out.z, out.y);
    return needle_case_pose(radius, vec3_add_scaled(mark, 1e-3, out), vec3_neg(out), aside);
}

static vbss_result hold_edge(vbss_drain *drain, const vec3 *x)
{
    drain_object *d;
    uint32_t id;
    vbss_drain_attachment a;
    VBSS_TRY(vbss_drain_open(drain, &d));
    VBSS_TRY(vbss_drain_attachment_init(&a, sizeof a));
    a.node = d->mesh.middle[DRAIN_RIGHT];
    vec3_store(a.position, x[a.node]);
    return vbss_drain_attach(drain, &a, &id);
}

/* Bodies 1, the drain, and 2, the needle. */
static vbss_result create(vbss_context *context, void *user, void **handle)
{
    const pricked *p = user;
    vbss_scene_config config;
    vbss_drain_config wall;
    vbss_needle_config own;
    vbss_drain_places places;
    vbss_scene *scene;
    vbss_drain *drain;
    vbss_needle *needle;
    vbss_view x;
    uint32_t body;
    scene_object *s;
    VBSS_TRY(vbss_scene_config_init(&config, sizeof config));
    config.hole_capacity = p->hole_capacity;
    config.node_capacity = 0;
    VBSS_TRY(vbss_scene_create(context, &config, &scene));
    VBSS_TRY(vbss_drain_config_init(&wall, sizeof wall));
    VBSS_TRY(vbss_drain_create(context, &wall, &drain));
    VBSS_TRY(vbss_scene_add_drain(scene, drain, &body));
    VBSS_TRY(vbss_drain_get_places(drain, &places, sizeof places));
    VBSS_TRY(vbss_drain_get_view(drain, VBSS_DRAIN_POSITIONS, &x, sizeof x));
    VBSS_TRY(hold_edge(drain, x.data));
    VBSS_TRY(vbss_needle_config_init(&own, sizeof own));
    pose at = first_pose(&places, x.data, own.radius);
    const double parts[4] = {at.orientation.w, at.orientation.x, at.orientation.y,
                             at.orientation.z};
    memcpy(own.orientation, parts, sizeof parts);
    vec3_store(own.position, at.position);
    VBSS_TRY(vbss_needle_create(context, &own, &needle));
    VBSS_TRY(vbss_scene_add_needle(scene, needle, &body));
    VBSS_TRY(vbss_scene_open(scene, &s));
    scene_rigid *r = &vbss_scene_body(s, body)->rigid;
    r->kind = VBSS_RIGID_COUPLED;
    r->body.coupling = needle_case_coupling;
    *handle = scene;
    return VBSS_OK;
}

/* Where the hand is follows from the number of the step alone: on, and from 18 mm back. */
static vbss_result step(void *handle)
{
    scene_object *s;
    vbss_scene_statistics told;
    VBSS_TRY(vbss_scene_open(handle, &s));
    VBSS_TRY(vbss_scene_get_statistics(handle, &told, sizeof told));
    const drain_object *d = vbss_scene_body(s, 1)->drain.drain;
    scene_rigid *r = &vbss_scene_body(s, 2)->rigid;
    vbss_drain_places places = {.marks = {d->mesh.marks[0], d->mesh.marks[1]}};
    pose at = first_pose(&places, d->mesh.rest, r->needle->config.radius);
    double way = SPEED * STEP_S * ((double)told.steps + 1.0);
    way = way > 18e-3 ? 36e-3 - way : way;
    vec3 turn = vec3_make(0.0, 0.0, way / r->needle->config.radius);
    at.orientation = quat_mul(at.orientation, vbss_quat_from_rotation_vector(turn));
    r->body.end = pose_mul(at, r->frame);
    return vbss_scene_step(handle, STEP_S);
}

static vbss_result destroy(void *handle)
{
    return vbss_scene_destroy(handle);
}

static harness_body as_body(pricked *p)
{
    const harness_body body = {"pricked drain", &vbss_scene_kind, create, NULL, step, destroy, p};
    return body;
}

/* ---- tests */

static uint32_t count_of(vbss_scene *scene, vbss_event_kind kind)
{
    vbss_view view;
    uint32_t count = 0;
    expect_ok(vbss_scene_get_view(scene, VBSS_SCENE_VIEW_EVENTS, &view, sizeof view));
    for (uint64_t i = 0; i < view.count; i++) {
        count += ((const uint32_t *)view.data)[4 * i] == (uint32_t)kind;
    }
    return count;
}

/* What the other tests stand on: moments 63 to 73 are about the first entry, 170 to 185 about the second. */
static void it_lives_through_all_events(void **state)
{
    (void)state;
    harness_memory memory;
    pricked p = {16};
    void *scene;
    uint32_t in = 0, out = 0;
    vbss_context *context = harness_context(&memory);
    expect_ok(create(context, &p, &scene));
    for (int i = 0; i < 420; i++) {
        expect_ok(step(scene));
        in += count_of(scene, VBSS_EVENT_PUNCTURE);
        out += count_of(scene, VBSS_EVENT_WITHDRAWN);
        if (count_of(scene, VBSS_EVENT_PUNCTURE) + count_of(scene, VBSS_EVENT_WITHDRAWN) > 0) {
            print_message("step %d: %u in, %u out\n", i + 1, in, out);
        }
    }
    assert_int_equal(in, 2);
    assert_int_equal(out, 2);
    harness_context_end(context, &memory);
}

static void a_restored_scene_goes_on_to_the_same_bits(void **state)
{
    (void)state;
    const size_t moments[] = {20, 55, 66, 70, 90, 120, 160, 176, 190, 220, 300};
    pricked p = {16};
    harness_body body = as_body(&p);
    for (size_t i = 0; i < sizeof moments / sizeof moments[0]; i++) {
        harness_save_restore_continue(&body, moments[i], 25);
    }
}

static void bad_snapshots_are_told(void **state)
{
    (void)state;
    pricked p = {2};
    harness_body body = as_body(&p);
    harness_refuses_bad_snapshots(&body, 190);
}

static void steps_allocate_nothing(void **state)
{
    (void)state;
    pricked p = {16};
    harness_body body = as_body(&p);
    assert_int_equal(harness_step_allocations(&body, 400), 0);
}

static void a_wall_holds_where_there_is_no_room_for_a_hole(void **state)
{
    (void)state;
    harness_memory memory;
    pricked p = {0};
    void *scene;
    vbss_hole hole;
    uint32_t lost = 0;
    vbss_context *context = harness_context(&memory);
    expect_ok(create(context, &p, &scene));
    for (int i = 0; i < 100; i++) {
        expect_ok(step(scene));
        lost += count_of(scene, VBSS_EVENT_HOLE_LOST);
        assert_int_equal(count_of(scene, VBSS_EVENT_PUNCTURE), 0);
    }
    assert_true(lost > 0);
    expect_result(VBSS_ERROR_OUT_OF_RANGE, vbss_scene_get_hole(scene, 0, &hole, sizeof hole));
    harness_context_end(context, &memory);
}

static void removed_bodies_take_their_holes_with_them(void **state)
{
    (void)state;
    for (uint32_t which = 1; which <= 2; which++) {
        harness_memory memory;
        pricked p = {16};
        void *scene;
        vbss_hole hole;
        vbss_context *context = harness_context(&memory);
        expect_ok(create(context, &p, &scene));
        for (int i = 0; i < 120; i++) {
            expect_ok(step(scene));
        }
        expect_ok(vbss_scene_get_hole(scene, 0, &hole, sizeof hole));
        expect_ok(vbss_scene_remove(scene, which));
        expect_result(VBSS_ERROR_OUT_OF_RANGE, vbss_scene_get_hole(scene, 0, &hole, sizeof hole));
        for (int i = 0; i < 20; i++) {
            expect_ok(vbss_scene_step(scene, STEP_S));
        }
        harness_context_end(context, &memory);
    }
}

int test_punctures_state(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(it_lives_through_all_events),
        cmocka_unit_test(a_restored_scene_goes_on_to_the_same_bits),
        cmocka_unit_test(bad_snapshots_are_told),
        cmocka_unit_test(steps_allocate_nothing),
        cmocka_unit_test(a_wall_holds_where_there_is_no_room_for_a_hole),
        cmocka_unit_test(removed_bodies_take_their_holes_with_them),
    };
    return cmocka_run_group_tests_name("scene.punctures_state", tests, NULL, NULL);
}
