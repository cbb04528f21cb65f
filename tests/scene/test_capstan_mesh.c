/* The law of the rope over a cylinder of the host's triangles, all of whose nodes are fixed (capstan_rig.h).
 *
 * The normal of such a contact is that of the start of a step, so a thread that slides by d in a step is braked more, by
 * some 2 d / R a radian: 2.5 % of the friction's 0.94 at 10 mm/s. So the law is tested at 2 mm/s. */
#include <string.h>

#include "scene/capstan_rig.h"

#define WALL 0.5e-3
#define WIDTH 3e-3
#define ASIDE 0.13e-3 /* the thread runs along no line of the mesh */
enum { AXIAL_CELLS = 4, MAX_ROUND = 90, NODES = (AXIAL_CELLS + 1) * MAX_ROUND };

static uint32_t round_cells;
static vbss_drain *mesh;

static void add_mesh(capstan *c)
{
    static double x[NODES][3];
    static uint32_t triangles[2 * AXIAL_CELLS * MAX_ROUND][3], anchors[NODES];
    uint32_t body, count = 0;
    for (uint32_t i = 0; i < round_cells * (AXIAL_CELLS + 1); i++) {
        const uint32_t column = i / (AXIAL_CELLS + 1);
        const double angle = 2.0 * CAPSTAN_PI * (column + 0.5) / round_cells;
        x[i][0] = -(CAPSTAN_RADIUS - 0.5 * WALL) * cos(angle);
        x[i][1] = (CAPSTAN_RADIUS - 0.5 * WALL) * sin(angle);
        x[i][2] = WIDTH * ((double)(i % (AXIAL_CELLS + 1)) / AXIAL_CELLS - 0.5) + ASIDE;
        anchors[i] = i;
    }
    for (uint32_t i = 0; i < round_cells * AXIAL_CELLS; i++, count += 2) {
        const uint32_t column = i / AXIAL_CELLS, row = i % AXIAL_CELLS;
        const uint32_t a = column * (AXIAL_CELLS + 1) + row;
        const uint32_t b = (column + 1) % round_cells * (AXIAL_CELLS + 1) + row;
        const uint32_t cell[2][3] = {{a, a + 1, b + 1}, {a, b + 1, b}};
        memcpy(triangles[count], cell, sizeof cell);
    }
    vbss_drain_surface surface = vbss_drain_surface_default();
    surface.node_count = surface.anchor_count = round_cells * (AXIAL_CELLS + 1);
    surface.triangle_count = count;
    surface.positions = x[0];
    surface.triangles = triangles[0];
    surface.anchors = anchors;
    vbss_drain_config drain = vbss_drain_config_default();
    drain.surface = &surface;
    drain.thickness = WALL;
    drain.friction = c->friction;
    drain.tear_stress = 1e12;
    expect_ok(vbss_drain_create(c->rig.thread.context, &drain, &mesh));
    expect_ok(vbss_scene_add_drain(c->rig.scene, mesh, &body));
}

/* log(T2 / T1) over the friction times the angle. */
static double friction_of_mesh(uint32_t cells, double friction, double speed)
{
    capstan c = capstan_half_turn(friction);
    round_cells = cells;
    c.speed = speed;
    c.add_cylinder = add_mesh;
    double got = capstan_pulled_over(&c);
    return got / (friction * c.angle);
}

static void tension_over_a_mesh_follows_capstan_equation(void **state)
{
    (void)state;
    const uint32_t cells[] = {18, 24, 36, 60, MAX_ROUND};
    for (int i = 0; i < 5; i++) {
        expect_near(1.0, friction_of_mesh(cells[i], 0.3, 2e-3), 0.01);
    }
    expect_near(1.0, friction_of_mesh(60, 0.1, 2e-3), 0.01);
}

/* Today's figure, where less is wanted. */
static void sliding_over_a_mesh_is_braked_by_its_speed(void **state)
{
    (void)state;
    const double slow = friction_of_mesh(36, 0.3, 2e-3), fast = friction_of_mesh(36, 0.3, 10e-3);
    assert_true(fast > slow && fast < slow + 0.03);
}

int test_capstan_mesh(void)
{
    const struct CMUnitTest tests[] = {
        harness_test(tension_over_a_mesh_follows_capstan_equation),
        harness_test(sliding_over_a_mesh_is_braked_by_its_speed),
    };
    return cmocka_run_group_tests_name("scene.capstan_mesh", tests, NULL, NULL);
}
