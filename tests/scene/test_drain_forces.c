/* Forces between a drain, tools and the floor against answers of other kinds: balance, the same shape held by pins,
 * Coulomb's law. */
#include "scene/drain_case.h"

static drain_case c;

#define TOP 7.0e-3

static void begin(void)
{
    drain_case_begin(&c);
    c.config.tear_stress = 1e9;
}

static void end(const char *name)
{
    drain_case_report(&c, name);
    small_watch_expect_nothing(&c.watch);
    drain_case_end(&c);
}

static void expect_vec3(vec3 wanted, vec3 got, double tolerance)
{
    expect_near(wanted.x, got.x, tolerance);
    expect_near(wanted.y, got.y, tolerance);
    expect_near(wanted.z, got.z, tolerance);
}

/* At rest, what the tool does to the drain the anchors take, and the hand feels. */
static void anchors_and_hand_balance_contact(void **state)
{
    (void)state;
    begin();
    drain_case_make(&c);
    uint32_t tip =
        drain_case_tool(&c, VBSS_SCENE_RIGID_COUPLED, vec3_make(0.3e-3, TOP + 10e-3, 4e-3),
                        vec3_make(0.0, 7e-3, 0.0), 1.5e-3);
    drain_case_move_to(&c, tip, vec3_make(0.3e-3, TOP + 5e-3, 4e-3), 200);
    drain_case_wait(&c, 1500);
    vec3 force = drain_case_contact_force(&c, tip);
    vbss_scene_rigid_state hand = small_rigid(&c.s, c.tools[tip].id);
    assert_true(vec3_norm(force) > 0.05);
    expect_vec3(force, drain_case_anchor_sum(&c), 1e-6);
    expect_vec3(force, vec3_load(hand.hand_force), 1e-6);
    end("balance");
}

/* How far a mark goes inward, and the force on the drain that did that. */
typedef struct dent {
    double depth;
    vec3 force, out, at; /* at: where the mark is then */
} dent;

static vec3 normal_at(uint32_t node)
{
    vec3 at = drain_case_node(&c, node);
    return vec3_unit_or(vec3_make(0.0, at.y, at.z), at);
}

/* By a ball that goes so far inward beyond touching. */
static dent press(double depth)
{
    const double radius = 0.3e-3;
    begin();
    drain_case_make(&c);
    uint32_t mark = c.places.marks[0];
    vec3 at = drain_case_node(&c, mark), out = normal_at(mark);
    vec3 touching = vec3_add_scaled(at, 0.5e-3 + radius, out);
    uint32_t ball = drain_case_tool(&c, VBSS_SCENE_RIGID_COUPLED,
                                    vec3_add_scaled(touching, 1e-3, out), vec3_zero(), radius);
    drain_case_move_to(&c, ball, vec3_add_scaled(touching, -depth, out), 300);
    drain_case_wait(&c, 1000);
    vec3 went = vec3_sub(at, drain_case_node(&c, mark));
    dent d = {vec3_dot(went, out), vec3_neg(drain_case_contact_force(&c, ball)), out,
              drain_case_node(&c, mark)};
    end("pressed");
    return d;
}

/* By a force on the node alone. */
static double force_down(vec3 force)
{
    begin();
    drain_case_make(&c);
    uint32_t mark = c.places.marks[0];
    vec3 at = drain_case_node(&c, mark), out = normal_at(mark);
    drain_case_force(&c, mark, force);
    drain_case_wait(&c, 1500);
    double depth = vec3_dot(vec3_sub(at, drain_case_node(&c, mark)), out);
    end("forced");
    return depth;
}

/* By a pin that holds the node where it is then: its force. */
static vec3 force_of_pin(vec3 to)
{
    double force[3];
    begin();
    drain_case_make(&c);
    uint32_t pin = drain_case_pin(&c, c.places.marks[0]);
    vec3 at = c.pins[pin].at;
    for (int i = 1; i <= 300; i++) {
        drain_case_target_pin(&c, pin, vec3_lerp(at, to, i / 300.0));
        drain_case_step(&c);
    }
    drain_case_wait(&c, 1000);
    expect_ok(vbss_drain_get_reaction(c.drain, c.pins[pin].id, force));
    end("pinned");
    return vec3_load(force);
}

