/* Needles, graspers and other rigid bodies: their shapes, and that they move. */
#include "base/elementary.h"
#include "fixture.h"
#include "grasper/grasper.h"
#include "needle/needle.h"

static const double place[3] = {0.01, -0.02, 0.03};
static const double turned[4] = {0.8, 0.0, 0.6, 0.0};

/* ---- needles */

static vbss_needle *make_needle(const fixture *f)
{
    vbss_needle_config c;
    vbss_needle *needle;
    expect_ok(vbss_needle_config_init(&c, sizeof c));
    memcpy(c.position, place, sizeof place);
    memcpy(c.orientation, turned, sizeof turned);
    expect_ok(vbss_needle_create(f->context, &c, &needle));
    expect_ok(vbss_visual_add_needle(f->visual, needle, NULL));
    return needle;
}

static void needle_is_wire_with_tip(void **state)
{
    (void)state;
    fixture f;
    begin(&f);
    make(&f);
    vbss_needle *needle = make_needle(&f);
    needle_object *n;
    expect_ok(vbss_needle_open(needle, &n));
    const drawn d = draw(&f);
    expect_sound(&d, &d.parts[0]);
    assert_int_equal(d.parts[0].kind, VBSS_VISUAL_KIND_NEEDLE);
    const pose at = vbss_needle_pose(n);
    const double length = vbss_needle_length(n), wire = n->config.wire_radius;
    double thickest = 0.0, foremost = 1.0;
    for (uint32_t i = 0; i < d.vertex_count; i++) {
        vec3 local = pose_apply_inverse(at, position_of(&d, i));
        double arc = vbss_needle_nearest_arc(n, local);
        double away = vec3_distance(local, vbss_needle_point(n, vbss_min(arc, length)));
        thickest = vbss_max(thickest, away);
        foremost = vbss_min(foremost, arc);
        if (arc > f.config.tip_length + 1e-6 && arc < length) {
            expect_near(wire, away, 3e-9);
        } else if (arc > 0.0 && arc < f.config.tip_length) {
            double left = 1.0 - arc / f.config.tip_length;
            expect_near(wire * (1.0 - left * left), away, 2e-6);
        }
        expect_near(-arc, material_of(&d, i).x, wire + 1e-9);
    }
    assert_true(thickest < wire + 3e-9);
    assert_true(fabs(foremost) < 1e-8); /* the tip is where the needle says */
    end(&f);
}

static void needle_without_tip_ends_round(void **state)
{
    (void)state;
    fixture f;
    begin(&f);
    f.config.tip_length = 0.0;
    make(&f);
    make_needle(&f);
    const drawn d = draw(&f);
    expect_sound(&d, &d.parts[0]);
    end(&f);
}

/* ---- graspers */

static vbss_grasper *make_grasper(const fixture *f, vbss_grasper_preset preset)
{
    vbss_grasper_config c;
    vbss_grasper *grasper;
    expect_ok(vbss_grasper_config_init(&c, sizeof c));
    expect_ok(vbss_grasper_config_preset(&c, preset));
    expect_ok(vbss_grasper_create(f->context, &c, &grasper));
    expect_ok(vbss_grasper_set_target(grasper, place, turned));
    expect_ok(vbss_visual_add_grasper(f->visual, grasper, NULL));
    return grasper;
}

/* No vertex is farther from the grasper's capsules than these are thick, but for the corners of flat jaws. */
static void expect_within_capsules(const drawn *d, vbss_grasper *grasper)
{
    vbss_view view;
    expect_ok(vbss_grasper_get_view(grasper, VBSS_GRASPER_VIEW_CAPSULES, &view, sizeof view));
    double outside = 0.0;
    for (uint32_t i = 0; i < d->vertex_count; i++) {
        double nearest = 1.0;
        const double *capsule = view.data;
        for (uint64_t k = 0; k < view.count; k++, capsule += 7) {
            vec3 a = vec3_load(capsule), b = vec3_load(capsule + 3), axis = vec3_sub(b, a);
            vec3 p = position_of(d, i);
            double length = vec3_norm_squared(axis);
            double share = length > 0.0 ? vec3_dot(vec3_sub(p, a), axis) / length : 0.0;
            share = vbss_min(vbss_max(share, 0.0), 1.0);
            double away = vec3_distance(p, vec3_add_scaled(a, share, axis)) / capsule[6];
            nearest = vbss_min(nearest, (away - 1.0) * capsule[6]);
        }
        outside = vbss_max(outside, nearest);
    }
    assert_true(outside < 0.42 * 0.5e-3); /* sqrt(2) - 1 of a jaw */
}

static void grasper_is_drawn_at_its_capsules(void **state)
{
    (void)state;
    const vbss_grasper_preset presets[2] = {VBSS_GRASPER_PRESET_STRAIGHT,
                                            VBSS_GRASPER_PRESET_ANGLED};
    for (int i = 0; i < 2; i++) {
        fixture f;
        begin(&f);
        make(&f);
        vbss_grasper *grasper = make_grasper(&f, presets[i]);
        const drawn d = draw(&f);
        assert_int_equal(d.parts[0].kind, VBSS_VISUAL_KIND_DRIVER);
        expect_sound(&d, &d.parts[0]);
        expect_within_capsules(&d, grasper);
        end(&f);
    }
}

