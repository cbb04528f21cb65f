#include "scenes/throw_scenes.h"

#include "base/elementary.h"
#include "base/error.h"
#include "scenes/throw_build.h"

#define PI 3.14159265358979324

/* ---- how hands are */

#define LAG 0.04        /* s */
#define HAND_SPEED 0.20 /* m/s, at most */
#define NEAR_SPEED 0.10
#define TRAVEL_SPEED 0.04
#define ADVANCE_SPEED 0.025
#define DRAW_SPEED 0.03

/* The orbit: its radius, m, and what it is of the thread's free length; the most that its angle changes. */
#define LEAST_RADIUS 8e-3
#define MOST_RADIUS 45e-3
#define RADIUS_SPEED 0.1 /* m/s */
#define FIRST_SHARE 0.92
#define LEAST_SHARE 0.3
#define MOST_SHARE 1.1
#define MOST_TURN 10.0       /* rad/s */
#define BEFORE_CONTACT 32e-3 /* m: of the thread that is not free before W is touched */
#define LOWEST 2e-3          /* m: of C, z */
#define HANDLE 12e-3
#define ARRIVED 2e-3

/* W takes the tail from so near, m, and comes from in line with it. */
#define TAIL_NEAR 3.4e-3
#define IN_LINE 1.5e-3
#define BEHIND_TAIL 10e-3
#define TOGETHER 0.83 /* of W's way C goes too */

/* Drawing: pulls at C and W, N, and what comes of them. */
#define GIVE_WAY 0.03
#define GIVE_WAY_MOST 2.0
#define SLOWER 0.05
#define STOPPED 0.1
#define LEASH_PULL 0.06
#define LEASH_SPEED 0.02 /* m/s */
#define LEASH_SHARE 0.97
#define LEASH_TIME 0.2
#define FURTHEST_RIGHT 95e-3
#define OVER (PI * 150.0 / 180.0)

/* Steps after which a phase ends whatever has come of it. */
enum {
    NEAR_STEPS = 1500,
    ORBIT_STEPS = 8000,
    TRAVEL_STEPS = 2500,
    DRAW_STEPS = 4000,
    REST_STEPS = 200
};

/* ---- where along the thread */

static vbss_view rest_lengths(const throw_scene *scene)
{
    vbss_view view = {0};
    (void)vbss_thread_get_view(scene->thread, VBSS_THREAD_REST_LENGTHS, &view, sizeof view);
    return view;
}

static double arc_of(const throw_scene *scene, uint32_t node)
{
    vbss_view view = rest_lengths(scene);
    double arc = 0.0;
    for (uint32_t i = 0; i < node && i < view.count; i++) {
        arc += ((const double *)view.data)[i];
    }
    return arc;
}

/* The node that is nearest to it. */
static uint32_t node_near(const throw_scene *scene, double arc)
{
    vbss_view view = rest_lengths(scene);
    const double *rest = view.data;
    uint32_t node = 0;
    while (node < view.count && arc > 0.5 * rest[node]) {
        arc -= rest[node++];
    }
    return node;
}

static void follow_mesh(throw_scene *scene)
{
    if (scene->options.thread.mesh == VBSS_MESH_ADAPTIVE) {
        scene->tail_node = node_near(scene, scene->arcs[0]);
        scene->right_mark = node_near(scene, scene->arcs[1]);
        scene->left_mark = node_near(scene, scene->arcs[2]);
        scene->held_node = node_near(scene, scene->arcs[3]);
    }
}

vbss_result throw_scene_create(vbss_context *context, const throw_scene_options *options,
                               throw_scene *scene)
{
    *scene = (throw_scene){
        .options = *options, .phi = -0.5 * PI, .share = FIRST_SHARE, .radius = MOST_RADIUS};
    VBSS_TRY(throw_build(context, scene));
    const uint32_t nodes[4] = {scene->tail_node, scene->right_mark, scene->left_mark,
                               scene->held_node};
    for (int k = 0; k < 4; k++) {
        scene->arcs[k] = arc_of(scene, nodes[k]);
    }
    return VBSS_OK;
}

/* ---- what hands see and feel */

static vec3 node_at(const throw_scene *scene, uint32_t node)
{
    vbss_view view;
    bool seen =
        vbss_thread_get_view(scene->thread, VBSS_THREAD_POSITIONS, &view, sizeof view) == VBSS_OK;
    return seen ? ((const vec3 *)view.data)[node] : vec3_zero();
}

static double tension(const throw_scene *scene, uint32_t segment)
{
    vbss_view view;
    bool seen =
        vbss_thread_get_view(scene->thread, VBSS_THREAD_TENSIONS, &view, sizeof view) == VBSS_OK;
    return seen ? ((const double *)view.data)[segment] : 0.0;
}