/* Dents of this mesh by a force at a mark, from a study that came before the library: another program, whose shell lacked
 * the correction of bending. */
static double table_at(double depth)
{
    static const double table[7][2] = {{0.0, 0.0},    {0.5e-3, 0.034}, {1e-3, 0.060}, {2e-3, 0.095},
                                       {4e-3, 0.141}, {6e-3, 0.186},   {8e-3, 0.214}};
    int i = 1;
    while (i < 6 && table[i][0] < depth) {
        i++;
    }
    double share = (depth - table[i - 1][0]) / (table[i][0] - table[i - 1][0]);
    return table[i - 1][1] + share * (table[i][1] - table[i - 1][1]);
}

/* A pin that takes the mark where the ball has pushed it needs nearly the force of the ball, which slides off it a little; and a force alone, which lets the dent go
 * aside, makes the dents of the table. */
static void ball_at_target_feels_wall(void **state)
{
    static const double depths[4] = {0.55e-3, 1.1e-3, 2.1e-3, 4e-3};
    (void)state;
    for (int i = 0; i < 4; i++) {
        dent d = press(depths[i]);
        double normal = -vec3_dot(d.force, d.out), forced = force_down(d.force);
        vec3 pinned = force_of_pin(d.at);
        print_message("mark %.3f mm by %.4f N, a pin needs %.4f N; %.3f mm by the force alone, "
                      "table %.4f N\n",
                      1e3 * d.depth, normal, -vec3_dot(pinned, d.out), 1e3 * forced,
                      table_at(forced));
        /* in the deepest it has slid so far that the mark is not the deepest point */
        double missing = vec3_distance(pinned, d.force) / vec3_norm(d.force);
        assert_true(i == 3 || missing < 0.3);
        expect_near(1.0, normal / table_at(forced), 0.3);
    }
}

/* Sums over all contacts: of the sizes along their normals, and of what is across them. */
static double sum_contacts(vec3 *across)
{
    double along = 0.0;
    uint64_t count = small_view(&c.s, VBSS_SCENE_VIEW_CONTACTS).count;
    *across = vec3_zero();
    for (uint64_t i = 0; i < count; i++) {
        vec3 n = small_vector(&c.s, VBSS_SCENE_VIEW_CONTACT_NORMALS, i);
        vec3 f = small_vector(&c.s, VBSS_SCENE_VIEW_CONTACT_FORCES, i);
        along += vec3_dot(f, n);
        *across = vec3_add(*across, vec3_add_scaled(f, -vec3_dot(f, n), n));
    }
    return along;
}

/* A rod is drawn along the side of the drain, pressed on it by its coupling. */
static void sliding_tool_drags_wall(void **state)
{
    (void)state;
    begin();
    c.config.friction = 0.4;
    c.s.rigid.friction = 0.1; /* the geometric mean is 0.2 */
    drain_case_make(&c);
    uint32_t rod = drain_case_tool(&c, VBSS_SCENE_RIGID_COUPLED, vec3_make(-4e-3, 0.0, 9.5e-3),
                                   vec3_make(0.0, 4e-3, 0.0), 1.5e-3);
    drain_case_move_to(&c, rod, vec3_make(-4e-3, 0.0, 7.0e-3), 200);
    double largest = 0.0, smallest = HUGE_VAL;
    for (int i = 1; i <= 800; i++) { /* 10 mm/s */
        drain_case_target(&c, rod, vec3_make(-4e-3 + 1e-5 * i, 0.0, 7.0e-3));
        drain_case_step(&c);
        vec3 across;
        double along = sum_contacts(&across);
        if (i > 200) {
            largest = fmax(largest, fabs(across.x) / along);
            smallest = fmin(smallest, fabs(across.x) / along);
        }
    }
    print_message("drags with %.4f to %.4f of %.4f N\n", smallest, largest,
                  drain_case_contact_force(&c, rod).z);
    expect_near(0.2, largest, 0.01);
    expect_near(0.2, smallest, 0.01);
    end("drag");
}

int test_drain_forces(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(anchors_and_hand_balance_contact),
        cmocka_unit_test(ball_at_target_feels_wall),
        cmocka_unit_test(sliding_tool_drags_wall),
    };
    return cmocka_run_group_tests_name("drain forces", tests, NULL, NULL);
}
