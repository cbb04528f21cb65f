/* A thread pulled over another one that is held straight: the law of the rope, T2 = T1 exp(mu angle), with a radius of half a
 * millimetre, over which a pulled thread slides by a noticeable angle in a step.
 *
 * A contact that acted in the middle of the step's slide, or at its start, would brake by slide / radius like additional
 * friction. That is asked of whole steps of 1 ms, as they are the default, and of shorter ones. */
#include <math.h>

#include "fixtures/scene_build.h"
#include "scene/rig.h"

enum { MAX_NODES = 200, POST_SEGMENTS = 8 };

static const double pi = 0x1.921fb54442d18p1;
static const double post_radius = 0.25e-3, thread_radius = 0.1e-3, bending_stiffness = 1e-10;
static const double load = 0.1, straight = 3e-3; /* N, m */

typedef struct strand_capstan {
    double friction, speed, step;
    scene_rig rig;
    double segment;
    uint32_t end;
    vec3 at;
} strand_capstan;

static double middle_radius(void)
{
    return post_radius + thread_radius;
}

/* Straight, half a turn whose segments touch the post with their middles, straight. */
static uint32_t wind(double *segment, vec3 *x)
{
    enum { ARC_SEGMENTS = 14 };
    const double turn = pi / ARC_SEGMENTS, outside = middle_radius() / cos(0.5 * turn);
    *segment = 2.0 * outside * sin(0.5 * turn);
    const uint32_t limb = (uint32_t)(straight / *segment);
    uint32_t count = 0;
    for (uint32_t i = 0; i < limb; i++) {
        x[count++] = vec3_make(-outside, (i - (double)limb) * *segment, 0.0);
    }
    for (uint32_t i = 0; i <= ARC_SEGMENTS; i++) {
        x[count++] = vec3_make(-outside * cos(i * turn), outside * sin(i * turn), 0.0);
    }
    for (uint32_t i = 1; i <= limb; i++) {
        x[count++] = vec3_make(outside, -(double)i * *segment, 0.0);
    }
    return count;
}

/* A thread along z of which each node is held. */
static void add_post(strand_capstan *c)
{
    vbss_thread_config config = rig_config(4e-3, POST_SEGMENTS);
    vbss_thread *post;
    config.radius = post_radius;
    config.attachment_capacity = POST_SEGMENTS + 1;
    vec3_store(config.start, vec3_make(0.0, 0.0, -2.1e-3));
    vec3_store(config.direction, vec3_make(0.0, 0.0, 1.0));
    expect_ok(scene_build_thread(c->rig.thread.context, c->rig.scene, &config, &post, NULL));
    for (uint32_t i = 0; i <= POST_SEGMENTS; i++) {
        vbss_thread_attachment pin;
        uint32_t id;
        expect_ok(vbss_thread_attachment_init(&pin, sizeof pin));
        pin.node = i;
        vec3_store(pin.position, vec3_make(0.0, 0.0, -2.1e-3 + i * 4e-3 / POST_SEGMENTS));
        expect_ok(vbss_thread_attach(post, &pin, &id));
    }
}

static void begin(strand_capstan *c)
{
    vec3 x[MAX_NODES];
    double rest[MAX_NODES];
    uint32_t count = wind(&c->segment, x);
    assert_true(count < MAX_NODES);
    for (uint32_t i = 0; i + 1 < count; i++) {
        rest[i] = c->segment;
    }
    vbss_scene_config scene = scene_rig_config();
    scene.thread_friction = c->friction;
    vbss_thread_config thread = rig_config(1.0, count - 1);
    thread.rest_lengths = rest;
    thread.positions = &x[0].x;
    thread.bending = VBSS_THREAD_BENDING_LOCAL;
    thread.radius = thread_radius;
    thread.bending_stiffness = bending_stiffness;
    thread.axial_stiffness = 4000.0;
    thread.gravity[1] = 0.0;
    thread.drag = 100.0;
    scene_rig_begin(&c->rig, &scene, &thread);
    add_post(c);
    uint32_t weight = rig_force(&c->rig.thread, 0, vec3_zero());
    c->end = rig_pin_here(&c->rig.thread, count - 1);
    c->at = x[count - 1];
    for (int i = 1; i <= 20; i++) {
        rig_move(&c->rig.thread, weight, vec3_make(0.0, -load * i / 20.0, 0.0));
        scene_rig_run(&c->rig, 1e-3, 1);
    }
}