double throw_scene_pull_at_c(const throw_scene *scene)
{
    return tension(scene, scene->held_node - THROW_WELDED - 2);
}

double throw_scene_pull_at_w(const throw_scene *scene)
{
    return scene->phase < THROW_DRAW ? 0.0 : tension(scene, scene->tail_node + THROW_WELDED + 1);
}

/* The node of the limb that touches W last; 0: none does. */
static uint32_t last_on_w(const throw_scene *scene)
{
    vbss_view view;
    uint32_t last = 0;
    if (vbss_scene_get_view(scene->scene, VBSS_SCENE_VIEW_CONTACTS, &view, sizeof view) !=
        VBSS_OK) {
        return 0;
    }
    const uint32_t(*keys)[5] = (const uint32_t(*)[5])view.data;
    for (uint64_t i = 0; i < view.count; i++) {
        bool limb = keys[i][1] == scene->thread_body && keys[i][3] == scene->w.body &&
                    keys[i][2] > scene->left_mark && keys[i][2] < scene->held_node;
        last = limb && keys[i][2] > last ? keys[i][2] : last;
    }
    return last;
}

/* ---- phases */

/* What a hand adds to where it wants to be. */
static vec3 tremble(const throw_scene *scene, double phase)
{
    double t = scene->steps * THROW_SCENE_STEP, a = scene->options.tremor;
    return vec3_make(a * vbss_sin(2.0 * PI * 9.0 * t + phase),
                     a * vbss_sin(2.0 * PI * 12.0 * t + 2.0 * phase),
                     a * vbss_sin(2.0 * PI * 10.3 * t + 3.0 * phase));
}

static void go_to(throw_tool *tool, vec3 target, double speed)
{
    vec3 way = vec3_scale(vec3_sub(target, tool->at), THROW_SCENE_STEP / LAG);
    double far = vec3_norm(way), most = speed * THROW_SCENE_STEP;
    tool->at = vec3_add_scaled(tool->at, far > most ? most / far : 1.0, way);
}

static void begin_phase(throw_scene *scene, throw_phase phase)
{
    scene->phase = phase;
    scene->since = 0;
}

static vec3 orbit_point(const throw_scene *scene)
{
    const throw_scene_options *o = &scene->options;
    vec3 u = throw_axis_of_w(scene->w.at), tip = vec3_add_scaled(scene->w.at, -THROW_GRASP, u);
    double turned = (scene->phi + 0.5 * PI) / (2.0 * PI);
    vec3 foot = vec3_add_scaled(tip, o->first - o->advance * turned, u);
    vec3 at = vec3_add_scaled(foot, scene->radius, throw_from_w(scene, scene->phi));
    /* Its handle points away from W: it shall not knock on drain and floor. */
    double down = vbss_max(-throw_from_w(scene, scene->phi).z, 0.0);
    at.z = vbss_max(at.z, LOWEST + HANDLE * down);
    return at;
}

static void come_near(throw_scene *scene)
{
    vec3 target = orbit_point(scene);
    go_to(&scene->c, target, NEAR_SPEED);
    if (vec3_distance(scene->c.at, target) < ARRIVED || scene->since >= NEAR_STEPS) {
        begin_phase(scene, THROW_ORBIT);
    }
}

static void orbit(throw_scene *scene)
{
    const throw_scene_options *o = &scene->options;
    const double h = THROW_SCENE_STEP;
    double pull = throw_scene_pull_at_c(scene);
    uint32_t last = last_on_w(scene);
    double free_length = o->held_at - BEFORE_CONTACT;
    if (last > 0) {
        bool adapts = o->thread.mesh == VBSS_MESH_ADAPTIVE;
        free_length =
            adapts ? scene->arcs[3] - arc_of(scene, last) : (scene->held_node - last) * o->segment;
    }
    bool slack = pull < 0.4 * o->pull; /* the worst that can be: loops fall off */
    scene->share += pull > o->pull ? -1e-3 : slack && last > 0 ? 4e-4 : 0.0;
    scene->share = vbss_max(vbss_min(scene->share, MOST_SHARE), LEAST_SHARE);
    double wanted =
        vbss_min(vbss_max(scene->share * free_length, LEAST_RADIUS), MOST_RADIUS) - scene->radius;
    scene->radius += vbss_min(vbss_max(wanted, -RADIUS_SPEED * h), RADIUS_SPEED * h);
    double slow = pull > 3.0 * o->pull ? 0.0 : pull > o->pull ? 0.3 : 1.0;
    scene->phi += slow * vbss_min(o->speed / scene->radius, MOST_TURN) * h;
    go_to(&scene->c, orbit_point(scene), HAND_SPEED);
    if (scene->phi >= 2.0 * PI * o->turns || scene->since >= ORBIT_STEPS) {
        begin_phase(scene, THROW_TRAVEL);
    }
}

