/* What is cut is flat, what is not is round: a lip that slides over another wall and off its lip is nowhere suddenly nearer. */
#include "fixtures/solver_of.h"
#include "scene/drains_rig.h"
#include "scene/api/api.h"
#include "scene/contacts/contacts.h"
#include "scene/world/world.h"

/* How far it slides, in steps, m; and by how much its gap is another after one: which wall it is above is asked where the
 * middle of the lip is, not where it touches. */
#define SLIDE 5e-3
#define STEP 5e-6
#define LEAP 80e-6
/* Beyond this distance nobody looks, m. */
#define FAR 150e-6

/* Of the right wall's nodes: from where on it rises; along the slit, so that lips do not meet node at node. */
#define LIP 1.5e-3
#define ALONG 0.3e-3

static vec3 place(vec3 rest, double slope, double height, double over)
{
    if (rest.y < 0.0) {
        return vec3_make(rest.x, rest.y - 50e-3, rest.z);
    }
    if (rest.z < 0.0) {
        return vec3_make(rest.x, 0.0, rest.z);
    }
    return vec3_make(rest.x + ALONG, height + slope * (rest.z - LIP), rest.z - over);
}

static bool has_node(const scene_object *s, const scene_body *b, const contact_constraint *row,
                     bool is_b, uint32_t node)
{
    uint32_t nodes[3];
    uint32_t count = vbss_scene_surface_feature_nodes(
        s, b, row->key.kind, is_b, is_b ? row->key.feature_b : row->key.feature_a, nodes);
    bool there = false;
    for (uint32_t k = 0; k < count; k++) {
        there = there || nodes[k] == node;
    }
    return there;
}

/* Of what has that node. */
static double min_gap(const scene_object *s, const scene_body *b, uint32_t node)
{
    double smallest = FAR;
    for (uint32_t i = 0; i < s->contacts->count; i++) {
        const contact_constraint *row = &s->contacts->constraints[i];
        const double gap = scene_geometry_of(s, row)->start_gap;
        if (row->key.body_a == b->number && row->key.body_b == b->number &&
            row->key.kind != VBSS_SCENE_CONTACT_DRAIN_FLOOR && gap < smallest &&
            (has_node(s, b, row, false, node) || has_node(s, b, row, true, node))) {
            smallest = gap;
        }
    }
    return smallest;
}

static const scene_substep part = {.step_length = 1e-3, .h = 1e-3, .end_fraction = 1.0};
static small s;

static scene_object *begin(double margin, drain_object **d)
{
    drain_hands hands;
    scene_object *o = NULL;
    expect_ok(drain_hands_init(&hands));
    hands.config.contact_capacity = 20000;
    hands.config.candidate_capacity = 200000;
    solver_of(&hands.config)->contact_margin = margin;
    *d = drains_rig_object(drains_rig_begin(&s, &hands));
    expect_ok(vbss_scene_open(s.scene, &o));
    return o;
}

static void slide(double slope, double height)
{
    drain_object *d;
    scene_object *o = begin(FAR, &d);
    double before = 0.0, deepest = FAR, largest = 0.0;
    for (uint32_t k = 0; k < (uint32_t)(SLIDE / STEP); k++) {
        for (uint32_t i = 0; i < d->mesh.node_count; i++) {
            d->x[i] = pose_apply(d->frame, place(d->mesh.rest[i], slope, height, STEP * k));
            d->v[i] = vec3_zero();
        }
        assert_true(vbss_scene_create_contacts(o, &part));
        double gap = min_gap(o, &o->bodies[0], d->mesh.slit_middle[DRAIN_RIGHT]);
        largest = k > 0 ? fmax(fabs(gap - before), largest) : 0.0;
        deepest = fmin(gap, deepest);
        before = gap;
    }
    print_message("slope %.2f, %.2f mm above: %.0f um deep, a leap of %.1f um\n", slope,
                  1e3 * height, -1e6 * deepest, 1e6 * largest);
    assert_true(deepest < -90e-6);
    assert_true(largest <= LEAP);
    small_end(&s);
}

/* Pressed together by a tenth of a wall. */
static void lip_slides_over_wall_and_edge_continuously(void **state)
{
    (void)state;
    for (int quarters = 0; quarters <= 6; quarters++) {
        double slope = 0.25 * quarters;
        double lean = 1.0 / sqrt(1.0 + slope * slope);
        slide(slope, 0.5e-3 + 0.4e-3 * lean);
    }
}

/* The right wall, at one height with the left one, by so much nearer than at rest. */
static void bring_near(drain_object *d, double over, vec3 velocity)
{
    const vec3 *rest = d->mesh.rest;
    for (uint32_t i = 0; i < d->mesh.node_count; i++) {
        bool right = rest[i].y >= 0.0 && rest[i].z >= 0.0;
        d->x[i] = pose_apply(d->frame, place(rest[i], 0.0, 0.0, over));
        d->v[i] = right ? quat_rotate(d->frame.orientation, velocity) : vec3_zero();
    }
}

/* End to end, 0.1 mm from touching: a row if one of them moves, which swings its line, whichever way it does. */
static void lip_moving_past_lip_end_has_contact(void **state)
{
    (void)state;
    drain_object *d;
    scene_object *o = begin(FAR, &d);
    const uint32_t lip = d->mesh.slit_middle[DRAIN_RIGHT];
    double over = 0.0;
    do {
        over += STEP;
        bring_near(d, over, vec3_zero());
        assert_true(vbss_scene_create_contacts(o, &part));
    } while (min_gap(o, &o->bodies[0], lip) > 0.1e-3);
    o->solver.contact_margin = 30e-6;
    assert_true(vbss_scene_create_contacts(o, &part));
    assert_true(min_gap(o, &o->bodies[0], lip) == FAR);
    bring_near(d, over, vec3_make(0.0, 0.3, 0.0));
    assert_true(vbss_scene_create_contacts(o, &part));
    expect_near(0.1e-3, min_gap(o, &o->bodies[0], lip), STEP);
    small_end(&s);
}

int test_lip_contacts(void)
{
    const struct CMUnitTest tests[] = {harness_test(lip_slides_over_wall_and_edge_continuously),
                                       harness_test(lip_moving_past_lip_end_has_contact)};
    return cmocka_run_group_tests_name("scene.lip_contacts", tests, NULL, NULL);
}