/* Vertices of one jaw's flat side, by its normal in the tool's frame. */
static double farthest_opening(const drawn *d, pose at)
{
    double largest = 0.0;
    for (uint32_t i = 0; i < d->vertex_count; i++) {
        if ((double)d->vertices[i].value > 1.5) {
            largest = vbss_max(largest, fabs(pose_apply_inverse(at, position_of(d, i)).x));
        }
    }
    return largest;
}

static void jaws_open_and_close(void **state)
{
    (void)state;
    fixture f;
    begin(&f);
    make(&f);
    vbss_grasper *grasper = make_grasper(&f, VBSS_GRASPER_PRESET_STRAIGHT);
    grasper_object *g;
    expect_ok(vbss_grasper_open(grasper, &g));
    const drawn open = draw(&f);
    double wide = farthest_opening(&open, g->tool_pose);
    expect_near(0.5e-3 + 13e-3 * vbss_sin(0.35), wide, 1.1e-3);
    g->jaw_angle = 0.0; /* as its scene would have it */
    const drawn shut = draw(&f);
    double narrow = farthest_opening(&shut, g->tool_pose);
    expect_near(1e-3, narrow, 1e-8); /* two halves of 0.5 mm each side */
    uint32_t flat = 0;
    for (uint32_t i = 0; i < shut.vertex_count; i++) { /* their flat sides meet in the middle */
        vec3 n = quat_rotate_back(g->tool_pose.orientation, normal_of(&shut, i));
        if ((double)shut.vertices[i].value > 1.5 && fabs(fabs(n.x) - 1.0) < 1e-6 &&
            fabs(pose_apply_inverse(g->tool_pose, position_of(&shut, i)).x) < 1e-8) {
            flat++;
        }
    }
    assert_int_equal(flat, 8); /* four corners a jaw */
    expect_sound(&shut, &shut.parts[0]);
    end(&f);
}

static void shears_have_tapered_blades(void **state)
{
    (void)state;
    fixture f;
    begin(&f);
    make(&f);
    grasper_object *g;
    expect_ok(vbss_grasper_open(make_grasper(&f, VBSS_GRASPER_PRESET_STRAIGHT), &g));
    g->kind = VBSS_GRASPER_KIND_SHEARS;
    const drawn d = draw(&f);
    assert_int_equal(d.parts[0].kind, VBSS_VISUAL_KIND_SHEARS);
    expect_sound(&d, &d.parts[0]);
    end(&f);
}

/* ---- other bodies of a scene, and its floor */

static void capsules_balls_and_floor_are_drawn(void **state)
{
    (void)state;
    fixture f;
    vbss_scene_config c;
    vbss_scene *scene;
    vbss_scene_rigid_config rigid;
    uint32_t body;
    const vbss_scene_capsule capsules[2] = {{{0.0, 0.0, 0.0}, {0.0, 0.01, 0.0}, 1e-3},
                                            {{0.02, 0.0, 0.0}, {0.02, 0.0, 0.0}, 2e-3}};
    begin(&f);
    make(&f);
    expect_ok(vbss_scene_config_init(&c, sizeof c));
    c.floor = 1;
    c.floor_height = -0.05;
    expect_ok(vbss_scene_create(f.context, &c, &scene));
    expect_ok(vbss_scene_rigid_config_init(&rigid, sizeof rigid));
    rigid.capsule_count = 2;
    rigid.capsules = capsules;
    memcpy(rigid.position, place, sizeof place);
    memcpy(rigid.orientation, turned, sizeof turned);
    expect_ok(vbss_scene_add_rigid(scene, &rigid, &body));
    expect_ok(vbss_visual_add_scene(f.visual, scene, NULL));
    const drawn d = draw(&f);
    assert_int_equal(d.part_count, 2);
    assert_int_equal(d.parts[0].kind, VBSS_VISUAL_KIND_RIGID);
    assert_int_equal(d.parts[0].body, body);
    expect_sound(&d, &d.parts[0]);
    const double wanted = VBSS_PI * (1e-6 * 0.01 + 4.0 / 3.0 * (1e-9 + 8e-9));
    expect_near(1.0, volume_of(&d, &d.parts[0]) / wanted, 0.03);
    const pose at = pose_make(vec3_load(place), quat_make(0.8, 0.0, 0.6, 0.0));
    double reach = 0.0; /* in its frame the ball ends at x = 22 mm */
    for (uint32_t i = 0; i < d.parts[0].vertex_count; i++) {
        reach = vbss_max(reach, pose_apply_inverse(at, position_of(&d, i)).x);
    }
    expect_near(0.022, reach, 1e-5);
    assert_int_equal(d.parts[1].kind, VBSS_VISUAL_KIND_FLOOR);
    assert_int_equal(d.parts[1].triangle_count, 2);
    assert_int_equal(inverted_triangles(&d, &d.parts[1]), 0);
    for (uint32_t i = 0; i < 4; i++) {
        vec3 p = position_of(&d, d.parts[1].first_vertex + i);
        expect_near(-0.05, p.y, 1e-8);
        expect_near(0.5 * f.config.floor_size * sqrt(2.0), sqrt(p.x * p.x + p.z * p.z), 1e-7);
    }
    end(&f);
}

int test_visual_tools(void)
{
    const struct CMUnitTest tests[] = {
        harness_test(needle_is_wire_with_tip),
        harness_test(needle_without_tip_ends_round),
        harness_test(grasper_is_drawn_at_its_capsules),
        harness_test(jaws_open_and_close),
        harness_test(shears_have_tapered_blades),
        harness_test(capsules_balls_and_floor_are_drawn),
    };
    return cmocka_run_group_tests_name("visual.visual_tools", tests, NULL, NULL);
}