static vbss_result travel(throw_scene *scene)
{
    vec3 tail = node_at(scene, scene->tail_node), before = scene->w.at;
    vec3 u = throw_axis_of_w(scene->w.at), aim = tail;
    vec3 off = vec3_sub(scene->w.at, tail);
    vec3 beside = vec3_add_scaled(off, -vec3_dot(off, u), u);
    bool in_line = vec3_norm(beside) < IN_LINE;
    if (!in_line) { /* first behind it */
        aim = vec3_add_scaled(tail, BEHIND_TAIL, u);
    }
    go_to(&scene->w, aim, in_line ? ADVANCE_SPEED : TRAVEL_SPEED);
    scene->c.at = vec3_add_scaled(scene->c.at, TOGETHER, vec3_sub(scene->w.at, before));
    if (vec3_distance(scene->w.at, tail) < TAIL_NEAR || scene->since >= TRAVEL_STEPS) {
        vec3 from = vec3_sub(scene->w.at, scene->mark);
        scene->over = vbss_atan2(from.z, from.x);
        scene->leash = vec3_norm(from);
        begin_phase(scene, THROW_DRAW);
        return throw_take(scene, &scene->w, scene->tail_node);
    }
    return VBSS_OK;
}

static void draw(throw_scene *scene)
{
    const double h = THROW_SCENE_STEP;
    double at_w = throw_scene_pull_at_w(scene), at_c = throw_scene_pull_at_c(scene);
    double slow = vbss_min(vbss_max((STOPPED - at_w) / (STOPPED - SLOWER), 0.0), 1.0);
    bool adapts = scene->options.thread.mesh == VBSS_MESH_ADAPTIVE;
    double whole =
        THROW_TAIL - (adapts ? scene->arcs[0] : scene->tail_node * scene->options.segment);
    scene->leash += at_w > LEASH_PULL ? -LEASH_SPEED * h
                                      : (LEASH_SHARE * whole - scene->leash) * h / LEASH_TIME;
    scene->over = vbss_min(scene->over + slow * DRAW_SPEED * h / whole, OVER);
    vec3 on_arc = vec3_make(vbss_cos(scene->over), 0.0, vbss_sin(scene->over));
    go_to(&scene->w, vec3_add_scaled(scene->mark, scene->leash, on_arc), HAND_SPEED);
    /* C goes to the right while the limb is slack, and gives way to W when it is not. */
    double eager = (GIVE_WAY - at_c) / GIVE_WAY;
    vec3 back = vec3_unit_or(vec3_sub(scene->w.at, scene->c.at), vec3_make(-1.0, 0.0, 0.0));
    vec3 way = eager > 0.0 ? vec3_make(eager, 0.0, 0.0)
                           : vec3_scale(back, vbss_min(-eager, GIVE_WAY_MOST));
    scene->c.at = vec3_add_scaled(scene->c.at, DRAW_SPEED * h, way);
    scene->c.at.x = vbss_min(scene->c.at.x, FURTHEST_RIGHT);
    scene->c.at.z = vbss_max(scene->c.at.z, LOWEST);
    if (scene->over >= OVER || scene->since >= DRAW_STEPS) {
        begin_phase(scene, THROW_REST);
    }
}

static vbss_result move_tool(const throw_scene *scene, const throw_tool *tool, quat stand,
                             double phase)
{
    const double orientation[4] = {stand.w, stand.x, stand.y, stand.z};
    double to[3];
    vec3_store(to, vec3_add(throw_frame_of(tool->at, stand), tremble(scene, phase)));
    return vbss_scene_move_rigid(scene->scene, tool->body, to, orientation);
}

vbss_result throw_scene_step(throw_scene *scene)
{
    scene->since++;
    follow_mesh(scene);
    switch (scene->phase) {
    case THROW_NEAR:
        come_near(scene);
        break;
    case THROW_ORBIT:
        orbit(scene);
        break;
    case THROW_TRAVEL:
        VBSS_TRY(travel(scene));
        break;
    case THROW_DRAW:
        draw(scene);
        break;
    default:
        if (scene->since >= REST_STEPS) {
            begin_phase(scene, THROW_DONE);
        }
    }
    VBSS_TRY(move_tool(scene, &scene->w, throw_stand_of_w(scene), 0.0));
    VBSS_TRY(move_tool(scene, &scene->c, throw_stand_of_c(scene), 1.0));
    scene->steps++;
    return vbss_scene_step(scene->scene, THROW_SCENE_STEP);
}