/* Mean of log(T2 / T1) while the end moves by so many segments. */
static double pull(strand_capstan *c, double segments)
{
    const double bent = 0.5 * bending_stiffness / (middle_radius() * middle_radius());
    uint32_t steps = (uint32_t)(segments * c->segment / (c->speed * c->step) + 0.5);
    double mean = 0.0;
    for (uint32_t i = 0; i < steps; i++) {
        c->at.y -= c->speed * c->step;
        rig_move(&c->rig.thread, c->end, c->at);
        scene_rig_run(&c->rig, c->step, 1);
        double pulls = -rig_reaction_force(&c->rig.thread, c->end).y;
        mean += log((pulls - bent) / (load - bent)) / steps;
    }
    return mean;
}

static double pulled_over(double friction, double speed, double step)
{
    strand_capstan c = {.friction = friction, .speed = speed, .step = step};
    begin(&c);
    (void)pull(&c, 4.0);
    double mean = pull(&c, 8.0);
    scene_rig_end(&c.rig);
    return mean;
}

/* A slide of 57 mrad a step: a brake of slide / radius would be 19 % more. */
static void strand_follows_capstan_equation_at_any_step(void **state)
{
    const double steps[] = {1e-3, 0.5e-3, 0.2e-3};
    (void)state;
    for (int i = 0; i < 3; i++) {
        expect_near(1.0, pulled_over(0.3, 0.02, steps[i]) / (0.3 * pi), 0.03);
    }
}

static void strand_without_friction_slides_without_brake(void **state)
{
    (void)state;
    expect_near(0.0, pulled_over(0.0, 0.02, 1e-3), 0.02);
    expect_near(0.0, pulled_over(0.0, 0.1, 0.2e-3), 0.02);
}

/* The pull goes on and stops from step to step. A contact whose points followed the motion of the step before would push
 * the thread on by slide / radius, 57 mrad, whenever it stops, and brake it whenever it starts. */
static void strand_that_stops_is_not_pushed_on(void **state)
{
    enum { PAIRS = 40 };
    const double bent = 0.5 * bending_stiffness / (middle_radius() * middle_radius());
    strand_capstan c = {.friction = 0.0, .speed = 0.02, .step = 1e-3};
    double mean[2] = {0.0, 0.0};
    (void)state;
    begin(&c);
    (void)pull(&c, 4.0);
    for (int i = 0; i < 2 * PAIRS; i++) {
        c.at.y -= i % 2 == 0 ? c.speed * c.step : 0.0;
        rig_move(&c.rig.thread, c.end, c.at);
        scene_rig_run(&c.rig, c.step, 1);
        const double pulls = -rig_reaction_force(&c.rig.thread, c.end).y;
        mean[i % 2] += log((pulls - bent) / (load - bent)) / PAIRS;
    }
    scene_rig_end(&c.rig);
    print_message("log T2/T1: %.4f in steps that pull, %.4f in steps that stop\n", mean[0],
                  mean[1]);
    expect_near(0.0, mean[0], 0.02);
    expect_near(0.0, mean[1], 0.02);
}

int test_strand_capstan(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(strand_follows_capstan_equation_at_any_step),
        cmocka_unit_test(strand_without_friction_slides_without_brake),
        cmocka_unit_test(strand_that_stops_is_not_pushed_on),
    };
    return cmocka_run_group_tests_name("scene.strand_capstan", tests, NULL, NULL);
}
