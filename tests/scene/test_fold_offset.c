/* A pair of a drain's sides that begins deeper than what it bore is let off slowly: in a fold other pairs become the nearest ones,
 * and what was never pressed in would push with tens of newtons. */
#include "scene/contacts/contacts.h"
#include "scene/stitch_case.h"

/* What a part lets off at most of a wall of this thickness: 20 mm/s. */
#define WALL 1e-3
#define OPENED 20e-6

static stitch_case c;
static const scene_substep part = {.step_length = 1e-3, .end_fraction = 1.0, .h = 1e-3};

static uint32_t body_of_kind(const scene_object *s, scene_body_kind kind)
{
    uint32_t i = 0;
    while (i < s->body_count && s->bodies[i].kind != kind) {
        i++;
    }
    assert_true(i < s->body_count);
    return s->bodies[i].number;
}

/* One row of that depth, m, of which is remembered that it bore so much, N; warm-started. */
static const contact_constraint *warm_start_wall(scene_object *s, uint32_t of, double thickness,
                                                 double depth, double bore)
{
    contact_set *set = s->contacts;
    const uint32_t drain = body_of_kind(s, SCENE_BODY_DRAIN);
    const contact_key key = {VBSS_SCENE_CONTACT_SIDES, of, 0, drain, 40};
    set->count = set->warm_start_count = 0;
    contact_constraint *row = vbss_contact_add(set, &key);
    assert_non_null(row);
    row->stiffness = 2e5;
    row->thickness = thickness;
    scene_contact_geometry *geometry = scene_geometry_of(s, row);
    geometry->start_gap = row->gap = -depth;
    geometry->overlap_allowance = 0.0;
    if (bore > 0.0) {
        set->warm_start[set->warm_start_count++] =
            (contact_warm_start_entry){.key = key, .status = CONTACT_STICK, .normal_force = bore};
    }
    vbss_scene_warm_start_contacts(s, &part);
    expect_near(depth, vbss_contact_max_penetration(set), 1e-18); /* what it is nobody hides */
    expect_near(row->recovery_allowance, geometry->overlap_allowance, 0.0);
    expect_near(row->gap, geometry->start_gap, 0.0);
    return row;
}

static const contact_constraint *warm_start(scene_object *s, uint32_t of, double depth, double bore)
{
    return warm_start_wall(s, of, WALL, depth, bore);
}

static void fold_offset_is_released_slowly(void **state)
{
    (void)state;
    stitch_case_begin(&c);
    c.options.scene.mode = VBSS_SCENE_MODE_OFFLINE;
    stitch_case_make(&c);
    scene_object *s = small_object(&c.s);
    const uint32_t drain = body_of_kind(s, SCENE_BODY_DRAIN),
                   thread = body_of_kind(s, SCENE_BODY_THREAD);
    expect_near(-OPENED, warm_start(s, drain, 100e-6, 0.0)->gap, 1e-12);
    expect_near(-OPENED, warm_start(s, drain, 100e-6, 3.0)->gap,
                1e-12); /* 15 um: no more for that */
    expect_near(-0.5 * OPENED, warm_start_wall(s, drain, 0.5 * WALL, 100e-6, 0.0)->gap, 1e-12);
    expect_near(-50e-6, warm_start(s, drain, 100e-6, 10.0)->gap, 1e-12);
    expect_near(-100e-6, warm_start(s, drain, 100e-6, 20.0)->gap, 0.0);
    expect_near(-100e-6, warm_start(s, drain, 100e-6, 30.0)->gap, 0.0);
    expect_near(-15e-6, warm_start(s, drain, 15e-6, 0.0)->gap, 0.0);
    expect_near(-100e-6, warm_start(s, thread, 100e-6, 0.0)->gap, 0.0); /* it knows its side */
    s->contacts->count = s->contacts->warm_start_count = 0;
    stitch_case_end(&c);
}

/* In real time parts leave overlaps that no force knows of: those are pushed out. */
static void overlap_without_force_is_pushed_out_in_real_time_mode(void **state)
{
    (void)state;
    stitch_case_open(&c, 0);
    scene_object *s = small_object(&c.s);
    expect_near(-100e-6, warm_start(s, body_of_kind(s, SCENE_BODY_DRAIN), 100e-6, 0.0)->gap, 0.0);
    s->contacts->count = s->contacts->warm_start_count = 0;
    stitch_case_end(&c);
}

int test_fold_offset(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(fold_offset_is_released_slowly),
        cmocka_unit_test(overlap_without_force_is_pushed_out_in_real_time_mode),
    };
    return cmocka_run_group_tests_name("scene.fold_offset", tests, NULL, NULL);
}
